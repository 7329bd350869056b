"""What `cotouch simulate` says of steps that had to be closed, and of cuts."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from tests.cli.commands import here
from tests.cli.inside import tools_table
from tests.cli.test_cli import SMALL

from cotouch.scenario import Scenario
from cotouch.simulation import simulate


@pytest.fixture(scope="module")
def linear(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, xr.Dataset]:
    """A run without such steps."""
    path = tmp_path_factory.mktemp("linear") / "small.toml"
    path.write_text(SMALL)
    return path, simulate(Scenario.read(path))


def shown(path: Path) -> tuple[dict[str, Any], str]:
    return json.loads(here("simulate", path, "--json").stdout), here("simulate", path).stdout


@pytest.mark.parametrize(
    ("factor", "alarms", "said"),
    [
        (0.05, 7, "changed velocities by at most 5.0e-02; 7 steps by more than 1 %: use shorter steps"),
        (1e-5, 0, "changed velocities by at most 1.0e-05"),
    ],
)
def test_how_much_is_told_and_a_warning_where_it_is_large(
    linear: tuple[Path, xr.Dataset], factor: float, alarms: int, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, run = linear
    work = np.zeros((2, run.sizes["step"]))
    largest, counted = np.zeros_like(work), np.zeros_like(work)
    work[0, 1:], work[0, 2:], work[1, 2:] = 2e-3, 1e-3, -4e-3
    largest[0, 1:], counted[0, 1:] = factor, alarms
    closed = {"closure": work, "closure_factor": largest, "closure_alarms": counted}
    run = run.assign({name: (("user", "step"), values) for name, values in closed.items()})
    monkeypatch.setattr("cotouch.cli._simulate.simulate_scenario", lambda _: run)
    monkeypatch.setenv("COLUMNS", "200")
    figures, text = shown(path)
    assert figures["closure"] == {"work_j": [2e-3, 4e-3], "largest_factor": factor, "alarms": alarms}
    assert [line.split("closure")[1].strip() for line in text.splitlines() if "closure" in line] == [said]


def test_a_linear_body_has_none(linear: tuple[Path, xr.Dataset]) -> None:
    figures, text = shown(linear[0])
    assert "closure" not in figures
    assert "closure" not in text
    assert "cuts" not in figures
    assert " cut " not in text


def test_cuts_are_counted(linear: tuple[Path, xr.Dataset], monkeypatch: pytest.MonkeyPatch) -> None:
    path, run = linear
    count, held = np.zeros((2, run.sizes["step"])), np.zeros((2, run.sizes["step"]))
    count[0, 2:], count[1, 3:], held[0, 2:], held[1, 3:] = 7, 5, 2e-3, 3e-3
    series = {"cut_elements": count, "cut": held}
    run = run.assign({name: (("user", "step"), values) for name, values in series.items()})
    run["cut_by"] = (("user", "element"), np.zeros((2, 9), dtype=np.int64))
    monkeypatch.setattr("cotouch.cli._simulate.simulate_scenario", lambda _: run)
    monkeypatch.setenv("COLUMNS", "200")
    figures, text = shown(path)
    assert figures["cuts"] == {"elements": [7, 5], "of": 9, "energy_j": [2e-3, 3e-3]}
    assert [line.split("cut ")[1].strip() for line in text.splitlines() if " cut " in line] == [
        "7 of 9 elements, which held at most 0.003 J"
    ]


def test_a_blade_has_no_contacts() -> None:
    """It touches and holds nothing; what it cut stands below."""
    felt = {"user": 1, "device": None, "peak_force_n": 2.5, "mean_force_n": 0.0}
    tools = [
        {**felt, "kind": "blade", "most_contacts": 0, "contact_time_s": 0.0},
        {**felt, "kind": "grasp", "most_contacts": 1, "contact_time_s": 0.5},
        {**felt, "kind": "touch", "most_contacts": 3, "contact_time_s": 0.25},
    ]
    columns = tools_table(("Ann",), {"local_damping": [0.1], "tools": tools}).columns[2:]
    rows = [tuple(row) for row in zip(*(column.cells for column in columns), strict=True)]
    assert rows == [
        ("blade", "2.5", "–", "–", "–"),
        ("grasp", "2.5", "0", "1 node", "0.5"),
        ("touch", "2.5", "0", "3", "0.25"),
    ]
