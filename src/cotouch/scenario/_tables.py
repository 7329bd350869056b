"""The tables of a scenario: every option, its range, and what it means."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Annotated, Literal, Self, cast, final

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    FiniteFloat,
    model_validator,
)
from pydantic import NonNegativeFloat as _NonNegativeFloat

from cotouch.arrays import has_truth
from cotouch.errors import BodyError, NetworkError
from cotouch.laws import law_named

Positive = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]
NonNegative = Annotated[_NonNegativeFloat, Field(allow_inf_nan=False)]
# Stiffness and damping of hands: what pulls a firmer one from its place is only rounding.
Firm = Annotated[float, Field(ge=0.0, le=1e9, allow_inf_nan=False)]
# Stiffness of contacts, for which likewise.
Hard = Annotated[float, Field(gt=0.0, le=1e15, allow_inf_nan=False)]
# Places, and what is added to them; products of larger ones are no numbers that energies can be told from.
FARTHEST = 1e9
Coordinate = Annotated[float, Field(ge=-FARTHEST, le=FARTHEST, allow_inf_nan=False)]
Probability = Annotated[float, Field(ge=0.0, le=1.0, allow_inf_nan=False)]
_MOST = 2**31 - 1
# Users, nodes, steps: from 1 in files, and what kernels can count.
Number = Annotated[int, Field(ge=1, le=_MOST)]
Mode = Literal["constant", "self-paced", "freshest"]
DampingMethod = Literal["rule", "minimax", "exact"]


def _numbers(value: float | Sequence[float | Sequence[float]]) -> Iterator[float]:
    """All numbers of nested lists."""
    if isinstance(value, Sequence):
        for entry in value:
            yield from _numbers(entry)
    else:
        yield value


class Table(BaseModel):
    """A table of a scenario: nothing unknown in it, nothing changed after reading."""

    model_config = ConfigDict(extra="forbid", frozen=True, arbitrary_types_allowed=True, str_strip_whitespace=True)

    @model_validator(mode="before")
    @classmethod
    def _no_truth(cls, given: object) -> object:
        """Refuses true and false for numbers, which Python counts as 1 and 0, and "yes" or 1 for true."""
        if not isinstance(given, Mapping):
            return given
        table = cast("Mapping[str, object]", given)
        for name, value in table.items():
            field = cls.model_fields.get(name)
            if field is None or (isinstance(value, bool) if field.annotation is bool else not has_truth(value)):
                continue
            shown = repr(value) if len(repr(value)) <= 60 else f"{repr(value)[:57]}..."
            right = "true or false" if field.annotation is bool else "given as a number, not as true or false"
            raise ValueError(f"{name} is {shown}; it must be {right}")
        return table


def check_times(begin: float, release: float | None, waypoints: Sequence[float] = ()) -> None:
    """Refuses times in a wrong order.

    Args:
        begin: when it takes hold [s].
        release: when it lets go [s]; None: never.
        waypoints: times of a path [s].
    """
    if any(b <= a for a, b in pairwise(waypoints)):
        raise ValueError(f"the times of path are {waypoints}; they must increase")
    if release is not None and release <= begin:
        raise ValueError(f"release is {release} s but begin is {begin} s; it must be later")


Place = Annotated[list[Coordinate], Field(min_length=3, max_length=3)]


def split_table(given: object, inner: str, own: Sequence[str]) -> tuple[dict[str, object], dict[str, object]] | None:
    """A table in which another's options stand beside its own, as in a file, in two; None: it holds that as a table.

    Args:
        given: what was given for the table.
        inner: name of the other.
        own: options of the table itself.
    """
    table = cast("Mapping[str, object]", given) if isinstance(given, Mapping) else {inner: given}
    if inner in table:
        return None
    rest = {name: value for name, value in table.items() if name not in own}
    return {name: table[name] for name in own if name in table}, rest


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

    This is how long a user takes by itself; a step also lasts while its user waits for others (`Synchronisation.mode`).

    Attributes:
        duration: [s].
        period: of the steps, one number or, but for a constant index, one for each user [s].
        rate: steps per second, likewise [Hz].
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
        mode: "constant" (a common index: nobody takes step k + 1 before all have taken step k; the sample k - N_ij is
            used, whatever buffering that takes), "self-paced" (step k is taken once the samples k - N_ij are there) or
            "freshest" (the newest sample that has arrived). In each a step lasts as long as has passed since the step
            before it on the user's own clock, waiting included.
        damping: "rule", "minimax" (smallest largest B_i), "exact" (constant mode with one common step length), or B_i
            itself, one number or one for each user [Ns/m]; by default what the law needs.
        law: what a link does: the name of a law, or a table of its name as `kind` and parameters; see `Scenario.law`.
        damping_scale: multiplies the damping; below 1 nothing is guaranteed.
        extra_damping: B_e, one number or one for each user [Ns/m].
        index_delay: N_ij in steps, [i][j] from j to i; by default from the channel's delays.
        quantile: share of this run's samples that N_ij ("constant", "self-paced") or the age budget ("freshest") must
            cover; by default all, and 99 % where self-pacing waits for the rest.
        max_step: bound on T_i(k), in the longest of the user's own steps. "self-paced": what passes beyond it is made
            up later; by default twice the mean pace of this run. "constant": a step that lasts longer is refused; by
            default none is.
    """

    mode: Mode = "freshest"
    law: str | dict[str, object] | None = None
    damping: DampingMethod | NonNegative | list[NonNegative] | None = None
    damping_scale: NonNegative = 1.0
    extra_damping: NonNegative | list[NonNegative] = 0.0
    index_delay: list[list[Annotated[int, Field(ge=0, le=_MOST)]]] | None = None
    quantile: Probability | None = None
    max_step: Annotated[float, Field(ge=1.0, allow_inf_nan=False)] | None = None

    @property
    def law_given(self) -> tuple[str, dict[str, float | str]] | None:
        """Name of the law, and the parameters that are given; None: no law is named."""
        if self.law is None or isinstance(self.law, str):
            return None if self.law is None else (self.law, {})
        given = cast("dict[str, float | str]", self.law)  # `_known_law` checks that
        return str(given["kind"]), {name: value for name, value in given.items() if name != "kind"}

    @model_validator(mode="after")
    def _of_the_mode(self) -> Self:
        if self.mode == "freshest":
            for name in ("index_delay", "max_step"):
                if getattr(self, name) is not None:
                    raise ValueError(
                        f'{name} is given, but in mode "freshest" it has no effect; leave it out, or use mode '
                        '"constant" or "self-paced"'
                    )
        return self

    @model_validator(mode="after")
    def _known_law(self) -> Self:
        if isinstance(self.law, dict) and "kind" not in self.law:
            raise ValueError(f'law is {self.law}; give a law\'s name, or a table with it as kind: {{kind = "wave"}}')
        if self.law_given is None:
            return self
        name, given = self.law_given
        try:
            law_named(name).check(given)
        except NetworkError as error:
            raise ValueError(str(error)) from None
        return self


