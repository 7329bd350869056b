"""Elements by fours: their corners and rotations as machine vectors, a lane for each element.

Where their number is no multiple of four, the last stands in for those there are not; what weighs it must be 0 there.
"""

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.kernels import FOUR, at, four, inner, load, splat, store, transposed
from cotouch.kernels.matrix3 import Matrix, Vector
from cotouch.mechanics._materials._memory import is_cut

# Four elements, or the rows of four nodes.
Quad: TypeAlias = tuple[int, int, int, int]
# And what a field has there, each a vector.
Rows: TypeAlias = tuple[float, float, float, float]


def blocks(values: Float, weighs: Sequence[int]) -> Float:
    """Numbers of elements, four elements at a time: a row of four for each number, (numbers * blocks, 4).

    Args:
        values: (elements, numbers).
        weighs: which of the numbers are 0 for elements that are missing; the others are those of the last.
    """
    tail = np.repeat(values[-1:], -values.shape[0] % 4, axis=0)
    tail[:, weighs] = 0.0
    whole = np.concatenate([values, tail]).reshape(-1, 4, values.shape[1])
    return np.ascontiguousarray(whole.transpose(0, 2, 1).reshape(-1, 4))


@inner
def elements(e: int, last: int) -> Quad:
    """Four elements from one on.

    Args:
        e: the first.
        last: the last that there is.
    """
    return e, min(e + 1, last), min(e + 2, last), min(e + 3, last)


@inner
def corner_rows(corner: Int, width: int, e: Quad, n: int) -> Quad:
    """Rows of the n-th corners of four elements that have so many.

    Args:
        corner: rows of all corners, element by element.
        width: corners of an element.
        e: which elements.
        n: which corner.
    """
    return (
        at(corner, width * e[0] + n),
        at(corner, width * e[1] + n),
        at(corner, width * e[2] + n),
        at(corner, width * e[3] + n),
    )


@inner
def coordinates(field: Float, i: Quad) -> Vector:
    """Four rows of a field: their first, second and third numbers.

    Args:
        field: (rows, 4).
        i: which rows.
    """
    a, b, c, d = four_rows(field, i)
    x, y, z, _ = transposed(a, b, c, d)
    return x, y, z


@inner
def four_rows(field: Float, i: Quad) -> Rows:
    """Four rows of a field.

    Args:
        field: (rows, 4).
        i: which rows.
    """
    return load(field, i[0], FOUR), load(field, i[1], FOUR), load(field, i[2], FOUR), load(field, i[3], FOUR)


@inner
def apart(a: Rows, b: Rows) -> Vector:
    """Differences of four pairs of rows: their first, second and third numbers.

    Args:
        a: from these.
        b: to these.
    """
    x, y, z, _ = transposed(b[0] - a[0], b[1] - a[1], b[2] - a[2], b[3] - a[3])
    return x, y, z


@inner
def kept(memory: Float, cut: int, e: Quad) -> float:
    """1 for each of four elements, 0 if it was cut.

    Args:
        memory: of the copy, (numbers,).
        cut: where marks of cut elements begin; negative: nothing can be cut.
        e: which elements.
    """
    if cut < 0:
        return splat(1.0, FOUR)
    return four(
        0.0 if is_cut(memory, cut, e[0]) else 1.0,
        0.0 if is_cut(memory, cut, e[1]) else 1.0,
        0.0 if is_cut(memory, cut, e[2]) else 1.0,
        0.0 if is_cut(memory, cut, e[3]) else 1.0,
    )


@inner
def rotations(memory: Float, first: int, e: Quad) -> Matrix:
    """Rotations of four elements; the columns of each are three rows of the memory.

    Args:
        memory: of the copy, (numbers,).
        first: row where they begin.
        e: which elements.
    """
    a, b, c, d = first + 3 * e[0], first + 3 * e[1], first + 3 * e[2], first + 3 * e[3]
    x, y, z = coordinates(memory, (a, b, c, d))
    u, v, w = coordinates(memory, (a + 1, b + 1, c + 1, d + 1))
    p, q, r = coordinates(memory, (a + 2, b + 2, c + 2, d + 2))
    return x, u, p, y, v, q, z, w, r


@inner
def keep_before(memory: Float, first: int, second: int, e: Quad) -> None:
    """Copies what `rotations` reads to rows behind it.

    Args:
        memory: of the copy, (numbers,).
        first: row where they begin.
        second: row where those behind begin.
        e: which elements.
    """
    for column in range(3):
        a, b = first + column, second + column
        i, j = (a + 3 * e[0], a + 3 * e[1], a + 3 * e[2], a + 3 * e[3]), b - a
        _keep(memory, (i[0] + j, i[1] + j, i[2] + j, i[3] + j), four_rows(memory, i))


@inner
def keep_rotations(memory: Float, first: int, e: Quad, m: Matrix) -> None:
    """Writes what `rotations` reads.

    Args:
        memory: of the copy, (numbers,).
        first: row where they begin.
        e: which elements.
        m: what they become.
    """
    a, b, c, d = first + 3 * e[0], first + 3 * e[1], first + 3 * e[2], first + 3 * e[3]
    _keep(memory, (a, b, c, d), as_rows((m[0], m[3], m[6])))
    _keep(memory, (a + 1, b + 1, c + 1, d + 1), as_rows((m[1], m[4], m[7])))
    _keep(memory, (a + 2, b + 2, c + 2, d + 2), as_rows((m[2], m[5], m[8])))


@inner
def _keep(memory: Float, i: Quad, rows: Rows) -> None:
    store(memory, i[0], rows[0], FOUR)
    store(memory, i[1], rows[1], FOUR)
    store(memory, i[2], rows[2], FOUR)
    store(memory, i[3], rows[3], FOUR)


@inner
def as_rows(coordinates: Vector) -> Rows:
    """Four rows of which these are the first, second and third numbers, the last 0."""
    return transposed(coordinates[0], coordinates[1], coordinates[2], splat(0.0, FOUR))


@inner
def add_rows(out: Float, i: Quad, rows: Rows) -> None:
    """Adds to four rows, one after the other: some may be the same.

    Args:
        out: (rows, 4), changed in place.
        i: which rows.
        rows: what is added to each.
    """
    store(out, i[0], load(out, i[0], FOUR) + rows[0], FOUR)
    store(out, i[1], load(out, i[1], FOUR) + rows[1], FOUR)
    store(out, i[2], load(out, i[2], FOUR) + rows[2], FOUR)
    store(out, i[3], load(out, i[3], FOUR) + rows[3], FOUR)


@inner
def take_rows(out: Float, i: Quad, rows: Rows) -> None:
    """Takes off four rows, likewise.

    Args:
        out: (rows, 4), changed in place.
        i: which rows.
        rows: what is taken off each.
    """
    store(out, i[0], load(out, i[0], FOUR) - rows[0], FOUR)
    store(out, i[1], load(out, i[1], FOUR) - rows[1], FOUR)
    store(out, i[2], load(out, i[2], FOUR) - rows[2], FOUR)
    store(out, i[3], load(out, i[3], FOUR) - rows[3], FOUR)
