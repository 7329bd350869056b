"""Settings for every test: the same examples on every run, and helpers importable as `tests....`."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

# Before numpy is loaded: the workers of one run must not fight for cores, and sums then have one order everywhere.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

ROOT = str(Path(__file__).parent.parent)
if ROOT not in sys.path:
    sys.path.insert(0, ROOT)

settings.register_profile(
    "cotouch",
    derandomize=True,
    deadline=None,  # the first example of a kernel includes its compilation
    max_examples=30,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("cotouch")


def pytest_configure(config: pytest.Config) -> None:
    """Compiles the kernels once, one process for each width, before several workers compile the same."""
    if getattr(config.option, "numprocesses", None) and not hasattr(config, "workerinput"):
        script = Path(__file__).parent / "warm_up.py"
        running = [subprocess.Popen([sys.executable, str(script), axes]) for axes in ("1", "3")]
        for process in running:
            process.wait()
