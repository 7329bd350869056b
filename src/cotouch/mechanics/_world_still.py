"""What stays where it was: it holds at obstacles what it held, whatever is near."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.mechanics._kernel import part
from cotouch.mechanics._vector import at, put
from cotouch.mechanics._world import World


@part
def farthest(x: Float, ahead: Float) -> float:
    """At least as far as any row moves; 0 only where none does [m].

    Args:
        x: displacements of the rows before, (rows, width) [m].
        ahead: and after, likewise.
    """
    far = 0.0
    for i in range(x.shape[0]):
        way = 0.0
        for a in range(3):
            way += abs(at(ahead, (i, a)) - at(x, (i, a)))
        far = max(far, way)
    return far


@part
def stay(world: World, memory: Float) -> None:
    """Notes that nothing moved: stretches stay, and nobody pushes anybody anew.

    Args:
        world: obstacles and bodies; that nothing was done on these is noted already.
        memory: of the copy; what the step begins with becomes what it ends with.
    """
    count = world.told.shape[0]
    for n in range(4 * count):
        put(memory, world.first + 4 * count + n, at(memory, world.first + n))
    if world.offset >= 0:
        for n in range(count):
            put(memory, world.offset + count + n, at(memory, world.offset + n))
    if world.bodies is not None:
        for b in range(world.bodies.met.group.shape[0]):
            put(world.bodies.met.group, b, b)
        for n in range(4 * world.bodies.push.shape[0]):
            put(world.bodies.push, n, 0.0)
