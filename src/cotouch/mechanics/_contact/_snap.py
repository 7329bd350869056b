"""Magnetic snap: within a short range of the skin a tool is drawn to it, by an energy of the state.

Each unit of area holds `-σ S(r²)`, r the distance to the tool's middle: S is 1 up to the tool's radius and falls to 0
within the range, by two parabolas in r² with one slope between them. Of three balls with the law of an elastic
foundation this is the second difference, so the sum over the skin is as exact as theirs. A flat draws with
`2 π z σ S(z²)`, z the height of the middle: σ is such that its greatest value is the pull-off force.
"""
# pyright: reportArgumentType=false, reportReturnType=false, reportOperatorIssue=false

import math
from math import pi

from cotouch.arrays import Float
from cotouch.kernels import FOUR, at, four, part, splat, store
from cotouch.mechanics._contact._beads import beads, reached
from cotouch.mechanics._contact._patch import MEETS, overlap_one, press_triangle
from cotouch.mechanics._contact._skin import note_hit, place_bead, place_face
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._contact_laws._foundation import Foundation, stiffness_of
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import Tools

# A change by more than this share of pull-off force and range was made from outside, and is no rounding.
_CHANGED = 1e-9
# By what share of its pull-off force a tool's motion pays what it owes; in proportion to speed below this [m/s].
_SHARE, _SLOW = 0.5, 0.01


@part
def draw_triangle(
    pull_off: float,
    radius: float,
    width: float,
    area: float,
    forces: bool,
    spot: Float,
    met: Float,
    out: Float,
    drawn: Float,
) -> float:
    """Works out how one ball and one triangle draw each other.

    Args:
        pull_off: greatest force that a flat draws with [N].
        radius: of the ball [m].
        width: the range [m].
        area: of the triangle at rest [m²].
        forces: whether to work out more than the energy.
        spot: its corners and the middle of the ball, (4, 4) [m].
        met: scratch, (FOUND, 4).
        out: scratch, (4, 4).
        drawn: result, as of `press_triangle`, of which the shares of the corners are not used.

    Returns:
        Sum of the sizes of what the energy is the difference of [J].
    """
    square = radius * radius
    half = 0.5 * width * (2.0 * radius + width)
    # Height of the pull-off, in r² beyond the radius, and the force there if σ were 1 / (2 π R).
    peak = 0.4 * (math.sqrt(square * square + 2.5 * half * half) - square)
    most = math.sqrt(1.0 + peak / square) * (1.0 - 0.5 * (peak / half) ** 2)
    modulus = 4.0 * pull_off / (2.0 * pi * radius * most) / (half * half)
    size = 0.0
    for q in range(4):
        store(drawn, q, splat(0.0, FOUR), FOUR)
    if not overlap_one(spot, four(square, square + half, square + 2.0 * half, 0.0), met):
        return size
    for k in range(3):
        if not at(met, (MEETS, k)) > 0.0:
            continue
        ball = math.sqrt(square + k * half)
        stiffness = stiffness_of(modulus * ball * ball, ball)
        press_triangle(Foundation(1.0), stiffness, ball, area, forces, False, met, k, out)
        sign = 2.0 if k == 1 else -1.0
        drawn[3, 3] += sign * out[3, 3]
        size += abs(sign * out[3, 3])
        for q in range(3):
            for a in range(3):
                drawn[q, a] += sign * out[q, a]
            drawn[3, q] += (k - 1.0) * out[3, q]  # the size of the slope: it changes its sign half-way
    return size


@part
def draw_tool(
    surface: Surface, work: ContactWork, tools: Tools, t: int, time: float, share: float
) -> tuple[float, float]:
    """Energy between a tool and the skin that it is drawn to after both moved for some time, at most 0.

    Args:
        surface: the skin.
        work: `near`, `rate` and `mean` say what moves; with a share, forces are added to what it gathers.
        tools: the proxies.
        t: which of them.
        time: how long they moved [s].
        share: of the forces there that acts in the step; 0: none, and nothing is written.

    Returns:
        The energy, and the sum of the sizes of what it is the difference of [J].
    """
    corner, near = surface.corner, work.near
    spot, drawn = work.spot, work.drawn
    reach = tools.radius[t] + tools.snap_range[t]
    energy, size = 0.0, 0.0
    fours, span = reached(corner, work, tools, t, reach, time, time), work.span
    for bead in range(beads(tools, t)):
        place_bead(work, tools, t, bead, time)
        for n in range(4 * fours):
            c = span[n // 4, 0] + n % 4
            if c >= work.number[t] or bead < span[n // 4, 1] or bead > span[n // 4, 2]:
                continue
            f = near[t, c]
            if place_face(work, f, corner, time) >= reach * reach:
                continue
            size += draw_triangle(
                tools.snap[t],
                tools.radius[t],
                tools.snap_range[t],
                surface.area[f],
                share != 0.0,
                spot,
                work.met,
                work.out,
                drawn,
            )
            energy += drawn[3, 3]
            if share == 0.0:
                continue
            note_hit(work, t, c)
            for q in range(3):
                v, firm = corner[f, q], share * time * drawn[3, q]
                for a in range(3):
                    work.force[v, a] += share * drawn[q, a]
                    work.pull[t, a] -= share * drawn[q, a]
                work.apart[v] += firm
                work.grip[t, 0] += firm
                work.grip[t, 1] += firm
    return energy, size


@part
def begin_snap(surface: Surface, work: ContactWork, tools: Tools, t: int) -> None:
    """Lets the skin draw a tool that is out of range and owes nothing; not one that was moved away from outside.

    Args:
        surface: the skin.
        work: what is near, and scratch.
        tools: the proxies; `snaps` is written.
        t: which of them.
    """
    if tools.snap[t] <= 0.0 or tools.inside[t] != 0:
        return
    energy, size = draw_tool(surface, work, tools, t, 0.0, 0.0)
    if tools.snaps[t] == 0:
        if size == 0.0 and tools.owed[t] == 0.0:
            tools.snaps[t] = 1
    elif energy > tools.well[t] + _CHANGED * tools.snap[t] * tools.snap_range[t]:
        end_snap(tools, t)


@part
def end_snap(tools: Tools, t: int) -> None:
    """No longer draws a tool, which owes what it would have taken to pull it off.

    Else taking it away, and letting it be drawn again, would give energy each time.

    Args:
        tools: the proxies; `owed`, `well` and `snaps` are written.
        t: which of them.
    """
    tools.owed[t] -= tools.well[t]
    tools.well[t], tools.snaps[t] = 0.0, 0


@part
def owed_drag(tools: Tools, t: int) -> float:
    """What resists the motion of a tool that owes energy [Ns/m].

    Args:
        tools: the proxies.
        t: which of them.
    """
    if tools.owed[t] <= 0.0:
        return 0.0
    fast = 0.0
    for a in range(3):
        fast += tools.rate[t, a] * tools.rate[t, a]
    return _SHARE * tools.snap[t] / max(math.sqrt(fast), _SLOW)
