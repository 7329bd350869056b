"""The send rate on emulated paths, on a clock of their own: it finds what a path bears and leaves a lossy one alone."""

from collections.abc import Callable

import numpy as np
import pytest

from cotouch.samples import EmulatedPath, PathLaw, SendRate, Trend

SIZE = 1200


class Loop:
    """A sender at 1 kHz, a path, and reports that come back at 100 Hz over a path of their own."""

    def __init__(self, law: PathLaw, *, back: PathLaw | None = None, seed: int = 0, highest: float = 1000.0) -> None:
        self.rate = SendRate(highest=highest, lowest=20.0)
        self.there = EmulatedPath(law, np.random.default_rng([seed, 0]))
        self.back = EmulatedPath(back or PathLaw(delay=0.02), np.random.default_rng([seed, 1]))
        self.now, self.sent, self.newest, self.count = 0.0, 0, -1, 0
        self.flying: list[tuple[float, int, float]] = []
        self.reports: list[tuple[float, int, int, float]] = []
        self.shortest = float("inf")
        self.history: list[float] = []
        self.delivered = 0

    def run(self, seconds: float, each: Callable[[], None] | None = None) -> "Loop":
        for tick in range(round(1000 * seconds)):
            self.now += 0.001
            if self.rate.due(self.now):
                for when in self.there.arrivals(self.now, SIZE)[:1]:
                    self.flying.append((when, self.sent, self.now))
                self.sent += 1
            arrived = [entry for entry in self.flying if entry[0] <= self.now]
            self.flying = [entry for entry in self.flying if entry[0] > self.now]
            for when, number, stamp in sorted(arrived):
                self.count += 1
                self.delivered += 1
                if number > self.newest:
                    self.newest, self.latest = number, (when, stamp)
            if tick % 10 == 0 and self.newest >= 0:
                when, stamp = self.latest
                for back in self.back.arrivals(self.now, 100)[:1]:
                    self.reports.append((back, self.newest, self.count, (when - stamp) + back - self.now))
            due = [entry for entry in self.reports if entry[0] <= self.now]
            self.reports = [entry for entry in self.reports if entry[0] > self.now]
            for _, newest, count, path in sorted(due):
                self.shortest = min(self.shortest, path)
                self.rate.report(
                    self.now, sent=self.sent, newest=newest, count=count, path=path, shortest=self.shortest
                )
            self.history.append(self.rate.rate)
            if each:
                each()
        return self

    def mean(self, seconds: float) -> float:
        return float(np.mean(self.history[-round(1000 * seconds) :]))


def test_a_clean_path_keeps_the_highest_rate():
    assert Loop(PathLaw(delay=0.05)).run(10.0).mean(10.0) == 1000.0


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("law", [
    PathLaw(delay=0.04, loss=0.3),
    PathLaw(delay=0.04, loss=0.1, jitter=0.02),
    PathLaw(delay=0.04, jitter=0.2),
    PathLaw(delay=0.3, loss=0.3, jitter=0.2, reordering=0.5, hold=0.05),
])  # fmt: skip
def test_a_path_that_is_merely_bad_is_used_in_full(law: PathLaw, seed: int):
    """Sending less would not lose less: it would only make samples older."""
    loop = Loop(law, seed=seed).run(40.0)
    assert loop.mean(20.0) > 800.0


@pytest.mark.parametrize("capacity", [100.0, 250.0, 500.0, 850.0])
@pytest.mark.parametrize("queue", [0.02, 0.5, 5.0])
def test_a_narrow_path_is_filled_but_not_flooded(capacity: float, queue: float):
    """In states per second; short and long queues before the wire."""
    loop = Loop(PathLaw(delay=0.03, rate=capacity * SIZE, queue=queue)).run(30.0)
    before = loop.delivered
    loop.run(20.0)
    assert 0.3 * capacity <= loop.mean(20.0) <= 1.3 * capacity
    assert loop.delivered - before >= 0.3 * 20.0 * capacity
    assert loop.rate.own_loss < 0.03  # nothing of it is taken for the path's own
    assert loop.rate.own_wait < 0.03


@pytest.mark.parametrize("seed", range(3))
def test_a_path_that_is_narrow_and_lossy(seed: int):
    loop = Loop(PathLaw(delay=0.03, rate=300.0 * SIZE, queue=0.1, loss=0.2), seed=seed).run(60.0)
    assert 60.0 <= loop.mean(20.0) <= 500.0


def test_it_rises_again_when_the_path_is_clean():
    loop = Loop(PathLaw(delay=0.03, rate=150.0 * SIZE, queue=0.1)).run(20.0)
    assert loop.rate.rate < 300.0
    loop.there.law = PathLaw(delay=0.03)
    assert loop.run(30.0).rate.rate == 1000.0


