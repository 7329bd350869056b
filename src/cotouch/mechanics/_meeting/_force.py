"""What bodies do to each other: pressure by the depth of the one's skin in the other's, damping, and friction.

As at an obstacle, all of it is a function of where points and triangles were and are: pressure is the discrete gradient
of its energy, friction a spring with a return mapping, and both lose at least 0 for any motion. What a point feels, the
corners of the triangle feel the other way round, so nothing is added to the momentum of both.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, block, inner, part, put
from cotouch.mechanics._meeting._asleep import is_last
from cotouch.mechanics._meeting._bodies import Meeting
from cotouch.mechanics._meeting._look import gather, make_ready, point_at
from cotouch.mechanics._meeting._near import FAR_SIDE, crossing, follow
from cotouch.mechanics._meeting._pressed_point import Pressed, Resists, pressed, resists, stretched, untouched
from cotouch.mechanics._meeting._stretch import mark_of, put_within, stretch_in
from cotouch.mechanics._meeting._tool_bodies import note_push
from cotouch.mechanics._meeting._world import World
from cotouch.mechanics._meeting._world_lean import couple_rows, tell
from cotouch.mechanics._meeting._world_offset import follow_offset, offset_of

# Normals that look so much against each other are of opposite sides.
_AGAINST = -0.5
# A force that does not do the work by which its energy changes is turned by at most this tangent; beyond rounding.
_TURNED, _ROUNDING = 0.5, 1e-13


@inner
def begin_work(m: Meeting | None) -> None:
    """Nothing was done on any body yet."""
    if m is not None:
        for b in range(m.met.group.shape[0]):
            put(m.met.worked, b, 0.0)
            put(m.met.flow, b, 0.0)
            put(m.met.passed, b, 0)


@inner
def book_work(m: Meeting | None, p: int, work: float, flow: float, passed: bool) -> None:
    """What an obstacle did on a point, how much energy went to and fro [J], and whether the point passed it.

    Args:
        m: the bodies that meet; None: there is one.
        p: which point.
        work: done on it [J].
        flow: that went to and fro, >= 0 [J].
        passed: whether it did.
    """
    if m is not None:
        _book(m, at(m.part, p), work, flow, passed)


@inner
def _book(m: Meeting, b: int, work: float, flow: float, passed: bool) -> None:
    put(m.met.worked, b, at(m.met.worked, b) + work)
    put(m.met.flow, b, at(m.met.flow, b) + flow)
    if passed:
        put(m.met.passed, b, 1)


@part
def _alone(m: Meeting) -> None:
    """Nobody touches anybody."""
    for b in range(m.met.group.shape[0]):
        put(m.met.group, b, b)


@inner
def _join(m: Meeting, e: int) -> None:
    """Those whom an entry's point joins are of one group; what stands still joins nobody."""
    one, two = at(m.part, at(m.point, e)), at(m.other, e)
    if max(one, two) < m.moves and (at(m.began, (e, 0)) > 0.0 or at(m.ended, (e, 0)) > 0.0):
        low, high = at(m.met.group, one), at(m.met.group, two)
        low, high = min(low, high), max(low, high)
        if low != high:
            for b in range(m.moves):
                if at(m.met.group, b) == high:
                    put(m.met.group, b, low)


@part
def _carrier(m: Meeting, e: int) -> int:
    """The triangle that feels what an entry's point does; shares of its corners go to row e of `ended`."""
    if at(m.ended, (e, 0)) > 0.0:
        f = at(m.face, (e, 2))
        if f == at(m.face, (e, 0)) and at(m.began, (e, 0)) > 0.0:
            for q in range(3):
                put(m.ended, (e, 4 + q), 0.5 * (at(m.ended, (e, 4 + q)) + at(m.began, (e, 4 + q))))
        return f
    for q in range(3):
        put(m.ended, (e, 4 + q), at(m.began, (e, 4 + q)))
    return at(m.face, (e, 0))


