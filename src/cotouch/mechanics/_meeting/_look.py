"""Which points of which bodies may meet in a step, and the triangles that they may come to."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, inner, part, put
from cotouch.mechanics._meeting._asleep import around, doze, wake
from cotouch.mechanics._meeting._bodies import Meeting
from cotouch.mechanics._meeting._near import FAR_SIDE, collect, is_hidden, search
from cotouch.mechanics._meeting._world import World

# A step may go so many times as far as it would at the speed where it begins, before what is near is looked for anew.
_AHEAD = 1.5
# Where vertices move at most so many times as far as rows, it is not asked how far bodies move as a whole; and what
# rounding may add to that, as a factor.
_TELLS, _SURELY = 1.01, 1.0 + 1e-9
# And is looked for anew for a motion so many times shorter: what is far may be found instead of what is near.
_GENEROUS = 4.0


@inner
def point_at(world: World, p: int, x: Float) -> tuple[float, float, float]:
    """Where a point is.

    Args:
        world: obstacles and points.
        p: which point.
        x: displacements of the rows, (rows, 4) [m].
    """
    a, b, c = at(world.rest, (p, 0)), at(world.rest, (p, 1)), at(world.rest, (p, 2))
    for e in range(at(world.pointer, p), at(world.pointer, p + 1)):
        i, share = at(world.row, e), at(world.share, e)
        a, b, c = a + share * at(x, (i, 0)), b + share * at(x, (i, 1)), c + share * at(x, (i, 2))
    return a, b, c


@part
def _lay(m: Meeting, x: Float, body: int, out: Float) -> None:
    """Brings the vertices of a body to where it is."""
    for v in range(at(m.vertices, body), at(m.vertices, body + 1)):
        a, b, c = at(m.rest, (v, 0)), at(m.rest, (v, 1)), at(m.rest, (v, 2))
        for e in range(at(m.pointer, v), at(m.pointer, v + 1)):
            i, share = at(m.row, e), at(m.share, e)
            a, b, c = a + share * at(x, (i, 0)), b + share * at(x, (i, 1)), c + share * at(x, (i, 2))
        put(out, (v, 0), a)
        put(out, (v, 1), b)
        put(out, (v, 2), c)


@part
def _enclose(m: Meeting, body: int) -> None:
    """Box around every part of a body's tree where the step begins."""
    root = at(m.boxes, body)
    box = at(m.boxes, body + 1) - 1
    while box >= root:
        left, right = at(m.child, (box, 0)), at(m.child, (box, 1))
        for a in range(3):
            low, high = math.inf, -math.inf
            if left >= 0:
                low = min(at(m.low, (left, a)), at(m.low, (right, a)))
                high = max(at(m.high, (left, a)), at(m.high, (right, a)))
            else:
                for n in range(-1 - left, -1 - left + right):
                    for q in range(0 if is_hidden(m, at(m.leaf, n)) else 3):
                        own = at(m.place, (at(m.corner, (at(m.leaf, n), q)), a))
                        low, high = min(low, own), max(high, own)
            put(m.low, (box, a), low)
            put(m.high, (box, a), high)
        box -= 1


@inner
def _near(m: Meeting, one: int, two: int, reach: float) -> bool:
    """Whether the boxes of two bodies are within reach."""
    i, j = at(m.boxes, one), at(m.boxes, two)
    for a in range(3):
        if at(m.low, (i, a)) > at(m.high, (j, a)) + reach or at(m.low, (j, a)) > at(m.high, (i, a)) + reach:
            return False
    return True


@inner
def begin_bodies(m: Meeting | None, x: Float) -> None:
    """A step begins: what is near where is known only if it was looked for just here, and nothing was cut since.

    Args:
        m: the bodies that meet; None: there is one.
        x: displacements of the rows, (rows, 4) [m].
    """
    if m is not None and at(m.entries, 0) != 0:
        same = m.away < 0 and m.hidden.shape[0] == 0
        for i in range(x.shape[0]):
            for a in range(3):
                same = same and at(x, (i, a)) == at(m.looked, (i, a))
        if not same:
            put(m.entries, 0, 0)


