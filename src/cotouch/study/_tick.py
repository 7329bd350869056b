"""The worst that one tick of PSPM can do, so that its d² is seen to be reached where ordinary hands stay far below."""

from math import inf
from typing import NamedTuple

from cotouch.coupling import modulate, modulation_bound


class WorstTick(NamedTuple):
    """A hand that pulls along the held force for one tick.

    Attributes:
        taken: beyond what the coupling was given [J].
        after: share of the spring that is left at the next tick; 0: the debt has switched it off.
        bound: d² of this speed and period [J].
    """

    taken: float
    after: float
    bound: float


def worst_tick(*, stiffness: float, period: float, speed: float) -> WorstTick:
    """Gives a relaxed coupling what its spring needs to be stretched by one tick's way, then goes that way.

    The spring holds ½ k Δq² and pulls with k Δq; a hand that goes along by Δq while the force is held takes k Δq².

    Args:
        stiffness: k [N/m].
        period: of the servo [s].
        speed: of the hand [m/s].
    """
    step = speed * period
    given = 0.5 * stiffness * step**2
    fraction, tank, sent = modulate(0.5 * stiffness * (10.0 * step) ** 2, given, inf)
    work = stiffness * fraction * 10.0 * step * step
    left = fraction**2 * 0.5 * stiffness * (10.0 * step) ** 2 + tank - work
    after, _, _ = modulate(given, left, inf)
    bound = modulation_bound(stiffness=stiffness, damping=0.0, period=period, speed=speed)
    return WorstTick(work + sent - given, after, bound)