@part
def _meet(
    world: World, m: Meeting, memory: Float, e: int, here: int, mx: float, my: float, mz: float, T: float
) -> tuple[tuple[float, float, float], Pressed]:
    """One point and the body that it may meet, whose nearest triangle it passes by m: the normal, and what it feels."""
    p = at(m.point, e)
    pair = at(m.part, p), at(m.other, e)
    off = offset_of(world, memory, world.kind.shape[0] * world.area.shape[0] + p)
    before, after = at(m.began, (e, 0)) - off, at(m.ended, (e, 0)) - off
    k = at(m.stiffness, pair) * at(world.area, p) * at(world.there, p)
    sx, sy, sz, was = stretch_in(memory, here, pair[1])
    if before <= 0.0 and after <= 0.0:
        return (0.0, 0.0, 0.0), untouched(stretched(k, sx, sy, sz))
    nx = (at(m.began, (e, 1)) if before > 0.0 else 0.0) + (at(m.ended, (e, 1)) if after > 0.0 else 0.0)
    ny = (at(m.began, (e, 2)) if before > 0.0 else 0.0) + (at(m.ended, (e, 2)) if after > 0.0 else 0.0)
    nz = (at(m.began, (e, 3)) if before > 0.0 else 0.0) + (at(m.ended, (e, 3)) if after > 0.0 else 0.0)
    size = math.sqrt(nx * nx + ny * ny + nz * nz)
    scale = 1.0 / size if size > 0.0 else 0.0
    nx, ny, nz = scale * nx, scale * ny, scale * nz
    square = mx * mx + my * my + mz * mz
    off = after - before + mx * nx + my * ny + mz * nz
    gx, gy, gz = nx, ny, nz
    if abs(off) > _ROUNDING * (abs(before) + abs(after) + m.lever) and square > 0.0:
        short = min(max(off, -_TURNED * math.sqrt(square)), _TURNED * math.sqrt(square)) / square
        gx, gy, gz = nx - short * mx, ny - short * my, nz - short * mz
    return (nx, ny, nz), pressed(
        k, at(m.loss, pair), at(m.friction, pair), at(m.kinetic, pair), before, after, nx, ny, nz, gx, gy, gz,
        mx, my, mz, sx, sy, sz, was, at(m.deepest, pair), T,
    )  # fmt: skip


@inner
def _beside(m: Meeting, e: int, f: int, place: Float) -> tuple[float, float, float]:
    """Where the point of a triangle is that an entry's shares name."""
    x = y = z = 0.0
    for q in range(3):
        v, share = at(m.corner, (f, q)), at(m.ended, (e, 4 + q))
        x, y, z = x + share * at(place, (v, 0)), y + share * at(place, (v, 1)), z + share * at(place, (v, 2))
    return x, y, z


@inner
def _give(row: int, share: float, firm: float, fx: float, fy: float, fz: float, world: World, out: Float) -> None:
    put(out, (row, 0), at(out, (row, 0)) - share * fx)
    put(out, (row, 1), at(out, (row, 1)) - share * fy)
    put(out, (row, 2), at(out, (row, 2)) - share * fz)
    put(world.hold, row, at(world.hold, row) + abs(share) * firm)


@part
def press_bodies(
    world: World, m: Meeting | None, firmness: float, memory: Float, x: Float, ahead: Float, T: float, out: Float
) -> tuple[float, float]:
    """Takes off `out` the mean forces between bodies; `hold` gets what resists there. See `press_world`.

    Args:
        world: obstacles and points; `hold` and `told` are written.
        m: the bodies that meet; None: there is one.
        firmness: what the forces are scaled by.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        T: length of the step [s].
        out: (rows, 4), taken off [N].

    Returns:
        Square of what forces changed by since the look before, and of the forces [N²].
    """
    if m is None:
        return 0.0, 0.0
    make_ready(world, m, memory, x, ahead)
    points = world.area.shape[0]
    slot, change, size = world.kind.shape[0] * points, 0.0, 0.0
    at_once = world.couple.shape[0] == 3 * world.hold.shape[0]
    _alone(m)
    sx = sy = sz = 0.0
    for e in range(at(m.entries, 1)):
        p = at(m.point, e)
        px, py, pz = point_at(world, p, x)
        qx, qy, qz = point_at(world, p, ahead)
        follow(m, e, qx, qy, qz)
        _join(m, e)
        f = _carrier(m, e)
        ax, ay, az = _beside(m, e, f, m.place)
        bx, by, bz = _beside(m, e, f, m.later)
        mx, my, mz = (qx - px) - (bx - ax), (qy - py) - (by - ay), (qz - pz) - (bz - az)
        here = world.first + 4 * (slot + p)
        normal, found = _meet(world, m, memory, e, here, mx, my, mz, T)
        fx, fy, fz, firm = found[0], found[1], found[2], found[5]
        sx, sy, sz = sx + fx, sy + fy, sz + fz
        if is_last(m, e):
            change += tell(world, slot + p, sx, sy, sz)
            size += sx * sx + sy * sy + sz * sz
            sx = sy = sz = 0.0
        if firm == 0.0 and fx == 0.0 and fy == 0.0 and fz == 0.0:
            continue
        fx, fy, fz = firmness * fx, firmness * fy, firmness * fz
        for n in range(at(world.pointer, p), at(world.pointer, p + 1)):
            _give(at(world.row, n), at(world.share, n), firm, fx, fy, fz, world, out)
        for q in range(3):
            v, share = at(m.corner, (f, q)), at(m.ended, (e, 4 + q))
            for n in range(at(m.pointer, v), at(m.pointer, v + 1)):
                _give(at(m.row, n), share * at(m.share, n), firm, -fx, -fy, -fz, world, out)
        if at_once:
            _couple(world, m, e, f, resists(normal, found))
        elif world.couple.shape[0] > 0:  # beside rows that one number resists, which the next look finds
            _couple(world, m, e, f, (firm, 0.0, 0.0, 0.0, firm, 0.0, 0.0, 0.0, firm))
    return change, size


