"""Elastic foundation: `ψ = ½ κ w²`, each point of the skin a spring of its own [Johnson 1985, section 4.3].

On a flat it pushes with `κ π z (R² - z²)² / (4 R²)`, z the height of the middle: with `κ π R h²` where it is shallow.
Beyond a depth of 0.55 R it gives way.
"""

from math import pi
from typing import NamedTuple

from cotouch.kernels import inner

# κ π R² / k so that a flat pushes with k R / 10 at a depth of R / 10.
_SHARE = 0.1 / (0.25 * 0.9 * (1.0 - 0.9**2) ** 2)


class Foundation(NamedTuple):
    """Parameters of the law.

    Attributes:
        hardness: factor on κ.
    """

    hardness: float = 1.0


@inner
def stiffness_of(modulus: float, radius: float) -> float:
    """The `stiffness` with which the foundation of a tool has a modulus κ, without a factor on it [N/m].

    Args:
        modulus: κ [N/m³].
        radius: of the ball [m].
    """
    return modulus * pi * radius * radius / _SHARE


@inner
def press(law: Foundation, stiffness: float, radius: float, depth: float) -> tuple[float, float, float]:
    """Energy, pressure and slope; see `cotouch.mechanics.CONTACT_LAWS`.

    Args:
        law: its numbers.
        stiffness: k of the tool, > 0 [N/m].
        radius: of the tool, > 0 [m].
        depth: of the skin in it, 0 to the radius [m].
    """
    modulus = law.hardness * _SHARE * stiffness / (pi * radius * radius)
    return 0.5 * modulus * depth * depth, modulus * depth, modulus
