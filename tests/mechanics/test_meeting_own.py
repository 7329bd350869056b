"""A body that meets itself: it does not pass through, and what its parts do to each other two bodies would do."""

import numpy as np
import numpy.typing as npt
import pytest
from tests.mechanics.materials import boxes
from tests.mechanics.test_meeting import Several

from cotouch.body import Body, Placed, body_from_surface, lattice, rigid_box, together
from cotouch.mechanics import CLOSURE_ALARM, SHORTENED, WORLD_STORED, Between, closed_settle, model

Float = npt.NDArray[np.float64]
H = 0.01
OWN = Between(stiffness=1e8, own=True)


def solid(keep: npt.NDArray[np.bool_]) -> Body:
    """The cubes of a grid that are kept, of 1 cm each."""
    points, tetrahedra = boxes(tuple(n + 1 for n in keep.shape), H)
    tetrahedra = tetrahedra[keep[tuple(np.floor(points[tetrahedra].mean(axis=1) / H).astype(int).T)]]
    edges = points[tetrahedra[:, 1:]] - points[tetrahedra[:, :1]]
    outwards = np.where((np.linalg.det(edges) > 0.0)[:, None], [0, 1, 2, 3], [0, 2, 1, 3])
    tetrahedra = np.take_along_axis(tetrahedra, outwards, axis=1)
    faces = tetrahedra[:, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]].reshape(-1, 3)
    _, first, number = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    used, corner = np.unique(faces[first[number == 1]], return_inverse=True)
    return body_from_surface(
        (points[used], corner.reshape(-1, 3)),
        unit="m",
        model="cells",
        resolution=max(keep.shape),
        young=2e5,
        density=1000.0,
    )


def clamp(within: int = 0) -> Body:
    """Two arms of 6 x 3 x 2 cm, 2 cm apart, and a back that joins them; the upper's rim is so many cm within."""
    keep = np.ones((8, 3 + 2 * within, 6), dtype=bool)
    keep[2:, :, 2:4] = False
    keep[2:, :within, 4:] = keep[2:, 3 + within :, 4:] = keep[8 - within :, :, 4:] = False
    return solid(keep)


def arms(body: Body) -> tuple[npt.NDArray[np.bool_], npt.NDArray[np.bool_]]:
    """Which nodes are of the lower arm, and of the upper one."""
    rest = place(body)
    return (rest[:, 0] > 2.5 * H) & (rest[:, 2] < 3 * H), (rest[:, 0] > 2.5 * H) & (rest[:, 2] > 3 * H)


def place(body: Body) -> Float:
    """Of its nodes at rest, from its least corner."""
    return body.rest - body.rest.min(axis=0)


def shut(speed: float, between: Between = OWN) -> Several:
    body = clamp(1)
    low, high = arms(body)
    scene = Several(body, between=between)
    velocity = np.zeros((body.nodes, 3))
    velocity[low, 2], velocity[high, 2] = speed, -speed
    scene.state.velocity[:] = scene.rows(velocity)
    settled(scene)
    return scene


def settled(scene: Several) -> None:
    """After its state was set."""
    closed_settle(scene.model.operator, scene.force, scene.state, scene.work, scene.ledger, scene.model.lanes)


def gap(scene: Several) -> float:
    """Least height of the upper arm above the lower one."""
    now, rest = scene.position + scene.body.rest, place(scene.body)
    facing = (rest[:, 0] > 2.5 * H) & (rest[:, 0] < 7.5 * H) & (np.abs(rest[:, 1] - 2.5 * H) < 2 * H)
    lower, upper = (np.isclose(rest[:, 2], z) & facing for z in (2 * H, 4 * H))
    return float((now[upper, 2] - now[lower, 2]).min())


