"""A box with a round hole through it: a plate, or a block that something goes into."""

import math
from typing import NamedTuple

from cotouch.arrays import Float
from cotouch.errors import BodyError
from cotouch.kernels import at, inner
from cotouch.mechanics._shapes import _box as box
from cotouch.mechanics._shapes._plane import Vector3

_DIAGONAL = math.sqrt(0.5)


class Plate(NamedTuple):
    """A box with a round hole through it along its third side.

    Attributes:
        size: lengths of its sides, each > 0 [m].
        hole: its radius, > 0, where its axis is along the first two sides, from the centre, and how far its rims are
            cut off at 45° [m].
        centre: of the box [m].
        turn: as of a box [rad].
    """

    size: Vector3
    hole: tuple[float, float, float, float]
    centre: Vector3 = (0.0, 0.0, 0.0)
    turn: Vector3 = (0.0, 0.0, 0.0)

    def packed(self, origin: Vector3) -> list[float]:
        """What `depth` reads: as of a box, and the hole.

        Raises:
            BodyError: a side has no length, or the hole is not within the plate.
        """
        numbers = box.Box(self.size, self.centre, self.turn).packed(origin)
        radius, chamfer = self.hole[0], self.hole[3]
        if not (math.isfinite(sum(self.hole)) and radius > 0.0):
            raise BodyError(f"hole is {list(self.hole)}; its radius must be more than 0 m")
        if not 0.0 <= chamfer < 0.5 * self.size[2]:
            raise BodyError(f"chamfer is {chamfer:g}; it must be at least 0 m and less than half of {self.size[2]:g} m")
        if not self._wall() > 0.0:
            raise BodyError(
                f"hole is {list(self.hole)} in a plate of {list(self.size)}; it must lie within, with some wall around"
            )
        return [*numbers, *self.hole]

    def thickness(self) -> float:
        """The least way through it [m]."""
        return min(*self.size, self._wall())

    def _wall(self) -> float:
        """What is left beside the hole [m]."""
        beside = min(0.5 * side - abs(place) for side, place in zip(self.size[:2], self.hole[1:3], strict=True))
        return beside - self.hole[0] - self.hole[3]


@inner
def _radial(numbers: Float, s: int, x: float, y: float, z: float) -> tuple[float, float, float, float]:
    """How deep a point is behind the wall of the hole or its cut rims, and the unit vector out of it."""
    px, py, pz = x - at(numbers, (s, 0)), y - at(numbers, (s, 1)), z - at(numbers, (s, 2))
    ux, uy, uz = at(numbers, (s, 6)), at(numbers, (s, 7)), at(numbers, (s, 8))
    vx, vy, vz = at(numbers, (s, 9)), at(numbers, (s, 10)), at(numbers, (s, 11))
    a = ux * px + uy * py + uz * pz - at(numbers, (s, 16))
    b = vx * px + vy * py + vz * pz - at(numbers, (s, 17))
    far = math.sqrt(a * a + b * b)
    if far > 0.0:
        a, b = -a / far, -b / far
    nx, ny, nz = a * ux + b * vx, a * uy + b * vy, a * uz + b * vz
    deep = far - at(numbers, (s, 15))
    wx, wy, wz = at(numbers, (s, 12)), at(numbers, (s, 13)), at(numbers, (s, 14))
    along = wx * px + wy * py + wz * pz
    cut = deep - (abs(along) - at(numbers, (s, 5)) + at(numbers, (s, 18)))
    if at(numbers, (s, 18)) > 0.0 and cut * _DIAGONAL < deep:
        up = _DIAGONAL if along > 0.0 else -_DIAGONAL
        nx, ny, nz = _DIAGONAL * nx + up * wx, _DIAGONAL * ny + up * wy, _DIAGONAL * nz + up * wz
        return cut * _DIAGONAL, nx, ny, nz
    return deep, nx, ny, nz


@inner
def depth(numbers: Float, s: int, x: float, y: float, z: float) -> tuple[float, float, float, float, int]:
    """See `cotouch.mechanics._shapes._shape.depth`. Faces are those of the box; the wall of the hole is none, -1.

    Args:
        numbers: of all shapes, (shapes, NUMBERS).
        s: which of them.
        x: of the point [m].
        y: likewise.
        z: likewise.
    """
    deep, nx, ny, nz, face = box.depth(numbers, s, x, y, z)
    wall, rx, ry, rz = _radial(numbers, s, x, y, z)
    if wall < deep:
        return wall, rx, ry, rz, -1
    return deep, nx, ny, nz, face


@inner
def through(numbers: Float, s: int, x: float, y: float, z: float, mx: float, my: float, mz: float) -> bool:
    """Whether a point that moves by m is in the hole, or in line with it, at the start and at the end.

    Args:
        numbers: of all shapes, (shapes, NUMBERS).
        s: which of them.
        x: of the point at the start [m].
        y: likewise.
        z: likewise.
        mx: how far it moves [m].
        my: likewise.
        mz: likewise.
    """
    begin, _, _, _ = _radial(numbers, s, x, y, z)
    end, _, _, _ = _radial(numbers, s, x + mx, y + my, z + mz)
    return begin <= 0.0 and end <= 0.0
