"""A simulated handle that is turned: by a hand, and by motors whose torque is held from one exchange to the next."""

import math
from collections.abc import Sequence
from typing import final

from cotouch.haptics._port import less, plus
from cotouch.haptics._quaternions import UNTURNED, Quaternion, back, product, turn_of, vector_of
from cotouch.haptics._safety import ZERO, Vector, dot, multiple

# A ball-shaped handle, so that its angular momentum is along its spin [kg m²]; assumed.
_INERTIA = 1e-4
# Spring and damper of a hand that holds it loosely, and friction of bearings [Nm/rad, Nms/rad]; assumed.
_GRIP, _FLESH, _BEARINGS = 1.0, 0.02, 5e-4
# Length of a step within which torques are constant [s].
_STEP = 2e-4
# How long a hand takes to turn it to and fro [s].
ROUND = 4.0


@final
class Wrist:
    """A handle about its point.

    Attributes:
        time: to which it was moved [s].
        orientation: of the handle.
        spin: its angular velocity [rad/s].
        torque: of the motors, held [Nm].
        work: of the motors so far [J].
    """

    def __init__(self, *, turn: float, hand: bool) -> None:
        """At rest.

        Args:
            turn: how far a hand turns it to and fro about the upright [rad].
            hand: whether one holds it.
        """
        self.time = 0.0
        self.orientation: Quaternion = UNTURNED
        self.spin: Vector = ZERO
        self.torque: Vector = ZERO
        self.work = 0.0
        self._turn, self._hand = turn, hand

    def advance(self, time: float) -> None:
        """Moves on.

        Args:
            time: to which [s].
        """
        left = time - self.time
        self.time = time
        steps = math.ceil(left / _STEP - 1e-9)
        for n in range(steps):
            self._step(left / steps, time - left * (1.0 - (n + 1) / steps))

    def hand_turn(self, time: float) -> Quaternion:
        """How the hand would have it turned.

        Args:
            time: [s].
        """
        return turn_of((0.0, 0.0, self._turn * math.sin(2.0 * math.pi * time / ROUND)))

    def _step(self, T: float, end: float) -> None:
        grip, damping = 0.0, _BEARINGS
        led: Sequence[float] = ZERO
        if self._hand:
            grip, damping = _GRIP, _BEARINGS + _FLESH
            led = vector_of(product(self.hand_turn(end), back(self.orientation)))
        # Implicit in the damper and in the spring of a small turn.
        x, y, z = led
        pushed = plus(self.torque, (grip * x, grip * y, grip * z))
        gain = T / (_INERTIA + T * damping + T * T * grip)
        self.spin = plus(self.spin, multiple(gain, less(pushed, multiple(damping + T * grip, self.spin))))
        turned = multiple(T, self.spin)
        self.work += dot(self.torque, turned)
        self.orientation = product(turn_of(turned), self.orientation)
