"""Measured latencies as a channel."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cotouch.errors import ScenarioError
from cotouch.members import path_laws
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, simulate

EXAMPLES = Path(__file__).parents[2] / "examples" / "networks"
ROWS = "send_s,rtt_ms\n10.0,40\n10.1,40\n10.2,80\n10.3,40\n"


def scenario(trace: dict[str, Any], *, duration: float = 1.0, mode: str = "freshest", **channel: Any) -> Scenario:
    return Scenario.make(
        network={"users": ["a", "b"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.01], [0.01, 0]]},
        steps={"duration": duration},
        synchronisation={"mode": mode},
        channel={"trace": trace, **channel},
        hands=[{"user": 1, "path": 0.05}],
    )


def written(folder: Path, text: str = ROWS) -> dict[str, Any]:
    path = folder / "trace.csv"
    path.write_text(text, encoding="utf-8")
    return {"file": str(path), "column": "rtt_ms", "as": "rtt", "time": "send_s"}


def test_messages_take_half_of_the_round_trip_measured_when_they_are_sent(tmp_path: Path) -> None:
    trace = {**written(tmp_path), "loop": False}
    timing = prepare(scenario(trace, duration=0.3)).schedule
    sent = timing.end[1]
    expected = 0.01 + 0.5e-3 * np.interp(sent, [0.0, 0.1, 0.2, 0.3], [40, 40, 80, 40])
    assert np.allclose(timing.draws[0].latency, expected, rtol=0, atol=1e-12)
    assert np.array_equal(timing.draws[0].latency, timing.draws[1].latency)


def test_one_way_is_taken_whole_and_rows_without_times_are_messages(tmp_path: Path) -> None:
    trace = written(tmp_path) | {"as": "one-way", "time": None, "loop": False}
    timing = prepare(scenario(trace, duration=0.004)).schedule
    assert np.allclose(timing.draws[0].latency, 0.01 + np.array([0.04, 0.04, 0.08, 0.04]))


def test_a_trace_begins_anew_and_each_direction_at_a_place_of_its_own(tmp_path: Path) -> None:
    timing = prepare(scenario(written(tmp_path), duration=2.0)).schedule
    a, b = (draws.latency for draws in timing.draws)
    assert not np.array_equal(a, b)
    again = int(0.4 / 1e-3)  # four rows, 0.1 s apart
    assert np.allclose(a[:-again], a[again:], atol=1e-9)
    assert a.min() >= 0.01 + 0.02 - 1e-12
    assert a.max() <= 0.01 + 0.04 + 1e-12


@pytest.mark.parametrize("mode", ["constant", "self-paced", "freshest"])
def test_the_ledger_is_exact_and_the_rule_covers_the_ages(mode: str, tmp_path: Path) -> None:
    run = simulate(scenario(written(tmp_path), mode=mode, loss=0.1))
    assert run.attrs["energy_residual"] < 1e-12
    assert run.attrs["made"] <= run.attrs["law_seed"] + 1e-12


@pytest.mark.parametrize("name", ["5g-n78-urban", "5g-n8-urban", "5g-n8-rural"])
def test_measured_networks_that_are_shipped_can_be_used(name: str) -> None:
    trace = {"file": str(EXAMPLES / f"{name}.csv"), "column": "rtt_ms", "as": "rtt", "time": "send_s", "most": 11.0}
    table = scenario(trace)
    assert table.files() == (EXAMPLES / f"{name}.csv",)
    found = table.trace()
    assert found is not None
    assert 0.005 < np.median(found.latency) < 0.02
    assert f"`{name}.csv`" in (EXAMPLES / "README.md").read_text(encoding="utf-8")


def test_a_file_is_found_beside_the_scenario(tmp_path: Path) -> None:
    written(tmp_path)
    text = """
    [network]
    users = ["a", "b"]
    spring = [[0, 50], [50, 0]]
    delay = [[0, 0], [0, 0]]
    [channel]
    trace = {file = "trace.csv", column = "rtt_ms", as = "rtt", loop = true}
    """
    (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
    found = Scenario.read(tmp_path / "scene.toml")
    assert found.trace() is not None
    assert found.replace(channel__loss=0.1).channel.trace == found.channel.trace


@pytest.mark.parametrize(
    ("text", "options", "message"),
    [
        ("send_s,rtt_ms\n", {}, "has no rows; a trace needs names in its first row"),
        ("", {}, "has no rows"),
        (ROWS, {"column": "owd_ms"}, 'has no column "owd_ms"; its first row names send_s, rtt_ms'),
        (ROWS.replace("80", "-80"), {}, 'rtt_ms in line 4 is "-80"; it must be a finite number, at least 0'),
        (ROWS.replace("80", "nan"), {}, 'rtt_ms in line 4 is "nan"; it must be a finite number'),
        (ROWS.replace("80", "inf"), {}, 'rtt_ms in line 4 is "inf"; it must be a finite number'),
        (ROWS.replace("10.2,80", "10.2"), {}, 'rtt_ms in line 4 is ""; it must be a finite number'),
        (ROWS.replace("80", "8000"), {}, "rtt_ms in line 4 is 8 s; if that is no mistake .* set channel.trace.most"),
        (ROWS.replace("10.2", "9.0"), {}, "send_s does not grow in line 4; keep one measurement in a file"),
        (ROWS, {"loop": False}, "lasts 0.4 s and the run 1; shorten the run, or let the trace begin anew"),
    ],
)
def test_what_is_wrong_with_a_trace_is_one_sentence(
    text: str, options: dict[str, Any], message: str, tmp_path: Path
) -> None:
    with pytest.raises(ScenarioError, match=message) as caught:
        prepare(scenario(written(tmp_path, text) | options))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"as": "both"}, "channel.trace.as is 'both'"),
        ({"column": "delay"}, 'column is "delay", which does not end in a unit; give unit'),
        ({"most": -1.0}, "channel.trace.most is -1.0"),
        ({"colour": 1}, "channel.trace.colour is not an option"),
    ],
)
def test_wrong_options_are_one_sentence(options: dict[str, Any], message: str, tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=message):
        scenario(written(tmp_path) | options)


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=r"none\.csv"):
        prepare(scenario({"file": str(tmp_path / "none.csv"), "column": "rtt_ms", "as": "rtt"}))


def test_sessions_say_that_they_do_not_emulate_it(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=r"channel\.trace is only for simulations"):
        path_laws(scenario(written(tmp_path)), 0)


def test_a_trace_has_its_own_jitter(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match="jitter and trace are given"):
        scenario(written(tmp_path), jitter={"scale": 0.01})
