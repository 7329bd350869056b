"""What a body's inner forces hold, for whoever checks a ledger."""

from cotouch.arrays import Float
from cotouch.mechanics._force import BodyForce, evaluate
from cotouch.mechanics._kernel import block

# Sweeps of the rotations from nowhere.
_MANY = 60


@block
def inner_energy(
    force: BodyForce, memory: Float, x: Float, ahead: Float, rate: Float, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy of a body's inner forces at a place, and the power of its dampers, for whoever checks a ledger.

    Args:
        force: what resists inside.
        memory: rotations to begin with, (numbers,); gets those that were found.
        x: where the step began, displacements from rest, (rows, width) [m].
        ahead: the place, likewise.
        rate: mean velocity from the one to the other, likewise [m/s].
        lanes: fixes the width.

    Returns:
        Energy at `ahead` [J] and power over the step [W], of the whole body.
    """
    return evaluate(force.law, memory, x, ahead, rate, _MANY, lanes)
