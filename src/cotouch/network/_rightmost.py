"""The rightmost root of the closed loop, counted, in compiled form."""

import numpy as np

from cotouch.arrays import Complex, Long
from cotouch.compiled import raised, routine, subroutine
from cotouch.network._definite import definite, negatives
from cotouch.network._elimination import cut
from cotouch.network._loop import Loop
from cotouch.network._walk import keep, polish, standing, walk

# Roots, and starts of Newton along one line, that are kept.
_MOST_ROOTS = 64
_MOST_STARTS = 64
_MOST_STEPS = 20_000
_ROUNDS = 20
# How far left of the rightmost root known the line of the count goes, beside its distance from 0.
_LEFT = 0.05
_NEAREST = 1e-3
# Once it is nearer than this and finds nothing, it goes to the right by this factor instead.
_SOON, _NEARER = 0.01, 0.8
# With more users, real roots are looked at first; this is the nearest to the rightmost root that the line then goes.
_MANY, _NARROW = 24, 2e-3
# Where delays differ both ways such a gap may be none. A count through it that takes more steps is given up for lines
# further left.
_PATIENCE = 600
# With more roots than this missed, what is known is far from the rightmost one.
_CROWD = 6
# The axis is looked at as far as links carry e to this, and to so many rates of the loop.
_FAR, _SWIFTEST = 20.0, 20.0
# Stretches of a line on which G turned by an angle is definite: upper over lower end at first, at most and at least;
# cotangents of the angle, beside the frequency over the line's distance from 0; and the share of that distance below
# which a walk takes few steps.
_STRETCH, _LONGEST, _SHORTEST = 2.0, 8.0, 1.08
_LEANS = (0.4, 0.2, 0.7, 1.2)
_AT_ONCE = 2e-3


@routine
def rate_of(loop: Loop) -> float:
    """A rate of the loop in 1/s, to call steps small by: the stiffest spring on its damper and mass."""
    rate = 0.0
    for i in range(len(loop.mass)):
        resistance = loop.drag[i] + np.sqrt(loop.rigid[i] * loop.mass[i])
        own = loop.rigid[i] / resistance if loop.rigid[i] > 0.0 else loop.drag[i] / loop.mass[i]
        rate = max(rate, own)
    return rate


@subroutine
def _free_beyond(loop: Loop, line: float) -> float:
    """Frequency beyond which the diagonal dominates all along the line."""
    n = len(loop.mass)
    pull = np.zeros(n)
    for e in range(len(loop.first)):
        pull[loop.first[e]] += loop.spring[e] * np.exp(-line * loop.to_first[e])
        pull[loop.second[e]] += loop.spring[e] * np.exp(-line * loop.to_second[e])
    beyond = 0.0
    for i in range(n):
        # |own|² = (rest - m ω²)² + (drag ω)² on the line, a quadratic in ω² beside pull².
        m = loop.mass[i]
        rest = line * line * m + line * loop.drag[i] + loop.rigid[i]
        drag = loop.drag[i] + 2.0 * line * m
        half = (drag * drag - 2.0 * rest * m) / (2.0 * m * m)
        inside = half * half - (rest * rest - pull[i] * pull[i]) / (m * m)
        if inside > 0.0:
            beyond = max(beyond, np.sqrt(inside) - half)
    return 1.01 * np.sqrt(max(beyond, 0.0))


@subroutine
def _own_roots(loop: Loop, line: float, high: float) -> tuple[int, float]:
    """Roots of the diagonal right of the line, and the turn of its product's phase from the line's foot to `high`."""
    count, turn = 0, 0.0
    for i in range(len(loop.mass)):
        m, b, k = loop.mass[i], loop.drag[i], loop.rigid[i]
        inside = b * b - 4.0 * m * k
        if inside < 0.0:
            count += 2 if -b / (2.0 * m) > line else 0
        else:
            larger = -(b + np.sqrt(inside)) / (2.0 * m)
            smaller = k / (m * larger) if larger != 0.0 else 0.0
            count += (1 if larger > line else 0) + (1 if smaller > line else 0)
        foot = (m * line + b) * line + k
        start = 0.0 if foot >= 0.0 else np.copysign(np.pi, 2.0 * m * line + b)
        turn += np.arctan2((2.0 * m * line + b) * high, foot - m * high * high) - start
    return count, turn


