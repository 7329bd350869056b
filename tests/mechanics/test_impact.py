"""What is free keeps its momentum, however hard it is hit and however far its steps are shortened."""

import numpy as np
import pytest
from tests.mechanics.materials import EVERY, Alone, bent, made
from tests.mechanics.test_meeting import Several

from cotouch.body import lattice, rigid_sphere
from cotouch.mechanics import SHORTENED, Between, closed_settle

# Of the momentum, what closures of less than a millionth of the energy may take.
SLIGHT = 1e-6
# Of forty steps, so many may be shortened; which ones, rounding decides.
FEW = 8
RADIUS, GAP, SPEED = 0.01, 0.013, 10.0


@pytest.mark.parametrize(("mass", "T"), [(0.02, 1e-3), (0.2, 2e-3), (0.02, 5e-3)])
def test_a_ball_thrown_at_a_free_sheet_gives_its_momentum_to_it(mass: float, T: float) -> None:
    """No foundation of theirs stops it within a step of 10 to 50 mm: the two part as fast as they came."""
    sheet = lattice((7, 7, 2), mass=0.05, stiffness=1e3, damping=1.0, spacing=0.02, model="cells")
    pair = Several(
        (sheet, (0.0,) * 3, (0.0,) * 3),
        (rigid_sphere(RADIUS, mass=mass, resolution=4), (0.003, 0.002, 0.01 + RADIUS + GAP), (0.0,) * 3),
        between=Between(stiffness=1e7, friction=0.3),
        speeds=((0.0,) * 3, (0.0, 0.0, -SPEED)),
    )
    begun, momentum, shortened = pair.energy, pair.momentum(), 0
    for _ in range(round(0.03 / T)):
        pair.run(1, T)
        shortened += pair.ledger[SHORTENED] > 0.0
        assert pair.momentum() == pytest.approx(momentum, abs=SLIGHT * mass * SPEED)
        assert pair.place(1)[2] - pair.place(0)[2] > -RADIUS - GAP - 0.01
    assert shortened > 0
    assert pair.energy + pair.lost == pytest.approx(begun, rel=1e-12)
    assert pair.momentum(1)[2] / mass > pair.momentum(0)[2] / 0.05 + 0.5 * SPEED


@pytest.mark.parametrize("name", [name for name in EVERY if "floating" not in name and name != "rigid"])
def test_what_flies_and_rings_in_steps_that_are_too_long_flies_on(name: str) -> None:
    """Its steps are closed, or shortened about the centre: how fast it flies makes no difference within it."""
    body = made(name)
    start, speed = bent(body, 0.5), np.array([3.0, -2.0, 1.0])
    copy = Alone(body, start, np.tile(speed, (body.nodes, 1)))
    closed_settle(copy.model.operator, copy.force, copy.state, copy.work, copy.ledger, copy.model.lanes)
    weight = copy.mass / copy.mass.sum()
    shortened, place = 0, (weight * start).sum(axis=0)
    for k in range(40):
        shortened += copy.step(0.02)[SHORTENED] > 0.0
        assert (weight * copy.velocity).sum(axis=0) == pytest.approx(speed, abs=1e-5)
        assert (weight * copy.position).sum(axis=0) == pytest.approx(place + 0.02 * (k + 1) * speed, abs=1e-5)
    assert shortened <= FEW
