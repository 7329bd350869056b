"""Contact laws in a scenario: both engines, ledgers, and what is said of wrong input."""

from typing import Any

import numpy as np
import pytest

from cotouch.errors import CotouchError
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch, run_peers

PAIR: dict[str, Any] = {"users": ["Ann", "Ben"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.02], [0.03, 0]]}
BLOCK: dict[str, Any] = {
    "kind": "lattice",
    "shape": [4, 3, 3],
    "spacing": 0.01,
    "mass": 0.05,
    "stiffness": 100.0,
    "damping": 0.02,
    "ground": "x-",
    "ground_stiffness": 200.0,
}
POKE: dict[str, Any] = {
    "user": 2,
    "at": [0.03, 0.01, 0.031],
    "radius": 0.01,
    "friction": 0.5,
    "kinetic_friction": 0.4,
    "damping": 0.5,
    "hand": {"path": [[0.0, 0.0, 0.0, 0.0], [0.1, 0.0, 0.0, -0.015], [0.2, -0.01, 0.0, -0.015]], "stiffness": 200.0},
}
LINEAR = {"body": BLOCK, "solver": {"basis": "nodal"}}
TURNING = {"body": {**BLOCK, "model": "cells"}, "world": {"gravity": [0.0, 0.0, -2.0]}}


@pytest.mark.parametrize("body", [LINEAR, TURNING], ids=["linear", "turning and heavy"])
def test_both_engines_touch_alike_and_balance_it(body: dict[str, Any]) -> None:
    """Users with delays; friction and a film on the skin; the ledger of every step and of the run."""
    film = {"viscosity": 2e3}
    scenario = Scenario.make(network=PAIR, steps={"duration": 0.4}, tools=[POKE], contact=film, **body)
    prepared = prepare(scenario)
    outcome, peers = run_batch(prepared), run_peers(prepared)
    largest = float(outcome.record.ticks[:4].max())
    for user in range(2):
        np.testing.assert_array_equal(peers.position[user][-1], outcome.position[user])
        assert max(abs(report.residual) for report in peers.reports[user]) <= 1e-14 * largest
    assert np.abs(outcome.record.ticks[4]).max() <= 1e-12 * largest
    assert outcome.tools is not None
    assert np.abs(outcome.tools.force).max() > 0.1
    assert peers.reports[1][-1].touch_loss >= 0.0
    np.testing.assert_array_equal(np.ravel(peers.tools[1][-1]), outcome.tools.place[0, -1, :3])


@pytest.mark.parametrize(
    ("contact", "tool", "said"),
    [
        ({"law": "glue"}, {}, 'contact.law is "glue"; it must be one of foundation, stiffening'),
        ({"viscosity": -1.0}, {}, "contact.viscosity is -1"),
        ({"law": "stiffening", "parameters": {"hardness": 0.0}}, {}, "contact.parameters.hardness is 0"),
        ({"law": "stiffening", "parameters": {"softness": 1.0}}, {}, 'law "stiffening" has hardness, each above 0'),
        ({"law": "stiffening"}, {"kinetic_friction": 0.6}, "what slips is not held more firmly"),
        (
            {},
            {"kind": "grasp", "friction": 0.0, "kinetic_friction": None, "axis": [0.0, 0.0, 0.01]},
            "axis is [0.0, 0.0, 0.01], but a grasp holds what is near its middle",
        ),
    ],
)
def test_wrong_contact_is_one_sentence(contact: dict[str, Any], tool: dict[str, Any], said: str) -> None:
    with pytest.raises(CotouchError) as caught:
        prepare(
            Scenario.make(body=BLOCK, network=PAIR, steps={"duration": 0.1}, tools=[{**POKE, **tool}], contact=contact)
        )
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_body_without_a_skin_is_held_and_not_touched() -> None:
    body = {**BLOCK, "shape": [4, 1, 1]}
    with pytest.raises(CotouchError, match=r'tools\[1\].kind is "touch", which needs a skin'):
        prepare(Scenario.make(body=body, network=PAIR, steps={"duration": 0.1}, tools=[POKE]))
    hold = {"user": 1, "kind": "grasp", "at": [0.03, 0.0, 0.0], "hand": {"path": [0.0, 0.0, 0.02]}}
    outcome = run_batch(prepare(Scenario.make(body=body, network=PAIR, steps={"duration": 0.2}, tools=[hold])))
    assert outcome.position[0][3, 2] > 1e-3


def test_a_sheet_is_felt_alike_from_both_sides() -> None:
    sheet = {**BLOCK, "shape": [4, 5, 1], "ground": "all"}
    forces = []
    for side in (1.0, -1.0):
        tool = {
            "user": 1,
            "at": [0.016, 0.018, 0.0101 * side],
            "hand": {"path": [[0.0, 0.0, 0.0, 0.0], [0.2, 0.0, 0.0, -0.008 * side]], "stiffness": 300.0},
        }
        scenario = Scenario.make(body=sheet, network=PAIR, steps={"duration": 0.3}, tools=[tool])
        outcome = run_batch(prepare(scenario))
        assert outcome.tools is not None
        forces.append(outcome.tools.force[0, :, 2])
        assert side * outcome.tools.place[0, -1, 2] > 0.0
    assert forces[0].max() > 0.1
    np.testing.assert_allclose(forces[0], -forces[1], rtol=1e-9, atol=1e-12)