@inner
def is_away(m: Meeting, memory: Float, body: int) -> bool:
    """Whether a body is another user's tool, which is not in this copy.

    Args:
        m: the bodies that meet.
        memory: of the copy, (numbers,).
        body: which one.
    """
    return m.away >= 0 and body < m.moves and at(memory, m.away + body) != 0.0


@inner
def point_away(m: Meeting | None, memory: Float, p: int) -> bool:
    """Whether a point is of a tool that is not in this copy.

    Args:
        m: the bodies that meet; None: there is one.
        memory: of the copy, (numbers,).
        p: which point.
    """
    if m is None:
        return False
    return is_away(m, memory, at(m.part, p))


@part
def gather(world: World, m: Meeting, memory: Float, x: Float, bound: float) -> None:
    """Looks which points may meet which body while no row moves farther than `bound`, and what is near them.

    Args:
        world: obstacles and points.
        m: the bodies that meet.
        memory: of the copy, (numbers,).
        x: displacements of the rows, (rows, 4) [m].
        bound: >= 0 [m].
    """
    bodies, reach, count, used = m.touched.shape[0], 2.0 * m.lever * bound, 0, 0
    for b in range(bodies):
        put(m.touched, b, 0)
        if is_away(m, memory, b):  # an empty box is near nothing
            for a in range(3):
                put(m.low, (at(m.boxes, b), a), math.inf)
                put(m.high, (at(m.boxes, b), a), -math.inf)
        elif b < m.moves:
            _lay(m, x, b, m.place)
            around(m, m.place, b, at(m.boxes, b), m.low, m.high)
    for one in range(bodies):
        for two in range(min(one, m.moves)):
            if _near(m, one, two, reach):
                put(m.touched, one, 1)
                put(m.touched, two, 1)
    for b in range(bodies):
        if at(m.within, b) > 0.0 and not is_away(m, memory, b):
            put(m.touched, b, 1)
        if at(m.touched, b) != 0 and b < m.moves:
            _enclose(m, b)
    for own in range(bodies):
        if at(m.touched, own) == 0:
            continue
        for p in range(at(m.points, own), at(m.points, own + 1)):
            if at(world.there, p) == 0.0:
                continue
            px, py, pz = point_at(world, p, x)
            for b in range(bodies if own < m.moves else m.moves):
                box = at(m.boxes, b)
                if (b == own and at(m.within, b) <= 0.0) or at(m.touched, b) == 0:
                    continue
                outside = max(at(m.low, (box, 0)) - px, px - at(m.high, (box, 0)))
                outside = max(outside, at(m.low, (box, 1)) - py, py - at(m.high, (box, 1)))
                outside = max(outside, at(m.low, (box, 2)) - pz, pz - at(m.high, (box, 2)))
                if outside > reach:
                    continue
                deep = search(m, b, p, px, py, pz, count, reach)
                if outside > 0.0 and b != own:  # of a skin turned inside out the nearest triangle says it is inside
                    put(m.began, (count, 0), -abs(deep))
                far = deep > -math.inf and at(m.face, (count, 1)) == FAR_SIDE  # must be known if it comes nearer
                if deep < -reach and not far:
                    continue
                last = collect(m, b, p, px, py, pz, (abs(deep) if far else max(deep, 0.0)) + 2.0 * reach, used)
                put(m.first, (count, 0), used if last >= 0 else -1)
                put(m.first, (count, 1), max(last, 0))
                used = max(last, used)
                count += 1
    put(m.entries, 0, 1)
    put(m.entries, 1, count)
    put(m.bound, 0, bound)
    for i in range(x.shape[0]):
        for a in range(3):
            put(m.looked, (i, a), at(x, (i, a)))


@inner
def _way(m: Meeting, x: Float, ahead: Float, i: int, about: int) -> float:
    """How far a row moves, beside the mean of its body's rows; `about` negative: beside nothing [m]."""
    square = 0.0
    for a in range(3):
        goes = at(ahead, (i, a)) - at(x, (i, a))
        if about >= 0:
            goes -= at(m.whole, (about, a))
        square += goes * goes
    return square


