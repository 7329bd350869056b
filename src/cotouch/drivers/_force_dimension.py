"""Force Dimension's omega, delta, sigma and lambda, and the Falcon, which their SDK drives as well."""

import contextlib
import threading
import time
from dataclasses import replace
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.device import DeviceSpec
from cotouch.drivers._dhd import BUTTON, CAUSES, DEADMAN, SATURATED, TIME_GUARD, WATCHDOG, Dhd
from cotouch.drivers._dhd_systems import SPECS, SYSTEMS, UNKNOWN, with_wrist
from cotouch.drivers._rotation import quaternion_of
from cotouch.drivers._watch import SampleWatch, failed
from cotouch.errors import DeviceError
from cotouch.haptics import ARM, FORCE_DIMENSION_FRAME, DeviceReading, Flag

# For a hand to put the handle into its rest.
_RESET_MS = 20_000
# A cycle that takes longer has no force, as the firmware's watchdog has taken it away or is about to; where that was
# only a busy machine, the next one is in time again, and two in a row are a fault [s].
_LIMIT = 0.03
# Longer than this is late [s].
_LATE = 0.005
# The device's own reason is asked for every so many cycles: it costs another exchange with the device.
_ASK_EVERY = 10
# A hand, or a pause; any other reason is a fault.
_BY_HAND = frozenset({BUTTON, DEADMAN})
_ORDINARY = _BY_HAND | {WATCHDOG}


