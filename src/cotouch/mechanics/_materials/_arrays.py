"""From a body's material to the arrays that its law works on."""

from typing import Any, TypedDict

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Array, Float, Int
from cotouch.body import SIGNS, Body, Material, Part, SumOfSquares, frame_of, strain_law
from cotouch.errors import UnsupportedError
from cotouch.mechanics._linear._operator import off_diagonal
from cotouch.mechanics._linear._state import numbered
from cotouch.mechanics._materials._call import called
from cotouch.mechanics._materials._cells import CorotatedCells
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._materials._fours import blocks
from cotouch.mechanics._materials._frame import FramedBody
from cotouch.mechanics._materials._memory import memory_size
from cotouch.mechanics._materials._rigid import Rigid
from cotouch.mechanics._materials._springs import SpringNetwork
from cotouch.mechanics._materials._tetrahedra import SOLIDS
from cotouch.mechanics._materials._together import Together, together_of
from cotouch.mechanics._meeting._bodies import Parts
from cotouch.mechanics._meeting._skin import parts_of
from cotouch.mechanics._meeting._tool_bodies import rigid_rows


def outline_of(body: Body, material: Material, *, tangent: bool = True) -> Body:
    """The linear body, in the node form, that gives a step's direction: masses, outer springs, a scalar bound on K.

    Args:
        body: with the material.
        material: of the body.
        tangent: whether what is rigid may give its own tangent.

    Raises:
        UnsupportedError: masses or what holds the body differ between axes.
    """
    if body.parts:
        return _outlines(body)
    exact = body.form == "node" and material.model != "spring-network"
    if body.form == "node":
        inner, dampers = body.stiffness_int, body.damping_int
        if material.elements.size:
            dampers = inner * float(np.max(material.viscosity))
        mass, held, dragged = body.mass, body.stiffness_ext, body.damping_ext
        if mass.nnz != body.nodes:
            raise UnsupportedError(f'model is "{material.model}", but masses are coupled; M must be diagonal')
    else:
        # What is rigid gives its own tangent, if it may.
        inner = (
            sp.csr_array((body.nodes, body.nodes))
            if body.rigid and tangent
            else scalar_bound(body.stiffness_int, body.dimension)
        )
        dampers = (
            inner * float(np.max(material.viscosity))
            if material.elements.size
            else scalar_bound(body.damping_int, body.dimension)
        )
        mass, held, dragged = (_one_axis(name, getattr(body, name), body) for name in _OUTER)
    return Body(
        mass=mass,
        rest=body.rest,
        damping_int=SumOfSquares(dampers),
        damping_ext=dragged,
        stiffness_int=SumOfSquares(inner if exact else _SHARE * inner),
        stiffness_ext=held,
    )


def _own(part: Part) -> Material:
    """The material of one of several bodies."""
    return part.body.material or Material(model="linear")


def _outlines(body: Body) -> Body:
    """Of several bodies: those of each, side by side."""
    tangent = body.rigid or bool(body.tools)
    each = [outline_of(part.body, _own(part), tangent=tangent) for part in body.parts]
    joined = {
        name: sp.csr_array(sp.block_diag([getattr(one, name) for one in each], format="csr"))
        for name in ("mass", "damping_int", "damping_ext", "stiffness_int", "stiffness_ext")
    }
    return Body(
        rest=body.rest,
        mass=joined["mass"],
        damping_int=SumOfSquares(joined["damping_int"]),
        damping_ext=joined["damping_ext"],
        stiffness_int=SumOfSquares(joined["stiffness_int"]),
        stiffness_ext=joined["stiffness_ext"],
    )


# A step takes this share of a scalar that bounds what stiffness couples two nodes. Looks still tend to the same, as the
# Hessian is at most twice the matrix, and faster: most directions are much softer than the bound.
_SHARE = 0.5
# How often a step looks ahead. Each look leaves a fifth of the last one's error at ω T = 1; the nearer the constant
# matrix is to the law's own, the fewer are enough for |β - 1| <= 1e-3.
DIRECTIONS = {
    "linear": 1,
    "floating": 2,
    "cells": 2,
    "spring-network": 3,
    "rigid": 2,
}
_OF_SOLIDS = 3
_FAR = 10.0
_OUTER = ("mass", "stiffness_ext", "damping_ext")


