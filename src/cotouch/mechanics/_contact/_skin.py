"""How a tool reads and loads the skin: which triangles are near, how fast vertices are, and what they carry."""
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float, Int
from cotouch.kernels import FOUR, at, four, inner, load, lower, part, put, size, splat, store, total, transposed, upper
from cotouch.kernels.matrix3 import Vector
from cotouch.mechanics._contact._beads import bead_place
from cotouch.mechanics._contact._near import touched
from cotouch.mechanics._contact._patch import overlap
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._state import State
from cotouch.mechanics._materials._fours import Quad, corner_rows, elements, four_rows
from cotouch.mechanics._model._fit import box_distance, farthest, place_vertex
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import Tools


@part
def fastest(surface: Surface, velocity: Float, lanes: tuple[int, ...]) -> float:
    """A bound on the speed of every vertex [m/s].

    Args:
        surface: the skin.
        velocity: of the rows, (rows, width) [m/s].
        lanes: fixes the width of a row.
    """
    rows, width = velocity.shape[0], velocity.shape[1]
    square = 0.0
    if surface.shape.shape[0] > 0:  # of the whole tree's box: its mean shape and what shapes differ from it
        for a in range(3):
            most = 0.0
            for i in range(rows):
                rate = abs(velocity[i, a if width > 1 else 0])
                most += rate * (abs(surface.lean[i, a]) + surface.spread[i, a])
            square += most * most
        return math.sqrt(square)
    if width > 1:
        return surface.swing * math.sqrt(farthest(velocity, velocity, 0.0, lanes))
    for i in range(rows):
        square = max(square, 3.0 * velocity[i, 0] * velocity[i, 0])
    return math.sqrt(square)


@inner
def found_fastest(surface: Surface, work: ContactWork, mean: Float, lanes: tuple[int, ...]) -> float:
    """`fastest` after a solve, of which `say` found the fastest row.

    Args:
        surface: the skin.
        work: `quick` is that of the fastest row.
        mean: velocity that was solved for, (rows, width) [m/s].
        lanes: fixes the width of a row.
    """
    if surface.shape.shape[0] == 0 and mean.shape[1] > 1:
        return surface.swing * work.quick[0]
    return fastest(surface, mean, lanes)


@part
def look_around(
    surface: Surface, work: ContactWork, tools: Tools, t: int, reach: float, position: Float, lanes: tuple[int, ...]
) -> None:
    """Notes every triangle that is no farther from the middle of a tool, its vertices, and how far all are at least.

    Args:
        surface: the skin.
        work: what is near is written.
        tools: the proxies.
        t: which of them.
        reach: how far from its middle it looks, > 0 [m].
        position: displacements of the rows, (rows, width) [m].
        lanes: fixes the width of a row.
    """
    fit, stack, near = work.fit, work.stack, work.near
    place, corner, child, leaf, fresh = fit.place, surface.corner, surface.child, surface.leaf, fit.fresh
    forget_hits(work, t)
    least = reach * reach
    x, y, z = tools.place[t, 0], tools.place[t, 1], tools.place[t, 2]
    middle, zero = four(x, y, z, 0.0), splat(0.0, FOUR)
    count, vertices, waiting = 0, 0, 1
    work.turn[0] += 1
    stack[0] = 0
    while waiting > 0:
        waiting -= 1
        box = at(stack, waiting)
        if not box_distance(surface, fit, box, x, y, z, position, lanes) <= reach * reach:
            continue
        left, right = at(child, (box, 0)), at(child, (box, 1))
        if left >= 0:
            stack[waiting], stack[waiting + 1] = left, right
            waiting += 2
            continue
        for member in range(-1 - left, -1 - left + right):
            f = at(leaf, member)
            if at(fit.hidden, f) != 0:
                continue
            low, high = splat(math.inf, FOUR), splat(-math.inf, FOUR)
            for q in range(3):
                v = at(corner, (f, q))
                if at(fresh, v) != at(fit.number, 0):
                    place_vertex(surface, fit, v, position, lanes)
                vertex = load(place, v, FOUR)
                low, high = lower(low, vertex), upper(high, vertex)
            apart = upper(upper(low - middle, middle - high), zero)
            gap = total(apart * apart)
            if gap <= reach * reach:
                near[t, count] = f
                count += 1
                least = min(least, gap)
                for q in range(3):
                    v = at(corner, (f, q))
                    if at(work.read, v) != at(work.turn, 0):
                        put(work.read, v, at(work.turn, 0))
                        put(work.vertex, (t, vertices), v)
                        vertices += 1
    work.number[t], work.vertices[t], work.clear[t] = count, vertices, math.sqrt(least)


@part
def reach_of(surface: Surface, tools: Tools, t: int) -> float:
    """How far from the middle of one of its balls the skin may act on a tool [m].

    Args:
        surface: the skin.
        tools: the proxies.
        t: which of them.
    """
    return tools.radius[t] + max(surface.relief.top, tools.snap_range[t])


