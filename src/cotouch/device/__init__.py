"""Simulated haptic devices and hands, in continuous time under a sampled servo."""

from cotouch.device._advance import advance
from cotouch.device._assemble import assemble
from cotouch.device._couple import (
    Couplings,
    account_energy,
    command_device,
    couplings,
    excess_bound,
    pull_proxy,
    sure_force,
)
from cotouch.device._coupling_model import Coupling
from cotouch.device._critical import critical_stiffness, rings
from cotouch.device._installed import installed_coupling
from cotouch.device._models import CartesianPlant, DeviceModel, PhantomPlant, ServoModel, SimulatedHand
from cotouch.device._noticed import HAND_DAMPING, NOTICED, NOTICED_DRAG
from cotouch.device._path import path_place
from cotouch.device._simulated import DeviceSample, SimulatedDevice
from cotouch.device._spec import PRESETS, DeviceSpec, preset
from cotouch.device._tables import DEVICE_LEDGER, Devices, DeviceState

__all__ = [
    "DEVICE_LEDGER",
    "HAND_DAMPING",
    "NOTICED",
    "NOTICED_DRAG",
    "PRESETS",
    "CartesianPlant",
    "Coupling",
    "Couplings",
    "DeviceModel",
    "DeviceSample",
    "DeviceSpec",
    "DeviceState",
    "Devices",
    "PhantomPlant",
    "ServoModel",
    "SimulatedDevice",
    "SimulatedHand",
    "account_energy",
    "advance",
    "assemble",
    "command_device",
    "couplings",
    "critical_stiffness",
    "excess_bound",
    "installed_coupling",
    "path_place",
    "preset",
    "pull_proxy",
    "rings",
    "sure_force",
]
