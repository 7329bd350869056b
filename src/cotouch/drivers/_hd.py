"""The functions of 3D Systems' OpenHaptics (libHD) that we use, as ctypes. Names, numbers and types are its own."""

import ctypes
import sys
from collections.abc import Callable
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_uint, c_ulong, c_ushort, c_void_p
from typing import Any, ClassVar, Final, final

from cotouch.drivers._library import Library
from cotouch.errors import DeviceError

SDK = Library(
    product="OpenHaptics (3D Systems)",
    linux=("libHD.so",),
    windows=("hd.dll", "HD.dll"),
    mac=(),
    variable="COTOUCH_OPENHAPTICS",
    install="OpenHaptics (3.4 or newer) and the Touch Device Driver (support.3dsystems.com)",
)
# hdDefines.h
POSITION, VELOCITY, TRANSFORM, BUTTONS = 0x2050, 0x2051, 0x2052, 0x2000
CURRENT_FORCE, MAX_FORCE, CONTINUOUS_FORCE = 0x2700, 0x2603, 0x2604
# Torques in mNm, of devices with six degrees of freedom that have motors only.
OUTPUT_DOF, CURRENT_TORQUE, MAX_TORQUE, CONTINUOUS_TORQUE = 0x2554, 0x2701, 0x2622, 0x2623
USABLE_WORKSPACE, MODEL, CALIBRATION_STYLE = 0x2551, 0x2501, 0x2555
FORCE_OUTPUT, FORCE_CLAMPING, FORCE_RAMPING, SOFTWARE_LIMIT = 0x4000, 0x4001, 0x4002, 0x4003
CALIBRATED, NEEDS_UPDATE, NEEDS_HAND = 0x5000, 0x5001, 0x5002
ENCODER_RESET, AUTO, INKWELL = 1 << 0, 1 << 1, 1 << 2
DONE, CONTINUE = 0, 1
WARM = 0x0200
_SAFETY = {
    0x0201: "the force was more than the device allows (0x201)",
    0x0202: "the force changed faster than the device allows (0x202)",
    0x0203: "it moved faster than it allows (0x203)",
}
_PRIORITY = 32767  # HD_DEFAULT_SCHEDULER_PRIORITY
_NOBODY = 0xFFFFFFFF  # HD_INVALID_HANDLE
_SERVO = ctypes.CFUNCTYPE if sys.platform != "win32" else ctypes.WINFUNCTYPE
CALLBACK: Final = _SERVO(c_uint, c_void_p)
"""HDSchedulerCallback."""


@final
class ErrorInfo(ctypes.Structure):
    """HDErrorInfo, which hdGetError returns by value."""

    _fields_: ClassVar = [("code", c_uint), ("internal", c_int), ("device", c_uint)]


_FUNCTIONS: dict[str, tuple[object, tuple[object, ...]]] = {
    "hdInitDevice": (c_uint, (c_char_p,)),
    "hdMakeCurrentDevice": (None, (c_uint,)),
    "hdDisableDevice": (None, (c_uint,)),
    "hdBeginFrame": (None, (c_uint,)),
    "hdEndFrame": (None, (c_uint,)),
    "hdEnable": (None, (c_uint,)),
    "hdDisable": (None, (c_uint,)),
    "hdGetError": (ErrorInfo, ()),
    "hdGetErrorString": (c_char_p, (c_uint,)),
    "hdGetString": (c_char_p, (c_uint,)),
    "hdGetDoublev": (None, (c_uint, POINTER(c_double))),
    "hdGetIntegerv": (None, (c_uint, POINTER(c_int))),
    "hdSetDoublev": (None, (c_uint, POINTER(c_double))),
    "hdCheckCalibration": (c_uint, ()),
    "hdUpdateCalibration": (None, (c_uint,)),
    "hdScheduleAsynchronous": (c_ulong, (CALLBACK, c_void_p, c_ushort)),
    "hdUnschedule": (None, (c_ulong,)),
    "hdStartScheduler": (None, ()),
    "hdStopScheduler": (None, ()),
}


