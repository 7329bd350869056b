"""Groups of bodies that go less far than was asked for: their momentum is that of what holds them from outside."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import at, inner, part, put
from cotouch.mechanics._closed._balance_groups import CENTRE, MASS, MOMENTUM, MOVING, OPEN, is_tied
from cotouch.mechanics._closed._balance_length import keep_groups
from cotouch.mechanics._closed._direction import predict
from cotouch.mechanics._closed._direction_missing import miss, resisted, take_port
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import Links, Ports, State, Workspace
from cotouch.mechanics._linear._step import assemble
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._meeting._bodies import Parts

# Looks at most, and the change of a centre's velocity, of itself, after which the next is not taken.
_LOOKS, _SETTLED = 20, 1e-10
# Places where a group keeps its last shift and what its momentum lacked before, of sums that each attempt makes anew.
_SHIFT, _LACKED = MOVING, CENTRE


@part
def level_groups(
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
    """Moves each group that something outside holds, and that is not closed, as a whole until its momentum agrees.

    What its bodies do to each other adds up to nothing, so however far they go, only what is done to them from outside
    changes it: by ports and obstacles where they come to, by links and by weight.

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
        work: `mean` is v̂; moved in place.
        lanes: fixes the width of a row.
    """
    if parts is None:
        return
    sought = False
    for b in range(parts.held.shape[0]):
        sought = sought or _moves(parts, links, b)
    for number in range(_LOOKS if sought else 0):
        predict(op, force, state, T, True, work, lanes)
        keep_groups(parts)
        assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
        miss(op, work.diagonal, work.rhs, work, work.rhs, lanes)
        for b in range(parts.held.shape[0]):
            for what in range(4):
                put(parts.sums, (b, what), 0.0)
        for p in range(ports.row.shape[0] if ports.shape.shape[0] > 0 else 0):
            take_port(ports, parts, p, at(work.port_gain, p), work)
        _gather(op, parts, work)
        change, size = 0.0, 0.0
        for group in range(parts.held.shape[0]):
            if at(parts.met.group, group) == group:
                _set_share(parts, group, number)
        for i in range(op.mass.shape[0]):
            b = at(parts.part, i)
            if _moves(parts, links, b):
                group = at(parts.met.group, b)
                for a in range(3):
                    more = at(parts.sums, (group, _SHIFT + a))
                    put(work.mean, (i, a), at(work.mean, (i, a)) + more)
                    change, size = change + more * more, size + at(work.mean, (i, a)) ** 2
        if not change > _SETTLED * _SETTLED * size:
            break


@part
def _gather(op: Operator, parts: Parts, work: Workspace) -> None:
    """Adds up, for each group, what resists its motion as a whole, and what its momentum lacks."""
    for b in range(parts.held.shape[0]):
        group, own = at(parts.met.group, b), at(parts.sums, (b, MASS))
        if group != b:  # what ports resist
            put(parts.sums, (group, MASS), at(parts.sums, (group, MASS)) + own)
    for i in range(op.mass.shape[0]):
        group, own = at(parts.met.group, at(parts.part, i)), resisted(op, i, work)
        put(parts.sums, (group, MASS), at(parts.sums, (group, MASS)) + own)
        for a in range(3):
            lacks = at(parts.sums, (group, MOMENTUM + a)) + at(work.rhs, (i, a))
            put(parts.sums, (group, MOMENTUM + a), lacks)


@part
def _set_share(parts: Parts, group: int, number: int) -> None:
    """Sets how far a group goes by what its momentum lacks; obstacles resist too, as much as the last shift tells."""
    most = 1.0 / at(parts.sums, (group, MASS))
    share, along, square = most, 0.0, 0.0
    for a in range(3 if number > 0 else 0):
        did = at(parts.sums, (group, _LACKED + a)) - at(parts.sums, (group, MOMENTUM + a))
        along += did * at(parts.sums, (group, _SHIFT + a))
        square += did * did
    if along > 0.0 and square > 0.0:
        share = min(along / square, most)
    for a in range(3):
        lacks = at(parts.sums, (group, MOMENTUM + a))
        put(parts.sums, (group, _LACKED + a), lacks)
        put(parts.sums, (group, _SHIFT + a), share * lacks)


@inner
def _moves(parts: Parts, links: Links, b: int) -> bool:
    """Whether a body is of a group that is not closed, and that links or something outside hold."""
    if at(parts.sums, (b, OPEN)) <= 0.0 or at(parts.held, b) != 0:
        return False
    return links.slot.shape[0] > 0 or is_tied(parts, at(parts.met.group, b))
