"""Points, units and lines as figures show them."""

import json

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from cotouch.drawing import DASHES, USERS, decimate, escaped, peak, prefix, user_line


@given(st.integers(0, 400), st.integers(4, 60), st.integers(0, 1000))
def test_decimation_keeps_ends_and_peaks(size: int, most: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    series = rng.normal(size=size)
    series[rng.random(size) < 0.1] = np.nan
    series[rng.random(size) < 0.1] = np.inf
    time, kept = decimate(np.arange(size, dtype=np.float64), series, most)
    known = series[np.isfinite(series)]
    assert kept.size <= most + 2 or kept.size == known.size
    assert (np.diff(time) > 0.0).all()
    if known.size:
        assert (kept.min(), kept.max()) == (known.min(), known.max())
        assert (kept[0], kept[-1]) == (known[0], known[-1])
    np.testing.assert_array_equal(kept, series[time.astype(int)])


def test_units_with_prefixes() -> None:
    assert prefix(0.02, "m") == (1e-3, "mm")
    assert prefix(1.0, "m") == (1.0, "m")
    assert prefix(4e6, "m") == (1.0, "m")
    assert prefix(3e-5, "J") == (1e-6, "µJ")
    assert prefix(0.0, "N") == (1.0, "N")
    assert prefix(float("nan"), "N") == (1.0, "N")


def test_peak_skips_what_is_not_finite() -> None:
    assert peak([1.0, -3.0, np.nan], np.array([np.inf, 2.0])) == 3.0
    assert peak([]) == 0.0


def test_users_have_lines_of_their_own() -> None:
    lines = [json.dumps(user_line(i)) for i in range(len(USERS) * len(DASHES))]
    assert len(set(lines)) == len(lines)


def test_a_name_begins_no_formula() -> None:
    assert escaped("Ann $5$") == r"Ann \$5\$"
