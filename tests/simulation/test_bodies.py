"""Several bodies in scenarios: tables, the batch engine and peers alike, what is refused, and the example."""

from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest
from tests.mechanics.materials import boxes

from cotouch.errors import CotouchError
from cotouch.scenario import Scenario
from cotouch.simulation import USER_LEDGER, prepare, run_batch, run_peers, run_prepared, simulate

EXAMPLE = Path(__file__).parents[2] / "examples" / "tower.toml"
PAIR = {"users": ["Ann", "Ben"], "spring": [[0, 20], [20, 0]], "delay": [[0, 0.01], [0.01, 0]]}
DIE: dict[str, Any] = {"kind": "box", "size": [0.05, 0.05, 0.05], "mass": 0.1, "resolution": 1}
# Thin plates, right through each other: less deep than a fiftieth of their size.
CROSSED = [0.1, 0.1, 0.003], [0.1, 0.003, 0.1]
PLANE: dict[str, Any] = {"gravity": [0, 0, -9.81], "planes": [{"friction": 0.5, "damping": 20.0}]}


PULL = {"user": 2, "body": "die 2", "at": [0.035, 0, 0.075], "path": [0.03, 0, 0.01], "stiffness": 100}


def stack(**tables: Any) -> Scenario:
    """Two dice on a table; one hand pulls at the upper."""
    given: dict[str, Any] = {
        "bodies": [{**DIE, "name": "die", "at": [0, 0, 0.025], "step": [0.01, 0, 0.05], "copies": 2}],
        "between": {"friction": 0.4, "damping": 20.0},
        "hands": [PULL],
        "network": PAIR,
        "world": PLANE,
        "steps": {"duration": 0.1},
    }
    return Scenario.make(**(given | tables))


@pytest.fixture(scope="module")
def taken_apart() -> Any:
    return simulate(Scenario.read(EXAMPLE).replace(record__nodes="all", steps__rate=500))


def test_a_tower_stands_and_two_take_it_apart(taken_apart: Any) -> None:
    place = taken_apart["position"].values.reshape(2, -1, 5, 4, 3)[:, :, :, :, :].mean(axis=3)
    begun = place[:, 0]
    assert np.abs(place[:, 240] - begun).max() <= 1.5e-3  # it stood, each block pressed in by those above
    assert place[:, -1, 4] == pytest.approx(np.tile([-0.12, 0.0, 0.025], (2, 1)), abs=0.03)  # Ann's lies on the table
    assert (place[:, -1, :, 2] < 0.06).all()  # Ben pushed the rest over
    assert taken_apart.attrs["energy_residual"] <= 1e-12
    assert taken_apart.attrs["passivity_margin"] >= -1e-12 * taken_apart.attrs["energy_in_play"]
    assert (np.diff(taken_apart["world_loss"].values, axis=1) >= 0.0).all()


def test_a_light_body_bears_a_heavy_one() -> None:
    """As soft as alone, its steps were refused without end, and the two hung where they were at full speed."""
    slab = {"kind": "box", "size": [0.05, 0.05, 0.02], "resolution": 2}
    loads = {"under": (0.02, 0.01), "over": (10.0, 0.03)}
    run = simulate(
        Scenario.make(
            network={"users": ["Ann"], "spring": [[0]], "delay": [[0]]},
            bodies=[{**slab, "name": name, "mass": mass, "at": [0, 0, z]} for name, (mass, z) in loads.items()],
            between={"friction": 0.5, "damping": 20.0, "stiffness": 1e7},
            world=PLANE,
            steps={"duration": 1.0, "period": 0.002},
            record={"nodes": "all"},
        )
    )
    assert np.abs(run["velocity"].values[0, -1]).max() < 1e-3
    assert run["closure_alarms"].values[0, -1] <= 2  # as it is set down; before, half of all steps
    assert run.attrs["energy_residual"] <= 1e-13


def test_what_only_falls_is_judged_by_the_energy_that_its_weight_gives() -> None:
    """Kinetic energy and weight cancel: their sum, and what hands gave, is rounding alone."""
    run = simulate(
        Scenario.make(
            network={"users": ["Ann"], "spring": [[0]], "delay": [[0]]},
            body=DIE,
            world={"gravity": [0, 0, -9.81], "planes": [{"point": [0, 0, -1e3]}]},  # far below, as in test_rigid.py
            steps={"duration": 0.5},
            record={"nodes": "all"},
        )
    )
    fell = 0.5 * 9.81 * 0.5**2
    assert run["position"].values[0, -1, :, 2].mean() == pytest.approx(-fell, abs=1e-12)
    assert run.attrs["energy_in_play"] == pytest.approx(0.1 * 9.81 * fell, rel=1e-9)
    assert run.attrs["energy_residual"] <= 1e-13