def test_losses_that_end_are_forgotten():
    loop = Loop(PathLaw(delay=0.03, loss=0.3)).run(20.0)
    assert loop.rate.own_loss == pytest.approx(0.3, abs=0.08)
    loop.there.law = PathLaw(delay=0.03)
    assert loop.run(200.0).rate.own_loss < 0.05


def test_an_outage_falls_to_the_lowest_rate_and_comes_back():
    loop = Loop(PathLaw(delay=0.03)).run(5.0)
    loop.back.law = PathLaw(down=True)
    loop.run(3.0)
    assert (loop.rate.rate, loop.rate.trend) == (20.0, Trend.SILENT)
    loop.back.law = PathLaw(delay=0.03)
    loop.run(0.5)
    assert loop.rate.rate >= 500.0
    assert loop.run(10.0).rate.rate == 1000.0


def test_a_neighbour_that_was_never_heard_is_sent_to_at_the_lowest_rate():
    """Nobody may be there, or somebody else."""
    loop = Loop(PathLaw(down=True)).run(2.0)
    assert (loop.rate.rate, loop.rate.trend) == (20.0, Trend.SILENT)
    assert loop.sent < 1100
    loop.there.law = PathLaw(delay=0.03)
    assert loop.run(12.0).rate.rate == 1000.0


def test_numbers_that_begin_anew_do_not_stop_it():
    """After new keys the sequence starts at 0 again."""
    loop = Loop(PathLaw(delay=0.03, rate=150.0 * SIZE, queue=0.1)).run(20.0)
    loop.sent, loop.newest, loop.count = 0, -1, 0
    loop.flying.clear()
    loop.reports.clear()
    loop.there.law = PathLaw(delay=0.03)
    assert loop.run(40.0).rate.rate == 1000.0


@pytest.mark.parametrize("cap", [5.0, 100.0])
def test_nothing_is_sent_above_a_cap_and_nothing_tried(cap: float):
    """Also on a path with losses, where more would be tried."""
    loop = Loop(PathLaw(delay=0.03, loss=0.2))
    loop.rate.cap(cap)
    loop.run(30.0)
    assert max(loop.history) == cap
    assert loop.sent <= 30.0 * cap + 1


def test_a_narrower_path_below_the_cap_is_found():
    loop = Loop(PathLaw(delay=0.03, rate=40.0 * SIZE, queue=0.5))
    loop.rate.cap(100.0)
    loop.run(60.0)
    assert loop.mean(20.0) <= 60.0


def test_without_its_cap_it_rises_again_and_a_cap_that_stays_changes_nothing():
    loop, free = Loop(PathLaw(delay=0.03)).run(5.0), Loop(PathLaw(delay=0.03)).run(5.0)
    for _ in range(3):
        loop.rate.cap(100.0)
        loop.run(1.0)
    assert loop.rate.rate == 100.0
    loop.rate.cap(float("inf"))
    assert loop.rate.rate == 500.0
    assert loop.run(10.0).rate.rate == 1000.0
    free.rate.cap(float("inf"))
    assert free.run(5.0).history[-1] == 1000.0


def test_the_rate_before_a_silence_is_not_forgotten_under_a_cap():
    """A way is lost, another takes over, the first comes back."""
    loop = Loop(PathLaw(delay=0.03)).run(2.0)
    loop.back.law = PathLaw(down=True)
    loop.run(2.0)
    loop.rate.cap(100.0)
    loop.back.law = PathLaw(delay=0.03)
    assert loop.run(2.0).rate.rate == 100.0
    loop.rate.cap(float("inf"))
    assert loop.rate.rate == 500.0


def test_a_silence_under_a_cap_ends_under_it():
    loop = Loop(PathLaw(delay=0.03)).run(2.0)
    loop.rate.cap(100.0)
    loop.back.law = PathLaw(down=True)
    loop.run(3.0)
    assert loop.rate.rate == 20.0
    loop.rate.cap(50.0)
    loop.back.law = PathLaw(delay=0.03)
    assert loop.run(5.0).rate.rate == 50.0


@pytest.mark.parametrize("rate", [20.0, 333.0, 1000.0])
def test_states_go_out_at_the_rate_and_never_in_bursts(rate: float):
    sender = SendRate(highest=rate, lowest=rate)
    sent = []
    for k in range(10_000):
        sender.report(0.001 * k, sent=k, newest=k, count=k, path=None, shortest=None)
        if sender.due(0.001 * k):
            sent.append(k)
    assert abs(len(sent) - 10.0 * rate) <= 0.002 * 10.0 * rate + 1
    assert [sender.due(20.0) for _ in range(3)] == [True, False, False]


def test_the_same_reports_give_the_same_rates():
    runs = [
        Loop(PathLaw(delay=0.03, rate=200.0 * SIZE, queue=0.2, loss=0.1), seed=4).run(20.0).history for _ in range(2)
    ]
    assert runs[0] == runs[1]
