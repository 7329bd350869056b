"""The matrices of a body and its link weights, laid out for the kernels; and products with them."""

from typing import NamedTuple

import numpy as np
import scipy.sparse as sp
from scipy.sparse import csgraph

from cotouch.arrays import Float, Int
from cotouch.kernels import at, inner, kernel, load, splat, store, total
from cotouch.passing import by_address

# A row sum of K this small beside the diagonal is the rounding of a row that sums to nothing.
_NO_GROUND = 1e-14
# Rows of `Operator.mix`; the weights follow.
MASS, DAMPING, STIFFNESS, WEIGHTS = 0, 1, 2, 3


@by_address
class Operator(NamedTuple):
    """M, B, K and the link weights W_w of one user's copy, as diagonals plus shared off-diagonal families.

    Off the diagonal, matrices are often multiples of each other (springs and dampers along the same edges; a diagonal
    mass) or absent. Each *family* is one set of off-diagonal values; `mix[q, f]` is how much of family f matrix q
    holds. With one family the system matrix of a step is `diagonal + scale * family` for every step length, so nothing
    is assembled at all; with none the step is a closed form.

    Attributes:
        copy_scale: 1/N, the scale of M, B and K in each of N copies.
        firmness: scale of K, of weight and of obstacles beside that, 1 but while members come and go.
        mass: diagonal of M, (rows,).
        damping: diagonal of B, (rows,).
        stiffness: diagonal of K, (rows,).
        weight: diagonals of the link weights, (weights, rows); weight 0 is the identity (in the body's own basis).
        pointer: CSR row pointer of the off-diagonal pattern, (rows + 1,).
        column: CSR column indices, (entries,).
        entries: values of each family, (families, entries).
        mix: (3 + weights, families), rows M, B, K, W_0, W_1, ...
        ground: row sums of K, exactly 0 where they are only rounding, (rows,).
        drag: row sums of B likewise, (rows,).
        magnitude: sum of the absolute values of each row of each family, (families, rows).
        split: rows before it have no entries among each other, nor have those from it on; 0 where no order of the rows
            makes it so.
        taken: what was taken off each row of each family where the copy that steps was cut, (families, rows); or (0, 0)
            of a body that cannot be cut.
        whole: `entries` of that body as it was made, likewise.
        gone: for each of its elements whether it is out of the entries, and how many were cut, (elements + 1,).
        debris: which rows lost all their elements there, and rest, (rows,); or (0,) of a body that cannot be cut.
    """

    copy_scale: float
    firmness: float
    mass: Float
    damping: Float
    stiffness: Float
    weight: Float
    pointer: Int
    column: Int
    entries: Float
    mix: Float
    ground: Float
    drag: Float
    magnitude: Float
    split: int
    taken: Float = np.zeros((0, 0))
    whole: Float = np.zeros((0, 0))
    gone: Int = np.zeros(0, dtype=np.int32)
    debris: Int = np.zeros(0, dtype=np.int32)


def cuttable(op: Operator, elements: int) -> Operator:
    """The operator of a body that can be cut; all copies in a process share what of it is out.

    Args:
        op: of the body, whole.
        elements: how many can be cut.
    """
    out, taken = np.zeros(elements + 1, dtype=np.int32), np.zeros_like(op.magnitude)
    debris = np.zeros(op.mass.size, dtype=np.int32)
    return op._replace(taken=taken, whole=op.entries.copy(), gone=out, debris=debris)


def rescaled(op: Operator, *, copy_scale: float, stiffness: float) -> Operator:
    """The same body in another number of copies; its springs, its weight and what it meets in yet another.

    Args:
        op: as the model has it.
        copy_scale: scale of M and B, > 0.
        stiffness: scale of K, weight and obstacles, > 0.
    """
    ratio = stiffness / copy_scale
    if ratio == 1.0:
        return op._replace(copy_scale=copy_scale)
    mix = op.mix.copy()
    mix[STIFFNESS] *= ratio
    return op._replace(
        copy_scale=copy_scale, firmness=ratio, stiffness=op.stiffness * ratio, ground=op.ground * ratio, mix=mix
    )


