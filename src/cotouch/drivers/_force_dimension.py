"""Force Dimension's omega, delta, sigma and lambda, and the Falcon, which their SDK drives as well."""

import contextlib
import threading
import time
from dataclasses import replace
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.device import PRESETS, DeviceSpec
from cotouch.drivers._dhd import SATURATED, SYSTEMS, TIME_GUARD, Dhd
from cotouch.drivers._watch import SampleWatch
from cotouch.errors import DeviceError
from cotouch.haptics import FORCE_DIMENSION, DeviceReading, Flag

Float = npt.NDArray[np.float64]

# For a hand to put the handle into its rest.
_RESET_MS = 20_000
# A call to the SDK that takes longer has failed; two late ones are still well below 100 ms [s].
_LIMIT = 0.03
# Longer than this is late [s].
_LATE = 0.005
# The device's own reason is asked for every so many cycles: it costs another exchange with the device.
_ASK_EVERY = 10
_SIGMA = "force, stiffness, damping: CHAI3D (sigma.7), which is less than the vendor says; the rest assumed"
_LAMBDA = "assumed to be those of the sigma"
SPECS: dict[str, DeviceSpec] = {
    "omega": PRESETS["omega"],
    "delta": PRESETS["delta"],
    "falcon": PRESETS["falcon"],
    "sigma": replace(PRESETS["omega"], name="Force Dimension sigma", stiffness=4000.0, source=_SIGMA),
    "lambda": replace(PRESETS["omega"], name="Force Dimension lambda", stiffness=4000.0, source=_LAMBDA),
}
"""By family; every one is nominal."""


@final
class ForceDimension:
    """A device of Force Dimension. `cotouch.haptics.Device` says what its methods do.

    The force is set in every cycle, zero as well, because the SDK compensates gravity only then. If the SDK says that
    the motors cannot do what they were told, the reading is flagged LIMITED.
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
        self._ticks = max(1, round(watchdog / 125e-6))
        self._threshold, self._reset = velocity_threshold, reset_seconds
        self._spec = SPECS[family or "omega"]
        self._dhd: Dhd | None = None
        self._lock = threading.Lock()  # what is set after stop() is zero
        self._on = False
        self._applied = np.zeros(3)
        self._cycle = 0
        self._watch = SampleWatch()
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
        self._dhd, self._cycle, self._watch = dhd, 0, SampleWatch()
        try:
            dhd.enable_force(False)
            family, product = SYSTEMS.get(dhd.system(), ("omega", "device of unknown kind"))
            _check_family(self._index, family, product, self._family)
            self._spec = replace(
                SPECS[family], name=f"{'Novint' if family == 'falcon' else 'Force Dimension'} {product}"
            )
            self.watchdog = dhd.protect(force=self._spec.force, watchdog=self._ticks)
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
            else:
                dhd.wait_for_reset(max(1, int(1e3 * self._reset)))
        except DeviceError as error:
            hint = "keep clear of it" if allow_motion else "put its handle into its rest, or allow it to move by itself"
            raise self._fault(f"{self._spec.name} is not calibrated; {hint}: {error}") from None
        if not dhd.initialized():
            raise self._fault(
                f"{self._spec.name} is not calibrated, though it says that it tried; switch it off and on"
            )

    def enable_force(self, on: bool = True) -> None:
        """See `Device.enable_force`."""
        dhd = self._opened()
        if not on:
            self.stop()
            return
        with self._lock:
            dhd.enable_force(True)
            dhd.set_force((0.0, 0.0, 0.0))
            self._on = True

    def exchange(self, force: Float) -> DeviceReading:
        """See `Device.exchange`."""
        dhd = self._opened()
        if not np.isfinite(force).all():
            raise self._fault(f"{self._spec.name} was told a force that is not finite")
        began = time.monotonic()
        try:
            place, guarded = dhd.position()
            position, velocity = FORCE_DIMENSION.place(place), FORCE_DIMENSION.place(dhd.velocity())
            at = time.monotonic()
            why = self._watch.fault(at, position, velocity)
            on, code = self._set(dhd, force if why is None else np.zeros(3))
            why = why or self._taken_away(dhd, on)
            buttons = dhd.buttons()
            calibrated = dhd.initialized()
        except DeviceError as error:
            raise self._fault(str(error)) from None
        took = time.monotonic() - began
        if why is None and took > _LIMIT:
            why = f"took {1e3 * took:.0f} ms for a cycle; more than {1e3 * _LIMIT:.0f} ms is a fault"
        if why is not None:
            raise self._fault(f"{self._spec.name} {why}")
        flags = Flag.CALIBRATED if calibrated else Flag(0)
        flags |= Flag.FORCE_ON if on else Flag(0)
        flags |= Flag.LIMITED if code else Flag(0)
        flags |= Flag.LATE if took > _LATE else Flag(0)
        flags |= Flag.STALE if guarded == TIME_GUARD else Flag(0)
        return DeviceReading(
            time=at, position=position, velocity=velocity, force=self._applied.copy(), buttons=buttons, flags=flags
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

    def _set(self, dhd: Dhd, force: Float) -> tuple[bool, int]:
        """Sets a force; whether motors follow, and what the SDK said."""
        with self._lock:
            on = self._on
            x, y, z = FORCE_DIMENSION.back(force if on else np.zeros(3)).tolist()
            code = dhd.set_force((x, y, z))
        if code == SATURATED:
            self._applied = FORCE_DIMENSION.direction(dhd.force())
        elif code != TIME_GUARD:
            self._applied = force.copy() if on else np.zeros(3)
        return on, code

    def _taken_away(self, dhd: Dhd, on: bool) -> str | None:
        """Why the device took its forces away by itself; asked now and then."""
        self._cycle += 1
        if not on or self._cycle % _ASK_EVERY:
            return None
        cause = dhd.why_off()
        return None if cause is None else f"took its forces away by itself: {cause}"

    def _opened(self) -> Dhd:
        if self._dhd is None:
            raise DeviceError(f"{self._spec.name} is not open; open it first")
        return self._dhd

    def _fault(self, why: str) -> DeviceError:
        """Takes the force away, and says why."""
        self.stop()
        return DeviceError(why)


def _check_family(index: int, family: str, product: str, wanted: str | None) -> None:
    if wanted is not None and wanted != family:
        raise DeviceError(f"the Force Dimension device {index} is a {product}; it must be a {wanted}, as was asked for")
