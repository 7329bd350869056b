"""Cutting: the energy that goes is that of the elements that go, and a blade takes what it goes through."""

from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from scipy.spatial import KDTree
from tests.mechanics.inside import EDGES, SOLIDS, crosses, gradients_of, lame_of, principal_stress
from tests.mechanics.materials import YOUNG, Alone, bent, boxes, energy_at, made

from cotouch.body import FACES, Body, body_from_tetrahedra, cut_skin, lattice
from cotouch.errors import BodyError
from cotouch.mechanics import (
    BETA,
    CUT,
    CUT_COUNT,
    Cutting,
    begin_cut,
    cutting_of,
    decide_cuts,
    expose,
    hear_cuts,
    model,
    sever,
    surface_of,
)

Float = npt.NDArray[np.float64]
CUTTABLE = ("spring-network", "cells", "corotated", "st-venant-kirchhoff", "neo-hookean")


def cut_copy(name: str, *, tear: float = np.inf, copies: int = 1) -> tuple[Alone, Cutting]:
    body = made(name, viscosity=1e-3).with_cutting(tear)
    rng = np.random.default_rng(4)
    still = rng.normal(scale=0.05, size=body.rest.shape)
    copy = Alone(body, bent(body, 0.3), still, copies=copies)
    cutting = cutting_of(copy.model)
    assert cutting is not None
    return copy, cutting


def take_away(copy: Alone, cutting: Cutting, elements: npt.NDArray[np.int64], step: int = 0) -> int:
    begin_cut(cutting, None, copy.state, None)
    cutting.wanted[elements] = 1
    return sever(cutting, copy.model.operator, copy.force, copy.state, step, copy.ledger, copy.model.lanes)


def held_by(copy: Alone, cutting: Cutting, element: int) -> float:
    """What one element holds: of a body in which all others are cut."""
    memory = copy.state.memory.copy()
    memory[cutting.first : cutting.first + cutting.wanted.size] = 1.0
    memory[cutting.first + element] = 0.0
    x = copy.state.position
    return energy_at(copy.force, memory, x, x, np.zeros_like(x), 0, copy.model.lanes)[0]


