"""Whatever JSON a page sends is one of the commands, or refused in one short sentence."""

import json
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.thorough import examples

from cotouch.errors import SessionError
from cotouch.observers import ChooseLinks, Cut, Impair, Kill, MoveHand, SetDamping, SetRecording, read_command

PULL = {"what": "hand", "slot": 0, "mode": "pull"}
PATH = {"what": "impair", "a": 0, "b": 1}


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({}, "the command is None; it must be one of hand, impair"),
        ({"what": "fly"}, "the command is 'fly'"),
        ({"what": ["kill"]}, "the command is ['kill']"),
        ({"what": "kill"}, "slot is missing; it must be the slot of a user"),
        ({"what": "kill", "slot": True}, "slot is True"),
        ({"what": "kill", "slot": 1.0}, "slot is 1.0"),
        ({"what": "kill", "slot": "1"}, "slot is '1'"),
        ({"what": "kill", "slot": 256}, "slot is 256"),
        ({"what": "kill", "slot": 1, "on": True}, "kill has no 'on'; it has slot"),
        ({"what": "hand", "slot": 0, "mode": "fly"}, "mode is 'fly'; it must be one of script"),
        ({"what": "hand", "slot": 0, "mode": "grab"}, "mode is 'grab'"),
        ({"what": "hand", "slot": 0, "mode": "hold", "node": -2}, "node is -2"),
        (PULL, "to is missing; pull needs 3 numbers"),
        (
            PULL | {"mode": "cut", "at": [0, 0, 0], "to": [0, 0, 1]},
            "edge is missing; cut needs at, edge and to, 3 numbers",
        ),
        (
            PULL | {"mode": "cut", "at": [0, 0, 0], "to": [0, 0, 1], "edge": [0, 0, 0]},
            "edge has no length; it must lead from one end of the blade's edge to the other",
        ),
        (PULL | {"to": [0, 0]}, "to is [0, 0]; it must be 3 numbers"),
        (PULL | {"to": [0, 0, float("nan")]}, "it must be 3 numbers"),
        (PULL | {"to": [0, 0, 2e4]}, "it must be 3 numbers"),
        (PULL | {"to": "abc"}, "it must be 3 numbers"),
        (PATH, "nothing is given"),
        (PATH | {"delay": -1}, "delay is -1; it must be from 0 to 5 s"),
        (PATH | {"jitter": 5.1}, "jitter is 5.1; it must be from 0 to 5 s"),
        (PATH | {"loss": 1.5}, "loss is 1.5; it must be from 0 to 1"),
        (PATH | {"loss": "much"}, "loss is 'much'"),
        (PATH | {"b": 0, "loss": 0.5}, "a and b are both 0"),
        ({"what": "record", "on": 1}, "on is 1; it must be true or false"),
        ({"what": "damping", "fraction": 0}, "fraction is 0; it must be above 0 and at most 1"),
        ({"what": "damping", "fraction": 10**400}, "fraction is 1000"),
        ({"what": "links"}, "either choice or links"),
        ({"what": "links", "choice": "best", "links": []}, "either choice or links"),
        ({"what": "links", "choice": "odd"}, "choice is 'odd'; it must be one of best, worst, start"),
        ({"what": "links", "links": [[0, 1, 2]]}, "links is [[0, 1, 2]]; it must be a list"),
        ({"what": "links", "links": [[2, 2]]}, "links has a pair of 2 and 2"),
        ({"what": "links", "links": [[0, 1]] * 497}, "at most 496 pairs"),
    ],
)
def test_mistakes_are_sentences(given: dict[str, Any], words: str) -> None:
    with pytest.raises(SessionError) as error:
        read_command(given)
    assert words in str(error.value)


def test_what_is_right_goes_through() -> None:
    assert read_command(PULL | {"to": [1, 2, 3]}) == MoveHand(slot=0, mode="pull", to=(1.0, 2.0, 3.0))
    impaired = read_command(PATH | {"delay": 0.1, "loss": 0})
    assert isinstance(impaired, Impair)
    assert impaired.changes() == {"delay": 0.1, "loss": 0.0}
    assert read_command({"what": "cut", "a": 3, "b": 1, "on": False}) == Cut(a=3, b=1, on=False)
    assert read_command({"what": "links", "links": [[0, 1]], "choice": None}) == ChooseLinks(links=((0, 1),))
    assert read_command({"what": "damping", "fraction": 1}) == SetDamping(fraction=1.0)
    assert read_command({"what": "record", "on": True}) == SetRecording(on=True)
    assert read_command({"what": "kill", "slot": 31}) == Kill(slot=31)


values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=100),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=8,
)
whats = st.sampled_from(["hand", "impair", "cut", "kill", "revive", "expel", "links", "damping", "record"])
names = st.sampled_from(
    ["slot", "mode", "node", "to", "a", "b", "delay", "jitter", "loss", "on", "choice", "links", "fraction"]
)


@settings(max_examples=examples(300))
@given(what=whats | values, parts=st.dictionaries(names | st.text(max_size=100), values, max_size=5))
def test_nothing_else_ever_comes_of_it(what: Any, parts: dict[str, Any]) -> None:
    refused = ""
    try:
        command = read_command({**parts, "what": what})
    except SessionError as error:
        refused = str(error)
    else:
        assert command.what == what
        assert read_command(json.loads(command.model_dump_json())) == command
        return
    assert 0 < len(refused) < 300
    assert "pydantic" not in refused
