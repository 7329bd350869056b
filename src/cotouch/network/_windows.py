"""The windows of frequency in which a consensus may have a root right of a line; compiled.

Such a root needs the delays of all links to resonate together. Few intervals of frequency let them, for a fine time
grid almost as quickly found as for a coarse one.
"""

import numpy as np

from cotouch.arrays import Float
from cotouch.compiled import raised, routine, subroutine
from cotouch.network._loop import Loop

# Windows narrower than this, in radians of the slowest link's phase, are not divided further.
_NARROW = 0.5


@subroutine
def _may_resonate(
    loop: Loop,
    low: float,
    high: float,
    around: Float,
    sizes: Float,
    cross: Float,
    fraction: Float,
    entry: Float,
    matrix: Float,
) -> bool:
    """Whether a root may lie right of the line between two frequencies.

    For a null vector p of G, `Re p*G p = 0`. The two directions of a link together contribute at most `|p_i||p_j| K_ij
    m_ij` with `m² = a² + b² + 2ab cos(ω (d_ij + d_ji))`, `a = e^(-σ d_ij), b = e^(-σ d_ji)`, which only falls to the
    right. So where `diag(S) - K m/2` is positive definite with the largest m of the interval there is no root, and the
    Hermitian part of G is positive definite.

    Its least eigenvalue is concave in the entries off the diagonal. Where each link by itself, taken back by `t_e`,
    makes it positive definite, all together taken back by shares of their `t_e` that add up to 1 do so too: that is
    looked at first.
    """
    n, links = len(loop.mass), len(around)
    turn, half = 0.5 * (low + high) / (2.0 * np.pi), 0.5 * (high - low)
    total = 0.0
    for e in range(links):
        turns: float = turn * around[e]
        away = max(np.abs(turns - np.round(turns)) * 2.0 * np.pi - half * around[e], 0.0)
        square = away * away
        # 1 - cos, from below
        rest = square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0 - square * (1.0 / 40320.0))))
        entry[e] = rest
        total += fraction[e] * rest
    if total > 1.0 + 1e-9:
        return False
    for i in range(n):
        for j in range(i):
            matrix[i, j] = 0.0
        matrix[i, i] = loop.rigid[i]
    for e in range(links):
        i, j = loop.first[e], loop.second[e]
        matrix[max(i, j), min(i, j)] = -0.5 * loop.spring[e] * np.sqrt(max(sizes[e] + cross[e] * (1.0 - entry[e]), 0.0))
    return not _positive(matrix)


@routine
def _positive(matrix: Float) -> bool:
    """Whether a symmetric matrix (lower triangle, overwritten) is clearly positive definite, by its pivots."""
    n = len(matrix)
    for c in range(n):
        if not matrix[c, c] > 0.0:
            return False
        over = 1.0 / matrix[c, c]
        for r in range(c + 1, n):
            factor = matrix[r, c] * over
            if factor != 0.0:
                least = 1e-12 * matrix[r, r]
                for k in range(c + 1, r + 1):
                    matrix[r, k] -= factor * matrix[k, c]
                if not matrix[r, r] > least:
                    return False
    return True


@subroutine
def _invert_real(matrix: Float) -> None:
    """Inverts a small real matrix in place, without pivoting; what comes of it is held against Cholesky."""
    n = len(matrix)
    for c in range(n):
        over = 1.0 / matrix[c, c]
        matrix[c, c] = 1.0
        for k in range(n):
            matrix[c, k] *= over
        for r in range(n):
            if r != c and matrix[r, c] != 0.0:
                factor = matrix[r, c]
                matrix[r, c] = 0.0
                for k in range(n):
                    matrix[r, k] -= factor * matrix[c, k]


@subroutine
def _tolerances(loop: Loop, sizes: Float, cross: Float, matrix: Float, tolerance: Float, fraction: Float) -> None:
    """For each link, how far its phase may be from resonance if all others resonate; π where that says nothing.

    With the other links at their largest, the matrix changes with this link in two entries only; its determinant is a
    quadratic in their change. What that yields is used after Cholesky has confirmed it, for the matrix is one whose
    least eigenvalue only rises when an entry off its diagonal shrinks.

    Args:
        loop: the loop.
        sizes: a² + b² of each link, see `_may_resonate`.
        cross: 2ab.
        matrix: scratch, (N, N).
        tolerance: filled, in radians.
        fraction: filled with what `1 - cos` of the phase is multiplied by for `_may_resonate`; 0 where that says
            nothing.
    """
    n, links = len(loop.mass), len(loop.first)
    full = np.zeros((n, n))
    for i in range(n):
        full[i, i] = loop.rigid[i]
    for e in range(links):
        i, j = loop.first[e], loop.second[e]
        full[i, j] = full[j, i] = -0.5 * loop.spring[e] * np.sqrt(sizes[e] + cross[e])
    inverse = full.copy()
    _invert_real(inverse)
    for e in range(links):
        tolerance[e], fraction[e] = np.pi, 0.0
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
        largest = np.sqrt(sizes[e] + cross[e])
        size = largest - 2.0 * change / loop.spring[e]
        if not size > 0.0:
            continue
        for r in range(n):
            for c in range(r + 1):
                matrix[r, c] = full[r, c]
        matrix[max(i, j), min(i, j)] += change
        if not _positive(matrix):
            continue
        # M - m = (M² - m²) / (M + m) >= cross (1 - cos) / (2 M)
        fraction[e] = 0.25 * loop.spring[e] * cross[e] / (largest * change)
        cosine = (size * size - sizes[e]) / cross[e]
        if cosine > -1.0:
            tolerance[e] = np.arccos(min(cosine, 1.0)) + 1e-9


@subroutine
def _comb(lows: Float, highs: Float, count: int, around: float, tolerance: float, out: Float) -> int:
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
def windows(loop: Loop, line: float, top: float, lows: Float, highs: Float, out: Float) -> tuple[int, int]:
    """Intervals of frequency outside which no root lies right of the line; their number, and that of the tests.

    Args:
        loop: the loop.
        line: real part, 1/s.
        top: largest frequency, 1/s.
        lows: begins of the intervals, filled.
        highs: their ends, filled.
        out: scratch, (2, as many).
    """
    n, links = len(loop.mass), len(loop.first)
    around, sizes, cross = np.empty(links), np.empty(links), np.empty(links)
    tolerance, fraction, entry = np.empty(links), np.empty(links), np.empty(links)
    longest = 0.0
    for e in range(links):
        around[e] = loop.to_first[e] + loop.to_second[e]
        longest = max(longest, around[e])
        a, b = np.exp(-line * loop.to_first[e]), np.exp(-line * loop.to_second[e])
        sizes[e], cross[e] = a * a + b * b, 2.0 * a * b
    matrix = np.empty((n, n))
    _tolerances(loop, sizes, cross, matrix, tolerance, fraction)
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
            if raised(loop.stop):
                return -1, tests
            if not _may_resonate(loop, low, high, around, sizes, cross, fraction, entry, matrix):
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
