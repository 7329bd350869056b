"""Where a sphere touches a surface: the places at which the distance to its centre is a local minimum.

One sphere on a flat of many triangles has one contact, in a valley two, in a dent as many as there are. A triangle
knows only its own nearest point; that point is a local minimum of the whole surface exactly if every triangle that
meets there says the same, so it is enough to count. They agree because what they share is worked out alike, see
`nearest_point`.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.mechanics._kernel import block, inner, part
from cotouch.mechanics._surface import Fit, Surface, box_distance, place_vertex
from cotouch.mechanics._triangle import nearest_point

Int = npt.NDArray[np.int32]

# Triangles whose nearest points one search compares; more, and the farthest are left out.
MOST_HITS = 512
_DEPTH = 64
# Two contacts of one sphere closer than this share of its radius are one.
_SAME = 1e-6
# Hits closer than this share of it may be one that rounding has split.
_CLOSE = 1e-9
# A centre this close to the skin is on it, and the way out is along the normal [m].
_ON = 1e-12


class Hits(NamedTuple):
    """Scratch of one search.

    Attributes:
        feature: where the nearest point of some triangles is, (MOST_HITS,).
        seen: how many triangles said so, (MOST_HITS,).
        triangle: one of them, (MOST_HITS,).
        fraction: of its corners in the point, (MOST_HITS, 4).
        away: from the point to the centre of the sphere, (MOST_HITS, 4) [m].
        distance: (MOST_HITS,) [m].
        normal: sum of their normals, weighted by their angles there, (MOST_HITS, 4).
        stack: boxes still to be looked at, (_DEPTH,).
        near: result of `nearest_point`: share of the corners, then the point, (2, 4).
    """

    feature: Int
    seen: Int
    triangle: Int
    barycentric: Float
    away: Float
    distance: Float
    normal: Float
    stack: Int
    near: Float


class Contacts(NamedTuple):
    """What touches, or may touch within a step; `number[0]` of them.

    Attributes:
        tool: which sphere, (most,).
        triangle: of the skin, (most,).
        fraction: of its corners in the point of contact, (most, 4).
        normal: outward, from the skin to the sphere, (most, 4).
        depth: penetration, negative for a gap, (most,) [m].
        number: (1,).
    """

    tool: Int
    triangle: Int
    barycentric: Float
    normal: Float
    depth: Float
    number: Int


def hits() -> Hits:
    """Scratch of a search."""
    return Hits(
        feature=np.zeros(MOST_HITS, dtype=np.int32),
        seen=np.zeros(MOST_HITS, dtype=np.int32),
        triangle=np.zeros(MOST_HITS, dtype=np.int32),
        barycentric=np.zeros((MOST_HITS, 4)),
        away=np.zeros((MOST_HITS, 4)),
        distance=np.zeros(MOST_HITS),
        normal=np.zeros((MOST_HITS, 4)),
        stack=np.zeros(_DEPTH, dtype=np.int32),
        near=np.zeros((2, 4)),
    )


def contacts(most: int) -> Contacts:
    """Room for at most so many contacts."""
    return Contacts(
        tool=np.zeros(most, dtype=np.int32),
        triangle=np.zeros(most, dtype=np.int32),
        barycentric=np.zeros((most, 4)),
        normal=np.zeros((most, 4)),
        depth=np.zeros(most),
        number=np.zeros(1, dtype=np.int32),
    )


@inner
def _dot(a: Float, i: int, b: Float, j: int) -> float:
    return a[i, 0] * b[j, 0] + a[i, 1] * b[j, 1] + a[i, 2] * b[j, 2]


@part
def _angle(place: Float, i: int, j: int, k: int) -> float:
    """Angle of a triangle at its corner i [rad]."""
    dot = square = other = 0.0
    for a in range(3):
        p, q = place[j, a] - place[i, a], place[k, a] - place[i, a]
        dot += p * q
        square += p * p
        other += q * q
    size = math.sqrt(square * other)
    return 0.0 if size == 0.0 else math.acos(min(max(dot / size, -1.0), 1.0))


@part
def _add_hit(
    surface: Surface, fit: Fit, hits: Hits, count: int, triangle: int, where: int, centre: Float, t: int
) -> int:
    """Notes what one triangle said; returns the new number of hits."""
    ia, ib, ic = surface.corner[triangle, 0], surface.corner[triangle, 1], surface.corner[triangle, 2]
    edges = surface.meeting.shape[0]
    feature = edges + triangle
    if where < 3:
        feature = surface.corner[triangle, where]
    elif where < 6:
        feature = surface.edge[triangle, where - 3]
    slot = 0
    while slot < count and hits.feature[slot] != feature:
        slot += 1
    if slot == count:
        square = 0.0
        for a in range(3):
            gap = centre[t, a] - hits.near[1, a]
            square += gap * gap
        distance = math.sqrt(square)
        if count == MOST_HITS:  # in place of the farthest; what falls out does not come back
            slot = 0
            for other in range(1, count):
                if hits.distance[other] > hits.distance[slot]:
                    slot = other
            if distance >= hits.distance[slot]:
                return count
        else:
            count += 1
        hits.feature[slot] = feature
        hits.seen[slot] = 0
        hits.triangle[slot] = triangle
        hits.distance[slot] = distance
        for a in range(3):
            hits.barycentric[slot, a] = hits.near[0, a]
            hits.away[slot, a] = centre[t, a] - hits.near[1, a]
            hits.normal[slot, a] = 0.0
    hits.seen[slot] += 1
    place = fit.place
    ux, uy, uz = place[ib, 0] - place[ia, 0], place[ib, 1] - place[ia, 1], place[ib, 2] - place[ia, 2]
    vx, vy, vz = place[ic, 0] - place[ia, 0], place[ic, 1] - place[ia, 1], place[ic, 2] - place[ia, 2]
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size = math.sqrt(nx * nx + ny * ny + nz * nz)
    if size > 0.0:
        weight = 1.0 / size
        if where == 0:
            weight *= _angle(place, ia, ib, ic)
        elif where == 1:
            weight *= _angle(place, ib, ic, ia)
        elif where == 2:
            weight *= _angle(place, ic, ia, ib)
        hits.normal[slot, 0] += weight * nx
        hits.normal[slot, 1] += weight * ny
        hits.normal[slot, 2] += weight * nz
    return count


@part
def _search(
    surface: Surface,
    fit: Fit,
    hits: Hits,
    centre: Float,
    t: int,
    reach: float,
    position: Float,
    lanes: tuple[int, ...],
) -> int:
    """Nearest points of all triangles within reach of a centre; returns how many different ones."""
    x, y, z = centre[t, 0], centre[t, 1], centre[t, 2]
    limit = reach * reach
    count, waiting = 0, 1
    hits.stack[0] = 0
    while waiting > 0:
        waiting -= 1
        box = hits.stack[waiting]
        if not box_distance(surface, fit, box, x, y, z, position, lanes) <= limit:
            continue
        left, right = surface.child[box, 0], surface.child[box, 1]
        if left >= 0:
            hits.stack[waiting] = left
            hits.stack[waiting + 1] = right
            waiting += 2
            continue
        for place in range(-1 - left, -1 - left + right):
            triangle = surface.leaf[place]
            ia, ib, ic = surface.corner[triangle, 0], surface.corner[triangle, 1], surface.corner[triangle, 2]
            place_vertex(surface, fit, ia, position, lanes)
            place_vertex(surface, fit, ib, position, lanes)
            place_vertex(surface, fit, ic, position, lanes)
            where = nearest_point(fit.place, ia, ib, ic, x, y, z, hits.near)
            square = 0.0
            for a in range(3):
                gap = centre[t, a] - hits.near[1, a]
                square += gap * gap
            if square <= limit:
                count = _add_hit(surface, fit, hits, count, triangle, where, centre, t)
    return count


@part
def _merge(hits: Hits, count: int, slot: int, close: float) -> None:
    """Sum of the normals of all that lies where a hit does, into row 0 of `near`.

    Over an edge, one triangle may by rounding say that the point is inside of it and the other that it is on the edge;
    on which side of the skin a centre is takes both.
    """
    hits.near[0, 0], hits.near[0, 1], hits.near[0, 2] = 0.0, 0.0, 0.0
    for other in range(count):
        square = 0.0
        for a in range(3):
            gap = hits.away[other, a] - hits.away[slot, a]
            square += gap * gap
        if square <= close * close:
            for a in range(3):
                hits.near[0, a] += hits.normal[other, a]


@block
def touching(
    surface: Surface,
    fit: Fit,
    hits: Hits,
    found: Contacts,
    tool: int,
    centre: Float,
    radius: float,
    margin: float,
    inside: bool,
    position: Float,
    lanes: tuple[int, ...],
) -> bool:
    """Adds the contacts of one sphere.

    Args:
        surface: the skin.
        fit: where it is.
        hits: scratch.
        found: result; contacts are added.
        tool: index of the sphere.
        centre: of all spheres, (tools, 4) [m].
        radius: of this one [m].
        margin: gaps up to it count, because they may close within the step [m].
        inside: whether the centre may be inside the body, because it was before or nobody looked; the way out is then
            looked for however far it is.
        position: displacement in the model's rows.
        lanes: fixes the width.

    Returns:
        Whether the centre is inside the body now.
    """
    reach = radius + margin
    count = _search(surface, fit, hits, centre, tool, reach, position, lanes)
    if inside:
        for _ in range(60):
            if count > 0:
                break
            reach *= 2.0
            count = _search(surface, fit, hits, centre, tool, reach, position, lanes)
    if count == 0:
        return False
    best = 0
    for slot in range(1, count):
        if hits.distance[slot] < hits.distance[best]:
            best = slot
    _merge(hits, count, best, _CLOSE * radius)
    within = _dot(hits.away, best, hits.near, 0) < 0.0 and hits.distance[best] > _ON
    first = found.number[0]
    for slot in range(count):
        feature = hits.feature[slot]
        if within:
            if slot == best:
                _keep(hits, found, slot, tool, radius + hits.distance[slot], -1.0)
        elif feature >= surface.meeting.shape[0] or hits.seen[slot] == surface.meeting[feature]:
            _merge(hits, count, slot, _CLOSE * radius)
            facing = _dot(hits.away, slot, hits.near, 0)
            if (facing >= 0.0 or hits.distance[slot] <= _ON) and hits.distance[slot] <= radius + margin:
                twin = False
                for other in range(first, found.number[0]):
                    gap = 0.0
                    for a in range(3):
                        step = (radius - found.depth[other]) * found.normal[other, a] - hits.away[slot, a]
                        gap += step * step
                    twin = twin or gap < (_SAME * radius) ** 2
                if not twin:
                    _keep(hits, found, slot, tool, radius - hits.distance[slot], 1.0)
    return within


@part
def _keep(hits: Hits, found: Contacts, slot: int, tool: int, depth: float, sign: float) -> None:
    """Adds a contact; with no room left, in place of the shallowest if that is shallower."""
    most = found.depth.shape[0]
    c = found.number[0]
    if c == most:
        c = 0
        for other in range(1, most):
            if found.depth[other] < found.depth[c]:
                c = other
        if found.depth[c] >= depth:
            return
    else:
        found.number[0] = c + 1
    found.tool[c] = tool
    found.triangle[c] = hits.triangle[slot]
    found.depth[c] = depth
    size = hits.distance[slot]
    for a in range(3):
        found.barycentric[c, a] = hits.barycentric[slot, a]
        found.normal[c, a] = sign * hits.away[slot, a]
    if size <= _ON:
        size = math.sqrt(_dot(hits.near, 0, hits.near, 0))
        for a in range(3):
            found.normal[c, a] = hits.near[0, a]
    for a in range(3):
        found.normal[c, a] = found.normal[c, a] / size if size > 0.0 else (1.0 if a == 2 else 0.0)
