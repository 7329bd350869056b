import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cotouch.errors import ScenarioError
from cotouch.scenario import Scenario
from cotouch.simulation import schedule
from cotouch.simulation._timing import ages, elapsed, indexed, newest, ring_size, self_paced

PAIR = {"users": ["a", "b"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.03], [0.05, 0]]}
times = st.lists(st.floats(1e-3, 0.1), min_size=1, max_size=40).map(np.cumsum)


def scenario(**tables: object) -> Scenario:
    return Scenario.make(network=PAIR, **tables)


@given(times, times, st.data())
def test_newest_is_the_newest_that_arrived(sent: np.ndarray, end: np.ndarray, data: st.DataObject) -> None:
    latency = np.array(
        data.draw(st.lists(st.one_of(st.floats(0, 0.5), st.just(np.inf)), min_size=sent.size, max_size=sent.size))
    )
    used = np.zeros(end.size, np.int32)
    newest(sent, sent + latency, end, used)
    for k, now in enumerate(end):
        there = [m for m in range(sent.size) if sent[m] + latency[m] <= now and sent[m] < now]
        assert used[k] == max(there, default=-1)


@given(times, st.integers(1, 10), st.data())
def test_indexed_takes_its_sample_or_the_newest_before(clock: np.ndarray, delay: int, data: st.DataObject) -> None:
    latency = np.array(data.draw(st.lists(st.floats(0, 0.5), min_size=clock.size, max_size=clock.size)))
    used = np.zeros(clock.size, np.int32)
    short = indexed(latency, clock, delay, used)
    missing = 0
    for k, now in enumerate(clock):
        there = [m for m in range(max(k - delay + 1, 0)) if clock[m] + latency[m] <= now + 1e-9]
        assert used[k] == max(there, default=-1)
        missing += int(used[k] < k - delay)
    assert short == missing


def test_ages_count_from_mid_step_to_the_end_of_the_step_that_uses_the_sample() -> None:
    age = np.zeros(3)
    used = np.array([-1, 0, 2], dtype=np.int32)
    ages(np.array([0.1, 0.3, 0.5]), np.array([0.1, 0.2, 0.4]), np.array([0.1, 0.1, 0.2]), used, age)
    assert age == pytest.approx([0.1, 0.25, 0.2])


def test_self_paced_steps_are_the_earliest_possible() -> None:
    rng = np.random.default_rng(3)
    users, steps = 4, 60
    period = rng.uniform(0.01, 0.02, (users, steps))
    peers = [[j for j in range(users) if j != i] for i in range(users)]
    first = np.cumsum([0] + [len(row) for row in peers]).astype(np.int32)
    peer = np.array([j for row in peers for j in row], dtype=np.int32)
    delay = rng.integers(1, 5, peer.size).astype(np.int32)
    latency = rng.exponential(0.03, (peer.size, steps))
    end = np.zeros((users, steps))
    self_paced(period, first, peer, delay, latency, end)
    for i in range(users):
        for k in range(steps):
            bounds = [(end[i, k - 1] if k else 0.0) + period[i, k]]
            slots = [s for s in range(first[i], first[i + 1]) if k >= delay[s]]
            bounds += [end[peer[s], k - delay[s]] + latency[s, k - delay[s]] for s in slots]
            assert end[i, k] == max(bounds)
    bound = np.full(users, 2.0 * end[:, -1].max() / steps)
    length = np.zeros_like(end)
    elapsed(end, bound, length)
    integrated = np.cumsum(length, axis=1)
    assert (length > 0).all()
    assert (length <= bound[:, None]).all()
    assert (integrated <= end + 1e-12).all()
    # Wherever T was below the bound, integration has caught up with real time: no drift.
    free = length < bound[:, None]
    assert free.any()
    assert np.allclose(integrated[free], end[free], rtol=0, atol=1e-12)


def test_self_pacing_without_jitter_is_the_constant_mode() -> None:
    constant = schedule(scenario(synchronisation={"mode": "constant"}, steps={"duration": 1.0, "period": 0.01}))
    paced = schedule(scenario(synchronisation={"mode": "self-paced"}, steps={"duration": 1.0, "period": 0.01}))
    assert np.array_equal(constant.used, paced.used)
    assert np.allclose(constant.end, paced.end, rtol=0, atol=1e-12)
    assert constant.index_delay is not None
    assert constant.index_delay.tolist() == [[0, 3], [5, 0]]
    assert constant.underruns.sum() == 0


