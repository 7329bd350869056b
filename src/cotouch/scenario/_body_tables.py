"""The tables of a body: a point, a grid, matrices, or a mesh in a file."""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal, Self, cast, final, get_args

from pydantic import (
    Discriminator,
    Field,
    FiniteFloat,
    InstanceOf,
    Tag,
    model_validator,
)

from cotouch.body import (
    MOST_ELEMENTS,
    MOST_NODES,
    MOST_TRIANGLES,
    Body,
    Frame,
    GridModel,
    Held,
    NodeNumbers,
    NodeSet,
    NodesInBox,
    NodesNearPlane,
    SurfaceModel,
    body_from_surface,
    body_from_tetrahedra,
    chain,
    is_solid_model,
    lattice,
    point,
    rigid_box,
    rigid_cylinder,
    rigid_sphere,
    solid_models,
)
from cotouch.meshfile import SURFACES, VOLUMES, is_surface
from cotouch.scenario._tables import NonNegative, Number, Place, Positive, Table


@final
class PointTable(Table):
    """One node: mass [kg], damping [Ns/m] and stiffness [N/m] to the ground, rest place (a number or 1 to 3) [m]."""

    kind: Literal["point"] = "point"
    mass: Positive = 1.0
    damping: NonNegative = 0.0
    stiffness: NonNegative = 0.0
    rest: FiniteFloat | list[FiniteFloat] = 0.0

    def build(self) -> Body:
        """The body."""
        return point(mass=self.mass, damping=self.damping, stiffness=self.stiffness, rest=self.rest)


class _GridTable(Table):
    mass: Positive = 1.0
    stiffness: NonNegative = 100.0
    damping: NonNegative = 0.0
    spacing: Positive = 0.01
    ground: str | list[Number] = "none"
    ground_stiffness: NonNegative = 0.0
    ground_damping: NonNegative = 0.0
    model: GridModel = "springs"
    frame: Frame = "fixed"
    most_nodes: Number = MOST_NODES

    def _common(self) -> dict[str, Any]:
        held = self.ground if isinstance(self.ground, str) else NodeNumbers(self.ground)
        return {**self.model_dump(include=set(_GridTable.model_fields)), "ground": held}


@final
class ChainTable(_GridTable):
    """Nodes along x; see `cotouch.body.chain`. `ground` lists node numbers from 1, or names all or a face."""

    kind: Literal["chain"]
    nodes: Number
    dimension: Annotated[int, Field(ge=1, le=3)] = 1

    def build(self) -> Body:
        """The body."""
        return chain(self.nodes, dimension=self.dimension, **self._common())


@final
class LatticeTable(_GridTable):
    """A box of nodes; see `cotouch.body.lattice`. `ground` lists node numbers from 1, or names all or a face."""

    kind: Literal["lattice"]
    shape: list[Number]
    neighbours: Literal[6, 18, 26] = 6

    def build(self) -> Body:
        """The body."""
        return lattice(self.shape, neighbours=self.neighbours, **self._common())


class _HeavyTable(Table):
    """What weighs `density` [kg/m³] times its volume, 1000 by default, or instead `mass` [kg]."""

    density: Positive | None = None
    mass: Positive | None = None

    @model_validator(mode="after")
    def _either(self) -> Self:
        if self.density is not None and self.mass is not None:
            raise ValueError("density and mass are given; give only one of them")
        return self


class _ShapeTable(_HeavyTable):
    centre: Place = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    rate: Annotated[Positive, Field(le=1e7)] | None = None
    model: Literal["rigid"] = "rigid"

    def _options(self) -> dict[str, Any]:
        return self.model_dump(exclude={"kind", "model"}, exclude_none=True)


@final
class RigidBoxTable(_ShapeTable):
    """A rigid box; see `cotouch.body.rigid_box`."""

    kind: Literal["box"]
    size: Annotated[list[Positive], Field(min_length=3, max_length=3)]
    turn: Place = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    resolution: Number = 4

    def build(self) -> Body:
        """The body."""
        return rigid_box(**self._options())


@final
class RigidCylinderTable(_ShapeTable):
    """A rigid cylinder, along z before it is turned; see `cotouch.body.rigid_cylinder`."""

    kind: Literal["cylinder"]
    radius: Positive
    length: Positive
    turn: Place = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    resolution: Number = 8

    def build(self) -> Body:
        """The body."""
        return rigid_cylinder(**self._options())


@final
class RigidSphereTable(_ShapeTable):
    """A rigid ball; see `cotouch.body.rigid_sphere`."""

    kind: Literal["sphere"]
    radius: Positive
    resolution: Number = 8

    def build(self) -> Body:
        """The body."""
        return rigid_sphere(**self._options())


