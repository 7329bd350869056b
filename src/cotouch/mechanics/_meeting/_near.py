"""How deep a point of one body is in another: the signed distance to its skin, by a tree of boxes."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, inner, part, put
from cotouch.mechanics._meeting._asleep import appears, beyond
from cotouch.mechanics._meeting._bodies import Meeting
from cotouch.mechanics._meeting._foot import foot, normal

# Two triangles are as near if squares of their distances differ by no more than this share.
_ALIKE = 1e-9
# A foot on a side lies as well as within if the way to it is the height above the plane, but for rounding.
_FLUSH = 1e-12
# Instead of whether the nearest point lies within its triangle: the body's own skin, seen from behind.
FAR_SIDE = 2


@inner
def is_hidden(m: Meeting, f: int) -> bool:
    """Whether a triangle of a body that can be cut is not there.

    Args:
        m: the bodies that meet.
        f: the triangle.
    """
    return m.hidden.shape[0] > 0 and at(m.hidden, f) != 0


@inner
def _outside(m: Meeting, place: Float, f: int, x: float, y: float, z: float) -> float:
    """Square of the distance from a point to the box around a triangle."""
    square = 0.0
    for a in range(3):
        here = x if a == 0 else y if a == 1 else z
        p, q, r = (
            at(place, (at(m.corner, (f, 0)), a)),
            at(place, (at(m.corner, (f, 1)), a)),
            at(place, (at(m.corner, (f, 2)), a)),
        )
        apart = max(min(p, q, r) - here, here - max(p, q, r), 0.0)
        square += apart * apart
    return square


@part
def keep_nearer(m: Meeting, place: Float, f: int, x: float, y: float, z: float, e: int, out: Float, col: int) -> None:
    """Notes a triangle in row e of `out`, and of `face`, if it is nearer than what is noted there.

    Of two that are as near, at an edge or a corner, it is the one whose plane is farther away, whose side of it is the
    side of the skin; of two in one plane the one that the point is above, else the first. Beside the other one by a
    hair, the normal would be turned by as much; and where rounding chose, looks would find no end. `out` gets for now
    the square of the distance, and the height above the plane beside it.

    Args:
        m: the bodies that meet.
        place: of the vertices, (V, 4) [m].
        f: the triangle.
        x: of the point [m].
        y: likewise.
        z: likewise.
        e: which entry.
        out: `began` or `ended`.
        col: of `face`: 0 of `began`, 2 of `ended`.
    """
    if is_hidden(m, f) or f == at(m.face, (e, col)):
        return
    i, j, k = at(m.corner, (f, 0)), at(m.corner, (f, 1)), at(m.corner, (f, 2))
    best = at(out, (e, 0))
    if _outside(m, place, f, x, y, z) > best * (1.0 + _ALIKE):
        return
    square, a, b, c, within = foot(place, i, j, k, x, y, z)
    if square > best * (1.0 + _ALIKE):
        return
    nx, ny, nz = normal(place, i, j, k)
    height = nx * (x - at(place, (i, 0))) + ny * (y - at(place, (i, 1))) + nz * (z - at(place, (i, 2)))
    flat = within or height * height >= square * (1.0 - _FLUSH)
    if square >= best * (1.0 - _ALIKE):
        known, own = abs(at(out, (e, 7))), abs(height)
        above = flat and at(m.face, (e, col + 1)) == 0 and own >= known * (1.0 - _FLUSH)
        if own <= known * (1.0 + _FLUSH) and not above:
            return
    put(out, (e, 0), square)
    put(out, (e, 1), nx)
    put(out, (e, 2), ny)
    put(out, (e, 3), nz)
    put(out, (e, 4), a)
    put(out, (e, 5), b)
    put(out, (e, 6), c)
    put(out, (e, 7), height)
    put(m.face, (e, col), f)
    put(m.face, (e, col + 1), 1 if flat else 0)


@part
def finish(m: Meeting, place: Float, x: float, y: float, z: float, e: int, out: Float, col: int) -> None:
    """Makes of the nearest triangle what is kept: depth, and the normal out of the skin.

    Args:
        m: the bodies that meet.
        place: of the vertices, (V, 4) [m].
        x: of the point [m].
        y: likewise.
        z: likewise.
        e: which entry.
        out: `began` or `ended`.
        col: as of `keep_nearer`.
    """
    square, height = at(out, (e, 0)), at(out, (e, 7))
    f = at(m.face, (e, col))
    distance = math.sqrt(square)
    sign = -1.0 if height >= 0.0 else 1.0
    if at(m.face, (e, col + 1)) != 0:
        put(out, (e, 0), -height)
        return
    put(out, (e, 0), sign * distance)
    if distance > 0.0:
        scale = -sign / distance
        for a in range(3):
            near = 0.0
            for q in range(3):
                near += at(out, (e, 4 + q)) * at(place, (at(m.corner, (f, q)), a))
            own = x if a == 0 else y if a == 1 else z
            put(out, (e, 1 + a), scale * (own - near))


@inner
def _clear(m: Meeting, e: int, out: Float, col: int, most: float) -> None:
    put(out, (e, 0), most)
    put(out, (e, 7), 0.0)
    put(m.face, (e, col), -1)


@inner
def _apart(m: Meeting, box: int, x: float, y: float, z: float) -> float:
    """Square of the distance from a point to a box."""
    dx = max(at(m.low, (box, 0)) - x, x - at(m.high, (box, 0)), 0.0)
    dy = max(at(m.low, (box, 1)) - y, y - at(m.high, (box, 1)), 0.0)
    dz = max(at(m.low, (box, 2)) - z, z - at(m.high, (box, 2)), 0.0)
    return dx * dx + dy * dy + dz * dz


@inner
def _beside(m: Meeting, p: int, f: int) -> bool:
    """Whether a triangle is so near to a point through what the body is made of that it is no other part."""
    first, last = at(m.skips, p), at(m.skips, p + 1)
    while first < last:
        middle = (first + last) // 2
        if at(m.skip, middle) < f:
            first = middle + 1
        else:
            last = middle
    return first < at(m.skips, p + 1) and at(m.skip, first) == f


@part
def _far_side(m: Meeting, e: int, out: Float, col: int) -> None:
    """A point of a body's own skin that is deeper behind it than another part could come looks at its far side.

    One that the step would bring there from the near side is pushed back as by that depth, though no step may end so:
    if it met nothing there, looks would have it shoot through, and it stood still with all that is held.
    """
    within = at(m.within, at(m.part, at(m.point, e)))
    if at(m.other, e) == at(m.part, at(m.point, e)) and at(out, (e, 0)) > within:
        if col == 0 or at(m.began, (e, 0)) <= 0.0:
            put(out, (e, 0), -at(out, (e, 0)))
        put(m.face, (e, col + 1), FAR_SIDE)


@part
def search(m: Meeting, body: int, p: int, x: float, y: float, z: float, e: int, reach: float) -> float:
    """Depth of a point in a body where the step begins; row e of `began` gets what belongs to it.

    Args:
        m: the bodies.
        body: which of them.
        p: the point.
        x: where it is.
        y: likewise.
        z: likewise.
        e: its entry.
        reach: of its own body, how far away more than `within` is not looked.
    """
    own = body == at(m.part, p)
    _clear(m, e, m.began, 0, (at(m.within, body) + reach) ** 2 if own else math.inf)
    put(m.point, e, p)
    put(m.other, e, body)
    root, waiting = at(m.boxes, body), 1
    put(m.stack, 0, root)
    while waiting > 0:
        waiting -= 1
        box = at(m.stack, waiting)
        if _apart(m, box, x, y, z) > at(m.began, (e, 0)) * (1.0 + _ALIKE):
            continue
        left, right = at(m.child, (box, 0)), at(m.child, (box, 1))
        if left < 0:
            for n in range(-1 - left, -1 - left + right):
                if not (own and _beside(m, p, at(m.leaf, n))):
                    keep_nearer(m, m.place, at(m.leaf, n), x, y, z, e, m.began, 0)
        else:  # the nearer one is looked at first
            swap = _apart(m, left, x, y, z) < _apart(m, right, x, y, z)
            put(m.stack, waiting, right if swap else left)
            put(m.stack, waiting + 1, left if swap else right)
            waiting += 2
    if at(m.face, (e, 0)) < 0:
        put(m.began, (e, 0), -math.inf)
        return -math.inf
    finish(m, m.place, x, y, z, e, m.began, 0)
    _far_side(m, e, m.began, 0)
    return at(m.began, (e, 0))


@part
def collect(m: Meeting, body: int, p: int, x: float, y: float, z: float, reach: float, begin: int) -> int:
    """Notes in `near` all triangles of a body within reach; returns one past the last, or -1 where there is no room.

    Args:
        m: the bodies that meet.
        body: whose triangles.
        p: which point.
        x: of the point [m].
        y: likewise.
        z: likewise.
        reach: >= 0 [m].
        begin: where in `near` there is room.
    """
    waiting, count, room, own = 1, begin, m.near.shape[0], body == at(m.part, p)
    put(m.stack, 0, at(m.boxes, body))
    while waiting > 0:
        waiting -= 1
        box = at(m.stack, waiting)
        if _apart(m, box, x, y, z) > reach * reach:
            continue
        left, right = at(m.child, (box, 0)), at(m.child, (box, 1))
        if left >= 0:
            put(m.stack, waiting, left)
            put(m.stack, waiting + 1, right)
            waiting += 2
            continue
        for n in range(-1 - left, -1 - left + right):
            f = at(m.leaf, n)
            if is_hidden(m, f):
                continue
            if _outside(m, m.place, f, x, y, z) > reach * reach or (own and _beside(m, p, f)):
                continue
            i, j, k = at(m.corner, (f, 0)), at(m.corner, (f, 1)), at(m.corner, (f, 2))
            square, _, _, _, _ = foot(m.place, i, j, k, x, y, z)
            if square <= reach * reach * (1.0 + _ALIKE):
                if count >= room:
                    return -1
                put(m.near, count, f)
                count += 1
    return count


@part
def follow(m: Meeting, e: int, x: float, y: float, z: float) -> float:
    """Depth of an entry's point where the step would end; row e of `ended` gets what belongs to it.

    Args:
        m: the bodies that meet.
        e: which entry.
        x: of the point [m].
        y: likewise.
        z: likewise.
    """
    if at(m.bound, 1) == 0.0:  # nothing moves
        for n in range(8):
            put(m.ended, (e, n), at(m.began, (e, n)))
        put(m.face, (e, 2), at(m.face, (e, 0)))
        put(m.face, (e, 3), at(m.face, (e, 1)))
        return at(m.ended, (e, 0))
    _clear(m, e, m.ended, 2, math.inf)
    first, last = at(m.first, (e, 0)), at(m.first, (e, 1))
    if at(m.face, (e, 0)) >= 0:  # most likely still the nearest
        keep_nearer(m, m.later, at(m.face, (e, 0)), x, y, z, e, m.ended, 2)
    if first >= 0:
        for n in range(first, last):
            keep_nearer(m, m.later, at(m.near, n), x, y, z, e, m.ended, 2)
    else:  # no room to note them: all of the body
        body, p = at(m.other, e), at(m.point, e)
        box, own = at(m.boxes, body), body == at(m.part, p)
        while box < at(m.boxes, body + 1):
            left, right = at(m.child, (box, 0)), at(m.child, (box, 1))
            if left < 0:
                for n in range(-1 - left, -1 - left + right):
                    if not (own and _beside(m, p, at(m.leaf, n))):
                        keep_nearer(m, m.later, at(m.leaf, n), x, y, z, e, m.ended, 2)
            box += 1
    if at(m.face, (e, 2)) < 0:
        put(m.ended, (e, 0), -math.inf)
        return -math.inf
    finish(m, m.later, x, y, z, e, m.ended, 2)
    _far_side(m, e, m.ended, 2)
    deep = at(m.ended, (e, 0))
    if deep > 0.0 and (appears(m, e) or beyond(m, e, x, y, z)):
        put(m.ended, (e, 0), -deep)
    return at(m.ended, (e, 0))


@part
def crossing(m: Meeting, e: int, x: float, y: float, z: float, mx: float, my: float, mz: float) -> tuple[int, int]:
    """The first triangle by which a point comes in on its way, and the last by which it goes out; -1: none.

    Args:
        m: the bodies.
        e: entry of the point.
        x: where it starts.
        y: likewise.
        z: likewise.
        mx: how far it moves.
        my: likewise.
        mz: likewise.
    """
    enters, leaves, early, late = -1, -1, math.inf, -math.inf
    body, p = at(m.other, e), at(m.point, e)
    noted, own = at(m.first, (e, 0)) >= 0, body == at(m.part, p)
    first = at(m.first, (e, 0)) if noted else at(m.leaves, body)
    for n in range(first, at(m.first, (e, 1)) if noted else at(m.leaves, body + 1)):
        f = at(m.near, n) if noted else n
        if not noted and (is_hidden(m, f) or (own and _beside(m, p, f))):  # no room to note them: all of the body
            continue
        i, j, k = at(m.corner, (f, 0)), at(m.corner, (f, 1)), at(m.corner, (f, 2))
        nx, ny, nz = normal(m.place, i, j, k)
        ox, oy, oz = normal(m.later, i, j, k)
        before = nx * (x - at(m.place, (i, 0))) + ny * (y - at(m.place, (i, 1))) + nz * (z - at(m.place, (i, 2)))
        after = ox * (x + mx - at(m.later, (i, 0))) + oy * (y + my - at(m.later, (i, 1)))
        after += oz * (z + mz - at(m.later, (i, 2)))
        if (before > 0.0) == (after > 0.0):
            continue
        when = before / (before - after)
        if not _hits(m, i, j, k, when, x + when * mx, y + when * my, z + when * mz):
            continue
        if before > 0.0 and when < early:
            enters, early = f, when
        if before <= 0.0 and when > late:
            leaves, late = f, when
    return enters, leaves


@part
def _hits(m: Meeting, i: int, j: int, k: int, when: float, x: float, y: float, z: float) -> bool:
    """Whether a point in a triangle's plane lies within it, at a share of the step."""
    ax, ay, az = _between(m, i, 0, when), _between(m, i, 1, when), _between(m, i, 2, when)
    ux, uy, uz = _between(m, j, 0, when) - ax, _between(m, j, 1, when) - ay, _between(m, j, 2, when) - az
    vx, vy, vz = _between(m, k, 0, when) - ax, _between(m, k, 1, when) - ay, _between(m, k, 2, when) - az
    px, py, pz = x - ax, y - ay, z - az
    uu, uv, vv = ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz
    up, vp = ux * px + uy * py + uz * pz, vx * px + vy * py + vz * pz
    size = uu * vv - uv * uv
    b, c = vv * up - uv * vp, uu * vp - uv * up
    slack = 1e-9 * size
    return size > 0.0 and b >= -slack and c >= -slack and b + c <= size + slack


@inner
def _between(m: Meeting, v: int, a: int, when: float) -> float:
    return (1.0 - when) * at(m.place, (v, a)) + when * at(m.later, (v, a))
