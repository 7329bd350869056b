"""Ages of samples between clocks that nobody set: only the sum of both directions of a link is needed, and known.

Each end subtracts a stamp of the other's clock from a time of its own, so what it finds is the age plus the offset of
the clocks. Both ends' offsets are opposite, hence the sum of what both find is the sum of the true ages, exactly, and
that sum is all the age rule asks for. Every sample carries what its sender found to the other end.

**An outage is not the path.** While nothing comes, the last sample gets as old as the outage is long. No budget could
be of use for that: the link is guarded anyhow, and would stay so for as long as such budgets take, or hold everybody up
by their damping. So ages count only once the next sample is there, and only if it came soon enough; what comes just
after an outage was held up by it. Outages that recur, though, are how this path is: of three in the window, the
shortest counts. What counts decides only what is asked for; every sample in use is judged by its own age.
"""

from bisect import bisect_left, insort
from collections import deque
from math import ceil, inf
from typing import final

# Bounds memory where steps are short and the window is long.
_MOST_KEPT = 20_000
# A path cannot take less than no time; clocks that drift apart by 1e-4 while an echo is held can make it look so.
_DRIFT = 1e-4
# Ten samples at the lowest rate: ten in a row a path may lose, at 30 %, once in 170,000 [s].
_OUTAGE = 0.5
# So many outages in a window are no accident.
_RECUR = 3
_MOST_ENDS = 32
# Ages that take their place in the window at once, between two steps.
_AT_ONCE = 8


@final
class AgeWindow:
    """Values of the last few seconds: their greatest, smallest and quantiles.

    Adding one and asking cost about a microsecond, however many there are: both happen in the loop of a peer.
    """

    def __init__(self, length: float) -> None:
        """Makes an empty window.

        Args:
            length: of the window, or as long as 20,000 values last, if that is shorter [s].
        """
        self._length = length
        self._values = deque[tuple[float, float]](maxlen=_MOST_KEPT)
        self._greatest = deque[tuple[float, float]]()
        self._smallest = deque[tuple[float, float]]()
        self._sorted: list[float] | None = None  # kept as soon as somebody asks for a quantile other than the ends

    def add(self, now: float, value: float) -> None:
        """Adds a value; now must not run backwards [s].

        Args:
            now: time by the clock of this member [s].
            value: the value.
        """
        values, greatest, smallest, ordered = self._values, self._greatest, self._smallest, self._sorted
        if ordered is not None:
            if len(values) == _MOST_KEPT:
                del ordered[bisect_left(ordered, values[0][1])]
            insort(ordered, value)
        entry = (now, value)
        values.append(entry)
        while greatest and greatest[-1][1] <= value:
            greatest.pop()
        while smallest and smallest[-1][1] >= value:
            smallest.pop()
        greatest.append(entry)
        smallest.append(entry)
        first = now - self._length
        while values[0][0] < first:
            _, old = values.popleft()
            if ordered is not None:
                del ordered[bisect_left(ordered, old)]
        if len(values) == _MOST_KEPT:
            first = max(first, values[0][0])
        while greatest[0][0] < first:
            greatest.popleft()
        while smallest[0][0] < first:
            smallest.popleft()

    def __len__(self) -> int:
        return len(self._values)

    @property
    def greatest(self) -> float | None:
        """None without values."""
        return self._greatest[0][1] if self._greatest else None

    @property
    def smallest(self) -> float | None:
        """None without values."""
        return self._smallest[0][1] if self._smallest else None

    def quantile(self, q: float) -> float | None:
        """The q-quantile, rounded up to a value that occurred; None without values."""
        if not self._values:
            return None
        at = ceil(q * (len(self._values) - 1))
        if at == len(self._values) - 1:
            return self._greatest[0][1]
        if self._sorted is None:
            self._sorted = sorted(value for _, value in self._values)
        return self._sorted[at]


