"""What a step works on: the state of a copy, its links, what grips it, and scratch."""

import math
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float, Int, Long
from cotouch.mechanics._linear._operator import WEIGHTS, Operator
from cotouch.passing import by_address

# What a step books, in order. The first four are work during the step [J], the next two energies after it [J]. Then
# three are of a closed step: work of the closure on the end velocity [J], |β - 1|, and the share of the step given up.
SUPPLIED, BODY_LOSS, LOCAL_LOSS, EXTRA_LOSS, KINETIC, ELASTIC, ITERATIONS, CLOSURE, BETA, SHORTENED = range(10)
# And of obstacles: what of BODY_LOSS was lost at them, what of ELASTIC they hold [J], and their mean force, along three
# axes [N].
WORLD_LOSS, WORLD_STORED, WORLD_FORCE = 10, 11, 12
# And of cutting: what the elements held that were taken away after the step, before KINETIC and ELASTIC [J], and how
# many they were.
CUT, CUT_COUNT = 15, 16
LEDGER_COLUMNS = 17

_NO_BRAKE, _NO_PUSH = np.zeros(0), np.zeros((0, 0, 0))


@by_address
class State(NamedTuple):
    """Where a copy is; every array (rows, width), positions relative to the rest shape.

    Attributes:
        position: x - x_d [m].
        velocity: v [m/s].
        momentum: M v, kept only where M has entries off the diagonal.
        tension: K (x - x_d) [N].
        memory: what a body force remembers, (numbers,); (0,) of a linear body.
    """

    position: Float
    velocity: Float
    momentum: Float
    tension: Float
    memory: Float


@by_address
class Links(NamedTuple):
    """The links to the neighbours: `F_ij = W [k (y - x̂) + c - b v̂]`, y in `samples[slot]`; springs have no b and c.

    Attributes:
        strength: k, (links,) [N/m for the identity weight].
        weight: index of each link's weight, (links,).
        slot: where y of each link is, (links,).
        samples: samples x̃, and what else links pull to, (slots, rows, width) [m].
        brake: b, (links,), or (0,) where all links are springs [Ns/m for the identity weight].
        push: c, (links, rows, width), or (0, rows, width); such weights are diagonal [N for the identity weight].
    """

    strength: Float
    weight: Int
    slot: Long
    samples: Float
    brake: Float = _NO_BRAKE
    push: Float = _NO_PUSH


@by_address
class Ports(NamedTuple):
    """What holds the copy at its ports during the step: `f = k (r̂ - ŷ) + b (ṙ̂ - ẏ̂) + push`, y the port's position.

    Attributes:
        row: the row that each port holds, (ports,); ignored where `shape` is given.
        shape: the row vectors h of `y = h x`, (ports, rows); (0, rows) for unit vectors.
        stiffness: k, (ports,) [N/m].
        damping: b, (ports,) [Ns/m].
        start: r at the start of the step, (ports, width) [m].
        end: r at the end of the step, (ports, width) [m].
        push: explicit mean force, (ports, width) [N].
        force: result: mean force of the step, (ports, width) [N].
    """

    row: Int
    shape: Float
    stiffness: Float
    damping: Float
    start: Float
    end: Float
    push: Float
    force: Float


def idle_ports(row: Int, shape: Float, width: int) -> Ports:
    """Ports that hold nothing yet.

    Args:
        row: that each holds, (ports,).
        shape: the row vectors, (ports, rows), or (0, rows).
        width: of a row.
    """
    line, rows = (lambda: np.zeros(row.size)), (lambda: np.zeros((row.size, width)))
    return Ports(
        row=row, shape=shape, stiffness=line(), damping=line(), start=rows(), end=rows(), push=rows(), force=rows()
    )


def own_ports(held: Ports, first: int, last: int) -> Ports:
    """Those of one copy, in the memory of all.

    Args:
        held: ports of all copies.
        first: the copy's first.
        last: one past its last.
    """
    return Ports._make(array[first:last] for array in held)


# Fields that a search for a direction keeps: the best, what it misses, how its rows are weighed, and of as many changes
# as it remembers these and what came of them.
CHANGES = 3
SOUGHT = 3 + 2 * CHANGES


@by_address
class Workspace(NamedTuple):
    """Scratch arrays of one step; sizes as `workspace` makes them.

    Rows of rigid bodies are solved for at once, by `dense`: row i is the `rigid[i]`th of these, negative: none of them;
    and the rth of them is row `among[r]`. `tried` keeps their rates at the last look, and behind all rows the square of
    what these had changed by, less than 0 before the first. `sought` and `search` are of a search for a direction;
    `asked` keeps the one of which attempts go a part.
    """

    diagonal: Float
    inverse: Float
    rhs: Float
    mean: Float
    residual: Float
    direction: Float
    image: Float
    stretch: Float
    values: Float
    scale: Float
    gain: Float
    quadratic: Float
    port_gain: Float
    small: Float
    small_rhs: Float
    ahead: Float
    pull: Float
    weighed: Float
    rigid: Int
    among: Int
    dense: Float
    factor: Float
    answer: Float
    tried: Float
    asked: Float
    sought: Float
    search: Float


def _aligned(*shape: int) -> Float:
    """Zeros that start at a cache line, so that no row lies across two."""
    size = math.prod(shape)
    raw = np.zeros(size + 8)
    first = (-raw.ctypes.data // 8) % 8
    return raw[first : first + size].reshape(shape)


def numbered(among: Int, rows: int) -> Int:
    """Which of some rows each row is, (rows,); negative: none of them.

    Args:
        among: these rows.
        rows: how many there are in all.
    """
    result = np.full(rows, -1, dtype=np.int32)
    result[among] = np.arange(among.size, dtype=np.int32)
    return result


def workspace(op: Operator, width: int, ports: int, *, closed: bool = False, among: Int | None = None) -> Workspace:
    """Scratch arrays for steps with `op` and at most `ports` ports per user.

    Args:
        op: the body.
        width: of a row.
        ports: at most, of one user.
        closed: whether steps are closed ones.
        among: rows that are solved for at once; None: there are none.
    """
    rows, families, weights = op.mass.size, op.entries.shape[0], op.weight.shape[0]
    among = np.zeros(0, dtype=np.int32) if among is None else among
    size = 3 * among.size
    solver = rows if families else 0
    general = rows if families and np.any(op.mix[WEIGHTS:]) else 0
    return Workspace(
        diagonal=_aligned(rows),
        inverse=_aligned(solver),
        rhs=_aligned(rows, width),
        mean=_aligned(rows, width),
        residual=_aligned(solver, width),
        direction=_aligned(solver, width),
        image=_aligned(max(solver, general), width),
        stretch=_aligned(general, width),
        values=_aligned(op.column.size if families > 1 else 0),
        scale=_aligned(families),
        gain=_aligned(weights),
        quadratic=_aligned(weights),
        port_gain=_aligned(ports),
        small=_aligned(ports, ports),
        small_rhs=_aligned(ports, width),
        ahead=_aligned(rows if closed else 0, width),
        pull=_aligned(rows if closed else 0, width),
        weighed=_aligned(10),
        rigid=numbered(among, rows),
        among=among,
        dense=_aligned(size, size),
        factor=_aligned(size, size),
        answer=_aligned(size),
        tried=_aligned(rows + 1 if size else 0, width),
        asked=_aligned(rows if closed else 0, width),
        sought=_aligned(SOUGHT * solver if closed else 0, width),
        search=_aligned(3),
    )
