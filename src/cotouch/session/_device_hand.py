"""A hand that holds a real device: its proxy is a tool of the seat, or a node that it holds."""

from typing import Any, Protocol, final

import numpy as np
import numpy.typing as npt

from cotouch.body import Body
from cotouch.haptics import Report, ServoLink, Vector, Word, proxy_end
from cotouch.mechanics import Grips, Surface, Tools
from cotouch.scenario import (
    Scenario,
    ToolTable,
    Touching,
    before_step_alone,
    ports_of,
    tools_of,
    touching_of,
)
from cotouch.scenario._tables import Hand as HandTable
from cotouch.session._hand import Seat, no_grips
from cotouch.session._told import write_hand

Float = npt.NDArray[np.float64]
_NOWHERE: Vector = (0.0, 0.0, 0.0)
# A ball that touches, where the session's file has no tool for the seat: so much of the body's largest extent, within
# these bounds [m]; light beside a hand, stiffer than the device's spring.
_SHARE, _SMALLEST, _LARGEST = 0.06, 0.002, 0.02
_MASS, _STIFFNESS = 0.05, 1000.0


class Held(Protocol):
    """What the device's spring pulls at."""

    def place(self) -> Vector:
        """Where it is [m]."""
        ...

    def drive(self, stiffness: float, damping: float, target: Vector, push: Vector) -> None:
        """Sets what pulls it in the coming step."""
        ...

    def force(self) -> Vector:
        """Mean of what pulled it in the last step [N]."""
        ...

    def show(self, fields: dict[str, npt.NDArray[Any]], target: Vector | None) -> None:
        """Writes it into a board's fields as the first hand.

        Args:
            fields: see `view_fields`.
            target: where the device is, as `place` says it [m]; None: nothing is known.
        """
        ...


@final
class Ball:
    """A tool: a sphere that touches the skin, or holds nodes."""

    def __init__(self, tools: Tools, radius: float) -> None:
        """The first of these, with its radius [m]."""
        self._tools = tools
        self._row = tools.first
        self._radius = radius

    def place(self) -> Vector:
        """Of its centre [m]."""
        return _vector(self._tools.place[self._row])

    def drive(self, stiffness: float, damping: float, target: Vector, push: Vector) -> None:
        """Sets what pulls it in the coming step."""
        tools, row = self._tools, self._row
        tools.drive_stiffness[row], tools.drive_damping[row] = stiffness, damping
        tools.drive_start[row, :3] = tools.drive_end[row, :3] = target
        tools.push[row, :3] = push

    def force(self) -> Vector:
        """Mean of what pulled it in the last step [N]."""
        return _vector(self._tools.drive_force[self._row])

    def show(self, fields: dict[str, npt.NDArray[Any]], target: Vector | None) -> None:
        """Writes it into a board's fields as the first hand."""
        place = self.place()
        write_hand(fields, 0, "ball", -1, target or place, place, self.force(), self._radius)


@final
class Node:
    """A node of a body, held at its ports; of a body with fewer axes the device's first ones count."""

    def __init__(self, grips: Grips, axes: int, node: int, rest: Vector) -> None:
        """Takes hold.

        Args:
            grips: one port with all axes, or one for each axis.
            axes: of the body.
            node: which, from 0.
            rest: its place at rest [m].
        """
        self._grips, self._axes = grips, axes
        self._node, self._rest = node, rest
        self._ports = range(grips.first, grips.last)
        self.position: Float | None = None  # of the copy's rows

    def place(self) -> Vector:
        """Displacement of the node [m]."""
        if self.position is None:
            return _NOWHERE
        grips, position = self._grips, self.position
        modal = grips.shape.shape[0] > 0
        rows = [grips.shape[p] @ position if modal else position[grips.row[p]] for p in self._ports]
        return self._spread(rows)

    def drive(self, stiffness: float, damping: float, target: Vector, push: Vector) -> None:
        """Sets what pulls it in the coming step."""
        grips, used = self._grips, self._axes if len(self._ports) == 1 else 1
        for axis, port in enumerate(self._ports):
            grips.stiffness[port], grips.damping[port] = stiffness, damping
            grips.start[port, :used] = grips.end[port, :used] = target[axis : axis + used]
            grips.push[port, :used] = push[axis : axis + used]

    def force(self) -> Vector:
        """Mean of what pulled it in the last step [N]."""
        return self._spread([self._grips.force[port] for port in self._ports])

    def show(self, fields: dict[str, npt.NDArray[Any]], target: Vector | None) -> None:
        """Writes it into a board's fields as the first hand."""
        place, axes = self.place(), self._axes
        there, here = _more(self._rest, target or place), _more(self._rest, place)
        write_hand(fields, 0, "hold", self._node, there[:axes], here[:axes], self.force()[:axes])

    def _spread(self, rows: list[Float]) -> Vector:
        values = rows[0][: self._axes].tolist() if len(rows) == 1 else [float(row[0]) for row in rows]
        x, y, z = (*values, 0.0, 0.0)[:3]
        return x, y, z


