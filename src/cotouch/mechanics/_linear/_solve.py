"""Solving `A v̂ = b` of one step: in closed form where A is diagonal, else by an iteration from zero.

*Conjugate gradients* solve every A. Where its diagonal outweighs the rest, bounds on the spectrum of `D⁻¹ A` are known
for the asking; the *Chebyshev* iteration then needs no inner products, and where the rows fall into two halves with
entries only across, as those of a lattice do, it works on one half: half the products of conjugate gradients.

The energy identity of the step needs `v̂ᵀ(b - A v̂) = 0`. A solution is scaled to it at the end, so that the identity
holds however early the iteration stops: a cap costs accuracy, never passivity. Conjugate gradients from zero keep it by
themselves, and the scale only makes up for rounding where A is badly conditioned; a warm start would break it.
"""

import math

import numpy as np

from cotouch.arrays import Float
from cotouch.kernels import at, inner, kernel, load, splat, store, total
from cotouch.mechanics._linear._dense import solve_dense
from cotouch.mechanics._linear._operator import Operator, row_sum
from cotouch.mechanics._linear._ports import add_ports
from cotouch.mechanics._linear._state import Ports, Workspace

# Squared residuals below this are the end of motion, not work left to do; they would underflow into 0/0.
_FLOOR = 1e-290
# What `v̂ᵀ r` may be beside `v̂ᵀ b`: less than rounding does to the sums themselves.
_NOTICED = 1e-16
# Up to this bound on the spectrum Chebyshev takes about half the time of conjugate gradients where the bound is sharp.
# Where one odd row makes it loose, and conjugate gradients stop early, a step was seen to take a fifth longer.
_SHARP = 0.9


@kernel
def invert(op: Operator, scale: Float, diagonal: Float, inverse: Float) -> float:
    """`inverse = 1 / diagonal`, and a bound ρ so that the eigenvalues of `D⁻¹ A` lie in [1 - ρ, 1 + ρ] (Gershgorin).

    Args:
        op: gives the families.
        scale: of each family in A, (families,).
        diagonal: D, (rows,), > 0.
        inverse: result (rows,).

    Returns:
        ρ, the largest sum of magnitudes off the diagonal in a row of `D⁻¹ A`.
    """
    bound = 0.0
    for i in range(diagonal.shape[0]):
        inverse[i] = 1.0 / at(diagonal, i)
        beside = 0.0
        for family in range(scale.shape[0]):
            beside += abs(at(scale, family)) * at(op.magnitude[family], i)
        bound = max(bound, beside * at(inverse, i))
    return bound


@kernel
def chebyshev_iterations(op: Operator, bound: float, tolerance: float) -> int:
    """How many iterations of `chebyshev` are sure to meet the tolerance; 0 where conjugate gradients do better.

    k half sweeps leave of the residual, in the norm of D^-½, at most `√(1 + ρ²) / T_k(1/ρ)` [Golub & Varga 1961; the
    root because the start of one half shows in the other], and the last scale, a projection along v̂, adds
    `1/√(1 - ρ²)` at most [Kantorovich]. Conjugate gradients need no more iterations than there are rows.

    Args:
        op: the body's matrices.
        bound: ρ, at least the spectral radius of the iteration, >= 0.
        tolerance: of the solver, 0 to 1.
    """
    if op.split == 0 or not bound <= _SHARP:
        return 0
    square = bound * bound
    gain = math.sqrt((1.0 + square) / (1.0 - square)) / tolerance
    sweeps = math.acosh(max(gain, 1.0)) / math.acosh(1.0 / bound)
    iterations = max(np.ceil(0.5 * (sweeps + 1.0)), 1.0)
    return int(iterations) if iterations <= op.mass.shape[0] else 0


