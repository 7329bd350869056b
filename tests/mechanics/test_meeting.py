"""Bodies that meet: what collides, rests, slides and turns, against closed forms and conservation laws."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import pytest
from tests.mechanics.materials import Alone

from cotouch.body import Body, Placed, lattice, rigid_box, together
from cotouch.errors import BodyError
from cotouch.mechanics import (
    BETA,
    BODY_LOSS,
    CLOSURE,
    CLOSURE_ALARM,
    KINETIC,
    WORLD_FORCE,
    WORLD_LOSS,
    WORLD_STORED,
    Between,
    Box,
    Obstacle,
    Plane,
    Solid,
    begin_world,
    closed_settle,
    deepest_between,
    follow_world,
    model,
)

Float = npt.NDArray[np.float64]
G, SIDE = 9.81, 0.1
TABLE = Obstacle(shape=Plane(), stiffness=1e7, loss=20.0, friction=0.5)
STUCK = Between(stiffness=1e7, loss=20.0, friction=0.5)


def cube(damping: float = 5.0, stiffness: float = 1e4) -> Body:
    """Of 1 kg and 0.1 m, that yields."""
    return lattice((3, 3, 3), mass=1.0, stiffness=stiffness, damping=damping, spacing=SIDE / 2, model="cells")


def die(resolution: int = 1, mass: float = 1.0, size: tuple[float, float, float] = (SIDE, SIDE, SIDE)) -> Body:
    """A rigid one."""
    return rigid_box(list(size), mass=mass, resolution=resolution)


class Several(Alone):
    """Several bodies, their ledger, and each one's motion."""

    def __init__(
        self,
        *bodies: Body | tuple[Body, tuple[float, ...], tuple[float, ...]],
        between: Between = STUCK,
        obstacles: tuple[Obstacle, ...] = (),
        pull: float = 0.0,
        speeds: tuple[tuple[float, ...], ...] = (),
        **options: float,
    ) -> None:
        placed = [body if isinstance(body, tuple) else (body, (0.0,) * 3, (0.0,) * 3) for body in bodies]
        whole = together(
            [
                Placed(body=b, name=str(k), at=(at[0], at[1], at[2]), turn=(turn[0], turn[1], turn[2]))
                for k, (b, at, turn) in enumerate(placed)
            ]
        ).with_gravity((0.0, 0.0, -pull))
        velocity = np.zeros((whole.nodes, 3))
        for part, speed in zip(whole.parts, speeds, strict=False):
            velocity[part.first : part.last] = speed
        super().__init__(whole, None, velocity, obstacles=obstacles, between=between, **options)  # pyright: ignore[reportArgumentType]
        self.scale = max(abs(self.energy), pull * SIDE)
        self.worst = self.beta = self.lost = 0.0

    def run(self, steps: int, T: float = 1e-3) -> None:
        for _ in range(steps):
            before, did = self.energy, self.step(T)
            assert did[WORLD_LOSS] >= 0.0
            self.lost += did[BODY_LOSS]
            self.scale = max(self.scale, abs(self.energy), self.lost)
            self.worst = max(self.worst, abs(self.energy - before + did[BODY_LOSS]))
            self.beta = max(self.beta, float(did[BETA]))
        assert self.worst <= 2e-14 * self.scale

    def momentum(self, number: int | None = None) -> Float:
        """Of one body, or of all."""
        own = slice(None) if number is None else self.span(number)
        return (self.mass * self.velocity)[own].sum(axis=0)

    def spin(self) -> Float:
        """Angular momentum of all."""
        return (self.mass * np.cross(self.body.rest + self.position, self.velocity)).sum(axis=0)

    def span(self, number: int) -> slice:
        part = self.body.parts[number]
        return slice(part.first, part.last)

    def place(self, number: int) -> Float:
        """Mean displacement of one."""
        own = self.mass[self.span(number)]
        return (own * self.position[self.span(number)]).sum(axis=0) / own.sum()

    def deepest(self) -> float:
        world = self.force.world
        assert world is not None
        assert world.bodies is not None
        return deepest_between(world, world.bodies, self.state.memory, self.state.position)[0]


