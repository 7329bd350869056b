"""The slowest mode of the first-order consensus over delays, certain and at any fineness of the time grid; compiled.

The eigenvalues of the lifted J are `z = e^(s h)`, where s runs over the roots of `det[diag(S_i) - K_ij e^(-s d_ij)]`
with `0 <= Im s <= π/h`. A root can lie right of a line only at frequencies where the delays of all links resonate
together; those few windows are found first, for a fine grid almost as quickly as for a coarse one.
"""

import numpy as np

from cotouch.compiled import routine
from cotouch.network._loop import Loop, keep, polish, standing, walk
from cotouch.network._types import ComplexArray, FloatArray, IntArray

# Roots, starts of Newton in one window, steps through one window, and windows that are kept.
_MOST_ROOTS = 64
_MOST_STARTS = 32
_MOST_STEPS = 20_000
_MOST_WINDOWS = 4096
_ROUNDS = 60
# How much further left each line is along which better roots are looked for.
_FURTHER = 4.0
# Windows looked into before those that are left are counted.
_LOOKS = 3
# How far left of the rightmost root known the line of the count goes, beside its distance from 0.
_LEFT = 0.03
# Windows narrower than this, in radians of the slowest link's phase, are not divided further.
_NARROW = 0.15
# Without a root that falls by less than this power of e in the longest round trip there is none but zero.
_NOTHING = 60.0


@routine
def _may_resonate(
    loop: Loop, low: float, high: float, around: FloatArray, sizes: FloatArray, cross: FloatArray, matrix: FloatArray
) -> bool:
    """Whether a root may lie right of the line between two frequencies.

    For a null vector p of G, `Re p*G p = 0`. The two directions of a link together contribute at most `|p_i||p_j| K_ij
    m_ij` with `m² = a² + b² + 2ab cos(ω (d_ij + d_ji))`, `a = e^(-σ d_ij), b = e^(-σ d_ji)`, which only falls to the
    right. So where `diag(S) - K m/2` is positive definite with the largest m of the interval there is no root, and the
    Hermitian part of G is positive definite.
    """
    n = len(loop.mass)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    for i in range(n):
        for j in range(i):
            matrix[i, j] = 0.0
        matrix[i, i] = loop.rigid[i]
    for e in range(len(loop.first)):
        wide = half * around[e]
        cosine = 1.0
        if wide < np.pi:
            turn = middle * around[e] / (2.0 * np.pi)
            away = np.abs(turn - np.round(turn)) * 2.0 * np.pi - wide
            if away > 0.0:
                cosine = np.cos(away)
        i, j = loop.first[e], loop.second[e]
        matrix[max(i, j), min(i, j)] -= 0.5 * loop.spring[e] * np.sqrt(max(sizes[e] + cross[e] * cosine, 0.0))
    return not _positive(matrix)


@routine
def _positive(matrix: FloatArray) -> bool:
    """Whether a symmetric matrix (lower triangle, overwritten) is clearly positive definite, by Cholesky."""
    for i in range(len(matrix)):
        least = 1e-12 * matrix[i, i]
        for j in range(i):
            entry = matrix[i, j]
            for k in range(j):
                entry -= matrix[i, k] * matrix[j, k]
            matrix[i, j] = entry / matrix[j, j]
            matrix[i, i] -= matrix[i, j] * matrix[i, j]
        if not matrix[i, i] > least:
            return False
        matrix[i, i] = np.sqrt(matrix[i, i])
    return True


@routine
def _tolerances(loop: Loop, sizes: FloatArray, cross: FloatArray, matrix: FloatArray, tolerance: FloatArray) -> None:
    """For each link, how far its phase may be from resonance if all others resonate; π where that says nothing.

    With the other links at their largest, the matrix changes with this link in two entries only; its determinant is a
    quadratic in their change. What that yields is used after Cholesky has confirmed it, for the matrix is one whose
    least eigenvalue only rises when an entry off its diagonal shrinks.
    """
    n, links = len(loop.mass), len(loop.first)
    full = np.zeros((n, n))
    for i in range(n):
        full[i, i] = loop.rigid[i]
    for e in range(links):
        i, j = loop.first[e], loop.second[e]
        full[i, j] = full[j, i] = -0.5 * loop.spring[e] * np.sqrt(sizes[e] + cross[e])
    inverse = np.linalg.inv(full)
    for e in range(links):
        tolerance[e] = np.pi
        i, j = loop.first[e], loop.second[e]
        # (1 + t y_ij)² = t² y_ii y_jj
        y, product = inverse[i, j], inverse[i, i] * inverse[j, j]
        if not product > 0.0:
            continue
        change = np.inf
        for sign in (-1.0, 1.0):
            slope = sign * np.sqrt(product) - y
            if slope > 0.0:
                change = min(change, 1.0 / slope)
        change *= 1.0 + 1e-9
        size = np.sqrt(sizes[e] + cross[e]) - 2.0 * change / loop.spring[e]
        if not size > 0.0:
            continue
        cosine = (size * size - sizes[e]) / cross[e]
        if not cosine > -1.0:
            continue
        for r in range(n):
            for c in range(r + 1):
                matrix[r, c] = full[r, c]
        matrix[max(i, j), min(i, j)] += change
        if _positive(matrix):
            tolerance[e] = np.arccos(min(cosine, 1.0)) + 1e-9


