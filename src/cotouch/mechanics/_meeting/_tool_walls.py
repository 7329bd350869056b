"""Points on the wall of a long, round tool: in rings, as close as edges of other bodies ask for.

Where it lies across an edge, it is in the other body with a few millimetres of its length only. Points half as far
apart as it is thick, which are enough on faces, may all be beside that.
"""

from typing import NamedTuple

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components

from cotouch.arrays import Float, Long
from cotouch.body import Body, CutSkin, shares_of

# What is so many times as long as thick has so many pairs of rings for each thickness, at most so many in all, of so
# many points each.
_LONG, _PAIRS, _MOST, _ROWS = 4.0, 6.0, 100, 24
# Points are so many times as far apart as those of a ring, or as rings, at most.
_GAP = 1.5
# Where the first point's share of the ring begins: facets of a cylinder, whatever their number, lie well within theirs.
_BEGINS = 0.1875
# Normals of a wall are less than so much along it; neighbouring ones differ by less than this cosine, and no neighbour
# is above a triangle's plane by more than this share of the thickness.
_ALONG, _ALIKE, _ABOVE = 0.6, 0.8, 1e-6
# Towards this an axis goes: none that is built by hand is square to it.
_AHEAD = (1.0, 0.61, 0.37)
# Pieces that are a smaller share of their triangle are rounding.
_NOTHING = 1e-9


class Walls(NamedTuple):
    """Points that stand for some of the triangles of several bodies.

    Attributes:
        places: (P, 3) [m].
        area: that each stands for, (P,) [m²].
        carry: how much of each node carries each, (P, n).
        part_of: which share of the point each triangle makes, (P, F).
        left: triangles for which none of them stands.
        tools: how thick those bodies are whose walls these are, by their numbers [m].
    """

    places: Float
    area: Float
    carry: sp.csr_array
    part_of: sp.csr_array
    left: Long
    tools: dict[int, float]


def spans_of(body: Body, faces: CutSkin | None) -> Long:
    """First triangle of each of several bodies, (bodies + 1,).

    Args:
        body: of several.
        faces: its skin with the inner faces, of what can be cut.
    """
    if faces is not None:
        return faces.triangles
    return np.cumsum([0, *(part.skin().triangles.shape[0] for part in body.parts)], dtype=np.int64)


