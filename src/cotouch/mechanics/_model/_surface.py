"""The skin of a body in the form that contact works on: its vertices, and a tree of boxes around them."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Bool, Float, Int
from cotouch.body import Body, cut_skin
from cotouch.errors import BodyError
from cotouch.mechanics._model._model import Model
from cotouch.mechanics._model._relief import Relief, bare
from cotouch.mechanics._model._tool_marks import tool_marks
from cotouch.passing import by_address

_LEAF = 4
# Triangles at which a truncated body's missing compliance is worked out.
_PROBES = 32


@by_address
class Surface(NamedTuple):
    """A triangulated skin, its tree of boxes, and how it hangs on the rows of a model.

    Attributes:
        rest: places of the vertices at rest, (V, 4), the last column zero [m].
        corner: vertices of each triangle, (F, 3).
        area: of each at rest, (F,) [m²].
        row: rows that carry each vertex, (V, k, axes): one for all axes, or one each; (V, 0, axes) in a modal basis.
        weight: how much of each, (V, k).
        shape: modal: displacement of each vertex with each row, (V * rows, 4): the same on all axes, or one for each.
        child: the two children of each box; of a leaf, `-1 - first` and how many triangles of `leaf`, (B, 2).
        leaf: triangles, ordered so that those of a leaf follow each other, (F,).
        low: rest corners of each box, (B, 4), modal only.
        high: likewise.
        lean: modal: mean shape of the vertices in a box, (B * rows, 4).
        spread: modal: how far a shape is from that mean anywhere in the box, (B * rows, 4).
        hold_rest: rest places of what a grasp may hold: nodes, or vertices in a modal basis, (H, 4) [m].
        hold_row: its rows, (H, axes); (H, 0) in a modal basis, where it is the vertex of the same number.
        soft: what a truncated body lacks in static compliance at a corner of each triangle, and between two of its
            corners, (F, 2), else (0, 2) [m/N].
        swing: how many times as fast as the fastest row a vertex can be; 1 where weights are none below 0.
        lever: how many times its share of a vertex of what is rigid a row resists; else 1, (V,).
        away: where in a copy's memory it is whether the body of each triangle, and of each that a grasp may hold, is
            not in it; negative: it always is, (F + H,), or (0,) without tools that are bodies.
        relief: heights on it.
    """

    rest: Float
    corner: Int
    area: Float
    row: Int
    weight: Float
    shape: Float
    child: Int
    leaf: Int
    low: Float
    high: Float
    lean: Float
    spread: Float
    hold_rest: Float
    hold_row: Int
    soft: Float
    swing: float
    lever: Float
    away: Int
    relief: Relief

    def tools(self) -> Bool:
        """Which triangles are of tools that are bodies, (F,)."""
        found = np.zeros(self.corner.shape[0], dtype=np.bool_)
        found[np.flatnonzero(self.away[: found.size] >= 0)] = True
        return found


def surface_of(model: Model) -> Surface:
    """The skin of a body in three dimensions; without one, its nodes are vertices that can only be held.

    Raises:
        BodyError: the body has fewer than three axes.
    """
    body = model.body
    if body.dimension != 3:
        raise BodyError(f"the body has {body.dimension} axes; tools touch bodies of 3 axes only")
    rest, corner, nodes, weights = _skin(body)
    axes = 3 if model.full else 1
    modal = model.modes is not None
    child, leaf, members = _tree(rest, corner)
    side = rest[corner[:, 1]] - rest[corner[:, 0]]
    rows = model.operator_rows
    shape = low = high = lean = spread = np.zeros((0, 4))
    row = np.zeros((rest.shape[0], 0, axes), dtype=np.int32)
    weight = np.zeros((rest.shape[0], 0))
    hold_rest, hold_row = _padded(rest), np.zeros((rest.shape[0], 0), dtype=np.int32)
    if modal:
        shape = _shapes(model, nodes, weights)
        low, high, lean, spread = _bounds(_padded(rest), shape, corner, leaf, members, rows)
    else:
        own = np.arange(body.nodes * axes) if model.order is None else np.argsort(model.order)
        hold_row = own.reshape(body.nodes, axes).astype(np.int32)
        row, weight = np.ascontiguousarray(hold_row[nodes]), np.ascontiguousarray(weights, dtype=np.float64)
        hold_rest = _padded(body.rest)
    turns = (weights < 0.0).any(axis=1) if body.tools else np.full(weights.shape[0], body.rigid)
    reach = np.abs(weights).sum(axis=1)
    return Surface(
        rest=_padded(rest),
        corner=corner,
        area=0.5 * np.linalg.norm(np.cross(side, rest[corner[:, 2]] - rest[corner[:, 0]]), axis=1),
        row=row,
        weight=weight,
        shape=shape,
        child=child,
        leaf=leaf,
        low=low,
        high=high,
        lean=lean,
        spread=spread,
        hold_rest=hold_rest,
        hold_row=hold_row,
        soft=_softness(model, rest, corner) if body.truncation is not None else np.zeros((0, 2)),
        swing=float(reach.max(initial=1.0)),
        lever=np.where(turns, reach[turns].max(initial=1.0), 1.0),
        away=tool_marks(model, corner) if body.tools else np.zeros(0, dtype=np.int32),
        relief=bare(),
    )


def _softness(model: Model, rest: Float, corner: Int) -> Float:
    """Missing compliance at every triangle of a truncated copy: worked out at some, elsewhere that of the nearest.

    The chosen triangles are each the farthest from those before it, so they cover the skin evenly.

    Returns:
        Of a corner by itself, and between two corners, (F, 2) [m/N].
    """
    result = np.zeros((corner.shape[0], 2))
    if model.body.skin is None:
        return result
    centre = rest[corner].mean(axis=1)
    chosen = [0]
    distance = np.linalg.norm(centre - centre[0], axis=1)
    owner = np.zeros(corner.shape[0], dtype=np.intp)
    while len(chosen) < min(_PROBES, corner.shape[0]):
        chosen.append(int(np.argmax(distance)))
        new = np.linalg.norm(centre - centre[chosen[-1]], axis=1)
        owner[new < distance] = len(chosen) - 1
        distance = np.minimum(distance, new)
    missing = model.body.missing_compliance(corner[chosen].ravel().tolist())
    axes = missing.shape[0] // (3 * len(chosen))
    for probe in range(len(chosen)):
        rows = slice(3 * axes * probe, 3 * axes * (probe + 1))
        own = missing[rows, rows].reshape(3, axes, 3, axes).trace(axis1=1, axis2=3) / axes
        alone, together = own.trace() / 3, (own.sum() - own.trace()) / 6
        result[owner == probe] = max(alone, 0.0), min(max(together, 0.0), max(alone, 0.0))
    return result / model.operator.copy_scale


def _padded(places: Float) -> Float:
    out = np.zeros((places.shape[0], 4))
    out[:, :3] = places
    return out


def _skin(body: Body) -> tuple[Float, Int, Int, Float]:
    """Vertices, triangles, carrying nodes and weights; a node without a skin is a triangle of no size."""
    faces = cut_skin(body) if body.cut_count else None
    skin = body.skin if faces is None else faces.skin
    if skin is None or not skin.triangles.size:
        number = np.arange(body.nodes, dtype=np.int32)
        return body.rest, np.repeat(number[:, None], 3, axis=1), number[:, None], np.ones((body.nodes, 1))
    # Copies, because the skin's own arrays are read-only, which is another type to the compiler.
    return skin.vertices, skin.triangles.copy(), skin.nodes, skin.weights.copy()


def _tree(rest: Float, corner: Int) -> tuple[Int, Int, list[tuple[int, int]]]:
    """Boxes by halving at the median of the longest side; parents before children, and each box's span of `leaf`."""
    centre = rest[corner].mean(axis=1)
    leaf = np.arange(int(corner.shape[0]))
    child: list[list[int]] = [[0, 0]]
    members = [(0, corner.shape[0])]
    waiting = [0]
    while waiting:
        box = waiting.pop()
        first, last = members[box]
        if last - first <= _LEAF:
            child[box] = [-1 - first, last - first]
            continue
        own = leaf[first:last]
        axis = int(np.argmax(np.ptp(centre[own], axis=0)))
        middle = (last - first) // 2
        leaf[first:last] = own[np.argpartition(centre[own, axis], middle)]
        for span in ((first, first + middle), (first + middle, last)):
            waiting.append(len(child))
            members.append(span)
            child.append([0, 0])
        child[box] = [len(child) - 2, len(child) - 1]
    return np.array(child, dtype=np.int32), leaf.astype(np.int32), members


