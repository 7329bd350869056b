"""A truncated body under a fingertip yields as the whole one does, though its shapes leave out what is local."""

import numpy as np
import pytest
from tests.mechanics.pressing import Pressed

from cotouch.body import Body, lattice

T, STEPS = 2e-3, 2500
PRESS, STIFF = 200.0, 1e5


def pressed(body: Body, place: tuple[float, float], *, soft: bool) -> float:
    """Stiffness that a fingertip pressed onto the top feels at rest, in a copy of half the body [N/m]."""
    copy = Pressed(body, basis="auto", copies=2, soft=soft)
    tools, top = copy.tools, 0.05
    tools.radius[0], tools.stiffness[0] = 0.0105, STIFF
    tools.place[0, :3] = [*place, top + 0.0105]
    tools.drive_stiffness[0], tools.drive_damping[0] = PRESS, 20.0
    tools.drive_start[0] = tools.drive_end[0] = [*place, top, 0.0]
    copy.copy.local_damping[:] = 5.0
    copy.begin()
    for _ in range(STEPS):
        copy.step(T)
    assert np.abs(tools.rate).max() < 1e-4
    return float(tools.touch_force[0, 2] / (top + 0.0105 - tools.place[0, 2]))


@pytest.fixture(scope="module")
def body() -> Body:
    """A block that the ground holds at its bottom."""
    return lattice((9, 9, 6), mass=1.0, stiffness=300.0, spacing=0.01, ground="z-", ground_stiffness=500.0)


@pytest.mark.parametrize("place", [(0.0413, 0.0391), (0.0262, 0.0581)])
def test_missing_compliance_is_in_series_with_the_contact(body: Body, place: tuple[float, float]):
    whole = pressed(body, place, soft=True)
    few = body.truncated(modes=30)
    assert abs(pressed(few, place, soft=True) / whole - 1.0) < 0.12
    assert pressed(few, place, soft=False) > 1.2 * whole


def test_a_whole_body_has_none(body: Body):
    assert Pressed(body, soft=True).surface.soft.size == 0
