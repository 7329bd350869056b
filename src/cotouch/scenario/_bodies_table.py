"""The tables of several bodies: each of them, where it is, and what they do to each other."""

import math
import re
from dataclasses import replace
from typing import Annotated, Self, final

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer, model_validator

from cotouch.body import Body, Placed, scaled
from cotouch.errors import BodyError, ScenarioError
from cotouch.mechanics import Between
from cotouch.scenario._body_tables import BodySource, FileTable
from cotouch.scenario._tables import MeetingTable, Number, Place, Table, split_table

_MOST = 64
# Strains of what is rigid swing at most so many times as fast; beyond, rounding of its place counts.
_HARDER = 100.0
_OWN = ("name", "at", "turn", "copies", "step", "color")
_COLOR = re.compile(r"#[0-9a-fA-F]{6}")


@final
class PartTable(Table):
    """One of several bodies: any table of a body, and where it is.

    Attributes:
        name: of its own; of copies it is followed by their number from 1.
        at: where the middle of its extents comes to; by default it stays where it is [m].
        turn: how it is turned about that middle: along the axis of turning, as long as the angle [rad].
        copies: how many of it there are.
        step: from one copy to the next [m].
        color: in pictures, as "#rrggbb"; by default each body has one of its own.
    """

    name: str
    at: Place | None = None
    turn: Place = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    copies: Annotated[Number, Field(le=_MOST)] = 1
    step: Place = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    color: str | None = None
    body: BodySource

    @model_validator(mode="before")
    @classmethod
    def _split(cls, given: object) -> object:
        """In a file the body's own options stand beside these."""
        return given if (parts := split_table(given, "body", _OWN)) is None else {**parts[0], "body": parts[1]}

    @model_serializer(mode="wrap")
    def _joined(self, handler: SerializerFunctionWrapHandler) -> dict[str, object]:
        table: dict[str, object] = handler(self)
        inner = table.pop("body", {})
        return {**table, **inner} if isinstance(inner, dict) else table

    @model_validator(mode="after")
    def _after(self) -> Self:
        if self.color is not None and not _COLOR.fullmatch(self.color):
            raise ValueError(f'color is "{self.color}"; it must be red, green and blue as "#rrggbb", such as "#d8be98"')
        if self.copies > 1 and not any(self.step):
            raise ValueError(f"copies is {self.copies}, but step is missing; it must lead from one copy to the next")
        if isinstance(self.body, FileTable) and self.body.modes is not None:
            raise ValueError(f"modes is {self.body.modes}; among several bodies leave modes out")
        return self

    def placed(self) -> list[Placed]:
        """It and its copies, as `cotouch.body.together` wants them."""
        body = self.body if isinstance(self.body, Body) else self.body.build()
        at = self.at
        if at is None:
            at = (0.5 * (body.rest.min(axis=0) + body.rest.max(axis=0))).tolist()
        places = [[x + k * s for x, s in zip(at, self.step, strict=False)] for k in range(self.copies)]
        return [
            Placed(
                body=body,
                name=self.name if self.copies == 1 else f"{self.name} {k + 1}",
                at=(place[0], place[1], place[2]) if len(place) == 3 else None,
                turn=(self.turn[0], self.turn[1], self.turn[2]),
            )
            for k, place in enumerate(places)
        ]


Parts = Annotated[list[PartTable], Field(max_length=_MOST)]


def colours_of(tables: list[PartTable]) -> tuple[str | None, ...]:
    """The colour of each body, as "#rrggbb"; None: its own by default.

    Args:
        tables: of the bodies.
    """
    return tuple(table.color for table in tables for _ in range(table.copies))


def placed_bodies(tables: list[PartTable]) -> list[Placed]:
    """Several bodies, each where it belongs.

    Args:
        tables: at least one.

    Raises:
        ScenarioError: there are too many.
        BodyError: a body is wrong.
    """
    placed: list[tuple[Placed, float | None]] = []
    for k, table in enumerate(tables, 1):
        try:
            placed += [(one, getattr(table.body, "rate", None)) for one in table.placed()]
        except BodyError as error:
            raise BodyError(f"bodies[{k}]: {error}") from None
    if len(placed) > _MOST:
        raise ScenarioError(f"there are {len(placed)} bodies; a scenario takes {_MOST}")
    masses = [one.body.mass.diagonal().sum() for one, _ in placed]
    return [
        one if rate is not None else replace(one, body=_bearing(one.body, max(masses) / mass))
        for (one, rate), mass in zip(placed, masses, strict=True)
    ]


def _bearing(body: Body, times: float) -> Body:
    """A body so hard that it bears the load of so many times its mass as it bears its own, if it is rigid."""
    if times == 1.0 or body.material is None or body.material.model != "rigid":
        return body
    return scaled(body, mass=1.0, rate=min(math.sqrt(times), _HARDER))


@final
class BetweenTable(MeetingTable):
    """What bodies do to each other where they meet.

    Attributes:
        self_contact: whether each body that yields meets itself as well.
    """

    self_contact: bool = False

    def checked(self, placed: list[Placed]) -> list[Placed]:
        """The same bodies, which it fits.

        Args:
            placed: all of them.

        Raises:
            ScenarioError: they are to meet themselves, but none yields.
        """
        if self.self_contact and all(one.body.rigid for one in placed):
            raise ScenarioError(
                "between.self_contact is true, but no body yields, so none can meet itself; leave it out"
            )
        return placed

    def made(self) -> Between:
        """For the kernels."""
        return Between(
            stiffness=self.stiffness,
            loss=self.damping,
            friction=self.friction,
            kinetic=self.kinetic_friction,
            own=self.self_contact,
        )
