"""The characteristic matrix of a delayed loop, in compiled form: its determinant's slope, its turn, its roots.

`G(s) = diag(m_i s² + b_i s + k_i) - K_ij e^(-s d_ij)` serves two models: the closed loop of all copies, and with
`m = b = 0, k_i = sum_j K_ij` the first-order consensus, whose eigenvalues are `e^(s h)` for time unit h.
"""

from typing import NamedTuple

import numpy as np

from cotouch.compiled import routine, subroutine
from cotouch.network._network import Network
from cotouch.network._types import ComplexArray, FloatArray, IntArray

# Share of a safe step that is taken: the determinant turns less than half a turn in it, whatever it does between.
_SAFE = 0.5
# Products that sharpen the safe step.
_POWERS = 2
_NEWTON_STEPS = 40
# Newton's last step, beside the root; and a step that rounding keeps from getting smaller.
_ARRIVED, _ROUGH = 1e-13, 1e-8
# Roots this close together, beside their size, count as one of several copies.
_CLUSTER = 1e-6


class Loop(NamedTuple):
    """One loop, link by link.

    Attributes:
        mass: m_i, (N,).
        drag: b_i, (N,).
        rigid: k_i, (N,), the springs of the links included.
        first: one end i of each link, (E,).
        second: the other end j, (E,).
        spring: K_ij, (E,).
        to_first: d_ij in s, the delay from j to i, (E,).
        to_second: d_ji in s, (E,).
    """

    mass: FloatArray
    drag: FloatArray
    rigid: FloatArray
    first: IntArray
    second: IntArray
    spring: FloatArray
    to_first: FloatArray
    to_second: FloatArray


def loop_of(network: Network, *, mass: FloatArray, drag: FloatArray, ground: FloatArray) -> Loop:
    """The loop that the links of a network close.

    Args:
        network: springs count as scalars.
        mass: (N,).
        drag: (N,).
        ground: (N,), to which the springs of the links are added.
    """
    pairs = np.array(network.links, dtype=np.int64).reshape(-1, 2)
    first, second = np.ascontiguousarray(pairs[:, 0]), np.ascontiguousarray(pairs[:, 1])
    return Loop(
        mass=mass,
        drag=drag,
        rigid=ground + network.linked_spring().sum(axis=1),
        first=first,
        second=second,
        spring=network.spring[first, second],
        to_first=network.delay[first, second],
        to_second=network.delay[second, first],
    )


def characteristic(loop: Loop, s: complex) -> ComplexArray:
    """G(s), (N, N)."""
    matrix = np.diag((loop.mass * s + loop.drag) * s + loop.rigid).astype(np.complex128)
    matrix[loop.first, loop.second] = -loop.spring * np.exp(-s * loop.to_first)
    matrix[loop.second, loop.first] = -loop.spring * np.exp(-s * loop.to_second)
    return matrix


@subroutine
def _sizes(loop: Loop, line: float, sizes: FloatArray) -> None:
    """`K_ij e^(-σ d)` of both directions of every link, which do not change along a line."""
    for e in range(len(loop.first)):
        sizes[0, e] = loop.spring[e] * np.exp(-line * loop.to_first[e])
        sizes[1, e] = loop.spring[e] * np.exp(-line * loop.to_second[e])


@subroutine
def _fill(loop: Loop, s: complex, sizes: FloatArray, matrix: ComplexArray, slope: ComplexArray) -> None:
    """G(s), and its slope: on the diagonal in row 0 of `slope`, of the links in rows 1 (i, j) and 2 (j, i)."""
    n = len(loop.mass)
    for i in range(n):
        for j in range(n):
            matrix[i, j] = 0.0
        matrix[i, i] = (loop.mass[i] * s + loop.drag[i]) * s + loop.rigid[i]
        slope[0, i] = 2.0 * loop.mass[i] * s + loop.drag[i]
    for e in range(len(loop.first)):
        i, j = loop.first[e], loop.second[e]
        a, b = s.imag * loop.to_first[e], s.imag * loop.to_second[e]
        forth = complex(sizes[0, e] * np.cos(a), -sizes[0, e] * np.sin(a))
        back = complex(sizes[1, e] * np.cos(b), -sizes[1, e] * np.sin(b))
        matrix[i, j] -= forth
        matrix[j, i] -= back
        slope[1, e] = loop.to_first[e] * forth
        slope[2, e] = loop.to_second[e] * back


