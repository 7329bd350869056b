"""Faults of devices: what nobody behind a driver can see, samples that stand still while the device moves."""

import math
from typing import final

from cotouch.arrays import Float
from cotouch.errors import DeviceError
from cotouch.haptics import Device

# A device that says it moves must show it within this time; well below the 100 ms within which force must be gone [s].
PATIENCE = 0.04
# Slower than this a device may report the same place for long: one step of the encoder, 0.05 mm, takes 5 ms [m/s].
_MOVING = 0.01


def failed(device: Device, why: str) -> DeviceError:
    """Takes a device's force away; the error that says why.

    Args:
        device: that has a fault.
        why: a sentence.
    """
    device.stop()
    return DeviceError(why)


@final
class SampleWatch:
    """Looks at every sample of a device.

    A device that rests may well repeat its place to the last bit; so only a place that stays while the velocity says
    otherwise is a fault. Numbers that are none are handed on.

    Attributes:
        repeated: whether the last sample was the one before it, to the last bit.
    """

    __slots__ = ("_changed", "_position", "_velocity", "_what", "repeated")

    def __init__(self, what: str = "position") -> None:
        """Has seen nothing.

        Args:
            what: it looks at: position, or orientation with its velocity as that of an arc.
        """
        self._what = what
        self._position: tuple[float, ...] = (math.nan,) * 3
        self._velocity: tuple[float, ...] = (math.nan,) * 3
        self._changed = -math.inf
        self.repeated = False

    def fault(self, time: float, position: Float, velocity: Float) -> str | None:
        """What is wrong with a sample, as the end of a sentence; None if nothing is.

        Args:
            time: of the sample, monotonic [s].
            position: (3,) [m], or a quaternion (4,).
            velocity: (3,) [m/s].
        """
        place: tuple[float, ...] = tuple(position.tolist())
        rate: tuple[float, ...] = tuple(velocity.tolist())
        same = place == self._position
        self.repeated = same and rate == self._velocity
        if not same:
            self._changed = time
        self._position, self._velocity = place, rate
        if same and time - self._changed > PATIENCE and max(map(abs, rate)) > _MOVING:
            return f"repeats one {self._what} for {1e3 * (time - self._changed):.0f} ms while it reports motion"
        return None