def walls_of(body: Body, faces: CutSkin | None, apart: float) -> Walls:
    """Points on the walls of those tools among several bodies that are long and round.

    Args:
        body: of several.
        faces: its skin with the inner faces, of what can be cut.
        apart: how far apart points may be, or something fits between them; what has them farther apart is left [m].
    """
    spans = spans_of(body, faces)
    triangles, tools = int(spans[-1]), dict[int, float]()
    left = np.ones(triangles, dtype=bool)
    places: list[Float] = [np.zeros((0, 3))]
    area: list[Float] = [np.zeros(0)]
    carry, part_of = [sp.csr_array((0, body.nodes))], [sp.csr_array((0, triangles))]
    for number, part in enumerate(body.parts):
        if part.tool is None or not part.body.rigid:
            continue
        vertices, corners = part.skin().vertices, part.skin().triangles.astype(np.int64)
        ends = vertices[corners]
        normal = np.cross(ends[:, 1] - ends[:, 0], ends[:, 2] - ends[:, 0])
        axis = _axis(vertices)
        own, shell, thick = _wall(vertices, corners, normal, axis)
        # What does not hang together has no point in common: two tines, or a shaft and its handle.
        row = _row_of(normal[own], axis) + _ROWS * shell
        around = np.bincount(np.unique(row) // _ROWS).min(initial=_ROWS)
        pitch = max(np.pi * thick / around, float(np.ptp(vertices @ axis)) / (2 * _MOST))
        if not own.size or _GAP * pitch > apart:
            continue
        found, size, of, share, point = _rings(ends[own], normal[own], row, axis, thick)
        columns = np.tile(np.arange(part.first, part.last), found.shape[0])
        rows: Long = np.repeat(np.arange(found.shape[0], dtype=np.int64), part.body.nodes)
        carried = shares_of(part.body.rest, found).ravel()
        carry.append(sp.csr_array((carried, (rows, columns)), shape=(found.shape[0], body.nodes)))
        entries = share, (point, spans[number] + own[of])
        part_of.append(sp.csr_array(entries, shape=(found.shape[0], triangles)))
        places.append(found @ part.turn.T + part.shift)
        area.append(size)
        left[spans[number] + own] = False
        tools[number] = thick
    return Walls(
        places=np.concatenate(places),
        area=np.concatenate(area),
        carry=sp.csr_array(sp.vstack(carry)),
        part_of=sp.csr_array(sp.vstack(part_of)),
        left=np.flatnonzero(left),
        tools=tools,
    )


def _axis(vertices: Float) -> Float:
    """Along which something is longest, (3,)."""
    axis: Float = np.linalg.svd(vertices - vertices.mean(axis=0), full_matrices=False)[2][0]
    return axis if axis @ np.array(_AHEAD) > 0.0 else -axis


def _wall(vertices: Float, corners: Long, normal: Float, axis: Float) -> tuple[Long, Long, float]:
    """Which triangles are the wall of something long and round, none where it is not that.

    Returns:
        The triangles, the number of what hangs together of which each is, and how thick all is [m].
    """
    size = np.linalg.norm(normal, axis=1)
    wall = np.abs(normal @ axis) < _ALONG * size
    # Where it is round, the least of its extents would be along axes that rounding chooses.
    long, none = float(np.ptp(vertices @ axis)), np.zeros(0, dtype=np.int64)
    thick = 0.5 * float(size[wall].sum()) / (np.pi * long)
    if long < _LONG * thick or not wall.any():
        return none, none, thick
    unit = normal / np.where(size > 0.0, size, 1.0)[:, None]
    ends = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1)[wall].reshape(-1, 2), axis=1)
    face = np.repeat(np.flatnonzero(wall), 3)
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    ends, face = ends[order], face[order]
    met = np.flatnonzero((ends[1:] == ends[:-1]).all(axis=1))
    one, two = face[met], face[met + 1]
    above = np.einsum("sca,sa->sc", vertices[corners[two]] - vertices[ends[met, 0]][:, None], unit[one])
    alike = np.einsum("sa,sa->s", unit[one], unit[two])
    is_round = alike.min(initial=1.0) >= _ALIKE and above.max(initial=0.0) <= _ABOVE * thick
    if not is_round:
        return none, none, thick
    together = sp.coo_array((np.ones(one.size), (one, two)), shape=(wall.size, wall.size))
    shell = connected_components(together, directed=False)[1][wall]
    return np.flatnonzero(wall), np.unique(shell, return_inverse=True)[1].reshape(-1).astype(np.int64), thick


