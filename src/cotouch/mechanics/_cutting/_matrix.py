"""What gives a step its direction no longer holds what was cut: what joined rows by cut elements leaves the matrix.

Ties of faces are hundreds of times as stiff as the elements beside them. A matrix that still held them would let each
look correct a hundredth of what the two sides of a cut do to each other, and leave the rest to the closure. Springs and
dampers of elements would hold pieces together that fly apart.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Bool, Float, Int
from cotouch.kernels import at, block, inner, put
from cotouch.mechanics._linear._operator import DAMPING, MASS, STIFFNESS, WEIGHTS, Operator
from cotouch.passing import by_address


@by_address
class Bonds(NamedTuple):
    """Where elements join pairs of rows in the operator that all copies of a process share.

    Attributes:
        pair: pairs that each element joins: by its edges, or of a face the ties; (E, p), -1 where there are fewer.
        place: of each pair in the operator's entries, in its one row and in its other, (P, 2).
        row: these rows, likewise.
        holders: first of the elements that join each pair, among `holder`, (P + 1,).
        holder: elements; a pair is in the matrix while one of its own is whole.
        family: whether a family holds springs or dampers, (families,).
        whole: of the operator, like the four that follow.
        entries: changed in place.
        taken: likewise.
        gone: likewise.
        pointer: of rows among the entries.
        debris: of the operator, changed in place.
        hung: first of the elements at each row, among `hangs`; faces are none, (rows + 1,).
        hangs: elements.
    """

    pair: Int
    place: Int
    row: Int
    holders: Int
    holder: Int
    family: Int
    whole: Float
    entries: Float
    taken: Float
    gone: Int
    pointer: Int
    debris: Int
    hung: Int
    hangs: Int


def bonds_of(op: Operator, tied: Int, corner: Int) -> Bonds:
    """What elements join in an operator.

    Args:
        op: of the body, whole.
        tied: rows of what is tied at each face, see `Cutting`; (E, 8).
        corner: rows of each element's corners, which count where nothing is tied; (E, 16).
    """
    count, rows = tied.shape[0], op.mass.size
    faces = (tied >= 0).any(axis=1)
    one, other = np.triu_indices(8, 1)
    ends = np.full((count, one.size, 2), -1)
    ends[faces, :4, 0], ends[faces, :4, 1] = tied[faces, :4], tied[faces, 4:]
    ends[~faces, :, 0], ends[~faces, :, 1] = corner[~faces][:, one], corner[~faces][:, other]
    ends.sort(axis=2)
    element, slot = np.nonzero(ends[:, :, 0] >= 0)
    number = np.arange(1, op.column.size + 1)
    find = sp.csr_array((number, op.column, op.pointer), shape=(rows, rows))
    first, second = ends[element, slot].T
    known = np.asarray(find[first, second]).ravel() > 0  # corners of a cube across it are not joined
    element, slot, first, second = (array[known] for array in (element, slot, first, second))
    joined, own = np.unique(first * rows + second, return_inverse=True)
    row = np.stack([joined // rows, joined % rows], axis=1)
    pair = np.full((count, one.size), -1, dtype=np.int32)
    pair[element, slot] = own.ravel()
    sort = np.argsort(own.ravel(), kind="stable")
    inside = (op.mix[[STIFFNESS, DAMPING]] != 0.0).any(axis=0)
    outside = (op.mix[MASS] != 0.0) | (op.mix[WEIGHTS:] != 0.0).any(axis=0)
    places = [np.asarray(find[row[:, k], row[:, 1 - k]]).ravel() - 1 for k in range(2)]
    alone: Bool = np.logical_and(corner >= 0, np.repeat(faces, corner.shape[1]).reshape(corner.shape) == 0)
    hangs = corner[alone]
    by_row = np.argsort(hangs, kind="stable")
    return Bonds(
        pair=pair,
        place=np.stack(places, axis=1).astype(np.int32),
        row=row.astype(np.int32),
        holders=np.concatenate([[0], np.cumsum(np.bincount(own.ravel(), minlength=joined.size))]).astype(np.int32),
        holder=element[sort].astype(np.int32),
        family=(inside & ~outside).astype(np.int32),
        whole=op.whole,
        entries=op.entries,
        taken=op.taken,
        gone=op.gone,
        pointer=op.pointer,
        debris=op.debris,
        hung=np.concatenate([[0], np.cumsum(np.bincount(hangs, minlength=rows))]).astype(np.int32),
        hangs=np.nonzero(alone)[0][by_row].astype(np.int32),
    )


@block
def loosen(bonds: Bonds, memory: Float, first: int) -> None:
    """Takes what a copy has cut through out of the operator, and puts back what it has not.

    Args:
        bonds: the pairs that elements join.
        memory: of the copy that steps next.
        first: where its marks begin, behind their number.
    """
    count, many = bonds.pair.shape[0], int(at(memory, first - 1))
    if many == 0 and bonds.gone[count] == 0:
        return
    bonds.gone[count] = many
    changed = False
    for e in range(count):
        gone = 1 if at(memory, first + e) != 0.0 else 0
        if gone == at(bonds.gone, e):
            continue
        bonds.gone[e], changed = gone, True
        for c in range(bonds.pair.shape[1]):
            if at(bonds.pair, (e, c)) >= 0:
                _join(bonds, at(bonds.pair, (e, c)))
    for i in range(bonds.debris.shape[0] if changed else 0):
        whole = at(bonds.hung, i) == at(bonds.hung, i + 1)  # what never had an element is none
        for n in range(at(bonds.hung, i), at(bonds.hung, i + 1)):
            whole = whole or at(bonds.gone, at(bonds.hangs, n)) == 0
        put(bonds.debris, i, 0 if whole else 1)


@inner
def _join(bonds: Bonds, pair: int) -> None:
    """Makes the matrix hold a pair of rows as far as an element that joins it is whole."""
    held = False
    for h in range(at(bonds.holders, pair), at(bonds.holders, pair + 1)):
        held = held or at(bonds.gone, at(bonds.holder, h)) == 0
    for side in range(2):
        p = at(bonds.place, (pair, side))
        for f in range(bonds.family.shape[0]):
            if at(bonds.family, f) != 0:
                bonds.entries[f, p] = bonds.whole[f, p] if held else 0.0
    for side in range(2):
        i = at(bonds.row, (pair, side))
        for f in range(bonds.family.shape[0]):
            # Anew, so that what was put back leaves nothing.
            taken = 0.0
            for p in range(at(bonds.pointer, i), at(bonds.pointer, i + 1)):
                taken += bonds.whole[f, p] - bonds.entries[f, p]
            bonds.taken[f, i] = taken
