"""A body made ready for the kernels: in its own basis, or in the modal basis where everything commutes."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, final

import numpy as np
import numpy.typing as npt
import scipy.linalg as la
import scipy.sparse as sp

from cotouch.arrays import Float, Int
from cotouch.body import Body, Material, Matrix, Truncation, canonical
from cotouch.errors import BodyError, UnsupportedError
from cotouch.kernels import WIDTHS
from cotouch.mechanics._linear._link_weight import fit_weights
from cotouch.mechanics._linear._operator import MASS, STIFFNESS, WEIGHTS, Operator, cuttable, halves, mixed, operator_of
from cotouch.mechanics._linear._state import Workspace, workspace
from cotouch.mechanics._materials._arrays import cut_law, force_of, outline_of
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._materials._memory import fresh_memory
from cotouch.mechanics._materials._together import Together, fresh_together
from cotouch.mechanics._meeting._bodies import Between
from cotouch.mechanics._meeting._tool_bodies import link_weights, rigid_rows
from cotouch.mechanics._meeting._world import Obstacle, solids_of
from cotouch.mechanics._meeting._world_points import world_of

Basis = Literal["auto", "nodal", "modal"]

# Up to this many rows "auto" tries the modal basis. Each hand and each recorded node reads a whole row of modes there:
# with one or two hands a step costs half of what it does in the body's own basis, with five as much.
_MODAL_ROWS = 256
# Eigenvalues that differ by no more than this, beside the largest, are equal.
_EQUAL = 1e-13
# How far from diagonal a matrix may be in the modal basis, relative to its largest entry there, to count as commuting.
_COMMUTES = 1e-11


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Model:
    """A body and its link weights in the form that `step` works on.

    Make it with `model`.

    Attributes:
        body: the body.
        operator: its matrices for the kernels.
        modes: columns are the modes in the body's own rows, (body rows, rows); None in the nodal basis. A truncated
            body has fewer columns than rows.
        inverse: the inverse of `modes`, or `modesᵀ M`, which projects on them; None in the nodal basis.
        order: row k of the kernels is row `order[k]` of the body; None where they are in the same order.
        force: what resists inside a body of some material; None where K and B of the operator do.
        memory: numbers that it remembers of a copy, with those of the world.
        obstacles: what stands still around the body.
        between: what its parts do to each other, of several bodies.
        cut: where in the memory it is which elements were cut, and by whom; negative: none can be.
    """

    body: Body
    operator: Operator
    modes: Float | None
    inverse: Float | None
    order: Int | None
    force: BodyForce | None = None
    memory: int = 0
    obstacles: tuple[Obstacle, ...] = ()
    between: Between | None = None
    cut: int = -1

    @property
    def basis(self) -> Literal["nodal", "modal"]:
        """Which basis the rows are in."""
        return "nodal" if self.modes is None else "modal"

    @property
    def full(self) -> bool:
        """Whether each axis of a node has a row of its own."""
        return self.force is None and self.body.form == "full"

    @property
    def operator_rows(self) -> int:
        """Number of rows."""
        return self.operator.mass.size

    @property
    def width(self) -> int:
        """Columns of a field in the kernels: 1 or 4."""
        return 1 if self.full else next(w for w in WIDTHS if w >= self.body.dimension)

    @property
    def lanes(self) -> tuple[int, ...]:
        """The width as kernels want it."""
        return (0,) * self.width

    def to_rows(self, field: npt.ArrayLike) -> Float:
        """A displacement or velocity field (n, d) in the kernels' rows, (rows, width).

        Of what a truncated body's shapes cannot take, the part orthogonal to them in M is dropped.
        """
        values = np.asarray(field, dtype=np.float64).reshape(self.body.nodes, self.body.dimension)
        rows = values.reshape(-1, 1) if self.full else values
        if self.inverse is not None:
            rows = self.inverse @ rows
        if self.order is not None:
            rows = rows[self.order]
        out = np.zeros((self.operator_rows, self.width))
        out[:, : rows.shape[1]] = rows
        return out

    def to_nodes(self, rows: Float) -> Float:
        """The inverse of `to_rows`: (rows, width) to (n, d), always a copy."""
        columns = rows[:, :1] if self.full else rows[:, : self.body.dimension]
        if self.order is not None:
            columns = columns[np.argsort(self.order)]
        if self.modes is not None:
            columns = self.modes @ columns
        return np.array(columns).reshape(self.body.nodes, self.body.dimension)

    def unturned(self) -> Float:
        """What a body force remembers of a copy that it has not seen, (memory,)."""
        if self.force is not None and isinstance(self.force.table, Together):
            return fresh_together(self.force.table, self.memory - int(self.force.table.memory[-1]))
        behind = 0 if self.force is None else self.force.behind
        return fresh_memory(behind, self.memory - behind) if behind else fresh_memory(self.memory)

    def workspace(self, ports: int) -> Workspace:
        """Scratch for steps with at most so many ports of one user."""
        among = rigid_rows(self.body, self.order)
        return workspace(self.operator, self.width, ports, closed=self.force is not None, among=among)

    def port_rows(self, node: int) -> Int:
        """Rows that hold a node, in the body's own basis: one, or one for each axis in the full form.

        Of a rigid body the "node" is one of `Body.held_rest`, and so is the row.
        """
        if self.body.rigid:
            return np.array([node], dtype=np.int32)
        axes = self.body.dimension if self.full else 1
        own = node * axes + np.arange(axes)
        return (own if self.order is None else np.argsort(self.order)[own]).astype(np.int32)

    def port_shapes(self, rows: Int) -> Float:
        """The row vectors by which ports read the kernels' rows: empty (0, rows) where they are unit vectors."""
        if self.body.held_shares is not None:
            return np.ascontiguousarray(self.body.held_shares[rows])
        if self.modes is None:
            return (rows[: None if self.body.tools else 0, None] == np.arange(self.operator_rows)).astype(np.float64)
        return np.ascontiguousarray(self.modes[rows])


