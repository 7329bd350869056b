"""The scenario in a run's attributes: what results and pictures read of it."""

import json
from typing import TYPE_CHECKING, Literal, NotRequired, TypeAlias, TypedDict

if TYPE_CHECKING:
    import xarray as xr


class Span(TypedDict):
    """When something acts [s]; None: to the end."""

    begin: float
    release: float | None


class HandEntry(Span):
    """A hand; user and node count from 1."""

    user: int
    node: int


class DeviceEntry(TypedDict):
    """A simulated device."""

    preset: str | None
    kind: Literal["cartesian", "phantom"] | None
    rate: float | None
    periods: list[float] | None
    coupling: str


class _ToolEntry(Span):
    user: int
    hand: Span | None
    device: DeviceEntry | None


class ProxyEntry(_ToolEntry):
    """A ball, a stylus or a grasp."""

    kind: Literal["touch", "grasp"]
    radius: float
    axis: list[float] | None


class BladeEntry(_ToolEntry):
    """A blade."""

    kind: Literal["blade"]
    axis: list[float]
    thickness: float


ToolEntry: TypeAlias = ProxyEntry | BladeEntry


class RigidToolEntry(TypedDict):
    """A tool that is a rigid body."""

    user: int
    kind: str
    hand: Span | None


class BodyEntry(TypedDict, total=False):
    """One of several bodies; one that was made in Python has its name only."""

    color: str | None
    copies: int


class NetworkEntry(TypedDict):
    """Who is linked, from 1."""

    links: list[tuple[int, int]]


class RunTables(TypedDict):
    """All of them."""

    network: NetworkEntry
    hands: list[HandEntry]
    tools: NotRequired[list[ToolEntry]]
    rigid_tools: NotRequired[list[RigidToolEntry]]
    bodies: NotRequired[list[BodyEntry]]
    world: NotRequired[dict[str, object]]
    contact: NotRequired[dict[str, object]]


def tables_of(run: "xr.Dataset") -> RunTables:
    """The scenario that was run.

    Args:
        run: a result of `simulate`.
    """
    return json.loads(run.attrs["scenario"])
