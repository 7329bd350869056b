"""Who takes part, in which slot, and linked to whom: decided by one member at a time, known to all.

Who decides, and who believes it, is in `_succession.py`. What is decided is a roster with a number that rises. Nothing
here waits, and it opens nothing: messages and times in, messages out.
"""

from collections.abc import Callable
from typing import NamedTuple, final

from cotouch.control import SignedMessage
from cotouch.errors import SessionError
from cotouch.members._admission import Admission
from cotouch.members._file import SessionFile
from cotouch.members._links import delays_of, present_links
from cotouch.members._messages import (
    LAST_EPOCH,
    MOST_BANNED,
    MOST_NAMES,
    Entry,
    Former,
    Join,
    NameOwner,
    Refused,
    Roster,
    Status,
    read_message,
    write_message,
)
from cotouch.network import Network, Pair

# Who is not seen for this long has left: longer than a path takes to come back after a short outage [s].
ABSENT_AFTER = 6.0
# A roster is said again, for those who were cut off when it changed [s].
_REPEAT = 2.0
# Links are planned anew at most this often, and only where a delay changed by this much [s].
_REPLAN_EVERY = 10.0
_REPLAN_FRACTION = 0.25
_REPLAN_LEAST = 2e-3
# Who came is measured for so long before links are planned without what is still not known [s].
_MEASURE = 5.0

Planner = Callable[[list[int], dict[Pair, float]], list[Pair] | None]


class Outgoing(NamedTuple):
    """A message to be sent; `to` is None for everybody."""

    topic: str
    body: bytes
    to: bytes | None = None


