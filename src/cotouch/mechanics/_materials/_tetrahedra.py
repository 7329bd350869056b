# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownParameterType=false
# numba has no types
"""Linear tetrahedra with a law of their own for the stress: what all of these have in common.

With H the gradient of displacement, F = I + H. A law gives the mean first Piola stress between two gradients and the
density of energy at the second; the nodes' forces, the dampers `2 η μ sym(FᵀḞ) + η λ tr(FᵀḞ)`, which feel no rotation,
and the sums are here. Four tetrahedra are worked out at a time, each in one lane.
"""
# Every law takes the interface's arguments, and not each needs all of them.
# ruff: noqa: ARG001, PLW0108
# pyright: reportMissingParameterType=false, reportUnusedFunction=false

from collections.abc import Callable
from typing import Any, NamedTuple

from numba.extending import overload

from cotouch.arrays import Float, Int
from cotouch.kernels import FOUR, inner, load, outlined, splat, total, where
from cotouch.kernels.matrix3 import (
    Matrix,
    cofactor,
    contraction,
    diagonal,
    mixture,
    product,
    scaled,
    symmetric,
    transpose,
    transposed_product,
)
from cotouch.mechanics._materials._fours import (
    Quad,
    Rows,
    add_rows,
    apart,
    as_rows,
    corner_rows,
    elements,
    four_rows,
    keep_before,
    keep_rotations,
    kept,
    rotations,
    take_rows,
)
from cotouch.mechanics._materials._memory import FIRST, before_row
from cotouch.mechanics._materials._nearest import SWEEPS, nearest
from cotouch.mechanics._materials._ties import pull_ties, weigh_ties
from cotouch.passing import by_address

# Rows of a block of four tetrahedra.
ROWS = 12
# Square of the change of FᵀF in a step from where on it is more than rounding.
_LITTLE = 1e-8


@by_address
class CorotatedTetrahedra(NamedTuple):
    """`μ ‖F - R‖² + ½ λ (tr RᵀF - 3)²`.

    Attributes:
        viscosity: the largest η [s].
        corner: rows of the corners, (tetrahedra, 4).
        volume: at rest, (tetrahedra,) [m³].
        block: of every four tetrahedra ∇N of the last three corners [1/m], λ and μ times the volume [J], with 0 for
            those that are missing, and η of the damper beside them [s]: `ROWS` rows of four.
        tie_start: see `CorotatedCells`, as of the other ties.
        tie_end: likewise.
        tie_face: likewise.
        tie: likewise.
        cut: where in the memory the marks of those that were cut begin; negative: none can be.
        tie_cut: likewise of the faces.
    """

    viscosity: float
    corner: Int
    volume: Float
    block: Float
    tie_start: Int
    tie_end: Int
    tie_face: Int
    tie: Float
    cut: int = -1
    tie_cut: int = -1


def tables_of(name: str, density: str) -> type:
    """Another class of tables with the fields of `CorotatedTetrahedra`: by their classes kernels tell laws apart.

    Args:
        name: of the class.
        density: of its elements' energy, in words or as a formula.
    """
    tables: Any = NamedTuple(name, list(CorotatedTetrahedra.__annotations__.items()))
    tables.__doc__ = f"{density}; fields as of `CorotatedTetrahedra`."
    tables.__new__.__defaults__ = CorotatedTetrahedra.__new__.__defaults__
    return by_address(tables)


StVenantKirchhoff = tables_of("StVenantKirchhoff", "`μ ‖E‖² + ½ λ (tr E)²`, `E = ½ (FᵀF - I)`")
NeoHookean = tables_of(
    "NeoHookean", "`½ μ (‖F‖² - 3) - μ (J - 1) + ½ (λ + μ) (J - 1)²`: stable, and sound where it is inverted"
)


@inner
def _strain(h: Matrix) -> Matrix:
    """Green's, `½ (H + Hᵀ + HᵀH)`."""
    return mixture(1.0, symmetric(h), 0.5, transposed_product(h, h))


@inner
def _trace(a: Matrix) -> float:
    return a[0] + a[4] + a[8]


