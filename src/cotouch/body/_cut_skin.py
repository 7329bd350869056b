"""The skin of a body that can be cut: what it has, and the faces inside that come to light where elements go."""

from dataclasses import dataclass
from itertools import combinations
from typing import final

import numpy as np

from cotouch.arrays import Bool, Float, Long
from cotouch.body._body import Body
from cotouch.body._cells import shapes_of
from cotouch.body._skin import Skin, joined_skins

# Faces of an element seen from outside, by its number of corners; the sides of cubes are two triangles each.
_TETRAHEDRON = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
_CUBE = (
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
    (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
)  # fmt: skip
FACES: dict[int, tuple[tuple[int, int, int], ...]] = {2: (), 4: _TETRAHEDRON, 8: _CUBE}
# How many of those make a side that two elements share.
_A_SIDE = {4: 1, 8: 2}
# A node whose weight is less does not carry a vertex.
_CARRIES = 1e-9


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class CutSkin:
    """A body's skin with its inner faces.

    A triangle is there while all elements that carry it are whole and the one beyond it, if any, is cut.

    Attributes:
        skin: that of the body first, then the inner faces; of several bodies one after the other.
        pointer: of each triangle into `element`, (F + 1,).
        element: that carry it; none where it hangs on nodes that share no element.
        beyond: the element on the other side of an inner face, or the face that opens; -1 of the outer ones, (F,).
        side: number of what each triangle comes and goes with: the inner ones of one side of an element, the outer ones
            that the same elements carry, (F,).
        vertices: first vertex of each body, (bodies + 1,).
        triangles: first triangle of each, (bodies + 1,).
    """

    skin: Skin
    pointer: Long
    element: Long
    beyond: Long
    side: Long
    vertices: Long
    triangles: Long

    def shown(self, cut: Bool) -> Bool:
        """Which triangles are there, (F,).

        Args:
            cut: which elements, or faces, were cut, (E,).
        """
        gone = np.zeros(self.beyond.size, dtype=np.int64)
        np.add.at(gone, np.repeat(np.arange(self.beyond.size), np.diff(self.pointer)), cut[self.element])
        open_ = (self.beyond < 0) | cut[np.maximum(self.beyond, 0)]
        return (gone == 0) & open_


def cut_skin(body: Body) -> CutSkin | None:
    """The skin of a body that can be cut; None where it has none.

    Args:
        body: that can be cut; see `Body.with_cutting`.
    """
    skin, material = body.skin, body.material
    if skin is None or material is None or not skin.triangles.size:
        return None
    if body.parts:
        return _side_by_side(body)
    count, none = skin.triangles.shape[0], np.zeros(0, dtype=np.int64)
    if material.faces.size:
        faces, own, beyond = _opened(material.faces, material.sides)
        side = 2 * beyond + (own != material.sides[beyond, 0])
        pointer, element = np.zeros(count + own.size + 1, dtype=np.int64), none
        fate = np.full(count, int(side.max(initial=-1)) + 1)
    else:
        carried = carriers(skin, material.elements)
        faces, own, beyond = _inner(material.elements)
        pairs = np.stack([own, beyond], axis=1)
        side = np.unique(pairs, axis=0, return_inverse=True)[1].reshape(-1) if own.size else none
        pointer = np.cumsum([0, *(len(some) for some in carried), *(1 for _ in range(own.size))])
        element = np.array([e for some in carried for e in some] + own.tolist(), dtype=np.int64)
        fates = {some: n for n, some in enumerate(sorted(set(map(tuple, carried))), int(side.max(initial=-1)) + 1)}
        fate = np.array([fates[tuple(some)] for some in carried], dtype=np.int64)
    places, nodes, weights, corners = _within(skin, body.rest, material.elements, faces, own)
    outer = np.full(count, -1)
    return CutSkin(
        skin=Skin(
            vertices=np.concatenate([skin.vertices, places]),
            triangles=np.concatenate([skin.triangles, skin.vertices.shape[0] + corners]),
            nodes=np.concatenate([skin.nodes, nodes]),
            weights=np.concatenate([skin.weights, weights]),
        ),
        pointer=pointer.astype(np.int64),
        element=element,
        beyond=np.concatenate([outer, beyond]).astype(np.int64),
        side=np.concatenate([fate, side]).astype(np.int64),
        vertices=np.array([0, skin.vertices.shape[0] + places.shape[0]]),
        triangles=np.array([0, count + corners.shape[0]]),
    )


def _opened(faces: Long, sides: Long) -> tuple[Long, Long, Long]:
    """Triangles of both sides of faces that open, as of `_inner`; beyond is the number of the face."""
    wide, number = faces.shape[1] // 2, np.arange(faces.shape[0], dtype=np.int64)
    found: list[Long] = []
    for n in range(1, wide - 1):
        found += [faces[:, [0, n, n + 1]], faces[:, [wide, wide + n + 1, wide + n]]]
    own = np.tile(np.concatenate([sides[:, 0], sides[:, 1]]), wide - 2)
    return np.concatenate(found), own, np.tile(number, 2 * (wide - 2))


def _whole(skin: Skin) -> CutSkin:
    """The skin of what cannot be cut."""
    count = int(skin.triangles.shape[0])
    return CutSkin(
        skin=skin,
        pointer=np.zeros(count + 1, dtype=np.int64),
        element=np.zeros(0, dtype=np.int64),
        beyond=np.full(count, -1),
        side=np.zeros(count, dtype=np.int64),
        vertices=np.array([0, skin.vertices.shape[0]]),
        triangles=np.array([0, count]),
    )


def _side_by_side(body: Body) -> CutSkin:
    """Of several bodies, of which some can be cut."""
    each = [(cut_skin(part.body) if part.body.cut_count else None) or _whole(part.skin()) for part in body.parts]
    first = np.cumsum([0, *(part.body.cut_count for part in body.parts)])
    entries = np.cumsum([0, *(one.element.size for one in each)])
    sides = np.cumsum([0, *(int(one.side.max(initial=-1)) + 1 for one in each)])
    beyond: list[Long] = [np.where(o.beyond < 0, -1, o.beyond + n) for o, n in zip(each, first, strict=False)]
    pointer: list[Long] = [one.pointer[1:] + n for one, n in zip(each, entries, strict=False)]
    side: list[Long] = [one.side + n for one, n in zip(each, sides, strict=False)]
    return CutSkin(
        skin=joined_skins([part.carrying(one.skin) for part, one in zip(body.parts, each, strict=True)]),
        pointer=np.concatenate([np.zeros(1, dtype=np.int64), *pointer]),
        element=np.concatenate([one.element + n for one, n in zip(each, first, strict=False)]),
        beyond=np.concatenate(beyond),
        side=np.concatenate(side),
        vertices=np.cumsum([0, *(one.skin.vertices.shape[0] for one in each)]),
        triangles=np.cumsum([0, *(one.skin.triangles.shape[0] for one in each)]),
    )


def drawn_skin(body: Body) -> Skin | None:
    """What a viewer draws of a body: its skin, with the inner faces of one that can be cut.

    Args:
        body: any.
    """
    if not body.cut_count:
        return body.skin
    faces = cut_skin(body)
    return None if faces is None else faces.skin


def _within(skin: Skin, rest: Float, elements: Long, faces: Long, own: Long) -> tuple[Float, Long, Float, Long]:
    """Places of the inner faces' corners, the nodes that carry them, how much of each, and the corners by number.

    A lattice reaches beyond the skin that it carries. There a corner lies on the skin, not at the node, and moves with
    its own element, also when the one beside it is gone.
    """
    width = skin.nodes.shape[1]
    lattice = width == elements.shape[1] == 8
    # Corners of a lattice belong to one element, of other bodies to all that have the node.
    pairs = np.stack([np.repeat(own, 3) if lattice else np.zeros(faces.size, dtype=np.int64), faces.ravel()], axis=1)
    used, corners = np.unique(pairs, axis=0, return_inverse=True)
    element, node = used.T
    places, nodes = rest[node].copy(), np.repeat(node[:, None], width, axis=1)
    weights = np.zeros((node.size, width))
    weights[:, 0] = 1.0
    if lattice:
        normal = np.zeros_like(skin.vertices)
        ends = skin.vertices[skin.triangles]
        across = np.cross(ends[:, 1] - ends[:, 0], ends[:, 2] - ends[:, 0])
        for corner in range(3):
            np.add.at(normal, skin.triangles[:, corner], across)
        from scipy.spatial import cKDTree

        nearest = cKDTree(skin.vertices).query(places)[1]
        outside = np.einsum("va,va->v", places - skin.vertices[nearest], normal[nearest]) > 0.0
        moved = element[outside]
        places[outside] = skin.vertices[nearest[outside]]
        low, high = rest[elements[moved, 0]], rest[elements[moved, 7]]
        nodes[outside] = elements[moved]
        weights[outside] = shapes_of((places[outside] - low) / (high - low))
    return places, nodes, weights, corners.reshape(faces.shape)


def carriers(skin: Skin, elements: Long) -> list[list[int]]:
    """Elements that carry each triangle: those of its vertices, or all springs between its nodes.

    Args:
        skin: of the body.
        elements: nodes of each element, (elements, corners).
    """
    of_node: dict[int, set[int]] = {}
    for number, corners in enumerate(elements.tolist()):
        for node in corners:
            of_node.setdefault(node, set()).add(number)
    nothing: set[int] = set()
    carriers: list[list[int]] = skin.nodes.tolist()
    weights: list[list[float]] = skin.weights.tolist()
    triangles: list[list[int]] = skin.triangles.tolist()
    vertex = [
        frozenset(n for n, w in zip(own, shares, strict=True) if abs(w) > _CARRIES)
        for own, shares in zip(carriers, weights, strict=True)
    ]
    result: list[list[int]] = []
    for triangle in triangles:
        nodes = frozenset[int]().union(*(vertex[v] for v in triangle))
        if elements.shape[1] == 2:
            pairs = combinations(sorted(nodes), 2)
            result.append(sorted(e for i, j in pairs for e in of_node.get(i, nothing) & of_node.get(j, nothing)))
            continue
        whole = set[int].intersection(*(of_node.get(n, nothing) for n in nodes))
        if whole:  # one element has all of it
            result.append([min(whole)])
            continue
        some = (set[int].intersection(*(of_node.get(n, nothing) for n in vertex[v])) for v in triangle)
        result.append(sorted({min(each) for each in some if each}))
    return result


def _inner(elements: Long) -> tuple[Long, Long, Long]:
    """Triangles inside: nodes (T, 3), the element that each belongs to, and the one beyond it."""
    nothing = np.zeros(0, dtype=np.int64)
    faces = FACES[elements.shape[1]]
    if not faces:
        return np.zeros((0, 3), dtype=np.int64), nothing, nothing
    together = _A_SIDE[elements.shape[1]]
    sides = np.array(faces).reshape(-1, together * 3)
    at = elements[:, sides].reshape(-1, together * 3)
    own: Long = np.repeat(np.arange(elements.shape[0], dtype=np.int64), sides.shape[0])
    key = np.array([sorted(set(side)) for side in at.tolist()])
    _, number, times = np.unique(key, axis=0, return_inverse=True, return_counts=True)
    order = np.argsort(number.reshape(-1), kind="stable")
    pairs = order[times[number.reshape(-1)[order]] == 2].reshape(-1, 2)
    here, there = np.concatenate([pairs, pairs[:, ::-1]]).T
    owner: Long = np.repeat(own[here], together).astype(np.int64)
    beyond: Long = np.repeat(own[there], together).astype(np.int64)
    return at[here].reshape(-1, 3), owner, beyond
