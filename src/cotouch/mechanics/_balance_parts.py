"""The balance of several bodies: each makes up for what it lacks by itself, about its own centre of mass.

One factor for all would scale velocities about a centre between the bodies: what one that flies lacks would kick one
that rests. So what came to each is worked out row by row, what contact did on it included. Only what bodies cannot make
up for by themselves is shared, among those that cannot.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.mechanics._balance import (
    AT_WORLD,
    ENERGY,
    GRAIN,
    HAVE,
    LAW,
    LEAST,
    LEFT,
    MOST,
    MOTION,
    NOISE,
    OUTSIDE,
    RIGID,
    ROUGH,
    TARGET,
    close,
)
from cotouch.mechanics._force import BodyForce
from cotouch.mechanics._kernel import inner, part
from cotouch.mechanics._meeting import Parts
from cotouch.mechanics._operator import Operator
from cotouch.mechanics._state import BETA, CLOSURE, KINETIC, SHORTENED, Links, Ports, State, Workspace
from cotouch.mechanics._vector import at, load, put, total

# Numbers of each body: mass, momentum, kinetic energy, what it lacks, what of its energy is about its centre, the
# factor on that, and whether it shares with others.
_MASS, _MOMENTUM, _HAVE, _LACKS, _ABOUT, _BETA, _SHARES = 0, 1, 4, 5, 6, 7, 8


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
        attempt: see `close`.
        work: likewise.
        ledger: likewise.
        lanes: fixes the width.

    Returns:
        Whether the step is good; else nothing is changed.
    """
    if force.parts is None:
        return close(op, state, attempt, work, ledger, lanes)
    _share_out(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, push, work, lanes)
    good = _close_parts(op, force.parts, state, work, ledger)
    if not good:
        good = close(op, state, attempt, work, ledger, lanes)
    if good:
        keep_parts(force.parts, state.memory)
    return good


@part
def keep_parts(parts: Parts | None, memory: Float) -> None:
    """Keeps each body's energy as it was evaluated last."""
    if parts is not None:
        for b in range(parts.worked.shape[0]):
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
    work: Workspace,
    lanes: tuple[int, ...],
) -> None:
    """Works out what each body lacks, of the whole body [J]."""
    if parts is None:
        return
    rows, share = op.mass.shape[0], 1.0 / op.copy_scale
    gravity = op.firmness * load(force.gravity, 0, lanes)
    for b in range(parts.worked.shape[0]):
        for what in range(_SHARES + 1):
            put(parts.sums, (b, what), 0.0)
        risen = at(parts.energy, (b, 0)) - at(state.memory, at(parts.memory, b)) + T * at(parts.energy, (b, 1))
        put(parts.sums, (b, _LACKS), op.firmness * (at(parts.worked, b) - risen))
    for i in range(rows):
        b, m, hold = at(parts.part, i), at(op.mass, i), at(op.ground, i)
        x, x0 = load(state.position, i, lanes), load(work.ahead, i, lanes)
        v, v0, rate = load(state.velocity, i, lanes), load(work.pull, i, lanes), load(work.mean, i, lanes)
        own = T * total(gravity * (m * rate)) - m * total((v - v0) * rate)
        own -= 0.5 * hold * total((x - x0) * (x + x0)) + T * at(op.drag, i) * total(rate * rate)
        for w in range(op.weight.shape[0]):
            lost = (local_damping[w] + extra_damping[w]) * at(op.weight, (w, i))
            own -= share * T * lost * total(rate * rate)
        if push.shape[0] > 0:
            own += share * T * total(load(push, i, lanes) * rate)
        _add(parts, b, _LACKS, own)
        put(parts.sums, (b, _MASS), at(parts.sums, (b, _MASS)) + m)
        _add(parts, b, _HAVE, 0.5 * m * total(v * v))
        for a in range(3):
            _add(parts, b, _MOMENTUM + a, m * at(state.velocity, (i, a)))
    for link in range(links.first, links.last):
        w, base = at(links.weight, link), at(links.slot, link) * rows
        for i in range(rows):
            rate = load(work.mean, i, lanes)
            middle = 0.5 * (load(state.position, i, lanes) + load(work.ahead, i, lanes))
            pulled = -at(links.strength, link) * (middle - load(links.samples, base + i, lanes))
            if links.push.shape[0] > 0:
                pulled = pulled + load(links.push, link * rows + i, lanes) - at(links.brake, link) * rate
            _add(parts, at(parts.part, i), _LACKS, share * T * at(op.weight, (w, i)) * total(pulled * rate))
    if ports.shape.shape[0] == 0:
        for p in range(ports.first, ports.last):
            i = at(ports.row, p)
            did = total(load(ports.force, p, lanes) * load(work.mean, i, lanes))
            _add(parts, at(parts.part, i), _LACKS, share * T * did)
    else:  # a port holds a point that follows many rows
        for p in range(ports.first, ports.last):
            for i in range(rows):
                did = at(ports.shape, (p, i)) * total(load(ports.force, p, lanes) * load(work.mean, i, lanes))
                _add(parts, at(parts.part, i), _LACKS, share * T * did)
    for i in range(rows):
        b = at(parts.part, i)
        beside = 0.0
        for a in range(3):
            centre = at(parts.sums, (b, _MOMENTUM + a)) / at(parts.sums, (b, _MASS))
            beside += (at(state.velocity, (i, a)) - centre) ** 2
        _add(parts, b, _ABOUT, 0.5 * at(op.mass, i) * beside)


