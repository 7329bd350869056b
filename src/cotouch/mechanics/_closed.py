"""The closed step: any energy, the same exact balance.

A direction comes from a linear solve with a constant matrix, at any truncation. The copy moves along it, its true
energy is worked out once, and what the ledger then lack is put into the end velocity by one scale β about the velocity
of the centre of mass. Only v̂ meets ports and links, so everything that is proved for the linear step holds here.
"""

from cotouch.arrays import Float
from cotouch.mechanics._balance import (
    AT_WORLD,
    ENERGY,
    HAVE,
    LAST_ATTEMPT,
    LEFT,
    MOTION,
    NOISE,
    PASSED,
    ROUGH,
    TARGET,
    go_back,
    keep_place,
    resting,
    weigh,
)
from cotouch.mechanics._balance_parts import close_all, keep_parts
from cotouch.mechanics._force import BodyForce, evaluate, lean, resist
from cotouch.mechanics._force_memory import looks_ahead
from cotouch.mechanics._force_together import begin
from cotouch.mechanics._kernel import block, part
from cotouch.mechanics._meeting import Parts
from cotouch.mechanics._operator import DAMPING, STIFFNESS, Operator, row_product
from cotouch.mechanics._state import (
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
from cotouch.mechanics._step import assemble, move, port_work, solve_step
from cotouch.mechanics._vector import at, load, put, splat, store, total
from cotouch.mechanics._world import World
from cotouch.mechanics._world_force import corrects, lean_world, looks_of, press_world, settle_world, take_up

# Sweeps of the rotations from nowhere.
_MANY = 60
# How much of what the last look missed the next may leave.
COARSE = 0.03
# Change of v̂ from one look to the next, of itself, below which the next would change it by rounding only.
_SETTLED = 1e-9
# And change of places, which is below their rounding: who rests has a v̂ of noise alone [m].
_STILL = 1e-18
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
        ledger: result (BOOKS,), as of `step`; CLOSURE, BETA and SHORTENED besides.
        link_work: result (links,).
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.
    """
    take_up(force.world, state.memory)
    ledger[ITERATIONS] = 0.0
    rate = state.velocity
    directions = looks_ahead(state.memory, force.directions, force.cut)
    for number in range(looks_of(force.world, directions, work.dense.shape[0] > 0)):
        settled = predict(op, force, state, T, rate, work, lanes)
        if number >= directions and settled:
            break
        direct(
            op,
            force.world,
            state,
            links,
            ports,
            local_damping,
            extra_damping,
            T,
            rate,
            number > 0 and corrects(force.world),
            work,
            ledger,
            tolerance,
            cap,
            lanes,
        )
        rate = work.mean
    level(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, work, lanes)
    attempt, length, refused = 0, 1.0, False
    while True:
        keep_place(state, work, lanes)
        ledger[SUPPLIED] = port_work(op, state, ports, T, work.mean, lanes)
        move(op, state, links, T, sample, work, link_work, lanes)
        gain = ledger[SUPPLIED]
        for link in range(links.first, links.last):
            gain += at(link_work, link)
        weigh(op, force, state, local_damping, extra_damping, T, gain, work, ledger, lanes)
        passed = work.weighed[PASSED] != 0.0
        if not passed and close_all(
            op,
            force,
            state,
            links,
            ports,
            local_damping,
            extra_damping,
            T,
            ports.push[:0],
            attempt,
            work,
            ledger,
            lanes,
        ):
            break
        go_back(state, work, lanes)
        still = not passed and resting(work.weighed)
        if attempt == 0 and not passed and not still:
            predict(op, force, state, T, work.mean, work, lanes)
            direct(
                op,
                force.world,
                state,
                links,
                ports,
                local_damping,
                extra_damping,
                T,
                work.mean,
                False,
                work,
                ledger,
                tolerance,
                cap,
                lanes,
            )
            level(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, work, lanes)
        else:
            # What cannot be closed, or would still pass an obstacle, at the last attempt stays where it is.
            shorter = 0.0 if still or attempt >= LAST_ATTEMPT - 1 else 0.5
            refused = refused or (not still and shorter == 0.0)
            length *= shorter
            for i in range(op.mass.shape[0]):
                store(work.mean, i, shorter * load(work.mean, i, lanes), lanes)
        attempt += 1
    weighed = work.weighed
    rounded = abs(weighed[TARGET] - weighed[HAVE]) <= max(weighed[NOISE], weighed[ROUGH])
    ledger[SHORTENED] = 0.0 if rounded and not refused else 1.0 - length


@part
def direct(
    op: Operator,
    world: World | None,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    rate: Float,
    correct: bool,
    work: Workspace,
    ledger: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> None:
    """Finds a direction that knows where this rate led, by `predict`; or corrects it, which a coarse solve can."""
    assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
    lean_world(world, op.copy_scale * op.firmness, rate, work, lanes)
    if not correct or op.entries.shape[0] == 0:
        ledger[ITERATIONS] += solve_step(op, ports, work, tolerance, cap, lanes)
        return
    miss(op, work.diagonal, work.rhs, work, work.rhs, lanes)
    for i in range(op.mass.shape[0]):
        store(work.pull, i, load(work.mean, i, lanes), lanes)
    ledger[ITERATIONS] += solve_step(op, ports, work, max(tolerance, COARSE), cap, lanes)
    for i in range(op.mass.shape[0]):
        store(work.mean, i, load(work.mean, i, lanes) + load(work.pull, i, lanes), lanes)


@part
def miss(op: Operator, diagonal: Float, rhs: Float, work: Workspace, out: Float, lanes: tuple[int, ...]) -> None:
    """What `A v̂` lacks of a right-hand side; `out` may be it."""
    for i in range(diagonal.shape[0]):
        left = load(rhs, i, lanes) - diagonal[i] * load(work.mean, i, lanes)
        for family in range(op.entries.shape[0]):
            left = left - work.scale[family] * row_product(op, family, i, work.mean, lanes)
        store(out, i, left, lanes)


@part
def level(
    op: Operator,
    force: BodyForce,
    parts: Parts | None,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    work: Workspace,
    lanes: tuple[int, ...],
) -> None:
    """Moves each of several bodies as a whole so that it gets just the momentum of the forces where v̂ leads.

    Coarse solves, and looks that end before contact is exactly what it was, would make some out of nothing.
    """
    if parts is None:
        return
    predict(op, force, state, T, work.mean, work, lanes)
    assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
    miss(op, work.diagonal, work.rhs, work, work.rhs, lanes)
    for b in range(parts.worked.shape[0]):
        for what in range(4):
            put(parts.sums, (b, what), 0.0)
    if ports.shape.shape[0] > 0:
        for p in range(ports.first, ports.last):
            _take_port(ports, parts, p, at(work.port_gain, p - ports.first), work)
    for i in range(op.mass.shape[0]):
        b, own = at(parts.part, i), at(work.diagonal, i)
        for family in range(op.entries.shape[0]):
            for e in range(at(op.pointer, i), at(op.pointer, i + 1)):
                own += work.scale[family] * at(op.entries, (family, e))
        put(parts.sums, (b, 0), at(parts.sums, (b, 0)) + own)
        for a in range(3):
            put(parts.sums, (b, 1 + a), at(parts.sums, (b, 1 + a)) + at(work.rhs, (i, a)))
    for i in range(op.mass.shape[0]):
        b = at(parts.part, i)
        for a in range(3):
            put(work.mean, (i, a), at(work.mean, (i, a)) + at(parts.sums, (b, 1 + a)) / at(parts.sums, (b, 0)))


@part
def _take_port(ports: Ports, parts: Parts | None, p: int, gain: float, work: Workspace) -> None:
    """Takes off a right-hand side what a port that holds many rows resists, and notes how it resists each body."""
    if parts is None:
        return
    for i in range(work.mean.shape[0]):
        b, own = at(parts.part, i), gain * at(ports.shape, (p, i))
        if own == 0.0:
            continue
        for j in range(work.mean.shape[0]):
            share = at(ports.shape, (p, j))
            if at(parts.part, j) == b:
                put(parts.sums, (b, 0), at(parts.sums, (b, 0)) + own * share)
            for a in range(3):
                put(work.rhs, (i, a), at(work.rhs, (i, a)) - own * share * at(work.mean, (j, a)))


@part
def predict(
    op: Operator, force: BodyForce, state: State, T: float, rate: Float, work: Workspace, lanes: tuple[int, ...]
) -> bool:
    """Writes into `tension` what makes the linear system of a step ask for the body's true mean force at this rate.

    Args:
        op: the body.
        force: what resists inside.
        state: where the copy is.
        T: length of the step [s].
        rate: guess of v̂, (rows, width).
        work: scratch.
        lanes: fixes the width.

    Returns:
        Whether obstacles do what they did by the rate before.
    """
    rows, families = op.mass.shape[0], op.entries.shape[0]
    zero = splat(0.0, lanes)
    for i in range(rows):
        store(work.ahead, i, load(state.position, i, lanes) + T * load(rate, i, lanes), lanes)
        store(work.pull, i, zero, lanes)
    resist(force.law, state.memory, state.position, work.ahead, rate, work.pull, lanes)
    gravity = op.firmness * load(force.gravity, 0, lanes)
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
    told = work.dense.shape[0] == 0 or _lean(op, force, state, T, rate, work, lanes)
    return press_world(force.world, op.firmness, state.memory, state.position, work.ahead, T, state.tension) and told


@part
def _lean(
    op: Operator, force: BodyForce, state: State, T: float, rate: Float, work: Workspace, lanes: tuple[int, ...]
) -> bool:
    """Puts the law's tangent at a rate into `dense`, and off `tension` what that does; whether the rate has settled."""
    rows, dense = op.mass.shape[0], work.dense
    for p in range(dense.shape[0]):
        for q in range(dense.shape[1]):
            put(dense, (p, q), 0.0)
    lean(force.law, state.memory, state.position, work.ahead, rate, T, dense, lanes)
    change, size = 0.0, 0.0
    for i in range(rows):
        for a in range(3):
            given = 0.0
            for j in range(rows):
                for b in range(3):
                    given += at(dense, (3 * i + a, 3 * j + b)) * at(rate, (j, b))
            put(state.tension, (i, a), at(state.tension, (i, a)) - op.firmness * given)
            change += (at(rate, (i, a)) - at(work.tried, (i, a))) ** 2
            size += at(rate, (i, a)) ** 2
            put(work.tried, (i, a), at(rate, (i, a)))
    scale = op.copy_scale * op.firmness
    for p in range(dense.shape[0]):
        for q in range(dense.shape[1]):
            put(dense, (p, q), scale * at(dense, (p, q)))
    return change <= _SETTLED * _SETTLED * size or T * T * change <= _STILL * _STILL


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
        ledger: result (BOOKS,): the energies [J].
        lanes: fixes the width of a row.
    """
    rows, memory = op.mass.shape[0], state.memory
    zero = splat(0.0, lanes)
    held, weight, moving = zero, zero, zero
    gravity = op.firmness * load(force.gravity, 0, lanes)
    begin(force.law, memory, force.behind)
    for i in range(rows):
        x, v, m = load(state.position, i, lanes), load(state.velocity, i, lanes), at(op.mass, i)
        held = held + at(op.ground, i) * (x * x)
        weight = weight + m * x
        moving = moving + m * (v * v)
        store(work.pull, i, zero, lanes)
    energy, _ = evaluate(force.law, memory, state.position, state.position, work.pull, _MANY, lanes)
    keep_parts(force.parts, memory)
    outside = settle_world(force.world, memory, state.position)
    memory[ENERGY], memory[MOTION], memory[LEFT], memory[AT_WORLD] = energy, 0.5 * total(moving), 0.0, outside
    ledger[KINETIC] = 0.5 * op.copy_scale * total(moving)
    outside = op.firmness * outside
    ledger[ELASTIC] = op.copy_scale * (op.firmness * energy + 0.5 * total(held) - total(gravity * weight) + outside)
    ledger[WORLD_STORED] = op.copy_scale * outside


def slowed(state: State, factor: float) -> None:
    """What a copy with a material remembers of its motion, after its velocity was scaled from outside.

    Args:
        state: of the copy; its memory is changed in place.
        factor: of the velocity.
    """
    state.memory[MOTION] *= factor * factor
