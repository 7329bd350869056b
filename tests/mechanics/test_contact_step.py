"""A step with tools that touch by a law: its energy, and what contact must feel like."""

import numpy as np
import pytest
from tests.mechanics.pressing import SPACING, Pressed, block, plate

from cotouch.body import lattice
from cotouch.mechanics import AWAY, GRASP, TOUCH_LOSS, TOUCHING, Stiffening, Surface, press_skin, relief_on

TOP = 2 * SPACING


def above(place: float, **numbers: float) -> Pressed:
    """One tool over the middle of the block."""
    copy = Pressed(block(damping=numbers.pop("damping", 0.2)))
    copy.tools.radius[:] = numbers.pop("radius", 0.01)
    copy.tools.place[0, :3] = [0.025, 0.031, TOP + place]
    copy.tools.rate[0, 2] = -numbers.pop("speed", 0.0)
    copy.begin()
    return copy


def test_a_bounce_returns_what_it_took() -> None:
    copy = above(0.0101, speed=0.3, damping=0.0)
    start, pressed = copy.energy, 0.0
    for _ in range(60):
        copy.step(1e-3)
        pressed = max(pressed, float(copy.tools.stored[0]))
    assert pressed > 0.2 * start
    assert copy.tools.touching[0] == 0
    assert copy.tools.rate[0, 2] > 0.0
    assert copy.energy == pytest.approx(start, rel=1e-12)
    assert copy.lost <= 1e-13 * start
    assert copy.residual <= 1e-14 * copy.in_play


@pytest.mark.parametrize("cap", [1, 2, 3, 200])
def test_the_balance_is_exact_however_early_the_solver_stops(cap: int) -> None:
    """Five tools at random, driven, with friction and damping, steps of random length."""
    rng = np.random.default_rng(cap)
    copy = Pressed(block(), count=5)
    tools = copy.tools
    tools.radius[:] = rng.uniform(0.004, 0.012, 5)
    tools.stiffness[:] = 10.0 ** rng.uniform(2.5, 4.5, 5)
    tools.friction[:], tools.kinetic[:] = [0.0, 0.5, 0.5, 0.2, 1.0], [0.0, 0.5, 0.3, 0.1, 0.9]
    tools.loss[:] = [0.0, 0.0, 1.0, 3.0, 0.0]
    tools.viscosity[:] = [0.0, 1e4, 0.0, 1e5, 1e4]
    tools.snap[:], tools.snap_range[:] = [0.0, 0.3, 0.0, 1.0, 0.3], 0.3 * tools.radius
    copy.surface = rough(copy)
    tools.axis[4, :3] = [0.008, 0.0, 0.004]
    tools.place[:, :2] = rng.uniform(0.3, 2.7, (5, 2)) * SPACING
    tools.place[:, 2] = TOP + 0.016
    tools.drive_stiffness[:], tools.drive_damping[:] = 300.0, 2.0
    copy.begin()
    goal = tools.place.copy()
    touched = 0
    for _ in range(250):
        T = float(rng.uniform(5e-4, 4e-3))
        tools.drive_start[:] = goal
        goal[:, :2] += T * rng.normal(scale=0.1, size=(5, 2))
        goal[:, 2] = TOP + 0.004 + 0.008 * rng.uniform()
        tools.drive_end[:] = goal
        copy.step(T, cap)
        assert copy.touch_ledger[TOUCH_LOSS] >= 0.0
        touched += int(tools.touching.sum())
    assert touched > 250
    assert copy.residual <= 1e-14 * copy.in_play


def rough(copy: Pressed) -> Surface:
    """The skin with a relief of 0.5 mm."""
    skin = copy.surface
    waves = relief_on(
        skin.rest[:, :3], skin.corner, lambda at, _: 5e-4 * np.sin(500.0 * at[:, 0]) ** 2, spacing=1e-3, most=10**5
    )
    return skin._replace(relief=waves)


def of_kind(kind: str) -> Pressed:
    body = block(shape=(3, 3, 3))  # all matrices commute: there is a modal basis
    if kind == "truncated":
        return Pressed(body.truncated(modes=8, contacts=range(0, 27, 4)), count=3, basis="auto")
    return Pressed(body.as_full() if "full" in kind else body, count=3, basis="modal" if "modal" in kind else "nodal")