@final
class ForceDimension:
    """A device of Force Dimension. `cotouch.haptics.Device` says what its methods do.

    The force is set in every cycle, zero as well, because the SDK compensates gravity only then. If the SDK says that
    the motors cannot do what they were told, the reading is flagged LIMITED. A device with motors in its wrist renders
    torques as well, and tells its orientation.

    What takes the force away in ordinary use is no fault: readings do not say FORCE_ON meanwhile, and the motors have
    zero. After a pause that was too long for the watchdog they are switched on again from here. Where a hand did it, by
    the force button or by letting go of a handle that senses one, the device itself gives the force back.
    """

    def __init__(
        self,
        index: int = 0,
        *,
        family: str | None = None,
        library: str | None = None,
        watchdog: float = 0.02,
        velocity_threshold: int | None = None,
        reset_seconds: float = 0.001 * _RESET_MS,
    ) -> None:
        """Loads nothing yet.

        Args:
            index: of the device, from 0, in the SDK's order.
            family: omega, delta, sigma, lambda or falcon; another device is refused. None: whatever is there.
            library: file or folder of libdrd; None: $COTOUCH_FORCE_DIMENSION, or where the system looks.
            watchdog: silence after which the device takes forces away by itself, 0.001 to 0.03 [s].
            velocity_threshold: at which the device brakes, in the unit of its firmware; None: as it is.
            reset_seconds: to wait for a hand to put the handle into its rest, if the device may not move by itself [s].

        Raises:
            DeviceError: an option is out of range.
        """
        if not 0.001 <= watchdog <= 0.03:
            raise DeviceError(f"the watchdog is {watchdog:g} s; it must be from 0.001 to 0.03 s")
        self._index, self._library, self._family = index, library, family
        self._ticks, self._silence = max(1, round(watchdog / 125e-6)), watchdog
        self._threshold, self._reset = velocity_threshold, reset_seconds
        self._spec = SPECS[family or "omega"]
        self._dhd: Dhd | None = None
        self._lock = threading.Lock()  # what is set after stop() is zero
        self._on = False
        self._off: int | None = None  # why the device took its forces away; None: it did not, as far as is known
        self._middle = np.zeros(3)
        self._applied, self._twisted = np.zeros(3), np.zeros(3)
        self._cycle = 0
        self._began = 0.0
        self._slow = False  # the last cycle took too long
        self._watch, self._turning_watch = SampleWatch(), SampleWatch("orientation")
        self.watchdog = False
        """Whether the opened device has a watchdog."""

    @property
    def spec(self) -> DeviceSpec:
        """Limits, nominal, of the family that the SDK reports once open."""
        return self._spec

    def open(self) -> None:
        """See `Device.open`."""
        self.close()
        dhd = Dhd(self._library, self._index)
        self._dhd, self._cycle, self._off, self._slow = dhd, 0, None, False
        self._watch, self._turning_watch = SampleWatch(), SampleWatch("orientation")
        try:
            dhd.enable_force(False)
            family, product, middle, gripper = SYSTEMS.get(dhd.system(), UNKNOWN)
            _check_family(self._index, family, product, self._family)
            self._middle = FORCE_DIMENSION_FRAME.place(middle)
            self._spec = replace(
                SPECS[family], name=f"{'Novint' if family == 'falcon' else 'Force Dimension'} {product}"
            )
            if dhd.wrist:
                self._spec = with_wrist(self._spec, family)
            if gripper:
                dhd.emulate_button()
            self.watchdog = dhd.protect(force=self._spec.force, torque=self._spec.torque, watchdog=self._ticks)
            if self._threshold is not None:
                dhd.limit_velocity(self._threshold)
        except BaseException:
            self.close()
            raise

    def calibrate(self, *, allow_motion: bool) -> None:
        """See `Device.calibrate`. With motion the device finds its place by itself; without, a hand puts it to rest."""
        dhd = self._opened()
        if dhd.initialized():
            return
        try:
            if allow_motion:
                dhd.auto_init()
                dhd.enable_force(False)  # finding its place leaves them on
            else:
                dhd.wait_for_reset(max(1, int(1e3 * self._reset)))
        except DeviceError as error:
            hint = "keep clear of it" if allow_motion else "put its handle into its rest, or allow it to move by itself"
            raise failed(self, f"{self._spec.name} is not calibrated; {hint}: {error}") from None
        if not dhd.initialized():
            raise failed(self, f"{self._spec.name} is still not calibrated after trying; switch it off and on")

    def enable_force(self, on: bool = True) -> None:
        """See `Device.enable_force`."""
        dhd = self._opened()
        if not on:
            self.stop()
            return
        with self._lock:
            if not self._on or self._off not in _BY_HAND:  # what a hand took, a hand gives back
                self._switch_on(dhd)
            self._on = True

    def _switch_on(self, dhd: Dhd) -> None:
        """From zero, whatever the device was told before."""
        dhd.set_force((0.0, 0.0, 0.0))
        dhd.enable_force(True)
        dhd.set_force((0.0, 0.0, 0.0))
        self._off = None

    def exchange(self, force: Float, torque: Float | None = None) -> DeviceReading:
        """See `TorqueDevice.exchange`; only a device with motors in its wrist renders the torque.

        Args:
            force: on the hand [N].
            torque: on the hand about the tip [Nm].
        """
        dhd = self._opened()
        torque = np.zeros(3) if torque is None else torque
        if not (np.isfinite(force).all() and np.isfinite(torque).all()):
            raise failed(self, f"{self._spec.name} was given a force that is not finite")
        began, before = time.monotonic(), self._began
        self._began = began
        try:
            place, guarded = dhd.position()
            position, velocity = (
                FORCE_DIMENSION_FRAME.place(place) - self._middle,
                FORCE_DIMENSION_FRAME.place(dhd.velocity()),
            )
            orientation, spin = self._turned(dhd)
            at = time.monotonic()
            why = self._watch.fault(at, position, velocity)
            if orientation is not None:
                why = why or self._turning_watch.fault(at, orientation, ARM * spin)
            self._look(dhd, paused=began - before > 0.5 * self._silence)
            if why is not None or at - began > _LIMIT:
                force = torque = np.zeros(3)
            on, code = self._set(dhd, force, torque)
            buttons = dhd.buttons()
            calibrated = dhd.initialized()
        except DeviceError as error:
            raise failed(self, str(error)) from None
        took = time.monotonic() - began
        slow, self._slow = self._slow, took > _LIMIT
        if why is None and slow and self._slow:
            why = f"took {1e3 * took:.0f} ms for a cycle, the second in a row of more than {1e3 * _LIMIT:.0f} ms"
        if why is not None:
            raise failed(self, f"{self._spec.name} {why}")
        flags = Flag.CALIBRATED if calibrated else Flag(0)
        flags |= Flag.FORCE_ON if on and not self._slow else Flag(0)
        flags |= Flag.LIMITED if code else Flag(0)
        flags |= Flag.LATE if took > _LATE else Flag(0)
        flags |= Flag.STALE if guarded == TIME_GUARD else Flag(0)
        return DeviceReading(
            time=at,
            position=position,
            velocity=velocity,
            force=self._applied.copy(),
            buttons=buttons,
            flags=flags,
            orientation=orientation,
            torque=self._twisted.copy() if dhd.wrist else None,
        )

    def stop(self) -> None:
        """See `Device.stop`."""
        self._on = False
        dhd = self._dhd
        if dhd is None:
            return
        held = self._lock.acquire(timeout=0.02)  # a call that hangs must not keep the brakes from being put on
        try:
            with contextlib.suppress(Exception):
                dhd.stop()
        finally:
            if held:
                self._lock.release()

    def close(self) -> None:
        """See `Device.close`."""
        self.stop()
        dhd, self._dhd = self._dhd, None
        if dhd is not None:
            with contextlib.suppress(Exception):
                dhd.close()

    def _turned(self, dhd: Dhd) -> tuple[Float | None, Float]:
        """Orientation of the handle and its angular velocity [rad/s]; None without motors in the wrist."""
        if not dhd.wrist:
            return None, np.zeros(3)
        return FORCE_DIMENSION_FRAME.orientation(quaternion_of(dhd.orientation())), FORCE_DIMENSION_FRAME.direction(
            dhd.spin()
        )

    def _set(self, dhd: Dhd, force: Float, torque: Float) -> tuple[bool, int]:
        """Sets force and torque; whether motors follow, and what the SDK said."""
        with self._lock:
            on = self._on and self._off is None
            if not on:
                force = torque = np.zeros(3)
            x, y, z = FORCE_DIMENSION_FRAME.back(force).tolist()
            a, b, c = FORCE_DIMENSION_FRAME.back(torque).tolist()
            code = dhd.set_force((x, y, z), (a, b, c))
            if self._on and self._off == WATCHDOG:
                self._switch_on(dhd)
        if code == SATURATED:
            self._applied, self._twisted = (FORCE_DIMENSION_FRAME.direction(one) for one in dhd.applied())
        elif code != TIME_GUARD:
            self._applied, self._twisted = force.copy(), torque.copy()
        return on, code

    def _look(self, dhd: Dhd, *, paused: bool) -> None:
        """Looks now and then, and after every pause, whether the device took its forces away by itself.

        Raises:
            DeviceError: it did, and for no reason of ordinary use.
        """
        self._cycle += 1
        if not self._on or not (paused or self._off is not None or self._cycle % _ASK_EVERY == 0):
            return
        off = dhd.why_off()
        if off is not None and off not in _ORDINARY and self._on:
            raise DeviceError(
                f"{self._spec.name} switched its forces off by itself: {CAUSES.get(off, 'no cause given')}"
            )
        self._off = off

    def _opened(self) -> Dhd:
        if self._dhd is None:
            raise DeviceError(f"{self._spec.name} is not open; open it first")
        return self._dhd


def _check_family(index: int, family: str, product: str, wanted: str | None) -> None:
    if wanted is not None and wanted != family:
        raise DeviceError(f"the Force Dimension device {index} is of type {product}, but a {wanted} was requested")
