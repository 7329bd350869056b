"""`cotouch feel`, `cotouch sweep`, and what `cotouch simulate` says about a law."""

import json
from pathlib import Path

import pytest
import xarray as xr
from tests.cli.commands import here

from cotouch.laws import End, Law, register

SCENARIO = """
[network]
users = ["a", "b"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.1], [0.1, 0]]
[steps]
duration = 2.0
[synchronisation]
LAW
[[hands]]
user = 1
path = 0.05
stiffness = 300.0
[[hands]]
user = 2
path = -0.05
stiffness = 300.0
"""


@pytest.fixture
def scenario(tmp_path: Path) -> Path:
    path = tmp_path / "two.toml"
    path.write_text(SCENARIO.replace("LAW", 'law = "wave"'), encoding="utf-8")
    return path


def test_simulate_says_what_the_law_made(scenario: Path) -> None:
    shown = here("simulate", scenario)
    assert shown.returncode == 0
    assert "wave: created 0 J, at most 0 J" in " ".join(shown.stdout.split())
    judged = json.loads(here("simulate", scenario, "--json").stdout)["judge"]
    assert judged["law"] == "wave"
    assert judged["kept"]
    assert judged["promised"]


def test_simulate_takes_the_default_law_and_another_by_name(scenario: Path) -> None:
    scenario.write_text(SCENARIO.replace("LAW", ""), encoding="utf-8")
    for options, law in (([], "paid"), (["--law", "spring"], "spring")):
        judged = json.loads(here("simulate", scenario, *options, "--json").stdout)["judge"]
        assert (judged["law"], judged["kept"]) == (law, True)


def test_simulate_says_that_springs_without_damping_promise_nothing(scenario: Path) -> None:
    scenario.write_text(SCENARIO.replace("LAW", 'law = "spring"\ndamping = 0.0'), encoding="utf-8")
    shown = " ".join(here("simulate", scenario).stdout.split())
    assert "J, guarantees nothing; its initial energy is 0 J" in shown
    assert "spring: made 0 J" not in shown


def test_feel_predicts_and_draws(scenario: Path, tmp_path: Path) -> None:
    done = here("feel", scenario, "--no-measure", "--law", "spring", "--figures", tmp_path / "figures", "--json")
    found = json.loads(done.stdout)
    assert found["predicted_drag"] == pytest.approx(4 * 50 * 0.1, rel=0.1)
    assert (tmp_path / "figures" / "impedance.png").read_bytes().startswith(b"\x89PNG")
    assert "what user 1 feels, others free" in here("feel", scenario, "--no-measure").stdout


def test_sweep_lists_every_run(scenario: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    done = here("sweep", scenario, "--vary", "link.delay=0.01,0.1", "--vary", "synchronisation.law=spring,wave",
                "--out", out, "--json")  # fmt: skip
    runs = json.loads(done.stdout)["runs"]
    assert len(runs) == 4
    assert all(run["made"] <= run["law_initial_energy"] + 1e-12 for run in runs)
    cells = {file.name: file.stat().st_mtime_ns for file in (out / "cells").iterdir()}
    assert len(cells) == 4
    again = here("sweep", scenario, "--vary", "link.delay=0.01,0.1", "--vary", "synchronisation.law=spring,wave",
                 "--out", out, "--jobs", "1", "--json")  # fmt: skip
    assert json.loads(again.stdout)["runs"] == runs
    assert {file.name: file.stat().st_mtime_ns for file in (out / "cells").iterdir()} == cells
    with xr.open_dataset(out / "results.nc", engine="h5netcdf") as found:
        assert found.sizes == {"link.delay": 2, "synchronisation.law": 2}
    assert "link.delay" in here("sweep", scenario, "--vary", "link.delay=0.01,0.1").stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["feel", "SCENARIO", "--others", "gone"], '--others is "gone"; it must be "free" or "holding"'),
        (["feel", "SCENARIO", "--user", "3"], "user is 3; the network has users 1 to 2"),
        (["feel", "SCENARIO", "--law", "x"], 'law is "x"; it must be one of'),
        (["sweep", "SCENARIO", "--vary", "link.delay"], '--vary is "link.delay"; it must be OPTION=VALUES'),
        (["sweep", "SCENARIO", "--vary", "link.delay=1:2"], '"1:2" is not a range'),
        (["sweep", "SCENARIO", "--vary", "a=1", "--vary", "a=2"], "--vary names a twice"),
        (["sweep", "SCENARIO", "--vary", "body.colour=1"], "colour"),
    ],
)
def test_wrong_questions_are_one_sentence(scenario: Path, arguments: list[str], message: str) -> None:
    done = here(*[str(scenario) if argument == "SCENARIO" else argument for argument in arguments])
    assert done.returncode == 2
    assert message in done.stderr
    assert done.stderr.count("\n") == 1


