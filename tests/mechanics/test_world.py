"""Planes and boxes that a body meets: what rests, slides, falls and bounces, against closed forms."""

import numpy as np
import numpy.typing as npt
import pytest
import scipy.sparse as sp
from tests.mechanics.inside import shortened
from tests.mechanics.materials import Alone, boxes

from cotouch.body import Body, GridModel, Placed, body_from_tetrahedra, chain, lattice, rigid_box, together
from cotouch.errors import BodyError, UnsupportedError
from cotouch.mechanics import (
    BETA,
    BODY_LOSS,
    CLOSURE,
    CLOSURE_ALARM,
    EXTRA_LOSS,
    KINETIC,
    LOCAL_LOSS,
    SHORTENED,
    WORLD_FORCE,
    WORLD_LOSS,
    WORLD_STORED,
    Between,
    Box,
    Obstacle,
    Plane,
    Solid,
    deepest_point,
    model,
)

Float, Int = npt.NDArray[np.float64], npt.NDArray[np.int64]
G, SIDE = 9.81, 0.1
# Rests at a depth of 98.1 µm with a weight of 1 kg on it.
TABLE = Obstacle(shape=Plane(), stiffness=1e7, loss=1.0, friction=0.5, kinetic=0.4)
SLICK = Obstacle(shape=Plane(), stiffness=1e7)


def cube(
    nodes: int = 3, *, stiffness: float = 1e4, damping: float = 5.0, kind: GridModel = "springs", pull: float = G
) -> Body:
    """A cube of 1 kg and 0.1 m, from z = 0 upwards."""
    return lattice(
        (nodes, nodes, nodes),
        mass=1.0,
        stiffness=stiffness,
        damping=damping,
        spacing=SIDE / (nodes - 1),
        model=kind,
    ).with_gravity((0.0, 0.0, -pull))


class Standing(Alone):
    """A cube among obstacles, and a ledger of its own."""

    def __init__(
        self, body: Body, *obstacles: Obstacle, lift: float = 0.0, speed: tuple[float, ...] = (0.0, 0.0, 0.0)
    ) -> None:
        place = np.tile([0.0, 0.0, lift], (body.nodes, 1))
        super().__init__(body, place, np.tile(speed, (body.nodes, 1)), obstacles=obstacles)
        self.begun = self.energy
        self.scale = G * SIDE  # of its weight, over its own height
        self.lost = self.worst = self.beta = 0.0
        self.shortened = 0

    def run(self, steps: int, T: float = 1e-3) -> Float:
        """So many steps; returns the force of the obstacles in the last."""
        for _ in range(steps):
            before, did = self.energy, self.step(T)
            lost = did[BODY_LOSS] + did[LOCAL_LOSS] + did[EXTRA_LOSS]
            assert did[WORLD_LOSS] >= 0.0
            self.lost += lost
            self.scale = max(self.scale, abs(self.energy), self.lost)
            self.worst = max(self.worst, abs(self.energy - before + lost))
            self.beta = max(self.beta, float(did[BETA]))
            self.shortened += did[SHORTENED] > 0.0
        return self.ledger[WORLD_FORCE : WORLD_FORCE + 3].copy()

    def lean(self, angle: float) -> None:
        """Turns gravity towards x, as if the plane leaned."""
        pull = G * np.array([np.sin(angle), 0.0, -np.cos(angle), 0.0])
        self.force = self.force._replace(gravity=np.tile(pull, (self.force.gravity.shape[0], 1)))

    def tilt(self, angle: float, steps: int) -> None:
        """Leans the plane slowly."""
        for k in range(steps):
            self.lean(angle * (k + 1) / steps)
            self.step(1e-3)
        self.begun, self.lost = self.energy, 0.0

    def check_ledger(self) -> None:
        assert self.worst <= 1e-14 * self.scale
        assert abs(self.energy - self.begun + self.lost) <= 1e-12 * self.scale


