"""The slowest mode of the first-order consensus over delays, certain and at any fineness of the time grid; compiled.

The eigenvalues of the lifted J are `z = e^(s h)`, where s runs over the roots of `det[diag(S_i) - K_ij e^(-s d_ij)]`
with `0 <= Im s <= π/h`. A root can lie right of a line only at frequencies where the delays of all links resonate
together; those few windows are found first, for a fine grid almost as quickly as for a coarse one.
"""

import numpy as np

from cotouch.arrays import Complex, Long
from cotouch.compiled import raised, routine, subroutine
from cotouch.network._loop import Loop
from cotouch.network._returns import Chain, arrive, bend_of, chain_of, excluded, on_line, simple, turn_of, value
from cotouch.network._walk import keep, polish, reciprocal, standing, walk
from cotouch.network._windows import windows

# Roots, starts of Newton in one window, steps through one window, and windows that are kept.
_MOST_ROOTS = 64
_MOST_STARTS = 32
_MOST_STEPS = 20_000
_MOST_WINDOWS = 4096
_ROUNDS = 60
# Tests and steps after which a search that any root would end gives up.
_MOST_EFFORT = 15_000
# How much further left each line is along which better roots are looked for, near 0 and, in units of the longest round
# trip, further left than that: there a line too far left crosses crowds of roots.
_FURTHER, _CROWDED, _STEP = 4.0, 0.3, 1.4
# Windows looked into before those that are left are counted.
_LOOKS = 3
# How far left of the rightmost root known the line of the count goes, beside its distance from 0.
_LEFT = 0.03
# The first line that is looked right of, in units of the longest round trip, and beside a guess.
_REACH, _HINT = -0.02, 1.3
_SWIFT_ROUNDS = 24
# Bounds that allow strides below this share of a radian of the longest round trip are of no use.
_COARSE = 10.0
# Without a root that falls by less than this power of e in the longest round trip there is none but zero.
_NOTHING = 60.0


@subroutine
def _detuning(loop: Loop, frequency: float) -> float:
    """How far the links are from resonating together; 0 if they all do."""
    result = 0.0
    for e in range(len(loop.first)):
        phase = frequency * (loop.to_first[e] + loop.to_second[e])
        result += loop.spring[e] * (1.0 - np.cos(phase))
    return result


@routine
def _count(loop: Loop, line: float, low: float, high: float, top: float, starts: Complex) -> tuple[int, int, int]:
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
def slowest(loop: Loop, top: float, guesses: Complex, enough: float = np.inf) -> tuple[complex, bool, int]:
    """The rightmost root but s = 0 in one period `0 <= Im s <= top` of a connected, aperiodic loop without masses.

    Args:
        loop: m = b = 0, k_i = sum_j K_ij, delays in whole time units h.
        top: π/h.
        guesses: where it may be.
        enough: any root right of this will do as well: then no further right one is looked for. With inf, the default,
            more is done to be certain.

    Returns:
        The root (real part -inf where there is none), whether it is certain, and the work done.
    """
    root, certain, effort = _swift(loop, top, guesses, enough)
    if certain:
        return root, True, effort
    if np.isfinite(root.real):
        guesses = np.array([root])
    root, certain, more = _thorough(loop, top, guesses, enough)
    effort += more
    if not certain and len(guesses) > 0 and enough == np.inf:
        root, certain, more = _thorough(loop, top, guesses[:0], enough)
        effort += more
    return root, certain, effort


@subroutine
def _further(reach: float, scale: float) -> float:
    """The next line to look right of."""
    return reach * (_FURTHER if reach > -_CROWDED * scale else _STEP)


@subroutine
def _rightmost_of(known: Complex, found: int) -> complex:
    """Of the known roots beside the first, which is s = 0; real part -inf where there is none."""
    best = complex(-np.inf, 0.0)
    for f in range(1, found):
        if known[f].real > best.real:
            best = known[f]
    return best


@subroutine
def _beside(best: complex, known: Complex, found: int, left: float, scale: float) -> float:
    """A line left of the best root, by a share `left` of its distance from 0, on which none that is known lies."""
    width = left * max(np.abs(best.real), 1e-6 * scale)
    line = best.real - width
    for f in range(1, found):
        if np.abs(known[f].real - line) < 0.1 * width:
            line = known[f].real - 0.25 * width
    return line


