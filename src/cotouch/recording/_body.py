"""The shared object as a recording carries it: the matrices themselves, so that an audit needs no other file."""

import io
import zipfile
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, final

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float, Int
from cotouch.body import Body, Matrix
from cotouch.errors import BodyError, RecordingError
from cotouch.mechanics import Model
from cotouch.recording._material import PARTS, RecordedMaterial, matrix_of

_MATRICES = ("mass", "damping", "stiffness")
_UNREADABLE = (
    OSError,
    ValueError,
    KeyError,
    EOFError,
    IndexError,
    TypeError,
    zipfile.BadZipFile,
    RuntimeError,  # a part that says it is encrypted, or packed by a method that nobody knows
    zlib.error,
    BodyError,
)


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class RecordedBody:
    """M, B, K and the link weights in the body's own rows, and how the recorded rows become nodes.

    With a material its rows are the nodes, and B and K are of the ground only.

    Attributes:
        rest: shape at rest, (n, d) [m].
        mass: M, n x n or nd x nd [kg].
        damping: B [Ns/m].
        stiffness: K [N/m].
        weights: link weights W_0, W_1, ...; W_0 is the identity, of a truncated body M over the mean mass of a row.
        modes: columns are the shapes that the recorded rows are coordinates of, in the body's rows; None: none.
        order: recorded row k is row `order[k]` of the body; None where they are in the same order.
        material: what the inner forces follow; None where they are in B and K.
    """

    rest: Float
    mass: sp.csr_array
    damping: sp.csr_array
    stiffness: sp.csr_array
    weights: tuple[sp.csr_array, ...]
    modes: Float | None
    order: Int | None
    material: RecordedMaterial | None = None

    @property
    def full(self) -> bool:
        """Whether each axis of a node has a row of its own."""
        return self.mass.shape[0] != self.rest.shape[0]

    @property
    def axes(self) -> int:
        """Columns of a recorded field."""
        return 1 if self.full else self.rest.shape[1]

    @property
    def rows(self) -> int:
        """Rows of a recorded field."""
        return self.mass.shape[0] if self.modes is None else self.modes.shape[1]

    @classmethod
    def of(cls, model: Model, *, weights: Sequence[Matrix] = ()) -> "RecordedBody":
        """Takes it from a model.

        Args:
            model: of the session; the matrices are those of its body, not what the kernels made of them.
            weights: those that the model was made with, besides the identity.
        """
        body = model.body
        if body.material is not None:
            return _of_material(model, body, weights)
        rows = body.mass.shape[0]
        first = sp.eye_array(rows, format="csr")
        if body.truncation is not None:
            first = sp.csr_array(body.mass * (rows / float(body.mass.sum())))
        return cls(
            rest=body.rest,
            mass=body.mass,
            damping=body.damping,
            stiffness=body.stiffness,
            weights=(sp.csr_array(first), *(_fit(weight, body.nodes, rows) for weight in weights)),
            modes=model.modes,
            order=model.order,
        )

    def field(self, rows: Float) -> Float:
        """Recorded rows (..., rows, axes) in the body's own rows."""
        if self.order is not None:
            rows = rows[..., np.argsort(self.order), :]
        return rows if self.modes is None else self.modes @ rows

    def nodes(self, rows: Float) -> Float:
        """Recorded rows (..., rows, axes) as displacements of nodes (..., n, d)."""
        return self.field(rows).reshape(*rows.shape[:-2], *self.rest.shape)

    def form(self, matrix: sp.csr_array, left: Float, right: Float | None = None) -> Float:
        """`leftᵀ matrix right`, for fields (steps, body rows, axes), (steps,).

        Args:
            matrix: of the body.
            left: one field.
            right: the other; None: the same.
        """
        return np.einsum("sra,sra->s", left, self.image(matrix, left if right is None else right))

    def image(self, matrix: sp.csr_array, field: Float) -> Float:
        """`matrix field` at every step, for fields (steps, body rows, axes).

        Args:
            matrix: of the body.
            field: the field.
        """
        steps, rows, axes = field.shape
        turned = np.ascontiguousarray(field.transpose(1, 0, 2)).reshape(rows, steps * axes)
        return np.asarray(matrix @ turned).reshape(rows, steps, axes).transpose(1, 0, 2)

    def to_bytes(self) -> bytes:
        """As a compressed NPZ file."""
        arrays: dict[str, Any] = {"rest": self.rest}
        for name, matrix in self._named().items():
            arrays |= {f"{name}_{part}": getattr(matrix, part) for part in PARTS}
        if self.modes is not None:
            arrays["modes"] = self.modes
        if self.order is not None:
            arrays["order"] = self.order
        if self.material is not None:
            arrays |= self.material.arrays()
        file = io.BytesIO()
        np.savez_compressed(file, **arrays)
        return file.getvalue()

    @classmethod
    def from_bytes(cls, data: bytes) -> "RecordedBody":
        """The inverse of `to_bytes`.

        Raises:
            RecordingError: it is none.
        """
        try:
            with np.load(io.BytesIO(data), allow_pickle=False) as arrays:
                size = int(arrays["mass_indptr"].size) - 1
                count = sum(name.startswith("weight") and name.endswith("_data") for name in arrays.files)
                result = cls(
                    rest=arrays["rest"],
                    **{name: matrix_of(arrays, name, size) for name in _MATRICES},
                    weights=tuple(matrix_of(arrays, f"weight{w}", size) for w in range(count)),
                    modes=arrays["modes"] if "modes" in arrays.files else None,
                    order=arrays["order"] if "order" in arrays.files else None,
                    material=RecordedMaterial.of_arrays(arrays, arrays["rest"]),
                )
        except _UNREADABLE as error:
            raise RecordingError(f"the recording's body cannot be read: {error}") from None
        if result.rest.ndim != 2 or size not in {result.rest.shape[0], result.rest.size}:
            raise RecordingError(f"the recording's body has {size} rows and a rest shape of {result.rest.shape}")
        if result.modes is not None and (result.modes.ndim != 2 or result.modes.shape[0] != size):
            raise RecordingError(f"the recording's shapes are {result.modes.shape}; its body has {size} rows")
        if result.order is not None and not np.array_equal(np.sort(result.order), np.arange(size)):
            raise RecordingError(f"the recording's order of rows does not fit its body {size} rows")
        if result.material is not None and (result.modes is not None or size != result.rest.shape[0]):
            raise RecordingError(f"the recording's body has a material, but {size} rows, or modes")
        return result

    def _named(self) -> dict[str, sp.csr_array]:
        own = {name: getattr(self, name) for name in _MATRICES}
        return own | {f"weight{w}": weight for w, weight in enumerate(self.weights)}


