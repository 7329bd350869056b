"""The closed step: any energy, the same exact balance.

A direction comes from a linear solve with a constant matrix, at any truncation. The copy moves along it, its true
energy is worked out once, and what the ledger then lack is put into the end velocity by one scale β about the velocity
of the centre of mass. Only v̂ meets ports and links, so everything that is proved for the linear step holds here.
"""

import math

from cotouch.arrays import Float
from cotouch.mechanics._force import BodyForce, evaluate, resist
from cotouch.mechanics._force_memory import forget
from cotouch.mechanics._kernel import block, inner, part
from cotouch.mechanics._operator import DAMPING, STIFFNESS, Operator
from cotouch.mechanics._state import (
    BETA,
    BODY_LOSS,
    CLOSURE,
    ELASTIC,
    EXTRA_LOSS,
    ITERATIONS,
    KINETIC,
    LOCAL_LOSS,
    SHORTENED,
    SUPPLIED,
    Links,
    Ports,
    State,
    Workspace,
)
from cotouch.mechanics._step import assemble, move, port_work, solve_step
from cotouch.mechanics._vector import at, load, splat, store, total

# Places in a memory: energy of the law, half of vᵀMv, and what rounding left unbalanced, all for the whole body [J].
_ENERGY, _MOTION, _LEFT = 0, 1, 2
# Places in what `weigh` finds.
TARGET, HAVE, ABOUT, NOISE, LAW, ROUGH = range(6)
# β² outside of this asks for another direction, then for a shorter step.
LEAST, MOST = 0.8, 1.25
# The first attempt after a step is told apart by its direction, the others by halves of its length; this is the last.
LAST_ATTEMPT = 14
# Sweeps of the rotations in a step, and from nowhere.
_SWEEPS, _MANY = 2, 60
# A difference below this share of the energies that made it is their rounding.
_ROUNDING = 4e-15
# A step whose end velocity is changed by more than this is told: its forces and its energy disagree.
CLOSURE_ALARM = 1e-2
# Below this share of the kinetic energy, motion about the centre of mass is too little to balance anything with.
_RIGID = 1e-9


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
        ledger: result (BOOKS,), as of `step`; CLOSURE, BETA and SHORTENED besides.
        link_work: result (links,).
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.
    """
    predict(op, force, state, T, state.velocity, work, lanes)
    assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
    ledger[ITERATIONS] = solve_step(op, ports, work, tolerance, cap, lanes)
    for _ in range(force.directions - 1):
        _redirect(op, force, state, links, ports, local_damping, extra_damping, T, work, ledger, tolerance, cap, lanes)
    attempt, length = 0, 1.0
    while True:
        keep_place(state, work, lanes)
        ledger[SUPPLIED] = port_work(op, state, ports, T, work.mean, lanes)
        move(op, state, links, T, sample, work, link_work, lanes)
        gain = ledger[SUPPLIED]
        for link in range(links.first, links.last):
            gain += at(link_work, link)
        weigh(op, force, state, local_damping, extra_damping, T, gain, work, ledger, lanes)
        if close(op, state, attempt, work, ledger, lanes):
            break
        go_back(state, work, lanes)
        if attempt == 0:
            _redirect(
                op, force, state, links, ports, local_damping, extra_damping, T, work, ledger, tolerance, cap, lanes
            )
        else:
            length *= 0.5
            for i in range(op.mass.shape[0]):
                store(work.mean, i, 0.5 * load(work.mean, i, lanes), lanes)
        attempt += 1
    weighed = work.weighed
    rounded = abs(weighed[TARGET] - weighed[HAVE]) <= max(weighed[NOISE], weighed[ROUGH])
    ledger[SHORTENED] = 0.0 if rounded else 1.0 - length


@part
def _redirect(
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    work: Workspace,
    ledger: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> None:
    """Finds a direction that knows where the last one led."""
    predict(op, force, state, T, work.mean, work, lanes)
    assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
    ledger[ITERATIONS] += solve_step(op, ports, work, tolerance, cap, lanes)


@part
def predict(
    op: Operator, force: BodyForce, state: State, T: float, rate: Float, work: Workspace, lanes: tuple[int, ...]
) -> None:
    """Writes into `tension` what makes the linear system of a step ask for the body's true mean force at this rate.

    Args:
        op: the body.
        force: what resists inside.
        state: where the copy is.
        T: length of the step [s].
        rate: guess of v̂, (rows, width).
        work: scratch.
        lanes: fixes the width.
    """
    rows, families = op.mass.shape[0], op.entries.shape[0]
    zero = splat(0.0, lanes)
    for i in range(rows):
        store(work.ahead, i, load(state.position, i, lanes) + T * load(rate, i, lanes), lanes)
        store(work.pull, i, zero, lanes)
    resist(force.law, state.memory, state.position, work.ahead, rate, work.pull, lanes)
    gravity = load(force.gravity, 0, lanes)
    for i in range(rows):
        tension = op.firmness * load(work.pull, i, lanes) - at(op.mass, i) * gravity
        tension = tension + at(op.ground, i) * load(state.position, i, lanes)
        own = load(rate, i, lanes)
        for family in range(families):
            scale = 0.5 * T * op.mix[STIFFNESS, family] + op.mix[DAMPING, family]
            slip = zero
            for e in range(at(op.pointer, i), at(op.pointer, i + 1)):
                slip = slip + at(op.entries, (family, e)) * (load(rate, at(op.column, e), lanes) - own)
            tension = tension - scale * slip
        store(state.tension, i, tension, lanes)


@part
def keep_place(state: State, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Keeps where the copy is, and how fast, before it moves."""
    for i in range(state.position.shape[0]):
        store(work.ahead, i, load(state.position, i, lanes), lanes)
        store(work.pull, i, load(state.velocity, i, lanes), lanes)