@inner
def _note(world: World, m: Meeting, count: int, guess: int, own: int, share: float) -> int:
    """Adds to the coefficient of a row that is solved for at once with others; returns how many these are.

    Corners of a rigid body's triangle are moved by the same rows in the same order, so it is guessed where each is.
    """
    row = at(world.rigid, own)
    if row < 0:
        return count
    if guess < count and at(m.moved, guess) == row:
        put(m.coefficient, guess, at(m.coefficient, guess) + share)
        return count
    for n in range(count):
        if at(m.moved, n) == row:
            put(m.coefficient, n, at(m.coefficient, n) + share)
            return count
    put(m.moved, count, row)
    put(m.coefficient, count, share)
    return count + 1


@part
def _couple(world: World, m: Meeting, e: int, f: int, by: Resists) -> None:
    """What resists that an entry's point passes its triangle, between all rows that move either; see `couple`."""
    p, count = at(m.point, e), 0
    for n in range(at(world.pointer, p), at(world.pointer, p + 1)):
        count = _note(world, m, count, count, at(world.row, n), at(world.share, n))
    begun = count
    for q in range(3):
        v = at(m.corner, (f, q))
        first, part = at(m.pointer, v), -at(m.ended, (e, 4 + q))
        for n in range(first, at(m.pointer, v + 1)):
            count = _note(world, m, count, begun + n - first, at(m.row, n), part * at(m.share, n))
    couple_rows(world, m.moved, m.coefficient, 0, count, by)


@part
def weigh_bodies(
    world: World, m: Meeting | None, memory: Float, x: Float, ahead: Float, T: float
) -> tuple[float, float, bool]:
    """What bodies hold between them after a motion and lost in it, and whether a point passed; see `weigh_world`.

    Args:
        world: obstacles and points.
        m: the bodies that meet; None: there is one.
        memory: of the copy, in place.
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        T: length of the step [s].
    """
    if m is None:
        return 0.0, 0.0, False
    make_ready(world, m, memory, x, ahead)
    points = world.area.shape[0]
    slot, energy, lost, passed = world.kind.shape[0] * points, 0.0, 0.0, False
    kept = world.first + 4 * world.told.shape[0]
    for n in range(4 * points):
        put(memory, kept + 4 * slot + n, 0.0)
    _alone(m)
    for p in range(points if world.offset >= 0 else 0):
        put(memory, world.offset + world.told.shape[0] + slot + p, 0.0)
    for n in range(4 * m.push.shape[0]):
        put(m.push, n, 0.0)
    deepest, held, within = -math.inf, 0.0, 0
    for e in range(at(m.entries, 1)):
        p, other = at(m.point, e), at(m.other, e)
        px, py, pz = point_at(world, p, x)
        qx, qy, qz = point_at(world, p, ahead)
        follow(m, e, qx, qy, qz)
        _join(m, e)
        through = _passes(m, e, px, py, pz, qx - px, qy - py, qz - pz)
        passed = passed or through
        f = _carrier(m, e)
        ax, ay, az = _beside(m, e, f, m.place)
        bx, by, bz = _beside(m, e, f, m.later)
        here = world.first + 4 * (slot + p)
        mx, my, mz = (qx - px) - (bx - ax), (qy - py) - (by - ay), (qz - pz) - (bz - az)
        _, found = _meet(world, m, memory, e, here, mx, my, mz, T)
        fx, fy, fz, stored, gone, _, ex, ey, ez, slips, _, _, _, _, _ = found
        energy, lost = energy + stored, lost + gone
        own = at(m.part, p)
        firm = at(m.stiffness, (own, other)) * at(world.area, p) * at(world.there, p)
        sx, sy, sz, _ = stretch_in(memory, here, other)
        before = 0.5 * firm * max(at(m.began, (e, 0)) - offset_of(world, memory, slot + p), 0.0) ** 2
        before += 0.25 * firm * sx**2
        before += 0.25 * firm * sy**2
        before += 0.25 * firm * sz**2
        did = fx * (qx - px) + fy * (qy - py) + fz * (qz - pz)
        took = -fx * (bx - ax) - fy * (by - ay) - fz * (bz - az)
        # What a force that could not be turned so far does not do by itself, both have half of.
        short = 0.5 * (before - stored - gone - did - took)
        flow = 0.5 * (abs(stored - before) + gone)
        if max(own, other) < m.moves:
            _book(m, own, did + short, flow, through)
            _book(m, other, took + short, flow, through)
        else:
            _book(m, min(own, other), did + took + 2.0 * short, 2.0 * flow, through)
            row, sign = world.kind.shape[0] + max(own, other) - m.moves, 1.0 if own < m.moves else -1.0
            put(world.force, (row, 0), at(world.force, (row, 0)) + sign * fx)
            put(world.force, (row, 1), at(world.force, (row, 1)) + sign * fy)
            put(world.force, (row, 2), at(world.force, (row, 2)) + sign * fz)
        # Of a point that is out nothing is kept: whether the next step finds it depends on how far that looks.
        here, deep, dropped = kept + 4 * (slot + p), at(m.ended, (e, 0)), stretched(firm, ex, ey, ez)
        if deep > max(deepest, 0.0):
            dropped, held = held, dropped
            put(memory, here, ex)
            put(memory, here + 1, ey)
            put(memory, here + 2, ez)
            put(memory, here + 3, mark_of(other, slips))
        energy, lost, deepest = energy - dropped, lost + dropped, max(deepest, deep)
        within += 1 if deep > 0.0 else 0
        if is_last(m, e):
            put_within(memory, here, within)
            follow_offset(world, memory, slot + p, deepest)
            deepest, held, within = -math.inf, 0.0, 0
        if m.push.shape[0] > 0 and at(m.tool, own) != at(m.tool, other):
            note_push(world, m, e, f, fx, fy, fz)
    return energy, lost, passed


