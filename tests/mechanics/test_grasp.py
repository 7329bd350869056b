"""Taking, holding and letting go: springs between a tool and nodes [Lee & Huang 2010, contact law]."""

import numpy as np
import pytest
from tests.mechanics.materials import made
from tests.mechanics.pressing import SPACING, Pressed
from tests.mechanics.pressing import block as pressed_block
from tests.mechanics.reference import dense_system
from tests.mechanics.support import Port, Scene, Spring

from cotouch.body import Body, lattice
from cotouch.mechanics import AWAY, GRASP, TOUCH_LOSS, Basis


def grasping(kind: str = "node", *, radius: float = 1.1 * SPACING) -> Pressed:
    body = lattice((3, 3, 3), mass=0.3, stiffness=400.0, damping=0.2, spacing=SPACING)
    copy = Pressed(body.as_full() if "full" in kind else body, basis="modal" if "modal" in kind else "nodal")
    tools = copy.tools
    tools.mode[:] = GRASP
    tools.radius[:] = radius
    tools.grip_stiffness[:] = 2000.0
    tools.grip_damping[:] = 1.0
    tools.place[0, :3] = [SPACING, SPACING, 2 * SPACING]
    copy.begin()
    return copy


@pytest.mark.parametrize("kind", ["node", "full", "modal", "full modal"])
def test_takes_what_is_within_its_radius(kind: str):
    copy = grasping(kind)
    copy.step(1e-3)
    held = copy.tools.hold[0, : copy.tools.held[0]]
    places = copy.surface.hold_rest[:, :3]
    away = np.linalg.norm(places - [SPACING, SPACING, 2 * SPACING], axis=1)
    assert set(held) == set(np.flatnonzero(away <= 1.1 * SPACING))
    assert copy.tools.touching[0] == held.size


def test_takes_the_nearest_where_none_is_within():
    copy = grasping(radius=1e-6)
    copy.tools.place[0, :3] += [1e-3, 2e-3, 1e-3]
    copy.step(1e-3)
    assert copy.tools.held[0] == 1
    assert copy.body.rest[copy.tools.hold[0, 0]] == pytest.approx([SPACING, SPACING, 2 * SPACING])


def test_with_too_many_within_keeps_the_nearest():
    copy = grasping("modal", radius=1.0)
    copy.tools.place[0, :3] += [1e-3, 2e-3, 3e-3]
    places = copy.surface.hold_rest[:, :3]
    away = np.linalg.norm(places - copy.tools.place[0, :3], axis=1)
    copy.step(1e-3)
    count = int(copy.tools.held[0])
    assert count == 8
    assert np.sort(away[copy.tools.hold[0, :count]]) == pytest.approx(np.sort(away)[:count])


@pytest.mark.parametrize("kind", ["node", "full", "modal", "full modal"])
def test_takes_and_lets_go_at_no_gain(kind: str):
    copy = grasping(kind)
    copy.step(1e-3)
    assert copy.energy == pytest.approx(0.0, abs=1e-30)  # springs start relaxed: nothing moves
    copy.tools.rate[0, :3] = [0.3, -0.2, 0.1]
    copy.begin()
    start = copy.energy
    for _ in range(20):
        copy.step(1e-3)
    stored = float(copy.tools.stored[0])
    assert stored > 1e-6
    copy.tools.mode[:] = AWAY
    before = copy.energy
    copy.step(1e-3)
    assert copy.touch_ledger[TOUCH_LOSS] == pytest.approx(stored, rel=1e-12)
    assert copy.energy <= before - stored + 1e-15
    assert copy.tools.held[0] == -1
    assert not copy.tools.touch_force.any()
    assert copy.residual <= 1e-13 * start


def test_a_held_body_carries_momentum():
    """Tool and free body together keep theirs."""
    copy = grasping()
    copy.tools.rate[0, :3] = [0.3, -0.2, 0.1]
    copy.begin()
    total = copy.tools.mass[0] * copy.tools.rate[0, :3]
    for T in (1e-3, 5e-4, 2e-3) * 30:
        copy.step(T)
    body = np.diag(copy.body.mass.toarray())[:, None] * copy.copy.velocity
    assert body.sum(axis=0) + copy.tools.mass[0] * copy.tools.rate[0, :3] == pytest.approx(total, rel=5e-4)


KINDS = ["node", "full", "modal", "full modal", "truncated"]


def block() -> Body:
    """All matrices commute: there is a modal basis."""
    return pressed_block(shape=(3, 3, 3))


def of_kind(kind: str) -> tuple[Body, Basis]:
    body = block()
    if kind == "truncated":
        return body.truncated(modes=8, contacts=range(0, 27, 4)), "auto"
    return (body.as_full() if "full" in kind else body), ("modal" if "modal" in kind else "nodal")


def reader(copy: Pressed, what: int) -> np.ndarray:
    """The matrix (3, 3 n) that reads a node, or a vertex of the skin in a modal basis."""
    row = np.zeros(copy.body.nodes)
    if copy.surface.hold_row.shape[1] > 0:
        row[what] = 1.0
    else:
        skin = copy.body.skin
        assert skin is not None
        np.add.at(row, skin.nodes[what], skin.weights[what])
    return np.kron(row[None], np.eye(3))


