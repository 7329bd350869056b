"""Bodies from meshes against closed forms: mass, rigid motions, stretched bars, vibrating bars."""

import re
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse.linalg import spsolve
from tests.body.shapes import block, box, joined, rotation, sphere, volume

from cotouch.body import (
    Body,
    NodeNumbers,
    NodeSet,
    NodesInBox,
    NodesNearPlane,
    body_from_surface,
    body_from_tetrahedra,
    lowest_modes,
)
from cotouch.errors import BodyError

E, RHO = 2e5, 900.0
SIZE = (0.3, 0.1, 0.1)


def made(kind: str, **options: Any) -> Body:
    """A bar of 0.3 x 0.1 x 0.1 m along x in each of four ways."""
    shape, model = kind.split()
    options = {"young": E, "density": RHO, "unit": "m", "model": model, **options}
    if shape == "lattice":
        return body_from_surface(box(SIZE), resolution=9, **options)
    return body_from_tetrahedra(block((6, 2, 2), SIZE, shake=0.6), **options)


KINDS = ["lattice springs", "lattice elastic", "solid springs", "solid elastic"]
ELASTIC = [kind for kind in KINDS if kind.endswith("elastic")]


def full(body: Body) -> Body:
    return body.as_full()


def rigid_fields(rest: np.ndarray) -> np.ndarray:
    """Three shifts and three small turns, (6, n, 3)."""
    shifts = [np.tile(axis, (len(rest), 1)) for axis in np.eye(3)]
    return np.stack(shifts + [np.cross(axis, rest) for axis in np.eye(3)])


@pytest.mark.parametrize("kind", KINDS)
class TestBar:
    def test_mass_and_size(self, kind: str):
        body = full(made(kind))
        assert body.mass.sum() / 3 == pytest.approx(RHO * np.prod(SIZE), rel=1e-9)
        assert body.origin is not None
        assert np.allclose(body.origin.size, SIZE)
        assert body.origin.volume == pytest.approx(np.prod(SIZE))
        assert full(made(kind, mass=2.0)).mass.sum() / 3 == pytest.approx(2.0)

    def test_a_stretched_bar_pulls_back_with_EA_over_L(self, kind: str):
        """Patch test: the linear field is in equilibrium inside, and its ends carry E A / L."""
        poisson = 0.3 if kind in ELASTIC else 0.0
        body = full(made(kind, poisson=0.3))
        stretch = 0.01
        field = body.rest * [stretch, -poisson * stretch, -poisson * stretch]
        force = body.apply(body.stiffness, field)
        x = body.rest[:, 0]
        ends = (x < 1e-9) | (x > SIZE[0] - 1e-9)
        assert np.abs(force[~ends]).max() < 1e-9 * np.abs(force).max()
        pull = force[x > SIZE[0] - 1e-9].sum(axis=0)
        stiffness = E * SIZE[1] * SIZE[2] / SIZE[0]
        assert pull[0] == pytest.approx(stiffness * stretch * SIZE[0], rel=1e-9)
        assert np.abs(pull[1:]).max() < 1e-9 * pull[0]

    def test_what_costs_no_energy(self, kind: str):
        """Shifts; turns as well in linear elasticity. Nothing else."""
        body = full(made(kind, frame="fixed"))
        fields = rigid_fields(body.rest)[: 6 if kind in ELASTIC else 3]
        dense = body.stiffness.toarray()
        for field in fields:
            assert np.abs(body.apply(body.stiffness, field)).max() < 1e-9 * np.abs(dense).max() * np.abs(field).max()
        values = np.linalg.eigvalsh(dense)
        assert np.count_nonzero(values < 1e-9 * values.max()) == len(fields)
        assert values.min() > -1e-12 * values.max()
        assert body.origin is not None
        assert body.origin.free == len(fields)

    def test_rayleigh_damping(self, kind: str):
        body = made(kind, rayleigh_mass=3.0, rayleigh_stiffness=0.02, ground="x-", ground_stiffness=50.0)
        expected = 3.0 * body.mass.toarray() + 0.02 * body.stiffness.toarray()
        assert np.allclose(body.damping.toarray(), expected, rtol=1e-12, atol=1e-9)

    def test_the_skin_follows_a_linear_field_exactly(self, kind: str):
        body = made(kind)
        assert body.skin is not None
        gradient = np.random.default_rng(0).normal(size=(3, 3))
        assert np.allclose(body.skin.carried(body.rest @ gradient), body.skin.vertices @ gradient, atol=1e-12)
        assert volume(body.skin.vertices, body.skin.triangles) == pytest.approx(np.prod(SIZE))


