"""A tool whose middle would pass through the skin within a step is held back by a push that skin and tool share.

No energy of the state could stop it there: it would have to be stored within less than a radius. What it loses is
booked as lost.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.mechanics._contact_work import ContactWork
from cotouch.mechanics._kernel import part
from cotouch.mechanics._surface import Surface
from cotouch.mechanics._tools import Tools

# How far from the skin it is held, in radii or in how far it was before, and how exactly, in that.
_APART, _EXACT = 0.5, 0.2


@part
def begin_catch(surface: Surface, work: ContactWork, tools: Tools, t: int) -> None:
    """Chooses along what, and how far from the triangle of `first_crossing`, a tool is held."""
    p, place, caught, aside = t - tools.first, work.fit.place, work.caught, work.aside
    f = int(caught[p, 1])
    ia, ib, ic = surface.corner[f, 0], surface.corner[f, 1], surface.corner[f, 2]
    ux, uy, uz = place[ib, 0] - place[ia, 0], place[ib, 1] - place[ia, 1], place[ib, 2] - place[ia, 2]
    vx, vy, vz = place[ic, 0] - place[ia, 0], place[ic, 1] - place[ia, 1], place[ic, 2] - place[ia, 2]
    aside[p, 0], aside[p, 1], aside[p, 2] = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size, apart = 0.0, 0.0
    for a in range(3):
        size += aside[p, a] * aside[p, a]
        apart += aside[p, a] * (tools.place[t, a] + caught[p, 9] * tools.axis[t, a] - place[ia, a])
    size = math.sqrt(size) if apart >= 0.0 else -math.sqrt(size)
    for a in range(3):
        aside[p, a] /= size
    caught[p, 0], caught[p, 2], caught[p, 3], caught[p, 4] = 1.0, -1.0, 0.0, 0.0
    caught[p, 5] = _APART * min(tools.radius[t], apart / size)


@part
def catch(surface: Surface, work: ContactWork, tools: Tools, t: int, T: float) -> bool:
    """Gathers the push on tool and skin that holds them apart at the end of a step.

    Where the present guess leads is compared with where the one before led: the push that is wanted follows.

    Returns:
        Whether the present guess holds them apart well enough.
    """
    p, place, rate, caught, aside = t - tools.first, work.fit.place, work.rate, work.caught, work.aside
    f = int(caught[p, 1])
    gap = 0.0
    for a in range(3):
        apart = tools.place[t, a] + caught[p, 9] * tools.axis[t, a] + T * work.mean[p, a]
        for q in range(3):
            v = surface.corner[f, q]
            apart -= caught[p, 6 + q] * (place[v, a] + T * rate[v, a])
        gap += aside[p, a] * apart
    wanted, push = caught[p, 5], caught[p, 4]
    settled = abs(gap - wanted) <= _EXACT * wanted or (gap > wanted and push == 0.0 and caught[p, 2] >= 0.0)
    if not settled:
        yields = T / work.inertia[p]
        if caught[p, 2] >= 0.0 and (gap - caught[p, 3]) * (push - caught[p, 2]) > 0.0:
            yields = (gap - caught[p, 3]) / (push - caught[p, 2])
        caught[p, 2], caught[p, 3] = push, gap
        caught[p, 4] = max(push + (wanted - gap) / yields, 0.0)
    for a in range(3):
        work.pull[p, a] = caught[p, 4] * aside[p, a]
        for q in range(3):
            work.force[surface.corner[f, q], a] -= caught[p, 4] * caught[p, 6 + q] * aside[p, a]
    work.total[p], work.grip[p, 0], work.grip[p, 1], work.way[p, 3] = 0.0, 0.0, 0.0, 0.0
    return settled
