"""What a page may ask a session for: one model for each command, checked here and nowhere else.

What depends on the session, such as who is in it, is checked where the command is carried out. The page's types are
made of these models by `page/messages.py`, and a test holds them to each other.
"""

from collections.abc import Mapping
from typing import Annotated, Literal, Self, cast, final

from pydantic import BaseModel, ConfigDict, Field, Strict, TypeAdapter, ValidationError, model_validator

from cotouch.errors import SessionError

# script: as the session's file says. free: nothing is held. hold: what is held stays where it is now. pull: drawn to a
# place. wander: drawn about slowly. cut: a blade is led to a place. grab: a pointer draws a node. ball: a pointer
# pushes with a sphere. blade: a pointer cuts. pose: rigid tools are held, one of them is led to a pose.
HandMode = Literal["script", "free", "hold", "pull", "wander", "grab", "ball", "blade", "cut", "pose"]
HAND_MODES: tuple[HandMode, ...] = ("script", "free", "hold", "pull", "wander", "grab", "ball", "blade", "cut", "pose")

# A place farther from rest than this is a mistake [m].
FARTHEST = 1e4
# A rotation vector needs no more [rad].
MOST_TURN = 4.0
# Most that may be emulated [s].
_LONGEST = 5.0
# Every pair of 32 users.
_MOST_LINKS = 496
# A sentence quotes so many characters of what was given, at most.
_QUOTED = 60

Slot = Annotated[int, Field(ge=0, le=255, description="the slot of a user, counted from 0")]
Coordinate = Annotated[float, Field(ge=-FARTHEST, le=FARTHEST)]
Place = Annotated[tuple[Coordinate, Coordinate, Coordinate], Strict(False)]
Angle = Annotated[float, Field(ge=-MOST_TURN, le=MOST_TURN)]
Turn = Annotated[tuple[Angle, Angle, Angle], Strict(False)]
Ends = Annotated[tuple[Slot, Slot], Strict(False)]
Seconds = Annotated[float | None, Field(ge=0.0, le=_LONGEST, description=f"from 0 to {_LONGEST:g} s")]
_NUMBERS = f"3 numbers, each at most {FARTHEST:g} m"
Flag = Annotated[bool, Field(description="true or false")]


class _Parts(BaseModel):
    """Nothing unknown, nothing changed, and nothing taken for what it is not: 1 is no truth, and "1" no number."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, allow_inf_nan=False)


@final
class MoveHand(_Parts):
    """A hand of `Scene.own` does something.

    Attributes:
        slot: whose.
        mode: what.
        node: that it holds; -1: the one that it holds already. With "pose" which of its rigid tools; -1: the first.
        to: where it pulls to, or leads its blade or its tool's handle to, (3,) [m]; only with "pull", "cut" and "pose".
        at: where its blade is put down, (3,) [m]; only with "cut".
        edge: of the blade, from its place to the other end, (3,) [m]; only with "cut".
        turn: of its tool from its start: along the axis of turning, as long as the angle, (3,) [rad]; only with "pose".
    """

    what: Literal["hand"] = "hand"
    slot: Slot
    mode: Annotated[
        Literal["script", "free", "hold", "pull", "wander", "cut", "pose"],
        Field(description="one of script, free, hold, pull, wander, cut, pose"),
    ]
    node: Annotated[
        int, Field(ge=-1, lt=1 << 31, description="a node, counted from 0, or -1 for the one that is held")
    ] = -1
    to: Annotated[Place | None, Field(description=_NUMBERS)] = None
    at: Annotated[Place | None, Field(description=_NUMBERS)] = None
    edge: Annotated[Place | None, Field(description=_NUMBERS)] = None
    turn: Annotated[Turn | None, Field(description=f"3 numbers, each at most {MOST_TURN:g} rad")] = None

    @model_validator(mode="after")
    def _has_what_it_needs(self) -> Self:
        if self.mode == "pull" and self.to is None:
            raise ValueError("to is missing; pull needs 3 numbers")
        if self.mode == "pose" and (self.to is None or self.turn is None):
            name = "to" if self.to is None else "turn"
            raise ValueError(f"{name} is missing; pose needs to and turn, 3 numbers each")
        for name in ("at", "edge", "to") if self.mode == "cut" else ():
            if getattr(self, name) is None:
                raise ValueError(f"{name} is missing; cut needs at, edge and to, 3 numbers each")
        if self.mode == "cut" and not any(self.edge or ()):
            raise ValueError("edge has no length; it must lead from one end of the blade's edge to the other")
        return self


class _OfPath(_Parts):
    """Both directions between two users.

    Attributes:
        a: slot of one.
        b: slot of the other.
    """

    a: Slot
    b: Slot

    @model_validator(mode="after")
    def _has_two_ends(self) -> Self:
        if self.a == self.b:
            raise ValueError(f"a and b are both {self.a}; a path has two ends")
        return self


@final
class Impair(_OfPath):
    """A path is made worse, or better again; what is missing stays as it is.

    Attributes:
        a: slot of one end.
        b: slot of the other.
        delay: of every sample, on top of the network's [s].
        jitter: scale of what comes on top of the delay [s].
        loss: share of samples that are lost.
    """

    what: Literal["impair"] = "impair"
    delay: Seconds = None
    jitter: Seconds = None
    loss: Annotated[float | None, Field(ge=0.0, le=1.0, description="from 0 to 1")] = None

    @model_validator(mode="after")
    def _changes_something(self) -> Self:
        if not self.changes():
            raise ValueError("nothing is given; give delay, jitter or loss")
        return self

    def changes(self) -> dict[str, float]:
        """What is named of delay, jitter and loss."""
        named = {"delay": self.delay, "jitter": self.jitter, "loss": self.loss}
        return {name: float(value) for name, value in named.items() if value is not None}


@final
class Cut(_OfPath):
    """Nothing gets through on a path any more, or everything again.

    Attributes:
        a: slot of one end.
        b: slot of the other.
        on: whether it is cut.
    """

    what: Literal["cut"] = "cut"
    on: Flag


@final
class Kill(_Parts):
    """A user's process dies."""

    what: Literal["kill"] = "kill"
    slot: Slot


