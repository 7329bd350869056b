"""Elimination of most users from the characteristic matrix of a delayed loop, in compiled form.

Right of a line of constant real part σ, all but a few users can be eliminated for certain. Let R be users whose own
`D_i(s) = m_i s² + b_i s + k_i` has real roots left of σ, such that `G(σ)` on R is an M-matrix, which Gaussian
elimination itself tells: all pivots are positive. Then `1 / D_i` and the delays are transforms of non-negative kernels,
`|G_RR(s)⁻¹| <= G_RR(σ)⁻¹` entry by entry wherever Re s >= σ, no root of G_RR lies there, and the roots of G are those
of the small matrix F that is left for the users who are kept. In a sparse network of hundreds of users those are few,
and the others cost hardly more than their links.
"""

from typing import NamedTuple

import numpy as np

from cotouch.arrays import Complex, Float, Long
from cotouch.compiled import routine, subroutine
from cotouch.network._loop import Loop

# A user is kept where elimination leaves less than this share of its own term: bounds beyond it get too coarse. At 0.3
# a walk past 100 users takes ten times as many steps.
REGULAR = 0.6


class Elimination(NamedTuple):
    """Who is eliminated, in which order, and who is kept.

    Attributes:
        order: users, the eliminated ones first, (N,).
        gone: how many are eliminated.
        begins: where the later neighbours of each eliminated user begin, (gone + 1,).
        later: users joined to it when it is eliminated, itself aside.
        first_root: -p of the root of `D_i` nearer to 0, 1/s, (N,); inf where it has none.
        other_root: likewise of the other one.
    """

    order: Long
    gone: int
    begins: Long
    later: Long
    first_root: Float
    other_root: Float


class EliminationScratch(NamedTuple):
    """Room for one elimination of a complex matrix and its slope.

    Attributes:
        matrix: G, then its factors and F, (N, N).
        slope: dG/ds, then that of F, (N, N).
        left: F of the users kept, in their order, (n, n).
        moved: its slope, (n, n).
        inverse: F⁻¹, (n, n).
    """

    matrix: Complex
    slope: Complex
    left: Complex
    moved: Complex
    inverse: Complex


@subroutine
def _own_roots(loop: Loop, first: Float, other: Float) -> None:
    """Magnitudes of the roots of every `D_i` where both are real and at most 0; NaN where they are not real."""
    for i in range(len(loop.mass)):
        m, b, k = loop.mass[i], loop.drag[i], loop.rigid[i]
        inside = b * b - 4.0 * m * k
        first[i] = other[i] = np.inf
        if inside < 0.0:
            first[i] = other[i] = np.nan
        elif b > 0.0:
            larger = 0.5 * (b + np.sqrt(inside))
            first[i] = k / larger
            if m > 0.0:
                other[i] = larger / m
        elif m > 0.0:
            first[i] = other[i] = 0.0


