"""3D Systems Touch through OpenHaptics: the library's own thread ticks, and every tick meets one exchange."""

import threading
import time
from collections.abc import Callable
from dataclasses import replace
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.device import PRESETS, DeviceSpec
from cotouch.drivers._hd import (
    BUTTONS,
    CALIBRATED,
    CALLBACK,
    CONTINUE,
    CONTINUOUS_FORCE,
    CONTINUOUS_TORQUE,
    DONE,
    ENCODER_RESET,
    MAX_FORCE,
    MAX_TORQUE,
    NEEDS_UPDATE,
    OUTPUT_DOF,
    POSITION,
    USABLE_WORKSPACE,
    VELOCITY,
    Hd,
)
from cotouch.drivers._rotation import quaternion_of
from cotouch.drivers._watch import SampleWatch, failed
from cotouch.errors import DeviceError
from cotouch.haptics import OPENHAPTICS_FRAME, DeviceReading, Flag

# A force that nobody renewed for so long is taken away by the tick itself [s].
_SILENCE = 0.02
# An exchange waits this long for a tick, then says LATE [s]; a library that does not tick for longer has failed [s].
_LATE, _LIMIT = 0.01, 0.05
# What a PHANToM Premium 6DOF can do about its weakest axis, along the stylus: nominal, by its data sheet but for
# stiffness and damping, which are those of other devices with motors in their wrist.
_WRIST = {
    "degrees_of_freedom": 6,
    "actuated": 6,
    "torque": 0.17,
    "continuous_torque": 0.048,
    "turning_stiffness": 1.0,
    "turning_damping": 0.07,
    "turning_resolution": 1.4e-4,
}
# Of what is asked of the ticking thread aside from forces, such as enabling motors [s].
_JOB = 0.1
_POLL = 0.05
# ctypes needs every callback referenced for as long as the library may call it, whatever becomes of its device.
_ALIVE: dict[int, object] = {}