def _shapes(model: Model, nodes: Int, weights: Float) -> Float:
    """Displacement of every vertex with every row, (V * rows, 4)."""
    modes = model.modes
    assert modes is not None
    count, rows = nodes.shape[0], modes.shape[1]
    carry = sp.csr_array(
        (weights.ravel(), nodes.ravel(), np.arange(0, nodes.size + 1, int(nodes.shape[1]))),
        shape=(count, model.body.nodes),
    )
    out = np.zeros((count, rows, 4))
    if model.full:
        each = modes.reshape(model.body.nodes, 3, rows)
        for axis in range(3):
            out[:, :, axis] = carry @ each[:, axis]
    else:
        out[:, :, :3] = np.asarray(carry @ modes)[:, :, None]
    return out.reshape(count * rows, 4)


def _bounds(
    rest: Float, shape: Float, corner: Int, leaf: Int, members: list[tuple[int, int]], rows: int
) -> tuple[Float, Float, Float, Float]:
    """Rest box, mean shape and spread of shapes for every box of the tree."""
    shapes = shape.reshape(-1, rows, 4)
    count = len(members)
    low, high = np.zeros((count, 4)), np.zeros((count, 4))
    lean, spread = np.zeros((count, rows, 4)), np.zeros((count, rows, 4))
    for box, (first, last) in enumerate(members):
        own = np.unique(corner[leaf[first:last]])
        low[box], high[box] = rest[own].min(axis=0), rest[own].max(axis=0)
        moved = shapes[own]
        lean[box] = 0.5 * (moved.min(axis=0) + moved.max(axis=0))
        spread[box] = 0.5 * np.ptp(moved, axis=0)
    return low, high, lean.reshape(-1, 4), spread.reshape(-1, 4)
