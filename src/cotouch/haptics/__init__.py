"""Haptic devices: their common interface, and the servo that runs them safely."""

from cotouch.haptics._conformance import CheckResult, conform
from cotouch.haptics._core import Order, ServoCore, ServoReport
from cotouch.haptics._coupling import COUPLING, LEAST_SCALE, MOST_SCALE, CouplingChoice, Scale, coupling_of
from cotouch.haptics._device import Device, DeviceReading, Flag, TorqueDevice
from cotouch.haptics._ends import DeviceEnd, EndOptions, ProxyEnd, checked
from cotouch.haptics._frames import (
    FORCE_DIMENSION_FRAME,
    FRAMES,
    HAPLY_FRAME,
    OPENHAPTICS_FRAME,
    OPENXR_FRAME,
    DeviceFrame,
)
from cotouch.haptics._limits import SafetyLimits
from cotouch.haptics._link import ServoLink
from cotouch.haptics._port import less, plus
from cotouch.haptics._quaternions import UNTURNED, Quaternion, back, product, turn_of, vector_of
from cotouch.haptics._registry import (
    GROUP,
    DeviceChoice,
    Driver,
    Option,
    device_names,
    driver,
    make_device,
    open_device,
)
from cotouch.haptics._safety import (
    ZERO,
    Cause,
    Heat,
    Observation,
    SafetyChain,
    Vector,
    multiple,
    norm,
    reasons,
    saturate,
    silence,
    slew,
    spoken,
)
from cotouch.haptics._servo import Servo
from cotouch.haptics._settings import ServoSettings
from cotouch.haptics._simulated import SIMULATED, SimulatedOnClock, simulated_model
from cotouch.haptics._turning import ARM, TurningEnd, TurningProxyEnd, Twist, at_arm
from cotouch.haptics._virtual import checked_virtual, virtual_limit
from cotouch.haptics._warning_log import priority_refused

__all__ = [
    "ARM",
    "COUPLING",
    "FORCE_DIMENSION_FRAME",
    "FRAMES",
    "GROUP",
    "HAPLY_FRAME",
    "LEAST_SCALE",
    "MOST_SCALE",
    "OPENHAPTICS_FRAME",
    "OPENXR_FRAME",
    "SIMULATED",
    "UNTURNED",
    "ZERO",
    "Cause",
    "CheckResult",
    "CouplingChoice",
    "Device",
    "DeviceChoice",
    "DeviceEnd",
    "DeviceFrame",
    "DeviceReading",
    "Driver",
    "EndOptions",
    "Flag",
    "Heat",
    "Observation",
    "Option",
    "Order",
    "ProxyEnd",
    "Quaternion",
    "SafetyChain",
    "SafetyLimits",
    "Scale",
    "Servo",
    "ServoCore",
    "ServoLink",
    "ServoReport",
    "ServoSettings",
    "SimulatedOnClock",
    "TorqueDevice",
    "TurningEnd",
    "TurningProxyEnd",
    "Twist",
    "Vector",
    "at_arm",
    "back",
    "checked",
    "checked_virtual",
    "conform",
    "coupling_of",
    "device_names",
    "driver",
    "less",
    "make_device",
    "multiple",
    "norm",
    "open_device",
    "plus",
    "priority_refused",
    "product",
    "reasons",
    "saturate",
    "silence",
    "simulated_model",
    "slew",
    "spoken",
    "turn_of",
    "vector_of",
    "virtual_limit",
]
