"""Contact laws in a scenario: both engines, ledgers, and what is said of wrong input."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imsave

from cotouch.errors import CotouchError
from cotouch.scenario import Scenario, TextureTable
from cotouch.simulation import prepare, run_batch, run_peers, simulate

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
RIDGES = {"pattern": "ridges", "wavelength": 4e-3, "height": 2e-4}
MAP = {"heights": [[0.0, 1e-4], [2e-4, 0.0]], "size": [0.01, 0.01]}
LINEAR = {"body": BLOCK, "solver": {"basis": "nodal"}}
TURNING = {"body": {**BLOCK, "model": "cells"}, "world": {"gravity": [0.0, 0.0, -2.0]}}


@pytest.mark.parametrize("body", [LINEAR, TURNING], ids=["linear", "turning and heavy"])
def test_both_engines_touch_alike_and_balance_it(body: dict[str, Any]) -> None:
    """Users with delays; friction, a film, a snap and a relief on the skin; the ledger of every step and of the run."""
    skin = {"viscosity": 2e3, "snap": {"force": 0.3, "range": 9e-4}, "texture": RIDGES}
    poke = {**POKE, "at": [0.03, 0.01, 0.0313]}
    scenario = Scenario.make(network=PAIR, steps={"duration": 0.4}, tools=[poke], contact=skin, **body)
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
    assert min(report.touch_stored for report in peers.reports[1]) < -1e-5
    np.testing.assert_array_equal(np.ravel(peers.tools[1][-1]), outcome.tools.place[0, -1, :3])


@pytest.mark.parametrize(
    ("contact", "tool", "said"),
    [
        ({"law": "glue"}, {}, 'contact.law is "glue"; it must be one of foundation, stiffening'),
        ({"viscosity": -1.0}, {}, "contact.viscosity is -1"),
        ({"snap": {"force": -0.5, "range": 1e-3}}, {}, "contact.snap.force is -0.5"),
        (
            {"snap": {"force": 0.5, "range": 0.02}},
            {},
            "contact.snap.range is 0.02 m, but tools[1].radius is 0.01 m; it must be between 0.0005 and 0.01 m",
        ),
        ({"texture": {**RIDGES, "height": 3e-3}}, {}, "contact.texture is 0.003 m high, but tools[1].radius is 0.01 m"),
        ({"texture": {"pattern": "ridges", "height": 1e-4}}, {}, "contact.texture.wavelength is missing"),
        (
            {"texture": {**RIDGES, **MAP}},
            {},
            "needs exactly one of pattern, heights and file, but pattern and heights are given",
        ),
        ({"texture": {}}, {}, "a texture needs exactly one of pattern, heights and file, but none is given"),
        (
            {"texture": {**MAP, "height": 1e-4}},
            {},
            "height is 0.0001, but a texture with heights has none",
        ),
        ({"texture": {**MAP, "heights": [[0.0], [0.0, 0.1]]}}, {}, "heights has rows of [1, 2] numbers"),
        ({"texture": {**RIDGES, "wavelength": 2e-5}}, {}, "contact.texture: the relief needs"),
        ({"texture": {"file": "no.png", "size": [0.1, 0.1], "height": 1e-4}}, {}, "the texture no.png"),
        (
            {"texture": {**RIDGES, "height": 2e-3}},
            {"at": [0.03, 0.01, 0.031]},
            "with its radius of 0.01 m and the texture this one is 0.001 m deep in the body; move it to",
        ),
        ({"law": "stiffening", "parameters": {"hardness": 0.0}}, {}, "contact.parameters.hardness is 0"),
        ({"law": "stiffening", "parameters": {"softness": 1.0}}, {}, 'law "stiffening" has hardness, each above 0'),
        ({"law": "stiffening"}, {"kinetic_friction": 0.6}, "what slips is not held more firmly"),
        (
            {},
            {"kind": "grasp", "friction": 0.0, "kinetic_friction": None, "axis": [0.0, 0.0, 0.01]},
            "axis is [0.0, 0.0, 0.01], but a grasp holds what is near its centre",
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


def test_a_map_is_laid_on_the_skin(tmp_path: Path) -> None:
    """Along one axis, turned, as heights, as a picture of 16 bits or in colours; between axes, a blend."""
    rng = np.random.default_rng(1)
    at, wave = rng.uniform(-0.05, 0.05, (200, 3)), 2.0 * np.pi / 0.004
    up, aside = np.tile([0.0, 0.0, -2.0], (200, 1)), np.tile([0.0, 1.0, 1.0], (200, 1))
    ridges = lambda u: 1e-4 * (1.0 + np.sin(wave * u))  # noqa: E731
    turned = TextureTable.model_validate({**RIDGES, "angle": 0.3, "projection": "y"}).profile()(at, up)
    np.testing.assert_allclose(turned, ridges(np.cos(0.3) * at[:, 0] + np.sin(0.3) * at[:, 2]), atol=1e-12)
    blend = TextureTable.model_validate(RIDGES).profile()
    np.testing.assert_allclose(blend(at, up), ridges(at[:, 0]), atol=1e-12)
    bumps = TextureTable.model_validate({**RIDGES, "pattern": "bumps", "projection": "x"}).profile()(at, up)
    np.testing.assert_allclose(bumps, 0.5 * ridges(at[:, 1]) * (1.0 + np.sin(wave * at[:, 2])), atol=1e-12)
    np.testing.assert_allclose(blend(at, aside), ridges(at[:, 0]), atol=1e-12)  # along y and z, u is x
    rows = 0.5 + 0.5 * np.sin(2.0 * np.pi * (np.arange(16) + 0.5) / 16.0)[:, None] * np.ones(8)
    size = {"size": [0.01, 0.02], "projection": "z"}
    expected = np.minimum(1e-4 * (1.0 + np.sin(2.0 * np.pi * at[:, 1] / 0.02)), 2e-4 * rows.max())
    given = TextureTable.model_validate({"heights": (2e-4 * rows).tolist(), **size}).profile()(at, up)
    np.testing.assert_allclose(given, expected, atol=2e-7)
    imsave(tmp_path / "rows.png", rows, cmap="gray", vmin=0.0, vmax=1.0)
    picture = {"file": str(tmp_path / "rows.png"), "height": 2e-4, **size}
    np.testing.assert_allclose(TextureTable.model_validate(picture).profile()(at, up), expected, atol=2e-6)
    (tmp_path / "rows.png").write_bytes((tmp_path / "rows.png").read_bytes()[:80])
    with pytest.raises(CotouchError, match=r"rows\.png is a broken PNG; save it again"):
        TextureTable.model_validate(picture).profile()
    (tmp_path / "rows.png").write_bytes(b"GIF89a")
    with pytest.raises(CotouchError, match=r"rows\.png is not a PNG; save it as one"):
        TextureTable.model_validate(picture).profile()


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


def test_what_attraction_gives_was_there_to_be_had() -> None:
    """A hand that holds a tool back from the skin gets some of the energy that the attraction has."""
    snap = {"snap": {"force": 1.0, "range": 5e-3}}
    hand = {"path": [[0, 0, 0, 0], [0.3, 0, 0, -5e-3]], "stiffness": 500.0}
    tool = {**POKE, "at": [0.03, 0.01, 0.0365], "hand": hand}
    spring = {"law": "spring"}  # which has no seed that may be spent
    steps = {"duration": 0.4}
    run = simulate(
        Scenario.make(network=PAIR, steps=steps, synchronisation=spring, tools=[tool], contact=snap, **LINEAR)
    )
    assert float(run["supplied_total"].min()) < -1e-5
    assert run.attrs["passivity_margin"] >= 0.0
    assert run.attrs["extracted"] == 0.0
