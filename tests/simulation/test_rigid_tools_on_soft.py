"""Tools that are rigid bodies on bodies that yield: known answers, both engines, and what is refused."""

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from cotouch.errors import CotouchError
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch, run_peers, simulate

Float = npt.NDArray[np.float64]
ALONE = {"users": ["Ann"], "spring": [[0]], "delay": [[0]]}
PAIR = {"users": ["Ann", "Ben"], "spring": [[0, 20], [20, 0]], "delay": [[0, 0.01], [0.01, 0]]}
# A block of 4 x 4 x 2 cubes; a cube gives a quarter of the stiffness to each edge, so a column of it has all of it.
SPRING, COLUMNS, HIGH, SIDE = 400.0, 16, 2, 0.01
BLOCK: dict[str, Any] = {
    "kind": "lattice",
    "shape": [5, 5, 3],
    "spacing": SIDE,
    "model": "cells",
    "mass": 0.1,
    "stiffness": SPRING,
    "damping": 0.8,
    "ground": "z-",
    "ground_stiffness": 1e6,
}
FIRM = 1e7
PLATE: dict[str, Any] = {"user": 1, "kind": "box", "size": [0.08, 0.08, 0.02], "mass": 0.05, "resolution": 1}
MIDDLE = [2.0 * SIDE, 2.0 * SIDE, HIGH * SIDE + 0.01005]
GAP = 5e-5


def scene(hand: dict[str, Any], tool: dict[str, Any] = PLATE, **tables: Any) -> Scenario:
    """The block, and a plate just above it."""
    held = {"stiffness": 1000, "damping": 8, "turning_stiffness": 20.0, **hand}
    given: dict[str, Any] = {
        "network": ALONE,
        "body": BLOCK,
        "between": {"stiffness": FIRM, "damping": 20.0},
        "tools": [{"at": MIDDLE, **tool, "hand": held}],
        "steps": {"duration": 0.2},
        "record": {"nodes": "all"},
    }
    return Scenario.make(**(given | tables))


def pressed(deep: float, *more: list[float]) -> list[list[float]]:
    """A path that goes down, and on to waypoints after that."""
    return [[0, *[0.0] * 6], [0.05, 0, 0, -deep, 0, 0, 0], *more]


def reactions(run: Any) -> tuple[Float, Float]:
    """Where the ground holds the block, and with which force, at the end."""
    place = run["position"].values[0]
    bottom = np.arange(0, 75, HIGH + 1)
    return place[-1, bottom], -1e6 * (place[-1, bottom] - place[0, bottom])


@pytest.mark.parametrize("deep", [0.0018, 0.0021])
def test_what_hardly_turns_is_not_closed_by_its_turning(deep: float) -> None:
    run = simulate(scene({"path": pressed(deep)}))
    assert run["closure_factor"].values[0, -1] < 1e-3


def test_pressed_evenly_it_is_as_stiff_as_hand_skin_and_block_in_series() -> None:
    run = simulate(scene({"path": pressed(0.002)}))
    block, skin = SPRING * COLUMNS / HIGH, FIRM * COLUMNS * SIDE**2
    force = run["rigid_force"].values[0, -1]
    assert -force[2] == pytest.approx((0.002 - GAP) / (1 / 1000 + 1 / block + 1 / skin), rel=3e-3)
    # By the contact law: the pressure of its depth on the block's top, each node with the skin that is its own.
    top = run["position"].values[0, -1, HIGH :: HIGH + 1]
    bottom = run["rigid_position"].values[0, -1, 2] - 0.01
    side = np.array([0.5, 1.0, 1.0, 1.0, 0.5]) * SIDE
    law = FIRM * np.sum(np.outer(side, side).ravel() * (top[:, 2] - bottom))
    assert -force[2] == pytest.approx(law, rel=0.01)
    # And it is felt just so: action is reaction, nothing turns, and all is as symmetric as a skin's triangles can be.
    assert run["rigid_contact_force"].values[0, -1] == pytest.approx(-force, abs=1e-4)
    _, held = reactions(run)
    assert held.sum(axis=0) == pytest.approx(-force, abs=1e-4)
    assert np.abs(run["rigid_torque"].values[0]).max() < 1e-4 * -force[2] * 2 * SIDE
    assert np.abs(force[:2]).max() < 1e-4 * -force[2]
    moved = (run["position"].values[0, -1] - run["position"].values[0, 0]).reshape(5, 5, 3, 3)
    assert np.flip(moved, (0, 1)) * [-1.0, -1.0, 1.0] == pytest.approx(moved, abs=1e-3 * float(np.abs(moved).max()))
    assert run.attrs["energy_residual"] <= 1e-12
    assert run["closure_factor"].values[0, -1] < 1e-3


