"""What a device's spring pulls at: a ball that touches or holds a body, or a node of it."""

from collections.abc import Sequence
from typing import Any, Protocol, final

import numpy as np
import numpy.typing as npt

from cotouch.haptics import Vector
from cotouch.mechanics import Grips, Tools
from cotouch.session._told import write_hand

Float = npt.NDArray[np.float64]
_NOWHERE: Vector = (0.0, 0.0, 0.0)


class Grasped(Protocol):
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

    def show(self, fields: dict[str, npt.NDArray[Any]], k: int, target: Vector | None) -> None:
        """Writes it into a board's fields.

        Args:
            fields: see `view_fields`.
            k: as which hand, from 0.
            target: where the device is, as `place` says it [m]; None: nothing is known.
        """
        ...


@final
class Ball:
    """A tool: a sphere that touches the skin, or holds nodes."""

    def __init__(self, tools: Tools, k: int, radius: float) -> None:
        """The `k`-th of a seat's, from 0, with its radius [m]."""
        self._tools = tools
        self._row = tools.first + k
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

    def show(self, fields: dict[str, npt.NDArray[Any]], k: int, target: Vector | None) -> None:
        """Writes it into a board's fields."""
        place = self.place()
        write_hand(fields, k, "ball", -1, target or place, place, self.force(), self._radius)


@final
class Node:
    """A node of a body, held at its ports; of a body with fewer axes the device's first ones count."""

    def __init__(self, grips: Grips, axes: int, node: int, rest: Vector, ports: Sequence[int]) -> None:
        """Takes hold.

        Args:
            grips: the ports of all hands.
            axes: of the body.
            node: which, from 0.
            rest: its place at rest [m].
            ports: its own: one with all axes, or one for each axis.
        """
        self._grips, self._axes = grips, axes
        self._node, self._rest = node, rest
        self._ports = ports
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

    def show(self, fields: dict[str, npt.NDArray[Any]], k: int, target: Vector | None) -> None:
        """Writes it into a board's fields."""
        place, axes = self.place(), self._axes
        there, here = more(self._rest, target or place), more(self._rest, place)
        write_hand(fields, k, "hold", self._node, there[:axes], here[:axes], self.force()[:axes])

    def _spread(self, rows: list[Float]) -> Vector:
        values = rows[0][: self._axes].tolist() if len(rows) == 1 else [float(row[0]) for row in rows]
        x, y, z = (*values, 0.0, 0.0)[:3]
        return x, y, z


def more(a: Vector, b: Vector) -> Vector:
    """Sum [m]."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def _vector(row: Float) -> Vector:
    x, y, z = row[:3].tolist()
    return x, y, z