def test_self_pacing_follows_real_time_over_a_jittery_lossy_channel() -> None:
    timing = schedule(
        scenario(
            synchronisation={"mode": "self-paced"},
            steps={"duration": 20.0, "period": 0.01},
            channel={"jitter": {"kind": "exponential", "scale": 0.02}, "loss": 0.05},
        )
    )
    for i, n in enumerate(timing.count):
        assert abs(timing.end[i, n - 1] - timing.length[i, :n].sum()) < 0.5
    assert timing.length.max() > 0.01


def test_constant_mode_covers_every_sample_unless_told_otherwise() -> None:
    tables = {"steps": {"duration": 5.0, "period": 0.01}, "channel": {"jitter": {"scale": 0.05}, "loss": 0.05}}
    everything = schedule(scenario(synchronisation={"mode": "constant"}, **tables))
    assert everything.underruns.sum() == 0
    half = schedule(scenario(synchronisation={"mode": "constant", "quantile": 0.5}, **tables))
    assert half.underruns.sum() > 0
    assert half.index_delay is not None
    assert everything.index_delay is not None
    assert half.index_delay.max() < everything.index_delay.max()


def test_own_rates_step_at_own_times() -> None:
    timing = schedule(scenario(steps={"duration": 1.0, "rate": [100.0, 250.0]}))
    assert timing.count.tolist() == [100, 250]
    assert timing.reference == 1
    assert timing.order.size == 350
    counter = np.zeros(2, int)
    clock = 0.0
    for i in timing.order:
        now = timing.end[i, counter[i]]
        assert now >= clock
        clock = now
        counter[i] += 1


def test_own_step_lengths_share_one_index() -> None:
    timing = schedule(scenario(synchronisation={"mode": "constant"}, steps={"duration": 1.0, "period": [0.01, 0.02]}))
    assert timing.count.tolist() == [50, 50]
    assert (timing.length[0] == 0.01).all()
    assert (timing.length[1] == 0.02).all()
    assert np.allclose(timing.end[0], 0.02 * np.arange(1, 51))


def test_random_steps_stay_within_bounds_and_repeat() -> None:
    tables = {"steps": {"duration": 2.0, "random": {"low": 0.001, "high": 0.02}}}
    a, b = schedule(scenario(**tables)), schedule(scenario(**tables))
    for i, n in enumerate(a.count):
        assert (a.length[i, :n] >= 0.001).all()
        assert (a.length[i, :n] <= 0.02).all()
        assert 1.97 < a.end[i, n - 1] <= 2.0
    assert np.array_equal(a.length, b.length)
    assert not np.array_equal(a.length, schedule(scenario(seed=1, **tables)).length)
    assert not np.array_equal(a.length[0], a.length[1])


def test_ring_keeps_what_is_still_needed() -> None:
    timing = schedule(
        scenario(channel={"jitter": {"scale": 0.1}, "loss": 0.3}, steps={"duration": 2.0, "rate": [90, 130]})
    )
    counter = np.zeros(2, int)
    for i in timing.order:
        for s in range(timing.slots.first[i], timing.slots.first[i + 1]):
            index = timing.used[s, counter[i]]
            written = counter[timing.slots.sender[s]]
            assert index < written
            assert index < 0 or written - index <= timing.ring
        counter[i] += 1
    again = ring_size(timing.order, timing.slots.first, timing.slots.sender, timing.used, np.zeros(2, np.int32))
    assert again <= timing.ring < 2 * again
    assert timing.ring & (timing.ring - 1) == 0


def test_waiting_longer_than_the_run_is_said() -> None:
    network = {**PAIR, "delay": [[0, 30.0], [30.0, 0]]}
    delays = [[0, 1], [1, 0]]
    with pytest.raises(ScenarioError, match="make it longer"):
        schedule(
            Scenario.make(
                network=network,
                synchronisation={"mode": "self-paced", "index_delay": delays},
                steps={"duration": 0.005, "period": 0.01},
            )
        )