STUDY = """
title = "Two laws"
laws = ["spring", "wave"]
draws = 2
duration = 4.0
tasks = ["carry"]
networks = [{name = "[/near] $_{$", delay = 0.02}]
tuning = {search = 0, local = 0}
map = {delay = [0.01], stiffness = [300.0]}
"""


def test_compare_writes_results_and_report_and_resumes(tmp_path: Path) -> None:
    study, out = tmp_path / "study.toml", tmp_path / "out"
    study.write_text(STUDY, encoding="utf-8")
    shown = here("compare", study, "--out", out)
    assert shown.returncode == 0, shown.stderr
    assert "cost with 2 users" in shown.stdout
    assert "wave" in shown.stdout
    assert "[/near] $_{$" in shown.stdout  # neither markup nor a formula
    report = (out / "report.html").read_text(encoding="utf-8")
    assert "<title>Two laws</title>" in report
    cells = {file.name: file.stat().st_mtime_ns for file in (out / "cells").iterdir()}
    assert len(cells) == 4
    told = json.loads(here("compare", study, "--out", out, "--json").stdout)
    assert {file.name: file.stat().st_mtime_ns for file in (out / "cells").iterdir()} == cells
    with xr.open_dataset(out / "results.nc", engine="h5netcdf") as found:
        cost = found["cost"].sel(law="wave").isel(hand=0).mean().item()
    assert [row["cost"] for row in told["costs"] if row["law"] == "wave"] == pytest.approx([cost])


def _kick(end: End) -> None:
    end.push[0] = 10.0 if end.step < 20 else 0.0


def _nothing(end: End) -> None:
    pass


def test_compare_names_a_law_that_makes_energy_although_it_promises_not_to(tmp_path: Path) -> None:
    register(Law(name="kick", before=_kick, after=_nothing))
    study, out = tmp_path / "study.toml", tmp_path / "out"
    study.write_text(STUDY.replace('"wave"', '"kick"').replace("map =", "felt = false\nmap ="), encoding="utf-8")
    shown = here("compare", study, "--out", out)
    assert "– kick promises to be passive, but made" in shown.stdout
    assert "laws that promise passivity and made energy: kick" in (out / "report.html").read_text(encoding="utf-8")
    told = json.loads(here("compare", study, "--out", out, "--json").stdout)["broken_promises_j"]
    assert list(told) == ["kick"]
    assert told["kick"] > 0.0


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (STUDY.replace('"wave"', '"wvae"'), 'law is "wvae"'),
        (STUDY + "[", "is not TOML"),
        ("", "laws is missing"),
    ],
)
def test_a_wrong_study_is_one_sentence_and_leaves_nothing(tmp_path: Path, text: str, message: str) -> None:
    (tmp_path / "study.toml").write_text(text, encoding="utf-8")
    shown = here("compare", tmp_path / "study.toml", "--out", tmp_path / "out")
    assert shown.returncode == 2
    assert message in " ".join(shown.stderr.split())
    assert not (tmp_path / "out").exists()


def test_compare_says_why_a_cell_is_empty(tmp_path: Path) -> None:
    """Of three users where a table has two."""
    study, out = tmp_path / "study.toml", tmp_path / "out"
    (tmp_path / "trips.csv").write_text(",a,b\na,0,40\nb,40,0\n", encoding="utf-8")
    text = STUDY.replace("delay = 0.02}", 'delays = "trips.csv"}').replace(
        "map =", "users = [2, 3]\nfelt = false\nmap ="
    )
    study.write_text(text, encoding="utf-8")
    shown = here("compare", study, "--out", out)
    assert shown.returncode == 0, shown.stderr
    said = 'wave, [/near] $_{$: network "[/near] $_{$" has 2 users; 3 are required'
    assert said in shown.stdout
    assert said in json.loads(here("compare", study, "--out", out, "--json").stdout)["problems"]
