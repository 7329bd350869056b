"""A tool whose middle would pass through the skin within a step is held back by a push that skin and tool share.

No energy of the state could stop it there: it would have to be stored within less than a radius. What it loses is
booked as lost.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.kernels import part
from cotouch.mechanics._contact._sweep import NEVER, first_crossing
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import Tools

# How far from the skin it is held, in radii, or where it was, but no nearer than that; and how exactly, in how far.
_APART, _NEAREST, _EXACT = 0.5, 0.1, 0.1
# By what it is held: the way out of a triangle, or all of its motion against the skin there.
_OUT, _ALL = 1.0, 2.0
# The push is at most so many times that which turns the tool's motion against a skin that does not yield.
_MOST = 2.0


@part
def begin_catch(op: Operator, surface: Surface, work: ContactWork, tools: Tools, t: int, T: float) -> None:
    """Chooses along what, and how far from the triangle of `first_crossing`, a tool is held, and how hard at most.

    Args:
        op: the body's matrices.
        surface: the skin.
        work: `caught` and `aside` are written.
        tools: the proxies.
        t: which of them.
        T: length of the step [s].
    """
    caught, aside, row = work.caught, work.aside, 3 * t
    apart = _turn_out(surface, work, tools, t)
    push, fast = 0.0, 0.0
    for a in range(3):
        push += work.pull[t, a] * aside[row, a]
        fast += (work.drive[t, a] / work.inertia[t] - _rate(surface, work, t, a)) ** 2
    for a in range(3):
        work.pull[t, a] = max(push, 0.0) * aside[row, a]
    caught[t, 0], caught[t, 2] = _OUT, 0.0
    caught[t, 5] = tools.radius[t] * min(_APART, max(apart / tools.radius[t], _NEAREST))
    caught[t, 10] = _MOST * work.inertia[t] * math.sqrt(fast)
    caught[t, 3] = T / work.inertia[t] + _loose(op, surface, work, t, T)


@part
def room(surface: Surface, work: ContactWork, tools: Tools, t: int) -> float:
    """Share of the way to the triangle of `first_crossing` that leaves a tool as far from it as it is held at least.

    Args:
        surface: the skin.
        work: `caught` says which triangle it is.
        tools: the proxies.
        t: which of them.
    """
    least = _NEAREST * tools.radius[t]
    apart = max(_turn_out(surface, work, tools, t), least)
    return 1.0 - least / apart


@part
def catch(surface: Surface, work: ContactWork, tools: Tools, t: int, T: float) -> bool:
    """Gathers the push on tool and skin that holds them apart at the end of a step.

    Where the present guess leads is compared with where the one before led: the push that is wanted follows. Who would
    then slip through beside what holds it, between triangles that move otherwise, is held where it is against the skin.

    Args:
        surface: the skin.
        work: `caught`, `aside`, `pull` and `force` are written.
        tools: the proxies.
        t: which of them.
        T: length of the step [s].

    Returns:
        Whether the present guess holds them apart well enough.
    """
    caught = work.caught
    settled = _follow_push(surface, work, tools, t, T)
    if settled and caught[t, 0] == _OUT and first_crossing(surface, work, tools, t, T) < NEVER:
        caught[t, 0], caught[t, 2] = _ALL, 0.0
        settled = _follow_push(surface, work, tools, t, T)
    for a in range(3):
        for q in range(3):
            work.force[surface.corner[int(caught[t, 1]), q], a] -= caught[t, 6 + q] * work.pull[t, a]
    work.total[t], work.grip[t, 0], work.grip[t, 1], work.way[t, 3] = 0.0, 0.0, 0.0, 0.0
    return settled


@part
def _turn_out(surface: Surface, work: ContactWork, tools: Tools, t: int) -> float:
    """Chooses the way out of the triangle of `first_crossing` as that along which a tool is held; how far it is [m]."""
    place, caught, aside, row = work.fit.place, work.caught, work.aside, 3 * t
    f = int(caught[t, 1])
    ia, ib, ic = surface.corner[f, 0], surface.corner[f, 1], surface.corner[f, 2]
    ux, uy, uz = place[ib, 0] - place[ia, 0], place[ib, 1] - place[ia, 1], place[ib, 2] - place[ia, 2]
    vx, vy, vz = place[ic, 0] - place[ia, 0], place[ic, 1] - place[ia, 1], place[ic, 2] - place[ia, 2]
    aside[row, 0], aside[row, 1], aside[row, 2] = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size, apart = 0.0, 0.0
    for a in range(3):
        size += aside[row, a] * aside[row, a]
        apart += aside[row, a] * (tools.place[t, a] + caught[t, 9] * tools.axis[t, a] - place[ia, a])
    size = math.sqrt(size) if apart >= 0.0 else -math.sqrt(size)
    for a in range(3):
        aside[row, a] /= size
    return apart / size


@part
def _rate(surface: Surface, work: ContactWork, t: int, a: int) -> float:
    """How fast the skin moves along an axis where a tool is held [m/s]."""
    rate = 0.0
    for q in range(3):
        rate += work.caught[t, 6 + q] * work.rate[surface.corner[int(work.caught[t, 1]), q], a]
    return rate


@part
def _loose(op: Operator, surface: Surface, work: ContactWork, t: int, T: float) -> float:
    """How far a push takes the skin, by its masses alone: at most so far [m/N]; 0 in a modal basis, where that is open.

    A push that began with what the tool alone yields would throw light vertices out of the body, and what came of that
    would tell nothing.
    """
    yields = 0.0
    for q in range(3 if surface.shape.shape[0] == 0 else 0):
        v = surface.corner[int(work.caught[t, 1]), q]
        for k in range(surface.row.shape[1]):
            share = work.caught[t, 6 + q] * surface.weight[v, k]
            yields += 0.5 * share * share * T * T / (op.copy_scale * op.mass[surface.row[v, k, 0]])
    return yields


@part
def _follow_push(surface: Surface, work: ContactWork, tools: Tools, t: int, T: float) -> bool:
    """Corrects the push by what it lacks of where it is to lead; returns whether that is little, or no push helps."""
    place, caught, aside, pull, row = work.fit.place, work.caught, work.aside, work.pull, 3 * t
    wanted, lacks, gap, push = caught[t, 5], row + 1, 0.0, 0.0
    for a in range(3):
        apart = tools.place[t, a] + caught[t, 9] * tools.axis[t, a]
        for q in range(3):
            apart -= caught[t, 6 + q] * place[surface.corner[int(caught[t, 1]), q], a]
        goes = T * (work.mean[t, a] - _rate(surface, work, t, a))
        gap += aside[row, a] * (apart + goes)
        push += aside[row, a] * pull[t, a]
        work.spot[0, a] = -goes
    if caught[t, 0] == _OUT:
        for a in range(3):
            work.spot[0, a] = (wanted - gap) * aside[row, a]
    square, did, along = 0.0, 0.0, 0.0
    for a in range(3):
        more = pull[t, a] - aside[row + 2, a]
        square += work.spot[0, a] * work.spot[0, a]
        did += more * more
        along += more * (aside[lacks, a] - work.spot[0, a])
    if square <= (_EXACT * wanted) ** 2 or (caught[t, 0] == _OUT and gap > wanted and push <= 0.0):
        return True
    yields = caught[t, 3]
    if caught[t, 2] != 0.0 and did > 0.0:  # as the tool does alone: skin that yields as well does no less
        yields = max(along / did, T / work.inertia[t])
    size = 0.0
    for a in range(3):
        aside[lacks, a], aside[row + 2, a] = work.spot[0, a], pull[t, a]
        pull[t, a] += work.spot[0, a] / yields
        size += pull[t, a] * pull[t, a]
    size = math.sqrt(size)
    if caught[t, 0] == _OUT and push + (wanted - gap) / yields < 0.0:
        size = math.inf
    if size > caught[t, 10]:
        for a in range(3):
            pull[t, a] *= caught[t, 10] / size
    change = 0.0
    for a in range(3):
        change += abs(pull[t, a] - aside[row + 2, a])
    same, caught[t, 2] = caught[t, 2] != 0.0 and change == 0.0, 1.0
    return same
