"""Tools and bodies that meet so fast that no energy of the skin stops them within a step."""

from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from tests.mechanics.inside import JAMMED, catching, stretch_tool
from tests.mechanics.materials import made as soft
from tests.mechanics.pressing import Pressed

from cotouch.body import Body, lattice
from cotouch.mechanics import BODY_LOSS, ELASTIC, KINETIC, TOUCHED

Float = npt.NDArray[np.float64]
Caught = list[bool]
MASS = 0.02
SHEET: dict[str, Any] = {"neighbours": 18, "model": "spring-network", "mass": 0.05, "stiffness": 500.0}
BLOCK: dict[str, Any] = {"mass": 0.1, "stiffness": 1000.0}
# Shape, spacing and kind of each body, and where on its top it is hit.
KINDS: dict[str, tuple[tuple[int, int, int], float, dict[str, Any]]] = {
    "sheet of one layer": ((9, 9, 1), 0.01, SHEET),
    "sheet of two layers": ((9, 9, 2), 0.01, SHEET),
    "cells": ((5, 5, 3), 0.015, {**BLOCK, "model": "cells"}),
    "linear": ((5, 5, 3), 0.015, BLOCK),
}


def made(name: str, **more: Any) -> tuple[Body, float]:
    """A body, and how high its top is [m]."""
    shape, spacing, kind = KINDS[name]
    return lattice(shape, damping=0.5, spacing=spacing, **{**kind, **more}), (shape[2] - 1) * spacing


def above(name: str, radius: float, height: float, **more: Any) -> Pressed:
    """A ball at some height over a body."""
    body, top = made(name, **more)
    copy = Pressed(body, tolerance=1e-6)
    copy.tools.radius[:], copy.tools.mass[:] = radius, MASS
    copy.tools.place[0, :3] = [0.043, 0.041, top + radius + height]
    return copy


def momentum(copy: Pressed) -> Float:
    """Of body and ball."""
    own = copy.body.mass.sum(axis=1)
    weight = np.asarray(own).reshape(copy.body.nodes, -1)[:, :1]
    return (weight * copy.copy.velocity).sum(axis=0) + MASS * copy.tools.rate[0, :3]


def passes(start: Float, end: Float, before: Float, after: Float, corner: npt.NDArray[np.int32]) -> bool:
    """Whether a point that moved straight was in a triangle, of corners that did so as well, at any time."""
    low, high = np.minimum(start, end)[corner].min(axis=1), np.maximum(start, end)[corner].max(axis=1)
    near = ((low <= np.maximum(before, after)) & (high >= np.minimum(before, after))).all(axis=1)
    times = np.array([0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0])
    for f in np.flatnonzero(near):
        begun, moved = start[corner[f]] - before, (end - start)[corner[f]] - (after - before)
        for root in np.roots(np.polyfit(times, [np.linalg.det(begun + t * moved) for t in times], 3)):
            if abs(root.imag) < 1e-7 and 0.0 <= root.real <= 1.0:
                a, b, c = begun + root.real * moved
                shares = np.linalg.lstsq(np.stack([b - a, c - a], axis=1), -a, rcond=None)[0]
                if shares.min() >= 0.0 and shares.sum() <= 1.0:
                    return True
    return False


def run(copy: Pressed, steps: int, T: float) -> Caught:
    """Steps in which the ball stays on its side, energy stays in balance, and a push has its bound; which was held."""
    caught, work = [], copy.contact.work
    for _ in range(steps):
        start, before = copy.skin_place(), copy.tools.place[0, :3].copy()
        copy.step(T)
        assert not passes(start, copy.skin_place(), before, copy.tools.place[0, :3], copy.surface.corner)
        caught.append(bool(work.caught[0, 0]))
        if caught[-1]:
            assert np.linalg.norm(work.pull[0, :3]) <= work.caught[0, 10] * (1.0 + 1e-12)
    assert copy.residual <= 1e-13 * copy.in_play
    return caught


@pytest.mark.parametrize("who", ["ball", "body"])
@pytest.mark.parametrize(("speed", "T"), [(1.0, 2.5e-4), (3.0, 1e-3), (10.0, 1e-3), (10.0, 2.5e-4)])
@pytest.mark.parametrize("radius", [0.0005, 0.003])
@pytest.mark.parametrize("name", KINDS)
def test_what_a_ball_loses_a_free_body_gets(name: str, radius: float, speed: float, T: float, who: str) -> None:
    """To rounding, whether it is held back or stopped by the skin; and the two part again, with no more energy."""
    copy = above(name, radius, 0.003)
    if who == "ball":
        copy.tools.rate[0, :3] = [0.2 * speed, 0.0, -speed]
    else:
        copy.state.velocity[:, 2] = speed
    copy.begin()
    begun, most, caught = momentum(copy), copy.energy, []
    came = speed
    for _ in range(round(0.02 / T)):
        caught += run(copy, 1, T)
        assert momentum(copy) == pytest.approx(begun, abs=1e-11 * float(np.linalg.norm(begun)))
        assert copy.energy <= most * (1.0 + 1e-12)
        most = copy.energy
    assert any(caught) or speed < 10.0
    parts = copy.tools.rate[0, 2] - copy.copy.velocity[:, 2].mean()
    assert -0.2 * came < parts < came