@final
class HandTable(Table):
    """A hand at a node: a spring-damper pulling to a moving place, or a force.

    Attributes:
        user: number from 1.
        node: number from 1.
        at: instead of `node`: a place in the body's rest shape; the nearest node is held [m].
        body: name of the one of several bodies that is held: `node` counts its own nodes, `at` finds its nearest.
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

    user: Number
    node: Number = 1
    at: Annotated[list[Coordinate], Field(min_length=1, max_length=3)] | None = None
    body: str | None = None
    kind: Literal["spring", "force"] = "spring"
    stiffness: Firm = 100.0
    damping: Firm = 0.0
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
        if self.path == []:
            raise ValueError("path is []; it must be a place, or waypoints [time, x, ...]")
        for name, value in (("path", self.path), ("amplitude", self.amplitude)):
            far = next((number for number in _numbers(value) if abs(number) > FARTHEST), None)
            if far is not None:
                raise ValueError(f"{name} has the number {far:g}; it must be within {FARTHEST:g}")
        rows = self.path if isinstance(self.path, list) else []
        check_times(self.begin, self.release, [row[0] for row in rows if isinstance(row, list) and row])
        return self


@final
class Initial(Table):
    """Where the copies start, displaced from rest and moving: for every user a number, d numbers, or n x d numbers."""

    position: list[object] | None = None
    velocity: list[object] | None = None


@final
class Solver(Table):
    """Accuracy of the step's solve; fewer iterations cost accuracy, never passivity."""

    tolerance: Annotated[float, Field(gt=0.0, lt=1.0)] = 1e-10
    iterations: Number = 500
    basis: Literal["auto", "nodal", "modal"] = "auto"


@final
class RecordTable(Table):
    """What is kept.

    Attributes:
        every: one of how many steps.
        nodes: numbers from 1, or "all"; by default all up to 64, else those held and those nearest to where tools
            start.
        frames: whole copies so many times a second, for an animation [Hz]; by default none.
    """

    every: Number = 1
    nodes: list[Number] | Literal["all"] | None = None
    frames: Positive | None = None


class MeetingTable(Table):
    """How hard what meets presses, and how it rubs.

    Attributes:
        stiffness: κ: pressure for each metre of depth [N/m³].
        damping: λ: pressure grows by 1 + λ times the speed of approach [s/m].
        friction: Coulomb's coefficient of what does not slip.
        kinetic_friction: of what slips, at most `friction`; by default the same.
    """

    stiffness: Hard = 1e7
    damping: NonNegative = 0.0
    friction: NonNegative = 0.0
    kinetic_friction: NonNegative | None = None

    def made(self) -> object:
        """For the kernels."""
        raise NotImplementedError

    @model_validator(mode="after")
    def _after(self) -> Self:
        if self.kinetic_friction is not None and self.kinetic_friction > self.friction:
            raise ValueError(
                f"kinetic_friction is {self.kinetic_friction:g}, but friction is {self.friction:g}; it must be at "
                "most that"
            )
        try:
            self.made()
        except BodyError as error:
            raise ValueError(str(error)) from None
        return self
