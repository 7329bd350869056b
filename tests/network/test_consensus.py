"""Mixing: against dense eigenvalues, closed forms, and the reference values of the paper's network."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.network.inside import consensus_loop, cycle_period, lifted_matrix
from tests.network.support import GRAPHS, five_users, mixings, pairs, random_network, uniform
from tests.thorough import examples

from cotouch.errors import NetworkError
from cotouch.network import complete, consensus_lags, mixing, ring, slowest


def printed_J(network, lags):
    """The lifted matrix as the paper prints it: A_0 ... A_N, of which A_l (here l = lag - 1) holds the weights."""
    size, longest = network.size, int(lags.max())
    spring = network.linked_spring()
    weights = spring / spring.sum(axis=1, keepdims=True)
    J = np.zeros((size * longest, size * longest))
    for i, j in np.argwhere(lags):
        J[i, (lags[i, j] - 1) * size + j] = weights[i, j]
    J[size:, :-size] = np.eye(size * (longest - 1))
    return J, weights


def moduli(matrix):
    return np.sort(np.abs(np.linalg.eigvals(matrix)))[::-1]


@settings(max_examples=examples(60), deadline=None)
@given(st.integers(0, 10**6), st.sampled_from(["equation", "matrix"]), st.sampled_from([0.04, 0.07, 0.3]))
def test_agrees_with_dense_eigenvalues(seed, convention, unit):
    network = random_network(np.random.default_rng(seed), delays=(0.01, 1.0))
    lags = consensus_lags(network, time_unit=unit, convention=convention, rounding="up")
    J, weights = printed_J(network, lags)
    dense = moduli(J)
    result = mixing(network, time_unit=unit, convention=convention, rounding="up")
    on_circle = int((dense > 1 - 1e-9).sum())
    assert on_circle == result.cycle_period, "a chain of period p has p eigenvalues on the unit circle"
    # A defective eigenvalue 0 of J comes out of the dense solver as large as eps^(1/size).
    assert result.value == pytest.approx(dense[1], abs=1e-9 if dense[1] > 0.3 else 0.3)
    condensed = moduli(lifted_matrix(weights, lags))
    assert condensed[1] == pytest.approx(dense[1], abs=1e-9 if dense[1] > 0.3 else 0.3)


def test_complete_graph_with_unit_delays():
    for n in (3, 4, 6):
        network = uniform(complete(n), n)
        assert mixing(network, time_unit=1.0).value == pytest.approx(1 / (n - 1), abs=1e-12)


def test_odd_ring_with_unit_delays():
    for n in (3, 5, 9):
        network = uniform(ring(n), n)
        assert mixing(network, time_unit=1.0).value == pytest.approx(math.cos(math.pi / n), abs=1e-12)
        # Lag 2 instead of 1: the same chain in the square of z.
        result = mixing(network, time_unit=1.0, convention="matrix")
        assert (result.value, result.cycle_period, result.time_constant_s) == (1.0, 2, math.inf)


def test_time_constant():
    result = mixing(uniform(complete(4), 4, delay=0.5), time_unit=0.5)
    assert result.time_constant_s == pytest.approx(0.5 / math.log(3))


def test_two_users_and_bipartite_graphs_never_mix():
    for links, n in (([(0, 1)], 2), (ring(6), 6)):
        assert mixing(uniform(links, n, delay=0.03), time_unit=0.01).cycle_period == 6
    assert mixing(uniform(ring(5), 5, delay=0.03), time_unit=0.01).cycle_period == 3


@settings(max_examples=examples(60), deadline=None)
@given(st.integers(0, 10**6))
def test_period_is_the_gcd_of_all_cycles(seed):
    rng = np.random.default_rng(seed)
    network = random_network(rng, size=int(rng.integers(2, 6)))
    lags = rng.integers(1, 5, (network.size,) * 2) * int(rng.integers(1, 4)) * network.adjacency()
    # Returns to the first user after k units, counted by walking; all cycle lengths here are far below the horizon.
    horizon = 200
    there = np.zeros((horizon, network.size), dtype=bool)
    there[0, 0] = True
    for k in range(1, horizon):
        for i, j in np.argwhere(lags):
            if lags[i, j] <= k:
                there[k, i] |= there[k - lags[i, j], j]
    assert cycle_period(lags) == math.gcd(*map(int, np.flatnonzero(there[:, 0])))


@pytest.mark.parametrize("unit", [0.01, 0.001])
def test_any_root_as_a_guess_leads_to_the_slowest(unit):
    network = five_users().with_links(pairs("12 14 23 24 34 45"))
    lags = consensus_lags(network, time_unit=unit, convention="matrix", rounding="exact")
    loop = consensus_loop(network, lags, unit)
    expected = mixing(network, time_unit=unit, convention="matrix").value
    for start in (-5 + 100j, -0.1 + 3j, -3 + 310j):
        root, certain, _ = slowest(loop, np.pi / unit, np.array([start], dtype=np.complex128))
        assert certain
        assert np.exp(root.real * unit) == pytest.approx(expected, abs=1e-12)


def test_a_finer_grid_agrees_with_the_dense_matrix():
    """No ordinary grid is too fine: what the windows leave out holds nothing."""
    rng = np.random.default_rng(5)
    for _ in range(6):
        network = random_network(rng, size=4, delays=(0.01, 0.12))
        lags = consensus_lags(network, time_unit=0.001, convention="matrix", rounding="nearest")
        if cycle_period(lags) > 1:
            continue
        spring = network.linked_spring()
        values = moduli(lifted_matrix(spring / spring.sum(axis=1, keepdims=True), lags))
        found = mixing(network, time_unit=0.001, convention="matrix", rounding="nearest").value
        assert found == pytest.approx(values[1], abs=1e-9)


@pytest.mark.parametrize(
    ("convention", "best", "value", "worst", "worst_value", "periodic"),
    [
        ("equation", "12 14 23 24 34 45", 0.993061, None, 1.0, 7),
        ("matrix", "12 23 24 34 35 45", 0.992725, "13 14 23 24 35 45", 0.999828, 0),
    ],
)
def test_reference_values(convention, best, value, worst, worst_value, periodic):
    results = mixings(convention)
    values = np.array([result.value for result in results])
    assert GRAPHS[int(np.argmin(values))] == pairs(best)
    assert values.min() == pytest.approx(value, abs=1e-6)
    assert values.max() == pytest.approx(worst_value, abs=1e-6)
    assert sum(result.cycle_period > 1 for result in results) == periodic
    assert ((values == 1.0) == [result.cycle_period > 1 for result in results]).all()
    if worst:
        assert GRAPHS[int(np.argmax(values))] == pairs(worst)


@pytest.mark.parametrize("rounding", ["nearest", "up"])
@pytest.mark.parametrize(("convention", "periodic"), [("equation", 11), ("matrix", 17)])
def test_periodic_graphs_on_the_coarse_grid(convention, periodic, rounding):
    results = mixings(convention, 0.05, rounding)
    assert sum(result.cycle_period > 1 for result in results) == periodic


def test_a_finer_grid_makes_every_graph_periodic():
    """All delays of the paper are whole hundredths: at a millisecond, the equation's cycles share the factor 10."""
    network = five_users().with_links(pairs("12 14 23 24 34 45"))
    assert mixing(network, time_unit=0.001).cycle_period == 10
    result = mixing(network, time_unit=0.001, convention="matrix")
    assert result.cycle_period == 1
    assert 0.999 < result.value < 1