def model(
    body: Body,
    *,
    copies: int = 1,
    weights: Sequence[Matrix] = (),
    basis: Basis = "auto",
    obstacles: Sequence[Obstacle] = (),
    between: Between | None = None,
) -> Model:
    """Makes a body ready for the kernels.

    Args:
        body: the shared object.
        copies: N; each copy carries 1/N of mass, damping and stiffness [Lee & Huang 2010, eq. 3].
        weights: link weights W_1, W_2, ... besides the identity W_0: n x n, nd x nd, or (for anisotropic springs that
            are the same at every node) d x d.
        basis: "nodal" solves by iteration; "modal" needs M, B, K and all weights to be diagonal in one
            basis, where the solve is a division; "auto" takes the modal one where it exists and pays. A truncated body
            is always in its shapes.
        obstacles: what each copy meets 1/N of. A body without a material is then one whose material is linear.
        between: what bodies do to each other, and each to itself, likewise 1/N of; None: the default of `Between`.

    Raises:
        BodyError: a weight does not fit the body; an obstacle is too thin for its skin.
        UnsupportedError: basis "modal" where the matrices do not commute; a truncated body with basis "nodal", link
            weights or obstacles; a material with basis "modal", weights that couple axes, or on one axis; no skin.
    """
    if copies < 1:
        raise BodyError(f"copies is {copies}; there must be at least 1 user")
    if body.truncation is not None:
        if basis == "nodal" or weights or obstacles:
            what = 'basis is "nodal"' if basis == "nodal" else "the links have weights of their own"
            what = "there are obstacles" if obstacles else what
            raise UnsupportedError(
                f"{what}, but the body is truncated to a few shapes; leave that out, or the truncation"
            )
        return _truncated(body, body.truncation, copies)
    if obstacles and body.material is None:
        body = body.with_gravity((0.0, 0.0, 0.0))
    if body.material is not None:
        return _of_material(body, body.material, copies, weights, basis, obstacles, between)
    fitted, full = fit_weights(body, weights)
    if body.form == "node" and full:
        body = body.as_full()
        fitted, _ = fit_weights(body, weights)
    rows = body.mass.shape[0]
    matrices = [body.mass, body.damping, body.stiffness, sp.eye_array(rows, format="csr"), *fitted]
    order, split = halves(matrices)
    ordered = matrices if order is None else [sp.csr_array(matrix[order][:, order]) for matrix in matrices]
    plain = Model(body=body, operator=operator_of(ordered, copies, split), modes=None, inverse=None, order=order)
    if basis == "nodal" or (basis == "auto" and (plain.operator.entries.shape[0] == 0 or rows > _MODAL_ROWS)):
        return plain
    changed = _modal(body, matrices, copies)
    if isinstance(changed, Model):
        return changed
    if basis == "modal":
        raise UnsupportedError(f'basis is "modal", but {changed}; use "nodal" or "auto"')
    return plain