@inner
def _turning(before: Matrix, after: Matrix, twice: Matrix, grown: Matrix) -> Matrix:
    """Twice the mean rotation R̄ for which `R̄ : ΔF` is the change of `tr RᵀF`.

    Half of the sum of both rotations misses `-ΔR : F̄`, which is of third order. It is made up for along `F̄ Δ(FᵀF)`,
    which does work of half the square of that change and has no torque [Gonzalez, J. Nonlinear Sci. 6, 1996]. Where a
    rotation jumps, as in an element that turns inside out, no more is added than of the order of F.

    Args:
        before: R.
        after: R at the end.
        twice: 2 F̄, the sum of F and F at the end.
        grown: ΔF.
    """
    change = symmetric(transposed_product(twice, grown))
    missed = contraction(mixture(1.0, after, -1.0, before), twice)
    share = missed / (contraction(change, change) + missed * missed + _LITTLE)
    return mixture(1.0, mixture(1.0, before, 1.0, after), share, product(twice, change))


@inner
def _corotated_stress(law: Any, lam: float, mu: float, h: Matrix, h1: Matrix, memory: Float, e: Quad) -> Matrix:
    before = rotations(memory, FIRST, e)
    f1 = diagonal(h1, 1.0)
    after = nearest(before, f1, SWEEPS)
    s = contraction(before, diagonal(h, 1.0)) + contraction(after, f1) - 6.0
    f = diagonal(mixture(1.0, h, 1.0, h1), 2.0)
    twice = _turning(before, after, f, mixture(1.0, h1, -1.0, h))
    # Twice the stretch halfway, and from there half of the stress.
    return mixture(mu, mixture(1.0, f, -1.0, twice), 0.25 * lam * s, twice)


@inner
def _corotated_energy(law: Any, lam: float, mu: float, h1: Matrix, memory: Float, e: Quad, sweeps: int) -> float:
    r = nearest(rotations(memory, FIRST, e), diagonal(h1, 1.0), sweeps)
    keep_before(memory, FIRST, before_row(law.volume.shape[0]), e)
    keep_rotations(memory, FIRST, e, r)
    stretch = mixture(1.0, h1, -1.0, diagonal(r, -1.0))
    # tr RᵀF - 3 = R : (F - R), as R : R = 3.
    s = contraction(r, stretch)
    return mu * contraction(stretch, stretch) + 0.5 * lam * s * s


@inner
def _kirchhoff_stress(law: Any, lam: float, mu: float, h: Matrix, h1: Matrix, memory: Float, e: Quad) -> Matrix:
    strain = mixture(1.0, _strain(h), 1.0, _strain(h1))
    f = diagonal(mixture(1.0, h, 1.0, h1), 2.0)
    return product(f, diagonal(scaled(0.5 * mu, strain), (0.25 * lam) * _trace(strain)))


@inner
def _kirchhoff_energy(law: Any, lam: float, mu: float, h1: Matrix, memory: Float, e: Quad, sweeps: int) -> float:
    strain = _strain(h1)
    trace = _trace(strain)
    return mu * contraction(strain, strain) + 0.5 * lam * trace * trace


@inner
def _grown(h: Matrix) -> tuple[float, float]:
    """`J - 1` without cancellation, and what of `½ (‖F‖² - 3) - (J - 1)` is beside it."""
    e, c = _strain(h), cofactor(_strain(h))
    first, second = _trace(e), _trace(c)
    third = e[0] * c[0] + e[1] * c[1] + e[2] * c[2]
    f = diagonal(h, 1.0)
    g = cofactor(f)
    J = f[0] * g[0] + f[1] * g[1] + f[2] * g[2]
    grown = where(J, (2.0 * first + 4.0 * second + 8.0 * third) / (J + 1.0), J - 1.0)
    rest = where(J, (first * grown - 4.0 * second - 8.0 * third) / (J + 1.0), first - (J - 1.0))
    return grown, rest


