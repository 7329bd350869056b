"""Turn of the determinant of a delayed loop along a line, and its roots by Newton, in compiled form."""

import numpy as np

from cotouch.arrays import Complex, Float, Long
from cotouch.compiled import raised, routine, subroutine
from cotouch.network._elimination import REGULAR, Elimination, EliminationScratch, cut, evaluate, largest, scratch
from cotouch.network._loop import Loop

# Spectral radius, at most, of what a step adds to the identity; radians, at most, by which its turn is uncertain.
_SAFE, _UNCERTAIN = 0.8, 3.0
# Products that sharpen the safe step.
_POWERS = 4
# Bounds are worked out anew when the frequency has grown by this factor and this share of the line's distance from 0.
_STALE, _SOON = 1.1, 0.1
# The first and the largest reach of a bound, beside the longest delay; and the step that tells its slope.
_FIRST, _FURTHEST, _SLOPE = 0.5, 2.0, 1e-5
_NEWTON_STEPS = 60
# Newton's last step, beside the root; and a step that rounding keeps from getting smaller.
_ARRIVED, _ROUGH = 1e-13, 1e-8
# Steps smaller than this, beside the root, may be drawn out.
_CLOSE = 2e-3
# Roots this close together, beside their size, count as one of several copies.
_CLUSTER = 1e-6
# Newton eliminates for a line so far left of where it is, beside the rate of the loop and the distance from 0.
_MARGIN = 0.1


@subroutine
def reciprocal(value: complex) -> complex:
    """1/value; of zero something as large as makes no difference, where Python would raise."""
    if value == 0.0:
        return 1e300 + 0.0j
    return 1.0 / value


@subroutine
def _remainder(
    loop: Loop, parts: Elimination, line: float, frequency: float, wanted: float, matrix: Float, out: Float
) -> float:
    """Bounds F's departure from its tangent: over a step iτ, |τ| at most the reach, by `out` τ², entry by entry.

    Returns:
        The reach, at most as far as wanted, 1/s.
    """
    kept = len(out)
    here, before, there = np.empty((kept, kept)), np.empty((kept, kept)), np.empty((kept, kept))
    slight = _SLOPE * wanted
    largest(loop, parts, line, frequency, 0.0, matrix, here)
    largest(loop, parts, line, frequency, -slight, matrix, before)
    reach = wanted
    while not largest(loop, parts, line, frequency, reach, matrix, there):
        reach *= 0.5
    # The majorant is convex: its slope at 0 is at least that before it, and what is left grows faster than τ².
    for a in range(kept):
        for b in range(kept):
            rest = there[a, b] - here[a, b] - reach * (here[a, b] - before[a, b]) / slight
            out[a, b] = max(rest, 0.0) / (reach * reach) + 1e-9 * here[a, b] / (reach * reach)
        out[a, a] += loop.mass[parts.order[parts.gone + a]]
    return reach


@subroutine
def _stride(room: EliminationScratch, bound: Float, reach: float, spare: Float) -> float:
    """How far from here along the line the determinant surely keeps a clear phase.

    `F(s + iτ) = F(s) (I + iτ M + X R)` with `X = F(s)⁻¹`, `M = X F'(s)` and `|R| <= bound τ²`. As long as the spectral
    radius of `P = τ |M| + τ² |X| bound` is below 1 no eigenvalue reaches zero; for any u > 0 it is at most the largest
    ratio of `P u` to u (Collatz and Wielandt). The turn is that of `τ tr M` but for at most the trace of `|X| bound τ²`
    and the higher powers of P, whose traces the Frobenius norm bounds.

    Args:
        room: holds X and F'.
        bound: see `_remainder`.
        reach: of the bound.
        spare: scratch, (2n + 2, n).
    """
    n = len(bound)
    straight, bent, u, grown = spare[:n], spare[n : 2 * n], spare[2 * n], spare[2 * n + 1]
    sizes = np.abs(room.inverse)
    re, im = room.moved.real.copy(), room.moved.imag.copy()
    real, imaginary = np.empty(n), np.empty(n)
    for a in range(n):
        u[a] = 1.0
        for b in range(n):
            real[b] = imaginary[b] = bent[a, b] = 0.0
        for c in range(n):
            x, y, size = room.inverse[a, c].real, room.inverse[a, c].imag, sizes[a, c]
            for b in range(n):
                real[b] += x * re[c, b] - y * im[c, b]
                imaginary[b] += x * im[c, b] + y * re[c, b]
                bent[a, b] += size * bound[c, b]
        for b in range(n):
            straight[a, b] = np.sqrt(real[b] * real[b] + imaginary[b] * imaginary[b])
    step = reach
    for turn in range(_POWERS):
        most, shortest = 0.0, reach
        for a in range(n):
            first, second = 0.0, 0.0
            for b in range(n):
                first += straight[a, b] * u[b]
                second += bent[a, b] * u[b]
            grown[a] = first + step * second
            most = max(most, grown[a])
            first, second = first / u[a], second / u[a]
            # first τ + second τ² = _SAFE
            if first > 0.0 or second > 0.0:
                shortest = min(shortest, 2.0 * _SAFE / (first + np.sqrt(first * first + 4.0 * second * _SAFE)))
        step = shortest
        if turn + 1 < _POWERS and most > 0.0:
            for a in range(n):
                u[a] = grown[a] / most + 1e-3
    while True:
        trace, square = 0.0, 0.0
        for a in range(n):
            trace += bent[a, a]
            for b in range(n):
                entry = step * (straight[a, b] + step * bent[a, b]) * u[b] / u[a]
                square += entry * entry
        if step * step * trace + square / (2.0 * (1.0 - _SAFE)) < _UNCERTAIN:
            return step
        step *= 0.8


