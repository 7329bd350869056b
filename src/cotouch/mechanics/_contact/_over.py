"""What a scaled motion of tools and body leaves over of the energy that came in, and where a little of that stays."""
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import Any

from cotouch.kernels import FOUR, at, load, part, splat, store, total
from cotouch.mechanics._contact._grasp import hold_energy
from cotouch.mechanics._contact._press import press_tool, pressing, rub
from cotouch.mechanics._contact._snap import draw_tool
from cotouch.mechanics._contact._sweep import first_crossing
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import Workspace
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import GRASP, TOUCHING, Tools

# A difference below this share of what made it is rounding.
ROUNDING = 8e-16


@part
def over_of(
    law: Any,
    surface: Surface,
    touch: ContactWork,
    tools: Tools,
    T: float,
    free: float,
    contact: float,
    inflow: float,
    body: bool,
    scale: float,
    beyond: float,
) -> tuple[float, float, float]:
    """What a scaled motion leaves over, of tools and, if so, a linear body; its rounding; what the tools lose [J].

    So far `beyond` the scale that the energy of pressure was last worked out at, it is foretold; 0: it is worked out.

    Args:
        law: of the contact.
        surface: the skin.
        touch: `mean` is the motion; `stored`, `pressed` and `well` are written.
        tools: the proxies.
        T: length of the step [s].
        free: power `v̂ᵀ b` of the body's system without contacts [W].
        contact: power of contacts on the body [W].
        inflow: power that goes in and out, by size [W].
        body: whether a linear body's balance is part of it.
        scale: of the motion, 0 to 1.
        beyond: by how much the scale is past the one that pressure was worked out at; 0: it is worked out.
    """
    over = T * scale * ((1.0 - scale) * free - scale * contact) if body else 0.0
    lost, stored = 0.0, 0.0
    for t in range(tools.mode.shape[0]):
        for a in range(3):
            rate = scale * touch.mean[t, a]
            over += T * rate * (touch.drive[t, a] - touch.inertia[t] * rate)
            stored += 0.0 if body else T * touch.inertia[t] * rate * rate
        gone, size = 0.0, 0.0
        if tools.mode[t] == TOUCHING and tools.inside[t] == 0:
            if beyond == 0.0:
                touch.pressed[t, 1] = press_tool(law, surface, touch, tools, t, scale * T, 0.0, True)
            touch.stored[t] = touch.pressed[t, 1] - beyond * T * pressing(touch, t)
            rubbed, gone, _ = rub(touch, tools, t, scale * T, T)
            if tools.snaps[t] != 0:
                touch.well[t], size = draw_tool(surface, touch, tools, t, scale * T, 0.0)
                rubbed += touch.well[t]
            touch.stored[t] += rubbed
        elif tools.mode[t] == GRASP:
            touch.stored[t], gone = hold_energy(touch, tools, t, scale * T, T)
            stored += tools.grip_stiffness[t] * touch.held[t, 0]
        over -= touch.stored[t] - tools.owed[t] - tools.stored[t] + gone
        lost += gone
        stored += abs(touch.stored[t]) + abs(tools.stored[t]) + 2.0 * size
    return over, ROUNDING * (T * scale * inflow + stored), lost


@part
def leave(touch: ContactWork, tools: Tools, over: float) -> bool:
    """Lets the tool that does most work keep what the next step is to make up for; whether there is one.

    Args:
        touch: `stored` of that tool changes.
        tools: the proxies.
        over: what the step leaves over [J].
    """
    chosen, most = -1, 0.0
    for t in range(tools.mode.shape[0]):
        work = 0.0
        for a in range(3):
            work += abs(touch.mean[t, a] * touch.pull[t, a])
        if tools.mode[t] in (TOUCHING, GRASP) and work > most:
            chosen, most = t, work
    if chosen >= 0:
        touch.stored[chosen] += over
    return chosen >= 0


@part
def driven(touch: ContactWork, tools: Tools) -> float:
    """Power that drives and motion give tools, by size [W].

    Args:
        touch: what is near, and scratch.
        tools: the proxies.
    """
    power = 0.0
    for t in range(tools.mode.shape[0]):
        for a in range(3):
            power += abs(touch.mean[t, a] * touch.drive[t, a])
    return power


