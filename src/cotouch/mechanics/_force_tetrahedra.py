# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownParameterType=false
# numba has no types
"""Linear tetrahedra with a law of their own for the stress: what all of these have in common.

With H the gradient of displacement, F = I + H. A law gives the mean first Piola stress between two gradients and the
density of energy at the second; the nodes' forces, the dampers `2 η μ sym(FᵀḞ) + η λ tr(FᵀḞ)`, which feel no rotation,
and the sums are here.
"""
# Every law takes the interface's arguments, and not each needs all of them.
# ruff: noqa: ARG001, ARG005
# pyright: reportMissingParameterType=false, reportUnusedFunction=false

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from numba.extending import overload

from cotouch.arrays import Float
from cotouch.mechanics._force_memory import FIRST, columns, is_cut, keep
from cotouch.mechanics._force_ties import pull_ties, weigh_ties
from cotouch.mechanics._kernel import inner, part
from cotouch.mechanics._matrix3 import (
    IDENTITY,
    Matrix,
    cofactor,
    contraction,
    mixture,
    product,
    symmetric,
    transpose,
    transposed_product,
    turned,
)
from cotouch.mechanics._vector import at, put

Int = npt.NDArray[np.int32]


class CorotatedTetrahedra(NamedTuple):
    """`μ ‖F - R‖² + ½ λ (tr RᵀF - 3)²`.

    Attributes:
        viscosity: the largest η [s].
        corner: rows of the corners, (tetrahedra, 4).
        gradient: ∇N of the last three corners, (3 · tetrahedra, 4) [1/m].
        volume: at rest, (tetrahedra,) [m³].
        lame: λ and μ [Pa], η of the damper beside them [s], (tetrahedra, 3).
        tie_start: see `CorotatedCells`, as of the other ties.
        tie_end: likewise.
        tie_face: likewise.
        tie: likewise.
        cut: where in the memory the marks of those that were cut begin; negative: none can be.
        tie_cut: likewise of the faces.
    """

    viscosity: float
    corner: Int
    gradient: Float
    volume: Float
    lame: Float
    tie_start: Int
    tie_end: Int
    tie_face: Int
    tie: Float
    cut: int = -1
    tie_cut: int = -1


class StVenantKirchhoff(NamedTuple):
    """`μ ‖E‖² + ½ λ (tr E)²`, `E = ½ (FᵀF - I)`; fields as of `CorotatedTetrahedra`."""

    viscosity: float
    corner: Int
    gradient: Float
    volume: Float
    lame: Float
    tie_start: Int
    tie_end: Int
    tie_face: Int
    tie: Float
    cut: int = -1
    tie_cut: int = -1


class NeoHookean(NamedTuple):
    """`½ μ (‖F‖² - 3) - μ (J - 1) + ½ (λ + μ) (J - 1)²`: stable, and sound where it is inverted; fields likewise."""

    viscosity: float
    corner: Int
    gradient: Float
    volume: Float
    lame: Float
    tie_start: Int
    tie_end: Int
    tie_face: Int
    tie: Float
    cut: int = -1
    tie_cut: int = -1


TETRAHEDRA = (CorotatedTetrahedra, StVenantKirchhoff, NeoHookean)


@inner
def _strain(h: Matrix) -> Matrix:
    """Green's, `½ (H + Hᵀ + HᵀH)`."""
    return mixture(1.0, symmetric(h), 0.5, transposed_product(h, h))


@inner
def _trace(a: Matrix) -> float:
    return a[0] + a[4] + a[8]


@inner
def _corotated_stress(lam: float, mu: float, h: Matrix, h1: Matrix, memory: Float, row: int) -> Matrix:
    before = columns(memory, row)
    f1 = mixture(1.0, IDENTITY, 1.0, h1)
    after = turned(turned(before, f1), f1)
    r = mixture(0.5, before, 0.5, after)
    s = 0.5 * (contraction(before, mixture(1.0, IDENTITY, 1.0, h)) + contraction(after, f1)) - 3.0
    stretch = mixture(0.5, mixture(1.0, h, 1.0, h1), -1.0, mixture(1.0, r, -1.0, IDENTITY))
    return mixture(2.0 * mu, stretch, lam * s, r)