@routine
def walk(loop: Loop, line: float, low: float, high: float, most: int, starts: Complex) -> tuple[float, int, int]:
    """Turn of the determinant's phase from `line + i low` to `line + i high`, in steps that cannot lose a turn.

    Args:
        loop: the loop.
        line: real part.
        low: first imaginary part, at least 0.
        high: last one.
        most: number of steps after which to give up.
        starts: filled with Newton's next points from where the determinant is locally smallest.

    Returns:
        The turn in radians (NaN if given up or a root is met), the number of steps, the number of starts.
    """
    n = len(loop.mass)
    parts = cut(loop, line, REGULAR)
    kept = n - parts.gone
    room = scratch(n, kept)
    matrix, bound, spare = np.zeros((n, n)), np.empty((kept, kept)), np.empty((2 * kept + 2, kept))
    longest = 0.0
    for e in range(len(loop.first)):
        longest = max(longest, loop.to_first[e], loop.to_second[e])
    furthest = _FURTHEST / longest if longest > 0.0 else max(high - low, 1.0)
    wanted = min(_FIRST / _FURTHEST * furthest, furthest)
    turn, count, steps = 0.0, 0, 0
    here, fresh, reach, stride, expected = low, -1.0, 0.0, 0.0, 0.0
    phase, speed, began = 0.0 + 0.0j, 0.0 + 0.0j, 0.0
    nearest, falling = 0.0 + 0.0j, False
    while True:
        s = complex(line, here)
        last, old = phase, speed
        phase, aside, speed = evaluate(loop, parts, s, room)
        if phase == 0.0:
            return np.nan, steps, count
        if steps == 0:
            began = aside
        else:
            change = phase * last.conjugate()
            exact: float = np.arctan2(change.imag, change.real)
            turn += exact + 2.0 * np.pi * np.round((expected - exact) / (2.0 * np.pi))
        closer = np.abs(speed) > np.abs(old)
        if falling and not closer and count < len(starts):
            starts[count] = nearest
            count += 1
        falling, nearest = closer, s - reciprocal(speed)
        if not here < high:
            turn += aside - began
            break
        if fresh < 0.0 or here > _STALE * fresh + _SOON * np.abs(line):
            reach = _remainder(loop, parts, line, here, wanted, matrix, bound)
            fresh, wanted = here, min(2.0 * reach, furthest)
        stride = min(_stride(room, bound, reach, spare), high - here)
        if steps >= most or not here + stride > here or raised(loop.stop):
            return np.nan, steps, count
        expected = 0.0
        for a in range(kept):
            for b in range(kept):
                expected += (room.inverse[a, b] * room.moved[b, a]).real * stride
        here = here + stride if stride < high - here else high
        steps += 1
    if falling and count < len(starts):
        starts[count] = nearest
        count += 1
    return turn, steps, count