@pytest.mark.parametrize(
    ("links", "options", "words"),
    [
        ("12 34", {"time_unit": 0.01}, ["3 separate groups", "link them"]),
        ("12 14 23 24 34 45", {"time_unit": 0.05}, ["0.04 s", "0.8 time units"]),
        ("12 14 23 24 34 45", {"time_unit": 0.0}, ["time_unit is 0 s", "above 0"]),
        ("12 14 23 24 34 45", {"time_unit": math.nan}, ["time_unit is nan"]),
        ("12 14 23 24 34 45", {"time_unit": 0.2, "rounding": "nearest"}, ["0 time units", "at least 1"]),
        ("12 14 23 24 34 45", {"time_unit": 0.01, "convention": "other"}, ['"other"', '"equation"']),
        ("12 14 23 24 34 45", {"time_unit": 0.01, "rounding": "down"}, ['"down"', '"nearest"']),
    ],
)
def test_refuses(links, options, words):
    with pytest.raises(NetworkError) as caught:
        mixing(five_users().with_links(pairs(links)), **options)
    for word in words:
        assert word in str(caught.value)


def test_one_user_does_not_mix():
    with pytest.raises(NetworkError, match="1 user"):
        mixing(uniform([], 1), time_unit=1.0)


def test_zero_delay_is_for_the_matrix_convention():
    network = uniform(complete(3), 3, delay=0.0)
    with pytest.raises(NetworkError, match="at least 1"):
        mixing(network, time_unit=1.0)
    assert mixing(network, time_unit=1.0, convention="matrix").value == pytest.approx(0.5, abs=1e-12)
