"""The balance of several bodies: each makes up for what it lacks by itself, about its own centre of mass.

One factor for all would scale velocities about a centre between the bodies: what one that flies lacks would kick one
that rests. So what came to each is worked out row by row, what contact did on it included. Only what bodies cannot make
up for by themselves is shared, and only among those that touch each other: a group. A group that cannot close its
balance goes less far, and no other group notices.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float, Int
from cotouch.kernels import at, inner, load, part, put, total
from cotouch.mechanics._closed._balance import HAVE, NOISE, PASSED, TARGET, close, square_of
from cotouch.mechanics._closed._balance_groups import (
    ABOUT,
    FLOW,
    LACKS,
    LAST_OF_ALL,
    MASS,
    MOMENTUM,
    MOVING,
    OPEN,
    decide,
    held_together,
    scale_parts,
)
from cotouch.mechanics._closed._balance_length import join_held, join_met
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import Links, Ports, State, Workspace
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._meeting._bodies import Parts
from cotouch.mechanics._model._surface import Surface


@part
def close_all(
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    push: Float,
    spare: float,
    attempt: int,
    work: Workspace,
    ledger: Float,
    lanes: tuple[int, ...],
) -> bool:
    """Balances the step that was just weighed: `close`, and of several bodies each by itself where it can be.

    Args:
        op: the body.
        force: what resists inside.
        state: where the copy came to; its velocity is changed in place.
        links: the neighbours' samples.
        ports: what holds the copy, with its forces.
        local_damping: B_i, (weights,).
        extra_damping: B_e, (weights,).
        T: length of the step [s].
        push: forces of tools on the rows, (rows, width) or (0, width) [N].
        spare: what tools gave, of the whole body [J].
        attempt: see `close`.
        work: likewise.
        ledger: likewise.
        lanes: fixes the width.

    Returns:
        Whether the step is good; else nothing is changed.
    """
    if force.parts is None:
        return close(op, state, attempt, work, ledger, lanes)
    join_met(force.world, force.parts)
    _share_out(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, push, spare, work, lanes)
    if attempt == LAST_OF_ALL:
        join_held(force.parts, work.weighed[NOISE])
    good, worst = decide(force.parts, work.weighed, attempt, False)
    if good:
        scale_parts(op, force.parts, state, worst, work, ledger)
        keep_parts(force.parts, state.memory)
    return good


@part
def judge(
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    push: Float,
    spare: float,
    attempt: int,
    work: Workspace,
    lanes: tuple[int, ...],
) -> tuple[float, float, bool, bool]:
    """What a step that was just weighed lacks where tools touch; of several bodies only that of those is asked.

    Args:
        op: see `close_all`, like all others.
        force: likewise.
        state: likewise.
        links: likewise.
        ports: likewise.
        local_damping: likewise.
        extra_damping: likewise.
        T: likewise.
        push: likewise.
        spare: likewise.
        attempt: how often others went less far.
        work: likewise.
        lanes: likewise.

    Returns:
        What is lacking, of the whole body [J]; β² that would close it; whether what tools touch passed an obstacle;
        and whether other bodies must go another length (`set_length`).
    """
    weighed = work.weighed
    if force.parts is None:
        square, _ = square_of(weighed, False)
        return weighed[TARGET] - weighed[HAVE], square, weighed[PASSED] != 0.0, False
    join_met(force.world, force.parts)
    hold_groups(force.parts)
    _share_out(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, push, spare, work, lanes)
    good, _ = decide(force.parts, weighed, attempt, True)
    held, lacks, square, passed = held_together(force.parts)
    return lacks if held else spare, square, passed, not good


@part
def free_parts(parts: Parts | None) -> None:
    """No tool touches any body."""
    if parts is not None:
        for b in range(parts.held.shape[0]):
            put(parts.held, b, 0)


@part
def hold_parts(parts: Parts | None, mark: Int) -> None:
    """Notes which bodies tools touch, and those that touch these, from which rows are touched.

    Args:
        parts: the bodies; None: there is one.
        mark: of each row, more than 0 where it is touched, (rows,).
    """
    if parts is not None:
        free_parts(parts)
        for i in range(mark.shape[0]):
            if at(mark, i) > 0:
                put(parts.held, at(parts.part, i), 1)
        hold_groups(parts)


@part
def hold_groups(parts: Parts | None) -> None:
    """What touches a body that is held is held as well."""
    if parts is None:
        return
    for one in range(parts.held.shape[0]):
        if at(parts.held, one) != 0:
            for two in range(parts.held.shape[0]):
                if at(parts.met.group, one) == at(parts.met.group, two):
                    put(parts.held, two, 1)


@part
def keep_parts(parts: Parts | None, memory: Float) -> None:
    """Keeps each body's energy as it was evaluated last.

    Args:
        parts: the bodies; None: there is one.
        memory: of the copy, in place.
    """
    if parts is not None:
        for b in range(parts.held.shape[0]):
            put(memory, at(parts.memory, b), at(parts.energy, (b, 0)))


@inner
def _add(parts: Parts, b: int, what: int, value: float) -> None:
    put(parts.sums, (b, what), at(parts.sums, (b, what)) + value)


@part
def _share_out(
    op: Operator,
    force: BodyForce,
    parts: Parts | None,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    push: Float,
    spare: float,
    work: Workspace,
    lanes: tuple[int, ...],
) -> None:
    """Works out what each body lacks, of the whole body [J]."""
    if parts is None:
        return
    rows, share = op.mass.shape[0], 1.0 / op.copy_scale
    held = False
    for b in range(parts.held.shape[0]):
        held = held or at(parts.held, b) != 0
        for what in range(OPEN + 1):
            put(parts.sums, (b, what), 0.0)
        risen = at(parts.energy, (b, 0)) - at(state.memory, at(parts.memory, b)) + T * at(parts.energy, (b, 1))
        put(parts.sums, (b, LACKS), op.firmness * (at(parts.met.worked, b) - risen))
    for i in range(rows):
        b, m, hold = at(parts.part, i), at(op.mass, i), at(op.ground, i)
        x, x0 = load(state.position, i, lanes), load(work.ahead, i, lanes)
        v, v0, rate = load(state.velocity, i, lanes), load(work.pull, i, lanes), load(work.mean, i, lanes)
        gravity = op.firmness * load(force.gravity, i, lanes)
        own = T * total(gravity * (m * rate)) - m * total((v - v0) * rate)
        own -= 0.5 * hold * total((x - x0) * (x + x0)) + T * at(op.drag, i) * total(rate * rate)
        for w in range(op.weight.shape[0]):
            lost = (local_damping[w] + extra_damping[w]) * at(op.weight, (w, i))
            own -= share * T * lost * total(rate * rate)
        if push.shape[0] > 0:
            pushed = share * T * total(load(push, i, lanes) * rate)
            own += pushed
            _add(parts, b, FLOW, abs(pushed))
        _add(parts, b, LACKS, own)
        put(parts.sums, (b, MASS), at(parts.sums, (b, MASS)) + m)
        _add(parts, b, MOVING, 0.5 * m * total(v * v))
        for a in range(3):
            _add(parts, b, MOMENTUM + a, m * at(state.velocity, (i, a)))
    for link in range(links.slot.shape[0]):
        w, base = at(links.weight, link), at(links.slot, link) * rows
        for i in range(rows):
            rate = load(work.mean, i, lanes)
            middle = 0.5 * (load(state.position, i, lanes) + load(work.ahead, i, lanes))
            pulled = -at(links.strength, link) * (middle - load(links.samples, base + i, lanes))
            if links.push.shape[0] > 0:
                pulled = pulled + load(links.push, link * rows + i, lanes) - at(links.brake, link) * rate
            _add(parts, at(parts.part, i), LACKS, share * T * at(op.weight, (w, i)) * total(pulled * rate))
    if ports.shape.shape[0] == 0:
        for p in range(ports.row.shape[0]):
            i = at(ports.row, p)
            did = total(load(ports.force, p, lanes) * load(work.mean, i, lanes))
            _add(parts, at(parts.part, i), LACKS, share * T * did)
    else:  # a port holds a point that follows many rows
        for p in range(ports.row.shape[0]):
            for i in range(rows):
                did = at(ports.shape, (p, i)) * total(load(ports.force, p, lanes) * load(work.mean, i, lanes))
                _add(parts, at(parts.part, i), LACKS, share * T * did)
    for i in range(rows):
        b = at(parts.part, i)
        beside = 0.0
        for a in range(3):
            centre = at(parts.sums, (b, MOMENTUM + a)) / at(parts.sums, (b, MASS))
            beside += (at(state.velocity, (i, a)) - centre) ** 2
        _add(parts, b, ABOUT, 0.5 * at(op.mass, i) * beside)
    _hand_out(op, parts, held, spare, work)


@part
def _hand_out(op: Operator, parts: Parts | None, held: bool, spare: float, work: Workspace) -> None:
    """Gives what is beside all that bodies lack to where energy flowed: to tools' contacts, else to others.

    What tools that touch nothing have to spare is no body's.
    """
    if parts is None:
        return
    left, flows = work.weighed[TARGET] - work.weighed[HAVE] - (0.0 if held else spare), 0.0
    for b in range(parts.held.shape[0]):
        left -= at(parts.sums, (b, LACKS))
        if not held:
            put(parts.sums, (b, FLOW), op.firmness * at(parts.met.flow, b))
        flows += at(parts.sums, (b, FLOW))
    if not held and abs(left) <= work.weighed[NOISE]:
        return
    most = -1
    for b in range(parts.held.shape[0]):
        if flows > 0.0:
            _add(parts, b, LACKS, left * at(parts.sums, (b, FLOW)) / flows)
        elif (not held or at(parts.held, b) != 0) and (most < 0 or _moves_more(parts, b, most)):
            most = b
    if most >= 0:
        _add(parts, most, LACKS, left)


@inner
def _moves_more(parts: Parts, one: int, two: int) -> bool:
    """Whether one body moves more about its centre than another; if both do not, whether it moves more at all."""
    what = ABOUT if at(parts.sums, (one, ABOUT)) != at(parts.sums, (two, ABOUT)) else MOVING
    return at(parts.sums, (one, what)) > at(parts.sums, (two, what))


@inner
def hold_face(surface: Surface, parts: Parts | None, f: int) -> None:
    """Notes that a tool touches the bodies of a triangle.

    Args:
        surface: the skin.
        parts: the bodies; None: there is one.
        f: the triangle.
    """
    if parts is None:
        return
    for q in range(3):
        v = surface.corner[f, q]
        for k in range(surface.row.shape[1]):
            if surface.weight[v, k] != 0.0:
                put(parts.held, at(parts.part, surface.row[v, k, 0]), 1)
