"""About which velocity a step is shortened: that of the centre, or rest.

How bodies that touch move as a whole must neither shorten their steps nor be changed by it. So their way is shortened
about the velocity of their common centre, and their momentum is that of the forces from outside, whatever becomes of
the step (`level_groups`). One body alone that something outside holds goes less far about rest.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, inner, load, part, put, splat, store, total
from cotouch.mechanics._closed._balance import FIXED
from cotouch.mechanics._closed._balance_groups import CENTRE, LACKS, LENGTH, MASS, MOVING, OPEN, STILL, TIED, WITH
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import Ports, State, Workspace
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._meeting._bodies import Meeting, Parts
from cotouch.mechanics._meeting._world import World


@part
def find_outside(
    op: Operator,
    world: World | None,
    parts: Parts | None,
    ports: Ports,
    T: float,
    work: Workspace,
    lanes: tuple[int, ...],
) -> None:
    """Notes which bodies something outside holds: the ground, a port, or an obstacle that is in reach of the step.

    Who was found to be held so stays so for all attempts at a step.

    Args:
        op: the bodies.
        world: obstacles, which a look has met; None: none.
        parts: the bodies; None: there is one, and `weighed` is told.
        ports: what holds it.
        T: length of the step [s].
        work: `mean` is how it would move.
        lanes: fixes the width of a row.
    """
    for i in range(op.mass.shape[0]):
        if at(op.ground, i) > 0.0:
            _note(parts, i, work)
    for p in range(ports.row.shape[0]):
        if at(ports.stiffness, p) > 0.0 or at(ports.damping, p) > 0.0:
            if ports.shape.shape[0] == 0:
                _note(parts, at(ports.row, p), work)
            for i in range(op.mass.shape[0] if ports.shape.shape[0] > 0 else 0):
                if at(ports.shape, (p, i)) != 0.0:
                    _note(parts, i, work)
    if world is None:
        return
    for p in range(world.moves if at(world.known, 0) != 0.0 else 0):
        if at(world.start, (p, 3)) <= T * _speed(world, p, work.mean, lanes):
            _note(parts, at(world.row, at(world.pointer, p)), work)
    _find_solids(world.bodies, parts, T, work, lanes)


@part
def _speed(world: World, p: int, mean: Float, lanes: tuple[int, ...]) -> float:
    """How fast a point moves [m/s]."""
    rate = splat(0.0, lanes)
    for e in range(at(world.pointer, p), at(world.pointer, p + 1)):
        rate = rate + at(world.share, e) * load(mean, at(world.row, e), lanes)
    return math.sqrt(total(rate * rate))


@part
def _find_solids(m: Meeting | None, parts: Parts | None, T: float, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Notes which bodies are in reach of solids that stand still: of their points, or with points of their own."""
    if m is None or parts is None:
        return
    fastest = 0.0
    for i in range(work.mean.shape[0]):
        rate = load(work.mean, i, lanes)
        fastest = max(fastest, total(rate * rate))
    fastest = m.lever * math.sqrt(fastest)
    for e in range(at(m.entries, 1)):
        one, two = at(m.part, at(m.point, e)), at(m.other, e)
        if max(one, two) >= m.moves and at(m.began, (e, 0)) >= -T * fastest:
            put(parts.sums, (min(one, two), TIED), 1.0)


@part
def join_met(world: World | None, parts: Parts | None) -> None:
    """Who would pass another is of one group with it; and who was so in one attempt at a step is so in all that follow.

    Only together can they go less far, though at some lengths of the step they do not touch.

    Args:
        world: obstacles and points; None: none.
        parts: the bodies; None: there is one.
    """
    if world is None or parts is None:
        return
    m = world.bodies
    if m is not None:
        for e in range(at(m.entries, 1)):
            one, two = at(m.part, at(m.point, e)), at(m.other, e)
            if max(one, two) < m.moves and at(m.met.passed, one) != 0 and at(m.met.passed, two) != 0:
                _join(parts, one, two)
    keep_groups(parts)


@part
def meet_again(world: World | None, parts: Parts | None) -> None:
    """Who touches or passes another by the motion that was weighed last is of one group with it, and nobody else.

    Args:
        world: obstacles and points; None: none.
        parts: the bodies; None: there is one.
    """
    if parts is None:
        return
    for b in range(parts.held.shape[0]):
        put(parts.met.group, b, b)
    if world is None:
        return
    m = world.bodies
    if m is not None:
        for e in range(at(m.entries, 1)):
            one, two = at(m.part, at(m.point, e)), at(m.other, e)
            meets = at(m.began, (e, 0)) > 0.0 or at(m.ended, (e, 0)) > 0.0
            meets = meets or (at(m.met.passed, one) != 0 and at(m.met.passed, two) != 0)
            if max(one, two) < m.moves and meets:
                _join(parts, one, two)


