"""The rightmost root of the closed loop, counted, in compiled form."""

import numpy as np

from cotouch.compiled import routine, subroutine
from cotouch.network._loop import Loop, keep, polish, standing, walk
from cotouch.network._types import ComplexArray

# Roots, and starts of Newton along one line, that are kept.
_MOST_ROOTS = 64
_MOST_STARTS = 64
_MOST_STEPS = 20_000
_ROUNDS = 12
# How far left of the rightmost root known the line of the count goes, beside its distance from 0.
_LEFT = 0.05
# With more roots than this missed, what is known is far from the rightmost one.
_CROWD = 6


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
def count_right(loop: Loop, line: float, starts: ComplexArray) -> tuple[int, int, int]:
    """Number of roots right of a line, by the argument principle.

    What turns is the determinant over the product of its diagonal, whose own roots are those of quadratics. Beyond a
    frequency the diagonal dominates along the line, and beyond a distance all over the half plane, so what is left of
    the contour there is known at its end.

    Returns:
        The number (-1 if unclear), the number of steps, the number of starts for Newton along the line.
    """
    high = _free_beyond(loop, line)
    turn, steps, count = walk(loop, line, 0.0, high, _MOST_STEPS, starts)
    own, own_turn = _own_roots(loop, line, high)
    rest = standing(loop, complex(line, high), True)
    windings = (rest - (turn - own_turn)) / np.pi
    if not abs(windings - np.round(windings)) < 0.02:
        return -1, steps, count
    return own + int(np.round(windings)), steps, count


@routine
def rightmost(loop: Loop, resting: bool, guesses: ComplexArray) -> tuple[complex, bool, int]:
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
    for g in range(len(guesses)):
        root, arrived = polish(loop, guesses[g], scale, known, copies, found)
        if arrived:
            found = keep(loop, root, scale, known, copies, found)
    left, nearer = _LEFT, 1.0
    best = complex(-np.inf, 0.0)
    for _ in range(_ROUNDS):
        for f in range(trivial, found):
            if known[f].real > best.real:
                best, nearer = known[f], 1.0
        line = -0.01 * scale
        if found > trivial:
            width = left * max(np.abs(best.real), 0.001 * scale)
            line = best.real - width
            for f in range(trivial, found):  # Not through a root that is known.
                if np.abs(known[f].real - line) < 0.1 * width:
                    line = known[f].real - 0.25 * width
            line *= nearer
        right, steps, count = count_right(loop, line, starts)
        effort += steps
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
            root, arrived = polish(loop, starts[c], scale, known, copies, found)
            if arrived and (root.real > line or nearer < 1.0 or found == trivial):
                found = keep(loop, root, scale, known, copies, found)
        if found == before:
            # Missed roots lie right of the line: where fewer others are near it, the walk points at them.
            nearer = 0.5 * nearer if right != expected else 1.0
            left *= 0.618
    return best, False, effort
