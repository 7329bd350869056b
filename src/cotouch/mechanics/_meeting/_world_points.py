"""Where a body's skin meets what stands still around it: points, the area of each, and the rows that carry them."""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Float, Int, Long
from cotouch.body import Body, CutSkin, cut_skin
from cotouch.errors import BodyError, UnsupportedError
from cotouch.mechanics._linear._state import numbered
from cotouch.mechanics._meeting._bodies import Between
from cotouch.mechanics._meeting._skin import meeting_of, part_of_nodes, thickness_of
from cotouch.mechanics._meeting._tool_bodies import copies_of, rigid_rows
from cotouch.mechanics._meeting._tool_walls import Walls, spans_of, walls_of
from cotouch.mechanics._meeting._world import Obstacle, World, solids_of
from cotouch.mechanics._shapes._shape import NUMBERS, packed
from cotouch.mechanics._shapes._solid import Solid

Corners: TypeAlias = npt.NDArray[np.int64]

# Points of a skin are no farther apart than this share of the thinnest obstacle, and no more than so many.
_APART, MOST_POINTS = 0.5, 100_000
# Of the thinnest body so many times that: bodies' own edges are met by the other's faces as well.
_BODY = 2.0
# A body whose skin is less than so many times that of a long, round tool meets its wall by points of its own.
_OWN = 1.5
# Points lie so far within the triangles that they stand for, as a share of each: what stands on its edge is not felt by
# the walls above it. Triangles whose normals differ by less than this cosine are one side.
_WITHIN, _ALIKE = 0.025, 0.8
# How many units of rounding a place is uncertain by.
_ROUNDING = 10.0


class _Thin(NamedTuple):
    """How thin something is [m], its name, and how many times that others' points may be apart, of what may be."""

    size: float
    name: str
    share: float


