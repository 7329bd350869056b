"""A step with tools against the dense reference, its energy, and what contact must feel like."""

import numpy as np
import pytest
from tests.mechanics.support import Port, Scene, Spring
from tests.mechanics.touch_reference import remember, touched_step
from tests.mechanics.touching import TouchedCopy

from cotouch.body import Body, Skin, lattice, point
from cotouch.mechanics import AWAY, GRASP, TOUCH, TOUCH_LOSS, Basis

SPACING = 0.02
KINDS = ["node", "full", "modal", "full modal", "truncated"]


def block(*, damping: float = 0.2, shape: tuple[int, int, int] = (3, 3, 3)) -> Body:
    return lattice(
        shape,
        mass=0.3,
        stiffness=400.0,
        damping=damping,
        spacing=SPACING,
        ground="z-",
        ground_stiffness=2000.0,
        ground_damping=5.0 * damping,  # all matrices commute: there is a modal basis
    )


def of_kind(kind: str, *, skin: bool = True) -> tuple[Body, Basis]:
    body = block() if skin else replaced_by_nodes(block())
    if kind == "truncated":
        return body.truncated(modes=8, contacts=range(0, 27, 4)), "auto"
    return (body.as_full() if "full" in kind else body), ("modal" if "modal" in kind else "nodal")


def scene(kind: str, rng: np.random.Generator, *, ports: int = 0, springs: int = 0) -> tuple[Scene, Basis]:
    """A block in motion, with hands at some nodes and links to neighbours."""
    body, basis = of_kind(kind)
    n = body.nodes
    return (
        Scene(
            body,
            1e-4 * rng.normal(size=(n, 3)),
            1e-2 * rng.normal(size=(n, 3)),
            copies=2,
            springs=[Spring(50.0 * (i + 1), 1e-4 * rng.normal(size=(n, 3))) for i in range(springs)],
            ports=[
                Port(
                    int(rng.integers(n)),
                    stiffness=300.0,
                    damping=1.0,
                    start=1e-3 * rng.normal(size=3),
                    end=1e-3 * rng.normal(size=3),
                    push=0.1 * rng.normal(size=3),
                )
                for _ in range(ports)
            ],
            local_damping=np.array([0.3]),
        ),
        basis,
    )


def equip(copy: TouchedCopy, rng: np.random.Generator, modes: list[int]) -> None:
    """Tools at and in the top of the block, driven, with accounts that do or don't suffice."""
    tools, count = copy.tools, len(modes)
    top = 2 * SPACING
    tools.mode[:] = modes
    tools.radius[:] = rng.uniform(0.3, 0.7, count) * SPACING
    tools.stiffness[:] = 10.0 ** rng.uniform(3, 6, count)
    tools.loss[:] = rng.choice([0.0, 1.0], count)
    tools.mass[:] = rng.uniform(0.02, 0.1, count)
    tools.grip_stiffness[:] = 500.0
    tools.grip_damping[:] = 0.5
    tools.drive_stiffness[:] = 200.0
    tools.drive_damping[:] = 1.0
    tools.place[:, :2] = rng.uniform(0.2, 1.8, (count, 2)) * SPACING
    tools.place[:, 2] = top + tools.radius - rng.uniform(-0.2, 1.0, count) * 1e-3
    tools.rate[:, :3] = 0.05 * rng.normal(size=(count, 3))
    tools.rate[:, 2] -= 0.05
    tools.drive_start[:, :3] = tools.place[:, :3] + 1e-3 * rng.normal(size=(count, 3))
    tools.drive_end[:, :3] = tools.drive_start[:, :3] + 1e-4 * rng.normal(size=(count, 3))
    tools.push[:, :3] = 0.2 * rng.normal(size=(count, 3))
    tools.account[:] = rng.choice([0.0, 1e-5, 1.0], count)
    copy.begin()


def agrees(copy: TouchedCopy, T: float, tolerance: float = 1e-7) -> None:
    before = remember(copy)
    copy.step(T)
    if any(tool >= 0 and not held for tool, held in zip(copy.tools.held, before.held, strict=True)):
        return  # took hold in this very step
    exact = touched_step(copy, before, T)
    tools = copy.tools
    for got, wanted, size in [
        (copy.copy.position, exact.position, 0.0),
        (copy.copy.velocity, exact.velocity, 0.0),
        (tools.place[:, :3], exact.place, 0.0),
        (tools.rate[:, :3], exact.rate, 0.0),
        (tools.touch_force[:, :3], exact.touch_force, 1e-6),
        (tools.drive_force[:, :3], exact.drive_force, 0.0),
        (copy.pushing, exact.pushing, 1e-6),
    ]:
        assert np.abs(got - wanted).max(initial=0.0) <= tolerance * max(np.abs(wanted).max(initial=0.0), size)


