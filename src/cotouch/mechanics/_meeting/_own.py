"""Which triangles of its own body a point of the skin does not meet: those that are near through the body itself."""

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import dijkstra

from cotouch.arrays import Float, Int
from cotouch.body import Body, Part
from cotouch.errors import BodyError

# Ways within the body shorter than so many of its middle edges lead to what is no other part; and how deep another part
# may come, in such edges: a body squashed to a third of itself still does not meet its far side.
_WAY, _WITHIN = 3.05, 0.75
# Rows of the table of ways that are worked out at a time, and entries of `skip` at most.
_CHUNK, _MOST = 512, 20_000_000


def unmet(bodies: int, points: int) -> tuple[Float, Int, Int]:
    """`within`, `skips` and `skip` of bodies that do not meet themselves; see `Meeting`.

    Args:
        bodies: how many.
        points: of all their skins.
    """
    return np.zeros(bodies), np.zeros(points + 1, dtype=np.int32), np.zeros(0, dtype=np.int32)


def own_of(
    body: Body, points: sp.csr_array, carry: sp.csr_array, corner: Int, order: Int | None, part: Int
) -> tuple[Float, Int, Int]:
    """`within`, `skips` and `skip` of bodies that meet themselves; a rigid one cannot. See `Meeting`.

    Args:
        body: of one or several.
        points: how much of each row of the kernels carries each point, (P, rows).
        carry: likewise of each vertex of the skin, (V, rows).
        corner: vertices of each triangle, (F, 3).
        order: row k of the kernels is node `order[k]`; None: node k.
        part: body of each point, (P,).

    Raises:
        BodyError: so many triangles are near each point that they could not be kept.
    """
    within, skips, skip = unmet(len(body.parts), part.size)
    blocks: list[sp.csr_array] = []
    for number, one in enumerate(body.parts):
        near, edge = _near(one)
        within[number] = _WITHIN * edge
        blocks.append(near)
    beside = sp.csr_array(sp.block_diag(blocks, format="csr"))
    if order is not None:
        beside = sp.csr_array(beside[order][:, order])
    faces: Int = np.repeat(np.arange(corner.shape[0], dtype=np.int32), 3)
    of_triangle = sp.csr_array(
        (np.ones(corner.size), (faces, corner.ravel())),
        shape=(corner.shape[0], carry.shape[0]),
    )
    touched = sp.csr_array(_marked(points) @ beside.astype(np.int32))  # rows near each point
    carried = sp.csr_array(_marked(sp.csr_array(of_triangle @ abs(carry))).T)
    rows: list[Int] = []
    count = 0
    for begin in range(0, part.size, _CHUNK):
        found = sp.csr_array(_marked(sp.csr_array(touched[begin : begin + _CHUNK])) @ carried)
        found.sort_indices()
        skips[begin + 1 : begin + 1 + found.shape[0]] = count + found.indptr[1:]
        rows.append(found.indices.astype(np.int32))
        count += found.nnz
        if count > _MOST:
            raise BodyError(
                f"a body that meets itself has more than {_MOST:,} pairs of places that are near each other; "
                "take a coarser mesh, or self_contact = false"
            )
    return within, skips, np.concatenate([skip, *rows]).astype(np.int32)


def _marked(matrix: sp.csr_array) -> sp.csr_array:
    """1 where a matrix is not 0."""
    made = sp.csr_array(matrix)
    made.eliminate_zeros()
    shape = int(made.shape[0]), int(made.shape[1])
    return sp.csr_array((np.ones(made.nnz, dtype=np.int32), made.indices, made.indptr), shape=shape)


def _near(part: Part) -> tuple[sp.csr_array, float]:
    """Which nodes of a body are near each other on ways along its springs, (n, n), and its middle edge [m]."""
    body = part.body
    per = 1 if body.form == "node" else body.dimension
    springs = body.stiffness_int.tocoo()
    known = springs.data != 0.0
    ends: Int = np.unique(np.stack([c[known] // per for c in springs.coords], axis=1), axis=0)
    ends = ends[ends[:, 0] != ends[:, 1]]
    length = np.linalg.norm(body.rest[ends[:, 0]] - body.rest[ends[:, 1]], axis=1)
    if body.rigid or not length.size:
        return sp.csr_array((body.nodes, body.nodes)), 0.0
    graph = sp.csr_array((length, (ends[:, 0], ends[:, 1])), shape=(body.nodes, body.nodes))
    edge = float(np.median(length))
    blocks: list[sp.csr_array] = []
    for begin in range(0, body.nodes, _CHUNK):
        own = np.arange(begin, min(begin + _CHUNK, body.nodes))
        away = dijkstra(graph, directed=False, indices=own, limit=_WAY * edge)
        blocks.append(sp.csr_array(np.isfinite(away)))
    joined = _marked(graph) + sp.eye_array(body.nodes, dtype=np.int32, format="csr")
    return sp.csr_array((sp.vstack(blocks).astype(np.int32) + joined @ joined) > 0), edge
