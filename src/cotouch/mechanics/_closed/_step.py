"""The closed step: any energy, the same exact balance.

A direction comes from a linear solve with a constant matrix, at any truncation. The copy moves along it, its true
energy is worked out once, and what the ledger then lack is put into the end velocity by one scale β about the velocity
of the centre of mass. Only v̂ meets ports and links, so everything that is proved for the linear step holds here.
"""

import math

from cotouch.arrays import Float
from cotouch.kernels import at, block, load, splat, store, total
from cotouch.mechanics._closed._balance import (
    AT_WORLD,
    ENERGY,
    FIXED,
    HAVE,
    LAST_ATTEMPT,
    LEFT,
    MOST,
    MOTION,
    NOISE,
    PASSED,
    ROUGH,
    TARGET,
    go_back,
    keep_place,
    next_length,
    resting,
    square_of,
    weigh,
    with_links,
)
from cotouch.mechanics._closed._balance_groups import OTHERS, resting_parts, start_attempts
from cotouch.mechanics._closed._balance_length import (
    ask_fall,
    ask_length,
    find_outside,
    free_groups,
    keep_groups,
    set_length,
    shortest,
    stop_all,
)
from cotouch.mechanics._closed._balance_parts import close_all, free_parts, keep_parts
from cotouch.mechanics._closed._debris import free_debris, rest_debris
from cotouch.mechanics._closed._direction import begin_looks, direct, level, predict
from cotouch.mechanics._closed._direction_groups import level_groups
from cotouch.mechanics._closed._direction_more import LITTLE, SLOWEST, rough
from cotouch.mechanics._closed._direction_search import FIRST_LOOKS, LOOKS, begin_search, best_again, search
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import (
    ELASTIC,
    ITERATIONS,
    KINETIC,
    SHORTENED,
    SUPPLIED,
    WORLD_STORED,
    Links,
    Ports,
    State,
    Workspace,
)
from cotouch.mechanics._linear._step import move, port_work
from cotouch.mechanics._materials._call import call_begin
from cotouch.mechanics._materials._force import BodyForce, evaluate
from cotouch.mechanics._materials._memory import looks_ahead
from cotouch.mechanics._meeting._world_force import looks_of, settle_world, take_up

# Sweeps of the rotations from nowhere.
_MANY = 60
# What the next look would change, of the end velocity about the centre of mass, for which it is not taken.
ENOUGH = 2e-4
# Where it might change more than `LITTLE`, more than the usual number are taken, up to so many. Not where the last
# changed more than twice as much as the one before: such looks go astray.
_MOST, _ASTRAY = 24, 2.0
# A step whose end velocity is changed by more than this is told: its forces and its energy disagree.
CLOSURE_ALARM = 1e-2


