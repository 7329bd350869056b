import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.simulation.inside import ages, elapsed, indexed, newest, ring_size, self_paced

from cotouch.errors import ScenarioError
from cotouch.scenario import Scenario
from cotouch.simulation import schedule

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
        there = [m for m in range(sent.size) if sent[m] + latency[m] <= now + 1e-9 and sent[m] < now]
        assert used[k] == max(there, default=-1)


@given(times, st.integers(1, 10), st.data())
def test_indexed_takes_its_sample_or_the_newest_before(clock: np.ndarray, delay: int, data: st.DataObject) -> None:
    def of_each(most: float) -> np.ndarray:
        return np.array(data.draw(st.lists(st.floats(0, most), min_size=clock.size, max_size=clock.size)))

    latency, sent, end = of_each(0.5), clock + of_each(9e-4), clock + of_each(9e-4)
    used = np.zeros(clock.size, np.int32)
    short = indexed(latency, sent, end, delay, used)
    missing = 0
    for k, now in enumerate(end):
        there = [m for m in range(max(k - delay + 1, 0)) if sent[m] + latency[m] <= now + 1e-9]
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


@pytest.mark.parametrize("delay", [0.005, 0.025, 0.1, 0.2])
def test_over_a_constant_delay_of_whole_steps_every_sample_is_used_once(delay: float) -> None:
    """Round-off decided whether it was there at the instant of a step, so up to 15 % of the samples were left out."""
    network = {**PAIR, "delay": [[0, delay], [delay, 0]]}
    steps = {"duration": 3.0, "period": 0.001}
    newest, index = (
        schedule(Scenario.make(network=network, steps=steps, synchronisation={"mode": mode}))
        for mode in ("freshest", "constant")
    )
    assert np.array_equal(newest.used, index.used)
    assert np.ptp(newest.age[:, 300:]) < 1e-9


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


def test_a_run_of_random_steps_lasts_as_long_as_was_asked_for() -> None:
    """Self-paced users wait for samples alone; they took only as many steps as if all waited: 1.58 s of 2 s."""
    for mode in ("freshest", "constant", "self-paced"):
        timing = schedule(
            scenario(
                synchronisation={"mode": mode}, steps={"duration": 2.0, "random": {"low": 1e-3, "high": 1e-2}}, seed=3
            )
        )
        last = np.array([row[n - 1] for row, n in zip(timing.end, timing.count, strict=True)])
        assert (last > 2.0 - 0.02).all()
        assert (last <= 2.0 + 1e-9).all()


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


@pytest.mark.parametrize("steps", [{"period": [0.01, 0.02]}, {"rate": [1000, 100]}])
def test_clocks_of_different_rates_cannot_share_one_index(steps: dict[str, object]) -> None:
    with pytest.raises(ScenarioError, match=r'^the scenario: steps\.\w+ is \[.*\], but .* use mode "freshest"'):
        scenario(synchronisation={"mode": "constant"}, steps=steps)
    scenario(synchronisation={"mode": "constant"}, steps={name: [0.01, 0.01] for name in steps})


def test_steps_of_a_common_index_last_while_their_user_waits() -> None:
    random = {"low": 0.001, "high": 0.02}
    timing = schedule(scenario(synchronisation={"mode": "constant"}, steps={"duration": 5.0, "random": random}))
    end, length = timing.end, timing.length
    # Nobody takes a step before all have taken the one before, and then each takes as long as it was going to.
    assert (end[:, 1:].min(axis=0) > end[:, :-1].max(axis=0)).all()
    begun = np.concatenate([[0.0], end.max(axis=0)[:-1]])
    assert np.allclose(end - begun, timing.nominal, rtol=0, atol=1e-12)
    # Everybody's copy has simulated what has passed, at every step, though T_i(k) differs.
    assert np.allclose(np.cumsum(length, axis=1), end, rtol=0, atol=1e-12)
    assert np.abs(length[0] - length[1]).max() > 0.01
    assert length.min() >= 0.001
    assert length.max() <= 2 * 0.02 - 0.001
    assert timing.bound == pytest.approx(length.max(axis=1))
    assert timing.underruns.sum() == 0


def test_an_index_delay_is_the_smallest_that_covers_what_it_is_to_cover() -> None:
    steps = {"duration": 5.0, "random": {"low": 0.001, "high": 0.02}}
    tables = {"steps": steps, "channel": {"jitter": {"scale": 0.05}, "loss": 0.05}}
    found = schedule(scenario(synchronisation={"mode": "constant"}, **tables))
    assert found.underruns.sum() == 0
    assert found.index_delay is not None
    for i, j in ((0, 1), (1, 0)):
        fewer = found.index_delay.copy()
        fewer[i, j] -= 1
        short = schedule(scenario(synchronisation={"mode": "constant", "index_delay": fewer.tolist()}, **tables))
        assert short.underruns.sum() > 0


def test_a_longest_step_that_cannot_be_kept_is_refused() -> None:
    steps = {"duration": 5.0, "random": {"low": 0.001, "high": 0.02}}
    schedule(scenario(synchronisation={"mode": "constant", "max_step": 2.0}, steps=steps))
    with pytest.raises(ScenarioError, match=r'max_step is 1; a step of user \d may last .* use mode "freshest"'):
        schedule(scenario(synchronisation={"mode": "constant", "max_step": 1.0}, steps=steps))


def test_self_pacing_that_could_never_make_up_for_its_waits_is_refused() -> None:
    steps = {"duration": 2.0, "period": [0.001, 0.01]}
    with pytest.raises(ScenarioError, match=r"max_step is 2; a step of user 1 simulates 0.002 s at most.*least 1\d,"):
        schedule(scenario(synchronisation={"mode": "self-paced", "max_step": 2.0}, steps=steps))
    timing = schedule(scenario(synchronisation={"mode": "self-paced", "max_step": 12.0}, steps=steps))
    assert abs(timing.end[0, -1] - timing.length[0].sum()) < 0.012
    # One that waits for long is behind for a while, and that is said.
    jitter = {"jitter": {"kind": "exponential", "scale": 0.05}}
    waits = schedule(
        scenario(synchronisation={"mode": "self-paced"}, steps={"duration": 2.0, "period": 0.01}, channel=jitter)
    )
    late = waits.end - np.cumsum(waits.length, axis=1)
    assert waits.behind == pytest.approx([late[i, :n].max() for i, n in enumerate(waits.count)], abs=1e-12)
    assert waits.behind.max() > 0.0


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
