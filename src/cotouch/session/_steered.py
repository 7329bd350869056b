"""What is the same whoever's members a page sees and steers: their mailboxes, recordings, events and requests."""

import time
from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from cotouch.body import Body
from cotouch.errors import SessionError
from cotouch.members import Pair, SessionEvent, SessionFile, SessionWatch
from cotouch.observers import (
    CommandClient,
    CopyView,
    Jobs,
    LastMoment,
    MailboxFolder,
    Overview,
    Pointer,
    RecordingClient,
)
from cotouch.session import _requests

_MOST_EVENTS = 200

Doing = Mapping[str, Callable[[Mapping[str, Any]], str]]


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
        name = self._name_of({"slot": slot})
        self._acts()
        self._commands.point(name, _requests.checked(pointer, self._body))

    def do(self, what: str, arguments: Mapping[str, Any]) -> str:
        """See `SessionApi.do`; waits for the loop where it has to do it.

        Args:
            what: name of the request.
            arguments: of the request.

        Raises:
            SessionError: it cannot be done.
        """
        doing = self._doing()
        if what not in doing:
            raise SessionError(self._refusal(what, ", ".join(doing)))
        self._acts()
        return doing[what](arguments)

    def _do_hand(self, given: Mapping[str, Any]) -> str:
        name = self._name_of(given)
        mode, node, to = _requests.hand_of(given, self._body)
        self._commands.hand(name, mode, node=node, to=to)
        return f"{name} {_requests.WORDS[mode]}"

    def _do_record(self, given: Mapping[str, Any]) -> str:
        return self._recording.switch(_requests.flag_of(given), time.monotonic())

    @abstractmethod
    def _acts(self) -> None:
        """Somebody acts now."""

    @abstractmethod
    def _name_of(self, given: Mapping[str, Any]) -> str:
        """Of the member whose slot a request names.

        Raises:
            SessionError: it names none that is steered from here.
        """

    @abstractmethod
    def _doing(self) -> Doing:
        """What can be done from here, by its name."""

    @abstractmethod
    def _refusal(self, what: str, known: str) -> str:
        """What to say of a request that is not known here."""
