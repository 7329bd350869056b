"""Tools that are rigid bodies: what their hands feel, what they do to bodies, both engines, and what is refused."""

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.laws.scenes import AS_LAW

from cotouch.errors import CotouchError
from cotouch.scenario import Scenario
from cotouch.simulation import animation, dataset, prepare, run_batch, run_peers, simulate, summary, tables

EXAMPLE = Path(__file__).parents[2] / "examples" / "turn-a-block.toml"
PAIR = {"users": ["Ann", "Ben"], "spring": [[0, 20], [20, 0]], "delay": [[0, 0.01], [0.01, 0]]}
DIE: dict[str, Any] = {"kind": "box", "size": [0.05, 0.05, 0.05], "mass": 0.1, "resolution": 1}
BAR: dict[str, Any] = {"user": 1, "kind": "box", "size": [0.1, 0.02, 0.02], "mass": 0.02, "resolution": 1}
TABLE: dict[str, Any] = {"gravity": [0, 0, -9.81], "planes": [{"friction": 0.5, "damping": 20.0}]}
HARD: dict[str, Any] = {"gravity": [0, 0, -9.81], "planes": [{"stiffness": 1e9, "damping": 2.0}]}


def scene(tool: dict[str, Any], **tables: Any) -> Scenario:
    """A die on a table, and one bar."""
    body = {**DIE, "centre": [0.0, 0.0, 0.025]}
    given: dict[str, Any] = {"network": PAIR, "body": body, "world": TABLE, "tools": [{**BAR, **tool}]}
    if "bodies" in tables:
        del given["body"]
    return Scenario.make(**(given | tables))


def write_box(path: Path, size: tuple[float, float, float]) -> None:
    """A box with a corner at the origin, as a mesh."""
    corners = [[x, y, z] for x in (0, size[0]) for y in (0, size[1]) for z in (0, size[2])]
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
             [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]  # fmt: skip
    lines = [*(f"v {x} {y} {z}" for x, y, z in corners), *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces)]
    path.write_text("\n".join(lines), encoding="utf-8")


@pytest.mark.parametrize("law", ["paid", AS_LAW.name])
def test_both_engines_move_it_alike_and_balance_it(law: str) -> None:
    """Ann turns the die by friction; Ben's copy of it follows, without her bar."""
    path = [[0, 0, 0, 0, 0, 0, 0], [0.05, 0, 0, -0.01, 0, 0, 0], [0.15, 0, 0, -0.01, 0, 0, 0.5]]
    tool = {"at": [0, 0, 0.0605], "hand": {"path": path, "stiffness": 500, "damping": 5, "turning_stiffness": 1.0}}
    ready = prepare(
        scene(
            tool,
            between={"friction": 0.8, "damping": 20.0},
            world={"gravity": [0, 0, -9.81], "planes": [{"friction": 0.1, "damping": 20.0}]},
            steps={"duration": 0.2},
            synchronisation={"law": law},
        )
    )
    batch, peers = run_batch(ready), run_peers(ready)
    assert np.array_equal(batch.position, np.stack([places[-1] for places in peers.position]))
    assert max(abs(report.residual) for reports in peers.reports for report in reports) <= 1e-15
    ledger = batch.record.ticks
    assert np.abs(ledger[4]).max() <= 1e-13 * np.abs(ledger[:4]).max()
    assert np.abs(batch.position[1, 4:]).max() < 1e-10  # not in Ben's copy, but for what rounding closes
    moved = np.abs(batch.position[:, :4, :2]).max(axis=(1, 2))
    assert moved[0] > 2e-3
    assert moved[1] > (0.2 if law == "paid" else 0.02) * moved[0]


