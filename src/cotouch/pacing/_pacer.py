"""Pacing: steps at a fixed rate on a monotonic clock; a late one takes longer, and none is made up for.

Sleep to shortly before the deadline, then look at the clock without sleeping: how late a sleep ends is the operating
system's business, how late the loop is then is not. Deadlines are `t₀ + k·period`; those that passed are left out.
What can be done before the deadline, such as reading what arrived, is done while waiting: as late as it can be and
still be done in time, so that the step finds everything that came until then, and finds it read.
"""

import math
import time
from array import array
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, Protocol, final

from cotouch.errors import SessionError

# A step shorter than this share of the period is not worth its work; the next deadline is taken.
_LEAST = 0.5
# Lateness of so many newest steps is kept for its quantiles.
_KEPT = 1 << 16
# Looks at a clock that stands still, and sleeps that end at once, are given up after so many.
_MOST_LOOKS = 1_000_000
_MOST_SLEEPS = 64
# A look that finds nothing takes less than this; nearer to the deadline only the clock is looked at [s].
_LOOK = 30e-6
# Reading is given as long as it took lately, but at most this share of the period; a step counts for so much of that.
_MOST_LEAD = 0.3
_LEARN = 0.05


class Idle(Protocol):
    """What a loop does while it waits."""

    def due(self) -> float:
        """When it wants to look at the latest, on the pacer's clock; inf: before the deadline is soon enough [s]."""
        ...

    def look(self, now: float) -> None:
        """Does what can be done now; never waits.

        Args:
            now: on the pacer's clock [s].
        """
        ...


class Turn(NamedTuple):
    """What a step is to do.

    Attributes:
        now: end of the step on the pacer's clock [s].
        T: length of the step, at most the cap [s].
        too_long: how much longer it really was than the cap, mostly 0; for so long the copy stood still, and links
            should be told [s].
    """

    now: float
    T: float
    too_long: float


@final
@dataclass(frozen=True, kw_only=True)
class PaceStatistics:
    """How well the rate was kept.

    Attributes:
        steps: taken.
        missed: deadlines that were left out.
        too_long: steps that were longer than the cap.
        late_p50: median of how late steps came after their deadlines, of the newest 65,536 [s].
        late_p99: 99th percentile [s].
        late_p999: 99.9th percentile [s].
        period_min: shortest step [s].
        period_mean: mean of steps, as they really were [s].
        period_max: longest step, as it really was [s].
        busy: share of the time that was not spent waiting.
    """

    steps: int
    missed: int
    too_long: int
    late_p50: float
    late_p99: float
    late_p999: float
    period_min: float
    period_mean: float
    period_max: float
    busy: float


