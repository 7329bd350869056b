"""Elastic foundation that stiffens with depth: `ψ = ½ κ (1 + ε) w² / (1 + ε - 2 w / R)`, ε = 0.05.

Shallow, it is the foundation. On a flat it pushes with `2 π z ψ`, z the height of the middle and ψ at its foot: more
and more up to a depth of 0.75 R, with more than 4 k R there, which no device holds against. Without ε the energy would
have no bound, but could not be summed where the ball's middle lies in the plane of a triangle beside it.
"""

from math import pi
from typing import NamedTuple

from cotouch.kernels import inner
from cotouch.passing import by_address

_SOFTEST = 0.05
# κ π R² / k so that a flat pushes with k R / 10 at a depth of R / 10.
_SHARE = 0.1 / (0.9 * (1.0 + _SOFTEST) * (0.5 * (1.0 - 0.9**2)) ** 2 / (0.9**2 + _SOFTEST))


@by_address
class Stiffening(NamedTuple):
    """Parameters of the law.

    Attributes:
        hardness: factor on κ.
    """

    hardness: float = 1.0


@inner
def press(law: Stiffening, stiffness: float, radius: float, depth: float) -> tuple[float, float, float]:
    """Energy, pressure and slope; see `cotouch.mechanics.CONTACT_LAWS`.

    Args:
        law: its numbers.
        stiffness: k of the tool, > 0 [N/m].
        radius: of the tool, > 0 [m].
        depth: of the skin in it, 0 to the radius [m].
    """
    modulus = (1.0 + _SOFTEST) * law.hardness * _SHARE * stiffness / (pi * radius * radius)
    share = 2.0 / radius * depth
    room = 1.0 / (1.0 + _SOFTEST - share)
    energy = 0.5 * modulus * depth * depth * room
    pressure = modulus * depth * room * (1.0 + 0.5 * share * room)
    return energy, pressure, modulus * room * (1.0 + share * room) ** 2