def world_of(
    body: Body, obstacles: Sequence[Obstacle], between: Between | None, order: Int | None, first: int
) -> tuple[World, int]:
    """What a body's skin meets for the kernels, and how many more numbers a copy remembers.

    Args:
        body: whose skin meets them.
        obstacles: what stands still.
        between: what its parts do to each other; None: nothing. One of these there must be.
        order: row k of the kernels is node `order[k]`; None: node k.
        first: numbers that a copy remembers without them.

    Raises:
        UnsupportedError: the body has no skin.
        BodyError: an obstacle is too thin for the skin.
    """
    if body.dimension != 3 or body.skin is None or not body.skin.triangles.size:
        what = f"has {body.dimension} axes" if body.dimension != 3 else "has no skin"
        raise UnsupportedError(f"the body {what}; obstacles are met by a skin, so take a body from a mesh or a lattice")
    origin = body.rest.mean(axis=0)
    solids = solids_of(obstacles, body)
    shaped = [(one, one.shape) for one in obstacles if not isinstance(one.shape, Solid)]
    still = [one.shape for one in solids if isinstance(one.shape, Solid)]
    thin = [_Thin(shape.thickness(), "an obstacle", 1.0) for _, shape in shaped]
    if between is not None:
        thin += [_Thin(thickness_of(part.skin().vertices), part.name, _BODY) for part in body.parts]
        thin += [_Thin(thickness_of(one.vertices), "a solid obstacle", _BODY) for one in still]
    thinnest = min(thin, key=lambda one: one.share * one.size)
    faces = cut_skin(body) if body.cut_count else None
    skin = body.skin if faces is None else faces.skin
    weight = sp.csr_array(skin.interpolation(body.nodes))
    every: Long = np.arange(skin.triangles.shape[0], dtype=np.int64)
    if between is None:
        places, area, carry, parted = _points(skin.vertices, skin.triangles, weight, faces, thinnest, every)
    else:
        walls = walls_of(body, faces, _APART * thinnest.share * thinnest.size)
        groups = [(every, thinnest)] if not walls.tools else _apart(body, walls, faces, thinnest)
        found = [_points(skin.vertices, skin.triangles, weight, faces, thin, own) for own, thin in groups if own.size]
        places = np.concatenate([*(one[0] for one in found), walls.places])
        area = np.concatenate([*(one[1] for one in found), walls.area])
        carry = sp.csr_array(sp.vstack([*(one[2] for one in found), walls.carry]))
        parted = sp.csr_array(sp.vstack([*(one[3] for one in found), walls.part_of[:, : found[0][3].shape[1]]]))
    of, moves = np.zeros(places.shape[0], dtype=np.int32), places.shape[0]
    if between is not None:  # point after point of each body
        of = part_of_nodes(body)[carry.indices[carry.indptr[:-1]]]
        sort = np.argsort(of, kind="stable")
        of, places = of[sort], places[sort]
        # A tool is in one copy only, which meets all of it.
        area = area[sort] * copies_of(body)[of]
        carry, parted = sp.csr_array(carry[sort]), sp.csr_array(parted[sort])
    for number, solid in enumerate(still, start=len(body.parts)):
        bare = sp.csr_array((solid.vertices.shape[0], body.nodes))
        all_of: Long = np.arange(solid.triangles.shape[0], dtype=np.int64)
        more, beside, _, _ = _points(solid.vertices, solid.triangles, bare, None, thinnest, all_of)
        places, area = np.concatenate([places, more]), np.concatenate([area, beside])
        carry, parted = _with_empty(carry, more.shape[0]), _with_empty(parted, more.shape[0])
        of = np.append(of, np.full(more.shape[0], number, dtype=np.int32))
    if order is not None:
        carry = sp.csr_array(carry[:, order])
    carry.sort_indices()
    rest = np.zeros((places.shape[0], 4))
    rest[:, :3] = places - origin
    among = rigid_rows(body, order)
    shapes = [packed(shape, (float(origin[0]), float(origin[1]), float(origin[2]))) for _, shape in shaped]
    numbers = np.zeros((len(shapes), NUMBERS))
    for s, (_, own) in enumerate(shapes):
        numbers[s, : len(own)] = own
    stiffness = np.array([one.stiffness for one, _ in shaped])
    off = _ROUNDING * np.finfo(np.float64).eps * float(np.abs(rest).max())
    slots = len(shapes) + (between is not None)
    count = slots * places.shape[0]
    away, marks = (first, len(body.parts)) if body.tools else (-1, 0)  # before all that is forgotten
    first += marks
    # The inner faces are not there yet.
    hidden, shown = np.zeros(0, dtype=np.int32), np.ones(places.shape[0])
    if faces is not None:
        inner = (faces.beyond >= 0).astype(np.int32)
        hidden = np.append(inner, np.zeros(sum(one.triangles.shape[0] for one in still), dtype=np.int32))
        shown = np.where(parted @ inner > 0.0, 0.0, 1.0)
    firm = float(sum(one.stiffness for one in obstacles)) + (0.0 if between is None else between.stiffness)
    world = World(
        first=first,
        pointer=carry.indptr.astype(np.int32),
        row=carry.indices.astype(np.int32),
        share=np.ascontiguousarray(carry.data, dtype=np.float64),
        rest=rest,
        area=area,
        reach=float(abs(carry).sum(axis=1).max(initial=0.0)),
        moves=moves,
        kind=np.array([kind for kind, _ in shapes], dtype=np.int32),
        numbers=numbers,
        stiffness=stiffness,
        loss=np.array([one.loss for one, _ in shaped]),
        friction=np.array([one.friction for one, _ in shaped]),
        kinetic=np.array([one.friction if one.kinetic is None else one.kinetic for one, _ in shaped]),
        grain=off * off * firm * float(area[shown > 0.0].sum()),
        hold=np.zeros(body.nodes),
        among=numbered(among, body.nodes)[carry.indices],
        rigid=numbered(among, body.nodes),
        pairs=np.zeros((3 * among.size**2, 4)),
        couple=np.zeros((3 * among.size, 3 * among.size)),
        told=np.zeros((count, 4)),
        start=np.zeros((places.shape[0], 4)),
        deepest=np.zeros(len(shapes)),
        known=np.zeros(1),
        tried=np.zeros((body.nodes, 4)),
        force=np.zeros((len(obstacles), 4)),
        offset=-1 if faces is None else first + 8 * count,
        whole=shown,
        there=shown.copy(),
        pointer_of=parted.indptr.astype(np.int32),
        triangle=parted.indices.astype(np.int32),
        part_of=np.ascontiguousarray(parted.data, dtype=np.float64),
        hidden=hidden,
        gone=np.zeros(1),
        bodies=None if between is None else meeting_of(body, between, solids, carry, of, order, faces, hidden, away),
    )
    return world, marks + (8 if faces is None else 10) * count