@block
def closed_step(
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    sample: int,
    work: Workspace,
    ledger: Float,
    link_work: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> None:
    """Advances one copy by T; see `step`, whose arguments these are.

    Args:
        op: the body's masses, outer dampers and springs, and the constant matrices that give the direction.
        force: what resists inside the body.
        state: of the copy; changed in place.
        links: the neighbours' samples.
        ports: what holds the copy.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step, > 0 [s].
        sample: slot of `links.samples` that receives x̂; negative: none.
        work: scratch.
        ledger: result (LEDGER_COLUMNS,), as of `step`; CLOSURE, BETA and SHORTENED besides.
        link_work: result (links,).
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.
    """
    take_up(force.world, state.memory, state.position)
    free_debris(op, ports, lanes)
    free_parts(force.parts)
    begin_looks(work)
    ledger[ITERATIONS] = 0.0
    for i in range(op.mass.shape[0]):
        store(work.mean, i, load(state.velocity, i, lanes), lanes)
    directions, before, alone = looks_ahead(state.memory, force.directions, force.cut), 0.0, force.parts is None
    tells = op.entries.shape[0] > 0
    known, number, looks = False, 0, looks_of(force.world, directions, work.dense.shape[0] > 0)
    least_told = rough(op, force, state)
    while number < looks:
        known = predict(op, force, state, T, False, work, lanes) and number >= directions
        if known:
            break
        change, moving, missed = direct(
            op,
            force,
            state,
            links,
            ports,
            local_damping,
            extra_damping,
            T,
            number,
            work,
            ledger,
            tolerance,
            cap,
            lanes,
        )
        number += 1
        # Each look leaves about that share of the last one's change by which that was smaller than the one before, and
        # of the power that v̂ misses, which the closure would give.
        power = 0.5 * T * missed / op.copy_scale
        left = max(change * moving, power * power) * max(change, SLOWEST * SLOWEST * before)
        goes, rounded = before * moving * moving, before * least_told * least_told
        if number > 1 and alone and tells and left <= max(ENOUGH * ENOUGH * goes, rounded):
            directions = min(directions, number)
            if force.world is None:
                break
        elif tells and number >= directions and left > max(LITTLE * LITTLE * goes, rounded):
            directions = number + 1 if number < _MOST and change < _ASTRAY * _ASTRAY * before else directions
            looks = max(looks, directions)
        before = change
    level(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, known, work, lanes)
    attempt, length, least, greatest, refused = 0, 1.0, 0.0, math.inf, False
    square, seeks, found = 1.0, -1, False
    start_attempts(force.parts)
    free_groups(force.parts)
    work.weighed[FIXED] = 0.0
    while True:
        keep_place(state, work, lanes)
        rest_debris(op, work.mean, lanes)
        ledger[SUPPLIED] = port_work(op, state, ports, T, work.mean, lanes)
        move(op, state, links, T, sample, work, link_work, lanes)
        gain = with_links(ledger[SUPPLIED], links, link_work)
        weigh(op, force, state, local_damping, extra_damping, T, gain, work, ledger, lanes)
        passed = work.weighed[PASSED] != 0.0
        if (not passed or force.parts is not None) and close_all(
            op,
            force,
            state,
            links,
            ports,
            local_damping,
            extra_damping,
            T,
            ports.push[:0],
            0.0,
            attempt,
            work,
            ledger,
            lanes,
        ):
            break
        go_back(force, state, work, lanes)
        if attempt == 0:
            ask_length(work, lanes)
        find_outside(op, force.world, force.parts, ports, T, work, lanes)
        still = (not passed and resting(work.weighed)) or resting_parts(force.parts)
        if alone:
            square, _ = square_of(work.weighed, attempt > 0)
        if seeks >= 0 and not passed and not still and not found and seeks < LOOKS:
            # Where a few looks lead nothing closes; where more do something might.
            begins = seeks == 0
            if begins:
                begin_search(force.parts, work, lanes)
            looks = FIRST_LOOKS if begins else 1
            found = search(
                op,
                force,
                state,
                links,
                ports,
                local_damping,
                extra_damping,
                T,
                looks,
                work,
                ledger,
                tolerance,
                cap,
                lanes,
            )
            seeks += looks
            start_attempts(force.parts)
            keep_groups(force.parts)
            ask_length(work, lanes)
            continue
        if attempt == 0 and not passed and not still:
            predict(op, force, state, T, False, work, lanes)
            direct(
                op,
                force,
                state,
                links,
                ports,
                local_damping,
                extra_damping,
                T,
                -1,
                work,
                ledger,
                tolerance,
                cap,
                lanes,
            )
            level(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, False, work, lanes)
            start_attempts(force.parts)
            keep_groups(force.parts)
            ask_length(work, lanes)
            seeks = 0 if op.entries.shape[0] > 0 else -1
        else:
            if seeks >= LOOKS and not (passed or still):
                best_again(force.parts, work, lanes)
                level(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, False, work, lanes)
                start_attempts(force.parts)
                ask_length(work, lanes)
                seeks = -1
                continue
            # What cannot be closed, or would still pass an obstacle, stays where it is at last: what nothing outside
            # holds with its centre first, then as it is.
            left = LAST_ATTEMPT - attempt
            stays = still or left <= (3 if alone else OTHERS)
            refused = refused or (stays and not still)
            if alone and not stays:
                least, greatest = (least, length) if passed or not square > MOST else (length, greatest)
                length = next_length(length, least, greatest)
            length = 0.0 if stays and not still else length
            rest = still or left <= (1 if alone else OTHERS - 2)
            if left == (2 if alone else OTHERS - 1):
                ask_fall(op, force, state, T, work, lanes)
            if left <= 1:
                stop_all(force.parts, work.mean, lanes)
            elif not set_length(op, force.parts, work, 0.0 if stays else length, rest, lanes):
                # Nothing that goes less far would be any different.
                refused, attempt = refused or not still, max(attempt, LAST_ATTEMPT - 1)
                length = length if still else 0.0
            elif not rest:
                level_groups(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, work, lanes)
        attempt += 1
    weighed = work.weighed
    rounded = abs(weighed[TARGET] - weighed[HAVE]) <= max(weighed[NOISE], weighed[ROUGH])
    ledger[SHORTENED] = 0.0 if rounded and not refused else max(1.0 - shortest(force.parts, length), 0.0)


@block
def closed_settle(
    op: Operator, force: BodyForce, state: State, work: Workspace, ledger: Float, lanes: tuple[int, ...]
) -> None:
    """Finds the rotations and energies of a state that was just set.

    Args:
        op: of the body.
        force: inside the body, and its weight.
        state: whose position and velocity were set; the rest is filled in.
        work: scratch.
        ledger: result (LEDGER_COLUMNS,): the energies [J].
        lanes: fixes the width of a row.
    """
    rows, memory = op.mass.shape[0], state.memory
    zero = splat(0.0, lanes)
    held, weight, moving = zero, zero, zero
    call_begin(force.law, memory, force.behind)
    for i in range(rows):
        x, v, m = load(state.position, i, lanes), load(state.velocity, i, lanes), at(op.mass, i)
        held = held + at(op.ground, i) * (x * x)
        weight = weight + (m * op.firmness) * (load(force.gravity, i, lanes) * x)
        moving = moving + m * (v * v)
        store(work.pull, i, zero, lanes)
    energy, _ = evaluate(force.law, memory, state.position, state.position, work.pull, _MANY, lanes)
    keep_parts(force.parts, memory)
    outside = settle_world(force.world, memory, state.position)
    memory[ENERGY], memory[MOTION], memory[LEFT], memory[AT_WORLD] = energy, 0.5 * total(moving), 0.0, outside
    ledger[KINETIC] = 0.5 * op.copy_scale * total(moving)
    outside = op.firmness * outside
    ledger[ELASTIC] = op.copy_scale * (op.firmness * energy + 0.5 * total(held) - total(weight) + outside)
    ledger[WORLD_STORED] = op.copy_scale * outside


def slowed(state: State, factor: float) -> None:
    """What a copy with a material remembers of its motion, after its velocity was scaled from outside.

    Args:
        state: of the copy; its memory is changed in place.
        factor: of the velocity.
    """
    state.memory[MOTION] *= factor * factor