@kernel
def chebyshev(
    op: Operator,
    values: Float,
    scale: float,
    diagonal: Float,
    inverse: Float,
    rhs: Float,
    solution: Float,
    bound: float,
    iterations: int,
    lanes: tuple[int, ...],
) -> int:
    """Chebyshev iterations from zero over the two halves in turn for `(diagonal + scale * values) solution = rhs`.

    This is the cyclic method of Golub and Varga [Numer. Math. 3, 1961]: since a half takes from the other only, iterate
    k is worked out where k's half is and overwrites iterate k - 2. A last Gauss-Seidel sweep solves the second half for
    what the first is, so that the whole is the Chebyshev iteration for the first with the second eliminated.

    Args:
        op: gives the pattern (`pointer`, `column`) and its halves.
        values: off-diagonal values, (entries,).
        scale: of the values.
        diagonal: (rows,), > 0.
        inverse: 1/diagonal, (rows,).
        rhs: (rows, width).
        solution: result (rows, width).
        bound: ρ of `invert`, < 1.
        iterations: how many, >= 1; each is a sweep over both halves.
        lanes: fixes the width.

    Returns:
        Number of iterations; 0 where nothing moves.
    """
    rows, split = diagonal.shape[0], op.split
    zero = splat(0.0, lanes)
    energy = splat(0.0, lanes)
    for i in range(rows):
        b = load(rhs, i, lanes)
        z = at(inverse, i) * b
        energy = energy + b * z
        store(solution, i, z if i < split else zero, lanes)
    if total(energy) <= _FLOOR:
        for i in range(split):
            store(solution, i, zero, lanes)
        return 0
    quarter = 0.25 * bound * bound
    weight = 2.0
    for _ in range(iterations - 1):
        weight = 1.0 / (1.0 - quarter * weight)
        _sweep(op, values, scale, inverse, rhs, solution, weight, split, rows, lanes)
        weight = 1.0 / (1.0 - quarter * weight)
        _sweep(op, values, scale, inverse, rhs, solution, weight, 0, split, lanes)
    _sweep(op, values, scale, inverse, rhs, solution, 1.0, split, rows, lanes)

    work, left = splat(0.0, lanes), splat(0.0, lanes)
    for i in range(split):
        v, b = load(solution, i, lanes), load(rhs, i, lanes)
        work = work + v * b
        left = left + v * (b - at(diagonal, i) * v - scale * row_sum(op, values, i, solution, lanes))
    for i in range(split, rows):  # has no residual after the last sweep
        work = work + load(solution, i, lanes) * load(rhs, i, lanes)
    _rescale(total(work), total(left), solution, lanes)
    return iterations


@inner
def _sweep(
    op: Operator,
    values: Float,
    scale: float,
    inverse: Float,
    rhs: Float,
    solution: Float,
    weight: float,
    first: int,
    last: int,
    lanes: tuple[int, ...],
) -> None:
    """Takes the rows from `first` to `last - 1` by `weight` of the way to where the others would have them."""
    for i in range(first, last):
        old = load(solution, i, lanes)
        wanted = at(inverse, i) * (load(rhs, i, lanes) - scale * row_sum(op, values, i, solution, lanes))
        store(solution, i, old + weight * (wanted - old), lanes)


@kernel
def conjugate_gradients(
    op: Operator,
    values: Float,
    scale: float,
    diagonal: Float,
    inverse: Float,
    rhs: Float,
    solution: Float,
    residual: Float,
    direction: Float,
    image: Float,
    tolerance: float,
    least: int,
    cap: int,
    lanes: tuple[int, ...],
) -> int:
    """Jacobi-preconditioned conjugate gradients from zero for `(diagonal + scale * values) solution = rhs`.

    Args:
        op: gives the pattern (`pointer`, `column`).
        values: off-diagonal values, (entries,).
        scale: of the values.
        diagonal: (rows,), > 0.
        inverse: 1/diagonal, (rows,).
        rhs: (rows, width).
        solution: result (rows, width).
        residual: scratch (rows, width).
        direction: scratch (rows, width).
        image: scratch (rows, width).
        tolerance: on the residual relative to the right-hand side, both in the norm of diagonal⁻¹.
        least: number of iterations below which no tolerance is met but that of a zero.
        cap: largest number of iterations, >= 1.
        lanes: fixes the width.

    Returns:
        Number of iterations.
    """
    rows = diagonal.shape[0]
    zero = splat(0.0, lanes)
    energy = splat(0.0, lanes)
    for i in range(rows):
        b = load(rhs, i, lanes)
        z = at(inverse, i) * b
        store(residual, i, b, lanes)
        store(direction, i, z, lanes)
        store(solution, i, zero, lanes)
        energy = energy + b * z
    size = total(energy)
    target = max(tolerance * tolerance * size, _FLOOR)
    iterations = 0
    # Written so that NaN enters, spoils the solution, and is seen, instead of passing for a body at rest.
    while not size <= (target if iterations >= least else _FLOOR) and iterations < cap:
        curvature = splat(0.0, lanes)
        for i in range(rows):
            own = load(direction, i, lanes)
            result = at(diagonal, i) * own + scale * row_sum(op, values, i, direction, lanes)
            store(image, i, result, lanes)
            curvature = curvature + own * result
        length = size / total(curvature)
        energy = splat(0.0, lanes)
        for i in range(rows):
            r = load(residual, i, lanes) - length * load(image, i, lanes)
            store(residual, i, r, lanes)
            energy = energy + (at(inverse, i) * r) * r
        new_size = total(energy)
        turn = new_size / size
        size = new_size
        iterations += 1
        if np.isnan(size):
            cap = iterations
        # The solution is brought up to date here rather than with the residual: the direction is read once, not twice.
        for i in range(rows):
            p = load(direction, i, lanes)
            store(solution, i, load(solution, i, lanes) + length * p, lanes)
            store(direction, i, at(inverse, i) * load(residual, i, lanes) + turn * p, lanes)
    work, left = splat(0.0, lanes), splat(0.0, lanes)
    for i in range(rows):
        v = load(solution, i, lanes)
        work = work + v * load(rhs, i, lanes)
        left = left + v * load(residual, i, lanes)
    _rescale(total(work), total(left), solution, lanes)
    return iterations


