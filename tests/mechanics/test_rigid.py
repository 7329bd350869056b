"""Rigid bodies: momentum, energy and inertia by closed forms; what they rest on, slide on and bounce off."""

import numpy as np
import numpy.typing as npt
import pytest
from tests.mechanics.inside import lean, resist
from tests.mechanics.materials import Alone, rotation
from tests.mechanics.test_world import SLICK, TABLE, G, Standing, sliding

from cotouch.body import Body, rigid_box, rigid_cylinder, rigid_sphere
from cotouch.kernels import kernel
from cotouch.mechanics import BETA, BODY_LOSS, CLOSURE_ALARM, WORLD_LOSS, WORLD_STORED, BodyForce, Obstacle, Plane

Float = npt.NDArray[np.float64]
SIZE = (0.1, 0.06, 0.03)


def spun(body: Body, rate: tuple[float, ...], speed: tuple[float, ...] = (0.1, 0.2, -0.05)) -> Float:
    """Velocities of its nodes."""
    return np.cross(rate, body.rest - body.rest.mean(axis=0)) + np.array(speed)


def momenta(copy: Alone) -> Float:
    """Linear, and angular about the centre, (6,)."""
    place, velocity = copy.body.rest + copy.position, copy.velocity
    about, beside = place - place.mean(axis=0), velocity - velocity.mean(axis=0)
    return np.concatenate([(copy.mass * velocity).sum(axis=0), np.cross(about, copy.mass * beside).sum(axis=0)])


@pytest.mark.parametrize(("viscosity", "rate"), [(0.0, 1.0), (0.0, 10.0), (5e-4, 1.0)])
def test_what_tumbles_keeps_energy_and_momentum(viscosity: float, rate: float) -> None:
    body = rigid_box(SIZE, mass=0.5, viscosity=viscosity)
    copy = Alone(body, velocity=spun(body, (3.0 * rate, 8.0 * rate, -2.0 * rate)), tolerance=1e-15)
    start, before, lost, worst = copy.energy, momenta(copy), 0.0, 0.0
    for _ in range(10_000):
        had, did = copy.energy, copy.step(1e-3)
        lost += float(did[BODY_LOSS])
        worst = max(worst, abs(copy.energy - had + float(did[BODY_LOSS])))
        assert did[BETA] <= 1e-9
    after = momenta(copy)
    for part in (slice(0, 3), slice(3, 6)):
        assert np.linalg.norm(after[part] - before[part]) <= 1e-11 * np.linalg.norm(before[part])
    assert worst <= 2e-15 * start
    assert abs(copy.energy + lost - start) <= 1e-11 * start
    assert lost <= 1e-4 * start  # dampers of strain hardly feel it
    place = copy.position + body.rest
    lengths = [np.linalg.norm(x[:, None] - x[None], axis=2)[np.triu_indices(4, 1)] for x in (place, body.rest)]
    assert np.abs(lengths[0] / lengths[1] - 1.0).max() <= 2.0 * (10.0 * rate / 2000.0) ** 2


@pytest.mark.parametrize("axis", [0, 2])
def test_it_turns_as_fast_as_it_was_spun(axis: int) -> None:
    body, rate = rigid_box(SIZE, mass=0.5), np.zeros(3)
    rate[axis] = 20.0
    copy = Alone(body, velocity=spun(body, tuple(rate), (0.0, 0.0, 0.0)))
    for _ in range(500):
        copy.step(1e-3)
    turned = (body.rest - body.rest.mean(axis=0)) @ rotation(np.eye(3)[axis], 10.0).T
    # It spins a little slower than it was spun, as it swells by (Ω / ω)² about the axis.
    np.testing.assert_allclose(copy.position + body.rest, turned + body.rest.mean(axis=0), atol=4e-3 * SIZE[0])


