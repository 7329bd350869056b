"""Bodies that turn, bend and weigh in a scenario: both engines, ledgers, tools, and what is said of wrong input."""

from typing import Any

import numpy as np
import pytest
from tests.laws.scenes import AS_LAW

from cotouch.errors import CotouchError
from cotouch.mechanics import CLOSURE_ALARM
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch, run_peers, simulate

PAIR: dict[str, Any] = {"users": ["Ann", "Ben"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.02], [0.03, 0]]}
BLOCK: dict[str, Any] = {
    "kind": "lattice",
    "shape": [4, 3, 3],
    "spacing": 0.01,
    "mass": 0.05,
    "stiffness": 100.0,
    "damping": 0.02,
    "model": "cells",
}
HELD: dict[str, Any] = {**BLOCK, "ground": "x-", "ground_stiffness": 200.0}
PULL = {"user": 1, "node": 36, "path": [[0.0, 0.0, 0.0, 0.0], [0.1, 0.02, 0.0, 0.01]], "stiffness": 200.0}
POKE = {
    "user": 2,
    "at": [0.03, 0.01, 0.031],
    "radius": 0.01,
    "stiffness": 1000.0,
    "hand": {"path": [[0.0, 0.0, 0.0, 0.0], [0.1, 0.0, 0.0, -0.015]], "stiffness": 200.0},
}


def test_both_engines_move_a_material_alike_and_balance_it() -> None:
    prepared = prepare(Scenario.make(body=HELD, network=PAIR, steps={"duration": 0.3}, hands=[PULL]))
    outcome, peers = run_batch(prepared), run_peers(prepared)
    for user in range(2):
        np.testing.assert_array_equal(peers.position[user][-1], outcome.position[user])
        reports = peers.reports[user]
        assert max(abs(report.residual) for report in reports) <= 1e-14 * outcome.record.ticks[:4].max()
        assert max(report.closure_factor for report in reports) == outcome.record.running[user, -2]
        assert sum(report.closure for report in reports) == pytest.approx(outcome.record.running[user, -3])
    assert np.abs(outcome.record.ticks[4]).max() <= 1e-12 * outcome.record.ticks[:4].max()
    assert np.abs(outcome.position).max() > 5e-3


def test_both_engines_count_the_steps_that_were_closed_by_much() -> None:
    yanked = PULL | {"path": [[0.0, 0.0, 0.0, 0.0], [0.1, 0.3, 0.0, 0.3]], "stiffness": 5000.0}
    tables = {"body": HELD, "network": PAIR, "steps": {"duration": 0.4, "period": 0.04}, "hands": [yanked]}
    run, peers = simulate(tables), run_peers(prepare(Scenario.make(**tables)))
    only_shortened = peers.reports[0][1]
    assert only_shortened.shortened > 0.0
    assert only_shortened.closure_factor <= CLOSURE_ALARM
    for user, reports in enumerate(peers.reports):
        much = [report.closure_factor > CLOSURE_ALARM or report.shortened > 0.0 for report in reports]
        assert np.array_equal(run["closure_alarms"].values[user, 1:], np.cumsum(much))
        assert 0 < np.count_nonzero(much) < len(much)


def test_a_run_says_what_its_closure_did() -> None:
    run = simulate({"body": HELD, "network": PAIR, "steps": {"duration": 0.2}, "hands": [PULL]})
    assert run.attrs["energy_residual"] <= 1e-12
    assert run.attrs["passivity_margin"] >= -1e-12 * run.attrs["energy_in_play"]
    assert 0.0 < float(run["closure_factor"][0, -1]) < 1e-3
    assert float(run["closure_alarms"].max()) == 0.0
    assert float(np.abs(run["closure"]).max()) > 0.0
    assert "cut" not in run
    assert "closure" not in simulate({"network": PAIR, "steps": {"duration": 0.01}})


def test_a_tool_touches_a_body_that_turns() -> None:
    run = simulate({"body": HELD, "network": PAIR, "steps": {"duration": 0.3}, "tools": [POKE]})
    assert run.attrs["finished"]
    assert run.attrs["energy_residual"] <= 1e-12
    assert float(np.abs(run["touch_force"]).max()) > 0.05
    assert float(run["closure_factor"].max()) < 0.05


def test_damping_by_the_rule_makes_it_passive_and_without_it_is_not() -> None:
    """Two free copies that fly apart, 20 and 30 ms away from each other: none gives more than it had."""
    made = {"body": {**BLOCK, "damping": 0.0}, "steps": {"duration": 1.5}}
    apart = {"velocity": [[0.1, 0.2, 0.0], [0.0, -0.2, 0.1]]}
    stiff = {**PAIR, "spring": [[0, 200], [200, 0]]}
    ruled, bare = (
        simulate({**made, "network": stiff, "initial": apart, "synchronisation": {"law": AS_LAW.name, **given}})
        for given in ({}, {"damping": 0.0})
    )
    assert float(ruled["stored"].max()) <= float(ruled["stored"][0]) * (1.0 + 1e-12)
    assert float(bare["stored"].max()) > 2.0 * float(bare["stored"][0])
    for run in (ruled, bare):
        assert run.attrs["energy_residual"] <= 1e-12


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ({"model": "cells", "neighbours": 26}, 'model "cells" needs at least 2 nodes along each of 3 axes'),
        ({"model": "cells", "shape": [5]}, 'model "cells" needs at least 2 nodes along each of 3 axes'),
        ({"model": "spring-network"}, "needs 18 or 26, or nothing resists shear"),
        ({"model": "cells", "frame": "floating"}, 'model "cells" turns by itself; leave frame out'),
        ({"model": "cells", "stiffness": 0}, 'stiffness is 0; model "cells" needs more than 0 N/m'),
        ({"model": "jelly"}, "model is 'jelly'"),
        ({"model": "springs", "shape": [5], "frame": "floating"}, 'model is "floating", but the body has one axis'),
    ],
)
def test_a_wrong_material_is_one_sentence(table: dict[str, Any], said: str) -> None:
    with pytest.raises(CotouchError) as caught:
        prepare(Scenario.make(body={**BLOCK, **table}, network=PAIR, steps={"duration": 0.1}))
    assert said in str(caught.value)


def test_modes_are_for_linear_bodies() -> None:
    with pytest.raises(CotouchError, match='basis is "modal", but model is "cells"'):
        prepare(Scenario.make(body=BLOCK, network=PAIR, steps={"duration": 0.1}, solver={"basis": "modal"}))
