"""Simulated haptic devices and hands, in continuous time under a sampled servo."""

from cotouch.device._advance import advance
from cotouch.device._assemble import assemble
from cotouch.device._models import CartesianPlant, Coupling, DeviceModel, PhantomPlant, Servo, SimulatedHand
from cotouch.device._spec import PRESETS, DeviceSpec, preset
from cotouch.device._tables import DEVICE_BOOKS, Devices, DeviceState, Grasps, Plants, Servos

__all__ = [
    "DEVICE_BOOKS",
    "PRESETS",
    "CartesianPlant",
    "Coupling",
    "DeviceModel",
    "DeviceSpec",
    "DeviceState",
    "Devices",
    "Grasps",
    "PhantomPlant",
    "Plants",
    "Servo",
    "Servos",
    "SimulatedHand",
    "advance",
    "assemble",
    "preset",
]