@final
class Coordinator:
    """Keeps the roster while this member is the one that decides.

    Attributes:
        roster: the newest.
        refused: how many requests were refused.
        admission: says who may come in.
    """

    def __init__(
        self,
        session: SessionFile,
        *,
        planner: Planner | None = None,
        fingerprint: list[float] | None = None,
        admission: Admission | None = None,
    ) -> None:
        """Starts with nobody.

        Args:
            session: what was asked for.
            planner: slots and measured times there and back in, links out, or None while it is still at work; for
                links = "plan".
            fingerprint: of the body as built here; None: nobody is answered before `admission` has it.
            admission: says who may come in; by default whoever fits, from wherever.
        """
        self.roster = Roster()
        self.refused = 0
        self.admission = admission or Admission(session, fingerprint=fingerprint)
        self._session = session
        self._planner = planner
        self._chosen: Network | None = None
        self._seen: dict[str, float] = {}
        self._said = -float("inf")
        self._out: list[Outgoing] = []
        self._paths: dict[Pair, float] = {}
        self._planned: tuple[list[int], dict[Pair, float]] | None = None
        self._asked: tuple[list[int], dict[Pair, float]] | None = None
        self._planned_at = -float("inf")
        self._changed: float | None = None

    def adopt(self, roster: Roster, now: float) -> None:
        """Goes on from a roster that somebody else made, or this one before it was started anew.

        Args:
            roster: who takes part.
            now: time [s].
        """
        self._forget_paths(roster.members)
        self.roster = roster
        self._seen = {entry.key: now for entry in roster.members}

    def receive(self, message: SignedMessage, now: float) -> None:
        """Takes a message that is for the one who decides; others are left alone.

        Args:
            message: as it came.
            now: time [s].
        """
        if message.topic == "join":
            request = read_message(Join, message.body)
            if request is not None:
                self._join(request, message.sender.hex(), now)
        elif message.topic == "leave":
            self._remove({message.sender.hex()})
        else:
            self.learn(message)

    def learn(self, message: SignedMessage) -> None:
        """Takes what a member says of its ways, which is of use to whoever decides next, too."""
        said = read_message(Status, message.body) if message.topic == "status" else None
        entry = self.roster.of(message.sender)
        if said is not None and entry is not None:
            slots = self.roster.by_slot()
            for slot, both in said.measured().items():
                if slot != entry.slot and slot in slots:
                    self.measured((min(entry.slot, slot), max(entry.slot, slot)), both)

    def take_up(self, other: Roster, present: frozenset[bytes], now: float, *, instead: bool = False) -> None:
        """Takes up whom another roster has besides, if they are there: as if they had come now.

        Nobody's slot, name or key changes by it.

        Args:
            other: that somebody else decided, meanwhile.
            present: public keys of those who are there.
            now: [s].
            instead: whether one who is not there loses its slot to one who is.
        """
        keys = {key.hex() for key in present}
        wanted = {entry.slot for entry in other.members if instead and entry.key in keys}
        members = [entry for entry in self.roster.members if entry.key in keys or entry.slot not in wanted]
        owners = self.roster.owners()
        for entry in other.members:
            # One that was started anew meanwhile asks again by itself: another's word for it would cut its links.
            mine = next((known for known in members if known.key == entry.key), None)
            fits = entry.slot < self._session.slots and entry.key not in self.roster.banned
            known = owners.get(entry.name, entry.key) == entry.key and (
                entry.key not in owners.values() or owners.get(entry.name) == entry.key
            )
            free = all(entry.slot != known.slot for known in members)
            if mine is None and entry.key in keys and fits and known and free and len(owners) < MOST_NAMES:
                beside = self.roster.model_copy(update={"members": list(members)})
                if not self.admission.welcome(entry, beside):  # it asks again by itself, and shows where it is
                    continue
                members.append(entry)
                owners[entry.name] = entry.key
        members.sort(key=lambda entry: entry.slot)
        if members != self.roster.members:
            for entry in members:
                self._seen.setdefault(entry.key, now)
            self._change(members)

    def expel(self, name: str, *, ban: bool = True) -> None:
        """Sends somebody away: its slot and its name are free.

        Args:
            name: whose.
            ban: whether its key comes in no more for the rest of the session.

        Raises:
            SessionError: there is nobody of this name, or too many were sent away.
        """
        key = self.roster.owners().get(name)
        if key is None:
            known = ", ".join(entry.name for entry in self.roster.members) or "nobody"
            raise SessionError(f'nobody here has the name "{name}"; there are: {known}')
        if ban and len(self.roster.banned) >= MOST_BANNED:
            raise SessionError(f"{MOST_BANNED} users have already been expelled; start a new session")
        left = [entry for entry in self.roster.members if entry.key != key]
        names = [bound for bound in self.roster.names if bound.key != key]
        self._change(left, names=names, banned=[*self.roster.banned, key] if ban else None)

    def release(self, name: str) -> None:
        """Lets a name go whose owner is not here, for whoever comes next.

        Raises:
            SessionError: it is nobody's, or its owner is here.
        """
        if any(entry.name == name for entry in self.roster.members):
            raise SessionError(f'"{name}" has joined; only the name of a user who has left can be released')
        names = [bound for bound in self.roster.names if bound.name != name]
        if len(names) == len(self.roster.names):
            raise SessionError(f'nobody has used the name "{name}"; there is nothing to release')
        self._change(self.roster.members, names=names)

    def choose(self, links: list[Pair]) -> None:
        """Takes links that somebody chose in place of the session's and of a plan; who comes is joined to somebody.

        Args:
            links: pairs of slots.

        Raises:
            NetworkError: a pair has no spring, or there are no such slots.
        """
        self._chosen = self._session.scenario.network.with_links(links)
        slots = [entry.slot for entry in self.roster.members]
        wanted = present_links(self._chosen, slots)
        if wanted != self.roster.links:
            self._announce(self.roster.members, wanted)

    def measured(self, pair: Pair, both: float) -> None:
        """Takes a time there and back of a pair, linked or not, the smaller slot first [s].

        Args:
            pair: two slots, the smaller first.
            both: time there and back [s].
        """
        self._paths[pair] = both

    def due(self, now: float) -> bool:
        """Whether the roster is to be said now; if so, it is taken as said [s]."""
        if now - self._said < _REPEAT:
            return False
        self._said = now
        return True

    def renew(self, beyond: int = 1) -> None:
        """The same roster under a higher number: what others decided meanwhile is over."""
        self._announce(self.roster.members, self.roster.links, by=beyond)

    def tick(self, now: float, present: frozenset[bytes]) -> list[Outgoing]:
        """What is to be sent now besides the roster.

        Args:
            now: [s].
            present: public keys of those who are there, this member included.
        """
        keys = {key.hex() for key in present}
        for entry in self.roster.members:
            if entry.key in keys:
                self._seen[entry.key] = now
        gone = {e.key for e in self.roster.members if now - self._seen.get(e.key, now) > ABSENT_AFTER}
        if gone:
            self._remove(gone)
        self._replan(now)
        out, self._out = self._out, []
        return out

    def _join(self, request: Join, key: str, now: float) -> None:
        own = next((entry for entry in self.roster.members if entry.key == key), None)
        if own is not None and (own.name, own.start) == (request.name, request.start):  # it did not hear of it yet
            self._said = -float("inf")
            return
        slot = self.admission.slot(request, key, self.roster, now)
        if slot is None:
            return
        if isinstance(slot, str):
            self.refused += 1
            final = self.admission.unfit(request, key, self.roster) is not None
            self._out.append(Outgoing("refused", write_message(Refused(reason=slot, final=final)), bytes.fromhex(key)))
            return
        others = [entry for entry in self.roster.members if entry.slot != slot]
        entry = Entry(slot=slot, name=request.name, key=key, start=request.start)
        self._seen[key] = now
        self._change(sorted([*others, entry], key=lambda entry: entry.slot))
        self.admission.came(request, key, self.roster, now)

    def _remove(self, keys: set[str]) -> None:
        left = [entry for entry in self.roster.members if entry.key not in keys]
        if len(left) < len(self.roster.members):
            self._change(left)

    def _change(
        self, members: list[Entry], *, names: list[NameOwner] | None = None, banned: list[str] | None = None
    ) -> None:
        slots = [entry.slot for entry in members]
        self._forget_paths(members)
        self._seen = {entry.key: self._seen[entry.key] for entry in members if entry.key in self._seen}
        network = self._session.scenario.network
        if self._planner is None or self._chosen is not None:
            links = present_links(self._chosen or network, slots)
        else:  # what is there is kept until a plan is made, and everybody is joined to somebody
            links = present_links(network.with_links(self.roster.links), slots)
        self._announce(members, links, names=names, banned=banned)

    def _forget_paths(self, members: list[Entry]) -> None:
        """What was measured of a slot that is now somebody else's, or nobody's, is of no use."""
        same = {entry.slot for entry in self.roster.members if entry in members}
        self._paths = {pair: both for pair, both in self._paths.items() if set(pair) <= same}
        self._changed = None

    def _announce(
        self,
        members: list[Entry],
        links: list[Pair],
        *,
        names: list[NameOwner] | None = None,
        banned: list[str] | None = None,
        by: int = 1,
    ) -> None:
        before = self.roster
        if before.epoch + by >= LAST_EPOCH:  # nobody makes so many changes, and nobody is believed who says so
            return
        kept = {bound.name: bound for bound in (before.names if names is None else names)}
        for entry in members:
            had = kept[entry.name].slots if entry.name in kept else ()
            slots = tuple(sorted({*had, entry.slot}))
            kept[entry.name] = NameOwner(name=entry.name, key=entry.key, slots=slots)
        former = {gone.key: gone for gone in before.former}
        for key in {bound.key for bound in before.names} - {bound.key for bound in kept.values()}:
            former[key] = Former(key=key, slots=tuple(sorted(before.slots()[key])))
        self.roster = Roster(
            epoch=before.epoch + by,
            members=members,
            links=links,
            names=list(kept.values()),
            banned=before.banned if banned is None else banned,
            former=list(former.values())[-MOST_NAMES:],
        )
        self._said = -float("inf")

    def _replan(self, now: float) -> None:
        if self._planner is None or self._chosen is not None or len(self.roster.members) < 2:
            return
        slots = [entry.slot for entry in self.roster.members]
        if self._asked is None:
            if not self._worth_it(now, slots):
                return
            self._asked = (slots, {pair: both for pair, both in self._paths.items() if set(pair) <= set(slots)})
        links = self._planner(*self._asked)
        if links is None:
            return
        asked, self._asked = self._asked, None
        self._planned, self._planned_at = asked, now
        if asked[0] == slots and sorted(links) != self.roster.links:
            self._announce(self.roster.members, sorted(links))

    def _worth_it(self, now: float, slots: list[int]) -> bool:
        if self._planned is None or self._planned[0] != slots:
            self._changed = now if self._changed is None else self._changed
            known = all((a, b) in self._paths for a in slots for b in slots if a < b)
            return known or now - self._changed >= _MEASURE
        if not self._session.options.replan or now - self._planned_at < _REPLAN_EVERY:
            return False
        before = delays_of(self._session.scenario.network, self._planned[1])
        after = delays_of(self._session.scenario.network, self._paths)
        change = abs(after - before)
        return bool((change > _REPLAN_FRACTION * before + _REPLAN_LEAST).any())
