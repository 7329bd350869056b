"""What can be seen of a session without taking part: the roster and what members say of themselves."""

from collections import deque
from dataclasses import dataclass
from typing import NamedTuple, final

from cotouch.live import ControlPlane, Message
from cotouch.session._coordinator import believed
from cotouch.session._links import Pair
from cotouch.session._messages import Entry, Roster, Status, read

# Topic of a status that the host hands on.
HANDED_ON = "seen"
_MOST_EVENTS = 200
# So many names are remembered, those heard of last.
_MOST_NAMES = 256
# A status is older than this if its sender is gone or stuck [s].
STALE = 2.0


class Event(NamedTuple):
    """Something worth a line.

    Attributes:
        time: [s].
        text: what happened.
    """

    time: float
    text: str


@final
@dataclass
class Seen:
    """One member.

    Attributes:
        entry: of the roster.
        status: its last; None before the first.
        time: when that came [s].
    """

    entry: Entry
    status: Status | None = None
    time: float = -float("inf")

    def stale(self, now: float) -> bool:
        """Whether nothing was heard of it for a while."""
        return now - self.time > STALE


@final
class Watch:
    """Follows a session.

    Attributes:
        roster: the newest.
        members: by seat; those who left are gone.
        events: the last ones, oldest first.
        ended: whether the host ended the session.
        last: the last status of who took part, by name; of the 256 names heard of last.
    """

    def __init__(self, control: ControlPlane, *, host: bytes) -> None:
        """Begins to watch.

        Args:
            control: the control plane; polled by `service`, or by its owner who hands messages to `hear`.
            host: public key of the host.
        """
        self.roster = Roster()
        self.members: dict[int, Seen] = {}
        self.events = deque[Event](maxlen=_MOST_EVENTS)
        self.ended = False
        self.last: dict[str, Status] = {}
        self._control = control
        self._host = host

    def service(self, now: float) -> None:
        """Hears what was said since the last call.

        Args:
            now: [s].
        """
        present = self._control.present()
        for message in self._control.poll():
            self.hear(message, present, now)

    def hear(self, message: Message, present: frozenset[bytes], now: float) -> None:
        """Takes one message.

        Args:
            message: what was said.
            present: public keys of those who are there.
            now: [s].
        """
        if message.topic == "roster":
            roster = read(Roster, message.body)
            if roster is not None and believed(roster, self.roster, message.sender, self._host, present):
                self.follow(roster, now)
        elif message.topic == "status":
            status, entry = read(Status, message.body), self.roster.of(message.sender)
            if status is not None and entry is not None and entry.seat == status.seat:
                self._note(entry, status, now)
        elif message.topic == HANDED_ON and message.sender == self._host:
            status = read(Status, message.body)
            entry = None if status is None else self.roster.by_seat().get(status.seat)
            if status is not None and entry is not None and bytes.fromhex(entry.key) not in present:
                self._note(entry, status, now)
        elif message.topic == "end" and message.sender == self._host:
            self.ended = True

    def follow(self, roster: Roster, now: float) -> None:
        """Takes a roster that is to be believed, if it is newer."""
        if roster.epoch <= self.roster.epoch:
            return
        before, after = self.roster.by_seat(), roster.by_seat()
        for seat, entry in before.items():
            if seat not in after or after[seat].key != entry.key:
                self.events.append(Event(now, f"{entry.name} left"))
                self.members.pop(seat, None)
        for seat, entry in after.items():
            if seat not in self.members:
                self.events.append(Event(now, f"{entry.name} joined"))
                self.members[seat] = Seen(entry)
        gone, come = set(self.roster.links) - set(roster.links), set(roster.links) - set(self.roster.links)
        if (gone or come) and self.roster.links and before.keys() == after.keys():
            self.events.append(Event(now, f"links changed: {_pairs(come)} for {_pairs(gone)}"))
        self.roster = roster

    def paths(self) -> dict[Pair, float]:
        """Quickest way there and back of each pair of those who are there, as far as either said one [s]."""
        found: dict[Pair, float] = {}
        for seat, seen in self.members.items():
            for other, both in ({} if seen.status is None else seen.status.measured()).items():
                if other in self.members and other != seat:
                    pair = (min(seat, other), max(seat, other))
                    found[pair] = min(both, found.get(pair, both))
        return found

    def _note(self, entry: Entry, status: Status, now: float) -> None:
        seen = self.members.setdefault(entry.seat, Seen(entry))
        before = {link.seat: link.state for link in seen.status.links} if seen.status is not None else {}
        for link in status.links:
            was = before.get(link.seat)
            other = self.roster.by_seat().get(link.seat)
            if other is not None and was != link.state and "coupled" in (was, link.state):
                told = "coupled with" if link.state == "coupled" else "guards itself from"
                self.events.append(Event(now, f"{entry.name} {told} {other.name}"))
        if seen.status is not None and status.alarms > seen.status.alarms:
            self.events.append(Event(now, f"ALARM: the energy books of {entry.name} do not balance"))
        seen.status, seen.time = status, now
        self.last.pop(entry.name, None)
        self.last[entry.name] = status
        if len(self.last) > _MOST_NAMES:
            del self.last[next(iter(self.last))]


def _pairs(links: set[tuple[int, int]]) -> str:
    return ", ".join(f"{a + 1}-{b + 1}" for a, b in sorted(links)) or "none"