@pytest.mark.parametrize("driven", [True, False])
@pytest.mark.parametrize("cap", [1, 1000])
@pytest.mark.parametrize("kind", ["node", "full", "modal", "full modal", "truncated"])
def test_balances_whatever_the_tools_do(kind: str, cap: int, driven: bool) -> None:
    """Steps of all lengths with tools that switch between touch and grasp, jump and rub; undriven, energy falls."""
    rng, copy = np.random.default_rng(cap + 2 * driven), of_kind(kind)
    tools = copy.tools
    tools.radius[:] = 0.5 * SPACING
    tools.stiffness[:] = 10.0 ** rng.uniform(2.5, 5.5, 3)
    tools.loss[:] = [0.0, 0.5, 0.0]
    tools.friction[:] = tools.kinetic[:] = [0.0, 0.5, 0.5]
    tools.snap[:], tools.snap_range[:] = [0.0, 0.0, 0.5], 0.2 * tools.radius
    copy.surface = rough(copy) if cap == 1 else copy.surface
    tools.grip_stiffness[:], tools.grip_damping[:] = 10.0 ** rng.uniform(2, 4), 0.2
    tools.place[:, :3] = rng.uniform(0, 1.2, (3, 3)) * TOP
    tools.rate[:, :3] = 0.3 * rng.normal(size=(3, 3))
    if driven:
        tools.drive_stiffness[:], tools.drive_damping[:] = 300.0, 0.5
        tools.drive_end[:] = tools.place
    copy.state.velocity[:] = copy.model.to_rows(0.05 * rng.normal(size=(27, 3)))
    copy.begin()
    T, before, acted = 1e-3, copy.energy, {TOUCHING: 0, GRASP: 0, AWAY: 0}
    for _ in range(250):
        T = float(np.clip(T * 20.0 ** rng.uniform(-1, 1), 1e-4, 1e-2))
        for t in range(3):
            if rng.random() < 0.05:
                tools.mode[t] = rng.choice([AWAY, TOUCHING, TOUCHING, TOUCHING, GRASP])
            if rng.random() < 0.02 and tools.held[t] < 0:  # somewhere else
                tools.mode[t] = AWAY
                copy.step(T, cap)
                tools.mode[t], tools.place[t, :3] = TOUCHING, rng.uniform(-0.4, 1.4, 3) * TOP
            if driven:
                tools.drive_start[t] = tools.drive_end[t]
                tools.drive_end[t, :3] = rng.uniform(-0.2, 1.4, 3) * TOP
        copy.step(T, cap)
        assert copy.touch_ledger[TOUCH_LOSS] >= 0.0
        assert driven or copy.energy <= before + 1e-12 * copy.in_play
        before = copy.energy
        for t in np.flatnonzero(tools.touching):
            acted[int(tools.mode[t])] += 1
    assert copy.residual <= (1e-11 if cap == 1 else 1e-12) * copy.in_play  # one iteration leads far, and back
    assert min(acted[TOUCHING], acted[GRASP]) > 0
    assert acted[AWAY] == 0


def test_never_pulls() -> None:
    copy = above(0.0101, speed=0.5)
    forces = []
    for _ in range(100):
        copy.step(1e-3)
        forces.append(copy.force[2])
    assert min(forces) >= 0.0
    assert max(forces) > 1.0
    assert copy.tools.rate[0, 2] > 0.0  # bounced


def test_two_equal_tools_feel_opposite_forces() -> None:
    copy = Pressed(lattice((3, 3, 3), mass=0.3, stiffness=400.0, damping=0.5, spacing=SPACING), count=2)
    tools = copy.tools
    tools.radius[:], tools.stiffness[:] = 0.5 * SPACING, 3000.0
    tools.place[:, 1:3] = SPACING
    tools.place[:, 0] = [-0.5 * SPACING - 1e-4, 2.5 * SPACING + 1e-4]
    tools.push[:, 0], tools.drive_damping[:] = [1.0, -1.0], 1.0
    copy.begin()
    for _ in range(300):
        tools.drive_start[:] = tools.drive_end[:] = tools.place
        copy.step(1e-3)
        left, right = tools.touch_force[:, 0]
        assert left == pytest.approx(-right, rel=1e-6, abs=1e-6)
    assert left < -0.9