def _one_axis(name: str, matrix: sp.csr_array, body: Body) -> sp.csr_array:
    """A diagonal matrix that is the same along every axis, in the node form."""
    own = matrix.diagonal().reshape(body.nodes, body.dimension)
    alone = matrix.nnz == np.count_nonzero(own)
    if not (alone and np.all(own == own[:, :1])):
        raise UnsupportedError(f"{name} differs between axes, or couples them; a material needs one number a node")
    return sp.csr_array(sp.diags_array(own[:, 0].copy()))


def scalar_bound(matrix: sp.csr_array, dimension: int) -> sp.csr_array:
    """A Laplacian L, n x n, so that `L ⊗ I - matrix` is positive semidefinite, for a matrix that feels no translation.

    `xᵀ K x = -½ Σ (x_i - x_j)ᵀ K_ij (x_i - x_j)`, so the largest eigenvalue of each block `-sym K_ij` is a spring that
    bounds it.

    Args:
        matrix: K, symmetric, (n * dimension, n * dimension) [N/m].
        dimension: axes of a node, 1 to 3.
    """
    blocks = sp.bsr_array(matrix, blocksize=(dimension, dimension))
    nodes = matrix.shape[0] // dimension
    i = np.repeat(np.arange(nodes), np.diff(blocks.indptr))
    j = blocks.indices
    off = i != j
    values = blocks.data[off]
    springs = np.maximum(np.linalg.eigvalsh(-0.5 * (values + values.transpose(0, 2, 1)))[:, -1], 0.0)
    laplacian = sp.csr_array((-springs, (i[off], j[off])), shape=(nodes, nodes))
    laplacian = 0.5 * (laplacian + laplacian.T)
    return sp.csr_array(laplacian - sp.diags_array(np.asarray(laplacian.sum(axis=1)).ravel()))


def force_of(body: Body, material: Material, order: Int | None) -> tuple[BodyForce, int]:
    """The law for the kernels, and how many numbers it remembers of a copy.

    Args:
        body: whose it is.
        material: its material.
        order: row k of the kernels is node `order[k]`; None: node k.
    """
    nodes = body.nodes
    row = np.arange(nodes, dtype=np.int32)
    if order is not None:
        row = np.empty(nodes, dtype=np.int32)
        row[order] = np.arange(nodes, dtype=np.int32)
    rest = np.zeros((nodes, 4))
    rest[:, : body.dimension] = body.rest - body.rest.mean(axis=0)
    parts: Parts | None = None
    if body.parts:
        law, size, directions = _together(body, row, numbered(rigid_rows(body, order), nodes))
        parts = parts_of(body, order, law.memory, law.energy)
    else:
        law, rotations = _law(body, material, row, rest)
        size, directions = memory_size(rotations), _directions(body, material)
    gravity = np.zeros((nodes, 4))
    gravity[:, : body.dimension] = material.gravity[: body.dimension]
    for part in body.parts:
        if part.tool is not None:
            gravity[row[part.first : part.last]] = 0.0
    # Places are as large as the body, or some times that where it has travelled.
    rounding = np.finfo(np.float64).eps * float(np.abs(rest).max())
    grain = (_FAR * rounding) ** 2 * float(abs(body.stiffness_int).sum())
    places = np.zeros_like(rest)
    places[row] = rest
    force = BodyForce(
        law=called(law),
        table=law,
        places=places,
        gravity=gravity,
        directions=directions,
        grain=grain,
        rounding=rounding,
        parts=parts,
    )
    return force, size


def _together(body: Body, row: Int, rigid: Int) -> tuple[Together, int, int]:
    """The laws of several bodies, each with its own nodes as rows; how many numbers they remember; looks they need."""
    laws: list[Any] = []
    sizes: list[int] = []
    looks = 1
    for part in body.parts:
        made, size = force_of(part.body, _own(part), None)
        laws.append(made.table)
        sizes.append(size)
        looks = max(looks, made.directions)
    rows = [row[part.first : part.last] for part in body.parts]
    law = together_of(laws, sizes, rows, [part.turn for part in body.parts], rigid)
    return law, int(law.memory[-1]), looks


