"""What holds a live copy: a hand on command, a ball that pushes, a device."""

from cotouch.hands._commanded_hand import CommandedHand, usual_stiffness
from cotouch.hands._device_hand import DeviceHand, DeviceWork

__all__ = [
    "CommandedHand",
    "DeviceHand",
    "DeviceWork",
    "usual_stiffness",
]