@subroutine
def _invert(matrix: ComplexArray) -> complex:
    """Inverts in place (Gauss-Jordan, pivots by rows); returns the phase of the determinant, 0 where it is singular."""
    n = len(matrix)
    order = np.empty(n, np.int64)
    phase = 1.0 + 0.0j
    for c in range(n):
        pivot, size = c, -1.0
        for r in range(c, n):
            here = matrix[r, c].real ** 2 + matrix[r, c].imag ** 2
            if here > size:
                pivot, size = r, here
        order[c] = pivot
        if not size > 0.0:
            return 0.0 + 0.0j
        if pivot != c:
            phase = -phase
            for k in range(n):
                matrix[c, k], matrix[pivot, k] = matrix[pivot, k], matrix[c, k]
        value = matrix[c, c]
        phase = phase * value / np.sqrt(size)
        over = complex(value.real / size, -value.imag / size)
        matrix[c, c] = 1.0
        for k in range(n):
            matrix[c, k] = matrix[c, k] * over
        for r in range(n):
            if r != c:
                factor = matrix[r, c]
                if factor.real != 0.0 or factor.imag != 0.0:
                    matrix[r, c] = 0.0
                    for k in range(n):
                        matrix[r, k] = matrix[r, k] - factor * matrix[c, k]
    for back in range(n):
        c = n - 1 - back
        pivot = order[c]
        if pivot != c:
            for r in range(n):
                matrix[r, c], matrix[r, pivot] = matrix[r, pivot], matrix[r, c]
    return phase


@subroutine
def reciprocal(value: complex) -> complex:
    """1/value; of zero something as large as makes no difference, where Python would raise."""
    if value == 0.0:
        return 1e300 + 0.0j
    return 1.0 / value


@subroutine
def _speed(loop: Loop, inverse: ComplexArray, slope: ComplexArray) -> complex:
    """Logarithmic derivative of the determinant, `tr(G⁻¹ G')`."""
    result = 0.0 + 0.0j
    for i in range(len(loop.mass)):
        result += inverse[i, i] * slope[0, i]
    for e in range(len(loop.first)):
        i, j = loop.first[e], loop.second[e]
        result += inverse[j, i] * slope[1, e] + inverse[i, j] * slope[2, e]
    return result


@subroutine
def _reach(loop: Loop, inverse: ComplexArray, slope: ComplexArray, room: FloatArray) -> float:
    """How far from here along a line of constant real part the determinant surely keeps a clear phase.

    `G(s + iτ) = G(s)(I + X E)` with `X = G(s)⁻¹` and `|E| <= |slope| τ + m τ²` entry by entry, because
    `|e^(-iτd) - 1| <= τ d`. As long as the spectral radius of `|X||E|` stays below `_SAFE`, no eigenvalue of `I + X E`
    comes near zero. For any u > 0 that radius is at most the largest ratio of `|X||E| u` to u (Collatz and Wielandt);
    u is what two products make of ones.

    Args:
        loop: the loop.
        inverse: X.
        slope: as `_fill` leaves it.
        room: scratch, (N + 4, N).
    """
    n, links = len(loop.mass), len(loop.first)
    u, pull, heavy = room[n], room[n + 1], room[n + 2]
    worst, most, least = 0.0, 0.0, 0.0
    for i in range(n):
        u[i] = 1.0
        for k in range(n):
            room[i, k] = np.sqrt(inverse[i, k].real ** 2 + inverse[i, k].imag ** 2)
    for turn in range(_POWERS):
        for i in range(n):
            pull[i] = np.abs(slope[0, i]) * u[i]
            heavy[i] = loop.mass[i] * u[i]
        for e in range(links):
            i, j = loop.first[e], loop.second[e]
            pull[i] += np.abs(slope[1, e]) * u[j]
            pull[j] += np.abs(slope[2, e]) * u[i]
        worst, most, largest = 0.0, 0.0, 0.0
        for i in range(n):
            total, size = 0.0, 0.0
            for k in range(n):
                total += room[i, k] * pull[k]
                size += room[i, k] * heavy[k]
            worst, most, largest = max(worst, total / u[i]), max(most, size / u[i]), max(largest, total)
            room[n + 3, i] = total
        if turn + 1 < _POWERS:
            least = 1e-3 * largest
            for i in range(n):
                u[i] = room[n + 3, i] + least
    # worst τ + most τ² = _SAFE
    return 2.0 * _SAFE / (worst + np.sqrt(worst * worst + 4.0 * most * _SAFE))


