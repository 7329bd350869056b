"""Where a closed step goes: looks ahead by the true mean force, each corrected by the constant matrix."""

from cotouch.arrays import Float
from cotouch.kernels import at, inner, load, part, put, splat, store, total
from cotouch.mechanics._closed._direction_combined import combine_looks, dot_rows
from cotouch.mechanics._closed._direction_missing import (
    add_momentum,
    hold_ports,
    lack,
    lack_ports,
    miss,
    move_whole,
    resisted,
    stiffen,
    take_port,
)
from cotouch.mechanics._closed._direction_turn import turn_whole
from cotouch.mechanics._linear._operator import DAMPING, STIFFNESS, Operator
from cotouch.mechanics._linear._solve import solve_step
from cotouch.mechanics._linear._state import ITERATIONS, Links, Ports, State, Workspace
from cotouch.mechanics._linear._step import assemble
from cotouch.mechanics._materials._force import BodyForce, lean, resist
from cotouch.mechanics._meeting._bodies import Parts
from cotouch.mechanics._meeting._world_force import press_world
from cotouch.mechanics._meeting._world_lean import lean_world

# How much of what the last look missed the next may leave.
COARSE = 0.03
# And how many iterations it takes at least: what they leave shrinks with the step, so that the closure does.
FEW = 2
# Change of v̂ from one look to the next, of itself, below which the next would change it by rounding only.
_SETTLED = 1e-9
# What the next would, where changes shrink at least so fast from look to look, as they do by a true tangent.
_LEFT, _SHRINKS = 1e-11, 0.1