def tower(count: int, body: Body, between: Between = STUCK) -> Several:
    """Where it stands: each block is pressed in by what is above it."""
    depth, places = 1.0 * G / (1e7 * SIDE**2), []
    height = 0.5 * SIDE
    for k in range(count):
        height -= (count - k) * depth
        places.append((body, (0.0, 0.0, height), (0.0,) * 3))
        height += SIDE
    return Several(*places, between=between, obstacles=(TABLE,), pull=G)


def test_two_elastic_blocks_keep_energy_and_momentum() -> None:
    """They meet off their middles, so both turn as well; one flies on its way before, and is not felt."""
    pair = Several(
        (cube(0.0), (0.0,) * 3, (0.0,) * 3),
        (cube(0.0), (0.13, 0.03, 0.01), (0.0, 0.0, 0.2)),
        between=Between(stiffness=1e7),
        speeds=((1.0, 0.0, 0.0),),
    )
    begun, momentum, spin = pair.energy, pair.momentum(), pair.spin()
    pair.run(15)
    assert pair.momentum(1) == pytest.approx(0.0, abs=1e-15)
    pair.run(85)
    assert pair.momentum() == pytest.approx(momentum, abs=1e-13)
    assert pair.spin() == pytest.approx(spin, abs=1e-3 * float(np.abs(spin).max()) + 1e-5)
    assert pair.energy == pytest.approx(begun, abs=1e-13)
    assert pair.momentum(1)[0] > 0.5
    assert pair.ledger[WORLD_STORED] == 0.0
    assert pair.beta <= CLOSURE_ALARM


def test_one_that_flies_does_not_move_one_that_rests() -> None:
    """What the balance of a ringing body lacks is made up for by itself: with one factor for all the other would go."""
    pair = Several(
        (cube(0.0, 2e3), (0.0, 0.0, 0.5), (0.0,) * 3),
        (cube(), (0.5, 0.0, 0.0), (0.0,) * 3),
        speeds=((1.0, 0.0, 0.0),),
    )
    ringing = pair.velocity
    ringing[pair.span(0)] += 3.0 * (pair.body.rest[pair.span(0)] - [0.0, 0.0, 0.5]) * [1.0, -1.0, 0.0]
    pair.state.velocity[:] = pair.rows(ringing)
    pair.state.memory[1] = 0.5 * float((pair.mass * ringing**2).sum())
    own = pair.momentum(0)
    for _ in range(200):
        pair.step(2e-3)
    assert float(pair.ledger[BETA]) > 0.0
    assert np.abs(pair.velocity[pair.span(1)]).max() <= 1e-18
    assert pair.momentum(0) == pytest.approx(own, abs=1e-13)


@pytest.mark.parametrize("made", [die, cube])
@pytest.mark.parametrize("seed", range(3))
def test_nothing_acts_at_a_distance(made: Callable[[], Body], seed: int) -> None:
    """Of four bodies two collide, one rests, and one flies and turns: alone, these two do just the same."""
    rng = np.random.default_rng(seed)
    far = rng.uniform(-1.0, 1.0, 3) + np.array([0.0, 0.0, 5.0])
    spin, speed = rng.uniform(-5.0, 5.0, 3), rng.uniform(-1.0, 1.0, 3)
    pull = float(rng.choice([0.0, G]))
    near = [
        (made(), (0.0,) * 3, tuple(rng.uniform(-1.0, 1.0, 3))),
        (made(), (0.15, *rng.uniform(-0.02, 0.02, 2)), (0.0,) * 3),
    ]
    apart = [(made(), (0.0, 0.0, 2.0), (0.0,) * 3), (made(), tuple(far), (0.0,) * 3)]
    runs: list[Several] = []
    for bodies, speeds in ((near + apart, ((2.0, 0.0, 0.0),)), (apart, ())):
        run = Several(*bodies, between=Between(friction=0.3), pull=pull, speeds=speeds)
        own, moving = run.span(len(bodies) - 1), run.velocity
        moving[own] = speed + np.cross(spin, run.body.rest[own] - far)
        run.state.velocity[:] = run.rows(moving)
        closed_settle(run.model.operator, run.force, run.state, run.work, run.ledger, run.model.lanes)
        run.scale = run.energy
        runs.append(run)
        begun, still = run.momentum(len(bodies) - 1), run.momentum(len(bodies) - 2)
        run.run(50)
        fallen = np.array([0.0, 0.0, -pull * 0.05]) * run.mass[own].sum()
        assert run.momentum(len(bodies) - 1) == pytest.approx(begun + fallen, abs=1e-13)
        assert run.momentum(len(bodies) - 2) == pytest.approx(still + fallen, abs=1e-13)
    many, few = runs
    assert many.momentum(1)[0] > 0.1
    assert many.position[many.span(2)] == pytest.approx(few.position[few.span(0)], abs=1e-15)
    # But for what the solver leaves of a motion that bends: looks and iterations end for all bodies at once.
    assert many.position[many.span(3)] == pytest.approx(few.position[few.span(1)], abs=1e-8)