@routine
def walk(loop: Loop, line: float, low: float, high: float, most: int, starts: ComplexArray) -> tuple[float, int, int]:
    """Turn of the determinant's phase from `line + i low` to `line + i high`, in steps that cannot lose a turn.

    Args:
        loop: the loop.
        line: real part.
        low: first imaginary part.
        high: last one.
        most: number of steps after which to give up.
        starts: filled with Newton's next points from where the determinant is locally smallest.

    Returns:
        The turn in radians (NaN if given up or a root is met), the number of steps, the number of starts.
    """
    n = len(loop.mass)
    matrix, slope = np.empty((n, n), np.complex128), np.empty((3, max(n, len(loop.first))), np.complex128)
    sizes = np.empty((2, len(loop.first)))
    room = np.empty((n + 4, n))
    _sizes(loop, line, sizes)
    # Over a step log det moves by tr(X E) but for N ρ² / (2 (1 - ρ)), which with ρ < 1/√N is less than half a turn.
    careful = min(1.0, 2.0 / np.sqrt(n))
    turn, count, steps, stride = 0.0, 0, 0, 0.0
    here, phase, speed = low, 0.0 + 0.0j, 0.0 + 0.0j
    nearest, falling = 0.0 + 0.0j, False
    while True:
        s = complex(line, here)
        _fill(loop, s, sizes, matrix, slope)
        last, old = phase, speed
        phase = _invert(matrix)
        if phase == 0.0:
            return np.nan, steps, count
        speed = _speed(loop, matrix, slope)
        if steps > 0:
            change = phase * last.conjugate()
            exact = np.arctan2(change.imag, change.real)
            expected = 0.5 * stride * (speed.real + old.real)
            turn += exact + 2.0 * np.pi * np.round((expected - exact) / (2.0 * np.pi))
        closer = np.abs(speed) > np.abs(old)
        if falling and not closer and count < len(starts):
            starts[count] = nearest
            count += 1
        falling, nearest = closer, s - reciprocal(speed)
        if not here < high:
            break
        stride = min(careful * _reach(loop, matrix, slope, room), high - here)
        if steps >= most or not here + stride > here:
            return np.nan, steps, count
        here = here + stride
        steps += 1
    if falling and count < len(starts):
        starts[count] = nearest
        count += 1
    return turn, steps, count