def _with_empty(matrix: sp.csr_array, rows: int) -> sp.csr_array:
    """A matrix with so many rows more, in which nothing is."""
    return sp.csr_array(sp.vstack([matrix, sp.csr_array((rows, int(matrix.shape[1])))]))


def _apart(body: Body, walls: Walls, faces: CutSkin | None, thinnest: _Thin) -> list[tuple[Long, _Thin]]:
    """Triangles of each body that no wall of a long, round tool has, and what is thinnest to it."""
    spans, parts = spans_of(body, faces), body.parts
    corners = [part.skin().vertices[part.skin().triangles] for part in parts]
    area = [float(np.linalg.norm(np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0]), axis=1).sum()) for c in corners]
    groups: list[tuple[Long, _Thin]] = []
    for number in range(len(parts)):
        thin = [
            _Thin(thick, parts[tool].name, 1.0)
            for tool, thick in walls.tools.items()
            if tool != number and area[number] < _OWN * area[tool]
        ]
        own = walls.left[(walls.left >= spans[number]) & (walls.left < spans[number + 1])]
        groups.append((own, min([thinnest, *thin], key=lambda one: one.share * one.size)))
    return groups


def _points(
    vertices: Float, triangles: Int, carry: sp.csr_array, faces: CutSkin | None, thinnest: _Thin, origin: Corners
) -> tuple[Float, Float, sp.csr_array, sp.csr_array]:
    """Vertices of a skin, its triangles halved until no obstacle fits between: places, areas, and what carries them.

    Of the triangles with the numbers `origin` only.

    Of what can be cut also what share of each point each triangle of the skin makes, (P, F). There only what comes and
    goes together shares a point: what is cut away flies anywhere, and would take the point along.

    Raises:
        BodyError: there would be too many.
    """
    corners, places = np.asarray(triangles, dtype=np.int64)[origin], np.asarray(vertices, dtype=np.float64)[:, :3]
    longest = float(np.linalg.norm(places[corners] - places[np.roll(corners, -1, axis=1)], axis=2).max())
    apart = _APART * thinnest.share * thinnest.size
    coarse = places, corners, carry, origin
    while longest > apart and 4 * places.shape[0] <= MOST_POINTS:
        places, corners, carry = _halved(places, corners, carry)
        origin = np.tile(origin, 4)
        longest *= 0.5
    if longest > apart:  # too many, if short triangles beside long ones are halved as often
        places, corners, carry, origin = coarse
    while longest > apart:
        places, corners, carry, origin, longest = shortened(places, corners, carry, origin, apart)
        if places.shape[0] > MOST_POINTS:
            raise BodyError(
                f"{thinnest.name} is {thinnest.size:.3g} m thin, so points of a skin that may meet it must be at most "
                f"{apart:.3g} m apart, which takes more than {MOST_POINTS:,}; make it thicker, or the skin smaller"
            )
    edges = places[corners[:, 1:]] - places[corners[:, :1]]
    normal = 0.5 * np.cross(edges[:, 0], edges[:, 1])
    area = np.linalg.norm(normal, axis=1)
    sound = area > 0.0
    corners, normal, area, origin = corners[sound], normal[sound], area[sound], origin[sound]
    fate = None if faces is None else faces.side[origin]
    side = _sides(corners, normal / area[:, None], fate)
    # Each corner of each triangle, a little within it, for a third of its area; those of one side are one point.
    share = np.full((3, 3), _WITHIN) + (1.0 - 3.0 * _WITHIN) * np.eye(3)
    mean = sp.csr_array(
        (
            (np.repeat(area, 9) / 3.0 * np.tile(share.ravel(), area.size)),
            (np.repeat(side.ravel(), 3), np.repeat(corners, 3, axis=0).ravel()),
        ),
        shape=(int(side.max()) + 1, places.shape[0]),
    )
    own: Float = np.bincount(side.ravel(), weights=np.repeat(area / 3.0, 3)).astype(np.float64)
    mean = sp.csr_array(sp.diags_array(1.0 / own) @ mean)
    carry = sp.csr_array(mean @ carry)
    carry.sum_duplicates()
    carry.eliminate_zeros()
    parted = sp.csr_array((own.size, 0))
    if faces is not None:
        third = np.repeat(area, 3) / 3.0 / own[side.ravel()]
        entries = side.ravel(), np.repeat(origin, 3)
        parted = sp.csr_array((third, entries), shape=(own.size, faces.beyond.size))
        parted.sum_duplicates()
    return mean @ places, own, carry, parted