@inner
def _neo_hookean_stress(law: Any, lam: float, mu: float, h: Matrix, h1: Matrix, memory: Float, e: Quad) -> Matrix:
    d, _ = _grown(h)
    d1, _ = _grown(h1)
    f = diagonal(mixture(0.5, h, 0.5, h1), 1.0)
    twelfth = mixture(1.0, cofactor(f), 1.0 / 12.0, cofactor(mixture(1.0, h1, -1.0, h)))
    pressure = (lam + mu) * 0.5 * (d + d1)
    return mixture(mu, mixture(1.0, f, -1.0, twelfth), pressure, twelfth)


@inner
def _neo_hookean_energy(law: Any, lam: float, mu: float, h1: Matrix, memory: Float, e: Quad, sweeps: int) -> float:
    d, rest = _grown(h1)
    return mu * rest + 0.5 * (lam + mu) * d * d


class SolidLaw(NamedTuple):
    """A law of tetrahedra.

    Attributes:
        kind: class of its tables, with the fields of `CorotatedTetrahedra`.
        stress: `stress(law, lam, mu, h, h1, memory, e)`, the mean first Piola stress between two gradients of
            displacement, times the volume [J].
        energy: `energy(law, lam, mu, h1, memory, e, sweeps)` at the second [J].
        turns: whether it keeps a rotation of each element.
    """

    kind: type
    stress: Callable[..., Matrix]
    energy: Callable[..., float]
    turns: bool = False


# The registry, by the names of `cotouch.body.Material`; λ and μ come times the volume.
SOLIDS = {
    "corotated": SolidLaw(CorotatedTetrahedra, _corotated_stress, _corotated_energy, turns=True),
    "st-venant-kirchhoff": SolidLaw(StVenantKirchhoff, _kirchhoff_stress, _kirchhoff_energy),
    "neo-hookean": SolidLaw(NeoHookean, _neo_hookean_stress, _neo_hookean_energy),
}


def stress_of(law: Any, lam: float, mu: float, h: Matrix, h1: Matrix, memory: Float, e: Quad) -> Matrix:
    """Mean first Piola stress between two gradients of displacement, times the volume [J].

    Args:
        law: of tetrahedra, see `SolidLaw`.
        lam: λ times the volume, of each of four elements [J].
        mu: μ likewise.
        h: gradients before the step.
        h1: after it.
        memory: of the copy, (numbers,).
        e: which elements.
    """
    raise NotImplementedError


def energy_of(law: Any, lam: float, mu: float, h1: Matrix, memory: Float, e: Quad, sweeps: int) -> float:
    """Energy [J].

    Args:
        law: of tetrahedra, see `SolidLaw`.
        lam: λ times the volume, of each of four elements [J].
        mu: μ likewise.
        h1: gradients after the step.
        memory: of the copy, (numbers,).
        e: which elements.
        sweeps: of the search for the nearest rotations, >= 1.
    """
    raise NotImplementedError


def _solid(law: Any) -> Any:
    kind = getattr(law, "instance_class", None)
    return next((solid for solid in SOLIDS.values() if solid.kind is kind), None)


@overload(stress_of)
def _stress_of(law, lam, mu, h, h1, memory, e):  # numba compares the names with the stub's
    solid = _solid(law)
    if solid is None:
        return None
    found = solid.stress
    return lambda law, lam, mu, h, h1, memory, e: found(law, lam, mu, h, h1, memory, e)


@overload(energy_of)
def _energy_of(law, lam, mu, h1, memory, e, sweeps):
    solid = _solid(law)
    if solid is None:
        return None
    found = solid.energy
    return lambda law, lam, mu, h1, memory, e, sweeps: found(law, lam, mu, h1, memory, e, sweeps)


@inner
def _shapes(law: Any, b: int) -> Matrix:
    """∇N of four tetrahedra, a row for each of the last three corners."""
    g = ROWS * b
    return (
        load(law.block, g, FOUR),
        load(law.block, g + 1, FOUR),
        load(law.block, g + 2, FOUR),
        load(law.block, g + 3, FOUR),
        load(law.block, g + 4, FOUR),
        load(law.block, g + 5, FOUR),
        load(law.block, g + 6, FOUR),
        load(law.block, g + 7, FOUR),
        load(law.block, g + 8, FOUR),
    )