class TestDense:
    @pytest.mark.parametrize("seed", range(3))
    @pytest.mark.parametrize("kind", KINDS)
    def test_contacts(self, kind: str, seed: int):
        rng = np.random.default_rng(seed)
        what, basis = scene(kind, rng)
        copy = TouchedCopy(what, count=6, basis=basis)
        equip(copy, rng, [TOUCH] * 6)
        for T in (1e-3, 3e-4, 2e-3):
            agrees(copy, T)
            assert copy.count >= 5  # more than one group of columns

    @pytest.mark.parametrize("seed", range(3))
    @pytest.mark.parametrize("kind", KINDS)
    def test_contacts_grasps_hands_and_links(self, kind: str, seed: int):
        rng = np.random.default_rng(100 + seed)
        what, basis = scene(kind, rng, ports=2, springs=0 if kind == "truncated" else 2)
        copy = TouchedCopy(what, count=5, basis=basis)
        equip(copy, rng, [TOUCH, GRASP, TOUCH, GRASP, AWAY])
        for T in (1e-3, 3e-4, 2e-3, 1e-3):
            agrees(copy, T)
        assert np.all(copy.tools.held[[1, 3]] > 0)

    @pytest.mark.parametrize("friction", [0.0, 0.5])
    def test_forms_of_one_body_agree(self, friction: float):
        copies = []
        for kind in ("node", "full", "modal", "full modal"):
            rng = np.random.default_rng(7)
            what, basis = scene(kind, rng, ports=1, springs=1)
            copy = TouchedCopy(what, count=4, basis=basis)
            equip(copy, rng, [TOUCH, TOUCH, TOUCH, AWAY])
            copy.tools.friction[:] = friction
            for T in (1e-3, 2e-3, 5e-4) * 3:
                copy.step(T)
            copies.append(copy)
        for other in copies[1:]:
            assert other.copy.position == pytest.approx(copies[0].copy.position, rel=1e-6, abs=1e-11)
            assert other.tools.place == pytest.approx(copies[0].tools.place, rel=1e-6)
            assert other.tools.touch_force == pytest.approx(copies[0].tools.touch_force, rel=1e-5, abs=1e-7)


def wander(copy: TouchedCopy, rng: np.random.Generator, steps: int, *, driven: bool, cap: int) -> list[float]:
    """Steps of all lengths with tools that switch, jump and rub; returns the energy after each."""
    tools, count = copy.tools, copy.tools.mass.size
    energies = [copy.energy]
    T = 1e-3
    for _ in range(steps):
        T = float(np.clip(T * 20.0 ** rng.uniform(-1, 1), 1e-4, 1e-2))
        for t in range(count):
            if rng.random() < 0.05:
                tools.mode[t] = rng.choice([AWAY, TOUCH, TOUCH, TOUCH, GRASP])
            if rng.random() < 0.02:  # somewhere else; what a grasp holds is let go first
                tools.mode[t] = TOUCH
                if tools.held[t] < 0:
                    tools.place[t, :3] = rng.uniform(-0.2, 1.4, 3) * 2 * SPACING
            if driven:
                tools.drive_start[t] = tools.drive_end[t]
                tools.drive_end[t, :3] = rng.uniform(-0.2, 1.4, 3) * 2 * SPACING
        copy.step(T, cap)
        assert np.all(copy.pushing >= 0.0)
        energies.append(copy.energy)
    return energies


def wanderer(seed: int, kind: str, *, driven: bool, tolerance: float) -> tuple[TouchedCopy, np.random.Generator]:
    rng = np.random.default_rng(seed)
    body, basis = of_kind(kind)
    copy = TouchedCopy(body, count=3, basis=basis, tolerance=tolerance)
    tools = copy.tools
    tools.radius[:] = 0.5 * SPACING
    tools.stiffness[:] = 10.0 ** rng.uniform(3, 6, 3)
    tools.loss[:] = rng.choice([0.0, 0.5], 3)
    tools.friction[:] = rng.choice([0.0, 0.5], 3)
    tools.grip_stiffness[:] = 10.0 ** rng.uniform(2, 4)
    tools.grip_damping[:] = 0.2
    tools.place[:, :3] = rng.uniform(0, 1.2, (3, 3)) * 2 * SPACING
    tools.rate[:, :3] = 0.3 * rng.normal(size=(3, 3))
    if driven:
        tools.drive_stiffness[:] = 300.0
        tools.drive_damping[:] = 0.5
        tools.drive_end[:] = tools.place
    copy.state.velocity[:] = copy.model.to_rows(0.05 * rng.normal(size=(body.nodes, 3)))
    copy.begin()
    return copy, rng