def _rings(ends: Float, normal: Float, rows: Long, axis: Float, thick: float) -> tuple[Float, Float, Long, Float, Long]:
    """Points of a wall, their areas, and their pieces: which triangle, what share of the point, and of which point.

    What looks one way in a slice is one point. It is beside the middle of that by the root of the mean square of its
    breadth, to one side and, in the next slice, to the other: so forces and torques on faces are exact.
    """
    level: Float = ends @ axis
    level -= level.min()
    most = float(level.max())
    count = 2 * min(int(np.ceil(_PAIRS * most / thick - _NOTHING)), _MOST)
    level = np.clip(level * (count / most), 0.0, count)
    low = np.floor(level.min(axis=1)).astype(np.int64)
    many = np.maximum(np.ceil(level.max(axis=1)).astype(np.int64) - low, 1)
    of: Long = np.repeat(np.arange(low.size, dtype=np.int64), many)
    ring: Long = np.repeat(low - np.cumsum(many) + many, many) + np.arange(of.size)
    sort = np.argsort(level, axis=1)
    level, ends = np.take_along_axis(level, sort, axis=1)[of], np.take_along_axis(ends, sort[:, :, None], axis=1)
    start: Float = ring.astype(np.float64)
    second = _below(level, start + 1.0) - _below(level, start)
    kept = np.flatnonzero(second.sum(axis=(1, 2)) > _NOTHING)
    of, ring = of[kept], ring[kept]
    second = second[kept] * (0.5 * np.linalg.norm(normal, axis=1))[of, None, None]
    width = int(rows.max()) + 1
    known, point = np.unique(ring * width + rows[of], return_inverse=True)
    point = point.reshape(-1).astype(np.int64)
    piece: Float = second.sum(axis=(1, 2))
    area = _sums(point, piece[:, None])[:, 0]
    middle = _sums(point, np.einsum("pc,pca->pa", second.sum(axis=2), ends[of])) / area[:, None]
    beside = _sums(point, np.cross(axis, normal[of]) * (piece / np.linalg.norm(normal[of], axis=1))[:, None])
    beside /= np.linalg.norm(beside, axis=1)[:, None]
    breadth = np.einsum("pca,pa->pc", ends[of] - middle[point][:, None], beside[point])
    square = _sums(point, np.einsum("pc,pcd,pd->p", breadth, second, breadth)[:, None])[:, 0] / area
    side = np.where(known // width % 2 == 0, 1.0, -1.0)
    places = middle + (side * np.sqrt(np.maximum(square, 0.0)))[:, None] * beside
    return places, area, of, piece / area[point], point


def _sums(point: Long, vectors: Float) -> Float:
    """What pieces have, for each point, (P, width)."""
    result = np.zeros((int(point.max()) + 1, vectors.shape[1]))
    np.add.at(result, point, vectors)
    return result


def _row_of(normal: Float, axis: Float) -> Long:
    """In which row around an axis triangles are, by where they look, (F,)."""
    if not normal.size:
        return np.zeros(0, dtype=np.int64)
    beside = normal - np.outer(normal @ axis, axis)
    first = beside[0] / np.linalg.norm(beside[0])
    angle = np.arctan2(beside @ np.cross(axis, first), beside @ first)
    return np.floor(angle * (_ROWS / (2.0 * np.pi)) + _BEGINS).astype(np.int64) % _ROWS


def _below(level: Float, limit: Float) -> Float:
    """`∫ λ λᵀ` over what of some triangles is below a level, by their areas; λ are shares of the corners, (F, 3, 3).

    Args:
        level: of the corners, in rising order, (F, 3).
        limit: (F,).
    """
    low, middle, high = level.T
    limit = np.clip(limit, low, high)
    tiny = np.finfo(np.float64).tiny
    across = np.maximum(high - low, tiny)
    a, b = (np.minimum(limit, middle) - low) / np.maximum(middle - low, tiny), (limit - low) / across
    c, d = (high - np.maximum(limit, middle)) / np.maximum(high - middle, tiny), (high - limit) / across
    # A corner of the triangle, or all but one.
    lower, upper = _corner(a, b, (0, 1, 2)), (1.0 + np.eye(3)) / 12.0 - _corner(c, d, (2, 1, 0))
    return np.where((limit <= middle)[:, None, None], lower, upper)


def _corner(a: Float, b: Float, order: tuple[int, int, int]) -> Float:
    """The same over what is between a corner and two places, shares a and b of the way to the two others."""
    i, j, k = order
    ends = np.zeros((a.size, 3, 3))
    ends[:, :, i] = np.stack([np.ones(a.size), 1.0 - a, 1.0 - b], axis=1)
    ends[:, 1, j], ends[:, 2, k] = a, b
    total = ends.sum(axis=1)
    products = np.einsum("fpi,fpj->fij", ends, ends) + total[:, :, None] * total[:, None, :]
    return (a * b)[:, None, None] * products / 12.0
