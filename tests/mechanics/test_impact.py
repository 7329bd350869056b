"""What is free keeps its momentum, however hard it is hit and however far its steps are shortened."""

import numpy as np
import pytest
from tests.mechanics.materials import EVERY, Alone, bent, made
from tests.mechanics.test_meeting import Several

from cotouch.body import Body, lattice, rigid_sphere
from cotouch.mechanics import (
    BODY_LOSS,
    SHORTENED,
    SUPPLIED,
    WORLD_FORCE,
    Between,
    Links,
    Obstacle,
    Plane,
    Ports,
    closed_settle,
    closed_step,
)

# Of the momentum, what closures of less than a millionth of the energy may take.
SLIGHT = 1e-6
# Of forty steps, so many may be shortened; which ones, rounding decides.
FEW = 8
RADIUS, GAP, SPEED = 0.01, 0.013, 10.0


def sheet() -> Body:
    """Thin and soft, of 50 g."""
    return lattice((7, 7, 2), mass=0.05, stiffness=1e3, damping=1.0, spacing=0.02, model="cells")


def thrown_at_sheet(mass: float, copies: int = 1) -> Several:
    """A ball on its way down to a sheet."""
    return Several(
        (sheet(), (0.0,) * 3, (0.0,) * 3),
        (rigid_sphere(RADIUS, mass=mass, resolution=4), (0.003, 0.002, 0.01 + RADIUS + GAP), (0.0,) * 3),
        between=Between(stiffness=1e7, friction=0.3),
        speeds=((0.0,) * 3, (0.0, 0.0, -SPEED)),
        copies=copies,
    )


@pytest.mark.parametrize(("mass", "T"), [(0.02, 1e-3), (0.2, 2e-3), (0.02, 5e-3)])
def test_a_ball_thrown_at_a_free_sheet_gives_its_momentum_to_it(mass: float, T: float) -> None:
    """No foundation of theirs stops it within a step of 10 to 50 mm: the two part as fast as they came."""
    pair = thrown_at_sheet(mass)
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


@pytest.mark.parametrize(("mass", "T"), [(0.02, 1e-3), (0.2, 1e-3), (0.2, 2e-3), (0.02, 5e-3)])
def test_a_hand_at_a_corner_gives_no_more_momentum_than_it_pushes(mass: float, T: float) -> None:
    """The ball is not turned back as by a wall: the hand holds 50 g with 300 N/m."""
    pair = thrown_at_sheet(mass)
    rows, still = pair.model.operator_rows, [np.zeros((1, 4)) for _ in range(4)]
    pair.ports = Ports(np.zeros(1, np.int32), np.zeros((0, rows)), np.array([300.0]), np.array([3.0]), *still)
    shortened, greatest = 0, pair.energy
    for _ in range(round(0.01 / T)):
        energy, momentum = pair.energy, pair.momentum()
        ledger = pair.step(T)
        shortened += ledger[SHORTENED] > 0.0
        pushed = T * pair.ports.force[0, :3]
        assert pair.momentum() == pytest.approx(momentum + pushed, abs=SLIGHT * mass * SPEED)
        assert pair.energy == pytest.approx(energy + ledger[SUPPLIED] - ledger[BODY_LOSS], abs=1e-13 * greatest)
    assert shortened > 0
    assert pair.momentum(1)[2] / mass < 0.65 * SPEED


@pytest.mark.parametrize("T", [2e-3, 5e-3])
def test_a_ball_thrown_at_a_block_from_beside_pushes_it_along_the_plane(T: float) -> None:
    """Friction of 0.3 times its weight stops neither."""
    mass, weight, plane = 0.02, 9.81, Obstacle(shape=Plane(), stiffness=1e7, friction=0.3)
    block = lattice((4, 4, 3), mass=0.1, stiffness=1e3, damping=1.0, spacing=0.02, model="cells")
    pair = Several(
        (block, (0.0, 0.0, 0.02), (0.0,) * 3),
        (rigid_sphere(RADIUS, mass=mass, resolution=4), (-0.03 - RADIUS - GAP, 0.003, 0.022), (0.0,) * 3),
        between=Between(stiffness=1e7, friction=0.3),
        obstacles=(plane,),
        pull=weight,
        speeds=((0.0,) * 3, (SPEED, 0.0, 0.0)),
    )
    shortened, falls = 0, np.array([0.0, 0.0, -weight * float(pair.mass.sum())])
    for _ in range(round(0.01 / T)):
        momentum = pair.momentum()
        ledger = pair.step(T)
        shortened += ledger[SHORTENED] > 0.0
        given = T * (falls + ledger[WORLD_FORCE : WORLD_FORCE + 3])
        assert pair.momentum() == pytest.approx(momentum + given, abs=10.0 * SLIGHT * mass * SPEED)
    assert shortened > 0
    assert pair.momentum(0)[0] / 0.1 > 0.2 * SPEED


@pytest.mark.parametrize("spring", [30.0, 1000.0])
def test_of_a_hit_in_two_copies_links_take_the_momentum_that_they_give(spring: float) -> None:
    """Each copy is hit by its own ball, and pulled to where the other was a step ago."""
    mass, T, steps = 0.2, 2e-3, 8
    copies = [thrown_at_sheet(mass, copies=2) for _ in range(2)]
    shortened = 0
    samples = [copy.state.position.copy() for copy in copies]
    for _ in range(steps):
        middles = []
        for k, copy in enumerate(copies):
            other, state, model = samples[1 - k], copy.state, copy.model
            links = Links(np.array([spring]), np.zeros(1, np.int32), np.zeros(1, np.int64), other[None])
            start, momentum, energy, work = state.position.copy(), copy.momentum(), copy.energy, np.zeros(1)
            args = np.zeros(1), np.zeros(1), T, -1, copy.work, copy.ledger, work, *copy.solver, model.lanes
            closed_step(model.operator, copy.force, state, links, copy.ports, *args)
            shortened += copy.ledger[SHORTENED] > 0.0
            middles.append(0.5 * (start + state.position))
            pulls = spring * (model.operator.weight[0][:, None] * (other - middles[-1])).sum(axis=0)[:3]
            # A copy's masses are those of the whole body, of which it takes its share.
            given = T * pulls / model.operator.copy_scale
            assert copy.momentum() == pytest.approx(momentum + given, abs=SLIGHT * mass * SPEED)
            assert copy.energy == pytest.approx(energy + work[0] - copy.ledger[BODY_LOSS], abs=1e-12)
        samples = middles
    assert shortened > 0