class TestEnergy:
    @pytest.mark.parametrize("seed", range(4))
    @pytest.mark.parametrize("kind", ["node", "full", "modal", "truncated"])
    def test_balances_whatever_the_tools_do(self, kind: str, seed: int):
        copy, rng = wanderer(seed, kind, driven=True, tolerance=1e-12)
        wander(copy, rng, 250, driven=True, cap=1000)
        assert copy.residual <= 1e-12 * copy.in_play
        assert copy.debt >= -1e-12 * copy.in_play

    @pytest.mark.parametrize("cap", [1, 2, 3])
    @pytest.mark.parametrize("seed", range(4))
    @pytest.mark.parametrize("kind", ["node", "full"])
    def test_balances_with_a_solver_that_stops_early(self, kind: str, seed: int, cap: int):
        copy, rng = wanderer(seed, kind, driven=True, tolerance=1e-12)
        wander(copy, rng, 200, driven=True, cap=cap)
        assert copy.residual <= 1e-12 * copy.in_play
        assert copy.debt >= -1e-6 * copy.in_play

    @pytest.mark.parametrize("cap", [1, 1000])
    @pytest.mark.parametrize("seed", range(4))
    @pytest.mark.parametrize("kind", ["node", "full", "modal"])
    def test_without_drive_only_falls(self, kind: str, seed: int, cap: int):
        copy, rng = wanderer(50 + seed, kind, driven=False, tolerance=1e-12)
        energies = wander(copy, rng, 200, driven=False, cap=cap)
        assert np.diff(energies).max() <= 1e-12 * copy.in_play
        assert copy.residual <= 1e-12 * copy.in_play


def pressing(count: int = 1, *, basis: Basis = "nodal", body: Body | None = None) -> TouchedCopy:
    copy = TouchedCopy(body or block(), count=count, basis=basis)
    copy.tools.radius[:] = 0.5 * SPACING
    copy.tools.place[:, :3] = [0.8 * SPACING, 1.3 * SPACING, 2.5 * SPACING + 1e-3]
    copy.begin()
    return copy


