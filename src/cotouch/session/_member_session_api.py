"""One's own part in a session as a stage: a process for the own copy, and of the others what it knows of them."""

import time
from collections.abc import Generator, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import final

from cotouch.control import Invitation
from cotouch.errors import SessionError
from cotouch.hands import usual_stiffness
from cotouch.members import SessionFile, SessionWatch, SharedModel
from cotouch.observers import Command, MailboxFolder, Overview, Scene, mailbox_folder
from cotouch.session import _requests
from cotouch.session._join import fetch_session, looking_on
from cotouch.session._process import MemberProcess
from cotouch.session._steered import SteeredMembers


@final
class MemberSessionApi(SteeredMembers):
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
        super().__init__(session, replica.body, mailboxes, [name])
        self.watch = watch
        self._name, self._invitation = name, invitation.encode()
        self._scenario, self._shapes, self._colours = replica.scenario, replica.shapes, replica.colours
        self._texture = replica.texture
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
            self._say(now, f"{self._name} no longer takes part")
        self._overview = self._looked(now)

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

    def _looked(self, now: float) -> Overview:
        alive = {} if self.slot is None else {self.slot: not self.over}
        return self._look(now, self.watch, alive=alive, ended=self.watch.ended or self.over)

    # -- any thread --------------------------------------------------------------------------------------------------

    @property
    def scene(self) -> Scene:
        """What does not change, once the own copy moves."""
        slot = self.slot
        return Scene(
            title=self._session.scenario.title or "cotouch",
            users=tuple(self._session.scenario.network.users),
            body=self._body,
            own=() if slot is None else (slot,),
            may=frozenset({"hand", "record"}),
            invitation=self._invitation,
            stiffness=usual_stiffness(self._scenario, slot or 0),
            shapes=self._shapes,
            colours=self._colours,
            texture=self._texture,
        )

    def overview(self) -> Overview:
        """How things were at the last `tick`."""
        return self._overview

    def hold_damping(self, on: bool) -> None:
        """Nothing: damping is not lowered from here."""

    def _name_of(self, slot: int) -> str:
        own = self.slot
        if own is None:
            raise SessionError(f"{self._name}'s copy is not moving yet; wait a moment")
        _requests.slot_among(slot, (own,))
        return self._name

    def _acts(self) -> None:
        """Nothing here waits for somebody to act."""

    def _do_more(self, command: Command) -> str:
        raise SessionError(f'"{command.what}" is only possible on the host\'s page; possible here: hand, record')


@contextmanager
def member_session_api(
    invitation: Invitation,
    *,
    name: str,
    listen: str | None = None,
    options: Sequence[str] = (),
) -> Generator[MemberSessionApi]:
    """Takes part in a session through a process of its own, and observes it from here.

    Args:
        invitation: to the session.
        name: that others see.
        listen: address in numbers to listen on; None: the one by which this machine reaches the host.
        options: of `cotouch join` besides.

    Raises:
        TransportError: the host, the network or this machine refuses.
        SessionError: it is no session of this version.
    """
    with (
        looking_on(invitation, listen) as control,
        TemporaryDirectory(prefix="cotouch-") as folder,
        mailbox_folder() as mailboxes,
    ):
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
        with closing(api):
            yield api
