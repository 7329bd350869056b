"""The tables of a scenario: every option, its range, and what it means."""

from collections.abc import Mapping
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal, Self, final

from pydantic import (
    BaseModel,
    ConfigDict,
    Discriminator,
    Field,
    FiniteFloat,
    InstanceOf,
    Tag,
    ValidationError,
    model_validator,
)
from pydantic import NonNegativeFloat as _NonNegativeFloat

from cotouch.body import (
    MOST_ELEMENTS,
    MOST_NODES,
    MOST_TRIANGLES,
    SURFACES,
    VOLUMES,
    Body,
    Box,
    Held,
    NodeSet,
    Plane,
    body_from_surface,
    body_from_tetrahedra,
    chain,
    lattice,
    point,
)
from cotouch.errors import ScenarioError

Positive = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]
NonNegative = Annotated[_NonNegativeFloat, Field(allow_inf_nan=False)]
Probability = Annotated[float, Field(ge=0.0, le=1.0, allow_inf_nan=False)]
Number = int  # users, nodes: from 1 in files
Mode = Literal["constant", "self-paced", "freshest"]
DampingMethod = Literal["rule", "minimax", "exact"]


class Table(BaseModel):
    """A table of a scenario: nothing unknown in it, nothing changed after reading."""

    model_config = ConfigDict(extra="forbid", frozen=True, arbitrary_types_allowed=True, str_strip_whitespace=True)


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

    def _common(self) -> dict[str, Any]:
        held = self.ground if isinstance(self.ground, str) else [number - 1 for number in self.ground]
        return {**self.model_dump(include=set(_GridTable.model_fields)), "ground": held}


@final
class ChainTable(_GridTable):
    """Nodes along x; see `cotouch.body.chain`. `ground` lists node numbers from 1, or names all or a face."""

    kind: Literal["chain"]
    nodes: Annotated[int, Field(ge=1)]
    dimension: Annotated[int, Field(ge=1, le=3)] = 1

    def build(self) -> Body:
        """The body."""
        return chain(self.nodes, dimension=self.dimension, **self._common())


@final
class LatticeTable(_GridTable):
    """A box of nodes; see `cotouch.body.lattice`. `ground` lists node numbers from 1, or names all or a face."""

    kind: Literal["lattice"]
    shape: list[Annotated[int, Field(ge=1)]]
    neighbours: Literal[6, 18, 26] = 6

    def build(self) -> Body:
        """The body."""
        return lattice(self.shape, neighbours=self.neighbours, **self._common())


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


Place = Annotated[list[FiniteFloat], Field(min_length=3, max_length=3)]


@final
class PlaneTable(Table):
    """The nodes within `thickness` [m] of the plane through `point` [m] across `normal`."""

    point: Place
    normal: Place
    thickness: NonNegative | None = None


@final
class BoxTable(Table):
    """The nodes in a box along the axes, from `low` to `high` [m]."""

    low: Place
    high: Place


@final
class GroundTable(Table):
    """Where the ground holds: one of a plane, a box, and a set of nodes or physical group that the file names."""

    plane: PlaneTable | None = None
    box: BoxTable | None = None
    set: str | None = None

    @model_validator(mode="after")
    def _one(self) -> Self:
        if sum(given is not None for given in (self.plane, self.box, self.set)) != 1:
            raise ValueError("it must have exactly one of plane, box and set")
        return self

    def held(self) -> Held:
        """As a builder wants it."""
        if self.plane is not None:
            return Plane(point=self.plane.point, normal=self.plane.normal, thickness=self.plane.thickness)
        if self.box is not None:
            return Box(low=self.box.low, high=self.box.high)
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
_OF_VOLUMES = ("most_elements",)


