"""Balls and grasps beside tools that are rigid bodies: both engines to the same numbers, and who meets whom."""

from typing import Any

import numpy as np
import pytest
from tests.simulation.test_rigid_tools_on_soft import MIDDLE, PAIR, PLATE, SIDE, pressed, scene

from cotouch.errors import ScenarioError
from cotouch.simulation import animation, dataset, prepare, run_batch, run_peers

TURNS = pressed(0.002, [0.15, 0.002, 0, -0.002, 0, 0, 0.3])
HELD = {"stiffness": 1000, "damping": 8, "turning_stiffness": 20.0, "path": TURNS}
LED = {**PLATE, "at": MIDDLE, "hand": HELD, "device": {"preset": "omega"}}
BALL: dict[str, Any] = {"radius": 0.008, "friction": 0.5, "damping": 0.5}
# Above the block, where only Ann has her plate.
ABOVE = [2.0 * SIDE, 2.0 * SIDE, 0.06]


def led(*path: list[float], **more: Any) -> dict[str, Any]:
    """What moves a ball or a grasp."""
    return {"path": [[0, 0, 0, 0], *path], "stiffness": 300, "damping": 5, **more}


def side_by_side(tools: list[dict[str, Any]], **tables: Any) -> tuple[Any, Any, Any]:
    """A run by both engines, whose motions are the same to the last bit; its variables, the run and what was run."""
    rubs = {"stiffness": 1e7, "damping": 20.0, "friction": 0.5}
    law = {"law": "paid"}  # feels what tools of all kinds do
    made = scene({}, tools=tools, **({"network": PAIR, "between": rubs, "synchronisation": law} | tables))
    prepared = prepare(made)
    batch, peers = run_batch(prepared), run_peers(prepared)
    for user in range(2):
        assert np.array_equal(peers.position[user][-1], batch.position[user])
        assert np.array_equal(peers.velocity[user][-1], batch.velocity[user])
    assert batch.tools is not None
    told = np.concatenate([places[-1] for places in peers.tools if places.size])
    assert np.array_equal(told, batch.tools.place[:, -1, :3])
    run = dataset(prepared, batch)
    assert run.attrs["energy_residual"] <= 1e-12
    assert run.attrs["passivity_margin"] >= 0.0
    return run, batch, prepared


def test_a_plate_a_ball_and_a_grasp_hold_one_block() -> None:
    """Ann's plate, led by a device, presses and turns; her grasp pulls a corner; Ben's ball with a device pushes."""
    pushes = {"user": 2, "at": [0.055, 0.02, 0.01], **BALL, "device": {"preset": "omega"}}
    holds = {"user": 1, "kind": "grasp", "at": [0.0, 0.0, 0.02], "radius": 0.011, "stiffness": 100, "damping": 0.5}
    tools = [pushes | {"hand": led([0.1, -0.012, 0, 0])}, LED, holds | {"hand": led([0.1, -0.005, 0, 0])}]
    texture = {"pattern": "bumps", "wavelength": 0.004, "height": 2e-4}
    run, _, prepared = side_by_side(tools, record={"frames": 20}, contact={"texture": texture})
    assert run["touch_force"].values[0, -1, 0] > 0.2  # out of the block
    assert run["touching"].values[1, -1] == 4.0  # a corner, its neighbours, and none of what the plate is made of
    assert run["touch_force"].values[1, -1, 0] > 0.1
    assert -run["rigid_force"].values[0, -1, 2] > 0.5
    assert run["device_force"].dims[0] == "tool"
    assert np.abs(run["device_force"].values[0]).max() > 0.1
    assert np.isnan(run["device_force"].values[1]).all()
    assert run["rigid_device_force"].dims[0] == "rigid_tool"
    assert np.abs(run["rigid_device_force"].values).max() > 0.5
    assert run.attrs["device_residual"] < 1e-12
    for name in ("", "rigid_"):
        assert np.nanmax(run[f"{name}coupling_excess"].values) <= np.nanmax(run[f"{name}coupling_bound"].values)
    shown = animation(run, prepared.body)
    assert shown.tools is not None
    assert shown.ports is not None
    assert list(shown.tools.owner) == [1, 0]
    assert list(shown.ports.owner) == [0]
    assert shown.texture is not None
    assert '"texture": {"rows": 64,' in shown.page()
    assert [part.get("bare", False) for part in shown.parts] == [False, True]