@part
def join_held(parts: Parts | None, noise: float) -> None:
    """Where a group that a tool touches would have less than no energy, all that tools touch are one group.

    How much of what tools gave was for whom is known only as far as they did work on it.

    Args:
        parts: the bodies; None: there is one.
        noise: energies of less than this are rounding [J].
    """
    if parts is None:
        return
    for group in range(parts.held.shape[0]):
        have = 0.0
        for b in range(parts.held.shape[0]):
            if at(parts.held, b) != 0 and at(parts.met.group, b) == group:
                have += at(parts.sums, (b, MOVING)) + at(parts.sums, (b, LACKS))
        if have < -noise:
            for one in range(parts.held.shape[0]):
                for two in range(one):
                    if at(parts.held, one) != 0 and at(parts.held, two) != 0:
                        _join(parts, one, two)


@part
def free_groups(parts: Parts | None) -> None:
    """A step begins: nothing is held yet, and nobody was of a group with another."""
    if parts is not None:
        for b in range(parts.held.shape[0]):
            put(parts.sums, (b, TIED), 0.0)
            put(parts.sums, (b, WITH), float(b))


@part
def keep_groups(parts: Parts | None) -> None:
    """Who was of a group with another, or is so now, stays so in this step."""
    if parts is None:
        return
    for b in range(parts.held.shape[0]):
        _join(parts, b, int(at(parts.sums, (b, WITH))))
    for b in range(parts.held.shape[0]):
        put(parts.sums, (b, WITH), float(at(parts.met.group, b)))


@part
def _join(parts: Parts, one: int, two: int) -> None:
    """Makes one group of those of two bodies."""
    low, high = at(parts.met.group, one), at(parts.met.group, two)
    low, high = min(low, high), max(low, high)
    for b in range(parts.met.group.shape[0] if low != high else 0):
        if at(parts.met.group, b) == high:
            put(parts.met.group, b, low)


@part
def _note(parts: Parts | None, i: int, work: Workspace) -> None:
    if parts is None:
        put(work.weighed, FIXED, 1.0)
    else:
        put(parts.sums, (at(parts.part, i), TIED), 1.0)


@part
def ask_length(work: Workspace, lanes: tuple[int, ...]) -> None:
    """Keeps the way that a direction asks for, of which attempts at a step go a part.

    Args:
        work: `asked` keeps `mean`.
        lanes: fixes the width of a row.
    """
    for i in range(work.mean.shape[0]):
        store(work.asked, i, load(work.mean, i, lanes), lanes)


