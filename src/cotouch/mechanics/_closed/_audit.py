"""What a body's inner forces and obstacles hold of a copy and take from it, for whoever checks a ledger."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import block
from cotouch.mechanics._materials._force import BodyForce, evaluate
from cotouch.mechanics._meeting._world import World
from cotouch.mechanics._meeting._world_force import settle_world, take_up, weigh_world

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


@block
def begin_world(world: World, memory: Float, x: Float) -> float:
    """What obstacles hold of a copy without friction, where it is, for whoever checks a ledger [J].

    Args:
        world: obstacles and points.
        memory: (numbers,); its friction is forgotten.
        x: displacements of the rows, (rows, width) [m].
    """
    return settle_world(world, memory, x)


@block
def follow_world(world: World, memory: Float, x: Float, ahead: Float, T: float) -> tuple[float, float]:
    """What obstacles hold after a step and lost in it, for whoever checks a ledger.

    Args:
        world: obstacles and points.
        memory: (numbers,), as the step before left it; gets what this one leaves.
        x: displacements of the rows before, (rows, width) [m].
        ahead: and after, likewise.
        T: how long it took [s].

    Returns:
        Energy held and energy lost [J], of the whole body.
    """
    take_up(world, memory, x)
    energy, lost, _ = weigh_world(world, memory, x, ahead, T)
    return energy, lost
