"""The way to one neighbour: which of its addresses answers, and whether that one still does.

Both ends send pings to all addresses of the other, so that each one's NAT lets the other's in (hole punching; ICE
[RFC 8445] without roles: each end chooses for itself). A way counts only once a pong came back on it: then both
directions work. Nothing else moves it, neither a ping nor a sample. Times are handed in.
"""

from collections import deque
from collections.abc import Sequence
from enum import Enum
from typing import NamedTuple, final

from cotouch.samples import Address, AgeWindow, ReplayWindow
from cotouch.traversal._candidates import Candidate, CandidateKind
from cotouch.traversal._probe import Kind, PairKeys, ping, pong, read_pair

# A round: pings to all addresses in turn. The first opens a NAT, the next get through; some are lost.
_LAPS = 12
_LATER_LAPS = 4
_LAP = 0.25
_PACE = 0.02
# After the last ping of a round, before it is given up [s].
_PATIENCE = 2.0
# Until the next round; at the longest so that one end's pings still find open what the other's have opened, for half a
# minute at least, whenever each of them begins.
_RETRY = 5.0
_LEAST_OFTEN = 40.0
# The way in use is asked so often while samples go there; it is lost after so long and so many without an answer.
_CHECK = 0.25
# Of one that no samples go to, so that it is known how far away it is.
_IDLE_CHECK = 5.0
# Over which the quickest way there and back is looked for [s].
_WINDOW = 20.0
_SILENCE = 2.0
_UNANSWERED = 4
# An address that answers is better than one that has not for this long.
_HESITANT = 0.6
# Pings that are answered later are of no use.
_OPEN = 4.0
_MOST_LEARNT = 4
_PROMPT = 0.1


@final
class PathState(Enum):
    """How a neighbour is reached."""

    TRYING = "checking addresses; samples are relayed meanwhile"
    DIRECT = "one of its addresses answers"
    RELAYED = "none of its addresses answers; they are checked again from time to time"


class Probe(NamedTuple):
    """A datagram to be sent: where to, and its bytes."""

    to: Address
    payload: bytes


