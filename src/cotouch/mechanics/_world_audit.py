"""What obstacles hold of a copy and take from it, for whoever checks a ledger."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.mechanics._kernel import block
from cotouch.mechanics._world import World
from cotouch.mechanics._world_force import settle_world, take_up, weigh_world


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
