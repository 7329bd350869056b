"""Cubes that turn: `⅛ k Σ ‖d_e - R h n_e‖²` over the twelve edges of each, R the rotation that fits the cube best."""
# Every law takes the interface's arguments, and not each needs all of them.
# ruff: noqa: ARG001

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.mechanics._force_memory import FIRST, columns, is_cut, keep, scratch_row
from cotouch.mechanics._force_ties import pull_ties, weigh_ties
from cotouch.mechanics._kernel import inner, part
from cotouch.mechanics._matrix3 import Matrix, Vector, cross, inertia, mixture, product, solved, transpose, turned
from cotouch.mechanics._vector import at, load, store, total

Int = npt.NDArray[np.int32]


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


@inner
def _sums(law: CorotatedCells, c: int, field: Float, lanes: tuple[int, ...]) -> tuple[float, float, float]:
    """Sums of the four differences along each axis."""
    base = 8 * c
    x0, x1 = load(field, at(law.corner, base), lanes), load(field, at(law.corner, base + 1), lanes)
    x2, x3 = load(field, at(law.corner, base + 2), lanes), load(field, at(law.corner, base + 3), lanes)
    x4, x5 = load(field, at(law.corner, base + 4), lanes), load(field, at(law.corner, base + 5), lanes)
    x6, x7 = load(field, at(law.corner, base + 6), lanes), load(field, at(law.corner, base + 7), lanes)
    front, back = (x0 + x1), (x2 + x3)
    left, right = (x4 + x5), (x6 + x7)
    along_x = (left + right) - (front + back)
    along_y = (back + right) - (front + left)
    along_z = ((x1 - x0) + (x3 - x2)) + ((x5 - x4) + (x7 - x6))
    return along_x, along_y, along_z


@inner
def _shape(law: CorotatedCells, c: int, field: Float, scratch: int, memory: Float, lanes: tuple[int, ...]) -> Matrix:
    """Sum of the four edges along each axis, as the columns of a matrix."""
    along_x, along_y, along_z = _sums(law, c, field, lanes)
    store(memory, scratch, along_x + 4.0 * load(law.edge, 0, lanes), lanes)
    store(memory, scratch + 1, along_y + 4.0 * load(law.edge, 1, lanes), lanes)
    store(memory, scratch + 2, along_z + 4.0 * load(law.edge, 2, lanes), lanes)
    return columns(memory, scratch)


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


@inner
def _rates(law: CorotatedCells, c: int, rate: Float, scratch: int, memory: Float, lanes: tuple[int, ...]) -> Matrix:
    along_x, along_y, along_z = _sums(law, c, rate, lanes)
    store(memory, scratch, along_x, lanes)
    store(memory, scratch + 1, along_y, lanes)
    store(memory, scratch + 2, along_z, lanes)
    return columns(memory, scratch)