def test_a_body_that_meets_itself_does_so_in_every_world_to_the_same_bits() -> None:
    """A strip is folded over by a hand; the other user's copy follows."""
    fold = {"path": [[0, 0, 0, 0], [0.15, -0.06, 0, 0.06], [0.3, -0.09, 0, 0.012]], "stiffness": 200, "damping": 1}
    held = {"user": 1, "at": [0.0, 0.01, 0.0], "stiffness": 200, "damping": 1}
    scenario = Scenario.make(
        network=PAIR,
        body={"kind": "lattice", "shape": [12, 3, 2], "mass": 0.05, "stiffness": 20, "damping": 0.05, "model": "cells"},
        between={"self_contact": True, "friction": 0.3, "damping": 1.0},
        hands=[{"user": 1, "at": [0.11, 0.01, 0.01], **fold}, held, {"user": 2, "at": [0.11, 0.0, 0.01], **fold}],
        steps={"duration": 0.35, "rate": 2000},
        cutting={},  # nothing is cut; the machine code is that of the test which follows
    )
    ready = prepare(scenario)
    batch, peers = run_batch(ready), run_peers(ready)
    assert np.array_equal(batch.position, np.stack([places[-1] for places in peers.position]))
    assert max(abs(report.residual) for reports in peers.reports for report in reports) <= 1e-15


def test_what_is_pressed_into_itself_comes_out_as_soon_as_its_grasp_pulls(tmp_path: Path) -> None:
    """A clamp whose upper tip is pressed as deep into the lower one as it may come."""
    points, tetrahedra = boxes((8, 3, 7), 0.006)
    column, _, row = np.floor(points[tetrahedra].mean(axis=1) / 0.006).astype(int).T
    meshio.Mesh(points, [("tetra", tetrahedra[(column < 2) | (row < 2) | (row > 3)])]).write(tmp_path / "clamp.vtk")
    pull, path = 0.45, [[0, 0, 0, 0], [0.3, 0, 0, -0.025], [0.45, 0, 0, -0.025], [0.75, 0, 0, 0]]
    grasp = {"kind": "grasp", "at": [0.039, 0.006, 0.034], "radius": 0.01, "stiffness": 300, "damping": 0.5}
    hand = {"stiffness": 300, "damping": 4, "path": path}
    scenario = Scenario.make(
        network={"users": ["Ann"], "spring": [[0]], "delay": [[0]]},
        body={
            "file": str(tmp_path / "clamp.vtk"),
            "unit": "m",
            "model": "corotated",
            "young": 2e4,
            "poisson": 0.3,
            "density": 800,
            "rayleigh_stiffness": 2e-3,
            "ground": {"box": {"low": [-0.001, -0.001, -0.001], "high": [0.07, 0.02, 0.001]}},
            "ground_stiffness": 300,
        },
        between={"self_contact": True, "stiffness": 1e6, "friction": 0, "damping": 2},
        tools=[{"user": 1, "mass": 0.03, "hand": hand, **grasp}],
        steps={"duration": 0.7, "period": 0.002},
        record={"nodes": "all"},
    )
    ready = prepare(scenario)
    batch, peers = run_batch(ready), run_peers(ready)
    assert np.array_equal(batch.position, np.stack([places[-1] for places in peers.position]))
    assert max(abs(report.residual) for reports in peers.reports for report in reports) <= 1e-15
    run = simulate(scenario)
    moved = np.linalg.norm(np.diff(run["position"].values[0], axis=0), axis=2).max(axis=1)
    assert run["closure_alarms"].values[0, -1] > 0  # it was as deep as it may come
    assert (moved[run["time"].values[0, 1:] > pull + 0.01] > 1e-6).all()