@part
def holds(touch: ContactWork, tools: Tools) -> bool:
    """Whether any contact holds energy before the step or after it.

    Args:
        touch: `stored` says what is held after the step.
        tools: the proxies.
    """
    held = False
    for t in range(tools.mode.shape[0]):
        held = held or touch.stored[t] > 0.0 or tools.stored[t] > 0.0
    return held


@part
def moved_by(op: Operator, touch: ContactWork, T: float, work: Workspace, lanes: tuple[int, ...]) -> float:
    """Power that inertia asks for, of a body and its tools [W].

    Args:
        op: the body's matrices.
        touch: what is near, and scratch.
        T: length of the step [s].
        work: scratch; see `Workspace`.
        lanes: fixes the width of a row.
    """
    body, tools = _squares(op, touch, work, lanes)
    return 2.0 * op.copy_scale / T * body + tools


@part
def _squares(op: Operator, touch: ContactWork, work: Workspace, lanes: tuple[int, ...]) -> tuple[float, float]:
    """`Σ m v̂²` of a body as it would go, and of its tools with their inertia in the place of m."""
    moving, own = splat(0.0, lanes), 0.0
    for i in range(work.mean.shape[0]):
        rate = load(work.mean, i, lanes)
        moving = moving + at(op.mass, i) * (rate * rate)
    for t in range(touch.mean.shape[0]):
        for a in range(3):
            own += touch.inertia[t] * touch.mean[t, a] * touch.mean[t, a]
    return total(moving), own


@part
def went_astray(op: Operator, touch: ContactWork, work: Workspace, lanes: tuple[int, ...]) -> bool:
    """Whether looks led to where nothing can be weighed; then nothing goes anywhere, and no tool pushes.

    Args:
        op: the body's matrices.
        touch: what tools do by the last look; 0 afterwards, if so.
        work: `mean` likewise.
        lanes: fixes the width of a row.
    """
    body, own = _squares(op, touch, work, lanes)
    size = body + own
    for t in range(touch.mean.shape[0]):
        size += abs(touch.held[t, 1]) + touch.held[t, 2]
        for a in range(3):
            size += abs(touch.pull[t, a])
    if size * size * size < math.inf:  # a volume that grows like this has an energy that is a number
        return False
    for i in range(work.mean.shape[0]):
        store(work.mean, i, splat(0.0, lanes), lanes)
        store(touch.push, i, splat(0.0, lanes), lanes)
    touch.quick[0] = 0.0
    for v in range(touch.rate.shape[0]):
        store(touch.rate, v, splat(0.0, FOUR), FOUR)
    for t in range(touch.mean.shape[0]):
        touch.patch[t], touch.held[t, 1], touch.held[t, 2] = 0.0, 0.0, 0.0
        for array in (touch.mean, touch.pull, touch.way, touch.skin):
            store(array, t, splat(0.0, FOUR), FOUR)
    return True


@part
def passes(surface: Surface, touch: ContactWork, tools: Tools, time: float) -> bool:
    """Whether any tool passes the skin within some time.

    Args:
        surface: the skin.
        touch: what is near, and scratch.
        tools: the proxies.
        time: for how long all move on as they do [s].
    """
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] == TOUCHING and tools.inside[t] == 0 and first_crossing(surface, touch, tools, t, time) <= 1.0:
            return True
    return False


@part
def stretch_tool(touch: ContactWork, t: int, factor: float) -> None:
    """Scales how far a tool goes, and what it holds; what overflowed would be no number times 0.

    Args:
        touch: `mean`, `skin` and `held` are changed.
        t: which tool.
        factor: by which it is scaled, >= 0.
    """
    goes = factor > 0.0
    touch.held[t, 1] = factor * touch.held[t, 1] if goes else 0.0
    touch.held[t, 2] = factor * factor * touch.held[t, 2] if goes else 0.0
    for a in range(3):
        touch.mean[t, a] = factor * touch.mean[t, a] if goes else 0.0
        touch.skin[t, a] = factor * touch.skin[t, a] if goes else 0.0