def test_a_torque_turns_it_as_its_inertia_says() -> None:
    """Two opposite forces a lever apart, beside the closed forms of the moments."""
    for body, moment in (
        (rigid_box(SIZE, mass=2.0), 2.0 * (SIZE[0] ** 2 + SIZE[1] ** 2) / 12.0),
        (rigid_cylinder(0.03, 0.2, mass=2.0), 2.0 * 0.03**2 / 2.0),
        (rigid_sphere(0.04, mass=2.0), 2.0 * 0.4 * 0.04**2),
    ):
        about = body.rest - body.rest.mean(axis=0)
        mass = body.mass.diagonal()[::3]
        assert float((mass * (about[:, :2] ** 2).sum(axis=1)).sum()) == pytest.approx(moment, rel=1e-12)
        assert (
            np.abs((mass[:, None] * about).T @ about - np.diag(np.diag((mass[:, None] * about).T @ about))).max()
            < 1e-15
        )


@kernel
def leaning(
    force: BodyForce, memory: Float, x: Float, ahead: Float, rate: Float, T: float, out: Float, lanes: tuple[int, ...]
) -> None:
    lean(force.law, memory, x, ahead, rate, T, out, lanes)


@kernel
def resisting(
    force: BodyForce, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]
) -> None:
    resist(force.law, memory, x, ahead, rate, out, lanes)