def test_without_drive_energy_only_falls() -> None:
    copy = above(0.0101, speed=1.0)
    copy.tools.friction[:] = copy.tools.kinetic[:] = 0.6
    copy.tools.rate[0, 0] = 0.7
    copy.begin()
    before = copy.energy
    for _ in range(200):
        copy.step(2e-3)
        assert copy.energy <= before * (1.0 + 1e-14)
        before = copy.energy


def pressed_in() -> Pressed:
    """The tool of `above` after a hand has pressed it in slowly."""
    copy = above(0.0101)
    place = [0.025, 0.031, TOP + 0.005]
    copy.lead([0.025, 0.031, TOP + 0.0101], place)
    copy.step(0.01)
    for _ in range(300):
        copy.lead(place, place)
        copy.step(1e-3)
    return copy


def test_a_contact_holds_what_its_state_says_and_hardly_more() -> None:
    """What is stored is the energy of the state and what one step leaves the next, whether worked out or foretold."""
    copy, place, foretold, rng = pressed_in(), np.array([0.025, 0.031, TOP + 0.005]), 0, np.random.default_rng(0)
    skin, work = copy.surface, copy.contact.work
    for n in range(300):  # it slides, and then trembles and lets go
        goal = place + np.array([0.01 * np.sin(0.03 * n), 0.003 * np.cos(0.05 * n), 0.0])
        if n >= 150:
            goal += 1e-3 * rng.normal(size=3) + np.array([0.0, 0.0, 0.006 * np.sin(0.1 * n)])
        copy.lead(copy.tools.drive_end[0, :3], goal)
        copy.step(1e-3)
        at = copy.tools.place[0, :3]
        own = press_skin(
            Stiffening(), copy.skin_place(), skin.corner, at, stiffness=1000.0, radius=0.01, area=skin.area
        )
        left = copy.tools.stored[0] - own[0]
        moved = 1e-3 * float(np.abs(copy.contact.work.mean[0, :3] * work.pull[0, :3]).sum())
        assert -1e-13 * own[0] <= left <= 1e-6 * moved + 1e-13 * own[0]
        foretold += int(abs(work.pressed[0, 1] - own[0]) > 1e-12 * own[0])
    assert foretold > 20
    assert copy.residual <= 1e-14 * copy.in_play


@pytest.mark.parametrize(("drop", "speed"), [(1e-4, 0.0), (2e-3, 0.0), (1e-4, 0.2)])
def test_a_tool_that_is_put_deeper_gets_no_energy(drop: float, speed: float) -> None:
    """By something else than its motion, at rest or not: the contact holds what it held, until it lets go."""
    copy = pressed_in()
    held, force = float(copy.tools.stored[0]), copy.force[2]
    copy.tools.rate[0, 0] = speed
    copy.begin()
    copy.tools.place[0, 2] -= drop
    copy.lead(copy.tools.place[0, :3], copy.tools.place[0, :3])
    copy.step(1e-3)
    assert copy.tools.stored[0] <= 1.03 * held
    assert 0.0 < copy.tools.share[0] < 1.0
    assert copy.force[2] <= 1.03 * force
    assert copy.residual <= 1e-14 * copy.in_play


def test_a_tool_at_rest_stays_for_a_minute() -> None:
    copy = above(0.0101)
    place = [0.025, 0.031, TOP + 0.005]
    copy.lead([0.025, 0.031, TOP + 0.0101], place)
    copy.step(0.01)
    for _ in range(300):
        copy.lead(place, place)
        copy.step(0.01)
    depth, force = copy.tools.place[0, 2], copy.force[2]
    assert force > 0.5
    for _ in range(6000):
        copy.step(0.01)
        assert abs(copy.force[2] - force) <= 1e-3 * force
    assert abs(copy.tools.place[0, 2] - depth) <= 1e-3 * (TOP + 0.01 - depth)


