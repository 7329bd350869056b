"""The functions of Force Dimension's SDK that we use, as ctypes: libdhd, and libdrd, which holds libdhd as well.

Names and types are those of `dhdc.h` (3.17) and `drdc.h`; `char ID` is always said.
"""

from ctypes import POINTER, byref, c_bool, c_byte, c_char_p, c_double, c_int, c_ubyte, c_uint
from typing import final

from cotouch.drivers._library import Library
from cotouch.errors import DeviceError

SDK = Library(
    product="Force Dimension",
    linux=("libdrd.so",),
    windows=("drd64.dll", "drd.dll"),
    mac=("libdrd.dylib",),
    variable="COTOUCH_FORCE_DIMENSION",
    install="the Force Dimension SDK (3.16 or newer, www.forcedimension.com/software/sdk)",
)
# Return codes that are not errors.
TIME_GUARD, SATURATED = 1, 2
# Fields of dhdGetStatus, and how many there are.
_POWER, _CONNECTED, _FORCE, _BRAKE, _CAUSE, _COUNT = 0, 1, 5, 6, 14, 17
BUTTON, WATCHDOG, DEADMAN = 1, 3, 6
"""Causes by which a device takes its forces away in ordinary use; see `CAUSES`."""
CAUSES = {
    1: "its button or foot switch",
    2: "it was too fast",
    3: "no force command arrived in time (watchdog)",
    4: "a program",
    5: "its USB cable is gone",
    6: "nobody held it",
}
"""In words, as the end of a sentence."""
_UNPLUGGED = 5
_D3 = (POINTER(c_double),) * 3
_FUNCTIONS: dict[str, tuple[object, tuple[object, ...]]] = {
    "dhdErrorGetLastStr": (c_char_p, ()),
    "dhdGetDeviceCount": (c_int, ()),
    "dhdGetSystemType": (c_int, (c_byte,)),
    "dhdEnableForce": (c_int, (c_ubyte, c_byte)),
    "dhdGetPosition": (c_int, (*_D3, c_byte)),
    "dhdGetLinearVelocity": (c_int, (*_D3, c_byte)),
    "dhdGetForce": (c_int, (*_D3, c_byte)),
    "dhdSetForce": (c_int, (c_double, c_double, c_double, c_byte)),
    "dhdHasActiveWrist": (c_bool, (c_byte,)),
    "dhdGetOrientationFrame": (c_int, (POINTER(c_double), c_byte)),
    "dhdGetAngularVelocityRad": (c_int, (*_D3, c_byte)),
    "dhdGetForceAndTorque": (c_int, (*_D3, *_D3, c_byte)),
    "dhdSetForceAndTorque": (c_int, (*(c_double,) * 6, c_byte)),
    "dhdSetMaxTorque": (c_int, (c_double, c_byte)),
    "dhdGetButtonMask": (c_uint, (c_byte,)),
    "dhdEmulateButton": (c_int, (c_ubyte, c_byte)),
    "dhdGetStatus": (c_int, (POINTER(c_int * _COUNT), c_byte)),
    "dhdSetMaxForce": (c_int, (c_double, c_byte)),
    "dhdSetGravityCompensation": (c_int, (c_int, c_byte)),
    "dhdWaitForReset": (c_int, (c_int, c_byte)),
    "dhdEnableExpertMode": (c_int, ()),
    "dhdDisableExpertMode": (c_int, ()),
    "dhdSetWatchdog": (c_int, (c_ubyte, c_byte)),
    "dhdSetVelocityThreshold": (c_int, (c_uint, c_byte)),
    "dhdGetVelocityThreshold": (c_int, (POINTER(c_uint), c_byte)),
    "dhdStop": (c_int, (c_byte,)),
    "drdOpenID": (c_int, (c_byte,)),
    "drdIsInitialized": (c_bool, (c_byte,)),
    "drdAutoInit": (c_int, (c_byte,)),
    "drdStop": (c_int, (c_bool, c_byte)),
    "drdClose": (c_int, (c_byte,)),
}
Triple = tuple[float, float, float]


