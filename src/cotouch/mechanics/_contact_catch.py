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
    place, caught, aside = work.fit.place, work.caught, work.aside
    f = int(caught[t, 1])
    ia, ib, ic = surface.corner[f, 0], surface.corner[f, 1], surface.corner[f, 2]
    ux, uy, uz = place[ib, 0] - place[ia, 0], place[ib, 1] - place[ia, 1], place[ib, 2] - place[ia, 2]
    vx, vy, vz = place[ic, 0] - place[ia, 0], place[ic, 1] - place[ia, 1], place[ic, 2] - place[ia, 2]
    aside[t, 0], aside[t, 1], aside[t, 2] = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size, apart = 0.0, 0.0
    for a in range(3):
        size += aside[t, a] * aside[t, a]
        apart += aside[t, a] * (tools.place[t, a] + caught[t, 9] * tools.axis[t, a] - place[ia, a])
    size = math.sqrt(size) if apart >= 0.0 else -math.sqrt(size)
    for a in range(3):
        aside[t, a] /= size
    caught[t, 0], caught[t, 2], caught[t, 3], caught[t, 4] = 1.0, -1.0, 0.0, 0.0
    caught[t, 5] = _APART * min(tools.radius[t], apart / size)


@part
def catch(surface: Surface, work: ContactWork, tools: Tools, t: int, T: float) -> bool:
    """Gathers the push on tool and skin that holds them apart at the end of a step.

    Where the present guess leads is compared with where the one before led: the push that is wanted follows.

    Returns:
        Whether the present guess holds them apart well enough.
    """
    place, rate, caught, aside = work.fit.place, work.rate, work.caught, work.aside
    f = int(caught[t, 1])
    gap = 0.0
    for a in range(3):
        apart = tools.place[t, a] + caught[t, 9] * tools.axis[t, a] + T * work.mean[t, a]
        for q in range(3):
            v = surface.corner[f, q]
            apart -= caught[t, 6 + q] * (place[v, a] + T * rate[v, a])
        gap += aside[t, a] * apart
    wanted, push = caught[t, 5], caught[t, 4]
    settled = abs(gap - wanted) <= _EXACT * wanted or (gap > wanted and push == 0.0 and caught[t, 2] >= 0.0)
    if not settled:
        yields = T / work.inertia[t]  # as the tool does alone: skin that yields as well does no less
        if caught[t, 2] >= 0.0 and push != caught[t, 2]:
            yields = max((gap - caught[t, 3]) / (push - caught[t, 2]), yields)
        caught[t, 2], caught[t, 3] = push, gap
        caught[t, 4] = max(push + (wanted - gap) / yields, 0.0)
    for a in range(3):
        work.pull[t, a] = caught[t, 4] * aside[t, a]
        for q in range(3):
            work.force[surface.corner[f, q], a] -= caught[t, 4] * caught[t, 6 + q] * aside[t, a]
    work.total[t], work.grip[t, 0], work.grip[t, 1], work.way[t, 3] = 0.0, 0.0, 0.0, 0.0
    return settled
