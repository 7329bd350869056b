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
from cotouch.session import _requests
from cotouch.session._command_client import CommandClient
from cotouch.session._commanded_hand import usual_stiffness
from cotouch.session._file import SessionFile
from cotouch.session._jobs import Jobs
from cotouch.session._join import fetch_session
from cotouch.session._mailboxes import MailboxFolder, mailbox_folder
from cotouch.session._moment import LastMoment
from cotouch.session._process import MemberProcess
from cotouch.session._recording import RecordingClient
from cotouch.session._session_api import CopyView, Overview, Pointer, Scene
from cotouch.session._shared_model import SharedModel
from cotouch.session._watch import SessionEvent, SessionWatch

_MOST_EVENTS = 200


@final
class MemberSessionApi:
    """Implements `SessionApi`.

    `tick` and `close` belong to the loop that moves it.

    Attributes:
        watch: what is seen of the session.
        member: the process of the own copy.
        over: whether that has ended, at the last `tick`.
    """

    def __init__(
        self,
        session: SessionFile,
        replica: SharedModel,
        watch: SessionWatch,
        invitation: Invitation,
        mailboxes: MailboxFolder,
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
            mailboxes: where the member is shown and told things.
            name: that others see.
            options: of `cotouch join` besides.

        Raises:
            InputError: a mailbox cannot be made.
        """
        self.watch = watch
        self._name, self._invitation = name, invitation.encode()
        self._session, self._replica = session, replica
        self._commands = CommandClient(mailboxes, session, [name])
        self._recording = RecordingClient(mailboxes, self._commands, [name], self._say)
        self._moment = LastMoment()
        self._jobs = Jobs()
        self._events = deque[SessionEvent](maxlen=_MOST_EVENTS)
        self.over = False
        self._left: tuple[int, str] | None = None
        self.member = MemberProcess(
            invitation, ["--name", name, "--headless", "--mailboxes", str(mailboxes.path), *options]
        )
        self._overview = self._looked(time.monotonic())

    @property
    def slot(self) -> int | None:
        """Of the own copy; None before it moves."""
        slot = self._commands.number(self._name, "slot")
        return slot if slot >= 0 and self._commands.number(self._name, "step") > 0 else None

    def tick(self, now: float) -> None:
        """Sees what is new; to be called some fifty times a second.

        Args:
            now: on the monotonic clock [s].
        """
        self.watch.service(now)
        self._jobs.turn()
        running = self.member.running
        self._recording.turn(now, [self._name] if running else [], ended=self.watch.ended or not running)
        if not running and not self.over:
            self.over = True
            self._say(now, f"{self._name} takes part no more")
        self._overview = self._looked(now)

    def recording_left(self) -> tuple[list[str], str | None]:
        """What went wrong with recordings that were ordered here, and where the last is kept that nobody fetched."""
        kept = self._recording.close(time.monotonic())
        return self._recording.troubles, kept

    def close(self) -> tuple[int, str]:
        """Lets the process leave; its exit code, and what it printed."""
        if self._left is None:
            self._jobs.close()
            code = self.member.stop()
            self._left = code, self.member.said()
            self._recording.turn(time.monotonic(), (), ended=True)
            self.member.close()
            self._commands.close()
        return self._left

    def _say(self, now: float, text: str) -> None:
        self._events.append(SessionEvent(now, text))

    def _looked(self, now: float) -> Overview:
        watch, slot = self.watch, self.slot
        events = sorted([*watch.events, *self._events], key=lambda event: event.time)
        return self._moment.seen(
            Overview(
                time=now,
                roster=watch.roster,
                statuses={other: seen.status for other, seen in watch.members.items() if seen.status is not None},
                alive={} if slot is None else {slot: not self.over},
                emulated={},
                choices={},
                damping=1.0,
                recording=self._recording.look(now),
                events=events[-_MOST_EVENTS:],
                ended=watch.ended or self.over,
            )
        )

    # -- any thread --------------------------------------------------------------------------------------------------

    @property
    def scene(self) -> Scene:
        """What does not change, once the own copy moves."""
        scenario, slot = self._replica.scenario, self.slot
        return Scene(
            title=self._session.scenario.title or "cotouch",
            users=tuple(self._session.scenario.network.users),
            body=self._replica.body,
            own=() if slot is None else (slot,),
            may=frozenset({"hand", "record"}),
            invitation=self._invitation,
            stiffness=usual_stiffness(scenario, slot or 0),
        )

    def views(self) -> Mapping[int, CopyView]:
        """The newest of every copy that can be seen, by slot."""
        return self._commands.views()

    def overview(self) -> Overview:
        """How things were at the last `tick`."""
        return self._overview

    def point(self, slot: int, pointer: Pointer) -> None:
        """Moves the own pointer; see `SessionApi.point`.

        Args:
            slot: the user's.
            pointer: where the hand is to be.

        Raises:
            SessionError: it is not the own slot, or a number is wrong.
        """
        self._own({"slot": slot})
        self._commands.point(self._name, _requests.checked(pointer, self._replica.body))

    def do(self, what: str, arguments: Mapping[str, Any]) -> str:
        """See `SessionApi.do`.

        Args:
            what: name of the request.
            arguments: of the request.

        Raises:
            SessionError: it cannot be done.
        """
        doing: dict[str, Callable[[Mapping[str, Any]], str]] = {
            "hand": self._do_hand,
            "record": lambda given: self._jobs.ask(
                lambda: self._recording.switch(_requests.flag_of(given), time.monotonic())
            ),
        }
        if what not in doing:
            raise SessionError(f'"{what}" is for the host\'s page; here can be done: {", ".join(doing)}')
        return doing[what](arguments)

    def hold_damping(self, on: bool) -> None:
        """Nothing: damping is not lowered from here."""

    def recorded(self) -> tuple[Path, ...]:
        """Files of the last recording of the own copy that came to its end; empty before there is one."""
        return self._recording.hand_out()

    def _do_hand(self, given: Mapping[str, Any]) -> str:
        self._own(given)
        mode, node, to = _requests.hand_of(given, self._replica.body)
        self._commands.hand(self._name, mode, node=node, to=to)
        return f"{self._name} {_requests.WORDS[mode]}"

    def _own(self, given: Mapping[str, Any]) -> None:
        slot = self.slot
        if slot is None:
            raise SessionError(f"{self._name} does not move yet; wait a moment")
        _requests.slot_of(given, (slot,))


@contextmanager
def member_session_api(
    invitation: Invitation,
    *,
    name: str,
    listen: str | None = None,
    options: Sequence[str] = (),
) -> Generator[MemberSessionApi]:
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
        with TemporaryDirectory(prefix="cotouch-") as folder, mailbox_folder() as mailboxes:
            session = fetch_session(control, invitation, Path(folder))
            api = MemberSessionApi(
                session,
                SharedModel.build(session),
                SessionWatch(control, host=invitation.host, network=session.scenario.network),
                invitation,
                mailboxes,
                name=name,
                options=[*([] if listen is None else ["--listen", listen]), *options],
            )
            try:
                yield api
            finally:
                api.close()
    finally:
        control.close()
