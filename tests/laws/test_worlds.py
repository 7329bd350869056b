"""Every law in both worlds: the batch engine and single peers call the same two functions."""

import numpy as np
import pytest
from tests.laws.scenes import AS_LAW, OTHERS, ROUGH, rough, two

from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch, run_peers


@pytest.mark.parametrize("body", [False, True])
@pytest.mark.parametrize("mode", ["constant", "self-paced", "freshest"])
def test_spring_as_a_law_is_the_spring_to_the_bit(mode: str, body: bool) -> None:
    built_in, law = (run_batch(prepare(rough(name, mode=mode, body=body))) for name in ("spring", AS_LAW.name))
    assert np.array_equal(built_in.position, law.position)
    for i, n in enumerate(built_in.taken):
        assert np.array_equal(built_in.record.position[i, : n + 1], law.record.position[i, : n + 1])
        assert np.array_equal(built_in.record.users[:, i, : n + 1], law.record.users[:, i, : n + 1])
    assert np.array_equal(built_in.record.made, law.record.made)


@pytest.mark.parametrize("law", [AS_LAW.name, *OTHERS])
@pytest.mark.parametrize("body", [False, True])
def test_peers_move_as_the_batch_does(law: str, body: bool) -> None:
    prepared = prepare(rough(law, body=body))
    batch, peers = run_batch(prepared), run_peers(prepared)
    for i, n in enumerate(prepared.schedule.count):
        assert peers.position[i].shape[0] == n + 1
        assert np.array_equal(peers.position[i][-1], batch.position[i])
        worst = max(abs(report.residual) for report in peers.reports[i])
        assert worst <= 1e-12 * max(1.0, *(report.kinetic + report.elastic for report in peers.reports[i]))


@pytest.mark.parametrize("law", [AS_LAW.name, *OTHERS])
@pytest.mark.parametrize("mode", ["constant", "self-paced", "freshest"])
def test_books_balance_whatever_a_law_does(law: str, mode: str) -> None:
    outcome = run_batch(prepare(rough(law, mode=mode, body=True)))
    ticks = outcome.record.ticks
    assert np.abs(ticks[4]).max() <= 1e-12 * np.abs(ticks[:4]).max()


@pytest.mark.parametrize("nodes", [1, 3])
@pytest.mark.parametrize("law", OTHERS)
def test_a_body_with_three_axes_moves_along_one_as_one_with_that_axis_alone(law: str, nodes: int) -> None:
    """Laws take four numbers of three axes at a time, and what is left over of one axis one by one."""
    places: list[np.ndarray] = []
    for axes in (1, 3):
        scenario = Scenario.make(
            network=two(0.02, 50.0),
            body={"kind": "chain", "nodes": nodes, "dimension": axes},
            synchronisation={"mode": "freshest", "law": law},
            channel=ROUGH,
            steps={"duration": 1.5, "period": 0.004},
            hands=[
                {"user": 1, "node": 1, "stiffness": 200.0, "damping": 1.0, "path": [0.05] + [0.0] * (axes - 1)},
                {"user": 2, "node": nodes, "kind": "force", "path": [0.3] + [0.0] * (axes - 1), "release": 1.1},
            ],
        )
        places.append(run_batch(prepare(scenario)).position[..., 0])
    assert np.abs(places[0]).max() > 0.01
    np.testing.assert_allclose(places[1], places[0], atol=1e-11)
