"""A body that opens along the faces of its elements: nodes are doubled there beforehand, and tied by stiff springs."""

from dataclasses import replace

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float, Long
from cotouch.body._body import Body
from cotouch.body._builders import MOST_NODES
from cotouch.body._cell_skin import divided
from cotouch.body._cells import CORNERS
from cotouch.body._checks import SumOfSquares
from cotouch.body._cut_skin import FACES, carriers
from cotouch.body._elasticity import elastic_tetrahedra, laplacian_of, springs_of_cells
from cotouch.body._material import Material
from cotouch.body._part import Part
from cotouch.body._skin import Skin
from cotouch.body._together import joined
from cotouch.errors import BodyError

# A face is so many times as stiff as the elements beside it: they yield by less than a hundredth more.
_STIFFER = {8: 250.0, 4: 500.0}
# Corners of the sides of elements in turn, seen from outside, by the number of an element's corners.
_SIDES: dict[int, Long] = {
    4: np.array(FACES[4]),
    8: np.array([(one[0], one[1], one[2], two[2]) for one, two in zip(FACES[8][::2], FACES[8][1::2], strict=True)]),
}


def with_faces(body: Body) -> Body:
    """The same body with nodes of its own for every element, tied where elements share a face.

    Masses, and what holds nodes to the ground, are shared out, so that the sums stay. The first element that has a node
    keeps its number.

    Args:
        body: that can be cut, of cubes or tetrahedra.

    Raises:
        BodyError: its elements have no faces, or there would be too many nodes.
    """
    if body.parts:
        return _parts_with_faces(body)
    material = body.material
    assert material is not None
    if not material.closes:
        raise BodyError(
            f'faces is true, but model is "{material.model}", whose elements have none; take "cells" or tetrahedra '
            "with a law of their own, or faces = false"
        )
    elements = material.elements
    count = elements.shape[1]
    own, parent = _numbered(elements)
    if own.size > MOST_NODES:
        raise BodyError(
            f"faces = true makes {own.size} nodes of the body's {body.nodes}, but the limit is {MOST_NODES}; make it "
            "coarser, or faces = false"
        )
    sides, faces = _tied(elements, own)
    rest = body.rest[parent]
    part = _part_of(elements, own, _sizes(body.rest, material))
    stiff = _stiffness(rest, own, material)
    ties = _ties(rest, own, faces, sides, material)
    wide = faces.shape[1] // 2
    tied = laplacian_of(
        parent.size, faces.reshape(-1, 2, wide).transpose(0, 2, 1).reshape(-1, 2), np.repeat(ties, wide)
    )
    damped = _stiffness(rest, own, replace(material, young=material.young * material.viscosity)) if count == 4 else None
    eta = float(np.max(material.viscosity))
    if count == 4:
        tied = sp.csr_array(sp.kron(tied, sp.eye_array(3)))
    damping = eta * (stiff + tied) if damped is None or not eta else damped + eta * tied
    return Body(
        rest=rest,
        stiffness_int=SumOfSquares(sp.csr_array(stiff + tied)),
        damping_int=SumOfSquares(sp.csr_array(damping if eta else 0.0 * stiff)),
        skin=_skin(body.skin, body.rest, elements, own)
        if body.skin is not None and body.skin.triangles.size
        else body.skin,
        origin=body.origin,
        material=replace(material, elements=own, faces=faces, sides=sides, ties=ties, part=part),
        mass=_shared_out(body.mass, parent, part),
        damping_ext=_shared_out(body.damping_ext, parent, part),
        stiffness_ext=_shared_out(body.stiffness_ext, parent, part),
    )


def _numbered(elements: Long) -> tuple[Long, Long]:
    """Numbers of each element's own nodes (E, c), and the node that each of them was (n,)."""
    flat = elements.ravel()
    nodes, first = np.unique(flat, return_index=True)
    own: Long = np.full(flat.size, -1, dtype=np.int64)
    own[first] = nodes
    more = np.flatnonzero(own < 0)
    own[more] = nodes.size + np.arange(more.size)
    parent = np.empty(flat.size, dtype=np.int64)
    parent[own] = flat
    return own.reshape(elements.shape), parent