class TestContact:
    @pytest.mark.parametrize("stiffness", [1e3, 1e6])
    def test_force_is_stiffness_times_depth(self, stiffness: float):
        """On a body that cannot yield, after all motion has died."""
        held = lattice((3, 3, 3), mass=1e6, stiffness=1e12, spacing=SPACING, ground="all", ground_stiffness=1e12)
        copy = pressing(body=held)
        copy.tools.stiffness[:] = stiffness
        copy.tools.push[0, 2] = -2.0
        copy.tools.drive_damping[:] = 20.0
        copy.tools.loss[:] = 1.0
        for _ in range(4000):
            copy.tools.drive_start[:] = copy.tools.place
            copy.tools.drive_end[:] = copy.tools.place
            copy.step(1e-3)
        depth = 2.5 * SPACING - copy.tools.place[0, 2]
        assert copy.tools.touch_force[0, 2] == pytest.approx(stiffness * depth, rel=1e-6)
        assert copy.tools.touch_force[0, 2] == pytest.approx(2.0, rel=1e-6)

    @pytest.mark.parametrize("kind", KINDS)
    def test_at_rest_in_contact_stays_at_rest(self, kind: str):
        """On a node, pushed straight down, so that the normal stays upright however the body yields."""
        body, basis = of_kind(kind, skin=False)
        node, stiffness, depth = 14, 2000.0, 5e-4
        copy = TouchedCopy(body, basis=basis)
        tools, n = copy.tools, body.nodes
        tools.stiffness[:] = stiffness
        tools.drive_stiffness[:] = 1000.0  # also holds it sideways: on top of a node alone it would fall off
        tools.drive_damping[:] = 1.0
        K = body.stiffness.toarray() if body.form == "full" else np.kron(body.stiffness.toarray(), np.eye(3))
        modes = np.eye(3 * n)
        if copy.model.modes is not None:
            modes = copy.model.modes if copy.model.full else np.kron(copy.model.modes, np.eye(3))
        load = np.zeros(3 * n)
        load[3 * node + 2] = -stiffness * depth
        moved = (modes @ np.linalg.solve(modes.T @ K @ modes, modes.T @ load)).reshape(n, 3)
        copy.state.position[:] = copy.model.to_rows(moved)
        tools.place[0, :3] = body.rest[node] + moved[node] + [0.0, 0.0, tools.radius[0] - depth]
        tools.account[0] = 0.5 * stiffness * depth**2
        tools.drive_start[:, :3] = tools.place[:, :3] - [0.0, 0.0, stiffness * depth / 1000.0]
        tools.drive_end[:] = tools.drive_start
        copy.begin()
        place, position = tools.place.copy(), copy.copy.position
        for _ in range(1000):
            copy.step(1e-3)
        assert np.abs(tools.place - place).max() <= 1e-9 * depth
        assert np.abs(copy.copy.position - position).max() <= 1e-9 * np.abs(position).max()
        assert tools.touch_force[0, 2] == pytest.approx(stiffness * depth, rel=1e-9)
        assert abs(copy.totals[TOUCH_LOSS]) <= 1e-15 * tools.account[0]

    def test_free_of_contact_stays_at_rest_to_the_bit(self):
        copy = pressing()
        place = copy.tools.place.copy()
        for _ in range(10):
            copy.step(1e-3)
        assert np.array_equal(copy.tools.place, place)
        assert not copy.state.position.any()
        assert copy.energy == 0.0

    @pytest.mark.parametrize("kind", ["node", "full", "modal"])
    def test_two_equal_tools_feel_opposite_forces(self, kind: str):
        body = lattice((3, 3, 3), mass=0.3, stiffness=400.0, damping=0.5, spacing=SPACING)
        if kind == "full":
            body = body.as_full()
        copy = TouchedCopy(body, count=2, basis="modal" if kind == "modal" else "nodal")
        tools = copy.tools
        tools.radius[:] = 0.5 * SPACING
        tools.stiffness[:] = 3000.0
        tools.place[:, 1:3] = SPACING
        tools.place[:, 0] = [-0.5 * SPACING - 1e-4, 2.5 * SPACING + 1e-4]
        tools.push[:, 0] = [1.0, -1.0]
        tools.drive_damping[:] = 1.0
        copy.begin()
        largest = 0.0
        for _ in range(300):
            tools.drive_start[:] = tools.place
            tools.drive_end[:] = tools.place
            copy.step(1e-3)
            left, right = tools.touch_force[:, 0]
            assert left == pytest.approx(-right, rel=1e-8, abs=1e-8)
            largest = max(largest, abs(left))
        assert largest > 0.9

    def test_never_pulls(self):
        copy = pressing()
        copy.tools.rate[0, 2] = -0.5
        copy.begin()
        lowest, highest = 0.0, 0.0
        for _ in range(100):
            copy.step(1e-3)
            lowest, highest = min(lowest, *copy.pushing, 0.0), max(highest, *copy.pushing, 0.0)
        assert lowest == 0.0
        assert highest > 1.0
        assert copy.tools.rate[0, 2] > 0.0  # bounced


