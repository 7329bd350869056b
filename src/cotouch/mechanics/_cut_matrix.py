"""What gives a step its direction no longer holds what was cut: ties of faces that opened leave the matrix.

They are hundreds of times as stiff as the elements beside them. A matrix that still held them would let each look
correct a hundredth of what the two sides of a cut do to each other, and leave the rest to the closure.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float, Int
from cotouch.mechanics._kernel import block
from cotouch.mechanics._operator import DAMPING, MASS, STIFFNESS, WEIGHTS, Operator
from cotouch.mechanics._vector import at
from cotouch.passing import by_address


@by_address
class Bonds(NamedTuple):
    """Where the ties of each face are in the operator that all copies of a process share.

    Attributes:
        place: of each face's ties, those of the one side and then of the other, in the operator's entries, (E, 8); -1
            where there are fewer. (0, 8) of a body without faces.
        row: rows of these entries, likewise.
        family: whether a family holds springs or dampers, (families,).
        whole: of the operator, like the four that follow.
        entries: changed in place.
        taken: likewise.
        gone: likewise.
        pointer: of rows among the entries.
    """

    place: Int
    row: Int
    family: Int
    whole: Float
    entries: Float
    taken: Float
    gone: Int
    pointer: Int


def bonds_of(op: Operator, tied: Int) -> Bonds:
    """The ties of faces in an operator.

    Args:
        op: of the body, whole.
        tied: rows of what is tied at each face, see `Cutting`; (E, 8).
    """
    count = tied.shape[0] if (tied >= 0).any() else 0
    rows = op.mass.size
    number = np.arange(1, op.column.size + 1)
    find = sp.csr_array((number, op.column, op.pointer), shape=(rows, rows))
    row = np.ascontiguousarray(tied[:count], dtype=np.int32)
    other = np.roll(row, 4, axis=1)
    place = np.full(row.shape, -1, dtype=np.int32)
    there = row >= 0
    if there.any():
        place[there] = np.asarray(find[row[there], other[there]]).ravel() - 1
    inside = (op.mix[[STIFFNESS, DAMPING]] != 0.0).any(axis=0)
    outside = (op.mix[MASS] != 0.0) | (op.mix[WEIGHTS:] != 0.0).any(axis=0)
    return Bonds(
        place=place,
        row=row,
        family=(inside & ~outside).astype(np.int32),
        whole=op.whole,
        entries=op.entries,
        taken=op.taken,
        gone=op.gone,
        pointer=op.pointer,
    )


@block
def loosen(bonds: Bonds, memory: Float, first: int) -> None:
    """Takes the ties of what a copy has cut out of the operator, and puts back those of what it has not.

    Args:
        bonds: the ties.
        memory: of the copy that steps next.
        first: where its marks begin, behind their number.
    """
    count, many = bonds.place.shape[0], int(at(memory, first - 1))
    if count == 0 or (many == 0 and bonds.gone[count] == 0):
        return
    bonds.gone[count] = many
    for e in range(count):
        gone = 1 if at(memory, first + e) != 0.0 else 0
        if gone == at(bonds.gone, e):
            continue
        bonds.gone[e] = gone
        for c in range(8):
            p = at(bonds.place, (e, c))
            for f in range(bonds.family.shape[0] if p >= 0 else 0):
                if at(bonds.family, f) != 0:
                    bonds.entries[f, p] = 0.0 if gone else bonds.whole[f, p]
        for c in range(8):
            i = at(bonds.row, (e, c))
            for f in range(bonds.family.shape[0] if i >= 0 else 0):
                # Anew, so that what was put back leaves nothing.
                taken = 0.0
                for p in range(at(bonds.pointer, i), at(bonds.pointer, i + 1)):
                    taken += bonds.whole[f, p] - bonds.entries[f, p]
                bonds.taken[f, i] = taken