@pytest.mark.parametrize(("friction", "kinetic"), [(0.0, 0.0), (0.6, 0.4)])
def test_sliding_over_rows_of_vertices(friction: float, kinetic: float) -> None:
    """The force stays, and friction is on its cone; a contact at each local minimum jumps by 44 % here."""
    copy = plate()
    copy.tools.friction[:], copy.tools.kinetic[:] = friction, kinetic
    forces = []
    for n in range(1500):
        start, end = ([0.02 + 4e-5 * max(0, n + k - 500), 0.021, 0.016] for k in (0, 1))
        copy.lead(start, end)
        copy.step(1e-3)
        forces.append(copy.force)
    slid = np.array(forces)[900:]  # 24 mm, over two rows
    assert np.ptp(slid[:, 2]) <= 0.01 * slid[:, 2].mean()
    aside = np.linalg.norm(slid[:, :2], axis=1)
    np.testing.assert_allclose(aside, kinetic * slid[:, 2], atol=1e-3 * slid[:, 2].mean())
    assert bool(copy.tools.slipping[0]) == (friction > 0.0)
    assert copy.residual <= 1e-14 * copy.in_play


def test_what_a_step_leaves_to_the_next_makes_no_contact_softer() -> None:
    """What energy of one tool is foretold, or left to another, is no change from outside; nor is rounding."""
    copy = Pressed(block(damping=0.02), count=3, tolerance=1e-6)
    tools, middle = copy.tools, np.array([[0.02, 0.02, TOP], [0.04, 0.03, TOP], [0.025, 0.045, TOP]])
    tools.radius[:], tools.drive_stiffness[:], tools.drive_damping[:] = 0.01, 500.0, 5.0
    tools.friction[:] = tools.kinetic[:] = 0.5
    tools.place[:, :3] = middle
    tools.place[:, 2] += 0.0101
    tools.drive_end[:] = tools.place
    copy.begin()
    for n in range(600):
        tools.drive_start[:] = tools.drive_end
        tools.drive_end[:, :3] = middle
        tools.drive_end[:, 0] += 0.006 * np.sin(0.1 * n)
        tools.drive_end[:, 2] += max(0.0101 - 1e-4 * n, 0.004)
        copy.step(1e-3)
    assert tools.touching.all()
    assert np.all(tools.share == 1.0)


def test_friction_holds_below_its_cone() -> None:
    copy = plate()
    copy.tools.friction[:], copy.tools.kinetic[:] = 0.6, 0.3
    down = [0.02, 0.021, 0.016]
    for _ in range(500):
        copy.lead(down, down)
        copy.step(1e-3)
    normal = copy.force[2]
    beside = [0.02 + 0.5 * normal / 500.0, 0.021, 0.016]  # pulls with 5/6 of the cone, but for what it yields
    for _ in range(1000):
        copy.lead(beside, beside)
        copy.step(1e-3)
    held = copy.tools.place[0, 0]
    for _ in range(2000):
        copy.step(1e-3)
    assert abs(copy.tools.place[0, 0] - held) <= 1e-9
    assert copy.tools.slipping[0] == 0
    assert copy.force[0] < -0.2 * copy.force[2]


def test_a_film_drags_by_area_and_speed() -> None:
    """`c A v` along a flat, A the disc that the tool cuts off it; all that it takes is booked."""
    copy, viscosity, place = plate(), 2e4, np.array([0.02, 0.021, 0.0185])
    copy.tools.viscosity[:] = viscosity
    for _ in range(60):
        copy.lead(place, place)
        copy.step(1e-3)
    x = z = 0.0
    for speed in (0.05, 0.1):
        for _ in range(60):
            before, x, z = place, *copy.tools.place[0, [0, 2]]
            place = place + np.array([speed * 1e-3, 0.0, 0.0])
            copy.lead(before, place)
            copy.step(1e-3)
        fast, area = (copy.tools.place[0, 0] - x) / 1e-3, np.pi * (0.01**2 - (z - copy.skin_place()[:, 2].max()) ** 2)
        assert fast == pytest.approx(speed, rel=0.05)
        assert copy.force[0] == pytest.approx(-viscosity * area * fast, rel=0.02)
        # And what holds the plate feels it: a balance alone would slow the tool, and drag nothing along.
        held = (copy.body.stiffness_ext @ copy.copy.position)[:, 0].sum()
        assert held == pytest.approx(viscosity * area * fast, rel=0.05)
        assert copy.touch_ledger[TOUCH_LOSS] == pytest.approx(viscosity * area * fast**2 * 1e-3, rel=0.02)
    assert copy.residual <= 1e-13 * copy.in_play


