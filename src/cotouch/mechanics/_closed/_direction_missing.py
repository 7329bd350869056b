"""What a direction misses of the forces where it leads, as the linear system of a step has it, and its corrections."""

from cotouch.arrays import Float
from cotouch.kernels import at, inner, load, part, put, splat, store
from cotouch.mechanics._linear._operator import (
    DAMPING,
    MASS,
    STIFFNESS,
    WEIGHTS,
    Operator,
    mixed,
    row_product,
    taken_off,
)
from cotouch.mechanics._linear._state import Ports, Workspace
from cotouch.mechanics._meeting._bodies import Parts


@part
def stiffen(op: Operator, T: float, share: float, work: Workspace) -> None:
    """Adds to A a share of the springs and dampers within the body.

    Args:
        op: the body's matrices.
        T: length of the step [s].
        share: of theirs, >= 0.
        work: `diagonal` and `scale` are added to.
    """
    for i in range(op.mass.shape[0]):
        put(work.diagonal, i, at(work.diagonal, i) + share * op.copy_scale * _inside(op, T, i))
    for family in range(op.entries.shape[0]):
        inside = at(op.mix, (DAMPING, family)) + 0.5 * T * at(op.mix, (STIFFNESS, family))
        put(work.scale, family, at(work.scale, family) + share * op.copy_scale * inside)


@inner
def _inside(op: Operator, T: float, i: int) -> float:
    """What stands on the diagonal of A by the springs and dampers within the body, of all copies."""
    inside = at(op.damping, i) - at(op.drag, i) + 0.5 * T * (at(op.stiffness, i) - at(op.ground, i))
    if op.taken.shape[0] > 0:
        inside += taken_off(op, T, i)
    return inside


@inner
def outer(op: Operator, T: float, i: int, work: Workspace) -> float:
    """What stands on the diagonal of A without the springs and dampers within the body, whose force is known.

    Args:
        op: the body's matrices.
        T: length of the step [s].
        i: which row.
        work: `diagonal` is that of A.
    """
    return at(work.diagonal, i) - op.copy_scale * _inside(op, T, i)


@inner
def _beside(op: Operator, T: float, family: int, work: Workspace) -> float:
    """And what of a family off the diagonal: of weights that couple nodes."""
    inside = at(op.mix, (DAMPING, family)) + 0.5 * T * at(op.mix, (STIFFNESS, family))
    return at(work.scale, family) - op.copy_scale * inside


@inner
def couples(op: Operator) -> bool:
    """Whether there are any."""
    coupled = mixed(op, MASS)
    for matrix in range(WEIGHTS, op.mix.shape[0]):
        coupled = coupled or mixed(op, matrix)
    return coupled


