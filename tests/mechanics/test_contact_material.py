"""Contact by a law on bodies that turn, bend far and are heavy: one balance of both, and what it must feel like."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from tests.mechanics.inside import press
from tests.mechanics.materials import EVERY, SPACING, boxes, made, rotation
from tests.mechanics.pressing import Pressed, plate, slab

from cotouch.body import body_from_tetrahedra
from cotouch.kernels import kernel
from cotouch.mechanics import (
    BETA,
    CLOSURE_ALARM,
    GRASP,
    ITERATIONS,
    KINETIC,
    SHORTENED,
    TOUCH_LOSS,
    TOUCH_STORED,
    Stiffening,
    press_skin,
)

STEPS = 120


def surrounded(name: str, seed: int) -> tuple[Pressed, np.ndarray]:
    """A body among four tools, at random: heavy and on the ground, or turned and free; and the way in for each."""
    rng = np.random.default_rng(seed)
    free = seed % 2 == 1 or name == "rigid"  # which stands on nothing
    body = made(
        name,
        viscosity=2e-3,
        ground="none" if free else "z-",
        hold=0.0 if free else 300.0,
        gravity=None if free else (0.5, 0.3, -9.81),
    )
    middle = body.rest.mean(axis=0)
    turn = rotation(rng.normal(size=3), 2.0) if free else np.eye(3)
    copy = Pressed(body, count=4, moved=(body.rest - middle) @ turn.T + middle - body.rest)
    tools = copy.tools
    tools.radius[:] = rng.uniform(0.004, 0.009, 4)
    tools.stiffness[:] = 10.0 ** rng.uniform(2.0, 3.5, 4)
    tools.friction[:], tools.kinetic[:] = [0.0, 0.5, 0.8, 0.3], [0.0, 0.3, 0.7, 0.3]
    tools.loss[:] = [0.0, 1.0, 0.0, 3.0]
    tools.axis[2, :3] = turn @ [0.005, 0.003, 0.0]
    ways = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.3], [0.0, -0.3, 1.0], [0.0, -1.0, 0.4]]) @ turn.T
    tools.place[:, :3] = middle + (2.2 * SPACING + tools.radius)[:, None] * ways
    tools.place[2, :3] += turn @ [-0.01, 0.0, 0.0]
    tools.drive_stiffness[:], tools.drive_damping[:] = 200.0, 2.0
    copy.begin()
    return copy, ways


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("name", EVERY)
def test_one_balance_for_contact_and_material(name: str, seed: int) -> None:
    """Energy to round-off with steps of random length, early solvers, friction, damping, weight; some tools pass."""
    copy, ways = surrounded(name, seed)
    rng, tools, cap = np.random.default_rng(seed), copy.tools, (1, 3, 200)[seed % 3]
    goal, start = tools.place[:, :3].copy(), tools.place[:, :3].copy()
    touched = 0
    for _ in range(STEPS):
        T = float(rng.uniform(5e-4, 4e-3))
        tools.drive_start[:, :3] = goal
        goal = goal + T * rng.normal(scale=0.1, size=goal.shape)
        goal += 0.05 * (start - (0.008 + 0.01 * rng.uniform()) * ways - goal)
        tools.drive_end[:, :3] = goal
        copy.step(T, cap)
        assert copy.touch_ledger[TOUCH_LOSS] >= 0.0
        touched += int(tools.touching.sum())
    assert touched > STEPS / 5
    assert copy.residual <= 5e-15 * copy.in_play


def test_what_is_pressed_at_rest_closes() -> None:
    """Where nothing moves, no velocity can make up for what a force missed, and nothing is made either."""
    copy = Pressed(made("cells", viscosity=2e-3, ground="z-", hold=300.0, gravity=(0.0, 0.0, -9.81)))
    copy.tools.radius[:] = 0.008
    top = 2.0 * SPACING
    place = [0.013, 0.009, top + 0.0035]
    copy.tools.place[0, :3] = [0.013, 0.009, top + 0.0085]
    copy.begin()
    for n in range(500):
        copy.lead([0.013, 0.009, max(place[2], top + 0.0085 - 2e-5 * n)], place)
        copy.step(2e-3)
    force, depth, lost = copy.force[2], copy.tools.place[0, 2], copy.lost
    assert force > 0.1
    told, solved = 0, 0.0
    for _ in range(10_000):
        copy.lead(place, place)
        copy.step(2e-3)
        told += int(copy.ledger[SHORTENED] > 0.0 or copy.ledger[BETA] > CLOSURE_ALARM)
        solved += float(copy.ledger[ITERATIONS])
    assert told == 0
    assert solved <= 200_000.0  # nothing is searched for where rounding alone is left over
    assert abs(copy.force[2] - force) <= 1e-3 * force
    assert abs(copy.tools.place[0, 2] - depth) <= 1e-3 * 0.005
    assert copy.lost - lost <= 1e-3 * copy.energy
    assert copy.residual <= 5e-15 * copy.in_play


def test_a_stylus_that_lies_over_an_edge_comes_to_rest() -> None:
    """Some of its balls reach the block's side beside their foot there: where nothing moves, energy must be exact."""
    copy = Pressed(made("cells", viscosity=2e-3, ground="z-", hold=300.0, gravity=(0.0, 0.0, -9.81)))
    copy.tools.radius[:] = 0.004
    copy.tools.axis[0, :3] = [0.03, 0.0, 0.0]
    copy.tools.place[0, :3] = start = np.array([0.0, 0.011, SPACING * 2.0 + 0.0045])
    copy.begin()
    told = 0
    for n in range(800):
        place = start - [0.0, 0.0, min(1e-5 * n, 0.004)]
        copy.lead(place, place)
        copy.step(2e-3)
        told += int(copy.ledger[SHORTENED] > 0.0 or copy.ledger[BETA] > CLOSURE_ALARM)
    assert told == 0
    assert copy.force[2] > 0.1
    assert np.linalg.norm(copy.tools.rate[0, :3]) <= 1e-5


