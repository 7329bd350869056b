"""`cotouch plan` as a user runs it."""

import json
import re
from pathlib import Path

import pytest
from tests.cli.commands import FIVE_USERS, cotouch, here

from cotouch.cli._plan import run


def test_plan_prints_one_json_object() -> None:
    done = cotouch("plan", FIVE_USERS, "--links", "6", "--objective", "decay", "--top", "2", "--json")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert (found["objective"], found["status"], found["graphs"], found["choices"]) == ("decay", "proved", 205, 210)
    assert found["best"]["links"] == [[1, 2], [1, 4], [2, 3], [2, 4], [3, 4], [4, 5]]
    assert found["best"]["value"] == pytest.approx(-1.428553, abs=1e-6)
    assert found["best"]["time_constant_s"] == pytest.approx(1 / 1.428553, abs=1e-6)
    assert len(found["best"]["damping"]) == 5
    assert found["worst"]["value"] == pytest.approx(-0.289652, abs=1e-6)
    assert len(found["top"]) == 2
    assert found["top"][0] == found["best"]


def test_plan_prints_a_table_and_keeps_to_the_limits() -> None:
    done = here("plan", FIVE_USERS, "--links", "5", "--must", "1-3", "--never", "2-4,4-5", "--max-degree", "3")
    assert done.returncode == 0, done.stderr
    assert "Proved for 5 users" in done.stdout
    best = re.search(r"^  1 +((?:\d-\d ?)+)", done.stdout, re.MULTILINE)
    assert best is not None
    assert "1-3" in best[1]
    assert "2-4" not in best[1]


def test_a_graph_that_never_mixes_has_no_time_constant() -> None:
    done = here("plan", FIVE_USERS, "--links", "6", "--json")
    worst = json.loads(done.stdout)["worst"]
    assert worst["value"] == 1.0
    assert worst["time_constant_s"] is None
    assert worst["period"] > 1


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--links", "3"], "links is 3"),
        (["--links", "6", "--must", "1to2"], '--must is "1to2"'),
        (["--links", "6", "--must", "1-2", "--never", "2-1"], "1-2 is both in must and in never"),
        (["--links", "6", "--objective", "speed"], 'objective is "speed"'),
        (["--links", "6", "--time-unit", "0.03"], "choose a time unit that divides it"),
    ],
)
def test_what_cannot_be_is_one_sentence_and_exit_code_2(options: list[str], message: str) -> None:
    done = here("plan", FIVE_USERS, *options)
    assert done.returncode == 2
    assert message in done.stderr
    assert done.stderr.count("\n") == 1


def test_a_delay_that_is_no_number_is_named(tmp_path: Path) -> None:
    for entry in ("nan", "-0.1"):
        path = tmp_path / "network.toml"
        path.write_text(f"[network]\nusers = ['a', 'b']\nspring = [[0, 1], [1, 0]]\ndelay = [[0, {entry}], [0.1, 0]]\n")
        done = here("plan", path, "--links", "1")
        assert done.returncode == 2
        assert "must be finite and at least 0" in done.stderr


def test_plan_draws_and_tunes(tmp_path: Path) -> None:
    done = here(
        *("plan", FIVE_USERS, "--links", "6", "--objective", "decay", "--tune-springs", "42"),
        *("--figures", str(tmp_path / "drawn"), "--json"),
    )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert sorted(Path(name).name for name in found["files"]) == ["knee.png", "networks.png", "ranks.png"]
    assert all(Path(name).stat().st_size > 10_000 for name in found["files"])
    tuned = found["tuned"]
    assert tuned["before"] == pytest.approx(found["best"]["value"], abs=1e-9)
    assert tuned["after"] < 2 * tuned["before"]
    assert max(tuned["damping"]) <= 42 * (1 + 1e-9)
    assert tuned["simulated"] == pytest.approx(tuned["after"], rel=0.01)


def test_plan_refuses_a_limit_of_nothing() -> None:
    done = here("plan", FIVE_USERS, "--links", "6", "--tune-springs", "0")
    assert done.returncode == 2
    assert "damping_limit" in done.stderr
    assert "Traceback" not in done.stderr


SCENARIO = """
[network]
users = ["a", "b", "c"]
spring = [[0, 20, 30], [20, 0, 40], [30, 40, 0]]
delay = [[0, 0.1, 0.2], [0.2, 0, 0.3], [0.1, 0.1, 0]]

[body]
"""


def test_the_body_of_a_scenario_counts_and_options_override_it(tmp_path: Path) -> None:
    values = {}
    for name, body, options in (
        ("file", "mass = 3.0\nstiffness = 5.0", []),
        ("options", "mass = 1.0", ["--mass", "3", "--stiffness", "5"]),
        ("part", "mass = 9.0\nstiffness = 5.0", ["--mass", "3"]),
        ("plain", "mass = 1.0", []),
    ):
        path = tmp_path / f"{name}.toml"
        path.write_text(SCENARIO + body)
        done = here("plan", path, "--links", "2", "--objective", "decay", "--json", *options)
        assert done.returncode == 0, done.stderr
        values[name] = json.loads(done.stdout)["best"]["value"]
    assert values["file"] == values["options"] == values["part"]
    assert values["file"] != values["plain"]


def test_a_body_that_is_not_modal_is_one_sentence(tmp_path: Path) -> None:
    path = tmp_path / "scenario.toml"
    path.write_text(
        SCENARIO + "kind = 'matrices'\nmass = [[1, 0], [0, 2]]\nrest = [0, 1]\nstiffness_int = [[1, -1], [-1, 1]]\n"
    )
    done = here("plan", path, "--links", "2", "--objective", "decay")
    assert done.returncode == 2
    assert "no modes that move by themselves" in done.stderr
    assert done.stderr.count("\n") == 1
    assert here("plan", path, "--links", "2").returncode == 0, "the consensus knows no body"


@pytest.mark.parametrize("cold", [True, False])
def test_a_first_run_says_that_it_compiles(
    cold: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("cotouch.planning.compiles", lambda method: cold)
    none = {"mass": None, "damping": None, "stiffness": None}
    run(
        Path(FIVE_USERS),
        must=[],
        never=[],
        tune=None,
        figures=None,
        as_json=True,
        **{"links": 6, "objective": "damping", "method": "auto", **none},
    )
    said = capsys.readouterr()
    assert said.err == ("Compiling, once on this machine: about a minute.\n" if cold else "")
    assert json.loads(said.out)["worst_status"] == "proved"