def test_bounce_of_two_as_the_closed_form_says() -> None:
    """Rigid, face to face: the reduced mass on a spring of κ A."""
    T, speed = 1e-4, 0.05
    pair = Several(
        (die(), (0.0,) * 3, (0.0,) * 3),
        (die(mass=3.0), (SIDE + 0.0002, 0.0, 0.0), (0.0,) * 3),
        between=Between(stiffness=1e6),
        speeds=((speed, 0.0, 0.0),),
    )
    rate = np.sqrt(1e6 * SIDE**2 / (1.0 * 3.0 / 4.0))
    deep, lasted = 0.0, 0
    for _ in range(400):
        pair.run(1, T)
        deep, lasted = max(deep, pair.deepest()), lasted + (pair.ledger[WORLD_STORED] > 0.0)
    assert deep == pytest.approx(speed / rate, rel=0.01)
    assert lasted * T == pytest.approx(np.pi / rate, rel=0.03)
    assert pair.momentum(1)[0] / 3.0 == pytest.approx(0.5 * speed, rel=2e-3)  # 2 m / (m + M) of the speed
    assert pair.momentum() == pytest.approx([speed, 0.0, 0.0], abs=1e-13)


@pytest.mark.parametrize("body", [die(), cube(100.0, 1e5)], ids=["rigid", "cells"])
@pytest.mark.parametrize("steps", [500, 1500])
def test_a_tower_of_five_stands(body: Body, steps: int) -> None:
    standing = tower(5, body)
    standing.run(2 * steps, 2e-3)
    settled, begun, standing.lost = standing.position, standing.energy, 0.0
    standing.run(steps, 2e-3)
    assert np.abs(standing.position - settled).max() <= 1e-6
    assert standing.energy <= begun + 1e-13
    assert standing.ledger[14] == pytest.approx(5.0 * G, rel=1e-3)


def test_a_block_rests_on_a_block_at_the_depth_that_its_weight_asks_for() -> None:
    pair = tower(2, die(2))
    pair.run(1500)
    assert pair.deepest() == pytest.approx(G / (1e7 * SIDE**2), rel=1e-3)


def test_what_was_near_in_another_step_makes_no_difference() -> None:
    """A resting stack is not searched anew; what moves is, to the same bits as by a model that never stepped before."""
    used = tower(2, die(4))
    used.run(50)
    for speed in (0.0, 1e-12, 0.0, 1e-4, 0.3, 0.0):
        used.state.velocity[used.span(1), 0] += speed
        fresh = tower(2, die(4))
        for own, other in zip(fresh.state, used.state, strict=True):
            own[...] = other
        for pair in (used, fresh):
            pair.step(1e-3)
        for own, other in zip(fresh.state, used.state, strict=True):
            assert np.array_equal(own, other)