def test_a_body_that_rests_stays_while_tools_go_on() -> None:
    """What rounding moves it by is no reason to move, where no tool does anything to it."""
    start, up, pair = np.array([0.013, 0.009, 0.2]), np.array([0.0, 0.0, 0.01]), list[Pressed]()
    for gravity in (None, (0.0, 0.0, -9.81)):
        pair.append(Pressed(made("cells", viscosity=2e-3, ground="z-", hold=300.0, gravity=gravity)))
        pair[-1].tools.radius[:], pair[-1].tools.place[0, :3] = 0.008, start
        pair[-1].begin()
    unloaded, rests, still = *pair, 0
    for n in range(1500):
        before = rests.state.position.copy()
        for copy in pair:
            copy.lead(start + np.sin(n) * up, start + np.sin(n + 1) * up)
            copy.step(2e-3)
        still += int(np.array_equal(rests.state.position, before))
        assert np.abs(rests.tools.place - unloaded.tools.place).max() <= 1e-14
    assert still > 20
    assert rests.residual <= 5e-15 * rests.in_play


def test_friction_that_sticks_is_stretched_by_what_tool_and_skin_moved() -> None:
    """Not by where they were thought to go a look before: its pull times the difference is work of no force."""
    copy = Pressed(made("cells", viscosity=2e-3, ground="z-", hold=300.0, gravity=(0.0, 0.0, -9.81)))
    tools, touch, start = copy.tools, copy.contact.work, np.array([0.013, 0.009, 2.0 * SPACING + 0.0085])
    tools.radius[:], tools.friction[:], tools.kinetic[:] = 0.008, 0.6, 0.6
    tools.place[0, :3] = end = start
    copy.begin()
    stuck = 0
    for n in range(400):
        was, end = end, start + np.array([2e-5 * max(n - 250, 0), 0.0, -2e-5 * min(n, 250)])
        stretch, place, skin = tools.stretch[0, :3].copy(), tools.place[0, :3].copy(), copy.skin_place()
        copy.lead(was, end)
        copy.step(2e-3)
        if n < 250 or tools.slipping[0]:
            continue
        hits = touch.hit[0, : touch.hits[0]]
        corner = copy.surface.corner[touch.near[0, hits]]
        moved = copy.skin_place()[corner] - skin[corner]
        against = tools.place[0, :3] - place - np.einsum("cq,cqa->a", touch.load[hits, :3], moved) / touch.total[0]
        across = np.eye(3) - np.outer(touch.way[0, :3], touch.way[0, :3])
        turned = across @ stretch
        turned *= np.linalg.norm(stretch) / np.linalg.norm(turned)
        off = np.linalg.norm(tools.stretch[0, :3] - turned - across @ against)
        assert off <= 1e-14
        stuck += 1
    assert stuck > 100


