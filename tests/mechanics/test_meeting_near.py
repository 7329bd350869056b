"""The nearest point of a triangle, beside all that could be it in more digits."""

from collections.abc import Callable

import numba
import numpy as np
import pytest
from tests.mechanics.inside import foot

from cotouch.arrays import Float

Made = Callable[[np.random.Generator], Float]


@numba.njit(error_model="numpy")
def nearest(corners: Float, x: float, y: float, z: float) -> tuple[float, float, float, float, bool]:
    """The kernel, as others call it."""
    return foot(corners, 0, 1, 2, x, y, z)


def any_triangle(rng: np.random.Generator) -> Float:
    return rng.normal(0.0, 1.0, (3, 3))


def obtuse(rng: np.random.Generator) -> Float:
    """Its corner lies a little beside the side opposite to it."""
    a, b = rng.normal(0.0, 1.0, (2, 3))
    c = a + rng.uniform(0.05, 0.95) * (b - a) + rng.normal(0.0, 10.0 ** rng.uniform(-3.0, -1.0), 3)
    return np.array([a, b, c])[rng.permutation(3)]


def sliver(rng: np.random.Generator) -> Float:
    """Its corner lies on the side opposite to it, but for rounding."""
    a, b = rng.normal(0.0, 1.0, (2, 3))
    c = a + rng.uniform(-0.5, 1.5) * (b - a) + rng.normal(0.0, 10.0 ** rng.uniform(-17.0, -6.0), 3)
    return np.array([a, b, c])[rng.permutation(3)]


def distance(corners: Float, point: Float) -> float:
    """The least of the distances to the sides, and to the plane where the point is above the triangle."""
    a, b, c, p = (np.longdouble(one) for one in (*corners, point))
    found = []
    for one, two in ((a, b), (a, c), (b, c)):
        side = two - one
        share = min(max((p - one) @ side / (side @ side), np.longdouble(0)), np.longdouble(1))
        found.append(p - one - share * side)
    u, v = b - a, c - a
    size = (u @ u) * (v @ v) - (u @ v) ** 2
    if size > 1e-24 * (u @ u) * (v @ v):
        x = ((v @ v) * (u @ (p - a)) - (u @ v) * (v @ (p - a))) / size
        y = ((u @ u) * (v @ (p - a)) - (u @ v) * (u @ (p - a))) / size
        if x >= 0 and y >= 0 and x + y <= 1:
            found.append(p - a - x * u - y * v)
    return float(min(np.sqrt(one @ one) for one in found))


@pytest.mark.parametrize("made", [any_triangle, obtuse, sliver])
def test_no_point_of_the_triangle_is_nearer(made: Made) -> None:
    rng = np.random.default_rng(0)
    for _ in range(1000):
        corners = made(rng)
        point = corners.mean(axis=0) + rng.normal(0.0, 10.0 ** rng.uniform(-2.0, 0.5), 3)
        square, a, b, c, _ = nearest(corners, *point.tolist())
        assert min(a, b, c) >= -1e-12
        assert a + b + c == pytest.approx(1.0, abs=1e-12)
        there = a * corners[0] + b * corners[1] + c * corners[2]
        assert np.sqrt(square) == pytest.approx(np.linalg.norm(point - there), rel=1e-9, abs=1e-12)
        assert np.sqrt(square) == pytest.approx(distance(corners, point), abs=2e-6)