def test_a_device_leads_its_handle_and_feels_what_presses_and_the_hand_turns_it() -> None:
    """Both engines alike; every joule is somewhere, and the coupling keeps its bound."""
    path = [[0, 0, 0, 0, 0, 0, 0], [0.05, 0, 0, -0.015, 0, 0, 0], [0.15, 0, 0, -0.015, 0, 0, 0.5]]
    hand = {"path": path, "stiffness": 500, "damping": 5, "turning_stiffness": 1.0}
    free = {**BAR, "user": 2, "at": [0, 0, 0.2]}
    led = {**BAR, "at": [0, 0, 0.0605], "handle": [0, 0, 0.005], "hand": hand, "device": {"preset": "omega"}}
    waits = {"user": 2, "at": [0, 0, 0.4], "radius": 0.01, "hand": {"path": [0, 0, 0], "stiffness": 300, "damping": 5}}
    ready = prepare(
        scene(
            {},
            tools=[free, led, waits],  # the ball, as other tests have one: else the engine would be another
            between={"friction": 0.8, "damping": 20.0},
            world={"gravity": [0, 0, -9.81], "planes": [{"friction": 0.1, "damping": 20.0}]},
            steps={"duration": 0.4},
            synchronisation={"law": "paid"},
        )
    )
    batch, peers = run_batch(ready), run_peers(ready)
    assert np.array_equal(batch.position, np.stack([places[-1] for places in peers.position]))
    assert max(abs(report.residual) for reports in peers.reports for report in reports) <= 1e-15
    run = dataset(ready, batch)
    assert run.attrs["energy_residual"] < 1e-12
    assert run.attrs["device_residual"] < 1e-12
    assert float(run["rigid_coupling_excess"][1].max()) <= float(run["rigid_coupling_bound"][1])
    assert bool(run["rigid_device_force"][0].isnull().all())
    place, device = run["rigid_position"].values[1], run["rigid_device_position"].values[1]
    force, felt = run["rigid_force"].values[1, -1], run["rigid_device_force"].values[1, -1]
    assert place[0] == pytest.approx(device[0], abs=1e-9)
    assert -0.015 < device[-1, 2] - device[0, 2] < -0.005
    assert force[2] < -1.0
    assert felt == pytest.approx(-force, rel=0.05, abs=0.02)
    assert run["rigid_rotation"].values[1, -1, 2] > 0.4
    assert np.abs(run["rigid_torque"].values[1, :, 2]).max() > 0.01  # which no device feels


def test_a_lever_is_felt_as_force_and_torque() -> None:
    """Pressed by its far edge on a table, a bar pushes back as the springs of place and turning in series say."""
    lever, k, turning, angle = 0.1, 400.0, 2.0, 0.05
    hand = {"path": [[0, *[0.0] * 6], [0.1, 0, 0, 0, 0, angle, 0]], "stiffness": k, "damping": 4}
    tool = {"at": [0.3, 0, 0.0101], "handle": [-lever / 2, 0, 0], "hand": {**hand, "turning_stiffness": turning}}
    push = {"user": 2, "at": [0, 0, 0.025], "kind": "force", "path": [0.1, 0.2, 0.0]}
    run = simulate(scene(tool, world=HARD, hands=[push], steps={"duration": 0.4}))
    assert run["hand_force"].values[0, -1] == pytest.approx([0.1, 0.2, 0.0])  # hands stay hands' beside tools
    force, torque = run["rigid_force"].values[0, -1], run["rigid_torque"].values[0, -1]
    turned = run["rigid_rotation"].values[0, -1]
    deep = lever * np.sin(angle) - 1e-4  # that the pose leads the edge below the table
    assert -force[2] == pytest.approx(deep / (1.0 / k + lever**2 / turning), rel=0.02)
    assert torque[1] == pytest.approx(-lever * force[2], rel=0.01)
    assert torque[1] == pytest.approx(turning * np.sin(angle - turned[1]), rel=1e-3)
    assert np.abs(np.delete(force, 2)).max() < 1e-8
    assert run["rigid_contact_force"].values[0, -1] == pytest.approx(-force, abs=1e-6)
    assert run["rigid_contact_torque"].values[0, -1] == pytest.approx(-torque, abs=1e-6)
    assert run.attrs["energy_residual"] <= 1e-12