@subroutine
def _standpoint(real: float, scale: float) -> float:
    """A line left of where Newton is."""
    return real - _MARGIN * (np.abs(real) + 0.01 * scale)


@routine
def polish(loop: Loop, start: complex, scale: float, known: Complex, copies: Long, found: int) -> tuple[complex, bool]:
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
    s, last, before, several = start, np.inf, 0.0, 1.0
    line = _standpoint(s.real, scale)
    parts = cut(loop, line, REGULAR)
    room = scratch(n, n - parts.gone)
    for _ in range(_NEWTON_STEPS):
        if s.real < line:
            line = _standpoint(s.real, scale)
            parts = cut(loop, line, REGULAR)
            room = scratch(n, n - parts.gone)
        phase, _, speed = evaluate(loop, parts, s, room)
        if phase == 0.0:
            return s, True
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
        ratio: float = size / last
        # From afar a crowd of roots looks like one of many copies, and such a step would leap across all of them.
        if several == 1.0 and 0.4 < ratio < 0.95 and np.abs(ratio - before) < 0.02 * ratio and size < _CLOSE * here:
            several = np.round(1.0 / (1.0 - ratio))
        elif ratio > 1.0:
            several = 1.0
        last, before = size, ratio
    return s, False


@routine
def keep(loop: Loop, root: complex, scale: float, known: Complex, copies: Long, found: int) -> int:
    """Adds a root to those that are known, with the number of roots that coincide there; returns how many are known.

    The logarithmic derivative of the determinant around a point counts the roots in a small circle.

    Args:
        loop: the loop.
        root: to be added, 1/s.
        scale: rate of the loop, 1/s.
        known: roots; filled.
        copies: how many coincide at each; filled.
        found: how many are known.
    """
    radius = _CLUSTER * (np.abs(root) + scale)
    if found == len(known):
        return found
    for f in range(found):
        if np.abs(known[f] - root) <= 2.0 * radius:
            return found
    n = len(loop.mass)
    parts = cut(loop, _standpoint(root.real - radius, scale), REGULAR)
    room = scratch(n, n - parts.gone)
    for points in (2, 16):
        counted = 0.0 + 0.0j
        for p in range(points):
            away = radius * np.exp(2j * np.pi * (p + 0.5) / points)
            _, _, speed = evaluate(loop, parts, root + away, room)
            counted += away * speed / points
        if np.abs(counted - np.round(counted.real)) < 0.01:
            break
    if not counted.real > 0.5:
        return found
    known[found], copies[found] = root, int(np.round(counted.real))
    return found + 1


@subroutine
def standing(loop: Loop, s: complex, normalised: bool) -> float:
    """Phase of det G(s) where no root is near, without ambiguity: the sum of the phases of the pivots.

    Where the Hermitian part of G is positive definite so is that of every Schur complement, so each pivot keeps to the
    right half plane and the sum is continuous all over such a region; the same holds where that is so of `e^(-iθ) G`
    for some θ in [0, π/2], which turns the half plane, and for G over its diagonal (`normalised`) where the diagonal
    dominates.

    Args:
        loop: the loop.
        s: where, 1/s.
        normalised: whether G is taken over its diagonal.
    """
    n = len(loop.mass)
    parts = cut(loop, s.real, REGULAR)
    room = scratch(n, n - parts.gone)
    evaluate(loop, parts, s, room)
    phase = 0.0
    for a in range(parts.gone):
        p = parts.order[a]
        pivot = room.matrix[p, p]
        if normalised:
            pivot = pivot * ((loop.mass[p] * s + loop.drag[p]) * s + loop.rigid[p]).conjugate()
        phase += np.arctan2(pivot.imag, pivot.real)
    kept = n - parts.gone
    for a in range(kept):
        for b in range(kept):
            room.left[a, b] = room.matrix[parts.order[parts.gone + a], parts.order[parts.gone + b]]
    for a in range(kept):
        p = parts.order[parts.gone + a]
        pivot = room.left[a, a]
        for r in range(a + 1, kept):
            factor = room.left[r, a] / pivot
            for c in range(a + 1, kept):
                room.left[r, c] -= factor * room.left[a, c]
        if normalised:
            pivot = pivot * ((loop.mass[p] * s + loop.drag[p]) * s + loop.rigid[p]).conjugate()
        phase += np.arctan2(pivot.imag, pivot.real)
    return float(phase)
