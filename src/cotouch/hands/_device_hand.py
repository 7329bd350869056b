"""Hands that hold real devices: the proxy of each is a tool of the slot, round or rigid, or a node that it holds."""

from collections.abc import Sequence
from typing import NamedTuple, final

import numpy as np

from cotouch.arrays import Array, Float
from cotouch.body import Body
from cotouch.coupling import EnergyMessage
from cotouch.errors import DeviceError
from cotouch.hands._grasped import Grasped, GraspedBall, GraspedNode
from cotouch.hands._grasped_tool import GraspedTool
from cotouch.hands._twisted import Twisted
from cotouch.haptics import (
    LEAST_SCALE,
    MOST_SCALE,
    ZERO,
    CouplingChoice,
    ProxyEnd,
    ServoLink,
    ServoReport,
    Vector,
    less,
    multiple,
    plus,
)
from cotouch.mechanics import Model, idle_ports, own_ports
from cotouch.members import Slot, SlotHand, coupling_of_slot, device_tools, handles_of, no_ports
from cotouch.observers import size_of
from cotouch.scenario import HandTable, RigidToolTable, Scenario, ToolTable, ports_of, with_tools

# A ball that touches, where the session's file has no tool for the slot: so much of the body's largest extent, within
# these bounds [m]; light beside a hand, stiffer than the device's spring.
_FRACTION, _SMALLEST, _LARGEST = 0.06, 0.002, 0.02
_MASS, _STIFFNESS = 0.05, 1000.0
# Where a device is to span the body, its workspace reaches so much beyond it, that it may come from outside.
_BEYOND = 1.25
# A workspace that is not known [m].
_WORKSPACE = 0.1


class DeviceWork(NamedTuple):
    """What a device's coupling has done to the copy so far.

    Attributes:
        place: where it moved its proxy [J].
        turning: where it turned it; None: the device renders no torques, or its proxy does not turn [J].
    """

    place: float
    turning: float | None


@final
class DeviceHand(SlotHand):
    """What a person does with a device, or with one in each hand; the copy attaches it to its position.

    Where a device is when it is heard first is where its proxy is then: nothing pulls at the start.
    """

    def __init__(
        self,
        at: Slot,
        *,
        link: ServoLink | Sequence[ServoLink] | None,
    ) -> None:
        """Takes tools of the slot, or such that fit the body; what the file's hands do there is left out.

        Args:
            at: the copy.
            link: to the device, or to each of several; None: nobody holds one, for steps that nobody sees.

        Raises:
            ScenarioError: a tool is wrong.
            DeviceError: the slot has no such tool, or a coupling does not fit its device.
        """
        scenario, body, model, slot = at.scenario, at.body, at.model, at.index
        super().__init__(model, slot)
        links = [] if link is None else list(link) if isinstance(link, Sequence) else [link]
        wanted = _tools_wanted([one.said for one in links], slot)
        self._attached: list[GraspedNode | GraspedTool] = []
        own = device_tools(scenario, slot)
        rigid = [number for number, table in enumerate(own) if isinstance(table, RigidToolTable)]
        tables = _tables(own, body, slot, wanted)
        held: dict[int, Grasped] = {}
        self._take_up(at, list(tables.values()))
        for k, (number, table) in enumerate(tables.items()):
            assert self.tools is not None
            held[number] = GraspedBall(self.tools, k, table.radius)
        if rigid:
            led = [number for number in wanted if number in rigid] if links else []
            held |= self._hold_tools(scenario, body, model, rigid, led)
        elif not tables:
            held = dict(
                zip(wanted, self._grasp(scenario, body, model, _nodes(scenario, body, slot, wanted)), strict=True)
            )
        self._holds: list[_Hold | _Unheld] = []
        for number, one in zip(wanted, links, strict=False):
            below = coupling_of_slot(scenario, at.devices, slot, number)
            self._holds.append(_Hold(held.pop(number), one, below, body))
        self._holds += [_Unheld(one) for one in held.values()]

    def attach(self, position: Float) -> None:
        """Learns where the copy's rows are, as they move."""
        for one in self._attached:
            one.attach(position)

    def before(self, end: float, T: float) -> None:
        """Takes the newest of each device, and pulls its proxy towards it.

        Args:
            end: of the step [s].
            T: length of the step [s].
        """
        super().before(end, T)
        for hold in self._holds:
            hold.before(T)

    def after(self) -> None:
        """Tells each device where its proxy went."""
        for hold in self._holds:
            hold.after()

    @property
    def work(self) -> tuple[DeviceWork, ...]:
        """What each device has done, in their order."""
        return tuple(hold.work for hold in self._holds if isinstance(hold, _Hold))

    def show(self, fields: dict[str, Array]) -> None:
        """Writes into a mailbox's fields where each device is, what it holds or pushes with, and what pulls that.

        Args:
            fields: see `view_fields`; hands that it has no room for are left out.
        """
        shown = self._holds[: fields["mode"].shape[0]]
        fields["hands"][()] = len(shown)
        for k, hold in enumerate(shown):
            hold.grasped.show(fields, k, hold.target)

    def _grasp(self, scenario: Scenario, body: Body, model: Model, nodes: list[int]) -> list[Grasped]:
        """Ports at nodes, numbered from 1."""
        slot = self._slot
        tables = [HandTable(user=slot + 1, node=node) for node in nodes]
        hands, ports = ports_of(tables, scenario.network.size, body, model)
        self.nodes = [node - 1 for node in nodes for _ in range(ports.shape[1])]
        held = idle_ports(hands.row, hands.shape, model.width)
        self.ports = own_ports(held, int(hands.first[slot]), int(hands.first[slot + 1]))
        for node, own in zip(nodes, ports, strict=True):
            x, y, z = (*body.held_rest[node - 1].tolist(), 0.0, 0.0)[:3]
            self._attached.append(GraspedNode(held, body.dimension, node - 1, (x, y, z), own.tolist()))
        return list(self._attached)

    def _hold_tools(
        self, scenario: Scenario, body: Body, model: Model, rigid: list[int], led: list[int]
    ) -> dict[int, Grasped]:
        """The rigid tools of the slot, by their number: those that devices move, then all others that a spring holds.

        Raises:
            DeviceError: a device is to move one that no spring holds.
        """
        slot = self._slot
        none, ports = ports_of([], scenario.network.size, body, model)
        hands, _, found = with_tools(none, ports, scenario.rigid_tools, model, slot)
        tools = dict(zip(rigid, found, strict=True))
        for number in led:
            if tools[number].hand is None:
                raise DeviceError(
                    f"a device would move tool {number + 1} of user {slot + 1}, which has no [tools.hand] whose "
                    "springs turn it; give it one in the session's file"
                )
        numbers = dict(zip((k for k, tool in tools.items() if tool.hand), handles_of(body, slot), strict=True))
        order = [*led, *(k for k in numbers if k not in led)]
        self.nodes = [number for k in order for number in numbers[k]]
        self.ports, first = no_ports(model, [0] * len(self.nodes)), 0
        held: dict[int, Grasped] = {}
        for k in order:
            points = hands.shape[tools[k].ports]
            own = range(first, first + len(numbers[k]))
            self.ports.shape[own[0]] = points.mean(axis=0)
            self.ports.shape[own[1:]] = points - points.mean(axis=0)
            held[k] = one = GraspedTool(self.ports, own, tools[k], model)
            self._attached.append(one)
            first = own.stop
        return held


