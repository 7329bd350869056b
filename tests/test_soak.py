"""The verdict of the soak: what grows is found, what only jumps about is not taken for it."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from benchmarks._trend import Trend, trend
from benchmarks.soak import verdict

TIMES = np.arange(0.0, 900.0, 40.0)


def walk(rng: np.random.Generator, drift: float) -> np.ndarray:
    """Memory as processes have it: jumps of up to 100 kB, one in 20 s, which stay; and what comes and goes [B]."""
    jumps = np.where(rng.random(900) < 0.05, rng.uniform(-1e5, 1e5, 900), 0.0)
    return 2.5e8 + np.cumsum(jumps)[TIMES.astype(int)] + rng.uniform(0.0, 2e4, TIMES.size) + drift * TIMES


def test_the_interval_holds_the_true_slope_as_often_as_it_says():
    rng = np.random.default_rng(0)
    for drift in (0.0, 3e3):
        found = [trend(TIMES, walk(rng, drift)) for _ in range(400)]
        inside = np.mean([abs(one.slope - drift) <= one.error for one in found])
        assert 0.92 <= inside <= 0.98
    # A line through the same values would say that half of what only wanders grows or shrinks.
    line = [np.polyfit(TIMES, walk(rng, 0.0), 1, cov=True) for _ in range(100)]
    assert np.mean([abs(fit[0]) <= 2.0 * np.sqrt(cov[0, 0]) for fit, cov in line]) < 0.5


def hanging(rng: np.random.Generator, fraction: float, count: int = TIMES.size) -> np.ndarray:
    """Values about nothing, of which a share carries on to the next."""
    out = [rng.standard_normal() / np.sqrt(1.0 - fraction**2)]
    for _ in range(count - 1):
        out.append(fraction * out[-1] + rng.standard_normal())
    return np.array(out)


@pytest.mark.parametrize("fraction", [0.0, 0.3, 0.6, 0.9])
def test_so_it_does_where_values_come_back_to_a_line(fraction: float):
    rng = np.random.default_rng(3)
    found = [trend(TIMES, hanging(rng, fraction) + 0.01 * TIMES) for _ in range(500)]
    assert np.mean([abs(one.slope - 0.01) <= one.error for one in found]) >= 0.95
    if not fraction:  # and there it is sure sooner: nothing of a walk has so narrow an interval
        rises = np.array([np.std(np.diff(hanging(rng, 0.0))) for _ in range(100)])
        as_walk = 2.0 * np.median(rises) * np.sqrt(TIMES.size - 1) / (TIMES[-1] - TIMES[0])
        assert np.median([one.error for one in found]) < 0.3 * as_walk


def test_what_carries_on_from_look_to_look_widens_the_interval_of_a_line():
    rng, times = np.random.default_rng(4), np.arange(80.0)
    found = [trend(times, hanging(rng, 0.6, times.size)) for _ in range(500)]
    assert np.mean([abs(one.slope) <= one.error for one in found]) >= 0.96


def test_what_grows_is_called_so():
    rng = np.random.default_rng(1)
    assert verdict(trend(TIMES, 2.5e8 + rng.uniform(0.0, 4e4, TIMES.size))) == "flat"
    assert verdict(trend(TIMES, 2.5e8 + rng.uniform(0.0, 4e4, TIMES.size) + 2e3 * TIMES)) == "grows"
    assert verdict(trend(TIMES, 20.0 * walk(rng, 0.0))) == "not known"
    assert verdict(Trend(float("nan"), float("nan"))) == "not known"


def test_twenty_kilobytes_for_every_member_killed_are_found():
    """Over ten minutes of faults, as they come, with memory that stands still but for 20 kB either way."""
    rng = np.random.default_rng(2)
    times = np.arange(200.0, 601.0, 44.0)
    found = {0.0: list[str](), 2e4: list[str]()}
    for _ in range(200):
        killed = np.cumsum(rng.poisson(2.5 / 60.0 * 44.0, times.size))
        for leak, verdicts in found.items():
            verdicts.append(verdict(trend(times, 1e8 + leak * killed + rng.uniform(-2e4, 2e4, times.size))))
    assert found[0.0].count("flat") > 190
    assert found[2e4].count("grows") > 170  # in the others too few were killed


TAKEN = """
import json, mmap, os, sys
from benchmarks.soak import taken
before = taken(os.getpid())
held = b"x" * (16 << 20)
anonymous = taken(os.getpid())
with open(sys.argv[1], "rb") as file:
    pages = mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ)
    sum(pages[::4096])
print(json.dumps([before, anonymous, taken(os.getpid())]))
"""


@pytest.mark.skipif(not Path("/proc/self/smaps_rollup").exists(), reason="this system does not say what is anonymous")
def test_pages_of_files_are_told_from_memory(tmp_path: Path):
    path = tmp_path / "file"
    path.write_bytes(bytes(16 << 20))
    done = subprocess.run([sys.executable, "-c", TAKEN, path], capture_output=True, check=True, timeout=60, text=True)
    before, anonymous, files = np.array(json.loads(done.stdout))
    assert anonymous - before == pytest.approx([16e6, 16e6], abs=2e6)
    assert files - anonymous == pytest.approx([0.0, 16e6], abs=2e6)


def test_too_few_values_are_refused():
    with pytest.raises(ValueError, match="3 looks show no slope"):
        trend(TIMES[:3], TIMES[:3])