@pytest.mark.parametrize(
    ("faces", "whole"), [(False, False), (False, True), (True, True)], ids=["peers", "elements", "faces"]
)
def test_several_are_cut_in_every_world_to_the_same_bits(faces: bool, whole: bool) -> None:
    """Two blocks lie on each other; one hand tears a corner off the upper, which falls on the lower."""
    block = {"kind": "lattice", "shape": [4, 3, 3], "model": "cells", "stiffness": 80, "damping": 0.1, "mass": 0.05}
    tear = {"path": [[0, 0, 0, 0], [0.15, 0.06, 0, 0.02]], "stiffness": 400, "damping": 1}
    scenario = Scenario.make(
        network=PAIR,
        bodies=[
            {**block, "name": "low", "at": [0.015, 0.01, 0.0101]},
            {**block, "name": "high", "at": [0.015, 0.01, 0.031]},
        ],
        between={"friction": 0.3, "damping": 2.0, "stiffness": 1e6},
        hands=[{"user": 1, "body": "high", "at": [0.03, 0.02, 0.04], **tear}],
        world=PLANE,
        cutting={"tear": 0.3, "faces": faces},
        steps={"duration": 0.2, "rate": 500},
    )
    ready = prepare(scenario)
    peers = run_peers(ready)
    assert max(abs(report.residual) for reports in peers.reports for report in reports) <= 1e-14
    cut = [{e for report in reports for e in report.cut_elements} for reports in peers.reports]
    assert cut[0]
    assert all(report.cut >= 0.0 for reports in peers.reports for report in reports)
    count = ready.body.cut_count
    assert min(cut[0] | cut[1]) >= count // 2  # of the upper block
    if whole:  # its engine is compiled for nothing else, see test_cutting.py for one body
        batch = run_batch(ready)
        assert np.array_equal(batch.position, np.stack([places[-1] for places in peers.position]))
        assert batch.cuts is not None
        assert [set(np.flatnonzero(marks[1])) for marks in batch.cuts] == cut


@pytest.mark.parametrize("law", ["spring", "paid"])
def test_peers_come_to_the_same_bits(law: str) -> None:
    ready = prepare(stack(synchronisation={"law": law}))
    batch, peers = run_batch(ready), run_peers(ready)
    assert np.array_equal(batch.position, np.stack([places[-1] for places in peers.position]))
    assert max(abs(report.residual) for reports in peers.reports for report in reports) <= 1e-15


def test_a_codec_says_several_bodies_with_the_record_of_the_batch_engine() -> None:
    plain = stack(synchronisation={"law": "wave"}, record={"every": 2}, hands=[{**PULL, "stiffness": 400}])
    exact = {"codec": {"deadband": 0.0, "quantum": 0.0, "hold": 1}}
    batch, single = run_batch(prepare(plain)), run_prepared(prepare(plain.replace(channel=exact)))
    assert np.array_equal(single.position, batch.position)
    for name in ("users", "slots", "made", "lowest", "ticks"):
        found, wanted = getattr(single.record, name), getattr(batch.record, name)
        assert found.shape == wanted.shape
        reached = batch.taken[0] // 2 + 1 if name not in {"made", "lowest"} else None
        assert found[..., :reached] == pytest.approx(wanted[..., :reached], rel=1e-9, abs=1e-12)
    assert single.record.users[len(USER_LEDGER) + 1].max() > 0.0  # closed steps told by how much


def test_a_codec_leaves_out_what_goes_on_as_several_bodies_did() -> None:
    coded = stack(synchronisation={"law": "paid"}, channel={"codec": {"deadband": 0.05, "quantum": 1e-5}})
    run = simulate(coded)
    assert run.attrs["unchanged"] > 0
    assert run.attrs["made"] <= run.attrs["law_initial_energy"]
    assert run.attrs["energy_residual"] < 1e-12
    whole = simulate(stack(synchronisation={"law": "paid"}))
    assert 0.0 < np.abs(run["position"].values - whole["position"].values).max() < 0.002


def test_a_tool_that_pushes_one_body_leaves_another_at_rest() -> None:
    """What the tool does is booked at the body that it does it to, or the balance of both would move the other."""
    tool = {
        "user": 1,
        "at": [-0.035, 0.0, 0.0],
        "radius": 0.01,
        "mass": 0.02,
        "stiffness": 2000,
        "hand": {"stiffness": 200, "damping": 2, "path": [[0, 0, 0, 0], [0.05, 0.03, 0, 0]]},
    }
    apart = [{**DIE, "name": "near", "at": [0, 0, 0]}, {**DIE, "name": "far", "at": [0, 0, 1]}]
    network = {"users": ["Ann"], "spring": [[0]], "delay": [[0]]}
    run = run_batch(prepare(stack(bodies=apart, hands=[], tools=[tool], world={}, network=network)))
    assert np.abs(run.position[0][:4]).max() > 1e-3
    assert np.abs(run.position[0][4:]).max() <= 1e-15