@routine
def definite_from(loop: Loop, line: float, high: float, near: float) -> float:
    """Frequency from which on to `high` the determinant's phase along the line is known without following it.

    There G, turned by some angle, has a positive definite Hermitian part. That is made sure of stretch by stretch, from
    above; an angle is found by trial.

    Args:
        loop: the loop.
        line: real part.
        high: highest frequency.
        near: low enough.
    """
    n = len(loop.mass)
    parts, matrix = cut(loop, 0.0, -np.inf), np.zeros((n, n), np.complex128)
    ratio, kind = _STRETCH, 0
    while high > near:
        low, held = high / ratio, False
        for turn in range(len(_LEANS)):
            lean = _LEANS[(kind + turn) % len(_LEANS)] * 0.5 * (low + high) / (np.abs(line) + near)
            if definite(loop, parts, line, low, high, lean, matrix):
                kind, held = (kind + turn) % len(_LEANS), True
                break
        if held:
            high, ratio = low, min(1.0 + 1.5 * (ratio - 1.0), _LONGEST)
        elif ratio > _SHORTEST:
            ratio = 1.0 + 0.4 * (ratio - 1.0)
        else:
            break
    return high


@routine
def count_right(
    loop: Loop, line: float, starts: Complex, whole: bool = True, most: int = _MOST_STEPS
) -> tuple[int, int, int]:
    """Number of roots right of a line, by the argument principle.

    What turns is the determinant over the product of its diagonal, whose own roots are those of quadratics. Beyond a
    frequency the diagonal dominates along the line, and beyond a distance all over the half plane, so what is left of
    the contour there is known at its end.

    Args:
        loop: the loop.
        line: real part.
        starts: filled with Newton's next points.
        whole: whether to walk all along the line, or only where the phase is not known by itself.
        most: steps after which it is unclear.

    Returns:
        The number (-1 if unclear), the number of steps, the number of starts for Newton along the line.
    """
    high = _free_beyond(loop, line)
    far = high if whole else definite_from(loop, line, high, _AT_ONCE * np.abs(line))
    turn, steps, count = walk(loop, line, 0.0, far, most, starts)
    if far < high:
        turn += standing(loop, complex(line, high), False) - standing(loop, complex(line, far), False)
    own, own_turn = _own_roots(loop, line, high)
    rest = standing(loop, complex(line, high), True)
    windings = (rest - (turn - own_turn)) / np.pi
    if not abs(windings - np.round(windings)) < 0.02:
        return -1, steps, count
    return own + int(np.round(windings)), steps, count


@routine
def on_axis(loop: Loop, resting: bool) -> float:
    """About where the rightmost real root is, the resting translation aside; NaN if there is none near.

    Args:
        loop: the loop.
        resting: whether s = 0 is a root, of all copies moving as one.
    """
    n = len(loop.mass)
    if len(loop.first) == 0:
        return np.nan
    parts, matrix = cut(loop, 0.0, -np.inf), np.zeros((n, n))
    longest = max(np.max(loop.to_first), np.max(loop.to_second))
    expected, scale = (1 if resting else 0), rate_of(loop)
    low, high = 0.0, -1e-4 * scale
    while negatives(loop, parts, high, matrix) <= expected:
        if high * longest < -_FAR or high < -_SWIFTEST * scale:
            return np.nan
        low, high = high, 2.0 * high
    while low - high > 1e-4 * -high:
        middle = 0.5 * (low + high)
        if negatives(loop, parts, middle, matrix) <= expected:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


@subroutine
def _gap(loop: Loop, rate: float, widest: float, resting: int) -> float:
    """How far left of a rate a line may go, as a share of it, and leave the real roots further left well alone."""
    parts, matrix = cut(loop, 0.0, -np.inf), np.zeros((len(loop.mass), len(loop.mass)))
    while widest > _NARROW and negatives(loop, parts, rate * (1.0 + 2.0 * widest), matrix) > resting + 1:
        widest *= 0.5
    return widest