@pytest.mark.parametrize("between", [OWN, Between(stiffness=1e8, own=True, loss=1.0, friction=0.5)])
def test_what_is_squeezed_shut_does_not_pass_through_itself(between: Between) -> None:
    scene = shut(1.0, between)
    momentum, spin, least, felt = scene.momentum(), scene.spin(), np.inf, 0.0
    for _ in range(60):
        scene.run(1, 5e-4)
        least, felt = min(least, gap(scene)), max(felt, float(scene.ledger[WORLD_STORED]))
    assert felt > 0.0
    assert -0.25 * H < least < 0.0
    assert gap(scene) > least + 0.5 * H  # it opens again
    assert scene.momentum() == pytest.approx(momentum, abs=1e-13)
    assert scene.spin() == pytest.approx(spin, abs=1e-4)
    assert scene.beta <= CLOSURE_ALARM


def test_without_it_the_arms_pass_each_other() -> None:
    scene = shut(2.0)
    assert scene.force.world is not None
    assert scene.force.world.bodies is not None
    scene.force.world.bodies.within[:] = 0.0
    for _ in range(60):
        scene.run(1, 5e-4)
    assert scene.ledger[WORLD_STORED] == 0.0
    assert gap(scene) < -0.5 * H


def test_what_is_as_deep_in_itself_as_it_may_come_is_pushed_back() -> None:
    """Arms that still come nearer, at a speed that contact turns back within the step: nothing shortens that."""
    scene = Several(clamp(1), between=Between(stiffness=1e7, own=True))
    assert scene.force.world is not None
    assert scene.force.world.bodies is not None
    within, rest, (_, high) = scene.force.world.bodies.within[0], place(scene.body), arms(scene.body)
    down, deep = np.zeros((scene.body.nodes, 3)), 0.7 * within
    down[:, 2] = -np.clip((rest[:, 0] - 2 * H) / (4 * H), 0.0, 1.0) * high
    for _ in range(3):
        scene.state.position[:] = scene.rows((2 * H + deep) * down)
        deep += (1.0 - 1e-6) * within - scene.deepest()
    scene.state.velocity[:] = scene.rows(5.0 * down)
    settled(scene)
    assert scene.deepest() == pytest.approx(within, rel=1e-5)
    before = gap(scene)
    scene.run(1, 2e-3)
    assert scene.ledger[SHORTENED] == 0.0
    assert gap(scene) > before + 0.1 * H


def test_the_same_parts_as_two_bodies_hold_the_same() -> None:
    """Arms pushed into each other, as one body and as two."""
    deep = 0.02 * H
    keep = np.ones((12, 3, 6), dtype=bool)
    keep[2:, :, 2:4] = False
    whole = solid(keep)
    field, rest = np.zeros((whole.nodes, 3)), place(whole)
    down = np.clip((rest[:, 0] - 2 * H) / (4 * H), 0.0, 1.0) * (rest[:, 2] > 3 * H)  # bent to 6 cm, flat to 12 cm
    field[:, 2] = -(2 * H + deep) * down
    one = Several(whole, between=OWN)
    one.state.position[:] = one.rows(field)
    arm = solid(np.ones((6, 3, 2), dtype=bool))
    two = Several(
        (arm, (5 * H, 1.5 * H, H), (0.0,) * 3), (arm, (5 * H, 1.5 * H, 3 * H - deep), (0.0,) * 3), between=OWN
    )
    held: list[float] = []
    for scene in (one, two):
        settled(scene)
        held.append(float(scene.ledger[WORLD_STORED]))
    assert held[0] == pytest.approx(held[1], rel=0.02)
    assert held[1] == pytest.approx(0.5 * 1e8 * deep**2 * 18 * H**2, rel=1e-9)


