"""The windows of frequency in which the consensus may be slow: nothing outside of them, by brute force."""

import numpy as np
import pytest
from tests.network.inside import consensus_loop, windows
from tests.network.support import random_network

from cotouch.network import consensus_lags


@pytest.mark.parametrize("seed", range(12))
def test_windows_hold_every_frequency_that_may_resonate(seed):
    rng = np.random.default_rng(seed)
    network = random_network(rng, size=int(rng.integers(2, 7)), delays=(0.01, 0.6))
    unit = 0.01
    lags = consensus_lags(network, time_unit=unit, convention="equation", rounding="up")
    loop = consensus_loop(network, lags, unit)
    top, line = np.pi / unit, -float(rng.choice([0.02, 0.2, 1.0]))
    lows, highs, scratch = np.empty(4096), np.empty(4096), np.empty((2, 4096))
    count, _ = windows(loop, line, top, lows, highs, scratch)
    lows, highs = lows[:count], highs[:count]
    assert (highs[:-1] <= lows[1:]).all()
    frequencies = np.linspace(0.0, top, 4001)
    inside = ((lows[None] - 1e-9 <= frequencies[:, None]) & (frequencies[:, None] <= highs[None] + 1e-9)).any(axis=1)
    i, j = loop.first, loop.second
    a, b = loop.spring * np.exp(-line * loop.to_first), loop.spring * np.exp(-line * loop.to_second)
    around = loop.to_first + loop.to_second
    matrices = np.tile(np.diag(loop.rigid), (len(frequencies), 1, 1))
    sizes = np.sqrt(a**2 + b**2 + 2 * a * b * np.cos(frequencies[:, None] * around))
    matrices[:, i, j] = matrices[:, j, i] = -sizes / 2
    may = np.linalg.eigvalsh(matrices)[:, 0] < 0
    assert may.any()
    assert inside[may].all()