@inner
def _corotated_energy(lam: float, mu: float, h1: Matrix, memory: Float, row: int, sweeps: int) -> float:
    f1 = mixture(1.0, IDENTITY, 1.0, h1)
    r = columns(memory, row)
    for _ in range(sweeps):
        r = turned(r, f1)
    keep(memory, row, r)
    stretch = mixture(1.0, h1, -1.0, mixture(1.0, r, -1.0, IDENTITY))
    # tr RᵀF - 3 = R : (F - R), as R : R = 3.
    s = contraction(r, stretch)
    return mu * contraction(stretch, stretch) + 0.5 * lam * s * s


@inner
def _kirchhoff_stress(lam: float, mu: float, h: Matrix, h1: Matrix) -> Matrix:
    e = mixture(0.5, _strain(h), 0.5, _strain(h1))
    f = mixture(1.0, IDENTITY, 0.5, mixture(1.0, h, 1.0, h1))
    return product(f, mixture(2.0 * mu, e, lam * _trace(e), IDENTITY))


@inner
def _kirchhoff_energy(lam: float, mu: float, h1: Matrix) -> float:
    e = _strain(h1)
    trace = _trace(e)
    return mu * contraction(e, e) + 0.5 * lam * trace * trace


@inner
def _grown(h: Matrix) -> tuple[float, float, float]:
    """`J - 1` without cancellation, and what of `½ (‖F‖² - 3) - (J - 1)` is beside it."""
    e, c = _strain(h), cofactor(_strain(h))
    first, second = _trace(e), _trace(c)
    third = e[0] * c[0] + e[1] * c[1] + e[2] * c[2]
    f = mixture(1.0, IDENTITY, 1.0, h)
    g = cofactor(f)
    J = f[0] * g[0] + f[1] * g[1] + f[2] * g[2]
    if J > 0.0:
        d = (2.0 * first + 4.0 * second + 8.0 * third) / (J + 1.0)
        return d, (first * d - 4.0 * second - 8.0 * third) / (J + 1.0), J
    return J - 1.0, first - (J - 1.0), J


@inner
def _neo_hookean_stress(lam: float, mu: float, h: Matrix, h1: Matrix) -> Matrix:
    d, _, _ = _grown(h)
    d1, _, _ = _grown(h1)
    f = mixture(1.0, IDENTITY, 0.5, mixture(1.0, h, 1.0, h1))
    twelfth = mixture(1.0, cofactor(f), 1.0 / 12.0, cofactor(mixture(1.0, h1, -1.0, h)))
    pressure = (lam + mu) * 0.5 * (d + d1)
    return mixture(mu, mixture(1.0, f, -1.0, twelfth), pressure, twelfth)


@inner
def _neo_hookean_energy(lam: float, mu: float, h1: Matrix) -> float:
    d, rest, _ = _grown(h1)
    return mu * rest + 0.5 * (lam + mu) * d * d


def stress_of(law: Any, lam: float, mu: float, h: Matrix, h1: Matrix, memory: Float, row: int) -> Matrix:
    """Mean first Piola stress between two gradients of displacement [Pa]."""
    raise NotImplementedError


def energy_of(law: Any, lam: float, mu: float, h1: Matrix, memory: Float, row: int, sweeps: int) -> float:
    """Density of energy [J/m³]."""
    raise NotImplementedError


@overload(stress_of)
def _stress_of(law, lam, mu, h, h1, memory, row):  # numba compares the names with the stub's
    kind = getattr(law, "instance_class", None)
    if kind is CorotatedTetrahedra:
        return lambda law, lam, mu, h, h1, memory, row: _corotated_stress(lam, mu, h, h1, memory, row)
    if kind is StVenantKirchhoff:
        return lambda law, lam, mu, h, h1, memory, row: _kirchhoff_stress(lam, mu, h, h1)
    if kind is NeoHookean:
        return lambda law, lam, mu, h, h1, memory, row: _neo_hookean_stress(lam, mu, h, h1)
    return None


@overload(energy_of)
def _energy_of(law, lam, mu, h1, memory, row, sweeps):
    kind = getattr(law, "instance_class", None)
    if kind is CorotatedTetrahedra:
        return lambda law, lam, mu, h1, memory, row, sweeps: _corotated_energy(lam, mu, h1, memory, row, sweeps)
    if kind is StVenantKirchhoff:
        return lambda law, lam, mu, h1, memory, row, sweeps: _kirchhoff_energy(lam, mu, h1)
    if kind is NeoHookean:
        return lambda law, lam, mu, h1, memory, row, sweeps: _neo_hookean_energy(lam, mu, h1)
    return None