@part
def lack(op: Operator, T: float, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Takes off the right-hand side what is done by v̂, but for springs and dampers within the body.

    Args:
        op: the body's matrices.
        T: length of the step [s].
        work: `mean` is v̂; `rhs` is changed.
        lanes: fixes the width of a row.
    """
    joined = couples(op)
    for i in range(op.mass.shape[0]):
        left = load(work.rhs, i, lanes) - outer(op, T, i, work) * load(work.mean, i, lanes)
        for family in range(op.entries.shape[0] if joined else 0):
            left = left - _beside(op, T, family, work) * row_product(op, family, i, work.mean, lanes)
        store(work.rhs, i, left, lanes)
    for p in range(work.dense.shape[0]):
        i, a, given = at(work.among, p // 3), p % 3, 0.0
        for q in range(work.dense.shape[1]):
            given += at(work.dense, (p, q)) * at(work.mean, (at(work.among, q // 3), q % 3))
        put(work.rhs, (i, a), at(work.rhs, (i, a)) - given)


@part
def lack_ports(ports: Ports, work: Workspace, rhs: Float) -> None:
    """Takes off a right-hand side what ports that hold many rows resist v̂.

    Args:
        ports: that hold many rows; there may be none.
        work: `mean` is v̂.
        rhs: (rows, width), changed in place [N].
    """
    for p in range(ports.shape.shape[0]):
        for a in range(rhs.shape[1]):
            goes = 0.0
            for i in range(rhs.shape[0]):
                goes += at(ports.shape, (p, i)) * at(work.mean, (i, a))
            goes *= at(work.port_gain, p)
            for i in range(rhs.shape[0]):
                put(rhs, (i, a), at(rhs, (i, a)) - at(ports.shape, (p, i)) * goes)


@part
def hold_ports(op: Operator, ports: Ports, work: Workspace) -> None:
    """Puts on the diagonal how ports resist rows that are solved for one by one beside others that are so at once.

    There each port holds one row.

    Args:
        op: the body's matrices.
        ports: what holds the copy.
        work: `diagonal` is added to.
    """
    if ports.shape.shape[0] > 0 and work.dense.shape[0] > 0:
        for p in range(ports.row.shape[0]):
            gain = at(work.port_gain, p)
            for i in range(op.mass.shape[0]):
                if at(work.rigid, i) < 0:
                    put(work.diagonal, i, at(work.diagonal, i) + gain * at(ports.shape, (p, i)) ** 2)


@inner
def _row(op: Operator, T: float, i: int, joined: bool, work: Workspace) -> float:
    """Sum of a row of A: springs and dampers within the body do not feel what moves it as a whole."""
    own = outer(op, T, i, work)
    for family in range(op.entries.shape[0] if joined else 0):
        for e in range(at(op.pointer, i), at(op.pointer, i + 1)):
            own += _beside(op, T, family, work) * at(op.entries, (family, e))
    return own


@part
def move_whole(op: Operator, parts: Parts | None, T: float, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Moves each body as a whole, in `pull`, as its momentum asks; the right-hand side gets what is left to solve.

    What is solved for at once is so as a whole.

    Args:
        op: the body's matrices.
        parts: the bodies; None: there is one.
        T: length of the step [s].
        work: `pull` and `rhs` are written.
        lanes: fixes the width of a row.
    """
    joined = couples(op)
    if parts is None:
        left, whole = splat(0.0, lanes), 0.0
        for i in range(op.mass.shape[0]):
            left = left + load(work.rhs, i, lanes)
            whole += _row(op, T, i, joined, work)
        left = (1.0 / whole) * left
        for i in range(op.mass.shape[0]):
            store(work.rhs, i, load(work.rhs, i, lanes) - _row(op, T, i, joined, work) * left, lanes)
            store(work.pull, i, load(work.pull, i, lanes) + left, lanes)
        return
    for b in range(parts.held.shape[0]):
        for what in range(4):
            put(parts.sums, (b, what), 0.0)
    for i in range(op.mass.shape[0]):
        b = at(parts.part, i)
        if at(work.rigid, i) >= 0:
            continue
        put(parts.sums, (b, 0), at(parts.sums, (b, 0)) + _row(op, T, i, joined, work))
        for a in range(3):
            put(parts.sums, (b, 1 + a), at(parts.sums, (b, 1 + a)) + at(work.rhs, (i, a)))
    for i in range(op.mass.shape[0]):
        b, own = at(parts.part, i), _row(op, T, i, joined, work)
        for a in range(3 if at(work.rigid, i) < 0 else 0):
            goes = at(parts.sums, (b, 1 + a)) / at(parts.sums, (b, 0))
            put(work.rhs, (i, a), at(work.rhs, (i, a)) - own * goes)
            put(work.pull, (i, a), at(work.pull, (i, a)) + goes)


@part
def add_momentum(op: Operator, T: float, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Moves the body as a whole so that `A v̂` has the momentum of the right-hand side, which a solve missed.

    Args:
        op: the body's matrices.
        T: length of the step [s].
        work: `mean` is v̂; changed in place.
        lanes: fixes the width of a row.
    """
    left, whole, joined = splat(0.0, lanes), 0.0, couples(op)
    for i in range(op.mass.shape[0]):
        own = _row(op, T, i, joined, work)
        left = left + (load(work.rhs, i, lanes) - own * load(work.mean, i, lanes))
        whole += own
    left = (1.0 / whole) * left
    for i in range(op.mass.shape[0]):
        store(work.mean, i, load(work.mean, i, lanes) + left, lanes)


@part
def miss(op: Operator, diagonal: Float, rhs: Float, work: Workspace, out: Float, lanes: tuple[int, ...]) -> None:
    """What `A v̂` lacks of a right-hand side; `out` may be it.

    Args:
        op: the body's matrices.
        diagonal: of A, (rows,) [Ns/m].
        rhs: (rows, width) [N].
        work: `mean` is v̂, and `scale` those of the families.
        out: result, (rows, width) [N].
        lanes: fixes the width of a row.
    """
    for i in range(diagonal.shape[0]):
        left = load(rhs, i, lanes) - diagonal[i] * load(work.mean, i, lanes)
        for family in range(op.entries.shape[0]):
            left = left - work.scale[family] * row_product(op, family, i, work.mean, lanes)
        store(out, i, left, lanes)


@inner
def resisted(op: Operator, i: int, work: Workspace) -> float:
    """Sum of a row of A: what resists there that a body moves as a whole [Ns/m].

    Args:
        op: the body's matrices.
        i: which row.
        work: `diagonal` and `scale` are those of A.
    """
    own = at(work.diagonal, i)
    for family in range(op.entries.shape[0]):
        for e in range(at(op.pointer, i), at(op.pointer, i + 1)):
            own += work.scale[family] * at(op.entries, (family, e))
    return own


@part
def take_port(ports: Ports, parts: Parts | None, p: int, gain: float, work: Workspace) -> None:
    """Takes off a right-hand side what a port that holds many rows resists, and notes how it resists each body.

    Args:
        ports: what holds the copy.
        parts: the bodies; None: there is one.
        p: which port.
        gain: what it resists [Ns/m].
        work: `mean` is v̂; `rhs` is changed.
    """
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