@routine
def _swift(loop: Loop, top: float, guesses: Complex, enough: float) -> tuple[complex, bool, int]:
    """What `slowest` finds, by the returns to one user; uncertain where the line gets too far left for that."""
    longest = 0.0
    for e in range(len(loop.first)):
        longest = max(longest, loop.to_first[e] + loop.to_second[e])
    scale = 1.0 / longest
    chain = chain_of(loop)
    known, found = np.zeros(_MOST_ROOTS, np.complex128), 1
    lows, highs, out = np.empty(_MOST_WINDOWS), np.empty(_MOST_WINDOWS), np.empty((2, _MOST_WINDOWS))
    promise = np.empty(_MOST_WINDOWS, np.complex128)
    effort = 0
    best = complex(-np.inf, 0.0)
    reach = _REACH * scale
    for g in range(len(guesses)):
        found = _take(chain, guesses[g], scale, top, known, found)
        reach = min(reach, _HINT * guesses[g].real)
    for _ in range(_SWIFT_ROUNDS):
        if raised(loop.stop):
            return best, False, effort
        best = _rightmost_of(known, found)
        if best.real >= enough:
            return best, True, effort
        line, final = reach, False
        if found > 1:
            line = _beside(best, known, found, _LEFT, scale)
            final = line >= reach
        if not final:
            line, reach = reach, _further(reach, scale)
        bend = bend_of(chain, line)
        if not bend < (_COARSE * longest) ** 2 * chain.loop.rigid[-1]:
            return best, False, effort
        many, tests = windows(chain.loop, line, top, lows, highs, out)
        effort += tests
        if many < 0:
            return best, False, effort
        # One value of f in each window leaves most of them empty, and says of the others where a root may be.
        open_ = 0
        for w in range(many):
            middle, half = 0.5 * (lows[w] + highs[w]), 0.5 * (highs[w] - lows[w])
            f, slope = value(chain, middle)
            effort += 1
            if lows[w] > 0.0 and highs[w] < top and excluded(f, slope, bend, half):
                continue
            likely = complex(line, middle) - f * reciprocal(slope)
            if not (likely.real < 0.0 and np.abs(likely.imag - middle) < 2.0 * half + scale):
                likely = complex(-np.inf, 0.0)
            for k in range(found):
                if lows[w] <= known[k].imag <= highs[w]:
                    likely = complex(-np.inf, 0.0)
            lows[open_], highs[open_], promise[open_] = lows[w], highs[w], likely
            open_ += 1
        before, ahead = found, best.real
        for _ in range(_LOOKS):
            w = -1
            for v in range(open_):
                if promise[v].real > ahead and (w < 0 or promise[v].real > promise[w].real):
                    w = v
            if w < 0:
                break
            start = promise[w]
            promise[w] = complex(-np.inf, 0.0)
            found = _take(chain, start, scale, top, known, found)
            ahead = _rightmost_of(known, found).real
        if ahead >= enough or not final or ahead > best.real + 0.05 * np.abs(line):
            continue
        certain = True
        on_line(chain, line)
        for w in range(open_):
            inside, steps, nearest = _zeros(chain, bend, lows[w], highs[w], top)
            effort += steps
            if inside == _expected(known, found, line, lows[w], highs[w], top):
                continue
            certain = False
            if inside < 0:
                return best, False, effort
            found = _take(chain, complex(line, 0.0) + nearest, scale, top, known, found)
            ahead = _rightmost_of(known, found).real
            if ahead > best.real + 0.05 * np.abs(line):
                break  # Better by much: a line further right crosses less.
            on_line(chain, line)
        if certain:
            return _rightmost_of(known, found), True, effort
        if found == before:
            return best, False, effort
    return best, False, effort


@routine
def none_beyond(loop: Loop, top: float, line: float) -> bool:
    """Whether surely no root but s = 0 lies right of a line left of it; False says nothing.

    Args:
        loop: the loop.
        top: frequency beyond which no root lies, 1/s.
        line: real part, < 0, 1/s.
    """
    chain = chain_of(loop)
    lows, highs, out = np.empty(_MOST_WINDOWS), np.empty(_MOST_WINDOWS), np.empty((2, _MOST_WINDOWS))
    bend = bend_of(chain, line)
    if not (line < 0.0 and bend > 0.0):
        return False
    many, _ = windows(chain.loop, line, top, lows, highs, out)
    on_line(chain, line)
    for w in range(many):
        middle, half = 0.5 * (lows[w] + highs[w]), 0.5 * (highs[w] - lows[w])
        f, slope = value(chain, middle)
        if lows[w] > 0.0 and highs[w] < top and excluded(f, slope, bend, half):
            continue
        inside, _, _ = _zeros(chain, bend, lows[w], highs[w], top)
        if inside != (1 if lows[w] == 0.0 else 0):
            return False
    return many >= 0


@subroutine
def _take(chain: Chain, start: complex, scale: float, top: float, known: Complex, found: int) -> int:
    """Takes up the root that Newton reaches if it is simple and new; returns the number known."""
    root, arrived = arrive(chain, start, scale, scale, known, found)
    if not arrived or not root.real > -1e3 * scale or found == len(known):
        return found
    root = _folded(root, top, scale)
    for k in range(found):
        if np.abs(known[k] - root) <= 2e-6 * (np.abs(root) + scale):
            return found
    if not simple(chain, root, scale):
        return found
    known[found] = root
    return found + 1