@final
class _Unheld:
    """A proxy that no device holds."""

    def __init__(self, grasped: Grasped) -> None:
        self.grasped = grasped
        self.target: Vector | None = None

    def before(self, T: float) -> None:
        """Leaves it alone."""
        self.grasped.drive(0.0, 1.0, self.grasped.place(), ZERO)
        self.grasped.turn(None, T)

    def after(self) -> None:
        """Tells nobody."""


@final
class _Hold:
    """A device and its proxy.

    The coupling is that of the device: its spring, damper, energy and places are in the device's metres and newtons.
    With a scale s, the body's metres are s of the device's, and a force on the body is 1/s of that on the device, so
    that both ends see the same power, to the bit but for rounding: k becomes k/s² and b becomes b/s² at the body.

    Attributes:
        grasped: the proxy.
        target: where the device is, in the body's metres; None: nothing is known.
    """

    def __init__(self, grasped: Grasped, link: ServoLink, below: CouplingChoice, body: Body) -> None:
        self.grasped = grasped
        self.target: Vector | None = None
        self._link = link
        self._end = ProxyEnd(link.couple(below))
        self._scale = _scale(link, below, body)
        self._origin: Vector | None = None
        self._before = ZERO
        self._message = EnergyMessage()
        self._twisted: Twisted | None = None
        if isinstance(grasped, GraspedTool) and link.spec.torque > 0.0:
            turning = link.couple_turning(below)
            self._twisted = None if turning is None else Twisted(grasped, turning)

    @property
    def work(self) -> DeviceWork:
        return DeviceWork(self._end.work, None if self._twisted is None else self._twisted.end.work)

    def before(self, T: float) -> None:
        scale = self._scale
        place = self._before = multiple(1.0 / scale, self.grasped.place())
        report: ServoReport | None = self._link.read()
        desired, rate = None, ZERO
        if report is not None:
            if self._origin is None:
                self._origin = less(place, report.place)
            desired, rate, self._message = plus(report.place, self._origin), report.rate, report.message
        self.target = None if desired is None else multiple(scale, desired)
        pull = self._end.pull(place, desired, rate, self._message, T)
        fraction = 1.0 / (scale * scale)
        self.grasped.drive(
            fraction * pull.stiffness,
            fraction * pull.damping,
            multiple(scale, pull.target),
            multiple(1.0 / scale, pull.push),
        )
        if self._twisted is None:
            self.grasped.turn(None if report is None else report.orientation, T)
        else:
            self._twisted.before(report, T)

    def after(self) -> None:
        place = multiple(1.0 / self._scale, self.grasped.place())
        self._end.settle(multiple(self._scale, self.grasped.force()), less(place, self._before))
        there, message, twisted = (
            None if self._origin is None else less(place, self._origin),
            self._end.message,
            self._twisted,
        )
        if twisted is None:
            self._link.order(there, message)
            return
        twisted.after()
        self._link.order(there, message, orientation=twisted.orientation, twist=twisted.end.message)


