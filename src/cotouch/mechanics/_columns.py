"""How a body yields under unit forces at a few places: columns of `A⁻¹`, worked out no farther than they reach.

Conjugate gradients from zero spread by one neighbour in an iteration, so k of them for a force at a point are exact on
the rows within k neighbours of it and zero beyond. Only those rows are ever touched: for a body of 20,000 nodes some
hundreds instead of all. Four columns are solved at a time, each in a lane of its own.
"""
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.mechanics._kernel import block, part
from cotouch.mechanics._operator import Operator, row_sum
from cotouch.mechanics._surface import FOUR
from cotouch.mechanics._vector import load, splat, store

Int = npt.NDArray[np.int32]

# Rows that a column may be read at: three corners, each carried by eight nodes, each with three axes.
ENTRIES = 72
_TINY = 1e-290


class Columns(NamedTuple):
    """Unit forces h_c at the body and what they do, `A⁻¹ h_c`.

    Attributes:
        row: rows of each h_c, in the body's own basis, (columns, entries).
        value: their weights, (columns, entries).
        entries: how many, (columns,).
        dense: h_c in a modal basis, (columns, rows), else (0, 0).
        answer: A⁻¹ h_c, four to a group, (groups, rows, 4).
        reach: rows that any column reaches, nearest first, (rows,).
        mark: whether a row is in `reach`, (rows,).
        size: number of rows in `reach`, (1,).
        ring: how many rows of `reach` lie within 0, 1, ... neighbours of the columns' own rows, (rows + 1,).
        residual: scratch (rows, 4).
        direction: scratch (rows, 4), zero outside of a solve.
        image: scratch (rows, 4).
        lane: scratch (2, 4).
    """

    row: Int
    value: Float
    entries: Int
    dense: Float
    answer: Float
    reach: Int
    mark: npt.NDArray[np.int8]
    size: Int
    ring: Int
    residual: Float
    direction: Float
    image: Float
    lane: Float


def columns(rows: int, most: int, *, held: int, modal: bool) -> Columns:
    """Room for `most` columns, `held` of which may have a whole grasp's entries."""
    nodal = 0 if modal else rows
    width = max(ENTRIES, held) if not modal else 0
    return Columns(
        row=np.zeros((most, width), dtype=np.int32),
        value=np.zeros((most, width)),
        entries=np.zeros(most, dtype=np.int32),
        dense=np.zeros((most if modal else 0, rows if modal else 0)),
        answer=np.zeros(((most + 3) // 4, rows, 4)),
        reach=np.zeros(nodal, dtype=np.int32),
        mark=np.zeros(nodal, dtype=np.int8),
        size=np.zeros(1, dtype=np.int32),
        ring=np.zeros(nodal + 1, dtype=np.int32),
        residual=np.zeros((nodal, 4)),
        direction=np.zeros((nodal, 4)),
        image=np.zeros((nodal, 4)),
        lane=np.zeros((2, 4)),
    )


@part
def _grow(op: Operator, work: Columns, first: int, last: int) -> int:
    """Adds the neighbours of the rows of `reach` from `first` to `last - 1`; returns the new number of rows."""
    size = last
    for place in range(first, last):
        i = work.reach[place]
        for e in range(op.pointer[i], op.pointer[i + 1]):
            j = op.column[e]
            if work.mark[j] == 0:
                work.mark[j] = 1
                work.reach[size] = j
                size += 1
    return size


@block
def solve_columns(
    op: Operator,
    values: Float,
    scale: float,
    diagonal: Float,
    work: Columns,
    count: int,
    tolerance: float,
    cap: int,
) -> None:
    """Fills `answer` for `count` columns with `(diagonal + scale * values)⁻¹ h_c`; see `conjugate_gradients`."""
    for place in range(work.size[0]):
        work.mark[work.reach[place]] = 0
    size = 0
    for c in range(count):
        for e in range(work.entries[c]):
            i = work.row[c, e]
            if work.mark[i] == 0:
                work.mark[i] = 1
                work.reach[size] = i
                size += 1
    seeds, rings, whole = size, 1, False
    work.ring[0] = seeds
    zero = splat(0.0, FOUR)
    tiny = splat(_TINY, FOUR)
    for group in range((count + 3) // 4):
        answer = work.answer[group]
        for place in range(size):  # what earlier groups reached is zeroed at once, the rest as it is reached
            i = work.reach[place]
            store(answer, i, zero, FOUR)
            store(work.residual, i, zero, FOUR)
        for lane in range(min(4, count - 4 * group)):
            c = 4 * group + lane
            for e in range(work.entries[c]):
                work.residual[work.row[c, e], lane] += work.value[c, e]
        square = zero
        for place in range(seeds):
            i = work.reach[place]
            r = load(work.residual, i, FOUR)
            z = (1.0 / diagonal[i]) * r
            store(work.direction, i, z, FOUR)
            square = square + r * z
        store(work.lane, 0, square, FOUR)
        ring = 0  # how far the direction has reached; no group goes farther than its own iterations
        for _ in range(cap):
            if ring + 1 == rings and not whole:
                grown = _grow(op, work, work.ring[ring - 1] if ring > 0 else 0, size)
                for place in range(size, grown):
                    i = work.reach[place]
                    for other in range(group + 1):  # earlier groups do not reach it: zero, not of another step
                        store(work.answer[other], i, zero, FOUR)
                    store(work.residual, i, zero, FOUR)
                whole = grown == size
                if not whole:
                    work.ring[rings] = grown
                    rings += 1
                size = grown
            ring = min(ring + 1, rings - 1)
            last = work.ring[ring]
            curvature = zero
            for place in range(last):
                i = work.reach[place]
                own = load(work.direction, i, FOUR)
                result = diagonal[i] * own + scale * row_sum(op, values, i, work.direction, FOUR)
                store(work.image, i, result, FOUR)
                curvature = curvature + own * result
            length = square / (curvature + tiny)
            new = zero
            for place in range(last):
                i = work.reach[place]
                p = load(work.direction, i, FOUR)
                store(answer, i, load(answer, i, FOUR) + length * p, FOUR)
                r = load(work.residual, i, FOUR) - length * load(work.image, i, FOUR)
                store(work.residual, i, r, FOUR)
                new = new + (1.0 / diagonal[i]) * (r * r)
            turn = new / (square + tiny)
            square = new
            store(work.lane, 1, new, FOUR)
            done = True
            for lane in range(4):
                if not work.lane[1, lane] <= max(tolerance * tolerance * work.lane[0, lane], _TINY):
                    done = False
            if done:
                break
            for place in range(last):
                i = work.reach[place]
                z = (1.0 / diagonal[i]) * load(work.residual, i, FOUR)
                store(work.direction, i, z + turn * load(work.direction, i, FOUR), FOUR)
        for place in range(size):
            store(work.direction, work.reach[place], zero, FOUR)
    work.size[0] = size


@block
def read_column(work: Columns, c: int, field: Float, lane: int) -> float:
    """`h_cᵀ field[:, lane]`."""
    total = 0.0
    if work.dense.shape[0] > 0:
        for i in range(field.shape[0]):
            total += work.dense[c, i] * field[i, lane]
    else:
        for e in range(work.entries[c]):
            total += work.value[c, e] * field[work.row[c, e], lane]
    return total
