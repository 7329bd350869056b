import json
from pathlib import Path

import numpy as np
import pytest

from cotouch.errors import InputError, NetworkError, ScenarioError
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, schedule

FIVE_USERS = Path(__file__).parents[2] / "examples" / "five-users.toml"
PAIR = """
[network]
users = ["Ann", "Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.05], [0.02, 0]]
"""


def test_example_is_the_papers() -> None:
    scenario = Scenario.read(FIVE_USERS)
    assert scenario.network.size == 5
    assert scenario.network.spring[0, 4] == 100
    assert scenario.network.delay[1, 0] == 0.05
    assert len(scenario.network.links) == 6
    assert scenario.build_body().mass[0, 0] == 1.0


def test_a_network_alone_is_a_scenario() -> None:
    scenario = Scenario.from_toml(PAIR)
    assert scenario.network.links == ((0, 1),)
    assert scenario.build_body().nodes == 1
    assert schedule(scenario).mode == "freshest"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[steps]\nduration = -1", ["steps.duration", "-1"]),
        ("[steps]\nperiod = 0.0", ["steps.period", "0.0"]),
        ("[steps]\nperiod = 0.001\nrate = 100", ["period and rate", "only one"]),
        ("[steps]\nrandom = {low = 0.2, high = 0.1}", ["low", "0.2"]),
        ("[steps]\nperiod = [0.001]", ["steps.period", "1 entries", "2 users"]),
        ("[steps]\nduration = nan", ["steps.duration", "nan"]),
        ("[steps]\nduration = 1e9", ["steps", "make it shorter"]),
        ("[steps]\nduration = 0.0001", ["less than one step"]),
        ("[synchronisation]\nmode = 'fastest'", ["synchronisation.mode", "'fastest'", "'freshest'"]),
        ("[synchronisation]\ndamping = 'best'", ["synchronisation.damping", "'best'"]),
        ("[synchronisation]\ndamping = [1.0]", ["synchronisation.damping", "1 entries"]),
        (
            "[synchronisation]\nmode='constant'\nindex_delay = [[0, 0], [3, 0]]",
            ["index_delay[1][2]", "0", "at least 1"],
        ),
        ("[synchronisation]\nmode='constant'\nindex_delay = [[0, 0]]", ["index_delay", "2 x 2"]),
        ("[channel]\nloss = 1.5", ["channel.loss", "1.5"]),
        ("[channel]\njitter = {scale = -1}", ["channel.jitter.scale", "-1"]),
        ("[channel]\nlos = 0.1", ["channel.los", "not an option"]),
        ("[chanel]\nloss = 0.1", ["chanel", "not an option"]),
        ("[[hands]]\nuser = 3", ["hands[1].user", "3", "users 1 to 2"]),
        ("[[hands]]\nuser = 1\n[[hands]]\nuser = 0", ["hands[2].user", "0"]),
        ("[[hands]]\nuser = 1\nnode = 2", ["hands[1].node", "2", "nodes 1 to 1"]),
        ("[[hands]]\nuser = 1\npath = [1.0, 2.0]", ["hands[1].path", "1 axes"]),
        ("[[hands]]\nuser = 1\npath = [[0.0, 1.0], [0.0, 2.0]]", ["path", "increase"]),
        ("[[hands]]\nuser = 1\npath = [[0.0, 1.0, 2.0]]", ["hands[1].path", "waypoint"]),
        ("[[hands]]\nuser = 1\nbegin = 2.0\nrelease = 1.0", ["release is 1.0", "later"]),
        ("[[hands]]\nuser = 'x'", ["hands[1].user", "'x'"]),
        ("[initial]\nposition = [1.0]", ["initial.position", "1 entries"]),
        ("[initial]\nposition = [1.0, [1.0, 2.0, 3.0]]", ["initial.position[2]"]),
        ("[body]\nmass = 0.0", ["body.mass", "0.0"]),
        ("[body]\nkind = 'blob'", ["body.kind", "'blob'", "lattice"]),
        ("[body]\nkind = 'lattice'", ["body.shape", "missing"]),
        ("[record]\nnodes = [7]", ["node 7", "1 to 1"]),
        ("[solver]\niterations = 0", ["solver.iterations", "0"]),
        ("seed = -1", ["seed", "-1"]),
    ],
)
def test_what_is_wrong_is_one_sentence(text: str, words: list[str]) -> None:
    ordered = f"{text}\n{PAIR}" if text.startswith("seed") else f"{PAIR}\n{text}"
    with pytest.raises(InputError) as caught:
        prepare(Scenario.from_toml(ordered, source="test.toml"))
    message = str(caught.value)
    assert "\n" not in message
    for word in words:
        assert word in message, message


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=r"nowhere\.toml cannot be read"):
        Scenario.read(tmp_path / "nowhere.toml")
    broken = tmp_path / "broken.toml"
    broken.write_text("[network\n")
    with pytest.raises(ScenarioError, match=r"broken\.toml is not TOML"):
        Scenario.read(broken)
    broken.write_bytes(b"\xff\xfe")
    with pytest.raises(ScenarioError, match="UTF-8"):
        Scenario.read(broken)
    broken.write_text("[body]\nmass = 1.0\n")
    with pytest.raises(ScenarioError, match=r"no \[network\] table"):
        Scenario.read(broken)
    broken.write_text(PAIR.replace("[[0, 50], [50, 0]]", "[[0, 50], [60, 0]]"))
    with pytest.raises(NetworkError, match=r"50.*60"):
        Scenario.read(broken)


def test_replace_changes_one_option_and_keeps_the_rest() -> None:
    scenario = Scenario.read(FIVE_USERS)
    other = scenario.replace(synchronisation__mode="freshest", steps__duration=3.0)
    assert other.synchronisation.mode == "freshest"
    assert other.synchronisation.damping == "rule"
    assert other.steps.duration == 3.0
    assert other.steps.period == scenario.steps.period
    assert other.hands == scenario.hands
    assert scenario.synchronisation.mode == "constant"


def test_json_holds_the_whole_scenario() -> None:
    scenario = Scenario.read(FIVE_USERS)
    again = json.loads(scenario.as_json())
    network = again.pop("network")
    rebuilt = Scenario.make(network=network, **again)
    assert rebuilt.as_json() == scenario.as_json()
    assert np.array_equal(rebuilt.network.spring, scenario.network.spring)
