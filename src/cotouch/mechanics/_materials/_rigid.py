"""Rigid bodies as four equal masses each: `½ m ω² Σ C_pq e_p e_q`, e the strains `½ (GᵀG - G₀ᵀG₀)` [Simo, Tarnow].

`G = ¼ Σ x_k s_kᵀ`, s_k alternate corners of a cube. The energy is quadratic in the strains, so `Ḡ S((e + e₁)/2)` is an
exact discrete gradient, and what it does not do to angular momentum a converged step does not do. Of so few rows the
law gives its true tangent, `lean`: a few looks then meet the mean force to rounding.
"""
# Every law takes the interface's arguments, and not each needs all of them.
# ruff: noqa: ARG001

from typing import NamedTuple

from cotouch.arrays import Float, Int
from cotouch.kernels import at, inner, outlined, put
from cotouch.kernels.matrix3 import Matrix, mixture, product, symmetric, transposed_product
from cotouch.passing import by_address

_Six = tuple[float, float, float, float, float, float]


@by_address
class Rigid(NamedTuple):
    """Bodies that keep their distances.

    Attributes:
        viscosity: η [s].
        corner: rows of the four masses of each body, (bodies, 4).
        sign: s_k, (4, 4); the last column is 0.
        frame: G₀, (bodies, 9) [m].
        law: m ω² C, (bodies, 36) [N/m³].
    """

    viscosity: float
    corner: Int
    sign: Float
    frame: Float
    law: Float


@inner
def _moved(law: Rigid, e: int, field: Float) -> Matrix:
    """`¼ Σ u_k s_kᵀ` of a field."""
    a = b = c = d = f = g = h = i = j = 0.0
    for k in range(4):
        row = 4 * at(law.corner, 4 * e + k)
        x, y, z = 0.25 * at(field, row), 0.25 * at(field, row + 1), 0.25 * at(field, row + 2)
        p, q, r = at(law.sign, 4 * k), at(law.sign, 4 * k + 1), at(law.sign, 4 * k + 2)
        a, b, c = a + x * p, b + x * q, c + x * r
        d, f, g = d + y * p, f + y * q, g + y * r
        h, i, j = h + z * p, i + z * q, j + z * r
    return a, b, c, d, f, g, h, i, j


@inner
def _frame(law: Rigid, e: int) -> Matrix:
    g = 9 * e
    return (
        at(law.frame, g),
        at(law.frame, g + 1),
        at(law.frame, g + 2),
        at(law.frame, g + 3),
        at(law.frame, g + 4),
        at(law.frame, g + 5),
        at(law.frame, g + 6),
        at(law.frame, g + 7),
        at(law.frame, g + 8),
    )


@inner
def _strain(frame: Matrix, h: Matrix) -> Matrix:
    """`½ (GᵀG - G₀ᵀG₀)` of `G = G₀ + H`, without the cancellation."""
    return mixture(1.0, symmetric(transposed_product(frame, h)), 0.5, transposed_product(h, h))


@inner
def _six(e: Matrix) -> _Six:
    return e[0], e[4], e[8], e[1], e[2], e[5]


@inner
def _row(law: Rigid, e: int, p: int, six: _Six) -> float:
    k = 36 * e + 6 * p
    return (
        at(law.law, k) * six[0]
        + at(law.law, k + 1) * six[1]
        + at(law.law, k + 2) * six[2]
        + at(law.law, k + 3) * six[3]
        + at(law.law, k + 4) * six[4]
        + at(law.law, k + 5) * six[5]
    )


@inner
def _stress(law: Rigid, e: int, strain: Matrix) -> Matrix:
    """What a strain, or its rate, is resisted by [N/m]."""
    six = _six(strain)
    xy, xz, yz = 0.5 * _row(law, e, 3, six), 0.5 * _row(law, e, 4, six), 0.5 * _row(law, e, 5, six)
    return _row(law, e, 0, six), xy, xz, xy, _row(law, e, 1, six), yz, xz, yz, _row(law, e, 2, six)


@inner
def _power(stress: Matrix, strain: Matrix) -> float:
    return (
        (stress[0] * strain[0] + stress[4] * strain[4] + stress[8] * strain[8])
        + 2.0 * (stress[1] * strain[1] + stress[2] * strain[2] + stress[5] * strain[5])
    )  # fmt: skip


