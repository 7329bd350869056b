"""What a body force remembers of a copy from step to step: its energy, and rotations as three rows of four each.

Behind the rotations are those with which the last evaluation began, to which a step that is not taken goes back.
"""

import numpy as np

from cotouch.arrays import Float
from cotouch.kernels import at, inner, put
from cotouch.kernels.matrix3 import IDENTITY, Matrix

# Rows of a memory, of four numbers: the first holds the energy, rotations begin here, and behind them is scratch.
FIRST = 1
_SCRATCH = 12
# Looks that a step of a body that was cut takes besides.
_MORE = 4


def memory_size(rotations: int) -> int:
    """Numbers in a memory with so many rotations."""
    return 4 * (FIRST + 6 * rotations + _SCRATCH)


def fresh_memory(size: int, more: int = 0) -> Float:
    """A memory of so many numbers in which nothing has turned, and so many more, which are 0.

    Args:
        size: how many, as of `memory_size`.
        more: how many behind them, >= 0.
    """
    rows = np.zeros((size // 4, 4))
    turns = rows[FIRST : max(rows.shape[0] - _SCRATCH, FIRST)].reshape(-1, 3, 4)
    turns[:, [0, 1, 2], [0, 1, 2]] = 1.0
    return np.concatenate([rows.ravel(), np.zeros(more)])


@inner
def is_cut(memory: Float, first: int, element: int) -> bool:
    """Whether an element was cut; its marks begin at a place, or there are none.

    Args:
        memory: of the copy, (numbers,).
        first: where its marks begin; negative: nothing can be cut.
        element: which one.
    """
    return first >= 0 and at(memory, first + element) != 0.0


@inner
def looks_ahead(memory: Float, directions: int, cut: int) -> int:
    """How often a step looks where its force leads: more often once something was cut.

    The constant matrix of its directions holds what is gone, and each look leaves a share of that.

    Args:
        memory: of the copy.
        directions: of a whole body.
        cut: where the number of cut elements is; negative: none can be.
    """
    return directions + _MORE if cut >= 0 and at(memory, cut) > 0.0 else directions


@inner
def before_row(rotations: int) -> int:
    """The first row of the rotations, so many, with which the last evaluation began."""
    return FIRST + 3 * rotations


@inner
def scratch_row(rotations: int) -> int:
    """The first of twelve rows behind so many rotations."""
    return FIRST + 6 * rotations


@inner
def take_back(memory: Float, behind: int) -> None:
    """Takes all rotations back to those with which the last evaluation began.

    Args:
        memory: (numbers,).
        behind: numbers from here on are of something else than the law; 0: none are.
    """
    size = behind if behind > 0 else memory.shape[0]
    numbers = 12 * ((size // 4 - FIRST - _SCRATCH) // 6)
    for place in range(4 * FIRST, 4 * FIRST + numbers):
        put(memory, place, at(memory, place + numbers))


@inner
def columns(memory: Float, row: int) -> Matrix:
    """The matrix whose columns are three rows of the memory.

    Args:
        memory: of the copy, (numbers,).
        row: the first of the three.
    """
    k = 4 * row
    return (
        at(memory, k),
        at(memory, k + 4),
        at(memory, k + 8),
        at(memory, k + 1),
        at(memory, k + 5),
        at(memory, k + 9),
        at(memory, k + 2),
        at(memory, k + 6),
        at(memory, k + 10),
    )


@inner
def keep(memory: Float, row: int, matrix: Matrix) -> None:
    """Writes what `columns` reads.

    Args:
        memory: of the copy, (numbers,).
        row: the first of the three.
        matrix: what they become.
    """
    k = 4 * row
    put(memory, k, matrix[0])
    put(memory, k + 4, matrix[1])
    put(memory, k + 8, matrix[2])
    put(memory, k + 1, matrix[3])
    put(memory, k + 5, matrix[4])
    put(memory, k + 9, matrix[5])
    put(memory, k + 2, matrix[6])
    put(memory, k + 6, matrix[7])
    put(memory, k + 10, matrix[8])


@inner
def forget(memory: Float, behind: int) -> None:
    """Sets all rotations to none, and all else to 0.

    Args:
        memory: (numbers,).
        behind: numbers from here on are of something else than the law; 0: none are.
    """
    for place in range(memory.shape[0]):
        put(memory, place, 0.0)
    size = behind if behind > 0 else memory.shape[0]
    for r in range((size // 4 - FIRST - _SCRATCH) // 3):
        keep(memory, FIRST + 3 * r, IDENTITY)
