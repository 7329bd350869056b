"""`cotouch plan` as a user runs it."""

import csv
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.cli.commands import FIVE_USERS, here

from cotouch import planning
from cotouch.network import Network
from cotouch.session import MeasuredNetwork


def test_plan_prints_one_json_object() -> None:
    done = here("plan", FIVE_USERS, "--links", "6", "--objective", "decay", "--top", "2", "--json")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert (found["objective"], found["status"], found["graphs"], found["choices"]) == ("decay", "proved", 205, 210)
    assert found["best"]["links"] == [list(pair) for pair in ("12", "14", "23", "24", "34", "45")]
    assert found["best"]["value"] == pytest.approx(-1.428553, abs=1e-6)
    assert found["best"]["time_constant_s"] == pytest.approx(1 / 1.428553, abs=1e-6)
    assert len(found["best"]["damping"]) == 5
    assert found["worst"]["value"] == pytest.approx(-0.289652, abs=1e-6)
    assert len(found["top"]) == 2
    assert found["top"][0] == found["best"]


def test_plan_prints_a_table_and_keeps_to_the_limits() -> None:
    done = here("plan", FIVE_USERS, "--links", "5", "--require", "1-3", "--forbid", "2-4,4-5", "--max-degree", "3")
    assert done.returncode == 0, done.stderr
    assert "Proved for 5 users" in done.stdout
    best = re.search(r"^  1 +((?:\d-\d ?)+)", done.stdout, re.MULTILINE)
    assert best is not None
    assert "1-3" in best[1]
    assert "2-4" not in best[1]