@final
class Pacer:
    """One loop's clock.

    `wait` once for every step: it returns when the step's time is over, and says how long the step was.

    Attributes:
        worked: time before the deadline of the last step that was spent on reading, not on waiting [s].

    Examples:
        >>> pacer = Pacer(0.001, cap=0.02)
        >>> turn = pacer.wait()
        >>> turn.T > 0.0
        True
    """

    def __init__(
        self,
        period: float,
        *,
        cap: float = math.inf,
        spin: float = 100e-6,
        clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
        idle: Idle | None = None,
    ) -> None:
        """Prepares the loop; the first step begins now.

        Args:
            period: wanted length of a step, > 0 [s].
            cap: longest T that a step may have, >= `period` [s].
            spin: how long before the deadline sleeping ends, >= 0; what is longer costs that share of a core [s].
            clock: monotonic time [s].
            sleep: waits so long, or a little longer [s].
            idle: what is done meanwhile; None: nothing.

        Raises:
            SessionError: one of them is out of its range.
        """
        if not 0.0 < period < math.inf:
            raise SessionError(f"period is {period:g} s; it must be a time > 0")
        if not cap >= period:
            raise SessionError(f"cap is {cap:g} s; it must be at least the period, {period:g} s")
        if not 0.0 <= spin < math.inf:
            raise SessionError(f"spin is {spin:g} s; it must be a time >= 0")
        self._period = period
        self._cap = cap
        self._spin = spin
        self._clock = clock
        self._sleep = sleep
        self._idle = idle
        self._lead = self.worked = 0.0
        self._late = array("d", bytes(8 * _KEPT))
        self.restart()

    @property
    def period(self) -> float:
        """Wanted length of a step [s]."""
        return self._period

    def restart(self, period: float | None = None) -> None:
        """Begins anew: the grid of deadlines starts now, statistics are empty.

        Args:
            period: another one, > 0 and at most the cap; None: as before [s].

        Raises:
            SessionError: it is not.
        """
        if period is not None:
            if not 0.0 < period <= self._cap:
                raise SessionError(f"period is {period:g} s; it must be > 0 and at most the cap, {self._cap:g} s")
            self._period = period
        self._steps = self._missed = self._long = 0
        self._shortest, self._longest, self._waited = math.inf, 0.0, 0.0
        self._begin = self._last = self._clock()
        self._next = 1

    def wait(self) -> Turn:
        """Waits for the deadline of this step, or not at all if it has passed."""
        clock = self._clock
        deadline = self._begin + self._next * self._period
        before = now = clock()
        self.worked = 0.0
        idle = self._idle
        now = self._doze(now, deadline - self._spin) if idle is None else self._look(idle, now, deadline)
        for _ in range(_MOST_LOOKS):
            if now >= deadline:
                break
            now = clock()
        self._waited += now - before - self.worked
        T = max(now - self._last, 1e-9)  # a clock that stands still must not make a step of no length
        self._last = now
        self._late[self._steps % _KEPT] = now - deadline
        self._steps += 1
        self._shortest, self._longest = min(self._shortest, T), max(self._longest, T)
        following = math.ceil((now - self._begin) / self._period + _LEAST)
        following = max(following, self._next + 1)
        self._missed += following - self._next - 1
        self._next = following
        if self._cap >= T:
            return Turn(now, T, 0.0)
        self._long += 1
        return Turn(now, self._cap, T - self._cap)

    def _doze(self, now: float, end: float) -> float:
        """Sleeps until shortly after the end, with more than one sleep if they end early; returns the time then."""
        for _ in range(_MOST_SLEEPS):
            ahead = end - now
            if ahead <= 0.0:
                break
            self._sleep(ahead)
            now = self._clock()
        return now

    def _look(self, idle: Idle, now: float, deadline: float) -> float:
        """Looks whenever something is due, then once in time for the deadline, then again until it is near."""
        clock = self._clock
        begin, end = deadline - self._spin - self._lead, deadline - _LOOK
        for _ in range(_MOST_SLEEPS):
            due = idle.due()
            if max(due, now) >= begin:
                break
            now = self._doze(now, due)
            idle.look(now)
            now = clock()
        now = self._doze(now, begin)
        if now >= end:
            return now
        idle.look(now)
        then, now = now, clock()
        self.worked = now - then
        self._lead += _LEARN * (min(self.worked, _MOST_LEAD * self._period) - self._lead)
        now = self._doze(now, deadline - self._spin)  # there was less to read than usual
        for _ in range(_MOST_LOOKS):
            if now >= end:
                break
            idle.look(now)
            now = clock()
        return now

    def statistics(self) -> PaceStatistics:
        """How well the rate was kept since the beginning; NaN where there was no step yet."""
        late = sorted(self._late[: min(self._steps, _KEPT)])
        elapsed = self._last - self._begin

        def quantile(fraction: float) -> float:
            return late[min(len(late) - 1, int(fraction * len(late)))] if late else math.nan

        return PaceStatistics(
            steps=self._steps,
            missed=self._missed,
            too_long=self._long,
            late_p50=quantile(0.5),
            late_p99=quantile(0.99),
            late_p999=quantile(0.999),
            period_min=self._shortest if self._steps else math.nan,
            period_mean=elapsed / self._steps if self._steps else math.nan,
            period_max=self._longest if self._steps else math.nan,
            busy=1.0 - self._waited / elapsed if elapsed > 0.0 else math.nan,
        )
