"""Which law links have, where a scenario names none."""

from typing import Any

import pytest

from cotouch.scenario import Scenario, makes_tree
from cotouch.simulation import simulate

TWO: dict[str, Any] = {"users": ["a", "b"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.02], [0.02, 0]]}
THREE: dict[str, Any] = {
    "users": ["a", "b", "c"],
    "spring": [[0, 50, 50], [50, 0, 50], [50, 50, 0]],
    "delay": [[0, 0.02, 0.02], [0.02, 0, 0.02], [0.02, 0.02, 0]],
}
EVERY = [[50.0 * (i != j) for j in range(4)] for i in range(4)]
FOUR: dict[str, Any] = {
    "users": ["a", "b", "c", "d"],
    "spring": EVERY,
    "delay": [[4e-4 * value for value in row] for row in EVERY],
    "links": [[1, 2], [2, 3], [3, 4], [1, 4]],
}
LATTICE: dict[str, Any] = {"kind": "lattice", "shape": [2, 2, 2], "stiffness": 100.0}
TOOL: dict[str, Any] = {"user": 1, "at": [0.5, 0.5, 2.0], "stiffness": 300.0}
WEIGHT = [[2.0, 0.5], [0.5, 1.0]]
CHAIN: dict[str, Any] = {"kind": "chain", "nodes": 2, "stiffness": 10.0}
TEXT = """
[network]
users = ["a", "b"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.02], [0.02, 0]]
"""


def law(**tables: Any) -> str:
    return Scenario.make(**{"network": TWO, **tables}).law[0]


def test_links_have_the_law_that_costs_least() -> None:
    assert (
        law()
        == law(network=THREE)
        == law(body=CHAIN)
        == law(synchronisation={"damping": 2.0, "extra_damping": 1.0})
        == "paid"
    )


@pytest.mark.parametrize(
    "tables",
    [
        *({"synchronisation": {"damping": method}} for method in ("rule", "minimax", "exact")),
        {"synchronisation": {"damping_scale": 1.0}},
        {"synchronisation": {"mode": "constant"}},
        {"synchronisation": {"mode": "self-paced"}},
        {"network": {**TWO, "weight": WEIGHT}, "body": CHAIN},
        {"network": {**TWO, "delay": [[0, 0.5], [0.2, 0]]}},
        {"network": FOUR},
        {"network": {**THREE, "links": [[1, 2], [2, 3]]}, "body": CHAIN},
    ],
)
def test_what_only_springs_have_makes_them_springs(tables: dict[str, Any]) -> None:
    assert law(**tables) == "spring"
    if "synchronisation" in tables:
        named = {**tables, "synchronisation": {**tables["synchronisation"], "law": "wave"}}
        assert law(**named) == "wave"


def test_all_linked_whose_hands_tools_and_devices_are_felt_have_the_law_that_costs_least() -> None:
    body = Scenario.make(network=TWO, body={**CHAIN, "nodes": 6, "ground": [1]}).build_body()
    assert law(body=LATTICE) == law(body=body.truncated(modes=2, contacts=[5])) == "paid"
    assert law(body=LATTICE, tools=[TOOL]) == "paid"
    assert law(network={**THREE, "links": [[1, 2], [2, 3]]}) == "paid"  # hands are told on where links make a tree
    text = f"{TEXT}[session]\n[[session.devices]]\nuser = 1\n"
    assert Scenario.from_toml(text).law[0] == "paid"


@pytest.mark.parametrize(
    ("users", "links", "tree"),
    [
        (2, [(0, 1)], False),  # who is linked to all need not be told
        (3, [(0, 1), (1, 2)], True),
        (4, [(0, 1), (0, 2), (0, 3)], True),
        (4, [(0, 1), (1, 2), (0, 2)], False),
        (4, [(0, 1), (2, 3)], False),
        (3, [(0, 1), (1, 2), (0, 2)], False),
    ],
)
def test_what_makes_a_tree(users: int, links: list[tuple[int, int]], tree: bool) -> None:
    assert makes_tree(range(users), links) == tree


@pytest.mark.parametrize(
    "option",
    [
        "tank = 0.1",
        'links = "plan"',
        "quantile = 0.9",
        "age_limit = 1.0",
        'encoding = "float32"',
    ],
)
def test_what_guards_have_makes_a_sessions_file_springs(option: str) -> None:
    assert Scenario.from_toml(f"{TEXT}[session]\n{option}\n").law[0] == "spring"
    assert Scenario.from_toml(f'{TEXT}[synchronisation]\nlaw = "wave"\n[session]\n{option}\n').law[0] == "wave"


def test_other_options_of_a_session_leave_the_default() -> None:
    assert Scenario.from_toml(f'{TEXT}[session]\nforce_limit = 5.0\nencoding = "float64"\n').law[0] == "paid"


def test_a_result_says_which_law_ran_and_gives_it_again() -> None:
    scenario = Scenario.make(network=TWO, steps={"duration": 0.05})
    run = simulate(scenario)
    assert run.attrs["law"] == "paid"
    assert '"law": "paid"' in run.attrs["scenario"]
    assert scenario.to_toml().count("law") == 0  # what was given, and no defaults