def _of_material(model: Model, body: Body, weights: Sequence[Matrix]) -> RecordedBody:
    """Masses and what the ground does of its nodes, and the material."""
    order = np.arange(body.nodes) if model.order is None else model.order
    back = np.argsort(order)
    mass, drag, ground = (
        sp.csr_array(sp.diags_array(diagonal[back]))
        for diagonal in (model.operator.mass, model.operator.drag, model.operator.ground)
    )
    rows, known = body.nodes, sp.csr_array(sp.diags_array(model.operator.weight[0][back]))
    tied = sp.diags_array((known.diagonal() > 0.0).astype(np.float64))  # links do not know of tools
    return RecordedBody(
        rest=body.rest,
        mass=mass,
        damping=drag,
        stiffness=ground,
        weights=(known, *(sp.csr_array(tied @ _fit(weight, rows, rows) @ tied) for weight in weights)),
        modes=None,
        order=model.order,
        material=RecordedMaterial.of(model),
    )


def _fit(weight: Matrix, nodes: int, rows: int) -> sp.csr_array:
    """A weight in rows of the body: one for whole rows, for nodes, or for the axes of every node."""
    own = sp.csr_array(weight if sp.issparse(weight) else np.atleast_2d(np.asarray(weight, dtype=np.float64)))
    axes = rows // nodes
    if own.shape == (rows, rows):
        return own
    if own.shape == (nodes, nodes):
        return sp.csr_array(sp.kron(own, sp.eye_array(axes)))
    if own.shape == (axes, axes):
        return sp.csr_array(sp.kron(sp.eye_array(nodes), own))
    raise RecordingError(f"a link weight is {own.shape[0]} x {own.shape[1]}; the body has {nodes} nodes, {rows} rows")
