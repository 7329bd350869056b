"""Stiffness matrices of solids: linear elasticity, and scalar springs that store the same energy in a stretched bar."""

from typing import TYPE_CHECKING, Final

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float, Long
from cotouch.body._cells import CORNERS

if TYPE_CHECKING:
    from skfem import Basis, DiscreteField

# The twelve edges of a cell, as pairs of its corners.
EDGES: Final = [(i, j) for i in range(8) for j in range(i + 1, 8) if int(np.abs(CORNERS[i] - CORNERS[j]).sum()) == 1]


def elastic_tetrahedra(
    points: Float, tetrahedra: Long, *, young: float | Float, poisson: float | Float
) -> sp.csr_array:
    """K of isotropic linear elasticity on linear tetrahedra (P1), 3n x 3n [N/m], by scikit-fem.

    Args:
        points: (n, 3) [m].
        tetrahedra: (E, 4) indices of points.
        young: Young's modulus, one or (E,) [Pa].
        poisson: Poisson's ratio, likewise.
    """
    from skfem import Basis, ElementTetP1, ElementVector, MeshTet
    from skfem.models.elasticity import lame_parameters, linear_elasticity

    mesh = MeshTet(np.ascontiguousarray(points.T), np.ascontiguousarray(tetrahedra.T))
    # Strains are constant in an element, so one point integrates them exactly.
    basis = Basis(mesh, ElementVector(ElementTetP1()), intorder=1)
    moduli = lame_parameters(_column(young), _column(poisson))
    return _by_nodes(linear_elasticity(*moduli).assemble(basis), basis)


def springs_of_tetrahedra(points: Float, tetrahedra: Long, *, young: float | Float) -> sp.csr_array:
    """K of the energy `½ E ∫ |∇u|²` on linear tetrahedra, n x n [N/m], by scikit-fem.

    Off the diagonal it is minus a spring for each edge, `k_ij = -E ∫ ∇φ_i·∇φ_j` (the cotangent weights). It stretches a
    bar by E A / L exactly. A flat element may have a spring below zero; the sum stays positive semidefinite.

    Args:
        points: (n, 3) [m].
        tetrahedra: (E, 4) indices of points.
        young: Young's modulus, one or (E,) [Pa].
    """
    from skfem import Basis, BilinearForm, ElementTetP1, MeshTet
    from skfem.helpers import dot, grad

    mesh = MeshTet(np.ascontiguousarray(points.T), np.ascontiguousarray(tetrahedra.T))
    basis = Basis(mesh, ElementTetP1(), intorder=1)
    modulus = _column(young)

    def form(u: "DiscreteField", v: "DiscreteField", _: object) -> Float:
        return modulus * dot(grad(u), grad(v))

    return sp.csr_array(BilinearForm(form).assemble(basis))


def springs_along_edges(nodes: int, tetrahedra: Long, *, stiffness: float) -> sp.csr_array:
    """K of equal springs along the edges of tetrahedra, n x n [N/m].

    Args:
        nodes: how many.
        tetrahedra: (E, 4) indices of points.
        stiffness: of one spring [N/m].
    """
    pairs = edges_of(tetrahedra)
    return laplacian_of(nodes, pairs, np.full(len(pairs), stiffness))


def edges_of(tetrahedra: Long) -> Long:
    """Every edge once, (.., 2)."""
    pairs = np.concatenate([tetrahedra[:, [i, j]] for i in range(4) for j in range(i + 1, 4)])
    return np.unique(np.sort(pairs, axis=1), axis=0)


def elastic_cells(
    nodes: int, corners: Long, fill: Float, *, spacing: float, young: float, poisson: float
) -> sp.csr_array:
    """K of isotropic linear elasticity on cubes with trilinear shapes (Q1), 3n x 3n [N/m], each scaled by its fill.

    Args:
        nodes: how many.
        corners: (C, 8) nodes of each cube, in the order of `CORNERS`.
        fill: (C,) share of each cube that the body takes.
        spacing: edge of a cube [m].
        young: Young's modulus [Pa].
        poisson: Poisson's ratio.
    """
    from skfem import Basis, ElementHex1, ElementVector, MeshHex
    from skfem.models.elasticity import lame_parameters, linear_elasticity

    cube = MeshHex()
    basis = Basis(cube, ElementVector(ElementHex1()), intorder=3)
    one = _by_nodes(linear_elasticity(*lame_parameters(young, poisson)).assemble(basis), basis).toarray()
    order = np.array([int(np.argmin(np.abs(cube.p.T - corner).sum(axis=1))) for corner in CORNERS])
    rows = (order[:, None] * 3 + np.arange(3)).ravel()
    one = one[rows][:, rows] * spacing
    one = 0.5 * (one + one.T)
    places = (corners[:, :, None] * 3 + np.arange(3)).reshape(-1, 24)
    return _assembled(3 * nodes, places, one, fill)