@part
def ask_fall(op: Operator, force: BodyForce, state: State, T: float, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Asks for the way that weight alone gives: what a direction asks for that went astray says nothing of a centre.

    Args:
        op: the body's matrices.
        force: what resists inside the body.
        state: of the copy.
        T: length of the step [s].
        work: `asked` is written.
        lanes: fixes the width of a row.
    """
    for i in range(work.mean.shape[0]):
        gained = (0.5 * T * op.firmness) * load(force.gravity, i, lanes)
        store(work.asked, i, load(state.velocity, i, lanes) + gained, lanes)


@part
def _find_centres(op: Operator, parts: Parts, asked: Float) -> None:
    """Writes how fast the centre of each body's group is to go."""
    for b in range(parts.held.shape[0]):
        for a in range(3):
            put(parts.sums, (b, CENTRE + a), 0.0)
    for i in range(op.mass.shape[0]):
        group = at(parts.met.group, at(parts.part, i))
        for a in range(3):
            more = at(op.mass, i) * at(asked, (i, a))
            put(parts.sums, (group, CENTRE + a), at(parts.sums, (group, CENTRE + a)) + more)
    for group in range(parts.held.shape[0]):
        if at(parts.met.group, group) == group:
            mass, goes = 0.0, 0.0
            for b in range(parts.held.shape[0]):
                if at(parts.met.group, b) == group:
                    mass += at(parts.sums, (b, MASS))
            for a in range(3):
                goes += abs(at(parts.sums, (group, CENTRE + a)))
            free = goes < math.inf
            for a in range(3):
                put(parts.sums, (group, CENTRE + a), at(parts.sums, (group, CENTRE + a)) / mass if free else 0.0)


@part
def stretch(parts: Parts | None, mean: Float, factor: float, lanes: tuple[int, ...]) -> None:
    """Scales how far a body goes; of several those that tools touch.

    Args:
        parts: the bodies; None: there is one.
        mean: velocity of the rows, (rows, width); changed in place [m/s].
        factor: by which it is scaled, >= 0.
        lanes: fixes the width of a row.
    """
    for i in range(mean.shape[0]):
        goes = factor
        if parts is not None:
            goes = factor if at(parts.held, at(parts.part, i)) != 0 else 1.0
        _scale(mean, i, goes, lanes)


@inner
def _scale(mean: Float, i: int, factor: float, lanes: tuple[int, ...]) -> None:
    """Scales a row; what overflowed would be no number times 0."""
    store(mean, i, factor * load(mean, i, lanes) if factor > 0.0 else splat(0.0, lanes), lanes)


@part
def set_length(
    op: Operator, parts: Parts | None, work: Workspace, length: float, rest: bool, lanes: tuple[int, ...]
) -> bool:
    """Sets how much of the way asked for a body goes; of several those whose groups are not closed, as `decide` says.

    Who rests stays, which is no shorter way.

    Args:
        op: the bodies.
        parts: which of them is which; None: there is one.
        work: `asked` holds the way, `mean` gets it; `find_outside` has told who is held.
        length: how much of it, of one body; of several 0: none, else what `decide` says.
        rest: about rest, whether anything holds them or not.
        lanes: fixes the width of a row.

    Returns:
        Whether any of it had gone anywhere.
    """
    if parts is None:
        return _set_alone(op, work, length, rest or at(work.weighed, FIXED) != 0.0, lanes)
    mean, asked, gone = work.mean, work.asked, False
    if not rest:
        _find_centres(op, parts, asked)
    for b in range(parts.held.shape[0]):
        if length == 0.0 and at(parts.sums, (b, OPEN)) > 0.0:
            put(parts.sums, (b, LENGTH), 0.0)
    for i in range(mean.shape[0]):
        b = at(parts.part, i)
        state = at(parts.sums, (b, OPEN))
        goes = 0.0 if state == STILL else at(parts.sums, (b, LENGTH))
        for a in range(3 if state != 0.0 else 0):
            about = 0.0 if rest or state == STILL else at(parts.sums, (at(parts.met.group, b), CENTRE + a))
            gone = gone or at(mean, (i, a)) != 0.0
            put(mean, (i, a), about + goes * (at(asked, (i, a)) - about) if goes > 0.0 else about)
    return gone


@part
def stop_all(parts: Parts | None, mean: Float, lanes: tuple[int, ...]) -> None:
    """Nothing goes anywhere.

    Args:
        parts: the bodies; None: there is one.
        mean: velocity of the rows, (rows, width), which becomes 0.
        lanes: fixes the width of a row.
    """
    for i in range(mean.shape[0]):
        store(mean, i, splat(0.0, lanes), lanes)
    if parts is not None:
        for b in range(parts.held.shape[0]):
            put(parts.sums, (b, LENGTH), 0.0)


@part
def _set_alone(op: Operator, work: Workspace, length: float, rest: bool, lanes: tuple[int, ...]) -> bool:
    """`set_length` of one body."""
    mean, asked, gone, about, mass = work.mean, work.asked, False, splat(0.0, lanes), 0.0
    for i in range(0 if rest else mean.shape[0]):
        about, mass = about + at(op.mass, i) * load(asked, i, lanes), mass + at(op.mass, i)
    if mass > 0.0:
        about = (1.0 / mass) * about
    if not total(about * about) < math.inf:
        about = splat(0.0, lanes)
    for i in range(mean.shape[0]):
        rate, goes = load(mean, i, lanes), load(asked, i, lanes)
        gone = gone or total(rate * rate) != 0.0
        store(mean, i, about + length * (goes - about) if length > 0.0 else about, lanes)
    return gone


@part
def shortest(parts: Parts | None, length: float) -> float:
    """How far a body went of the way that was asked for; of several, the one that went least.

    Args:
        parts: the bodies; None: there is one.
        length: of a single body, 0 to 1.
    """
    if parts is not None:
        length = 1.0
        for b in range(parts.held.shape[0]):
            length = min(length, at(parts.sums, (b, LENGTH)))
    return length
