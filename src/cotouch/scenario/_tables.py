"""The tables of a scenario: every option, its range, and what it means."""

from itertools import pairwise
from typing import Annotated, Any, Literal, Self, final

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    FiniteFloat,
    model_validator,
)
from pydantic import NonNegativeFloat as _NonNegativeFloat

Positive = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]
NonNegative = Annotated[_NonNegativeFloat, Field(allow_inf_nan=False)]
Probability = Annotated[float, Field(ge=0.0, le=1.0, allow_inf_nan=False)]
Number = int  # users, nodes: from 1 in files
Mode = Literal["constant", "self-paced", "freshest"]
DampingMethod = Literal["rule", "minimax", "exact"]


class Table(BaseModel):
    """A table of a scenario: nothing unknown in it, nothing changed after reading."""

    model_config = ConfigDict(extra="forbid", frozen=True, arbitrary_types_allowed=True, str_strip_whitespace=True)


Place = Annotated[list[FiniteFloat], Field(min_length=3, max_length=3)]


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