def _of_material(
    body: Body,
    material: Material,
    copies: int,
    weights: Sequence[Matrix],
    basis: Basis,
    obstacles: Sequence[Obstacle],
    between: Between | None,
) -> Model:
    """The model of a body whose inner forces are not linear: its matrices give the direction of a step."""
    if basis == "modal":
        raise UnsupportedError(f'basis is "modal", but model is "{material.model}", which has no modes; use "auto"')
    if body.dimension < 2:
        raise UnsupportedError("the body has one axis; weight, obstacles and what turns need 2 or 3")
    outline = outline_of(body, material)
    fitted, full = fit_weights(outline, weights)
    if full:
        raise UnsupportedError(
            f'model is "{material.model}", so link weights must be {body.nodes} x {body.nodes}, alike along each axis'
        )
    matrices = [outline.mass, outline.damping, outline.stiffness, *link_weights(body, fitted)]
    order, split = (None, 0) if body.rigid else halves(matrices)
    ordered = matrices if order is None else [sp.csr_array(matrix[order][:, order]) for matrix in matrices]
    force, memory = force_of(body, material, order)
    force = force._replace(behind=memory)
    solids = bool(solids_of(obstacles, body))
    meets = len(body.parts) > 1 or (bool(body.parts) and (solids or (between is not None and between.own)))
    between = (between or Between()) if meets else None
    if obstacles or between is not None:
        world, more = world_of(body, obstacles, between, order, memory)
        force, memory = force._replace(world=world), memory + more
        force = force._replace(parts=force.parts and world.bodies and force.parts._replace(met=world.bodies.met))
    cut = -1
    if body.cut_count:
        cut, memory = memory + 1, memory + 1 + 2 * body.cut_count
        force = force.following(cut_law(body, force.table, cut))._replace(cut=cut - 1)
    op = operator_of(ordered, copies, split)
    return Model(
        body=body,
        operator=op if cut < 0 else cuttable(op, body.cut_count),
        modes=None,
        inverse=None,
        order=order,
        force=force,
        memory=memory,
        obstacles=tuple(obstacles),
        between=between,
        cut=cut,
    )


def _modal(body: Body, matrices: list[sp.csr_array], copies: int) -> Model | str:
    """The model in the basis that diagonalises every matrix, or the reason why there is none."""
    dense = [matrix.toarray() for matrix in matrices]
    mass = dense[MASS]
    # One matrix with generic coefficients splits eigenspaces that K alone leaves open; sizes are evened out first.
    mixture = np.zeros_like(mass)
    for q, matrix in enumerate(dense[1:], start=1):
        size = np.abs(matrix).max()
        if size > 0.0:
            mixture += matrix * (np.sqrt(q + 1.0) / size)
    values, modes = la.eigh(mixture, mass)
    modes = canonical(values, modes, mass, _EQUAL * float(np.abs(values).max()))
    names = ["mass", "damping", "stiffness", "the identity link weight"]
    names += [f"link weight {w}" for w in range(1, len(dense) - WEIGHTS + 1)]
    diagonals: list[sp.csr_array] = []
    for name, matrix in zip(names, dense, strict=False):
        turned = modes.T @ matrix @ modes
        own = np.diag(turned)
        if np.abs(turned - np.diag(own)).max() > _COMMUTES * max(np.abs(own).max(), 1e-300):
            return f"{name} is not diagonal in the basis that diagonalises the others"
        # What is left below zero is round-off; a negative damping or stiffness would feed energy.
        diagonals.append(sp.csr_array(sp.diags_array(np.maximum(own, 0.0))))
    operator = operator_of(diagonals, copies, 0)
    assert not mixed(operator, STIFFNESS)
    return Model(
        body=body,
        operator=operator,
        modes=np.ascontiguousarray(modes),
        inverse=np.ascontiguousarray(modes.T @ mass),
        order=None,
    )


def _truncated(body: Body, truncation: Truncation, copies: int) -> Model:
    """The model in the shapes of a truncation, where M = I, K and B are diagonal.

    Everything is projected on the shapes, links too, so what is passive stays passive. Weight 0 is `M / m̄` here: the
    identity where all nodes weigh the same, and diagonal in any case.
    """
    shapes = truncation.shapes
    mean = float(body.mass.sum()) / body.mass.shape[0]
    rows = [
        np.ones(shapes.shape[1]),
        np.maximum(np.einsum("ij,ij->j", shapes, np.asarray(body.damping @ shapes)), 0.0),
        truncation.stiffness,
        np.full(shapes.shape[1], 1.0 / mean),
    ]
    operator = operator_of([sp.csr_array(sp.diags_array(row)) for row in rows], copies, 0)
    return Model(
        body=body,
        operator=operator,
        modes=np.ascontiguousarray(shapes),
        inverse=np.ascontiguousarray(np.asarray(body.mass @ shapes).T),
        order=None,
    )
