"""Tuned springs: slopes against differences, closed form and grid, the limit, and never worse."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.network.support import five_users, pairs, random_network, uniform
from tests.planning.inside import Search
from tests.thorough import examples

from cotouch.errors import NetworkError, UnsupportedError
from cotouch.network import Network, path, rightmost_root, rule_damping
from cotouch.planning import tune_springs

OBJECTS = [
    {"mass": 1.0, "damping": 0.0, "stiffness": 0.0},
    {"mass": 2.0, "damping": 0.3, "stiffness": 4.0},
]


def ages(network: Network) -> np.ndarray:
    return rule_damping(network, ages=network.delay)[:, 0]


def search_of(network: Network, thing: dict[str, float]) -> Search:
    return Search(
        network, np.full(network.size, 1e9), np.array([[thing[name] for name in ("mass", "damping", "stiffness")]])
    )


@pytest.mark.parametrize("thing", OBJECTS)
def test_slopes_of_the_front_against_differences(thing):
    """Of every simple root in the front, in relative changes of every spring; the damping goes along."""
    checked = 0
    for seed in range(4):
        network = random_network(np.random.default_rng(seed), delays=(0.1, 1.0))
        search = search_of(network, thing)
        springs = search.springs_of(network)
        roots, slopes = search.front(search.at(springs), springs)
        h = 1e-6
        for e in range(len(springs)):
            shifted = []
            for sign in (1, -1):
                moved = springs.copy()
                moved[e] *= 1 + sign * h
                shifted.append(search.front(search.at(moved), moved)[0])
            for root, slope in list(zip(roots, slopes[:, e], strict=True))[:5]:
                after, before = (there[np.argmin(abs(there - root))] for there in shifted)
                assert abs((after - before) / (2 * h) - slope) < 1e-5 * (1 + abs(slope))
                checked += 1
    assert checked > 50


def test_a_pair_that_meets_moves_smoothly_in_mean_and_square():
    """The slopes of the second program, against differences, on a conjugate pair."""
    network = uniform(path(3), 3, spring=1.0, delay=0.3)
    search = search_of(network, OBJECTS[0])
    springs = np.array([1.0, 2.0])
    here, h = search.programs(search.at(springs), springs), 1e-6
    assert len(here) > 1
    for e in range(2):
        moved = springs.copy()
        moved[e] *= 1 + h
        there = search.programs(search.at(moved), moved)
        for one, other in zip(here[1:], there[1:], strict=True):
            assert (other.apart - one.apart) / h == pytest.approx(one.parting[:, e], rel=1e-3, abs=1e-4)
            assert (other.rates - one.rates)[-1] / h == pytest.approx(one.slopes[-1, e], rel=1e-3, abs=1e-4)


@settings(max_examples=examples(12))
@given(seed=st.integers(0, 10_000), fraction=st.floats(0.2, 3.0), thing=st.sampled_from(OBJECTS))
def test_never_worse_and_within_the_limits(seed, fraction, thing):
    rng = np.random.default_rng(seed)
    network = random_network(rng, size=int(rng.integers(2, 5)))
    limit = fraction * ages(network).max() * rng.uniform(0.8, 1.2, network.size)
    tuned = tune_springs(network, damping_limit=limit, rounds=15, **thing)
    factor = min(1.0, float((limit / np.maximum(ages(network), 1e-300)).min()))
    assert tuned.start_factor == pytest.approx(factor, rel=1e-12)
    start = network.replace(spring=network.spring * factor)
    assert tuned.before == pytest.approx(rightmost_root(start, **thing).rate, rel=1e-9)
    assert tuned.after <= tuned.before
    assert tuned.after == pytest.approx(rightmost_root(tuned.network, **thing).rate, rel=1e-9)
    assert (tuned.sync_damping <= limit * (1 + 1e-12)).all()
    np.testing.assert_allclose(tuned.sync_damping, ages(tuned.network), rtol=1e-12)
    assert tuned.network.links == network.links
    used, new = ([net.spring[i, j] for i, j in net.links] for net in (start, tuned.network))
    assert min(new) >= min(used) / 10 * (1 - 1e-6)
    assert max(new) <= max(used) * 10 * (1 + 1e-6)


def test_two_users_against_a_fine_grid():
    """One spring: the whole range is tried."""
    network = uniform(path(2), 2, spring=1.0, delay=0.4)
    tuned = tune_springs(network, damping_limit=3.0)
    grid = np.geomspace(0.1, 3.0 / 0.4, 300)
    rates = [rightmost_root(network.replace(spring=[[0, k], [k, 0]])).rate for k in grid]
    assert tuned.after <= min(rates) + 1e-9
    assert tuned.after == pytest.approx(min(rates), rel=1e-2)
    assert tuned.after < tuned.before * 1.2


def test_two_users_without_delay_in_closed_form():
    """No delay, no rule: with b = 2c·m the difference mode is fastest once its spring makes it ring, at -b/2m."""
    network = uniform(path(2), 2, spring=0.1, delay=0.0)
    m, b = 2.0, 6.0
    tuned = tune_springs(network, damping_limit=1.0, mass=m, damping=b)
    # s² m/2 + s b/2 + 2 K: roots at -b/2m once K >= b²/16 m; the sum mode has -b/m.
    assert tuned.before == pytest.approx(max(np.roots([m / 2, b / 2, 0.2]).real), abs=1e-9)
    assert b * b / 16 / m > 1.0  # Out of reach at first: as stiff as is allowed.
    assert tuned.after == pytest.approx(max(np.roots([m / 2, b / 2, 2.0]).real), rel=1e-9)
    free = tune_springs(network, damping_limit=1.0, mass=m, damping=b, highest=9.0)
    assert free.after == pytest.approx(-b / 2 / m, rel=1e-6)


def test_two_springs_against_a_grid():
    network = uniform(path(3), 3, spring=1.0, delay=0.5).replace(delay=[[0, 0.2, 0.0], [0.3, 0, 0.9], [0.0, 0.7, 0]])
    tuned = tune_springs(network, damping_limit=1.0)
    best = 0.0
    for first in np.geomspace(0.08, 10, 20):
        for second in np.geomspace(0.08, 10, 20):
            chosen = network.replace(spring=[[0, first, 0], [first, 0, second], [0, second, 0]])
            if ages(chosen).max() <= 1.0:
                best = min(best, rightmost_root(chosen).rate)
    assert tuned.after <= best * 0.999
    assert tuned.before > best


def test_the_papers_best_topology():
    """The largest damping stays as it is; the decay is nearly four times as fast."""
    network = five_users().with_links(pairs("12 14 23 24 34 45"))
    limit = ages(network).max()
    tuned = tune_springs(network, damping_limit=limit, rounds=40)
    assert tuned.before == pytest.approx(-1.428553, abs=1e-6)
    assert tuned.after < -5.0
    assert tuned.sync_damping.max() <= limit * (1 + 1e-12)
    again = tune_springs(network, damping_limit=limit, rounds=40)
    np.testing.assert_array_equal(again.network.spring, tuned.network.spring)


def test_a_start_that_breaks_the_limit_is_scaled_into_it():
    network = uniform(path(3), 3, spring=2.0, delay=0.5)
    tuned = tune_springs(network, damping_limit=[9.0, 1.0, 9.0], rounds=0)
    assert tuned.start_factor == pytest.approx(0.5)
    assert tuned.rounds == 0
    assert tuned.before == tuned.after
    np.testing.assert_allclose(tuned.network.spring, network.spring / 2)


def test_nothing_to_tune():
    """Without any delay and damping the translation drifts, whatever the springs."""
    network = uniform(path(2), 2, delay=0.0)
    tuned = tune_springs(network, damping_limit=1.0)
    assert (tuned.before, tuned.after, tuned.rounds) == (0.0, 0.0, 0)


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"damping_limit": 0.0}, "damping_limit is 0 Ns/m; it must be finite and above 0"),
        ({"damping_limit": float("nan")}, "damping_limit is nan Ns/m"),
        ({"damping_limit": "much"}, "damping_limit is 'much'; it must be a number"),
        ({"damping_limit": [1.0, 2.0]}, r"damping_limit has shape \(2,\); it must be one number or \(3,\)"),
        ({"damping_limit": [1.0, -2.0, 1.0]}, "damping_limit of user 2 .*is -2 Ns/m"),
        ({"damping_limit": 1.0, "lowest": -1.0}, "lowest is -1 N/m; it must be finite and above 0"),
        ({"damping_limit": 1.0, "highest": float("inf")}, "highest is inf N/m"),
        ({"damping_limit": 1.0, "lowest": 3.0, "highest": 2.0}, "lowest must not be above highest"),
        ({"damping_limit": 0.5, "lowest": 0.9}, "between users 1 and 2, scaled by 0.25 into .* lowest is 0.9 N/m"),
        ({"damping_limit": 9.0, "highest": 0.5}, "is 1 N/m, and highest is 0.5 N/m; start within the bounds"),
        ({"damping_limit": 1.0, "rounds": -1}, "rounds is -1; it must be a whole number, at least 0"),
        ({"damping_limit": 1.0, "mass": 0.0}, "mass is 0 kg"),
    ],
)
def test_bad_input(options, sentence):
    with pytest.raises(NetworkError, match=sentence):
        tune_springs(uniform(path(3), 3), **options)


def test_networks_it_does_not_take():
    with pytest.raises(NetworkError, match="2 separate groups"):
        tune_springs(uniform([(0, 1), (2, 3)], 4), damping_limit=1.0)
    weighted = Network(users=["a", "b"], spring=[[0, 1], [1, 0]], delay=[[0, 1], [1, 0]], weight=np.diag([1.0, 2.0]))
    with pytest.raises(UnsupportedError, match="springs have weights"):
        tune_springs(weighted, damping_limit=1.0)


def test_the_slowest_of_several_modes_counts():
    network = five_users()
    modes = {"mass": [1.0, 3.0], "damping": [0.0, 0.5], "stiffness": [0.0, 40.0]}
    tuned = tune_springs(network, damping_limit=80.0, rounds=6, **modes)
    rates = [
        rightmost_root(tuned.network, mass=m, damping=b, stiffness=k).rate
        for m, b, k in zip(*modes.values(), strict=True)
    ]
    assert tuned.after == pytest.approx(max(rates), rel=1e-12)
    assert tuned.after < tuned.before
    assert tuned.mode[0] == modes["mass"][int(np.argmax(rates))]
    # Tuned for the first mode alone, the second is left slower than need be.
    alone = tune_springs(network, damping_limit=80.0, rounds=6, mass=1.0)
    assert (
        max(
            rightmost_root(alone.network, mass=m, damping=b, stiffness=k).rate
            for m, b, k in zip(*modes.values(), strict=True)
        )
        >= tuned.after - 1e-9
    )