@pytest.mark.parametrize("name", CUTTABLE)
def test_energy_falls_by_what_the_elements_held(name: str) -> None:
    copy, cutting = cut_copy(name, copies=2)
    before, count = copy.energy, cutting.wanted.size
    elements = np.random.default_rng(1).choice(count, count // 3, replace=False)
    single = [held_by(copy, cutting, int(element)) for element in elements]
    assert min(single) >= 0.0
    moving = 0.5 * copy.model.operator.mass * (copy.state.velocity**2).sum(axis=1)
    assert take_away(copy, cutting, elements) == elements.size
    assert copy.ledger[CUT_COUNT] == elements.size
    assert copy.ledger[CUT] > 0.0
    debris = copy.model.operator.debris != 0
    assert np.array_equal(debris, (copy.state.velocity == 0.0).all(axis=1))
    went = 0.5 * (sum(single) + moving[debris].sum())  # and nodes that have lost their last one stop
    assert before - copy.energy == pytest.approx(went, rel=1e-12)
    assert copy.ledger[CUT] == pytest.approx(went, rel=1e-12)
    assert take_away(copy, cutting, elements) == 0  # they are gone
    assert copy.ledger[CUT] == 0.0


@pytest.mark.parametrize("name", CUTTABLE)
def test_what_is_left_moves_on_in_balance(name: str) -> None:
    """Cut as it moves; then every step balances."""
    copy, cutting = cut_copy(name, copies=2)
    for _ in range(5):
        copy.step(1e-3)
    before, count = copy.energy, cutting.wanted.size
    elements = np.random.default_rng(1).choice(count, count // 3, replace=False)
    assert take_away(copy, cutting, elements) == elements.size
    assert before - copy.energy == pytest.approx(copy.ledger[CUT], rel=1e-12)
    for _ in range(50):
        energy = copy.energy
        ledger = copy.step(1e-3)
        assert copy.energy - energy + ledger[1] == pytest.approx(0.0, abs=1e-14 * before)


def test_springs_held_what_hookes_law_says() -> None:
    copy, cutting = cut_copy("spring-network")
    material, places = copy.body.material, copy.body.rest + copy.position
    assert material is not None
    ends, rest = places[material.elements], copy.body.rest[material.elements]
    stretch = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) - np.linalg.norm(rest[:, 1] - rest[:, 0], axis=1)
    chosen = np.arange(0, stretch.size, 3)
    take_away(copy, cutting, chosen)
    held = 0.5 * material.stiffness[chosen] * stretch[chosen] ** 2
    assert copy.ledger[CUT] == pytest.approx(float(held.sum()), rel=1e-12)


@pytest.mark.parametrize("name", ["spring-network", "cells", "neo-hookean"])
def test_cut_to_pieces_every_node_rests_where_it_is(name: str) -> None:
    copy, cutting = cut_copy(name)
    copy.step(1e-3)
    before = copy.energy
    take_away(copy, cutting, np.arange(cutting.wanted.size))
    place = copy.state.position.copy()
    assert copy.ledger[CUT] == pytest.approx(before, rel=1e-12)
    for _ in range(20):
        begin_cut(cutting, None, copy.state, None)
        assert copy.step(1e-3)[BETA] <= 1e-12
    assert copy.energy == 0.0
    assert np.array_equal(copy.state.position, place)
    assert not copy.velocity.any()


@pytest.mark.parametrize("name", ["spring-network", "cells"])
def test_a_node_that_has_lost_its_last_element_rests_and_the_others_move_on(name: str) -> None:
    copy, cutting = cut_copy(name)
    copy.step(1e-3)
    corner = int(cutting.corner[0, 0])
    take_away(copy, cutting, np.flatnonzero((cutting.corner == corner).any(axis=1)))
    debris = copy.model.operator.debris != 0
    assert debris[corner]
    assert 0 < np.count_nonzero(debris) < debris.size // 2
    place = copy.state.position.copy()
    for _ in range(20):
        begin_cut(cutting, None, copy.state, None)
        energy = copy.energy
        ledger = copy.step(1e-3)
        assert copy.energy - energy + ledger[1] == pytest.approx(0.0, abs=1e-14 * copy.energy)
    assert np.array_equal(copy.state.position[debris], place[debris])
    assert (copy.state.position[~debris] != place[~debris]).any(axis=1).all()


@pytest.mark.parametrize("name", ["cells", "corotated"])
def test_what_was_cut_is_whole_again_in_the_matrix_of_another_copy(name: str) -> None:
    copy, cutting = cut_copy(name)
    op = copy.model.operator
    whole = op.entries.copy()
    rng = np.random.default_rng(2)
    take_away(copy, cutting, rng.choice(cutting.wanted.size, 2 * cutting.wanted.size // 3, replace=False))
    begin_cut(cutting, None, copy.state, None)
    out = whole - op.entries
    assert out.any()
    np.testing.assert_allclose(op.taken, np.add.reduceat(out, op.pointer[:-1], axis=1), rtol=1e-12)
    other = copy.state._replace(memory=copy.state.memory.copy())
    other.memory[cutting.first - 1 : cutting.first + cutting.wanted.size] = 0.0
    begin_cut(cutting, None, other, None)
    assert np.array_equal(op.entries, whole)
    assert not op.taken.any()


def test_across_a_cut_force_and_energy_agree() -> None:
    copy, cutting = cut_copy("cells")
    take_away(copy, cutting, np.arange(cutting.wanted.size // 3, 2 * cutting.wanted.size // 3))
    assert max(float(copy.step(2e-3)[BETA]) for _ in range(100)) <= 2e-3


def test_what_is_stretched_too_far_breaks() -> None:
    copy, cutting = cut_copy("spring-network", tear=0.05)
    material, places = copy.body.material, copy.body.rest + copy.position
    assert material is not None
    length, rest = (
        np.linalg.norm(shape[material.elements[:, 1]] - shape[material.elements[:, 0]], axis=1)
        for shape in (places, copy.body.rest)
    )
    begin_cut(cutting, None, copy.state, None)
    decide_cuts(cutting, copy.state.memory, copy.state.position, None, 3, True)
    too_far = length > 1.05 * rest
    assert 0 < np.count_nonzero(too_far) < rest.size
    assert np.array_equal(cutting.wanted, np.where(too_far, 3, 0))


@pytest.mark.parametrize("name", ["corotated", "st-venant-kirchhoff", "neo-hookean"])
def test_the_principal_stress_is_the_slope_of_the_energy(name: str) -> None:
    """Of any turned stretch: dψ/dλ by differences of the energy of one tetrahedron, whichever law it has."""
    rng, rest = np.random.default_rng(8), np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.1, 1]])
    whole = body_from_tetrahedra((rest, [[0, 1, 2, 3]]), unit="m", model=name, young=7.0, poisson=0.3)
    material = whole.material
    assert material is not None
    gradient, lame = gradients_of(whole.rest, material.elements), lame_of(material)
    copy = Alone(whole)
    middle, volume = whole.rest.mean(axis=0), float(copy.force.table.volume[0])
    for _ in range(20):
        stretch = rng.uniform(0.7, 1.5, 3)
        one, two = (np.linalg.qr(rng.normal(size=(3, 3)))[0] for _ in range(2))
        one, two = one * np.linalg.det(one), two * np.linalg.det(two)

        def energy(stretch: Float, one: Float = one, two: Float = two) -> float:
            place = (whole.rest - middle) @ (one @ np.diag(stretch) @ two).T
            x = copy.rows(place - (whole.rest - middle))
            memory = copy.state.memory
            return energy_at(copy.force, memory, x, x, np.zeros_like(x), 200, copy.model.lanes)[0] / volume

        slopes = [(energy(stretch + h) - energy(stretch - h)) / 2e-5 for h in 1e-5 * np.eye(3)]
        spot = np.zeros((4, 4))
        spot[:, :3] = whole.rest[material.elements[0]] @ (one @ np.diag(stretch) @ two).T
        found = principal_stress(SOLIDS.index(name), lame[0, 0], lame[0, 1], spot, gradient, 0)
        great = int(np.argmax(stretch))
        assert found == pytest.approx(slopes[great], rel=1e-5, abs=1e-5)


@pytest.mark.parametrize("name", CUTTABLE)
def test_what_bears_too_much_stress_breaks(name: Any) -> None:
    """Stretched by 4 % along one axis: E times that, of cells and tetrahedra without Poisson's ratio."""
    body = made(name)
    if body.material is not None and body.material.solid and name != "neo-hookean":
        body = body_from_tetrahedra(boxes(), unit="m", model=name, young=YOUNG, poisson=0.0)
    x = np.zeros_like(body.rest)
    x[:, 0] = 0.04 * body.rest[:, 0]
    bears = 0.04 * YOUNG * (0.4 if name == "spring-network" else 1.0)  # k is 0.4 E h, of an edge as wide as long
    for share, breaks in ((0.8, True), (1.8, False)):
        copy = Alone(body.with_cutting(strength=share * bears), x)
        cutting = cutting_of(copy.model)
        assert cutting is not None
        decide_cuts(cutting, copy.state.memory, copy.state.position, None, 1, True)
        assert bool(cutting.wanted.any()) == breaks
        if name in {"cells", "corotated", "st-venant-kirchhoff"}:
            assert bool(cutting.wanted.all()) == breaks


def test_a_neighbour_is_heard_as_of_the_sample_that_arrived() -> None:
    copy, cutting = cut_copy("cells")
    other = copy.state.memory.copy()
    other[cutting.first + np.array([1, 4])] = 1.0 + np.array([7, 9])  # after steps 7 and 9
    other[cutting.first + cutting.wanted.size + np.array([1, 4])] = 2.0
    for sample, expected in ((6, []), (7, [1]), (8, [1]), (9, [1, 4])):
        begin_cut(cutting, None, copy.state, None)
        hear_cuts(cutting, copy.state.memory, other, sample)
        assert np.flatnonzero(cutting.wanted).tolist() == expected
        assert set(cutting.wanted[expected].tolist()) <= {2}


def sampled(spot: Float, corners: int, reach: float) -> bool:
    """Whether a fine set of points of the quadrilateral's two triangles comes near a fine set in a tetrahedron."""
    line = np.linspace(0.0, 1.0, 30)
    a, b = (grid.ravel() for grid in np.meshgrid(line, line))
    a, b = np.where(a + b > 1.0, 1.0 - a, a), np.where(a + b > 1.0, 1.0 - b, b)
    one, two, three, four = spot[corners:, :3]
    flat = np.concatenate(
        [one + a[:, None] * (q - one) + b[:, None] * (r - one) for q, r in ((two, three), (three, four))]
    )
    inverse = np.linalg.inv((spot[1:4, :3] - spot[0, :3]).T)
    share = (flat - spot[0, :3]) @ inverse.T
    share = np.column_stack([1.0 - share.sum(axis=1), share])
    if reach == 0.0:
        return bool((share.min(axis=1) > 0.0).any())
    weight = np.random.default_rng(0).dirichlet(np.full(4, 0.5), 3000)
    inner = weight @ spot[:4, :3]
    return bool(KDTree(inner).query(flat)[0].min() < reach)


def test_a_blade_takes_what_it_comes_near_to() -> None:
    rng, edge = np.random.default_rng(5), np.array(EDGES[4], dtype=np.int32)
    face, met = np.array(FACES[4], dtype=np.int32), 0
    for _ in range(400):
        spot = np.zeros((8, 4))
        spot[:4, :3] = rng.normal(size=(4, 3))
        if np.linalg.det(spot[1:4, :3] - spot[0, :3]) < 0.0:
            spot[[0, 1]] = spot[[1, 0]]
        size = rng.choice([0.1, 1.0, 3.0])
        spot[4, :3] = rng.normal(size=3)
        along, way = rng.normal(size=(2, 3)) * size
        spot[5, :3], spot[6, :3], spot[7, :3] = spot[4, :3] + along, spot[4, :3] + along + way, spot[4, :3] + way
        found = crosses(spot, 4, edge, face, 0.0)
        near = crosses(spot, 4, edge, face, 0.1)
        assert near or not found
        if sampled(spot, 4, 0.0):
            met += 1
            assert found
        elif near:
            assert sampled(spot, 4, 0.15)
    assert met > 50


def test_a_blade_within_a_cell_or_swept_by_a_hair_still_cuts() -> None:
    corner = np.array([(a, b, c, 0) for a in (0, 1) for b in (0, 1) for c in (0, 1)], dtype=float)
    edge, face = np.array(EDGES[8], dtype=np.int32), np.array(FACES[8], dtype=np.int32)
    within = np.array([[0.4, 0.4, 0.4, 0], [0.5, 0.4, 0.4, 0], [0.5, 0.5, 0.4, 0], [0.4, 0.5, 0.4, 0]])
    hair = np.array([[0.4, 0.4, -2, 0], [0.4, 0.4, 3, 0], [0.4, 0.4001, 3, 0], [0.4, 0.4001, -2, 0]])
    for quad in (within, hair):
        assert crosses(np.concatenate([corner, quad]), 8, edge, face, 0.0)
        assert not crosses(np.concatenate([corner, quad + np.array([1.5, 0, 0, 0])]), 8, edge, face, 0.4)


@pytest.mark.parametrize("name", ["cells", "corotated"])
def test_the_skin_stays_closed_around_what_is_left(name: str) -> None:
    """Every edge of the triangles that are there is passed as often one way as the other."""
    body = made(name).with_cutting()
    faces = cut_skin(body)
    assert faces is not None
    assert body.material is not None
    count, ready = body.material.elements.shape[0], model(body)
    cutting = cutting_of(ready)
    assert cutting is not None
    whole = faces.shown(np.zeros(count, dtype=np.bool_))
    assert np.array_equal(whole, faces.beyond < 0)
    for seed in range(3):
        cut = np.random.default_rng(seed).random(count) < 0.3
        shown = faces.shown(cut)
        memory, hidden = np.zeros(ready.memory), np.zeros(shown.size, dtype=np.int32)
        memory[ready.cut : ready.cut + count] = cut
        expose(cutting, memory, hidden)
        assert np.array_equal(hidden == 0, shown)
        place = np.round(faces.skin.vertices * 1e6).astype(np.int64)
        corners = place[faces.skin.triangles[shown]]
        sums: dict[tuple[bytes, bytes], int] = {}
        for triangle in corners:
            for k in range(3):
                a, b = triangle[k].tobytes(), triangle[(k + 1) % 3].tobytes()
                sums[min(a, b), max(a, b)] = sums.get((min(a, b), max(a, b)), 0) + (1 if a < b else -1)
        if name == "corotated":  # two sides of cubes may be halved along different diagonals
            assert not any(sums.values())
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2.0
        assert np.abs(normal.sum(axis=0)).max() == pytest.approx(0.0, abs=1.0)
    assert surface_of(ready).corner.shape[0] == whole.size


def test_what_cannot_be_cut_is_told() -> None:
    whole = lattice([3, 3, 3])
    with pytest.raises(BodyError, match="the body is linear and has none; take one of"):
        whole.with_cutting()
    with pytest.raises(BodyError, match='model is "floating", which has none'):
        made("floating").with_cutting()
    with pytest.raises(BodyError, match=r"tear is 0\.0; it must be a strain above 0"):
        made("cells").with_cutting(0.0)
    with pytest.raises(BodyError, match=r"strength is -1\.0; it must be a stress above 0 Pa"):
        made("cells").with_cutting(strength=-1.0)
    with pytest.raises(BodyError, match=r"toughness is -1\.0; it must be a finite number of at least 0 J/m²"):
        made("cells").with_cutting(toughness=-1.0)
    flat = lattice([3, 3], neighbours=26, model="spring-network")
    with pytest.raises(BodyError, match="cutting needs a body of 3 axes, but this one has 2"):
        flat.with_cutting()
    kept: Body = made("cells").with_cutting(0.5).with_gravity((0.0, 0.0, -9.81))
    assert kept.material is not None
    assert (kept.material.cuttable, kept.material.tear) == (True, 0.5)
