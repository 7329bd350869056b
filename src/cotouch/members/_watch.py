"""What can be seen of a session without taking part: the roster and what members say of themselves."""

from collections import deque
from dataclasses import dataclass
from typing import NamedTuple, final

from cotouch.control import ControlPlane, SignedMessage
from cotouch.members._messages import Decided, Entry, Roster, Status, read_message
from cotouch.members._succession import Belief
from cotouch.network import Network, Pair

# Topic of a status that the host hands on.
HANDED_ON = "seen"
_MOST_EVENTS = 200
# So many names are remembered, those heard of last.
_MOST_NAMES = 256
# A status is older than this if its sender is gone or stuck [s].
STALE = 2.0


class SessionEvent(NamedTuple):
    """An event worth a line.

    Attributes:
        time: [s].
        text: what happened.
    """

    time: float
    text: str


@final
@dataclass
class MemberState:
    """What is known about one member.

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
class SessionWatch:
    """Follows a session.

    Attributes:
        roster: the newest.
        members: by slot; those who left are gone.
        events: the last ones, oldest first.
        ended: whether the host ended the session.
        last: the last status of who took part, by name; of the 256 names heard of last.
        left: whether somebody took a part of the session's ledger along, who left or began anew: what the others got
            out is no longer beside all that was put in.
    """

    def __init__(self, control: ControlPlane, *, host: bytes, network: Network | None = None) -> None:
        """Begins to watch.

        Args:
            control: the control plane; polled by `service`, or by its owner who hands messages to `receive`.
            host: public key of the host.
            network: of the session, if it is known: nobody is then believed to be beyond it.
        """
        self.roster = Roster()
        self._belief = Belief(host, network=network)
        self._complained: str | None = None
        self.members: dict[int, MemberState] = {}
        self.events = deque[SessionEvent](maxlen=_MOST_EVENTS)
        self.ended = False
        self.last: dict[str, Status] = {}
        self.left = False
        self._control = control
        self._host = host

    def service(self, now: float) -> None:
        """Hears what was said since the last call.

        Args:
            now: [s].
        """
        present = self._control.present()
        for message in self._control.poll():
            self.receive(message, present, now)
        if self._belief.settle(self.votes(now), present):
            self.follow(self._belief.roster, now)

    def receive(self, message: SignedMessage, present: frozenset[bytes], now: float) -> None:
        """Takes one message.

        Args:
            message: what was said.
            present: public keys of those who are there.
            now: [s].
        """
        if message.topic == "roster":
            decided = read_message(Decided, message.body)
            if decided is not None and self._belief.receive(decided, message.sender, present):
                self.follow(self._belief.roster, now)
            self._complain(now)
        elif message.topic == "status":
            status, entry = read_message(Status, message.body), self.roster.of(message.sender)
            if status is not None and entry is not None and entry.slot == status.slot:
                self._note(entry, status, now)
        elif message.topic == HANDED_ON and message.sender == self._host:
            status = read_message(Status, message.body)
            entry = None if status is None else self.roster.by_slot().get(status.slot)
            if status is not None and entry is not None and bytes.fromhex(entry.key) not in present:
                self._note(entry, status, now)
        elif message.topic == "end" and message.sender == self._host:
            self.ended = True

    def follow(self, roster: Roster, now: float) -> None:
        """Takes a roster that is to be believed.

        Args:
            roster: who takes part.
            now: time [s].
        """
        if roster == self.roster:
            return
        before, after = self.roster.by_slot(), roster.by_slot()
        self.left |= len(roster.owners()) > len(after)
        for slot, entry in before.items():
            if slot not in after or after[slot].key != entry.key:
                self.events.append(SessionEvent(now, f"{entry.name} left"))
                self.members.pop(slot, None)
        for slot, entry in after.items():
            if slot not in self.members:
                self.events.append(SessionEvent(now, f"{entry.name} joined"))
                self.members[slot] = MemberState(entry)
        gone, come = set(self.roster.links) - set(roster.links), set(roster.links) - set(self.roster.links)
        if (gone or come) and self.roster.links and before.keys() == after.keys():
            self.events.append(SessionEvent(now, f"links changed: {_pairs(come)} for {_pairs(gone)}"))
        self.roster = roster

    def note(self, now: float, text: str) -> None:
        """Adds something worth a line [s].

        Args:
            now: when [s].
            text: the words.
        """
        self.events.append(SessionEvent(now, text))

    def votes(self, now: float) -> dict[bytes, str | None]:
        """Digest of the roster that members work with, as far as they said so just now, by their keys."""
        fresh = [seen for seen in self.members.values() if seen.status is not None and not seen.stale(now)]
        return {bytes.fromhex(seen.entry.key): seen.status.roster for seen in fresh if seen.status is not None}

    def _complain(self, now: float) -> None:
        """Says once why whoever decides is not believed."""
        complaint = self._belief.complaint
        if complaint is not None and complaint != self._complained:
            self.events.append(SessionEvent(now, f"ALARM: a roster was rejected: {complaint}"))
        self._complained = complaint

    def paths(self) -> dict[Pair, float]:
        """Quickest way there and back of each pair of those who are there, as far as either said one [s]."""
        found: dict[Pair, float] = {}
        for slot, seen in self.members.items():
            for other, both in ({} if seen.status is None else seen.status.measured()).items():
                if other in self.members and other != slot:
                    pair = (min(slot, other), max(slot, other))
                    found[pair] = min(both, found.get(pair, both))
        return found

    def _note(self, entry: Entry, status: Status, now: float) -> None:
        seen = self.members.setdefault(entry.slot, MemberState(entry))
        links = [] if seen.status is None else seen.status.links
        before = {link.slot: link.state for link in links}
        beyond = {link.slot for link in links if link.asked is not None}
        for link in status.links:
            was = before.get(link.slot)
            other = self.roster.by_slot().get(link.slot)
            if other is not None and was != link.state and "coupled" in (was, link.state):
                told = {"coupled": "coupled with", "waiting": "receives nothing from"}.get(
                    link.state, "guards its link to"
                )
                self.events.append(SessionEvent(now, f"{entry.name} {told} {other.name}"))
            if other is not None and link.asked is not None and link.slot not in beyond:
                asked, granted = f"{link.asked:.3g} s", f"{link.budget or 0.0:.3g} s"
                self.events.append(
                    SessionEvent(
                        now,
                        f"{other.name} asks {entry.name} for damping for samples up to {asked} old; {granted} is "
                        f"granted",
                    )
                )
        self.left |= seen.status is not None and status.steps < seen.status.steps
        if status.device and (seen.status is None or status.device != seen.status.device):
            self.events.append(SessionEvent(now, f"{entry.name}'s device: {status.device}"))
        if seen.status is not None and status.alarms > seen.status.alarms:
            self.events.append(SessionEvent(now, f"ALARM: the energy ledger of {entry.name} does not balance"))
        if status.closure_alarms and not (seen.status is not None and seen.status.closure_alarms):
            self.events.append(
                SessionEvent(now, f"ALARM: forces and energy of {entry.name}'s copy disagree; its steps are too long")
            )
        if status.recording == "failed" and (seen.status is None or seen.status.recording != "failed"):
            why = f": {status.recording_failure}" if status.recording_failure else ""
            self.events.append(SessionEvent(now, f"ALARM: the recording of {entry.name} stopped{why}"))
        seen.status, seen.time = status, now
        self.last.pop(entry.name, None)
        self.last[entry.name] = status
        if len(self.last) > _MOST_NAMES:
            del self.last[next(iter(self.last))]


def _pairs(links: set[tuple[int, int]]) -> str:
    return ", ".join(f"{a + 1}-{b + 1}" for a, b in sorted(links)) or "none"
