"""Whether the middle of a tool would pass through the skin within a step, by the motion of both."""
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import part
from cotouch.mechanics._contact._beads import bead_place, beads, reached
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import Tools

# Later than any step.
NEVER = 2.0
# A point this far outside of a triangle, in its size, is still on it: two triangles leave no gap.
_SLACK = 1e-9
_HALVES = 60


@part
def first_crossing(surface: Surface, work: ContactWork, tools: Tools, t: int, T: float) -> float:
    """Share of a step after which the middle of a tool first lies in a triangle near it; `NEVER`: it does not.

    All move straight, so the volume of triangle and point is a cubic in time, whose roots are found between its turns
    [Provot 1997]. Triangle, shares of its corners and ball go to `caught`.

    Args:
        surface: the skin.
        work: `rate` and `mean` say what moves; `caught` is written.
        tools: the proxies.
        t: which of them.
        T: length of the step [s].
    """
    place, rate, mean, middle = work.fit.place, work.rate, work.mean, tools.place
    corner, near, caught = surface.corner, work.near, work.caught
    earliest, long, way = NEVER, 0.0, 0.0
    for a in range(3):
        long += tools.axis[t, a] * tools.axis[t, a]
        way += mean[t, a] * mean[t, a]
    if work.clear[t] - math.sqrt(long) > T * (work.quick[0] + math.sqrt(way)):
        return NEVER
    fours, span = reached(corner, work, tools, t, 0.0, 0.0, T), work.span
    for bead in range(beads(tools, t)):
        along = bead_place(tools, t, bead)
        for n in range(fours):
            if bead < span[n, 1] or bead > span[n, 2]:
                continue
            for c in range(span[n, 0], min(span[n, 0] + 4, work.number[t])):
                f = near[t, c]
                ia, ib, ic = corner[f, 0], corner[f, 1], corner[f, 2]
                if _far(place, rate, mean, middle, tools.axis, ia, ib, ic, t, along, T):
                    continue
                f0 = _volume(place, rate, mean, middle, tools.axis, ia, ib, ic, t, along, 0.0)
                f1 = _volume(place, rate, mean, middle, tools.axis, ia, ib, ic, t, along, T / 3.0)
                f2 = _volume(place, rate, mean, middle, tools.axis, ia, ib, ic, t, along, T * (2.0 / 3.0))
                f3 = _volume(place, rate, mean, middle, tools.axis, ia, ib, ic, t, along, T)
                # a s³ + b s² + d s + f0
                a3 = 4.5 * (f3 - 3.0 * f2 + 3.0 * f1 - f0)
                b2 = 4.5 * (2.0 * f0 - 5.0 * f1 + 4.0 * f2 - f3)
                d1 = 0.5 * (2.0 * f3 - 9.0 * f2 + 18.0 * f1 - 11.0 * f0)
                under = b2 * b2 - 3.0 * a3 * d1
                turn, other = 1.0, 1.0
                if under > 0.0:
                    root = math.sqrt(under)
                    if a3 != 0.0:
                        turn, other = (-b2 - root) / (3.0 * a3), (-b2 + root) / (3.0 * a3)
                    elif b2 != 0.0:
                        turn = -0.5 * d1 / b2
                turn, other = min(max(min(turn, other), 0.0), 1.0), min(max(turn, other, 0.0), 1.0)
                low = 0.0
                for piece in range(3):
                    high = turn if piece == 0 else other if piece == 1 else 1.0
                    begin = ((a3 * low + b2) * low + d1) * low + f0
                    end = ((a3 * high + b2) * high + d1) * high + f0
                    if (begin > 0.0) != (end > 0.0) and high > low:
                        first, last = low, high
                        for _ in range(_HALVES):
                            half = 0.5 * (first + last)
                            value = ((a3 * half + b2) * half + d1) * half + f0
                            if (value > 0.0) == (begin > 0.0):
                                first = half
                            else:
                                last = half
                        if first < earliest and _within(work, tools, t, ia, ib, ic, along, last * T):
                            earliest = first
                            caught[t, 1] = f
                            caught[t, 9] = along
                            for q in range(3):
                                caught[t, 6 + q] = work.spot[0, q]
                    low = max(low, high)
    return earliest


