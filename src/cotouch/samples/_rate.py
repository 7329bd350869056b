"""How often samples are sent: less when the path cannot bear it, more again when it can.

A path that is too narrow shows it by losses or by a queue: the way there and back takes longer than it can. But losses
may also be the path's own, as on a bad radio link, and waiting may be jitter, and then sending less only makes samples
older. They are told apart by trying another rate: over a full path arrives what it bears, whatever is sent; over any
other arrives half as much when half as much is sent, with losses and waiting as before.
"""

from enum import Enum
from math import sqrt
from typing import NamedTuple, final

# The rate that is left where nothing is heard [1/s].
LOWEST_RATE = 20.0
# An interval has at least so many datagrams: at 30 % loss what arrives is then known to 6 %, so 1/2 is told from 1.
_LEAST_SENT = 100
_LEAST_INTERVAL = 0.5
# After a change, what jitter holds back is still to come when what overtook it is counted [s].
_SETTLE = 0.5
_DOWN = 0.5
_UP = 0.05  # of the highest rate
# The path's own losses and jitter are believed a little less with every clean interval, so that a wrong belief passes.
_FORGET = 0.99
# Intervals without trying again, after trying more on a path that was full.
_REST = 10
# Waiting, beyond the path's own, that is worth a try [s].
_QUEUE = 0.015
# Without any report for this long the other end hears nothing, or cannot say so [s].
_SILENCE = 1.0


@final
class Trend(Enum):
    """The trend of the last interval."""

    HOLD = "not enough known"
    UP = "clean: raised"
    TRY = "losses or waiting: another rate, to see whether it matters"
    FULL = "it did: the path was full"
    OWN = "it did not: losses and jitter are the path's own"
    SILENT = "nothing is heard: lowest"


class _Interval(NamedTuple):
    delivered: float  # datagrams per second
    loss: float
    waited: float


