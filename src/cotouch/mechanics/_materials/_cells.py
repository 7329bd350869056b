"""Cubes that turn: `⅛ k Σ ‖d_e - R h n_e‖²` over the twelve edges of each, R the rotation that fits the cube best.

The rotations of four cubes are found at a time, each in one lane; places and forces are added up row by row.
"""
# Every law takes the interface's arguments, and not each needs all of them.
# ruff: noqa: ARG001

from typing import NamedTuple

from cotouch.arrays import Float, Int
from cotouch.kernels import at, inner, load, outlined, store, total
from cotouch.kernels.matrix3 import (
    Matrix,
    Vector,
    cross,
    diagonal,
    inertia,
    mixture,
    product,
    scaled,
    solved,
    transpose,
)
from cotouch.mechanics._materials._fours import elements, keep_before, keep_rotations, rotations
from cotouch.mechanics._materials._memory import FIRST, before_row, is_cut, scratch_row
from cotouch.mechanics._materials._nearest import SWEEPS, nearest
from cotouch.mechanics._materials._ties import pull_ties, weigh_ties
from cotouch.passing import by_address


@by_address
class CorotatedCells(NamedTuple):
    """Cubes of a regular grid; corner `4a + 2b + c` has coordinates (a, b, c).

    Attributes:
        viscosity: η of the damper beside each spring, which no rotation feels [s].
        corner: rows of the corners, (cells, 8).
        stiffness: of the spring along an edge that four such cubes share, (cells,) [N/m].
        edge: h n_a, the edges at rest, (3, 4) [m].
        spacing: h [m].
        tie_start: row of the one end of each spring of no length at a face that opens, (ties,).
        tie_end: row of the other.
        tie_face: number of the face.
        tie: k, (ties,) [N/m].
        cut: where in the memory the marks of those that were cut begin; negative: none can be.
        tie_cut: likewise of the faces.
    """

    viscosity: float
    corner: Int
    stiffness: Float
    edge: Float
    spacing: float
    tie_start: Int
    tie_end: Int
    tie_face: Int
    tie: Float
    cut: int = -1
    tie_cut: int = -1


# Four rows of a memory's scratch.
_ALL = (0, 1, 2, 3)


@inner
def _sum_up(law: CorotatedCells, c: int, field: Float, memory: Float, row: int, lanes: tuple[int, ...]) -> None:
    """Writes the sums of the four differences along each axis."""
    base = 8 * c
    x0, x1 = load(field, at(law.corner, base), lanes), load(field, at(law.corner, base + 1), lanes)
    x2, x3 = load(field, at(law.corner, base + 2), lanes), load(field, at(law.corner, base + 3), lanes)
    x4, x5 = load(field, at(law.corner, base + 4), lanes), load(field, at(law.corner, base + 5), lanes)
    x6, x7 = load(field, at(law.corner, base + 6), lanes), load(field, at(law.corner, base + 7), lanes)
    front, back = (x0 + x1), (x2 + x3)
    left, right = (x4 + x5), (x6 + x7)
    store(memory, row, (left + right) - (front + back), lanes)
    store(memory, row + 1, (back + right) - (front + left), lanes)
    store(memory, row + 2, ((x1 - x0) + (x3 - x2)) + ((x5 - x4) + (x7 - x6)), lanes)


@inner
def _sums(
    law: CorotatedCells, first: int, last: int, field: Float, memory: Float, row: int, lanes: tuple[int, ...]
) -> Matrix:
    """Sums of the four differences along each axis of four cells, as the columns of a matrix."""
    for c in range(4):
        _sum_up(law, min(first + c, last), field, memory, row + 3 * c, lanes)
    return rotations(memory, row, _ALL)


@inner
def _spin(middle: Matrix, spun: Matrix, h: float) -> Vector:
    """The angular velocity that fits a cube's edges best; `middle` are its unit edges, `spun` sums of rates."""
    # Least squares over ‖ḋ - ω × h r‖²: (tr RRᵀ I - RRᵀ) ω = Σ r_a × ṡ_a / (4 h).
    m = product(middle, transpose(middle))
    x = cross((middle[0], middle[3], middle[6]), (spun[0], spun[3], spun[6]))
    y = cross((middle[1], middle[4], middle[7]), (spun[1], spun[4], spun[7]))
    z = cross((middle[2], middle[5], middle[8]), (spun[2], spun[5], spun[8]))
    q = 0.25 / h
    return solved(inertia(m), (q * (x[0] + y[0] + z[0]), q * (x[1] + y[1] + z[1]), q * (x[2] + y[2] + z[2])))