def test_a_stylus_slides_across_an_edge_without_catching() -> None:
    """With points as far apart as it is thick it was pushed with 0.02 to 0.93 N on its way, and 0.2 N came at once."""
    tilt, slide, deep = 0.6, 0.02, 0.01
    into = np.array([-deep * np.sin(tilt), 0.0, -deep * np.cos(tilt)])
    there = into + np.array([slide, 0.0, -slide * np.tan(tilt)])
    path = [[0, *[0.0] * 6], [0.05, *into, 0, 0, 0], [0.3, *there, 0, 0, 0]]
    hand = {"path": path, "stiffness": 300, "damping": 3, "turning_stiffness": 1.0}
    stylus = {"user": 1, "kind": "cylinder", "radius": 0.006, "length": 0.12, "turn": [0, np.pi / 2 + tilt, 0]}
    block = {**DIE, "size": [0.06, 0.06, 0.06], "mass": 1.0, "resolution": 4, "centre": [0, 0, 0.03]}
    run = simulate(
        Scenario.make(
            network=PAIR,
            body=block,
            world=TABLE,
            between={"stiffness": 1e8, "friction": 0.2, "damping": 20.0},
            tools=[{**stylus, "mass": 0.02, "at": [0.0375, 0, 0.071], "hand": hand}],
            steps={"duration": 0.3},
        )
    )
    felt = np.linalg.norm(run["rigid_force"].values[0], axis=-1)
    on_the_way = felt[felt.size // 3 :]
    assert on_the_way.min() > 0.6 * on_the_way.max()
    assert np.abs(np.diff(on_the_way)).max() < 0.06
    assert run.attrs["energy_residual"] <= 1e-12


def test_a_bar_laid_flat_stays_flat_and_is_felt_to_want_to_turn() -> None:
    hand = {"path": [[0, *[0.0] * 6], [0.1, 0, 0, -0.0101, 0, 0.04, 0]], "stiffness": 800, "damping": 4}
    tool = {"at": [0.3, 0, 0.0101], "hand": {**hand, "turning_stiffness": 2.0}}
    world = {"gravity": [0, 0, -9.81], "planes": [{"stiffness": 1e7, "damping": 2.0}]}
    run = simulate(scene(tool, world=world, steps={"duration": 0.4}))
    turned = run["rigid_rotation"].values[0, -1]
    firm = 1e7 * 0.1 * 0.02  # of the table below the bar, all of it though there are two copies
    assert run["rigid_force"].values[0, -1] == pytest.approx([0, 0, -0.01 / (1 / 800 + 1 / firm)], rel=3e-3, abs=1e-6)
    assert run["rigid_torque"].values[0, -1] == pytest.approx([0, 2.0 * np.sin(0.04 - turned[1]), 0], abs=1e-4)
    assert 0.0 < turned[1] < 5e-3


@pytest.mark.parametrize(("friction", "missed"), [(0.0, 4e-4), (0.4, 2e-3)])
def test_what_it_does_is_what_is_done_to_it(friction: float, missed: float) -> None:
    """Of a free die: force to rounding; torque but for what rubs, as deep as skins lie, and what closes each body."""
    path = [[0, *[0.0] * 6], [0.2, 0.05, -0.02, 0.01, 0.2, 0, 0.6]]
    hand = {"path": path, "stiffness": 300, "damping": 3, "turning_stiffness": 1.0}
    tool = {"at": [-0.04, 0.015, 0], "turn": [0, 0, np.pi / 2], "mass": 0.05, "handle": [0, 0.03, 0], "hand": hand}
    run = simulate(
        scene(
            tool,
            body=DIE,
            network={"users": ["Ann"], "spring": [[0]], "delay": [[0]]},
            between={"friction": friction, "damping": 2.0},
            world={},
            steps={"duration": 0.2},
        )
    )
    place, rate = run["position"].values[0], run["velocity"].values[0]
    pushed = 0.025 * np.diff(rate, axis=0) / run["period"].values[0, 1:, None, None]
    handle = run["rigid_position"].values[0]
    about = 0.5 * (place[1:] + place[:-1]) - 0.5 * (handle[1:] + handle[:-1])[:, None]
    force, torque = pushed.sum(axis=1), np.cross(about, pushed).sum(axis=1)
    assert np.abs(force).max() > 1.0
    assert np.abs(force + run["rigid_contact_force"].values[0, 1:]).max() <= 1e-11
    left = np.abs(torque + run["rigid_contact_torque"].values[0, 1:]).max()
    assert left <= missed * np.abs(torque).max()
    assert run.attrs["energy_residual"] <= 1e-12


def test_a_pose_leads_a_free_tool_and_turns_it_more_than_once() -> None:
    """A hand that turns evenly by 7 rad takes a light ball along; the pose's torque is felt about the handle."""
    path = [[0, *[0.0] * 6], [0.3, 0.02, 0, 0.05, 0, 0, 7.0]]
    hand = {"path": path, "stiffness": 500, "damping": 5, "turning_stiffness": 0.5}
    tool = {"at": [0.3, 0, 0.1], "hand": hand}
    run = simulate(scene(tool, steps={"duration": 0.6}))
    assert run["rigid_position"].values[0, -1] == pytest.approx([0.32, 0, 0.15], abs=1e-4)
    assert run["rigid_rotation"].values[0, -1] == pytest.approx([0, 0, 7.0 - 2.0 * np.pi], abs=1e-3)
    assert run["rigid_spin"].values[0, 200] == pytest.approx([0, 0, 7.0 / 0.3], rel=0.02, abs=1e-6)
    assert np.abs(run["rigid_force"].values[0, -1]).max() < 1e-3
    assert np.abs(run["rigid_contact_force"].values[0, 1:]).max() < 1e-6  # force is mass times acceleration
    assert np.abs(run["rigid_contact_torque"].values[0, 1:]).max() < 1e-6


def test_the_example_turns_the_block_for_both_and_can_be_watched() -> None:
    scenario = Scenario.read(EXAMPLE).replace(record__frames=5.0)
    run = simulate(scenario)
    body = scenario.build_body()
    edge = run["position"].values[:, -1, 0] - run["position"].values[:, -1, 1]
    begun = run["position"].values[:, 0, 0] - run["position"].values[:, 0, 1]
    turned = np.arctan2(edge[:, 1], edge[:, 0]) - np.arctan2(begun[:, 1], begun[:, 0])
    assert np.degrees(turned) == pytest.approx([75, 75], abs=15)
    assert run.attrs["energy_residual"] <= 1e-12
    assert run.attrs["passivity_margin"] >= -1e-12 * run.attrs["energy_in_play"]
    table = tables(run)["rigid_tool_axis"]  # though there are no hands
    assert table.groupby("rigid_tool_user")["time"].max().to_dict() == pytest.approx({"Ann": 2.5, "Ben": 2.5})
    told = summary(run, body)
    assert [tool["user"] for tool in told["rigid_tools"]] == [1, 2]
    assert told["rigid_tools"][0]["peak_torque_nm"] == pytest.approx(
        np.linalg.norm(run["rigid_torque"].values[0], axis=-1).max()
    )
    assert told["discrepancy_m"]["max"] < 0.02  # bars, which are in one copy each, do not count
    film = animation(run, body)
    there = np.isposinf(film.spans[:, :, 1])
    triangles = np.cumsum([0, *(part.skin().triangles.shape[0] for part in body.parts)])
    shown = [[there[user, a:b].all() for a, b in pairwise(triangles)] for user in (0, 1)]
    assert shown == [[True, True, False], [True, False, True]]
    assert film.ports.place[-1, 0] == pytest.approx(run["rigid_position"].values[0, -1], abs=5e-3)


def test_a_mesh_that_stands_still_carries_it(tmp_path: Path) -> None:
    """A bar pressed flat on a mesh feels what it pushes with; of the other's copy and its links nothing."""
    write_box(tmp_path / "slab.obj", (200, 200, 20))
    mesh = {"file": str(tmp_path / "slab.obj"), "unit": "mm", "centre": [0, 0, 0.01], "stiffness": 1e7, "damping": 2.0}
    hand = {"path": [[0, *[0.0] * 6], [0.1, 0, 0, -0.0101, 0, 0, 0]], "stiffness": 800, "damping": 4}
    tool = {"at": [0.0, 0.05, 0.0301], "hand": {**hand, "turning_stiffness": 2.0}}
    body = {**DIE, "centre": [0.0, -0.05, 0.045]}
    world = {"gravity": [0, 0, -9.81], "meshes": [mesh]}
    run = simulate(scene(tool, body=body, world=world, steps={"duration": 0.3}))
    firm = 1e7 * 0.1 * 0.02
    assert run["rigid_force"].values[0, -1, 2] == pytest.approx(-0.01 / (1 / 800 + 1 / firm), rel=0.02)
    assert run["rigid_contact_force"].values[0, -1, 2] == pytest.approx(-run["rigid_force"].values[0, -1, 2], rel=1e-4)
    assert np.abs(run["rigid_rotation"].values[0, -1]).max() < 1e-3
    assert run.attrs["energy_residual"] <= 1e-12
    assert run["world_force"].values[1, -1, 2] == pytest.approx(0.5 * 0.1 * 9.81, rel=0.02)  # still settles


def test_what_it_does_not_touch_does_not_notice() -> None:
    """Groups close by themselves: a die that flies is the same to rounding with the bar at another and without."""
    bodies = [
        {**DIE, "name": "held", "at": [0, 0, 0]},
        {**DIE, "name": "flies", "at": [0, 0, 0.5], "turn": [0.1, 0.2, 0]},
    ]
    flight = np.zeros((8, 3))
    flight[4:] = [0.3, 0.1, 0.0]
    path = [[0, *[0.0] * 6], [0.1, 0.04, 0, 0, 0, 0, 0.8]]
    hand = {"path": path, "stiffness": 400, "damping": 3, "turning_stiffness": 1.0}
    tool = {"at": [-0.04, 0.01, 0], "turn": [0, 0, np.pi / 2], "mass": 0.05, "hand": hand}
    given = {
        "bodies": bodies,
        "network": {"users": ["Ann"], "spring": [[0]], "delay": [[0]]},
        "between": {"friction": 0.4, "damping": 2.0},
        "world": {},
        "steps": {"duration": 0.2},
        "initial": {"velocity": [flight.tolist()]},
    }
    met, free = (simulate(scene(tool | more, **given)) for more in ({}, {"hand": None}))
    moved = np.abs(met["position"].values[0, -1, :4] - free["position"].values[0, -1, :4]).max()
    assert moved > 0.01
    assert np.abs(met["velocity"].values[0, :, 4:] - free["velocity"].values[0, :, 4:]).max() <= 1e-12
    assert met.attrs["energy_residual"] <= 1e-12


def test_what_rests_beside_a_tool_that_moves_is_not_told_as_shortened() -> None:
    """The die has come to rest; the bar goes to and fro in the air above it."""
    path = [[0, 0, 0, 0], [0.6, 0, 0, 0.0], [0.8, 0.03, 0.01, 0.02], [1.0, 0, 0, 0]]
    tool = {"at": [0, 0, 0.1], "hand": {"path": path, "stiffness": 300, "damping": 6}}
    run = simulate(scene(tool, steps={"duration": 1.0}))
    assert run["closure_alarms"].values[0, -1] == 0


def test_how_many_users_there_are_is_asked_anew() -> None:
    """A tool's mass among the bodies is as many times what it is, as there are copies."""
    pair = scene({"at": [0.2, 0, 0.3]})
    before = pair.build_body().tools[0].body.mass.sum()
    three = {
        "users": ["Ann", "Ben", "Cem"],
        "spring": [[0, 20, 0], [20, 0, 20], [0, 20, 0]],
        "delay": [[0, 0.01, 0.01], [0.01, 0, 0.01], [0.01, 0.01, 0]],
    }
    assert pair.replace(network=three).build_body().tools[0].body.mass.sum() == pytest.approx(1.5 * before)


def test_a_file_says_all_of_it(tmp_path: Path) -> None:
    scenario = Scenario.read(EXAMPLE)
    again = Scenario.from_toml(scenario.to_toml())
    assert again.rigid_tools == scenario.rigid_tools
    write_box(tmp_path / "bar.obj", (40, 10, 10))
    tool = {
        "user": 2,
        "file": str(tmp_path / "bar.obj"),
        "unit": "mm",
        "mass": 0.03,
        "at": [0.2, 0, 0.3],
    }  # tools of two users never meet
    ready = prepare(scene({}, tools=[{**BAR, "at": [0.2, 0, 0.3]}, tool]))
    bar = ready.rigid_tools[1]
    assert (bar.user, bar.ports.size) == (1, 0)  # without a hand nothing holds it
    assert 4 * bar.mass == pytest.approx(0.03)
    assert bar.part.rest().mean(axis=0) == pytest.approx([0.2, 0, 0.3])
    assert ready.body.shared == 4
    assert ready.body.holds == 4 + ready.body.parts[0].skin().vertices.shape[0]  # hands hold no tools


WRONG: list[tuple[dict[str, Any], str]] = [
    ({"tools": [{**BAR, "at": [0, 0, 1], "user": 3}]}, "tools[1].user is 3; the network has users 1 to 2"),
    ({"tools": [{**BAR, "at": [0, 0, 1], "radius": 1}]}, "tools[1].radius is not an option that cotouch knows"),
    ({"tools": [{**BAR, "at": [0, 0, 1], "size": [1, 0, 1]}]}, "tools[1].size[2] is 0; it must be greater than 0"),
    ({"tools": [{**BAR, "at": [0, 0, 1], "hand": {"path": [[0, 1, 2]]}}]}, "tools[1].hand.path has the waypoint"),
    ({"tools": [{**BAR, "at": [0, 0, 1], "hand": {"path": [1.0]}}]}, "tools[1].hand.path is [1.0]; it must be 3"),
    ({"tools": [{**BAR, "at": [0, 0, 1], "hand": {"stiffness": 0}}]}, "tools[1].hand.stiffness is 0"),
    ({"tools": [{"user": 1, "file": "a.obj", "unit": "m", "model": "cells", "at": [0, 0, 1]}]}, 'model is "cells"'),
    ({"tools": [{**BAR, "at": [0, 0, 0.02]}]}, 'tools[1]: it begins 0.02 m deep in "body"'),
    ({"tools": [{"user": 1, "kind": "sponge", "at": [0, 0, 1]}]}, 'tools[1].kind is "sponge"; it must be one of'),
    ({"tools": [{**BAR, "at": [0, 0, 1], "device": {}}]}, "device is given, but no hand, whose springs turn the tool"),
    (
        {"tools": [{**BAR, "at": [0, 0, 1]}, {**BAR, "at": [0, 0, 2], "hand": {}, "device": {"resolution": 1e-3}}]},
        "tools[2].device: ",
    ),
    ({"cutting": {}, "tools": [{**BAR, "at": [0, 0, 1]}]}, "cutting takes away elements, but none of the bodies is"),
    ({"tools": [{**BAR, "at": [0, 0, 1 + k]} for k in range(12)]}, "tools[1] is one of 13 rigid bodies"),
]


@pytest.mark.parametrize(("tables", "said"), WRONG)
def test_what_is_wrong_is_one_sentence(tables: dict[str, Any], said: str) -> None:
    with pytest.raises(CotouchError) as caught:
        prepare(scene({}, **tables))
    assert said in str(caught.value)
