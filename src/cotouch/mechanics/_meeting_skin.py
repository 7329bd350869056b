"""The skins of several bodies in the form in which they meet: vertices, triangles, and trees of boxes around these."""

from itertools import pairwise

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Float
from cotouch.body import Body, CutSkin, Part
from cotouch.mechanics._meeting import Between, Meeting, Parts
from cotouch.mechanics._meeting_own import own_of, unmet

Int = npt.NDArray[np.int32]

_LEAF = 4
# Room for triangles near points: so many a point, and for all triangles so many times.
_NEAR, _ALL = 48, 8
# Rows may move by this share of the thinnest body before what is near is looked for anew.
_SLACK = 1e-3
# By which power of the ratio of their skins' areas a smaller body's points count more.
_SMALLER = 4.0
# Numbers of each body's balance.
SUMS = 12


def part_of_nodes(body: Body) -> Int:
    """Which of the bodies each node is of, (n,)."""
    return np.repeat(np.arange(len(body.parts)), [part.body.nodes for part in body.parts]).astype(np.int32)


def thickness_of(part: Part) -> float:
    """The least extent of a body along the main axes of its vertices [m]."""
    vertices = part.skin().vertices
    about = vertices - vertices.mean(axis=0)
    return float(np.ptp(about @ np.linalg.svd(about, full_matrices=False)[2].T, axis=0).min())


def parts_of(body: Body, order: Int | None, memory: Int, energy: Float, worked: Float) -> Parts:
    """Each body's share in the balance.

    Args:
        body: of several.
        order: row k of the kernels is node `order[k]`; None: node k.
        memory: where each body's memory begins, (bodies + 1,).
        energy: where the law writes energies and powers, (bodies, 2).
        worked: where contact writes its work, (bodies,).
    """
    of = part_of_nodes(body)
    return Parts(
        part=of if order is None else np.ascontiguousarray(of[order]),
        memory=memory,
        energy=energy,
        worked=worked,
        sums=np.zeros((len(body.parts), SUMS)),
    )


def meeting_of(
    body: Body, between: Between, points: sp.csr_array, order: Int | None, faces: CutSkin | None, hidden: Int
) -> Meeting:
    """Several bodies that meet, for the kernels.

    Args:
        body: of several, with a skin.
        between: what they do to each other.
        points: how much of each row of the kernels carries each point, (P, rows), one body after the other.
        order: row k of the kernels is node `order[k]`; None: node k.
        faces: the skin with its inner faces, of what can be cut.
        hidden: where it is written which of its triangles are not there.
    """
    skin = body.skin if faces is None else faces.skin
    assert skin is not None
    of = part_of_nodes(body)
    carry = skin.interpolation(body.nodes).copy()
    rows = of
    if order is not None:
        carry, rows = sp.csr_array(carry[:, order]), of[order]
    carry.sum_duplicates()
    carry.eliminate_zeros()
    carry.sort_indices()
    if faces is None:
        vertices = np.cumsum([0, *(part.skin().vertices.shape[0] for part in body.parts)])
        triangles = np.cumsum([0, *(part.skin().triangles.shape[0] for part in body.parts)])
    else:
        vertices, triangles = faces.vertices, faces.triangles
    corner, rest = np.ascontiguousarray(skin.triangles, dtype=np.int32), np.zeros((skin.vertices.shape[0], 4))
    rest[:, :3] = skin.vertices - body.rest.mean(axis=0)
    child: list[Int] = []
    leaf: list[Int] = []
    boxes = [0]
    for f, g in pairwise(triangles):
        own, members = _tree(rest[corner[f:g]].mean(axis=1), boxes[-1], int(f))
        child.append(own)
        leaf.append(members)
        boxes.append(boxes[-1] + own.shape[0])
    part = np.asarray(rows[points.indices[points.indptr[:-1]]], dtype=np.int32)
    count, bodies = part.size, len(body.parts)
    within, skips, skip = own_of(body, points, carry, corner, order, part) if between.own else unmet(bodies, count)
    return Meeting(
        stiffness=between.stiffness * _shares(body),
        loss=between.loss,
        friction=between.friction,
        kinetic=between.friction if between.kinetic is None else between.kinetic,
        part=part,
        points=np.searchsorted(part, np.arange(bodies + 1)).astype(np.int32),
        vertices=vertices.astype(np.int32),
        boxes=np.array(boxes, dtype=np.int32),
        corner=corner,
        pointer=carry.indptr.astype(np.int32),
        row=carry.indices.astype(np.int32),
        share=np.ascontiguousarray(carry.data, dtype=np.float64),
        rest=rest,
        hidden=hidden,
        child=np.concatenate(child).astype(np.int32),
        leaf=np.concatenate(leaf).astype(np.int32),
        leaves=triangles.astype(np.int32),
        lever=float(max(abs(carry).sum(axis=1).max(), abs(points).sum(axis=1).max())),
        slack=_SLACK * min(thickness_of(one) for one in body.parts),
        within=within,
        skips=skips,
        skip=skip,
        low=np.zeros((boxes[-1], 4)),
        high=np.zeros((boxes[-1], 4)),
        place=np.zeros_like(rest),
        later=np.zeros_like(rest),
        touched=np.zeros(bodies, dtype=np.int32),
        stack=np.zeros(boxes[-1] + 2, dtype=np.int32),
        entries=np.zeros(2, dtype=np.int32),
        bound=np.zeros(1),
        point=np.zeros(count, dtype=np.int32),
        other=np.zeros(count, dtype=np.int32),
        first=np.zeros((count, 2), dtype=np.int32),
        near=np.zeros(_NEAR * count + _ALL * corner.shape[0], dtype=np.int32),
        began=np.zeros((count + 1, 8)),
        face=np.zeros((count + 1, 4), dtype=np.int32),
        ended=np.zeros((count + 1, 8)),
        coefficient=np.zeros(body.nodes),
        moved=np.zeros(body.nodes, dtype=np.int32),
        alike=np.zeros((body.nodes,) * 2 if body.rigid else (0, 0)),
        worked=np.zeros(bodies),
    )


def _shares(body: Body) -> Float:
    """How much the points of one body count in another, (bodies, bodies): of one size half each."""
    corners = [part.skin().vertices[part.skin().triangles] for part in body.parts]
    area = np.array([np.linalg.norm(np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0]), axis=1).sum() for c in corners])
    return 1.0 / (1.0 + (area[:, None] / area[None, :]) ** _SMALLER)


def _tree(centre: Float, first_box: int, first: int) -> tuple[Int, Int]:
    """Boxes by halving at the median of the longest side, parents before children; numbers are those of all bodies."""
    leaf: npt.NDArray[np.int64] = np.arange(centre.shape[0], dtype=np.int64)
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
