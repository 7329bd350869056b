"""What acts on a modal body at single points, all together: hands and grasps, in a basis where each moves every row."""
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float
from cotouch.mechanics._kernel import part
from cotouch.mechanics._vector import load, splat, store


class ModalPorts(NamedTuple):
    """Scratch for `A = D + Σ c_p h_p h_pᵀ`.

    Attributes:
        shape: the h_p, (ports, rows).
        gain: √c_p, (ports,).
        factor: Cholesky factor of `I + √c H D⁻¹ Hᵀ √c`, (ports, ports).
        reading: scratch (ports, 4).
    """

    shape: Float
    gain: Float
    factor: Float
    reading: Float


def ports_of(count: int, rows: int) -> ModalPorts:
    """Room for so many ports."""
    return ModalPorts(
        shape=np.zeros((count, rows)),
        gain=np.zeros(count),
        factor=np.zeros((count, count)),
        reading=np.zeros((count, 4)),
    )


@part
def factorise(matrix: Float, size: int) -> None:
    """Cholesky factor in the lower triangle, in place.

    A pivot that is lost, as in a matrix worked out by a solver that stopped too early, is made small and positive.
    """
    for p in range(size):
        least = 1e-12 * matrix[p, p]
        for q in range(p + 1):
            entry = matrix[p, q]
            for k in range(q):
                entry -= matrix[p, k] * matrix[q, k]
            if p == q and entry < least:
                entry = least
            matrix[p, q] = math.sqrt(entry) if p == q else entry / matrix[q, q]


@part
def factorise_ports(ports: ModalPorts, count: int, diagonal: Float) -> None:
    """Works out `factor` for the first `count` ports."""
    for p in range(count):
        for q in range(p + 1):
            product = 0.0
            for i in range(diagonal.shape[0]):
                product += ports.shape[p, i] * ports.shape[q, i] / diagonal[i]
            ports.factor[p, q] = ports.gain[p] * ports.gain[q] * product + (1.0 if q == p else 0.0)
    factorise(ports.factor, count)


@part
def correct(ports: ModalPorts, count: int, diagonal: Float, field: Float, lanes: tuple[int, ...]) -> None:
    """Turns `D⁻¹ b` into `(D + Σ c_p h_p h_pᵀ)⁻¹ b` (Woodbury)."""
    rows, factor, reading = field.shape[0], ports.factor, ports.reading
    for p in range(count):
        value = splat(0.0, lanes)
        for i in range(rows):
            value = value + ports.shape[p, i] * load(field, i, lanes)
        value = ports.gain[p] * value
        for k in range(p):
            value = value - factor[p, k] * load(reading, k, lanes)
        store(reading, p, (1.0 / factor[p, p]) * value, lanes)
    for back in range(count):
        p = count - 1 - back
        value = load(reading, p, lanes)
        for k in range(p + 1, count):
            value = value - factor[k, p] * load(reading, k, lanes)
        store(reading, p, (1.0 / factor[p, p]) * value, lanes)
    if count > 0:
        for i in range(rows):
            push = splat(0.0, lanes)
            for p in range(count):
                push = push + (ports.gain[p] * ports.shape[p, i]) * load(reading, p, lanes)
            store(field, i, load(field, i, lanes) - (1.0 / diagonal[i]) * push, lanes)
