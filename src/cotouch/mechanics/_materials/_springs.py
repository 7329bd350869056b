"""Springs that turn with their ends: `½ k (l - L)²`, with an exact discrete gradient."""
# Every law takes the interface's arguments, and not each needs all of them.
# ruff: noqa: ARG001

from typing import NamedTuple

from cotouch.arrays import Float, Int
from cotouch.kernels import FOUR, at, inner, load, outlined, root, splat, total, where
from cotouch.kernels.matrix3 import Vector
from cotouch.mechanics._materials._fours import Quad, add_rows, apart, as_rows, elements, four_rows, kept, take_rows
from cotouch.passing import by_address

# Rows of a block of four springs.
ROWS = 5


@by_address
class SpringNetwork(NamedTuple):
    """Springs between nodes.

    Attributes:
        viscosity: η of the dampers `η k n nᵀ` along the springs [s].
        start: row of the one end, (springs,).
        end: row of the other.
        block: of every four springs k [N/m], with 0 for those that are missing, the length L and the coordinates of the
            edge from one end to the other at rest [m]: `ROWS` rows of four.
        cut: where in the memory the marks of those that were cut begin; negative: none can be.
    """

    viscosity: float
    start: Int
    end: Int
    block: Float
    cut: int = -1


@inner
def _rows(end: Int, e: Quad) -> Quad:
    return at(end, e[0]), at(end, e[1]), at(end, e[2]), at(end, e[3])


@inner
def _between(field: Float, i: Quad, j: Quad) -> Vector:
    """Differences of four pairs of rows."""
    return apart(four_rows(field, i), four_rows(field, j))


@inner
def _dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@inner
def _sum(a: Vector, b: Vector) -> Vector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@outlined
def resist(
    law: SpringNetwork, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]
) -> None:
    """Adds the mean force between two places and the damping; see `cotouch.mechanics.BodyForce`.

    Args:
        law: see `SpringNetwork`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    count = law.start.shape[0]
    for first in range(0, count, 4):
        b, e = ROWS * (first // 4), elements(first, count - 1)
        i, j = _rows(law.start, e), _rows(law.end, e)
        k, length = kept(memory, law.cut, e) * load(law.block, b, FOUR), load(law.block, b + 1, FOUR)
        edge = (load(law.block, b + 2, FOUR), load(law.block, b + 3, FOUR), load(law.block, b + 4, FOUR))
        before, after = _between(x, i, j), _between(ahead, i, j)
        d, d1 = _sum(edge, before), _sum(edge, after)
        l, l1 = root(_dot(d, d)), root(_dot(d1, d1))
        # l - L without cancellation: an edge may stretch by less than its rounding.
        one, other = l + length, l1 + length
        stretch = _dot(_sum(edge, d), before) * other + _dot(_sum(edge, d1), after) * one
        way = one * other * (l + l1)
        pull = where(way, stretch / way, 0.0)
        twice = _sum(d, d1)
        if law.viscosity > 0.0:
            square = _dot(twice, twice)
            slip = _dot(twice, _between(rate, i, j))
            pull = pull + where(square, (2.0 * law.viscosity) * slip / square, 0.0)
        pull = 0.5 * k * pull
        rows = as_rows((pull * twice[0], pull * twice[1], pull * twice[2]))
        take_rows(out, i, rows)
        add_rows(out, j, rows)


@outlined
def evaluate(
    law: SpringNetwork, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy at the end of a step, and the power of the dampers in it.

    Args:
        law: see `SpringNetwork`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        sweeps: nothing is sought.
        lanes: fixes the width of a row.
    """
    energy, power = splat(0.0, FOUR), splat(0.0, FOUR)
    count = law.start.shape[0]
    for first in range(0, count, 4):
        b, e = ROWS * (first // 4), elements(first, count - 1)
        i, j = _rows(law.start, e), _rows(law.end, e)
        k, length = kept(memory, law.cut, e) * load(law.block, b, FOUR), load(law.block, b + 1, FOUR)
        edge = (load(law.block, b + 2, FOUR), load(law.block, b + 3, FOUR), load(law.block, b + 4, FOUR))
        after = _between(ahead, i, j)
        d1 = _sum(edge, after)
        way = root(_dot(d1, d1)) + length
        stretch = where(way, _dot(_sum(edge, d1), after) / way, 0.0)
        energy = energy + k * (stretch * stretch)
        if law.viscosity > 0.0:
            twice = _sum(_sum(edge, _between(x, i, j)), d1)
            square = _dot(twice, twice)
            slip = _dot(twice, _between(rate, i, j))
            power = power + k * where(square, slip * slip / square, 0.0)
    return 0.5 * total(energy), law.viscosity * total(power)