def test_three_copies_over_delays_stay_passive() -> None:
    spring = 30.0 * (np.ones((3, 3)) - np.eye(3))
    delay = 0.03 * (np.ones((3, 3)) - np.eye(3))
    network = {"users": ["Ann", "Ben", "Cleo"], "spring": spring.tolist(), "delay": delay.tolist()}
    hands = [
        {"user": 1, "body": "die 1", "at": [0.025, 0, 0.025], "path": [0.05, 0.02, 0], "stiffness": 200},
        {"user": 3, "body": "die 2", "at": [-0.015, 0, 0.09], "path": [-0.03, 0, 0], "stiffness": 200},
    ]
    run = simulate(stack(network=network, hands=hands, steps={"duration": 0.5, "random": {"low": 5e-4, "high": 3e-3}}))
    assert run.attrs["energy_residual"] <= 1e-12
    assert run.attrs["passivity_margin"] >= -1e-12 * run.attrs["energy_in_play"]


def test_a_hand_holds_the_body_that_it_names() -> None:
    """At a place that two share, the one that is named; by number, its own nodes."""
    middle = {"user": 1, "at": [0.0, 0.0, 0.05], "path": [0, 0, 0]}
    low = stack(hands=[{**middle, "body": "die 1"}]).placed()
    high = stack(hands=[{**middle, "body": "die 2"}]).placed()
    bodies = [scenario.build_body() for scenario in (low, high)]
    for number, (scenario, body) in enumerate(zip((low, high), bodies, strict=True)):
        assert scenario.hands[0].node - 1 in body.held_by(number)
    own = stack(hands=[{"user": 1, "body": "die 2", "node": 3}]).placed()
    assert own.hands[0].node == 7


def test_a_file_says_all_of_it() -> None:
    scenario = Scenario.read(EXAMPLE)
    again = Scenario.from_toml(scenario.to_toml())
    assert again.to_toml() == scenario.to_toml()
    assert np.array_equal(again.build_body().rest, scenario.build_body().rest)
    assert [part.name for part in again.build_body().parts] == [f"block {k}" for k in range(1, 6)]


