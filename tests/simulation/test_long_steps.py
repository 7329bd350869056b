"""Bodies that tools touch and hold in steps far too long for them: whatever becomes of a step, its balance is exact."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest
from tests.mechanics.materials import SHAPE, SPACING, boxes
from tests.simulation.stepped import Stepped

from cotouch.mechanics import CLOSURE_ALARM
from cotouch.peer import Peer, StepReport
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, simulate

ALONE = {"users": ["Ann"], "spring": [[0]], "delay": [[0]]}
SIDES = (np.array(SHAPE) - 1) * SPACING
STEPS = 40
CELLS: dict[str, Any] = {
    "kind": "lattice",
    "shape": list(SHAPE),
    "spacing": SPACING,
    "model": "cells",
    "mass": 0.012,
    "stiffness": 100.0,
    "damping": 0.02,
}
DIE: dict[str, Any] = {
    "kind": "box",
    "size": SIDES.tolist(),
    "mass": 0.1,
    "resolution": 1,
    "at": (0.5 * SIDES).tolist(),
}
BALL: dict[str, Any] = {"radius": 0.008, "stiffness": 1000.0, "friction": 0.5}
PLANE = {"point": [0, 0, -1e-4], "stiffness": 1e7, "friction": 0.4}


@pytest.fixture(scope="module")
def solid(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    path = Path(tmp_path_factory.mktemp("long")) / "box.vtk"
    points, elements = boxes()
    meshio.Mesh(points, [("tetra", elements)]).write(path)
    common = {"frame": "fixed", "young": 1e4, "rayleigh_stiffness": 2e-4}
    return {"file": str(path), "unit": "m", "model": "neo-hookean", **common}


def led(T: float, k: float, way: Callable[[float], Any], **tool: Any) -> dict[str, Any]:
    """A tool that a hand leads along a path."""
    times = np.arange(0.0, STEPS * T + 0.02, 0.02)
    path = [[float(time), *(float(place) for place in way(time))] for time in times]
    return {"user": 1, "hand": {"stiffness": k, "damping": 0.002 * k, "path": path}, **tool}


def ball(rng: np.random.Generator, T: float, k: float, top: float) -> dict[str, Any]:
    """It is pressed into a body and slid along it."""
    at = [*(rng.uniform(0.3, 0.7, 2) * SIDES[:2]).tolist(), top + 0.0085]
    deep, slide, rate = rng.uniform(0.006, 0.016), rng.uniform(-0.5, 0.5, 2) * SIDES[:2], rng.uniform(4.0, 12.0, 3)

    def way(s: float) -> list[float]:
        return [*(slide * np.sin(rate[:2] * s)).tolist(), 0.7 * deep * (np.cos(rate[2] * s) - 1.0)]

    return led(T, k, way, **BALL, at=at)


def grasp(rng: np.random.Generator, T: float, k: float, top: float) -> dict[str, Any]:
    """It pulls a body about."""
    at = (rng.uniform(0.3, 1.0, 3) * [*SIDES[:2], top]).tolist()
    size, rate = rng.uniform(0.01, 0.05) * rng.normal(size=3), rng.uniform(3.0, 12.0, 3)
    holds = {"kind": "grasp", "at": at, "radius": 0.012, "stiffness": k, "damping": 0.001 * k}
    return led(T, k, lambda s: size * np.sin(rate * s), **holds)


def scene(bodies: list[dict[str, Any]], kinds: list[Any], T: float, seed: int) -> dict[str, Any]:
    """One body, or two on each other on a plane, and what is done to them."""
    rng = np.random.default_rng(seed)
    k, two = float(10.0 ** rng.uniform(2.5, 3.8)), len(bodies) == 2
    above = SIDES[2] + 1e-4 if two else 0.0
    given: dict[str, Any] = {"body": bodies[0], "world": {"gravity": [0, 0, -9.81]}}
    if two:
        upper = {"name": "over", "at": [*(0.5 * SIDES[:2]), 0.5 * SIDES[2] + above]}
        given = {"bodies": [bodies[0] | {"name": "under"}, bodies[1] | upper], "world": given["world"]}
        given |= {"between": {"stiffness": 1e7, "friction": 0.3}}
        given["world"]["planes"] = [PLANE]
    given["tools"] = [kind(rng, T, k, SIDES[2] + above) for kind in kinds]
    return {**given, "network": ALONE, "steps": {"duration": STEPS * T, "period": T}}


def stepped(tables: dict[str, Any]) -> list[tuple[StepReport, dict[str, Any]]]:
    """Of every step what it booked, and the proxy after it; by a peer: the engine would compile for this alone."""
    seen: list[tuple[StepReport, dict[str, Any]]] = []

    def look(peer: Peer, report: StepReport, now: float, T: float) -> None:
        assert peer.tools is not None
        proxy = {name: field[0].copy() for name, field in peer.tools._asdict().items()}
        seen.append((report, proxy))

    Stepped(prepare(Scenario.make(**tables))).run(look)
    return seen


@pytest.mark.parametrize(
    ("bodies", "kinds", "T", "seed"),
    [
        ("solid", [ball], 0.04, 0),
        ("solid", [ball, grasp], 0.02, 3),
        ("die cells", [ball], 0.04, 4),
        ("die cells", [ball, grasp], 0.04, 5),
        ("cells cells", [ball], 0.01, 1),
        ("cells cells", [grasp], 0.04, 1),
        ("solid solid", [grasp], 0.04, 1),
        ("solid cells", [grasp], 0.04, 1),
        ("solid solid", [ball, grasp], 0.04, 2),
        ("cells cells", [ball, grasp], 0.02, 0),
        ("cells cells", [ball, grasp], 0.01, 4),
        ("solid solid", [ball, grasp], 0.01, 0),
        ("solid cells", [ball, grasp], 0.01, 5),
        ("solid", [ball], 0.04, 7),
        ("solid", [ball, grasp], 0.04, 4),
    ],
)
def test_the_balance_is_exact(solid: dict[str, Any], bodies: str, kinds: list[Any], T: float, seed: int) -> None:
    """What went astray, by 1e12 N or to no number at all, is not closed by the rounding of that."""
    tables = {"solid": solid, "cells": CELLS, "die": DIE}
    run = simulate(scene([tables[name] for name in bodies.split()], kinds, T, seed))
    assert run.attrs["energy_residual"] <= 1e-12
    assert np.isfinite(run["kinetic"].values).all()
    assert run["touching"].values.max() > 0.0


@pytest.mark.parametrize(("soft", "T", "seed"), [("solid", 0.02, 10), ("solid", 0.01, 11), ("cells", 0.02, 15)])
def test_what_holds_a_tool_back_is_told(solid: dict[str, Any], soft: str, T: float, seed: int) -> None:
    """A small ball strikes: in the step that ends before it gets there, no contact pushes, yet 3 to 6 N turn it."""
    rng = np.random.default_rng(seed)
    rng.choice([0.01, 0.02])
    at = [*(rng.uniform(0.0, 1.0, 2) * SIDES[:2]).tolist(), float(SIDES[2] + 0.003 + rng.uniform(0.001, 0.02))]
    aside = rng.uniform(-0.02, 0.02, 2).tolist()
    path = [[0, 0, 0, 0], [0.06, 0, 0, -0.03], [0.12, 0, 0, -0.03], [0.42, *aside, -0.03], [0.6, *aside, 0.02]]
    mass = 0.06
    tool = {
        "user": 1,
        "at": at,
        "mass": mass,
        "radius": 0.003,
        "stiffness": 1700.0,
        "friction": 0.9,
        "damping": 1.0,
        "hand": {"stiffness": 450.0, "damping": 1.2, "path": path},
    }
    seen = stepped(
        {
            "network": ALONE,
            "body": solid | {"young": 3e3, "rayleigh_stiffness": 1e-3}
            if soft == "solid"
            else CELLS | {"stiffness": 30.0},
            "world": {"gravity": [0, 0, -9.81], "planes": [PLANE]},
            "tools": [tool],
            "steps": {"duration": 0.6, "period": T},
        }
    )
    fields = "place", "rate", "touch_force", "drive_force"
    place, rate, touch, drive = (np.array([proxy[name][:3] for _, proxy in seen]) for name in fields)
    turned = 2.0 * mass / T * (np.diff(place, axis=0) / T - rate[:-1])
    pushed = touch[1:] + drive[1:]
    assert np.abs(turned - pushed).max() < 1e-10
    assert np.abs(turned).max() > 1.0


def test_a_body_that_no_tool_touches_and_that_goes_less_far_is_told_of() -> None:
    """In the first step, in which nothing touches anything yet."""
    (first, proxy), (second, _), *_ = stepped(scene([DIE, CELLS], [ball], 0.04, 4))
    assert proxy["touching"] == 0
    assert first.shortened > 0.0
    assert second.shortened == 0.0
    assert second.closure_factor <= CLOSURE_ALARM