@pytest.mark.parametrize("kind", ELASTIC)
def test_a_free_bar_rings_at_its_wave_speed(kind: str):
    """Without Poisson's effect longitudinal waves of a free bar have f_n = n c / 2L with c = √(E/ρ)."""
    length = 1.0
    if kind.startswith("lattice"):
        options: dict[str, Any] = {"unit": "m", "model": "elastic", "young": E, "poisson": 0.0, "density": RHO}
        body = body_from_surface(box((length, 0.05, 0.05)), resolution=20, **options)
    else:
        body = body_from_tetrahedra(
            block((20, 1, 1), (length, 0.05, 0.05)), unit="m", young=E, poisson=0.0, density=RHO
        )
    values, shapes = lowest_modes(body.mass, body.stiffness, body.rest, 30)
    fields = shapes.T.reshape(30, -1, 3)
    along = np.argmax(np.sum(fields[..., 0] ** 2, axis=1) / np.sum(fields**2, axis=(1, 2)) * (values > 0.0))
    sound = np.sqrt(E / RHO)
    assert np.sqrt(values[along]) / (2 * np.pi) == pytest.approx(sound / (2 * length), rel=0.01)
    assert np.count_nonzero(values == 0.0) == 6


def test_a_clamped_beam_bends_like_a_beam():
    """First frequency of a slender cantilever: 1.8751² / (2π L²) √(E I / ρ A); Q1 cells are a little too stiff."""
    body = body_from_surface(
        box((1.0, 0.1, 0.1)),
        unit="m",
        resolution=40,
        model="elastic",
        young=E,
        poisson=0.0,
        density=RHO,
        ground="x-",
        ground_stiffness=1e9,
    )
    values, _ = lowest_modes(body.mass, body.stiffness, body.rest, 2)
    expected = 1.875104**2 / (2 * np.pi) * np.sqrt(E * 0.1**2 / 12 / RHO)
    assert np.sqrt(values[0]) / (2 * np.pi) == pytest.approx(expected, rel=0.05)


def test_poissons_ratio_shows_when_a_bar_is_pulled():
    body = made(
        "solid elastic", poisson=0.4, ground=NodesNearPlane(point=(0, 0, 0), normal=(1, 0, 0)), ground_stiffness=1e-3
    )
    x, y = body.rest[:, 0], body.rest[:, 1]
    load = np.zeros_like(body.rest)
    # The load that a uniform stress does to the two ends, so that the answer is uniform too.
    uniform = body.rest * [0.01, -0.004, -0.004]
    load = body.apply(body.stiffness_int, uniform)
    answer = np.asarray(spsolve(body.stiffness.tocsc(), load.ravel())).reshape(load.shape)
    stretch = (answer[x > 0.299, 0].mean() - answer[x < 1e-3, 0].mean()) / 0.3
    narrowing = (answer[y > 0.099, 1].mean() - answer[y < 1e-3, 1].mean()) / 0.1
    assert -narrowing / stretch == pytest.approx(0.4, rel=1e-3)


@given(st.integers(0, 100))
def test_turning_the_mesh_turns_the_elastic_body(seed: int):
    points, elements = block((2, 1, 1), shake=0.3, seed=seed)
    turn = rotation(seed)
    one = body_from_tetrahedra((points, elements), unit="m")
    two = body_from_tetrahedra((points @ turn.T, elements), unit="m")
    field = np.random.default_rng(seed).normal(size=one.rest.shape)
    force, turned = one.apply(one.stiffness, field), two.apply(two.stiffness, field @ turn.T)
    assert np.allclose(turned, force @ turn.T, rtol=0.0, atol=1e-10 * np.abs(force).max())