@kernel
def mixed(op: Operator, matrix: int) -> bool:
    """Whether a matrix (a row of `mix`) has anything off the diagonal.

    Args:
        op: of the body.
        matrix: its row of `mix`.
    """
    for family in range(op.entries.shape[0]):  # noqa: SIM110 (kernels have no generators)
        if op.mix[matrix, family] != 0.0:
            return True
    return False


@inner
def row_sum(op: Operator, values: Float, i: int, field: Float, lanes: tuple[int, ...]) -> float:
    """Row i of a matrix on the operator's pattern, given by its values, times a field.

    Three entries at a time and two sums: rows have few entries, for which the compiler's own unrolling by eight never
    gets going.

    Args:
        op: the body's matrices.
        values: off the diagonal, (entries,).
        i: which row.
        field: (rows, width).
        lanes: fixes the width of a row.
    """
    e, last = at(op.pointer, i), at(op.pointer, i + 1)
    even, odd = splat(0.0, lanes), splat(0.0, lanes)
    while last - e >= 3:
        even = even + at(values, e) * load(field, at(op.column, e), lanes)
        odd = odd + at(values, e + 1) * load(field, at(op.column, e + 1), lanes)
        even = even + at(values, e + 2) * load(field, at(op.column, e + 2), lanes)
        e += 3
    if e < last:
        odd = odd + at(values, e) * load(field, at(op.column, e), lanes)
    if e + 1 < last:
        even = even + at(values, e + 1) * load(field, at(op.column, e + 1), lanes)
    return even + odd


@inner
def row_product(op: Operator, family: int, i: int, field: Float, lanes: tuple[int, ...]) -> float:
    """Row i of one family times a field.

    Args:
        op: the body's matrices.
        family: which one.
        i: which row.
        field: (rows, width).
        lanes: fixes the width of a row.
    """
    return row_sum(op, op.entries[family], i, field, lanes)


@kernel
def pull(op: Operator, i: int, field: Float, lanes: tuple[int, ...]) -> float:
    """Row i of K times a field, by differences between rows: `(K 1)_i x_i + sum_j K_ij (x_j - x_i)`.

    A free body may travel far on a small stretch, and the plain product would lose the stretch in the travel.

    Args:
        op: the body's matrices.
        i: which row.
        field: (rows, width).
        lanes: fixes the width of a row.
    """
    own = load(field, i, lanes)
    result = at(op.ground, i) * own
    for family in range(op.entries.shape[0]):
        coefficient = op.mix[STIFFNESS, family]
        if coefficient != 0.0:
            entries = op.entries[family]
            for e in range(at(op.pointer, i), at(op.pointer, i + 1)):
                result = result + (coefficient * at(entries, e)) * (load(field, at(op.column, e), lanes) - own)
    return result


@kernel
def multiply(op: Operator, matrix: int, diagonal: Float, field: Float, out: Float, lanes: tuple[int, ...]) -> float:
    """`out = A field` for a matrix of the operator; returns `fieldᵀ A field`.

    Args:
        op: of the body.
        matrix: its row of `mix`.
        diagonal: its diagonal, (rows,).
        field: (rows, width).
        out: result, likewise.
        lanes: fixes the width of a row.
    """
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


@inner
def taken_off(op: Operator, T: float, i: int) -> float:
    """What the diagonal of `B + (T/2) K` has too much where the copy that steps was cut; at most 0.

    Args:
        op: the body's matrices.
        T: length of the step [s].
        i: which row.
    """
    off = 0.0
    for family in range(op.taken.shape[0]):
        scale = at(op.mix, (DAMPING, family)) + 0.5 * T * at(op.mix, (STIFFNESS, family))
        off += scale * at(op.taken, (family, i))
    return off


def off_diagonal(matrix: sp.csr_array) -> sp.csr_array:
    """What is beside the diagonal, without stored zeros."""
    rest = sp.csr_array(matrix - sp.diags_array(matrix.diagonal()))
    rest.eliminate_zeros()
    return rest


def halves(matrices: list[sp.csr_array]) -> tuple[Int | None, int]:
    """The order that puts rows into two halves with entries only across, and where the second starts; or (None, 0).

    Lattices, chains and trees have such halves. They are found in the graph that has every row twice, once for each
    half, and an edge across for every entry: there the two of a row are connected exactly if a cycle is odd.
    """
    pattern = off_diagonal(sum((abs(m) for m in matrices[1:]), start=abs(matrices[0])))
    if pattern.nnz == 0:
        return None, 0
    rows = pattern.shape[0]
    labels = csgraph.connected_components(sp.block_array([[None, pattern], [pattern, None]]), directed=False)[1]
    first, second = labels[:rows], labels[rows:]
    if np.any(first == second):
        return None, 0
    return np.argsort(first > second, kind="stable").astype(np.int32), int(np.count_nonzero(first < second))


