"""Ages of samples between clocks that nobody set: only the sum of both directions of a link is needed, and known.

Each end subtracts a stamp of the other's clock from a time of its own, so what it finds is the age plus the offset of
the clocks. Both ends' offsets are opposite, hence the sum of what both find is the sum of the true ages, exactly, and
that sum is all the age rule asks for. Every sample carries what its sender found to the other end.
"""

from bisect import bisect_left, insort
from collections import deque
from math import ceil
from typing import final

# Bounds memory where steps are short and the window is long.
_MOST_KEPT = 20_000
# A path cannot take less than no time; clocks that drift apart by 1e-4 while an echo is held can make it look so.
_DRIFT = 1e-4


@final
class Window:
    """Values of the last so many seconds: their greatest, smallest and quantiles.

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
        """Adds a value; now must not run backwards [s]."""
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
    """What one end of a link knows of both directions' ages.

    Attributes:
        impossible: how many echoes came back before they were sent, as only a wrong or lying clock gives.
    """

    def __init__(self, *, window: float = 10.0) -> None:
        """Starts without knowledge.

        Args:
            window: over which ages are looked at [s].
        """
        self.impossible = 0
        self._own = Window(window)
        self._others = Window(window)
        self._path = Window(window)
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
        self._age = now - oldest
        self._own.add(now, self._age)
        return self._age

    def heard(self, now: float, *, index: int, age: float, worst: float) -> None:
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
    def own(self) -> tuple[float, float] | None:
        """This end's last age and the greatest of its window, offset included; None before the first step."""
        worst = self._own.greatest
        return None if self._age is None or worst is None else (self._age, worst)

    @property
    def worst_sum(self) -> float | None:
        """Greatest age here plus greatest age there, in both windows; exact, whatever the clocks show [s].

        None until both are known.
        """
        own = self._own.greatest
        return None if own is None or self._reported is None else own + self._reported[1]

    def own_quantile(self, q: float) -> float | None:
        """The q-quantile of the ages here, offset included; None before the first step [s]."""
        return self._own.quantile(q)

    def sum_quantile(self, q: float) -> float | None:
        """The q-quantile of the ages here plus that of those there; None until both are known [s]."""
        own, others = self._own.quantile(q), self._others.quantile(q)
        return None if own is None or others is None else own + others

    @property
    def shortest_path(self) -> float | None:
        """The quickest way there and back in the window [s]."""
        return self._path.smallest
