"""What the pivots tell when everybody is eliminated from the characteristic matrix: signs of its eigenvalues."""

import numpy as np

from cotouch.arrays import Complex, Float
from cotouch.compiled import routine
from cotouch.network._elimination import Elimination
from cotouch.network._loop import Loop

# A pivot counts as positive above this share of the springs of its user.
_POSITIVE = 1e-10


@routine
def negatives(loop: Loop, parts: Elimination, line: float, matrix: Float) -> int:
    """Negative eigenvalues of G on the real axis, each round trip shared equally by its two ends.

    With delays that are the same both ways this counts the real roots between 0 and the line; with others it is near.

    Args:
        loop: the loop.
        parts: an order in which everybody is eliminated.
        line: where, 1/s.
        matrix: scratch, (N, N).
    """
    n = len(loop.mass)
    for a in range(n):
        p = parts.order[a]
        for x in range(parts.begins[a], parts.begins[a + 1]):
            matrix[p, parts.later[x]] = matrix[parts.later[x], p] = 0.0
        matrix[p, p] = (loop.mass[p] * line + loop.drag[p]) * line + loop.rigid[p]
    for e in range(len(loop.first)):
        i, j = loop.first[e], loop.second[e]
        pull = loop.spring[e] * np.exp(-0.5 * line * (loop.to_first[e] + loop.to_second[e]))
        matrix[i, j] -= pull
        matrix[j, i] -= pull
    found = 0
    for a in range(n):
        p = parts.order[a]
        pivot = matrix[p, p]
        if pivot < 0.0:
            found += 1
        if pivot == 0.0:
            continue
        for x in range(parts.begins[a], parts.begins[a + 1]):
            i = parts.later[x]
            factor = matrix[i, p] / pivot
            for y in range(parts.begins[a], parts.begins[a + 1]):
                matrix[i, parts.later[y]] -= factor * matrix[p, parts.later[y]]
    return found


@routine
def definite(
    loop: Loop, parts: Elimination, line: float, low: float, high: float, lean: float, matrix: Complex
) -> bool:
    """Whether the Hermitian part of `e^(-iθ) G` is surely positive definite all along a stretch of a line.

    It is looked at in the middle of the stretch, less what it can move by from there: no entry moves by more than the
    half length times the largest slope, and a Hermitian matrix is at least minus the sums of its rows.

    Args:
        loop: the loop.
        parts: an order in which everybody is eliminated.
        line: real part.
        low: smallest imaginary part.
        high: largest one.
        lean: cotangent of θ, at least 0.
        matrix: scratch, (N, N).
    """
    n = len(loop.mass)
    s, half = complex(line, 0.5 * (low + high)), 0.5 * (high - low)
    turn = complex(lean, -1.0) / np.sqrt(1.0 + lean * lean)
    for a in range(n):
        p = parts.order[a]
        for x in range(parts.begins[a], parts.begins[a + 1]):
            matrix[p, parts.later[x]] = matrix[parts.later[x], p] = 0.0
        own = turn * ((loop.mass[p] * s + loop.drag[p]) * s + loop.rigid[p])
        moved = np.abs(complex(2.0 * loop.mass[p] * line + loop.drag[p], 2.0 * loop.mass[p] * high))
        matrix[p, p] = own.real - half * moved
    for e in range(len(loop.first)):
        i, j = loop.first[e], loop.second[e]
        forth = turn * loop.spring[e] * np.exp(-s * loop.to_first[e])
        back = turn * loop.spring[e] * np.exp(-s * loop.to_second[e])
        both = 0.5 * (forth + back.conjugate())
        matrix[i, j] -= both
        matrix[j, i] -= both.conjugate()
        moved = 0.5 * half * (loop.to_first[e] * np.abs(forth) + loop.to_second[e] * np.abs(back))
        matrix[i, i] -= moved
        matrix[j, j] -= moved
    for a in range(n):
        p = parts.order[a]
        pivot = matrix[p, p].real
        if not pivot > _POSITIVE * np.abs(loop.rigid[p]):
            return False
        for x in range(parts.begins[a], parts.begins[a + 1]):
            i = parts.later[x]
            factor = matrix[i, p] / pivot
            for y in range(parts.begins[a], parts.begins[a + 1]):
                matrix[i, parts.later[y]] -= factor * matrix[p, parts.later[y]]
    return True