@inner
def _rescale(supplied: float, missed: float, solution: Float, lanes: tuple[int, ...]) -> None:
    """Scales the solution so that `v̂ᵀ(b - A v̂) = 0`, given `v̂ᵀ b` and `v̂ᵀ r` with `r = b - A v̂`.

    With `v̂ᵀ A v̂ = v̂ᵀ b - v̂ᵀ r` the scale is `v̂ᵀ b / v̂ᵀ A v̂`.
    """
    if abs(missed) > _NOTICED * supplied and supplied - missed > 0.0:
        scale = max(supplied, 0.0) / (supplied - missed)
        for i in range(solution.shape[0]):
            store(solution, i, scale * load(solution, i, lanes), lanes)


@kernel
def divide(diagonal: Float, rhs: Float, solution: Float, lanes: tuple[int, ...]) -> None:
    """`solution = rhs / diagonal`, row by row.

    Args:
        diagonal: (rows,), not 0.
        rhs: (rows, width).
        solution: result, likewise.
        lanes: fixes the width of a row.
    """
    for i in range(diagonal.shape[0]):
        store(solution, i, (1.0 / at(diagonal, i)) * load(rhs, i, lanes), lanes)


@inner
def solve_step(
    op: Operator, ports: Ports, work: Workspace, tolerance: float, least: int, cap: int, lanes: tuple[int, ...]
) -> int:
    """Solves the system of a step for `mean`; returns the iterations that it took, 0 where it is a closed form.

    Args:
        op: the body's matrices.
        ports: what holds the copy.
        work: `diagonal`, `scale`, `port_gain` and `rhs` are the system; `mean` is the result.
        tolerance: of the solver.
        least: iterations at least.
        cap: on its iterations.
        lanes: fixes the width of a row.
    """
    families = op.entries.shape[0]
    if families == 0 and work.dense.shape[0] > 0:
        solve_dense(op, ports, work)
        return 0
    if families == 0:
        divide(work.diagonal, work.rhs, work.mean, lanes)
        if ports.shape.shape[0] > 0:
            add_ports(
                work.diagonal,
                ports.shape,
                work.port_gain,
                work.small,
                work.small_rhs,
                work.mean,
                lanes,
            )
        return 0
    values, scale = op.entries[0], work.scale[0]
    if families > 1:
        values, scale = work.values, 1.0
        for e in range(values.shape[0]):
            value = 0.0
            for family in range(families):
                value += work.scale[family] * op.entries[family, e]
            values[e] = value
    bound = invert(op, work.scale, work.diagonal, work.inverse)
    enough = chebyshev_iterations(op, bound, tolerance)
    if enough > 0:
        iterations = chebyshev(
            op,
            values,
            scale,
            work.diagonal,
            work.inverse,
            work.rhs,
            work.mean,
            bound,
            min(max(enough, least), cap),
            lanes,
        )
    else:
        iterations = conjugate_gradients(
            op,
            values,
            scale,
            work.diagonal,
            work.inverse,
            work.rhs,
            work.mean,
            work.residual,
            work.direction,
            work.image,
            tolerance,
            least,
            cap,
            lanes,
        )
    if work.dense.shape[0] > 0:
        solve_dense(op, ports, work)
    return iterations