def test_a_grasp_that_pulls_within_long_steps_makes_no_energy() -> None:
    """Where looks lead so far that energies overflow, the rounding of these is no reason to call a step closed."""
    copy = Pressed(made("neo-hookean", viscosity=2e-4, ground="z-", hold=300.0, gravity=(0.0, 0.0, -9.81)))
    copy.tolerance, tools = 1e-6, copy.tools
    tools.radius[:], tools.mode[:] = 0.008, GRASP
    tools.place[0, :3] = start = np.array([0.013, 0.009, 2.0 * SPACING])
    copy.begin()
    tools.drive_stiffness[:], tools.drive_damping[:], tools.grip_stiffness[:] = 5e3, 2.0, 5e3
    end, told = start, 0
    for n in range(80):
        tools.drive_start[:, :3] = end
        end = start + 0.05 * np.sin(0.08 * np.pi * (n + 1)) * np.array([1.0, 0.6, 0.4])
        tools.drive_end[:, :3] = end
        copy.step(0.04)
        told += int(copy.ledger[SHORTENED] > 0.0)
        assert copy.ledger[BETA] <= CLOSURE_ALARM  # rather the tool goes less far
    assert 0 < told <= 10  # such steps are searched for at once
    assert copy.residual <= 5e-15 * copy.in_play
    assert copy.in_play < 100.0


def test_a_step_that_leads_where_nothing_can_be_weighed_is_not_taken_and_told() -> None:
    """What touches stays where it is, by velocities that are turned back."""
    copy = Pressed(made("cells", viscosity=2e-3, ground="z-", hold=300.0))
    copy.tools.radius[:], copy.tools.place[0, :3] = 0.008, [0.013, 0.009, 2.0 * SPACING + 0.0075]
    copy.tools.rate[0, 2] = -1e60
    copy.begin()
    place, position = copy.tools.place.copy(), copy.state.position.copy()
    for sign in (1.0, -1.0):
        copy.step(0.01)
        assert copy.ledger[SHORTENED] == 1.0
        assert copy.tools.rate[0, 2] == sign * 1e60
    assert np.array_equal(copy.tools.place, place)
    assert np.abs(copy.state.position - position).max() <= 1e-4
    assert copy.residual <= 5e-15 * copy.in_play


@kernel
def at_depth(law: Any, stiffness: float, radius: float, depth: float) -> tuple[float, float, float]:
    """A law for tests."""
    return press(law, stiffness, radius, depth)


LONG = (0.01, 0.02, 0.03, 0.04)


def moved_about(name: str, kind: str) -> tuple[Pressed, Callable[[float], np.ndarray]]:
    """A heavy block on the ground with a ball or a stylus above it, or held by a grasp, and where a hand leads that."""
    copy = Pressed(made(name, viscosity=2e-4, shape=(6, 5, 4), ground="z-", hold=300.0, gravity=(0.0, 0.0, -9.81)))
    copy.tolerance, tools = 1e-6, copy.tools
    tools.radius[:] = {"ball": 0.008, "stylus": 0.004, "grasp": 0.012}[kind]
    tools.friction[:], tools.kinetic[:] = 0.4, 0.3
    if kind == "stylus":
        tools.axis[0, 1] = 0.02
    if kind == "grasp":
        tools.mode[:], tools.grip_stiffness[:], tools.grip_damping[:] = GRASP, 400.0, 0.4
    start = np.array([0.025, 0.02, 0.03 if kind == "grasp" else 0.0305 + float(tools.radius[0])])
    tools.place[0, :3] = start
    copy.begin()

    def way(time: float) -> np.ndarray:
        aside, rate = (0.01, 7.0) if kind == "grasp" else (0.006, 5.0)
        down = -0.007 if kind == "grasp" else 0.005
        wave = [aside * np.sin(rate * time), aside * np.sin(6.0 * time), down * (np.cos(5.0 * time) - 1.0)]
        return start + np.array(wave)

    return copy, way