class TestExtremes:
    def test_point_body(self):
        copy = TouchedCopy(point(mass=0.2, stiffness=100.0, rest=[0.0, 0.0, 0.0]))
        copy.tools.place[0, :3] = [0.0, 0.0, 0.02]
        copy.tools.rate[0, 2] = -0.3
        copy.begin()
        start = copy.energy
        for _ in range(200):
            copy.step(1e-3)
        assert copy.residual <= 1e-13 * start
        assert copy.state.velocity[0, 2] < 0.0 or copy.state.position[0, 2] != 0.0

    def test_far_and_huge_tools(self):
        copy = pressing(count=2)
        copy.tools.place[0, :3] = 1e9
        copy.tools.radius[1] = 100.0
        copy.tools.place[1, :3] = [SPACING, SPACING, 2 * SPACING + 100.0 - 1e-4]
        copy.tools.account[1] = 1.0
        copy.begin()
        for _ in range(20):
            copy.step(1e-3)
        assert np.isfinite(copy.energy)
        assert copy.tools.rate[1, 2] > 0.0
        assert not copy.tools.touch_force[0].any()

    def test_more_contacts_than_room(self):
        copy = TouchedCopy(replaced_by_nodes(block(shape=(3, 3, 3))), count=12)
        tools = copy.tools
        tools.radius[:] = 2.5 * SPACING
        tools.place[:, :3] = SPACING + 1e-4 * np.random.default_rng(0).normal(size=(12, 3))
        copy.begin()
        for _ in range(5):
            copy.step(1e-3)
        assert copy.count == 32
        assert np.isfinite(copy.energy)
        assert copy.residual <= 1e-12 * copy.in_play

    def test_many_tools_at_one_node(self):
        copy = TouchedCopy(replaced_by_nodes(block()), count=6)
        tools = copy.tools
        tools.radius[:] = 0.4 * SPACING
        tools.stiffness[:] = 1e6
        tools.place[:, :3] = [SPACING, SPACING, 2.4 * SPACING - 1e-4]
        tools.account[:] = 1.0
        copy.begin()
        for _ in range(50):
            copy.step(1e-3)
            tools_up = tools.rate[:, 2]
            assert tools_up == pytest.approx(np.full(6, tools_up.mean()), rel=1e-6, abs=1e-9)
        assert copy.residual <= 1e-12 * copy.in_play

    def test_skin_with_a_triangle_of_no_size(self):
        body = block()
        skin = body.skin
        assert skin is not None
        triangles = np.concatenate([skin.triangles, [[0, 0, 1], [2, 2, 2]]])
        odd = Skin(vertices=skin.vertices, triangles=triangles, nodes=skin.nodes, weights=skin.weights)
        copies = [TouchedCopy(body), TouchedCopy(with_skin(body, odd))]
        for copy in copies:
            copy.tools.place[0, :3] = [0.0, 0.0, 2.5 * SPACING - 1e-4]
            copy.tools.radius[:] = 0.5 * SPACING
            copy.tools.account[:] = 1.0
            copy.begin()
            copy.step(1e-3)
        assert copies[0].tools.touch_force == pytest.approx(copies[1].tools.touch_force, rel=1e-9)
        assert copies[0].tools.touch_force[0, 2] > 0.0


def with_skin(body: Body, skin: Skin | None) -> Body:
    return Body(
        mass=body.mass,
        rest=body.rest,
        damping_int=body.damping_int,
        damping_ext=body.damping_ext,
        stiffness_int=body.stiffness_int,
        stiffness_ext=body.stiffness_ext,
        skin=skin,
    )


def replaced_by_nodes(body: Body) -> Body:
    """The same without a skin."""
    return with_skin(body, None)


def test_every_skin_and_body_has_arrays_of_one_type():
    """Read-only arrays would be another type, and compile everything anew."""
    for body in (block(), replaced_by_nodes(block())):
        copy = TouchedCopy(body)
        for array in copy.surface:
            assert array.flags.writeable
            assert array.flags.c_contiguous


class TestFriction:
    @pytest.mark.parametrize("seed", range(10))
    def test_acts_across_the_normal_whichever_way_it_points(self, seed: int):
        """Around an edge or corner of the block, where normals point anywhere."""
        rng = np.random.default_rng(seed)
        copy = TouchedCopy(block())
        tools = copy.tools
        away = rng.normal(size=3)
        away /= np.linalg.norm(away)
        corner = np.where(away > 0.0, 2 * SPACING, 0.0)
        tools.radius[:] = 0.5 * SPACING
        tools.friction[:] = 0.3
        tools.place[0, :3] = corner + (0.5 * SPACING - 1e-4) * away
        across = np.cross(away, rng.normal(size=3))
        tools.rate[0, :3] = -0.1 * away + across
        tools.account[:] = 1.0
        copy.begin()
        copy.step(1e-4)
        triple = copy.touch.small.direction[:3, :3]
        assert triple[0] == pytest.approx(away, abs=1e-9)
        assert triple @ triple.T == pytest.approx(np.eye(3), abs=1e-12)
        force = tools.touch_force[0, :3]
        normal = force @ away
        rubbing = force - normal * away
        assert normal > 0.0
        assert np.linalg.norm(rubbing) <= 0.3 * normal * (1.0 + 1e-9)
        assert rubbing @ across < 0.0
        if np.linalg.norm(rubbing) > 0.3 * normal * (1.0 - 1e-9):  # slips: straight against the motion
            slip = -rubbing / np.linalg.norm(rubbing)
            assert slip @ across == pytest.approx(np.linalg.norm(across), rel=0.05)