@inner
def _rotated(spin: Vector, middle: Matrix, h: float) -> Matrix:
    """`ω × h r_a` as columns."""
    x = cross(spin, (middle[0], middle[3], middle[6]))
    y = cross(spin, (middle[1], middle[4], middle[7]))
    z = cross(spin, (middle[2], middle[5], middle[8]))
    return h * x[0], h * y[0], h * z[0], h * x[1], h * y[1], h * z[1], h * x[2], h * y[2], h * z[2]


@outlined
def resist(
    law: CorotatedCells, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]
) -> None:
    """Adds the mean force between two places and the damping; see `cotouch.mechanics.BodyForce`.

    Args:
        law: see `CorotatedCells`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    pull_ties(law, memory, x, ahead, rate, out, lanes)
    count, h, eta = law.corner.shape[0], law.spacing, law.viscosity
    scratch = scratch_row(count)
    for first in range(0, count, 4):
        e = elements(first, count - 1)
        before = rotations(memory, FIRST, e)
        shape = diagonal(_sums(law, first, count - 1, ahead, memory, scratch, lanes), 4.0 * h)
        middle = mixture(0.5, before, 0.5, nearest(before, shape, SWEEPS))
        turn = diagonal(scaled(h, middle), -h)
        if eta > 0.0:
            spun = _sums(law, first, count - 1, rate, memory, scratch, lanes)
            turn = mixture(1.0, turn, eta, _rotated(_spin(middle, spun, h), middle, h))
        keep_rotations(memory, scratch, _ALL, turn)
        for c in range(4):
            cell, row = first + c, scratch + 3 * c
            if cell < count and not is_cut(memory, law.cut, cell):
                tx, ty, tz = load(memory, row, lanes), load(memory, row + 1, lanes), load(memory, row + 2, lanes)
                _press(law, cell, eta, x, ahead, rate, tx, ty, tz, out, lanes)


@inner
def _press(
    law: CorotatedCells,
    c: int,
    eta: float,
    x: Float,
    ahead: Float,
    rate: Float,
    tx: float,
    ty: float,
    tz: float,
    out: Float,
    lanes: tuple[int, ...],
) -> None:
    """Adds the forces of a cell whose edges would be longer by t at rest."""
    k = 0.25 * at(law.stiffness, c)
    # What the dampers add is a spring whose ends are η v further on.
    q0, q1 = _place(law, c, 0, eta, x, ahead, rate, lanes), _place(law, c, 1, eta, x, ahead, rate, lanes)
    q2, q3 = _place(law, c, 2, eta, x, ahead, rate, lanes), _place(law, c, 3, eta, x, ahead, rate, lanes)
    q4, q5 = _place(law, c, 4, eta, x, ahead, rate, lanes), _place(law, c, 5, eta, x, ahead, rate, lanes)
    q6, q7 = _place(law, c, 6, eta, x, ahead, rate, lanes), _place(law, c, 7, eta, x, ahead, rate, lanes)
    x0, x1, x2, x3 = (q4 - q0) - tx, (q5 - q1) - tx, (q6 - q2) - tx, (q7 - q3) - tx
    y0, y1, y2, y3 = (q2 - q0) - ty, (q3 - q1) - ty, (q6 - q4) - ty, (q7 - q5) - ty
    z0, z1, z2, z3 = (q1 - q0) - tz, (q3 - q2) - tz, (q5 - q4) - tz, (q7 - q6) - tz
    _push(law, c, 0, out, -k, x0 + y0 + z0, lanes)
    _push(law, c, 1, out, -k, x1 + y1 - z0, lanes)
    _push(law, c, 2, out, -k, x2 - y0 + z1, lanes)
    _push(law, c, 3, out, -k, x3 - y1 - z1, lanes)
    _push(law, c, 4, out, k, x0 - y2 - z2, lanes)
    _push(law, c, 5, out, k, x1 - y3 + z2, lanes)
    _push(law, c, 6, out, k, x2 + y2 - z3, lanes)
    _push(law, c, 7, out, k, x3 + y3 + z3, lanes)


@inner
def _place(
    law: CorotatedCells, c: int, n: int, eta: float, x: Float, ahead: Float, rate: Float, lanes: tuple[int, ...]
) -> float:
    """A corner halfway, and η v further on."""
    i = at(law.corner, 8 * c + n)
    middle = 0.5 * (load(x, i, lanes) + load(ahead, i, lanes))
    return middle + eta * load(rate, i, lanes)


@inner
def _push(law: CorotatedCells, c: int, n: int, out: Float, k: float, stretch: float, lanes: tuple[int, ...]) -> None:
    i = at(law.corner, 8 * c + n)
    store(out, i, load(out, i, lanes) + k * stretch, lanes)


@outlined
def evaluate(
    law: CorotatedCells, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy at the end of a step, whose rotations it keeps, and the power of the dampers in it.

    Args:
        law: see `CorotatedCells`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        sweeps: of the search for the nearest rotations, >= 1.
        lanes: fixes the width of a row.
    """
    count, h, eta = law.corner.shape[0], law.spacing, law.viscosity
    scratch = scratch_row(count)
    energy, power = weigh_ties(law, memory, ahead, rate, lanes)
    for first in range(0, count, 4):
        e = elements(first, count - 1)
        before = rotations(memory, FIRST, e)
        shape = diagonal(_sums(law, first, count - 1, ahead, memory, scratch, lanes), 4.0 * h)
        after = nearest(before, shape, sweeps)
        keep_before(memory, FIRST, before_row(count), e)
        keep_rotations(memory, FIRST, e, after)
        if eta > 0.0:
            middle = mixture(0.5, before, 0.5, after)
            spun = _sums(law, first, count - 1, rate, memory, scratch, lanes)
            keep_rotations(memory, scratch, _ALL, _rotated(_spin(middle, spun, h), middle, h))
        for c in range(4):
            cell = first + c
            if cell < count and not is_cut(memory, law.cut, cell):
                row = FIRST + 3 * cell
                tx = h * load(memory, row, lanes) - load(law.edge, 0, lanes)
                ty = h * load(memory, row + 1, lanes) - load(law.edge, 1, lanes)
                tz = h * load(memory, row + 2, lanes) - load(law.edge, 2, lanes)
                energy += 0.125 * at(law.stiffness, cell) * _squares(law, cell, ahead, tx, ty, tz, lanes)
                if eta > 0.0:
                    row = scratch + 3 * c
                    wx, wy, wz = load(memory, row, lanes), load(memory, row + 1, lanes), load(memory, row + 2, lanes)
                    lost = _squares(law, cell, rate, wx, wy, wz, lanes)
                    power += eta * 0.25 * at(law.stiffness, cell) * lost
    return energy, power


