"""Devices that are held in a hand: what they have in common, and the loop that holds them safely."""

from cotouch.haptics._device import Device, DeviceReading, Flag

__all__ = ["Device", "DeviceReading", "Flag"]
