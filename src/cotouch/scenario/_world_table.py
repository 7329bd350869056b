"""The table of a scenario for what is around the body: gravity, planes, boxes, plates with a hole, meshes."""

from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Annotated, final

import numpy as np
from pydantic import Field, FiniteFloat

from cotouch.arrays import Float, Int
from cotouch.body import CORNERS, FACES, Unit, closed_surface, turning
from cotouch.errors import ScenarioError
from cotouch.mechanics import (
    Box,
    Model,
    Obstacle,
    Plane,
    Plate,
    Shape,
    Solid,
    World,
    deepest_between,
    deepest_point,
    unsettled,
)
from cotouch.scenario._penetration import overlap, thickness
from cotouch.scenario._tables import MeetingTable, NonNegative, Place, Positive, Table

_MOST = 16
# A copy may begin as deep in an obstacle as this share of its size.
_DEEP = 0.1
# And bodies as deep in each other as this share of the smaller one's.
_INSIDE = 0.02
# Whatever the size, no deeper than this share of a thickness: what is thin may be right through another.
_THIN = 0.25
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
class MeshTable(_ObstacleTable):
    """What a closed surface in a file encloses.

    Attributes:
        file: STL, OBJ, PLY, OFF or GLB; relative to the scenario.
        unit: of the file: "m", "mm", "cm", "in"; only GLB has one by itself.
        scale: how many times as large it is.
        centre: where the middle of its extents comes to; by default it stays where it is [m].
        turn: how it is turned about that middle: along the axis of turning, as long as the angle [rad].
        most_triangles: refuse files with more.
    """

    file: str
    unit: Unit | None = None
    scale: Positive = 1.0
    centre: Place | None = None
    turn: Place = Field(default_factory=lambda: [*_ORIGIN])
    most_triangles: Annotated[int, Field(ge=4, le=200_000)] = 20_000

    def _shape(self) -> Shape:
        path = Path(self.file)
        changed = path.stat().st_mtime_ns if path.is_file() else 0
        vertices, triangles = _surface(self.file, self.unit, self.most_triangles, changed)
        middle = 0.5 * (vertices.min(axis=0) + vertices.max(axis=0))
        turned = self.scale * (vertices - middle) @ turning(self.turn).T
        return Solid(turned + (middle if self.centre is None else np.array(self.centre)), triangles)


@lru_cache(maxsize=_MOST)
def _surface(file: str, unit: Unit | None, most: int, changed: int) -> tuple[Float, Int]:  # noqa: ARG001
    """A closed surface, read once; `changed` says when the file was written last."""
    vertices, triangles, _ = closed_surface(file, unit=unit, most_triangles=most)
    return vertices, triangles


@final
class WorldTable(Table):
    """What is around the body and does not move.

    Attributes:
        gravity: acceleration along x, y, z [m/s²].
        planes: half-spaces that the body's skin meets.
        boxes: boxes that it meets.
        plates: boxes with a hole through each.
        meshes: what surfaces in files enclose.
    """

    gravity: Place | None = None
    planes: Annotated[list[PlaneTable], Field(max_length=_MOST)] = Field(default_factory=list[PlaneTable])
    boxes: Annotated[list[BoxTable], Field(max_length=_MOST)] = Field(default_factory=list[BoxTable])
    plates: Annotated[list[PlateTable], Field(max_length=_MOST)] = Field(default_factory=list[PlateTable])

    meshes: Annotated[list[MeshTable], Field(max_length=_MOST)] = Field(default_factory=list[MeshTable])

    def obstacles(self) -> list[Obstacle]:
        """All of them: planes, boxes, plates, meshes."""
        return [table.made() for table in (*self.planes, *self.boxes, *self.plates, *self.meshes)]

    def name(self, number: int) -> str:
        """How the file names one of `obstacles`.

        Args:
            number: from 0.
        """
        kinds = (("planes", self.planes), ("boxes", self.boxes), ("plates", self.plates), ("meshes", self.meshes))
        for name, tables in kinds:
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
            _refuse_inside(ready, world, position, [self.name(world.kind.size + k) for k in range(len(self.meshes))])
        size = float(np.ptp(ready.body.rest[: ready.body.shared], axis=0).max())
        for i, field in enumerate(position if world.kind.size else ()):
            deep, s = deepest_point(world, unsettled(ready, i), ready.to_rows(field))
            shape = self.obstacles()[s].shape
            if deep > _DEEP * size or (isinstance(shape, Box | Plate) and deep > _THIN * min(shape.size)):
                what = "a tenth of its own size" if deep > _DEEP * size else "a quarter of how thick that is"
                raise ScenarioError(
                    f"{self.name(s)}: the copy of user {i + 1} begins {deep:.3g} m deep in it, more than {what}; move "
                    "one of them"
                )
        for i, field in enumerate(position):
            if i == 0 or ready.body.tools or not np.array_equal(field, position[0]):
                self._refuse_within(ready, i, field)

    def _refuse_within(self, ready: Model, user: int, field: Float) -> None:
        """Refuses a copy with a body that encloses an obstacle, or is in the place of one or of another body."""
        skin, parts = ready.body.skin, ready.body.parts
        assert skin is not None
        places, ends = skin.vertices + skin.carried(field), np.array([skin.vertices.shape[0]])
        if parts:
            ends = np.cumsum([part.skin().vertices.shape[0] for part in parts])
        names = [f'"{part.name}"' for part in parts] or ["the body"]
        away = [part.tool is not None and part.tool.owner != user for part in parts] or [False]
        corners, things = skin.triangles, list[tuple[str, tuple[Float, Int]]]()
        for name, begin, end, elsewhere in zip(names, [0, *ends[:-1]], ends, away, strict=True):
            if elsewhere:
                continue
            own = corners[(corners >= begin).all(axis=1) & (corners < end).all(axis=1)] - begin
            things.append((name, (places[begin:end], own.astype(np.int32))))
        still = [(self.name(k), found) for k, one in enumerate(self.obstacles()) if (found := _surface_of(one.shape))]
        for k, (name, own) in enumerate(things):
            for other, beside in (*still, *things[:k]):
                deep = overlap(own, beside)
                if deep > min(_limits(own, beside)):
                    raise ScenarioError(
                        f"{other} and {name} overlap in the copy of user {user + 1}, {deep:.3g} m deep; move "
                        "one of them"
                    )