@pytest.mark.parametrize("T", [2e-4, 1e-3, 4e-3])
def test_a_bounce_returns_what_it_took(T: float):
    """Off a body too heavy to move, without damping: a contact that lets go gives back all of its account."""
    heavy = lattice((3, 3, 2), mass=1e9, stiffness=1.0, spacing=0.02)
    copy = TouchedCopy(heavy)
    tools = copy.tools
    tools.radius[0], tools.stiffness[0] = 0.01, 1e5
    tools.place[0, :3], tools.rate[0, :3] = [0.019, 0.021, 0.0335], [0.0, 0.0, -0.4]
    copy.begin()
    touched = 0
    for _ in range(round(0.05 / T)):
        copy.step(T)
        touched += int(tools.touching[0])
    assert touched > 0
    assert tools.rate[0, 2] == pytest.approx(0.4, rel=1e-6)
    assert abs(float(tools.account[0])) < 1e-7 * copy.in_play


@pytest.mark.parametrize("tolerance", [1e-12, 1e-10, 1e-8, 1e-6, 1e-4])
def test_what_is_pressed_in_pushes_however_coarse_the_solver(tolerance: float):
    """Off light, soft bodies: an account that would be overdrawn by what the solver left out costs the whole force."""
    rng = np.random.default_rng(3)
    pressed, lost = 0, 0
    for _ in range(20):
        body = lattice((3, 3, 2), mass=10.0 ** rng.uniform(-2, 1), stiffness=10.0 ** rng.uniform(2, 4), spacing=0.02)
        copy = TouchedCopy(body, tolerance=tolerance)
        tools = copy.tools
        tools.radius[0], tools.stiffness[0] = 0.01, 10.0 ** rng.uniform(3, 6)
        tools.place[0, :3], tools.rate[0, 2] = [0.02, 0.02, 0.0305], -0.4
        copy.begin()
        T = 10.0 ** rng.uniform(-3.5, -2.5)
        for _ in range(round(0.04 / T)):
            copy.step(T)
            if np.any(copy.touch.small.depth[: copy.count] > 0.0):
                pressed += 1
                lost += int(tools.touching[0] == 0)
        assert copy.debt >= -1e-12 * copy.in_play
        assert copy.residual <= 1e-10 * copy.in_play
    assert pressed > 60
    assert lost == 0


class TestDeep:
    """A tool that comes to be deep in the body without having passed its skin slowly."""

    def deep(self) -> TouchedCopy:
        copy = TouchedCopy(block(shape=(5, 5, 5)))
        copy.tools.radius[:] = 0.15 * SPACING
        copy.tools.place[0, :3] = [2.0 * SPACING, 2.1 * SPACING, 2.6 * SPACING]  # 1.4 spacings below the top
        return copy

    @pytest.mark.parametrize("before", [AWAY, GRASP])
    def test_is_kept_from_going_deeper_from_the_first_step_that_it_touches(self, before: int):
        copy = self.deep()
        tools = copy.tools
        tools.mode[:] = before
        copy.begin()
        copy.step(1e-3)
        tools.mode[:] = TOUCH
        tools.rate[0, :3] = [0.0, 0.0, -0.05]
        copy.begin()
        copy.step(1e-3)
        assert copy.count == 1
        assert copy.touch.found.normal[0, :3] == pytest.approx([0.0, 0.0, 1.0], abs=1e-2)
        assert tools.touch_force[0, 2] > 0.0
        assert copy.residual <= 1e-10 * copy.in_play
        assert copy.debt == 0.0

    def test_is_let_out_without_a_push(self):
        copy = self.deep()
        copy.tools.rate[0, :3] = [0.0, 0.0, 0.05]
        copy.begin()
        copy.step(1e-3)
        assert copy.count == 1
        assert not copy.tools.touch_force.any()

    def test_is_found_where_one_step_took_it(self):
        """From rest above the skin to a spacing below it."""
        copy = self.deep()
        tools = copy.tools
        tools.place[0, 2] = 4.5 * SPACING
        copy.begin()
        tools.push[0, 2] = -2.0 * tools.mass[0] * 1.5 * SPACING / 1e-3**2
        copy.step(1e-3)
        assert tools.place[0, 2] == pytest.approx(3.0 * SPACING)
        assert not tools.touching.any()
        tools.push[:] = 0.0
        copy.step(1e-3)
        assert tools.touching[0] == 1
        assert tools.touch_force[0, 2] > 0.0
        assert copy.residual <= 1e-10 * copy.in_play

    def test_far_away_it_touches_nothing(self):
        copy = self.deep()
        copy.tools.place[0, 2] = 50.0 * SPACING
        copy.tools.rate[0, 2] = -1.0
        copy.begin()
        copy.step(1e-3)
        assert copy.count == 0
        assert not copy.tools.inside.any()
