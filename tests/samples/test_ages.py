"""The sum of both directions' ages is exact whatever the clocks show; its parts are nobody's business."""

import gc
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cotouch.samples import AgeWindow, LinkAges

offsets = st.floats(-1e8, 1e8)


@given(st.lists(st.tuples(st.floats(0.0, 3.0), st.floats(-5.0, 5.0)), min_size=1, max_size=80), st.floats(0.0, 1.0))
def test_the_window_against_a_list(steps: list[tuple[float, float]], q: float):
    window, now, held = AgeWindow(2.0), 0.0, []
    for wait, value in steps:
        now += wait
        window.add(now, value)
        held = [(then, was) for then, was in [*held, (now, value)] if then >= now - 2.0]
        values = [was for _, was in held]
        assert (window.greatest, window.smallest, len(window)) == (max(values), min(values), len(values))
        found = window.quantile(q)
        assert found in values
        assert sum(was <= found for was in values) >= q * len(values) - 1e-9


def blocks() -> int:
    """How much Python holds."""
    gc.collect()
    return sys.getallocatedblocks()


def test_the_window_does_not_grow_without_end():
    window = AgeWindow(1e9)
    for k in range(50_000):
        window.add(float(k), float(-k))
    assert len(window) == 20_000
    assert (window.greatest, window.smallest) == (-30_000.0, -49_999.0)
    before = blocks()
    for k in range(50_000, 100_000):
        window.add(float(k), float(-k))
    assert blocks() - before < 1000


def test_quantiles_of_a_window_that_is_full():
    rng = np.random.default_rng(3)
    window, values = AgeWindow(1e9), rng.normal(0.0, 1.0, 21_000)
    window.add(-2.0, 0.0)
    window.add(-1.0, 1.0)
    assert window.quantile(0.0) == 0.0  # from now on it is kept in order
    for k, value in enumerate(values):
        window.add(float(k), float(value))
    for q in (0.0, 0.25, 0.5, 0.99, 1.0):
        assert window.quantile(q) == np.quantile(values[-20_000:], q, method="higher")


def simulate(seed: int, offset: float, drift: float, loss: float, window: float):
    """Two users at their own rates over a bad path. True ages are kept beside what the two find with their clocks."""
    rng = np.random.default_rng(seed)
    ends = [LinkAges(window=window), LinkAges(window=window)]
    period = [0.001 * rng.integers(1, 20), 0.001 * rng.integers(1, 20)]
    delay = rng.uniform(0.0, 0.2, 2)  # to user 0, to user 1
    clocks = [lambda t: t, lambda t: t * (1.0 + drift) + offset]
    flying, newest, arrived = [], [None, None], [None, None]
    true: list[list[tuple[float, float]]] = [[], []]
    paths: list[float] = []
    now, due = 0.0, [0.0, 0.0]
    while now < 6.0:
        user = int(due[1] < due[0])
        now = due[user]
        due[user] += period[user]
        for message in sorted(m for m in flying if m[0] <= now and m[1] == user):
            flying.remove(message)
            when, _, stamp, index, told, echo, sent_true = message
            if newest[user] is None or stamp > newest[user][0]:
                newest[user], arrived[user] = (stamp, sent_true), when
            clock = clocks[user](now)
            if told is not None:
                ends[user].received(clock, index=index, age=told[0], worst=told[1])
            if echo is not None:
                path = ends[user].echoed(clock, arrived=clocks[user](when), echo=echo[0], held=echo[1])
                assert path is not None
                paths.append(path)
        if newest[user] is not None:
            ends[user].used(clocks[user](now), newest[user][0])
            true[user].append((now, now - newest[user][1]))
        middle = now - 0.5 * period[user]
        if rng.random() >= loss:
            echo = None
            if newest[user] is not None:
                echo = (newest[user][0], clocks[user](now) - clocks[user](arrived[user]))
            latency = delay[1 - user] + rng.exponential(0.02)
            flying.append(
                (now + latency, 1 - user, clocks[user](middle), round(now / period[user]), ends[user].own, echo, middle)
            )
    return ends, true, delay, paths, now