def _scale(link: ServoLink, below: CouplingChoice, body: Body) -> float:
    """Metres of the body for each of the device."""
    wanted = link.said.over(below).scale
    if wanted is None:
        return 1.0
    if wanted != "fit":
        return float(wanted)
    reach = link.spec.workspace if np.isfinite(link.spec.workspace) and link.spec.workspace > 0.0 else _WORKSPACE
    return float(np.clip(_BEYOND * size_of(body) / reach, LEAST_SCALE, MOST_SCALE))


def _tools_wanted(said: Sequence[CouplingChoice], slot: int) -> list[int]:
    """Which of the slot's tools each device moves, from 0; without devices the first.

    Raises:
        DeviceError: two want the same.
    """
    given = [one.tool for one in said if one.tool is not None]
    if len(set(given)) < len(given):
        raise DeviceError(
            f"two devices would move the same tool of user {slot + 1}; give each a different one, as in tool=2"
        )
    left = iter(number for number in range(1, len(said) + len(given) + 1) if number not in given)
    return [(next(left) if one.tool is None else one.tool) - 1 for one in said] or [0]


def _tables(
    own: Sequence[ToolTable | RigidToolTable], body: Body, slot: int, wanted: list[int]
) -> dict[int, ToolTable]:
    """Tools by number, without what moves them in the file, or such that fit; none where nodes or bodies are held.

    Raises:
        DeviceError: the slot has not so many.
    """
    if own:
        _check_count(wanted, len(own), slot)
        bare = {"hand": None, "device": None, "begin": 0.0, "release": None}
        return {k: table.model_copy(update=bare) for k in wanted if isinstance(table := own[k], ToolTable)}
    if body.dimension != 3 or body.skin is None or not body.skin.triangles.size:
        return {}
    rest = body.held_rest
    low, high = rest.min(axis=0), rest.max(axis=0)
    radius = min(max(_FRACTION * float((high - low).max()), _SMALLEST), _LARGEST)
    middle, above = 0.5 * (low + high), float(high[2]) + 1.5 * radius
    # Side by side, the first on the left, which is where y grows.
    aside = [1.5 * radius * (len(wanted) - 1 - 2 * k) for k in range(len(wanted))]
    return {
        number: ToolTable(
            user=slot + 1,
            at=[float(middle[0]), float(middle[1]) + beside, above],
            radius=radius,
            mass=_MASS,
            stiffness=_STIFFNESS,
        )
        for number, beside in zip(wanted, aside, strict=True)
    }


def _check_count(wanted: list[int], count: int, slot: int) -> None:
    """Sees that a slot has the tools that devices are to move.

    Raises:
        DeviceError: it has not so many.
    """
    if wanted and max(wanted) >= count:
        some = "only one tool" if count == 1 else f"only {count} tools"
        raise DeviceError(
            f"a device would move tool {max(wanted) + 1} of user {slot + 1}, which has {some}; give the session's "
            "file another [[tools]], or take part with fewer devices"
        )


def _nodes(scenario: Scenario, body: Body, slot: int, wanted: list[int]) -> list[int]:
    """The nodes, from 1, that the file's hands of this slot hold; else, for one device, the one nearest to the middle.

    Raises:
        DeviceError: the slot has not so many hands.
    """
    own = [hand.node for hand in scenario.hands if hand.user == slot + 1]
    if max(wanted) < len(own):
        return [own[number] for number in wanted]
    if own or wanted != [0]:
        raise DeviceError(
            f"a device would hold what hand {max(wanted) + 1} of user {slot + 1} holds, which has {len(own)}; "
            "give the session's file another [[hands]], or take part with fewer devices"
        )
    rest = body.rest[: body.shared]
    return [1 + int(np.argmin(np.linalg.norm(rest - rest.mean(axis=0), axis=1)))]