@part
def direct(
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    number: int,
    work: Workspace,
    ledger: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> tuple[float, float, float]:
    """Corrects v̂ by what it misses of the forces where it leads, by `predict`; a coarse solve is enough for that.

    What of the momentum of these forces the solve leaves is given to the body as a whole, so that all of it arrives; of
    a single body so is their angular momentum, and its looks at a step are combined; `number` says how many were taken,
    negative: it is none of these.

    Args:
        op: the body's matrices.
        force: what resists inside the body.
        state: of the copy.
        links: the neighbours' samples.
        ports: what holds the copy.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step [s].
        number: how many looks were taken; negative: it is none of a step's.
        work: `mean` is v̂; corrected in place.
        ledger: ITERATIONS is added to.
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.

    Returns:
        Squares of the correction, and of the end velocity about the centre of mass, in the norm of M: it is of this
        that the closure takes; and the power that was missing before, which it would have made up for. Of what no
        matrix couples, 1 and 0, which say nothing.
    """
    ask(op, force, state, links, ports, local_damping, extra_damping, T, work, lanes)
    if op.entries.shape[0] == 0:
        ledger[ITERATIONS] += solve_step(op, ports, work, tolerance, 0, cap, lanes)
        return 1.0, 0.0, 0.0
    missed = 0.0
    if number >= 0 and force.parts is None and work.dense.shape[0] == 0:
        missed = combine_looks(state, T, number, work, lanes)
    elif number > 0 and work.dense.shape[0] == 0:
        missed = dot_rows(work.mean, work.rhs, lanes)  # as `combine_looks` returns it
    change, moving = _corrected(op, force, state, ports, T, 0.0, True, work, ledger, tolerance, cap, lanes)
    return change, moving, missed


@part
def ask(
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    work: Workspace,
    lanes: tuple[int, ...],
) -> None:
    """Works out what v̂ misses of the forces where it leads, by `predict`, for `correct`.

    Where nothing couples rows, all that is asked for.

    Args:
        op: the body's matrices.
        force: what resists inside the body.
        state: of the copy.
        links: the neighbours' samples.
        ports: what holds the copy.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step [s].
        work: `mean` is v̂; the system is written.
        lanes: fixes the width of a row.
    """
    assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
    lean_world(force.world, op.copy_scale * op.firmness, work.mean, work, lanes)
    if op.entries.shape[0] > 0:
        lack(op, T, work, lanes)
        lack_ports(ports, work, work.rhs)
        hold_ports(op, ports, work)


@part
def correct(
    op: Operator,
    force: BodyForce,
    state: State,
    ports: Ports,
    T: float,
    stiffer: float,
    work: Workspace,
    ledger: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> tuple[float, float]:
    """Corrects v̂ by what it misses, with springs and dampers within the body that are stiffer by a share of theirs.

    Args:
        op: the body's matrices.
        force: what resists inside the body.
        state: of the copy.
        ports: what holds the copy.
        T: length of the step [s].
        stiffer: that share, >= 0.
        work: `mean` is v̂, corrected in place; `rhs` what it misses.
        ledger: ITERATIONS is added to.
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.

    Returns:
        See `direct`.
    """
    return _corrected(op, force, state, ports, T, stiffer, False, work, ledger, tolerance, cap, lanes)


@part
def _corrected(
    op: Operator,
    force: BodyForce,
    state: State,
    ports: Ports,
    T: float,
    stiffer: float,
    turns: bool,
    work: Workspace,
    ledger: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> tuple[float, float]:
    """`correct`; `turns`: also turns the body as a whole, which helps where v̂ is nearly right."""
    turns, turned = turns and force.parts is None, 0.0
    for i in range(op.mass.shape[0]):
        store(work.pull, i, load(work.mean, i, lanes), lanes)
    move_whole(op, force.parts, T, work, lanes)
    if turns:
        turned = turn_whole(op, force.places, T, False, work)
    if stiffer > 0.0:
        stiffen(op, T, stiffer, work)
    ledger[ITERATIONS] += solve_step(op, ports, work, max(tolerance, COARSE), FEW, cap, lanes)
    if stiffer > 0.0:
        stiffen(op, T, -stiffer, work)
    if force.parts is None:
        add_momentum(op, T, work, lanes)
    if turns:
        turned += turn_whole(op, force.places, T, True, work)
    zero = splat(0.0, lanes)
    change, moving, momentum, mass = zero, zero, zero, 0.0
    for i in range(op.mass.shape[0]):
        more, m = load(work.mean, i, lanes), at(op.mass, i)
        rate = load(work.pull, i, lanes) + more
        store(work.mean, i, rate, lanes)
        change = change + m * (more * more)
        end = 2.0 * rate - load(state.velocity, i, lanes)
        moving = moving + m * (end * end)
        momentum = momentum + m * end
        mass += m
    return total(change) + turned, total(moving) - total(momentum * momentum) / mass


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
    known: bool,
    work: Workspace,
    lanes: tuple[int, ...],
) -> None:
    """Moves each of several bodies as a whole so that it gets just the momentum of the forces where v̂ leads.

    Coarse solves, and looks that end before contact is exactly what it was, would make some out of nothing. What a tool
    touches is left as it was found together with the tool. `known`: the last look was where v̂ leads.

    Args:
        op: the body's matrices.
        force: what resists inside the body.
        parts: the bodies; None: there is one.
        state: of the copy.
        links: the neighbours' samples.
        ports: what holds the copy.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step [s].
        known: whether the last look was where v̂ leads.
        work: `mean` is v̂; moved in place.
        lanes: fixes the width of a row.
    """
    if parts is None:
        return
    if not known or op.entries.shape[0] > 0:
        predict(op, force, state, T, True, work, lanes)
    assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
    miss(op, work.diagonal, work.rhs, work, work.rhs, lanes)
    for b in range(parts.held.shape[0]):
        for what in range(4):
            put(parts.sums, (b, what), 0.0)
    if ports.shape.shape[0] > 0:
        for p in range(ports.row.shape[0]):
            take_port(ports, parts, p, at(work.port_gain, p), work)
    for i in range(op.mass.shape[0]):
        b, own = at(parts.part, i), resisted(op, i, work)
        put(parts.sums, (b, 0), at(parts.sums, (b, 0)) + own)
        for a in range(3):
            put(parts.sums, (b, 1 + a), at(parts.sums, (b, 1 + a)) + at(work.rhs, (i, a)))
    for i in range(op.mass.shape[0]):
        b = at(parts.part, i)
        for a in range(3 if at(parts.held, b) == 0 else 0):
            put(work.mean, (i, a), at(work.mean, (i, a)) + at(parts.sums, (b, 1 + a)) / at(parts.sums, (b, 0)))


@inner
def begin_looks(work: Workspace) -> None:
    """No look at the step at hand was taken."""
    if work.tried.shape[0] > 0:
        put(work.tried, (work.tried.shape[0] - 1, 0), -1.0)


@part
def predict(
    op: Operator, force: BodyForce, state: State, T: float, whole: bool, work: Workspace, lanes: tuple[int, ...]
) -> bool:
    """Writes into `tension` the body's true mean force where v̂ leads.

    Args:
        op: the body.
        force: what resists inside.
        state: where the copy is.
        T: length of the step [s].
        whole: whether the linear system of a step shall ask for that force: then what its own springs and dampers do
            within the body is taken off.
        work: scratch; `mean` is v̂.
        lanes: fixes the width.

    Returns:
        Whether obstacles do what they did by the rate before.
    """
    rows, families, rate = op.mass.shape[0], op.entries.shape[0], work.mean
    zero = splat(0.0, lanes)
    for i in range(rows):
        store(work.ahead, i, load(state.position, i, lanes) + T * load(rate, i, lanes), lanes)
        store(work.pull, i, zero, lanes)
    resist(force.law, state.memory, state.position, work.ahead, rate, work.pull, lanes)
    for i in range(rows):
        gravity = op.firmness * load(force.gravity, i, lanes)
        tension = op.firmness * load(work.pull, i, lanes) - at(op.mass, i) * gravity
        tension = tension + at(op.ground, i) * load(state.position, i, lanes)
        own = load(rate, i, lanes)
        for family in range(families if whole else 0):
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
    among, dense, rates = work.among, work.dense, work.answer
    for p in range(dense.shape[0]):
        for q in range(dense.shape[1]):
            put(dense, (p, q), 0.0)
    lean(force.law, state.memory, state.position, work.ahead, rate, T, dense, lanes)
    change, size = 0.0, 0.0
    for r in range(among.shape[0]):
        for a in range(3):
            put(rates, 3 * r + a, at(rate, (at(among, r), a)))
    for r in range(among.shape[0]):
        i, gx, gy, gz = at(among, r), 0.0, 0.0, 0.0
        for q in range(dense.shape[1]):
            value = at(rates, q)
            gx += at(dense, (3 * r, q)) * value
            gy += at(dense, (3 * r + 1, q)) * value
            gz += at(dense, (3 * r + 2, q)) * value
        for a in range(3):
            given = gx if a == 0 else gy if a == 1 else gz
            put(state.tension, (i, a), at(state.tension, (i, a)) - op.firmness * given)
            change += (at(rate, (i, a)) - at(work.tried, (i, a))) ** 2
            size += at(rate, (i, a)) ** 2
            put(work.tried, (i, a), at(rate, (i, a)))
    scale = op.copy_scale * op.firmness
    for p in range(dense.shape[0]):
        for q in range(dense.shape[1]):
            put(dense, (p, q), scale * at(dense, (p, q)))
    last = at(work.tried, (rate.shape[0], 0))
    put(work.tried, (rate.shape[0], 0), change if last >= 0.0 else 0.0)  # of the first look there is none
    # Each look leaves that share of the last one's change by which that was smaller than the one before.
    done = change <= _SHRINKS * _SHRINKS * last and change * change <= _LEFT * _LEFT * size * last
    # Who rests has a v̂ of noise alone, which changes places by less than they are rounded.
    return done or change <= _SETTLED * _SETTLED * size or T * T * change <= force.rounding * force.rounding