def _directions(body: Body, material: Material) -> int:
    if material.model == "floating" and body.form == "full":
        return _OF_SOLIDS
    return DIRECTIONS.get(material.model, _OF_SOLIDS)


def _law(body: Body, material: Material, row: Int, rest: Float) -> tuple[Any, int]:
    elements: Int = np.ascontiguousarray(row[material.elements], dtype=np.int32)
    if material.model in {"linear", "floating"}:
        return _frame(body, material, row, rest), 1
    if material.model == "rigid":
        frame = frame_of(rest[:, :3])
        sign = np.zeros((4, 4))
        sign[:, :3] = SIGNS
        return Rigid(
            viscosity=float(np.max(material.viscosity)),
            corner=elements,
            sign=sign,
            frame=np.ascontiguousarray(frame.reshape(1, 9)),
            law=(material.stiffness[0] * strain_law(frame)).reshape(1, 36),
        ), 0
    if material.model == "spring-network":
        edge = rest[material.elements[:, 1], :3] - rest[material.elements[:, 0], :3]
        length = np.linalg.norm(edge, axis=1)
        rows = np.concatenate([material.stiffness[:, None], length[:, None], edge], axis=1)
        return SpringNetwork(
            viscosity=float(np.max(material.viscosity)),
            start=np.ascontiguousarray(elements[:, 0]),
            end=np.ascontiguousarray(elements[:, 1]),
            block=blocks(rows, [0]),
        ), 0
    if material.model == "cells":
        corner = rest[material.elements[0]]
        spacing = float(np.linalg.norm(corner[4] - corner[0]))
        edge = np.zeros((3, 4))
        edge[[0, 1, 2], [0, 1, 2]] = spacing
        return CorotatedCells(
            viscosity=float(np.max(material.viscosity)),
            corner=elements,
            stiffness=np.ascontiguousarray(material.stiffness),
            edge=edge,
            spacing=spacing,
            **_ties(material, row),
        ), elements.shape[0]
    edges = rest[material.elements[:, 1:], :3] - rest[material.elements[:, :1], :3]
    volume = np.linalg.det(edges) / 6.0
    slopes = gradients_of(rest[:, :3], material.elements)[:, :3].reshape(-1, 9)
    lame = lame_of(material)
    lame[:, :2] *= volume[:, None]
    rows = np.concatenate([slopes, lame], axis=1)
    solid = SOLIDS[material.model]
    law = solid.kind(
        viscosity=float(np.max(material.viscosity)),
        corner=elements,
        volume=volume,
        block=blocks(rows, [9, 10]),
        **_ties(material, row),
    )
    return law, elements.shape[0] if solid.turns else 0


class _Ties(TypedDict):
    tie_start: Int
    tie_end: Int
    tie_face: Int
    tie: Float


def _ties(material: Material, row: Int) -> _Ties:
    """Springs of no length at the faces along which a body opens."""
    wide = material.faces.shape[1] // 2
    return {
        "tie_start": np.ascontiguousarray(row[material.faces[:, :wide].ravel()], dtype=np.int32),
        "tie_end": np.ascontiguousarray(row[material.faces[:, wide:].ravel()], dtype=np.int32),
        "tie_face": np.repeat(np.arange(material.ties.size, dtype=np.int32), wide),
        "tie": np.repeat(material.ties, wide),
    }


def _cut_field(material: Material | None) -> str:
    """The field of a law that says where in the memory the marks of what was cut begin.

    Args:
        material: that can be cut.
    """
    return "tie_cut" if material is not None and material.faces.size else "cut"


def gradients_of(rest: Float, elements: npt.NDArray[np.integer[Any]]) -> Float:
    """∇N of the last three corners of each tetrahedron, (3 E, 4) [1/m].

    Args:
        rest: places at rest, (n, 3) [m].
        elements: their corners, (E, 4).
    """
    edges = rest[elements[:, 1:]] - rest[elements[:, :1]]
    gradient = np.zeros((3 * elements.shape[0], 4))
    gradient[:, :3] = np.linalg.inv(edges).transpose(0, 2, 1).reshape(-1, 3)
    return gradient


