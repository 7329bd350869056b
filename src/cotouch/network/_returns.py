"""The slowest mode of the consensus as that of the returns to one user; compiled.

Eliminating all users but one, the anchor, from `G(s) = diag(S_i) - K_ij e^(-s d_ij)` leaves `f(s) = S (1 - φ(s))`.
There φ is the transform of the time in which a walk along the links returns to the anchor, a sum `p_k e^(-s t_k)` with
p_k >= 0: the renewal equation of a Markov chain. So on a line of constant real part no derivative of f exceeds what it
is on the real axis, which says how far one value of f is good for. As long as the matrix without the anchor is an
M-matrix where the line crosses the real axis, it is regular on and right of the line, and the roots right of it are
those of f.
"""

from typing import NamedTuple

import numpy as np

from cotouch.arrays import Complex, Float, Long
from cotouch.compiled import raised, routine, subroutine
from cotouch.network._loop import Loop
from cotouch.network._walk import reciprocal

_NEWTON_STEPS = 40
_ARRIVED, _ROUGH = 1e-13, 1e-8
# Roots this close together, beside their size, count as one.
_CLUSTER = 1e-6
# Pivots this small beside the springs of their user make the bounds too coarse to be of use.
_REGULAR = 0.02
# Share of a safe step that is taken.
_SAFE = 0.9


class Chain(NamedTuple):
    """A loop whose users are in the order of elimination, the anchor last, with scratch.

    Attributes:
        loop: the loop; what is said of returns needs m = b = 0, k_i = sum_j K_ij.
        place: where each user of the loop went, (N,).
        line: real part of the present line, 1/s, (1,).
        delay: d_ij of all links and then d_ji, s, (2E,).
        size: `K_ij e^(-σ d)` of the present line, (2E,).
        real: their phasors, (2E,).
        imag: likewise.
        matrix: G and then its factors L and U down to f, (N, N).
        left: z, 1 at the anchor, with `zᵀ G` 0 elsewhere, (N,).
        right: x, likewise with `G x`, (N,).
        room: scratch, (N,).
    """

    loop: Loop
    place: Long
    line: Float
    delay: Float
    size: Float
    real: Float
    imag: Float
    matrix: Complex
    left: Complex
    right: Complex
    room: Complex


@routine
def chain_of(loop: Loop) -> Chain:
    """The chain of a loop: users with few links go first, the one with the stiffest springs last."""
    n, links = len(loop.mass), len(loop.first)
    degree, place = np.zeros(n, np.int64), np.zeros(n, np.int64)
    mass, drag, rigid = np.empty(n), np.empty(n), np.empty(n)
    for e in range(links):
        degree[loop.first[e]] += 1
        degree[loop.second[e]] += 1
    degree[np.argmax(loop.rigid)] = links + 1
    for u in range(n):
        for v in range(n):
            if degree[v] < degree[u] or (degree[v] == degree[u] and v < u):
                place[u] += 1
    for u in range(n):
        mass[place[u]], drag[place[u]], rigid[place[u]] = loop.mass[u], loop.drag[u], loop.rigid[u]
    delay = np.empty(2 * links)
    delay[:links], delay[links:] = loop.to_first, loop.to_second
    return Chain(
        Loop(
            mass,
            drag,
            rigid,
            place[loop.first],
            place[loop.second],
            loop.spring,
            loop.to_first,
            loop.to_second,
            loop.stop,
        ),
        place,
        np.zeros(1),
        delay,
        np.empty(2 * links),
        np.empty(2 * links),
        np.empty(2 * links),
        np.empty((n, n), np.complex128),
        np.empty(n, np.complex128),
        np.empty(n, np.complex128),
        np.empty(n, np.complex128),
    )


@routine
def on_line(chain: Chain, line: float) -> None:
    """Makes a line of constant real part the present one.

    Args:
        chain: the loop, returned to one user.
        line: real part, 1/s.
    """
    links = len(chain.loop.first)
    chain.line[0] = line
    for e in range(2 * links):
        chain.size[e] = chain.loop.spring[e % links] * np.exp(-line * chain.delay[e])


@subroutine
def _wave(delay: Float, size: Float, frequency: float, real: Float, imag: Float) -> None:
    """`size e^(-i ω d)`, by series of the half angle: several at once, without a call each."""
    turn = frequency / (2.0 * np.pi)
    for e in range(len(delay)):
        turns: float = turn * delay[e]
        x = np.pi * (turns - np.round(turns))
        q = x * x
        c = 1.0 - q / 20 / 19
        c = 1.0 - q * c / (18 * 17)
        c = 1.0 - q * c / (16 * 15)
        c = 1.0 - q * c / (14 * 13)
        c = 1.0 - q * c / (12 * 11)
        c = 1.0 - q * c / (10 * 9)
        c = 1.0 - q * c / (8 * 7)
        c = 1.0 - q * c / (6 * 5)
        c = 1.0 - q * c / (4 * 3)
        c = 1.0 - q * c / 2
        s = 1.0 - q / (21 * 20)
        s = 1.0 - q * s / (19 * 18)
        s = 1.0 - q * s / (17 * 16)
        s = 1.0 - q * s / (15 * 14)
        s = 1.0 - q * s / (13 * 12)
        s = 1.0 - q * s / (11 * 10)
        s = 1.0 - q * s / (9 * 8)
        s = 1.0 - q * s / (7 * 6)
        s = 1.0 - q * s / (5 * 4)
        s = x * (1.0 - q * s / (3 * 2))
        real[e] = size[e] * (1.0 - 2.0 * s * s)
        imag[e] = -2.0 * size[e] * s * c