def operator_of(matrices: list[sp.csr_array], copies: int, split: int) -> Operator:
    """Splits matrices into diagonals and shared off-diagonal families.

    Args:
        matrices: mass, damping, stiffness and link weights, in the kernels' order.
        copies: N.
        split: see `Operator`.
    """
    rows = matrices[0].shape[0]
    diagonals = [np.ascontiguousarray(matrix.diagonal(), dtype=np.float64) for matrix in matrices]
    if all(matrix.nnz == np.count_nonzero(own) for matrix, own in zip(matrices, diagonals, strict=True)):
        nothing = np.zeros((len(matrices), 0))
        return _assembled(
            copies, split, diagonals, np.zeros(rows + 1, np.int32), np.zeros(0, np.int32), np.zeros((0, 0)), nothing
        )
    off = [off_diagonal(matrix) for matrix in matrices]
    pattern = sp.csr_array(sum((abs(m) for m in off[1:]), start=abs(off[0])))
    pattern.sort_indices()
    # Adding 1 at every place of the pattern keeps each matrix's zeros stored, so that all have the same entry order.
    ones = sp.csr_array((np.ones(pattern.nnz), pattern.indices, pattern.indptr), shape=pattern.shape)
    values: list[Float] = []
    for matrix in off:
        padded = sp.csr_array(ones * 1.0)
        padded.data = np.asarray(matrix[ones.nonzero()]).ravel() if matrix.nnz else np.zeros(pattern.nnz)
        values.append(padded.data.astype(np.float64))
    families: list[Float] = []
    mix = np.zeros((len(matrices), len(matrices)))
    # Springs first: their family is then exact and the others are multiples of it.
    order = [STIFFNESS, *(q for q in range(len(matrices)) if q != STIFFNESS)]
    for q in order:
        if not np.any(values[q]):
            continue
        for f, family in enumerate(families):
            largest = int(np.argmax(np.abs(family)))  # one entry: a quotient of sums would add the rounding of the sums
            ratio = float(values[q][largest] / family[largest])
            if np.abs(values[q] - ratio * family).max() <= 1e-14 * np.abs(values[q]).max():
                mix[q, f] = ratio
                break
        else:
            mix[q, len(families)] = 1.0
            families.append(values[q])
    return _assembled(
        copies,
        split,
        diagonals,
        pattern.indptr.astype(np.int32),
        pattern.indices.astype(np.int32),
        np.ascontiguousarray(np.stack(families)),
        np.ascontiguousarray(mix[:, : len(families)]),
    )


def _assembled(
    copies: int, split: int, diagonals: list[Float], pointer: Int, column: Int, entries: Float, mix: Float
) -> Operator:
    rows = diagonals[0].size
    magnitude = np.zeros((entries.shape[0], rows))
    ground, drag = diagonals[STIFFNESS].copy(), diagonals[DAMPING].copy()
    for family, values in enumerate(entries):
        magnitude[family] = sp.csr_array((np.abs(values), column, pointer), shape=(rows, rows)).sum(axis=1)
        beside = sp.csr_array((values, column, pointer), shape=(rows, rows)).sum(axis=1)
        ground += mix[STIFFNESS, family] * beside
        drag += mix[DAMPING, family] * beside
    ground[np.abs(ground) <= _NO_GROUND * diagonals[STIFFNESS]] = 0.0
    drag[np.abs(drag) <= _NO_GROUND * diagonals[DAMPING]] = 0.0
    return Operator(
        copy_scale=1.0 / copies,
        firmness=1.0,
        mass=diagonals[0],
        damping=diagonals[1],
        stiffness=diagonals[2],
        weight=np.ascontiguousarray(np.stack(diagonals[WEIGHTS:])),
        pointer=pointer,
        column=column,
        entries=entries,
        mix=mix,
        ground=ground,
        drag=drag,
        magnitude=magnitude,
        split=split,
    )