def lame_of(material: Material) -> Float:
    """λ and μ [Pa] and η [s] of each tetrahedron, (E, 3)."""
    count = material.elements.shape[0]
    said = (material.young, material.poisson, material.viscosity)
    young, poisson, eta = (np.broadcast_to(value, (count,)) for value in said)
    lam = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
    return np.ascontiguousarray(np.stack([lam, young / (2.0 * (1.0 + poisson)), eta], axis=1))


def _frame(body: Body, material: Material, row: Int, rest: Float) -> FramedBody:
    """The body's own matrices, off the diagonal and in the kernels' order."""
    nodes, dimension = rest.shape[0], body.dimension
    order = np.argsort(row)
    if body.form == "node":
        place = off_diagonal((abs(body.stiffness_int) + abs(body.damping_int))[order][:, order]).nonzero()
        stiffness, damping = (
            # A body of one node has no entries, and of none scipy makes another type.
            np.asarray(sp.csr_array(m[order][:, order])[place] if place[0].size else []).reshape(-1, 1)
            for m in (body.stiffness_int, body.damping_int)
        )
        lever = body.stiffness_int @ rest
    else:
        k, b = (sp.bsr_array(m, blocksize=(dimension, dimension)) for m in (body.stiffness_int, body.damping_int))
        known = (sp.csr_array((np.ones(m.indices.size), m.indices, m.indptr), shape=(nodes, nodes)) for m in (k, b))
        place = off_diagonal(sum(known, start=sp.csr_array((nodes, nodes)))[order][:, order]).nonzero()
        stiffness, damping = (_blocks(m, order[place[0]], order[place[1]], dimension) for m in (k, b))
        mass = body.mass.diagonal().reshape(nodes, dimension)[:, 0]
        lever = mass[:, None] * (rest - np.average(rest, axis=0, weights=mass))
    pointer = np.concatenate([[0], np.cumsum(np.bincount(place[0], minlength=nodes))]).astype(np.int32)
    return FramedBody(
        turning=int(material.model == "floating"),
        damped=int(bool(np.any(damping))),
        pointer=pointer,
        column=place[1].astype(np.int32),
        stiffness=np.ascontiguousarray(stiffness, dtype=np.float64),
        damping=np.ascontiguousarray(damping, dtype=np.float64),
        rest=np.ascontiguousarray(rest[order]),
        lever=np.ascontiguousarray(np.asarray(lever)[order]),
        local=np.zeros((nodes, 4)),
        image=np.zeros((nodes, 4)),
    )


def _blocks(matrix: sp.bsr_array, rows: Array, columns: Array, dimension: int) -> Float:
    """Blocks at these places as rows of nine; zero where there is none."""
    result = np.zeros((rows.size, 3, 3))
    where = {(int(i), int(j)): n for n, (i, j) in enumerate(zip(rows, columns, strict=True))}
    i = np.repeat(np.arange(matrix.indptr.size - 1), np.diff(matrix.indptr))
    for n in range(matrix.indices.size):
        found = where.get((int(i[n]), int(matrix.indices[n])))
        if found is not None:
            result[found, :dimension, :dimension] = matrix.data[n]
    return result.reshape(-1, 9)


def cut_law(body: Body, law: Any, first: int) -> Any:
    """A law that knows where in a copy's memory it is what was cut.

    Args:
        body: whose law it is.
        law: of one body, or of several.
        first: where the marks begin, those of one body after the other.
    """
    if not isinstance(law, Together):
        return law._replace(**{_cut_field(body.material): first})
    packs = [pack._replace(number=pack.number.copy()) for pack in law.packs]
    for b, part in enumerate(body.parts):
        if part.body.cut_count:
            pack = packs[int(law.kind[b])]
            # Of a piece of the memory that begins with this body's own.
            pack.number[law.slot[b], pack.law._fields.index(_cut_field(part.body.material))] = first - law.memory[b]
            first += part.body.cut_count
    return law._replace(packs=tuple(packs))
