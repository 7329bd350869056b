"""Solving `A v̂ = b` of one step: in closed form where A is diagonal, else by conjugate gradients from zero.

Started from zero, every iterate of conjugate gradients satisfies `v̂ᵀ(b - A v̂) = 0`. The energy identity of the step
therefore holds however early the iteration stops: a cap costs accuracy, never passivity. A warm start would break this.
Rounding does too, slowly, where A is badly conditioned; one scale for the whole solution at the end makes up for it.
"""

import numpy as np
import numpy.typing as npt

from cotouch.mechanics._kernel import kernel
from cotouch.mechanics._operator import Operator, row_sum
from cotouch.mechanics._vector import at, load, splat, store, total

Float = npt.NDArray[np.float64]

# Squared residuals below this are the end of motion, not work left to do; they would underflow into 0/0.
_FLOOR = 1e-290
# What `v̂ᵀ r` may be beside `v̂ᵀ b`: less than rounding does to the sums themselves.
_NOTICED = 1e-16


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
    cap: int,
    lanes: tuple[int, ...],
) -> int:
    """Jacobi-preconditioned conjugate gradients from zero for `(diagonal + scale * values) solution = rhs`.

    Args:
        op: gives the pattern (`pointer`, `column`).
        values: off-diagonal values, (entries,).
        scale: of the values.
        diagonal: (rows,), > 0.
        inverse: scratch (rows,), becomes 1/diagonal.
        rhs: (rows, width).
        solution: result (rows, width).
        residual: scratch (rows, width).
        direction: scratch (rows, width).
        image: scratch (rows, width).
        tolerance: on the residual relative to the right-hand side, both in the norm of diagonal⁻¹.
        cap: largest number of iterations, >= 1.
        lanes: fixes the width.

    Returns:
        Number of iterations.
    """
    rows = diagonal.shape[0]
    zero = splat(0.0, lanes)
    energy = splat(0.0, lanes)
    for i in range(rows):
        inverse[i] = 1.0 / at(diagonal, i)
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
    while not size <= target and iterations < cap:
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
    _rescale(rhs, residual, solution, lanes)
    return iterations


@kernel
def _rescale(rhs: Float, residual: Float, solution: Float, lanes: tuple[int, ...]) -> None:
    """Scales the solution so that `v̂ᵀ(b - A v̂) = 0` again, where badly conditioned matrices let rounding wear it off.

    With `v̂ᵀ A v̂ = v̂ᵀ b - v̂ᵀ r` the scale is `v̂ᵀ b / v̂ᵀ A v̂`; it costs two sums, and mostly differs from 1 by nothing.
    """
    work, left = splat(0.0, lanes), splat(0.0, lanes)
    for i in range(rhs.shape[0]):
        v = load(solution, i, lanes)
        work = work + v * load(rhs, i, lanes)
        left = left + v * load(residual, i, lanes)
    supplied, missed = total(work), total(left)
    if abs(missed) > _NOTICED * supplied and supplied - missed > 0.0:
        scale = max(supplied, 0.0) / (supplied - missed)
        for i in range(rhs.shape[0]):
            store(solution, i, scale * load(solution, i, lanes), lanes)


@kernel
def divide(diagonal: Float, rhs: Float, solution: Float, lanes: tuple[int, ...]) -> None:
    """`solution = rhs / diagonal`, row by row."""
    for i in range(diagonal.shape[0]):
        store(solution, i, (1.0 / at(diagonal, i)) * load(rhs, i, lanes), lanes)


@kernel
def add_ports(
    diagonal: Float,
    shape: Float,
    first: int,
    last: int,
    gain: Float,
    small: Float,
    small_rhs: Float,
    solution: Float,
    lanes: tuple[int, ...],
) -> None:
    """Turns `D⁻¹ b` into `(D + Σ_p gain_p h_p h_pᵀ)⁻¹ b` (Woodbury), for ports that touch many rows of a modal basis.

    Args:
        diagonal: D, (rows,).
        shape: the h_p, (.., rows); the ports are rows `first` to `last - 1`.
        first: first port.
        last: one past the last.
        gain: (ports,), >= 0.
        small: scratch (ports, ports).
        small_rhs: scratch (ports, width).
        solution: `D⁻¹ b` going in, (rows, width); the solution coming out.
        lanes: fixes the width.
    """
    ports, rows = last - first, shape.shape[1]
    # (I + √c G √c) y = √c Hx with G = H D⁻¹ Hᵀ is symmetric positive definite even where a gain is zero.
    for p in range(ports):
        root = np.sqrt(gain[p])
        for q in range(p + 1):
            product = 0.0
            for i in range(rows):
                product += shape[first + p, i] * shape[first + q, i] / diagonal[i]
            small[p, q] = root * np.sqrt(gain[q]) * product
        small[p, p] += 1.0
        reading = splat(0.0, lanes)
        for i in range(rows):
            reading = reading + shape[first + p, i] * load(solution, i, lanes)
        store(small_rhs, p, root * reading, lanes)
    for p in range(ports):  # Cholesky, in place in the lower triangle
        for q in range(p + 1):
            entry = small[p, q]
            for k in range(q):
                entry -= small[p, k] * small[q, k]
            small[p, q] = np.sqrt(entry) if p == q else entry / small[q, q]
    for p in range(ports):
        value = load(small_rhs, p, lanes)
        for k in range(p):
            value = value - small[p, k] * load(small_rhs, k, lanes)
        store(small_rhs, p, (1.0 / small[p, p]) * value, lanes)
    for back in range(ports):
        p = ports - 1 - back
        value = load(small_rhs, p, lanes)
        for k in range(p + 1, ports):
            value = value - small[k, p] * load(small_rhs, k, lanes)
        store(small_rhs, p, (1.0 / small[p, p]) * value, lanes)
    for i in range(rows):
        push = splat(0.0, lanes)
        for p in range(ports):
            push = push + (np.sqrt(gain[p]) * shape[first + p, i]) * load(small_rhs, p, lanes)
        store(solution, i, load(solution, i, lanes) - (1.0 / at(diagonal, i)) * push, lanes)
