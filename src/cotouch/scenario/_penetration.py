"""Whether a sphere stands clear of a body: how near its skin is, and on which side."""

import numpy as np

from cotouch.arrays import Float
from cotouch.body import Body, drawn_tools

# Share of a sphere's radius that rounding in a scenario may cost.
_SLACK = 1e-6


def resolve_penetration(
    body: Body, displacement: Float, centre: Float, radius: float, user: int
) -> tuple[float, Float] | None:
    """Where a sphere would just touch a body from outside, if it reaches into its skin.

    Args:
        body: with a skin.
        displacement: of its nodes, (n, 3) [m].
        centre: of the sphere, (3,) [m].
        radius: [m].
        user: in whose copy, from 0; tools of others are not in it.

    Returns:
        How far the sphere reaches into the body [m] and the nearest place where it does not, (3,); None if it is clear.
    """
    skin = body.skin
    assert skin is not None
    there = np.ones(skin.vertices.shape[0], dtype=np.bool_)
    for first, last, owner in drawn_tools(body):
        there[first:last] = owner == user
    corners = (skin.vertices + skin.carried(displacement))[skin.triangles[there[skin.triangles[:, 0]]]]
    near = _nearest(corners, centre)
    best = int(np.argmin(np.linalg.norm(near - centre, axis=1)))
    nearest = near[best]
    side = -1.0 if _winding(corners - centre) > 0.5 else 1.0
    normal = np.cross(corners[best, 1] - corners[best, 0], corners[best, 2] - corners[best, 0])
    away = centre - nearest
    distance = float(np.linalg.norm(away))
    depth = radius - side * distance
    if depth <= _SLACK * radius:
        return None
    way = side * away if distance > _SLACK * radius else normal
    return depth, nearest + way * (radius / np.linalg.norm(way))


def _nearest(corners: Float, point: Float) -> Float:
    """Nearest place to a point on every triangle, (F, 3): on its face if the point stands over it, else on an edge."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    best = a.copy()
    least = np.full(a.shape[0], np.inf)
    for start, end in ((a, b), (b, c), (c, a)):
        way = end - start
        fraction = ((point - start) * way).sum(axis=1) / np.maximum((way * way).sum(axis=1), np.finfo(np.float64).tiny)
        place = start + np.clip(fraction, 0.0, 1.0)[:, None] * way
        square = ((point - place) ** 2).sum(axis=1)
        closer = square < least
        best[closer], least[closer] = place[closer], square[closer]
    normal = np.cross(b - a, c - a)
    size = (normal * normal).sum(axis=1)
    over = size > 0.0
    for start, end in ((a, b), (b, c), (c, a)):
        over &= (np.cross(end - start, point - start) * normal).sum(axis=1) >= 0.0
    height = ((point - a) * normal).sum(axis=1)
    best[over] = point - (height[over] / size[over])[:, None] * normal[over]
    return best


def _winding(corners: Float) -> float:
    """How often the triangles go around the origin: 1 inside a closed surface, 0 outside [van Oosterom & Strackee]."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    x, y, z = (np.linalg.norm(side, axis=1) for side in (a, b, c))
    volume = (a * np.cross(b, c)).sum(axis=1)
    around = x * y * z + (a * b).sum(axis=1) * z + (b * c).sum(axis=1) * x + (c * a).sum(axis=1) * y
    return float(np.arctan2(volume, around).sum() / (2.0 * np.pi))