@given(seed=st.integers(0, 10**6), offset=offsets, loss=st.sampled_from([0.0, 0.3]))
def test_the_sum_of_the_greatest_ages_is_exact(seed: int, offset: float, loss: float):
    """The window holds everything; what was found last may still be on its way, so it is looked for among the true."""
    ends, true, _, _, _ = simulate(seed, offset, 0.0, loss, 100.0)
    worst = [max(age for _, age in ages) for ages in true]
    tolerance = 4e-8 if abs(offset) > 1.0 else 1e-9  # numbers of 1e8 s have steps of 1.5e-8 s
    for user, end in enumerate(ends):
        assert end.own[1] + (offset if user == 0 else -offset) == pytest.approx(worst[user], abs=tolerance)
        received = end.worst_sum - end.own[1] + (-offset if user == 0 else offset)
        assert any(abs(received - age) <= tolerance for _, age in true[1 - user])
        assert end.worst_sum <= worst[0] + worst[1] + 2 * tolerance
        assert end.worst_sum == pytest.approx(worst[user] + received, abs=2 * tolerance)
        assert end.impossible == 0


@given(seed=st.integers(0, 10**6), offset=offsets)
def test_quantiles_of_the_sum_do_not_depend_on_the_clocks(seed: int, offset: float):
    set_alike, apart = (simulate(seed, shift, 0.0, 0.2, 100.0)[0] for shift in (0.0, offset))
    for one, other in zip(set_alike, apart, strict=True):
        for q in (0.5, 0.9, 0.99, 1.0):
            assert one.sum_quantile(q) == pytest.approx(other.sum_quantile(q), abs=1e-7)
        assert one.sum_quantile(0.5) <= one.sum_quantile(0.99) <= one.sum_quantile(1.0)


@given(seed=st.integers(0, 10**6), offset=offsets)
def test_the_path_is_its_own_time_whatever_waits_at_its_ends(seed: int, offset: float):
    """From a stamp, half a step before sending, there and back again: at least the constant delays."""
    ends, _, delay, paths, _ = simulate(seed, offset, 0.0, 0.1, 100.0)
    assert min(paths) >= delay.sum() - 1e-7
    for end in ends:
        assert delay.sum() - 1e-7 <= end.shortest_path <= delay.sum() + 0.5 * 0.019 * 2 + 0.1


@pytest.mark.parametrize("drift", [1e-4, -1e-4, 5e-5])
def test_drifting_clocks_change_the_sum_by_no_more_than_they_drift(drift: float):
    ends, true, _, _, _ = simulate(7, 12.5, drift, 0.1, 100.0)
    worst = sum(max(age for _, age in ages) for ages in true)
    for end in ends:
        assert end.impossible == 0
        assert abs(end.worst_sum - worst) <= 2 * 6.0 * abs(drift) + 0.01


def test_what_was_long_ago_is_forgotten():
    ages = LinkAges(window=1.0)
    ages.used(0.0, -5.0)
    ages.received(0.0, index=0, age=5.0, worst=5.0)
    assert ages.worst_sum == 10.0
    for k in range(1, 30):
        ages.used(0.1 * k, 0.1 * k - 0.1)
        ages.received(0.1 * k, index=k, age=0.2, worst=0.2)
    assert ages.worst_sum == pytest.approx(0.3)
    assert ages.sum_quantile(0.5) == pytest.approx(0.3)


def test_a_report_that_was_overtaken_does_not_count_again():
    ages = LinkAges()
    ages.used(0.0, -1.0)
    ages.received(0.1, index=9, age=1.0, worst=3.0)
    ages.received(0.2, index=8, age=1.0, worst=7.0)
    assert ages.worst_sum == 4.0


def test_nothing_is_known_at_first():
    ages = LinkAges()
    assert (ages.own, ages.worst_sum, ages.sum_quantile(0.9), ages.shortest_path) == (None, None, None, None)
    ages.used(1.0, 0.5)
    assert (ages.own, ages.worst_sum, ages.sum_quantile(0.9)) == ((0.5, 0.5), None, None)


