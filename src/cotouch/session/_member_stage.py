"""One's own part in a session as a stage: a process for the own copy, and of the others what it knows of them."""

import os
import time
from collections import deque
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, final

from cotouch.errors import SessionError
from cotouch.live import Identity, Invitation, ZenohControl
from cotouch.session import _wishes
from cotouch.session._boards import BoardFolder, board_folder
from cotouch.session._desk import Desk
from cotouch.session._file import SessionFile
from cotouch.session._jobs import Jobs
from cotouch.session._join import fetch_session
from cotouch.session._process import MemberProcess
from cotouch.session._recording import RecordingDesk
from cotouch.session._replica import Replica
from cotouch.session._stage import CopyView, Overview, Pointer, Scene
from cotouch.session._told import usual_stiffness
from cotouch.session._watch import Event, Watch

_MOST_EVENTS = 200


@final
class MemberStage:
    """Implements `Stage`.

    `tick` and `close` belong to the loop that moves it.

    Attributes:
        watch: what is seen of the session.
        member: the process of the own copy.
        over: whether that has ended, at the last `tick`.
    """

    def __init__(
        self,
        session: SessionFile,
        replica: Replica,
        watch: Watch,
        invitation: Invitation,
        boards: BoardFolder,
        *,
        name: str,
        options: Sequence[str],
    ) -> None:
        """Starts the process.

        Args:
            session: as the host describes it.
            replica: the body as built here.
            watch: of the session.
            invitation: to it.
            boards: where the member is shown and told things.
            name: that others see.
            options: of `cotouch join` besides.

        Raises:
            InputError: a board cannot be made.
        """
        self.watch = watch
        self._name, self._invitation = name, invitation.encode()
        self._session, self._replica = session, replica
        self._desk = Desk(boards, session, [name])
        self._tapes = RecordingDesk(boards, self._desk)
        self._jobs = Jobs()
        self._events = deque[Event](maxlen=_MOST_EVENTS)
        self.over = False
        self.member = MemberProcess(invitation, ["--name", name, "--headless", "--boards", str(boards.path), *options])
        self._overview = self._looked(0.0)

    @property
    def seat(self) -> int | None:
        """Of the own copy; None before it moves."""
        seat = self._desk.number(self._name, "seat")
        return seat if seat >= 0 and self._desk.number(self._name, "step") > 0 else None

    def tick(self, now: float) -> None:
        """Sees what is new; to be called some fifty times a second.

        Args:
            now: on the monotonic clock [s].
        """
        self.watch.service(now)
        self._jobs.turn()
        if not self.member.running and not self.over:
            self.over = True
            self._events.append(Event(now, f"{self._name} takes part no more"))
        self._tapes.turn(now, [] if self.over else [self._name])
        self._overview = self._looked(now)

    def close(self) -> int:
        """Lets the process leave, and returns its exit code."""
        self._jobs.close()
        code = self.member.stop()
        self.member.close()
        self._tapes.close()
        self._desk.close()
        return code

    def _looked(self, now: float) -> Overview:
        watch, seat = self.watch, self.seat
        events = sorted([*watch.events, *self._events], key=lambda event: event.time)
        return Overview(
            roster=watch.roster,
            statuses={other: seen.status for other, seen in watch.members.items() if seen.status is not None},
            alive={} if seat is None else {seat: not self.over},
            emulated={},
            choices={},
            damping=1.0,
            recording=self._tapes.since(now),
            events=events[-_MOST_EVENTS:],
            ended=watch.ended or self.over,
        )

    # -- any thread --------------------------------------------------------------------------------------------------

    @property
    def scene(self) -> Scene:
        """What does not change, once the own copy moves."""
        scenario, seat = self._replica.scenario, self.seat
        return Scene(
            title=self._session.scenario.title or "cotouch",
            users=tuple(self._session.scenario.network.users),
            body=self._replica.body,
            own=() if seat is None else (seat,),
            may=frozenset({"hand", "record"}),
            invitation=self._invitation,
            stiffness=usual_stiffness(scenario, seat or 0),
        )

    def views(self) -> Mapping[int, CopyView]:
        """The newest of every copy that can be seen, by seat."""
        return self._desk.views()

    def overview(self) -> Overview:
        """How things were at the last `tick`."""
        return self._overview

    def point(self, seat: int, pointer: Pointer) -> None:
        """Moves the own pointer; see `Stage.point`.

        Raises:
            SessionError: it is not the own seat, or a number is wrong.
        """
        self._own({"seat": seat})
        self._desk.point(self._name, _wishes.checked(pointer, self._replica.body))

    def do(self, what: str, arguments: Mapping[str, Any]) -> str:
        """See `Stage.do`.

        Raises:
            SessionError: it cannot be done.
        """
        doing: dict[str, Callable[[Mapping[str, Any]], str]] = {
            "hand": self._do_hand,
            "record": lambda given: self._jobs.ask(
                lambda: self._tapes.switch(_wishes.flag_of(given), time.monotonic())
            ),
        }
        if what not in doing:
            raise SessionError(f'"{what}" is for the host\'s page; here can be done: {", ".join(doing)}')
        return doing[what](arguments)

    def recorded(self) -> bytes | None:
        """The last finished recording of the own copy as a ZIP archive; None before there is one."""
        return self._tapes.archive

    def _do_hand(self, given: Mapping[str, Any]) -> str:
        self._own(given)
        mode, node, to = _wishes.hand_of(given, self._replica.body)
        self._desk.hand(self._name, mode, node=node, to=to)
        return f"{self._name} {_wishes.WORDS[mode]}"

    def _own(self, given: Mapping[str, Any]) -> None:
        seat = self.seat
        if seat is None:
            raise SessionError(f"{self._name} does not move yet; wait a moment")
        _wishes.seat_of(given, (seat,))


@contextmanager
def member_stage(
    invitation: Invitation,
    *,
    name: str,
    listen: str | None = None,
    options: Sequence[str] = (),
) -> Generator[MemberStage]:
    """Takes part in a session by a process of its own, and sees it from here.

    Args:
        invitation: to the session.
        name: that others see.
        listen: address in numbers to listen on; None: the one by which this machine reaches the host.
        options: of `cotouch join` besides.

    Raises:
        TransportError: the host, the network or this machine refuses.
        SessionError: it is no session of this version.
    """
    control = ZenohControl(invitation, Identity.make(os.urandom), listen=listen or "reachable")
    try:
        with TemporaryDirectory(prefix="cotouch-") as folder, board_folder() as boards:
            session = fetch_session(control, invitation.digest, Path(folder))
            stage = MemberStage(
                session,
                Replica.build(session),
                Watch(control, host=invitation.host),
                invitation,
                boards,
                name=name,
                options=[*([] if listen is None else ["--listen", listen]), *options],
            )
            try:
                yield stage
            finally:
                stage.close()
    finally:
        control.close()