@inner
def _gradient(law: Any, e: int, field: Float) -> Matrix:
    """Gradient of a field over a tetrahedron."""
    i, j, k, l = (
        4 * at(law.corner, 4 * e),
        4 * at(law.corner, 4 * e + 1),
        4 * at(law.corner, 4 * e + 2),
        4 * at(law.corner, 4 * e + 3),
    )
    x, y, z = at(field, i), at(field, i + 1), at(field, i + 2)
    edges = (
        at(field, j) - x,
        at(field, k) - x,
        at(field, l) - x,
        at(field, j + 1) - y,
        at(field, k + 1) - y,
        at(field, l + 1) - y,
        at(field, j + 2) - z,
        at(field, k + 2) - z,
        at(field, l + 2) - z,
    )
    return product(edges, _shapes(law, e))


@inner
def _shapes(law: Any, e: int) -> Matrix:
    g = 12 * e
    return (
        at(law.gradient, g),
        at(law.gradient, g + 1),
        at(law.gradient, g + 2),
        at(law.gradient, g + 4),
        at(law.gradient, g + 5),
        at(law.gradient, g + 6),
        at(law.gradient, g + 8),
        at(law.gradient, g + 9),
        at(law.gradient, g + 10),
    )


@inner
def _push(law: Any, e: int, n: int, out: Float, x: float, y: float, z: float) -> None:
    i = 4 * at(law.corner, 4 * e + n)
    put(out, i, at(out, i) + x)
    put(out, i + 1, at(out, i + 1) + y)
    put(out, i + 2, at(out, i + 2) + z)


@part
def resist(law: Any, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]) -> None:
    """Adds the mean force between two places and the damping; see `cotouch.mechanics.BodyForce`."""
    pull_ties(law, memory, x, ahead, rate, out, lanes)
    for e in range(law.volume.shape[0]):
        if is_cut(memory, law.cut, e):
            continue
        lam, mu = at(law.lame, 3 * e), at(law.lame, 3 * e + 1)
        h, h1 = _gradient(law, e, x), _gradient(law, e, ahead)
        stress = stress_of(law, lam, mu, h, h1, memory, FIRST + 3 * e)
        if law.viscosity > 0.0:
            f = mixture(1.0, IDENTITY, 0.5, mixture(1.0, h, 1.0, h1))
            slip = symmetric(transposed_product(f, _gradient(law, e, rate)))
            drag = mixture(2.0 * mu, slip, lam * _trace(slip), IDENTITY)
            stress = mixture(1.0, stress, at(law.lame, 3 * e + 2), product(f, drag))
        p = product(stress, transpose(_shapes(law, e)))
        v = at(law.volume, e)
        _push(law, e, 1, out, v * p[0], v * p[3], v * p[6])
        _push(law, e, 2, out, v * p[1], v * p[4], v * p[7])
        _push(law, e, 3, out, v * p[2], v * p[5], v * p[8])
        _push(law, e, 0, out, -v * (p[0] + p[1] + p[2]), -v * (p[3] + p[4] + p[5]), -v * (p[6] + p[7] + p[8]))


@part
def evaluate(
    law: Any, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy at the end of a step, whose rotations it keeps, and the power of the dampers in it."""
    energy, power = weigh_ties(law, memory, ahead, rate, lanes)
    for e in range(law.volume.shape[0]):
        if is_cut(memory, law.cut, e):
            continue
        lam, mu, v = at(law.lame, 3 * e), at(law.lame, 3 * e + 1), at(law.volume, e)
        h1 = _gradient(law, e, ahead)
        energy += v * energy_of(law, lam, mu, h1, memory, FIRST + 3 * e, sweeps)
        if law.viscosity > 0.0:
            f = mixture(1.0, IDENTITY, 0.5, mixture(1.0, _gradient(law, e, x), 1.0, h1))
            slip = symmetric(transposed_product(f, _gradient(law, e, rate)))
            trace = _trace(slip)
            power += v * at(law.lame, 3 * e + 2) * (2.0 * mu * contraction(slip, slip) + lam * trace * trace)
    return energy, power