@final
class PathProber:
    """Finds and keeps the path to one neighbour. Opens nothing: probes in, probes out.

    Attributes:
        path_state: of now.
        address: where samples go, if `DIRECT`.
        round_trip: of the last answer there [s].
        refused: probes that were of no use: forged or replayed.
    """

    def __init__(self, now: float) -> None:
        """Begins without keys and addresses; gives up for the first time when none answer [s]."""
        self.path_state = PathState.TRYING
        self.address: Address | None = None
        self.round_trip = 0.0
        self.refused = 0
        self._trips = AgeWindow(_WINDOW)
        self._keys: PairKeys | None = None
        self._number = 0
        self._seen = ReplayWindow(8)
        self._open: dict[int, tuple[Address, float]] = {}  # asked where and when, oldest first
        self._offered: dict[Address, CandidateKind] = {}
        self._learnt: deque[Address] = deque(maxlen=_MOST_LEARNT)
        self._round: deque[Address] = deque()
        self._next = now
        self._pace = _LAP
        self._give_up = now + _LAPS * _LAP + _PATIENCE
        self._retry = float("inf")
        self._pause = _RETRY
        self._prompt: Address | None = None
        self._prompted = -float("inf")
        self._checked = -float("inf")
        self._waiting: float | None = None  # since when the way in use was asked without an answer
        self._unanswered = 0

    @property
    def quickest(self) -> float | None:
        """The quickest way there and back lately; None while no address answers [s]."""
        return self._trips.smallest if self.path_state is PathState.DIRECT else None

    def rekey(self, keys: PairKeys) -> None:
        """Takes the pair's keys; what was asked with others is forgotten."""
        if keys == self._keys:  # numbers must not begin anew
            return
        self._keys, self._number, self._seen = keys, 0, ReplayWindow(8)
        self._open.clear()
        self._begin(_LAPS)

    def offer(self, candidates: Sequence[Candidate]) -> None:
        """Where the neighbour says that it may be reached."""
        offered = {address: origin for origin, address in reversed(candidates)}
        if offered != self._offered:
            self._offered = offered
            self._begin(_LAPS)

    def moved(self) -> None:
        """This end sends from elsewhere now: the way in use is asked at once, and if there is none, all addresses."""
        self._checked = -float("inf")
        if self.path_state is not PathState.DIRECT:
            self._pause = _RETRY
            self._begin(_LAPS)

    def learn(self, now: float, address: Address) -> None:
        """The neighbour was heard from there, by an authentic sample or ping: worth a ping if it may be better.

        Args:
            now: time by the clock of this member [s].
            address: IP address and port.
        """
        if address == self.address or not self._better(now, address):
            return
        if address not in self._offered and address not in self._learnt:
            self._learnt.append(address)
        self._prompt = address

    def due(self, now: float, *, active: bool) -> list[Probe]:
        """Probes to be sent now.

        Args:
            now: [s].
            active: whether samples are sent to this neighbour, so that it matters at once if they get through.
        """
        if self._keys is None:
            self._judge_round(now)
            return []
        out: list[Probe] = []
        while self._open and now - next(iter(self._open.values()))[1] > _OPEN:
            del self._open[next(iter(self._open))]
        if self.path_state is PathState.DIRECT:
            self._check(now, out, active=active)
        if self._prompt is not None and now >= self._prompted + _PROMPT:
            self._prompted = now
            self._ask(now, self._prompt, out)
            self._prompt = None
        if now >= self._retry and not self._round:
            self._pause = min(_LEAST_OFTEN, 2.0 * self._pause)
            self._begin(_LATER_LAPS)
        if self._round and now >= self._next:
            self._next = now + self._pace  # whatever begins anew: one ping in this time
            self._ask(now, self._round.popleft(), out)
            if not self._round:
                self._give_up = now + _PATIENCE
                self._retry = self._give_up + self._pause if self._improvable() else float("inf")
        self._judge_round(now)
        return out

    def receive(self, now: float, datagram: bytes, source: Address) -> Probe | None:
        """Takes a ping or pong, or what is said to be one; returns what is to be answered.

        Args:
            now: [s].
            datagram: as it arrived.
            source: in plain form.
        """
        read = None if self._keys is None else read_pair(self._keys, datagram)
        if self._keys is None or read is None:
            self.refused += 1
            return None
        kind, number = read
        if kind is Kind.PING:
            if not self._seen.fresh(number):
                self.refused += 1
                return None
            self._seen.mark(number)
            self.learn(now, source)
            return Probe(source, pong(self._keys, number))
        asked = self._open.get(number)
        if asked is None or asked[0] != source:
            self.refused += 1
            return None
        del self._open[number]
        if source == self.address or self._better(now, source):
            self._take(now, source, asked[1])
        return None

    def _take(self, now: float, source: Address, then: float) -> None:
        new = source != self.address
        self.path_state, self.address = PathState.DIRECT, source
        self.round_trip = now - then
        if new:
            self._trips = AgeWindow(_WINDOW)
        self._trips.add(now, self.round_trip)
        self._waiting, self._unanswered = None, 0
        if new:
            self._checked, self._pause = then, _RETRY
            if not self._improvable():
                self._round.clear()
                self._retry = float("inf")
            elif not self._round:
                self._retry = now + _LEAST_OFTEN

    def _better(self, now: float, source: Address) -> bool:
        if self.address is None or source == self.address:
            return self.address is None
        hesitant = self._waiting is not None and now - self._waiting > _HESITANT + self.round_trip
        return hesitant or self._rank(source) < self._rank(self.address)

    def _rank(self, address: Address) -> CandidateKind:
        return self._offered.get(address, CandidateKind.LEARNT)

    def _improvable(self) -> bool:
        """Whether an address could answer that is better than what there is."""
        if self.address is None:
            return True
        return any(origin < self._rank(self.address) for origin in self._offered.values())

    def _check(self, now: float, out: list[Probe], *, active: bool) -> None:
        doubtful = self._waiting is not None and now - self._waiting > self.round_trip + _CHECK
        if self.address is not None and now - self._checked >= (_CHECK if active or doubtful else _IDLE_CHECK):
            self._checked = now
            self._unanswered += 1
            self._waiting = now if self._waiting is None else self._waiting
            self._ask(now, self.address, out)
        silent = self._waiting is not None and now - self._waiting > _SILENCE + self.round_trip
        if silent and self._unanswered >= _UNANSWERED:
            if self.address is not None and self.address not in self._offered and self.address not in self._learnt:
                self._learnt.append(self.address)
            self.path_state, self.address = PathState.TRYING, None
            self._waiting, self._unanswered, self._pause = None, 0, _RETRY
            self._begin(_LAPS)

    def _begin(self, laps: int) -> None:
        """A round over all addresses, or over the better ones if there is a way; the straightest first."""
        offered = sorted(self._offered, key=self._rank)
        addresses = [*offered, *(address for address in self._learnt if address not in self._offered)]
        if self.address is not None:
            addresses = [address for address in addresses if self._rank(address) < self._rank(self.address)]
        if not addresses or self._keys is None:
            self._round.clear()
            self._retry = float("inf")
            return
        self._round = deque(addresses * laps)
        self._pace = max(_PACE, _LAP / len(addresses))
        self._give_up = self._retry = float("inf")

    def _judge_round(self, now: float) -> None:
        if self.path_state is PathState.TRYING and now >= self._give_up:
            self.path_state = PathState.RELAYED

    def _ask(self, now: float, to: Address, out: list[Probe]) -> None:
        if self._keys is None:
            return
        self._open[self._number] = (to, now)
        out.append(Probe(to, ping(self._keys, self._number)))
        self._number += 1