def held_by(copy: Pressed) -> float:
    """What a tool's contact and friction hold by where it and the skin are [J]."""
    tools, skin, place = copy.tools, copy.surface, copy.skin_place()
    radius, axis = float(tools.radius[0]), tools.axis[0, :3]
    long = float(np.linalg.norm(axis))
    along = np.linspace(-1.0, 1.0, 2 + int(4.0 * long / radius)) if long > 0.0 else np.zeros(1)
    result = 0.5 * 1000.0 * float((tools.stretch[0, :3] ** 2).sum())
    for middle in tools.place[0, :3] + along[:, None] * axis:
        ball = Stiffening(), place, skin.corner, middle
        result += press_skin(*ball, stiffness=1000.0, radius=radius, area=skin.area)[0]
    return result


@pytest.mark.parametrize("kind", ["ball", "stylus", "grasp"])
@pytest.mark.parametrize("name", ["cells", "spring-network", "neo-hookean"])
def test_steps_that_are_far_too_long_close_all_the_same(name: str, kind: str) -> None:
    """Where looks for body and tools go astray, they are sought together; few steps are shortened, none costs much."""
    for T in LONG:
        copy, way = moved_about(name, kind)
        steps, touched, told, closed, most = int(1.2 / T), 0, 0, 0, 0
        for n in range(steps):
            copy.lead(way(n * T), way((n + 1) * T), 400.0, 8.0)
            copy.step(T, 500)
            touched += int(copy.tools.touching[0] > 0)
            told += int(copy.ledger[SHORTENED] > 0.0)
            closed += int(copy.ledger[BETA] > CLOSURE_ALARM)
            most = max(most, int(copy.ledger[ITERATIONS]))
            if kind != "grasp":
                assert copy.tools.stored[0] == pytest.approx(held_by(copy), rel=1e-9, abs=1e-15)
        assert touched > 0.7 * steps
        assert told <= 1
        assert closed <= 0.15 * steps
        assert most <= 600
        assert copy.residual <= 1e-14 * copy.in_play


@pytest.mark.parametrize("model", ["elastic", "corotated"])
def test_a_tool_slides_over_a_stiff_uneven_mesh_as_over_any_other(model: str) -> None:
    """Small elements among large ones ring faster than a step follows, at ωT/2 of 15; dampers must still them."""
    points, elements = boxes((7, 6, 4), 0.005)
    inner = ((points > 0.0) & (points < points.max(axis=0))).all(axis=1)
    points[inner] += np.random.default_rng(3).uniform(-0.0018, 0.0018, (int(inner.sum()), 3))
    body = body_from_tetrahedra(
        (points, elements),
        unit="m",
        model=model,
        frame="floating" if model == "elastic" else "fixed",
        young=1e6,
        density=1000.0,
        rayleigh_stiffness=2e-4,
        ground="z-",
        ground_stiffness=1e3,
    )
    copy = Pressed(body, tolerance=1e-10)
    copy.tools.radius[:], copy.tools.stiffness[:] = 0.006, 800.0
    end = above = np.array([0.011, 0.01, 0.015 + 0.006])
    copy.tools.place[0, :3] = above
    copy.begin()
    told, across = 0, 0.0
    for n in range(700):
        way = max(n - 200, 0)
        start, end = end, above + np.array([1.2e-5 * way, 0.5e-5 * way, -min(1e-5 * n, 0.002)])
        copy.lead(start, end, damping=3.0)
        copy.step(1e-3)
        told += int(copy.ledger[SHORTENED] > 0.0 or copy.ledger[BETA] > CLOSURE_ALARM)
        across = max(across, float(np.hypot(*copy.force[:2])) / max(copy.force[2], 0.1))
    assert told == 0
    assert across <= 0.01  # without friction
    assert copy.lost <= 1e-9
    assert copy.residual <= 5e-15 * copy.in_play