@final
class FileTable(Table):
    """A body from a mesh; see `cotouch.body_from_surface` and `cotouch.body_from_tetrahedra`.

    Attributes:
        file: STL, OBJ, PLY, OFF, GLB (surfaces), VTK, VTU, Gmsh .msh, MEDIT .mesh (tetrahedra); relative to the
            scenario.
        unit: of the file: "m", "mm", "cm", "in"; only GLB has one by itself.
        resolution: surfaces: cells of the lattice along the longest side.
        model: "springs" (default of surfaces) or "elastic" (default of tetrahedra).
        young: [Pa].
        poisson: Poisson's ratio.
        stiffness: of each spring, instead of what Young's modulus gives [N/m].
        density: [kg/m³].
        mass: of the whole body, instead of density times volume [kg].
        rayleigh_mass: α of the damping α M + β K [1/s].
        rayleigh_stiffness: β [s].
        ground: "none", "all", a face such as "z-", {plane = ...}, {box = ...}, {set = ...}, or node numbers from 1.
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
        part: which of several separate parts, the biggest is 1.
        modes: confine the body to so many of its lowest modes and to how it yields at the nodes that hands hold.
        most_triangles: refuse files with more.
        most_elements: refuse files with more.
        most_nodes: refuse bodies with more.
    """

    kind: Literal["file"] = "file"
    file: str
    unit: Literal["m", "mm", "cm", "in"] | None = None
    resolution: Annotated[int, Field(ge=1)] = 12
    model: Literal["springs", "elastic"] | None = None
    young: Positive = 1e4
    poisson: Annotated[float, Field(gt=-1.0, lt=0.5)] = 0.3
    stiffness: Positive | None = None
    density: Positive = 1000.0
    mass: Positive | None = None
    rayleigh_mass: NonNegative = 0.0
    rayleigh_stiffness: NonNegative = 0.0
    ground: GroundSource = "none"
    ground_stiffness: NonNegative = 0.0
    ground_damping: NonNegative = 0.0
    part: Annotated[int, Field(ge=1)] | None = None
    modes: Annotated[int, Field(ge=1)] | None = None
    most_triangles: Annotated[int, Field(ge=1)] = MOST_TRIANGLES
    most_elements: Annotated[int, Field(ge=1)] = MOST_ELEMENTS
    most_nodes: Annotated[int, Field(ge=1)] = MOST_NODES

    @model_validator(mode="after")
    def _fits(self) -> Self:
        suffix = Path(self.file).suffix.lower()
        if suffix not in SURFACES + VOLUMES:
            raise ValueError(
                f'file is "{self.file}"; it must end in {", ".join(SURFACES)} (surfaces) or {", ".join(VOLUMES)} '
                "(tetrahedra)"
            )
        others, what = (_OF_VOLUMES, "tetrahedra") if suffix in SURFACES else (_OF_SURFACES, "surfaces")
        for name in others:
            if name in self.model_fields_set:
                raise ValueError(f'{name} is for {what}, but file is "{self.file}"; leave it out')
        return self

    @classmethod
    def make(cls, *, source: str, **options: Any) -> "FileTable":
        """Makes a table; errors are one sentence each.

        Raises:
            ScenarioError: an option is wrong.
        """
        from cotouch.scenario._messages import sentence

        try:
            return cls(**options)
        except ValidationError as error:
            raise ScenarioError(sentence(error, source)) from None

    def build(self) -> Body:
        """The body, with all its modes."""
        options = self.model_dump(exclude={"kind", "file", "modes", "model", *_OF_SURFACES, *_OF_VOLUMES})
        if isinstance(self.ground, GroundTable):
            options["ground"] = self.ground.held()
        elif isinstance(self.ground, list):
            options["ground"] = [number - 1 for number in self.ground]
        if Path(self.file).suffix.lower() in SURFACES:
            return body_from_surface(
                self.file,
                model=self.model or "springs",
                resolution=self.resolution,
                most_triangles=self.most_triangles,
                **options,
            )
        return body_from_tetrahedra(
            self.file, model=self.model or "elastic", most_elements=self.most_elements, **options
        )


def _kind(value: object) -> str | None:
    """Which sort of body is given."""
    if isinstance(value, Body):
        return "body"
    usual = "file" if isinstance(value, Mapping) and "file" in value else "point"
    kind = value.get("kind", usual) if isinstance(value, Mapping) else getattr(value, "kind", None)
    return kind if isinstance(kind, str) else None


BodySource = Annotated[
    Annotated[InstanceOf[Body], Tag("body")]
    | Annotated[PointTable, Tag("point")]
    | Annotated[ChainTable, Tag("chain")]
    | Annotated[LatticeTable, Tag("lattice")]
    | Annotated[MatrixTable, Tag("matrices")]
    | Annotated[FileTable, Tag("file")],
    Discriminator(_kind),
]


@final
class Random(Table):
    """Step lengths drawn anew for every step and user, uniformly between two bounds [s]."""

    low: Positive
    high: Positive

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.low > self.high:
            raise ValueError(f"low is {self.low} and high is {self.high}; low must not be above high")
        return self


@final
class Steps(Table):
    """How long the run lasts and how long the steps are: one of `period`, `rate`, `random`.

    Attributes:
        duration: [s].
        period: T of every step, one number or one for each user [s].
        rate: steps per second, one number or one for each user [Hz].
        random: bounds of random steps.
    """

    duration: Positive = 20.0
    period: Positive | list[Positive] | None = None
    rate: Positive | list[Positive] | None = None
    random: Random | None = None

    @model_validator(mode="after")
    def _one(self) -> Self:
        given = [name for name in ("period", "rate", "random") if getattr(self, name) is not None]
        if len(given) > 1:
            raise ValueError(f"{' and '.join(given)} are given; give only one of period, rate, random")
        return self


@final
class Synchronisation(Table):
    """How the copies are kept together.

    Attributes:
        mode: "constant" (a common index; the sample k - N_ij is used, whatever buffering that takes), "self-paced"
            (step k is taken once the samples k - N_ij are there, and lasts as long as that took) or "freshest" (the
            newest sample that has arrived).
        damping: "rule", "minimax" (smallest largest B_i), "exact" (constant mode with one common step length), or B_i
            itself, one number or one for each user [Ns/m].
        scale: multiplies the damping; below 1 nothing is guaranteed.
        extra_damping: B_e, one number or one for each user [Ns/m].
        index_delay: N_ij in steps, [i][j] from j to i; by default from the channel's delays.
        quantile: share of this run's samples that N_ij ("constant", "self-paced") or the age budget ("freshest") must
            cover; by default all, and 99 % where self-pacing waits for the rest.
        longest: self-paced: bound on T_i(k), in nominal steps; what passes beyond it is made up later. By default
            twice the mean pace of this run.
    """

    mode: Mode = "freshest"
    damping: DampingMethod | NonNegative | list[NonNegative] = "rule"
    scale: NonNegative = 1.0
    extra_damping: NonNegative | list[NonNegative] = 0.0
    index_delay: list[list[Annotated[int, Field(ge=0)]]] | None = None
    quantile: Probability | None = None
    longest: Annotated[float, Field(ge=1.0, allow_inf_nan=False)] | None = None