def test_what_was_measured_can_be_planned_as_the_documents_say(tmp_path: Path) -> None:
    """Measured delays are no whole time units of the consensus model, which is the objective where none is named."""
    delay = np.array([[0.0, 0.002849, 0.0013], [0.002849, 0.0, 0.0021], [0.0013, 0.0021, 0.0]])
    spring = 60.0 * (delay > 0.0)
    network = Network(users=["Ann", "Ben", "Cleo"], spring=spring, delay=delay, links=[(0, 1), (1, 2)])
    path = tmp_path / "network.toml"
    path.write_text(MeasuredNetwork(network=network, missing=[(0, 2)], emulated=False).toml())
    done = here("plan", path, "--links", "2", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["objective"] == "decay"
    assert "(--objective decay)" in done.stderr
    named = here("plan", path, "--links", "2", "--objective", "consensus")
    assert (named.returncode, "choose a time unit" in named.stderr) == (2, True)


def test_a_number_of_choices_that_nobody_would_read_is_told_by_its_size() -> None:
    trips = Path(__file__).parents[2] / "examples" / "round-trips.csv"
    options = ("--objective", "damping", "--method", "local", "--time-limit", "1")
    done = here("plan", "--delays", trips, "--links", "16", *options)
    assert done.returncode == 0, done.stderr
    assert re.search(r"\d+ graphs? of about 10\^14 choices\s+evaluated", done.stdout), done.stdout


def test_a_graph_that_never_mixes_has_no_time_constant() -> None:
    done = here("plan", FIVE_USERS, "--links", "6", "--json")
    worst = json.loads(done.stdout)["worst"]
    assert worst["value"] == 1.0
    assert worst["time_constant_s"] is None
    assert worst["cycle_period"] > 1


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--links", "3"], "links is 3"),
        (["--links", "6", "--require", "1to2"], '--require is "1to2"'),
        (["--links", "6", "--require", "1-2", "--forbid", "2-1"], "1-2 is both in require and in forbid"),
        (["--links", "6", "--objective", "speed"], 'objective is "speed"'),
        (["--links", "6", "--time-unit", "0.03"], "choose a time unit that divides it"),
        (["--links", "many"], '--links is "many"; it must be a number such as 6'),
        (["--links", "at most 3"], "takes 4 to 10"),
        (["--links", "6", "--forbid", "1-Ann"], '--forbid is "1-Ann", which is not a link'),
        (["--links", "6", "--pick", "1,2"], "give one with --delays"),
        (["--links", "6", "--delays", "trips.csv"], "both give users and delays"),
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


@pytest.mark.parametrize("limit", ["0", "-1", "nan", "inf"])
def test_plan_refuses_a_limit_of_nothing(limit: str) -> None:
    done = here("plan", FIVE_USERS, "--links", "6", "--tune-springs", limit)
    assert (done.returncode, done.stdout) == (2, "")
    assert f"--tune-springs is {limit} Ns/m" in done.stderr
    assert done.stderr.count("\n") == 1


SCENARIO = """
[network]
users = ["a", "b", "c"]
spring = [[0, 20, 30], [20, 0, 40], [30, 40, 0]]
delay = [[0, 0.1, 0.2], [0.2, 0, 0.3], [0.1, 0.1, 0]]

[body]
"""


def test_plan_draws_and_tunes(tmp_path: Path) -> None:
    (tmp_path / "three.toml").write_text(SCENARIO)
    done = here(
        *("plan", tmp_path / "three.toml", "--links", "2", "--objective", "decay", "--tune-springs", "42"),
        *("--figures", str(tmp_path / "drawn"), "--json"),
    )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert sorted(Path(name).name for name in found["files"]) == ["knee.png", "networks.png", "ranks.png"]
    assert all(Path(name).stat().st_size > 10_000 for name in found["files"])
    tuned = found["tuned"]
    assert tuned["links"] != found["best"]["links"], "links are chosen with their springs"
    assert tuned["after"] < -3.8 < found["best"]["value"]
    assert max(tuned["damping"]) <= 42 * (1 + 1e-9)
    assert tuned["simulated"] == pytest.approx(tuned["after"], rel=1e-4)


def test_nothing_is_said_of_a_run_where_the_slowest_modes_are_alike() -> None:
    done = here("plan", FIVE_USERS, "--links", "6", "--objective", "decay", "--tune-springs", "42", "--json")
    assert done.returncode == 0, done.stderr
    tuned = json.loads(done.stdout)["tuned"]
    assert tuned["after"] < -6.6, "links are chosen with their springs"
    assert max(tuned["damping"]) <= 42 * (1 + 1e-9)
    # Three modes within half a per mille of each other: a run does not tell which is the slowest.
    assert tuned["simulated"] is None


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
    assert "no independent modes" in done.stderr
    assert done.stderr.count("\n") == 1
    assert here("plan", path, "--links", "2").returncode == 0, "the consensus knows no body"


@pytest.mark.parametrize("cold", [True, False])
def test_a_first_run_says_that_it_compiles_and_has_a_first_answer(cold: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cotouch.cli._plan.compiles", lambda *_: cold)
    done = here("plan", FIVE_USERS, "--links", "6", "--objective", "damping", "--json")
    compiling, *first = done.stderr.splitlines() or [""]
    assert compiling == ("Compiling, which takes about two minutes, once on this machine." if cold else "")
    assert [line[:47] for line in first] == (["Meanwhile, the best of 205 choices of 6 links, "] if cold else [])
    assert json.loads(done.stdout)["worst_status"] == "proved"


def test_a_range_of_links_tells_the_knee() -> None:
    done = here("plan", FIVE_USERS, "--links", "4-7", "--objective", "decay", "--json")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    rates = {one["links"]: one["value"] for one in found["counts"]}
    assert rates[5] == pytest.approx(-5.1, abs=0.05)
    assert rates[6] == pytest.approx(-1.428553, abs=1e-6)
    text = here("plan", FIVE_USERS, "--links", "at most 7", "--objective", "decay").stdout
    assert f"the knee is at {found['knee']}" in text


def test_users_go_by_their_names(tmp_path: Path) -> None:
    path = tmp_path / "trips.csv"
    path.write_text(",Ann,Jo-Ann,Cleo,Dora\nAnn,0,100,80,50\nJo-Ann,100,0,60,90\nCleo,80,60,0,70\nDora,50,90,70,0\n")
    options = (
        "--delays",
        str(path),
        "--links",
        "3",
        "--objective",
        "decay",
        "--require",
        "Jo-Ann-Cleo",
        "--forbid",
        "1-2",
    )
    done = here("plan", *options, "--json")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert found["users"] == ["Ann", "Jo-Ann", "Cleo", "Dora"]
    for choice in (found["best"], found["worst"], *found["top"]):
        assert ["Jo-Ann", "Cleo"] in choice["links"]
        assert {name for link in choice["links"] for name in link} == set(found["users"])
    assert "Jo-Ann-Cleo" in here("plan", *options).stdout
    picked = here("plan", "--delays", str(path), "--pick", "Dora,Ann,Cleo", "--links", "2", "--objective", "damping")
    assert "Proved for 3 users" in picked.stdout
    assert "Dora-Ann" in picked.stdout


def test_names_with_commas_and_brackets_are_quoted_as_they_are_shown(tmp_path: Path) -> None:
    names = ["New York, NY", "São Paulo [BR]", "[red]Oslo", 'St. John\'s "NL"', "Aix-en-Provence"]
    path = tmp_path / "trips.csv"
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(["", *names])
        rows.writerows([name, *(0 if i == j else 40 + 7 * i + 7 * j for j in range(5))] for i, name in enumerate(names))
    options = ("plan", "--delays", str(path), "--links", "3", "--objective", "damping")
    picked = '"New York, NY", [red]Oslo, "St. John\'s ""NL""", Aix-en-Provence'
    whole = here(*options, "--pick", picked, "--require", "New York, NY-Aix-en-Provence")
    assert whole.returncode == 0, whole.stderr
    assert "Proved for 4 users" in whole.stdout
    shown = '"New York, NY-Aix-en-Provence"'
    assert shown in " ".join(whole.stdout.split())
    again = here(*options, "--pick", picked, "--require", f"{shown}, [red]Oslo-Aix-en-Provence", "--json")
    assert again.returncode == 0, again.stderr
    links = json.loads(again.stdout)["best"]["links"]
    assert {("New York, NY", "Aix-en-Provence"), ("[red]Oslo", "Aix-en-Provence")} <= set(map(tuple, links))


def test_the_knee_figure_shows_what_the_plan_says(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The objective asked for, with the plan's own numbers; around a single number of links as many on either side."""
    seen: list[tuple[tuple[Any, ...], dict[str, Any]]] = []
    real = planning.knee
    monkeypatch.setattr("cotouch.cli._plan_extras.knee", lambda *a, **more: seen.append((a, more)) or real(*a, **more))
    options = ("plan", FIVE_USERS, "--json", "--figures", str(tmp_path / "drawn"))
    found = json.loads(here(*options, "--links", "4-7", "--objective", "drag").stdout)
    ((counts, (label, values), _), more) = seen.pop()
    assert label == "Drag / (Ns/m)"
    assert dict(zip(counts, values, strict=True)) == {one["links"]: one["value"] for one in found["counts"]}
    assert (more["bend"], more["chosen"]) == (found["knee"], len(found["best"]["links"]))
    found = json.loads(here(*options, "--links", "6", "--objective", "decay").stdout)
    ((counts, (label, values), _), more) = seen.pop()
    assert (label, counts) == ("Decay / (1/s)", [4, 5, 6, 7, 8, 9, 10])
    assert values[2] == -found["best"]["value"]
    assert values[1] == pytest.approx(5.1, abs=0.05)


def test_an_interrupted_tuning_still_tells_the_plan(monkeypatch: pytest.MonkeyPatch) -> None:
    """And the springs found so far; a plan of several numbers of links tells those there are."""
    tuned = planning.tune_springs(Network.read(FIVE_USERS), damping_limit=42.0, rounds=0)

    def interrupt(*_: object, ranked: planning.Plan, **__: object) -> None:
        raise planning.JointInterrupted(planning.Joint(tuned, 1, 1, ranked))

    monkeypatch.setattr("cotouch.cli._plan_extras.plan_springs", interrupt)
    done = here("plan", FIVE_USERS, "--links", "6", "--objective", "decay", "--tune-springs", "42", "--json")
    assert (done.returncode, done.stderr) == (130, "cotouch: interrupted\n")
    said = json.loads(done.stdout)
    assert said["best"]["value"] == pytest.approx(-1.428553, abs=1e-6)
    assert said["tuned"]["after"] == tuned.after
    assert len(said["top"]) == 5


def test_a_long_delay_is_questioned(tmp_path: Path) -> None:
    path = tmp_path / "trips.csv"
    path.write_text(",Ann,Ben\nAnn,0,120000\nBen,120000,0\n")
    done = here("plan", "--delays", str(path), "--links", "1", "--objective", "damping")
    assert done.returncode == 0, done.stderr
    assert "is it right?" in done.stdout
