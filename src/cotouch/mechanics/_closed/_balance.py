"""What a closed step holds, lost and still lacks, and the factor on its end velocity that makes up for it."""

import math

from cotouch.arrays import Float
from cotouch.kernels import at, inner, load, part, splat, store, total
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import (
    BETA,
    BODY_LOSS,
    CLOSURE,
    ELASTIC,
    EXTRA_LOSS,
    KINETIC,
    LOCAL_LOSS,
    SHORTENED,
    WORLD_LOSS,
    WORLD_STORED,
    Links,
    State,
    Workspace,
)
from cotouch.mechanics._materials._call import call_undo
from cotouch.mechanics._materials._force import BodyForce, evaluate
from cotouch.mechanics._materials._nearest import SWEEPS
from cotouch.mechanics._meeting._world_force import grain_of, tell_world, unsettled, weigh_world

# Places in a memory: energy of the law, half of vᵀMv, what rounding left unbalanced, and energy at obstacles, all for
# the whole body [J].
ENERGY, MOTION, LEFT, AT_WORLD = 0, 1, 2, 3
# Places in what `weigh` finds; the last says whether something outside holds the body.
TARGET, HAVE, ABOUT, NOISE, LAW, ROUGH, OUTSIDE, PASSED, GRAIN, FIXED = range(10)
# β² outside of this asks for another direction, then for a shorter step.
LEAST, MOST = 0.8, 1.25
# The first attempts at a step are told apart by their direction, the others by their length; this is the last.
LAST_ATTEMPT = 20
# A difference below this share of the energies that made it is their rounding.
_ROUNDING = 4e-15
# Who has less than the first share of its energy about its own centre, and would be changed by more than the second if
# it made up for what it lacks by itself, does so as a whole where it meets an obstacle, or with those that touch it.
HARDLY, MUCH = 1e-4, 1e-3
# Who is free may be changed as a whole, and with it its momentum, by less than this share of its energy.
SLIGHT = 1e-6
# Below this share of the kinetic energy, motion about the centre of mass is too little to balance anything with.
RIGID = 1e-9


