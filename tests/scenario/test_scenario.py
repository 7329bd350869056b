import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from cotouch.body import point
from cotouch.errors import InputError, NetworkError, ScenarioError
from cotouch.network import Network, certify
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, schedule, simulate

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
        ("[steps]\nduration = 1e9", ["steps", "1e+12 steps", "make steps.duration shorter"]),
        ("[steps]\nduration = 0.0001", ["less than one step"]),
        # What no number can hold beside others: a hand so firm was told to take energy out, or moved nothing.
        (
            "[[hands]]\nuser = 1\nstiffness = 1e100",
            ["hands[1].stiffness", "1e+100", "less than or equal to 1000000000"],
        ),
        ("[[hands]]\nuser = 1\ndamping = 1e10", ["hands[1].damping", "less than or equal to 1000000000"]),
        ("[[hands]]\nuser = 1\npath = [1e100]", ["hands[1].path", "1e+100", "within 1e+09"]),
        ("[world]\ngravity = [0, 0, -1e300]", ["world.gravity[3]", "greater than or equal to -1000000000"]),
        ("[[tools]]\nuser = 1\nat = [0, 0, 0]\nstiffness = 1e16", ["tools[1].stiffness", "less than or equal to"]),
        ("[[tools]]\nuser = 1\nat = [0, 0, 0]\n[tools.hand]\nstiffness = 1e16", ["tools[1].hand.stiffness"]),
        # Whether or not there is a tool that touches.
        ("[contact]\nlaw = 'glue'", ['contact.law is "glue"', "foundation", "stiffening"]),
        ("[contact.parameters]\nsoftness = 1", ["contact.parameters.softness is 1", "hardness, each above 0"]),
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
        ("[[hands]]\nuser = 'x'", ["hands[1].user", "'x'", "must be an integer"]),
        ("[initial]\nposition = [1.0]", ["initial.position", "1 entries"]),
        ("[initial]\nposition = [1.0, [1.0, 2.0, 3.0]]", ["initial.position[2]"]),
        ("[body]\nmass = 0.0", ["body.mass", "0.0"]),
        ("[body]\nkind = 'blob'", ["body.kind", "'blob'", "lattice"]),
        ("[body]\nkind = 'lattice'", ["body.shape", "missing"]),
        ("[record]\nnodes = [7]", ["node 7", "1 to 1"]),
        ("[solver]\niterations = 0", ["solver.iterations", "0"]),
        ("seed = -1", ["seed", "-1"]),
        ("seed = 10000000000000000000", ["seed", "less than"]),
        ("seed = true", ["seed is True", "number"]),
        ("[body]\nmass = true", ["body.mass is True", "number"]),
        ("[steps]\nrate = [true, 1]", ["steps.rate is [True, 1]", "number"]),
        ("[[hands]]\nuser = 1\npath = [[0, true]]", ["hands[1].path", "True"]),
        ("[[hands]]\nuser = 1\npath = []", ["hands[1].path is []", "waypoints"]),
        ("[[hands]]\nuser = 10000000000000000000", ["hands[1].user", "less than"]),
        (
            "[synchronisation]\nmode='constant'\nindex_delay = [[0, 1e19], [3, 0]]",
            ["synchronisation.index_delay", "1e+19", "smaller"],
        ),
        ("[synchronisation]\nindex_delay = [[0, 1], [3, 0]]", ["synchronisation.index_delay", "freshest", "no effect"]),
        ("[synchronisation]\nmax_step = 3", ["synchronisation.max_step", "freshest", "no effect"]),
        ("[channel]\nreordering = 0.1", ["channel.reordering is 0.1", "reordering_delay is 0 s"]),
        ("[steps]\nduration = 1\n[record]\nevery = 5000", ["record.every is 5000", "1000 steps"]),
        ("[record]\nevery = 10000000000000000000", ["record.every", "less than"]),
        ("[solver]\niterations = 10000000000000000000", ["solver.iterations", "less than"]),
        ("[between]\nself_contact = 'yes'", ["between.self_contact is 'yes'; it must be true or false"]),
        ("[between]\nself_contact = 1", ["between.self_contact is 1; it must be true or false"]),
        ("[between]\nstiffness = 1e30", ["between.stiffness is 1e+30", "less than or equal to 1000000000000000"]),
        ("[[world.planes]]\nstiffness = 1e30", ["world.planes[1].stiffness is 1e+30", "less than or equal to"]),
        ("[cutting]\nusers = [1, 1]", ["cutting.users is [1, 1]; name each user once"]),
        ("[body]\nkind = 'sphere'\nradius = 0.1\ndensity = 5\nmass = 2", ["density and mass are given", "only one"]),
        ("[body]\nfile = 'a.stl'\ndensity = 5\nmass = 2", ["body.density and mass are given", "only one"]),
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


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ("[[hands]]\nuser = 1\nnode = 9", "hands[1].node is 9; the body has nodes 1 to 1"),
        ("[[hands]]\nuser = 5", "hands[1].user is 5; the network has users 1 to 2"),
        ("[body]\nkind = 'chain'\nnodes = 2\nground = [7]", "ground names node 7; this body has nodes 1 to 2"),
        ("[record]\nevery = 2000000", "record.every is 2000000, but the run has 20000 steps; make it less"),
    ],
)
def test_what_only_the_run_tells_names_the_file_once(tmp_path: Path, more: str, said: str) -> None:
    """And still where options were replaced; a scenario of no file names none."""
    path = tmp_path / "wrong.toml"
    path.write_text(PAIR + more)
    for scenario, where in (
        (Scenario.read(path), f"{path}: "),
        (Scenario.read(path).replace(seed=1), f"{path}: "),
        (Scenario.from_toml(PAIR + more), ""),
    ):
        with pytest.raises(InputError) as error:
            prepare(scenario)
        assert str(error.value) == where + said


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


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ("3", ["network is 3", "users, spring, delay"]),
        ("{users = 3, spring = [[0]], delay = [[0]]}", ["users is 3", "list of names"]),
        ("{users = ['a', 'b'], spring = [[0, true], [true, 0]], delay = [[0, 1], [1, 0]]}", ["spring", "real numbers"]),
        ("{users = ['a', 'b'], spring = [[0, 1], [1, 0]], delay = [[0, '1'], [1, 0]]}", ["delay", "real numbers"]),
        (
            '{users = ["a", "b\\u001b[2J"], spring = [[0, 1], [1, 0]], delay = [[0, 1], [1, 0]]}',
            ["user 2", r"\x1b", "printable"],
        ),
    ],
)
def test_what_is_no_network_is_one_sentence(table: str, words: list[str]) -> None:
    with pytest.raises(NetworkError) as caught:
        Scenario.from_toml(f"network = {table}", source="test.toml")
    for word in ("test.toml", *words):
        assert word in str(caught.value)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (Scenario, ["network is missing"]),
        (lambda: Scenario(network=3), ["network is 3", "must be a table"]),
        (lambda: simulate(None), ["scenario is None", "a path or a mapping"]),
        (lambda: simulate({1: 2}), ["network is missing"]),
        (lambda: Network(users=["a", "b"], spring=np.eye(2) * 1j, delay=np.zeros((2, 2))), ["spring", "real numbers"]),
        (lambda: certify(Scenario.from_toml(PAIR).network, damping="big"), ["damping", "real numbers"]),
        (lambda: certify(Scenario.from_toml(PAIR).network, periods="long"), ["periods", "real numbers"]),
    ],
)
def test_what_is_wrong_in_python_is_one_sentence_too(call: Callable[[], object], words: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        call()
    for word in words:
        assert word in str(caught.value)


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


def test_options_are_replaced_one_by_one() -> None:
    scenario = Scenario.read(FIVE_USERS)
    other = scenario.replace(
        steps__rate=[100, 200, 100, 100, 100], steps__period=None, synchronisation__mode="freshest"
    )
    assert (other.steps.rate, other.steps.period) == ([100, 200, 100, 100, 100], None)
    fewer = scenario.replace(network__links=[[1, 2], [2, 3], [3, 4], [4, 5]])
    assert fewer.network.links == ((0, 1), (1, 2), (2, 3), (3, 4))
    assert np.array_equal(fewer.network.delay, scenario.network.delay)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"network__links": [[1, 9]]}, ["[1, 9]", "users are numbered 1 to 5"]),
        ({"network__link": 3}, ['no key "link"']),
        ({"setps__duration": 3}, ['"setps" is not a table', "steps"]),
        ({"title__size": 3}, ["title has no options"]),
        ({"hands__path": 3}, ["hands has no options"]),
        ({"network": 3}, ["network is 3", "table"]),
    ],
)
def test_what_cannot_be_replaced_is_one_sentence(changes: dict[str, object], words: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        Scenario.read(FIVE_USERS).replace(**changes)
    for word in words:
        assert word in str(caught.value)


EXAMPLES = sorted(path for path in FIVE_USERS.parent.glob("*.toml") if "[network]" in path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_a_scenario_is_its_own_text(path: Path) -> None:
    scenario = Scenario.read(path)
    again = Scenario.from_toml(scenario.to_toml())
    left, right = json.loads(scenario.as_json()), json.loads(again.as_json())
    for one in (left, right):
        one["body"].pop("file", None)  # absolute in the text
    assert left == right
    assert again.to_toml() == scenario.to_toml()


def test_text_that_needs_escapes_and_what_is_left_out() -> None:
    title = 'She said "so": \\ \x7f\t\u00e9'
    scenario = Scenario.from_toml(PAIR).replace(title=title, synchronisation__law={"kind": "wave", "impedance": 2.0})
    text = scenario.to_toml()
    assert Scenario.from_toml(text).title == title
    assert Scenario.from_toml(text).synchronisation.law_given == ("wave", {"impedance": 2.0})
    assert "[channel]" not in text, "no defaults"
    assert "impedance = 2.0" in scenario._repr_html_()
    with pytest.raises(ScenarioError, match="made in Python"):
        scenario.replace(body=point()).to_toml()
    assert "<td>Ann</td><td>Ben</td><td>50</td><td>0.02</td><td>0.05</td>" in scenario.network._repr_html_()


def test_python_counts_users_from_0_and_says_so() -> None:
    network = Scenario.from_toml(PAIR).network
    with pytest.raises(NetworkError, match=r"links: \(0, 2\) holds the index 2; users have the indices 0 to 1"):
        network.with_links([(0, 2)])
    with pytest.raises(NetworkError, match=r"links: \[1, 3\] names user 3; users are numbered 1 to 2"):
        Network.from_table({**network.as_table(), "links": [[1, 3]]})