def test_a_folded_strip_does_not_pass_through_itself() -> None:
    """A strip, bent over once; its legs come down on each other."""
    strip = lattice((25, 4, 2), mass=0.1, stiffness=50.0, damping=0.05, spacing=H, model="cells")
    radius, rest = 2.0 * H, place(strip)
    along, height = rest[:, 0] - 12 * H, rest[:, 2]
    half = 0.5 * np.pi * radius
    angle, beyond = np.clip(along, -half, half) / radius, np.maximum(np.abs(along) - half, 0.0)
    away = radius - height
    aside = 0.25 * H * np.sin(angle)  # or rims would slide off rims
    folded = np.stack([away * np.sin(angle), rest[:, 1] + aside, beyond - away * np.cos(angle)], axis=1)
    scene = Several(strip, between=Between(stiffness=1e7, own=True, loss=1.0, friction=0.3))
    speed, middle = np.zeros((strip.nodes, 3)), np.abs(rest[:, 1] - 1.5 * H) < H
    right, left = (np.isclose(height, H) & (side * along > 4.5 * H) & middle for side in (1.0, -1.0))
    speed[along > half, 0], speed[along < -half, 0] = -2.0, 2.0
    scene.state.position[:], scene.state.velocity[:] = scene.rows(folded - strip.rest), scene.rows(speed)
    settled(scene)
    scene.scale = scene.energy
    assert scene.ledger[WORLD_STORED] == 0.0
    least, felt = np.inf, 0.0
    for _ in range(34):
        scene.run(1, 2.5e-4)
        now = scene.position + strip.rest
        least = min(least, float(now[right, 0].min() - now[left, 0].max()))
        felt = max(felt, float(scene.ledger[WORLD_STORED]))
    assert felt > 0.0
    assert least > -0.5 * H
    assert scene.beta <= CLOSURE_ALARM


def test_what_is_squashed_flat_keeps_its_balance() -> None:
    """Its far side comes so near that it is taken for another part, which costs what that would hold."""
    body = lattice((5, 4, 6), mass=0.1, stiffness=1.0, damping=0.0, spacing=H, model="cells")
    scene = Several(body, between=Between(stiffness=1e5, own=True))
    velocity = np.zeros((body.nodes, 3))
    velocity[:, 2] = -100.0 * (place(body)[:, 2] - 2.5 * H)
    scene.state.velocity[:] = scene.rows(velocity)
    settled(scene)
    felt = 0.0
    for _ in range(60):
        scene.run(1, 5e-4)
        felt = max(felt, float(scene.ledger[WORLD_STORED]))
    assert felt > 0.0


def test_what_is_near_at_rest_is_left_out() -> None:
    body = together([Placed(body=clamp(), name="clamp")])
    force = model(body, between=OWN).force
    assert force is not None
    assert force.world is not None
    meeting = force.world.bodies
    assert meeting is not None
    assert meeting.within == pytest.approx([0.75 * H])
    rest, corner = meeting.rest[:, :3], meeting.corner
    middle, points = rest[corner].mean(axis=1), force.world.rest[:, :3]
    upper = np.flatnonzero((points[:, 2] > 0.9 * H) & (points[:, 2] < 1.1 * H) & (points[:, 0] > H))
    assert upper.size > 0
    for p in upper:
        near = meeting.skip[meeting.skips[p] : meeting.skips[p + 1]]
        assert (np.diff(near) > 0).all()
        away = np.linalg.norm(middle - points[p], axis=1)
        assert set(np.flatnonzero(away < 0.9 * H)) <= set(near)  # its own corner
        facing = np.flatnonzero((middle[:, 2] < 0.0) & (middle[:, 0] > H))
        assert not set(facing) & set(near)  # across the gap


def test_a_rigid_body_does_not_meet_itself() -> None:
    scene = Several(rigid_box([0.1, 0.1, 0.1], mass=1.0), between=OWN, speeds=((1.0, 0.0, 0.0),))
    scene.run(5)
    assert scene.momentum() == pytest.approx([1.0, 0.0, 0.0])
    assert scene.force.world is not None
    assert scene.force.world.bodies is not None
    assert scene.force.world.bodies.entries[1] == 0