@routine
def value(chain: Chain, frequency: float) -> tuple[complex, complex]:
    """Of f the value and the derivative by s on the present line.

    Args:
        chain: the loop, returned to one user.
        frequency: imaginary part, 1/s.
    """
    loop, matrix, x, z = chain.loop, chain.matrix, chain.right, chain.left
    n, links = len(loop.rigid), len(loop.first)
    _wave(chain.delay, chain.size, frequency, chain.real, chain.imag)
    matrix[:] = 0.0
    s = complex(chain.line[0], frequency)
    for i in range(n):
        matrix[i, i] = (loop.mass[i] * s + loop.drag[i]) * s + loop.rigid[i]
    for e in range(links):
        i, j = loop.first[e], loop.second[e]
        matrix[i, j] = -complex(chain.real[e], chain.imag[e])
        matrix[j, i] = -complex(chain.real[links + e], chain.imag[links + e])
    for c in range(n - 1):
        pivot = matrix[c, c]
        size = pivot.real * pivot.real + pivot.imag * pivot.imag
        over = complex(pivot.real / size, -pivot.imag / size)
        for r in range(c + 1, n):
            factor = matrix[r, c]
            if factor.real != 0.0 or factor.imag != 0.0:
                factor = factor * over
                matrix[r, c] = factor
                for k in range(c + 1, n):
                    matrix[r, k] -= factor * matrix[c, k]
        matrix[c, c] = over
    x[n - 1] = z[n - 1] = 1.0
    for above in range(n - 1):
        c = n - 2 - above
        onward, before = 0.0 + 0.0j, 0.0 + 0.0j
        for k in range(c + 1, n):
            onward -= matrix[c, k] * x[k]
            before -= matrix[k, c] * z[k]
        x[c], z[c] = onward * matrix[c, c], before
    slope = 0.0 + 0.0j
    for i in range(n):
        slope += (2.0 * loop.mass[i] * s + loop.drag[i]) * z[i] * x[i]
    for e in range(links):
        i, j = loop.first[e], loop.second[e]
        forth, back = complex(chain.real[e], chain.imag[e]), complex(chain.real[links + e], chain.imag[links + e])
        slope += chain.delay[e] * (forth * z[i] * x[j]) + chain.delay[links + e] * (back * z[j] * x[i])
    return matrix[n - 1, n - 1], slope


@routine
def bend_of(chain: Chain, line: float) -> float:
    """Largest |f''| on a line, which becomes the present one; NaN where nothing is known of it.

    Args:
        chain: the loop, returned to one user.
        line: real part, 1/s.
    """
    if not _anchored(chain, line):
        return np.nan
    value(chain, 0.0)
    loop, matrix, x, z, pull = chain.loop, chain.matrix, chain.right, chain.left, chain.room
    n, links = len(loop.rigid), len(loop.first)
    total = 0.0
    pull[:] = 0.0
    for e in range(links):
        i, j = loop.first[e], loop.second[e]
        forth, back = chain.delay[e] * chain.size[e], chain.delay[links + e] * chain.size[links + e]
        total += (chain.delay[e] * forth * z[i] * x[j] + chain.delay[links + e] * back * z[j] * x[i]).real
        pull[i] += forth * x[j]
        pull[j] += back * x[i]
    pull[n - 1] = 0.0
    for c in range(n - 1):
        for r in range(c + 1, n - 1):
            pull[r] -= matrix[r, c] * pull[c]
    for above in range(n - 1):
        c = n - 2 - above
        for k in range(c + 1, n - 1):
            pull[c] -= matrix[c, k] * pull[k]
        pull[c] *= matrix[c, c]
    for e in range(links):
        i, j = loop.first[e], loop.second[e]
        forth, back = chain.delay[e] * chain.size[e], chain.delay[links + e] * chain.size[links + e]
        total += 2.0 * (forth * z[i] * pull[j] + back * z[j] * pull[i]).real
    return total


@subroutine
def _anchored(chain: Chain, line: float) -> bool:
    """Whether the real matrix without the anchor is an M-matrix where the line, now the present one, crosses the axis.

    Its inverse is then the sum of the powers of a matrix >= 0, and right of there and beside the axis no entry of that
    matrix is larger: the sum still converges.
    """
    loop = chain.loop
    n, links = len(loop.rigid), len(loop.first)
    matrix = np.zeros((n, n))
    on_line(chain, line)
    for i in range(n):
        matrix[i, i] = loop.rigid[i]
    for e in range(links):
        i, j = loop.first[e], loop.second[e]
        matrix[i, j] = -chain.size[e]
        matrix[j, i] = -chain.size[links + e]
    for c in range(n - 1):
        if not matrix[c, c] > _REGULAR * loop.rigid[c]:
            return False
        for r in range(c + 1, n - 1):
            factor = matrix[r, c] / matrix[c, c]
            if factor != 0.0:
                for k in range(c + 1, n - 1):
                    matrix[r, k] -= factor * matrix[c, k]
    return True