@final
class Touch:
    """A 3D Systems Touch, Touch X or PHANToM. `cotouch.haptics.Device` says what its methods do.

    An exchange hands its force to the next tick and returns what that tick measured. What goes wrong in a tick makes
    the force zero and ends the ticking; the next exchange says why. After a force that nobody renewed in time a reading
    does not say FORCE_ON, so that it comes back by the ramp.
    """

    def __init__(
        self,
        name: str | None = None,
        *,
        library: str | None = None,
        hand_seconds: float = 20.0,
        reset: bool = False,
    ) -> None:
        """Loads nothing yet.

        Args:
            name: of the device, as set up with the vendor's tool; None: "Default Device".
            library: file or folder of libHD; None: $COTOUCH_OPENHAPTICS, or where the system looks.
            hand_seconds: to wait for a hand to put the stylus into the inkwell for calibration [s].
            reset: whether somebody holds the device in its reset position. Some have no other way to find their place:
                their encoders are set to zero where they are when it is calibrated.
        """
        self._name, self._library, self._patience, self._held = name, library, hand_seconds, reset
        self._spec = PRESETS["touch"]
        self._middle = np.zeros(3)
        self._hd: Hd | None = None
        self._callback: object = None
        self._met = threading.Condition()
        self._reset()

    def _reset(self) -> None:
        self._on = self._calibrated = False
        self._hushed = False  # a force that nobody renewed was taken away, and no reading has told so yet
        self._by_reset = False  # it is calibrated by a hand that holds it in its reset position
        self._force, self._torque = np.zeros(3), np.zeros(3)
        self._wrist = False  # it renders torques
        self._renewed = 0.0  # when a force came last
        self._ticks = 0
        self._ticked = time.monotonic()
        self._job: Callable[[Hd], None] | None = None
        self._reading: DeviceReading | None = None
        self._why: str | None = None
        self._ended = False
        self._watch = SampleWatch()

    @property
    def spec(self) -> DeviceSpec:
        """Limits; forces are those that the library tells once open."""
        return self._spec

    def open(self) -> None:
        """See `Device.open`."""
        self.close()
        hd = Hd(self._library, self._name)
        self._reset()
        self._hd = hd
        self._callback = CALLBACK(self._tick)
        _ALIVE[id(self._callback)] = self._callback
        try:
            most, lasting = hd.numbers(MAX_FORCE, 1)[0], hd.numbers(CONTINUOUS_FORCE, 1)[0]
            least = np.array(hd.numbers(USABLE_WORKSPACE, 6)).reshape(2, 3)
            self._wrist = hd.integer(OUTPUT_DOF) == 6
            twists = [1e-3 * hd.numbers(what, 1)[0] for what in (MAX_TORQUE, CONTINUOUS_TORQUE)] if self._wrist else []
            hd.check()
            if most > 0.0 and lasting > 0.0:
                self._spec = replace(
                    self._spec, name=f"3D Systems {hd.model()}", force=most, continuous_force=min(most, lasting)
                )
            if self._wrist:  # the library's numbers are taken where they are less
                self._spec = replace(self._spec, **_WRIST)
                torque, lasting = (
                    min(told, known) if told > 0.0 else known
                    for told, known in zip(twists, (self._spec.torque, self._spec.continuous_torque), strict=True)
                )
                self._spec = replace(self._spec, torque=torque, continuous_torque=min(torque, lasting))
            if np.isfinite(least).all():
                self._middle = OPENHAPTICS_FRAME.place(least.mean(axis=0))
            hd.start(self._callback)
            self._asked(self._look)
        except BaseException:
            self.close()
            raise

    def calibrate(self, *, allow_motion: bool) -> None:  # noqa: ARG002
        """See `Device.calibrate`. The device does not move by itself; a hand puts the stylus into the inkwell.

        One that can only have its encoders reset is held in its reset position by somebody who has said so.
        """
        end = time.monotonic() + self._patience
        while not self._calibrated:
            self._asked(self._take_up)
            if self._calibrated:
                return
            if self._by_reset:
                raise failed(
                    self,
                    f"the {self._spec.name} is not calibrated, and takes the place where it is held meanwhile for its "
                    "reset position; hold it there as its manual shows, and open it with the option reset=true",
                )
            if time.monotonic() > end:
                raise failed(self, f"the {self._spec.name} is not calibrated; put its stylus into the inkwell")
            time.sleep(_POLL)

    def enable_force(self, on: bool = True) -> None:
        """See `Device.enable_force`."""
        self._opened()
        if not on:
            self.stop()
            return
        with self._met:
            self._force, self._torque, self._renewed = np.zeros(3), np.zeros(3), time.monotonic()
            self._on = True
        self._asked(lambda device: device.enable(True))

    def exchange(self, force: Float, torque: Float | None = None) -> DeviceReading:
        """See `TorqueDevice.exchange`; only a device with motors in its wrist renders the torque.

        Args:
            force: on the hand [N].
            torque: on the hand about the tip [Nm].
        """
        self._opened()
        torque = np.zeros(3) if torque is None else torque
        if not (np.isfinite(force).all() and np.isfinite(torque).all()):
            raise failed(self, f"the {self._spec.name} was given a force that is not finite")
        with self._met:
            self._force, self._torque, self._renewed = force.copy(), torque.copy(), time.monotonic()
            before = self._ticks
            self._met.wait_for(lambda: self._ticks > before or self._ended, _LATE)
            why, late, last = self._why, self._ticks == before, self._reading
            if self._hushed and not late:
                # Until the next exchange, which knows of it.
                self._hushed, self._force, self._torque = False, np.zeros(3), np.zeros(3)
        if why is None and time.monotonic() - self._ticked > _LIMIT:
            why = f"the library of the {self._spec.name} no longer ticks; is its cable loose?"
        if why is not None or last is None:
            raise failed(self, why or f"the {self._spec.name} gave no sample")
        return replace(last, flags=last.flags | Flag.LATE | Flag.STALE) if late else last

    def stop(self) -> None:
        """See `Device.stop`."""
        self._on = False  # the next tick sets zero and switches the motors off, at most 1 ms from now
        hd = self._hd
        if hd is None or self._ended:
            return
        if not self._met.acquire(timeout=_SILENCE):
            hd.enable(False)
            return
        try:
            before = self._ticks
            # Two, as one may be under way with the force of before.
            if not self._met.wait_for(lambda: self._ticks > before + 1 or self._ended, _LATE):
                hd.enable(False)
        except Exception:  # noqa: BLE001  it never raises; what is left is to switch the motors off from here
            hd.enable(False)
        finally:
            self._met.release()

    def close(self) -> None:
        """See `Device.close`."""
        self.stop()
        hd, self._hd = self._hd, None
        if hd is not None:
            hd.halt()
            _ALIVE.pop(id(self._callback), None)
            self._callback = None

    def _tick(self, _data: int | None) -> int:
        """Called by the library's own thread, about 1,000 times a second."""
        hd = self._hd
        if hd is None or self._ended:
            return DONE
        try:
            self._frame(hd)
        except BaseException as error:  # noqa: BLE001  an exception that left would end the ticking silently
            self._why = str(error) if isinstance(error, DeviceError) else f"the servo failed: {error!r}"
            self._ended = True
            _without_force(hd, twists=self._wrist)
        with self._met:
            self._ticks += 1
            self._ticked = time.monotonic()
            self._met.notify_all()
        return DONE if self._ended else CONTINUE

    def _frame(self, hd: Hd) -> None:
        hd.begin()
        try:
            job, self._job = self._job, None
            if job is not None:
                job(hd)
            now = time.monotonic()
            position = OPENHAPTICS_FRAME.place(hd.vector(POSITION)) - self._middle
            velocity = OPENHAPTICS_FRAME.place(hd.vector(VELOCITY))
            orientation = OPENHAPTICS_FRAME.orientation(_quaternion(hd.transform()))
            buttons = hd.integer(BUTTONS)
            on, force, torque = self._on, self._force, self._torque
            pushes = bool(force.any() or torque.any())
            self._hushed |= on and pushes and now - self._renewed > _SILENCE
            follows = on and not self._hushed
            fraction, part = (
                _share(one, most) if follows else 0.0
                for one, most in ((force, self._spec.force), (torque, self._spec.torque if self._wrist else np.inf))
            )
            commanded, twisted = fraction * force, part * torque
            x, y, z = OPENHAPTICS_FRAME.back(commanded).tolist()
            hd.set_force(x, y, z)
            if self._wrist:
                x, y, z = OPENHAPTICS_FRAME.back(twisted).tolist()
                hd.set_torque(x, y, z)
            if not on:
                hd.enable(False)
        finally:
            hd.end()
        hd.check()
        why = self._watch.fault(now, position, velocity)
        if why is not None:
            raise DeviceError(f"the {self._spec.name} {why}")
        flags = Flag.CALIBRATED if self._calibrated else Flag(0)
        flags |= Flag.FORCE_ON if follows else Flag(0)
        flags |= Flag.LIMITED if hd.warm or (on and min(fraction, part) < 1.0) else Flag(0)
        self._reading = DeviceReading(
            time=now,
            position=position,
            velocity=velocity,
            force=commanded,
            buttons=buttons,
            flags=flags,
            orientation=orientation,
            torque=twisted if self._wrist else None,
        )

    def _look(self, hd: Hd) -> None:
        self._calibrated = hd.calibration() == CALIBRATED

    def _take_up(self, hd: Hd) -> None:
        needed, style = hd.calibration(), hd.style()
        self._by_reset = style == ENCODER_RESET
        if needed != CALIBRATED and (self._held if self._by_reset else needed == NEEDS_UPDATE):
            hd.calibrate(style)
        self._look(hd)

    def _asked(self, job: Callable[[Hd], None]) -> None:
        """Lets the next tick do something in its frame, and waits for it."""
        with self._met:
            self._job = job
            before = self._ticks
            done = self._met.wait_for(lambda: (self._job is None and self._ticks > before) or self._ended, _JOB)
        if self._why is not None or not done:
            raise failed(self, self._why or f"the library of the {self._spec.name} does not tick; is it connected?")

    def _opened(self) -> None:
        if self._hd is None:
            raise DeviceError(f"the {self._spec.name} is not open; open it first")


def _share(wanted: Float, most: float) -> float:
    """As much of it as is within a limit."""
    size = float(np.linalg.norm(wanted))
    return min(1.0, most / size) if size else 1.0


def _without_force(hd: Hd, *, twists: bool) -> None:
    """A frame with zero force and torque, then motors off, whatever the library thinks of it."""
    zero, limp = lambda: hd.set_force(0.0, 0.0, 0.0), lambda: hd.set_torque(0.0, 0.0, 0.0)
    for call in (hd.begin, zero, *((limp,) if twists else ()), hd.end, lambda: hd.enable(False)):
        try:
            call()
        except Exception:  # noqa: BLE001, S112  the next one may still help
            continue


def _quaternion(by_columns: list[float]) -> tuple[float, float, float, float]:
    """Rotation of a transform as xyzw, unit."""
    m00, m10, m20, _, m01, m11, m21, _, m02, m12, m22, *_ = by_columns
    return quaternion_of((m00, m01, m02, m10, m11, m12, m20, m21, m22))