@pytest.mark.parametrize(
    ("tables", "said"),
    [
        ({"bodies": [{**DIE, "name": name} for name in "ab"]}, 'bodies "a" and "b" overlap; move one'),
        (
            {"bodies": [{**DIE, "name": "a"}, {**DIE, "name": "b", "at": [0.03, 0.01, 0.01]}], "world": {}},
            'bodies: "a" and "b" begin 0.015 m deep in each other in the copy of user 1, more than 0.02 of',
        ),
        (
            {"bodies": [{**DIE, "name": "a", "size": CROSSED[0]}, {**DIE, "name": "b", "size": CROSSED[1]}]},
            'bodies: "a" and "b" begin 0.0015 m deep in each other in the copy of user 1, more than 0.25 of the',
        ),
        (
            {"bodies": [{**DIE, "name": "a", "size": CROSSED[0]}], "world": {"boxes": [{"size": CROSSED[1]}]}},
            "world.boxes[1]",
        ),
        ({"bodies": [{**DIE, "name": "a"}, {**DIE, "name": "a"}]}, 'two bodies are named "a"'),
        (
            {"bodies": [{**DIE, "name": "a", "color": "red"}]},
            'bodies[1].color is "red"; it must be red, green and blue as',
        ),
        (
            {"bodies": [{**DIE, "name": "a"}], "world": {"boxes": [{"size": [0.02, 0.02, 0.02]}]}},
            'world.boxes[1] and "a" overlap in the copy of user 1',
        ),
        (
            {"world": {"meshes": [{"file": "a.msh", "unit": "m"}]}},
            'world.meshes[1]: a.msh ends in ".msh"; a surface mesh',
        ),
        ({"world": {"meshes": [{"file": "none.stl", "unit": "m"}]}}, "the mesh none.stl cannot be read: No such file"),
        ({"bodies": [DIE]}, "bodies[1].name is missing"),
        (
            {"bodies": [{**DIE, "name": "a", "step": [1, 0, 0], "copies": 10**9}]},
            "bodies[1].copies is 1000000000; it must",
        ),
        (
            {"bodies": [{**DIE, "name": "a", "size": [1e300, 1, 1]}]},
            "bodies[1]: size is [1e+300, 1.0, 1.0]; it must be three lengths",
        ),
        (
            {"bodies": [{**DIE, "name": "a"}, {"name": "b", "file": "none.msh", "unit": "m"}]},
            "bodies[2]: the mesh none.msh cannot be read: No such file",
        ),
        ({"bodies": [{**DIE, "name": "a", "sise": 1}]}, "bodies[1].sise is not an option that cotouch knows"),
        (
            {"bodies": [{**DIE, "name": "a", "size": [1, 1]}]},
            "bodies[1].size is [1, 1]; it must have at least 3 entries",
        ),
        ({"bodies": [{**DIE, "name": "a", "copies": 2}]}, "copies is 2, but step is missing"),
        ({"body": DIE}, "body and bodies are given; give [body] for one object, or [[bodies]] for several"),
        (
            {"cutting": {}},
            "cutting takes away elements, but none of the bodies is of cubes or tetrahedra; give one of them",
        ),
        (
            {"bodies": [{"name": "a", "kind": "box", "size": [1, 1, 1]}], "between": {"self_contact": True}},
            "between.self_contact is true, but no body yields, so none can meet itself; leave it out",
        ),
        ({"between": {"friction": 0.1, "kinetic_friction": 0.2}}, "kinetic_friction is 0.2, but friction is 0.1"),
        ({"hands": [{"user": 1, "body": "c"}]}, 'hands[1].body is "c"; there are "die 1", "die 2"'),
        ({"hands": [{"user": 1, "body": "die 1", "node": 99}]}, 'hands[1].node is 99; "die 1" has nodes 1 to'),
    ],
)
def test_wrong_bodies_are_one_sentence(tables: dict[str, Any], said: str) -> None:
    with pytest.raises(CotouchError) as caught:
        prepare(stack(**({"hands": []} | tables)))
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def stiff_and_uneven(path: Path, **tables: Any) -> Scenario:
    """A block of small elements, which ring faster than steps follow, and a die beside it."""
    points, elements = boxes((7, 6, 4), 0.005)
    inner = ((points > 0.0) & (points < points.max(axis=0))).all(axis=1)
    points[inner] += np.random.default_rng(3).uniform(-0.0018, 0.0018, (int(inner.sum()), 3))
    meshio.Mesh(points, [("tetra", elements)]).write(path)
    soft = {"name": "soft", "file": str(path), "unit": "m", "model": "corotated", "rayleigh_stiffness": 2e-4}
    held = {"ground": "z-", "ground_stiffness": 1e3, "young": tables.pop("young")}
    return Scenario.make(
        network={"users": ["Ann"], "spring": [[0]], "delay": [[0]]},
        bodies=[{**soft, **held}, {**DIE, "name": "die", "at": [0.1, 0, 0]}],
        **tables,
    )


def test_a_tool_slides_over_a_stiff_uneven_one_of_several(tmp_path: Path) -> None:
    """With too few looks they hold a tool back, without friction."""
    path = [[0, 0, 0, 0], [0.2, 0, 0, -0.002], [0.7, 0.006, 0.0025, -0.002]]
    hand = {"path": path, "stiffness": 500, "damping": 3}
    tool = {"user": 1, "at": [0.011, 0.01, 0.0211], "radius": 0.006, "stiffness": 800, "hand": hand}
    run = simulate(stiff_and_uneven(tmp_path / "block.vtu", young=1e6, tools=[tool], steps={"duration": 0.7}))
    force = run["touch_force"].values[0, 250:-1]
    assert run["closure_alarms"].values[0, -1] == 0
    assert np.hypot(force[:, 0], force[:, 1]).max() <= 0.05 * force[:, 2].min()


def test_a_hand_pulls_at_a_stiff_uneven_one_of_several(tmp_path: Path) -> None:
    """With too few looks most steps raised an alarm, and some did where changes alone ask for more."""
    path = [[0, 0, 0, 0], [0.1, 0.002, 0, -0.002], [0.3, 0.002, 0.002, -0.002]]
    hand = {"user": 1, "body": "soft", "at": [0.011, 0.01, 0.015], "path": path, "stiffness": 500, "damping": 3}
    run = simulate(stiff_and_uneven(tmp_path / "block.vtu", young=2e5, hands=[hand], steps={"duration": 0.3}))
    assert run["closure_alarms"].values[0, -1] == 0
    assert run.attrs["energy_residual"] <= 1e-13
