"""Solving for the rows of rigid bodies at once, whose law gives its true tangent: a dense matrix on top of the rest."""

from cotouch.arrays import Float
from cotouch.kernels import FOUR, at, load, part, put, store
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import Ports, Workspace


@part
def solve_dense(op: Operator, ports: Ports, work: Workspace) -> None:
    """Writes into `mean`, at rows that are solved for at once, what `(D + families + ports + dense) v̂ = rhs` asks for.

    Args:
        op: the body.
        ports: what holds the copy.
        work: `diagonal`, `scale`, `port_gain`, `dense` and `rhs` are read.
    """
    among, matrix, right = work.among, work.factor, work.answer
    size = 3 * among.shape[0]
    for p in range(size):
        for q in range(size):
            put(matrix, (p, q), at(work.dense, (p, q)))
    for r in range(among.shape[0]):
        i = at(among, r)
        for a in range(3):
            put(right, 3 * r + a, at(work.rhs, (i, a)))
        _add(matrix, r, r, at(work.diagonal, i))
        for family in range(op.entries.shape[0]):
            for e in range(at(op.pointer, i), at(op.pointer, i + 1)):
                s = at(work.rigid, at(op.column, e))
                if s >= 0:
                    _add(matrix, r, s, at(work.scale, family) * at(op.entries, (family, e)))
    if ports.shape.shape[0] > 0:
        for p in range(ports.row.shape[0]):
            gain = at(work.port_gain, p)
            if gain != 0.0:
                for r in range(among.shape[0]):
                    share = gain * at(ports.shape, (p, at(among, r)))
                    for s in range(among.shape[0] if share != 0.0 else 0):
                        _add(matrix, r, s, share * at(ports.shape, (p, at(among, s))))
    _eliminate(matrix, right, size)
    for r in range(among.shape[0]):
        for a in range(3):
            put(work.mean, (at(among, r), a), at(right, 3 * r + a))


@part
def _add(matrix: Float, i: int, j: int, value: float) -> None:
    for a in range(3):
        place = (3 * i + a, 3 * j + a)
        put(matrix, place, at(matrix, place) + value)


@part
def _eliminate(matrix: Float, right: Float, size: int) -> None:
    """Gauss's elimination with the largest pivot of each column; a column without one is left out.

    Rows go by fours, which four masses of each body are. What that changes left of a pivot is not read again.
    """
    blocks = size // 4
    for k in range(size):
        best, most = k, abs(at(matrix, (k, k)))
        for p in range(k + 1, size):
            if abs(at(matrix, (p, k))) > most:
                best, most = p, abs(at(matrix, (p, k)))
        if not most > 0.0:
            put(matrix, (k, k), 1.0)
            put(right, k, 0.0)
            continue
        if best != k:
            for q in range(k // 4, blocks):
                row = load(matrix, k * blocks + q, FOUR)
                store(matrix, k * blocks + q, load(matrix, best * blocks + q, FOUR), FOUR)
                store(matrix, best * blocks + q, row, FOUR)
            value = at(right, k)
            put(right, k, at(right, best))
            put(right, best, value)
        inverse = 1.0 / at(matrix, (k, k))
        for p in range(k + 1, size):
            factor = inverse * at(matrix, (p, k))
            if factor == 0.0:
                continue
            for q in range((k + 1) // 4, blocks):
                row = load(matrix, p * blocks + q, FOUR) - factor * load(matrix, k * blocks + q, FOUR)
                store(matrix, p * blocks + q, row, FOUR)
            put(right, p, at(right, p) - factor * at(right, k))
    for back in range(size):
        k = size - 1 - back
        value = at(right, k) / at(matrix, (k, k))
        put(right, k, value)
        for p in range(k):
            put(right, p, at(right, p) - at(matrix, (p, k)) * value)