@routine
def cut(loop: Loop, line: float, regular: float) -> Elimination:
    """Chooses who is eliminated right of a line: those with the fewest neighbours first, as long as pivots allow it.

    Args:
        loop: the loop.
        line: σ, 1/s.
        regular: share of its own term that elimination must leave a user, in (0, 1); -inf eliminates everybody, for
            `negatives`.
    """
    n = len(loop.mass)
    first, other = np.empty(n), np.empty(n)
    _own_roots(loop, first, other)
    matrix, joined = np.zeros((n, n)), np.zeros((n, n), np.bool_)
    own, degree = np.empty(n), np.zeros(n, np.int64)
    for i in range(n):
        own[i] = matrix[i, i] = (loop.mass[i] * line + loop.drag[i]) * line + loop.rigid[i]
    for e in range(len(loop.first)):
        i, j = loop.first[e], loop.second[e]
        matrix[i, j] -= loop.spring[e] * np.exp(-line * loop.to_first[e])
        matrix[j, i] -= loop.spring[e] * np.exp(-line * loop.to_second[e])
        if not joined[i, j]:
            joined[i, j] = joined[j, i] = True
            degree[i] += 1
            degree[j] += 1
    # 0: not yet looked at; 1: eliminated; 2: kept.
    state, order = np.zeros(n, np.int64), np.empty(n, np.int64)
    begins, later = np.zeros(n + 1, np.int64), np.empty(n * (n - 1) // 2 + n, np.int64)
    gone, count = 0, 0
    for _ in range(n):
        p = -1
        for i in range(n):
            if state[i] == 0 and (p < 0 or degree[i] < degree[p]):
                p = i
        # NaN compares as not regular, so users that ring are kept.
        certain = min(first[p], other[p]) > -line and matrix[p, p] > regular * own[p]
        if not (certain or regular == -np.inf):
            state[p] = 2
            continue
        begin = count
        for q in range(n):
            if joined[p, q] and state[q] != 1:
                later[count] = q
                count += 1
        for a in range(begin, count):
            i = later[a]
            factor = matrix[i, p] / matrix[p, p]
            for b in range(begin, count):
                j = later[b]
                matrix[i, j] -= factor * matrix[p, j]
                if i != j and not joined[i, j]:
                    joined[i, j] = joined[j, i] = True
                    degree[i] += 1
                    degree[j] += 1
            degree[i] -= 1
        state[p] = 1
        order[gone] = p
        gone += 1
        begins[gone] = count
    kept = gone
    for i in range(n):
        if state[i] == 2:
            order[kept] = i
            kept += 1
    return Elimination(order, gone, begins[: gone + 1], later[:count], first, other)


@routine
def scratch(size: int, kept: int) -> EliminationScratch:
    """Room for `size` users of whom `kept` are kept.

    Args:
        size: users.
        kept: of these.
    """
    return EliminationScratch(
        np.zeros((size, size), np.complex128),
        np.zeros((size, size), np.complex128),
        np.empty((kept, kept), np.complex128),
        np.empty((kept, kept), np.complex128),
        np.empty((kept, kept), np.complex128),
    )


@subroutine
def _fill(loop: Loop, parts: Elimination, s: complex, matrix: Complex, slope: Complex) -> None:
    """G(s) and its slope, where elimination is going to look."""
    n = len(loop.mass)
    for a in range(parts.gone):
        p = parts.order[a]
        for x in range(parts.begins[a], parts.begins[a + 1]):
            j = parts.later[x]
            matrix[p, j] = matrix[j, p] = slope[p, j] = slope[j, p] = 0.0
    for a in range(parts.gone, n):
        for b in range(parts.gone, n):
            i, j = parts.order[a], parts.order[b]
            matrix[i, j] = slope[i, j] = 0.0
    for i in range(n):
        matrix[i, i] = (loop.mass[i] * s + loop.drag[i]) * s + loop.rigid[i]
        slope[i, i] = 2.0 * loop.mass[i] * s + loop.drag[i]
    for e in range(len(loop.first)):
        i, j = loop.first[e], loop.second[e]
        forth = loop.spring[e] * np.exp(-s * loop.to_first[e])
        back = loop.spring[e] * np.exp(-s * loop.to_second[e])
        matrix[i, j] -= forth
        matrix[j, i] -= back
        slope[i, j] += loop.to_first[e] * forth
        slope[j, i] += loop.to_second[e] * back


@subroutine
def invert(matrix: Complex, inverse: Complex) -> complex:
    """Inverts (Gauss-Jordan, pivots by rows); the phase of the determinant, 0 where it is singular.

    Real and imaginary parts lie apart, so that the loops become vector instructions.

    Args:
        matrix: (n, n).
        inverse: filled, (n, n).
    """
    n = len(matrix)
    re, im = matrix.real.copy(), matrix.imag.copy()
    order = np.empty(n, np.int64)
    phase = 1.0 + 0.0j
    for c in range(n):
        pivot, size = c, -1.0
        for r in range(c, n):
            here = re[r, c] ** 2 + im[r, c] ** 2
            if here > size:
                pivot, size = r, here
        order[c] = pivot
        if not size > 0.0:
            return 0.0 + 0.0j
        if pivot != c:
            phase = -phase
            for k in range(n):
                re[c, k], re[pivot, k] = re[pivot, k], re[c, k]
                im[c, k], im[pivot, k] = im[pivot, k], im[c, k]
        phase = phase * complex(re[c, c], im[c, c]) / np.sqrt(size)
        u, v = re[c, c] / size, -im[c, c] / size
        re[c, c], im[c, c] = 1.0, 0.0
        for k in range(n):
            x = re[c, k]
            re[c, k] = x * u - im[c, k] * v
            im[c, k] = x * v + im[c, k] * u
        for r in range(n):
            u, v = re[r, c], im[r, c]
            if r != c and (u != 0.0 or v != 0.0):
                re[r, c], im[r, c] = 0.0, 0.0
                for k in range(n):
                    re[r, k] -= u * re[c, k] - v * im[c, k]
                    im[r, k] -= u * im[c, k] + v * re[c, k]
    for back in range(n):
        c = n - 1 - back
        pivot = order[c]
        if pivot != c:
            for r in range(n):
                re[r, c], re[r, pivot] = re[r, pivot], re[r, c]
                im[r, c], im[r, pivot] = im[r, pivot], im[r, c]
    for r in range(n):
        for c in range(n):
            inverse[r, c] = complex(re[r, c], im[r, c])
    return phase


@routine
def evaluate(loop: Loop, parts: Elimination, s: complex, room: EliminationScratch) -> tuple[complex, float, complex]:
    """G(s) with all but a few users eliminated; leaves `moved` (dF/ds) and `inverse` (F⁻¹) in the scratch.

    Args:
        loop: the loop.
        parts: who is eliminated, chosen for a line at or left of s.
        s: where, 1/s.
        room: scratch.

    Returns:
        The phase of det F as a unit number (0 where it is singular); the phase in radians, continuous all over the half
        plane right of the line, of the determinant on the users eliminated; and the logarithmic slope of det G, s.
    """
    matrix, slope = room.matrix, room.slope
    _fill(loop, parts, s, matrix, slope)
    phase, speed = 0.0, 0.0 + 0.0j
    for a in range(parts.gone):
        p = parts.order[a]
        # The pivot keeps to the right half plane about its own term, whose phase is that of its two real roots.
        own = (loop.mass[p] * s + loop.drag[p]) * s + loop.rigid[p]
        over = 1.0 / matrix[p, p]
        turned = matrix[p, p] * own.conjugate()
        phase += np.arctan2(turned.imag, turned.real)
        for root in (parts.first_root[p], parts.other_root[p]):
            if root < np.inf:
                phase += np.arctan2(s.imag, s.real + root)
        speed += slope[p, p] * over
        for x in range(parts.begins[a], parts.begins[a + 1]):
            i = parts.later[x]
            factor = matrix[i, p] * over
            bend = (slope[i, p] - factor * slope[p, p]) * over
            for y in range(parts.begins[a], parts.begins[a + 1]):
                j = parts.later[y]
                matrix[i, j] -= factor * matrix[p, j]
                slope[i, j] -= bend * matrix[p, j] + factor * slope[p, j]
    kept = len(loop.mass) - parts.gone
    for a in range(kept):
        for b in range(kept):
            i, j = parts.order[parts.gone + a], parts.order[parts.gone + b]
            room.left[a, b], room.moved[a, b] = matrix[i, j], slope[i, j]
    turn = invert(room.left, room.inverse)
    for a in range(kept):
        for b in range(kept):
            speed += room.inverse[a, b] * room.moved[b, a]
    return turn, float(phase), complex(speed)


@subroutine
def largest(
    loop: Loop, parts: Elimination, line: float, frequency: float, aside: float, matrix: Float, out: Float
) -> bool:
    """Majorant of what elimination adds to the users kept, `H = D - F`, on a line beyond a frequency.

    With θ = `aside` its derivatives in θ at 0 bound those of H in s, entry by entry, at any `σ + iω` with ω at least
    `frequency`: `1 / D_i` has kernels whose transforms are at most `1 / (|s + p| - θ)` for each of its roots -p, and
    `|K e^(-sd)|` at most `K e^((θ - σ) d)`. So H moves over a step iτ by at most `H(τ) - H(0)`.

    Args:
        loop: the loop.
        parts: who is eliminated, chosen for the line.
        line: σ.
        frequency: ω, at least 0.
        aside: θ, may be negative.
        matrix: scratch, (N, N).
        out: filled, (n, n).

    Returns:
        Whether the series converges there.
    """
    n = len(loop.mass)
    for a in range(parts.gone):
        p = parts.order[a]
        for x in range(parts.begins[a], parts.begins[a + 1]):
            j = parts.later[x]
            matrix[p, j] = matrix[j, p] = 0.0
        size = loop.mass[p] if loop.mass[p] > 0.0 else (loop.drag[p] if loop.drag[p] > 0.0 else loop.rigid[p])
        for root in (parts.first_root[p], parts.other_root[p]):
            if root < np.inf:
                away = np.sqrt((line + root) * (line + root) + frequency * frequency) - aside
                if not away > 0.0:
                    return False
                size *= away
        matrix[p, p] = size
    for a in range(parts.gone, n):
        for b in range(parts.gone, n):
            matrix[parts.order[a], parts.order[b]] = 0.0
    for e in range(len(loop.first)):
        i, j = loop.first[e], loop.second[e]
        matrix[i, j] -= loop.spring[e] * np.exp((aside - line) * loop.to_first[e])
        matrix[j, i] -= loop.spring[e] * np.exp((aside - line) * loop.to_second[e])
    for a in range(parts.gone):
        p = parts.order[a]
        if not matrix[p, p] > 0.0:
            return False
        over = 1.0 / matrix[p, p]
        for x in range(parts.begins[a], parts.begins[a + 1]):
            i = parts.later[x]
            factor = matrix[i, p] * over
            for y in range(parts.begins[a], parts.begins[a + 1]):
                j = parts.later[y]
                matrix[i, j] -= factor * matrix[p, j]
    kept = n - parts.gone
    for a in range(kept):
        for b in range(kept):
            out[a, b] = -matrix[parts.order[parts.gone + a], parts.order[parts.gone + b]]
    return True
