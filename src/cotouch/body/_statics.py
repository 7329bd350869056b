"""Natural modes and static answers of large bodies: a factorisation ordered by where the nodes are."""

from dataclasses import dataclass
from typing import final

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp
from scipy.sparse.linalg import LinearOperator, SuperLU, eigsh, splu

from cotouch.arrays import Float, Index
from cotouch.body._eigenspaces import canonical

# Up to here a dense eigenvalue solve takes well under a second.
_DENSE_ROWS = 600
# A piece of this many nodes is ordered as it comes.
_LEAF = 64
# The shift that makes a free body's K invertible, beside its lowest elastic eigenvalue as a uniform grid would have it.
_SHIFT = 1e-3
# Eigenvalues this small beside the shift are rigid motions.
_RIGID = 1e-6
# Rounding of a dense solve, in last places of the largest eigenvalue.
_ROUNDINGS = 16.0
# Eigenvalues this close to each other, relatively, are equal.
_EQUAL = 1e-9
# Shapes looked for beyond those that are wanted, so that all of a repeated eigenvalue are found.
_MORE = 6
# Each refinement leaves of the error the share that the shift has in the lowest eigenvalue left, mostly a thousandth.
_REFINEMENTS = 40
_EXACT = 1e-12


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Statics:
    """K and M of a body with `K + shift M` factorised.

    Attributes:
        mass: M, (rows, rows).
        stiffness: K, (rows, rows).
        shift: [1/s²].
        factors: of the permuted matrix.
        order: rows in the order of the factors.
    """

    mass: sp.csr_array
    stiffness: sp.csr_array
    shift: float
    factors: SuperLU
    order: Index

    def solve(self, rhs: Float) -> Float:
        """`(K + shift M)⁻¹ rhs`."""
        result = np.empty_like(rhs)
        result[self.order] = self.factors.solve(np.ascontiguousarray(rhs[self.order]))
        return result

    def residual(self, loads: Float, shapes: Float) -> Float:
        """What K answers to loads, (rows, m), beyond what modes Φ answer: `K ψ = (I - M Φ Φᵀ) f`, `Φᵀ M ψ = 0`.

        All rigid motions must be among the modes. A load then finds inertia relief: the shape that a free body takes
        while the load accelerates it.

        Args:
            loads: (rows, m) [N].
            shapes: (rows, m) mass-normal modes.
        """
        carried = self.mass @ shapes
        balanced = loads - carried @ (shapes.T @ loads)
        answer = np.zeros_like(loads)
        for _ in range(_REFINEMENTS):  # several, because the shift is no part of K
            missed = balanced - self.stiffness @ answer
            missed -= carried @ (shapes.T @ missed)
            change = self.solve(missed)
            change -= shapes @ (carried.T @ change)
            answer += change
            if np.abs(change).max(initial=0.0) <= _EXACT * np.abs(answer).max(initial=0.0):
                break
        return answer