@pytest.mark.parametrize("seed", range(2))
def test_however_bodies_turn_all_that_is_near_is_looked_at(seed: int) -> None:
    """One that spins by the other's skin, several triangles in a step, meets it as if it looked at all triangles."""
    rng = np.random.default_rng(seed)
    runs: list[Several] = []
    turn, spin = tuple(rng.uniform(-1.0, 1.0, 3)), rng.normal(0.0, 150.0, 3)
    for all_near in (False, True):
        pair = Several((die(4), (0.0, 0.0, 0.11), turn), die(4), between=Between(friction=0.3))
        world = pair.force.world
        assert world is not None
        assert world.bodies is not None
        if all_near:
            pair.force = pair.force._replace(world=world._replace(bodies=world.bodies._replace(slack=1.0)))
        own, moving = pair.span(0), pair.velocity
        moving[own] = np.array([0.0, 0.0, -2.0]) + np.cross(spin, pair.body.rest[own] - [0.0, 0.0, 0.11])
        pair.state.velocity[:] = pair.rows(moving)
        closed_settle(pair.model.operator, pair.force, pair.state, pair.work, pair.ledger, pair.model.lanes)
        for _ in range(15):
            pair.step(1e-3)
        runs.append(pair)
    few, every = runs
    assert np.abs(few.momentum(1)).max() > 0.1
    assert few.position == pytest.approx(every.position, abs=1e-9)


def closed_while_sliding(pair: Several, steps: int) -> float:
    """Median of what closes a step, of the kinetic energy, after the upper body was pushed."""
    pair.state.velocity[pair.span(1), 0] += 0.3
    closed_settle(pair.model.operator, pair.force, pair.state, pair.work, pair.ledger, pair.model.lanes)
    closed: list[float] = []
    for _ in range(steps):
        did = pair.step(1e-3)
        closed.append(abs(did[CLOSURE]) / did[KINETIC])
    return float(np.median(closed))


def test_looks_meet_what_slides_to_rounding() -> None:
    """The tangent of contact is the true one, with friction that slips: the balance finds next to nothing to close."""
    pair = tower(2, die(4))
    pair.run(200)
    assert closed_while_sliding(pair, 20) <= 1e-10


def test_looks_meet_what_slides_along_edges_to_rounding() -> None:
    """Points of the one slide along edges between triangles of the other, in one plane: rounding does not choose."""
    depth = G / (1e7 * SIDE**2)
    low, high = (die(5), (0.0, 0.0, 0.5 * SIDE - 2.0 * depth), (0.0,) * 3), (die(5), (0.0, 0.0, 1.5 * SIDE), (0.0,) * 3)
    pair = Several(low, high, between=Between(), obstacles=(Obstacle(shape=Plane(), stiffness=1e7),), pull=G)
    pair.run(100)
    assert closed_while_sliding(pair, 8) <= 1e-12


def lean(pair: Several, angle: float) -> None:
    pull = G * np.array([np.sin(angle), 0.0, -np.cos(angle), 0.0])
    pair.force = pair.force._replace(gravity=np.tile(pull, (pair.force.gravity.shape[0], 1)))


@pytest.mark.parametrize("kinetic", [0.5, 0.25])
def test_friction_between_bodies_holds_to_a_thousandth_of_its_cone(kinetic: float) -> None:
    """The upper of two slides where it must; the lower is held by a table with more friction.

    What is tilted in a hurry slides for a while just below the cone as well, where little is left to stop it.
    """
    rough = Obstacle(shape=Plane(), stiffness=1e7, loss=20.0, friction=5.0)
    wide = die(2, size=(0.4, 0.4, SIDE))
    depth = G / (1e7 * SIDE**2)
    places = ((wide, (0.0, 0.0, 0.05), (0.0,) * 3), (die(2), (0.0, 0.0, 0.15 - depth), (0.0,) * 3))
    between = Between(stiffness=1e7, loss=20.0, friction=0.5, kinetic=kinetic)
    pair = Several(*places, between=between, obstacles=(rough,), pull=G)
    below, above = np.arctan(0.5 * 0.999), np.arctan(0.5 * 1.001)
    for angles in (np.linspace(0.0, 0.98 * below, 500), np.linspace(0.98 * below, below, 500), np.full(100, below)):
        for angle in angles:
            lean(pair, angle)
            pair.step(1e-3)
    held = pair.place(1) - pair.place(0)
    for _ in range(100):
        pair.step(1e-3)
    assert pair.place(1) - pair.place(0) == pytest.approx(held, abs=1e-6)
    lean(pair, above)
    for _ in range(200 if kinetic == 0.5 else 400):
        pair.step(1e-3)
    before = pair.momentum(1)[0]
    for _ in range(200):
        pair.step(1e-3)
    gained = (pair.momentum(1)[0] - before) / 0.2
    coefficient = (G * np.sin(above) - gained) / (G * np.cos(above))
    assert coefficient == pytest.approx(kinetic, rel=1e-3)
    assert pair.momentum(1)[0] > before > 0.0


