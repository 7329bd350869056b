"""Who may take part, in which seat, and linked to whom: decided by one member at a time, known to all.

The host decides as long as it is there. When it is gone, the member in the lowest seat that is still there does; every
member works this out by itself, and believes no other. What is decided is a roster with a number that rises. Nothing
here waits, and it opens nothing: messages and times in, messages out.
"""

from collections.abc import Callable
from typing import NamedTuple, final

from cotouch.live import Message
from cotouch.network import Network
from cotouch.session._file import SessionFile
from cotouch.session._links import Pair, delays_of, present_links
from cotouch.session._messages import Entry, Join, Refused, Roster, Status, read, write
from cotouch.session._replica import same_body

# Who is not seen for this long has left: longer than a path takes to come back after a short outage [s].
ABSENT_AFTER = 6.0
# A roster is said again, for those who were cut off when it changed [s].
_REPEAT = 2.0
# Links are planned anew at most this often, and only where a delay changed by this much [s].
_REPLAN_EVERY = 10.0
_REPLAN_SHARE = 0.25
_REPLAN_LEAST = 2e-3
# Who came is measured for so long before links are planned without what is still not known [s].
_MEASURE = 5.0

Planner = Callable[[list[int], dict[Pair, float]], list[Pair] | None]


class Outgoing(NamedTuple):
    """A message to be sent; `to` is None for everybody."""

    topic: str
    body: bytes
    to: bytes | None = None


def acting(roster: Roster, host: bytes, present: frozenset[bytes]) -> bytes | None:
    """Public key of the one who decides: the host, or else the lowest seat that is there; None: nobody."""
    if host in present:
        return host
    there = {entry.seat: bytes.fromhex(entry.key) for entry in roster.members}
    return next((there[seat] for seat in sorted(there) if there[seat] in present), None)


def believed(roster: Roster, known: Roster, sender: bytes, host: bytes, present: frozenset[bytes]) -> bool:
    """Whether a roster is newer and comes from the one who decides.

    Args:
        roster: that was said.
        known: the newest so far; one who knows none takes it from the one who decides among those it names.
        sender: public key of who said it.
        host: public key of the host.
        present: public keys of those who are there.
    """
    return roster.epoch > known.epoch and sender == acting(known if known.members else roster, host, present)