@inner
def _constant(law: Any, b: int, which: int) -> float:
    """λ and μ times the volume, or η, of four tetrahedra."""
    return load(law.block, ROWS * b + 9 + which, FOUR)


@inner
def _gradient(field: Float, corners: tuple[Quad, Quad, Quad, Quad], shapes: Matrix) -> Matrix:
    """Gradient of a field over four tetrahedra."""
    start = four_rows(field, corners[0])
    a, d, g = apart(start, four_rows(field, corners[1]))
    b, e, h = apart(start, four_rows(field, corners[2]))
    c, f, i = apart(start, four_rows(field, corners[3]))
    return product((a, b, c, d, e, f, g, h, i), shapes)


@inner
def _corners(law: Any, e: Quad) -> tuple[Quad, Quad, Quad, Quad]:
    return (
        corner_rows(law.corner, 4, e, 0),
        corner_rows(law.corner, 4, e, 1),
        corner_rows(law.corner, 4, e, 2),
        corner_rows(law.corner, 4, e, 3),
    )


@outlined
def resist(law: Any, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]) -> None:
    """Adds the mean force between two places and the damping; see `cotouch.mechanics.BodyForce`.

    Args:
        law: of tetrahedra, see `SolidLaw`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    pull_ties(law, memory, x, ahead, rate, out, lanes)
    count = law.volume.shape[0]
    for first in range(0, count, 4):
        b, e = first // 4, elements(first, count - 1)
        corners, shapes = _corners(law, e), _shapes(law, b)
        share = kept(memory, law.cut, e)
        lam, mu = share * _constant(law, b, 0), share * _constant(law, b, 1)
        h, h1 = _gradient(x, corners, shapes), _gradient(ahead, corners, shapes)
        stress = stress_of(law, lam, mu, h, h1, memory, e)
        if law.viscosity > 0.0:
            f = diagonal(mixture(1.0, h, 1.0, h1), 2.0)  # twice that halfway
            slip = symmetric(transposed_product(f, _gradient(rate, corners, shapes)))
            eta = 0.25 * _constant(law, b, 2)
            drag = product(f, diagonal(scaled(2.0 * eta * mu, slip), eta * lam * _trace(slip)))
            stress = mixture(1.0, stress, 1.0, drag)
        p = product(stress, transpose(shapes))
        one, two, three = as_rows((p[0], p[3], p[6])), as_rows((p[1], p[4], p[7])), as_rows((p[2], p[5], p[8]))
        add_rows(out, corners[1], one)
        add_rows(out, corners[2], two)
        add_rows(out, corners[3], three)
        take_rows(out, corners[0], _sum(one, two, three))


@inner
def _sum(a: Rows, b: Rows, c: Rows) -> Rows:
    return a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2], a[3] + b[3] + c[3]


@outlined
def evaluate(
    law: Any, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy at the end of a step, whose rotations it keeps, and the power of the dampers in it.

    Args:
        law: of tetrahedra, see `SolidLaw`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        sweeps: of the search for the nearest rotations, >= 1.
        lanes: fixes the width of a row.
    """
    tied, damped = weigh_ties(law, memory, ahead, rate, lanes)
    energy, power = splat(0.0, FOUR), splat(0.0, FOUR)
    count = law.volume.shape[0]
    for first in range(0, count, 4):
        b, e = first // 4, elements(first, count - 1)
        corners, shapes = _corners(law, e), _shapes(law, b)
        share = kept(memory, law.cut, e)
        lam, mu = share * _constant(law, b, 0), share * _constant(law, b, 1)
        h1 = _gradient(ahead, corners, shapes)
        energy = energy + energy_of(law, lam, mu, h1, memory, e, sweeps)
        if law.viscosity > 0.0:
            f = diagonal(mixture(1.0, _gradient(x, corners, shapes), 1.0, h1), 2.0)
            slip = symmetric(transposed_product(f, _gradient(rate, corners, shapes)))
            trace = _trace(slip)
            lost = 2.0 * mu * contraction(slip, slip) + lam * trace * trace
            power = power + (0.25 * _constant(law, b, 2)) * lost
    return tied + total(energy), damped + total(power)
