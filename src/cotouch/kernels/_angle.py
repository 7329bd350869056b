"""Angles of four vectors in a plane at once."""

import math

from cotouch.kernels._kernel import inner
from cotouch.kernels._vector import FOUR, lower, size, splat, upper, where

_SIXTEENTH, _THREE, _EIGHTH = math.tan(math.pi / 16.0), math.tan(3.0 * math.pi / 16.0), math.tan(math.pi / 8.0)
# Of the series of the arcus tangent as far as it matters up to a sixteenth of half a turn, the last term first.
_SERIES = tuple((-1.0) ** n / (2 * n + 1) for n in range(11, -1, -1))
_TINY = 1e-300


@inner
def angles(x: float, y: float) -> float:
    """Angles from the first axis to four vectors, in [-π, π], to rounding; 0 where a vector is 0.

    Each is mirrored into the first eighth of a turn, and turned by 0, 1/16 or 1/8 of a turn to where the series is
    short.

    Args:
        x: first coordinates, four.
        y: second ones.
    """
    wide, high = size(x), size(y)
    long, short = upper(upper(wide, high), splat(_TINY, FOUR)), lower(wide, high)
    near, far = short - _SIXTEENTH * long, short - _THREE * long
    slope = where(far, 1.0, where(near, splat(_EIGHTH, FOUR), 0.0))
    t = (short - slope * long) / (long + slope * short)
    square = t * t
    series = splat(_SERIES[0], FOUR)
    for n in range(1, 12):
        series = series * square + _SERIES[n]
    angle = where(far, 0.25 * math.pi, where(near, splat(0.125 * math.pi, FOUR), 0.0)) + t * series
    angle = where(high - wide, 0.5 * math.pi - angle, angle)
    angle = where(0.0 - x, math.pi - angle, angle)
    return where(0.0 - y, 0.0 - angle, angle)
