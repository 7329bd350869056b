"""A linear body in a frame that turns with it: `½ ‖Rᵀx - X‖²_K`, one rotation R for the whole body.

R maximises `tr RᵀG`, `G = Σ x_i p_iᵀ`. With p = K X it is the R of least energy; where linear elasticity leaves that
open, p = m X is taken, and the force has what the turning of R adds. Without turning it is the linear body.
"""
# Every law takes the interface's arguments, and not each needs all of them.
# ruff: noqa: ARG001

from typing import NamedTuple

from cotouch.arrays import Float, Int
from cotouch.kernels import at, inner, outlined, put
from cotouch.kernels.matrix3 import Matrix, Vector, cross, inertia, solved, times, transposed_product, transposed_times
from cotouch.mechanics._materials._memory import FIRST, before_row, columns, keep
from cotouch.mechanics._materials._nearest import SWEEPS, nearest
from cotouch.passing import by_address


@by_address
class FramedBody(NamedTuple):
    """A linear body in one frame.

    Attributes:
        turning: 1: the frame turns; 0: it stays.
        damped: 1: there are dampers.
        pointer: CSR row pointer of the pattern of K and B, off the diagonal, (rows + 1,).
        column: CSR column indices, (entries,).
        stiffness: K, off the diagonal: (entries, 1), the same along each axis, or blocks of 3 by 3, (entries, 9).
        damping: B likewise.
        rest: X, less its mean, (rows, 4) [m].
        lever: p, (rows, 4).
        local: scratch: x in the frame, (rows, 4) [m].
        image: scratch, (rows, 4).
    """

    turning: int
    damped: int
    pointer: Int
    column: Int
    stiffness: Float
    damping: Float
    rest: Float
    lever: Float
    local: Float
    image: Float


# Of a single rotation nothing need be left: audits work the energy out anew, also of a body that is squashed flat.
_SWEEPS = 2 * SWEEPS


@inner
def _moment(law: FramedBody, x: Float, ahead: Float, fraction: float) -> Matrix:
    """G of the place so far on the way from one to the other."""
    rows = law.rest.shape[0]
    a = b = c = d = e = f = g = h = k = 0.0
    for i in range(rows):
        j = 4 * i
        px, py, pz = at(law.lever, j), at(law.lever, j + 1), at(law.lever, j + 2)
        qx = at(law.rest, j) + (1.0 - fraction) * at(x, j) + fraction * at(ahead, j)
        qy = at(law.rest, j + 1) + (1.0 - fraction) * at(x, j + 1) + fraction * at(ahead, j + 1)
        qz = at(law.rest, j + 2) + (1.0 - fraction) * at(x, j + 2) + fraction * at(ahead, j + 2)
        a, b, c = a + qx * px, b + qx * py, c + qx * pz
        d, e, f = d + qy * px, e + qy * py, f + qy * pz
        g, h, k = g + qz * px, h + qz * py, k + qz * pz
    return a, b, c, d, e, f, g, h, k


@inner
def _local(law: FramedBody, r: Matrix, x: Float, ahead: Float, fraction: float) -> None:
    """Places in the frame, about the mean."""
    rows = law.rest.shape[0]
    cx = cy = cz = 0.0
    for i in range(rows):
        j = 4 * i
        cx += (1.0 - fraction) * at(x, j) + fraction * at(ahead, j)
        cy += (1.0 - fraction) * at(x, j + 1) + fraction * at(ahead, j + 1)
        cz += (1.0 - fraction) * at(x, j + 2) + fraction * at(ahead, j + 2)
    cx, cy, cz = cx / rows, cy / rows, cz / rows
    for i in range(rows):
        j = 4 * i
        q = (
            at(law.rest, j) + (1.0 - fraction) * at(x, j) + fraction * at(ahead, j) - cx,
            at(law.rest, j + 1) + (1.0 - fraction) * at(x, j + 1) + fraction * at(ahead, j + 1) - cy,
            at(law.rest, j + 2) + (1.0 - fraction) * at(x, j + 2) + fraction * at(ahead, j + 2) - cz,
        )
        y = transposed_times(r, q)
        put(law.local, j, y[0])
        put(law.local, j + 1, y[1])
        put(law.local, j + 2, y[2])


@inner
def _stretch(law: FramedBody, i: int) -> Vector:
    """The stretch Rᵀx - X of a row."""
    j = 4 * i
    return (
        at(law.local, j) - at(law.rest, j),
        at(law.local, j + 1) - at(law.rest, j + 1),
        at(law.local, j + 2) - at(law.rest, j + 2),
    )


@inner
def _image(law: FramedBody, i: int) -> Vector:
    return at(law.image, 4 * i), at(law.image, 4 * i + 1), at(law.image, 4 * i + 2)


@inner
def _row(law: FramedBody, values: Float, i: int, strained: bool) -> Vector:
    """Row i of K or B times u, or times the field in `image`, by differences between rows."""
    own = _stretch(law, i) if strained else _image(law, i)
    x = y = z = 0.0
    for e in range(at(law.pointer, i), at(law.pointer, i + 1)):
        j = at(law.column, e)
        other = _stretch(law, j) if strained else _image(law, j)
        dx, dy, dz = other[0] - own[0], other[1] - own[1], other[2] - own[2]
        if values.shape[1] == 1:
            value = at(values, e)
            x, y, z = x + value * dx, y + value * dy, z + value * dz
        else:
            b = 9 * e
            x += at(values, b) * dx + at(values, b + 1) * dy + at(values, b + 2) * dz
            y += at(values, b + 3) * dx + at(values, b + 4) * dy + at(values, b + 5) * dz
            z += at(values, b + 6) * dx + at(values, b + 7) * dy + at(values, b + 8) * dz
    return x, y, z


