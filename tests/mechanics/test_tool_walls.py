"""Points on the walls of long, round tools: what they stand for, and what is felt where edges cross."""

import numpy as np
import numpy.typing as npt
import pytest
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation
from tests.mechanics.inside import walls_of
from tests.mechanics.materials import Alone, made

from cotouch.body import (
    Body,
    Placed,
    ToolBody,
    body_from_surface,
    cut_skin,
    rigid_body,
    rigid_box,
    rigid_cylinder,
    together,
)
from cotouch.mechanics import ELASTIC, Between, closed_settle

Float = npt.NDArray[np.float64]
RADIUS, LENGTH, SIDE = 0.006, 0.12, 0.06
HELD = ToolBody(owner=0, copies=1)
# So that an edge of a box is on top, along y.
EDGE_UP = (0.0, np.pi / 4, 0.0)


def stylus(resolution: int = 8) -> Body:
    """Along x."""
    return rigid_cylinder(RADIUS, LENGTH, mass=0.02, turn=(0.0, np.pi / 2, 0.0), resolution=resolution)


def cone(angle: float, resolution: int) -> Body:
    """A stylus that gets thinner, in a file of triangles as long as it."""
    whole = stylus(resolution).skin
    assert whole is not None
    vertices = whole.vertices.copy()
    vertices[:, 1:] *= 1.0 - np.tan(angle) * (vertices[:, :1] + 0.5 * LENGTH) / RADIUS
    return body_from_surface((vertices, whole.triangles), unit="m", model="rigid", mass=0.02)


def beside(*bodies: Body, tool: Body, at: tuple[float, float, float] = (0.0, 0.0, 0.1)) -> Body:
    """A tool, turned somehow, and others."""
    placed = [Placed(body=one, name=f"{k}") for k, one in enumerate(bodies)]
    return together([*placed, Placed(body=tool, name="tool", at=at, turn=(0.3, -0.2, 0.5), tool=HELD)])


def moments(corners: Float) -> tuple[Float, Float, Float]:
    """Area of each triangle, their centre, and `∫ r rᵀ` over them."""
    area = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    middles = 0.5 * (corners + np.roll(corners, 1, axis=1))
    second = np.einsum("f,fea,feb->ab", area / 3.0, middles, middles)
    return area, area @ corners.mean(axis=1) / area.sum(), second


@pytest.mark.parametrize(
    "tool", [stylus(1), stylus(8), stylus(100), cone(0.02, 1)], ids=["coarse", "default", "fine", "cone"]
)
def test_they_stand_for_the_wall_whatever_its_triangles(tool: Body) -> None:
    """Area and middle are exact, second moments but for the length of a slice; so are force and torque on faces."""
    body = beside(rigid_box([SIDE] * 3), tool=tool)
    assert body.skin is not None
    walls = walls_of(body, None, RADIUS)
    assert list(walls.tools) == [1]
    corners = body.skin.vertices[body.skin.triangles]
    area, _, _ = moments(corners)
    gone = np.setdiff1d(np.arange(area.size), walls.left)
    assert walls.part_of.sum(axis=1) == pytest.approx(1.0, abs=1e-12)
    assert walls.part_of.T @ walls.area == pytest.approx(np.where(np.isin(np.arange(area.size), gone), area, 0.0))
    assert walls.carry @ body.rest == pytest.approx(walls.places, abs=1e-15)
    assert np.abs(walls.carry[:, : body.parts[1].first]).sum() == 0.0
    area, middle, second = moments(corners[gone] - body.skin.vertices.mean(axis=0))
    places = walls.places - body.skin.vertices.mean(axis=0)
    assert walls.area @ places / walls.area.sum() == pytest.approx(middle, abs=1e-6 * LENGTH)
    found = np.einsum("p,pa,pb->ab", walls.area, places, places)
    assert np.abs(found - second).max() <= 1e-4 * np.abs(second).max()
    beside_it = Rotation.from_rotvec((0.3, -0.2, 0.5)).apply(np.eye(3))[1:]
    about = area.sum() * np.outer(middle, middle)
    across, exact = (beside_it @ (one - about) @ beside_it.T for one in (found, second))
    assert np.abs(across - exact).max() <= 5e-4 * np.abs(exact).max()


def test_what_is_short_or_has_edges_along_it_or_is_no_tool_keeps_its_points() -> None:
    bar, peg = rigid_box([LENGTH, 0.012, 0.012]), rigid_cylinder(RADIUS, 7.0 * RADIUS)
    assert not any(walls_of(beside(tool=tool), None, RADIUS).tools for tool in (bar, peg))
    shared = together([Placed(body=stylus(), name="no tool")])
    assert walls_of(shared, None, RADIUS).tools == {}
    assert walls_of(beside(tool=stylus()), None, RADIUS).tools == {0: pytest.approx(2.0 * RADIUS, rel=0.01)}


def test_what_does_not_hang_together_has_no_point_in_common() -> None:
    """Two tines that look the same ways, and nothing between them."""
    one = stylus().skin
    assert one is not None
    aside = np.array([0.0, 3.0 * RADIUS, 0.0])
    vertices = np.concatenate([one.vertices - aside, one.vertices + aside])
    triangles = np.concatenate([one.triangles, one.triangles + one.vertices.shape[0]])
    fork = rigid_body(vertices, triangles, mass=0.04, centre=[0.0] * 3, spread=np.diag([1e-3, 4e-4, 1e-4]))
    whole = together([Placed(body=fork, name="fork", tool=HELD)])
    places = walls_of(whole, None, RADIUS).places
    assert places.shape[0] > 1000
    assert np.hypot(np.abs(places[:, 1]) - 3.0 * RADIUS, places[:, 2]) == pytest.approx(RADIUS, rel=0.01)


