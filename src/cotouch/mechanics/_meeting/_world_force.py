"""What obstacles do to a body: pressure by the depth of every point of its skin, damping, and friction."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, block, inner, part, put, splat, store
from cotouch.mechanics._linear._state import WORLD_FORCE
from cotouch.mechanics._meeting._force import begin_work, book_work, press_bodies, weigh_bodies
from cotouch.mechanics._meeting._look import begin_bodies, point_away, settle_bodies
from cotouch.mechanics._meeting._pressed_point import Pressed, pressed, resists, stretched, untouched
from cotouch.mechanics._meeting._world import World
from cotouch.mechanics._meeting._world_lean import clear_pairs, couple, spread_pairs, tell
from cotouch.mechanics._meeting._world_offset import follow_offset, offset_of
from cotouch.mechanics._shapes._shape import depth, passes

# Looks at most that a step with obstacles takes, and the change of forces from one to the next at which they end.
_LOOKS = 16
_SETTLED = 1e-7
# What rounding may add to how far a point comes, as a factor.
_SURELY = 1.0 + 1e-9
# Of one point whether it passed through, the normal, and what it feels.
_Point = tuple[bool, tuple[float, float, float], Pressed]


@inner
def looks_of(world: World | None, directions: int, dense: bool) -> int:
    """How often a step looks where its forces lead, at most.

    Args:
        world: obstacles and points; None: none.
        directions: looks that a body without obstacles takes.
        dense: whether rows are solved for at once.
    """
    if world is None:
        return _LOOKS if dense else directions
    return _LOOKS


@inner
def _meet(
    world: World, memory: Float, s: int, p: int, x: float, y: float, z: float, mx: float, my: float, mz: float,
    T: float,
) -> _Point:  # fmt: skip
    """One obstacle and one point that is here, and moves by m within T."""
    kind = at(world.kind, s)
    before, ax, ay, az, face = depth(kind, world.numbers, s, x, y, z)
    after, nx, ny, nz, other = depth(kind, world.numbers, s, x + mx, y + my, z + mz)
    passed = passes(kind, world.numbers, s, x, y, z, mx, my, mz, before, face, after, other)
    k = at(world.stiffness, s) * at(world.area, p) * at(world.there, p)
    slot = s * world.area.shape[0] + p
    here, off = world.first + 4 * slot, offset_of(world, memory, slot)
    before, after = before - off, after - off
    sx, sy, sz = at(memory, here), at(memory, here + 1), at(memory, here + 2)
    if before <= 0.0 and after <= 0.0:
        return passed, (0.0, 0.0, 0.0), untouched(stretched(k, sx, sy, sz))
    if after <= 0.0:
        nx, ny, nz = ax, ay, az
    gx, gy, gz = nx, ny, nz
    if face != other or face < 0:
        if before > 0.0 and after > 0.0:  # between two faces
            size = math.sqrt((nx + ax) ** 2 + (ny + ay) ** 2 + (nz + az) ** 2)
            if size > 0.0:
                nx, ny, nz = (nx + ax) / size, (ny + ay) / size, (nz + az) / size
        square = mx * mx + my * my + mz * mz
        short = (after - before + nx * mx + ny * my + nz * mz) / square if square > 0.0 else 0.0
        gx, gy, gz = nx - short * mx, ny - short * my, nz - short * mz
    return passed, (nx, ny, nz), pressed(
        k, at(world.loss, s), at(world.friction, s), at(world.kinetic, s), before, after, nx, ny, nz, gx, gy, gz,
        mx, my, mz, sx, sy, sz, at(memory, here + 3), at(world.deepest, s), T,
    )  # fmt: skip


@inner
def _place(world: World, p: int, x: Float) -> tuple[float, float, float]:
    """How far a point is from its rest place."""
    a = b = c = 0.0
    for e in range(at(world.pointer, p), at(world.pointer, p + 1)):
        i, share = at(world.row, e), at(world.share, e)
        a, b, c = a + share * at(x, (i, 0)), b + share * at(x, (i, 1)), c + share * at(x, (i, 2))
    return a, b, c


@part
def take_up(world: World | None, memory: Float, x: Float) -> None:
    """Takes the stretches that the last step came to as those that the next begins with.

    Args:
        world: obstacles and points; None: none.
        memory: of the copy, in place.
        x: displacements of the rows, (rows, 4) [m].
    """
    if world is not None:
        put(world.known, 0, 0.0)
        count = 4 * world.told.shape[0]
        for n in range(count):
            put(memory, world.first + n, at(memory, world.first + count + n))
        if world.offset >= 0:
            count = world.told.shape[0]
            for n in range(count):
                put(memory, world.offset + n, at(memory, world.offset + count + n))
                put(memory, world.offset + count + n, 0.0)
        begin_bodies(world.bodies, x)


@part
def _begin(world: World, memory: Float, x: Float) -> None:
    """Notes where all points start, how far each is from what it may meet, and how deep any is in each obstacle."""
    for s in range(world.kind.shape[0]):
        put(world.deepest, s, 0.0)
    for p in range(world.moves):
        there = at(world.there, p) != 0.0 and not point_away(world.bodies, memory, p)
        ux, uy, uz = _place(world, p, x)
        rx, ry, rz = at(world.rest, (p, 0)) + ux, at(world.rest, (p, 1)) + uy, at(world.rest, (p, 2)) + uz
        clear = math.inf
        for s in range(world.kind.shape[0]):
            deep, _, _, _, _ = depth(at(world.kind, s), world.numbers, s, rx, ry, rz)
            clear = min(clear, -deep)
            if there and deep > at(world.deepest, s):
                put(world.deepest, s, deep)
        put(world.start, (p, 0), ux)
        put(world.start, (p, 1), uy)
        put(world.start, (p, 2), uz)
        put(world.start, (p, 3), clear)
    put(world.known, 0, 1.0)


@inner
def _way(x: Float, ahead: Float, i: int) -> float:
    """As far as a row moves, or farther [m]."""
    way = 0.0
    for a in range(3):
        way += abs(at(ahead, (i, a)) - at(x, (i, a)))
    return way


@part
def press_world(
    world: World | None, firmness: float, memory: Float, x: Float, ahead: Float, T: float, out: Float
) -> bool:
    """Takes off `out` the mean force of all obstacles between two places; `hold` gets what resists there.

    Args:
        world: obstacles and points; None: none.
        firmness: what the forces are scaled by.
        memory: of the copy.
        x: displacements of the rows, (rows, width) [m].
        ahead: where they come to, likewise.
        T: within which time [s].
        out: result (rows, width) [N].

    Returns:
        Whether forces, and what was leaned on, are those of the call before.
    """
    if world is None:
        return True
    change, size, far = 0.0, 0.0, 0.0
    for i in range(world.hold.shape[0]):  # what the last look leaned on has moved since
        far = max(far, _way(x, ahead, i))
        hold = at(world.hold, i)
        if hold != 0.0:
            for a in range(3):
                missed = hold * ((at(ahead, (i, a)) - at(x, (i, a))) / T - at(world.tried, (i, a)))
                change += missed * missed
        put(world.hold, i, 0.0)
    clear_pairs(world)
    far *= _SURELY * world.reach
    if world.kind.shape[0] > 0 and at(world.known, 0) == 0.0:
        _begin(world, memory, x)
    for p in range(world.moves if world.kind.shape[0] > 0 else 0):
        if at(world.there, p) == 0.0 or point_away(world.bodies, memory, p):
            continue
        if at(world.start, (p, 3)) > far:  # it meets nothing on its way
            change += tell(world, p, 0.0, 0.0, 0.0)
            continue
        ux, uy, uz = at(world.start, (p, 0)), at(world.start, (p, 1)), at(world.start, (p, 2))
        vx, vy, vz = _place(world, p, ahead)
        rx, ry, rz = at(world.rest, (p, 0)) + ux, at(world.rest, (p, 1)) + uy, at(world.rest, (p, 2)) + uz
        fx = fy = fz = firm = 0.0
        for s in range(world.kind.shape[0]):
            _, normal, found = _meet(world, memory, s, p, rx, ry, rz, vx - ux, vy - uy, vz - uz, T)
            a, b, c, firm_here, along = found[0], found[1], found[2], found[5], found[10]
            fx, fy, fz, firm = fx + a, fy + b, fz + c, firm + firm_here
            if firm_here > 0.0 or along > 0.0:
                couple(world, p, resists(normal, found))
        change += tell(world, p, fx, fy, fz)
        size += fx * fx + fy * fy + fz * fz
        if firm == 0.0 and fx == 0.0 and fy == 0.0 and fz == 0.0:
            continue
        fx, fy, fz = firmness * fx, firmness * fy, firmness * fz
        for e in range(at(world.pointer, p), at(world.pointer, p + 1)):
            i, share = at(world.row, e), at(world.share, e)
            put(out, (i, 0), at(out, (i, 0)) - share * fx)
            put(out, (i, 1), at(out, (i, 1)) - share * fy)
            put(out, (i, 2), at(out, (i, 2)) - share * fz)
            put(world.hold, i, at(world.hold, i) + abs(share) * firm)
    more, beside = press_bodies(world, world.bodies, firmness, memory, x, ahead, T, out)
    spread_pairs(world)
    change, size = change + more, size + beside
    return change <= _SETTLED * _SETTLED * size


@inner
def _forgets(world: World, memory: Float, p: int, points: int, kept: int) -> bool:
    """Whether nothing is stretched at a point; then nothing will be where it meets nothing."""
    held = 0.0
    for s in range(world.kind.shape[0]):
        for a in range(4):
            place = 4 * (s * points + p) + a
            held += abs(at(memory, world.first + place))
            put(memory, kept + place, 0.0)
    return held == 0.0


@part
def weigh_world(world: World | None, memory: Float, x: Float, ahead: Float, T: float) -> tuple[float, float, bool]:
    """What obstacles hold after a motion and lost in it; stretches at its end go to the second half of the memory.

    Args:
        world: obstacles and points; None: none.
        memory: of the copy.
        x: displacements of the rows before, (rows, width) [m].
        ahead: and after, likewise.
        T: how long it took [s].

    Returns:
        Energy held [J], energy lost [J], and whether a point passed through an obstacle.
    """
    if world is None:
        return 0.0, 0.0, False
    points, energy, lost, passed = world.area.shape[0], 0.0, 0.0, False
    kept = world.first + 4 * world.told.shape[0]
    zero = splat(0.0, (0, 0, 0, 0))
    for s in range(world.force.shape[0]):
        store(world.force, s, zero, (0, 0, 0, 0))
    begin_work(world.bodies)
    far = 0.0
    for i in range(world.hold.shape[0]):
        far = max(far, _way(x, ahead, i))
    far *= _SURELY * world.reach
    if world.kind.shape[0] > 0 and at(world.known, 0) == 0.0:
        _begin(world, memory, x)
    sure = world.offset < 0
    for p in range(world.moves if world.kind.shape[0] > 0 else 0):
        if at(world.there, p) == 0.0 or point_away(world.bodies, memory, p):
            continue
        if sure and at(world.start, (p, 3)) > far and _forgets(world, memory, p, points, kept):
            continue
        ux, uy, uz = _place(world, p, x)
        vx, vy, vz = _place(world, p, ahead)
        rx, ry, rz = at(world.rest, (p, 0)) + ux, at(world.rest, (p, 1)) + uy, at(world.rest, (p, 2)) + uz
        for s in range(world.kind.shape[0]):
            through, _, found = _meet(world, memory, s, p, rx, ry, rz, vx - ux, vy - uy, vz - uz, T)
            a, b, c, stored, gone, _, ex, ey, ez, slips, _, _, _, _, _ = found
            energy, lost, passed = energy + stored, lost + gone, passed or through
            here = kept + 4 * (s * points + p)
            put(memory, here, ex)
            put(memory, here + 1, ey)
            put(memory, here + 2, ez)
            put(memory, here + 3, slips)
            if offset_of(world, memory, s * points + p) > 0.0:
                deep, _, _, _, _ = depth(at(world.kind, s), world.numbers, s, rx + vx - ux, ry + vy - uy, rz + vz - uz)
                follow_offset(world, memory, s * points + p, deep)
            put(world.force, (s, 0), at(world.force, (s, 0)) + a)
            put(world.force, (s, 1), at(world.force, (s, 1)) + b)
            put(world.force, (s, 2), at(world.force, (s, 2)) + c)
            book_work(world.bodies, p, a * (vx - ux) + b * (vy - uy) + c * (vz - uz), stored + gone, through)
    stored, gone, through = weigh_bodies(world, world.bodies, memory, x, ahead, T)
    return energy + stored, lost + gone, passed or through


@inner
def grain_of(world: World | None, energy: float) -> float:
    """What the rounding of places does to an energy at obstacles [J].

    Args:
        world: obstacles and points; None: none.
        energy: that is held there, >= 0 [J].
    """
    if world is None:
        return 0.0
    return world.grain + 2.0 * math.sqrt(world.grain * energy)


@inner
def unsettled(world: World | None, flow: float) -> float:
    """What looks that end once forces have settled leave of an energy that flows in the step [J].

    Args:
        world: obstacles and points; None: none.
        flow: by size, >= 0 [J].
    """
    if world is None:
        return 0.0
    return _SETTLED * flow


@inner
def tell_world(world: World | None, copy_scale: float, ledger: Float) -> None:
    """Writes into a ledger the mean force of all obstacles on the copy.

    Args:
        world: obstacles and points; None: none.
        copy_scale: what is taken of it.
        ledger: WORLD_FORCE is written.
    """
    if world is not None:
        for a in range(3):
            ledger[WORLD_FORCE + a] = 0.0
            for s in range(world.force.shape[0]):
                ledger[WORLD_FORCE + a] += copy_scale * at(world.force, (s, a))


@block
def deepest_point(world: World, memory: Float, x: Float) -> tuple[float, int]:
    """How deep the deepest point is in any obstacle, less than 0 outside [m], and in which.

    Args:
        world: what the body may meet.
        memory: of the copy; says which tools are away from it.
        x: displacements from rest, (rows, width) [m].
    """
    most, where = -math.inf, 0
    for p in range(world.moves):
        if at(world.there, p) == 0.0 or point_away(world.bodies, memory, p):
            continue
        ux, uy, uz = _place(world, p, x)
        rx, ry, rz = at(world.rest, (p, 0)) + ux, at(world.rest, (p, 1)) + uy, at(world.rest, (p, 2)) + uz
        for s in range(world.kind.shape[0]):
            deep, _, _, _, _ = depth(at(world.kind, s), world.numbers, s, rx, ry, rz)
            if deep > most:
                most, where = deep, s
    return most, where


@part
def settle_world(world: World | None, memory: Float, x: Float) -> float:
    """Forgets all friction; returns what obstacles hold where the copy is [J].

    Args:
        world: obstacles and points; None: none.
        memory: of the copy, in place.
        x: displacements of the rows, (rows, 4) [m].
    """
    if world is None:
        return 0.0
    energy = 0.0
    for n in range(world.first, memory.shape[0]):
        put(memory, n, 0.0)
    for p in range(world.moves):
        if at(world.there, p) == 0.0 or point_away(world.bodies, memory, p):
            continue
        ux, uy, uz = _place(world, p, x)
        rx, ry, rz = at(world.rest, (p, 0)) + ux, at(world.rest, (p, 1)) + uy, at(world.rest, (p, 2)) + uz
        for s in range(world.kind.shape[0]):
            deep, _, _, _, _ = depth(at(world.kind, s), world.numbers, s, rx, ry, rz)
            if deep > 0.0:
                energy += 0.5 * at(world.stiffness, s) * at(world.area, p) * at(world.there, p) * deep * deep
    return energy + settle_bodies(world, world.bodies, memory, x)