def factorise(mass: sp.csr_array, stiffness: sp.csr_array, rest: Float, *, free: bool = True) -> Statics:
    """Factorises `K + shift M`, with the rows ordered by nested dissection of the nodes' places [George 1973].

    For a solid of 20,000 nodes this needs a third of the fill and an eighth of the time of minimum degree. Where
    nothing is free the shift may be left out.

    Args:
        mass: M, sparse [kg].
        stiffness: K, sparse [N/m].
        rest: (n, 3) places at rest [m].
        free: whether rigid motions may be free.
    """
    nodes = int(rest.shape[0])
    axes = mass.shape[0] // nodes
    shift = _SHIFT * _lowest_guess(mass, stiffness, nodes) if free else 0.0
    graph = _node_graph(abs(stiffness) + abs(mass), axes)
    order = (np.concatenate(_dissect(np.arange(nodes), rest, graph))[:, None] * axes + np.arange(axes)).ravel()
    shifted = sp.csr_array(stiffness + shift * mass)
    permuted = sp.csc_array(shifted[order][:, order])
    factors = splu(permuted, permc_spec="NATURAL", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    return Statics(mass=mass, stiffness=stiffness, shift=shift, factors=factors, order=order)


def _lowest_guess(mass: sp.csr_array, stiffness: sp.csr_array, nodes: int) -> float:
    """About the lowest eigenvalue that bends a body, as a uniform grid of so many nodes would have it [1/s²].

    From the median of the rows, because a few may be held very hard.
    """
    middle = float(np.median(stiffness.diagonal() / mass.diagonal()))
    return (middle if middle > 0.0 else 1.0) / nodes ** (2.0 / 3.0)


def _node_graph(matrix: sp.csr_array, axes: int) -> sp.csr_array:
    coo = matrix.tocoo()
    nodes = matrix.shape[0] // axes
    return sp.csr_array((np.ones(coo.nnz, np.int8), (coo.row // axes, coo.col // axes)), shape=(nodes, nodes))


def _dissect(piece: Index, rest: Float, graph: sp.csr_array) -> list[Index]:
    """Halves first, then the nodes that separate them."""
    if piece.size <= _LEAF:
        return [piece]
    along = rest[piece]
    axis = int(np.argmax(np.ptp(along, axis=0)))
    low = along[:, axis] < np.median(along[:, axis])
    first, second = piece[low], piece[~low]
    if first.size == 0:
        return [piece]
    reached = np.diff(graph[second][:, first].indptr) > 0
    if reached.all():
        return [*_dissect(first, rest, graph), second]
    return [*_dissect(first, rest, graph), *_dissect(second[~reached], rest, graph), second[reached]]


def lowest_modes(
    mass: sp.csr_array, stiffness: sp.csr_array, rest: Float, count: int, statics: Statics | None = None
) -> tuple[Float, Float]:
    """The lowest eigenpairs of `K φ = λ M φ`, `φᵀ M φ = 1`.

    Args:
        mass: M.
        stiffness: K.
        rest: places of the nodes.
        count: how many; fewer where the body has fewer rows.
        statics: the factors, if there are some already.

    Returns:
        λ (count,) [1/s²], exactly 0 for rigid motions, and Φ (rows, count), the same on every machine: see `canonical`.
    """
    rows = mass.shape[0]
    count = min(count, rows)
    wanted = count
    while True:
        wanted = min(wanted + _MORE, rows)
        values, shapes, closeness = _lowest(mass, stiffness, rest, wanted, statics)
        # Where the last of them has equals that are not there yet, which of them it is would be left to round-off.
        if wanted == rows or (np.diff(values[count - 1 :]) > closeness[count - 1 :]).any():
            return values[:count], np.ascontiguousarray(canonical(values, shapes, mass, closeness)[:, :count])
        wanted *= 2


def _lowest(
    mass: sp.csr_array, stiffness: sp.csr_array, rest: Float, wanted: int, statics: Statics | None
) -> tuple[Float, Float, Float]:
    """λ, Φ, and how close neighbours of the λ can be and still be equal."""
    rows = mass.shape[0]
    guess = _lowest_guess(mass, stiffness, rest.shape[0])
    if rows <= _DENSE_ROWS or wanted > rows // 3:
        values, shapes = la.eigh(stiffness.toarray(), mass.toarray(), subset_by_index=[0, wanted - 1])
        highest = float((stiffness.diagonal() / mass.diagonal()).max(initial=0.0))
        noise = _ROUNDINGS * np.finfo(np.float64).eps * highest
        limit = max(_RIGID * _SHIFT * guess, noise)
    else:
        ready = factorise(mass, stiffness, rest) if statics is None else statics
        inverse = LinearOperator((rows, rows), matvec=lambda b: ready.solve(np.asarray(b).ravel()), dtype=np.float64)
        values, shapes = eigsh(
            stiffness,
            k=wanted,
            M=mass,
            sigma=-ready.shift,
            OPinv=inverse,
            v0=np.cos(np.arange(rows) * 1.618),  # any fixed vector, so that the same body gives the same modes
            ncv=min(rows, max(2 * wanted + 1, wanted + 20)),
        )
        best = np.argsort(values)
        values, shapes = values[best], shapes[:, best]
        noise, limit = 0.0, _RIGID * _SHIFT * guess
    values = np.where(values < limit, 0.0, values)
    return values, shapes, np.asarray(noise + _EQUAL * values[1:])
