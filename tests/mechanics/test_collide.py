"""Contacts of a sphere with a skin against brute force over all triangles."""

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.thorough import examples

from cotouch.body import Body, Skin, lattice
from cotouch.mechanics import MOST_CONTACTS, TouchWork, model, surface_of, touch_work
from cotouch.mechanics._collide import MOST_HITS, touching
from cotouch.mechanics._surface import refit
from cotouch.mechanics._triangle import nearest_point

Array = np.ndarray


class Ball:
    """A body whose nodes are the vertices of a skin, and searches on it."""

    def __init__(self, vertices: Array, triangles: Array | None, *, shuffle: int | None = None) -> None:
        n = vertices.shape[0]
        if triangles is not None and shuffle is not None:
            triangles = np.random.default_rng(shuffle).permutation(triangles)
        skin = None
        if triangles is not None:
            skin = Skin(vertices=vertices, triangles=triangles, nodes=np.arange(n)[:, None], weights=np.ones((n, 1)))
        self.model = model(Body(mass=np.eye(n), rest=vertices, skin=skin), basis="nodal")
        self.surface = surface_of(self.model)
        self.work: TouchWork = touch_work(self.model, self.surface, tools=1, port_count=0)
        self.triangles = self.surface.corner
        self.vertices = vertices

    def search(
        self, places: Array, centre: Array, radius: float, *, margin: float = 0.0, inside: bool = False
    ) -> tuple[Array, Array, bool]:
        """Depths, ordered, the normals with them, and whether the centre is inside."""
        work = self.work
        position = self.model.to_rows(places - self.vertices)
        refit(self.surface, work.fit, position, self.model.lanes)
        work.found.number[0] = 0
        row = np.zeros((1, 4))
        row[0, :3] = centre
        within = touching(
            self.surface,
            work.fit,
            work.hits,
            work.found,
            0,
            row,
            float(radius),
            float(margin),
            inside,
            position,
            self.model.lanes,
        )
        count = int(work.found.number[0])
        order = np.argsort(-work.found.depth[:count], kind="stable")
        for c in range(count):  # the point of contact is where the normal says
            spot = work.found.barycentric[c, :3] @ places[self.triangles[work.found.triangle[c]]]
            reached = centre - work.found.normal[c, :3] * (radius - work.found.depth[c])
            assert spot == pytest.approx(reached, abs=1e-12 * (1.0 + radius))
        return work.found.depth[order].copy(), work.found.normal[order, :3].copy(), bool(within)


