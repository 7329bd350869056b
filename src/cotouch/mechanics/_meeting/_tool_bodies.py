"""Tools that are bodies: each is in the copy of its user alone, and links do not know it."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from collections.abc import Sequence

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float, Int
from cotouch.body import Body, pulls_of
from cotouch.kernels import at, inner, part, put
from cotouch.mechanics._meeting._bodies import Meeting
from cotouch.mechanics._meeting._world import World


def rigid_rows(body: Body, order: Int | None) -> Int:
    """Rows of the kernels that are solved for at once: of rigid bodies, where there are only such, or tools that are.

    Args:
        body: of one or several.
        order: row k of the kernels is node `order[k]`; None: node k.
    """
    nodes = np.arange(body.nodes if body.rigid else 0, dtype=np.int32)
    if body.tools and not body.rigid:
        nodes = np.concatenate([np.arange(one.first, one.last) for one in body.parts if one.body.rigid])
    return np.argsort(order)[nodes].astype(np.int32) if order is not None else nodes.astype(np.int32)


def copies_of(body: Body) -> Float:
    """How many times contact with each of several bodies counts, because one copy of N meets all of it, (bodies,)."""
    return np.array([1.0 if one.tool is None else float(one.tool.copies) for one in body.parts])


def link_weights(body: Body, weights: Sequence[sp.csr_array]) -> list[sp.csr_array]:
    """How much of a link each node feels, and other link weights, with rows of zeros for tools.

    Args:
        body: of one or several.
        weights: (n, n).
    """
    every = [sp.csr_array(sp.diags_array(pulls_of(body))), *weights]
    if not body.tools:
        return every
    shared = np.ones(body.nodes)
    for one in body.tools:
        shared[one.first : one.last] = 0.0
    known = sp.diags_array(shared)
    every = [sp.csr_array(known @ weight @ known) for weight in every]
    for weight in every:
        weight.eliminate_zeros()
    return every


@inner
def _add_push(m: Meeting, row: int, share: float, fx: float, fy: float, fz: float) -> None:
    put(m.push, (row, 0), at(m.push, (row, 0)) + share * fx)
    put(m.push, (row, 1), at(m.push, (row, 1)) + share * fy)
    put(m.push, (row, 2), at(m.push, (row, 2)) + share * fz)


@part
def note_push(world: World, m: Meeting, e: int, f: int, fx: float, fy: float, fz: float) -> None:
    """Adds to `push` what an entry's point and triangle, one of them a tool's, do to the rows of the shared body.

    Args:
        world: whose points they are.
        m: the bodies.
        e: the entry.
        f: the triangle.
        fx: force on the point [N].
        fy: likewise.
        fz: likewise.
    """
    p = at(m.point, e)
    if at(m.tool, at(m.part, p)) == 0:
        for n in range(at(world.pointer, p), at(world.pointer, p + 1)):
            _add_push(m, at(world.row, n), at(world.share, n), fx, fy, fz)
        return
    for q in range(3):
        v, share = at(m.corner, (f, q)), at(m.ended, (e, 4 + q))
        for n in range(at(m.pointer, v), at(m.pointer, v + 1)):
            _add_push(m, at(m.row, n), -share * at(m.share, n), fx, fy, fz)


@inner
def _add_pushes(m: Meeting | None, scale: float, weight: Float, fresh: bool, out: Float) -> None:
    if m is not None:
        for n in range(m.push.size):
            before = 0.0 if fresh or at(weight, n) == 0.0 else at(out, n)
            put(out, n, before + scale * at(m.push, n))


@inner
def tell_push(world: World | None, scale: float, weight: Float, fresh: bool, out: Float) -> None:
    """Adds what tools that are bodies did to the others in the step to what balls did; nothing without them.

    Args:
        world: that the tools are in.
        scale: share of forces that a copy has.
        weight: of a link, flat; what it is 0 of, a tool, links do not know, nor who touches that.
        fresh: whether balls did nothing, and `out` says nothing yet.
        out: result, flat, (rows * width,) [N].
    """
    if world is not None:
        _add_pushes(world.bodies, scale, weight, fresh, out)
