"""What several bodies' velocities are scaled by: each about its own centre, else about that of those that touch it."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, inner, part, put
from cotouch.mechanics._closed._balance import (
    AT_WORLD,
    ENERGY,
    GRAIN,
    HARDLY,
    HAVE,
    LAST_ATTEMPT,
    LAW,
    LEAST,
    LEFT,
    MOST,
    MOTION,
    MUCH,
    NOISE,
    OUTSIDE,
    RIGID,
    ROUGH,
    SLIGHT,
    TARGET,
    next_length,
)
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import BETA, CLOSURE, KINETIC, SHORTENED, State, Workspace
from cotouch.mechanics._meeting._bodies import Parts

# Numbers of each body: mass, momentum, kinetic energy, what it lacks, what of its energy is about its centre, how much
# energy went to and fro; the factor on its velocity, the velocity about which that acts; whether it shares with others
# what it lacks, and whether its group is open, 0: it is closed, `STILL`: it moves by nothing but rounding. What
# attempts keep: how far it goes, how far was too little and too much, whether something outside holds it, and one that
# it has been of one group with.
MASS, MOMENTUM, MOVING, LACKS, ABOUT, FLOW, FACTOR, CENTRE, SHARES, OPEN = 0, 1, 4, 5, 6, 7, 8, 9, 12, 13
LENGTH, TOO_LITTLE, TOO_MUCH, TIED, WITH = 14, 15, 16, 17, 18
STILL = -1.0
# An attempt that is the last in any case: who passed another has done so.
LAST_OF_ALL = LAST_ATTEMPT + 1
# Where a group stays at last, those beside it may need as many attempts to go on without it.
OTHERS = 6


def closing_of(parts: Parts) -> Float:
    """What each body's velocity was scaled by in the step that was closed last, and about which, (bodies, 4).

    Args:
        parts: the bodies; what they hold is of whichever copy stepped last.
    """
    return parts.sums[:, FACTOR : CENTRE + 3].copy()


@inner
def _belongs(parts: Parts, b: int, group: int, sharing: bool) -> bool:
    """Whether a body is of a group, and of those in it that share."""
    return at(parts.met.group, b) == group and (not sharing or at(parts.sums, (b, SHARES)) != 0.0)


@part
def _sum(parts: Parts, group: int, sharing: bool) -> tuple[float, float, float, float, float, float, float]:
    """What a group lacks, or those in it that share.

    Returns:
        β² about the common centre, negative infinity: nothing moves about it; β² about rest; what is lacking [J]; the
        mass [kg]; and the velocity of the centre.
    """
    mass = px = py = pz = have = lacks = 0.0
    for b in range(parts.held.shape[0]):
        if _belongs(parts, b, group, sharing):
            mass, have = mass + at(parts.sums, (b, MASS)), have + at(parts.sums, (b, MOVING))
            lacks += at(parts.sums, (b, LACKS))
            px, py = px + at(parts.sums, (b, MOMENTUM)), py + at(parts.sums, (b, MOMENTUM + 1))
            pz += at(parts.sums, (b, MOMENTUM + 2))
    if mass == 0.0:
        return 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0
    about = have - 0.5 * (px * px + py * py + pz * pz) / mass
    square = 1.0 + lacks / about if about > RIGID * have else -math.inf
    whole = 1.0 + lacks / have if have > 0.0 else -math.inf
    return square, whole, lacks, mass, px / mass, py / mass, pz / mass


@part
def _scale(parts: Parts, group: int, sharing: bool, square: float, x: float, y: float, z: float) -> None:
    """Has the velocities of a group, or of those in it that share, scaled about one velocity."""
    for b in range(parts.held.shape[0]):
        if _belongs(parts, b, group, sharing):
            put(parts.sums, (b, FACTOR), math.sqrt(square))
            put(parts.sums, (b, CENTRE), x)
            put(parts.sums, (b, CENTRE + 1), y)
            put(parts.sums, (b, CENTRE + 2), z)


@part
def decide(parts: Parts | None, weighed: Float, attempt: int, others: bool) -> tuple[bool, float]:
    """Finds for each body what its velocity is to be scaled by; groups that are not closed so are marked as open.

    Args:
        parts: the bodies; `_share_out` has found what they lack.
        weighed: see `weigh`.
        attempt: how often this step was tried before.
        others: whether only groups that no tool touches are asked.

    Returns:
        Whether all are closed, and the largest |β - 1| that is more than rounding.
    """
    good, worst = True, 0.0
    if parts is None:
        return good, worst
    noise, rounded = weighed[NOISE], max(weighed[NOISE], weighed[ROUGH])
    for group in range(parts.held.shape[0]):
        if at(parts.met.group, group) != group or (others and at(parts.held, group) != 0):
            continue
        passed, alone, hardly = False, 0.0, False
        for b in range(parts.held.shape[0]):
            if at(parts.met.group, b) != group:
                continue
            passed = passed or at(parts.met.passed, b) != 0
            lacks, about = at(parts.sums, (b, LACKS)), at(parts.sums, (b, ABOUT))
            square = 1.0 + lacks / about if about > RIGID * at(parts.sums, (b, MOVING)) else -1.0
            own = LEAST <= square <= MOST
            put(parts.sums, (b, SHARES), 0.0 if own else 1.0)
            put(parts.sums, (b, FACTOR), math.sqrt(square) if own else 1.0)
            for a in range(3):
                centre = at(parts.sums, (b, MOMENTUM + a)) / at(parts.sums, (b, MASS))
                put(parts.sums, (b, CENTRE + a), centre)
            if own and abs(lacks) > rounded:
                beside = abs(math.sqrt(square) - 1.0)
                alone = max(alone, beside)
                hardly = hardly or (beside > MUCH and about <= HARDLY * at(parts.sums, (b, MOVING)))
        square, whole, lacks, mass, x, y, z = _sum(parts, group, True)
        closed = mass == 0.0 or abs(lacks) <= noise
        if mass == 0.0 and hardly:
            square, whole, lacks, mass, x, y, z = _sum(parts, group, False)
            if abs(square - 1.0) <= MUCH:
                _scale(parts, group, False, square, x, y, z)
                alone = 0.0
            else:
                square, lacks = 1.0, 0.0
        worst = max(worst, alone)
        if not closed and LEAST <= square <= MOST:
            _scale(parts, group, True, square, x, y, z)
            closed = True
        elif not closed:
            square, whole, lacks, mass, x, y, z = _sum(parts, group, False)
            central, still = LEAST <= square <= MOST, square == -math.inf
            tied = is_tied(parts, group) and attempt > LAST_ATTEMPT - OTHERS + 2
            held = attempt > 0 and (tied or abs(whole - 1.0) <= SLIGHT)
            rests = not central and (still or held) and LEAST <= whole <= MOST
            closed = central or rests or (abs(lacks) <= rounded and max(square, whole) >= 0.0)
            closed = closed or attempt >= LAST_ATTEMPT
            if rests or square < 0.0:
                square, x, y, z = max(whole, 0.0), 0.0, 0.0, 0.0
            _scale(parts, group, False, square, x, y, z)
        if abs(lacks) > rounded and closed:
            worst = max(worst, abs(math.sqrt(square) - 1.0))
        if not closed or (passed and attempt < LAST_OF_ALL):
            good = False
            still = not passed and _rests(parts, group, rounded)
            far = passed or not (whole if square == -math.inf else square) > MOST
            for b in range(parts.held.shape[0]):
                if at(parts.met.group, b) == group and still:
                    put(parts.sums, (b, OPEN), STILL)
                elif at(parts.met.group, b) == group:
                    _go_on(parts, b, far)
    return good, worst


@inner
def _go_on(parts: Parts, b: int, far: bool) -> None:
    """Says how far a body is to go in the next attempt, as what it went was too much or too little."""
    length = at(parts.sums, (b, LENGTH))
    put(parts.sums, (b, TOO_MUCH if far else TOO_LITTLE), length)
    following = next_length(length, at(parts.sums, (b, TOO_LITTLE)), at(parts.sums, (b, TOO_MUCH)))
    put(parts.sums, (b, OPEN), 1.0)
    put(parts.sums, (b, LENGTH), following if length > 0.0 else 0.0)


@part
def start_attempts(parts: Parts | None) -> None:
    """No attempt at the step was made so far."""
    if parts is not None:
        for b in range(parts.held.shape[0]):
            put(parts.sums, (b, LENGTH), 1.0)
            put(parts.sums, (b, TOO_LITTLE), 0.0)
            put(parts.sums, (b, TOO_MUCH), math.inf)


@part
def is_tied(parts: Parts, group: int) -> bool:
    """Whether a tool, or something outside, holds any of a group.

    Args:
        parts: the bodies.
        group: the first of its bodies.
    """
    for b in range(parts.held.shape[0]):
        if at(parts.met.group, b) == group and (at(parts.sums, (b, TIED)) != 0.0 or at(parts.held, b) != 0):
            return True
    return False


@inner
def _rests(parts: Parts, group: int, rounded: float) -> bool:
    """Whether a group moves by nothing but rounding."""
    lacks = _sum(parts, group, False)[2]
    have = 0.0
    for b in range(parts.held.shape[0]):
        if at(parts.met.group, b) == group:
            have += at(parts.sums, (b, MOVING))
    return have <= rounded and abs(lacks) <= rounded


@part
def resting_parts(parts: Parts | None) -> bool:
    """Whether all groups that were not closed move by nothing but rounding."""
    rests = parts is not None
    if parts is not None:
        for b in range(parts.held.shape[0]):
            rests = rests and at(parts.sums, (b, OPEN)) <= 0.0
    return rests


@part
def held_together(parts: Parts | None) -> tuple[bool, float, float, bool]:
    """Whether tools touch a body; of all that they touch: what it lacks, β² that would close it, whether it passed."""
    held = passed = False
    lacks = have = px = py = pz = 0.0
    mass = 1e-300
    if parts is None:
        return held, lacks, 1.0, passed
    for b in range(parts.held.shape[0]):
        if at(parts.held, b) != 0:
            held, passed = True, passed or at(parts.met.passed, b) != 0
            lacks, have = lacks + at(parts.sums, (b, LACKS)), have + at(parts.sums, (b, MOVING))
            mass += at(parts.sums, (b, MASS))
            px, py = px + at(parts.sums, (b, MOMENTUM)), py + at(parts.sums, (b, MOMENTUM + 1))
            pz += at(parts.sums, (b, MOMENTUM + 2))
    if have == 0.0:
        return held, lacks, -1.0, passed
    about = have - 0.5 * (px * px + py * py + pz * pz) / mass
    return held, lacks, 1.0 + lacks / (about if about > RIGID * have else have), passed


@part
def scale_parts(op: Operator, parts: Parts | None, state: State, worst: float, work: Workspace, ledger: Float) -> None:
    """Scales the velocities of bodies as it was decided.

    Args:
        op: the body's matrices.
        parts: the bodies; None: there is one.
        state: whose velocity and memory are changed.
        worst: the factor that is farthest from 1.
        work: `weighed` says what there is.
        ledger: KINETIC, CLOSURE, BETA and SHORTENED are written.
    """
    if parts is None:
        return
    weighed, closed, kinetic = work.weighed, 0.0, work.weighed[HAVE]
    for i in range(op.mass.shape[0]):
        b = at(parts.part, i)
        beta = at(parts.sums, (b, FACTOR))
        for a in range(3):
            v = at(state.velocity, (i, a))
            if beta != 1.0:
                centre = at(parts.sums, (b, CENTRE + a))
                v = centre + beta * (v - centre)
                put(state.velocity, (i, a), v)
            closed += 0.5 * at(op.mass, i) * v * v
    memory = state.memory
    memory[ENERGY], memory[MOTION], memory[AT_WORLD] = weighed[LAW], closed, weighed[OUTSIDE]
    left = weighed[TARGET] - closed
    bound = parts.held.shape[0] * weighed[NOISE] + weighed[GRAIN]
    memory[LEFT] = left if abs(left) <= bound else 0.0
    ledger[KINETIC] = op.copy_scale * closed
    ledger[CLOSURE] = op.copy_scale * (closed - kinetic)
    ledger[BETA] = worst
    ledger[SHORTENED] = 0.0