@final
class MatrixTable(Table):
    """Any small body, written out: M, B_int, B_ext, K_int, K_ext and the rest shape."""

    kind: Literal["matrices"]
    mass: list[list[FiniteFloat]]
    rest: list[FiniteFloat] | list[list[FiniteFloat]]
    damping_int: list[list[FiniteFloat]] | None = None
    damping_ext: list[list[FiniteFloat]] | None = None
    stiffness_int: list[list[FiniteFloat]] | None = None
    stiffness_ext: list[list[FiniteFloat]] | None = None

    def build(self) -> Body:
        """The body."""
        return Body(**self.model_dump(exclude={"kind"}))


@final
class NodesNearPlaneTable(Table):
    """The nodes within `thickness` [m] of the plane through `point` [m] across `normal`."""

    point: Place
    normal: Place
    thickness: NonNegative | None = None


@final
class NodesInBoxTable(Table):
    """The nodes in a box along the axes, from `low` to `high` [m]."""

    low: Place
    high: Place


@final
class GroundTable(Table):
    """Where the ground holds: one of a plane, a box, and a set of nodes or physical group that the file names."""

    plane: NodesNearPlaneTable | None = None
    box: NodesInBoxTable | None = None
    set: str | None = None

    @model_validator(mode="after")
    def _one(self) -> Self:
        if sum(given is not None for given in (self.plane, self.box, self.set)) != 1:
            raise ValueError("it must have exactly one of plane, box and set")
        return self

    def held(self) -> Held:
        """As a builder wants it."""
        if self.plane is not None:
            return NodesNearPlane(point=self.plane.point, normal=self.plane.normal, thickness=self.plane.thickness)
        if self.box is not None:
            return NodesInBox(low=self.box.low, high=self.box.high)
        assert self.set is not None
        return NodeSet(name=self.set)


def _ground_form(value: object) -> str:
    return (
        "place()" if isinstance(value, Mapping | GroundTable) else "numbers()" if isinstance(value, list) else "face()"
    )


GroundSource = Annotated[
    Annotated[str, Tag("face()")] | Annotated[list[Number], Tag("numbers()")] | Annotated[GroundTable, Tag("place()")],
    Discriminator(_ground_form),
]

# Options of one sort of file only.
_OF_SURFACES = ("resolution", "most_triangles")
_OF_VOLUMES = ("most_elements", "parts")
# What has modes.
_LINEAR = (None, "springs", "elastic")
# And of what is not rigid.
_OF_SOFT = ("young", "poisson", "stiffness", "rayleigh_mass", "rayleigh_stiffness", "frame", "ground", "modes")