@inner
def _give(
    law: FramedBody,
    r: Matrix,
    values: Float,
    fraction: float,
    strained: bool,
    moment: Matrix,
    out: Float,
) -> None:
    """Adds a share of the force of K on u, or of B on `image`, with what the turning of the frame adds."""
    rows = law.rest.shape[0]
    turn = (0.0, 0.0, 0.0)
    if law.turning == 1:
        tx = ty = tz = 0.0
        for i in range(rows):
            pull = _row(law, values, i, strained)
            t = cross((at(law.local, 4 * i), at(law.local, 4 * i + 1), at(law.local, 4 * i + 2)), pull)
            tx, ty, tz = tx + t[0], ty + t[1], tz + t[2]
        turn = solved(inertia(transposed_product(r, moment)), (tx, ty, tz))
    for i in range(rows):
        pull = _row(law, values, i, strained)
        j = 4 * i
        if law.turning == 1:
            c = cross(turn, (at(law.lever, j), at(law.lever, j + 1), at(law.lever, j + 2)))
            pull = (pull[0] - c[0], pull[1] - c[1], pull[2] - c[2])
        force = times(r, pull)
        put(out, j, at(out, j) + fraction * force[0])
        put(out, j + 1, at(out, j + 1) + fraction * force[1])
        put(out, j + 2, at(out, j + 2) + fraction * force[2])


@inner
def _strain_rate(law: FramedBody, r: Matrix, moment: Matrix, rate: Float) -> None:
    """Writes into `image` the velocity in the frame, less the frame's own turning."""
    rows = law.rest.shape[0]
    tx = ty = tz = 0.0
    for i in range(rows):
        j = 4 * i
        z = transposed_times(r, (at(rate, j), at(rate, j + 1), at(rate, j + 2)))
        put(law.image, j, z[0])
        put(law.image, j + 1, z[1])
        put(law.image, j + 2, z[2])
        t = cross((at(law.lever, j), at(law.lever, j + 1), at(law.lever, j + 2)), z)
        tx, ty, tz = tx + t[0], ty + t[1], tz + t[2]
    if law.turning == 1:
        spin = solved(inertia(transposed_product(r, moment)), (tx, ty, tz))
        for i in range(rows):
            j = 4 * i
            c = cross(spin, (at(law.local, j), at(law.local, j + 1), at(law.local, j + 2)))
            put(law.image, j, at(law.image, j) - c[0])
            put(law.image, j + 1, at(law.image, j + 1) - c[1])
            put(law.image, j + 2, at(law.image, j + 2) - c[2])


@inner
def _turn(law: FramedBody, r: Matrix, moment: Matrix, sweeps: int) -> Matrix:
    return nearest(r, moment, sweeps) if law.turning == 1 else r


@outlined
def resist(
    law: FramedBody, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]
) -> None:
    """Adds the mean force between two places and the damping; see `cotouch.mechanics.BodyForce`.

    Args:
        law: see `FramedBody`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    before = columns(memory, FIRST)
    for end in range(2):
        fraction = 1.0 * end
        moment = _moment(law, x, ahead, fraction)
        r = _turn(law, before, moment, _SWEEPS)
        _local(law, r, x, ahead, fraction)
        _give(law, r, law.stiffness, 0.5, True, moment, out)
    if law.damped == 1:
        moment = _moment(law, x, ahead, 0.5)
        r = _turn(law, before, moment, _SWEEPS)
        _local(law, r, x, ahead, 0.5)
        _strain_rate(law, r, moment, rate)
        _give(law, r, law.damping, 1.0, False, moment, out)


@outlined
def evaluate(
    law: FramedBody, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy at the end of a step, whose rotation it keeps, and the power of the dampers in it.

    Args:
        law: see `FramedBody`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        sweeps: of the search for the nearest rotations, >= 1.
        lanes: fixes the width of a row.
    """
    before = columns(memory, FIRST)
    rows = law.rest.shape[0]
    energy, power = 0.0, 0.0
    if law.damped == 1:
        moment = _moment(law, x, ahead, 0.5)
        r = _turn(law, before, moment, _SWEEPS)
        _local(law, r, x, ahead, 0.5)
        _strain_rate(law, r, moment, rate)
        for i in range(rows):
            drag = _row(law, law.damping, i, False)
            power += (
                at(law.image, 4 * i) * drag[0] + at(law.image, 4 * i + 1) * drag[1] + at(law.image, 4 * i + 2) * drag[2]
            )
    moment = _moment(law, x, ahead, 1.0)
    after = _turn(law, before, moment, max(sweeps, _SWEEPS))
    keep(memory, before_row(1), before)
    keep(memory, FIRST, after)
    _local(law, after, x, ahead, 1.0)
    for i in range(rows):
        u, pull = _stretch(law, i), _row(law, law.stiffness, i, True)
        energy += 0.5 * (u[0] * pull[0] + u[1] * pull[1] + u[2] * pull[2])
    return energy, power