def count(path: str | None = None) -> int:
    """How many devices the SDK finds.

    Raises:
        DeviceError: there is no SDK.
    """
    library = SDK.load(path)
    return max(0, SDK.bind(library, "dhdGetDeviceCount", c_int, ())())


@final
class Dhd:
    """One opened device of the SDK. What the SDK calls an error raises `DeviceError` with its own words.

    Attributes:
        wrist: whether it has motors that turn its handle; torques are set together with forces, if only to zero.
    """

    def __init__(self, path: str | None, index: int) -> None:
        """Loads the library and opens a device.

        Args:
            path: of the library or its folder; None: see `SDK`.
            index: of the device, from 0, in the SDK's order.

        Raises:
            DeviceError: no library, or no such device.
        """
        library = SDK.load(path)
        self._call = {name: SDK.bind(library, name, *types) for name, types in _FUNCTIONS.items()}
        self._id = -1
        count = self._call["dhdGetDeviceCount"]()
        if count <= index:
            raise DeviceError(
                f"Force Dimension's SDK finds {max(count, 0)} devices, so none has the number {index}; connect it, "
                "switch it on, and see that you may open USB devices (udev rules of the SDK)"
            )
        opened = self._call["drdOpenID"](index)
        if opened < 0:
            raise DeviceError(f"the Force Dimension device {index} cannot be opened: {self._said()}")
        self._index, self._id = index, opened  # what every other call must name, whatever the order of devices is
        self._a, self._b, self._c = c_double(), c_double(), c_double()
        self._three = (byref(self._a), byref(self._b), byref(self._c))
        self._turning = (c_double(), c_double(), c_double())
        self._six = (*self._three, *(byref(one) for one in self._turning))
        self._frame = (c_double * 9)()
        self._code = 0
        self.wrist = bool(self._call["dhdHasActiveWrist"](self._id))
        self._status = (c_int * _COUNT)()

    def system(self) -> int:
        """What kind of device it is; see `SYSTEMS`."""
        return self._asked("dhdGetSystemType")

    def initialized(self) -> bool:
        """Whether positions are absolute."""
        return bool(self._call["drdIsInitialized"](self._id))

    def auto_init(self) -> None:
        """Lets the device move to where it knows its place, and ends the SDK's own regulation."""
        self._asked("drdAutoInit")
        self._asked("drdStop", True)

    def wait_for_reset(self, milliseconds: int) -> None:
        """Waits until the user has put the handle into its rest."""
        self._asked("dhdWaitForReset", milliseconds)

    def protect(self, *, force: float, torque: float, watchdog: int) -> bool:
        """Arms what the device itself can do for safety.

        Args:
            force: that the SDK may ask of it [N].
            torque: likewise, of one with a wrist [Nm].
            watchdog: after which it takes forces away by itself, in units of 125 µs, 1 to 255.

        Returns:
            Whether it has a watchdog.
        """
        self._asked("dhdSetMaxForce", force)
        if self.wrist:
            self._asked("dhdSetMaxTorque", torque)
        self._asked("dhdSetGravityCompensation", 1)
        if self._call["dhdEnableExpertMode"]() < 0:
            return False
        try:
            return self._call["dhdSetWatchdog"](watchdog, self._id) >= 0
        finally:
            self._call["dhdDisableExpertMode"]()

    def limit_velocity(self, threshold: int) -> None:
        """Sets the velocity at which the device brakes, in the unit of its firmware; only downwards."""
        now = c_uint()
        self._asked("dhdEnableExpertMode", device=False)
        try:
            self._asked("dhdGetVelocityThreshold", byref(now))
            if not 0 < threshold <= now.value:
                raise DeviceError(
                    f"the velocity threshold is {threshold}; it must be from 1 to {now.value}, what the device came "
                    "with"
                )
            self._asked("dhdSetVelocityThreshold", threshold)
        finally:
            self._call["dhdDisableExpertMode"]()

    def enable_force(self, on: bool) -> None:
        """Motors follow, or brake."""
        self._asked("dhdEnableForce", 1 if on else 0)

    def position(self) -> tuple[Triple, int]:
        """In the vendor's axes [m]; and 0, or TIME_GUARD where it is that of before."""
        place = self._vector("dhdGetPosition")
        return place, self._code

    def velocity(self) -> Triple:
        """In the vendor's axes [m/s]."""
        return self._vector("dhdGetLinearVelocity")

    def orientation(self) -> tuple[float, ...]:
        """Of the handle: a rotation matrix in the vendor's axes, 9 numbers by rows."""
        if self._call["dhdGetOrientationFrame"](self._frame, self._id) < 0:
            raise self._error("dhdGetOrientationFrame")
        return tuple(self._frame)

    def spin(self) -> Triple:
        """Angular velocity of the handle in the vendor's axes [rad/s]."""
        return self._vector("dhdGetAngularVelocityRad")

    def applied(self) -> tuple[Triple, Triple]:
        """What the motors apply, in the vendor's axes: force [N] and torque [Nm], which is 0 without a wrist."""
        if not self.wrist:
            return self._vector("dhdGetForce"), (0.0, 0.0, 0.0)
        if self._call["dhdGetForceAndTorque"](*self._six, self._id) < 0:
            raise self._error("dhdGetForceAndTorque")
        a, b, c = self._turning
        return (self._a.value, self._b.value, self._c.value), (a.value, b.value, c.value)

    def set_force(self, force: Triple, torque: Triple = (0.0, 0.0, 0.0)) -> int:
        """Sets force and torque; returns 0, TIME_GUARD or SATURATED.

        Args:
            force: in the vendor's axes [N].
            torque: likewise; without a wrist it has no effect [Nm].
        """
        name = "dhdSetForceAndTorque" if self.wrist else "dhdSetForce"
        code = self._call[name](*force, *(torque if self.wrist else ()), self._id)
        if code < 0:
            raise self._error(name)
        return code

    def buttons(self) -> int:
        """Bit n is button n."""
        return self._call["dhdGetButtonMask"](self._id)

    def emulate_button(self) -> bool:
        """Lets a gripper that is closed be button 0; whether the device has such a gripper."""
        return self._call["dhdEmulateButton"](1, self._id) >= 0

    def why_off(self) -> int | None:
        """Why the device took its forces away by itself, as one of `CAUSES` or 0 for none said; None if it did not.

        Raises:
            DeviceError: it cannot be asked, its cable is gone, or it has no power.
        """
        if self._call["dhdGetStatus"](byref(self._status), self._id) < 0:
            raise self._error("dhdGetStatus")
        for field, why in ((_CONNECTED, CAUSES[_UNPLUGGED]), (_POWER, "it has no power")):
            if not self._status[field]:
                raise DeviceError(f"the Force Dimension device {self._index} switched its forces off by itself: {why}")
        if self._status[_FORCE] and not self._status[_BRAKE]:
            return None
        return self._status[_CAUSE]

    def stop(self) -> None:
        """Zero force and torque, then brakes."""
        try:
            self.set_force((0.0, 0.0, 0.0))
        finally:
            self._call["dhdStop"](self._id)

    def close(self) -> None:
        """Lets go of it; never raises."""
        self._call["drdClose"](self._id)

    def _vector(self, name: str) -> Triple:
        self._code = self._call[name](*self._three, self._id)
        if self._code < 0:
            raise self._error(name)
        return self._a.value, self._b.value, self._c.value

    def _asked(self, name: str, *arguments: object, device: bool = True) -> int:
        answer = self._call[name](*arguments, self._id) if device else self._call[name](*arguments)
        if answer < 0:
            raise self._error(name)
        return answer

    def _error(self, name: str) -> DeviceError:
        return DeviceError(f"the Force Dimension device {self._index} failed: {self._said()} ({name})")

    def _said(self) -> str:
        text = self._call["dhdErrorGetLastStr"]()
        return text.decode(errors="replace") if text else "the SDK does not say why"
