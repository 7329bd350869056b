"""How deep a point of the skin was where a cut brought it, or what it lies in, to light; see `_world_cut`."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import at, inner, put
from cotouch.mechanics._meeting._world import World


@inner
def offset_of(world: World, memory: Float, n: int) -> float:
    """From which depth on a point meets something [m].

    Args:
        world: obstacles and points.
        memory: of the copy, (numbers,).
        n: which obstacle and point, as in `told`.
    """
    return at(memory, world.offset + n) if world.offset >= 0 else 0.0


@inner
def follow_offset(world: World, memory: Float, n: int, deep: float) -> None:
    """Lets an offset shrink with the depth at the end of a step.

    Args:
        world: obstacles and points.
        memory: of the copy, in place.
        n: which obstacle and point, as in `told`.
        deep: that depth [m].
    """
    if world.offset >= 0:
        kept = world.offset + world.told.shape[0] + n
        put(memory, kept, min(at(memory, world.offset + n), max(deep, 0.0)))