def test_the_order_of_bodies_makes_no_difference() -> None:
    one, two = (die(), (0.0,) * 3, (0.0,) * 3), (die(2), (0.101, 0.02, 0.01), (0.1, 0.2, 0.3))
    there = Several(one, two, speeds=((1.0, 0.0, 0.0),))
    back = Several(two, one, speeds=((0.0,) * 3, (1.0, 0.0, 0.0)))
    for pair in (there, back):
        pair.run(60)
    for a, b in ((0, 1), (1, 0)):
        assert there.position[there.span(a)] == pytest.approx(back.position[back.span(b)], abs=1e-9)


@pytest.mark.parametrize(("made", "friction"), [(die, 0.0), (die, 0.5), (cube, 0.0)])
def test_what_lies_in_two_others_at_once_holds_what_places_say(made: Callable[[], Body], friction: float) -> None:
    """Three bodies driven into each other: what they hold follows from where they are, not from how they came there."""
    rng, twice = np.random.default_rng(7), 0
    for _ in range(2):
        places = 0.3 * SIDE * rng.uniform(-1.0, 1.0, (3, 3)) + 0.5 * SIDE * np.eye(3)
        turns, speeds = rng.uniform(-1.0, 1.0, (2, 3, 3))
        speeds -= 30.0 * (places - places.mean(axis=0))
        three = Several(
            *((made(), tuple(at), tuple(turn)) for at, turn in zip(places, turns, strict=True)),
            between=Between(stiffness=1e5, loss=1.0, friction=friction),
            speeds=tuple(map(tuple, speeds)),
        )
        world, audited = three.force.world, three.state.memory.copy()
        assert world is not None
        assert world.bodies is not None
        begin_world(world, audited, three.state.position)
        for _ in range(25):
            before = three.state.position.copy()
            three.run(1, 0.01)
            near, count = 1e-14 * three.scale, world.bodies.entries[1]
            told = three.ledger[[WORLD_STORED, WORLD_LOSS]]
            assert told == pytest.approx(follow_world(world, audited, before, three.state.position, 0.01), abs=near)
            if friction == 0.0:
                memory = three.state.memory.copy()
                assert begin_world(world, memory, three.state.position) == pytest.approx(told[0], abs=near)
            deep = world.bodies.began[:count, 0] > 0.0
            twice += np.count_nonzero(np.bincount(world.bodies.point[:count][deep]) > 1)
    assert twice > 100


@pytest.mark.parametrize("goes_on", [1e-9, 0.02])
def test_what_has_come_out_of_another_holds_nothing(goes_on: float) -> None:
    """Friction that pulled until then is lost at once, not in the next step, which may not look so far."""
    low, high = die(), (die(), (0.0, 0.0, SIDE - 1e-4), (0.0,) * 3)
    pair = Several(low, high, between=Between(stiffness=1e7, loss=0.0, friction=0.5))
    world, memory, places = pair.force.world, pair.state.memory.copy(), [np.zeros((pair.body.nodes, 3))]
    assert world is not None
    for way in ([1e-5, 0.0, 0.0], [1e-3, 0.0, 5e-3], [goes_on, 0.0, goes_on]):
        places.append(places[-1].copy())
        places[-1][pair.span(1)] += way
    at, slid, out, on = (pair.rows(place) for place in places)
    held = begin_world(world, memory, at)
    stuck, _ = follow_world(world, memory, at, slid, 0.01)
    assert stuck > held > 0.0
    stored, lost = follow_world(world, memory, slid, out, 0.01)
    assert stored == 0.0
    assert lost > 0.0
    assert follow_world(world, memory, out, on, 0.01) == (0.0, 0.0)


