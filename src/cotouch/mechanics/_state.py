"""What a step works on: the state of a copy, its links, what grips it, and scratch."""

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.mechanics._operator import WEIGHTS, Operator

Float = npt.NDArray[np.float64]
Int = npt.NDArray[np.int32]

# What a step books, in order. The first four are work during the step [J], the next two energies after it [J].
SUPPLIED, BODY_LOSS, LOCAL_LOSS, EXTRA_LOSS, KINETIC, ELASTIC, ITERATIONS = range(7)
BOOKS = 7


class State(NamedTuple):
    """Where a copy is; every array (rows, width), positions relative to the rest shape.

    Attributes:
        position: x - x_d [m].
        velocity: v [m/s].
        momentum: M v, kept only where M has entries off the diagonal.
        tension: K (x - x_d) [N].
    """

    position: Float
    velocity: Float
    momentum: Float
    tension: Float


class Links(NamedTuple):
    """The springs to the neighbours: K_ij = strength * W_weight, pulling towards the sample in `samples[slot]`.

    The arrays may hold the links of many users; those of this copy are `first` to `last - 1`.

    Attributes:
        first: first link of this copy.
        last: one past its last.
        strength: (links,) [N/m for the identity weight].
        weight: index of each link's weight, (links,).
        slot: which sample each link uses, (links,).
        samples: samples x̃, (slots, rows, width) [m].
    """

    first: int
    last: int
    strength: Float
    weight: Int
    slot: npt.NDArray[np.int64]
    samples: Float


class Grips(NamedTuple):
    """What holds the copy at its ports during the step: `f = k (r̂ - ŷ) + b (ṙ̂ - ẏ̂) + push`, y the port's position.

    The arrays may hold the ports of many users; those of this copy are `first` to `last - 1`.

    Attributes:
        first: first port of this copy.
        last: one past its last.
        row: the row that each port holds, (ports,); ignored where `shape` is given.
        shape: the row vectors h of `y = h x`, (ports, rows); (0, rows) for unit vectors.
        stiffness: k, (ports,) [N/m].
        damping: b, (ports,) [Ns/m].
        start: r at the start of the step, (ports, width) [m].
        end: r at the end of the step, (ports, width) [m].
        push: explicit mean force, (ports, width) [N].
        force: result: mean force of the step, (ports, width) [N].
    """

    first: int
    last: int
    row: Int
    shape: Float
    stiffness: Float
    damping: Float
    start: Float
    end: Float
    push: Float
    force: Float


class Workspace(NamedTuple):
    """Scratch arrays of one step; sizes as `workspace` makes them."""

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


def _aligned(*shape: int) -> Float:
    """Zeros that start at a cache line, so that no row lies across two."""
    size = math.prod(shape)
    raw = np.zeros(size + 8)
    first = (-raw.ctypes.data // 8) % 8
    return raw[first : first + size].reshape(shape)


def workspace(op: Operator, width: int, ports: int) -> Workspace:
    """Scratch arrays for steps with `op` and at most `ports` ports per user."""
    rows, families, weights = op.mass.size, op.entries.shape[0], op.weight.shape[0]
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
    )
