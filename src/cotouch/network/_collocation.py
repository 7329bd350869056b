"""Chebyshev collocation of the delayed closed loop, for starting values of its roots.

Every user keeps its own past only as long as somebody still uses it, so short delays cost few unknowns.
"""

import numpy as np

from cotouch.arrays import Complex, Float


def generator_eigenvalues(
    inertia: Float, drag: Float, stiffness: Float, coupling: Float, delay: Float, *, order: int
) -> Complex:
    """Eigenvalues of the discretised generator of `m x'' + c x' + kappa x = sum_j K_ij x_j(t - d_ij)`.

    Args:
        inertia: (N,) kg.
        drag: (N,) Ns/m.
        stiffness: (N,) N/m, with what the links add.
        coupling: (N, N) N/m, 0 where not linked.
        delay: (N, N) s.
        order: degree of the polynomial over the longest delay; shorter ones take fewer.

    Returns:
        Sorted by real part, the largest first. Those near the origin are accurate, the others are not.
    """
    size = len(inertia)
    history = np.where(coupling > 0, delay, 0.0).max(axis=0, initial=0.0)
    longest = history.max(initial=0.0)
    degrees = [_degree(h, longest, order) for h in history]
    first = np.concatenate([[0], np.cumsum([degree + 1 for degree in degrees])])
    total = int(first[-1])
    matrix = np.zeros((total + size, total + size))
    for j, degree in enumerate(degrees):
        here = slice(int(first[j]), int(first[j + 1]))
        points, weights = _chebyshev(degree)
        if degree:
            # Points run from 1 (now) to -1 (the oldest sample anybody needs).
            matrix[here, here] = _differentiation(points, weights) * (2.0 / history[j])
        matrix[first[j]] = 0.0
        matrix[first[j], total + j] = 1.0
        for i in np.flatnonzero(coupling[:, j]):
            at = 1.0 - 2.0 * delay[i, j] / history[j] if degree else 1.0
            matrix[total + i, here] += coupling[i, j] / inertia[i] * _interpolation(points, weights, at)
        matrix[total + j, first[j]] -= stiffness[j] / inertia[j]
        matrix[total + j, total + j] -= drag[j] / inertia[j]
    roots = np.linalg.eigvals(matrix).astype(np.complex128)
    return roots[np.argsort(-roots.real)]


def _degree(history: float, longest: float, order: int) -> int:
    if history == 0.0:
        return 0
    return max(int(np.ceil(order * np.sqrt(history / longest))), 3)


def _chebyshev(degree: int) -> tuple[Float, Float]:
    """Chebyshev points of the second kind from 1 to -1, and their barycentric weights."""
    if degree == 0:
        return np.ones(1), np.ones(1)
    weights = (-1.0) ** np.arange(degree + 1)
    weights[[0, -1]] /= 2
    return np.cos(np.pi * np.arange(degree + 1) / degree), weights.astype(np.float64)


def _differentiation(points: Float, weights: Float) -> Float:
    apart = points[:, None] - points[None, :] + np.eye(len(points))
    matrix = weights[None, :] / weights[:, None] / apart
    np.fill_diagonal(matrix, 0.0)
    np.fill_diagonal(matrix, -matrix.sum(axis=1))
    return matrix


def _interpolation(points: Float, weights: Float, at: float) -> Float:
    apart = at - points
    hit = np.abs(apart) < 1e-14
    if hit.any():
        return hit.astype(np.float64)
    row = weights / apart
    return row / row.sum()
