"""What a closed surface of triangles encloses, met like another body that does not move."""

from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float, Int
from cotouch.errors import BodyError


@final
class Solid:
    """What a closed surface encloses.

    Unlike other shapes it has no `depth`: points of bodies look for its nearest triangle, as for that of a body.

    Args:
        vertices: (V, 3) [m].
        triangles: indices of vertices, counter-clockwise seen from outside, (F, 3).

    Raises:
        BodyError: they are no closed surface that is turned outwards.
    """

    def __init__(self, vertices: npt.ArrayLike, triangles: npt.ArrayLike) -> None:
        self.vertices: Float = np.array(vertices, dtype=np.float64).reshape(-1, 3)
        self.triangles: Int = np.array(triangles, dtype=np.int32).reshape(-1, 3)
        corners = self.triangles
        if not np.isfinite(self.vertices).all() or not corners.size or corners.min() < 0:
            raise BodyError("a solid must have triangles between vertices at finite places")
        if corners.max() >= self.vertices.shape[0]:
            raise BodyError(f"a solid's triangle names vertex {corners.max()}; there are {self.vertices.shape[0]}")
        sides = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
        one, two = (np.unique(ends, axis=0, return_counts=True) for ends in (sides, sides[:, ::-1]))
        a, b, c = (self.vertices[corners[:, k]] for k in range(3))
        volume = float(np.einsum("fa,fa->", a, np.cross(b, c))) / 6.0
        if not (np.array_equal(one[0], two[0]) and np.array_equal(one[1], two[1]) and volume > 0.0):
            raise BodyError("the triangles of a solid must be a closed surface that is turned outwards")
        for array in (self.vertices, self.triangles):
            array.setflags(write=False)
