"""One scale over the motion of body and tools makes the energy of a step with contacts exact.

Of a body with a material the true energy is weighed with that of the contact, where the same motion led, and its end
velocity closes what little is left: one balance for both.
"""
# pyright: reportArgumentType=false, reportReturnType=false

from typing import Any

from cotouch.arrays import Float
from cotouch.kernels import load, part, store
from cotouch.mechanics._closed._balance import (
    FIXED,
    LEAST,
    MOST,
    TARGET,
    go_back,
    is_rough,
    is_rounded,
    keep_place,
    resting,
    stay,
)
from cotouch.mechanics._closed._balance_groups import LAST_OF_ALL, start_attempts
from cotouch.mechanics._closed._balance_length import ask_length, free_groups, shortest, stretch
from cotouch.mechanics._closed._balance_parts import close_all
from cotouch.mechanics._contact._catch import room
from cotouch.mechanics._contact._centre import go_about, is_free, join_crossed
from cotouch.mechanics._contact._follow import follow_all
from cotouch.mechanics._contact._others import free_others, shorten_others
from cotouch.mechanics._contact._outside import soften_all
from cotouch.mechanics._contact._over import ROUNDING, driven, holds, leave, moved_by, over_of, passes, went_astray
from cotouch.mechanics._contact._press import unsure
from cotouch.mechanics._contact._search import search_touched, seekable
from cotouch.mechanics._contact._skin import fastest
from cotouch.mechanics._contact._sweep import NEVER, first_crossing
from cotouch.mechanics._contact._weigh import EASY, is_closed, next_scale, weigh_way
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import SHORTENED, SUPPLIED, Links, Ports, State, Workspace
from cotouch.mechanics._linear._step import book_energies, move, port_work
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._meeting._stop import join_deep
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import GRASP, TOUCH_LOSS, TOUCHED, TOUCHING, Tools

# Of the work between tools and a linear body in a step, so much may be left to the next.
_LEFT = 1e-6
# How often a scale near 1 is sought that makes up for what the looks missed; how often the way is shortened then, by
# the rounding of the scale first and by half at last.
_TRIES = 12
_HALVES = 60
# The same about a common centre, and by which share at first.
_PARTS, _SHARE = 24, 1e-4
# A tool that would pass the skin goes so much of the way to it.
_SHORT = 0.9
# How often what would come too deep into its own body is made to move as one.
_JOINS = 12
# What a search may miss of the motion: first, and where that does not close the step.
_ENOUGH = (1e-4, 1e-6)