@final
class FileTable(_HeavyTable):
    """A body from a mesh; see `cotouch.body_from_surface` and `cotouch.body_from_tetrahedra`.

    Attributes:
        file: STL, OBJ, PLY, OFF, GLB (surfaces), VTK, VTU, Gmsh .msh, MEDIT .mesh (tetrahedra); relative to the
            scenario.
        unit: of the file: "m", "mm", "cm", "in"; only GLB has one by itself.
        resolution: surfaces: cells of the lattice along the longest side.
        model: "springs" (default of surfaces), "elastic" (default of tetrahedra), "spring-network"; of surfaces
            "cells"; of tetrahedra "corotated", "st-venant-kirchhoff", "neo-hookean"; "rigid", which needs no more.
        frame: of "springs" and "elastic": "floating" (the default, but with modes): it turns as a whole without a
            force; or "fixed".
        young: [Pa].
        poisson: Poisson's ratio.
        stiffness: of each spring, instead of what Young's modulus gives [N/m].
        density: by default 1000 [kg/m³].
        mass: of the whole body, instead of density times volume [kg].
        rayleigh_mass: α of the damping α M + β K [1/s].
        rayleigh_stiffness: β [s].
        ground: "none", "all", a face such as "z-", {plane = ...}, {box = ...}, {set = ...}, or node numbers from 1.
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
        part: which of several separate parts, the biggest is 1.
        parts: of tetrahedra, by the name of a set of the file: young, poisson, rayleigh_stiffness of what is in it.
        modes: confine the body to so many of its lowest modes and to how it yields at the nodes that hands hold.
        most_triangles: refuse files with more.
        most_elements: refuse files with more.
        most_nodes: refuse bodies with more.
    """

    kind: Literal["file"] = "file"
    file: str
    unit: Literal["m", "mm", "cm", "in"] | None = None
    resolution: Annotated[int, Field(ge=1)] = 12
    model: str | None = None
    frame: Frame | None = None
    young: Positive = 1e4
    poisson: Annotated[float, Field(gt=-1.0, lt=0.5)] = 0.3
    stiffness: Positive | None = None
    rayleigh_mass: NonNegative = 0.0
    rayleigh_stiffness: NonNegative = 0.0
    ground: GroundSource = "none"
    ground_stiffness: NonNegative = 0.0
    ground_damping: NonNegative = 0.0
    part: Annotated[int, Field(ge=1)] | None = None
    parts: dict[str, dict[str, FiniteFloat]] | None = None
    modes: Annotated[int, Field(ge=1)] | None = None
    most_triangles: Annotated[int, Field(ge=1)] = MOST_TRIANGLES
    most_elements: Annotated[int, Field(ge=1)] = MOST_ELEMENTS
    most_nodes: Number = MOST_NODES

    @model_validator(mode="after")
    def _fits(self) -> Self:
        suffix = Path(self.file).suffix.lower()
        if suffix not in SURFACES + VOLUMES:
            raise ValueError(
                f'file is "{self.file}"; it must end in {", ".join(SURFACES)} (surfaces) or {", ".join(VOLUMES)} '
                "(tetrahedra)"
            )
        others, what = (_OF_VOLUMES, "tetrahedra") if is_surface(Path(self.file)) else (_OF_SURFACES, "surfaces")
        if self.model is not None:
            self._known_model(self.model)
        if self.modes is not None and self.frame == "floating":
            raise ValueError(f'modes is {self.modes}, but frame is "floating", which has none; leave one of them out')
        if self.model == "rigid":
            for name in _OF_SOFT:
                if getattr(self, name) != type(self).model_fields[name].default:
                    raise ValueError(f'{name} is {getattr(self, name)}, but model is "rigid"; leave it out')
        for name in others:
            if name in self.model_fields_set:
                raise ValueError(f'{name} is for {what}, but file is "{self.file}"; leave it out')
        return self

    def _known_model(self, model: str) -> None:
        surface = is_surface(Path(self.file))
        if not (model in get_args(SurfaceModel) if surface else is_solid_model(model)):
            names = ", ".join(f'"{name}"' for name in (get_args(SurfaceModel) if surface else solid_models()))
            what = "surfaces" if surface else "tetrahedra"
            raise ValueError(f'model is "{model}", but file is "{self.file}"; {what} take {names}')

    @classmethod
    def make(cls, *, source: str, **options: object) -> "FileTable":
        """Makes a table; errors are one sentence each.

        Args:
            source: what a message calls it.
            **options: of the table, by name.

        Raises:
            ScenarioError: an option is wrong.
        """
        from cotouch.scenario._messages import refusing

        with refusing(source):
            return cls.model_validate(options)

    def build(self) -> Body:
        """The body, with all its modes."""
        options = self.model_dump(exclude={"kind", "file", "modes", "model", *_OF_SURFACES, *_OF_VOLUMES})
        if self.density is None:
            del options["density"]
        if self.modes is not None and self.model in _LINEAR:
            options["frame"] = self.frame or "fixed"
        if isinstance(self.ground, GroundTable):
            options["ground"] = self.ground.held()
        elif isinstance(self.ground, list):
            options["ground"] = NodeNumbers(self.ground)
        if is_surface(Path(self.file)):
            return body_from_surface(
                self.file,
                model=cast("SurfaceModel", self.model or "springs"),
                resolution=self.resolution,
                most_triangles=self.most_triangles,
                **options,
            )
        return body_from_tetrahedra(
            self.file,
            model=self.model or "elastic",
            most_elements=self.most_elements,
            parts=self.parts,
            **options,
        )


def _kind(value: object) -> str | None:
    """Which sort of body is given."""
    if isinstance(value, Body):
        return "body"
    if isinstance(value, Mapping):
        table = cast("Mapping[str, object]", value)
        kind = table.get("kind", "file" if "file" in table else "point")
    else:
        kind = getattr(value, "kind", None)
    return kind if isinstance(kind, str) else None


# Which kinds a file may name.
KINDS = ("point", "chain", "lattice", "box", "cylinder", "sphere", "matrices", "file")

BodySource = Annotated[
    Annotated[InstanceOf[Body], Tag("body")]
    | Annotated[PointTable, Tag("point")]
    | Annotated[ChainTable, Tag("chain")]
    | Annotated[LatticeTable, Tag("lattice")]
    | Annotated[RigidBoxTable, Tag("box")]
    | Annotated[RigidCylinderTable, Tag("cylinder")]
    | Annotated[RigidSphereTable, Tag("sphere")]
    | Annotated[MatrixTable, Tag("matrices")]
    | Annotated[FileTable, Tag("file")],
    Discriminator(_kind),
]
