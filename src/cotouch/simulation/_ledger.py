"""What the batch engine books and records."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.interaction import Hands
from cotouch.kernels import at, inner, kernel, load, put, splat, store, total
from cotouch.mechanics import ITERATIONS, WEIGHTS, Operator, mixed, multiply
from cotouch.simulation._layout import (
    SLOT_DELAY_WORK,
    SLOT_LINK_WORK,
    USER_ELASTIC,
    Fields,
    Float,
    Frames,
    Record,
    Scratch,
    Topology,
)


@inner
def delay_work_of(
    op: Operator, topology: Topology, fields: Fields, scratch: Scratch, s: int, T: float, lanes: tuple[int, ...]
) -> float:
    """Energy that the age of a sample adds to a link while its receiver moves: `-T v̂ᵀ K (x_j - x̃)`.

    Args:
        op: the model.
        topology: who is linked to whom.
        fields: state of all copies.
        scratch: room to work in.
        s: the slot.
        T: length of the step [s].
        lanes: axes that are stepped together.
    """
    rows = op.mass.shape[0]
    w = at(topology.weight, s)
    peer = at(topology.peer, s)
    base = at(scratch.slot, s) * rows
    mean = scratch.work.mean
    work = splat(0.0, lanes)
    if mixed(op, WEIGHTS + w):
        multiply(op, WEIGHTS + w, op.weight[w], mean, scratch.product, lanes)
        for i in range(rows):
            gap = load(fields.samples, base + i, lanes) - load(fields.position, peer * rows + i, lanes)
            work = work + load(scratch.product, i, lanes) * gap
    else:
        for i in range(rows):
            gap = load(fields.samples, base + i, lanes) - load(fields.position, peer * rows + i, lanes)
            work = work + at(op.weight, (w, i)) * (load(mean, i, lanes) * gap)
    return T * at(topology.strength, s) * total(work)


@inner
def spring_energies(
    op: Operator,
    topology: Topology,
    fields: Fields,
    record: Record,
    scratch: Scratch,
    tick: int,
    lanes: tuple[int, ...],
) -> float:
    """Energy `½‖x_i - x_j‖²_K` of every link, recorded; returns their sum.

    Args:
        op: the model.
        topology: who is linked to whom.
        fields: state of all copies.
        record: what is kept; written to.
        scratch: room to work in.
        tick: entry of the record.
        lanes: axes that are stepped together.
    """
    rows = op.mass.shape[0]
    result = 0.0
    for link in range(topology.ends.shape[0]):
        a, b, s = at(topology.ends, (link, 0)), at(topology.ends, (link, 1)), at(topology.slot, link)
        w = at(topology.weight, s)
        form = 0.0
        if mixed(op, WEIGHTS + w):
            for i in range(rows):
                gap = load(fields.position, a * rows + i, lanes) - load(fields.position, b * rows + i, lanes)
                store(scratch.difference, i, gap, lanes)
            form = multiply(op, WEIGHTS + w, op.weight[w], scratch.difference, scratch.product, lanes)
        else:
            square = splat(0.0, lanes)
            for i in range(rows):
                gap = load(fields.position, a * rows + i, lanes) - load(fields.position, b * rows + i, lanes)
                square = square + at(op.weight, (w, i)) * (gap * gap)
            form = total(square)
        energy = 0.5 * at(topology.strength, s) * form
        put(record.links, (tick, link), energy)
        result += energy
    return result


@inner
def keep_user(
    record: Record,
    hands: Hands,
    fields: Fields,
    scratch: Scratch,
    topology: Topology,
    i: int,
    entry: int,
    lanes: tuple[int, ...],
) -> None:
    """Records one user: kept nodes, forces at its ports, its ledger and those of its slots.

    Args:
        record: what is kept; written to.
        hands: of all users.
        fields: state of all copies.
        scratch: room to work in.
        topology: who is linked to whom.
        i: the user.
        entry: of the record.
        lanes: axes that are stepped together.
    """
    dense = record.shape.shape[0] > 0
    kept = record.position.shape[2]
    rows = fields.position.shape[1]
    base = (i * record.position.shape[1] + entry) * kept
    for node in range(kept):
        if dense:
            x, v = splat(0.0, lanes), splat(0.0, lanes)
            for j in range(rows):
                x = x + at(record.shape, (node, j)) * load(fields.position, i * rows + j, lanes)
                v = v + at(record.shape, (node, j)) * load(fields.velocity, i * rows + j, lanes)
        else:
            x = load(fields.position, i * rows + at(record.row, node), lanes)
            v = load(fields.velocity, i * rows + at(record.row, node), lanes)
        store(record.position, base + node, x, lanes)
        store(record.velocity, base + node, v, lanes)
    for p in range(at(hands.first, i), at(hands.first, i + 1)):
        store(record.force, p * record.force.shape[1] + entry, load(scratch.ports.force, p, lanes), lanes)
    for column in range(USER_ELASTIC + 1):
        _unless_zero(record.users, column, i, entry, at(record.running, (i, column)))
    for column in range(USER_ELASTIC + 1, record.running.shape[1]):
        _unless_zero(record.users, column + 1, i, entry, at(record.running, (i, column)))
    _unless_zero(record.users, USER_ELASTIC + 1, i, entry, scratch.ledger[ITERATIONS])
    for s in range(at(topology.first, i), at(topology.first, i + 1)):
        put(record.slots, (SLOT_LINK_WORK, s, entry), at(scratch.slot_running, (s, SLOT_LINK_WORK)))
        put(record.slots, (SLOT_DELAY_WORK, s, entry), at(scratch.slot_running, (s, SLOT_DELAY_WORK)))


@inner
def _unless_zero(ledger: Float, book: int, row: int, entry: int, value: float) -> None:
    if value != 0.0:
        put(ledger, (book, row, entry), value)


@inner
def add(array: Float, row: int, column: int, value: float) -> None:
    """Adds to an entry.

    Args:
        array: two-dimensional; changed in place.
        row: of the entry.
        column: of the entry.
        value: to add.
    """
    put(array, (row, column), at(array, (row, column)) + value)


@kernel
def copy(target: Float, source: Float, lanes: tuple[int, ...]) -> None:
    """Copies rows.

    Args:
        target: written, (rows, width).
        source: read, (rows, width).
        lanes: as long as a row is wide.
    """
    for i in range(source.shape[0]):
        store(target, i, load(source, i, lanes), lanes)


@inner
def keep_frames(frames: Frames, fields: Fields, end: float, lanes: tuple[int, ...]) -> None:
    """Keeps whole copies for the frames before a time.

    Args:
        frames: written to.
        fields: state of all copies.
        end: [s].
        lanes: axes that are stepped together.
    """
    rows = fields.position.shape[0] * fields.position.shape[1]
    while frames.done[0] < frames.time.shape[0] and at(frames.time, frames.done[0]) < end:
        for place in range(rows):
            store(frames.position, frames.done[0] * rows + place, load(fields.position, place, lanes), lanes)
        frames.done[0] += 1