@routine
def polish(
    loop: Loop, start: complex, scale: float, known: ComplexArray, copies: IntArray, found: int
) -> tuple[complex, bool]:
    """Newton on the determinant over the roots that are known, from `start`.

    Args:
        loop: the loop.
        start: where to begin.
        scale: a rate of the loop in 1/s, against which steps count as small.
        known: roots (and, implied, their conjugates) to keep away from.
        copies: how many roots coincide at each.
        found: how many of them there are.

    Returns:
        The root with Im >= 0, and whether Newton arrived.
    """
    n = len(loop.mass)
    matrix, slope = np.empty((n, n), np.complex128), np.empty((3, max(n, len(loop.first))), np.complex128)
    sizes = np.empty((2, len(loop.first)))
    s, last, before, several = start, np.inf, 0.0, 1.0
    for _ in range(_NEWTON_STEPS):
        _sizes(loop, s.real, sizes)
        _fill(loop, s, sizes, matrix, slope)
        if _invert(matrix) == 0.0:
            return s, True
        speed = _speed(loop, matrix, slope)
        for f in range(found):
            speed -= copies[f] * reciprocal(s - known[f])
            if known[f].imag != 0.0:
                speed -= copies[f] * reciprocal(s - known[f].conjugate())
        step = several * reciprocal(speed)
        size, limit = np.abs(step), 0.5 * (np.abs(s) + scale)
        if not size < np.inf:
            return s, False
        if size > limit:
            step, size = step * (limit / size), limit
        s = s - step
        here = np.abs(s) + scale
        if size <= _ARRIVED * here or (size <= _ROUGH * here and size >= last):
            if np.abs(s.imag) <= _ROUGH * here:
                s = complex(s.real, 0.0)
            return complex(s.real, np.abs(s.imag)), True
        # Newton nears a root of c copies by the share 1 - 1/c each time; c times the step is quick again.
        ratio = size / last
        if several == 1.0 and 0.4 < ratio < 0.95 and np.abs(ratio - before) < 0.02 * ratio and size < 0.1 * here:
            several = np.round(1.0 / (1.0 - ratio))
        elif ratio > 1.0:
            several = 1.0
        last, before = size, ratio
    return s, False


@subroutine
def standing(loop: Loop, s: complex, normalised: bool) -> float:
    """Phase of det G(s) where no root is near, without ambiguity: the sum of the phases of the pivots.

    Where the Hermitian part of G is positive definite so is that of every Schur complement, so each pivot keeps to the
    right half plane and the sum is continuous all over such a region; the same holds for G over its diagonal
    (`normalised`) where the diagonal dominates.
    """
    n = len(loop.mass)
    matrix, slope = np.empty((n, n), np.complex128), np.empty((3, max(n, len(loop.first))), np.complex128)
    sizes = np.empty((2, len(loop.first)))
    _sizes(loop, s.real, sizes)
    _fill(loop, s, sizes, matrix, slope)
    phase = 0.0
    for c in range(n):
        if normalised:
            own = (loop.mass[c] * s + loop.drag[c]) * s + loop.rigid[c]
            for k in range(n):
                matrix[c, k] = matrix[c, k] / own
    for c in range(n):
        pivot = matrix[c, c]
        phase += np.arctan2(pivot.imag, pivot.real)
        for r in range(c + 1, n):
            factor = matrix[r, c] / pivot
            for k in range(c + 1, n):
                matrix[r, k] = matrix[r, k] - factor * matrix[c, k]
    return phase


@routine
def keep(loop: Loop, root: complex, scale: float, known: ComplexArray, copies: IntArray, found: int) -> int:
    """Adds a root to those that are known, with the number of roots that coincide there; returns how many are known.

    The logarithmic derivative of the determinant around a point counts the roots in a small circle.
    """
    radius = _CLUSTER * (np.abs(root) + scale)
    if found == len(known):
        return found
    for f in range(found):
        if np.abs(known[f] - root) <= 2.0 * radius:
            return found
    n = len(loop.mass)
    matrix, slope = np.empty((n, n), np.complex128), np.empty((3, max(n, len(loop.first))), np.complex128)
    sizes = np.empty((2, len(loop.first)))
    for points in (2, 16):
        counted = 0.0 + 0.0j
        for p in range(points):
            away = radius * np.exp(2j * np.pi * (p + 0.5) / points)
            _sizes(loop, (root + away).real, sizes)
            _fill(loop, root + away, sizes, matrix, slope)
            _invert(matrix)
            counted += away * _speed(loop, matrix, slope) / points
        if np.abs(counted - np.round(counted.real)) < 0.01:
            break
    if not counted.real > 0.5:
        return found
    known[found], copies[found] = root, int(np.round(counted.real))
    return found + 1