@routine
def _comb(lows: FloatArray, highs: FloatArray, count: int, around: float, tolerance: float, out: FloatArray) -> int:
    """Cuts intervals down to where one link's phase is within its tolerance; -1 if there are too many of them."""
    made = 0
    for w in range(count):
        tooth = np.ceil((lows[w] * around - tolerance) / (2.0 * np.pi))
        while True:
            low = max(lows[w], (2.0 * np.pi * tooth - tolerance) / around)
            if not low <= highs[w]:
                break
            if made == len(lows):
                return -1
            out[0, made], out[1, made] = low, min(highs[w], (2.0 * np.pi * tooth + tolerance) / around)
            made += 1
            tooth += 1.0
    for w in range(made):
        lows[w], highs[w] = out[0, w], out[1, w]
    return made


@routine
def _windows(
    loop: Loop, line: float, top: float, lows: FloatArray, highs: FloatArray, out: FloatArray
) -> tuple[int, int]:
    """Intervals of frequency outside which no root lies right of the line; their number, and that of the tests."""
    n, links = len(loop.mass), len(loop.first)
    around, sizes, cross, tolerance = np.empty(links), np.empty(links), np.empty(links), np.empty(links)
    longest = 0.0
    for e in range(links):
        around[e] = loop.to_first[e] + loop.to_second[e]
        longest = max(longest, around[e])
        a, b = np.exp(-line * loop.to_first[e]), np.exp(-line * loop.to_second[e])
        sizes[e], cross[e] = a * a + b * b, 2.0 * a * b
    matrix = np.empty((n, n))
    _tolerances(loop, sizes, cross, matrix, tolerance)
    lows[0], highs[0] = 0.0, top
    given = 1
    order = np.argsort(around)  # short delays make few wide teeth, which long ones then divide
    for k in range(links):
        e = int(order[k])
        if tolerance[e] < np.pi:
            given = _comb(lows, highs, given, around[e], tolerance[e], out)
            if given < 0:
                return -1, 0
    stack = np.empty((128, 2))
    count, tests = 0, 0
    for w in range(given):
        out[0, w], out[1, w] = lows[w], highs[w]
    for w in range(given):
        stack[0, 0], stack[0, 1] = out[0, w], out[1, w]
        depth = 1
        while depth > 0:
            depth -= 1
            low, high = stack[depth, 0], stack[depth, 1]
            tests += 1
            if not _may_resonate(loop, low, high, around, sizes, cross, matrix):
                continue
            if 0.5 * (high - low) * longest > _NARROW:
                middle = 0.5 * (low + high)
                stack[depth, 0], stack[depth, 1] = middle, high
                stack[depth + 1, 0], stack[depth + 1, 1] = low, middle
                depth += 2
            elif count > 0 and highs[count - 1] == low:
                highs[count - 1] = high
            elif count == len(lows):
                return -1, tests
            else:
                lows[count], highs[count] = low, high
                count += 1
    return count, tests


@routine
def _detuning(loop: Loop, frequency: float) -> float:
    """How far the links are from resonating together; 0 if they all do."""
    result = 0.0
    for e in range(len(loop.first)):
        phase = frequency * (loop.to_first[e] + loop.to_second[e])
        result += loop.spring[e] * (1.0 - np.cos(phase))
    return result


@routine
def _count(loop: Loop, line: float, low: float, high: float, top: float, starts: ComplexArray) -> tuple[int, int, int]:
    """Roots right of the line in one window (with their mirror images at 0 and at `top`); -1 if unclear."""
    turn, steps, count = walk(loop, line, low, high, _MOST_STEPS, starts)
    whole = -turn
    if high < top:
        whole += standing(loop, complex(line, high), False)
    if low > 0.0:
        whole -= standing(loop, complex(line, low), False)
    whole /= np.pi if low == 0.0 or high == top else 2.0 * np.pi
    if not np.abs(whole - np.round(whole)) < 0.02:
        return -1, steps, count
    return int(np.round(whole)), steps, count


