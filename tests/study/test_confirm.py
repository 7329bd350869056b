"""What the simulator shows of the slowest mode, against the rightmost root."""

import numpy as np
import pytest
from tests.network.support import five_users, pairs, random_network, uniform
from tests.study.inside import slowest

from cotouch.errors import NetworkError, UnsupportedError
from cotouch.network import path, rightmost_root
from cotouch.planning import tune_springs
from cotouch.study import confirmed

BEST = "12 14 23 24 34 45"


@pytest.mark.parametrize("off", [1.0, 1.15, 0.85])
def test_the_papers_network(off):
    """Also where the expected rate is wrong: it must not draw the result to itself."""
    network = five_users().with_links(pairs(BEST))
    rate = rightmost_root(network).rate
    assert confirmed(network, rate * off) == pytest.approx(rate, rel=1e-4)


def test_tuned_springs_of_the_papers_network():
    network = five_users().with_links(pairs(BEST))
    limit = rightmost_root(network).sync_damping.max()
    tuned = tune_springs(network, damping_limit=limit, rounds=40)
    assert confirmed(tuned.network, tuned.after) == pytest.approx(tuned.after, rel=0.01)


def test_an_object_with_ground_and_damping():
    thing = {"mass": 2.0, "damping": 0.3, "stiffness": 4.0}
    network = random_network(np.random.default_rng(3), size=3, delays=(0.1, 0.9))
    rate = rightmost_root(network, **thing).rate
    assert confirmed(network, rate, **thing) == pytest.approx(rate, rel=0.01)


def test_the_slowest_of_several_exponentials():
    """Known rates, one of them a double one, none of them the expected one."""
    time = 0.05 * np.arange(300)
    signals = np.array(
        [
            np.exp(-0.2 * time) * np.cos(3 * time) + 2 * np.exp(-0.5 * time),
            np.exp(-0.4 * time) * (1 + time) - np.exp(-0.2 * time) * np.sin(3 * time),
        ]
    )
    assert slowest(signals, 0.05) == pytest.approx(-0.2, abs=1e-6)


@pytest.mark.parametrize("other", [0.02, 2e-3, -0.02, 40.0])
def test_powers_that_leave_the_range_of_floating_point(other):
    """One that is gone after a few samples, one that comes out of round-off in the last ones."""
    samples = np.arange(300)
    extra = other ** (samples if abs(other) < 1 else samples - 299.0)
    signals = np.array([np.exp(-0.01 * samples) + extra, np.exp(-0.01 * samples) - 2 * extra])
    assert slowest(signals, 0.05) == pytest.approx(-0.2, abs=1e-9)


def test_refusals():
    network = uniform(path(2), 2, delay=1.0)
    for rate in (0.0, 1.0, float("nan")):
        with pytest.raises(NetworkError, match="it must be finite and below 0"):
            confirmed(network, rate)
    with pytest.raises(NetworkError, match="separate groups"):
        confirmed(uniform([(0, 1), (2, 3)], 4), -1.0)
    with pytest.raises(UnsupportedError, match="at most 2000000 are simulated"):
        confirmed(uniform(path(2), 2, delay=1e-6), -1.0)
    with pytest.raises(UnsupportedError, match="no decay"):
        slowest(np.zeros((2, 300)), 0.1)
