"""The balls in a row that stand for a long tool, and which of the triangles near it each may reach."""
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Int
from cotouch.kernels import FOUR, at, load, lower, part, put, splat, total, upper
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._model._tools import Tools

# How much farther a ball is taken to reach, of all lengths that this is worked out from, than rounding may be.
_SLACK = 1e-9


@part
def beads(tools: Tools, t: int) -> int:
    """How many balls stand for a tool: one, or a row of them half a radius apart.

    Args:
        tools: the proxies.
        t: which of them.
    """
    axis, square = tools.axis, 0.0
    for a in range(3):
        square += axis[t, a] * axis[t, a]
    return 1 if square == 0.0 else 2 + int(4.0 * math.sqrt(square) / tools.radius[t])


@part
def bead_place(tools: Tools, t: int, bead: int) -> float:
    """Where a ball of the row is: its middle is that of the tool and so many times the axis.

    Args:
        tools: the proxies.
        t: which of them.
        bead: which of its balls, from 0.
    """
    count = beads(tools, t)
    return 0.0 if count == 1 else 2.0 * bead / (count - 1) - 1.0


@part
def reached(corner: Int, work: ContactWork, tools: Tools, t: int, reach: float, begin: float, end: float) -> int:
    """Notes which of the triangles near a tool, four by four, balls of its row may reach, and which balls those are.

    All of the row are near to few of the triangles that are near to the tool, so each ball would look at most of them
    in vain. A ball around the way of four of them, as the tool sees it, is compared with the row.

    Args:
        corner: vertices of the triangles.
        work: `near`, `rate` and `mean` say what moves; `span` gets the first of each four, its first and its last ball.
        tools: the proxies.
        t: which of them.
        reach: of a ball, from its middle [m].
        begin: of the time in which they may reach it [s].
        end: of that time [s].

    Returns:
        How many fours.
    """
    near, place, rate, span, last = work.near, work.fit.place, work.rate, work.span, beads(tools, t) - 1
    middle, axis, goes = load(tools.place, t, FOUR), load(tools.axis, t, FOUR), load(work.mean, t, FOUR)
    square, count, kept = total(axis * axis), work.number[t], 0
    for first in range(0, count, 4):
        low, high, one, two = splat(math.inf, FOUR), splat(-math.inf, FOUR), 0, last
        for c in range(first, min(first + 4, count) if last > 0 else 0):
            for q in range(3):
                v = at(corner, (at(near, (t, c)), q))
                way = load(rate, v, FOUR) - goes
                start = load(place, v, FOUR) - middle
                before, after = start + begin * way, start + end * way
                low, high = lower(low, lower(before, after)), upper(high, upper(before, after))
        if last > 0:
            between, half = 0.5 * (low + high), 0.5 * (high - low)
            apart, within = total(between * between), reach + math.sqrt(total(half * half))
            along = total(between * axis) / square
            spare = within * within - (apart - along * along * square) + _SLACK * (within * within + apart)
            if spare < 0.0:
                continue
            if spare < math.inf:  # what is no number is reached by all
                wide = (1.0 + _SLACK) * math.sqrt(spare / square)
                least, most = 0.5 * last * (along - wide + 1.0), 0.5 * last * (along + wide + 1.0)
                if least > last or most < 0.0:
                    continue
                one, two = int(max(least, 0.0)), min(int(most) + 1, last) if most < last else last
        put(span, (kept, 0), first)
        put(span, (kept, 1), one)
        put(span, (kept, 2), two)
        kept += 1
    return kept