@part
def length_of(rows: Float, row: int) -> float:
    """Length of the vector in a row, in its unit.

    Args:
        rows: (rows, 3 or more).
        row: which of them.
    """
    return math.sqrt(rows[row, 0] ** 2 + rows[row, 1] ** 2 + rows[row, 2] ** 2)


@part
def follow(
    surface: Surface,
    work: ContactWork,
    tools: Tools,
    t: int,
    T: float,
    state: State,
    mean: Float,
    lanes: tuple[int, ...],
) -> bool:
    """Reads how fast the skin near one tool moves by the present guess; what it may come to is near, too.

    Args:
        surface: the skin.
        work: what is near, and `rate`, are written.
        tools: the proxies.
        t: which of them.
        T: length of the step [s].
        state: of the copy.
        mean: mean velocity of the rows, (rows, width) [m/s].
        lanes: fixes the width of a row.

    Returns:
        Whether what was near is in its place, so that what the last look gathered still says where the tool presses.
    """
    travel = (
        reach_of(surface, tools, t) + length_of(tools.axis, t) + 1.25 * T * (work.quick[0] + length_of(work.mean, t))
    )
    same = not travel > work.seen[t]
    if not same:  # faster than it was thought to be
        work.seen[t] = 1.5 * travel
        look_around(surface, work, tools, t, work.seen[t], state.position, lanes)
    read_rates(surface, work, t, mean, lanes)
    return same


@part
def place_bead(work: ContactWork, tools: Tools, t: int, bead: int, time: float) -> None:
    """Writes where one ball of a tool is after it moved for some time, into row 3 of `spot`.

    Args:
        work: `mean` says how the tool moves; `spot` is written.
        tools: the proxies.
        t: which of them.
        bead: which of its balls, from 0.
        time: how long it moved [s].
    """
    along, spot = bead_place(tools, t, bead), work.spot
    for a in range(3):
        spot[3, a] = tools.place[t, a] + along * tools.axis[t, a] + time * work.mean[t, a]
    spot[3, 3] = 0.0


@part
def place_face(work: ContactWork, face: int, corner: Int, time: float) -> float:
    """Writes where the corners of a triangle are after they moved for some time, into rows 0 to 2 of `spot`.

    Args:
        work: `rate` says how vertices move; `spot` is written.
        face: which triangle.
        corner: vertices of each triangle, (F, 3).
        time: how long they moved [s].

    Returns:
        Square of the distance of the point in row 3 from the box around them [m²].
    """
    place, rate, spot = work.fit.place, work.rate, work.spot
    middle = load(spot, 3, FOUR)
    low = high = load(place, corner[face, 0], FOUR) + time * load(rate, corner[face, 0], FOUR)
    store(spot, 0, low, FOUR)
    for q in range(1, 3):
        moved = load(place, corner[face, q], FOUR) + time * load(rate, corner[face, q], FOUR)
        store(spot, q, moved, FOUR)
        low, high = lower(low, moved), upper(high, moved)
    gap = upper(upper(low - middle, middle - high), splat(0.0, FOUR))
    return total(gap * gap)


@part
def meet_four(work: ContactWork, corner: Int, t: int, first: int, time: float, radius: float) -> bool:
    """Where four of the triangles near a tool lie in the ball in row 3 of `spot`, after they moved for some time.

    Args:
        work: `met` gets what `overlap` finds.
        corner: vertices of the triangles.
        t: the tool.
        first: which of those near it is the first of the four; the last stands in for what there is not.
        time: how long they moved [s].
        radius: of the ball [m].

    Returns:
        Whether any does.
    """
    own = t * work.near.shape[1]
    a, b, c, d = elements(first, work.number[t] - 1)
    faces = at(work.near, own + a), at(work.near, own + b), at(work.near, own + c), at(work.near, own + d)
    one, two, three = (
        corner_rows(corner, 3, faces, 0),
        corner_rows(corner, 3, faces, 1),
        corner_rows(corner, 3, faces, 2),
    )
    square = splat(radius * radius, FOUR)
    return overlap(_seen(work, one, time), _seen(work, two, time), _seen(work, three, time), square, work.met)


@inner
def _seen(work: ContactWork, v: Quad, time: float) -> Vector:
    """Where four vertices are after they moved for some time, from the point in row 3 of `spot`."""
    middle, place, rate = load(work.spot, 3, FOUR), four_rows(work.fit.place, v), four_rows(work.rate, v)
    x, y, z, _ = transposed(
        (place[0] - middle) + time * rate[0],
        (place[1] - middle) + time * rate[1],
        (place[2] - middle) + time * rate[2],
        (place[3] - middle) + time * rate[3],
    )
    return x, y, z