@final
class SendRate:
    """The rate of one direction of one link; a pure function of what is reported and when.

    Attributes:
        rate: states to send [1/s].
        own_loss: the path's own, as far as believed.
        own_wait: the path's own jitter, likewise: what three quarters of the reports take longer than the quickest [s].
        loss: of the last interval.
        trend: what it led to.
    """

    def __init__(self, *, highest: float = 1000.0, lowest: float = LOWEST_RATE) -> None:
        """Starts at the highest rate.

        Args:
            highest: of the session [1/s].
            lowest: [1/s].
        """
        self.rate = self._highest = self._session = highest
        self._lowest = min(lowest, highest)
        self.own_loss = 0.0
        self.own_wait = 0.0
        self.loss = 0.0
        self.trend = Trend.HOLD
        self._due = -float("inf")
        self._received: float | None = None
        self._started: tuple[float, int, int] | None = None
        self._skip = -1  # reports about datagrams up to this one are about the rate before
        self._reached = float("inf")
        self._waits: list[float] = []
        self._trial: tuple[float, _Interval] | None = None
        self._before_silence = highest
        self._before_cap = 0.0
        self._rest = 0

    def cap(self, most: float) -> None:
        """Nothing above this is sent from now on, not even to try; the way that it is for bears no more [1/s].

        With another way begins another judgement: where there is more room than before, at half the rate that was
        left for the narrower one, as after a silence.
        """
        highest = min(self._session, most)
        if highest == self._highest:
            return
        wider = highest > self._highest
        if not wider:
            before = self._before_silence if self.trend is Trend.SILENT else self.rate
            self._before_cap = max(self._before_cap, before if self._trial is None else self._trial[0])
        self._highest = highest
        if self.trend is Trend.SILENT:
            self._turn(self._lowest, Trend.SILENT, -1)
            return
        self._turn(max(self.rate, _DOWN * self._before_cap) if wider else self.rate, Trend.HOLD, -1)
        if highest == self._session:
            self._before_cap = 0.0

    def due(self, now: float) -> bool:
        """Whether a state is to be sent now; if so, it is taken as sent."""
        period = 1.0 / self.rate
        # Half a period early is in time, so that a sender at its own rate never misses by a hair. The next is counted
        # from when this one was due, so that the mean rate is right; but what was missed is not made up for.
        if now < self._due - 0.5 * period:
            return False
        self._due = (now if now >= self._due + period else self._due) + period
        if self._received is None:
            self._received = now
        if now - self._received > _SILENCE and self.trend is not Trend.SILENT:
            self._before_silence = self.rate if self._trial is None else self._trial[0]
            self._turn(self._lowest, Trend.SILENT, -1)
        return True

    def report(
        self, now: float, *, sent: int, newest: int, count: int, path: float | None, shortest: float | None
    ) -> None:
        """Takes what the other end says of this direction.

        Args:
            now: [s].
            sent: sequence number of the next datagram.
            newest: greatest sequence number that it opened.
            count: how many it opened.
            path: time there and back, by the echo of this report [s].
            shortest: of the window [s].
        """
        self._received = now
        if self.trend is Trend.SILENT:
            self._turn(_DOWN * self._before_silence, Trend.HOLD, sent)
        if self._started is None:
            if newest >= self._skip:
                self._reached = min(self._reached, now)
                if now >= self._reached + _SETTLE:
                    self._started = (now, newest, count)
                    self._waits.clear()
            return
        then, first, before = self._started
        if newest < first or count < before:
            if newest < first // 2:  # not merely overtaken: the numbers began anew with new keys
                self._turn(self.rate, Trend.HOLD, -1)
            return
        if path is not None and shortest is not None:
            self._waits.append(path - shortest)
        if now - then < _LEAST_INTERVAL or newest - first < _LEAST_SENT:
            return
        waits = sorted(self._waits)
        fraction = (count - before) / (newest - first)
        self.loss = max(0.0, 1.0 - fraction)  # what comes late belongs to the interval before
        interval = _Interval((count - before) / (now - then), self.loss, waits[len(waits) // 4] if waits else 0.0)
        self._started = (now, newest, count)
        self._waits.clear()
        self._judge(interval, newest - first, sent)

    def _judge(self, seen: _Interval, datagrams: int, sent: int) -> None:
        # Three standard deviations of counting, so that chance does not start a try.
        own = max(self.own_loss, 0.01)
        losses = seen.loss > self.own_loss + 0.02 + 3.0 * sqrt(own * (1.0 - own) / datagrams)
        waiting = seen.waited > 1.25 * self.own_wait + _QUEUE
        if self._trial is not None:
            self._conclude(*self._trial, seen, sent)
        elif self._rest > 0:
            self._rest -= 1
        elif losses or waiting:
            self._trial = (self.rate, seen)
            factor = _DOWN if _DOWN * self.rate >= self._lowest else 1.0 / _DOWN
            self._turn(factor * self.rate, Trend.TRY, sent)
        else:
            self.own_loss *= _FORGET
            self.own_wait *= _FORGET
            self.rate = min(self._highest, self.rate + _UP * self._highest)
            self.trend = Trend.UP

    def _conclude(self, rate: float, before: _Interval, seen: _Interval, sent: int) -> None:
        self._trial = None
        lower, higher = (seen, before) if self.rate < rate else (before, seen)
        proportion = min(self.rate, rate) / max(self.rate, rate)
        full = lower.delivered >= 0.5 * (1.0 + proportion) * higher.delivered
        # A path that was just full is not at the lower rate: then losses or waiting are gone, to half at least.
        full |= higher.loss > 0.05 and lower.loss < 0.5 * higher.loss
        full |= higher.waited > _QUEUE and lower.waited < 0.5 * higher.waited
        if full:
            if rate < self.rate:
                self._rest = _REST
            self._turn(min(rate, self.rate), Trend.FULL, sent)
        else:
            self.own_loss = max(self.own_loss, 0.5 * (lower.loss + higher.loss))
            self.own_wait = max(self.own_wait, lower.waited, higher.waited)
            self._turn(max(rate, self.rate), Trend.OWN, sent)

    def _turn(self, rate: float, trend: Trend, sent: int) -> None:
        """Changes the rate and waits until reports are about it."""
        if trend in {Trend.SILENT, Trend.HOLD}:
            self._trial = None
        self.rate = min(self._highest, max(self._lowest, rate))
        self.trend = trend
        self._started, self._skip, self._reached = None, sent, float("inf")