def test_springs_of_given_stiffness():
    body = body_from_surface(box((4, 4, 4)), unit="m", resolution=4, stiffness=7.0)
    inner = np.flatnonzero(np.all((body.rest > 0.5) & (body.rest < 3.5), axis=1))
    off = body.stiffness_int.toarray()[np.ix_(inner, inner)]
    assert set(np.round(off[np.triu_indices(len(inner), 1)], 12)) == {0.0, -7.0}
    tetrahedra = body_from_tetrahedra(block((1, 1, 1)), unit="m", model="springs", stiffness=7.0)
    dense = tetrahedra.stiffness_int.toarray()
    assert set(np.round(dense[np.triu_indices(8, 1)], 12)) == {0.0, -7.0}
    assert np.count_nonzero(np.triu(dense, 1)) == 19  # 12 edges, 6 diagonals of faces, 1 of the box


@pytest.mark.parametrize(("unit", "scale"), [("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("in", 0.0254)])
def test_units(unit: Any, scale: float):
    surface = body_from_surface(box(), unit=unit, resolution=2)
    solid = body_from_tetrahedra(block((1, 1, 1), (1, 1, 1)), unit=unit)
    for body in (surface, solid):
        assert body.rest.max() == pytest.approx(scale)
        assert body.skin is not None
        assert body.skin.vertices.max() == pytest.approx(scale)
        assert full(body).mass.sum() / 3 == pytest.approx(1000.0 * scale**3)


class TestGround:
    def held(self, ground: Any, **options: Any) -> np.ndarray:
        body = made("solid elastic", ground=ground, ground_stiffness=5.0, **options)
        held = body.stiffness_ext.diagonal().reshape(-1, 3)
        assert set(held.ravel()) <= {0.0, 5.0}
        assert body.origin is not None
        assert np.array_equal(np.flatnonzero(held[:, 0]), body.origin.held)
        return body.rest[body.origin.held]

    def test_face_plane_and_box_agree(self):
        face = self.held("x+")
        assert np.allclose(face[:, 0], 0.3)
        assert len(face) == 9
        assert np.array_equal(face, self.held(NodesNearPlane(point=(0.3, 0, 0), normal=(-2, 0, 0))))
        assert np.array_equal(face, self.held(NodesInBox(low=(0.29, -1, -1), high=(1, 1, 1))))
        assert len(self.held(NodesNearPlane(point=(0, 0, 0), normal=(1, 0, 0), thickness=0.06))) == 18
        assert len(self.held("all")) == 63
        assert len(self.held([0, 2, 2])) == 2

    def test_sets_follow_their_points(self):
        points, elements = block((6, 2, 2), SIZE)
        stray = np.vstack([[[9.0, 9.0, 9.0]], points])  # of no element: the indices of the body's nodes are others
        ends = np.flatnonzero(stray[:, 0] < 1e-9)
        body = body_from_tetrahedra(
            (stray, elements + 1),
            unit="m",
            sets={"end": ends.tolist()},
            ground=NodeSet(name="end"),
            ground_stiffness=1.0,
        )
        assert body.origin is not None
        assert np.allclose(body.rest[body.origin.held][:, 0], 0.0)
        assert "1 point in no tetrahedron left out." in body.origin.notes

    def test_a_lattice_plane_reaches_half_a_cell(self):
        body = body_from_surface(
            box((4, 4, 4)),
            unit="m",
            resolution=4,
            ground=NodesNearPlane(point=(0, 0, 1.4), normal=(0, 0, 1)),
            ground_stiffness=1.0,
        )
        assert body.origin is not None
        assert set(body.rest[body.origin.held][:, 2]) == {1.0}

    @pytest.mark.parametrize(("nodes", "free"), [([], 6), ([0], 3), ([0, 1], 1), ([0, 1, 3], 0)])
    def test_what_is_still_free(self, nodes: list[int], free: int):
        body = made("solid elastic", ground=nodes, ground_stiffness=1e3)
        assert body.origin is not None
        assert body.origin.free == free
        values = np.linalg.eigvalsh(body.stiffness.toarray())
        assert np.count_nonzero(values < 1e-9 * values.max()) == free
        heard = " ".join(body.origin.notes)
        assert ("Nothing holds it" in heard) == (free == 6)
        assert (f"leaves {free} rigid motion" in heard) == (0 < free < 6)

    @pytest.mark.parametrize(
        ("ground", "message"),
        [
            (
                NodesNearPlane(point=(0, 0, 5), normal=(0, 0, 1)),
                "the plane holds no node: the nearest is 4.9 m away, thickness is 0",
            ),
            (NodesNearPlane(point=(0, 0, 0), normal=(0, 0, 0)), "the normal of the ground's plane is 0, 0, 0"),
            (
                NodesNearPlane(point=(0, 0), normal=(0, 0, 1)),
                "the plane's point is (0, 0); it must be three finite numbers",
            ),
            (
                NodesNearPlane(point=(0, 0, 0), normal=(0, 0, 1), thickness=-1.0),
                "the thickness of the ground's plane is -1.0",
            ),
            (
                NodesInBox(low=(1, 1, 1), high=(2, 2, 2)),
                "the ground's box holds no node; the nodes lie from (0, 0, 0) to (0.3",
            ),
            (NodesInBox(low=(1, 1, 1), high=(0, 2, 2)), "low must not be above high"),
            (NodeSet(name="foot"), 'the ground is the set "foot"; the sets of this mesh are: none'),
            ("top", 'ground is "top"; it must be "none", "all", a face "x-"'),
            ([63], "ground names node index 63; this body has nodes 0 to 62"),
            (NodeNumbers([64]), "ground names node 64; this body has nodes 1 to 63"),
        ],
    )
    def test_refused(self, ground: Any, message: str):
        with pytest.raises(BodyError, match=re.escape(message)):
            self.held(ground)

    def test_ground_without_stiffness_is_no_ground(self):
        with pytest.raises(BodyError, match="the ground holds 9 nodes with ground_stiffness 0; give it in N/m"):
            made("solid elastic", ground="x-")


class TestParts:
    two = joined(box((2, 1, 1)), box((1, 1, 1), (4, 0, 0)))

    def test_several_parts_are_refused_or_chosen(self):
        with pytest.raises(BodyError, match=r"arrays has 2 separate parts \(66.7 %, 33.3 % of its volume\)"):
            body_from_surface(self.two, unit="m")
        big, small = (body_from_surface(self.two, unit="m", resolution=4, part=part) for part in (1, 2))
        assert big.mass.sum() == pytest.approx(2000.0)
        assert small.mass.sum() == pytest.approx(1000.0)
        assert small.skin is not None
        assert small.skin.vertices.min(axis=0).tolist() == [4.0, 0.0, 0.0]
        assert small.rest.min() == 0.0
        assert small.origin is not None
        assert "Part 2 of 2 used." in small.origin.notes
        with pytest.raises(BodyError, match="part is 3; arrays has parts 1 to 2"):
            body_from_surface(self.two, unit="m", part=3)

    def test_parts_that_overlap_are_one(self):
        body = body_from_surface(joined(box((2, 2, 2)), box((2, 2, 2), (1, 0, 0))), unit="m", resolution=6)
        assert body.rest[:, 0].max() == pytest.approx(3.0)

    def test_a_loose_crumb_is_left_out(self):
        body = body_from_surface(joined(box((2, 2, 2)), box((0.3, 0.3, 0.3), (4, 0, 0))), unit="m", resolution=8)
        assert body.origin is not None
        assert body.origin.notes[0] == "1 loose part left out, below 1 % of the volume."
        assert body.mass.sum() == pytest.approx(8000.0)

    def test_tetrahedra_alike(self):
        points, elements = block((2, 1, 1), (2, 1, 1))
        both = (np.concatenate([points, 0.5 * points + 9]), np.concatenate([elements, elements + len(points)]))
        with pytest.raises(BodyError, match="arrays has 2 separate parts"):
            body_from_tetrahedra(both, unit="m")
        assert body_from_tetrahedra(both, unit="m", part=2).rest.min() == 9.0
        crumb = (np.concatenate([points, 0.1 * points + 9]), both[1])
        assert body_from_tetrahedra(crumb, unit="m").rest.max() == 2.0

    def test_round_off_does_not_number_parts(self):
        points, elements = block((2, 1, 1), (2, 1, 1))
        both = (np.concatenate([points, (1 + 1e-12) * points + 9]), np.concatenate([elements, elements + len(points)]))
        assert [body_from_tetrahedra(both, unit="m", part=part).rest.min() for part in (1, 2)] == [0.0, 9.0]
        surfaces = joined(box((1, 1, 1)), box((1 + 1e-12, 1, 1), (4, 0, 0)))
        first = body_from_surface(surfaces, unit="m", resolution=3, part=1)
        assert first.skin is not None
        assert first.skin.vertices[:, 0].min() == 0.0


class TestTetrahedra:
    @given(st.sets(st.integers(0, 47)))
    def test_inverted_elements_are_turned(self, flipped: set[int]):
        points, elements = block((2, 2, 2), SIZE)
        chosen = sorted(flipped)
        mirrored = elements.copy()
        mirrored[chosen] = mirrored[chosen][:, [1, 0, 2, 3]]
        body = body_from_tetrahedra((points, mirrored), unit="m")
        plain = body_from_tetrahedra((points, elements), unit="m")
        assert abs(body.stiffness - plain.stiffness).max() < 1e-12 * abs(plain.stiffness).max()
        assert body.origin is not None
        assert any("tetrahedra were inverted" in note for note in body.origin.notes) == bool(chosen)

    def test_flat_and_repeated_elements_go(self):
        points, elements = block((2, 1, 1))
        flat = [[0, 1, 2, 3], elements[0], elements[0][[1, 0, 2, 3]], [4, 4, 5, 6]]
        body = body_from_tetrahedra((points, np.concatenate([elements, flat])), unit="m")
        assert body.origin is not None
        assert body.origin.elements == len(elements)
        assert "2 degenerate tetrahedra left out." in body.origin.notes
        assert "2 tetrahedra that repeated another left out." in body.origin.notes

    def test_only_flat_ones_are_refused(self):
        with pytest.raises(BodyError, match="no tetrahedron of arrays has a volume"):
            body_from_tetrahedra((np.eye(4)[:, :3] * [1, 1, 0], [[0, 1, 2, 3]]), unit="m")

    def test_the_skin_is_the_boundary(self):
        body = body_from_tetrahedra(block((3, 2, 2), SIZE, shake=0.5), unit="m")
        assert body.skin is not None
        assert len(body.skin.triangles) == 4 * (2 * 3 + 2 * 3 + 2 * 2)
        assert body.skin.nodes.shape[1] == 1


@pytest.mark.parametrize("build", [body_from_surface, body_from_tetrahedra])
class TestRefused:
    def source(self, build: Any) -> Any:
        return box() if build is body_from_surface else block((1, 1, 1))

    @pytest.mark.parametrize(
        ("options", "message"),
        [
            (
                {"unit": None},
                'the unit of arrays is not given, and the mesh does not state it; give unit "m", "mm", "cm" or "in"',
            ),
            ({"unit": "inch"}, 'the unit of arrays is "inch"; it must be "m", "mm", "cm" or "in"'),
            ({"young": 0.0}, "young is 0.0; it must be more than 0 Pa"),
            ({"young": np.nan}, "young is nan; it must be more than 0 Pa"),
            ({"density": -1.0}, "density is -1.0; it must be more than 0 kg/m³"),
            ({"mass": 0.0}, "mass is 0.0; it must be more than 0 kg"),
            ({"poisson": 0.5}, "poisson is 0.5; it must be above -1 and below 0.5"),
            ({"poisson": -1.0}, "poisson is -1.0"),
            ({"model": "elastic", "stiffness": 3.0}, 'stiffness is 3.0, but model is "elastic"'),
            ({"model": "jelly"}, 'model is "jelly"; it must be one of springs, elastic'),
            ({"rayleigh_mass": -1.0}, "rayleigh_mass is -1.0; it must be a finite number of at least 0"),
            ({"rayleigh_stiffness": np.inf}, "rayleigh_stiffness is inf"),
            ({"ground_stiffness": -1.0}, "ground_stiffness is -1.0; it must be a finite number of at least 0"),
            ({"ground_damping": np.nan}, "ground_damping is nan"),
            ({"part": 2}, "part is 2; arrays has parts 1 to 1"),
            ({"most_nodes": 3}, "nodes"),
        ],
    )
    def test_values(self, build: Any, options: dict[str, Any], message: str):
        with pytest.raises(BodyError, match=re.escape(message)):
            build(self.source(build), **{"unit": "m", **options})

    @pytest.mark.parametrize("source", [7, (1, 2, 3), ([[0, 0, 0]], "abc"), ([[0, 0]], [[0, 0, 0]]), (np.eye(3), [])])
    def test_no_mesh(self, build: Any, source: Any):
        with pytest.raises(BodyError):
            build(source, unit="m")


@given(st.integers(0, 100_000), st.integers(3, 12), st.integers(1, 30), st.sampled_from([1.0, 1e-9, 1e9]))
def test_any_soup_is_a_body_or_refused(seed: int, points: int, faces: int, scale: float):
    """Random triangles, mostly nonsense: a sound body comes out, or one sentence."""
    rng = np.random.default_rng(seed)
    places = scale * rng.integers(0, 4, size=(points, 3)).astype(float)
    soup = rng.integers(0, points, size=(faces, 3))
    try:
        body = body_from_surface((places, soup), unit="m", resolution=4)
    except BodyError as error:
        assert "\n" not in str(error)  # noqa: PT017
        return
    assert body.origin is not None
    assert body.mass.sum() == pytest.approx(1000.0 * body.origin.volume)
    assert body.origin.volume > 0.0
    assert body.skin is not None
    assert np.allclose(body.skin.carried(body.rest), body.skin.vertices, rtol=1e-9, atol=1e-9 * scale)


def test_resolution_and_limits():
    for resolution in (0, -1, 2.5):
        with pytest.raises(BodyError, match=f"resolution is {resolution}; it must be a whole number of at least 1"):
            body_from_surface(box(), unit="m", resolution=resolution)  # pyright: ignore[reportArgumentType]
    with pytest.raises(
        BodyError, match="arrays has 12 triangles but the limit is 11; make it coarser, or raise most_tri"
    ):
        body_from_surface(box(), unit="m", most_triangles=11)
    with pytest.raises(
        BodyError, match="arrays has 6 tetrahedra but the limit is 5; make it coarser, or raise most_ele"
    ):
        body_from_tetrahedra(block((1, 1, 1)), unit="m", most_elements=5)


def test_locking_is_said():
    body = made("solid elastic", poisson=0.49)
    assert body.origin is not None
    assert any("0.49: this close to 0.5, linear elements are too stiff" in note for note in body.origin.notes)


@pytest.mark.parametrize("name", ["liver", "kidney", "gear"])
def test_example_shapes(name: str):
    """The surface of each example is closed and right already; its lattice carries its whole skin."""
    from examples import make_shapes

    points, faces = getattr(make_shapes, name)()
    body = body_from_surface((points, faces), unit="mm", resolution=16)
    assert body.origin is not None
    *inertia, held = body.origin.notes
    assert held == "Nothing holds it: when pushed, it flies off. Give ground and ground_stiffness to hold it."
    assert all(note.startswith("Its moments of inertia are up to") for note in inertia)
    assert body.mass.sum() == pytest.approx(1000.0 * volume(points, faces) * 1e-9, rel=1e-6)
    assert body.skin is not None
    assert np.allclose(body.skin.carried(body.rest), body.skin.vertices, atol=1e-12)
    assert np.array_equal(points, getattr(make_shapes, name)()[0])  # the same every time


def test_sphere_volume_and_frequency_do_not_depend_on_where_it_lies():
    points, faces = sphere(3)
    rung = []
    for seed in range(3):
        body = body_from_surface(
            (points @ rotation(seed).T + seed, faces), unit="cm", resolution=10, model="elastic", young=E
        )
        values, _ = lowest_modes(body.mass, body.stiffness, body.rest, 7)
        rung.append(float(np.sqrt(values[6])))
    assert np.ptp(rung) < 0.02 * np.mean(rung)


def overlapping_spheres() -> tuple[Any, float]:
    """Two spheres of radius 1 whose middles are 1 apart, turned so that nothing is on a grid; what both together hold.

    What they share is 5/16 of a sphere; that of the octahedra divided four times is less by what they are.
    """
    points, faces = sphere(4)
    mesh = joined((points, faces), (points + np.array([1.0, 0.0, 0.0]), faces))
    return (mesh[0] @ rotation(3).T, mesh[1]), 2.0 - 5.0 / 16.0


@pytest.mark.parametrize("model", ["springs", "elastic"])
@pytest.mark.parametrize("resolution", [7, 12])
def test_what_shells_share_counts_once_in_volume_and_mass(model: Any, resolution: int):
    mesh, shares = overlapping_spheres()
    body = body_from_surface(mesh, unit="m", density=RHO, model=model, resolution=resolution)
    assert body.origin is not None
    assert body.origin.volume == pytest.approx(shares * volume(*sphere(4)), rel=2e-3)
    assert full(body).mass.sum() / 3 == pytest.approx(RHO * body.origin.volume, rel=1e-9)
    assert any(
        re.fullmatch(r"Its surface overlaps itself in 18 % of the volume, counted once\.", note)
        for note in body.origin.notes
    )


def test_a_solid_in_a_solid_counts_once():
    inside = body_from_surface(joined(box((4, 4, 4)), box((2, 2, 2), (1, 1, 1))), unit="m", resolution=8)
    assert inside.origin is not None
    assert inside.origin.volume == pytest.approx(64.0, rel=1e-3)


def test_shells_that_touch_do_not_overlap():
    """To the last bit the volume of the divergence theorem, however they are turned."""
    for seed in range(5):
        points, faces = joined(box((2, 2, 2)), box((2, 2, 2), (2.0, 0.5, 0.3)))
        body = body_from_surface((points @ rotation(seed).T, faces), unit="m", resolution=6)
        assert body.origin is not None
        assert body.origin.volume == pytest.approx(16.0, rel=1e-12)
        assert not any("overlap" in note for note in body.origin.notes)


def test_a_node_pulled_through_its_neighbours_is_refused():
    """The elements around it were turned inside out; turned round they would lie in others, and the skin is whole."""
    points, elements = block((3, 3, 3), (1.0, 1.0, 1.0))
    middle = int(np.argmin(np.abs(points - points.mean(axis=0) - 0.01).sum(axis=1)))
    for move, right in ((0.1, True), (0.45, False)):
        moved = points.copy()
        moved[middle] += move
        if right:
            assert body_from_tetrahedra((moved, elements), unit="m").nodes == len(points)
        else:
            with pytest.raises(
                BodyError, match=r"tetrahedra of arrays overlap in \d\S* % of their volume; every place"
            ):
                body_from_tetrahedra((moved, elements), unit="m")


def test_tetrahedra_that_overlap_are_refused():
    """A mesh that is folded over itself: two blocks that share a corner, one half inside the other."""
    points, elements = block((2, 2, 2), (1.0, 1.0, 1.0))
    again = points + 0.5
    corner = int(np.flatnonzero((points == 0.5).all(axis=1))[0])
    where = np.arange(len(points)) + len(points)
    where[int(np.flatnonzero((again == 0.5).all(axis=1))[0])] = corner
    mesh = (np.concatenate([points, again]), np.concatenate([elements, where[elements]]))
    with pytest.raises(
        BodyError, match=r"tetrahedra of arrays overlap in 6\.\d % of their volume; every place must be"
    ):
        body_from_tetrahedra(mesh, unit="m")