@part
def resist(
    law: CorotatedCells, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]
) -> None:
    """Adds the mean force between two places and the damping; see `cotouch.mechanics.BodyForce`."""
    h, eta, scratch = law.spacing, law.viscosity, scratch_row(law.stiffness.shape[0])
    pull_ties(law, memory, x, ahead, rate, out, lanes)
    for c in range(law.stiffness.shape[0]):
        if is_cut(memory, law.cut, c):
            continue
        k = 0.25 * at(law.stiffness, c)
        row = FIRST + 3 * c
        before = columns(memory, row)
        shape = _shape(law, c, ahead, scratch, memory, lanes)
        after = turned(turned(before, shape), shape)
        keep(memory, scratch, after)
        tx = (0.5 * h) * (load(memory, row, lanes) + load(memory, scratch, lanes)) - load(law.edge, 0, lanes)
        ty = (0.5 * h) * (load(memory, row + 1, lanes) + load(memory, scratch + 1, lanes)) - load(law.edge, 1, lanes)
        tz = (0.5 * h) * (load(memory, row + 2, lanes) + load(memory, scratch + 2, lanes)) - load(law.edge, 2, lanes)
        if eta > 0.0:
            middle = mixture(0.5, before, 0.5, after)
            spun = _rates(law, c, rate, scratch, memory, lanes)
            keep(memory, scratch, _rotated(_spin(middle, spun, h), middle, h))
            tx = tx + eta * load(memory, scratch, lanes)
            ty = ty + eta * load(memory, scratch + 1, lanes)
            tz = tz + eta * load(memory, scratch + 2, lanes)
        # What the dampers add is a spring whose ends are η v further on.
        q0, q1 = _place(law, c, 0, eta, x, ahead, rate, lanes), _place(law, c, 1, eta, x, ahead, rate, lanes)
        q2, q3 = _place(law, c, 2, eta, x, ahead, rate, lanes), _place(law, c, 3, eta, x, ahead, rate, lanes)
        q4, q5 = _place(law, c, 4, eta, x, ahead, rate, lanes), _place(law, c, 5, eta, x, ahead, rate, lanes)
        q6, q7 = _place(law, c, 6, eta, x, ahead, rate, lanes), _place(law, c, 7, eta, x, ahead, rate, lanes)
        _push(law, c, 0, out, k * ((3.0 * q0 - q4 - q2 - q1) + tx + ty + tz), lanes)
        _push(law, c, 1, out, k * ((3.0 * q1 - q5 - q3 - q0) + tx + ty - tz), lanes)
        _push(law, c, 2, out, k * ((3.0 * q2 - q6 - q0 - q3) + tx - ty + tz), lanes)
        _push(law, c, 3, out, k * ((3.0 * q3 - q7 - q1 - q2) + tx - ty - tz), lanes)
        _push(law, c, 4, out, k * ((3.0 * q4 - q0 - q6 - q5) - tx + ty + tz), lanes)
        _push(law, c, 5, out, k * ((3.0 * q5 - q1 - q7 - q4) - tx + ty - tz), lanes)
        _push(law, c, 6, out, k * ((3.0 * q6 - q2 - q4 - q7) - tx - ty + tz), lanes)
        _push(law, c, 7, out, k * ((3.0 * q7 - q3 - q5 - q6) - tx - ty - tz), lanes)


@inner
def _place(
    law: CorotatedCells, c: int, n: int, eta: float, x: Float, ahead: Float, rate: Float, lanes: tuple[int, ...]
) -> float:
    """A corner halfway, and η v further on."""
    i = at(law.corner, 8 * c + n)
    middle = 0.5 * (load(x, i, lanes) + load(ahead, i, lanes))
    return middle + eta * load(rate, i, lanes)


@inner
def _push(law: CorotatedCells, c: int, n: int, out: Float, force: float, lanes: tuple[int, ...]) -> None:
    i = at(law.corner, 8 * c + n)
    store(out, i, load(out, i, lanes) + force, lanes)


@part
def evaluate(
    law: CorotatedCells, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy at the end of a step, whose rotations it keeps, and the power of the dampers in it."""
    h, eta, scratch = law.spacing, law.viscosity, scratch_row(law.stiffness.shape[0])
    energy, power = weigh_ties(law, memory, ahead, rate, lanes)
    for c in range(law.stiffness.shape[0]):
        if is_cut(memory, law.cut, c):
            continue
        row = FIRST + 3 * c
        before = columns(memory, row)
        shape = _shape(law, c, ahead, scratch, memory, lanes)
        after = before
        for _ in range(sweeps):
            after = turned(after, shape)
        keep(memory, row, after)
        tx = h * load(memory, row, lanes) - load(law.edge, 0, lanes)
        ty = h * load(memory, row + 1, lanes) - load(law.edge, 1, lanes)
        tz = h * load(memory, row + 2, lanes) - load(law.edge, 2, lanes)
        energy += 0.125 * at(law.stiffness, c) * _squares(law, c, ahead, tx, ty, tz, lanes)
        if eta > 0.0:
            middle = mixture(0.5, before, 0.5, after)
            spun = _rates(law, c, rate, scratch, memory, lanes)
            keep(memory, scratch, _rotated(_spin(middle, spun, h), middle, h))
            wx, wy, wz = (
                load(memory, scratch, lanes),
                load(memory, scratch + 1, lanes),
                load(memory, scratch + 2, lanes),
            )
            power += eta * 0.25 * at(law.stiffness, c) * _squares(law, c, rate, wx, wy, wz, lanes)
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
