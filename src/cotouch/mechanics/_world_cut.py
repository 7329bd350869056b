"""What a cut does to contact with the world and other bodies: parts of the skin go, and others come to light.

No cut may raise an energy. What comes to light within something, or has something within it, is therefore met from as
deep as it was then: contact acts beyond that offset, which shrinks as the point comes out and never grows again.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.mechanics._kernel import block, part
from cotouch.mechanics._meeting import Meeting
from cotouch.mechanics._meeting_look import gather, point_at
from cotouch.mechanics._shape import depth
from cotouch.mechanics._vector import at, put
from cotouch.mechanics._world import World


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
def _depths(world: World, memory: Float, x: Float) -> None:
    """Depth of each point in each obstacle and in other bodies, where a step ended, and κ, into columns of `told`."""
    points = world.area.shape[0]
    for n in range(world.told.shape[0]):
        put(world.told, (n, 3), 0.0)
    for p in range(world.moves):
        if at(world.there, p) == 0.0:
            continue
        px, py, pz = point_at(world, p, x)
        for s in range(world.kind.shape[0]):
            deep, _, _, _, _ = depth(at(world.kind, s), world.numbers, s, px, py, pz)
            put(world.told, (s * points + p, 2), at(world.stiffness, s))
            put(world.told, (s * points + p, 3), deep)
    _depths_between(world, world.bodies, memory, x)


@part
def _depths_between(world: World, m: Meeting | None, memory: Float, x: Float) -> None:
    """Likewise in other bodies."""
    if m is None:
        return
    gather(world, m, memory, x, 0.0)
    put(m.entries, 0, 0)
    first = world.kind.shape[0] * world.area.shape[0]
    for e in range(at(m.entries, 1)):
        n = first + at(m.point, e)
        put(world.told, (n, 2), at(m.stiffness, (at(m.part, at(m.point, e)), at(m.other, e))))
        put(world.told, (n, 3), at(m.began, (e, 0)))


@block
def keep_depths(world: World, memory: Float, x: Float) -> None:
    """Before a cut: keeps in `told` how deep each point presses, beyond its offset, and how much of it is there.

    Args:
        world: what the skin meets.
        memory: of the copy, after a step.
        x: where it came to, displacements of the rows [m].
    """
    _depths(world, memory, x)
    count, points = world.told.shape[0], world.area.shape[0]
    for n in range(count):
        off = at(memory, world.offset + count + n)
        put(world.told, (n, 0), max(at(world.told, (n, 3)) - off, 0.0))
        put(world.told, (n, 1), at(world.there, n % points))


@block
def meet_anew(world: World, memory: Float, x: Float) -> float:
    """After a cut: finds offsets with which no point holds more than before, and returns what all hold [J].

    Args:
        world: what the skin meets; `keep_depths` was called before the cut.
        memory: of the copy; friction and offsets are changed.
        x: where it is, displacements of the rows [m].
    """
    _depths(world, memory, x)
    count, points, energy = world.told.shape[0], world.area.shape[0], 0.0
    for n in range(count):
        p = n % points
        there, deep = at(world.there, p), at(world.told, (n, 3))
        stretch = world.first + 4 * (count + n)
        kept = world.offset + count + n
        if there == 0.0 or deep <= 0.0:
            for a in range(4):
                put(memory, stretch + a, 0.0)
            put(memory, kept, 0.0)
            continue
        pressed = at(world.told, (n, 0)) * math.sqrt(min(at(world.told, (n, 1)) / there, 1.0))
        off = max(at(memory, kept), deep - pressed)
        if deep - at(memory, kept) <= at(world.told, (n, 0)) and at(world.told, (n, 1)) >= there:
            off = at(memory, kept)  # as it was, to the bit
        put(memory, kept, off)
        k = at(world.told, (n, 2)) * at(world.area, p) * there
        beyond = max(deep - off, 0.0)
        slid = 0.0
        for a in range(3):
            slid += at(memory, stretch + a) ** 2
        energy += 0.5 * k * beyond * beyond + 0.25 * k * slid
    return energy
