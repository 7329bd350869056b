"""What a user does to its own copy: nothing, what the session's file says, or whatever a device or page does."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol, final, runtime_checkable

import numpy as np

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.interaction import Touching, after_step_alone, before_step_alone, grip, tools_of
from cotouch.mechanics import Contact, Model, Ports, Surface, Tools, idle_ports, own_ports
from cotouch.members._device_table import DeviceTable
from cotouch.members._file import SessionFile
from cotouch.members._shared_model import SharedModel
from cotouch.scenario import Scenario, ToolTable, ports_of, touching_of, with_tools


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Slot:
    """The copy that a hand moves.

    Attributes:
        scenario: of the session, with its hands at nodes (`Scenario.placed`).
        body: the shared object.
        model: the same for the kernels.
        index: of the user.
        period: usual length of a step [s].
        longest: greatest length of a step [s].
        devices: what the session's file says of devices in people's hands.
    """

    scenario: Scenario
    body: Body
    model: Model
    index: int
    period: float
    longest: float
    devices: Sequence[DeviceTable] = ()

    @classmethod
    def of(cls, session: SessionFile, replica: SharedModel, index: int, model: Model) -> "Slot":
        """The copy of one user of a session.

        Args:
            session: the session's file.
            replica: the shared model.
            index: slot of the user.
            model: in the kernels' form.
        """
        return cls(
            scenario=replica.scenario,
            body=replica.body,
            model=model,
            index=index,
            period=session.period(index),
            longest=session.options.max_step,
            devices=session.options.devices,
        )


class Hand(Protocol):
    """What holds and touches one copy.

    Attributes:
        ports: the ports, for the peer.
        surface: the skin, with tools.
        tools: the proxies; None without.
        contact: the law by which they touch; None: springs.
        nodes: index of the node that each of its ports holds; of a body in the full form once for every axis; of
            tools see `grips_of`.
    """

    nodes: list[int]
    ports: Ports
    surface: Surface | None
    tools: Tools | None
    contact: Contact | None

    def before(self, end: float, T: float) -> None:
        """Writes into grips and tools what it does in the step that ends now.

        Args:
            end: time of what the file says; 0 as long as that waits (`session.wait_for_peers`) [s].
            T: length of the step [s].
        """
        ...

    def after(self) -> None:
        """Takes what came of the step: forces at the ports and on the proxies."""
        ...


@runtime_checkable
class AttachedHand(Protocol):
    """A hand that goes by where the copy is."""

    def attach(self, position: Float) -> None:
        """Learns of the copy's position, which then changes in place.

        Args:
            position: its rows, (rows, width) [m].
        """
        ...


def no_ports(model: Model, row: Sequence[int] = ()) -> Ports:
    """Ports at rows of the model that hold nothing yet.

    Args:
        model: in the kernels' form.
        row: rows of the model.
    """
    rows = np.array(row, dtype=np.int32)
    return idle_ports(rows, model.port_shapes(rows), model.width)


def grips_of(body: Body, slot: int) -> list[int]:
    """Numbers of the points that hold a user's tools, after those where hands can hold the body; see `Hand.nodes`.

    Args:
        body: with tools.
        slot: the user's.
    """
    owner = [part.tool.owner for part in body.tools if part.tool is not None for _ in part.tool.grips]
    return [body.holds + grip for grip, user in enumerate(owner) if user == slot]


def handles_of(body: Body, slot: int) -> list[list[int]]:
    """Numbers, as in `grips_of`, of the handle of each tool that can be held, and of the vectors from there.

    Args:
        body: with tools.
        slot: the user's.
    """
    held = [part.tool for part in body.tools if part.tool is not None and part.tool.grips]
    first = body.holds + sum(len(tool.grips) for tool in held)
    found: list[list[int]] = []
    for tool in held:
        last = first + 1 + len(tool.grips)
        if tool.owner == slot:
            found.append(list(range(first, last)))
        first = last
    return found


class SlotHand:
    """What hands of a slot have in common: nothing in the beginning, then the tools that they take up; a `Hand`."""

    def __init__(self, model: Model, slot: int) -> None:
        """Holds nothing.

        Args:
            model: the body.
            slot: the user's.
        """
        self.nodes: list[int] = []
        self.ports = no_ports(model)
        self.surface: Surface | None = None
        self.tools: Tools | None = None
        self.contact: Contact | None = None
        self._touching: Touching | None = None
        self._slot = slot

    def _take_up(self, at: Slot, tables: list[ToolTable], numbers: Sequence[int] | None = None) -> Touching | None:
        """Takes up tools, by their numbers among all of the file, for messages; None where there are none."""
        users, body = at.scenario.network.size, at.body
        still = np.zeros((users, body.nodes, body.dimension))
        lengths = np.tile([at.period, at.longest], (users, 1))
        self._touching, _ = touching_of(
            tables, users, body, at.model, lengths, start=still, contact=at.scenario.contact, numbers=numbers
        )
        if self._touching is not None:
            self.surface, self.contact = self._touching.surface, self._touching.contact
            self.tools = tools_of(self._touching, self._slot)
        return self._touching

    def before(self, end: float, T: float) -> None:
        """Has its tools do what they do in this step.

        Args:
            end: of the step [s].
            T: length of the step [s].
        """
        if self._touching is not None:
            before_step_alone(self._touching, self._slot, end, T)

    def after(self) -> None:
        """Tells simulated devices what came of the step."""
        if self._touching is not None:
            after_step_alone(self._touching, self._slot)


@final
class NoHand(SlotHand):
    """Takes part without touching anything."""

    def __init__(self, model: Model) -> None:
        """Holds nothing.

        Args:
            model: the body.
        """
        super().__init__(model, 0)


@final
class ScriptedHand(SlotHand):
    """The hands and tools of one slot, as the session's file defines them."""

    def __init__(self, at: Slot) -> None:
        """Takes hold.

        Args:
            at: the copy.

        Raises:
            ScenarioError: a hand, tool or device is wrong.
        """
        scenario, body, model, slot = at.scenario, at.body, at.model, at.index
        super().__init__(model, slot)
        hands, ports = ports_of(scenario.hands, scenario.network.size, body, model)
        axes = body.dimension if model.full else 1
        self.nodes = [hand.node - 1 for hand in scenario.hands if hand.user == slot + 1 for _ in range(axes)]
        if body.tools:
            hands, _, _ = with_tools(hands, ports, scenario.rigid_tools, model)
            self.nodes += grips_of(body, slot)
        self._hands = hands
        self._cursor = hands.path_first[:-1].copy()
        self._lanes = model.lanes
        self._ports = idle_ports(hands.row, hands.shape, model.width)
        self._own = int(hands.first[slot]), int(hands.first[slot + 1])
        self.ports = own_ports(self._ports, *self._own)
        if any(tool.user == slot + 1 for tool in scenario.proxies):
            self._take_up(at, scenario.proxies, scenario.proxy_numbers)

    def before(self, end: float, T: float) -> None:
        """Does what the file says for this step.

        Args:
            end: of the step [s].
            T: length of the step [s].
        """
        for port in range(*self._own):
            grip(self._hands, self._ports, self._cursor, port, end, T, self._lanes)
        super().before(end, T)
