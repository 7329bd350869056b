"""The verdict of the soak: what grows is found, what only jumps about is not taken for it."""

import numpy as np
import pytest
from benchmarks._trend import Trend, trend
from benchmarks.soak import verdict

TIMES = np.arange(0.0, 900.0, 1.0)


def walk(rng: np.random.Generator, drift: float) -> np.ndarray:
    """Memory as processes have it: jumps of up to 100 kB, one in 20 s, which stay; and what comes and goes [B]."""
    jumps = np.where(rng.random(TIMES.size) < 0.05, rng.uniform(-1e5, 1e5, TIMES.size), 0.0)
    return 2.5e8 + np.cumsum(jumps) + rng.uniform(0.0, 2e4, TIMES.size) + drift * TIMES


def test_the_interval_holds_the_true_slope_as_often_as_it_says():
    rng = np.random.default_rng(0)
    for drift in (0.0, 3e3):
        found = [trend(TIMES, walk(rng, drift)) for _ in range(400)]
        inside = np.mean([abs(one.slope - drift) <= one.error for one in found])
        assert 0.92 <= inside <= 0.98
    # A line through the same values would say that half of what only wanders grows or shrinks.
    line = [np.polyfit(TIMES, walk(rng, 0.0), 1, cov=True) for _ in range(100)]
    assert np.mean([abs(fit[0]) <= 2.0 * np.sqrt(cov[0, 0]) for fit, cov in line]) < 0.5


def test_what_grows_is_called_so():
    rng = np.random.default_rng(1)
    assert verdict(trend(TIMES, 2.5e8 + rng.uniform(0.0, 4e4, TIMES.size))) == "flat"
    assert verdict(trend(TIMES, 2.5e8 + rng.uniform(0.0, 4e4, TIMES.size) + 2e3 * TIMES)) == "grows"
    assert verdict(trend(TIMES, 20.0 * walk(rng, 0.0))) == "not known"
    assert verdict(Trend(float("nan"), float("nan"))) == "not known"


def test_too_few_values_are_refused():
    with pytest.raises(ValueError, match="3 looks show no slope"):
        trend(TIMES[:3], TIMES[:3])