def _tied(elements: Long, own: Long) -> tuple[Long, Long]:
    """Pairs of elements that share a face (F, 2), and the nodes of the one and of the other there (F, 2 m)."""
    loops = _SIDES[elements.shape[1]]
    at = elements[:, loops]
    key = np.sort(at.reshape(-1, loops.shape[1]), axis=1)
    _, number, times = np.unique(key, axis=0, return_inverse=True, return_counts=True)
    number = number.reshape(-1)
    order = np.argsort(number, kind="stable")
    here, there = order[times[number[order]] == 2].reshape(-1, 2).T
    sides = np.stack([here // loops.shape[0], there // loops.shape[0]], axis=1)
    one = loops[here % loops.shape[0]]
    nodes = np.take_along_axis(elements[sides[:, 0]], one, axis=1)
    two = np.argmax(nodes[:, :, None] == elements[sides[:, 1]][:, None, :], axis=2)
    faces = [np.take_along_axis(own[sides[:, 0]], one, axis=1), np.take_along_axis(own[sides[:, 1]], two, axis=1)]
    return sides, np.concatenate(faces, axis=1)


def _sizes(rest: Float, material: Material) -> Float:
    """How much of a node each element has: by its volume, of cubes by how much of one is solid, (E,)."""
    if material.model == "cells":
        return material.stiffness
    edges = rest[material.elements[:, 1:]] - rest[material.elements[:, :1]]
    return np.abs(np.linalg.det(edges)) / 6.0


def _part_of(elements: Long, own: Long, size: Float) -> Float:
    """The share of the node that it was which each node has, (n,)."""
    each = np.repeat(size, elements.shape[1])
    whole = np.bincount(elements.ravel(), weights=each)
    part = np.empty(own.size)
    part[own.ravel()] = each / whole[elements.ravel()]
    return part


def _shared_out(matrix: sp.csr_array, parent: Long, part: Float) -> sp.csr_array:
    """A diagonal matrix of the nodes that were."""
    axes = matrix.shape[0] // (int(parent.max()) + 1)
    values = matrix.diagonal().reshape(-1, axes)[parent] * part[:, None]
    return sp.csr_array(sp.diags_array(values.ravel()))


def _stiffness(rest: Float, own: Long, material: Material) -> sp.csr_array:
    """K of all elements by themselves, in the body's form."""
    if material.model == "cells":
        return springs_of_cells(rest.shape[0], own, material.stiffness, stiffness=1.0)
    least = np.finfo(np.float64).tiny  # a modulus must be above 0
    return elastic_tetrahedra(rest, own, young=np.maximum(material.young, least), poisson=material.poisson)


def _ties(rest: Float, own: Long, faces: Long, sides: Long, material: Material) -> Float:
    """Stiffness of the spring at each corner of a face, (F,) [N/m]."""
    stiffer = _STIFFER[own.shape[1]]
    if material.model == "cells":
        return stiffer * material.stiffness[sides].max(axis=1) / 4.0
    corner = rest[faces[:, :3]]
    area = 0.5 * np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
    said = (material.young, material.poisson)
    young, poisson = (np.broadcast_to(value, own.shape[:1])[sides] for value in said)
    modulus = (young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson))).max(axis=1)
    edges = rest[own[:, 1:]] - rest[own[:, :1]]
    thin = (np.abs(np.linalg.det(edges))[sides] / 2.0).min(axis=1) / area
    return stiffer * modulus * area / (3.0 * thin)


def _skin(skin: Skin, rest: Float, elements: Long, own: Long) -> Skin:
    """The skin, whose triangles each hang on their own element; one that runs through cubes is divided."""
    if elements.shape[1] == skin.nodes.shape[1] == len(CORNERS):
        skin, owner = divided(skin, rest, elements)
    else:
        owner = np.array([some[0] for some in carriers(skin, elements)], dtype=np.int64)
    pairs = np.stack([np.repeat(owner, 3), skin.triangles.ravel()], axis=1)
    used, corner = np.unique(pairs, axis=0, return_inverse=True)
    element, vertex = used.T
    nodes, weights = skin.nodes[vertex], skin.weights[vertex]
    best = np.argmax(np.abs(weights), axis=1)[:, None]
    nodes = np.where(weights == 0.0, np.take_along_axis(nodes, best, axis=1), nodes)
    place = np.argmax(nodes[:, :, None] == elements[element][:, None, :], axis=2)
    return Skin(
        vertices=skin.vertices[vertex],
        triangles=corner.reshape(-1, 3),
        nodes=np.take_along_axis(own[element], place, axis=1),
        weights=weights,
    )


def _parts_with_faces(body: Body) -> Body:
    """Of several bodies: those that can be cut."""
    assert body.material is not None
    parts: list[Part] = []
    first = 0
    for part in body.parts:
        own = with_faces(part.body) if part.body.cut_count else part.body
        parts.append(replace(part, body=own, first=first))
        first += own.nodes
    return joined(parts).with_gravity(body.material.gravity)