@part
def _farthest(m: Meeting, x: Float, ahead: Float) -> float:
    """How far rows move that carry vertices as far as those of a motion come at most [m].

    Shares of rows may be greater than 1, of a rigid body's masses above all; but they add up to about 1, so that what
    all rows of a body do together, its vertices do, and no more.
    """
    square = 0.0
    for i in range(x.shape[0]):
        square = max(square, _way(m, x, ahead, i, -1))
    farthest = math.sqrt(square)
    if m.lever <= _TELLS or farthest == 0.0:
        return farthest
    for b in range(m.moves):
        for a in range(4):
            put(m.whole, (b, a), 0.0)
    for i in range(x.shape[0]):
        b = at(m.body, i)
        for a in range(3):
            put(m.whole, (b, a), at(m.whole, (b, a)) + at(m.part_of, i) * (at(ahead, (i, a)) - at(x, (i, a))))
    for i in range(x.shape[0]):
        b = at(m.body, i)
        put(m.whole, (b, 3), max(at(m.whole, (b, 3)), _way(m, x, ahead, i, b)))
    most = 0.0
    for b in range(m.moves):
        mean = at(m.whole, (b, 0)) ** 2 + at(m.whole, (b, 1)) ** 2 + at(m.whole, (b, 2)) ** 2
        most = max(most, m.as_one * math.sqrt(mean) / m.lever + math.sqrt(at(m.whole, (b, 3))))
    return min(farthest, most * _SURELY)


@inner
def _note_deepest(m: Meeting) -> None:
    """Notes how deep any point that is not asleep is where the step begins, for each pair of bodies."""
    for one in range(m.touched.shape[0]):
        for two in range(m.touched.shape[0]):
            put(m.deepest, (one, two), 0.0)
    for e in range(at(m.entries, 1)):
        own, other, deep = at(m.part, at(m.point, e)), at(m.other, e), at(m.began, (e, 0))
        if deep > at(m.deepest, (own, other)):
            put(m.deepest, (own, other), deep)
            put(m.deepest, (other, own), deep)


@part
def make_ready(world: World, m: Meeting, memory: Float, x: Float, ahead: Float) -> None:
    """Makes sure that what is near is known for a motion, and brings the vertices of who meets to its end.

    Args:
        world: obstacles and points.
        m: the bodies that meet.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
    """
    farthest = _farthest(m, x, ahead)
    put(m.bound, 1, farthest)
    bound = max(_AHEAD * farthest, m.slack)
    if at(m.entries, 0) == 0 or farthest > at(m.bound, 0) or at(m.bound, 0) > _GENEROUS * bound:
        gather(world, m, memory, x, bound)
        doze(m, memory, world.first + 4 * world.kind.shape[0] * world.area.shape[0])
        _note_deepest(m)
    if at(m.entries, 1) > 0:
        for b in range(m.moves):
            if at(m.touched, b) != 0:
                _lay(m, ahead, b, m.later)
                put(m.least, (b, 3), 0.0)


@part
def settle_bodies(world: World, m: Meeting | None, memory: Float, x: Float) -> float:
    """What bodies hold between them where the copy is, without friction [J].

    Args:
        world: obstacles and points.
        m: the bodies that meet; None: there is one.
        memory: of the copy, (numbers,).
        x: displacements of the rows, (rows, 4) [m].
    """
    if m is None:
        return 0.0
    gather(world, m, memory, x, 0.0)
    put(m.entries, 0, 0)
    energy = 0.0
    for e in range(at(m.entries, 1)):
        deep = at(m.began, (e, 0))
        if deep > 0.0:
            p = at(m.point, e)
            firm = at(m.stiffness, (at(m.part, p), at(m.other, e)))
            energy += 0.5 * firm * at(world.area, p) * at(world.there, p) * deep * deep
    wake(m, memory, world.first + 4 * (world.told.shape[0] + world.kind.shape[0] * world.area.shape[0]))
    return energy
