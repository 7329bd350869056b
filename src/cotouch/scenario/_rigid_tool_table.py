"""The table of a scenario for tools that are rigid bodies: moved by a pose, with force and torque."""

from collections.abc import Mapping
from typing import Annotated, Self, cast, final

import numpy as np
from pydantic import Discriminator, Field, SerializerFunctionWrapHandler, Tag, model_serializer, model_validator

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.files import table_of
from cotouch.scenario._body_tables import FileTable, RigidBoxTable, RigidCylinderTable, RigidSphereTable
from cotouch.scenario._tables import Firm, NonNegative, Number, Place, Positive, Table, check_times, split_table
from cotouch.scenario._tool_tables import RIGID, SimulatedDeviceTable, ToolHand, ToolPath, ToolTable

_OWN = ("user", "at", "turn", "handle", "hand", "device")


def is_rigid_tool(given: object) -> bool:
    """Whether a table of [[tools]] is of a rigid body."""
    if isinstance(given, Mapping):
        table = cast("Mapping[str, object]", given)
        return table.get("kind", "file" if "file" in table else None) in RIGID
    return isinstance(given, RigidToolTable)


@final
class PoseHand(Table):
    """What moves a rigid tool: a spring and damper to a pose on a path, in place and orientation.

    Attributes:
        path: how the pose has moved and turned from the tool's start: [x, y, z] or [x, y, z, rx, ry, rz], or waypoints
            with a time before these. It turns about the handle, along the axis of turning, as long as the angle
            [s, m, rad]. Between waypoints all numbers change evenly.
        stiffness: [N/m].
        damping: [Ns/m].
        turning_stiffness: torque for each angle, while that is small; `turning_stiffness sin(angle)` [Nm/rad]. The
            damping of turning is as much of the damping.
        begin: when it takes hold [s].
        release: when it lets go [s]; by default never.
    """

    path: ToolPath = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    stiffness: Annotated[Positive, Field(le=1e9)] = 135.0
    damping: Firm = 6.45
    turning_stiffness: Firm = 0.5
    begin: NonNegative = 0.0
    release: NonNegative | None = None

    @model_validator(mode="after")
    def _after(self) -> Self:
        rows = [row for row in self.path if isinstance(row, list)]
        wrong = next((row for row in rows if len(row) not in {4, 7}), None)
        if wrong is not None:
            raise ValueError(
                f"path has the waypoint {wrong}; it must be a time and 3 numbers, or 6 with the rotation of the tool"
            )
        if not rows and len(self.path) not in {3, 6}:
            raise ValueError(
                f"path is {self.path}; it must be 3 numbers, 6 with the rotation of the tool, or waypoints of a time "
                "and such numbers"
            )
        check_times(self.begin, self.release, [row[0] for row in rows])
        return self

    def poses(self) -> Float:
        """The path as waypoints, a time, a way and a turn each, (waypoints, 7) [s, m, rad]."""
        rows = [row for row in self.path if isinstance(row, list)]
        alone = [value for value in self.path if isinstance(value, float)]
        rows = rows or [[0.0, *alone]]
        return np.array([[*row, *[0.0] * (7 - len(row))] for row in rows])


RigidToolSolid = Annotated[
    Annotated[RigidBoxTable, Tag("box")]
    | Annotated[RigidCylinderTable, Tag("cylinder")]
    | Annotated[RigidSphereTable, Tag("sphere")]
    | Annotated[FileTable, Tag("file")],
    Discriminator(lambda value: str(value["kind"] if isinstance(value, Mapping) else value.kind)),  # pyright: ignore[reportUnknownLambdaType, reportUnknownMemberType, reportUnknownArgumentType]
]


@final
class RigidToolTable(Table):
    """A tool that is a rigid body: any table of one, and who moves it how. It meets bodies by `[between]`.

    Attributes:
        user: number from 1.
        at: where the middle of its extents starts [m].
        turn: how it is turned about that at the start: along the axis of turning, as long as the angle [rad].
        handle: from `at` to where the hand holds it at the start; forces and torques are about that [m].
        hand: what moves it; None: nothing does.
        device: the simulated device in between, in the simulator: its coupling leads the handle, and the hand turns the
            tool beside it.
        solid: its shape and mass.
    """

    user: Number
    at: Place
    turn: Place = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    handle: Place = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    hand: PoseHand | None = None
    device: SimulatedDeviceTable | None = None
    solid: RigidToolSolid

    @model_validator(mode="before")
    @classmethod
    def _split(cls, given: object) -> object:
        """In a file the shape's own options stand beside these."""
        if (parts := split_table(given, "solid", _OWN)) is None:
            return given
        own, solid = parts
        if solid.setdefault("kind", "file") == "file" and solid.setdefault("model", "rigid") != "rigid":
            raise ValueError(f'model is "{solid["model"]}", but a tool is rigid; leave it out')
        return {**own, "solid": solid}

    @model_validator(mode="after")
    def _after(self) -> Self:
        if self.device is not None and self.hand is None:
            raise ValueError("device is given, but no hand, whose springs turn the tool; give it a [tools.hand]")
        return self

    @model_serializer(mode="wrap")
    def _joined(self, handler: SerializerFunctionWrapHandler) -> dict[str, object]:
        table: dict[str, object] = handler(self)
        solid = table_of(table.pop("solid")) or {}
        if table.get("device") is None:
            table.pop("device", None)
        return {**table, **solid}

    def led(self) -> ToolTable:
        """Its handle as what a device moves, with the hand that moves that."""
        place = [a + b for a, b in zip(self.at, self.handle, strict=True)]
        if self.hand is None:
            return ToolTable(user=self.user, at=place, kind="grasp")
        given = self.hand
        hand = ToolHand(
            path=[row[:4].tolist() for row in given.poses()],
            stiffness=given.stiffness,
            damping=given.damping,
            begin=given.begin,
            release=given.release,
        )
        return ToolTable(user=self.user, at=place, kind="grasp", hand=hand, device=self.device)

    def build(self) -> Body:
        """The body, where its table has it.

        Raises:
            BodyError: it is wrong.
        """
        return self.solid.build()


ToolSource = Annotated[
    Annotated[ToolTable, Tag("proxy()")] | Annotated[RigidToolTable, Tag("rigid()")],
    Discriminator(lambda value: "rigid()" if is_rigid_tool(value) else "proxy()"),
]
