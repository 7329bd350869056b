"""Springs that turn with their ends: `½ k (l - L)²`, with an exact discrete gradient."""
# Every law takes the interface's arguments, and not each needs all of them.
# ruff: noqa: ARG001

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.mechanics._force_memory import is_cut
from cotouch.mechanics._kernel import part
from cotouch.mechanics._vector import at, load, store, total

Int = npt.NDArray[np.int32]


class SpringNetwork(NamedTuple):
    """Springs between nodes.

    Attributes:
        viscosity: η of the dampers `η k n nᵀ` along the springs [s].
        start: row of the one end, (springs,).
        end: row of the other.
        stiffness: k, (springs,) [N/m].
        edge: from one end to the other at rest, (springs, 4) [m].
        length: L, (springs,) [m].
        cut: where in the memory the marks of those that were cut begin; negative: none can be.
    """

    viscosity: float
    start: Int
    end: Int
    stiffness: Float
    edge: Float
    length: Float
    cut: int = -1


@part
def resist(
    law: SpringNetwork, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]
) -> None:
    """Adds the mean force between two places and the damping; see `cotouch.mechanics.BodyForce`."""
    for e in range(law.stiffness.shape[0]):
        if is_cut(memory, law.cut, e):
            continue
        i, j = at(law.start, e), at(law.end, e)
        k, length, edge = at(law.stiffness, e), at(law.length, e), load(law.edge, e, lanes)
        before = load(x, j, lanes) - load(x, i, lanes)
        after = load(ahead, j, lanes) - load(ahead, i, lanes)
        d, d1 = edge + before, edge + after
        l, l1 = math.sqrt(total(d * d)), math.sqrt(total(d1 * d1))
        middle = 0.5 * (d + d1)
        if l + l1 > 0.0:
            # l - L without cancellation: an edge may stretch by less than its rounding.
            stretch = total((edge + d) * before) / (l + length) + total((edge + d1) * after) / (l1 + length)
            pull = k * stretch / (l + l1)
            square = total(middle * middle)
            if law.viscosity > 0.0 and square > 0.0:
                slip = load(rate, j, lanes) - load(rate, i, lanes)
                pull += law.viscosity * k * total(middle * slip) / square
            force = pull * middle
            store(out, i, load(out, i, lanes) - force, lanes)
            store(out, j, load(out, j, lanes) + force, lanes)


@part
def evaluate(
    law: SpringNetwork, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy at the end of a step, and the power of the dampers in it."""
    energy, power = 0.0, 0.0
    for e in range(law.stiffness.shape[0]):
        if is_cut(memory, law.cut, e):
            continue
        i, j = at(law.start, e), at(law.end, e)
        k, length, edge = at(law.stiffness, e), at(law.length, e), load(law.edge, e, lanes)
        after = load(ahead, j, lanes) - load(ahead, i, lanes)
        d1 = edge + after
        l1 = math.sqrt(total(d1 * d1))
        if l1 + length > 0.0:
            stretch = total((edge + d1) * after) / (l1 + length)
            energy += 0.5 * k * stretch * stretch
        if law.viscosity > 0.0:
            middle = edge + 0.5 * (after + load(x, j, lanes) - load(x, i, lanes))
            square = total(middle * middle)
            if square > 0.0:
                slip = total(middle * (load(rate, j, lanes) - load(rate, i, lanes)))
                power += law.viscosity * k * slip * slip / square
    return energy, power