@final
class Coordinator:
    """Keeps the roster while this member is the one who decides.

    Attributes:
        roster: the newest.
        refused: how many wishes were refused.
    """

    def __init__(
        self, session: SessionFile, *, planner: Planner | None = None, fingerprint: list[float] | None = None
    ) -> None:
        """Starts with nobody.

        Args:
            session: what was asked for.
            planner: seats and measured times there and back in, links out, or None while it is still at work; for
                links = "plan".
            fingerprint: of the body; of the first who joins, if not given.
        """
        self.roster = Roster()
        self.refused = 0
        self._session = session
        self._planner = planner
        self._fingerprint = fingerprint
        self._chosen: Network | None = None
        self._seen: dict[str, float] = {}
        self._present: set[str] = set()
        self._said = -float("inf")
        self._out: list[Outgoing] = []
        self._paths: dict[Pair, float] = {}
        self._planned: tuple[list[int], dict[Pair, float]] | None = None
        self._asked: tuple[list[int], dict[Pair, float]] | None = None
        self._planned_at = -float("inf")
        self._changed: float | None = None

    def adopt(self, roster: Roster, now: float) -> None:
        """Goes on from a roster that somebody else made."""
        if roster.epoch >= self.roster.epoch:
            self._forget_paths(roster.members)
            self.roster = roster
            self._seen = {entry.key: now for entry in roster.members}

    def hear(self, message: Message, now: float) -> None:
        """Takes a message that is for the one who decides; others are left alone."""
        if message.topic == "join":
            wish = read(Join, message.body)
            if wish is not None:
                self._join(wish, message.sender, now)
        elif message.topic == "leave":
            self._remove({message.sender.hex()})
        elif message.topic == "status":
            said, entry = read(Status, message.body), self.roster.of(message.sender)
            if said is not None and entry is not None:
                for seat, both in said.measured().items():
                    if seat != entry.seat:
                        self.measured((min(entry.seat, seat), max(entry.seat, seat)), both)

    def choose(self, links: list[Pair]) -> None:
        """Takes links that somebody chose in place of the session's and of a plan; who comes is joined to somebody.

        Args:
            links: pairs of seats.

        Raises:
            NetworkError: a pair has no spring, or there are no such seats.
        """
        self._chosen = self._session.scenario.network.with_links(links)
        seats = [entry.seat for entry in self.roster.members]
        wanted = present_links(self._chosen, seats)
        if wanted != self.roster.links:
            self._announce(self.roster.members, wanted)

    def measured(self, pair: Pair, both: float) -> None:
        """Takes a time there and back of a pair, linked or not, the smaller seat first [s]."""
        self._paths[pair] = both

    def tick(self, now: float, present: frozenset[bytes]) -> list[Outgoing]:
        """What is to be sent now.

        Args:
            now: [s].
            present: public keys of those who are there, this member included.
        """
        keys = self._present = {key.hex() for key in present}
        for entry in self.roster.members:
            if entry.key in keys:
                self._seen[entry.key] = now
        gone = {e.key for e in self.roster.members if now - self._seen.get(e.key, now) > ABSENT_AFTER}
        if gone:
            self._remove(gone)
        self._replan(now)
        if now - self._said >= _REPEAT:
            self._said = now
            self._out.append(Outgoing("roster", write(self.roster)))
        out, self._out = self._out, []
        return out

    def _join(self, wish: Join, key: bytes, now: float) -> None:
        own = self.roster.of(key)
        if own is not None:  # it did not hear of it yet
            self._said = -float("inf")
            return
        seat = self._seat(wish)
        if isinstance(seat, str):
            self.refused += 1
            self._out.append(Outgoing("refused", write(Refused(reason=seat)), key))
            return
        self._fingerprint = wish.fingerprint
        others = [entry for entry in self.roster.members if entry.seat != seat]
        entry = Entry(seat=seat, name=wish.name, key=key.hex())
        self._seen[entry.key] = now
        self._change(sorted([*others, entry], key=lambda entry: entry.seat))

    def _seat(self, wish: Join) -> int | str:
        """The seat that a newcomer gets, or why it gets none."""
        if self._fingerprint is not None and not same_body(wish.fingerprint, self._fingerprint):
            return "this machine built another body from the same file; use the same version of cotouch as the others"
        holder = next((entry for entry in self.roster.members if entry.name == wish.name), None)
        if holder is not None and holder.key not in self._present:  # it crashed, and this is it again
            return holder.seat
        if holder is not None:
            return f'the name "{wish.name}" is taken by somebody who is here; choose another with --name'
        users = self._session.scenario.network.users
        if self._session.named and wish.name in users:
            seat = users.index(wish.name)
            if seat not in {entry.seat for entry in self.roster.members}:
                return seat
        taken = {entry.seat for entry in self.roster.members}
        free = [seat for seat in range(len(users)) if seat not in taken]
        if not free:
            return f"all {len(users)} seats of this session are taken"
        return free[0]

    def _remove(self, keys: set[str]) -> None:
        left = [entry for entry in self.roster.members if entry.key not in keys]
        if len(left) < len(self.roster.members):
            for key in keys:
                self._seen.pop(key, None)
            self._change(left)

    def _change(self, members: list[Entry]) -> None:
        seats = [entry.seat for entry in members]
        self._forget_paths(members)
        self._seen = {entry.key: self._seen[entry.key] for entry in members if entry.key in self._seen}
        network = self._session.scenario.network
        if self._planner is None or self._chosen is not None:
            links = present_links(self._chosen or network, seats)
        else:  # what is there is kept until a plan is made, and everybody is joined to somebody
            kept = network.with_links(self.roster.links) if self.roster.links else network.with_links([])
            links = present_links(kept, seats)
        self._announce(members, links)

    def _forget_paths(self, members: list[Entry]) -> None:
        """What was measured of a seat that is now somebody else's, or nobody's, is of no use."""
        same = {entry.seat for entry in self.roster.members if entry in members}
        self._paths = {pair: both for pair, both in self._paths.items() if set(pair) <= same}
        self._changed = None

    def _announce(self, members: list[Entry], links: list[Pair]) -> None:
        self.roster = Roster(epoch=self.roster.epoch + 1, members=members, links=links)
        self._said = -float("inf")

    def _replan(self, now: float) -> None:
        if self._planner is None or self._chosen is not None or len(self.roster.members) < 2:
            return
        seats = [entry.seat for entry in self.roster.members]
        if self._asked is None:
            if not self._worth_it(now, seats):
                return
            self._asked = (seats, {pair: both for pair, both in self._paths.items() if set(pair) <= set(seats)})
        links = self._planner(*self._asked)
        if links is None:
            return
        asked, self._asked = self._asked, None
        self._planned, self._planned_at = asked, now
        if asked[0] == seats and sorted(links) != self.roster.links:
            self._announce(self.roster.members, sorted(links))

    def _worth_it(self, now: float, seats: list[int]) -> bool:
        if self._planned is None or self._planned[0] != seats:
            self._changed = now if self._changed is None else self._changed
            known = all((a, b) in self._paths for a in seats for b in seats if a < b)
            return known or now - self._changed >= _MEASURE
        if not self._session.options.replan or now - self._planned_at < _REPLAN_EVERY:
            return False
        before = delays_of(self._session.scenario.network, self._planned[1])
        after = delays_of(self._session.scenario.network, self._paths)
        change = abs(after - before)
        return bool((change > _REPLAN_SHARE * before + _REPLAN_LEAST).any())
