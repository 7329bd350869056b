"""The table of a scenario for what is around the body: gravity, planes, boxes, plates with a hole."""

from collections.abc import Sequence
from typing import Annotated, final

import numpy as np
from pydantic import Field, FiniteFloat

from cotouch.arrays import Float
from cotouch.errors import ScenarioError
from cotouch.mechanics import Box, Model, Obstacle, Plane, Plate, Shape, World, deepest_between, deepest_point
from cotouch.scenario._tables import MeetingTable, NonNegative, Place, Positive, Table

_MOST = 16
# A copy may begin as deep in an obstacle as this share of its size.
_DEEP = 0.1
# And bodies as deep in each other as this share of the smaller one's.
_INSIDE = 0.02
_ORIGIN = [0.0, 0.0, 0.0]


class _ObstacleTable(MeetingTable):
    """What all obstacles have."""

    def _shape(self) -> Shape:
        raise NotImplementedError

    def made(self) -> Obstacle:
        """For the kernels."""
        return Obstacle(
            shape=self._shape(),
            stiffness=self.stiffness,
            loss=self.damping,
            friction=self.friction,
            kinetic=self.kinetic_friction,
        )


@final
class PlaneTable(_ObstacleTable):
    """Everything below a plane is solid.

    Attributes:
        point: of the plane [m].
        normal: out of it, of any length.
    """

    point: Place = Field(default_factory=lambda: [*_ORIGIN])
    normal: Place = Field(default_factory=lambda: [0.0, 0.0, 1.0])

    def _shape(self) -> Shape:
        return Plane(_three(self.point), _three(self.normal))


@final
class BoxTable(_ObstacleTable):
    """A solid box.

    Attributes:
        size: lengths of its sides [m].
        centre: of it [m].
        turn: how it is turned about its centre: along the axis of turning, as long as the angle [rad].
    """

    size: Annotated[list[Positive], Field(min_length=3, max_length=3)]
    centre: Place = Field(default_factory=lambda: [*_ORIGIN])
    turn: Place = Field(default_factory=lambda: [*_ORIGIN])

    def _shape(self) -> Shape:
        return Box(_three(self.size), _three(self.centre), _three(self.turn))


@final
class PlateTable(_ObstacleTable):
    """A solid box with a round hole through it along its third side.

    Attributes:
        size: lengths of its sides [m].
        hole_radius: of the hole [m].
        hole_at: where its axis is along the first two sides, from the centre [m].
        chamfer: how far the rims of the hole are cut off, at 45° [m].
        centre: of the box [m].
        turn: as of a box [rad].
    """

    size: Annotated[list[Positive], Field(min_length=3, max_length=3)]
    hole_radius: Positive
    hole_at: Annotated[list[FiniteFloat], Field(min_length=2, max_length=2)] = Field(default_factory=lambda: [0.0, 0.0])
    chamfer: NonNegative = 0.0
    centre: Place = Field(default_factory=lambda: [*_ORIGIN])
    turn: Place = Field(default_factory=lambda: [*_ORIGIN])

    def _shape(self) -> Shape:
        hole = (self.hole_radius, self.hole_at[0], self.hole_at[1], self.chamfer)
        return Plate(_three(self.size), hole, _three(self.centre), _three(self.turn))


@final
class WorldTable(Table):
    """What is around the body and does not move.

    Attributes:
        gravity: acceleration along x, y, z [m/s²].
        planes: half-spaces that the body's skin meets.
        boxes: boxes that it meets.
        plates: boxes with a hole through each.
    """

    gravity: Place | None = None
    planes: Annotated[list[PlaneTable], Field(max_length=_MOST)] = Field(default_factory=list[PlaneTable])
    boxes: Annotated[list[BoxTable], Field(max_length=_MOST)] = Field(default_factory=list[BoxTable])
    plates: Annotated[list[PlateTable], Field(max_length=_MOST)] = Field(default_factory=list[PlateTable])

    def obstacles(self) -> list[Obstacle]:
        """All of them: planes, boxes, plates."""
        return [table.made() for table in (*self.planes, *self.boxes, *self.plates)]

    def name(self, number: int) -> str:
        """How the file names one of `obstacles`.

        Args:
            number: from 0.
        """
        for name, tables in (("planes", self.planes), ("boxes", self.boxes), ("plates", self.plates)):
            if number < len(tables):
                return f"world.{name}[{number + 1}]"
            number -= len(tables)
        raise IndexError(number)

    def refuse_overlap(self, ready: Model, position: Float) -> None:
        """Refuses copies that begin in an obstacle.

        Args:
            ready: the body, with these obstacles.
            position: displacement of every user's copy, (users, n, d) [m].

        Raises:
            ScenarioError: one is deeper than a tenth of its own size.
        """
        world = None if ready.force is None else ready.force.world
        if world is None:
            return
        if world.bodies is not None:
            _refuse_inside(ready, world, position)
        if not world.kind.size:
            return
        size = float(np.ptp(ready.body.rest, axis=0).max())
        for i, field in enumerate(position):
            deep, s = deepest_point(world, ready.to_rows(field))
            if deep > _DEEP * size:
                raise ScenarioError(
                    f"{self.name(s)}: the copy of user {i + 1} begins {deep:.3g} m deep in it, more than a tenth "
                    "of its own size; move one of them"
                )


def _refuse_inside(ready: Model, world: World, position: Float) -> None:
    """Refuses copies in which bodies begin in each other."""
    assert world.bodies is not None
    parts = ready.body.parts
    for i, field in enumerate(position):
        deep, one, two = deepest_between(world, world.bodies, ready.to_rows(field))
        size = min(float(np.ptp(parts[b].body.rest, axis=0).max()) for b in (one, two))
        if deep <= _INSIDE * size:
            continue
        who = f"in the copy of user {i + 1}, more than {_INSIDE:g} of"
        if one == two:
            name = parts[one].name
            raise ScenarioError(
                f'between: "{name}" begins {deep:.3g} m deep in itself {who} its size; take self_contact = false, or '
                "another shape"
            )
        raise ScenarioError(
            f'bodies: "{parts[one].name}" and "{parts[two].name}" begin {deep:.3g} m deep in each other {who} the '
            "smaller one's size; move one of them"
        )


def _three(values: Sequence[float]) -> tuple[float, float, float]:
    return values[0], values[1], values[2]