def _sides(corners: Corners, normal: Float, fate: Corners | None) -> Corners:
    """Numbers the sides of every vertex: triangles that meet there and look the same way belong to one; (F, 3).

    Of what can be cut, those of one `fate` only, which come and go together.
    """
    result, count = np.zeros(corners.shape, dtype=np.int64), 0
    place = np.argsort(corners.ravel(), kind="stable")
    ends = np.flatnonzero(np.diff(corners.ravel()[place], append=-1)) + 1
    for begin, end in zip(np.concatenate([[0], ends[:-1]]), ends, strict=True):
        found: list[tuple[Float, int]] = []
        for entry in place[begin:end]:
            own, face = normal[entry // 3], -1 if fate is None else int(fate[entry // 3])
            alike = [n for n, (other, beside) in enumerate(found) if face == beside and float(own @ other) >= _ALIKE]
            if not alike:
                found.append((own, face))
            result.flat[entry] = count + (alike[0] if alike else len(found) - 1)
        count += len(found)
    return result


def _halved(places: Float, corners: Corners, carry: sp.csr_array) -> tuple[Float, Corners, sp.csr_array]:
    """Every triangle as four."""
    ends = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    sides, number = np.unique(ends, axis=0, return_inverse=True)
    middle = places.shape[0] + number.reshape(-1, 3)
    a, b, c = corners.T
    ab, bc, ca = middle.T
    finer: Corners = np.concatenate(
        [np.stack(t, axis=1) for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))]
    )
    between = sp.csr_array(0.5 * (carry[sides[:, 0]] + carry[sides[:, 1]]))
    return (
        np.concatenate([places, 0.5 * (places[sides[:, 0]] + places[sides[:, 1]])]),
        finer,
        sp.csr_array(sp.vstack([carry, between])),
    )


def shortened(
    places: Float, corners: Corners, carry: sp.csr_array, origin: Corners, apart: float
) -> tuple[Float, Corners, sp.csr_array, Corners, float]:
    """Halves every edge longer than that, so that a triangle becomes two to four; neighbours still meet.

    Args:
        places: vertices, (V, 3) [m].
        corners: of each triangle, (F, 3).
        carry: how vertices follow from others, (V, others).
        origin: from which triangle each came, (F,).
        apart: how long an edge may be [m].

    Returns:
        The first four anew, and the length of the longest edge that is left [m].
    """
    ends = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    sides, number = np.unique(ends, axis=0, return_inverse=True)
    long = np.linalg.norm(places[sides[:, 0]] - places[sides[:, 1]], axis=1) > apart
    middle = np.where(long, places.shape[0] - 1 + np.cumsum(long), -1)[number.reshape(-1, 3)]
    cut = middle >= 0
    count = cut.sum(axis=1)
    # Turned so that the only long edge comes first, or the only short one last.
    first = np.where(count == 1, cut.argmax(axis=1), np.where(count == 2, cut.argmin(axis=1) + 1, 0))
    turn = (first[:, None] + np.arange(3)) % 3
    (a, b, c), (ab, bc, ca) = np.take_along_axis(corners, turn, 1).T, np.take_along_axis(middle, turn, 1).T
    pieces = (
        (count == 0, ((a, b, c),)),
        (count == 1, ((a, ab, c), (ab, b, c))),
        (count == 2, ((ab, b, bc), (a, ab, bc), (a, bc, c))),
        (count == 3, ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))),
    )
    finer: Corners = np.concatenate([np.stack(t, axis=1)[own] for own, split in pieces for t in split])
    origin = np.concatenate([origin[own] for own, split in pieces for _ in split])
    halves = sides[long]
    places = np.concatenate([places, 0.5 * (places[halves[:, 0]] + places[halves[:, 1]])])
    carry = sp.csr_array(sp.vstack([carry, sp.csr_array(0.5 * (carry[halves[:, 0]] + carry[halves[:, 1]]))]))
    longest = float(np.linalg.norm(places[finer] - places[np.roll(finer, -1, axis=1)], axis=2).max())
    return places, finer, carry, origin, longest
