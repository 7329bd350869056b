"""Points that are found deep in another body though no motion brought them there: they are asleep until they are out.

The nearest triangle says on which side of a skin a point is. Of a skin that is turned inside out or passes through
itself it may say anything, so a depth may come or go at once, and its energy from nowhere.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, inner, part, put
from cotouch.mechanics._meeting._bodies import Meeting
from cotouch.mechanics._meeting._stretch import put_within, stretched_in, within_of

# What rounding may add to a motion, as a factor, and of places for each metre.
_SURELY, _GRAIN = 1.0 + 1e-9, 1e-13


@inner
def is_last(m: Meeting, e: int) -> bool:
    """Whether an entry is the last of its point, which has one for each body that it may meet.

    Args:
        m: the bodies that meet.
        e: which entry.
    """
    return e + 1 == at(m.entries, 1) or at(m.point, e + 1) != at(m.point, e)


@part
def doze(m: Meeting, memory: Float, stretches: int) -> None:
    """Points are asleep in what they are found in where a step begins, though the last one did not leave them in it.

    Args:
        m: the bodies; all points were looked for.
        memory: of the copy.
        stretches: where in it those of the points and other bodies begin.
    """
    found = 0
    for e in range(at(m.entries, 1)):
        found += 1 if at(m.began, (e, 0)) > 0.0 else 0
        if is_last(m, e):
            n, here = e, stretches + 4 * at(m.point, e)
            within = within_of(memory, here) if found > 0 else 0
            while found > within and n >= 0 and at(m.point, n) == at(m.point, e):
                known = within > 0 and at(m.other, n) == stretched_in(memory, here)
                if at(m.began, (n, 0)) > 0.0 and not known:
                    put(m.began, (n, 0), -math.inf)
                n -= 1
            found = 0


@part
def wake(m: Meeting, memory: Float, stretches: int) -> None:
    """Nothing is asleep any more; see `doze`.

    Args:
        m: the bodies that meet.
        memory: of the copy, in place.
        stretches: where in it stretches of points in other bodies begin, as this step leaves them.
    """
    found = 0
    for e in range(at(m.entries, 1)):
        found += 1 if at(m.began, (e, 0)) > 0.0 else 0
        if is_last(m, e):
            put_within(memory, stretches + 4 * at(m.point, e), found)
            found = 0


@inner
def appears(m: Meeting, e: int) -> bool:
    """Whether a point that was outside, or asleep, is deeper inside than the motion could bring it.

    Args:
        m: the bodies that meet.
        e: which entry.
    """
    most = 2.0 * m.lever * at(m.bound, 1) * _SURELY + _GRAIN * m.lever
    return at(m.began, (e, 0)) <= 0.0 and at(m.ended, (e, 0)) - at(m.began, (e, 0)) > most


@part
def around(m: Meeting, place: Float, body: int, row: int, least: Float, most: Float) -> None:
    """Box around a body.

    Args:
        m: the bodies that meet.
        place: of the vertices, (V, 4) [m].
        body: which one.
        row: of the result.
        least: result: lowest corners, (rows, 3 or more) [m].
        most: result: highest corners, likewise.
    """
    for a in range(3):
        low, high = math.inf, -math.inf
        if m.hidden.shape[0] == 0:
            for v in range(at(m.vertices, body), at(m.vertices, body + 1)):
                low, high = min(low, at(place, (v, a))), max(high, at(place, (v, a)))
        else:  # what was cut away flies anywhere
            for f in range(at(m.leaves, body), at(m.leaves, body + 1)):
                for q in range(0 if at(m.hidden, f) != 0 else 3):
                    own = at(place, (at(m.corner, (f, q)), a))
                    low, high = min(low, own), max(high, own)
        put(least, (row, a), low)
        put(most, (row, a), high)


@inner
def _out(low: Float, high: Float, row: int, x: float, y: float, z: float) -> float:
    """How far a point is outside of a box, along one axis [m]."""
    outside = max(at(low, (row, 0)) - x, x - at(high, (row, 0)))
    outside = max(outside, at(low, (row, 1)) - y, y - at(high, (row, 1)))
    return max(outside, at(low, (row, 2)) - z, z - at(high, (row, 2)))


@part
def beyond(m: Meeting, e: int, x: float, y: float, z: float) -> bool:
    """Whether a point is outside of the box around another body, where the step would end.

    Points that are out of that are not looked for. It is worked out only for those that are not well within the box
    where the step begins.

    Args:
        m: the bodies that meet.
        e: which entry.
        x: of the point [m].
        y: likewise.
        z: likewise.
    """
    b = at(m.other, e)
    if b == at(m.part, at(m.point, e)):
        return False
    if _out(m.low, m.high, at(m.boxes, b), x, y, z) < -m.lever * at(m.bound, 1) * _SURELY:
        return False
    if b < m.moves and at(m.least, (b, 3)) == 0.0:
        around(m, m.later, b, b, m.least, m.most)
        put(m.least, (b, 3), 1.0)
    return _out(m.least, m.most, b, x, y, z) > 0.0
