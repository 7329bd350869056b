"""Ports that hold many rows, added to the solution of a step that is a closed form without them."""

import numpy as np

from cotouch.arrays import Float
from cotouch.kernels import at, inner, load, splat, store


@inner
def add_ports(
    diagonal: Float,
    shape: Float,
    gain: Float,
    small: Float,
    small_rhs: Float,
    solution: Float,
    lanes: tuple[int, ...],
) -> None:
    """Turns `D⁻¹ b` into `(D + Σ_p gain_p h_p h_pᵀ)⁻¹ b` (Woodbury), for ports that touch many rows of a modal basis.

    Args:
        diagonal: D, (rows,).
        shape: the h_p, (ports, rows).
        gain: (ports,), >= 0.
        small: scratch (ports, ports).
        small_rhs: scratch (ports, width).
        solution: `D⁻¹ b` going in, (rows, width); the solution coming out.
        lanes: fixes the width.
    """
    ports, rows = shape.shape[0], shape.shape[1]
    # (I + √c G √c) y = √c Hx with G = H D⁻¹ Hᵀ is symmetric positive definite even where a gain is zero.
    for p in range(ports):
        root = np.sqrt(gain[p])
        for q in range(p + 1):
            product = 0.0
            for i in range(rows):
                product += shape[p, i] * shape[q, i] / diagonal[i]
            small[p, q] = root * np.sqrt(gain[q]) * product
        small[p, p] += 1.0
        reading = splat(0.0, lanes)
        for i in range(rows):
            reading = reading + shape[p, i] * load(solution, i, lanes)
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
            push = push + (np.sqrt(gain[p]) * shape[p, i]) * load(small_rhs, p, lanes)
        store(solution, i, load(solution, i, lanes) - (1.0 / at(diagonal, i)) * push, lanes)