@outlined
def resist(law: Rigid, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]) -> None:
    """Adds the mean force between two places and the damping; see `cotouch.mechanics.BodyForce`.

    Args:
        law: see `Rigid`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    for e in range(law.corner.shape[0]):
        frame, h, h1 = _frame(law, e), _moved(law, e, x), _moved(law, e, ahead)
        middle = mixture(1.0, frame, 0.5, mixture(1.0, h, 1.0, h1))
        strain = mixture(0.5, _strain(frame, h), 0.5, _strain(frame, h1))
        if law.viscosity > 0.0:
            slip = symmetric(transposed_product(middle, _moved(law, e, rate)))
            strain = mixture(1.0, strain, law.viscosity, slip)
        p = product(middle, _stress(law, e, strain))
        for k in range(4):
            row = 4 * at(law.corner, 4 * e + k)
            a, b, c = 0.25 * at(law.sign, 4 * k), 0.25 * at(law.sign, 4 * k + 1), 0.25 * at(law.sign, 4 * k + 2)
            put(out, row, at(out, row) + a * p[0] + b * p[1] + c * p[2])
            put(out, row + 1, at(out, row + 1) + a * p[3] + b * p[4] + c * p[5])
            put(out, row + 2, at(out, row + 2) + a * p[6] + b * p[7] + c * p[8])


@outlined
def evaluate(
    law: Rigid, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy at the end of a step, and the power of the dampers in it.

    Args:
        law: see `Rigid`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        sweeps: nothing is sought.
        lanes: fixes the width of a row.
    """
    energy, power = 0.0, 0.0
    for e in range(law.corner.shape[0]):
        frame, h1 = _frame(law, e), _moved(law, e, ahead)
        strain = _strain(frame, h1)
        energy += 0.5 * _power(_stress(law, e, strain), strain)
        if law.viscosity > 0.0:
            middle = mixture(1.0, frame, 0.5, mixture(1.0, _moved(law, e, x), 1.0, h1))
            slip = symmetric(transposed_product(middle, _moved(law, e, rate)))
            power += law.viscosity * _power(_stress(law, e, slip), slip)
    return energy, power


@outlined
def lean(
    law: Rigid,
    memory: Float,
    x: Float,
    ahead: Float,
    rate: Float,
    T: float,
    out: Float,
    lanes: tuple[int, ...],
) -> None:
    """Adds to `out`, (3 rows, 3 rows), how the force that `resist` adds grows with the rate [Ns/m].

    Args:
        law: see `Rigid`.
        memory: of the copy.
        x: where the step begins, (rows, 4) [m].
        ahead: where it leads, x + T rate.
        rate: (rows, 4) [m/s].
        T: length of the step [s].
        out: rows and columns 3 i + axis.
        lanes: fixes the width.
    """
    for e in range(law.corner.shape[0]):
        frame, h, h1 = _frame(law, e), _moved(law, e, x), _moved(law, e, ahead)
        middle = mixture(1.0, frame, 0.5, mixture(1.0, h, 1.0, h1))
        end, going = mixture(1.0, frame, 1.0, h1), _moved(law, e, rate)
        strain = mixture(0.5, _strain(frame, h), 0.5, _strain(frame, h1))
        strain = mixture(1.0, strain, law.viscosity, symmetric(transposed_product(middle, going)))
        stress = _stress(law, e, strain)
        # With dG of the rate: G₁ grows by T dG, Ḡ by ½ T dG.
        along = mixture(0.5 * T, end, law.viscosity, middle)
        for l in range(4):
            p, q, r = 0.25 * at(law.sign, 4 * l), 0.25 * at(law.sign, 4 * l + 1), 0.25 * at(law.sign, 4 * l + 2)
            column = 3 * at(law.corner, 4 * e + l)
            for b in range(3):
                x1, y1, z1 = 1.0 if b == 0 else 0.0, 1.0 if b == 1 else 0.0, 1.0 if b == 2 else 0.0
                grown = (x1 * p, x1 * q, x1 * r, y1 * p, y1 * q, y1 * r, z1 * p, z1 * q, z1 * r)
                more = symmetric(transposed_product(along, grown))
                if law.viscosity > 0.0:
                    turn = symmetric(transposed_product(grown, going))
                    more = mixture(1.0, more, 0.5 * T * law.viscosity, turn)
                push = product(middle, _stress(law, e, more))
                push = mixture(1.0, push, 0.5 * T, product(grown, stress))
                for k in range(4):
                    row = 3 * at(law.corner, 4 * e + k)
                    i, j, m = 0.25 * at(law.sign, 4 * k), 0.25 * at(law.sign, 4 * k + 1), 0.25 * at(law.sign, 4 * k + 2)
                    for a in range(3):
                        value = i * push[3 * a] + j * push[3 * a + 1] + m * push[3 * a + 2]
                        place = (row + a, column + b)
                        put(out, place, at(out, place) + value)