def closest(corners: Array, point: Array) -> tuple[Array, Array]:
    """Nearest point of each triangle (F, 3, 3) by trying its face, its edges and its corners; and the distances."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    best, spots = np.full(len(corners), np.inf), np.zeros((len(corners), 3))

    def offer(candidates: Array, allowed: Array) -> None:
        away = np.where(allowed, np.linalg.norm(point - candidates, axis=1), np.inf)
        better = away < best
        best[better], spots[better] = away[better], candidates[better]

    for i, j in ((a, b), (b, c), (c, a)):
        along = j - i
        size = (along**2).sum(axis=1)
        t = np.clip(((point - i) * along).sum(axis=1) / np.where(size > 0, size, 1.0), 0.0, 1.0)
        offer(i + t[:, None] * along, np.ones(len(i), dtype=bool))
    edges = np.stack([b - a, c - a], axis=2)  # least squares on each face, by its normal equations
    squares = np.swapaxes(edges, 1, 2) @ edges
    wide = np.linalg.det(squares) > 1e-20 * squares[:, 0, 0] * squares[:, 1, 1]
    squares[~wide] = np.eye(2)
    fractions = np.linalg.solve(squares, np.swapaxes(edges, 1, 2) @ (point - a)[:, :, None])
    allowed = wide & (fractions[:, 0, 0] > 0) & (fractions[:, 1, 0] > 0) & (fractions.sum(axis=1)[:, 0] < 1)
    offer(a + (edges @ fractions)[:, :, 0], allowed)
    return spots, best


def local_minima(corners: Array, point: Array, reach: float) -> Array:
    """Local minima of the distance to a surface, by definition: no triangle that meets there has anything nearer."""
    spots, away = closest(corners, point)
    found: list[Array] = []
    distances = []
    for spot, distance in zip(spots, away, strict=True):
        if distance > reach or any(np.linalg.norm(spot - other) < 1e-9 for other in found):
            continue
        meets = closest(corners, spot)[1] < 1e-10
        if np.all(away[meets] >= distance - 1e-10):
            found.append(spot)
            distances.append(distance)
    return np.sort(np.array(distances))


SPHERE = trimesh.creation.icosphere(subdivisions=2)
BLOB = Ball(np.asarray(SPHERE.vertices), np.asarray(SPHERE.faces))
OTHER = Ball(np.asarray(SPHERE.vertices), np.asarray(SPHERE.faces), shuffle=3)


def dented(rng: np.random.Generator) -> Array:
    """The unit sphere, deformed smoothly with bumps, dents and a stretch; still closed."""
    x = np.asarray(SPHERE.vertices)
    waves = sum(rng.uniform(-0.12, 0.12) * np.sin(x @ rng.normal(size=3) * 3 + rng.uniform(0, 6)) for _ in range(3))
    return x * (1.0 + waves)[:, None] * rng.uniform(0.6, 1.4, 3) + 0.01 * rng.normal(size=x.shape)


class TestClosedSkin:
    @pytest.mark.parametrize("seed", range(25))
    def test_outside_every_local_minimum_is_a_contact(self, seed: int):
        rng = np.random.default_rng(seed)
        places = dented(rng)
        direction = rng.normal(size=3)
        centre = direction / np.linalg.norm(direction) * rng.uniform(1.6, 2.2)
        corners = places[BLOB.triangles]
        radius = closest(corners, centre)[1].min() + rng.uniform(0.05, 0.5)
        depth, normal, within = BLOB.search(places, centre, radius)
        exact = radius - local_minima(corners, centre, radius)
        assert not within
        assert depth == pytest.approx(exact, abs=1e-9)
        assert np.linalg.norm(normal, axis=1) == pytest.approx(np.ones(len(depth)))

    @pytest.mark.parametrize("seed", range(20))
    def test_does_not_depend_on_the_tree(self, seed: int):
        rng = np.random.default_rng(seed)
        places = dented(rng)
        centre = rng.normal(size=3)
        centre *= rng.uniform(0.7, 1.5) / np.linalg.norm(centre)
        first = BLOB.search(places, centre, 0.6, inside=True)
        second = OTHER.search(places, centre, 0.6, inside=True)
        assert first[2] == second[2]
        assert first[0] == pytest.approx(second[0], abs=1e-12)
        assert first[1] == pytest.approx(second[1], abs=1e-9)

    @pytest.mark.parametrize("seed", range(20))
    def test_inside_the_one_contact_is_the_way_out(self, seed: int):
        rng = np.random.default_rng(seed)
        places = dented(rng)
        centre = rng.normal(size=3) * 0.15
        away = closest(places[BLOB.triangles], centre)[1].min()
        depth, normal, within = BLOB.search(places, centre, 0.1, inside=True)
        assert within
        assert depth == pytest.approx([0.1 + away], abs=1e-12)
        corners = places[BLOB.triangles]
        assert closest(corners, centre + (away + 1e-6) * normal[0])[1].min() <= 1e-6 + 1e-9

    def test_centre_on_the_skin_goes_straight_out(self):
        places = np.asarray(SPHERE.vertices)
        for triangle in BLOB.triangles[:20]:
            for barycentric in ([1, 0, 0], [0.5, 0.5, 0], [0.2, 0.3, 0.5]):
                centre = np.array(barycentric) @ places[triangle]
                depth, normal, _ = BLOB.search(places, centre, 0.05, inside=True)
                assert depth[0] == pytest.approx(0.05, abs=1e-12)
                assert normal[0] @ centre > 0.9 * np.linalg.norm(centre)


SIDE = 5
BOX = lattice((SIDE, SIDE, SIDE), spacing=1.0)
assert BOX.skin is not None
FLAT = Ball(np.asarray(BOX.skin.vertices), np.asarray(BOX.skin.triangles))


def turned(rng: np.random.Generator) -> Array:
    """A random rotation."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


class TestBox:
    @given(st.integers(0, 10**6), st.integers(0, 8), st.integers(0, 8), st.booleans())
    @settings(max_examples=examples(150))
    def test_a_flat_of_many_triangles_is_one_contact(self, seed: int, i: int, j: int, turn: bool):
        """Also just over a corner, an edge or a diagonal of its triangles, and however the box is turned."""
        rng = np.random.default_rng(seed)
        Q = turned(rng) if turn else np.eye(3)
        places = FLAT.vertices @ Q.T
        spot = np.array([0.5 * i, 0.5 * j, SIDE - 1.0])
        if seed % 3 == 0 and 0 < i < 8:
            spot[0] += rng.uniform(-1, 1) * 10.0 ** rng.uniform(-17, -6)
        depth, normal, within = FLAT.search(places, Q @ (spot + np.array([0, 0, 1.3])), 1.5)
        assert not within
        assert depth == pytest.approx([0.2], abs=1e-6)
        if 0 < i < 8 and 0 < j < 8:
            assert normal[0] == pytest.approx(Q[:, 2], abs=1e-6)

    def test_edge_and_corner(self):
        end = SIDE - 1.0
        for away in ([1.0, 0.0, 1.0], [1.0, 1.0, 1.0]):
            direction = np.array(away) / np.linalg.norm(away)
            spot = np.where(np.array(away) > 0, end, 1.7)
            depth, normal, _ = FLAT.search(FLAT.vertices, spot + direction, 1.2)
            assert depth == pytest.approx([0.2])
            assert normal[0] == pytest.approx(direction)

    def test_valley_has_two(self):
        """The top folded along its middle: each half rises by 30 degrees."""
        places = FLAT.vertices.copy()
        places[:, 2] += np.abs(places[:, 0] - 2.0) * np.tan(np.pi / 6)
        centre = np.array([2.0, 2.0, 4.0 + 1.0 / np.cos(np.pi / 6)])
        depth, normal, _ = FLAT.search(places, centre, 1.01)
        assert depth == pytest.approx([0.01, 0.01])
        assert np.sort(normal[:, 0]) == pytest.approx([-0.5, 0.5])

    def test_gap_within_the_margin_counts(self):
        centre = np.array([1.3, 1.3, 5.2])
        assert FLAT.search(FLAT.vertices, centre, 1.0)[0].size == 0
        assert FLAT.search(FLAT.vertices, centre, 1.0, margin=0.3)[0] == pytest.approx([-0.2])