def springs_of_cells(nodes: int, corners: Long, fill: Float, *, stiffness: float) -> sp.csr_array:
    """K of springs along the edges of cubes, n x n [N/m]: each cube gives a quarter of `stiffness` to each edge.

    Inside, where four full cubes share an edge, a spring has `stiffness`. With `stiffness = E h` a bar along the grid
    stretches by E A / L exactly: each of the A/h² rows of springs has E h per cell of length h.

    Args:
        nodes: how many.
        corners: (C, 8) nodes of each cube, in the order of `CORNERS`.
        fill: (C,) share of each cube that the body takes.
        stiffness: of one spring [N/m].
    """
    one = np.zeros((8, 8))
    for i, j in EDGES:
        one[[i, j], [i, j]] += 0.25 * stiffness
        one[[i, j], [j, i]] -= 0.25 * stiffness
    return _assembled(nodes, corners, one, fill)


def cubes_of(extents: tuple[int, ...]) -> Long:
    """Corners of the cubes of a box of nodes, (.., 8), in the order of `CORNERS`."""
    index = np.arange(int(np.prod(extents))).reshape(extents)
    ends = [slice(0, -1), slice(1, None)]
    return np.stack([index[ends[a], ends[b], ends[c]].ravel() for a, b, c in CORNERS], axis=1).astype(np.int64)


def network_of_cells(corners: Long, fill: Float, *, stiffness: float) -> tuple[Long, Float]:
    """Springs along edges and across faces of cubes, each edge once, (.., 2), and their stiffness.

    With springs of k inside along both, the lattice is isotropic, with `E = 2.5 k / h` and a Poisson's ratio of ¼: four
    cubes share an edge, two a face.

    Args:
        corners: (C, 8) nodes of each cube, in the order of `CORNERS`.
        fill: (C,) share of each cube that the body takes.
        stiffness: of one spring [N/m].
    """
    apart = {1: 0.25, 2: 0.5}
    kinds = [(i, j, int(np.abs(CORNERS[i] - CORNERS[j]).sum())) for i in range(8) for j in range(i + 1, 8)]
    chosen = [(i, j, apart[steps]) for i, j, steps in kinds if steps in apart]
    pairs = np.concatenate([np.sort(corners[:, [i, j]], axis=1) for i, j, _ in chosen])
    fractions = np.concatenate([fraction * stiffness * fill for _, _, fraction in chosen])
    edges, place = np.unique(pairs, axis=0, return_inverse=True)
    return edges, np.bincount(place.ravel(), weights=fractions).astype(np.float64)


def laplacian_of(nodes: int, edges: Long, stiffness: Float) -> sp.csr_array:
    """K of scalar springs, n x n [N/m].

    Args:
        nodes: how many.
        edges: (S, 2) pairs of nodes.
        stiffness: (S,) of each spring [N/m].
    """
    i, j = edges.T
    values = np.concatenate([stiffness, stiffness, -stiffness, -stiffness])
    return sp.csr_array((values, (np.r_[i, j, i, j], np.r_[i, j, j, i])), shape=(nodes, nodes))


def _assembled(rows: int, places: Long, one: Float, fill: Float) -> sp.csr_array:
    size = one.shape[0]
    i = np.repeat(places, size, axis=1).ravel()
    j = np.tile(places, (1, size)).ravel()
    values = (fill[:, None] * one.ravel()[None, :]).ravel()
    kept = np.tile(one.ravel() != 0.0, fill.size)
    return sp.csr_array((values[kept], (i[kept], j[kept])), shape=(rows, rows))


def _column(values: float | Float) -> float | Float:
    """With one number for each element, beside its one point of integration."""
    return np.reshape(values, (-1, 1)) if np.ndim(values) else values


def _by_nodes(matrix: sp.csr_array, basis: "Basis") -> sp.csr_array:
    """With rows ordered node by node, whatever order the assembler uses."""
    order = np.asarray(basis.nodal_dofs).T.ravel()
    csr = sp.csr_array(matrix)
    return csr if np.array_equal(order, np.arange(order.size)) else sp.csr_array(csr[order][:, order])