@subroutine
def _look_around(loop: Loop, line: float, best: complex, scale: float, known: Complex, copies: Long, found: int) -> int:
    """Newton from points right of a root: pairs that just left the axis lie there; ends with the first one found."""
    for ahead in (0.97, 0.9, 0.8):
        for aside in (0.02, 0.08, 0.25):
            if raised(loop.stop):
                return found
            start = complex(ahead * best.real, aside * np.abs(best.real))
            root, arrived = polish(loop, start, scale, known, copies, found)
            if arrived and root.real > line:
                now = keep(loop, root, scale, known, copies, found)
                if now > found:
                    return now
    return found


@routine
def rightmost(loop: Loop, resting: bool, guesses: Complex) -> tuple[complex, bool, int]:
    """The rightmost root, the resting translation aside.

    Newton from the guesses gives a first root. A line just left of it is walked: the count of roots right of the line
    says whether any was missed, and the walk itself says where to look for it.

    Args:
        loop: the loop; m > 0.
        resting: whether 0 is a root that does not count.
        guesses: where the rightmost root may be.

    Returns:
        The root with Im >= 0, whether it is certain, and the number of matrices inverted for the counts.
    """
    scale = rate_of(loop)
    known, copies, found = np.zeros(_MOST_ROOTS, np.complex128), np.ones(_MOST_ROOTS, np.int64), 0
    if resting:
        found = 1
    trivial = found
    starts = np.empty(_MOST_STARTS, np.complex128)
    effort = 0
    many, afresh = len(loop.mass) > _MANY, len(guesses) == 0
    while True:
        if afresh:
            real = on_axis(loop, resting)
            # Roots leave the axis where delays differ both ways; Newton by itself never does.
            guesses = np.array([complex(real, 0.0), complex(1.03 * real, 0.03 * real), complex(real, 0.1 * real)])
        first = guesses[0].real
        for g in range(len(guesses)):
            # A root where it was guessed needs no other guess.
            if np.isfinite(guesses[g].real) and not (many and found > trivial and known[trivial].real > 1.005 * first):
                root, arrived = polish(loop, guesses[g], scale, known, copies, found)
                if arrived:
                    found = keep(loop, root, scale, known, copies, found)
        if afresh or found > trivial:
            break
        afresh = True  # Newton lost its way from the guesses: roots of other links may be far from any of these.
    left, nearer, whole, gaps = _LEFT, 1.0, not many, many
    best, around = complex(-np.inf, 0.0), complex(np.inf, 0.0)
    for _ in range(_ROUNDS):
        if raised(loop.stop):
            return best, False, effort
        for f in range(trivial, found):
            if known[f].real > best.real:
                best, nearer = known[f], 1.0
        line = -0.01 * scale
        if found > trivial:
            if gaps:  # Their roots lie close together, and a line through a gap takes fewer steps.
                left = _gap(loop, best.real, left, trivial)
            width = left * max(np.abs(best.real), 0.001 * scale)
            line = best.real - width
            for f in range(trivial, found):  # Not through a root that is known.
                if np.abs(known[f].real - line) < 0.1 * width:
                    line = known[f].real - 0.25 * width
            line *= nearer
        right, steps, count = count_right(loop, line, starts, whole, _PATIENCE if gaps else _MOST_STEPS)
        effort += steps
        if right < 0 and gaps and not raised(loop.stop):
            gaps, left = False, _LEFT
            continue
        expected = 1 if resting and line < 0.0 else 0
        for f in range(trivial, found):
            if known[f].real > line:
                expected += 2 * copies[f] if known[f].imag != 0.0 else copies[f]
        if found > trivial and nearer == 1.0 and right == expected:
            return best, True, effort
        if right > expected + _CROWD:
            nearer *= 0.5
            continue
        before = found
        for c in range(count):
            if raised(loop.stop):
                return best, False, effort
            root, arrived = polish(loop, starts[c], scale, known, copies, found)
            if arrived and (root.real > line or nearer < 1.0 or found == trivial):
                found = keep(loop, root, scale, known, copies, found)
        if found == before and found > trivial and right > expected and around != best:
            around = best
            found = _look_around(loop, line, best, scale, known, copies, found)
        if found == before and not whole:  # What is missed may lie beside the part that was not walked.
            whole = True
        elif found == before:
            # What is missed lies between the line and the root, where a line nearer to it leaves it out; or else right
            # of the root, where the walk points at it once fewer others are near the line.
            nearer = _NEARER * nearer if right != expected and left < _SOON else 1.0
            left = max(0.3 * left, 0.3 * _NEAREST)
    return best, False, effort