@pytest.mark.parametrize("name", KINDS)
def test_what_a_hand_gives_is_all_that_tool_and_body_get(name: str) -> None:
    """A hand pushes a ball through a body at 10 m/s: it goes before the ball, which does not stick in it."""
    copy, T, way = above(name, 0.003, 0.02), 1e-3, 0.12
    place = copy.tools.place[0, :3].copy()
    copy.begin()
    caught: Caught = []
    greatest = 0.0
    for n in range(40):
        ends = [place - [0.0, 0.0, min(10.0 * T * k, way)] for k in (n, n + 1)]
        copy.lead(ends[0], ends[1], stiffness=2e4, damping=20.0)
        before = momentum(copy)
        caught += run(copy, 1, T)
        given = T * copy.tools.drive_force[0, :3]
        greatest = max(greatest, float(np.linalg.norm(copy.tools.drive_force[0])))
        if caught[-1]:
            assert momentum(copy) - before == pytest.approx(given, abs=1e-10)
    assert sum(caught) > 3
    assert greatest < 600.0  # of one that stays where it is 2,000 N
    assert copy.copy.velocity[:, 2].mean() < -1.0


def test_a_jammed_ball_comes_free() -> None:
    """Where it would go nowhere, velocities are not just turned back for ever: it loses motion, and goes on."""
    copy = Pressed(soft("st-venant-kirchhoff", viscosity=2e-4), tolerance=1e-6)
    copy.tools.radius[:], copy.tools.mass[:], copy.tools.stiffness[:] = 0.003, 0.019, 4950.0
    copy.tools.place[0, :3], copy.tools.rate[0, :3] = [0.00992, 0.01258, 0.0245], [1.60322, 2.10986, -4.72688]
    copy.begin()
    jammed, lacks = 0, 0.0
    for _ in range(60):
        own = copy.ledger[KINETIC] + copy.ledger[ELASTIC]
        copy.step(3.241e-3)
        jammed += int(copy.contact.work.goal[0] < JAMMED)
        gained = copy.touch_ledger[TOUCHED] - copy.ledger[BODY_LOSS]
        lacks = max(lacks, abs(float(copy.ledger[KINETIC] + copy.ledger[ELASTIC] - own - gained)))
    assert 0 < jammed <= 5
    assert lacks <= 1e-13 * copy.in_play  # what it loses with the ball, the ball did on it
    assert copy.residual <= 1e-13 * copy.in_play


def test_a_way_that_overflowed_comes_to_rest() -> None:
    """As the last of all attempts at a step, which must be a number: rates, and what a grasp holds by them."""
    work = above("cells", 0.003, 0.01).contact.work
    arrays = (work.mean[:, :3], work.skin[:, :3], work.held[:, 1:])
    for number in (np.inf, -np.inf, np.nan):
        for array in arrays:
            array[:] = number
        stretch_tool.py_func(work, 0, 0.0)
        assert not any(array.any() for array in arrays)
    for array in arrays:
        array[:] = 3.0
    stretch_tool.py_func(work, 0, 0.5)
    assert (work.mean[:, :3] == 1.5).all()
    assert (work.skin[:, :3] == 1.5).all()
    assert work.held[0, 1:].tolist() == [1.5, 0.75]


def test_no_guess_asks_for_more_than_turns_the_tool_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """A gap that does not follow the push, as the body is guessed to be elsewhere, asks for no 1e12 N."""
    copy, T, most, wanted = above("linear", 0.01, 0.01), 0.02, 60.0, 1e-3
    copy.begin()
    copy.step(1e-3)
    monkeypatch.setattr(catching, "_rate", catching._rate.py_func)
    follow: Any = catching._follow_push.py_func
    work = copy.contact.work
    work.caught[0, :] = [1.0, 0.0, 0.0, T / 5.0, 0.0, wanted, 1.0, 0.0, 0.0, 0.0, most]
    work.aside[0, :3], work.mean[0, :3], work.inertia[0], work.pull[:] = [0.0, 0.0, 1.0], [0.0, 0.0, -6.0], 5.0, 0.0
    pushes, gaps = [0.0], []
    for _ in range(6):
        done = follow(copy.surface, work, copy.tools, 0, T)
        pushes.append(float(work.pull[0, 2]))
        gaps.append(float(wanted - work.aside[1, 2]))
        work.mean[0, 2] += 1e-9
    more = np.diff(pushes)
    assert more[0] == pytest.approx((wanted - gaps[0]) * work.inertia[0] / T)  # as the tool does alone, at first
    assert pushes[-1] == most
    assert done