@pytest.mark.parametrize("speed", [0.3, 1.0, 3.0, 10.0])
@pytest.mark.parametrize("who", ["tool", "body"])
def test_nothing_passes(speed: float, who: str) -> None:
    """A tool of 0.5 mm, or a body that meets it, as fast as 20 radii in a step."""
    copy = Pressed(block())
    copy.tools.radius[:] = 0.0005
    copy.tools.place[0, :3] = [0.025, 0.031, TOP + 0.0012]
    copy.tools.mass[:] = 0.005  # a heavy one drives the top through the bottom
    if speed == 3.0:  # drawn through it, or lifted by a relief that is as high as it is allowed
        copy.tools.snap[:], copy.tools.snap_range[:] = 5.0, 0.0005
        copy.surface = copy.surface._replace(relief=rough(copy).relief)
    if who == "tool":
        copy.tools.rate[0, 2] = -speed
    else:
        copy.state.velocity[:, 2] = speed
    copy.begin()
    start, touched = copy.energy, 0
    for _ in range(60):
        copy.step(1e-3)
        touched += int(copy.tools.touching[0])
        assert abs(windings(copy)) < 0.5
        assert copy.energy <= start * (1.0 + 1e-12)
    assert touched > 0
    assert copy.residual <= 1e-14 * copy.in_play


def windings(copy: Pressed, along: float = 0.0) -> float:
    """How often the skin winds around the first tool's middle, or a place so many times its axis away.

    It is 1 inside and 0 outside [van Oosterom & Strackee 1983].
    """
    away = copy.skin_place() - copy.tools.place[0, :3] - along * copy.tools.axis[0, :3]
    a, b, c = (away[copy.surface.corner[:, q]] for q in range(3))
    x, y, z = (np.linalg.norm(side, axis=1) for side in (a, b, c))
    volume = (a * np.cross(b, c)).sum(axis=1)
    beside = x * y * z + (a * b).sum(axis=1) * z + (b * c).sum(axis=1) * x + (c * a).sum(axis=1) * y
    return float(np.arctan2(volume, beside).sum() / (2.0 * np.pi))


def test_a_stylus_pushes_with_its_tip_and_lies_on_its_side() -> None:
    def pressed(axis: list[float], height: float) -> float:
        copy = plate()
        copy.tools.axis[0, :3] = axis
        copy.tools.place[0, 2] = 0.01 + 0.0101 + height
        place = [0.02, 0.021, 0.0195 + height]
        for _ in range(400):
            copy.lead(place, place, stiffness=1e4, damping=20.0)
            copy.step(1e-3)
        return float(copy.force[2])

    ball = pressed([0.0, 0.0, 0.0], 0.0)
    assert pressed([0.0, 0.0, -0.02], 0.02) == pytest.approx(ball, rel=0.02)
    assert pressed([0.01, 0.0, 0.0], 0.0) > 1.3 * ball