class TestOthers:
    def test_nodes_without_a_skin(self):
        places = np.random.default_rng(0).normal(size=(50, 3))
        cloud = Ball(places, None)
        depth, _, within = cloud.search(places, np.zeros(3), 1.0)
        away = np.linalg.norm(places, axis=1)
        assert not within
        assert np.sort(depth) == pytest.approx(np.sort(1.0 - away[away <= 1.0]))

    @pytest.mark.parametrize("seed", range(10))
    def test_open_skin(self, seed: int):
        """A sheet from its front, over its middle, its rim and beyond."""
        rng = np.random.default_rng(seed)
        x, y = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
        vertices = np.stack([x.ravel(), y.ravel(), 0.1 * rng.normal(size=16)], axis=1)
        cells = [(4 * i + j, 4 * i + 4 + j, 4 * i + 5 + j, 4 * i + 1 + j) for i in range(3) for j in range(3)]
        triangles = np.array([t for a, b, c, d in cells for t in ((a, b, c), (a, c, d))])
        sheet = Ball(vertices, triangles)
        centre = np.array([*rng.uniform(-0.2, 3.2, 2), rng.uniform(0.6, 1.0)])
        depth, _, within = sheet.search(vertices, centre, 1.2)
        assert not within
        assert depth == pytest.approx(1.2 - local_minima(vertices[triangles], centre, 1.2), abs=1e-9)

    def test_more_hits_than_room_keeps_the_nearest(self):
        ball = trimesh.creation.icosphere(subdivisions=3)
        vertices = np.asarray(ball.vertices)
        many = Ball(vertices, np.asarray(ball.faces))
        assert len(ball.faces) > 2 * MOST_HITS
        for seed in range(10):
            centre = np.random.default_rng(seed).normal(size=3)
            centre *= 1.5 / np.linalg.norm(centre)
            corners = vertices[many.triangles]
            depth, _, within = many.search(vertices, centre, 10.0)
            assert not within
            assert depth[0] == pytest.approx(10.0 - closest(corners, centre)[1].min(), abs=1e-12)
            depth, _, within = many.search(vertices, 0.3 * centre, 10.0, inside=True)
            assert within
            assert depth == pytest.approx([10.0 + closest(corners, 0.3 * centre)[1].min()], abs=1e-12)

    def test_more_contacts_than_room_keeps_the_deepest(self):
        places = np.random.default_rng(0).normal(size=(100, 3))
        depth, _, _ = Ball(places, None).search(places, np.zeros(3), 5.0)
        assert depth.size == MOST_CONTACTS
        assert depth == pytest.approx(np.sort(5.0 - np.linalg.norm(places, axis=1))[::-1][:MOST_CONTACTS])


class TestNearestPoint:
    @given(st.integers(0, 10**6), st.sampled_from(["any", "thin", "line", "point", "pair"]))
    @settings(max_examples=examples(200))
    def test_is_nearest(self, seed: int, kind: str):
        rng = np.random.default_rng(seed)
        corners = rng.normal(size=(3, 3))
        if kind == "thin":
            corners[2] = corners[0] + rng.uniform() * (corners[1] - corners[0]) + 1e-7 * rng.normal(size=3)
        elif kind == "line":
            corners[2] = corners[0] + rng.uniform(-1, 2) * (corners[1] - corners[0])
        elif kind == "pair":
            corners[2] = corners[1]
        elif kind == "point":
            corners[:] = corners[0]
        point = rng.normal(size=3) * 10.0 ** rng.uniform(-1, 2)
        place, near = np.zeros((3, 4)), np.zeros((2, 4))
        place[:, :3] = corners
        where = nearest_point(place, 0, 1, 2, *point, near)
        assert 0 <= where <= 6
        assert near[0, :3].sum() == pytest.approx(1.0)
        assert np.all(near[0, :3] >= 0.0)
        assert near[0, :3] @ corners == pytest.approx(near[1, :3], abs=1e-12)
        distance = np.linalg.norm(point - near[1, :3])
        assert distance == pytest.approx(closest(corners[None], point)[1][0], rel=1e-9)