def test_balls_and_grasps_meet_no_tool_of_another_user() -> None:
    """Ben's ball goes through where Ann's plate is to the block; his grasp there holds nodes of the block alone."""
    above = {**LED, "at": ABOVE, "hand": HELD | {"path": [0, 0, 0]}}
    ball = {"user": 2, "at": [0.02, 0.02, 0.058], **BALL, "hand": led([0.1, 0, 0, -0.032])}
    holds = {"user": 2, "kind": "grasp", "at": [0.04, 0.04, 0.06], "radius": 0.045, "stiffness": 10, "damping": 0.1}
    run, _, prepared = side_by_side([ball, above, holds])
    force, place = run["touch_force"].values[0], run["tool_position"].values[0]
    through = (place[:, 2] > 0.029) & (np.arange(place.shape[0]) > 0)
    assert place[0, 2] - 0.008 < ABOVE[2] + 0.01
    assert np.count_nonzero(through) > 50
    assert np.all(force[through] == 0.0)
    assert force[-1, 2] > 0.3  # on the block
    near = np.linalg.norm(prepared.body.rest - holds["at"], axis=1) < holds["radius"]
    assert np.count_nonzero(near[prepared.body.shared :]) > 0  # masses of the plate
    assert run["touching"].values[1, -1] == np.count_nonzero(near[: prepared.body.shared]) == 6


def test_ones_own_ball_meets_ones_own_plate() -> None:
    """It presses the plate down on nothing: what pushes the ball up is what the plate's hand holds, and no link."""
    held = {"path": [0, 0, 0], "stiffness": 300, "damping": 8, "turning_stiffness": 20.0}
    above = {**LED, "at": ABOVE, "hand": held}
    ball = {"user": 1, "at": [0.02, 0.02, 0.0785], **BALL, "hand": led([0.1, 0, 0, -0.004])}
    run, batch, _ = side_by_side([ball, above], steps={"duration": 0.5})
    up = run["touch_force"].values[0, -1, 2]
    assert up > 0.1
    assert run["rigid_force"].values[0, -1] == pytest.approx([0.0, 0.0, up], rel=0.02, abs=1e-3)
    # The law is told what tools do to the block, and of the plate links do not know.
    assert batch.ends is not None
    assert not batch.ends.touch.any()


def test_a_ball_starts_outside_of_what_is_in_its_users_copy() -> None:
    """The sentence names the table by its place in the file."""
    within = {"user": 1, "at": ABOVE, **BALL}
    above = {"at": ABOVE, **PLATE, "hand": HELD}
    with pytest.raises(ScenarioError, match=r"tools\[2\].at is .*; a tool that touches starts outside"):
        prepare(scene({}, tools=[above, within], network=PAIR))
    prepare(scene({}, tools=[above, within | {"user": 2}], network=PAIR))


def test_a_ball_that_waits_changes_nothing() -> None:
    """While no ball or grasp acts, a copy takes the step that it would without them, to the last bit."""
    waits = {"user": 1, "at": [0.02, 0.02, 0.2], **BALL, "begin": 9.0}
    _, beside, _ = side_by_side([LED, waits])
    rubs = {"stiffness": 1e7, "damping": 20.0, "friction": 0.5}
    alone = run_batch(prepare(scene({}, tools=[LED], network=PAIR, between=rubs, synchronisation={"law": "paid"})))
    assert np.array_equal(beside.position, alone.position)


def test_a_texture_is_on_what_is_shared() -> None:
    texture = {"pattern": "bumps", "wavelength": 0.004, "height": 0.0002}
    outside = {"user": 1, "at": [0.02, 0.02, 0.2], **BALL}
    prepared = prepare(scene({}, tools=[LED, outside], network=PAIR, contact={"texture": texture}))
    assert prepared.touching is not None
    surface = prepared.touching.surface
    relief, tools = surface.relief, surface.tools()
    highest = np.maximum.reduceat(relief.height, relief.first)
    assert np.count_nonzero(tools) == 12
    assert np.all(highest[tools] == 0.0)
    assert np.all(highest[~tools] > 0.0001)