def test_an_echo_from_the_future_is_counted():
    ages = LinkAges()
    assert ages.echoed(1.0, arrived=1.0, echo=2.0, held=0.0) is None
    assert ages.echoed(1.0, arrived=1.0, echo=0.5, held=0.6) is None
    assert ages.impossible == 2
    assert ages.shortest_path is None


def test_waiting_to_be_read_is_not_the_paths_time():
    ages = LinkAges()
    assert ages.echoed(5.0, arrived=4.0, echo=1.0, held=1.0) == 2.0
    assert ages.shortest_path == 2.0


STEP, PATH = 0.01, 0.05


class Receiver:
    """Steps of 10 ms, and a sample of 50 ms for each of them while there are any."""

    def __init__(self, **options: float) -> None:
        self.ages, self.k, self.stamp = LinkAges(**options), 0, -PATH

    @property
    def worst(self) -> float:
        assert self.ages.own is not None
        return self.ages.own[1]

    def steps(self, seconds: float, *, arrives: bool = True, late: float = 0.0) -> None:
        for _ in range(round(seconds / STEP)):
            self.k += 1
            now = self.k * STEP
            if arrives:
                self.stamp = now - PATH - late
            self.ages.used(now, self.stamp)
            assert self.ages.own is not None
            assert self.ages.own[0] <= self.ages.own[1]  # or nobody would believe what is told


def test_an_outage_is_not_the_path():
    end = Receiver()
    end.steps(3.0)
    end.steps(4.0, arrives=False)
    assert end.ages.age == pytest.approx(PATH + 4.0)
    end.steps(0.4, late=0.3)  # what was held up
    assert end.ages.age == pytest.approx(PATH + 0.3)
    end.steps(3.0)
    assert end.worst == pytest.approx(PATH)
    assert end.ages.own_quantile(0.5) == pytest.approx(PATH)
    assert end.ages.outages == 1
    end.steps(1.0, late=0.3)  # the path itself has become longer
    assert end.worst == pytest.approx(PATH + 0.3)


def test_what_a_path_loses_now_and_then_counts():
    end = Receiver()
    end.steps(3.0)
    end.steps(0.45, arrives=False)
    assert end.worst == pytest.approx(PATH)  # nobody knows yet which it is
    end.steps(0.5)
    assert end.worst == pytest.approx(PATH + 0.45)
    assert end.ages.outages == 0
    # Every step's counts, so that a quantile is a share of the time: of 395 these 45.
    assert end.ages.own_quantile(349 / 394) == pytest.approx(PATH)
    assert end.ages.own_quantile(350 / 394) == pytest.approx(PATH + STEP)
    assert end.ages.own_quantile(393 / 394) == pytest.approx(PATH + 0.44)


def test_outages_that_recur_are_the_path():
    end = Receiver(window=10.0)
    for gap in (2.0, 0.8):
        end.steps(1.0)
        end.steps(gap, arrives=False)
    end.steps(1.0)
    assert end.worst == pytest.approx(PATH)
    end.steps(1.2, arrives=False)
    end.steps(0.1)
    assert end.worst == pytest.approx(PATH + 0.8 + STEP)  # the age that it would have had in the next step
    assert end.ages.own_quantile(0.5) == end.worst
    assert end.ages.sum_quantile(1.0) is None
    end.steps(9.0)
    assert end.worst == pytest.approx(PATH)


def test_a_long_outage_takes_no_memory():
    end = Receiver()
    end.steps(1.0)
    before = blocks()
    end.steps(600.0, arrives=False)
    assert blocks() - before < 300
    for _ in range(1000):
        end.steps(0.6, arrives=False)
        end.steps(0.02)
    assert end.ages.outages > 900
    assert blocks() - before < 300


def test_who_sends_seldom_has_longer_pauses():
    end = Receiver(outage=2.0)
    end.steps(1.0)
    end.steps(1.5, arrives=False)
    end.steps(0.5)
    assert end.worst == pytest.approx(PATH + 1.5)
