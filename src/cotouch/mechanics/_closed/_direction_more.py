"""Whether a step takes more looks than usual: while what one left would change the end velocity."""

import math

from cotouch.kernels import inner
from cotouch.mechanics._closed._balance import ENERGY
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import State
from cotouch.mechanics._materials._force import BodyForce

# Looks at most.
MOST_LOOKS = 10
# What the next look would change, of the end velocity about the centre of mass, for which it is not taken; a look is
# taken to leave no less than that share of the one before: the first finds what the matrix knows well, so the second
# says too little of what it leaves.
LITTLE, SLOWEST = 5e-4, 0.1
# No more are taken for less than this share of what rounding of places does to the energy of a strained body.
_ROUNDED = 0.1


@inner
def rough(op: Operator, force: BodyForce, state: State) -> float:
    """Below which energy of the end velocity more looks are of no use [J].

    Args:
        op: the body's matrices.
        force: what resists inside the body.
        state: of the copy.
    """
    return _ROUNDED * op.firmness * (force.grain + 2.0 * math.sqrt(2.0 * force.grain * abs(state.memory[ENERGY])))


@inner
def leaves_little(change: float, before: float, moving: float, rounded: float) -> bool:
    """Whether what a look leaves would hardly change the end velocity.

    Each leaves about that share of the last one's change by which that was smaller than the one before.

    Args:
        change: square of what it changed of the rate, in the norm of M [J].
        before: the same of the look before.
        moving: of the end velocity about the centre of mass.
        rounded: see `rough`.
    """
    left = change * max(change, SLOWEST * SLOWEST * before) * moving
    return left <= before * max(LITTLE * LITTLE * moving * moving, rounded * rounded)
