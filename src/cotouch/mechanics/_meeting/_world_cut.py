"""What a cut does to contact with the world and other bodies: parts of the skin go, and others come to light.

No cut may raise an energy. What comes to light within something, or has something within it, is therefore met from as
deep as it was then: contact acts beyond that offset, which shrinks as the point comes out and never grows again.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, block, inner, part, put
from cotouch.mechanics._meeting._asleep import doze, wake
from cotouch.mechanics._meeting._bodies import Meeting
from cotouch.mechanics._meeting._look import gather, point_at
from cotouch.mechanics._meeting._stretch import stretched_in
from cotouch.mechanics._meeting._world import World
from cotouch.mechanics._shapes._shape import depth


@block
def show(world: World) -> None:
    """Works out which share of each point is there, by the triangles that are not.

    Args:
        world: `hidden` is known; `there` is changed.
    """
    for p in range(world.moves):
        gone, there = 0.0, 0.0
        for n in range(at(world.pointer_of, p), at(world.pointer_of, p + 1)):
            if at(world.hidden, at(world.triangle, n)) != 0:
                gone += at(world.part_of, n)
            else:
                there += at(world.part_of, n)
        put(world.there, p, 1.0 - gone if there > 0.0 else 0.0)


@part
def _depths(world: World, memory: Float, x: Float, awake: bool) -> None:
    """What each point holds in each obstacle, and in other bodies, where a step ended, into columns of `told`.

    Of those that sleep nothing, or all of them are awake from now on.

    These are: energy beyond its offset over half of its area, κ, and how deep it is; in bodies the sum, the sum, and
    where it is deepest.
    """
    count, points = world.told.shape[0], world.area.shape[0]
    for n in range(count):
        for a in range(1, 4):
            put(world.told, (n, a), 0.0)
    for p in range(world.moves):
        if at(world.there, p) == 0.0:
            continue
        px, py, pz = point_at(world, p, x)
        for s in range(world.kind.shape[0]):
            deep, _, _, _, _ = depth(at(world.kind, s), world.numbers, s, px, py, pz)
            _add_depth(world, memory, s * points + p, p, at(world.stiffness, s), deep)
    _depths_between(world, world.bodies, memory, x, awake)


@inner
def _add_depth(world: World, memory: Float, n: int, p: int, stiffness: float, deep: float) -> None:
    """Adds to the columns of `told` what a point holds in one thing."""
    if deep > 0.0:
        beyond = max(deep - at(memory, world.offset + world.told.shape[0] + n), 0.0)
        put(world.told, (n, 1), at(world.told, (n, 1)) + stiffness * at(world.there, p) * beyond * beyond)
        put(world.told, (n, 2), at(world.told, (n, 2)) + stiffness)
        put(world.told, (n, 3), max(at(world.told, (n, 3)), deep))


@part
def _depths_between(world: World, m: Meeting | None, memory: Float, x: Float, awake: bool) -> None:
    """Likewise in other bodies."""
    if m is None:
        return
    gather(world, m, memory, x, 0.0)
    put(m.entries, 0, 0)
    first = world.kind.shape[0] * world.area.shape[0]
    stretches = world.first + 4 * (world.told.shape[0] + first)
    if awake:
        wake(m, memory, stretches)
    else:
        doze(m, memory, stretches)
    for e in range(at(m.entries, 1)):
        p = at(m.point, e)
        stiffness = at(m.stiffness, (at(m.part, p), at(m.other, e)))
        _add_depth(world, memory, first + p, p, stiffness, at(m.began, (e, 0)))


@block
def keep_depths(world: World, memory: Float, x: Float) -> None:
    """Before a cut: keeps in `told` what each point holds.

    Args:
        world: what the skin meets.
        memory: of the copy, after a step.
        x: where it came to, displacements of the rows [m].
    """
    _depths(world, memory, x, False)
    for n in range(world.told.shape[0]):
        put(world.told, (n, 0), at(world.told, (n, 1)))


@block
def meet_anew(world: World, memory: Float, x: Float) -> float:
    """After a cut: finds offsets with which no point holds more than before, and returns what all hold [J].

    Args:
        world: what the skin meets; `keep_depths` was called before the cut.
        memory: of the copy; friction and offsets are changed.
        x: where it is, displacements of the rows [m].
    """
    _depths(world, memory, x, True)
    count, points, energy = world.told.shape[0], world.area.shape[0], 0.0
    for n in range(count):
        there, deep = at(world.there, n % points), at(world.told, (n, 3))
        kept = world.offset + count + n
        if there == 0.0 or deep <= 0.0:
            for a in range(4):
                put(memory, world.first + 4 * (count + n) + a, 0.0)
            put(memory, kept, 0.0)
        elif at(world.told, (n, 1)) > at(world.told, (n, 0)):  # else it is as it was, to the bit
            beyond = math.sqrt(at(world.told, (n, 0)) / (there * at(world.told, (n, 2))))
            put(memory, kept, max(at(memory, kept), deep - beyond))
    _depths(world, memory, x, True)
    for n in range(count):
        p, stretch, slid = n % points, world.first + 4 * (count + n), 0.0
        for a in range(3):
            slid += at(memory, stretch + a) ** 2
        other = stretched_in(memory, stretch)
        s = n // points
        k = at(world.stiffness, s) if s < world.kind.shape[0] else _stiffness(world.bodies, p, other)
        energy += 0.5 * at(world.area, p) * (at(world.told, (n, 1)) + 0.5 * at(world.there, p) * k * slid)
    return energy


@inner
def _stiffness(m: Meeting | None, p: int, other: int) -> float:
    """Of a point in a body that remembers its friction; 0: none does [N/m³]."""
    return 0.0 if m is None or other < 0 else at(m.stiffness, (at(m.part, p), other))
