"""One step of a copy with its user's tools, whose contacts and grasps are an energy of the state.

A few looks find where body and tools go. Whatever they miss, one scale over the motion of body and tools makes the
energy of the contact, and of the step, exact [after DESIGN.md, "One scale keeps the energy identity"].
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import Any

from cotouch.arrays import Float, Int
from cotouch.kernels import block, load, part, splat, store
from cotouch.mechanics._closed._balance_parts import hold_parts
from cotouch.mechanics._closed._debris import drop_debris, free_debris
from cotouch.mechanics._closed._direction import begin_looks, level, predict
from cotouch.mechanics._closed._direction_combined import dot_rows
from cotouch.mechanics._closed._direction_missing import hold_ports
from cotouch.mechanics._closed._direction_more import MOST_LOOKS, leaves_little, rough
from cotouch.mechanics._contact._absent import hide_away
from cotouch.mechanics._contact._balance import balanced
from cotouch.mechanics._contact._catch import begin_catch, catch
from cotouch.mechanics._contact._centre import JAMMED, lose_motion
from cotouch.mechanics._contact._follow import follow_all
from cotouch.mechanics._contact._grasp import feel_grasp, take
from cotouch.mechanics._contact._near import correct_near, empty_rows, forget_rows, tell
from cotouch.mechanics._contact._outside import begin_tool, feel_first
from cotouch.mechanics._contact._press import feel_tool
from cotouch.mechanics._contact._proxy import book_drive, move_proxy, pay, proxy_drive, proxy_inertia
from cotouch.mechanics._contact._settled import changed, settled
from cotouch.mechanics._contact._skin import fastest, follow, found_fastest, length_of, load_rows, look_around, reach_of
from cotouch.mechanics._contact._snap import begin_snap, end_snap, owed_drag
from cotouch.mechanics._contact._solve import solve_touched
from cotouch.mechanics._contact._sweep import NEVER, first_crossing
from cotouch.mechanics._contact._work import Contact, ContactWork
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import ITERATIONS, Links, Ports, State, Workspace
from cotouch.mechanics._linear._step import assemble
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._materials._memory import looks_ahead
from cotouch.mechanics._meeting._world_force import looks_of, take_up
from cotouch.mechanics._meeting._world_lean import lean_world
from cotouch.mechanics._model._fit import refit
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import BLADE, GRASP, TOUCH_LOSS, TOUCH_STORED, TOUCHING, Tools

# Looks at most; the change of forces of a linear body at which one more correction is enough.
_LOOKS, _NEARLY = 12, 1e-3
# How far a tool looks around beyond its radius, in radii and in ways of a step; below how many radii those are short.
_MARGIN, _WAYS, _SLOW = 0.05, 3.0, 0.05
# A force below this share of what made it is rounding.
_ROUNDING = 1e-13


@block
def contact_step(
    by: Contact,
    op: Operator,
    force: BodyForce | None,
    state: State,
    links: Links,
    ports: Ports,
    surface: Surface,
    tools: Tools,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    sample: int,
    work: Workspace,
    ledger: Float,
    touch_ledger: Float,
    link_work: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> None:
    """Advances one copy and its tools by T; see `step`, whose arguments these are.

    Args:
        by: the law of the contact, and scratch.
        op: the body's matrices.
        force: what resists inside the body beside them; None: nothing.
        state: of the copy; changed in place.
        links: the neighbours' samples.
        ports: what else holds the copy.
        surface: the body's skin.
        tools: the proxies; changed in place.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step, > 0 [s].
        sample: slot of `links.samples` that receives x̂; negative: none.
        work: scratch.
        ledger: result (LEDGER_COLUMNS,), as of `step`.
        touch_ledger: result (TOUCH_LEDGER,): see `cotouch.mechanics.TOUCH_LEDGER`.
        link_work: result (links,).
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.
    """
    for book in range(touch_ledger.shape[0]):
        touch_ledger[book] = 0.0
    law, touch = by.law, by.work
    mean, push, hold, modal = work.mean, touch.push, touch.hold, surface.shape.shape[0] > 0
    near = not modal and op.entries.shape[0] > 0 and work.dense.shape[0] == 0
    _drive(tools, touch, T)
    forget_rows(touch, lanes)
    look = _begin(law, surface, touch, tools, T, state, op.debris, touch_ledger, force is None, lanes)
    guess = state.velocity
    ledger[ITERATIONS], looks, directions, change, enough, last = 0.0, 1, 1, math.inf, 0.0, False
    # Whether the first look corrects the velocity already: what it leaves, the second finds.
    begins = corrects = False
    material, was, rounded = force is not None, 0.0, 0.0
    if force is not None:
        for i in range(mean.shape[0]):
            store(mean, i, load(state.velocity, i, lanes), lanes)
        take_up(force.world, state.memory, state.position)
        free_debris(op, ports, lanes)
        begin_looks(work)
        directions = looks_ahead(state.memory, force.directions, force.cut)
        looks = looks_of(force.world, directions, work.dense.shape[0] > 0)
        begins, rounded = looks > 1, rough(op, force, state)
    for number in range(_LOOKS + looks):
        empty_rows(touch, lanes)
        touch.yields[0] = touch.yields[1] = touch.yields[2] = 0.0
        if modal:
            for i in range(mean.shape[0]):
                store(push, i, splat(0.0, lanes), lanes)
        before, change = change, 0.0
        for t in range(tools.mode.shape[0]):
            if look and (tools.mode[t] == GRASP or (tools.mode[t] == TOUCHING and tools.inside[t] == 0)):
                change = max(
                    change,
                    _look(
                        law,
                        op,
                        surface,
                        touch,
                        tools,
                        t,
                        T,
                        state,
                        guess,
                        work.diagonal,
                        number == 0 and force is None,
                        lanes,
                    ),
                )
        if number >= looks:
            enough = settled(op, force, state, guess, touch, tools, T, change, near, lanes)
            if change <= enough:
                break
            last = near and (change <= _NEARLY if force is None else change * change <= enough * min(before, 1.0))
        if number < looks or not near:
            for c in range(touch.many[0]):
                i = touch.reach[c]
                store(push, i, load(push, i, lanes) + hold[i] * load(guess, i, lanes), lanes)
        if number < looks:  # what the body asks for; later looks only tell contacts apart
            same, corrects = True, near and (number > 0 or begins)
            if force is not None:
                same = predict(op, force, state, T, not corrects, work, lanes)
                if same and number >= directions:
                    looks = number  # obstacles are told as well
            assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
            if force is not None:
                lean_world(force.world, op.copy_scale * op.firmness, mean, work, lanes)
                hold_ports(op, ports, work)
        if number >= looks and near:
            leaves = enough / change if change > 0.0 else 0.0
            ledger[ITERATIONS] += correct_near(op, work, touch, leaves, force is None, cap, lanes)
        else:
            bent, moving = solve_touched(
                op, ports, touch, state, work, T, number, modal, corrects, material, ledger, tolerance, cap, lanes
            )
            touch.quick[0] = found_fastest(surface, touch, mean, lanes)
            if material and number < looks:
                most = MOST_LOOKS if bent < was else 0
                if directions <= number + 1 < most and not leaves_little(bent, was, moving, rounded):
                    directions, looks = number + 2, max(looks, number + 2)
                was = bent
        guess = mean
        for t in range(tools.mode.shape[0]):
            _move_tool(touch, t)
        if last:
            break
    follow_all(surface, touch, tools, T, state, mean, work.diagonal, look, lanes)
    tell(touch, modal, lanes)
    if look and near and force is None:  # contacts do what the body asks for and nothing else gives
        free, contact = touch.given[0], touch.given[1]
    else:
        free, contact = dot_rows(mean, work.rhs, lanes), dot_rows(mean, push, lanes) if look else 0.0
    if force is not None:
        hold_parts(force.parts, touch.mark)
        level(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, False, work, lanes)
    sigma = balanced(
        law,
        op,
        force,
        state,
        links,
        ports,
        surface,
        tools,
        local_damping,
        extra_damping,
        T,
        sample,
        work,
        touch,
        ledger,
        touch_ledger,
        link_work,
        free,
        contact,
        look,
        tolerance,
        cap,
        lanes,
    )
    _settle(touch, tools, T, sigma, touch_ledger)
    if touch.goal[0] < JAMMED:
        if force is None:
            lose_motion(op, state, tools, None, touch, ledger, touch_ledger, lanes)
        else:
            lose_motion(op, state, tools, force.parts, touch, ledger, touch_ledger, lanes)


@part
def _drive(tools: Tools, touch: ContactWork, T: float) -> None:
    """What each proxy does without contacts, and the guess that it goes on."""
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] != BLADE:
            tools.drag[t] = owed_drag(tools, t)
        touch.inertia[t] = proxy_inertia(tools, t, T)
        touch.caught[t, 0], touch.caught[t, 4], touch.grip[t, 0], touch.grip[t, 1] = 0.0, 0.0, 0.0, 0.0
        touch.stored[t], touch.well[t], touch.total[t], touch.way[t, 3] = 0.0, 0.0, 0.0, 0.0
        touch.slips[t] = 0
        for a in range(3):
            touch.drive[t, a] = proxy_drive(tools, t, a, T)
            touch.mean[t, a] = tools.rate[t, a]
            touch.pull[t, a] = 0.0
            touch.rubbed[t, a] = 0.0  # of one that is inside nobody asks


@part
def _begin(
    law: Any,
    surface: Surface,
    touch: ContactWork,
    tools: Tools,
    T: float,
    state: State,
    debris: Int,
    touch_ledger: Float,
    linear: bool,
    lanes: tuple[int, ...],
) -> bool:
    """Looks around, takes and lets go; returns whether any tool touches or holds.

    A tool that comes into being within the skin begins to touch once it is out of it.
    """
    acting = False
    for t in range(tools.mode.shape[0]):
        mode = tools.mode[t]
        touch.number[t], tools.touching[t] = 0, 0
        acts = mode in (TOUCHING, GRASP)
        acting = acting or acts
        if mode != TOUCHING:
            end_snap(tools, t)
        if not acts or (mode == GRASP) != (tools.held[t] >= 0):  # what it held before goes
            touch_ledger[TOUCH_LOSS] += tools.stored[t] + tools.owed[t]
            tools.stored[t], tools.held[t] = -tools.owed[t], -1
        if mode != TOUCHING:
            tools.inside[t], tools.slipping[t] = 1, 0
            for a in range(3):
                tools.stretch[t, a] = 0.0
    if not acting:
        return False
    hide_away(surface, touch.fit, state.memory)
    refit(surface, touch.fit, state.position, lanes)
    touch.quick[0] = fastest(surface, state.velocity, lanes)
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] == TOUCHING:
            way = T * (touch.quick[0] + length_of(tools.rate, t))
            finest = min(tools.radius[t], tools.snap_range[t]) if tools.snap[t] > 0.0 else tools.radius[t]
            touch.seen[t] = reach_of(surface, tools, t) * (1.0 + _MARGIN) + length_of(tools.axis, t) + _WAYS * way
            touch.slow[t] = way < _SLOW * finest
            look_around(surface, touch, tools, t, touch.seen[t], state.position, lanes)
            begin_tool(law, surface, touch, tools, t, linear)
            begin_snap(surface, touch, tools, t)
        elif tools.mode[t] == GRASP and tools.held[t] < 0:
            take(surface, touch.fit, tools, t, state.position, state.memory, debris, lanes)
        elif tools.mode[t] == GRASP:
            lost = drop_debris(debris, surface, tools, t, state.position)
            tools.stored[t] -= lost
            touch_ledger[TOUCH_LOSS] += lost
    return True


@part
def _look(
    law: Any,
    op: Operator,
    surface: Surface,
    touch: ContactWork,
    tools: Tools,
    t: int,
    T: float,
    state: State,
    mean: Float,
    diagonal: Float,
    first: bool,
    lanes: tuple[int, ...],
) -> float:
    """Gathers what one tool does by the present guess; returns by which share that is not what it did before."""
    for a in range(3):
        touch.before[t, a] = touch.pull[t, a]
    if tools.mode[t] == GRASP:
        feel_grasp(surface, touch, tools, t, T, state.position, mean, diagonal, True, lanes)
        return changed(touch, t)
    follow(surface, touch, tools, t, T, state, mean, lanes)
    if touch.caught[t, 0] == 0.0 and first_crossing(surface, touch, tools, t, T) < NEVER:
        begin_catch(op, surface, touch, tools, t, T)
    if touch.caught[t, 0] != 0.0:
        settled = catch(surface, touch, tools, t, T)
        load_rows(surface, touch, t, diagonal)
        return 0.0 if settled else math.inf
    if first:
        feel_first(law, surface, touch, tools, t, T)
    else:
        feel_tool(law, surface, touch, tools, t, T)
    load_rows(surface, touch, t, diagonal)
    return changed(touch, t)


@part
def _move_tool(touch: ContactWork, t: int) -> None:
    """Solves for the motion of one proxy, with the forces that the last look gathered."""
    along, across = touch.inertia[t] + touch.grip[t, 0], touch.inertia[t] + touch.grip[t, 1]
    wanted, own = 0.0, 0.0
    for a in range(3):
        wanted += touch.way[t, a] * (touch.drive[t, a] + touch.pull[t, a])
        own += touch.way[t, a] * touch.mean[t, a]
    if touch.way[t, 3] == 0.0:
        wanted, own, along = 0.0, 0.0, across
    wanted += touch.grip[t, 0] * own
    for a in range(3):
        way = touch.way[t, a]
        beside = touch.drive[t, a] + touch.pull[t, a] + touch.grip[t, 1] * (touch.mean[t, a] - own * way)
        beside -= (wanted - touch.grip[t, 0] * own) * way
        touch.mean[t, a] = beside / across + wanted * way / along


@part
def _is_pushed(touch: ContactWork, t: int, sigma: float) -> bool:
    """Whether a proxy goes otherwise than its drive alone has it, by more than rounding: what is held back does."""
    left, size = 0.0, 0.0
    for a in range(3):
        goes, drive = touch.inertia[t] * sigma * touch.mean[t, a], touch.drive[t, a]
        left, size = left + (goes - drive) ** 2, size + goes * goes + drive * drive
    return left > _ROUNDING * _ROUNDING * size


@part
def _settle(touch: ContactWork, tools: Tools, T: float, sigma: float, touch_ledger: Float) -> None:
    """New places, velocities and energies of the proxies, and the forces on them."""
    for t in range(tools.mode.shape[0]):
        acted = touch.total[t] != 0.0 or touch.caught[t, 0] != 0.0 or tools.held[t] >= 0 or touch.well[t] != 0.0
        acted = acted or _is_pushed(touch, t, sigma)
        for a in range(3):
            w = sigma * touch.mean[t, a]
            tools.touch_force[t, a] = touch.inertia[t] * w - touch.drive[t, a]
            if not acted:
                tools.touch_force[t, a] = 0.0
            pay(tools, t, a, T, w, touch_ledger)
            book_drive(tools, t, a, T, w, touch_ledger)
            move_proxy(tools, t, a, T, w, touch_ledger)
            tools.stretch[t, a] = touch.rubbed[t, a] if tools.mode[t] == TOUCHING else 0.0
        tools.slipping[t] = touch.slips[t]
        tools.touching[t] = 1 if touch.total[t] > 0.0 or touch.caught[t, 0] != 0.0 else max(tools.held[t], 0)
        if tools.owed[t] < 0.0:  # it paid more
            touch_ledger[TOUCH_LOSS] -= tools.owed[t]
            tools.owed[t] = 0.0
        tools.stored[t], tools.well[t] = touch.stored[t] - tools.owed[t], touch.well[t]
        touch_ledger[TOUCH_STORED] += tools.stored[t]
