"""The shared object: masses, dampers and springs between its nodes and to the ground, and its shape at rest."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import inf
from typing import final

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Float
from cotouch.body._body_checks import check_mass, check_rates, rest_shape
from cotouch.body._checks import Form, Matrix, SumOfSquares, diagonal, plausible, positive, square
from cotouch.body._material import Material, cuttable_models
from cotouch.body._origin import Origin
from cotouch.body._part import Part, cuttable_parts, held_shares, held_vertices
from cotouch.body._skin import Skin
from cotouch.body._strains import shares_of
from cotouch.body._truncation import Truncation, missing_at, truncate
from cotouch.errors import BodyError, UnsupportedError

# Rigid bodies are solved for at once up to so many nodes, four each; beyond that one by one is quicker.
_MOST_RIGID = 48


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class Body:
    """A linear deformable object of n nodes in d dimensions: `M a + B v + K (x - x_d) = f` [Lee & Huang 2010, eq. 1-2].

    Every matrix is either n x n ("node" form: the same scalar weight on every axis, `K = K_n ⊗ I_d`) or nd x nd
    ("full" form, rows ordered node by node: x0, y0, z0, x1, ...). Both forms may be mixed; then all become full.

    Args:
        mass: M, symmetric positive definite [kg].
        rest: x_d, the shape at rest, (n, d) or (n,) for one dimension [m].
        damping_int: dampers between nodes, symmetric positive semidefinite [Ns/m]. None: none.
        damping_ext: dampers to the ground, diagonal, >= 0 [Ns/m]. None: none.
        stiffness_int: springs between nodes, symmetric positive semidefinite [N/m]. None: none.
        stiffness_ext: springs to the ground, diagonal, >= 0 [N/m]. None: none.
        skin: a surface that the nodes carry, in three dimensions. None: contact happens at nodes.
        origin: what a builder read and understood.
        truncation: shapes that the motion is confined to; see `truncated`.
        material: what its inner forces follow instead of K and B, of which these are then what they are like at rest.
        parts: what it was put together of; see `cotouch.body.together`.
        places: points of a rigid body that can be held besides its nodes and its skin's vertices, (P, 3) [m].

    Raises:
        BodyError: a matrix is not finite, symmetric, definite or of the right size; a node has too little mass; the
            rest shape is not (n, d) with d from 1 to 3; the skin hangs on nodes that there are not.

    Examples:
        >>> body = Body(mass=[[2.0, 0.0], [0.0, 2.0]], rest=[0.0, 1.0], stiffness_int=[[5.0, -5.0], [-5.0, 5.0]])
        >>> body.nodes, body.dimension, body.form
        (2, 1, 'node')
    """

    mass: sp.csr_array
    rest: Float
    damping_int: sp.csr_array
    damping_ext: sp.csr_array
    stiffness_int: sp.csr_array
    stiffness_ext: sp.csr_array
    skin: Skin | None
    origin: Origin | None
    truncation: Truncation | None
    material: Material | None
    parts: tuple[Part, ...]
    places: Float
    form: Form = field(init=False)

    def __init__(
        self,
        *,
        mass: Matrix,
        rest: npt.ArrayLike,
        damping_int: Matrix | SumOfSquares | None = None,
        damping_ext: Matrix | None = None,
        stiffness_int: Matrix | SumOfSquares | None = None,
        stiffness_ext: Matrix | None = None,
        skin: Skin | None = None,
        origin: Origin | None = None,
        truncation: Truncation | None = None,
        material: Material | None = None,
        parts: tuple[Part, ...] = (),
        places: npt.ArrayLike = (),
    ) -> None:
        shape = rest_shape(rest)
        nodes, dimension = shape.shape
        sizes: dict[int, Form] = {nodes * dimension: "full", nodes: "node"}
        given: dict[str, Matrix | SumOfSquares | None] = {
            "mass": mass,
            "damping_int": damping_int,
            "damping_ext": damping_ext,
            "stiffness_int": stiffness_int,
            "stiffness_ext": stiffness_ext,
        }
        known = {name for name, matrix in given.items() if isinstance(matrix, SumOfSquares)}
        matrices = {
            name: square(name, matrix.matrix if isinstance(matrix, SumOfSquares) else matrix, sizes=sizes)
            for name, matrix in given.items()
            if matrix is not None
        }
        full = any(matrix.shape[0] != nodes for matrix in matrices.values())
        rows = nodes * dimension if full else nodes
        for name, matrix in matrices.items():
            if full and matrix.shape[0] == nodes:
                matrices[name] = sp.csr_array(sp.kron(matrix, sp.eye_array(dimension)))
        check_mass(matrices["mass"], dimension if full else 1)
        for name, matrix in matrices.items():
            if name in known:
                plausible(name, matrix)
            elif name.endswith("_int"):
                positive(name, matrix, strictly=False)
            elif name.endswith("_ext"):
                diagonal(name, matrix)
        for name, value in {
            **{name: matrices.get(name, sp.csr_array((rows, rows), dtype=np.float64)) for name in given},
            "rest": shape,
            "form": "full" if full else "node",
            "skin": skin,
            "origin": origin,
            "truncation": truncation,
            "material": material,
            "parts": parts,
        }.items():
            object.__setattr__(self, name, value)
        check_rates(self.mass, self.stiffness_int, self.damping_int, dimension if full else 1)
        if skin is not None:
            if dimension != 3:
                raise BodyError(f"the body has {dimension} axes; a skin needs 3")
            skin.check(nodes)
        if material is not None:
            material.check(shape)
            if (material.model == "several") != bool(parts):
                raise BodyError(f'model is "{material.model}" of a body of {len(parts)} parts; use `together` instead')
        more = np.array(places, dtype=np.float64).reshape(-1, 3)
        if more.size and not (self.rigid and np.isfinite(more).all()):
            raise BodyError("only rigid bodies have places that are not nodes, which must be finite; leave them out")
        object.__setattr__(self, "places", more)

    @property
    def nodes(self) -> int:
        """Number of nodes n."""
        return self.rest.shape[0]

    @property
    def dimension(self) -> int:
        """Number of axes d, 1 to 3."""
        return self.rest.shape[1]

    @property
    def rigid(self) -> bool:
        """Whether its nodes keep their distances; of several bodies, whether those of each do, and they are few."""
        if self.parts:
            return self.nodes <= _MOST_RIGID and all(part.body.rigid for part in self.parts)
        return self.material is not None and self.material.model == "rigid"

    @property
    def cut_count(self) -> int:
        """How many elements, or faces, can be cut, of several bodies those of all in turn; 0: it cannot be cut."""
        if self.parts:
            return sum(part.body.cut_count for part in self.parts)
        made = self.material
        return 0 if made is None or not made.cuttable else made.faces.shape[0] or made.elements.shape[0]

    @property
    def tools(self) -> tuple[Part, ...]:
        """Those of its parts that are tools, the last ones."""
        return tuple(part for part in self.parts if part.tool is not None)

    @property
    def shared(self) -> int:
        """Number of nodes that are no tool's; they come first."""
        return self.tools[0].first if self.tools else self.nodes

    @property
    def holds(self) -> int:
        """How many points of it hands can hold."""
        return self.held_rest.shape[0]

    @cached_property
    def held_rest(self) -> Float:
        """What hands can hold at rest: nodes, and of a rigid body its skin's vertices and `places`, (H, d) [m]."""
        if not self.rigid:
            return self.rest[: self.shared]
        return np.concatenate([self.rest[: self.shared], held_vertices(self.parts, self.skin), self.places])

    @cached_property
    def held_shares(self) -> Float | None:
        """How much of each node what hands can hold follows, (H, n); None where that is the nodes themselves."""
        if self.parts and self.rigid:
            return held_shares(self.parts, self.held_rest, self.nodes)
        return shares_of(self.rest, self.held_rest) if self.rigid else None

    def held_by(self, number: int) -> npt.NDArray[np.intp]:
        """Which of what hands can hold is of one of several bodies; its nodes come first.

        Args:
            number: of the body, from 0.
        """
        part, shares = self.parts[number], self.held_shares
        if shares is None:
            return np.arange(part.first, part.last)
        return np.flatnonzero(np.abs(shares[:, part.first : part.last]).sum(axis=1) > 0.0)

    @cached_property
    def linearised(self) -> "Body":
        """The linear body that it is like at rest, without weight."""
        return self if self.material is None else self._made_of(None, ())

    def with_places(self, places: npt.ArrayLike) -> "Body":
        """The same rigid body with more points that can be held.

        Args:
            places: at rest, (P, 3) [m].

        Raises:
            BodyError: the body is not rigid, or a number not finite.
        """
        return self._made_of(self.material, places)

    @cached_property
    def damping(self) -> sp.csr_array:
        """B = B_int + B_ext in the body's form [Ns/m]."""
        return _sum(self.damping_int, self.damping_ext)

    @cached_property
    def stiffness(self) -> sp.csr_array:
        """K = K_int + K_ext in the body's form [N/m]."""
        return _sum(self.stiffness_int, self.stiffness_ext)

    def as_full(self) -> "Body":
        """The same body with every matrix nd x nd."""
        if self.form == "full":
            return self
        identity = sp.eye_array(self.dimension)

        def wide(matrix: sp.csr_array) -> sp.csr_array:
            return sp.csr_array(sp.kron(matrix, identity))

        return Body(
            mass=wide(self.mass),
            rest=self.rest,
            damping_int=SumOfSquares(wide(self.damping_int)),  # checked in the node form
            damping_ext=wide(self.damping_ext),
            stiffness_int=SumOfSquares(wide(self.stiffness_int)),
            stiffness_ext=wide(self.stiffness_ext),
            skin=self.skin,
            origin=self.origin,
            truncation=None if self.truncation is None else self.truncation.as_full(self.dimension),
            material=self.material,
            parts=self.parts,
        )

    def with_gravity(self, gravity: tuple[float, float, float]) -> "Body":
        """The same body with weight.

        Args:
            gravity: acceleration, (3,) [m/s²].

        Raises:
            BodyError: gravity is not three finite numbers.
            UnsupportedError: the body is truncated.
        """
        if self.truncation is not None:
            raise UnsupportedError("the body is truncated to a few modes, so it cannot have weight; leave one out")
        return self._made_of(replace(self.material or Material(model="linear"), gravity=gravity))

    def with_cutting(self, tear: float = inf, *, strength: float = inf, toughness: float = 0.0) -> "Body":
        """The same body, whose elements can be cut; of several bodies those of cubes and tetrahedra can.

        Args:
            tear: strain at which an element breaks by itself, > 0; by default none does.
            strength: tensile stress at which it does, > 0 [Pa]; by default none; see `Material`.
            toughness: what a blade pays for new area, >= 0 [J/m²].

        Raises:
            BodyError: the body's model has no elements, it has fewer than three axes, or a value is out of its range.
        """
        if self.parts:
            made = cuttable_parts(self.parts, tear=tear, strength=strength, toughness=toughness)
            return self._made_of(self.material, parts=made)
        if self.material is None:
            raise BodyError(
                "cutting takes away elements, but the body is linear and has none; take one of the models "
                f'"spring-network", {cuttable_models()}'
            )
        if self.dimension != 3:
            raise BodyError(f"cutting needs a body of 3 axes, but this one has {self.dimension}")
        return self._made_of(replace(self.material, cuttable=True, tear=tear, strength=strength, toughness=toughness))

    def _made_of(
        self,
        material: Material | None,
        places: npt.ArrayLike | None = None,
        parts: tuple[Part, ...] | None = None,
        truncation: Truncation | None = None,
    ) -> "Body":
        own = self.parts if parts is None else parts
        return Body(
            mass=self.mass,
            rest=self.rest,
            damping_int=SumOfSquares(self.damping_int),
            damping_ext=self.damping_ext,
            stiffness_int=SumOfSquares(self.stiffness_int),
            stiffness_ext=self.stiffness_ext,
            skin=self.skin,
            origin=self.origin,
            truncation=truncation,
            material=material,
            parts=() if material is None else own,  # what is linear is one body
            places=self.places if places is None else places,
        )

    def truncated(self, *, modes: int, contacts: Sequence[int] = ()) -> "Body":
        """The same body, confined to its lowest modes and to how it yields where it is touched.

        The modes alone make a body too stiff under a fingertip, because a force at one point bends mostly what the
        modes left out. For every contact node its static residual is kept as a shape of its own, which makes the body's
        static compliance among the contacts exact [MacNeal 1971; Rubin 1975].

        A body from a mesh, which turns by default, does so no more: modes are linear.

        The result has the same nodes and matrices; a simulator works in the shapes, `body.truncation`, where mass,
        stiffness and Rayleigh damping are diagonal. A link between two copies then pulls with the weight `M / m̄`
        instead of the identity (m̄: mean mass of a node), the one that is diagonal there too.

        Args:
            modes: r, how many of the lowest modes, rigid motions included.
            contacts: indices of nodes whose local compliance stays exact.

        Raises:
            BodyError: fewer modes than the body's free motions or more than it has; a contact it does not have.
            UnsupportedError: damping that the modes do not make diagonal; a material, which has no modes.
        """
        # A mesh's body turns unless it is told not to; that is no wish against modes.
        unasked = self.origin is not None and self.material is not None and self.material.model == "floating"
        if self.material is not None and not (unasked and not any(self.material.gravity)):
            if self.material.model == "linear" or unasked:
                raise UnsupportedError(
                    f"modes is {modes}, but the body has weight or meets obstacles, for which it takes closed steps, "
                    "without modes: leave one out"
                )
            raise UnsupportedError(
                f'modes is {modes}, but model is "{self.material.model}"; only a linear body has modes: leave one out'
            )
        shapes = truncate(self.mass, self.damping, self.stiffness, self.rest, modes=modes, contacts=contacts)
        return self._made_of(None, (), truncation=shapes)

    def missing_compliance(self, vertices: Sequence[int]) -> Float:
        """What a truncated body lacks in static compliance among vertices of its skin [m/N].

        In the whole body a static force f at these vertices moves them by `missing @ f` more than in the truncated one.
        A contact that puts this compliance in series with its own spring feels the right stiffness anywhere on the
        skin, not only at the contacts that the truncation kept.

        Args:
            vertices: indices of skin vertices.

        Returns:
            Symmetric and positive semidefinite, up to rounding: (3m, 3m) in the full form, ordered vertex by vertex;
            (m, m), the same along every axis, in the node form.

        Raises:
            BodyError: the body is not truncated, has no skin, or not such a vertex.
        """
        if self.truncation is None or self.skin is None:
            raise BodyError(f"the body has no {'skin' if self.skin is None else 'truncation'}; it needs both")
        chosen = np.asarray(vertices, dtype=np.intp).reshape(-1)
        count = self.skin.vertices.shape[0]
        if chosen.size and not (chosen.min() >= 0 and chosen.max() < count):
            wrong = int(chosen.min() if chosen.min() < 0 else chosen.max())
            raise BodyError(f"vertices names {wrong}; the skin has vertices 0 to {count - 1}")
        readings = self.skin.interpolation(self.nodes)[chosen]
        if self.form == "full":
            readings = sp.csr_array(sp.kron(readings, sp.eye_array(self.dimension)))
        return missing_at(readings, self.truncation, self.mass, self.stiffness, self.rest)

    def apply(self, matrix: sp.csr_array, field_: npt.ArrayLike) -> Float:
        """`matrix @ field` for one of the body's own matrices and a field of shape (..., n, d).

        Args:
            matrix: sparse, square.
            field_: (..., n, d).
        """
        values = np.asarray(field_, dtype=np.float64)
        if self.form == "full":
            flat = values.reshape(-1, self.nodes * self.dimension)
            return np.asarray(matrix @ flat.T).T.reshape(values.shape)
        moved = np.moveaxis(values, -2, 0)
        return np.moveaxis(np.asarray(matrix @ moved.reshape(self.nodes, -1)).reshape(moved.shape), 0, -2)


def _sum(internal: sp.csr_array, external: sp.csr_array) -> sp.csr_array:
    if not internal.nnz or not external.nnz:
        return internal if internal.nnz else external
    return sp.csr_array(internal + external)
