"""Rigid bodies in a scenario: several copies with delays, hands at any point, tools, and wrong input."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.laws.scenes import AS_LAW

from cotouch.errors import CotouchError
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch, run_peers, simulate

EXAMPLES = Path(__file__).parents[2] / "examples"
BOX: dict[str, Any] = {"kind": "box", "size": [0.1, 0.06, 0.04], "mass": 0.5, "centre": [0.0, 0.0, 0.02]}
WORLD: dict[str, Any] = {"gravity": [0.0, 0.0, -9.81], "planes": [{"friction": 0.5, "damping": 10.0}]}
# Far below: what meets nothing moves by the machine code of what does.
FAR: dict[str, Any] = {"planes": [{"point": [0.0, 0.0, -1e3]}]}
LIFT: dict[str, Any] = {
    "user": 1,
    "at": [0.05, 0.03, 0.011],
    "stiffness": 500.0,
    "damping": 10.0,
    "path": [[0.0, 0.0, 0.0, 0.0], [0.4, 0.02, 0.0, 0.05]],
}
PUSH: dict[str, Any] = {
    "user": 2,
    "at": [-0.062, 0.0, 0.02],
    "radius": 0.01,
    "friction": 0.3,
    "damping": 1.0,
    "hand": {"path": [[0.0, 0.0, 0.0, 0.0], [0.4, 0.03, 0.0, 0.0]], "stiffness": 500.0, "damping": 5.0},
}


def network(users: int, spring: float = 100.0, delay: float = 0.02) -> dict[str, Any]:
    """All linked, no two delays alike."""
    count = np.arange(users)
    links = spring * (count[:, None] != count[None, :])
    ages = delay * (1.0 + 0.3 * count[:, None] + 0.1 * count[None, :]) * (links > 0.0)
    return {"users": [f"User {n + 1}" for n in range(users)], "spring": links.tolist(), "delay": ages.tolist()}


@pytest.mark.parametrize("tools", [[], [PUSH]], ids=["hand", "tool"])
def test_both_engines_move_it_alike_and_balance_it(tools: list[dict[str, Any]]) -> None:
    tables: dict[str, Any] = {"body": BOX, "network": network(2), "world": WORLD, "steps": {"duration": 0.6}}
    prepared = prepare(Scenario.make(hands=[LIFT], tools=tools, **tables))
    outcome, peers = run_batch(prepared), run_peers(prepared)
    energy = outcome.record.ticks[:4].max()
    for user in range(2):
        np.testing.assert_array_equal(peers.position[user][-1], outcome.position[user])
        assert max(abs(report.residual) for report in peers.reports[user]) <= 1e-14 * energy
    assert np.abs(outcome.record.ticks[4]).max() <= 1e-12 * energy
    assert np.abs(outcome.position).max() > 0.02


@pytest.mark.parametrize("users", [2, 3, 4, 5])
def test_copies_that_spin_apart_are_passive(users: int) -> None:
    """Each begins with a spin of its own; springs between them and the rule bring them together."""
    body = Scenario.make(body=BOX, network=network(users)).build_body()
    about, rng = body.rest - body.rest.mean(axis=0), np.random.default_rng(users)
    speed = [
        (np.cross(rng.normal(scale=6.0, size=3), about) + rng.normal(scale=0.2, size=3)).tolist() for _ in range(users)
    ]
    made = {"body": BOX, "network": network(users, 300.0), "initial": {"velocity": speed}, "steps": {"duration": 2.0}}
    made["world"] = FAR
    ruled = simulate({**made, "synchronisation": {"law": AS_LAW.name}})
    stored = ruled["stored"].to_numpy()
    assert np.all(stored <= stored[0] * (1.0 + 1e-12))
    assert ruled.attrs["energy_residual"] <= 1e-12
    assert ruled.attrs["passivity_margin"] >= 0.0
    if users == 2:
        bare = simulate({**made, "synchronisation": {"law": AS_LAW.name, "damping": 0.0}})
        assert float(bare["stored"].max()) > 1.1 * float(bare["stored"][0])
        assert bare.attrs["energy_residual"] <= 1e-12


def test_a_hand_holds_the_place_that_it_names() -> None:
    """It hangs from there, straight below; elsewhere it would hang askew."""
    run = simulate(
        {
            "body": BOX,
            "network": network(1),
            "world": {"gravity": [0.0, 0.0, -9.81], **FAR},
            "hands": [{**LIFT, "at": [0.01, 0.02, 0.02], "stiffness": 2000.0, "damping": 5.0, "path": [0, 0, 0]}],
            "synchronisation": {"damping": 2.0, "law": AS_LAW.name},
            "steps": {"duration": 6.0},
        }
    )
    assert run["node"].to_numpy().tolist()[:4] == [1, 2, 3, 4]
    held, nodes = run["position"][0, -1, -1].to_numpy(), run["position"][0, -1, :4].to_numpy()
    assert run["position"][0, 0, -1].to_numpy() == pytest.approx([0.01, 0.02, 0.02])
    centre = nodes.mean(axis=0)
    assert held - centre == pytest.approx([0.0, 0.0, np.hypot(0.01, 0.02)], abs=1e-4)
    assert 0.02 - held[2] == pytest.approx(0.5 * 9.81 / 2000.0, rel=1e-3)
    assert run["hand_force"][0, -1].to_numpy() == pytest.approx([0.0, 0.0, 0.5 * 9.81], abs=1e-3)


@pytest.mark.parametrize("suffix", [".obj", ".vtk"])
def test_a_mesh_is_rigid_where_it_is_told_to_be(tmp_path: Path, suffix: str) -> None:
    """A cube of a surface and of tetrahedra, of the inertia of a cube."""
    from tests.mechanics.materials import boxes

    path = tmp_path / f"cube{suffix}"
    points, solids = boxes((3, 3, 3), 0.02)
    if suffix == ".obj":
        from cotouch.body import rigid_box

        skin = rigid_box([0.04] * 3, centre=[0.02] * 3).skin
        assert skin is not None
        lines = [f"v {x} {y} {z}" for x, y, z in skin.vertices.tolist()]
        lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in skin.triangles.tolist()]
    else:
        cells = [f"4 {a} {b} {c} {d}" for a, b, c, d in solids.tolist()]
        lines = ["# vtk DataFile Version 3.0", "cube", "ASCII", "DATASET UNSTRUCTURED_GRID"]
        lines += [f"POINTS {len(points)} double", *(" ".join(map(str, point)) for point in points.tolist())]
        lines += [f"CELLS {len(cells)} {5 * len(cells)}", *cells, f"CELL_TYPES {len(cells)}", *["10"] * len(cells)]
    path.write_text("\n".join(lines) + "\n")
    made = {"file": str(path), "unit": "m", "model": "rigid", "mass": 0.064}
    run = simulate({"body": made, "network": network(1), "world": WORLD, "steps": {"duration": 0.3}})
    assert run.attrs["energy_residual"] <= 1e-12
    body = Scenario.make(body=made, network=network(1)).build_body()
    about = body.rest - body.rest.mean(axis=0)
    np.testing.assert_allclose(about.T @ about / 4.0, np.eye(3) * 0.04**2 / 12.0, atol=1e-12)
    np.testing.assert_allclose(body.rest.mean(axis=0), 0.02, atol=1e-12)


@pytest.mark.parametrize(
    "table", [BOX, {"kind": "cylinder", "radius": 0.1, "length": 0.1}, {"kind": "sphere", "radius": 0.1}]
)
def test_how_hard_a_shape_is_can_be_said(table: dict[str, Any]) -> None:
    """Its stiffness grows with the square of how fast strains oscillate, which is 2000 rad/s where nothing is said."""
    built = [
        Scenario.make(body={**table, **rate}, network=network(1)).build_body()
        for rate in ({}, {"rate": 2000.0}, {"rate": 1e4})
    ]
    firm = [body.material.stiffness[0] for body in built if body.material is not None]
    assert firm[1:] == pytest.approx([firm[0], 25.0 * firm[0]])


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ({"rate": 0.0}, "rate is 0"),
        ({"size": [0.1, 0.0, 0.1]}, "size[2] is 0"),
        ({"size": [0.1, 0.1]}, "size"),
        ({"mass": -1.0}, "mass is -1"),
        ({"size": [1.0, 1.0, 1e-5]}, "times as thick as it is long"),
        ({"resolution": 1000}, "resolution is 1000; it must be a whole number from 1 to 200"),
        ({"model": "springs"}, "model is 'springs'"),
        ({"kind": "cylinder"}, "radius is missing"),
    ],
)
def test_a_wrong_shape_is_one_sentence(table: dict[str, Any], said: str) -> None:
    with pytest.raises(CotouchError) as caught:
        prepare(Scenario.make(body={**BOX, **table}, network=network(1), steps={"duration": 0.1}))
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_what_does_not_fit_what_is_rigid_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CotouchError, match=r'young is 5.*model is "rigid"; leave it out'):
        Scenario.make(body={"file": "x.obj", "unit": "m", "model": "rigid", "young": 5.0}, network=network(1))
    with pytest.raises(CotouchError, match='basis is "modal"'):
        prepare(Scenario.make(body=BOX, network=network(1), steps={"duration": 0.1}, solver={"basis": "modal"}))
    with pytest.raises(CotouchError, match="it must be 3 coordinates"):
        Scenario.make(body=BOX, network=network(1), hands=[{**LIFT, "at": [0.1]}]).placed()


def test_a_peg_goes_into_its_hole() -> None:
    """19.9 mm into 20 mm, by two with 50 ms between them: to the ground, and hardly into the wall."""
    scenario = Scenario.read(EXAMPLES / "peg-in-hole.toml")
    run, body = simulate(scenario), scenario.build_body()
    assert body.skin is not None
    assert run.attrs["energy_residual"] <= 1e-12
    assert run.attrs["passivity_margin"] >= 0.0
    assert float(run["closure_factor"].max()) <= 1e-2
    plate = scenario.world.plates[0]
    nodes = run["position"].to_numpy()[:, :, :4]
    for own in nodes:
        places = np.array([body.skin.carried(step) for step in own])
        beyond, height = np.hypot(places[..., 0], places[..., 1]) - plate.hole_radius, places[..., 2]
        cut = np.sqrt(0.5) * (beyond - np.maximum(np.abs(height - 0.025) - 0.025 + plate.chamfer, 0.0))
        deep = np.minimum(np.minimum(beyond, cut), np.minimum(plate.size[2] - height, height))
        # The edge of a skin sinks in by a fortieth of a triangle before the rim is felt.
        assert deep[height < plate.size[2] - plate.chamfer].max() <= 1e-4
        assert deep.max() <= 1.5e-4
        assert np.abs(height[-1].min()) <= 1e-4  # it stands on the ground below
        assert own[0, :, 2].min() > 0.05  # and came from above
