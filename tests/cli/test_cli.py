"""The command as a user runs it: a process of its own."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

FIVE_USERS = Path(__file__).parents[2] / "examples" / "five-users.toml"
SMALL = """
[network]
users = ["Ann", "Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.05], [0.02, 0]]
[steps]
duration = 0.5
[[hands]]
user = 1
path = 0.1
"""


def cotouch(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", "from cotouch.cli import main; main()", *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


@pytest.fixture
def small(tmp_path: Path) -> Path:
    path = tmp_path / "small.toml"
    path.write_text(SMALL)
    return path


def test_help_names_every_command_and_loads_nothing_heavy() -> None:
    done = cotouch("--help")
    assert done.returncode == 0
    for command in ("simulate", "certify", "plan", "reproduce"):
        assert command in done.stdout
    heavy = "('numba', 'numpy', 'xarray', 'pydantic', 'rich')"
    code = f"import sys, cotouch.cli; print([name for name in {heavy} if name in sys.modules])"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert loaded.stdout.strip() == "[]"


def test_simulate_prints_one_json_object_and_nothing_else() -> None:
    done = cotouch("simulate", FIVE_USERS, "--json")
    assert done.returncode == 0, done.stderr
    figures = json.loads(done.stdout)
    assert figures["steps"] == 24_000
    assert figures["duration_s"] == 24.0
    assert figures["energy_residual"] < 1e-10
    assert figures["passivity_margin_j"] >= -1e-12
    assert set(figures["settling_time_s"]) == {"position", "force"}
    assert 1.0 < figures["settling_time_s"]["position"] < 6.0
    assert len(figures["final"]["position"]) == 5
    assert len(figures["final"]["force"]) == 5
    assert figures["final"]["force_sum"] == 0.0
    assert abs(figures["hold"]["force_sum"]) < 1e-4


def test_simulate_writes_result_and_figures(small: Path, tmp_path: Path) -> None:
    done = cotouch("simulate", small, "--out", tmp_path / "run.nc", "--figures", tmp_path / "figures")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "run.nc").read_bytes()[1:4] == b"HDF"
    names = {path.stem for path in (tmp_path / "figures").iterdir()}
    assert {"positions", "forces", "energies", "ages"} <= names
    for word in ("Ann", "Ben", "residual", "passive", "run.nc"):
        assert word in done.stdout


def test_certify_designs_and_checks() -> None:
    done = cotouch("certify", FIVE_USERS, "--json")
    assert done.returncode == 0, done.stderr
    found = {(entry["basis"], entry["method"]): entry for entry in json.loads(done.stdout)["certificates"]}
    rule = found["index", "rule"]
    assert rule["damping"] == pytest.approx([36.5, 9.0, 3.625, 41.25, 3.375])
    assert found["index", "minimax"]["largest"] < rule["largest"]
    assert found["index", "exact"]["sum"] < rule["sum"]
    assert found["index", "exact"]["modes"] == ["constant"]
    assert "freshest" in found["age", "rule"]["modes"]
    assert all(entry["holds"] for entry in found.values())
    checked = cotouch("certify", FIVE_USERS, "--json", "--damping", "20")
    assert not any(entry["holds"] for entry in json.loads(checked.stdout)["certificates"])
    table = cotouch("certify", FIVE_USERS)
    assert "minimax" in table.stdout
    assert "36.5" in table.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("simulate", "nowhere.toml"), "nowhere.toml"),
        (("certify", "nowhere.toml"), "nowhere.toml"),
        (("certify", FIVE_USERS, "--damping", "1,2"), "one for each of the 5 users"),
        (("certify", FIVE_USERS, "--period", "-1"), "period"),
        (("simulate", FIVE_USERS, "--out", "/nowhere/run.nc"), "does not exist"),
        (("simulate",), "Missing argument"),
        (("fly",), "fly"),
    ],
)
def test_what_the_user_got_wrong_is_said_with_exit_code_2(arguments: tuple[str | Path, ...], words: str) -> None:
    done = cotouch(*arguments)
    assert done.returncode == 2
    assert words in done.stderr
    assert "Traceback" not in done.stderr
    assert not done.stdout


def test_a_bad_scenario_is_one_sentence(small: Path) -> None:
    small.write_text(SMALL + "\n[steps2]\n")
    done = cotouch("simulate", small)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "steps2" in done.stderr