@part
def forget_hits(work: ContactWork, t: int) -> None:
    """Begins with no triangle that a tool does anything on.

    Args:
        work: `hits` and `load` are emptied.
        t: which tool.
    """
    faces = work.near.shape[1]
    for n in range(work.hits[t]):
        store(work.load, t * faces + work.hit[t, n], splat(0.0, FOUR), FOUR)
    work.hits[t] = 0


@part
def note_hit(work: ContactWork, t: int, c: int) -> None:
    """Notes that a tool does something on one of the triangles near it.

    Args:
        work: `hits`, `hit` and `load` are written.
        t: which tool.
        c: which of the triangles near it.
    """
    place = t * work.near.shape[1] + c
    if work.load[place, 3] == 0.0:
        work.load[place, 3] = 1.0
        work.hit[t, work.hits[t]] = c
        work.hits[t] += 1


@part
def read_rates(surface: Surface, work: ContactWork, t: int, mean: Float, lanes: tuple[int, ...]) -> None:
    """Works out how fast the vertices near a tool move.

    Args:
        surface: the skin.
        work: `vertex` says which are near; `rate` is written.
        t: which tool.
        mean: mean velocity of the rows, (rows, width) [m/s].
        lanes: fixes the width of a row.
    """
    row, weight, shape = surface.row, surface.weight, surface.shape
    rate, modal, rows = work.rate, surface.shape.shape[0] > 0, mean.shape[0]
    for n in range(work.vertices[t]):
        v = at(work.vertex, (t, n))
        speed = splat(0.0, FOUR)
        if modal:
            for i in range(rows):
                speed = speed + load(mean, i, lanes) * load(shape, v * rows + i, FOUR)
            store(rate, v, speed, FOUR)
        elif row.shape[2] == 1:
            for k in range(row.shape[1]):
                speed = speed + at(weight, (v, k)) * load(mean, at(row, (v, k, 0)), FOUR)
            store(rate, v, speed, FOUR)
        else:
            for a in range(3):
                value = 0.0
                for k in range(row.shape[1]):
                    value += weight[v, k] * mean[row[v, k, a], 0]
                rate[v, a] = value


@part
def load_rows(surface: Surface, work: ContactWork, t: int, diagonal: Float) -> None:
    """Hands on to the body's rows what the vertices that a tool acts on carry, and takes it off them.

    Args:
        surface: the skin.
        work: `force`, `firm` and `apart` of the vertices; `push`, `hold`, `stiff` and `yields` are added to.
        t: the tool.
        diagonal: of a modal body's system without contacts [Ns/m].
    """
    corner, near, hit = surface.corner, work.near, work.hit
    for n in range(work.hits[t]):
        f = at(near, (t, at(hit, (t, n))))
        for q in range(3):
            v = at(corner, (f, q))
            if at(work.firm, v) + at(work.apart, v) != 0.0 or total(size(load(work.force, v, FOUR))) != 0.0:
                _load_vertex(surface, work, v, diagonal)
    for q in range(3 if work.caught[t, 0] != 0.0 else 0):
        _load_vertex(surface, work, at(corner, (int(work.caught[t, 1]), q)), diagonal)


@part
def _load_vertex(surface: Surface, work: ContactWork, v: int, diagonal: Float) -> None:
    row, weight, shape, force, push, hold = surface.row, surface.weight, surface.shape, work.force, work.push, work.hold
    ward, stiff, rows, wide = work.ward, work.stiff, push.shape[0], push.shape[1] > 1
    firm, apart = work.firm[v], work.apart[v]
    whole = firm + apart
    if shape.shape[0] > 0:
        for a in range(3):
            for i in range(rows):
                share = shape[v * rows + i, a]
                push[i, a if wide else 0] += force[v, a] * share
                if a == 0 or not wide:
                    work.yields[a] += whole * share * share / diagonal[i]
    elif row.shape[2] == 1:
        along = load(ward, v, FOUR)
        square = total(along * along)
        own = firm / square if square > 0.0 else 0.0
        for k in range(row.shape[1]):
            share, i = at(weight, (v, k)), at(row, (v, k, 0))
            store(push, i, load(push, i, FOUR) + share * load(force, v, FOUR), FOUR)
            place = 3 * touched(work, i)
            share = at(surface.lever, v) * abs(share)  # one below 0, of what is rigid, resists as well
            hold[i] += share * whole
            for a in range(3):
                store(stiff, place + a, load(stiff, place + a, FOUR) + (share * own * at(ward, (v, a))) * along, FOUR)
                stiff[place + a, a] += share * apart
    else:
        for a in range(3):
            for k in range(row.shape[1]):
                share, i = weight[v, k], row[v, k, a]
                push[i, 0] += share * force[v, a]
                hold[i] += share * whole
                stiff[3 * touched(work, i), 0] += share * whole
    store(force, v, splat(0.0, FOUR), FOUR)
    work.firm[v], work.apart[v] = 0.0, 0.0
