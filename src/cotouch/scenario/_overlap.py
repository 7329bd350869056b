"""Whether two closed surfaces enclose a place in common, also where no point of the one is deep in the other."""

import math

import numpy as np

from cotouch.arrays import Bool, Float, Int

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
    for surface in sorted((one, two), key=lambda surface: surface[1].shape[0]):
        places = places[_inside(places, *surface)]
    return max((min(_distance(place, *one), _distance(place, *two)) for place in places), default=0.0)


def _inside(places: Float, vertices: Float, triangles: Int) -> Bool:
    """Whether each place is enclosed, by the solid angle of all triangles [Van Oosterom & Strackee 1983]."""
    result = np.zeros(places.shape[0], dtype=np.bool_)
    for k, place in enumerate(places):
        a, b, c = (vertices[triangles[:, corner]] - place for corner in range(3))
        x, y, z = (np.linalg.norm(side, axis=1) for side in (a, b, c))
        up = np.einsum("fa,fa->f", a, np.cross(b, c))
        along = x * y * z + z * np.einsum("fa,fa->f", a, b)
        along += y * np.einsum("fa,fa->f", a, c) + x * np.einsum("fa,fa->f", b, c)
        result[k] = float(np.arctan2(up, along).sum()) > math.pi
    return result


def _distance(place: Float, vertices: Float, triangles: Int) -> float:
    """From a place to the nearest plane side, edge or corner of some triangles [m]."""
    a, b, c = (vertices[triangles[:, corner]] for corner in range(3))
    normal = np.cross(b - a, c - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    height = np.einsum("fa,fa->f", place - a, normal)
    foot = place - height[:, None] * normal
    beyond = np.zeros(height.size)
    best = np.full(height.size, np.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        beyond = np.maximum(beyond, np.einsum("fa,fa->f", np.cross(normal, q - p), p - foot))
        way = q - p
        share = np.einsum("fa,fa->f", place - p, way) / np.maximum(np.einsum("fa,fa->f", way, way), 1e-300)
        best = np.minimum(best, np.linalg.norm(place - p - np.clip(share, 0.0, 1.0)[:, None] * way, axis=1))
    return float(np.where(beyond <= 0.0, np.abs(height), best).min())
