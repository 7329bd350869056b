"""A box, turned as one likes."""

import math
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import BodyError
from cotouch.kernels import at, inner
from cotouch.mechanics._shapes._plane import Vector3


class Box(NamedTuple):
    """A box.

    Attributes:
        centre: of it [m].
        size: lengths of its sides, each > 0 [m].
        turn: how it is turned about its centre: along the axis of turning, as long as the angle [rad].
    """

    size: Vector3
    centre: Vector3 = (0.0, 0.0, 0.0)
    turn: Vector3 = (0.0, 0.0, 0.0)

    def packed(self, origin: Vector3) -> list[float]:
        """What `depth` reads: centre, seen from an origin, half sides and the directions of the sides.

        Raises:
            BodyError: a side has no length.
        """
        if not all(math.isfinite(side) and side > 0.0 for side in self.size):
            raise BodyError(f"size is {list(self.size)}; it must be three lengths above 0 m")
        centre = [c - o for c, o in zip(self.centre, origin, strict=True)]
        return [*centre, *(0.5 * side for side in self.size), *_rotation(self.turn).T.ravel().tolist()]

    def thickness(self) -> float:
        """The least way through it [m]."""
        return min(self.size)


def _rotation(turn: Vector3) -> Float:
    """Rodrigues' formula."""
    angle = math.sqrt(sum(a * a for a in turn))
    if angle == 0.0:
        return np.eye(3)
    x, y, z = (a / angle for a in turn)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross


@inner
def depth(numbers: Float, s: int, x: float, y: float, z: float) -> tuple[float, float, float, float, int]:
    """See `cotouch.mechanics._shapes._shape.depth`. Faces are 0 to 5; beside an edge or a corner there is none, -1.

    Args:
        numbers: of all shapes, (shapes, NUMBERS).
        s: which of them.
        x: of the point [m].
        y: likewise.
        z: likewise.
    """
    px, py, pz = x - at(numbers, (s, 0)), y - at(numbers, (s, 1)), z - at(numbers, (s, 2))
    best, face, sign, square, beyond = -math.inf, -1, 1.0, 0.0, 0
    for a in range(3):
        along = at(numbers, (s, 6 + 3 * a)) * px + at(numbers, (s, 7 + 3 * a)) * py + at(numbers, (s, 8 + 3 * a)) * pz
        over = abs(along) - at(numbers, (s, 3 + a))
        if over > 0.0:
            square += over * over
            beyond += 1
        if over > best:
            best, sign = over, 1.0 if along >= 0.0 else -1.0
            face = 2 * a + (1 if along < 0.0 else 0)
    a = face // 2
    nx, ny, nz = (
        sign * at(numbers, (s, 6 + 3 * a)),
        sign * at(numbers, (s, 7 + 3 * a)),
        sign * at(numbers, (s, 8 + 3 * a)),
    )
    if beyond > 1:
        return -math.sqrt(square), nx, ny, nz, -1
    return -best, nx, ny, nz, face


@inner
def crosses(numbers: Float, s: int, x: float, y: float, z: float, mx: float, my: float, mz: float) -> tuple[int, int]:
    """Through which faces a point that moves by m comes in and goes out; -1: it was inside, or stays there or outside.

    Args:
        numbers: of all shapes.
        s: this one.
        x: where it starts.
        y: likewise.
        z: likewise.
        mx: how far it moves.
        my: likewise.
        mz: likewise.

    Returns:
        The two faces; (-2, -2) where it does not meet the box.
    """
    px, py, pz = x - at(numbers, (s, 0)), y - at(numbers, (s, 1)), z - at(numbers, (s, 2))
    begin, end, enters, leaves = 0.0, 1.0, -1, -1
    for a in range(3):
        ux, uy, uz = at(numbers, (s, 6 + 3 * a)), at(numbers, (s, 7 + 3 * a)), at(numbers, (s, 8 + 3 * a))
        along, way, half = ux * px + uy * py + uz * pz, ux * mx + uy * my + uz * mz, at(numbers, (s, 3 + a))
        if way == 0.0:
            if abs(along) > half:
                return -2, -2
            continue
        first, last = (-half - along) / way, (half - along) / way
        near, far = (2 * a + 1, 2 * a) if way > 0.0 else (2 * a, 2 * a + 1)
        if way < 0.0:
            first, last = last, first
        if first > begin:
            begin, enters = first, near
        if last < end:
            end, leaves = last, far
    return (enters, leaves) if begin < end else (-2, -2)
