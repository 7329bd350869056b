"""What is the same whoever's members a page sees and steers: their mailboxes, recordings, events and requests."""

import time
from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Mapping
from pathlib import Path

from cotouch.body import Body
from cotouch.members import SessionEvent, SessionFile, SessionWatch
from cotouch.network import Pair
from cotouch.observers import (
    ChooseLinks,
    Command,
    CommandClient,
    CopyView,
    Cut,
    Expel,
    Impair,
    Jobs,
    Kill,
    LastMoment,
    MailboxFolder,
    MoveHand,
    Overview,
    Pointer,
    RecordingClient,
    Revive,
    SetDamping,
    SetRecording,
)
from cotouch.session import _requests

_MOST_EVENTS = 200


class SteeredMembers(ABC):
    """The part of a `SessionApi` that needs nothing but members' mailboxes."""

    def __init__(self, session: SessionFile, body: Body, mailboxes: MailboxFolder, names: list[str]) -> None:
        """Opens the mailboxes.

        Args:
            session: that they take part in.
            body: as built here.
            mailboxes: where members are shown and told things.
            names: of the members.

        Raises:
            InputError: a mailbox cannot be made.
        """
        self._session, self._body, self._names = session, body, names
        self._commands = CommandClient(mailboxes, session, names)
        self._recording = RecordingClient(mailboxes, self._commands, names, self._say)
        self._jobs, self._moment = Jobs(), LastMoment()
        self._events = deque[SessionEvent](maxlen=_MOST_EVENTS)

    # -- the loop ----------------------------------------------------------------------------------------------------

    def recording_left(self) -> tuple[list[str], str | None]:
        """What went wrong with recordings that were ordered here, and where the last is kept that nobody fetched."""
        kept = self._recording.close(time.monotonic())
        return self._recording.troubles, kept

    def _say(self, now: float, text: str) -> None:
        self._events.append(SessionEvent(now, text))

    def _look(
        self,
        now: float,
        watch: SessionWatch,
        *,
        alive: dict[int, bool],
        ended: bool,
        choices: Mapping[str, list[Pair]] | None = None,
        emulated: bool = False,
        damping: float = 1.0,
    ) -> Overview:
        """How things are now, as `Overview` has it."""
        events = sorted([*watch.events, *self._events], key=lambda event: event.time)
        return self._moment.seen(
            Overview(
                time=now,
                roster=watch.roster,
                statuses={slot: seen.status for slot, seen in watch.members.items() if seen.status is not None},
                alive=alive,
                emulated=self._commands.emulated() if emulated else {},
                choices=dict(choices or {}),
                damping=damping,
                recording=self._recording.look(now),
                events=events[-_MOST_EVENTS:],
                left=watch.left,
                ended=ended,
            )
        )

    # -- any thread --------------------------------------------------------------------------------------------------

    def views(self) -> Mapping[int, CopyView]:
        """The newest of every copy that can be seen, by slot."""
        return self._commands.views()

    def recorded(self) -> tuple[Path, ...]:
        """Files of the last recording that came to its end; empty before there is one."""
        return self._recording.hand_out()

    def point(self, slot: int, pointer: Pointer) -> None:
        """Moves a user's pointer; see `SessionApi.point`.

        Args:
            slot: of the user.
            pointer: where the hand is to be.

        Raises:
            SessionError: nothing can be done for this slot from here, or a number is wrong.
        """
        name = self._name_of(slot)
        self._acts()
        self._commands.point(name, _requests.checked(pointer, self._body, slot, cuts=self._may_cut(slot)))

    def do(self, command: Command) -> str:
        """See `SessionApi.do`; waits for the loop where it has to do it.

        Args:
            command: what to do.

        Raises:
            SessionError: it cannot be done.
        """
        self._acts()
        match command:
            case MoveHand():
                name = self._name_of(command.slot)
                _requests.check_hand(command, self._body, cuts=self._may_cut(command.slot))
                where = {"to": command.to, "at": command.at, "edge": command.edge, "turn": command.turn}
                self._commands.hand(name, command.mode, node=command.node, **where)
                return f"{name} {_requests.WORDS[command.mode]}"
            case SetRecording():
                return self._jobs.ask(lambda: self._recording.switch(command.on, time.monotonic()))
            case _:
                return self._do_more(command)

    def _may_cut(self, slot: int) -> bool:
        """Whether a user's blade cuts."""
        cutting = self._session.scenario.cutting
        return cutting is None or cutting.may(slot + 1)

    @abstractmethod
    def _acts(self) -> None:
        """Somebody acts now."""

    @abstractmethod
    def _name_of(self, slot: int) -> str:
        """Of the member that has a slot.

        Raises:
            SessionError: none has that is steered from here.
        """

    @abstractmethod
    def _do_more(self, command: Impair | Cut | Kill | Revive | Expel | ChooseLinks | SetDamping) -> str:
        """Does what not everybody can who steers members.

        Raises:
            SessionError: it cannot be done.
        """
