"""The batch engine: all steps of all users in one compiled loop, with the energy books of the whole network.

Storage is booked in the order of the steps: when user i moves, its springs are measured against where the neighbours'
copies are at that moment. With a common index this is V of [Lee & Huang 2010, eq. 7] once all users have taken the
step; with own rates it stays an exact balance, because every joule is booked by the copy that moves.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.mechanics import (
    BODY_LOSS,
    DRIVE,
    ELASTIC,
    EXTRA_LOSS,
    ITERATIONS,
    KINETIC,
    LOCAL_LOSS,
    PROXY,
    SUPPLIED,
    TOUCH_LOSS,
    TOUCH_STORED,
    TOUCHED,
    WEIGHTS,
    Grips,
    Links,
    Operator,
    State,
    Tools,
    Workspace,
    at,
    inner,
    kernel,
    load,
    mixed,
    multiply,
    put,
    settle,
    splat,
    step,
    store,
    total,
    touch_step,
)
from cotouch.scenario import (
    Hands,
    ToolRecord,
    Touching,
    after_step,
    before_step,
    grip,
    keep_tools,
    proxy_energy,
)

Float = npt.NDArray[np.float64]
Int = npt.NDArray[np.int32]

# Rows of `Record.users`: cumulative work and losses, energies now [J], iterations of the last solve.
USER_BOOKS = ("supplied", "body_loss", "local_loss", "extra_loss", "kinetic", "elastic", "iterations")
# And of users with tools: cumulative work of what drives the proxies, and of the touch on the body, and losses in the
# touch; energies of proxies and touch now [J].
TOOL_BOOKS = ("drive_work", "touch_work", "touch_loss", "proxy", "touch_stored")
# Rows of `Record.slots`, cumulative [J]: what the link did on its receiver; what delay added to the link.
SLOT_BOOKS = ("link_work", "delay_work")
# Rows of `Record.ticks` [J].
TICK_BOOKS = ("stored", "supplied", "dissipated", "delay_work", "residual")


class Topology(NamedTuple):
    """Who is joined to whom. A *slot* is one direction of a link: a receiver's view of one neighbour.

    Attributes:
        first: first slot of each user, (users + 1,); a user's slots are consecutive.
        peer: the neighbour of each slot, (slots,).
        strength: spring of each slot's link, (slots,) [N/m].
        weight: index of its weight, (slots,).
        ends: the two users of each link, (links, 2).
        slot: a slot of each link, (links,).
    """

    first: Int
    peer: Int
    strength: Float
    weight: Int
    ends: Int
    slot: Int


class Timing(NamedTuple):
    """When every step happens and which samples it uses.

    Attributes:
        order: user of each event, (events,); a user's steps come in order.
        end: time at the end of each step, (users, steps) [s].
        length: T of each step, (users, steps) [s].
        used: index of the sample that each slot uses at each step of its user, (slots, steps); -1: the initial one.
        ring: how many samples of a user are kept, a power of two: a mask is ten times quicker than a remainder.
        reference: the user whose steps mark the network-wide records.
    """

    order: Int
    end: Float
    length: Float
    used: Int
    ring: int
    reference: int


class Fields(NamedTuple):
    """State of all users, (users, rows, width); samples (users * ring + users, rows, width)."""

    position: Float
    velocity: Float
    momentum: Float
    tension: Float
    samples: Float


class Record(NamedTuple):
    """What is kept of a run; entry 0 is the initial state.

    Attributes:
        every: one of how many steps is kept.
        row: rows kept in a nodal basis, (kept,).
        shape: row vectors that read kept nodes in a modal basis, (kept, rows), or (0, rows).
        position: (users, records, kept, width) [m].
        velocity: likewise [m/s].
        force: of the ports, (ports, records, width) [N].
        users: (len(USER_BOOKS), users, records), or with those of TOOL_BOOKS, zeros: what stays 0, such as the losses
            of dampers that there are not, is never written, so it takes no memory.
        slots: (len(SLOT_BOOKS), slots, records).
        links: spring energy of each link, (ticks, links) [J].
        ticks: (len(TICK_BOOKS), ticks) [J].
        running: cumulative books of users, (users, 6), or with those of TOOL_BOOKS (users, 11) [J].
        lowest: result (1,): smallest energy that the ports had supplied in all, over every step [J].
    """

    every: int
    row: Int
    shape: Float
    position: Float
    velocity: Float
    force: Float
    users: Float
    slots: Float
    links: Float
    ticks: Float
    running: Float
    lowest: Float


class Frames(NamedTuple):
    """Whole copies at given times.

    Attributes:
        time: increasing, (frames,) [s].
        position: result: displacement at the end of the last step before that time, (frames, users, rows, width) [m].
        done: result: how many are there, (1,).
    """

    time: Float
    position: Float
    done: Int


class Scratch(NamedTuple):
    """Scratch arrays of the engine."""

    grips: Grips
    work: Workspace
    books: Float
    link_work: Float
    slot: npt.NDArray[np.int64]
    counter: Int
    cursor: Int
    slot_running: Float
    difference: Float
    product: Float


@kernel
def run(
    op: Operator,
    topology: Topology,
    timing: Timing,
    hands: Hands,
    local_damping: Float,
    extra_damping: Float,
    fields: Fields,
    record: Record,
    scratch: Scratch,
    touching: Touching | None,
    tool_record: ToolRecord | None,
    frames: Frames,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> int:
    """Runs all events; returns how many were run before the motion left the range of floating point.

    Without tools `touching` and `tool_record` are None, and what concerns them is not even compiled.
    """
    users = fields.position.shape[0]
    supplied = 0.0
    dissipated = 0.0
    delay_work = 0.0
    energy = 0.0
    initial = 0.0
    lowest = 0.0
    tick = 0
    for i in range(users):
        state = State(fields.position[i], fields.velocity[i], fields.momentum[i], fields.tension[i])
        settle(op, state, scratch.books, lanes)
        record.running[i, 4] = scratch.books[KINETIC]
        record.running[i, 5] = scratch.books[ELASTIC]
        initial += scratch.books[KINETIC] + scratch.books[ELASTIC]
        if touching is not None:
            moving = proxy_energy(touching, i)
            put(record.running, (i, 9), moving)
            initial += moving
        _copy(fields.samples[users * timing.ring + i], fields.position[i], lanes)
        _keep_user(record, hands, fields, scratch, topology, i, 0, lanes)
        if touching is not None:
            keep_tools(tool_record, touching, i, 0)
    initial += _spring_energies(op, topology, fields, record, scratch, 0, lanes)
    put(record.ticks, (0, 0), initial)
    for book in range(1, 5):
        put(record.ticks, (book, 0), 0.0)
    energy = initial
    for event in range(timing.order.shape[0]):
        i = at(timing.order, event)
        k = at(scratch.counter, i)
        put(scratch.counter, i, k + 1)
        T = at(timing.length, (i, k))
        end = at(timing.end, (i, k))
        while frames.done[0] < frames.time.shape[0] and at(frames.time, frames.done[0]) < end:
            for place in range(users * fields.position.shape[1]):
                row = frames.done[0] * users * fields.position.shape[1] + place
                store(frames.position, row, load(fields.position, place, lanes), lanes)
            frames.done[0] += 1
        s0, s1 = at(topology.first, i), at(topology.first, i + 1)
        p0, p1 = at(hands.first, i), at(hands.first, i + 1)
        for s in range(s0, s1):
            index = at(timing.used, (s, k))
            peer = at(topology.peer, s)
            kept = peer * timing.ring + (index & (timing.ring - 1))
            put(scratch.slot, s, users * timing.ring + peer if index < 0 else kept)
        for p in range(p0, p1):
            grip(hands, scratch.grips, scratch.cursor, p, end, T, lanes)
        held = scratch.grips
        grips = Grips(
            p0,
            p1,
            held.row,
            held.shape,
            held.stiffness,
            held.damping,
            held.start,
            held.end,
            held.push,
            held.force,
        )
        links = Links(s0, s1, topology.strength, topology.weight, scratch.slot, fields.samples)
        state = State(fields.position[i], fields.velocity[i], fields.momentum[i], fields.tension[i])
        books = scratch.books
        if touching is not None:
            if not before_step(touching, i, end, T):
                record.lowest[0] = lowest
                return event
            have = touching.tools
            tools = Tools(
                at(touching.first, i),
                at(touching.first, i + 1),
                have.mass,
                have.radius,
                have.stiffness,
                have.loss,
                have.friction,
                have.reserve,
                have.grip_stiffness,
                have.grip_damping,
                have.mode,
                have.drive_stiffness,
                have.drive_damping,
                have.drive_start,
                have.drive_end,
                have.push,
                have.place,
                have.rate,
                have.account,
                have.grip_energy,
                have.inside,
                have.held,
                have.hold,
                have.offset,
                have.drive_force,
                have.touch_force,
                have.touching,
            )
            touch_step(
                op,
                state,
                links,
                grips,
                touching.surface,
                tools,
                local_damping[i],
                extra_damping[i],
                T,
                i * timing.ring + (k & (timing.ring - 1)),
                scratch.work,
                touching.work,
                books,
                touching.books,
                scratch.link_work,
                tolerance,
                cap,
                lanes,
            )
            after_step(touching, i)
            own = touching.books
            _add(record.running, i, 6, own[DRIVE])
            _add(record.running, i, 7, own[TOUCHED])
            _add(record.running, i, 8, own[TOUCH_LOSS])
            put(record.running, (i, 9), own[PROXY])
            put(record.running, (i, 10), own[TOUCH_STORED])
            supplied += own[DRIVE]
            dissipated += own[TOUCH_LOSS]
        else:
            step(
                op,
                state,
                links,
                grips,
                local_damping[i],
                extra_damping[i],
                T,
                i * timing.ring + (k & (timing.ring - 1)),
                scratch.work,
                books,
                scratch.link_work,
                tolerance,
                cap,
                lanes,
            )
        for s in range(s0, s1):
            added = _delay_work(op, topology, fields, scratch, s, T, lanes)
            _add(scratch.slot_running, s, 0, at(scratch.link_work, s))
            _add(scratch.slot_running, s, 1, added)
            delay_work += added
        running = record.running
        _add(running, i, 0, books[SUPPLIED])
        _add(running, i, 1, books[BODY_LOSS])
        _add(running, i, 2, books[LOCAL_LOSS])
        _add(running, i, 3, books[EXTRA_LOSS])
        put(running, (i, 4), books[KINETIC])
        put(running, (i, 5), books[ELASTIC])
        supplied += books[SUPPLIED]
        dissipated += books[BODY_LOSS] + books[LOCAL_LOSS] + books[EXTRA_LOSS]
        lowest = min(lowest, supplied)
        if not books[KINETIC] + books[ELASTIC] < 1e200:
            record.lowest[0] = lowest
            return event
        if (k + 1) % record.every == 0:
            _keep_user(record, hands, fields, scratch, topology, i, (k + 1) // record.every, lanes)
            if touching is not None:
                keep_tools(tool_record, touching, i, (k + 1) // record.every)
            if i == timing.reference:
                tick = (k + 1) // record.every
                energy = _spring_energies(op, topology, fields, record, scratch, tick, lanes)
                for user in range(users):
                    energy += at(running, (user, 4)) + at(running, (user, 5))
                    if touching is not None:
                        energy += at(running, (user, 9)) + at(running, (user, 10))
                put(record.ticks, (0, tick), energy)
                put(record.ticks, (1, tick), supplied)
                put(record.ticks, (2, tick), dissipated)
                put(record.ticks, (3, tick), delay_work)
                put(record.ticks, (4, tick), energy - initial - supplied + dissipated - delay_work)
    record.lowest[0] = lowest
    return timing.order.shape[0]


@inner
def _add(array: Float, row: int, column: int, value: float) -> None:
    put(array, (row, column), at(array, (row, column)) + value)


@kernel
def _copy(target: Float, source: Float, lanes: tuple[int, ...]) -> None:
    for i in range(source.shape[0]):
        store(target, i, load(source, i, lanes), lanes)


@inner
def _delay_work(
    op: Operator, topology: Topology, fields: Fields, scratch: Scratch, s: int, T: float, lanes: tuple[int, ...]
) -> float:
    """Energy that the age of a sample adds to a link while its receiver moves: `-T v̂ᵀ K (x_j - x̃)`."""
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
def _spring_energies(
    op: Operator,
    topology: Topology,
    fields: Fields,
    record: Record,
    scratch: Scratch,
    tick: int,
    lanes: tuple[int, ...],
) -> float:
    """Energy `½‖x_i - x_j‖²_K` of every link, recorded; returns their sum."""
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
def _keep_user(
    record: Record,
    hands: Hands,
    fields: Fields,
    scratch: Scratch,
    topology: Topology,
    i: int,
    entry: int,
    lanes: tuple[int, ...],
) -> None:
    """Records one user: kept nodes, forces at its ports, its books and those of its slots."""
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
        store(record.force, p * record.force.shape[1] + entry, load(scratch.grips.force, p, lanes), lanes)
    for book in range(6):
        _unless_zero(record.users, book, i, entry, at(record.running, (i, book)))
    for book in range(6, record.running.shape[1]):
        _unless_zero(record.users, book + 1, i, entry, at(record.running, (i, book)))
    _unless_zero(record.users, 6, i, entry, scratch.books[ITERATIONS])
    for s in range(at(topology.first, i), at(topology.first, i + 1)):
        put(record.slots, (0, s, entry), at(scratch.slot_running, (s, 0)))
        put(record.slots, (1, s, entry), at(scratch.slot_running, (s, 1)))


@inner
def _unless_zero(books: Float, book: int, row: int, entry: int, value: float) -> None:
    if value != 0.0:
        put(books, (book, row, entry), value)
