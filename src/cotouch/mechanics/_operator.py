"""The matrices of a body and its link weights, laid out for the kernels; and products with them."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.mechanics._kernel import kernel
from cotouch.mechanics._vector import at, load, splat, store, total

Float = npt.NDArray[np.float64]
Int = npt.NDArray[np.int32]

# Rows of `Operator.mix`; the weights follow.
MASS, DAMPING, STIFFNESS, WEIGHTS = 0, 1, 2, 3


class Operator(NamedTuple):
    """M, B, K and the link weights W_w of one user's copy, as diagonals plus shared off-diagonal families.

    Off the diagonal, matrices are often multiples of each other (springs and dampers along the same edges; a diagonal
    mass) or absent. Each *family* is one set of off-diagonal values; `mix[q, f]` is how much of family f matrix q
    holds. With one family the system matrix of a step is `diagonal + scale * family` for every step length, so nothing
    is assembled at all; with none the step is a closed form.

    Attributes:
        share: 1/N, the scale of M, B and K in each of N copies.
        mass: diagonal of M, (rows,).
        damping: diagonal of B, (rows,).
        stiffness: diagonal of K, (rows,).
        weight: diagonals of the link weights, (weights, rows); weight 0 is the identity (in the body's own basis).
        pointer: CSR row pointer of the off-diagonal pattern, (rows + 1,).
        column: CSR column indices, (entries,).
        entries: values of each family, (families, entries).
        mix: (3 + weights, families), rows M, B, K, W_0, W_1, ...
    """

    share: float
    mass: Float
    damping: Float
    stiffness: Float
    weight: Float
    pointer: Int
    column: Int
    entries: Float
    mix: Float


@kernel
def mixed(op: Operator, matrix: int) -> bool:
    """Whether a matrix (a row of `mix`) has anything off the diagonal."""
    for family in range(op.entries.shape[0]):  # noqa: SIM110 (kernels have no generators)
        if op.mix[matrix, family] != 0.0:
            return True
    return False


@kernel
def row_product(op: Operator, family: int, i: int, field: Float, lanes: tuple[int, ...]) -> float:
    """Row i of one family times a field."""
    entries = op.entries[family]
    result = splat(0.0, lanes)
    for e in range(at(op.pointer, i), at(op.pointer, i + 1)):
        result = result + at(entries, e) * load(field, at(op.column, e), lanes)
    return result


@kernel
def multiply(op: Operator, matrix: int, diagonal: Float, field: Float, out: Float, lanes: tuple[int, ...]) -> float:
    """`out = A field` for a matrix of the operator; returns `fieldᵀ A field`."""
    form = splat(0.0, lanes)
    for i in range(diagonal.shape[0]):
        own = load(field, i, lanes)
        result = at(diagonal, i) * own
        for family in range(op.entries.shape[0]):
            scale = op.mix[matrix, family]
            if scale != 0.0:
                result = result + scale * row_product(op, family, i, field, lanes)
        store(out, i, result, lanes)
        form = form + own * result
    return total(form)
