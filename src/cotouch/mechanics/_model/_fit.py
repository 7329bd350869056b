"""Where a skin is just now: its vertices, and the boxes around its triangles.

The boxes follow the body. Where a vertex hangs on a few nodes, all of them are refitted in one pass. Where it hangs on
every shape of a modal or truncated body, a box is worked out only when a search comes to it: its mean shape moves it
and the shapes' spread within it widens it, a bound that holds for every motion [James & Pai 2004].
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.kernels import FOUR, at, block, four, inner, load, lower, put, splat, store, total, upper
from cotouch.mechanics._model._model import Model
from cotouch.mechanics._model._surface import Surface
from cotouch.passing import by_address

# Boxes serve until a vertex may be so far from where they hold it, in sides of triangles.
_STALE = 0.1


@by_address
class Fit(NamedTuple):
    """Where a surface is just now; scratch of `refit` and the searches.

    Attributes:
        place: of the vertices, (V, 4) [m].
        fresh: the search for which a vertex was last worked out, (V,).
        low: corners of the boxes, (B, 4) [m].
        high: likewise.
        size: modal: magnitudes of the rows' coordinates, (rows, width); else where rows were when boxes were refitted.
        number: number of the search, (1,).
        slack: how far any vertex may be from where the boxes hold it, and at most, (2,) [m].
        hidden: 1 where a triangle is not there, because the body was cut or is another user's tool, (F,).
    """

    place: Float
    fresh: Int
    low: Float
    high: Float
    size: Float
    number: Int
    slack: Float
    hidden: Int


def fit_of(surface: Surface, model: Model) -> Fit:
    """Scratch for a surface.

    Args:
        surface: the skin.
        model: of its body.
    """
    boxes, vertices = surface.child.shape[0], surface.rest.shape[0]
    side = surface.rest[surface.corner[:, 1]] - surface.rest[surface.corner[:, 0]]
    return Fit(
        place=surface.rest.copy(),
        fresh=np.zeros(vertices, dtype=np.int32),
        low=np.zeros((boxes, 4)),
        high=np.zeros((boxes, 4)),
        size=np.full((model.operator_rows, model.width), np.inf),
        number=np.zeros(1, dtype=np.int32),
        slack=np.array([0.0, _STALE * float(np.median(np.linalg.norm(side, axis=1)))]),
        hidden=np.zeros(surface.corner.shape[0], dtype=np.int32),
    )


@block
def refit(surface: Surface, fit: Fit, position: Float, lanes: tuple[int, ...]) -> None:
    """Brings boxes to where the body is, if it went far since the last time; in a modal basis prepares for searches.

    Args:
        surface: the skin.
        fit: result.
        position: displacement in the model's rows, (rows, width).
        lanes: fixes the width.
    """
    fit.number[0] += 1
    if surface.shape.shape[0] > 0:
        for i in range(position.shape[0]):
            for a in range(position.shape[1]):
                fit.size[i, a] = abs(position[i, a])
        return
    if surface.row.shape[2] == 1:
        far = surface.swing * math.sqrt(farthest(position, fit.size, 1.0, lanes))
        fit.slack[0] = far
        if far <= fit.slack[1]:
            return
        for i in range(position.shape[0]):
            store(fit.size, i, load(position, i, lanes), lanes)
    fit.slack[0] = 0.0
    for v in range(surface.rest.shape[0]):
        _carry(surface, fit, v, position, lanes)
    for back in range(surface.child.shape[0]):
        box = surface.child.shape[0] - 1 - back
        left, right = at(surface.child, 2 * box), at(surface.child, 2 * box + 1)
        if left < 0:
            low, high = splat(np.inf, FOUR), splat(-np.inf, FOUR)
            for place in range(-1 - left, -1 - left + right):
                triangle = at(surface.leaf, place)
                for q in range(3):
                    vertex = load(fit.place, at(surface.corner, 3 * triangle + q), FOUR)
                    low, high = lower(low, vertex), upper(high, vertex)
        else:
            low = lower(load(fit.low, left, FOUR), load(fit.low, right, FOUR))
            high = upper(load(fit.high, left, FOUR), load(fit.high, right, FOUR))
        store(fit.low, box, low, FOUR)
        store(fit.high, box, high, FOUR)


@inner
def farthest(first: Float, second: Float, share: float, lanes: tuple[int, ...]) -> float:
    """A bound on the squares of `first - share * second` in all rows, four at a time: a maximum waits for another.

    Args:
        first: (rows, width).
        second: likewise.
        share: how much of it is taken off.
        lanes: fixes the width of a row.
    """
    a = b = c = d = splat(0.0, lanes)
    last = first.shape[0] - 1
    for i in range(0, last + 1, 4):
        j, k, n = min(i + 1, last), min(i + 2, last), min(i + 3, last)
        p, q = (
            load(first, i, lanes) - share * load(second, i, lanes),
            load(first, j, lanes) - share * load(second, j, lanes),
        )
        r, s = (
            load(first, k, lanes) - share * load(second, k, lanes),
            load(first, n, lanes) - share * load(second, n, lanes),
        )
        a, b, c, d = upper(a, p * p), upper(b, q * q), upper(c, r * r), upper(d, s * s)
    return total(upper(upper(a, b), upper(c, d)))


@inner
def _carry(surface: Surface, fit: Fit, v: int, position: Float, lanes: tuple[int, ...]) -> None:
    """Brings one vertex of a skin that hangs on a few nodes to where they are."""
    if surface.row.shape[2] == 1:
        place = load(surface.rest, v, FOUR)
        for k in range(surface.row.shape[1]):
            entry = v * surface.row.shape[1] + k
            place = place + at(surface.weight, entry) * load(position, at(surface.row, entry), lanes)
        store(fit.place, v, place, FOUR)
        return
    for a in range(3):
        x = surface.rest[v, a]
        for k in range(surface.row.shape[1]):
            x += surface.weight[v, k] * position[surface.row[v, k, a], 0]
        fit.place[v, a] = x


@block
def place_vertex(surface: Surface, fit: Fit, v: int, position: Float, lanes: tuple[int, ...]) -> None:
    """Brings one vertex to where the body is, if this search has not done so yet.

    Args:
        surface: the skin.
        fit: where the skin is; changed in place.
        v: the vertex.
        position: displacements of the rows, (rows, width) [m].
        lanes: fixes the width of a row.
    """
    if at(fit.fresh, v) == at(fit.number, 0):
        return
    put(fit.fresh, v, at(fit.number, 0))
    if surface.shape.shape[0] == 0:
        _carry(surface, fit, v, position, lanes)
        return
    rows = position.shape[0]
    place = load(surface.rest, v, FOUR)
    for i in range(rows):
        place = place + load(position, i, lanes) * load(surface.shape, v * rows + i, FOUR)
    store(fit.place, v, place, FOUR)


@block
def box_distance(
    surface: Surface, fit: Fit, box: int, x: float, y: float, z: float, position: Float, lanes: tuple[int, ...]
) -> float:
    """Square of the distance from a point to a box that holds what it does wherever that is by now, 0 inside [m²].

    Args:
        surface: the skin.
        fit: where the skin is; the box is brought there.
        box: which one.
        x: of the point [m].
        y: likewise.
        z: likewise.
        position: displacements of the rows, (rows, width) [m].
        lanes: fixes the width of a row.
    """
    rows = position.shape[0]
    if surface.shape.shape[0] > 0:
        low, high = load(surface.low, box, FOUR), load(surface.high, box, FOUR)
        moved, wider = splat(0.0, FOUR), splat(0.0, FOUR)
        for i in range(rows):
            moved = moved + load(position, i, lanes) * load(surface.lean, box * rows + i, FOUR)
            wider = wider + load(fit.size, i, lanes) * load(surface.spread, box * rows + i, FOUR)
        store(fit.low, box, low + moved - wider, FOUR)
        store(fit.high, box, high + moved + wider, FOUR)
    middle, far, zero = four(x, y, z, 0.0), splat(at(fit.slack, 0), FOUR), splat(0.0, FOUR)
    gap = upper(upper(load(fit.low, box, FOUR) - middle, middle - load(fit.high, box, FOUR)) - far, zero)
    return total(gap * gap)