@part
def keep_place(state: State, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Keeps where the copy is, and how fast, before it moves.

    Args:
        state: of the copy.
        work: `ahead` and `pull` keep them.
        lanes: fixes the width of a row.
    """
    for i in range(state.position.shape[0]):
        store(work.ahead, i, load(state.position, i, lanes), lanes)
        store(work.pull, i, load(state.velocity, i, lanes), lanes)


@part
def go_back(force: BodyForce, state: State, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Takes the copy back to where it was kept, after it was weighed.

    Args:
        force: what resists inside the body.
        state: whose memory, position and velocity are changed.
        work: `ahead` and `pull` kept them.
        lanes: fixes the width of a row.
    """
    call_undo(force.law, state.memory, force.behind)
    for i in range(state.position.shape[0]):
        store(state.position, i, load(work.ahead, i, lanes), lanes)
        store(state.velocity, i, load(work.pull, i, lanes), lanes)


@part
def stay(force: BodyForce, state: State, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Takes the copy back, to be weighed anew where it does not move.

    Args:
        force: what resists inside the body.
        state: whose memory, position and velocity are changed.
        work: as of `go_back`; `mean` becomes 0.
        lanes: fixes the width of a row.
    """
    go_back(force, state, work, lanes)
    for i in range(work.mean.shape[0]):
        store(work.mean, i, splat(0.0, lanes), lanes)


@part
def with_links(work: float, links: Links, link_work: Float) -> float:
    """Some work, and that of all links of a copy in the step [J].

    Args:
        work: of what else there is [J].
        links: the neighbours' samples.
        link_work: work of each link, (links,) [J].
    """
    for link in range(links.slot.shape[0]):
        work += at(link_work, link)
    return work


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
            what the rounding of places does to that, the energy at obstacles and what rounding does to it, all for
            the whole body [J]; and whether it passed through one.
        ledger: result: all but KINETIC and the closure's.
        lanes: fixes the width.
    """
    rows = op.mass.shape[0]
    memory, mean, weighed = state.memory, work.mean, work.weighed
    energy, power = evaluate(force.law, memory, work.ahead, state.position, mean, SWEEPS, lanes)
    outside, rubbed, passed = weigh_world(force.world, memory, work.ahead, state.position, T)
    weighed[OUTSIDE], weighed[PASSED] = outside, 1.0 if passed else 0.0
    before, was_outside = memory[ENERGY], op.firmness * memory[AT_WORLD]
    outside, rubbed = op.firmness * outside, op.firmness * rubbed
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
        gravity = (m * op.firmness) * load(force.gravity, i, lanes)
        weight = weight + gravity * x
        fallen = fallen + gravity * rate
        momentum = momentum + m * v
        moving = moving + m * (v * v)
        mass += m
    local, extra = 0.0, 0.0
    for w in range(op.weight.shape[0]):
        local += T * local_damping[w] * work.quadratic[w]
        extra += T * extra_damping[w] * work.quadratic[w]
    lost = T * (op.firmness * power + total(dragged))
    risen = op.firmness * (energy - before) + 0.5 * (total(held) - total(was_held)) - T * total(fallen)
    risen += outside - was_outside + rubbed
    given = (gain - local - extra) / op.copy_scale
    kinetic = 0.5 * total(moving)
    centre = (1.0 / mass) * momentum
    own = zero
    for i in range(rows):
        beside = load(state.velocity, i, lanes) - centre
        own = own + at(op.mass, i) * (beside * beside)
    weighed[TARGET] = memory[MOTION] + memory[LEFT] + given - lost - risen
    weighed[HAVE], weighed[ABOUT], weighed[LAW] = kinetic, 0.5 * total(own), energy
    weighed[NOISE] = _ROUNDING * (
        op.firmness * (abs(energy) + abs(before))
        + total(held)
        + abs(given)
        + lost
        + kinetic
        + memory[MOTION]
        + outside
        + was_outside
        + rubbed
    )
    # What rounding of places does to the energy of a strained body: too little to tell motion from rest by.
    weighed[ROUGH] = op.firmness * (force.grain + 2.0 * math.sqrt(force.grain * (abs(energy) + abs(before))))
    weighed[GRAIN] = grain_of(force.world, outside + was_outside)
    weighed[ROUGH] += weighed[GRAIN] + unsettled(force.world, rubbed + T * abs(total(fallen)))
    if not weighed[NOISE] + weighed[ROUGH] < math.inf:  # no rounding, and nothing closes it
        weighed[TARGET], weighed[HAVE], weighed[ABOUT], weighed[NOISE], weighed[ROUGH] = -1.0, 1.0, 1.0, -math.inf, 0.0
    ledger[ELASTIC] = op.copy_scale * (op.firmness * energy + 0.5 * total(held) - total(weight) + outside)
    ledger[WORLD_LOSS], ledger[WORLD_STORED] = op.copy_scale * rubbed, op.copy_scale * outside
    tell_world(force.world, op.copy_scale * op.firmness, ledger)
    ledger[BODY_LOSS] = op.copy_scale * (lost + rubbed)
    ledger[LOCAL_LOSS], ledger[EXTRA_LOSS] = local, extra


@inner
def is_rounded(weighed: Float, over: float, share: float) -> bool:
    """Whether what the step that was weighed leaves over [J], of a copy of some share, may be rounding.

    Args:
        weighed: what the step was weighed with; see `weigh`.
        over: what it leaves over [J].
        share: of the copy, its 1/N.
    """
    return abs(over) <= share * max(weighed[NOISE], weighed[ROUGH])


@inner
def is_rough(weighed: Float) -> bool:
    """Whether the step that was weighed moves by rounding of places alone, which tells nothing of forces."""
    return weighed[HAVE] <= weighed[ROUGH]


@inner
def resting(weighed: Float) -> bool:
    """Whether the step that was weighed moves by nothing but the rounding of places, which is no reason to move."""
    return is_rough(weighed) and abs(weighed[TARGET] - weighed[HAVE]) <= weighed[ROUGH]


@inner
def next_length(length: float, least: float, greatest: float) -> float:
    """How far the next attempt at a step goes: halfway between what is too little and what is too much.

    As a step gets shorter, β² grows from below 1 to far above it, so that somewhere between it is 1 (DESIGN.md).

    Args:
        length: of the attempt before, of the way that the direction asked for.
        least: the greatest so far that was too little.
        greatest: the smallest so far that was too much; infinity: none was.
    """
    return 0.5 * (least + greatest) if greatest < math.inf else 2.0 * length


@inner
def square_of(weighed: Float, rest: bool) -> tuple[float, bool]:
    """β² that closes the step that was weighed, and whether it acts about the centre of mass.

    It acts about rest where nothing moves about the centre; if it may, where it would not do about the centre and
    something outside holds the body, or hardly anything is lacking; and where what meets an obstacle slides as a whole,
    hardly moving about its centre: that takes momentum anyway.

    Args:
        weighed: what the step was weighed with; see `weigh`.
        rest: whether it may act about rest.
    """
    target, kinetic, about = weighed[TARGET], weighed[HAVE], weighed[ABOUT]
    square, still = -1.0, about <= RIGID * kinetic
    if not still:
        square = 1.0 + (target - kinetic) / about
        if weighed[OUTSIDE] > 0.0 and about <= HARDLY * kinetic and not abs(square - 1.0) <= MUCH:
            still = abs(target - kinetic) <= MUCH * kinetic
    rest = rest and (weighed[FIXED] != 0.0 or abs(target - kinetic) <= SLIGHT * kinetic)
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
    memory[ENERGY], memory[MOTION], memory[AT_WORLD] = weighed[LAW], closed, weighed[OUTSIDE]
    left = target - closed
    memory[LEFT] = left if abs(left) <= noise + weighed[GRAIN] else 0.0
    ledger[KINETIC] = op.copy_scale * closed
    ledger[CLOSURE] = op.copy_scale * (closed - kinetic)
    ledger[BETA] = 0.0 if rounded else abs(beta - 1.0)
    ledger[SHORTENED] = 0.0
    return True