@pytest.mark.parametrize(("tremble", "slide"), [(2e-5, 0.0), (0.0, SPACING)])
def test_three_tools_take_few_looks(tremble: float, slide: float) -> None:
    """Hands that tremble or slide: looks end where the end velocity hardly notices what they miss."""
    copy = Pressed(made("cells", viscosity=2e-4, shape=(8, 8, 5), ground="z-", hold=100.0), count=3)
    rng, tools, radius = np.random.default_rng(1), copy.tools, 1.5 * SPACING
    copy.tolerance, angle = 1e-6, 2.0 * np.pi * np.arange(3) / 3
    around = np.stack([np.cos(angle), np.sin(angle), np.zeros(3)], axis=1)
    above = 1.6 * SPACING * around + [3.5 * SPACING, 3.4 * SPACING, 4.0 * SPACING + radius]
    tools.radius[:], tools.place[:, :3] = radius, above
    copy.begin()
    tools.drive_stiffness[:], tools.drive_damping[:] = 500.0, 5.0
    taken, factors, end = [], [], above
    for n in range(500):
        start, end = end, above + tremble * rng.normal(size=(3, 3))
        end += [slide * np.sin(0.01 * max(n - 200, 0)), 0.0, -min(0.8 * SPACING, 8e-5 * n)]
        tools.drive_start[:, :3], tools.drive_end[:, :3] = start, end
        copy.step(1e-3)
        taken.append(copy.ledger[ITERATIONS])
        factors.append(copy.ledger[BETA])
    assert tools.touching.all()
    assert np.median(taken[200:]) <= 8.0  # four of these before any correction
    assert np.quantile(factors[200:], 0.99) <= 1e-3
    assert copy.residual <= 5e-15 * copy.in_play


@pytest.mark.parametrize("name", ["floating", "cells"])
def test_sliding_over_rows_of_vertices(name: str) -> None:
    kind = {"frame": "floating"} if name == "floating" else {"model": "cells"}
    copy = plate(**kind)
    copy.tools.friction[:], copy.tools.kinetic[:] = 0.6, 0.4
    forces, factors = [], []
    for n in range(1300):
        start, end = ([0.02 + 4e-5 * max(0, n + k - 300), 0.021, 0.016] for k in (0, 1))
        copy.lead(start, end)
        copy.step(1e-3)
        forces.append(copy.force)
        factors.append(copy.ledger[BETA])
    slid = np.array(forces)[700:]  # 24 mm, over two rows
    assert slid[:, 2].mean() > 1.0
    assert np.ptp(slid[:, 2]) <= 0.01 * slid[:, 2].mean()
    assert np.abs(np.diff(slid[:, 2])).max() <= 1e-3 * slid[:, 2].mean()
    assert np.quantile(factors[700:], 0.99) <= 1e-3
    assert copy.residual <= 5e-15 * copy.in_play


@pytest.mark.parametrize("turned", [0.0, 0.5 * np.pi, 2.5])
def test_a_turned_floating_flat_pushes_as_the_closed_form_says(turned: float) -> None:
    """Two tools hold a free slab between them: `F = 2 π z ψ`, z the height of a tool's middle, ψ at its foot."""
    body = slab(frame="floating", ground="none")
    middle, turn = body.rest.mean(axis=0), rotation((1.0, 0.4, 0.2), turned)
    copy = Pressed(body, count=2, moved=(body.rest - middle) @ turn.T + middle - body.rest)
    copy.tools.radius[:] = 0.01
    normal = turn @ [0.0, 0.0, 1.0]
    sides = np.array([1.0, -1.0])[:, None] * normal
    copy.tools.place[:, :3] = middle + 0.0151 * sides
    copy.begin()
    goal = middle + 0.0125 * sides
    copy.tools.drive_stiffness[:], copy.tools.drive_damping[:] = 5000.0, 60.0
    for n in range(800):
        copy.tools.drive_start[:, :3] = copy.tools.drive_end[:, :3] = goal + max(0.0, 0.0026 - 2e-5 * n) * sides
        copy.step(1e-3)
    skin = (copy.skin_place() - middle) @ normal
    radius, beside = 0.01, np.linalg.norm((copy.body.rest - middle)[:, :2], axis=1)
    top = (copy.copy.position + body.rest - middle) @ normal
    level = top[(beside < 0.012) & (body.rest[:, 2] > middle[2])].mean()
    assert skin.max() < 0.006
    z = float((copy.tools.place[0, :3] - middle) @ normal) - level
    psi = at_depth(Stiffening(), 1000.0, radius, (radius**2 - z**2) / (2.0 * radius))[0]
    assert copy.force @ normal == pytest.approx(2.0 * np.pi * z * psi, rel=2e-3)
    assert copy.ledger[KINETIC] <= 1e-6 * copy.energy
    assert copy.residual <= 5e-15 * copy.in_play