@final
class Jitter(Table):
    """Random delay added to every message, never negative.

    Uniform in [0, scale], exponential with mean scale, or the size of a normal with standard deviation scale [s].
    """

    kind: Literal["uniform", "exponential", "normal"] = "uniform"
    scale: NonNegative


@final
class Burst(Table):
    """Losses in bursts (Gilbert-Elliott): a good and a bad state with their own losses, switching at every message."""

    enter: Probability
    leave: Annotated[float, Field(gt=0.0, le=1.0)]
    loss_good: Probability = 0.0
    loss_bad: Probability = 1.0


@final
class Channel(Table):
    """What the network does to messages, besides the delay of `[network]`; the same law on every link, own draws.

    Attributes:
        jitter: random delay.
        loss: probability that a message is lost.
        burst: losses in bursts, on top.
        duplication: probability that a message arrives a second time, with its own delay.
        reordering: probability that a message is held back by `reordering_delay`.
        reordering_delay: [s].
        resend: after how long a lost message is sent again where every sample is needed (constant, self-paced); by
            default the link's round trip with its jitter [s].
    """

    jitter: Jitter | None = None
    loss: Annotated[float, Field(ge=0.0, lt=1.0)] = 0.0
    burst: Burst | None = None
    duplication: Probability = 0.0
    reordering: Probability = 0.0
    reordering_delay: NonNegative = 0.0
    resend: Positive | None = None


@final
class Hand(Table):
    """A hand at a node: a spring-damper pulling to a moving place, or a force.

    Attributes:
        user: number from 1.
        node: number from 1.
        at: instead of `node`: a place in the body's rest shape; the nearest node is held [m].
        kind: "spring": `f = k (r - x) + b (r' - x')`; "force": the path itself is f.
        stiffness: k [N/m].
        damping: b [Ns/m].
        path: where it pulls to, as displacement of the node from rest [m] (force: [N]): one place, or waypoints
            [time, x, ...] with straight lines between them.
        amplitude: of a sine added to the path [m or N].
        frequency: of the sine [Hz].
        phase: of the sine [rad].
        begin: when it takes hold [s].
        release: when it lets go [s]; by default never.
    """

    user: Annotated[Number, Field(ge=1)]
    node: Annotated[Number, Field(ge=1)] = 1
    at: Annotated[list[FiniteFloat], Field(min_length=1, max_length=3)] | None = None
    kind: Literal["spring", "force"] = "spring"
    stiffness: NonNegative = 100.0
    damping: NonNegative = 0.0
    path: FiniteFloat | list[FiniteFloat] | list[list[FiniteFloat]] = 0.0
    amplitude: FiniteFloat | list[FiniteFloat] = 0.0
    frequency: NonNegative = 0.0
    phase: FiniteFloat = 0.0
    begin: NonNegative = 0.0
    release: NonNegative | None = None

    @model_validator(mode="after")
    def _after(self) -> Self:
        if self.at is not None and "node" in self.model_fields_set:
            raise ValueError("node and at are given; give only one of them")
        if self.release is not None and self.release <= self.begin:
            raise ValueError(f"release is {self.release} s but begin is {self.begin} s; it must be later")
        if isinstance(self.path, list) and self.path and isinstance(self.path[0], list):
            times = [row[0] for row in self.path if isinstance(row, list) and row]
            if any(b <= a for a, b in pairwise(times)):
                raise ValueError(f"the times of path are {times}; they must increase")
        return self


@final
class Initial(Table):
    """Where the copies start, displaced from rest and moving: for every user a number, d numbers, or n x d numbers."""

    position: list[Any] | None = None
    velocity: list[Any] | None = None


@final
class Solver(Table):
    """Accuracy of the step's solve; fewer iterations cost accuracy, never passivity."""

    tolerance: Annotated[float, Field(gt=0.0, lt=1.0)] = 1e-10
    iterations: Annotated[int, Field(ge=1)] = 500
    basis: Literal["auto", "nodal", "modal"] = "auto"


@final
class Recording(Table):
    """What is kept.

    Attributes:
        every: one of how many steps.
        nodes: numbers from 1, or "all"; by default all up to 64, else those held and those nearest to where tools
            start.
        frames: whole copies so many times a second, for an animation [Hz]; by default none.
    """

    every: Annotated[int, Field(ge=1)] = 1
    nodes: list[Annotated[Number, Field(ge=1)]] | Literal["all"] | None = None
    frames: Positive | None = None