def test_a_block_rests_for_a_minute() -> None:
    block = Standing(cube(2), TABLE, lift=-1e-4)
    slope = np.arctan(0.3)
    block.tilt(slope, 300)
    block.run(700, 2e-3)
    block.begun, block.lost, settled = block.energy, 0.0, block.position
    force = block.run(30_000, 2e-3)
    assert np.abs(block.position - settled).max() <= 1e-9
    assert block.energy <= block.begun + 1e-12 * block.scale
    # Solved to a millionth of its weight: where it comes to rest below that is rounding's, another on each processor.
    assert force == pytest.approx([-G * np.sin(slope), 0.0, G * np.cos(slope)], abs=1e-6 * G)
    block.check_ledger()


@pytest.mark.parametrize("shape", [Plane(), Box((2.0, 2.0, 0.2), (0.3, 0.0, -0.1))])
def test_friction_holds_to_a_thousandth_of_its_cone(shape: Plane | Box) -> None:
    block = Standing(cube(), Obstacle(shape=shape, stiffness=1e7, loss=1.0, friction=0.5), lift=-1e-4)
    block.run(200)
    block.tilt(np.arctan(0.5 * 0.999), 800)
    block.run(200)
    held = block.position
    force = block.run(200)
    assert np.abs(block.position - held).max() <= 1e-7
    assert -force[0] / force[2] == pytest.approx(0.4995, rel=1e-4)
    block.tilt(np.arctan(0.5 * 1.001), 1)
    block.run(200)
    assert sliding(block, np.arctan(0.5 * 1.001)) == pytest.approx(0.5, rel=1e-3)
    assert block.beta <= CLOSURE_ALARM
    block.check_ledger()


def test_what_is_pressed_unevenly_holds_as_one_though_what_slides_is_held_less() -> None:
    """Its upper side is pressed less and slips first, but does not slide before the lower side slips."""
    block = Standing(cube(), Obstacle(shape=Plane(), stiffness=1e7, loss=1.0, friction=0.5, kinetic=0.25), lift=-1e-4)
    below, above = np.arctan(0.5 * 0.999), np.arctan(0.5 * 1.001)
    block.tilt(below, 1500)
    block.run(200)
    held = block.position
    force = block.run(200)
    assert np.abs(block.position - held).max() <= 1e-6
    assert -force[0] / force[2] == pytest.approx(0.4995, rel=1e-4)
    block.tilt(above, 1)
    block.run(600)
    assert sliding(block, above) == pytest.approx(0.25, rel=1e-3)
    block.check_ledger()


@pytest.mark.parametrize("friction", [0.0, 0.4])
def test_what_slides_as_a_whole_is_not_closed_by_what_it_hardly_does_within(friction: float) -> None:
    """Dampers took nearly all motion about the centre; what forces of the ground are off by is much beside that."""
    points, corners = boxes((3, 3, 3), 0.02)
    points[13] += [0.004, -0.003, 0.002]  # no two elements alike
    body = body_from_tetrahedra(
        (points, corners), unit="m", frame="floating", young=5e4, density=800.0, rayleigh_stiffness=2e-3
    )
    slope = np.arctan(0.44)
    heavy = body.with_gravity((G * np.sin(slope), 0.0, -G * np.cos(slope)))
    ground = Obstacle(shape=Plane(), stiffness=1e7, loss=5.0, friction=friction)
    copy = Alone(heavy, obstacles=[ground])
    factors = [float(copy.step(1e-3)[BETA]) for _ in range(1000)]
    assert max(factors[200:]) <= 1e-3
    assert abs(copy.ledger[CLOSURE]) <= 1e-6 * copy.ledger[KINETIC]


def test_what_comes_in_within_a_step_is_pushed_in_that_step() -> None:
    """Half of its way is free; a point that is out of reach is not asked, one that comes within reach is."""
    block = Standing(cube(2, pull=0.0), TABLE, lift=5e-4, speed=(0.3, 0.0, -1.0))
    before = block.velocity.mean(axis=0)
    force = block.run(1)
    assert force[2] > 10.0
    assert block.velocity.mean(axis=0) - before == pytest.approx(1e-3 * force, rel=1e-4, abs=1e-6)
    assert block.beta <= CLOSURE_ALARM
    far = Standing(cube(2, pull=0.0), TABLE, lift=1.1e-3, speed=(0.3, 0.0, -1.0))
    assert not far.run(1).any()
    far.check_ledger()