def _limits(*surfaces: tuple[Float, Int]) -> tuple[float, float]:
    """How deep things may begin in each other: by the smaller one's size, and by the thinner one's thickness [m].

    What encloses nothing, such as a sheet of one layer, has no thickness.
    """
    size = _INSIDE * min(float(np.ptp(vertices, axis=0).max()) for vertices, _ in surfaces)
    return size, min((_THIN * thick for one in surfaces if (thick := thickness(*one)) > 0.0), default=np.inf)


def _surface_of(shape: Shape) -> tuple[Float, Int] | None:
    """The closed surface of a box or a solid; None of others."""
    if isinstance(shape, Solid):
        return shape.vertices, shape.triangles
    if not isinstance(shape, Box):
        return None
    corners = 0.5 * np.array(shape.size) * (2.0 * CORNERS - 1.0)
    return corners @ turning(shape.turn).T + np.array(shape.centre), np.array(FACES[8], dtype=np.int32)


def _refuse_inside(ready: Model, world: World, position: Float, solids: Sequence[str]) -> None:
    """Refuses copies in which bodies begin in each other, or in a solid."""
    assert world.bodies is not None
    parts = ready.body.parts
    for i, field in enumerate(position):
        deep, one, two = deepest_between(world, world.bodies, unsettled(ready, i), ready.to_rows(field))
        own = [b for b in (one, two) if b < len(parts)]
        size, thin = _limits(*((parts[b].skin().vertices, parts[b].skin().triangles) for b in own))
        if deep <= (size if one == two else min(size, thin)):
            continue
        big = deep > size
        who = f"in the copy of user {i + 1}, more than {_INSIDE if big else _THIN:g} of"
        if len(own) == 1:
            raise ScenarioError(
                f'{solids[max(one, two) - len(parts)]}: "{parts[own[0]].name}" begins {deep:.3g} m deep in it {who} '
                f"its own {'size' if big else 'thickness'}; move one of them"
            )
        if one == two:
            name = parts[one].name
            raise ScenarioError(
                f'between: "{name}" begins {deep:.3g} m deep in itself {who} its size; take self_contact = false, or '
                "another shape"
            )
        least = "the smaller one's size" if big else "the thinner one's thickness"
        if parts[one].tool is not None or parts[two].tool is not None:
            tool, other = (one, two) if parts[one].tool is not None else (two, one)
            raise ScenarioError(
                f'{parts[tool].name}: it begins {deep:.3g} m deep in "{parts[other].name}" {who} {least}; move one of '
                "them"
            )
        raise ScenarioError(
            f'bodies: "{parts[one].name}" and "{parts[two].name}" begin {deep:.3g} m deep in each other {who} '
            f"{least}; move one of them"
        )


def _three(values: Sequence[float]) -> tuple[float, float, float]:
    return values[0], values[1], values[2]
