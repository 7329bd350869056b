"""Bodies that no tool touches, in a step in which tools touch others: they go their own way."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import at, load, part, put, store
from cotouch.mechanics._closed._balance import LAST_ATTEMPT, go_back, keep_place
from cotouch.mechanics._closed._balance_groups import LENGTH, OPEN, OTHERS, WITH
from cotouch.mechanics._closed._balance_length import ask_fall, find_outside, meet_again, set_length
from cotouch.mechanics._closed._balance_parts import hold_face, hold_groups
from cotouch.mechanics._closed._direction_groups import level_groups
from cotouch.mechanics._contact._sweep import NEVER, first_crossing
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import Links, Ports, State, Workspace
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._meeting._bodies import Parts
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import TOUCHING, Tools


@part
def shorten_others(
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    attempt: int,
    work: Workspace,
    lanes: tuple[int, ...],
) -> None:
    """Has bodies that no tool touches, and whose groups are not closed, go another length; a step is taken back.

    Args:
        op: the bodies.
        force: what resists inside, and between them.
        state: of the copy.
        links: the neighbours' samples.
        ports: what else holds the copy.
        local_damping: B_i, (weights,).
        extra_damping: B_e, (weights,).
        T: length of the step [s].
        attempt: how often they did before.
        work: scratch; `mean` gets how they go.
        lanes: fixes the width.
    """
    go_back(force, state, work, lanes)
    find_outside(op, force.world, force.parts, ports, T, work, lanes)
    left = LAST_ATTEMPT - attempt
    if left == OTHERS - 1:
        ask_fall(op, force, state, T, work, lanes)
    rest = left <= OTHERS - 2
    set_length(op, force.parts, work, 0.0 if left <= OTHERS else 1.0, rest, lanes)
    if not rest:
        level_groups(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, work, lanes)
    keep_place(state, work, lanes)  # looks went elsewhere


@part
def free_others(
    op: Operator,
    force: BodyForce,
    parts: Parts | None,
    state: State,
    links: Links,
    ports: Ports,
    surface: Surface,
    tools: Tools,
    touch: ContactWork,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    work: Workspace,
    lanes: tuple[int, ...],
) -> bool:
    """Frees bodies and tools that only a guess that was given up had meet each other; a step is taken back then.

    Such a guess may lead metres away. They go as their drives, weight and what holds them from outside lead.

    Args:
        op: see `shorten_others`, like all others.
        force: likewise.
        parts: which body is which; None: there is one.
        state: likewise.
        links: likewise.
        ports: likewise.
        surface: the skin.
        tools: the proxies.
        touch: what they touch.
        local_damping: likewise.
        extra_damping: likewise.
        T: likewise.
        work: likewise; the step was weighed.
        lanes: likewise.

    Returns:
        Whether there were any; else nothing is changed.
    """
    if parts is None:
        return False
    found = _free_tools(surface, tools, touch, T)
    meet_again(force.world, parts)
    for b in range(parts.held.shape[0]):
        put(parts.sums, (b, OPEN), float(at(parts.held, b)))
        put(parts.held, b, 0)
    for i in range(op.mass.shape[0]):
        if touch.mark[i] > 0:
            put(parts.held, at(parts.part, i), 1)
    for t in range(tools.mode.shape[0]):
        if touch.caught[t, 0] != 0.0:
            hold_face(surface, parts, int(touch.caught[t, 1]))
    hold_groups(parts)
    for b in range(parts.held.shape[0]):
        frees = at(parts.sums, (b, OPEN)) != 0.0 and at(parts.held, b) == 0
        put(parts.sums, (b, OPEN), 1.0 if frees else 0.0)
        found = found or frees
    if not found:
        return False
    go_back(force, state, work, lanes)
    for b in range(parts.held.shape[0]):
        put(parts.sums, (b, WITH), float(at(parts.met.group, b)))
        if at(parts.sums, (b, OPEN)) != 0.0:
            put(parts.sums, (b, LENGTH), 1.0)
    for i in range(op.mass.shape[0]):
        if at(parts.sums, (at(parts.part, i), OPEN)) != 0.0:
            gained = (0.5 * T * op.firmness) * load(force.gravity, i, lanes)
            store(work.mean, i, load(state.velocity, i, lanes) + gained, lanes)
    find_outside(op, force.world, parts, ports, T, work, lanes)
    level_groups(op, force, parts, state, links, ports, local_damping, extra_damping, T, work, lanes)
    for i in range(op.mass.shape[0]):
        if at(parts.sums, (at(parts.part, i), OPEN)) != 0.0:
            store(work.asked, i, load(work.mean, i, lanes), lanes)
    keep_place(state, work, lanes)  # looks went elsewhere
    return True


@part
def _free_tools(surface: Surface, tools: Tools, touch: ContactWork, T: float) -> bool:
    """Frees tools that do nothing now, and would pass no skin on their own way; returns whether there are any."""
    found = False
    for t in range(tools.mode.shape[0]):
        acts = touch.total[t] > 0.0 or touch.well[t] != 0.0 or touch.stored[t] != 0.0 or tools.stored[t] != 0.0
        if tools.mode[t] != TOUCHING or tools.inside[t] != 0 or touch.caught[t, 4] == 0.0 or acts:
            continue
        for n in range(3):
            touch.out[0, n], touch.out[1, n] = touch.mean[t, n], touch.caught[t, 6 + n]
            touch.mean[t, n] = touch.drive[t, n] / touch.inertia[t]
        face, along = touch.caught[t, 1], touch.caught[t, 9]
        if first_crossing(surface, touch, tools, t, T) < NEVER:
            touch.caught[t, 1], touch.caught[t, 9] = face, along
            for n in range(3):
                touch.mean[t, n], touch.caught[t, 6 + n] = touch.out[0, n], touch.out[1, n]
        else:
            touch.caught[t, 0], touch.caught[t, 4], found = 0.0, 0.0, True
    return found