def test_held_beside_the_middle_its_torque_is_lever_times_force() -> None:
    lever = 0.015
    run = simulate(scene({"path": pressed(0.002)}, {**PLATE, "handle": [-lever, 0, 0]}))
    force, torque = run["rigid_force"].values[0, -1], run["rigid_torque"].values[0, -1]
    place, held = reactions(run)
    centre = (place[:, 0] * held[:, 2]).sum() / held[:, 2].sum()  # of pressure, by what the ground does
    handle = run["rigid_position"].values[0, -1, 0]
    assert centre - handle == pytest.approx(lever, abs=1e-3)
    about = np.cross(place - run["rigid_position"].values[0, -1], held).sum(axis=0)
    assert torque[1] == pytest.approx(-about[1], rel=1e-3)
    assert torque[1] == pytest.approx(-lever * force[2], rel=0.03)
    assert torque[1] > 0.015
    assert torque[1] == pytest.approx(20.0 * np.sin(-run["rigid_rotation"].values[0, -1, 1]), rel=1e-3)
    assert np.abs(torque[[0, 2]]).max() < 1e-4 * torque[1]
    assert run.attrs["energy_residual"] <= 1e-12


def test_turned_it_is_felt_to_grip_and_then_to_rub() -> None:
    """Below the cone the block turns with it; beyond, the torque is that of friction on the whole of its top."""
    friction, deep = 0.3, 0.002
    path = pressed(
        deep,
        [0.1, 0, 0, -deep, 0, 0, 0],
        [0.12, 0, 0, -deep, 0, 0, 0.005],
        [0.14, 0, 0, -deep, 0, 0, 0.005],
        [0.25, 0, 0, -deep, 0, 0, 0.4],
    )
    run = simulate(
        scene(
            {"path": path},
            between={"stiffness": FIRM, "damping": 2.0, "friction": friction},
            steps={"duration": 0.25},
        )
    )
    force, torque = run["rigid_force"].values[0], run["rigid_torque"].values[0, :, 2]
    place, held = reactions(run)
    arm = place - run["rigid_position"].values[0, -1]
    reaction = (arm[:, 0] * held[:, 1] - arm[:, 1] * held[:, 0]).sum()
    assert torque[-1] == pytest.approx(-reaction, rel=0.02)
    side = np.array([0.5, 1.0, 1.0, 1.0, 0.5])
    x, y = np.meshgrid(*2 * [np.array([-1.95, -1.0, 0.0, 1.0, 1.95]) * SIDE])  # points lie a little within their sides
    mean = np.sum(np.outer(side, side) * np.hypot(x, y)) / COLUMNS
    assert torque[-1] == pytest.approx(-friction * force[-1, 2] * mean, rel=0.03)
    turned = run["rigid_rotation"].values[0, :, 2]
    corner = run["position"].values[0, :, HIGH]
    about = corner[0] - np.array(MIDDLE)
    follows = (about[0] * (corner[:, 1] - corner[0, 1]) - about[1] * (corner[:, 0] - corner[0, 0])) / (
        about[:2] @ about[:2]
    )
    grips = int(np.searchsorted(run["time"].values[0], 0.139))
    assert 0.6 * turned[grips] < follows[grips] < turned[grips]
    assert follows[-1] < 0.1 * turned[-1]
    assert run.attrs["energy_residual"] <= 1e-12


def test_nothing_passes_though_more_triangles_are_near_than_there_is_room_for() -> None:
    """A small ball, thrown down at 10 m/s: all triangles of the plate are within reach of all of its points."""
    ball = {"user": 1, "kind": "sphere", "radius": 0.003, "resolution": 3, "mass": 0.005}
    hand = {"path": [[0, *[0.0] * 6], [0.018, 0, 0, -0.18, 0, 0, 0]], "stiffness": 3000, "damping": 20}
    run = simulate(
        scene(
            {**hand, "turning_stiffness": 0.5},
            {**ball, "at": [0.023, 0.021, SIDE + 0.007]},
            body={**BLOCK, "shape": [5, 5, 2], "stiffness": 800, "damping": 0.5, "ground": "x-"},
            between={"stiffness": FIRM, "damping": 1.0, "friction": 0.3},
            steps={"duration": 0.008},
        )
    )
    plate = run["position"].values[0, :, :, 2]
    assert (run["rigid_position"].values[0, :, 2] > plate.min(axis=1)).all()


