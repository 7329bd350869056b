"""The numerical core under other interpreters: the same numbers as under this one, where they are here to ask."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.conftest import IMPORTS, ROOT

OWN = f"{sys.version_info.major}.{sys.version_info.minor}"
VERSIONS = ("3.11", "3.12", "3.13")
# What the core imports; an interpreter without one of them cannot run it.
NEEDED = ("h5netcdf", "numba", "numpy", "pydantic", "scipy", "xarray")
ASKED = f"""
import importlib, json
found = {{name: importlib.import_module(name).__version__ for name in {NEEDED}}}
print(json.dumps(found))
"""
# A chain between two users on a bad channel; damping by the exact test; the rightmost root. Numbers in hex, whole.
CORE = """
import json, sys
import numpy as np
from cotouch.network import Network, exact_scaling, rightmost_root, rule_damping
from cotouch.simulation import simulate
pair = {"users": ["Ann", "Ben"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.03], [0.05, 0]]}
run = simulate({
    "network": pair, "body": {"kind": "chain", "nodes": 3, "dimension": 2, "spacing": 0.5},
    "steps": {"duration": 0.5, "rate": [100, 250]}, "channel": {"jitter": {"scale": 0.02}, "loss": 0.1},
    "hands": [{"user": 1, "node": 3, "path": [0.1, -0.1]}],
})
network = Network(**pair)
delays = network.index_delays(0.01)
damping = rule_damping(network, index_delay=delays, periods=0.01)
numbers = [
    *run["position"].values.ravel(), *run["age"].values.ravel(), *run["residual"].values, rightmost_root(network).rate,
    exact_scaling(network, index_delay=delays, period=0.01, damping=damping),
]
print(json.dumps({"python": sys.version_info[:2], "numbers": [float(x).hex() for x in numbers]}))
"""


def interpreter(version: str) -> tuple[str, dict[str, str]]:
    """The program of a version and the libraries that it has; skips with the reason where there is none."""
    named = f"PYTHON{version.replace('.', '')}"
    program = sys.executable if version == OWN else os.environ.get(named) or shutil.which(f"python{version}")
    if program is None:
        pytest.skip(f"no python{version} is installed here; {named} may name one that has the libraries")
    done = subprocess.run([program, "-c", ASKED], capture_output=True, text=True, check=False, timeout=120)
    if done.returncode:
        said = done.stderr.strip().splitlines()
        reason = next((line for line in reversed(said) if "Error" in line), said[0] if said else "it says nothing")
        pytest.skip(f"{program} cannot run the core: {reason}; {named} may name one that has the libraries")
    return program, json.loads(done.stdout)


def computed(program: str, folder: Path) -> dict[str, Any]:
    """What an interpreter makes of the core; kernels of other versions are compiled into a folder of their own."""
    env = {**os.environ, "PYTHONPATH": IMPORTS}
    if program != sys.executable:
        env["NUMBA_CACHE_DIR"] = str(folder)
    done = subprocess.run(
        [program, "-c", CORE], cwd=ROOT, env=env, capture_output=True, text=True, check=False, timeout=900
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    return computed(sys.executable, tmp_path_factory.mktemp("own"))


@pytest.mark.parametrize("version", VERSIONS)
def test_the_core_gives_the_same_numbers(version: str, request: pytest.FixtureRequest, tmp_path: Path) -> None:
    program, libraries = interpreter(version)
    own = request.getfixturevalue("own")  # only where there is another
    found = computed(program, tmp_path)
    assert ".".join(map(str, found["python"])) == version
    _, here = interpreter(OWN)
    if libraries == here:  # the same libraries: to the last bit
        assert found["numbers"] == own["numbers"]
    values, wanted = (np.array([float.fromhex(x) for x in each["numbers"]]) for each in (found, own))
    assert np.count_nonzero(np.isfinite(values)) > 1000
    np.testing.assert_allclose(values, wanted, rtol=1e-9, atol=1e-12)


def test_classifiers_name_versions_that_are_asked_here() -> None:
    text = Path(ROOT, "pyproject.toml").read_text(encoding="utf-8")
    named = set(re.findall(r"Programming Language :: Python :: (3\.\d+)", text))
    assert OWN in named
    assert named <= set(VERSIONS)