@routine
def slowest(loop: Loop, top: float, guesses: ComplexArray) -> tuple[complex, bool, int]:
    """The rightmost root but s = 0 in one period `0 <= Im s <= top` of a connected, aperiodic loop without masses.

    Args:
        loop: m = b = 0, k_i = sum_j K_ij, delays in whole time units h.
        top: π/h.
        guesses: where it may be.

    Returns:
        The root (real part -inf where there is none), whether it is certain, and the work done.
    """
    longest = 0.0
    for e in range(len(loop.first)):
        longest = max(longest, loop.to_first[e] + loop.to_second[e])
    scale = 1.0 / longest
    known, copies, found = np.zeros(_MOST_ROOTS, np.complex128), np.ones(_MOST_ROOTS, np.int64), 1
    lows, highs, out = np.empty(_MOST_WINDOWS), np.empty(_MOST_WINDOWS), np.empty((2, _MOST_WINDOWS))
    starts, detuned = np.empty(_MOST_STARTS, np.complex128), np.empty(_MOST_WINDOWS)
    effort = 0
    best = complex(-np.inf, 0.0)
    found = _add(loop, complex(-0.5 * scale, 0.0), scale, top, known, copies, found)
    for g in range(len(guesses)):
        found = _add(loop, guesses[g], scale, top, known, copies, found)
    reach, left = -0.02 * scale, _LEFT
    for _ in range(_ROUNDS):
        best = complex(-np.inf, 0.0)
        for f in range(1, found):
            if known[f].real > best.real:
                best = known[f]
        width = left * max(np.abs(best.real), 1e-6 * scale)
        line = best.real - width
        for f in range(1, found):
            if np.abs(known[f].real - line) < 0.1 * width:
                line = known[f].real - 0.25 * width
        final = found > 1 and line >= reach
        if not final:
            # Lines far left cross many windows: better roots are looked for right of there first.
            line, reach = reach, _FURTHER * reach
        windows, tests = _windows(loop, line, top, lows, highs, out)
        effort += tests
        if windows < 0:
            return best, False, effort
        # Where resonance is best a root lies furthest right: look there before counting anything.
        for w in range(windows):
            detuned[w] = _detuning(loop, 0.5 * (lows[w] + highs[w]))
            for f in range(found):
                if lows[w] <= known[f].imag <= highs[w]:
                    detuned[w] = np.inf
        before, ahead = found, best.real
        for _ in range(min(windows, _LOOKS)):
            w = int(np.argmin(detuned[:windows]))
            if detuned[w] == np.inf:
                break
            detuned[w] = np.inf
            found = _add(loop, complex(0.5 * line, 0.5 * (lows[w] + highs[w])), scale, top, known, copies, found)
        for f in range(before, found):
            ahead = max(ahead, known[f].real)
        if found > 1 and (not final or ahead > best.real + 0.05 * np.abs(line)):
            continue
        certain, fresh = True, False
        for w in range(windows):
            inside, steps, count = _count(loop, line, lows[w], highs[w], top, starts)
            effort += steps
            mirrored = lows[w] == 0.0 or highs[w] == top
            expected = 0
            for f in range(found):
                if known[f].real > line and lows[w] <= known[f].imag <= highs[w]:
                    twice = mirrored and known[f].imag != 0.0 and known[f].imag != top
                    expected += 2 * copies[f] if twice else copies[f]
            if inside == expected:
                continue
            certain = False
            before = found
            for c in range(count):
                found = _add(loop, starts[c], scale, top, known, copies, found)
            for f in range(before, found):
                fresh = fresh or known[f].real > line
                if known[f].real > best.real:
                    best = known[f]
            if best.real > line + 0.5 * np.abs(line):
                break  # Much better: a line further right crosses fewer windows.
        if certain and found == 1 and line * longest < -_NOTHING:
            return best, True, effort
        if certain and found > 1:
            for f in range(1, found):
                if known[f].real > best.real:
                    best = known[f]
            return best, True, effort
        if found > 1 and not fresh:
            left *= 0.618
    return best, False, effort


@routine
def _add(
    loop: Loop, start: complex, scale: float, top: float, known: ComplexArray, copies: IntArray, found: int
) -> int:
    """Takes up the root that Newton reaches, folded into the first half period; returns the number known."""
    root, arrived = polish(loop, start, scale, known, copies, found)
    if not arrived or not root.real > -1e3 * scale:
        return found
    turn = root.imag / (2.0 * top)
    folded = np.abs(turn - np.round(turn)) * 2.0 * top
    snap = 1e-9 * (top + scale)
    if np.abs(folded - top) < snap:
        folded = top
    return keep(loop, complex(root.real, folded if folded > snap else 0.0), scale, known, copies, found)