def test_nothing_thin_fits_between_them() -> None:
    """Where something might, there are none: points are then as close as without them."""
    body, fine = beside(tool=stylus()), beside(tool=stylus(100))
    assert fine.skin is not None
    assert walls_of(body, None, 2.3e-3).tools == {}
    wire = beside(tool=rigid_cylinder(0.1 * RADIUS, 2.0 * LENGTH))
    assert walls_of(wire, None, 0.2 * RADIUS).tools == {}
    points = cKDTree(walls_of(body, None, 2.4e-3).places)
    wall = np.delete(fine.skin.triangles, walls_of(fine, None, RADIUS).left, axis=0)
    # As far as the middle of a triangle with sides that long is from its corners.
    assert points.query(fine.skin.vertices[np.unique(wall)])[0].max() <= 2.4e-3 / np.sqrt(3.0)


@pytest.mark.parametrize(("side", "points"), [(SIDE, 486), (0.02, 486)])
def test_its_triangles_say_nothing_of_the_points_of_others(side: float, points: int) -> None:
    """Else 120 mm of them put 25,350 points on a box. One that is smaller than the tool has them half as far apart."""
    for resolution in (1, 8, 32):
        body = beside(rigid_box([side] * 3), tool=stylus(resolution))
        force = Alone(body, between=Between()).force
        assert force.world is not None
        assert force.world.bodies is not None
        assert np.bincount(force.world.bodies.part)[0] == points


def test_beside_what_can_be_cut_they_are_there_and_stay() -> None:
    body = beside(made("cells").with_cutting(), tool=stylus(), at=(0.0, 0.0, 0.1))
    world = Alone(body, between=Between()).force.world
    faces = cut_skin(body)
    assert world is not None
    assert faces is not None
    walls = walls_of(body, faces, RADIUS)
    assert walls.part_of.indices.min() >= faces.triangles[1]
    own = world.whole[-walls.area.size :]
    assert walls.area.size > 2000
    assert own == pytest.approx(1.0)
    assert world.area[-walls.area.size :] == pytest.approx(walls.area)


def pair(block: Placed, turn: tuple[float, float, float], stiffness: float) -> Alone:
    """A stylus at the origin, and a block."""
    tool = Placed(body=stylus(), name="tool", at=(0.0, 0.0, 0.0), turn=turn, tool=HELD)
    return Alone(together([tool, block]), between=Between(stiffness=stiffness))


def lift(copy: Alone, at: Float) -> float:
    """What pushes the stylus up where it is put, by the slope of the energy between the two [N]."""
    energy = []
    for above in (-1e-6, 1e-6):
        places = np.zeros((8, 3))
        places[:4] = at + np.array([0.0, 0.0, above])
        copy.state.position[:] = copy.model.to_rows(places)
        closed_settle(copy.model.operator, copy.force, copy.state, copy.work, copy.ledger, copy.model.lanes)
        energy.append(float(copy.ledger[ELASTIC]))
    return (energy[0] - energy[1]) / 2e-6


@pytest.mark.parametrize(("angle", "mean", "spread"), [(90, 0.18, 0.4), (60, 0.206, 0.2), (30, 0.35, 0.25)])
def test_across_an_edge_it_hardly_matters_where_along_it(angle: float, mean: float, spread: float) -> None:
    """With points half a thickness apart the greatest force was up to 9 times the mean, the least almost none."""
    turn = (0.0, 0.0, np.radians(angle - 90.0))
    block = Placed(body=rigid_box([SIDE] * 3), name="block", at=(0.0, 0.0, -SIDE / np.sqrt(2.0)), turn=EDGE_UP)
    copy, along = pair(block, turn, 1e8), Rotation.from_rotvec(turn).apply([1.0, 0.0, 0.0])
    for deep, most in ((1e-3, spread), (2e-3, 0.1)):
        places = np.linspace(-0.0137, 0.0163, 40)
        force = np.array([lift(copy, place * along + np.array([0.0, 0.0, RADIUS - deep])) for place in places])
        assert np.ptp(force) <= most * force.mean()
        if deep == 1e-3:
            assert force.mean() == pytest.approx(mean, rel=0.02)


def test_rolled_on_a_face_it_is_felt_as_its_facets_say() -> None:
    """24 facets of 60 mm, 0.2 mm deep: 0.188 N on average, by the integral of the depth, and 4 % between extremes."""
    block = Placed(body=rigid_box([SIDE] * 3), name="block", at=(0.0, 0.0, -0.5 * SIDE))
    rolls = np.linspace(0.0, np.radians(15.0), 7)
    force = [lift(pair(block, (roll, 0.0, 0.0), 1e7), np.array([0.0, 0.0, RADIUS - 2e-4])) for roll in rolls]
    assert np.mean(force[:-1]) == pytest.approx(0.188, rel=0.03)
    assert np.ptp(force) <= 0.12 * np.mean(force)