@final
class DeviceHand:
    """What a person does with a device; a `Hand` that the copy attaches to its position.

    Where the device is when it is heard first is where the proxy is then: nothing pulls at the start.
    """

    def __init__(self, at: Seat, *, link: ServoLink | None) -> None:
        """Takes the seat's first tool, or one that fits the body; what the file's hands do there is left out.

        Args:
            at: the copy.
            link: to the device; None: nobody holds it, for steps that nobody sees.

        Raises:
            ScenarioError: a tool is wrong.
        """
        scenario, body, model, seat = at.scenario, at.body, at.model, at.index
        self._link = link
        self._end = None if link is None else proxy_end(link.options)
        self._origin: Vector | None = None
        self._before = _NOWHERE
        self._target: Vector | None = None
        self._word = Word()
        self.nodes: list[int] = []
        self.grips = no_grips(model)
        self.surface: Surface | None = None
        self.tools: Tools | None = None
        self._touching: Touching | None = None
        self._seat, self._node = seat, None
        users = scenario.network.size
        table = _tool(scenario, body, seat)
        if table is not None:
            still = np.zeros((users, body.nodes, body.dimension))
            lengths = np.tile([at.period, at.longest], (users, 1))
            self._touching, _ = touching_of([table], users, body, model, lengths, start=still, ports=0)
            assert self._touching is not None
            self.surface = self._touching.surface
            self.tools = tools_of(self._touching, seat)
            self._held: Held = Ball(self.tools, table.radius)
            return
        node = _node(scenario, body, seat)
        hands, _ = ports_of([HandTable(user=seat + 1, node=node)], users, body, model)
        self.nodes = [node - 1 for _ in range(body.dimension if model.full else 1)]
        self.grips = no_grips(model, hands.row.tolist())._replace(
            first=int(hands.first[seat]), last=int(hands.first[seat + 1]), shape=hands.shape
        )
        x, y, z = (*body.rest[node - 1].tolist(), 0.0, 0.0)[:3]
        self._node = Node(self.grips, body.dimension, node - 1, (x, y, z))
        self._held = self._node

    def attach(self, position: Float) -> None:
        """Learns where the copy's rows are, as they move."""
        if self._node is not None:
            self._node.position = position

    def before(self, end: float, T: float) -> None:
        """Takes the newest of the device, and pulls the proxy towards it."""
        if self._touching is not None:
            before_step_alone(self._touching, self._seat, end, T)
        place = self._before = self._held.place()
        if self._link is None or self._end is None:
            self._held.drive(0.0, 1.0, place, _NOWHERE)
            return
        report: Report | None = self._link.read()
        wish, rate = None, _NOWHERE
        if report is not None:
            if self._origin is None:
                self._origin = _less(place, report.place)
            wish, rate, self._word = _more(report.place, self._origin), report.rate, report.word
        self._target = wish
        pull = self._end.pull(place, wish, rate, self._word, T)
        self._held.drive(pull.stiffness, pull.damping, pull.target, pull.push)

    def after(self) -> None:
        """Tells the device where the proxy went."""
        if self._link is None or self._end is None:
            return
        place = self._held.place()
        self._end.settle(self._held.force(), _less(place, self._before))
        self._link.order(None if self._origin is None else _less(place, self._origin), self._end.purse.word)

    def show(self, fields: dict[str, npt.NDArray[Any]]) -> None:
        """Writes into a board's fields where the device is, what it holds or pushes with, and what pulls that."""
        fields["hands"][()] = 1
        self._held.show(fields, self._target)


def _tool(scenario: Scenario, body: Body, seat: int) -> ToolTable | None:
    """The seat's tool without what moves it in the file, or one that fits; None where nodes are held."""
    for table in scenario.tools:
        if table.user == seat + 1:
            return table.model_copy(update={"hand": None, "device": None, "begin": 0.0, "release": None})
    if body.dimension != 3 or body.skin is None or not body.skin.triangles.size:
        return None
    low, high = body.rest.min(axis=0), body.rest.max(axis=0)
    radius = min(max(_SHARE * float((high - low).max()), _SMALLEST), _LARGEST)
    above = [0.5 * float(low[0] + high[0]), 0.5 * float(low[1] + high[1]), float(high[2]) + 1.5 * radius]
    return ToolTable(user=seat + 1, at=above, radius=radius, mass=_MASS, stiffness=_STIFFNESS)


def _node(scenario: Scenario, body: Body, seat: int) -> int:
    """The node, from 1, that the file's hand of this seat holds, or the one nearest to the middle."""
    for hand in scenario.hands:
        if hand.user == seat + 1:
            return hand.node
    middle = body.rest.mean(axis=0)
    return 1 + int(np.argmin(np.linalg.norm(body.rest - middle, axis=1)))


def _vector(row: Float) -> Vector:
    x, y, z = row[:3].tolist()
    return x, y, z


def _less(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _more(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
