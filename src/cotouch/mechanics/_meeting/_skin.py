"""The skins of several bodies in the form in which they meet: vertices, triangles, and trees of boxes around these."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float, Int, Long
from cotouch.body import Body, CutSkin
from cotouch.mechanics._meeting._bodies import Between, Meeting, Met, Parts
from cotouch.mechanics._meeting._own import own_of, unmet
from cotouch.mechanics._meeting._tool_bodies import copies_of
from cotouch.mechanics._meeting._world import Obstacle
from cotouch.mechanics._shapes._solid import Solid

_LEAF = 4
# Room for triangles near points: so many a point, and for all triangles so many times.
_NEAR, _ALL = 48, 8
# Rows may move by this share of the thinnest body before what is near is looked for anew.
_SLACK = 1e-4
# By which power of the ratio of their skins' areas a smaller body's points count more.
_SMALLER = 4.0
# Numbers of each body's balance.
SUMS = 19


def part_of_nodes(body: Body) -> Int:
    """Which of the bodies each node is of, (n,)."""
    return np.repeat(np.arange(len(body.parts)), [part.body.nodes for part in body.parts]).astype(np.int32)


def thickness_of(vertices: Float) -> float:
    """The least extent of a body along the main axes of its vertices [m]."""
    about = vertices - vertices.mean(axis=0)
    return float(np.ptp(about @ np.linalg.svd(about, full_matrices=False)[2].T, axis=0).min())


def met_of(bodies: int) -> Met:
    """Room for what contact does to so many bodies."""
    numbers = np.arange(bodies, dtype=np.int32)
    return Met(worked=np.zeros(bodies), flow=np.zeros(bodies), passed=np.zeros_like(numbers), group=numbers)


def parts_of(body: Body, order: Int | None, memory: Int, energy: Float) -> Parts:
    """Each body's share in the balance.

    Args:
        body: of several.
        order: row k of the kernels is node `order[k]`; None: node k.
        memory: where each body's memory begins, (bodies + 1,).
        energy: where the law writes energies and powers, (bodies, 2).
    """
    of = part_of_nodes(body)
    return Parts(
        part=of if order is None else np.ascontiguousarray(of[order]),
        memory=memory,
        energy=energy,
        met=met_of(len(body.parts)),
        held=np.zeros(len(body.parts), dtype=np.int32),
        sums=np.zeros((len(body.parts), SUMS)),
    )


def meeting_of(
    body: Body,
    between: Between,
    solids: Sequence[Obstacle],
    points: sp.csr_array,
    part: Int,
    order: Int | None,
    faces: CutSkin | None,
    hidden: Int,
    away: int,
) -> Meeting:
    """Several bodies that meet each other, and solids that stand still, for the kernels.

    Args:
        body: of several, with a skin.
        between: what they do to each other.
        solids: meshes that stand still.
        points: how much of each row of the kernels carries each point, (P, rows), one body after the other.
        part: body of each point, solids last, (P,).
        order: row k of the kernels is node `order[k]`; None: node k.
        faces: the skin with its inner faces, of what can be cut.
        hidden: where it is written which of its triangles are not there, those of solids last.
        away: where in a copy's memory it is which tools are not in it; negative: there are none.
    """
    skin = body.skin if faces is None else faces.skin
    assert skin is not None
    carry = skin.interpolation(body.nodes).copy()
    if order is not None:
        carry = sp.csr_array(carry[:, order])
    carry.sum_duplicates()
    carry.eliminate_zeros()
    carry.sort_indices()
    still = [one.shape for one in solids if isinstance(one.shape, Solid)]
    skins = [part.skin() for part in body.parts]
    moving = len(skins)
    if faces is None:
        vertices = np.cumsum([0, *(one.vertices.shape[0] for one in skins)])
        triangles = np.cumsum([0, *(one.triangles.shape[0] for one in skins)])
    else:
        vertices, triangles = faces.vertices, faces.triangles
    vertices = np.append(vertices, vertices[-1] + np.cumsum([one.vertices.shape[0] for one in still], dtype=int))
    triangles = np.append(triangles, triangles[-1] + np.cumsum([one.triangles.shape[0] for one in still], dtype=int))
    corner = np.concatenate(
        [skin.triangles, *(one.triangles + vertices[moving + k] for k, one in enumerate(still))]
    ).astype(np.int32)
    rest = np.zeros((int(vertices[-1]), 4))
    rest[:, :3] = np.concatenate([skin.vertices, *(one.vertices for one in still)]) - body.rest.mean(axis=0)
    pointer = np.append(carry.indptr, np.full(rest.shape[0] - carry.shape[0], carry.indptr[-1]))
    child: list[Int] = []
    leaf: list[Int] = []
    boxes = [0]
    for f, g in pairwise(triangles):
        own, members = _tree(rest[corner[f:g]].mean(axis=1), boxes[-1], int(f))
        child.append(own)
        leaf.append(members)
        boxes.append(boxes[-1] + own.shape[0])
    count, bodies = part.size, moving + len(still)
    entries = count * max(bodies - 1 + between.own, 1)  # of each point as many as it may meet
    within, skips, skip = unmet(bodies, count)
    if between.own:
        own = int(np.searchsorted(part, moving))
        within[:moving], skips[: own + 1], skip = own_of(
            body, sp.csr_array(points[:own]), carry, corner[: triangles[moving]], order, part[:own]
        )
        skips[own + 1 :] = skip.size
    of = part_of_nodes(body) if order is None else np.ascontiguousarray(part_of_nodes(body)[order])
    shares = _shares(
        [one.vertices[one.triangles] for one in (*skins, *still)], np.append(copies_of(body), np.ones(len(still)))
    )
    low, high = np.zeros((boxes[-1], 4)), np.zeros((boxes[-1], 4))
    for one in range(moving, bodies):
        _enclose(low, high, np.concatenate(child), np.concatenate(leaf), rest[corner], boxes[one], boxes[one + 1])
    return Meeting(
        moves=moving,
        stiffness=_of_pairs(between.stiffness, [one.stiffness for one in solids], moving) * shares,
        loss=_of_pairs(between.loss, [one.loss for one in solids], moving),
        friction=_of_pairs(between.friction, [one.friction for one in solids], moving),
        kinetic=_of_pairs(_slipping(between), [_slipping(one) for one in solids], moving),
        part=part,
        tool=np.array([one.tool is not None for one in body.parts] + len(still) * [False], dtype=np.int32),
        away=away,
        points=np.searchsorted(part, np.arange(bodies + 1)).astype(np.int32),
        vertices=vertices.astype(np.int32),
        boxes=np.array(boxes, dtype=np.int32),
        corner=corner,
        pointer=pointer.astype(np.int32),
        row=carry.indices.astype(np.int32),
        share=np.ascontiguousarray(carry.data, dtype=np.float64),
        rest=rest,
        hidden=hidden,
        child=np.concatenate(child).astype(np.int32),
        leaf=np.concatenate(leaf).astype(np.int32),
        leaves=triangles.astype(np.int32),
        body=of,
        part_of=1.0 / np.bincount(of)[of],
        whole=np.zeros((bodies, 4)),
        lever=float(max(abs(carry).sum(axis=1).max(), abs(points).sum(axis=1).max())),
        as_one=float(max(abs(carry.sum(axis=1)).max(), abs(points.sum(axis=1)).max())),
        slack=_SLACK * min(thickness_of(one.vertices) for one in (*skins, *still)),
        within=within,
        skips=skips,
        skip=skip,
        low=low,
        high=high,
        least=low[boxes[:-1]],
        most=high[boxes[:-1]],
        place=rest.copy(),
        later=rest.copy(),
        touched=np.zeros(bodies, dtype=np.int32),
        stack=np.zeros(boxes[-1] + 2, dtype=np.int32),
        entries=np.zeros(2, dtype=np.int32),
        bound=np.zeros(2),
        looked=np.zeros((body.nodes, 3)),
        point=np.zeros(entries, dtype=np.int32),
        other=np.zeros(entries, dtype=np.int32),
        first=np.zeros((entries, 2), dtype=np.int32),
        near=np.zeros(_NEAR * count + _ALL * corner.shape[0], dtype=np.int32),
        began=np.zeros((entries + 1, 8)),
        face=np.zeros((entries + 1, 4), dtype=np.int32),
        ended=np.zeros((entries + 1, 8)),
        deepest=np.zeros((bodies, bodies)),
        coefficient=np.zeros(body.nodes),
        moved=np.zeros(body.nodes, dtype=np.int32),
        met=met_of(bodies),
        push=np.zeros((body.nodes if body.tools else 0, 4)),
    )


def _slipping(law: Between | Obstacle) -> float:
    return law.friction if law.kinetic is None else law.kinetic


def _of_pairs(between: float, solids: Sequence[float], moving: int) -> Float:
    """A number of two bodies that meet, or of a body and a solid, for all pairs, (bodies, bodies)."""
    found = np.full((moving + len(solids),) * 2, between)
    for k, own in enumerate(solids):
        found[moving + k, :] = found[:, moving + k] = own
    return found


def _enclose(low: Float, high: Float, child: Int, leaf: Int, corners: Float, first: int, last: int) -> None:
    """Boxes of what stands still, once for all; see `Meeting`."""
    for box in range(last - 1, first - 1, -1):
        left, right = child[box]
        if left >= 0:
            low[box], high[box] = np.minimum(low[left], low[right]), np.maximum(high[left], high[right])
        else:
            own = corners[leaf[-1 - left : -1 - left + right]].reshape(-1, 4)
            low[box], high[box] = own.min(axis=0), own.max(axis=0)


def _shares(corners: Sequence[Float], copies: Float) -> Float:
    """How much the points of one body count in another, (bodies, bodies): of one size half each."""
    area = np.array([np.linalg.norm(np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0]), axis=1).sum() for c in corners])
    # One copy only meets a tool, all of it; the tool's own points have that in their areas.
    whole = np.where(copies[:, None] > 1.0, 1.0, copies[None, :])
    return whole / (1.0 + (area[:, None] / area[None, :]) ** _SMALLER)


def _tree(centre: Float, first_box: int, first: int) -> tuple[Int, Int]:
    """Boxes by halving at the median of the longest side, parents before children; numbers are those of all bodies."""
    leaf: Long = np.arange(centre.shape[0], dtype=np.int64)
    child: list[list[int]] = [[0, 0]]
    waiting = [(0, 0, centre.shape[0])]
    while waiting:
        box, begin, end = waiting.pop()
        if end - begin <= _LEAF:
            child[box] = [-1 - (first + begin), end - begin]
            continue
        own = leaf[begin:end]
        axis = int(np.argmax(np.ptp(centre[own], axis=0)))
        middle = (end - begin) // 2
        leaf[begin:end] = own[np.argsort(centre[own, axis], kind="stable")]
        number = len(child)
        child[box] = [first_box + number, first_box + number + 1]
        child += [[0, 0], [0, 0]]
        waiting += [(number, begin, begin + middle), (number + 1, begin + middle, end)]
    return np.array(child, dtype=np.int32), (first + leaf).astype(np.int32)
