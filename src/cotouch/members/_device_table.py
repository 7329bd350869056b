"""What a session's file says of the devices in people's hands."""

from collections.abc import Sequence
from typing import Annotated, Literal, Self, final

from pydantic import Field, model_validator

from cotouch.errors import DeviceError
from cotouch.haptics import LEAST_SCALE, MOST_SCALE, CouplingChoice
from cotouch.scenario import NonNegative, Positive, RigidToolTable, Scenario, Table, ToolTable

Numbered = Annotated[int, Field(ge=1)]


@final
class DeviceTable(Table):
    """How a device is coupled to what it moves; what its holder says beside its name goes first.

    Attributes:
        user: whose device; by default everybody's.
        tool: of that user, from 1; by default all.
        coupling: "pspm" (passive whatever the rates), "virtual" (a plain spring and damper where the device's own
            friction allows it), or another of `cotouch.mechanics.device_couplings`.
        stiffness: of the spring [N/m].
        damping: [Ns/m].
        friction: viscous, that the device has for certain; with "virtual" only [Ns/m].
        coulomb: dry friction that it has for certain; with "virtual" only [N].
        ages: of the places that both ends know of each other, together; with "virtual" only [s].
        weight: more lets the device pay for old places, less the proxy; with "virtual" only.
        scale: metres of the body for each metre of the device, which feels so many times the force; "fit": as much as
            lets its workspace span the body.
        turning_stiffness: of the spring to a rigid tool's orientation, for a device that renders torques [Nm/rad].
        turning_damping: likewise [Nms/rad].
    """

    user: Numbered | None = None
    tool: Numbered | None = None
    coupling: str | None = None
    stiffness: Positive | None = None
    damping: NonNegative | None = None
    friction: NonNegative | None = None
    coulomb: NonNegative | None = None
    ages: NonNegative | None = None
    weight: Positive | None = None
    scale: Annotated[float, Field(ge=LEAST_SCALE, le=MOST_SCALE)] | Literal["fit"] | None = None
    turning_stiffness: Positive | None = None
    turning_damping: NonNegative | None = None

    @model_validator(mode="after")
    def _after(self) -> Self:
        if self.tool is not None and self.user is None:
            raise ValueError(f"tool is {self.tool}, but user is not given; tools are numbered for each user")
        try:
            self.said()
        except DeviceError as error:
            raise ValueError(str(error)) from None
        return self

    def said(self) -> CouplingChoice:
        """As the device's processes want it."""
        plain = self.coupling is None and (self.stiffness is not None or self.damping is not None)
        return CouplingChoice(
            law="pspm" if plain else self.coupling,
            stiffness=self.stiffness,
            damping=self.damping,
            friction=self.friction,
            coulomb=self.coulomb,
            ages=self.ages,
            weight=self.weight,
            scale=self.scale,
            turning_stiffness=self.turning_stiffness,
            turning_damping=self.turning_damping,
        )


def device_tools(scenario: Scenario, slot: int) -> list[ToolTable | RigidToolTable]:
    """The tools that a user's devices may move, in the order of the file; beside rigid tools, no blades.

    Args:
        scenario: of the session.
        slot: of the user, from 0.
    """
    own = [tool for tool in scenario.tools if tool.user == slot + 1]
    if any(isinstance(tool, RigidToolTable) for tool in own):
        own = [tool for tool in own if isinstance(tool, RigidToolTable) or tool.kind != "blade"]
    return own


def coupling_of_slot(scenario: Scenario, devices: Sequence[DeviceTable], slot: int, tool: int) -> CouplingChoice:
    """The file's options for the device that moves a tool.

    Tables that name the tool go before those that name the user, and these before those for everybody; at last what
    `[tools.device]` says of the coupling of the device that is simulated there.

    Args:
        scenario: of the session.
        devices: its tables `[[session.devices]]`.
        slot: of the user, from 0.
        tool: of the slot, from 0.
    """
    fitting = [table for table in devices if table.user in {None, slot + 1} and table.tool in {None, tool + 1}]
    fitting.sort(key=lambda table: (table.tool is None, table.user is None))
    found = CouplingChoice()
    for table in fitting:
        found = found.over(table.said())
    own = device_tools(scenario, slot)
    simulated = own[tool].device if tool < len(own) else None
    if simulated is None or simulated.coupling == "host_force":
        return found
    given = simulated.model_fields_set & {"coupling", "stiffness", "damping"}
    if not given:
        return found
    return found.over(
        CouplingChoice(
            law=simulated.coupling,
            stiffness=simulated.stiffness if "stiffness" in given else None,
            damping=simulated.damping if "damping" in given else None,
        )
    )
