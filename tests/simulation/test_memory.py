"""What a run is said to take of memory, beside what it takes; and what is refused for it."""

import tracemalloc
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.simulation.inside import free_memory, needed, refuse_beyond

from cotouch.body import chain, lattice
from cotouch.errors import BodyError, ScenarioError
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, simulate

FIVE_USERS = Path(__file__).parents[2] / "examples" / "five-users.toml"
PAIR: dict[str, Any] = {"users": ["Ann", "Ben"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.03], [0.05, 0]]}
CHAIN = {"kind": "chain", "nodes": 30, "dimension": 3, "model": "springs"}


def _five(**tables: Any) -> Scenario:
    return Scenario.read(FIVE_USERS).replace(**tables)


@pytest.mark.parametrize(
    "scenario",
    [
        _five(),
        _five(record__every=20, steps__duration=100.0),
        _five(synchronisation__mode="freshest", steps__rate=[900, 1000, 800, 1000, 700], steps__period=None),
        _five(synchronisation__mode="self-paced", channel={"jitter": {"scale": 0.02}, "loss": 0.1, "duplication": 0.1}),
        Scenario.make(network=PAIR, body=CHAIN, steps={"duration": 5.0}),
        Scenario.make(
            network=PAIR, body=CHAIN, steps={"duration": 10.0}, record={"every": 1000, "nodes": [1], "frames": 500}
        ),
    ],
    ids=["five", "few records", "own rates", "a bad network", "many nodes", "frames"],
)
def test_what_a_run_is_said_to_take_is_what_it_takes(scenario: Scenario) -> None:
    simulate(scenario.replace(steps__duration=0.9, record__frames=None, record__every=1))  # compiles and imports
    prepared = prepare(scenario)
    said = needed(scenario, prepared.body, prepared.model, prepared.nodes.size)
    tracemalloc.start()
    simulate(scenario)
    taken = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert 0.7 * taken < said < 2.5 * taken, (said / taken, taken)


def test_a_run_that_does_not_fit_is_refused_with_the_figure() -> None:
    scenario = _five(steps__duration=20_000.0)
    prepared = prepare(_five(steps__duration=1.0))
    wanted = needed(scenario, prepared.body, prepared.model, 1)
    assert 5e9 < wanted < 50e9
    with pytest.raises(ScenarioError, match=r"needs about .* GB of memory, but 4 GB are free; make steps\.duration"):
        refuse_beyond(wanted, 4_000_000_000)
    assert 0 < free_memory() < 1 << 60
    refuse_beyond(wanted, wanted)


def test_a_run_of_many_frames_is_refused_before_it_begins() -> None:
    with pytest.raises(ScenarioError, match="GB are free"):
        prepare(_five(record__frames=1e12))


@pytest.mark.parametrize("body", [{"kind": "chain", "nodes": 1e9}, {"kind": "lattice", "shape": [1000, 1000, 1000]}])
def test_a_body_of_too_many_nodes_is_refused(body: dict[str, Any]) -> None:
    with pytest.raises(
        BodyError,
        match=r"(?:1000 make|that is) 10+ nodes, but the limit is 100000; make it coarser, or raise most_nodes",
    ):
        prepare(Scenario.make(network=PAIR, body=body))


def test_the_limit_can_be_moved() -> None:
    assert lattice((3, 3), most_nodes=9).nodes == 9
    with pytest.raises(BodyError, match="3 x 3 make 9 nodes, but the limit is 8"):
        lattice((3, 3), most_nodes=8)
    with pytest.raises(BodyError, match="limit is 8"):
        Scenario.make(network=PAIR, body={"kind": "chain", "nodes": 9, "most_nodes": 8}).build_body()
    assert np.array_equal(chain(3).rest, lattice((3,)).rest)