def test_what_appears_in_an_inside_out_skin_sleeps() -> None:
    """All that is outside such a skin is behind its triangles; as deep as it would be, no motion could have come."""
    crumb = lattice((3, 3, 3), mass=0.1, stiffness=1e3, spacing=0.01, model="cells")
    pair = Several(
        (cube(5.0, 1e2), (0.0,) * 3, (0.0, 0.0, 0.25 * np.pi)),
        (crumb, (0.1, 0.055, 0.0), (0.0,) * 3),
        speeds=((0.0,) * 3, (-1.0, 0.0, 0.0)),
    )
    own, mirrored = pair.span(0), np.zeros((pair.body.nodes, 3))
    mirrored[own, 2] = 2.0 * (pair.body.rest[own, 2].mean() - pair.body.rest[own, 2])
    pair.state.position[:] = pair.rows(mirrored)
    closed_settle(pair.model.operator, pair.force, pair.state, pair.work, pair.ledger, pair.model.lanes)
    world, audited = pair.force.world, pair.state.memory.copy()
    assert world is not None
    assert begin_world(world, audited, pair.state.position) == pair.ledger[WORLD_STORED] == 0.0
    for _ in range(40):
        before = pair.state.position.copy()
        pair.run(1)
        assert follow_world(world, audited, before, pair.state.position, 1e-3) == (0.0, 0.0)
    assert pair.ledger[WORLD_STORED] == 0.0
    assert pair.deepest() > 0.01
    # But known to be there, as where somebody begins, it is met.
    assert begin_world(world, audited, pair.state.position) > 0.0


def slab(size: tuple[float, float, float], at: tuple[float, float, float], **law: float) -> Obstacle:
    """A box that stands still, as a mesh."""
    skin = die(1, size=size).skin
    assert skin is not None
    return Obstacle(shape=Solid(skin.vertices + np.array(at), skin.triangles), **law)


@pytest.mark.parametrize("steps", [1_200, 12_000])
def test_a_block_rests_on_a_mesh_that_stands_still(steps: int) -> None:
    """For six seconds, and for a minute."""
    floor = slab((1.0, 1.0, 0.2), (0.0, 0.0, -0.1), stiffness=1e7, loss=20.0, friction=0.5)
    block = Several((die(), (0.0, 0.0, 0.5 * SIDE - G / (1e7 * SIDE**2)), (0.0,) * 3), obstacles=(floor,), pull=G)
    block.run(300)
    settled = block.place(0)
    assert block.ledger[WORLD_FORCE : WORLD_FORCE + 3] == pytest.approx([0.0, 0.0, G], abs=1e-6)
    block.run(steps, 5e-3)
    assert block.place(0) == pytest.approx(settled, abs=1e-6)
    lean(block, np.arctan(0.5 * 1.001))
    for _ in range(200):
        block.step(1e-3)
    before = block.momentum()[0]
    for _ in range(200):
        block.step(1e-3)
    gained = (block.momentum()[0] - before) / 0.2
    angle = np.arctan(0.5 * 1.001)
    assert (G * np.sin(angle) - gained) / (G * np.cos(angle)) == pytest.approx(0.5, rel=1e-3)


@pytest.mark.parametrize("size", [(SIDE, SIDE, SIDE), (0.01, 0.2, 0.2)], ids=["cube", "plate"])
@pytest.mark.parametrize("turn", [(0.0,) * 3, (0.3, 0.5, 0.7)])
def test_nothing_passes_a_mesh_that_stands_still(size: tuple[float, float, float], turn: tuple[float, ...]) -> None:
    wall = slab(size, (0.2, 0.0, 0.0), stiffness=1e7)
    flying = Several((die(2, mass=0.2), (0.0,) * 3, turn), obstacles=(wall,), speeds=((10.0, 0.0, 0.0),))
    for _ in range(60):
        flying.run(1)
        assert flying.place(0)[0] < 0.2
    assert flying.momentum()[0] < 0.0