@part
def _far(
    place: Float,
    rate: Float,
    mean: Float,
    middle: Float,
    axis: Float,
    ia: int,
    ib: int,
    ic: int,
    t: int,
    along: float,
    T: float,
) -> bool:
    """Whether boxes around the ways of a triangle and a ball's middle are apart."""
    for a in range(3):
        x = middle[t, a] + along * axis[t, a]
        y = x + T * mean[t, a]
        p0, p1, p2 = place[ia, a], place[ib, a], place[ic, a]
        q0, q1, q2 = p0 + T * rate[ia, a], p1 + T * rate[ib, a], p2 + T * rate[ic, a]
        if max(x, y) < min(p0, p1, p2, q0, q1, q2) or min(x, y) > max(p0, p1, p2, q0, q1, q2):
            return True
    return False


@part
def _volume(
    place: Float,
    rate: Float,
    mean: Float,
    middle: Float,
    axis: Float,
    ia: int,
    ib: int,
    ic: int,
    t: int,
    along: float,
    time: float,
) -> float:
    """Six times the volume of a triangle and a ball's middle, both moved for some time."""
    ax, ay, az = place[ia, 0] + time * rate[ia, 0], place[ia, 1] + time * rate[ia, 1], place[ia, 2] + time * rate[ia, 2]
    ux, uy, uz = (
        place[ib, 0] + time * rate[ib, 0] - ax,
        place[ib, 1] + time * rate[ib, 1] - ay,
        place[ib, 2] + time * rate[ib, 2] - az,
    )
    vx, vy, vz = (
        place[ic, 0] + time * rate[ic, 0] - ax,
        place[ic, 1] + time * rate[ic, 1] - ay,
        place[ic, 2] + time * rate[ic, 2] - az,
    )
    x = middle[t, 0] + along * axis[t, 0] + time * mean[t, 0] - ax
    y = middle[t, 1] + along * axis[t, 1] + time * mean[t, 1] - ay
    z = middle[t, 2] + along * axis[t, 2] + time * mean[t, 2] - az
    return x * (uy * vz - uz * vy) + y * (uz * vx - ux * vz) + z * (ux * vy - uy * vx)


@part
def _within(work: ContactWork, tools: Tools, t: int, ia: int, ib: int, ic: int, along: float, time: float) -> bool:
    """Whether a point in the plane of a moved triangle lies in it; row 0 of `spot` gets the corners' shares."""
    place, rate, spot = work.fit.place, work.rate, work.spot
    for a in range(3):
        spot[0, a] = place[ia, a] + time * rate[ia, a]
        spot[1, a] = place[ib, a] + time * rate[ib, a] - spot[0, a]
        spot[2, a] = place[ic, a] + time * rate[ic, a] - spot[0, a]
        spot[3, a] = tools.place[t, a] + along * tools.axis[t, a] + time * work.mean[t, a] - spot[0, a]
    uu, uv, vv, up, vp = 0.0, 0.0, 0.0, 0.0, 0.0
    for a in range(3):
        uu += spot[1, a] * spot[1, a]
        uv += spot[1, a] * spot[2, a]
        vv += spot[2, a] * spot[2, a]
        up += spot[1, a] * spot[3, a]
        vp += spot[2, a] * spot[3, a]
    size = uu * vv - uv * uv
    if not size > 0.0:
        return False
    b, c = (vv * up - uv * vp) / size, (uu * vp - uv * up) / size
    spot[0, 0], spot[0, 1], spot[0, 2] = 1.0 - b - c, b, c
    return b >= -_SLACK and c >= -_SLACK and b + c <= 1.0 + _SLACK
