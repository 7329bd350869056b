"""What every haptic device is to us, whoever made it."""

from dataclasses import dataclass
from enum import IntFlag
from typing import Protocol, final

from cotouch.arrays import Float
from cotouch.device import DeviceSpec


@final
class Flag(IntFlag):
    """What a device reports about itself in a cycle.

    Attributes:
        CALIBRATED: positions can be trusted.
        FORCE_ON: the motors follow.
        HELD: a hand is sensed; devices that cannot sense one never say so.
        LIMITED: the device applied less than it was told, or something else.
        LATE: the device did not answer in its time.
        STALE: the position is that of the cycle before, because nothing new came.
    """

    CALIBRATED = 1
    FORCE_ON = 2
    HELD = 4
    LIMITED = 8
    LATE = 16
    STALE = 32


_NONE = Flag(0)


@final
@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class DeviceReading:
    """What one cycle measured, in cotouch's frame: x forward, y left, z up, right-handed.

    Attributes:
        time: of the measurement, on a monotonic clock [s].
        position: of the tip, (3,) [m].
        velocity: of the tip, (3,) [m/s].
        force: that the motors really apply, (3,) [N]; NaN where the device does not say.
        buttons: bit n is button n.
        flags: see `Flag`.
        orientation: of the handle, quaternion xyzw; None where it is not measured.
        torque: that the motors really apply about the tip, (3,) [Nm]; None where the device does not say.
    """

    time: float
    position: Float
    velocity: Float
    force: Float
    buttons: int = 0
    flags: Flag = _NONE
    orientation: Float | None = None
    torque: Float | None = None


class Device(Protocol):
    """A device that a person holds.

    One thread calls all methods but `stop`, in the order open, calibrate, enable_force, exchange..., close. What goes
    wrong raises `DeviceError` with one sentence; after that only `stop` and `close` are called. A device without motors
    (`spec.actuated` is 0) takes any force and applies none.

    `exchange` may be called before `enable_force`, and after `stop` or `enable_force(False)`: the device measures, and
    whatever force it is given, its motors stay off until `enable_force` is called again. The origin of the frame is the
    middle of the workspace, that is, of the ball in `spec`.

    Attributes:
        spec: its limits.
    """

    @property
    def spec(self) -> DeviceSpec:
        """Limits; nominal before `open`, of the opened device afterwards where it tells them."""
        ...

    def open(self) -> None:
        """Connects; motors stay off.

        Raises:
            DeviceError: it is missing, busy, or its vendor's library is not installed; says what to do.
        """
        ...

    def calibrate(self, *, allow_motion: bool) -> None:
        """Makes positions absolute, if they are not.

        Args:
            allow_motion: whether the device may move by itself. If not, and it must, the error's sentence says what the
                user has to do by hand.

        Raises:
            DeviceError: it is not calibrated.
        """
        ...

    def enable_force(self, on: bool = True) -> None:
        """Lets the motors follow, from zero; or not.

        Args:
            on: whether they may.

        Raises:
            DeviceError: the device refuses.
        """
        ...

    def exchange(self, force: Float) -> DeviceReading:
        """One cycle: commands a force and measures.

        Blocks as long as the device's own cycle takes, never longer than the driver's time limit, which is at most
        20 ms. The force acts from here to the next call; the place is that at which it begins to act, as nearly as the
        device can tell. A measurement that is no number is handed on as it is: what follows makes it a fault.

        Args:
            force: on the hand, (3,) [N]; finite.

        Raises:
            DeviceError: a fault; motors are off or will be by the device's own watchdog.
        """
        ...

    def stop(self) -> None:
        """Takes all force away, now. From any thread, at any time, as often as one likes; never raises."""
        ...

    def close(self) -> None:
        """Stops and lets go of the device. May be called again; never raises."""
        ...


class TorqueDevice(Device, Protocol):
    """A device that also renders torque: `spec.torque` is above 0, and every reading has an orientation.

    Wherever `Device` speaks of force, it is force and torque: both are taken away together.
    """

    def exchange(self, force: Float, torque: Float | None = None) -> DeviceReading:
        """One cycle, as `Device.exchange`.

        Args:
            force: on the hand, (3,) [N]; finite.
            torque: on the hand about the tip, (3,) [Nm]; finite; None: none.

        Raises:
            DeviceError: a fault; motors are off or will be by the device's own watchdog.
        """
        ...


_MEMBERS = ("spec", "open", "calibrate", "enable_force", "exchange", "stop", "close")


def lacks(device: object) -> list[str]:
    """Members of `Device` that an object does not have.

    Args:
        device: that a driver made.
    """
    return [name for name in _MEMBERS if not hasattr(device, name)]
