"""Where a body would come too deep into itself within a step, what meets there moves as one, and the rest as it may."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import at, inner, load, part, splat, store
from cotouch.mechanics._meeting._bodies import Meeting
from cotouch.mechanics._meeting._near import FAR_SIDE
from cotouch.mechanics._meeting._world import World

# Points beside each other share rows: so often each is made one with its triangle.
_SWEEPS = 8


@part
def join_deep(world: World | None, mass: Float, mean: Float, lanes: tuple[int, ...]) -> bool:
    """Has each point that was weighed to come too deep move with the triangle that it is deep in; whether any was.

    Both keep their momentum, and the point its depth.

    Args:
        world: what the body meets, as it was weighed last; None: nothing.
        mass: of the rows, (rows,) [kg].
        mean: how they move, (rows, width); changed in place [m/s].
        lanes: fixes the width of a row.
    """
    if world is None:
        return False
    return _join_all(world, world.bodies, mass, mean, lanes)


@part
def _join_all(world: World, m: Meeting | None, mass: Float, mean: Float, lanes: tuple[int, ...]) -> bool:
    """`join_deep`; of arguments alone the compiler knows which are None."""
    if m is None:
        return False
    found = False
    for _ in range(_SWEEPS):
        for e in range(at(m.entries, 1)):
            if at(m.began, (e, 0)) > 0.0 and at(m.face, (e, 3)) == FAR_SIDE:
                found = True
                _join(world, m, e, mass, mean, lanes)
        if not found:
            break
    return found


@inner
def _join(world: World, m: Meeting, e: int, mass: Float, mean: Float, lanes: tuple[int, ...]) -> None:
    """Gives an entry's point and its triangle the velocity of their centre."""
    p, whole, momentum = at(m.point, e), 0.0, splat(0.0, lanes)
    for n in range(at(world.pointer, p), at(world.pointer, p + 1)):
        i = at(world.row, n)
        whole, momentum = whole + at(mass, i), momentum + at(mass, i) * load(mean, i, lanes)
    for q in range(3):
        v = at(m.corner, (at(m.face, (e, 2)), q))
        for n in range(at(m.pointer, v), at(m.pointer, v + 1)):
            i = at(m.row, n)
            whole, momentum = whole + at(mass, i), momentum + at(mass, i) * load(mean, i, lanes)
    rate = (1.0 / whole) * momentum
    for n in range(at(world.pointer, p), at(world.pointer, p + 1)):
        store(mean, at(world.row, n), rate, lanes)
    for q in range(3):
        v = at(m.corner, (at(m.face, (e, 2)), q))
        for n in range(at(m.pointer, v), at(m.pointer, v + 1)):
            store(mean, at(m.row, n), rate, lanes)