def test_a_mesh_of_triangles_is_met_as_the_box_that_it_is() -> None:
    """Beside each other: where faces meet faces, both hold the same force at the same depth."""
    law = {"stiffness": 1e7, "loss": 5.0, "friction": 0.3}
    box = Obstacle(shape=Box((1.0, 1.0, 0.2), (0.0, 0.0, -0.1)), **law)
    near, far = (die(2), (0.0, 0.0, 0.5 * SIDE), (0.0,) * 3), (die(), (0.0, 0.0, 9.0), (0.0,) * 3)  # that falls alone
    runs = [
        Several(near, far, obstacles=(one,), pull=G, speeds=((0.1, 0.0, -0.1),))
        for one in (box, slab((1.0, 1.0, 0.2), (0.0, 0.0, -0.1), **law))
    ]
    for run in runs:
        run.run(40)
    assert runs[1].position == pytest.approx(runs[0].position, abs=1e-5)


@pytest.mark.parametrize("size", [(SIDE, SIDE, SIDE), (0.01, 0.2, 0.2)], ids=["cube", "plate"])
@pytest.mark.parametrize("turn", [(0.0,) * 3, (0.3, 0.5, 0.7)])
def test_nothing_passes_at_ten_metres_a_second(size: tuple[float, float, float], turn: tuple[float, ...]) -> None:
    pair = Several(
        (die(2, mass=0.2), (0.0,) * 3, turn),
        (die(4, mass=1.0, size=size), (0.2, 0.0, 0.0), (0.0,) * 3),
        between=Between(stiffness=1e7),
        speeds=((10.0, 0.0, 0.0),),
    )
    for _ in range(60):
        pair.run(1)
        assert pair.place(0)[0] < pair.place(1)[0] + 0.2
    assert pair.momentum(0)[0] / 0.2 < pair.momentum(1)[0]


def test_two_copies_in_step_are_one() -> None:
    alone, shared = tower(2, die()), tower(2, die())
    shared.model = model(shared.body, copies=2, obstacles=[TABLE], between=STUCK)
    for pair in (alone, shared):
        pair.state.velocity[:4, 0] = 0.1
        pair.state.memory[1] = 0.5 * 0.1**2
    for _ in range(50):
        alone.step(1e-3)
        shared.step(1e-3)
    assert shared.position == pytest.approx(alone.position, abs=1e-12)


def test_upside_down_it_meets_as_well() -> None:
    """A body that is turned over stands as one that is not, to what the diagonals of its squares make."""
    turned = tower(2, die(2))
    placed = [(p.body, (0.0, 0.0, float(p.rest()[:, 2].mean())), (np.pi, 0.0, 0.0)) for p in turned.body.parts]
    over = Several(*placed, obstacles=(TABLE,), pull=G)
    for pair in (turned, over):
        pair.run(500)
    assert over.deepest() == pytest.approx(turned.deepest(), rel=1e-3)


def test_far_apart_they_are_not_looked_for() -> None:
    pair = Several((die(4), (0.0,) * 3, (0.0,) * 3), (die(4), (1.0, 0.0, 0.0), (0.0,) * 3))
    pair.run(1)
    assert pair.force.world is not None
    assert pair.force.world.bodies is not None
    assert pair.force.world.bodies.touched.tolist() == [0, 0]


@pytest.mark.parametrize(
    ("option", "said"),
    [
        ({"stiffness": 0.0}, "stiffness between bodies is 0; it must be a finite number above 0"),
        ({"loss": -1.0}, "loss between bodies is -1; it must be a finite number at least 0"),
        (
            {"friction": 0.1, "kinetic": 0.2},
            "kinetic friction between bodies is 0.2; it must be between 0 and friction",
        ),
    ],
)
def test_what_bodies_cannot_do_is_refused(option: dict[str, float], said: str) -> None:
    with pytest.raises(BodyError) as caught:
        Between(**option)
    assert said in str(caught.value)
