"""What a device's spring pulls at: a ball that touches or holds a body, or a node of it; see `GraspedTool`, too."""

from collections.abc import Sequence
from typing import Protocol, final

from cotouch.arrays import Array, Float
from cotouch.hands._commanded_hand import write_hand
from cotouch.haptics import ZERO, Quaternion, Vector, plus
from cotouch.mechanics import Ports, Tools


class Grasped(Protocol):
    """What the device's spring pulls at."""

    def place(self) -> Vector:
        """Where it is [m]."""
        ...

    def drive(self, stiffness: float, damping: float, target: Vector, push: Vector) -> None:
        """Sets what pulls it in the coming step.

        Args:
            stiffness: [N/m].
            damping: [Ns/m].
            target: where it is pulled to [m].
            push: force besides [N].
        """
        ...

    def turn(self, orientation: Quaternion | None, T: float) -> None:
        """Is told how the device is turned in the coming step; what has no orientation of its own ignores it.

        Args:
            orientation: quaternion xyzw; None: nothing is known.
            T: length of the step [s].
        """
        ...

    def force(self) -> Vector:
        """Mean of what pulled it in the last step [N]."""
        ...

    def show(self, fields: dict[str, Array], k: int, target: Vector | None) -> None:
        """Writes it into a mailbox's fields.

        Args:
            fields: see `view_fields`.
            k: as which hand, from 0.
            target: where the device is, as `place` says it [m]; None: nothing is known.
        """
        ...


@final
class GraspedBall:
    """A tool: a sphere that touches the skin, or holds nodes."""

    def __init__(self, tools: Tools, k: int, radius: float) -> None:
        """The `k`-th of a slot's, from 0, with its radius [m]."""
        self._tools = tools
        self._row = k
        self._radius = radius

    def place(self) -> Vector:
        """Of its centre [m]."""
        return vector(self._tools.place[self._row])

    def drive(self, stiffness: float, damping: float, target: Vector, push: Vector) -> None:
        """Sets what pulls it in the coming step.

        Args:
            stiffness: [N/m].
            damping: [Ns/m].
            target: where it is pulled to [m].
            push: force besides [N].
        """
        tools, row = self._tools, self._row
        tools.drive_stiffness[row], tools.drive_damping[row] = stiffness, damping
        tools.drive_start[row, :3] = tools.drive_end[row, :3] = target
        tools.push[row, :3] = push

    def turn(self, orientation: Quaternion | None, T: float) -> None:
        """Is the same however the device is turned.

        Args:
            orientation: of the device.
            T: length of the step [s].
        """

    def force(self) -> Vector:
        """Mean of what pulled it in the last step [N]."""
        return vector(self._tools.drive_force[self._row])

    def show(self, fields: dict[str, Array], k: int, target: Vector | None) -> None:
        """Writes it into a mailbox's fields.

        Args:
            fields: written to.
            k: entry of the fields.
            target: where it is pulled to [m].
        """
        place = self.place()
        write_hand(fields, k, "ball", -1, target or place, place, self.force(), self._radius)


@final
class GraspedNode:
    """A node of a body, held at its ports; of a body with fewer axes the device's first ones count."""

    def __init__(self, ports: Ports, axes: int, node: int, rest: Vector, own_ports: Sequence[int]) -> None:
        """Takes hold.

        Args:
            ports: the ports of all hands.
            axes: of the body.
            node: which, from 0.
            rest: its place at rest [m].
            own_ports: its own: one with all axes, or one for each axis.
        """
        self._ports, self._axes = ports, axes
        self._node, self._rest = node, rest
        self._own_ports = own_ports
        self._position: Float | None = None

    def attach(self, position: Float) -> None:
        """Learns where the copy's rows are, as they move."""
        self._position = position

    def place(self) -> Vector:
        """Displacement of the node [m]."""
        if self._position is None:
            return ZERO
        ports, position = self._ports, self._position
        modal = ports.shape.shape[0] > 0
        rows = [ports.shape[p] @ position if modal else position[ports.row[p]] for p in self._own_ports]
        return self._spread(rows)

    def drive(self, stiffness: float, damping: float, target: Vector, push: Vector) -> None:
        """Sets what pulls it in the coming step.

        Args:
            stiffness: [N/m].
            damping: [Ns/m].
            target: where it is pulled to [m].
            push: force besides [N].
        """
        ports, used = self._ports, self._axes if len(self._own_ports) == 1 else 1
        for axis, port in enumerate(self._own_ports):
            ports.stiffness[port], ports.damping[port] = stiffness, damping
            ports.start[port, :used] = ports.end[port, :used] = target[axis : axis + used]
            ports.push[port, :used] = push[axis : axis + used]

    def turn(self, orientation: Quaternion | None, T: float) -> None:
        """Is the same however the device is turned.

        Args:
            orientation: of the device.
            T: length of the step [s].
        """

    def force(self) -> Vector:
        """Mean of what pulled it in the last step [N]."""
        return self._spread([self._ports.force[port] for port in self._own_ports])

    def show(self, fields: dict[str, Array], k: int, target: Vector | None) -> None:
        """Writes it into a mailbox's fields.

        Args:
            fields: written to.
            k: entry of the fields.
            target: where it is pulled to [m].
        """
        place, axes = self.place(), self._axes
        there, here = plus(self._rest, target or place), plus(self._rest, place)
        write_hand(fields, k, "hold", self._node, there[:axes], here[:axes], self.force()[:axes])

    def _spread(self, rows: list[Float]) -> Vector:
        values = rows[0][: self._axes].tolist() if len(rows) == 1 else [float(row[0]) for row in rows]
        x, y, z = (*values, 0.0, 0.0)[:3]
        return x, y, z


def vector(row: Float) -> Vector:
    """The first three of a row's numbers, (>= 3,)."""
    x, y, z = row[:3].tolist()
    return x, y, z
