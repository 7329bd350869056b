"""Blades, and elements that tear, beside a tool that is a rigid body: both engines to the same numbers."""

from typing import Any

import numpy as np
import pytest
from tests.simulation.test_rigid_tools_on_soft import MIDDLE, PAIR, PLATE, pressed, scene

from cotouch.body import Body, cut_skin
from cotouch.simulation import animation, dataset, prepare, run_batch, run_peers

TOUGHNESS, SIDE = 2.0, 0.01
HELD = {
    "stiffness": 1000,
    "damping": 8,
    "turning_stiffness": 20.0,
    "path": pressed(0.004, [0.15, 0.004, 0, -0.004, 0, 0, 0.3]),
}
PRESSES: dict[str, Any] = {"at": MIDDLE, **PLATE, "hand": HELD}
OMEGA = {"device": {"preset": "omega", "rate": 437}}
BLADE: dict[str, Any] = {
    "user": 2,
    "kind": "blade",
    "at": [0.025, -0.01, -0.005],
    "axis": [0, 0, 0.04],
    "thickness": 0.001,
    "hand": {"path": [[0.05, 0, 0, 0], [0.15, 0, 0.06, 0]], "stiffness": 500, "damping": 20},
}


def ran(tools: list[dict[str, Any]], cutting: dict[str, Any]) -> tuple[Any, Body]:
    """A run by both engines, whose motions are the same to the last bit; its variables, and the body."""
    rubs = {"stiffness": 1e7, "damping": 20.0, "friction": 0.5}
    made = scene({"path": []}, tools=tools, network=PAIR, cutting=cutting, between=rubs, record={"frames": 20})
    prepared = prepare(made)
    batch, peers = run_batch(prepared), run_peers(prepared)
    for user in range(2):
        assert np.array_equal(peers.position[user][-1], batch.position[user])
        assert np.array_equal(peers.velocity[user][-1], batch.velocity[user])
    if batch.tools is not None:
        assert np.array_equal(np.ravel(peers.tools[1][-1]), batch.tools.place[0, -1, :3])
    run = dataset(prepared, batch)
    assert run.attrs["energy_residual"] <= 1e-12
    assert run.attrs["passivity_margin"] >= 0.0
    assert run["cut"].values[:, -1].min() > 0.0
    assert np.array_equal(run["cut_time"].notnull().values[0], run["cut_time"].notnull().values[1])
    return run, prepared.body


@pytest.mark.parametrize(
    "device",
    [pytest.param({}, marks=pytest.mark.thorough, id="hand"), pytest.param(OMEGA, id="device")],
)
def test_a_blade_cuts_what_a_plate_presses(device: dict[str, Any]) -> None:
    run, built = ran([PRESSES | device, BLADE], {"toughness": TOUGHNESS, "users": [2]})
    assert run["cut_elements"].values[:, -1].tolist() == [8.0, 8.0]  # a row of four cubes, two high
    assert set(np.unique(run["cut_by"].values)) == {0, 2}
    paid = run["touch_loss"].values[1, -1]
    assert paid == pytest.approx(8 * TOUGHNESS * SIDE**2, rel=0.05)
    assert run["touch_loss"].values[0, -1] == 0.0
    assert run["tool_position"].values[0, -1] == pytest.approx([0.025, 0.05, -0.005], abs=1e-3)
    assert -run["rigid_force"].values[0, -1, 2] > 0.5  # the plate is felt
    shown = animation(run, built)
    assert shown.spans.shape[:2] == (2, cut_skin(built).skin.triangles.shape[0])
    assert np.count_nonzero(shown.spans[1, :, 1] == -np.inf) == 12  # of the plate, in Ben's copy
    assert not np.any(shown.spans[0, :, 1] == -np.inf)
    if device:
        assert run["rigid_device_force"].dims[0] == "rigid_tool"
        assert np.abs(run["rigid_device_force"].values).max() > 0.5


@pytest.mark.thorough
def test_a_pin_that_is_pressed_in_tears() -> None:
    """Who has the pin decides, the other follows."""
    pin = {"user": 1, "kind": "box", "size": [0.006, 0.006, 0.03], "mass": 0.05, "resolution": 1}
    hand = HELD | {"path": pressed(0.01, [0.15, 0.02, 0, -0.01, 0, 0, 0])}
    tool = pin | {"at": [0.02, 0.02, 0.03505], "hand": hand}
    run, _ = ran([tool], {"tear": 0.1, "users": [1]})
    assert run["cut_elements"].values[0, -1] > 1.0
    assert set(np.unique(run["cut_by"].values)) == {0, 1}
