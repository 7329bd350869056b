"""How a body of point masses turns, beside the solid that it stands for."""

import numpy as np

from cotouch.arrays import Float, Long


def inertia_excess(vertices: Float, triangles: Long, rest: Float, shares: Float) -> float:
    """By how much the moments of inertia of masses at nodes exceed those of the solid, at most, as a share.

    Args:
        vertices: of the closed surface, (vertices, 3) [m].
        triangles: of it, seen from outside, (triangles, 3).
        rest: places of the nodes, (n, 3) [m].
        shares: of the mass that nodes have, in any unit, (n,).
    """
    middle = rest.mean(axis=0)
    volume, first, second = sums_of(vertices[triangles] - middle)
    solid = _moments(volume, first, second / 120.0)
    places = rest - middle
    nodes = _moments(float(shares.sum()), shares @ places, np.einsum("n,ni,nj->ij", shares, places, places))
    return float((nodes / solid).max()) - 1.0


def sums_of(corners: Float) -> tuple[float, Float, Float]:
    """Of a solid its volume V [m³], `∫ r` [m⁴] and 120 times `∫ r rᵀ` [m⁵].

    Args:
        corners: of the triangles of its closed surface, seen from outside, (triangles, 3, 3) [m].
    """
    six = np.linalg.det(corners)  # volume of the tetrahedron to the middle, times 6
    total = corners.sum(axis=1)
    second = np.einsum("t,ti,tj->ij", six, total, total) + np.einsum("t,tci,tcj->ij", six, corners, corners)
    return float(six.sum()) / 6.0, six @ total / 24.0, second


def _moments(mass: float, first: Float, second: Float) -> Float:
    """Moments about the centre for a mass of 1, ascending, from the sums of m, m r and m r rᵀ."""
    centre = first / mass
    spread = second / mass - np.outer(centre, centre)
    moments: Float = np.linalg.eigvalsh(np.trace(spread) * np.eye(3) - spread).astype(np.float64)
    return moments