@part
def _passes(m: Meeting, e: int, x: float, y: float, z: float, mx: float, my: float, mz: float) -> bool:
    """Whether a point comes out of a body, or is pushed out, on the side opposite to where it came in."""
    before, after = at(m.began, (e, 0)), at(m.ended, (e, 0))
    if before > 0.0 and at(m.face, (e, 3)) == FAR_SIDE:
        return True
    if before > 0.0 and after > 0.0:
        turned = 0.0
        for a in range(3):
            turned += at(m.began, (e, 1 + a)) * at(m.ended, (e, 1 + a))
        return turned < _AGAINST
    enters, leaves = crossing(m, e, x, y, z, mx, my, mz)
    if (before <= 0.0 and enters < 0) or (after <= 0.0 and leaves < 0):
        return False
    turned = 0.0
    for a in range(3):
        first = at(m.began, (e, 1 + a)) if before > 0.0 else _side(m, enters, a)
        last = at(m.ended, (e, 1 + a)) if after > 0.0 else _side(m, leaves, a)
        turned += first * last
    return turned < _AGAINST


@part
def _side(m: Meeting, f: int, a: int) -> float:
    """A component of a triangle's normal where the step begins."""
    i, j, k = at(m.corner, (f, 0)), at(m.corner, (f, 1)), at(m.corner, (f, 2))
    b, c = (a + 1) % 3, (a + 2) % 3
    ub, uc = at(m.place, (j, b)) - at(m.place, (i, b)), at(m.place, (j, c)) - at(m.place, (i, c))
    vb, vc = at(m.place, (k, b)) - at(m.place, (i, b)), at(m.place, (k, c)) - at(m.place, (i, c))
    ua, va = at(m.place, (j, a)) - at(m.place, (i, a)), at(m.place, (k, a)) - at(m.place, (i, a))
    na, nb, nc = ub * vc - uc * vb, uc * va - ua * vc, ua * vb - ub * va
    size = math.sqrt(na * na + nb * nb + nc * nc)
    return na / size if size > 0.0 else 0.0


@block
def deepest_between(world: World, m: Meeting, memory: Float, x: Float) -> tuple[float, int, int]:
    """How deep the deepest point of any body is in another, less than 0 outside [m], and which two these are.

    Args:
        world: the points.
        m: the bodies.
        memory: of the copy; says which tools are away from it.
        x: displacements of the rows, (rows, width) [m].
    """
    gather(world, m, memory, x, 0.0)
    put(m.entries, 0, 0)
    most, one, two = -math.inf, 0, 0
    for e in range(at(m.entries, 1)):
        if at(m.began, (e, 0)) > most:
            most, one, two = at(m.began, (e, 0)), at(m.part, at(m.point, e)), at(m.other, e)
    return most, one, two