def test_what_grows_between_steps_gives_no_energy() -> None:
    """A radius that is changed from outside: the contact holds what it held, until it lets go."""
    copy = Pressed(made("cells", viscosity=2e-3, ground="z-", hold=300.0))
    copy.tools.radius[:] = 0.006
    top = 2.0 * SPACING
    copy.tools.place[0, :3] = [0.013, 0.009, top + 0.0061]
    copy.begin()
    for _ in range(100):
        copy.lead([0.013, 0.009, top + 0.004], [0.013, 0.009, top + 0.004])
        copy.step(2e-3)
    for _ in range(30):
        copy.tools.radius[:] += 5e-5
        copy.step(2e-3)
        assert copy.touch_ledger[TOUCH_LOSS] >= 0.0
    assert 0.0 < copy.tools.share[0] < 1.0
    assert copy.residual <= 5e-15 * copy.in_play
    for _ in range(100):
        copy.lead([0.013, 0.009, top + 0.03], [0.013, 0.009, top + 0.03])
        copy.step(2e-3)
    assert copy.tools.share[0] == 1.0


@pytest.mark.parametrize("paid", [0.0, 1e-22])
def test_a_contact_that_nothing_was_paid_for_does_nothing_until_it_lets_go(paid: float) -> None:
    """A tool that comes to be in the skin without its own motion; that it does nothing does not take it out of it."""
    copy = Pressed(made("cells", viscosity=2e-3, ground="z-", hold=300.0))
    copy.tools.radius[:] = 0.006
    top = 2.0 * SPACING
    copy.tools.place[0, :3] = [0.013, 0.009, top + 0.0061]
    copy.begin()
    copy.step(2e-3)
    copy.tools.place[0, 2] -= 0.003
    copy.tools.stored[0] = paid
    for _ in range(20):
        copy.lead(copy.tools.place[0, :3], copy.tools.place[0, :3])
        copy.step(2e-3)
        assert copy.tools.share[0] <= 1e15 * paid
        assert copy.tools.touching[0] == int(paid > 0.0)
    assert copy.residual <= 1e-15
    for _ in range(100):
        copy.lead([0.013, 0.009, top + 0.03], [0.013, 0.009, top + 0.03])
        copy.step(2e-3)
    assert copy.tools.share[0] == 1.0


def test_the_tool_closes_what_begins_after_all_that_looks_see_of_a_step() -> None:
    """Its contact holds a millionth of the tool's energy by then, but some of what a body has that hardly moves."""
    T, speed, radius, told = 1e-3, 0.4, 0.008, 0
    for late in (0.93, 0.94, 0.95):
        copy = Pressed(made("cells", viscosity=2e-3, ground="z-", hold=300.0))
        copy.tools.radius[:] = radius
        copy.tools.place[0, :3] = [0.013, 0.009, 2.0 * SPACING + radius + late * speed * T]
        copy.tools.rate[0, :3] = [0.0, 0.0, -speed]
        copy.state.velocity[:, :3] = 5e-3 * np.random.default_rng(2).normal(size=(copy.body.nodes, 3))
        copy.begin()
        copy.step(T)
        assert 0.02 < copy.touch_ledger[TOUCH_STORED] / copy.ledger[KINETIC] < 0.2
        told += int(copy.ledger[SHORTENED] > 0.0 or copy.ledger[BETA] > CLOSURE_ALARM)
    assert told == 0
