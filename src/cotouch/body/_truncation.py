"""A body confined to a few shapes: its lowest modes, and how it yields where it is touched."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp

from cotouch.arrays import Float
from cotouch.body._eigenspaces import canonical
from cotouch.body._statics import factorise, lowest_modes
from cotouch.errors import BodyError, UnsupportedError

# A residual this small beside the whole answer is rounding; shapes whose mass is so small follow from the others.
_DEPENDENT = 1e-11
# Stiffnesses of residual shapes this close to each other, beside the largest, are equal.
_EQUAL = 1e-9
# How far from diagonal the damping may be in the shapes, relative to its largest entry there.
_COMMUTES = 1e-8


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Truncation:
    """Shapes that diagonalise mass and stiffness: `Ψᵀ M Ψ = I`, `Ψᵀ K Ψ = diag(stiffness)`.

    Made by `Body.truncated`.

    Attributes:
        shapes: Ψ, the modes and then the residual shapes, (rows of the body, q).
        stiffness: (q,) [1/s²].
        modes: r, how many of the shapes are natural modes.
        contacts: nodes whose static compliance is exact.
        error: largest relative error of the contacts' own static compliance, as it is [1].
        error_without: what it would be with the modes alone [1].
    """

    shapes: Float
    stiffness: Float
    modes: int
    contacts: tuple[int, ...]
    error: float
    error_without: float

    @property
    def frequencies(self) -> Float:
        """Of the natural modes, (r,) [Hz]."""
        return np.sqrt(self.stiffness[: self.modes]) / (2.0 * np.pi)

    def as_full(self, dimension: int) -> "Truncation":
        """The same shapes for a body with a row for every axis."""
        return Truncation(
            shapes=np.asarray(np.kron(self.shapes, np.eye(dimension)), dtype=np.float64),
            stiffness=np.repeat(self.stiffness, dimension),
            modes=self.modes * dimension,
            contacts=self.contacts,
            error=self.error,
            error_without=self.error_without,
        )

    def compliance(self, readings: Float) -> Float:
        """Static compliance that the shapes give among readings h (m, rows), rigid motions left out, (m, m) [m/N]."""
        bends = self.stiffness > 0.0
        read = readings @ self.shapes[:, bends]
        return (read / self.stiffness[bends]) @ read.T


def truncate(
    mass: sp.csr_array,
    damping: sp.csr_array,
    stiffness: sp.csr_array,
    rest: Float,
    *,
    modes: int,
    contacts: Sequence[int],
) -> Truncation:
    """The lowest modes and the residual shapes of the contacts; see `Body.truncated`.

    With Φ the kept modes, the static answer to a force at a contact is `K⁻¹h = Φ Λ⁻¹ Φᵀh + ψ`. The rest ψ is orthogonal
    to the modes in M and in K, so keeping it as a shape changes no mode and makes `hᵀK⁻¹h` exact [MacNeal 1971; Rubin
    1975].

    Args:
        mass: M, sparse [kg].
        damping: D, sparse [Ns/m].
        stiffness: K, sparse [N/m].
        rest: (n, 3) places at rest [m].
        modes: how many are kept.
        contacts: nodes at which static answers stay exact.
    """
    nodes, rows = rest.shape[0], mass.shape[0]
    if not 1 <= modes <= rows:
        raise BodyError(f"modes is {modes}; it must be from 1 to {rows}, the rows of this body")
    for contact in contacts:
        if not 0 <= contact < nodes:
            raise BodyError(f"contacts names node index {contact}; this body has nodes 0 to {nodes - 1}")
    kept = tuple(dict.fromkeys(int(contact) for contact in contacts))
    axes = rows // nodes
    statics = factorise(mass, stiffness, rest)
    values, shapes = lowest_modes(mass, stiffness, rest, min(modes + 1, rows), statics)
    if modes < values.size and values[modes] == 0.0:
        raise BodyError(f"modes is {modes}, but more rigid motions are free; keep at least these, or hold the body")
    values, shapes = values[:modes], shapes[:, :modes]
    bends = values > 0.0
    extra_values, extra = np.zeros(0), np.zeros((rows, 0))
    error = error_without = 0.0
    if kept:
        touched = (np.array(kept)[:, None] * axes + np.arange(int(axes))).ravel()
        loads = np.zeros((rows, touched.size))
        loads[touched, np.arange(touched.size)] = 1.0
        if bends.all():  # without the shift there is nothing to refine
            statics = factorise(mass, stiffness, rest, free=False)
        residual = statics.residual(loads, shapes)
        answers = residual + (shapes[:, bends] / values[bends]) @ shapes[touched][:, bends].T
        exact = np.diag(answers[touched])
        extra_values, extra = _orthonormal(mass, stiffness, residual, answers)
        without = np.sum(shapes[touched][:, bends] ** 2 / values[bends], axis=1)
        having = without + np.sum(extra[touched] ** 2 / extra_values, axis=1)
        error_without = float(np.max(np.abs(exact - without) / exact))
        error = float(np.max(np.abs(exact - having) / exact))
    everything = np.ascontiguousarray(np.hstack([shapes, extra]))
    turned = everything.T @ (damping @ everything)
    own = np.diag(turned)
    if np.abs(turned - np.diag(own)).max(initial=0.0) > _COMMUTES * np.abs(own).max(initial=0.0):
        raise UnsupportedError(
            "the damping of this body is not diagonal in its modes, so it cannot be truncated; use Rayleigh damping "
            "(damping proportional to mass and stiffness) without dampers to the ground"
        )
    return Truncation(
        shapes=everything,
        stiffness=np.concatenate([values, extra_values]),
        modes=modes,
        contacts=kept,
        error=error,
        error_without=error_without,
    )


def _orthonormal(mass: sp.csr_array, stiffness: sp.csr_array, residual: Float, answers: Float) -> tuple[Float, Float]:
    """Combinations of the residual shapes that are orthonormal in M and orthogonal in K, and their K."""
    scale = np.sqrt(np.einsum("ij,ij->j", residual, mass @ residual))
    whole = np.sqrt(np.einsum("ij,ij->j", answers, mass @ answers))
    useful = scale > _DEPENDENT * whole
    if not useful.any():
        return np.zeros(0), np.zeros((mass.shape[0], 0))
    columns = residual[:, useful] / scale[useful]
    sizes, turn = la.eigh(columns.T @ (mass @ columns))
    good = sizes > _DEPENDENT * sizes.max(initial=0.0)
    basis = columns @ (turn[:, good] / np.sqrt(sizes[good]))
    values, turn = la.eigh(basis.T @ (stiffness @ basis))
    return values, canonical(values, basis @ turn, mass, _EQUAL * values[-1])


def missing_at(
    readings: sp.csr_array, kept: Truncation, mass: sp.csr_array, stiffness: sp.csr_array, rest: Float
) -> Float:
    """Static compliance that a truncation lacks between some readings of the rows, (m, m).

    Args:
        readings: of the rows, (m, rows).
        kept: the truncation.
        mass: M.
        stiffness: K.
        rest: shape at rest, (n, d) [m].
    """
    loads = np.ascontiguousarray(readings.toarray().T)
    statics = factorise(mass, stiffness, rest, free=bool(np.any(kept.stiffness == 0.0)))
    # The modes proper are taken out of the load; the residual shapes, which are no modes, out of its answer.
    missing = np.asarray(readings @ statics.residual(loads, kept.shapes[:, : kept.modes]))
    residual = np.asarray(readings @ kept.shapes[:, kept.modes :])
    missing -= (residual / kept.stiffness[kept.modes :]) @ residual.T
    return 0.5 * (missing + missing.T)