@pytest.mark.parametrize("kind", KINDS)
def test_a_step_is_that_of_one_dense_system(kind: str):
    """Two grasps, hands and links: one linear system for body and tools."""
    body, basis = of_kind(kind)
    rng, n = np.random.default_rng(len(kind)), body.nodes
    draw = lambda scale: scale * rng.normal(size=3)  # noqa: E731
    start, end, push = draw(1e-3), draw(1e-3), draw(0.1)
    scene = Scene(
        body,
        1e-4 * rng.normal(size=(n, 3)),
        1e-2 * rng.normal(size=(n, 3)),
        copies=2,
        springs=[] if kind == "truncated" else [Spring(50.0, 1e-4 * rng.normal(size=(n, 3)))],
        ports=[Port(5, stiffness=300.0, damping=1.0, start=start, end=end, push=push)],
        local_damping=np.array([0.3]),
    )
    copy = Pressed(scene, count=2, basis=basis)
    tools = copy.tools
    tools.mode[:], tools.radius[:] = GRASP, 1.1 * SPACING
    tools.grip_stiffness[:], tools.grip_damping[:] = 500.0, 0.5
    tools.drive_stiffness[:], tools.drive_damping[:] = 200.0, 1.0
    tools.place[:, :3] = [[SPACING, SPACING, 2 * SPACING], [0.0, SPACING, SPACING]]
    tools.rate[:, :3] = 0.05 * rng.normal(size=(2, 3))
    copy.begin()
    for T in (1e-3, 3e-4, 2e-3):
        tools.drive_start[:] = tools.drive_end
        tools.drive_end[:, :3] = tools.place[:, :3] + 1e-3 * rng.normal(size=(2, 3))
        x, v, y, w = copy.copy.position, copy.copy.velocity, tools.place[:, :3].copy(), tools.rate[:, :3].copy()
        copy.step(T)
        size, held = 3 * n, np.arange(2) * tools.hold.shape[1]
        A, b = np.zeros((size + 6, size + 6)), np.zeros(size + 6)
        A[:size, :size], b[:size] = dense_system(type(scene)(**{**vars(scene), "position": x, "velocity": v}), T)
        for t in range(2):
            own = slice(size + 3 * t, size + 3 * t + 3)
            k, c = tools.drive_stiffness[t], tools.drive_damping[t]
            start, end = tools.drive_start[t, :3], tools.drive_end[t, :3]
            A[own, own] += (2.0 * tools.mass[t] / T + 0.5 * T * k + c) * np.eye(3)
            b[own] += 2.0 * tools.mass[t] / T * w[t] + k * (0.5 * (start + end) - y[t]) + c * (end - start) / T
            for place in range(tools.held[t]):
                H = np.zeros((3, size + 6))
                H[:, :size] = reader(copy, int(tools.hold[t, place]))
                stretch = H[:, :size] @ x.ravel() - y[t] - tools.offset[held[t] + place, :3]
                H[:, own] -= np.eye(3)
                A += H.T @ H * (0.5 + 0.5 * T * 500.0)
                b -= H.T @ (500.0 * stretch)
        modes = np.eye(size)
        if copy.model.modes is not None:
            modes = copy.model.modes if copy.model.full else np.kron(copy.model.modes, np.eye(3))
        into = np.zeros((size + 6, modes.shape[1] + 6))
        into[:size, : modes.shape[1]], into[size:, modes.shape[1] :] = modes, np.eye(6)
        mean = into @ np.linalg.solve(into.T @ A @ into, into.T @ b)
        assert copy.copy.position == pytest.approx(x + T * mean[:size].reshape(-1, 3), rel=1e-3, abs=1e-7)
        assert tools.place[:, :3] == pytest.approx(y + T * mean[size:].reshape(2, 3), rel=1e-3, abs=1e-7)
    assert tools.held.min() > 0
    assert copy.residual <= 1e-13 * copy.in_play


@pytest.mark.parametrize("name", ["cells", "corotated", "st-venant-kirchhoff"])
def test_a_body_with_a_material_is_carried(name: str):
    """One balance of grasp and material; body and tool keep their momentum together."""
    body = made(name, viscosity=1e-3)
    copy = Pressed(body)
    tools = copy.tools
    tools.mode[:], tools.radius[:] = GRASP, 0.012
    tools.grip_stiffness[:], tools.grip_damping[:] = 200.0, 0.05
    tools.place[0, :3] = body.rest.max(axis=0)
    tools.rate[0, :3] = [0.3, -0.2, 0.1]
    copy.begin()
    total, start = tools.mass[0] * tools.rate[0, :3], copy.energy
    for T in (1e-3, 5e-4, 2e-3) * 40:
        copy.step(T)
        assert copy.touch_ledger[TOUCH_LOSS] >= 0.0
    assert copy.residual <= 5e-15 * copy.in_play
    assert copy.energy < start
    mass = copy.body.mass.diagonal()
    moved = (mass[::3] if copy.body.form == "full" else mass)[:, None] * copy.copy.velocity
    assert moved.sum(axis=0) + tools.mass[0] * tools.rate[0, :3] == pytest.approx(total, rel=2e-3, abs=1e-6)