def test_each_ball_of_a_stylus_meets_all_that_it_reaches_and_looks_at_little_else() -> None:
    """Pressed into a skin and slid along and across it, it holds what each of its balls would hold by itself."""
    copy, rng = Pressed(block(shape=(7, 6, 3))), np.random.default_rng(1)
    skin, work, tools, looks, reached, own = copy.surface, copy.contact.work, copy.tools, 0, 0, 0.0
    tools.radius[:] = 0.004
    tools.axis[0, :3] = [0.03, 0.011, 0.006]
    tools.place[0, :3] = end = start = np.array([0.055, 0.05, TOP + 0.0102])
    copy.begin()
    along = np.linspace(-1.0, 1.0, 2 + int(4.0 * np.linalg.norm(tools.axis[0, :3]) / 0.004))
    for n in range(120):
        goal = start + np.array([0.02 * np.sin(0.1 * n), 0.02 * np.sin(0.07 * n), -min(1.5e-4 * n, 0.007)])
        goal += 1e-3 * rng.normal(size=3)
        copy.lead(end, goal)
        end = goal
        work.span[:] = 0, 0, -1
        copy.step(1e-3)
        place = copy.skin_place()
        own = sum(
            press_skin(Stiffening(), place, skin.corner, middle, stiffness=1000.0, radius=0.004, area=skin.area)[0]
            for middle in tools.place[0, :3] + along[:, None] * tools.axis[0, :3]
        )
        assert copy.tools.stored[0] == pytest.approx(own, rel=2e-6)
        looks += along.size * work.number[0]
        reached += 4 * int((work.span[:, 2] - work.span[:, 1] + 1).sum())
    assert own > 1e-4
    assert reached < 0.5 * looks
    assert copy.residual <= 1e-14 * copy.in_play


@pytest.mark.parametrize("axis", [(0.012, 0.005, 0.0), (0.004, 0.0, 0.012)])
def test_no_ball_of_a_stylus_passes(axis: tuple[float, float, float]) -> None:
    copy = Pressed(block())
    tools, along = copy.tools, np.linspace(-1.0, 1.0, 9)
    tools.radius[:], tools.mass[:] = 0.0005, 0.005
    tools.axis[0, :3], tools.rate[0, 2] = axis, -3.0
    tools.place[0, :3] = [0.025, 0.031, TOP + 0.0012 + axis[2]]
    copy.begin()
    touched = 0
    for _ in range(60):
        copy.step(1e-3)
        touched += int(tools.touching[0])
        assert max(abs(windings(copy, share)) for share in along) < 0.5
    assert touched > 0
    assert copy.residual <= 1e-14 * copy.in_play


def test_a_tool_that_begins_inside_does_not_push_until_it_was_out() -> None:
    copy = above(0.002)
    for _ in range(10):
        copy.step(1e-3)
    assert copy.tools.touching[0] == 0
    assert copy.energy == 0.0
    copy.tools.place[0, 2] = TOP + 0.0101
    copy.tools.rate[0, 2] = -0.1
    copy.begin()
    for _ in range(10):
        copy.step(1e-3)
    assert copy.tools.touching[0] == 1


def test_what_is_put_down_inside_has_no_friction_of_before() -> None:
    """It would be lost once it is out, though nothing holds it."""
    copy = plate()
    copy.tools.friction[:] = copy.tools.kinetic[:] = 0.5
    for k in range(20):
        copy.lead([0.02, 0.021, 0.0185], [0.02 + 1e-4 * k, 0.021, 0.0185])
        copy.step(1e-3)
    assert np.abs(copy.tools.stretch[0]).max() > 1e-5
    copy.tools.mode[:] = AWAY
    copy.step(1e-3)
    for height in (0.005, 0.0205):
        copy.tools.mode[:] = TOUCHING
        copy.tools.place[0, :3] = [0.02, 0.021, height]
        copy.tools.drive_stiffness[:] = 0.0
        copy.step(1e-3)
        assert not copy.tools.stretch.any()
    assert copy.residual <= 1e-13 * copy.in_play


def test_what_is_let_go_of_is_booked_as_lost() -> None:
    copy = above(0.0101, speed=0.3)
    for _ in range(6):
        copy.step(1e-3)
    held = float(copy.tools.stored[0])
    assert held > 0.0
    copy.tools.mode[:] = AWAY
    copy.step(1e-3)
    assert copy.touch_ledger[TOUCH_LOSS] == pytest.approx(held)
    assert copy.residual <= 1e-14 * copy.in_play
    copy.tools.mode[:] = TOUCHING
    copy.step(1e-3)
    assert copy.residual <= 1e-14 * copy.in_play