@final
class Hd:
    """One device of OpenHaptics. What it calls an error raises `DeviceError`.

    Attributes:
        warm: whether the motors are too warm for full force.
    """

    def __init__(self, path: str | None, name: str | None) -> None:
        """Loads the library and starts a device, with its motors off.

        Args:
            path: of the library or its folder; None: see `SDK`.
            name: of the device, as set up with the vendor's tool; None: "Default Device".

        Raises:
            DeviceError: no library, or no such device.
        """
        library = SDK.load(path)
        self._call: dict[str, Callable[..., Any]] = {}
        for each, types in _FUNCTIONS.items():
            self._call[each] = SDK.bind(library, each, *types)
        self._three, self._sixteen, self._one = (c_double * 3)(), (c_double * 16)(), c_int()
        self._handle = 0
        self.warm = False
        shown = f'"{name}"' if name else "Default Device"
        self._device: int = self._call["hdInitDevice"](name.encode() if name else None)
        error = self._call["hdGetError"]()
        if error.code or self._device == _NOBODY:
            raise DeviceError(
                f"the 3D Systems device {shown} does not start: {self._text(error.code)}; connect it, switch it on, "
                "and set it up with the vendor's Touch Setup"
            )
        self._call["hdMakeCurrentDevice"](self._device)
        self._call["hdDisable"](FORCE_OUTPUT)
        for protection in (FORCE_CLAMPING, FORCE_RAMPING, SOFTWARE_LIMIT):
            self._call["hdEnable"](protection)

    def numbers(self, what: int, count: int) -> tuple[float, ...]:
        """Numbers of the device.

        Args:
            what: parameter of the vendor's library.
            count: how many there are.
        """
        values = (c_double * 16)()
        self._call["hdGetDoublev"](what, values)
        return tuple(values[:count])

    def model(self) -> str:
        """What it is called."""
        text = self._call["hdGetString"](MODEL)
        return text.decode(errors="replace") if text else "Touch"

    def start(self, callback: object) -> None:
        """Lets the library call back at every tick of its servo; who calls keeps the callback referenced."""
        self._handle = self._call["hdScheduleAsynchronous"](callback, None, _PRIORITY)
        self._call["hdStartScheduler"]()
        self.check()

    def halt(self) -> None:
        """Ends the callbacks and lets go of the device; never raises."""
        self._call["hdStopScheduler"]()
        self._call["hdUnschedule"](self._handle)
        self._call["hdDisableDevice"](self._device)

    def begin(self) -> None:
        """Begins the frame of a tick."""
        self._call["hdBeginFrame"](self._device)

    def end(self) -> None:
        """Ends the frame of a tick: the force goes out."""
        self._call["hdEndFrame"](self._device)

    def vector(self, what: int) -> tuple[float, float, float]:
        """Position, velocity or force, in the vendor's axes and units; within a frame."""
        self._call["hdGetDoublev"](what, self._three)
        x, y, z = self._three
        return x, y, z

    def transform(self) -> list[float]:
        """Of the stylus, 16 numbers by columns [mm]; within a frame."""
        self._call["hdGetDoublev"](TRANSFORM, self._sixteen)
        return list(self._sixteen)

    def integer(self, what: int) -> int:
        """A whole number of the device."""
        self._call["hdGetIntegerv"](what, byref(self._one))
        return self._one.value

    def set_force(self, x: float, y: float, z: float) -> None:
        """Of this frame, in the vendor's axes [N].

        Args:
            x: right.
            y: up.
            z: towards the user.
        """
        self._three[0], self._three[1], self._three[2] = x, y, z
        self._call["hdSetDoublev"](CURRENT_FORCE, self._three)

    def set_torque(self, x: float, y: float, z: float) -> None:
        """Of this frame about the tip, in the vendor's axes [Nm]; of a device that renders torques.

        Args:
            x: right.
            y: up.
            z: towards the user.
        """
        self._three[0], self._three[1], self._three[2] = 1e3 * x, 1e3 * y, 1e3 * z
        self._call["hdSetDoublev"](CURRENT_TORQUE, self._three)

    def enable(self, on: bool) -> None:
        """Motors follow, or not."""
        self._call["hdEnable" if on else "hdDisable"](FORCE_OUTPUT)

    def calibration(self) -> int:
        """CALIBRATED, NEEDS_UPDATE or NEEDS_HAND; within a frame."""
        return self._call["hdCheckCalibration"]()

    def style(self) -> int:
        """How this device is calibrated: AUTO, INKWELL or ENCODER_RESET, the first that it can; 0: none of these.

        The library tells all of them in one mask, and takes one.
        """
        styles = self.integer(CALIBRATION_STYLE)
        return next((style for style in (AUTO, INKWELL, ENCODER_RESET) if styles & style), 0)

    def calibrate(self, style: int) -> None:
        """Takes up the calibration in one way; see `style`."""
        self._call["hdUpdateCalibration"](style)

    def check(self) -> None:
        """Looks at all errors since the last look.

        Raises:
            DeviceError: one of them is more than warm motors.
        """
        self.warm = False
        while (code := self._call["hdGetError"]().code) != 0:
            if code != WARM:
                raise DeviceError(f"the 3D Systems device failed: {_SAFETY.get(code) or self._text(code)}")
            self.warm = True

    def _text(self, code: int) -> str:
        text = self._call["hdGetErrorString"](code)
        return f"{text.decode(errors='replace') if text else 'no reason given'} (0x{code:x})"