@subroutine
def arrive(
    chain: Chain, start: complex, scale: float, beyond: float, known: Complex, found: int
) -> tuple[complex, bool]:
    """Newton on f over the roots that are known; the present line changes.

    Args:
        chain: the chain.
        start: where to begin.
        scale: a rate of the loop in 1/s, against which steps count as small.
        beyond: real part right of which there is no root.
        known: roots (and, implied, their conjugates) to keep away from.
        found: how many of them there are.

    Returns:
        The root with Im >= 0, and whether Newton arrived at one.
    """
    s, last = start, np.inf
    for _ in range(_NEWTON_STEPS):
        on_line(chain, s.real)
        f, slope = value(chain, s.imag)
        if f == 0.0:
            return complex(s.real, np.abs(s.imag)), True
        speed = slope * reciprocal(f)
        for k in range(found):
            if s != known[k]:
                speed -= reciprocal(s - known[k])
            if known[k].imag != 0.0 and s != known[k].conjugate():
                speed -= reciprocal(s - known[k].conjugate())
        step = reciprocal(speed)
        size, limit = np.abs(step), 0.5 * (np.abs(s) + scale)
        if not size < np.inf:
            return s, False
        if size > limit:
            step, size = step * (limit / size), limit
        s = s - step
        if s.real > beyond:
            return s, False
        here = np.abs(s) + scale
        if size <= _ARRIVED * here or (size <= _ROUGH * here and size >= last):
            if np.abs(s.imag) <= _ROUGH * here:
                s = complex(s.real, 0.0)
            return complex(s.real, np.abs(s.imag)), True
        last = size
    return s, False


@subroutine
def simple(chain: Chain, root: complex, scale: float) -> bool:
    """Whether just one root is at or beside a place, by f'/f around it; the present line changes.

    Args:
        chain: the loop, returned to one user.
        root: the place, 1/s.
        scale: rate of the loop, 1/s.
    """
    radius = _CLUSTER * (np.abs(root) + scale)
    counted = 0.0 + 0.0j
    for side in (-1.0, 1.0):
        away = complex(0.0, side * radius)
        on_line(chain, root.real)
        f, slope = value(chain, root.imag + away.imag)
        counted += 0.5 * away * slope * reciprocal(f)
    return np.abs(counted - 1.0) < 0.01


@routine
def excluded(f: complex, slope: complex, bend: float, half: float) -> bool:
    """Whether f is not 0 within `half` on either side of a place on a line where |f''| is at most `bend`.

    Args:
        f: value in the middle.
        slope: derivative there.
        bend: bound on |f''|.
        half: length to either side, 1/s.
    """
    return np.abs(f) * _SAFE > half * (np.abs(slope) + 0.5 * bend * half)


@routine
def turn_of(chain: Chain, bend: float, low: float, high: float, most: int) -> tuple[float, int, complex]:
    """Turn of f's phase along the present line, in steps in which it provably misses 0.

    Between two points f is what its value and slope say but for `bend τ²/2`; a step ends before that could close the
    gap to 0, so f turns as its tangent does and then by less than half a turn.

    Args:
        chain: the loop, returned to one user.
        bend: bound on |f''| on the line.
        low: where to begin, imaginary part, 1/s.
        high: where to end.
        most: steps, before it gives up.

    Returns:
        The turn in radians (NaN if given up), the number of steps, and where f is smallest less Newton's step there.
    """
    here, steps, turn, least = low, 0, 0.0, np.inf
    nearest = 0.0 + 0.0j
    f, slope = value(chain, here)
    while True:
        size, speed = np.abs(f), np.abs(slope)
        if not size > 0.0:
            return np.nan, steps, nearest
        if size < least * speed:
            least, nearest = size / speed, complex(0.0, here) - f * reciprocal(slope)
        if not here < high:
            return turn, steps, nearest
        # Smallest value of the tangent f + iτ f' from here on.
        ahead = f.imag * slope.real - f.real * slope.imag  # Re(f̄ i f')
        gap = size
        if ahead < 0.0:
            gap = np.sqrt(max(size * size - (ahead / speed) ** 2, 0.0))
        stride = np.sqrt(2.0 * _SAFE * gap / bend)
        stride = max(stride, 2.0 * _SAFE * size / (speed + np.sqrt(speed * speed + 2.0 * bend * size)))
        stride = min(stride, high - here)
        if steps >= most or not here + stride > here or raised(chain.loop.stop):
            return np.nan, steps, nearest
        tangent = f + complex(0.0, stride) * slope
        old = f
        here = here + stride
        f, slope = value(chain, here)
        for a, b in ((old, tangent), (tangent, f)):
            change = b * a.conjugate()
            turn += np.arctan2(change.imag, change.real)
        steps += 1