def test_the_tangent_is_the_slope_of_the_force() -> None:
    body, rng, T, h = rigid_box(SIZE, mass=0.5), np.random.default_rng(1), 2e-3, 1e-6
    copy = Alone(body)
    x, rate = (copy.rows(rng.normal(scale=scale, size=(4, 3))) for scale in (0.01, 1.0))
    lanes, memory, tangent = copy.model.lanes, copy.state.memory, np.zeros((12, 12))
    leaning(copy.force, memory, x, x + T * rate, rate, T, tangent, lanes)
    for column in range(12):
        slope = np.zeros((4, 4))
        for sign in (1.0, -1.0):
            out, near = np.zeros((4, 4)), rate.copy()
            near[column // 3, column % 3] += sign * h
            resisting(copy.force, memory, x, x + T * near, near, out, lanes)
            slope += sign * out / (2.0 * h)
        np.testing.assert_allclose(tangent[:, column], slope[:, :3].ravel(), atol=1e-7 * np.abs(tangent).max())


def block(*, pull: float = G) -> Body:
    """A rigid cube of 1 kg and 0.1 m, from z = 0 upwards."""
    return rigid_box([0.1, 0.1, 0.1], mass=1.0, centre=[0.0, 0.0, 0.05]).with_gravity((0.0, 0.0, -pull))


@pytest.mark.parametrize("steps", [3_000, 30_000])
def test_a_block_rests(steps: int) -> None:
    """For six seconds, and for a minute."""
    standing = Standing(block(), TABLE, lift=-1e-4)
    slope = np.arctan(0.3)
    standing.tilt(slope, 300)
    standing.run(4000, 2e-3)
    standing.begun, standing.lost, settled = standing.energy, 0.0, standing.position
    force = standing.run(steps, 2e-3)
    assert np.abs(standing.position - settled).max() <= 1e-9
    assert standing.energy <= standing.begun + 1e-12 * standing.scale
    # Solved to a millionth of its weight: where it comes to rest below that is rounding's, another on each processor.
    assert force == pytest.approx([-G * np.sin(slope), 0.0, G * np.cos(slope)], abs=1e-6 * G)
    standing.check_ledger()


def test_friction_holds_to_a_thousandth_of_its_cone() -> None:
    # Nothing but the plane takes the rocking of a rigid block away.
    standing = Standing(block(), Obstacle(shape=Plane(), stiffness=1e7, loss=30.0, friction=0.5), lift=-1e-4)
    standing.run(200)
    standing.tilt(np.arctan(0.5 * 0.999), 2000)
    standing.run(1000)
    held = standing.position
    force = standing.run(200)
    assert np.abs(standing.position - held).max() <= 1e-7
    assert -force[0] / force[2] == pytest.approx(0.4995, rel=1e-4)
    standing.tilt(np.arctan(0.5 * 1.001), 1)
    standing.run(200)
    assert sliding(standing, np.arctan(0.5 * 1.001)) == pytest.approx(0.5, rel=1e-3)
    assert standing.beta <= CLOSURE_ALARM
    standing.check_ledger()


def test_falls_and_bounces_as_closed_forms_say() -> None:
    height, T = 0.01, 1e-4
    standing = Standing(block(), SLICK, lift=height)
    fall = np.sqrt(2.0 * height / G)
    steps = int(fall / T)
    standing.run(steps, T)
    assert standing.position[:, 2] == pytest.approx(height - 0.5 * G * (steps * T) ** 2, abs=1e-12)
    rate, speed, low = np.sqrt(1e7 * 0.1**2), G * fall, 0.0
    while standing.velocity.mean(axis=0)[2] < 0.0 or standing.ledger[WORLD_STORED] > 0.0:
        standing.run(1, T)
        low = min(low, float(standing.position[:, 2].mean()))
    assert -low == pytest.approx(G / rate**2 + np.hypot(G / rate**2, speed / rate), rel=0.02)
    assert standing.velocity.mean(axis=0)[2] == pytest.approx(speed, rel=0.03)  # strain takes the rest
    standing.check_ledger()


@pytest.mark.parametrize(("rate", "lost"), [(2e3, 0.17), (1e4, 0.0085), (5e4, 0.00035)])
def test_what_a_bounce_loses_its_own_dampers_take_at_any_step(rate: float, lost: float) -> None:
    """A plane so hard that the ball is not rigid beside it: the harder the ball, the less, whatever the steps."""
    ball = rigid_sphere(0.03, mass=0.1, centre=[0.0, 0.0, 0.03], rate=rate).with_gravity((0.0, 0.0, -G))
    for T in (2e-3, 2e-4):
        standing = Standing(ball, Obstacle(shape=Plane(), stiffness=1e8), lift=0.05)
        took = 0.0
        while standing.velocity.mean(axis=0)[2] <= 0.0 or standing.ledger[WORLD_STORED] > 0.0:
            standing.run(1, T)
            took += standing.ledger[BODY_LOSS]
            assert standing.ledger[WORLD_LOSS] == 0.0
        assert took / (0.1 * G * 0.05) == pytest.approx(lost, rel=0.2)


def test_a_ball_rolls_without_slipping() -> None:
    """Down a slope below the cone: 5/7 of what a slick one would gain."""
    ball = rigid_sphere(0.05, mass=1.0, centre=[0.0, 0.0, 0.05], resolution=24).with_gravity((0.0, 0.0, -G))
    standing = Standing(ball, Obstacle(shape=Plane(), stiffness=1e9, loss=1.0, friction=0.8), lift=-1e-5)
    standing.run(200)
    standing.tilt(0.1, 100)
    standing.run(200)
    before = standing.velocity.mean(axis=0)[0]
    standing.run(500)
    gained = (standing.velocity.mean(axis=0)[0] - before) / 0.5
    assert gained == pytest.approx(5.0 / 7.0 * G * np.sin(0.1), rel=0.05)
    assert standing.worst <= 1e-14 * standing.scale


def test_nothing_passes_at_ten_metres_a_second() -> None:
    hard = Obstacle(shape=Plane(), stiffness=1e7, friction=0.3)
    standing = Standing(block(), hard, lift=0.02, speed=(1.0, 0.0, -10.0))
    for _ in range(60):
        standing.run(1)
        assert (standing.body.rest + standing.position)[:, 2].min() > -0.06
    assert standing.velocity.mean(axis=0)[2] > 0.0
    assert standing.worst <= 1e-14 * standing.scale
