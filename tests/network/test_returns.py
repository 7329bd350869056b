"""The consensus as returns to one user: against the whole determinant, and its bounds against brute force."""

import numpy as np
import pytest
from tests.network.inside import bend_of, consensus_loop, cycle_period, excluded, swift, thorough, turn_of
from tests.network.support import five_users, pairs, random_network

from cotouch.network import chain_of, characteristic, closed_loop, consensus_lags, none_beyond, on_line, value

NOWHERE = np.zeros(0, dtype=np.complex128)


def random_loop(rng, unit=0.01, delays=(0.01, 0.6)):
    """An aperiodic consensus loop of 3 to 6 users."""
    while True:
        network = random_network(rng, size=int(rng.integers(3, 7)), delays=delays)
        lags = consensus_lags(network, time_unit=unit, convention="equation", rounding="up")
        if cycle_period(lags) == 1:
            return consensus_loop(network, lags, unit)


def without_anchor(loop, s):
    """det G over the determinant without the user of the stiffest springs."""
    matrix, anchor = characteristic(loop, s), int(np.argmax(loop.rigid))
    rest = np.delete(np.delete(matrix, anchor, 0), anchor, 1)
    return np.linalg.det(matrix) / np.linalg.det(rest)


@pytest.mark.parametrize("seed", range(6))
def test_value_and_slope_are_those_of_the_determinant(seed):
    rng = np.random.default_rng(seed)
    heavy, _ = closed_loop(random_network(rng, size=5), 0.7, 0.2, 3.0)
    for loop in (random_loop(rng), heavy):
        chain = chain_of(loop)
        for _ in range(5):
            s = complex(rng.uniform(-0.5, 0.2), rng.uniform(0, 300))
            on_line(chain, s.real)
            f, slope = value(chain, s.imag)
            assert f == pytest.approx(without_anchor(loop, s), rel=1e-9)
            h = 1e-5
            expected = (without_anchor(loop, s + h) - without_anchor(loop, s - h)) / (2 * h)
            assert slope == pytest.approx(expected, rel=1e-5)
            # The null vectors: G x and zᵀ G vanish but at the anchor, in the chain's order.
            G = np.zeros((len(chain.place),) * 2, dtype=complex)
            G[np.ix_(chain.place, chain.place)] = characteristic(loop, s)
            assert np.abs((G @ chain.right)[:-1]).max() < 1e-9 * np.abs(G).max() * np.abs(chain.right).max()
            assert np.abs((chain.left @ G)[:-1]).max() < 1e-9 * np.abs(G).max() * np.abs(chain.left).max()


@pytest.mark.parametrize("seed", range(10))
def test_no_second_derivative_on_the_line_is_above_its_bound(seed):
    rng = np.random.default_rng(seed)
    loop = random_loop(rng)
    chain = chain_of(loop)
    line = -float(rng.choice([0.02, 0.1, 0.3]))
    bend = bend_of(chain, line)
    if np.isnan(bend):
        assert line < -0.05, "near the axis the returns always converge"
        return
    slopes = lambda where: np.array([value(chain, w)[1] for w in where])  # noqa: E731
    where, h = np.linspace(0.0, 314.0, 3000), 1e-4
    second = np.abs(slopes(where + h) - slopes(where - h)) / (2 * h)
    assert second.max() <= bend * (1 + 1e-6)
    assert second[0] == pytest.approx(bend, rel=1e-4), "on the real axis the bound is met"


@pytest.mark.parametrize("seed", range(10))
def test_what_is_excluded_is_empty_and_no_turn_is_lost(seed):
    rng = np.random.default_rng(seed)
    loop = random_loop(rng)
    chain = chain_of(loop)
    line = -0.05
    bend = bend_of(chain, line)
    low = float(rng.uniform(0, 250))
    high = low + float(rng.uniform(1, 40))
    turn, _, _ = turn_of(chain, bend, low, high, 20_000)
    values = np.array([value(chain, w)[0] for w in np.linspace(low, high, 40_001)])
    assert turn == pytest.approx(np.unwrap(np.angle(values))[-1] - np.angle(values[0]), abs=1e-6)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    for fraction in (0.001, 0.01, 0.1):
        if excluded(*value(chain, middle), bend, fraction * half):
            near = [value(chain, w)[0] for w in np.linspace(middle - fraction * half, middle + fraction * half, 400)]
            assert min(map(abs, near)) > 0


@pytest.mark.parametrize("unit", [0.05, 0.01, 0.001])
def test_both_ways_find_the_same_root(unit):
    rng = np.random.default_rng(7)
    settled = 0
    for _ in range(12):
        loop = random_loop(rng, unit)
        slow, sure, _ = thorough(loop, np.pi / unit, NOWHERE, np.inf)
        quick, certain, _ = swift(loop, np.pi / unit, NOWHERE, np.inf)
        assert sure
        if certain:
            settled += 1
            assert quick.real == pytest.approx(slow.real, rel=1e-9)
    assert settled > 4


def test_enough_is_enough_and_nothing_beyond_is_never_claimed_wrongly():
    network, unit = five_users().with_links(pairs("12 14 23 24 34 45")), 0.01
    lags = consensus_lags(network, time_unit=unit, convention="equation", rounding="exact")
    loop, top = consensus_loop(network, lags, unit), np.pi / unit
    root, certain, _ = swift(loop, top, NOWHERE, np.inf)
    assert certain
    some, certain, _ = swift(loop, top, NOWHERE, 2.0 * root.real)
    assert certain
    assert 2.0 * root.real <= some.real <= root.real + 1e-12
    assert none_beyond(loop, top, 0.98 * root.real)
    assert not none_beyond(loop, top, 1.02 * root.real)
    assert not none_beyond(loop, top, 0.0)
