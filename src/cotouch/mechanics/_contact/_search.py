"""A search for where body and tools go within a step that looks did not close, as `_closed/_direction_search`.

Looks solve for tools one by one, each as if the skin did not yield to it, and for the body as if tools did not. Where a
step is long both go too far, and a contact that was not there pushes with a thousand times of what holds in the end.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import Any

from cotouch.arrays import Float
from cotouch.kernels import FOUR, inner, load, part, splat, store
from cotouch.mechanics._closed._direction import COARSE, FEW, ask, predict
from cotouch.mechanics._closed._direction_missing import stiffen
from cotouch.mechanics._closed._direction_search import (
    BEST,
    FOUND,
    HOPELESS,
    Sought,
    begin_search,
    best_again,
    combine_kept,
    judge_look,
    stiffer,
)
from cotouch.mechanics._contact._grasp import feel_grasp
from cotouch.mechanics._contact._near import empty_rows
from cotouch.mechanics._contact._press import feel_tool
from cotouch.mechanics._contact._skin import fastest, follow, load_rows
from cotouch.mechanics._contact._sweep import NEVER, first_crossing
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._solve import solve_step
from cotouch.mechanics._linear._state import ITERATIONS, Links, Ports, State, Workspace
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import GRASP, TOUCHING, Tools

# Looks at most.
_LOOKS = 24


@part
def search_touched(
    law: Any,
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    surface: Surface,
    tools: Tools,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    enough: float,
    work: Workspace,
    touch: ContactWork,
    ledger: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> None:
    """Seeks motions of body and tools that miss none of the forces where they lead.

    Args:
        law: of the contact.
        op: the body.
        force: what resists inside it.
        state: of the copy.
        links: the neighbours' samples.
        ports: what else holds the copy.
        surface: the skin.
        tools: the proxies.
        local_damping: B_i, (weights,).
        extra_damping: B_e, (weights,).
        T: length of the step [s].
        enough: which share of the motion may be missed.
        work: scratch; `mean` gets the motion of the body that misses least.
        touch: scratch; gets that of the tools, and what contacts do by both.
        ledger: of the step; ITERATIONS is added to.
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.
    """
    count = tools.mode.shape[0]
    sought = Sought(touch.inertia, touch.mean, touch.lacks, touch.kept)
    firm = touch.missed
    begin_search(force.parts, work, lanes)
    for t in range(count):
        store(touch.mean, t, splat(0.0, FOUR), FOUR)
        store(touch.grips, t, splat(0.0, FOUR), FOUR)
        store(touch.kept, t, splat(0.0, FOUR), FOUR)
    for c in range(touch.many[0]):
        store(firm, touch.reach[c], splat(0.0, lanes), lanes)
    here = False
    for _ in range(_LOOKS):
        passes = _feel(law, surface, touch, tools, T, state, work, lanes)
        predict(op, force, state, T, False, work, lanes)
        ask(op, force, state, links, ports, local_damping, extra_damping, T, work, lanes)
        for c in range(touch.many[0]):
            i = touch.reach[c]
            store(work.rhs, i, load(work.rhs, i, lanes) + load(touch.push, i, lanes), lanes)
        for t in range(count):
            for a in range(3):
                touch.lacks[t, a] = touch.drive[t, a] + touch.pull[t, a] - touch.inertia[t] * touch.mean[t, a]
            if passes:
                touch.lacks[t, 0] = math.inf
        came = judge_look(force.parts, sought, enough, work, lanes)
        here = came in (BEST, FOUND)
        _keep_firm(touch, tools, here)
        if came in (FOUND, HOPELESS):
            break
        combine_kept(force.parts, sought, work, lanes)
        here = False
        _correct(op, ports, T, stiffer(work), work, touch, tools, ledger, tolerance, cap, lanes)
    if not here:
        best_again(force.parts, work, lanes)
        for t in range(count):
            store(touch.mean, t, load(touch.kept, t, FOUR), FOUR)
        _feel(law, surface, touch, tools, T, state, work, lanes)


@part
def _feel(
    law: Any,
    surface: Surface,
    touch: ContactWork,
    tools: Tools,
    T: float,
    state: State,
    work: Workspace,
    lanes: tuple[int, ...],
) -> bool:
    """Gathers what tools do by the present guess; returns whether any would pass the skin."""
    empty_rows(touch, lanes)
    touch.quick[0] = fastest(surface, work.mean, lanes)
    passes = False
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] == GRASP:
            feel_grasp(surface, touch, tools, t, T, state.position, work.mean, work.diagonal, True, lanes)
        elif tools.mode[t] == TOUCHING and tools.inside[t] == 0:
            follow(surface, touch, tools, t, T, state, work.mean, lanes)
            passes = passes or first_crossing(surface, touch, tools, t, T) < NEVER
            feel_tool(law, surface, touch, tools, t, T)
            load_rows(surface, touch, t, work.diagonal)
    return passes


@part
def _keep_firm(touch: ContactWork, tools: Tools, best: bool) -> None:
    """Keeps what resists in the contacts of the best look, and no less than in those that led astray since."""
    firm, grips = touch.missed, touch.grips
    for c in range(touch.many[0]):
        i = touch.reach[c]
        for a in range(firm.shape[1]):
            firm[i, a] = touch.hold[i] if best else max(firm[i, a], touch.hold[i])
    for t in range(tools.mode.shape[0]):
        for a in range(2):
            grips[t, a] = touch.grip[t, a] if best else max(grips[t, a], touch.grip[t, a])


@part
def _correct(
    op: Operator,
    ports: Ports,
    T: float,
    more: float,
    work: Workspace,
    touch: ContactWork,
    tools: Tools,
    ledger: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> None:
    """Corrects the rates of body and tools by what they miss; what resists in bodies and contacts is so much more.

    The system of the step is as that leaves it; each look makes it anew.
    """
    for i in range(op.mass.shape[0]):
        store(work.pull, i, load(work.mean, i, lanes), lanes)
    stiffen(op, T, more, work)
    for c in range(touch.many[0]):
        i = touch.reach[c]
        work.diagonal[i] += (1.0 + more) * touch.missed[i, 0]
    ledger[ITERATIONS] += solve_step(op, ports, work, max(tolerance, COARSE), FEW, cap, lanes)
    for i in range(op.mass.shape[0]):
        store(work.mean, i, load(work.mean, i, lanes) + load(work.pull, i, lanes), lanes)
    for t in range(tools.mode.shape[0]):
        wanted = 0.0
        for a in range(3):
            wanted += touch.way[t, a] * touch.lacks[t, a]
        along = touch.inertia[t] + (1.0 + more) * touch.grips[t, 0]
        across = touch.inertia[t] + (1.0 + more) * touch.grips[t, 1]
        if touch.way[t, 3] == 0.0:
            wanted, across = 0.0, along
        for a in range(3):
            way = touch.way[t, a]
            touch.mean[t, a] += (touch.lacks[t, a] - wanted * way) / across + wanted * way / along


@inner
def seekable(op: Operator, force: BodyForce, surface: Surface, work: Workspace) -> bool:
    """Whether a search is of use: one body, of many nodes that are solved for together.

    Args:
        op: the body's matrices.
        force: what resists inside the body.
        surface: the skin.
        work: `dense` says what is solved for at once.
    """
    return force.parts is None and op.entries.shape[0] > 0 and work.dense.shape[0] == 0 and surface.shape.shape[0] == 0
