"""Measured latencies as a channel."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cotouch.errors import ScenarioError, SessionError
from cotouch.members import SessionFile, path_laws
from cotouch.samples import EmulatedPath
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


@pytest.mark.parametrize(
    "text",
    [
        "\ufeff" + ROWS.replace("\n", "\r\n"),
        ROWS.replace(",", ", "),
        ROWS.replace("send_s,rtt_ms", '"send_s", "rtt_ms"'),
    ],
)
def test_what_spreadsheets_write_is_read(text: str, tmp_path: Path) -> None:
    found = scenario(written(tmp_path, text)).trace()
    assert found is not None
    assert found.latency.tolist() == pytest.approx([0.02, 0.02, 0.04, 0.02])
    assert found.time is not None


@pytest.mark.parametrize("mode", ["constant", "self-paced", "freshest"])
def test_the_ledger_is_exact_and_the_rule_covers_the_ages(mode: str, tmp_path: Path) -> None:
    run = simulate(scenario(written(tmp_path), mode=mode, loss=0.1))
    assert run.attrs["energy_residual"] < 1e-12
    assert run.attrs["made"] <= run.attrs["law_initial_energy"] + 1e-12


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
        (ROWS.replace("send_s", "rtt_ms"), {"time": None}, 'has 2 columns "rtt_ms"; give each a name of its own'),
        (ROWS, {"column": "owd_ms"}, 'has no column "owd_ms"; its first row names send_s, rtt_ms'),
        (ROWS.replace("80", "-80"), {}, 'rtt_ms in line 4 is "-80"; it must be a finite number, at least 0'),
        (ROWS.replace("80", "nan"), {}, 'rtt_ms in line 4 is "nan"; it must be a finite number'),
        (ROWS.replace("\n10.2,80", "\n\n10.2,x"), {}, 'rtt_ms in line 5 is "x"; it must be a finite number'),
        (ROWS.replace("10.2", "1e308"), {}, 'send_s in line 4 is "1e308"; it must be a finite number'),
        (ROWS.replace("80", "inf"), {}, 'rtt_ms in line 4 is "inf"; it must be a finite number'),
        (ROWS.replace("10.2,80", "10.2"), {}, 'rtt_ms in line 4 is ""; it must be a finite number'),
        (ROWS.replace("80", "8000"), {}, "rtt_ms in line 4 is 8 s; if that is no mistake .* set channel.trace.most"),
        (ROWS + "1" * 200_000, {}, "trace .* cannot be read: field larger than field limit"),
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


@pytest.mark.parametrize("time", ["send_s", None])
def test_a_session_emulates_what_the_simulator_draws(time: str | None, tmp_path: Path) -> None:
    """Each direction from the same place on."""
    asked = scenario(written(tmp_path) | {"time": time}, duration=2.0)
    timing = prepare(asked).schedule
    for receiver in (0, 1):
        path = EmulatedPath(path_laws(asked, 1 - receiver)[receiver], np.random.default_rng(1))
        if time is not None:
            path.arrivals(7.0, 10)  # the simulator's clock begins a step before the first message
        sent = 7.0 + timing.end[1 - receiver]
        arrived = np.array([path.arrivals(when, 10)[0] for when in sent])
        latency = timing.draws[list(timing.slots.receiver).index(receiver)].latency
        assert np.allclose(arrived - sent, latency, rtol=0, atol=1e-9)


def test_a_session_lasts_longer_than_a_trace_that_ends(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=r"channel\.trace\.loop is false, but a session may last longer"):
        path_laws(scenario(written(tmp_path) | {"loop": False}), 0)


def test_a_trace_travels_with_its_session(tmp_path: Path) -> None:
    written(tmp_path)
    text = """
    [network]
    users = ["a", "b"]
    spring = [[0, 50], [50, 0]]
    delay = [[0, 0], [0, 0]]
    [channel]
    trace = {file = "trace.csv", column = "rtt_ms", as = "rtt"}
    [session]
    emulate = true
    """
    (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
    session = SessionFile.read(tmp_path / "scene.toml")
    assert set(session.files) == {"trace.csv"}
    (tmp_path / "there").mkdir()
    travelled = SessionFile.from_content(session.content, session.files, folder=tmp_path / "there")
    (tmp_path / "trace.csv").unlink()
    law = path_laws(travelled.scenario, 0)[1]
    assert law.further is not None
    assert {law.further(0.0, number) for number in range(4)} == {0.02, 0.04}
    with pytest.raises(SessionError, match=r"trace\.csv cannot be read: No such file"):
        SessionFile.read(tmp_path / "scene.toml")
    (tmp_path / "trace.csv").write_text("rtt_ms\n" + (1 << 19) * "1\n", encoding="utf-8")
    with pytest.raises(SessionError, match=r"the trace .*trace\.csv cannot be read: it has more than 1 MB"):
        SessionFile.read(tmp_path / "scene.toml")
    (tmp_path / "trace.csv").write_text("send_s,rtt_ms\n", encoding="utf-8")
    with pytest.raises(ScenarioError, match="has no rows"):
        SessionFile.read(tmp_path / "scene.toml")


def test_a_trace_has_its_own_jitter(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match="jitter and trace are given"):
        scenario(written(tmp_path), jitter={"scale": 0.01})