@subroutine
def _expected(known: Complex, found: int, line: float, low: float, high: float, top: float) -> int:
    """How many of the known roots are right of the line in a window, mirror images at 0 and at `top` included."""
    mirrored, expected = low == 0.0 or high == top, 0
    for k in range(found):
        if known[k].real > line and low <= known[k].imag <= high:
            expected += 2 if mirrored and known[k].imag != 0.0 and known[k].imag != top else 1
    return expected


@subroutine
def _zeros(chain: Chain, bend: float, low: float, high: float, top: float) -> tuple[int, int, complex]:
    """Roots of f right of the present line in one window (with their mirror images at 0 and at `top`); -1 if unclear.

    At the ends of a window, and right of them, the Hermitian part of G is positive definite. So is f, the last
    pivot: it keeps to the right half plane, and turns by no more than the phase it has.
    """
    turn, steps, nearest = turn_of(chain, bend, low, high, _MOST_STEPS)
    whole = -turn
    if high < top:
        f, _ = value(chain, high)
        whole += np.arctan2(f.imag, f.real)
    if low > 0.0:
        f, _ = value(chain, low)
        whole -= np.arctan2(f.imag, f.real)
    whole /= np.pi if low == 0.0 or high == top else 2.0 * np.pi
    if not np.abs(whole - np.round(whole)) < 0.02:
        return -1, steps, nearest
    return int(np.round(whole)), steps, nearest


@subroutine
def _folded(root: complex, top: float, scale: float) -> complex:
    """The same root within the first half period."""
    turn = root.imag / (2.0 * top)
    folded = np.abs(turn - np.round(turn)) * 2.0 * top
    snap = 1e-9 * (top + scale)
    if np.abs(folded - top) < snap:
        folded = top
    return complex(root.real, folded if folded > snap else 0.0)


@routine
def _thorough(loop: Loop, top: float, guesses: Complex, enough: float) -> tuple[complex, bool, int]:
    """What `slowest` finds, for any line: by the turn of the whole determinant.

    Args:
        loop: m = b = 0, k_i = sum_j K_ij, delays in whole time units h.
        top: π/h.
        guesses: where it may be.
        enough: any root right of this will do as well; asked so, it gives up sooner.

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
    most = _MOST_EFFORT if enough < np.inf else 2**62
    best = complex(-np.inf, 0.0)
    found = _add(loop, complex(-0.5 * scale, 0.0), scale, top, known, copies, found)
    for g in range(len(guesses)):
        found = _add(loop, guesses[g], scale, top, known, copies, found)
    reach, left = -0.02 * scale, _LEFT
    for _ in range(_ROUNDS):
        if raised(loop.stop):
            return best, False, effort
        best = _rightmost_of(known, found)
        if best.real >= enough:
            return best, True, effort
        if effort > most:
            return best, False, effort
        line = _beside(best, known, found, left, scale)
        final = found > 1 and line >= reach
        if not final:
            # Lines far left cross many windows: better roots are looked for right of there first.
            line, reach = reach, _further(reach, scale)
        many, tests = windows(loop, line, top, lows, highs, out)
        effort += tests
        if many < 0:
            return best, False, effort
        # Where resonance is best a root lies furthest right: look there before counting anything.
        for w in range(many):
            detuned[w] = _detuning(loop, 0.5 * (lows[w] + highs[w]))
            for f in range(found):
                if lows[w] <= known[f].imag <= highs[w]:
                    detuned[w] = np.inf
        for _ in range(min(many, _LOOKS)):
            w = int(np.argmin(detuned[:many]))
            if detuned[w] == np.inf:
                break
            detuned[w] = np.inf
            found = _add(loop, complex(0.5 * line, 0.5 * (lows[w] + highs[w])), scale, top, known, copies, found)
        ahead = _rightmost_of(known, found).real
        if found > 1 and (not final or ahead > best.real + 0.05 * np.abs(line)):
            continue
        certain, fresh = True, False
        for w in range(many):
            if raised(loop.stop):
                return best, False, effort
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
            return _rightmost_of(known, found), True, effort
        if found > 1 and not fresh:
            left *= 0.618
    return best, False, effort


@routine
def _add(loop: Loop, start: complex, scale: float, top: float, known: Complex, copies: Long, found: int) -> int:
    """Takes up the root that Newton reaches, folded into the first half period; returns the number known."""
    root, arrived = polish(loop, start, scale, known, copies, found)
    if not arrived or not root.real > -1e3 * scale:
        return found
    return keep(loop, _folded(root, top, scale), scale, known, copies, found)