@part
def balanced(
    law: Any,
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
    touch: ContactWork,
    ledger: Float,
    touch_ledger: Float,
    link_work: Float,
    free: float,
    contact: float,
    look: bool,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> float:
    """Moves the copy as far as the energies of body and contact allow, and books it.

    What comes in less what is stored and lost is above 0 for small scales and falls: somewhere near 1 it is 0. If it
    is not near 1, what is left over counts as lost; if there is too little, the way is shortened until there is not.

    Args:
        law: of the contact.
        op: the body's matrices.
        force: what resists inside the body beside them; None: nothing.
        state: of the copy; changed in place.
        links: the neighbours' samples.
        ports: what else holds the copy.
        surface: the skin.
        tools: the proxies.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step [s].
        sample: slot of `links.samples` that receives x̂; negative: none.
        work: scratch; `mean` holds the motion that the last solve found, and gets what comes of it.
        touch: what the last look found, with rates and motions of the last solve.
        ledger: result (LEDGER_COLUMNS,), as of `step`.
        touch_ledger: result: TOUCHED, and TOUCH_LOSS is added to.
        link_work: result (links,).
        free: `v̂ᵀ b`, b the right-hand side without contacts [W].
        contact: `v̂ᵀ (A v̂ - b)`, what contacts do on the body [W].
        look: whether any tool touches.
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.

    Returns:
        The scale, in [0, 1.25].
    """
    astray = force is not None and went_astray(op, touch, work, lanes)
    if force is not None and astray and look and seekable(op, force, surface, work):
        for t in range(tools.mode.shape[0]):
            touch.caught[t, 0], touch.caught[t, 4] = 0.0, 0.0
        search_touched(
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
            _ENOUGH[0],
            work,
            touch,
            ledger,
            tolerance,
            cap,
            lanes,
        )
        astray, free, contact = went_astray(op, touch, work, lanes), -moved_by(op, touch, T, work, lanes), 0.0
    most, held_back, touches, passed = 1.0, False, False, False
    inflow, slope, spare = abs(free) + abs(contact) if force is None else 0.0, -T * (free + contact), 0.0
    for t in range(tools.mode.shape[0]):
        held_back = held_back or touch.caught[t, 0] != 0.0
        if tools.mode[t] == TOUCHING and tools.inside[t] == 0:
            first = first_crossing(surface, touch, tools, t, T)
            if first < NEVER:
                most = min(most, _SHORT * first, room(surface, touch, tools, t) * first)
        for a in range(3):
            slope -= T * touch.inertia[t] * touch.mean[t, a] * touch.mean[t, a]
            spare += _LEFT * T * abs(touch.mean[t, a] * touch.pull[t, a])
        touches = touches or touch.total[t] > 0.0 or touch.well[t] != 0.0 or tools.mode[t] == GRASP
    inflow += driven(touch, tools)
    aim = 0.5 * spare if force is None else 0.0
    if force is not None:
        keep_place(state, work, lanes)
        start_attempts(force.parts)
        free_groups(force.parts)
        ask_length(work, lanes)
    held_back = held_back or astray or most < 1.0
    central = held_back or is_free(op, force, links, ports, tools, touch, T, work, lanes)
    work.weighed[FIXED], searches = 1.0, 0
    if force is not None and look and not central and seekable(op, force, surface, work):
        searches = len(_ENOUGH)
    seeks, still, rounded, hardly, told = not held_back, False, True, False, False
    scale, have, last, last_over, tries, halves, shrinks, square = most, 1.0, 0.0, 0.0, 0, 0, ROUNDING, 1.0
    shorter, joins, crossed, frees, foretells, most_halves = 0, 0, False, True, False, _PARTS if central else _HALVES
    if central:
        shrinks = _SHARE
        join_crossed(surface, tools, touch, force, T)
    pushed = touch.push[: op.mass.shape[0] if look else 0]
    while True:
        if central:
            contact = go_about(
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
                scale / have if scale > 0.0 else 0.0,
                halves > most_halves,
                work,
                touch,
                lanes,
            )
            have = scale
        goes = 1.0 if central else scale  # of the way that is there
        beyond = scale - last if foretells else 0.0
        over, noise, lost = over_of(law, surface, touch, tools, T, free, contact, inflow, force is None, goes, beyond)
        if force is None:
            fine = not look or -noise <= over <= max(noise, spare)
        else:
            if central:
                keep_place(state, work, lanes)  # looks went elsewhere
            else:
                stretch(force.parts, work.mean, scale / have if scale > 0.0 else 0.0, lanes)
            have, touch_ledger[TOUCHED] = scale, over
            over, noise, square, passed, others = weigh_way(
                op,
                force,
                state,
                links,
                ports,
                local_damping,
                extra_damping,
                T,
                sample,
                pushed,
                over,
                noise,
                shorter,
                work,
                link_work,
                ledger,
                lanes,
            )
            weighed = work.weighed
            passed = passed or (joins > 0 and passes(surface, touch, tools, scale * T))
            if passed and scale == 1.0 and joins < _JOINS and not (central or others):
                joins += 1
                if join_deep(force.world, op.mass, work.mean, lanes):
                    go_back(force, state, work, lanes)
                    touch.quick[0] = fastest(surface, work.mean, lanes)
                    follow_all(surface, touch, tools, T, state, work.mean, work.diagonal, look, lanes)
                    keep_place(state, work, lanes)
                    ask_length(work, lanes)
                    seeks, tries, last = True, 0, 0.0
                    continue
            meets = touches or holds(touch, tools)  # or comes in, or out, after all that looks see of the step
            rounded, hardly = is_rounded(weighed, over, op.copy_scale), is_rough(weighed)
            easy = touches or (meets and (seeks or searches > 0))
            fine = not passed and is_closed(weighed, over, noise, square, easy, rounded, seeks, central)
            seeks = seeks and not passed
            if others:  # bodies that no tool touches
                shorten_others(op, force, state, links, ports, local_damping, extra_damping, T, shorter, work, lanes)
                shorter += 1
                continue
            if not (fine or passed or meets or still or central) and resting(weighed):
                still = True  # the body stays, and its tools go on
                stay(force, state, work, lanes)
                continue
        if central:
            crossed = join_crossed(surface, tools, touch, force, T)
            fine = fine and not crossed
            ends = not crossed and (fine or over >= -noise or halves > most_halves)
            if force is not None and ends and frees:  # at most once
                frees = False
                freed = free_others(
                    op,
                    force,
                    force.parts,
                    state,
                    links,
                    ports,
                    surface,
                    tools,
                    touch,
                    local_damping,
                    extra_damping,
                    T,
                    work,
                    lanes,
                )
                if freed:
                    continue
        # What tools do not touch may be closed by more, but not where a search would close it by less.
        sure = fine and (searches == 0 or rounded or abs(square - 1.0) <= EASY)
        if sure and not (goes > 1.0 and passes(surface, touch, tools, scale * T)):
            break
        begins_anew = False
        if foretells:  # not as it was thought to be
            foretells = False
            continue
        if seeks:
            slope, following = next_scale(scale, over, last, last_over, slope, aim, tries)
            tries, last, last_over = tries + 1, scale, over
            seeks = not fine and tries <= _TRIES and following != scale
            if seeks and tries == 1 and not central:  # about a centre, tools go as that does as well
                foretells = aim > 0.0 and abs(following - scale) * unsure(touch, tools, T) <= 0.5 * aim
            begins_anew = not seeks and scale != 1.0 and (fine or crossed or (over > 0.0 and scale == MOST))
            scale = following if seeks else 1.0 if begins_anew else scale
        enough = over >= -noise and not (passed or crossed)  # what is no number is too much
        lacks = not (fine or seeks or begins_anew or enough or rounded or passed or still) or (fine and not sure)
        if force is not None and searches > 0 and lacks:
            go_back(force, state, work, lanes)
            search_touched(
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
                _ENOUGH[len(_ENOUGH) - searches],
                work,
                touch,
                ledger,
                tolerance,
                cap,
                lanes,
            )
            keep_place(state, work, lanes)
            searches, seeks, tries, last = searches - 1, True, 0, 0.0
            scale, have, slope = 1.0, 1.0, -T * moved_by(op, touch, T, work, lanes)
            inflow = driven(touch, tools)
            continue
        if not (seeks or begins_anew):
            if enough or halves >= (most_halves + 1 if central else most_halves):
                break
            halves, told = halves + 1, told or not (rounded or hardly)
            shrinks = min(16.0 * shrinks, 0.5)
            scale = (1.0 - shrinks) * scale if halves < most_halves else 0.0
            if force is None and scale == 0.0:
                soften_all(law, surface, touch, tools)
        if force is not None:
            go_back(force, state, work, lanes)
    if fine and force is None and over > noise and leave(touch, tools, over):
        over = 0.0
    touch_ledger[TOUCH_LOSS] += lost + over if over > noise and (force is None or not fine) else lost
    if force is None:
        for i in range(work.mean.shape[0] if goes != 1.0 else 0):
            store(work.mean, i, goes * load(work.mean, i, lanes), lanes)
        touch_ledger[TOUCHED] = T * goes * (goes * contact - (1.0 - goes) * free)
        ledger[SUPPLIED] = port_work(op, state, ports, T, work.mean, lanes)
        move(op, state, links, T, sample, work, link_work, lanes)
        book_energies(op, state, local_damping, extra_damping, T, work, ledger, lanes)
    else:
        if not fine and over > noise:
            work.weighed[TARGET] -= over / op.copy_scale
            touch_ledger[TOUCHED] -= over
        close_all(
            op,
            force,
            state,
            links,
            ports,
            local_damping,
            extra_damping,
            T,
            pushed,
            touch_ledger[TOUCHED] / op.copy_scale,
            LAST_OF_ALL,
            work,
            ledger,
            lanes,
        )
        ledger[SHORTENED] = max(LEAST - scale, 0.0) if told and not held_back else 0.0
        if astray:
            ledger[SHORTENED] = 1.0
        elif shorter > 0:
            ledger[SHORTENED] = max(1.0 - shortest(force.parts, 1.0), ledger[SHORTENED])
    touch.goal[0] = scale if held_back else 1.0
    return goes