def sliding(block: Standing, angle: float) -> float:
    """The coefficient of friction, by how much faster a block becomes while it slides down."""
    before = block.velocity.mean(axis=0)[0]
    force = block.run(200)
    gained = (block.velocity.mean(axis=0)[0] - before) / 0.2
    assert -force[0] / force[2] <= (1.0 + 1e-12) * 0.5
    return float(np.tan(angle) - gained / (G * np.cos(angle)))


def test_what_slides_has_kinetic_friction() -> None:
    block = Standing(cube(), TABLE, lift=-1e-4)
    block.lean(np.arctan(0.6))
    block.run(600)
    assert sliding(block, np.arctan(0.6)) == pytest.approx(0.4, rel=1e-3)
    assert block.beta <= CLOSURE_ALARM


def test_falls_and_bounces_as_closed_forms_say() -> None:
    height, T = 0.01, 5e-5
    block = Standing(cube(2, stiffness=1e7, damping=0.0), SLICK, lift=height)
    fall = np.sqrt(2.0 * height / G)
    steps = int(fall / T)
    block.run(steps, T)
    assert block.position[:, 2] == pytest.approx(height - 0.5 * G * (steps * T) ** 2, abs=1e-12)
    # On the plane: a mass of 1 kg on a spring of 1e5 N/m, pressed by its weight.
    rate, speed = np.sqrt(1e7 * SIDE**2), G * fall
    low, lasted = 0.0, 0
    while block.velocity.mean(axis=0)[2] < 0.0 or block.ledger[WORLD_STORED] > 0.0:
        block.run(1, T)
        low, lasted = min(low, float(block.position[:, 2].mean())), lasted + 1
    assert -low == pytest.approx(G / rate**2 + np.hypot(G / rate**2, speed / rate), rel=0.02)
    assert lasted * T == pytest.approx((np.pi + 2.0 * np.arctan(G / rate / speed)) / rate, rel=0.03)
    assert block.velocity.mean(axis=0)[2] == pytest.approx(speed, rel=0.01)
    assert block.beta <= 1e-3
    block.check_ledger()


@pytest.mark.parametrize("kind", ["springs", "cells"])
@pytest.mark.parametrize("shape", [Plane(), Box((0.5, 0.5, 0.03), (0.05, 0.05, -0.0151), (0.0, 0.1, 0.2))])
def test_nothing_passes_at_ten_metres_a_second(kind: GridModel, shape: Plane | Box) -> None:
    soft = Obstacle(shape=shape, stiffness=1e5 if isinstance(shape, Box) else 1e7, friction=0.3)
    block = Standing(cube(kind=kind), soft, lift=0.02, speed=(1.0, 0.0, -10.0))
    for _ in range(40):
        block.run(1)
        # The far side of the box is 0.03 m away.
        assert (block.body.rest + block.position)[:, 2].min() > -0.06
    assert block.velocity.mean(axis=0)[2] > 0.0
    assert block.worst <= 1e-14 * block.scale


def test_two_copies_in_step_are_one_body() -> None:
    alone, shared = (Standing(cube(2), TABLE, lift=0.001) for _ in range(2))
    shared.model = model(shared.body, copies=2, obstacles=[TABLE])
    for _ in range(30):
        alone.run(1)
        shared.step(1e-3)
    assert np.abs(alone.position - shared.position).max() <= 1e-12
    assert 2.0 * shared.ledger[WORLD_FORCE : WORLD_FORCE + 3] == pytest.approx(
        alone.ledger[WORLD_FORCE : WORLD_FORCE + 3], abs=1e-9
    )


