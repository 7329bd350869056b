"""Whether spheres and closed surfaces stand clear of each other: how near they are, and on which side."""

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.body import Body, drawn_tools, winding

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
    near = nearest_places(corners, centre)
    best = int(np.argmin(np.linalg.norm(near - centre, axis=1)))
    nearest = near[best]
    side = -1.0 if winding(corners - centre) > 0.5 else 1.0
    normal = np.cross(corners[best, 1] - corners[best, 0], corners[best, 2] - corners[best, 0])
    away = centre - nearest
    distance = float(np.linalg.norm(away))
    depth = radius - side * distance
    if depth <= _SLACK * radius:
        return None
    way = side * away if distance > _SLACK * radius else normal
    return depth, nearest + way * (radius / np.linalg.norm(way))


def nearest_places(corners: Float, point: Float) -> Float:
    """Nearest place to a point on every triangle, (F, 3): on its face if the point stands over it, else on an edge.

    Args:
        corners: of the triangles, (F, 3, 3) [m].
        point: (3,) [m].
    """
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


def thickness(vertices: Float, triangles: Int) -> float:
    """How thick what a closed surface encloses is in the mean, twice its volume over its area; 0: it encloses nothing.

    Args:
        vertices: (V, 3) [m].
        triangles: (F, 3), turned outwards.
    """
    a, b, c = (vertices[triangles[:, corner]] - vertices.mean(axis=0) for corner in range(3))
    across = np.cross(b - a, c - a)
    area = 0.5 * float(np.linalg.norm(across, axis=1).sum())
    return max(float(np.einsum("fa,fa->", a, across)) / 3.0 / area, 0.0) if area > 0.0 else 0.0


# Places along each axis of what the boxes around two surfaces have in common.
_ALONG = 4


def overlap(one: tuple[Float, Int], two: tuple[Float, Int]) -> float:
    """How deep some place is in both of two closed surfaces, 0 where none was found [m].

    What the skins of both run through is found by their points; this finds one within another, or in the same place.

    Args:
        one: vertices (V, 3) [m] and triangles (F, 3), turned outwards.
        two: of the other.
    """
    low = np.maximum(one[0].min(axis=0), two[0].min(axis=0))
    high = np.minimum(one[0].max(axis=0), two[0].max(axis=0))
    if (low >= high).any():
        return 0.0
    at = (np.arange(_ALONG) + 0.5) / _ALONG
    grid = np.stack(np.meshgrid(at, at, at, indexing="ij"), axis=-1).reshape(-1, 3)
    places = low + grid * (high - low)
    surfaces = sorted((vertices[triangles] for vertices, triangles in (one, two)), key=len)
    for corners in surfaces:
        places = places[[winding(corners - place) > 0.5 for place in places]]
    return max((min(_distance(place, corners) for corners in surfaces) for place in places), default=0.0)


def _distance(place: Float, corners: Float) -> float:
    return float(np.linalg.norm(nearest_places(corners, place) - place, axis=1).min())