@inner
def _squares(
    law: CorotatedCells, c: int, field: Float, tx: float, ty: float, tz: float, lanes: tuple[int, ...]
) -> float:
    """`Σ ‖difference along the edge - t_axis‖²` over the edges."""
    base = 8 * c
    x0, x1 = load(field, at(law.corner, base), lanes), load(field, at(law.corner, base + 1), lanes)
    x2, x3 = load(field, at(law.corner, base + 2), lanes), load(field, at(law.corner, base + 3), lanes)
    x4, x5 = load(field, at(law.corner, base + 4), lanes), load(field, at(law.corner, base + 5), lanes)
    x6, x7 = load(field, at(law.corner, base + 6), lanes), load(field, at(law.corner, base + 7), lanes)
    a, b, c0, d = x4 - x0 - tx, x5 - x1 - tx, x6 - x2 - tx, x7 - x3 - tx
    square = (a * a + b * b) + (c0 * c0 + d * d)
    a, b, c0, d = x2 - x0 - ty, x3 - x1 - ty, x6 - x4 - ty, x7 - x5 - ty
    square = square + ((a * a + b * b) + (c0 * c0 + d * d))
    a, b, c0, d = x1 - x0 - tz, x3 - x2 - tz, x5 - x4 - tz, x7 - x6 - tz
    square = square + ((a * a + b * b) + (c0 * c0 + d * d))
    return total(square)
