"""A rigid tool that a device holds: its spring leads the handle, and springs of the file's turn the tool about that."""

from collections.abc import Sequence
from typing import final

import numpy as np

from cotouch.arrays import Array, Float
from cotouch.body import frame_of
from cotouch.hands._grasped import vector
from cotouch.hands._shown import write_hand
from cotouch.hands._turning import Turner, nearest_to, turned
from cotouch.haptics import Quaternion, Twist, Vector, back, product, turn_of
from cotouch.mechanics import Model, Ports
from cotouch.scenario import RigidTool, rows_of

# As a wrist turns: how fast a tool may [rad/s], how closely it follows [1/s], and how fast that changes [rad/s²].
_TURNING = {"speed": 20.0, "sharpness": 100.0, "rush": 2000.0}


@final
class GraspedTool:
    """A rigid tool, held by the port of its handle and those of the ways from there to the points of the file's hand.

    Forces of the latter only turn, so all that moves the handle is the device's coupling, which books it; what they put
    in is the hand's. They hold the orientation that the tool has, or lead it as the device turns from where it was
    heard first: no device feels that (`turn`). Of a device that renders torques they are the coupling's (`twist`).
    """

    def __init__(self, ports: Ports, own: Sequence[int], tool: RigidTool, model: Model) -> None:
        """Takes hold.

        Args:
            ports: the ports of all hands.
            own: its ports: of the handle, and of each way.
            tool: with a hand.
            model: of the body.
        """
        assert tool.hand is not None
        self._ports, self._handle, self._arms = ports, own[0], list(own[1:])
        shares = tool.shares.mean(axis=0)
        self._rest, self._rows, self._shares = tool.part.rest(), rows_of(tool.part, model), shares
        self._start = tool.handle
        self._arm_shares = tool.shares - shares
        self._ways = self._arm_shares @ self._rest
        self._upright = np.linalg.inv(frame_of(self._rest))
        # The points are alternate corners of a cube, so springs of all four are as stiff about every axis.
        self._square = float((self._ways**2).sum()) / 1.5
        self._from = self._ways
        self._seen: tuple[Float, Quaternion] | None = None  # where its masses were, and how it was turned there
        ports.stiffness[self._arms] = 0.25 * tool.hand.stiffness
        ports.damping[self._arms] = 0.25 * tool.hand.damping
        self._position: Float | None = None
        self._turner: Turner | None = None  # of the pose to which springs turn it
        self._frame: Quaternion | None = None  # from the device's orientation to that

    def attach(self, position: Float) -> None:
        """Learns where the copy's rows are, as they move."""
        self._position = position

    def place(self) -> Vector:
        """Of its handle [m]."""
        return vector(self._shares @ self._masses())

    def drive(self, stiffness: float, damping: float, target: Vector, push: Vector) -> None:
        """Sets what pulls its handle in the coming step.

        Args:
            stiffness: [N/m].
            damping: [Ns/m].
            target: where it is pulled to [m].
            push: force besides [N].
        """
        ports, port = self._ports, self._handle
        ports.stiffness[port], ports.damping[port] = stiffness, damping
        ports.start[port, :3] = ports.end[port, :3] = np.array(target) - self._start
        ports.push[port, :3] = push

    def turn(self, orientation: Quaternion | None, T: float) -> None:
        """Leads its orientation in the coming step.

        Args:
            orientation: of the device, quaternion xyzw; None: it stays as it is led now.
            T: length of the step [s].
        """
        if self._turner is None:
            self._turner = Turner()
            self._turner.put(self.orientation())
        ports, turner = self._ports, self._turner
        here = goal = turner.turn
        ports.start[self._arms, :3] = turned(here, self._ways) - self._ways
        if orientation is not None:
            if self._frame is None:
                self._frame = product(back(orientation), here)
            goal = product(orientation, self._frame)
        turner.move(goal, T, **_TURNING)
        ports.end[self._arms, :3] = turned(turner.turn, self._ways) - self._ways

    def orientation(self) -> Quaternion:
        """From its rest."""
        masses = self._masses()
        if self._seen is None or not np.array_equal(masses, self._seen[0]):  # it takes some 50 µs
            self._seen = masses, nearest_to(frame_of(masses) @ self._upright)
        return self._seen[1]

    def twist(self, twist: Twist) -> None:
        """Sets what turns it in the coming step.

        Args:
            twist: from its orientation.
        """
        ports, arms, square = self._ports, self._arms, self._square
        self._from = here = self._where()
        ports.stiffness[arms], ports.damping[arms] = twist.stiffness / square, twist.damping / square
        ports.start[arms, :3] = ports.end[arms, :3] = turned(turn_of(twist.turn), here) - self._ways
        x, y, z = twist.push
        ports.push[arms, :3] = here @ np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]) / square

    def twisted(self) -> float:
        """The work of what turned it in the last step [J]."""
        return float((self._ports.force[self._arms, :3] * (self._where() - self._from)).sum())

    def force(self) -> Vector:
        """Mean of what pulled its handle in the last step [N]."""
        return vector(self._ports.force[self._handle])

    def show(self, fields: dict[str, Array], k: int, target: Vector | None) -> None:
        """Writes it into a mailbox's fields.

        Args:
            fields: written to.
            k: entry of the fields.
            target: where it is pulled to [m].
        """
        place = self.place()
        write_hand(fields, k, "pose", -1, target or place, place, self.force())

    def _where(self) -> Float:
        """The ways from its handle, (4, 3) [m]."""
        return self._arm_shares @ self._masses()

    def _masses(self) -> Float:
        return self._rest if self._position is None else self._rest + self._position[self._rows, :3]