@final
class LinkAges:
    """What one end of a link knows about the ages in both directions.

    Attributes:
        impossible: how many echoes came back before they were sent, as only a wrong or lying clock gives.
        outages: how many there were.
    """

    def __init__(self, *, window: float = 10.0, outage: float = _OUTAGE) -> None:
        """Starts without knowledge.

        Args:
            window: over which ages are looked at [s].
            outage: steps for longer than this without anything newer are an outage, > 0 [s].
        """
        self.impossible = 0
        self.outages = 0
        self._outage = outage
        self._oldest: float | None = None  # stamp in use
        self._since = 0.0  # first step that used it
        self._settled = -inf  # ages count again
        self._pending = deque[tuple[float, float]]()  # ages of the sample in use, from its second step on
        self._counted = deque[tuple[float, float]]()  # on their way into the window
        self._ends = deque[tuple[float, float]](maxlen=_MOST_ENDS)  # of outages: when, and the age then
        self._window = window
        self._own = AgeWindow(window)
        self._others = AgeWindow(window)
        self._path = AgeWindow(window)
        self._age: float | None = None
        self._reported: tuple[int, float] | None = None

    def used(self, now: float, oldest: float) -> float:
        """Notes the end of a step.

        Args:
            now: end of the step, on this end's clock [s].
            oldest: stamp of the oldest rows it used, on the other's [s].

        Returns:
            The age plus the offset of the clocks [s].
        """
        age = self._age = now - oldest
        if self._oldest is None or oldest != self._oldest:
            if self._oldest is not None and self.silent(now):
                self._end_outage(now, now - self._oldest)
            self._counted.extend(self._pending)
            self._pending.clear()
            self._oldest, self._since = oldest, now
            if now >= self._settled:
                self._counted.append((now, age))
        elif self.silent(now):
            self._pending.clear()
        elif now >= self._settled:
            self._pending.append((now, age))
        for _ in range(min(_AT_ONCE, len(self._counted))):
            self._own.add(*self._counted.popleft())
        while self._ends and self._ends[0][0] < now - self._window:
            self._ends.popleft()
        return age

    def silent(self, now: float) -> bool:
        """Whether nothing newer has come for as long as makes an outage.

        Args:
            now: on this end's clock [s].
        """
        return self._oldest is not None and now - self._since > self._outage

    def _end_outage(self, now: float, age: float) -> None:
        self.outages += 1
        self._settled = now + self._outage
        self._pending.clear()
        self._ends.append((now, age))

    def _recurring(self) -> float:
        """Age that outages lead to again and again; -inf without."""
        return sorted(age for _, age in self._ends)[-_RECUR] if len(self._ends) >= _RECUR else -inf

    @property
    def _worst(self) -> float | None:
        greatest = self._own.greatest
        return None if greatest is None else max(greatest, self._recurring())

    def received(self, now: float, *, index: int, age: float, worst: float) -> None:
        """Notes what the other end found.

        Args:
            now: time of arrival, on this end's clock, never backwards [s].
            index: of the step that it found it in; an overtaken one changes only the quantile.
            age: at the end of that step [s].
            worst: greatest in its window [s].
        """
        self._others.add(now, age)
        if self._reported is None or index > self._reported[0]:
            self._reported = (index, worst)

    def echoed(self, now: float, *, arrived: float, echo: float, held: float) -> float | None:
        """Notes an echo: how long the path there and back takes, waiting at the other end not included.

        Args:
            now: never backwards [s].
            arrived: when the datagram did [s].
            echo: this end's stamp that it brings back [s].
            held: how long the other end had it [s].

        Returns:
            The path's time, from a stamp there to its arrival and back again [s]; None if it is impossible.
        """
        path = arrived - echo - held
        if path < -_DRIFT * held - 1e-6:
            self.impossible += 1
            return None
        self._path.add(now, path)
        return path

    @property
    def age(self) -> float | None:
        """Of the last step, offset included, whether it counts or not; None before the first [s]."""
        return self._age

    @property
    def own(self) -> tuple[float, float] | None:
        """This end's last age, as far as it counts, and the greatest that does; None before the first step [s].

        The offset of the clocks is included.
        """
        worst = self._worst
        return None if self._age is None or worst is None else (min(self._age, worst), worst)

    @property
    def worst_sum(self) -> float | None:
        """Greatest age here plus greatest age there, in both windows; exact, whatever the clocks show [s].

        None until both are known.
        """
        own = self._worst
        return None if own is None or self._reported is None else own + self._reported[1]

    def own_quantile(self, q: float) -> float | None:
        """The q-quantile of the ages here, offset included; None before the first step [s]."""
        own = self._own.quantile(q)
        return None if own is None else max(own, self._recurring())

    def sum_quantile(self, q: float) -> float | None:
        """The q-quantile of the ages here plus that of those there; None until both are known [s]."""
        own, others = self.own_quantile(q), self._others.quantile(q)
        return None if own is None or others is None else own + others

    @property
    def shortest_path(self) -> float | None:
        """The quickest way there and back in the window [s]."""
        return self._path.smallest
