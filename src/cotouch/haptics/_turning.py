"""The coupling of turning: both ends of the linear one's law, on three angles.

A handle is turned about its tip. Angles are taken as arcs at a radius of 50 mm, about as far as a hand reaches from the
middle of its grip, and torques as forces there. Work is the same, so every law, threshold and bound of places holds as
it stands. PSPM needs no more of a place than the work of a held force along it and the gap to the set position:

* the way of the device's end is the sum of its turns from tick to tick, each as a rotation vector. A held torque does
  the work torque · turn but for what it bends within a tick, at most ½ |torque| angle², which is charged as for levers;
* the gap is the rotation vector to the other end's orientation. It need not be the difference of two ways, and
  rotations do not commute: each end only sees to it that the spring of its gap holds no more than its tank has.
"""

from math import inf
from typing import NamedTuple, final

from cotouch.coupling import EnergyMessage
from cotouch.device import DeviceSpec
from cotouch.haptics._ends import DeviceEnd, EndOptions, ProxyEnd
from cotouch.haptics._measured import MeasuredMotion
from cotouch.haptics._port import less, plus
from cotouch.haptics._quaternions import Quaternion, back, product, turn_of, vector_of, way_back
from cotouch.haptics._safety import ZERO, Vector, multiple

# Radius at which angles are arcs, and torques forces [m].
ARM = 0.05


def at_arm(spec: DeviceSpec) -> DeviceSpec:
    """Limits of a device's turning as those of a position at the arm's end, without a workspace.

    Args:
        spec: of a device that renders torques.
    """
    square = ARM * ARM
    return DeviceSpec(
        name=spec.name,
        force=spec.torque / ARM,
        continuous_force=spec.continuous_torque / ARM,
        workspace=inf,
        stiffness=spec.turning_stiffness / square,
        damping=spec.turning_damping / square,
        resolution=spec.turning_resolution * ARM,
        rate=spec.rate,
        degrees_of_freedom=3,
        actuated=3,
        mass=0.0,
        friction=0.0,
        source=spec.source,
    )


@final
class TurningEnd:
    """The servo's end of turning: orientations in, torques out; internally arcs and forces at an arm.

    Attributes:
        end: the law's.
        seen: what measured orientations tell.
        orientation: of the handle as the law takes it, with less of its flicker at rest; None: never measured.
        wanted: force that the coupling wants [N].
        force: what acts next: as much of that as the safety chain left [N].
    """

    def __init__(self, options: EndOptions, *, resolution: float, most: float) -> None:
        """Relaxed.

        Args:
            options: of the coupling.
            resolution: of arcs [m].
            most: largest force that the safety chain lets through [N].
        """
        self.end = DeviceEnd(options, resolution=resolution, lever=ARM)
        self.seen = MeasuredMotion(most)
        self.orientation: Quaternion | None = None
        self.wanted = self.force = ZERO
        self._measured: Quaternion | None = None

    def measure(self, orientation: Quaternion, time: float, said: Vector | None, T: float, since: float) -> float:
        """Books the tick that has passed; the quickest of the last moments [m/s].

        Args:
            orientation: measured.
            time: of that [s].
            said: torque that the device says its motors have [Nm]; None: nothing.
            T: since the last cycle [s].
            since: since the last measurement [s].
        """
        before, way = self._measured, self.seen.place or ZERO
        if before is not None:
            x, y, z = vector_of(product(orientation, back(before)))
            way = plus(way, (ARM * x, ARM * y, ARM * z))
        self._measured = orientation
        self.seen.observe(way, T, self.force, self.end)
        self.end.measure(way, self.force, None if said is None else multiple(1.0 / ARM, said), since)
        taken = self.end.place or way
        self.orientation = product(turn_of(multiple(1.0 / ARM, less(taken, way))), orientation)
        return self.seen.quick(time, taken, way)

    def decide(self, goal: Quaternion | None, message: EnergyMessage, T: float) -> None:
        """What the coupling wants; after `measure`.

        Args:
            goal: orientation of the proxy in the device's frame; None: it is not to be followed.
            message: of the proxy's end.
            T: length of a tick [s].
        """
        here, place = self.orientation, self.end.place
        assert here is not None, "measure first"
        assert place is not None, "measure first"
        desired = None if goal is None else plus(place, multiple(ARM, way_back(goal, here)))
        self.wanted = self.end.decide(desired, self.seen.rate, message, T)

    @property
    def torque(self) -> Vector:
        """That acts next [Nm]."""
        return multiple(ARM, self.force)

    @property
    def spin(self) -> Vector:
        """Angular velocity over the window [rad/s]."""
        return multiple(1.0 / ARM, self.seen.rate)


class Twist(NamedTuple):
    """What turns a proxy in a step: `τ = k (turn - θ/2) - b ω + push`, where θ is its rotation in the step.

    Attributes:
        stiffness: k [Nm/rad].
        damping: b [Nms/rad].
        turn: from its orientation to the set one, as a rotation vector [rad].
        push: the damper's pull towards the device's angular velocity [Nm].
    """

    stiffness: float
    damping: float
    turn: Vector
    push: Vector


@final
class TurningProxyEnd(ProxyEnd):
    """The peer's end of turning; its options are at the arm."""

    def twist(self, here: Quaternion, goal: Quaternion | None, spin: Vector, message: EnergyMessage, T: float) -> Twist:
        """What turns the proxy in the coming step.

        Args:
            here: orientation of the proxy.
            goal: where the device would have it; None: nothing is known.
            spin: angular velocity of the device [rad/s].
            message: of the device's end.
            T: length of the step [s].
        """
        gap = None if goal is None else multiple(ARM, way_back(goal, here))
        pull = self.pull(ZERO, gap, multiple(ARM, spin), message, T)
        square = ARM * ARM
        return Twist(
            stiffness=square * pull.stiffness,
            damping=square * pull.damping,
            turn=multiple(1.0 / ARM, pull.target),
            push=multiple(ARM, pull.push),
        )