def test_depth_in_a_turned_box() -> None:
    ready = model(
        cube(2, pull=0.0), obstacles=[Obstacle(shape=Box((0.2, 0.3, 0.4), (1.0, 2.0, 3.0), (0.0, 0.0, np.pi / 2)))]
    )
    world = None if ready.force is None else ready.force.world
    assert world is not None
    size = 0.3 / 2  # along x: the box is turned, so its second side lies there
    for x, deep in ((1.0, 0.1), (1.0 + size - 0.02, 0.02), (1.0 - size - 0.05 - SIDE, -0.05)):
        # Points lie a little within the sides that they stand for: look along x, at the middle of a face.
        place = np.tile(np.array([x, 2.0, 3.0]) - SIDE / 2, (8, 1)) * np.array([1.0, 1.0, 1.0])
        if deep < 0.0:
            place[:, 0] = x
        found, which = deepest_point(world, ready.unturned(), ready.to_rows(place))
        assert which == 0
        assert (found > 0.0) == (deep > 0.0)
        if deep < 0.0:
            assert found == pytest.approx(deep, abs=1e-12)


def bar(sides: int) -> tuple[Float, Int]:
    """A round bar of 2 m: long triangles along it, short ones at its ends."""
    turn = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([0.05 * np.cos(turn), 0.05 * np.sin(turn), np.ones(sides)], axis=1)
    places = np.concatenate([ring * [1, 1, -1], ring, [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]])
    a = np.arange(sides)
    b = np.roll(a, -1)
    middle, top = np.full(sides, 2 * sides), np.full(sides, 2 * sides + 1)
    wall = [(a, b, b + sides), (a, b + sides, a + sides)]
    return places, np.concatenate([np.stack(t, axis=1) for t in (*wall, (b, a, middle), (a + sides, b + sides, top))])


def test_only_what_is_long_is_halved() -> None:
    """The surface stays closed and what it was, and no triangle is longer than it may be."""
    places, coarse = bar(20)
    corners, origin = coarse, np.arange(coarse.shape[0], dtype=np.int64)
    finer, carry, longest = places, sp.csr_array(sp.eye_array(places.shape[0])), np.inf
    while longest > 0.05 and corners.shape[0] < 100_000:
        finer, corners, carry, origin, longest = shortened(finer, corners, carry, origin, 0.05)
    sides = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    assert np.linalg.norm(finer[sides[:, 0]] - finer[sides[:, 1]], axis=1).max() == longest <= 0.05
    assert np.unique(sides, axis=0).shape == sides.shape
    assert np.array_equal(np.unique(sides, axis=0), np.unique(sides[:, ::-1], axis=0))
    assert carry @ places == pytest.approx(finer, abs=1e-15)

    def areas(vertices: Float, triangles: Int) -> Float:
        a, b, c = vertices[triangles].transpose(1, 0, 2)
        return 0.5 * np.cross(b - a, c - a)

    pieces = np.zeros((coarse.shape[0], 3))
    np.add.at(pieces, origin, areas(finer, corners))
    assert pieces == pytest.approx(areas(places, coarse), abs=1e-15)
    assert np.einsum("fa,fa->f", areas(finer, corners), areas(places, coarse)[origin]).min() > 0.0


def test_a_mesh_of_short_and_long_triangles_is_met() -> None:
    """Halved as often everywhere, its skin would take 400,000 points and be refused."""
    places, corners = bar(400)
    block = together([Placed(body=rigid_box((0.1, 0.1, 0.1)), name="block")])
    far = Obstacle(shape=Solid(places + np.array([0.0, 0.0, 3.0]), corners))
    ready = model(block, obstacles=[far], between=Between())
    assert ready.force is not None
    assert ready.force.world is not None


def test_bad_obstacles_are_refused() -> None:
    with pytest.raises(BodyError, match=r"^size is \[0.1, 0.0, 0.1\]; it must be three lengths above 0 m$"):
        Obstacle(shape=Box((0.1, 0.0, 0.1)))
    with pytest.raises(BodyError, match=r"^normal is \[0.0, 0.0, 0.0\]; it must be three finite numbers, not all 0$"):
        Obstacle(shape=Plane(normal=(0.0, 0.0, 0.0)))
    with pytest.raises(BodyError, match=r"^an obstacle is 1e-06 m thin, so points of .* at most 5e-07 m apart"):
        model(cube(), obstacles=[Obstacle(shape=Box((1.0, 1.0, 1e-6)))])
    with pytest.raises(UnsupportedError, match=r"^the body has no skin; obstacles are met by a skin"):
        model(chain(3, dimension=3), obstacles=[TABLE])