@part
def go_back(state: State, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Takes the copy back to where it was kept."""
    for i in range(state.position.shape[0]):
        store(state.position, i, load(work.ahead, i, lanes), lanes)
        store(state.velocity, i, load(work.pull, i, lanes), lanes)


@part
def weigh(
    op: Operator,
    force: BodyForce,
    state: State,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    gain: float,
    work: Workspace,
    ledger: Float,
    lanes: tuple[int, ...],
) -> None:
    """Works out what the copy that was just moved holds and lost, and what its velocity should hold.

    Args:
        op: the body.
        force: what resists inside.
        state: where the copy came to.
        local_damping: B_i, (weights,).
        extra_damping: B_e, (weights,).
        T: length of the step [s].
        gain: work done on the copy by all but its own damping [J].
        work: `ahead` holds where the copy was, `mean` how it moved; `weighed` gets the kinetic energy that balances the
            step, that there is, what of it is about the centre of mass, the rounding of these, the energy of the law,
            and what the rounding of places does to that, all for the whole body [J].
        ledger: result: all but KINETIC and the closure's.
        lanes: fixes the width.
    """
    rows = op.mass.shape[0]
    memory, mean, weighed = state.memory, work.mean, work.weighed
    energy, power = evaluate(force.law, memory, work.ahead, state.position, mean, _SWEEPS, lanes)
    before = memory[_ENERGY]
    gravity = load(force.gravity, 0, lanes)
    zero = splat(0.0, lanes)
    held, was_held, dragged, weight, fallen = zero, zero, zero, zero, zero
    momentum, moving = zero, zero
    mass = 0.0
    for i in range(rows):
        m, hold = at(op.mass, i), at(op.ground, i)
        x, x0, rate, v = (
            load(state.position, i, lanes),
            load(work.ahead, i, lanes),
            load(mean, i, lanes),
            load(state.velocity, i, lanes),
        )
        held = held + hold * (x * x)
        was_held = was_held + hold * (x0 * x0)
        dragged = dragged + at(op.drag, i) * (rate * rate)
        weight = weight + m * x
        fallen = fallen + m * rate
        momentum = momentum + m * v
        moving = moving + m * (v * v)
        mass += m
    local, extra = 0.0, 0.0
    for w in range(op.weight.shape[0]):
        local += T * local_damping[w] * work.quadratic[w]
        extra += T * extra_damping[w] * work.quadratic[w]
    lost = T * (op.firmness * power + total(dragged))
    risen = op.firmness * (energy - before) + 0.5 * (total(held) - total(was_held)) - T * total(gravity * fallen)
    given = (gain - local - extra) / op.copy_scale
    kinetic = 0.5 * total(moving)
    centre = (1.0 / mass) * momentum
    own = zero
    for i in range(rows):
        beside = load(state.velocity, i, lanes) - centre
        own = own + at(op.mass, i) * (beside * beside)
    weighed[TARGET] = memory[_MOTION] + memory[_LEFT] + given - lost - risen
    weighed[HAVE], weighed[ABOUT], weighed[LAW] = kinetic, 0.5 * total(own), energy
    weighed[NOISE] = _ROUNDING * (
        op.firmness * (abs(energy) + abs(before)) + total(held) + abs(given) + lost + kinetic + memory[_MOTION]
    )
    # What rounding of places does to the energy of a strained body: too little to tell motion from rest by.
    weighed[ROUGH] = op.firmness * (force.grain + 2.0 * math.sqrt(force.grain * (abs(energy) + abs(before))))
    ledger[ELASTIC] = op.copy_scale * (op.firmness * energy + 0.5 * total(held) - total(gravity * weight))
    ledger[BODY_LOSS] = op.copy_scale * lost
    ledger[LOCAL_LOSS], ledger[EXTRA_LOSS] = local, extra


@inner
def square_of(weighed: Float, rest: bool) -> tuple[float, bool]:
    """β² that closes the step that was weighed, and whether it acts about the centre of mass.

    It acts about rest where nothing moves about the centre, and, if it may, where it would not do about the centre.
    """
    target, kinetic, about = weighed[TARGET], weighed[HAVE], weighed[ABOUT]
    square, still = -1.0, about <= _RIGID * kinetic
    if not still:
        square = 1.0 + (target - kinetic) / about
    if kinetic > 0.0 and (still or (rest and not LEAST <= square <= MOST)):
        whole = target / kinetic
        if still or LEAST <= whole <= MOST:
            return whole, False
    return square, True


@part
def close(op: Operator, state: State, attempt: int, work: Workspace, ledger: Float, lanes: tuple[int, ...]) -> bool:
    """Balances the step that was just weighed.

    Args:
        op: the body.
        state: where the copy came to; its velocity is changed in place.
        attempt: how often this step was tried before; after `LAST_ATTEMPT` it is closed as far as it can be.
        work: see `weigh`.
        ledger: result: KINETIC and the closure's.
        lanes: fixes the width.

    Returns:
        Whether the step is good; else nothing is changed.
    """
    rows, memory, weighed, zero = op.mass.shape[0], state.memory, work.weighed, splat(0.0, lanes)
    target, kinetic, noise = weighed[TARGET], weighed[HAVE], weighed[NOISE]
    square, central = square_of(weighed, attempt > 0)
    good = LEAST <= square <= MOST
    if not good and abs(target - kinetic) <= noise:
        good, square = True, 1.0
    # No step would be better, and force and energy do not disagree.
    rounded = abs(target - kinetic) <= max(noise, weighed[ROUGH])
    if not good and attempt < LAST_ATTEMPT and not (rounded and target >= 0.0):
        return False
    if not good and square < 0.0:  # nothing else is left to take it from
        square, central = (max(target, 0.0) / kinetic if kinetic > 0.0 else 1.0), False
    beta, closed = math.sqrt(square), kinetic
    if beta != 1.0:
        momentum, moving = zero, zero
        mass = 0.0
        for i in range(rows):
            momentum = momentum + at(op.mass, i) * load(state.velocity, i, lanes)
            mass += at(op.mass, i)
        centre = (1.0 / mass if central else 0.0) * momentum
        for i in range(rows):
            v = load(state.velocity, i, lanes)
            v = centre + beta * (v - centre)
            store(state.velocity, i, v, lanes)
            moving = moving + at(op.mass, i) * (v * v)
        closed = 0.5 * total(moving)
    memory[_ENERGY], memory[_MOTION] = weighed[LAW], closed
    left = target - closed
    memory[_LEFT] = left if abs(left) <= noise else 0.0
    ledger[KINETIC] = op.copy_scale * closed
    ledger[CLOSURE] = op.copy_scale * (closed - kinetic)
    ledger[BETA] = 0.0 if rounded else abs(beta - 1.0)
    ledger[SHORTENED] = 0.0
    return True


@block
def closed_settle(
    op: Operator, force: BodyForce, state: State, work: Workspace, ledger: Float, lanes: tuple[int, ...]
) -> None:
    """Finds the rotations and energies of a state that was just set."""
    rows, memory = op.mass.shape[0], state.memory
    zero = splat(0.0, lanes)
    held, weight, moving = zero, zero, zero
    gravity = load(force.gravity, 0, lanes)
    forget(memory)
    for i in range(rows):
        x, v, m = load(state.position, i, lanes), load(state.velocity, i, lanes), at(op.mass, i)
        held = held + at(op.ground, i) * (x * x)
        weight = weight + m * x
        moving = moving + m * (v * v)
        store(work.pull, i, zero, lanes)
    energy, _ = evaluate(force.law, memory, state.position, state.position, work.pull, _MANY, lanes)
    memory[_ENERGY], memory[_MOTION], memory[_LEFT] = energy, 0.5 * total(moving), 0.0
    ledger[KINETIC] = 0.5 * op.copy_scale * total(moving)
    ledger[ELASTIC] = op.copy_scale * (op.firmness * energy + 0.5 * total(held) - total(gravity * weight))


def slowed(state: State, factor: float) -> None:
    """What a copy with a material remembers of its motion, after its velocity was scaled from outside.

    Args:
        state: of the copy; its memory is changed in place.
        factor: of the velocity.
    """
    state.memory[_MOTION] *= factor * factor


@block
def inner_energy(
    force: BodyForce, memory: Float, x: Float, ahead: Float, rate: Float, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy of a body's inner forces at a place, and the power of its dampers, for whoever checks a ledger.

    Args:
        force: what resists inside.
        memory: rotations to begin with, (numbers,); gets those that were found.
        x: where the step began, displacements from rest, (rows, width) [m].
        ahead: the place, likewise.
        rate: mean velocity from the one to the other, likewise [m/s].
        lanes: fixes the width.

    Returns:
        Energy at `ahead` [J] and power over the step [W], of the whole body.
    """
    return evaluate(force.law, memory, x, ahead, rate, _MANY, lanes)