@final
class Revive(_Parts):
    """A user's process is started again."""

    what: Literal["revive"] = "revive"
    slot: Slot


@final
class Expel(_Parts):
    """Whoever has a slot goes, and it is free for whoever comes."""

    what: Literal["expel"] = "expel"
    slot: Slot


@final
class ChooseLinks(_Parts):
    """Who is linked to whom.

    Attributes:
        choice: a set of `Overview.choices`, or
        links: pairs of slots.
    """

    what: Literal["links"] = "links"
    choice: Annotated[Literal["best", "worst", "start"] | None, Field(description="one of best, worst, start")] = None
    links: Annotated[
        Annotated[tuple[Ends, ...], Strict(False)] | None,
        Field(max_length=_MOST_LINKS, description=f"a list of at most {_MOST_LINKS} pairs of slots, counted from 0"),
    ] = None

    @model_validator(mode="after")
    def _says_which(self) -> Self:
        if (self.choice is None) == (self.links is None):
            raise ValueError("either choice or links must be given")
        for a, b in self.links or ():
            if a == b:
                raise ValueError(f"links has a pair of {a} and {a}; a link has two ends")
        return self


@final
class SetDamping(_Parts):
    """Copies are given a part of the damping that passivity needs.

    Attributes:
        fraction: of it; below 1 it holds only while `SessionApi.hold_damping` says so.
    """

    what: Literal["damping"] = "damping"
    fraction: Annotated[float, Field(gt=0.0, le=1.0, description="above 0 and at most 1")]


@final
class SetRecording(_Parts):
    """Everybody's part is recorded from now on, or no more."""

    what: Literal["record"] = "record"
    on: Flag


Command = MoveHand | Impair | Cut | Kill | Revive | Expel | ChooseLinks | SetDamping | SetRecording
Doable = Literal["hand", "impair", "cut", "kill", "revive", "expel", "links", "damping", "record"]

COMMANDS: TypeAdapter[Command] = TypeAdapter(Annotated[Command, Field(discriminator="what")])


def read_command(given: Mapping[str, object]) -> Command:
    """A command from its parts, as JSON has them.

    Args:
        given: "what", and the parts that this command has.

    Raises:
        SessionError: there is no such command, or a part of it is missing, unknown or wrong; says what would be right.
    """
    try:
        return COMMANDS.validate_python(dict(given))
    except ValidationError as error:
        raise SessionError(_sentence(error, given)) from None


def _sentence(error: ValidationError, given: Mapping[str, object]) -> str:
    """What is wrong first, and what would be right."""
    first = error.errors(include_url=False)[0]
    known = cast("tuple[type[Command], ...]", Command.__args__)
    models = {model.model_fields["what"].default: model for model in known}
    what = given.get("what")
    if not isinstance(what, str) or what not in models:
        return f"the command is {_quoted(what)}; it must be one of {', '.join(models)}"
    if len(first["loc"]) < 2:  # of the whole command: a sentence of ours
        return str(first["ctx"]["error"]) if "ctx" in first else first["msg"]
    name = str(first["loc"][1])
    fields = models[what].model_fields
    if name not in fields:
        return f"{what} has no {_quoted(name)}; it has {', '.join(part for part in fields if part != 'what')}"
    said = "is missing" if name not in given else f"is {_quoted(given.get(name))}"
    return f"{name} {said}; it must be {fields[name].description}"


def _quoted(value: object) -> str:
    """As it was given, cut short."""
    text = str(value) if isinstance(value, int | float | None) else repr(value)
    return text if len(text) <= _QUOTED else f"{text[: _QUOTED - 1]}…"
