"""A half-space below a plane."""

from math import isfinite, sqrt
from typing import NamedTuple

from cotouch.arrays import Float
from cotouch.errors import BodyError
from cotouch.kernels import at, inner

Vector3 = tuple[float, float, float]


class Plane(NamedTuple):
    """Everything below a plane.

    Attributes:
        point: of the plane [m].
        normal: out of it, of any length.
    """

    point: Vector3 = (0.0, 0.0, 0.0)
    normal: Vector3 = (0.0, 0.0, 1.0)

    def packed(self, origin: Vector3) -> list[float]:
        """What `depth` reads: unit normal, and how high the plane is along it, seen from an origin.

        Raises:
            BodyError: the normal has no direction.
        """
        size = sqrt(sum(a * a for a in self.normal))
        if not (isfinite(size) and size > 0.0):
            raise BodyError(f"normal is {list(self.normal)}; it must be three finite numbers, not all 0")
        unit = [a / size for a in self.normal]
        return [*unit, sum(n * (p - o) for n, p, o in zip(unit, self.point, origin, strict=True))]

    def thickness(self) -> float:
        """The least way through it [m]."""
        return float("inf")


@inner
def depth(numbers: Float, s: int, x: float, y: float, z: float) -> tuple[float, float, float, float, int]:
    """See `cotouch.mechanics._shapes._shape.depth`.

    Args:
        numbers: of all shapes, (shapes, NUMBERS).
        s: which of them.
        x: of the point [m].
        y: likewise.
        z: likewise.
    """
    a, b, c = at(numbers, (s, 0)), at(numbers, (s, 1)), at(numbers, (s, 2))
    return at(numbers, (s, 3)) - (a * x + b * y + c * z), a, b, c, 0
