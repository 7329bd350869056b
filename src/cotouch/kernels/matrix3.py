"""Matrices of three by three as tuples of nine numbers, row by row.

A "number" may be a machine vector: all of this then works on four matrices at once.
"""

from typing import TypeAlias

from cotouch.kernels._kernel import inner
from cotouch.kernels._vector import lower, size, where

Matrix: TypeAlias = tuple[float, float, float, float, float, float, float, float, float]
Vector: TypeAlias = tuple[float, float, float]

IDENTITY = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
# A solve is trusted down to this determinant beside the cube of the matrix's size.
_FLAT = 1e-12


@inner
def product(a: Matrix, b: Matrix) -> Matrix:
    """`A B`.

    Args:
        a: A, row by row.
        b: B likewise.
    """
    return (
        a[0] * b[0] + a[1] * b[3] + a[2] * b[6],
        a[0] * b[1] + a[1] * b[4] + a[2] * b[7],
        a[0] * b[2] + a[1] * b[5] + a[2] * b[8],
        a[3] * b[0] + a[4] * b[3] + a[5] * b[6],
        a[3] * b[1] + a[4] * b[4] + a[5] * b[7],
        a[3] * b[2] + a[4] * b[5] + a[5] * b[8],
        a[6] * b[0] + a[7] * b[3] + a[8] * b[6],
        a[6] * b[1] + a[7] * b[4] + a[8] * b[7],
        a[6] * b[2] + a[7] * b[5] + a[8] * b[8],
    )


@inner
def transpose(a: Matrix) -> Matrix:
    """`Aᵀ`."""
    return a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]


@inner
def transposed_product(a: Matrix, b: Matrix) -> Matrix:
    """`Aᵀ B`.

    Args:
        a: A, row by row.
        b: B likewise.
    """
    return product(transpose(a), b)


@inner
def symmetric(a: Matrix) -> Matrix:
    """`½ (A + Aᵀ)`."""
    xy, xz, yz = 0.5 * (a[1] + a[3]), 0.5 * (a[2] + a[6]), 0.5 * (a[5] + a[7])
    return a[0], xy, xz, xy, a[4], yz, xz, yz, a[8]


@inner
def mixture(p: float, a: Matrix, q: float, b: Matrix) -> Matrix:
    """`p A + q B`.

    Args:
        p: a number.
        a: A, row by row.
        q: a number.
        b: B likewise.
    """
    return (
        p * a[0] + q * b[0],
        p * a[1] + q * b[1],
        p * a[2] + q * b[2],
        p * a[3] + q * b[3],
        p * a[4] + q * b[4],
        p * a[5] + q * b[5],
        p * a[6] + q * b[6],
        p * a[7] + q * b[7],
        p * a[8] + q * b[8],
    )


@inner
def diagonal(a: Matrix, q: float) -> Matrix:
    """`A + q I`.

    Args:
        a: A, row by row.
        q: a number.
    """
    return a[0] + q, a[1], a[2], a[3], a[4] + q, a[5], a[6], a[7], a[8] + q


@inner
def scaled(p: float, a: Matrix) -> Matrix:
    """`p A`.

    Args:
        p: a number.
        a: A, row by row.
    """
    return p * a[0], p * a[1], p * a[2], p * a[3], p * a[4], p * a[5], p * a[6], p * a[7], p * a[8]


@inner
def contraction(a: Matrix, b: Matrix) -> float:
    """`A : B`.

    Args:
        a: A, row by row.
        b: B likewise.
    """
    return (
        (a[0] * b[0] + a[1] * b[1] + a[2] * b[2])
        + (a[3] * b[3] + a[4] * b[4] + a[5] * b[5])
        + (a[6] * b[6] + a[7] * b[7] + a[8] * b[8])
    )


@inner
def cofactor(a: Matrix) -> Matrix:
    """The derivative of the determinant."""
    return (
        a[4] * a[8] - a[5] * a[7],
        a[5] * a[6] - a[3] * a[8],
        a[3] * a[7] - a[4] * a[6],
        a[2] * a[7] - a[1] * a[8],
        a[0] * a[8] - a[2] * a[6],
        a[1] * a[6] - a[0] * a[7],
        a[1] * a[5] - a[2] * a[4],
        a[2] * a[3] - a[0] * a[5],
        a[0] * a[4] - a[1] * a[3],
    )


@inner
def times(a: Matrix, b: Vector) -> Vector:
    """`A b`.

    Args:
        a: A, row by row.
        b: a vector.
    """
    return (
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
        a[3] * b[0] + a[4] * b[1] + a[5] * b[2],
        a[6] * b[0] + a[7] * b[1] + a[8] * b[2],
    )


@inner
def transposed_times(a: Matrix, b: Vector) -> Vector:
    """`Aᵀ b`.

    Args:
        a: A, row by row.
        b: a vector.
    """
    return (
        a[0] * b[0] + a[3] * b[1] + a[6] * b[2],
        a[1] * b[0] + a[4] * b[1] + a[7] * b[2],
        a[2] * b[0] + a[5] * b[1] + a[8] * b[2],
    )


@inner
def cross(a: Vector, b: Vector) -> Vector:
    """`a × b`.

    Args:
        a: a vector.
        b: likewise.
    """
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@inner
def solved(a: Matrix, b: Vector) -> Vector:
    """`A⁻¹ b` for a symmetric matrix; where A is singular or indefinite, `b` over twice its size: a safe step.

    Args:
        a: A, row by row, symmetric.
        b: a vector.
    """
    c = cofactor(a)
    determinant = a[0] * c[0] + a[1] * c[1] + a[2] * c[2]
    bulk = size(a[0]) + size(a[4]) + size(a[8])
    sound = lower(lower(determinant - _FLAT * bulk * bulk * bulk, c[0]), lower(a[0], c[8]))
    scale = 1.0 / determinant
    safe = where(bulk, 0.5 / bulk, 0.0)
    return (
        where(sound, scale * (c[0] * b[0] + c[3] * b[1] + c[6] * b[2]), safe * b[0]),
        where(sound, scale * (c[1] * b[0] + c[4] * b[1] + c[7] * b[2]), safe * b[1]),
        where(sound, scale * (c[2] * b[0] + c[5] * b[1] + c[8] * b[2]), safe * b[2]),
    )


@inner
def inertia(m: Matrix) -> Matrix:
    """`tr M · I - sym M`: how `tr RᵀS` falls as R turns away from its best, M = RᵀS."""
    trace = m[0] + m[4] + m[8]
    xy, xz, yz = -0.5 * (m[1] + m[3]), -0.5 * (m[2] + m[6]), -0.5 * (m[5] + m[7])
    return trace - m[0], xy, xz, xy, trace - m[4], yz, xz, yz, trace - m[8]
