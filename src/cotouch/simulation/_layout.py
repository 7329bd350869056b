"""What the batch engine works on: who is joined to whom, when, and what is kept."""

from typing import NamedTuple

from cotouch.arrays import Float, Int, Long
from cotouch.mechanics import Links, Ports, State, Tools, Workspace
from cotouch.passing import Each, by_address

# Rows of `Record.users`: cumulative work and losses, energies now [J], iterations of the last solve.
USER_LEDGER = ("supplied", "body_loss", "local_loss", "extra_loss", "kinetic", "elastic", "iterations")
# And of users with tools: cumulative work of what drives the proxies, and of the touch on the body, and losses in the
# touch; energies of proxies and touch now [J].
TOOL_LEDGER = ("drive_work", "touch_work", "touch_loss", "proxy", "touch_stored")
# And of bodies that take closed steps: work of the closure so far [J]; largest |β - 1| so far; steps that told of one.
CLOSED_LEDGER = ("closure", "closure_factor", "closure_alarms")
# And where there are obstacles: what of the body's losses was lost there, and of its energy is held there [J]; the mean
# force of all of them on the copy [N].
WORLD_LEDGER = ("world_loss", "world_stored", "world_x", "world_y", "world_z")
# And of bodies that can be cut: what the elements held that were taken away so far [J], and how many they are.
CUT_LEDGER = ("cut", "cut_elements")
# Rows of `Record.slots`, cumulative [J]: what the link did on its receiver; what delay added to the link.
SLOT_LEDGER = ("link_work", "delay_work")
# Rows of `Record.ticks` [J].
TICK_LEDGER = ("stored", "supplied", "dissipated", "delay_work", "residual", "slack")
# Columns of `Record.running`: of users but for iterations, then of tools, where there are any.
USER_SUPPLIED, USER_BODY_LOSS, USER_LOCAL_LOSS, USER_EXTRA_LOSS, USER_KINETIC, USER_ELASTIC = range(6)
TOOL_DRIVE_WORK, TOOL_TOUCH_WORK, TOOL_TOUCH_LOSS, TOOL_PROXY, TOOL_TOUCH_STORED = range(6, 11)
# And, counted from behind these, of closed steps, then of obstacles.
CLOSED_CLOSURE, CLOSED_CLOSURE_FACTOR, CLOSED_CLOSURE_ALARMS = range(3)
CLOSED_WORLD_LOSS, CLOSED_WORLD_STORED, CLOSED_WORLD_X = range(3, 6)
# Rows of the ledgers of slots and of ticks.
SLOT_LINK_WORK, SLOT_DELAY_WORK = range(2)
TICK_STORED, TICK_SUPPLIED, TICK_DISSIPATED, TICK_DELAY_WORK, TICK_RESIDUAL, TICK_SLACK = range(6)


@by_address
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


@by_address
class Timing(NamedTuple):
    """When every step happens and which samples it uses.

    Attributes:
        order: user of each event, (events,); a user's steps come in order.
        end: time at the end of each step, (users, steps) [s].
        length: T of each step, (users, steps) [s].
        used: index of the sample that each slot uses at each step of its user, (slots, steps); -1: the initial one.
        ring: how many samples of a user are kept, a power of two: a mask is ten times quicker than a remainder.
        reference: the user whose steps mark the network-wide records.
        stop: the run ends once this is raised, (1,); see `cotouch.interrupt`.
    """

    order: Int
    end: Float
    length: Float
    used: Int
    ring: int
    reference: int
    stop: Long


@by_address
class Fields(NamedTuple):
    """State of all users, (users, rows, width); memory (users, numbers); samples (ring and initial, rows, width)."""

    position: Float
    velocity: Float
    momentum: Float
    tension: Float
    memory: Float
    samples: Float


@by_address
class Copies(NamedTuple):
    """What each copy has of what all have, in the same memory.

    Attributes:
        states: of the fields.
        links: to its neighbours.
        ports: that hold it.
        tools: None where nobody has tools.
    """

    states: Each[State]
    links: Each[Links]
    ports: Each[Ports]
    tools: Each[Tools] | None


@by_address
class Record(NamedTuple):
    """What is kept of a run; entry 0 is the initial state.

    Attributes:
        every: one of how many steps is kept.
        row: rows kept in a nodal basis, (kept,).
        shape: row vectors that read kept nodes in a modal basis, (kept, rows), or (0, rows).
        position: (users, records, kept, width) [m].
        velocity: likewise [m/s].
        force: of the ports, (ports, records, width) [N].
        users: (len(USER_LEDGER), users, records), and those of the other ledgers where there are any, zeros:
            what stays 0, such as the losses of dampers that there are not, is never written, so it takes no memory.
        slots: (len(SLOT_LEDGER), slots, records).
        links: spring energy of each link, (ticks, links) [J].
        ticks: (len(TICK_LEDGER), ticks) [J].
        running: cumulative ledgers of users, (users, 6), then those of the other ledgers likewise [J].
        lowest: result (1 + users,), over every step: smallest energy that the ports had supplied in all, and that each
            copy and its tools held by their places, at most 0: what weight gave one that fell below where it began, and
            attraction a tool that it drew near [J].
        refused: result (1,): number of the user whose law said what no link can be, 0 if none did.
        made: result (2,): energy that links less the damping B_i had put into all copies, at most and at the end [J].
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
    refused: Int
    made: Float


@by_address
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


@by_address
class Scratch(NamedTuple):
    """Scratch arrays of the engine."""

    ports: Ports
    work: Workspace
    ledger: Float
    link_work: Float
    slot: Long
    counter: Int
    cursor: Int
    slot_running: Float
    difference: Float
    product: Float