@part
def _close_parts(op: Operator, parts: Parts | None, state: State, work: Workspace, ledger: Float) -> bool:
    """Balances each body by itself, and those that cannot about the centre of them all; nothing if that is too much."""
    if parts is None:
        return False
    bodies, weighed = parts.worked.shape[0], work.weighed
    kinetic, noise = weighed[HAVE], weighed[NOISE]
    rounded = max(noise, weighed[ROUGH])
    left = weighed[TARGET] - kinetic
    worst = 0.0
    mass = px = py = pz = shared = 0.0
    for b in range(bodies):
        lacks, about = at(parts.sums, (b, _LACKS)), at(parts.sums, (b, _ABOUT))
        square = 1.0 + lacks / about if about > RIGID * at(parts.sums, (b, _HAVE)) else -1.0
        if not LEAST <= square <= MOST:
            put(parts.sums, (b, _SHARES), 1.0)
            mass, shared = mass + at(parts.sums, (b, _MASS)), shared + at(parts.sums, (b, _HAVE))
            px, py = px + at(parts.sums, (b, _MOMENTUM)), py + at(parts.sums, (b, _MOMENTUM + 1))
            pz += at(parts.sums, (b, _MOMENTUM + 2))
            square = 1.0
        else:
            left -= lacks
            if abs(lacks) > rounded:
                worst = max(worst, abs(math.sqrt(square) - 1.0))
        put(parts.sums, (b, _BETA), math.sqrt(square))
    together = 1.0
    if abs(left) > noise:
        about = shared - 0.5 * (px * px + py * py + pz * pz) / mass if mass > 0.0 else 0.0
        square = 1.0 + left / about if about > RIGID * shared else -1.0
        if not LEAST <= square <= MOST:
            return False
        together = math.sqrt(square)
        if abs(left) > rounded:
            worst = max(worst, abs(together - 1.0))
    closed = 0.0
    for i in range(op.mass.shape[0]):
        b = at(parts.part, i)
        share, beta = at(parts.sums, (b, _SHARES)) != 0.0, at(parts.sums, (b, _BETA))
        if share:
            beta = together
        for a in range(3):
            whole = px if a == 0 else py if a == 1 else pz
            centre = whole / mass if share else at(parts.sums, (b, _MOMENTUM + a)) / at(parts.sums, (b, _MASS))
            v = at(state.velocity, (i, a))
            if beta != 1.0:
                v = centre + beta * (v - centre)
                put(state.velocity, (i, a), v)
            closed += 0.5 * at(op.mass, i) * v * v
    memory = state.memory
    memory[ENERGY], memory[MOTION], memory[AT_WORLD] = weighed[LAW], closed, weighed[OUTSIDE]
    left = weighed[TARGET] - closed
    memory[LEFT] = left if abs(left) <= noise + weighed[GRAIN] else 0.0
    ledger[KINETIC] = op.copy_scale * closed
    ledger[CLOSURE] = op.copy_scale * (closed - kinetic)
    ledger[BETA] = worst
    ledger[SHORTENED] = 0.0
    return True