def test_both_engines_turn_it_alike_and_another_copy_follows() -> None:
    """Ann turns the top by friction; Ben's copy of the block follows, without her plate."""
    path = pressed(0.003, [0.15, 0, 0, -0.003, 0, 0, 0.4])
    held = {"user": 2, "node": 3, "path": [0, 0, 0.002], "stiffness": 100}
    ready = prepare(
        scene(
            {"path": path},
            {**PLATE, "size": [0.05, 0.05, 0.02]},
            network=PAIR,
            hands=[held],
            between={"friction": 0.8, "damping": 20.0},
            steps={"duration": 0.15},
        )
    )
    batch, peers = run_batch(ready), run_peers(ready)
    assert np.array_equal(batch.position, np.stack([places[-1] for places in peers.position]))
    assert max(abs(report.residual) for reports in peers.reports for report in reports) <= 1e-15
    ledger = batch.record.ticks
    assert np.abs(ledger[4]).max() <= 1e-13 * np.abs(ledger[:4]).max()
    ends = np.stack([ready.model.to_nodes(copy) for copy in batch.position])
    assert np.abs(ends[1, 75:]).max() < 1e-10  # not in Ben's copy, but for what rounding closes
    turned = ends[:, 3 * 5 * 2 + HIGH, 0] - ends[:, 3 * 5 * 2 + 3 * 4 + HIGH, 0]  # of the top's edges
    assert abs(turned[0]) > 5e-4
    assert turned[1] == pytest.approx(turned[0], rel=0.3)
    assert ends[1, 2, 2] - ends[1, 74, 2] > 1e-4  # Ben's hand holds a node, though a tool is held at points


def test_what_nothing_holds_is_pushed_with_what_is_felt(tmp_path: Path) -> None:
    """A free block gets the momentum that the tool, a mesh, gives."""
    corners = [[x, y, z] for x in (0, 8) for y in (0, 40) for z in (0, 20)]
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
             [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]  # fmt: skip
    lines = [*(f"v {x} {y} {z}" for x, y, z in corners), *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces)]
    (tmp_path / "bar.obj").write_text("\n".join(lines), encoding="utf-8")
    tool = {"user": 1, "file": str(tmp_path / "bar.obj"), "unit": "mm", "mass": 0.03, "at": [-0.0045, 0.02, 0.01]}
    push = {"path": [[0, *[0.0] * 6], [0.1, 0.03, 0, 0, 0, 0, 0]], "stiffness": 300, "damping": 3}
    free = {**BLOCK, "ground": "none", "ground_stiffness": 0.0, "damping": 0.2}
    run = simulate(scene(push, tool, body=free, between={"stiffness": 1e6, "damping": 2.0}, steps={"duration": 0.15}))
    speed = run["velocity"].values[0].mean(axis=1)
    pushed = 0.1 * np.diff(speed, axis=0) / run["period"].values[0, 1:, None]
    assert np.abs(pushed).max() > 0.5
    assert np.abs(pushed + run["rigid_contact_force"].values[0, 1:]).max() <= 1e-10
    assert speed[-1, 0] > 0.1
    assert run.attrs["energy_residual"] <= 1e-12


WRONG: list[tuple[dict[str, Any], str]] = [
    ({"tools": [{**PLATE, "at": [0, 0, 1 + k]} for k in range(13)]}, "tools[1] is one of 13 rigid bodies"),
    ({"tools": [{**PLATE, "at": [*MIDDLE[:2], 0.022]}]}, 'tools[1]: it begins 0.008 m deep in "body"'),
    ({"hands": [{"user": 1, "node": 76}], "tools": [{**PLATE, "at": MIDDLE}]}, "the body has nodes 1 to 75"),
]


@pytest.mark.parametrize(("tables", "said"), WRONG)
def test_what_is_wrong_is_one_sentence(tables: dict[str, Any], said: str) -> None:
    with pytest.raises(CotouchError) as caught:
        prepare(scene({}, **tables))
    assert said in str(caught.value)
