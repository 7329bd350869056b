"""How handles are turned: unit quaternions xyzw."""

import math
from collections.abc import Sequence

from cotouch.arrays import Float
from cotouch.haptics._safety import Vector

Quaternion = tuple[float, float, float, float]
# By how much the square of an orientation's length may be off one.
_UNIT = 2e-3
UNTURNED: Quaternion = (0.0, 0.0, 0.0, 1.0)


def product(a: Quaternion, b: Quaternion) -> Quaternion:
    """The rotation b followed by the rotation a, normalised.

    Args:
        a: what comes second.
        b: what comes first.
    """
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    x = aw * bx + ax * bw + ay * bz - az * by
    y = aw * by - ax * bz + ay * bw + az * bx
    z = aw * bz + ax * by - ay * bx + az * bw
    w = aw * bw - ax * bx - ay * by - az * bz
    scale = 1.0 / math.sqrt(x * x + y * y + z * z + w * w)
    return scale * x, scale * y, scale * z, scale * w


def back(a: Quaternion) -> Quaternion:
    """The inverse of a rotation."""
    x, y, z, w = a
    return -x, -y, -z, w


def turn_of(vector: Sequence[float]) -> Quaternion:
    """The rotation of a rotation vector, whose length is the angle [rad]."""
    x, y, z = vector
    angle = math.sqrt(x * x + y * y + z * z)
    scale = math.sin(0.5 * angle) / angle if angle > 0.0 else 0.5
    return scale * x, scale * y, scale * z, math.cos(0.5 * angle)


def vector_of(a: Quaternion) -> list[float]:
    """The rotation vector of the shortest rotation; its length is the angle [rad]."""
    x, y, z, w = a
    sine = math.sqrt(x * x + y * y + z * z)
    scale = 2.0 * math.atan2(sine, abs(w)) / sine if sine > 0.0 else 2.0
    scale = math.copysign(scale, w)
    return [scale * x, scale * y, scale * z]


def quaternion(given: Sequence[float] | Float | None) -> Quaternion | None:
    """As it is handed on: a unit quaternion xyzw; None where it is none.

    Args:
        given: (4,), or None.
    """
    if given is None:
        return None
    x, y, z, w = (float(value) for value in given)
    return (x, y, z, w) if abs(x * x + y * y + z * z + w * w - 1.0) < _UNIT else None


def way_back(goal: Quaternion, here: Quaternion) -> Vector:
    """Along the axis of the shortest turn from here to a goal, as long as its angle θ, but π - θ beyond a quarter turn.

    So it is steady however both are turned: at half a turn, where the axis changes its sign, it is 0.

    Args:
        goal: how it is to be turned.
        here: how it is turned.
    """
    x, y, z = vector_of(product(goal, back(here)))
    angle = math.sqrt(x * x + y * y + z * z)
    part = 1.0 if angle <= 0.5 * math.pi else math.pi / angle - 1.0
    return part * x, part * y, part * z
