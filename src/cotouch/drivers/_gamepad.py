"""A gamepad: sticks lead a point through a ball, and what would be felt becomes rumble."""

import os
import threading
import time
from collections.abc import Callable
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.drivers._evdev import EV_ABS, EV_KEY, EventFile, Ioctl, Opener, kernel_ioctl
from cotouch.drivers._passive import PASSIVE, UNSAID
from cotouch.errors import DeviceError
from cotouch.haptics import DeviceReading, Flag

# ABS_Y forward, ABS_X to the left, ABS_RY up; all three count the other way.
_AXES = (0x01, 0x00, 0x04)
_FIRST_BUTTON = 0x130
# Sticks rest off centre by as much as this share.
_DEAD = 0.08
# Half a second from the middle to the rim: what a hand does with a device [m/s].
_SPEED = 0.2
_RADIUS = PASSIVE.workspace
# The force that rumbles in full [N].
_FULL = 4.0
# Rumble is an exchange over a slow bus, and one lasts 100 ms [s].
_RUMBLE_EVERY = 0.05


@final
class Gamepad:
    """A gamepad on Linux. `cotouch.haptics.Device` says what its methods do.

    The left stick says where forward and sideways, the right one how high; the point follows no faster than the speed
    limit, so that its velocity is one that a body can be coupled to. The size of the force rumbles.
    """

    spec = PASSIVE

    def __init__(
        self,
        path: str | None = None,
        *,
        speed: float = _SPEED,
        clock: Callable[[], float] = time.monotonic,
        opener: Opener = os.open,
        ioctl: Ioctl = kernel_ioctl,
    ) -> None:
        """Opens nothing yet.

        Args:
            path: of the event file; None: the first gamepad.
            speed: of the point at most, 0.01 to 2 [m/s].
            clock: monotonic time [s].
            opener: what opens files.
            ioctl: what controls them.

        Raises:
            DeviceError: the speed is out of range.
        """
        if not 0.01 <= speed <= 2.0:
            raise DeviceError(f"the speed of the point is {speed:g} m/s; it must be from 0.01 to 2")
        self._path, self._speed, self._clock = path, speed, clock
        self._opener, self._ioctl = opener, ioctl
        self._file: EventFile | None = None
        self._lock = threading.Lock()
        self._on = False
        self._ranges: dict[int, tuple[int, int]] = {}
        self._sticks: dict[int, float] = {}
        self._position, self._time = np.zeros(3), 0.0
        self._buttons = 0
        self._rumbled, self._strength = -np.inf, 0.0

    def open(self) -> None:
        """See `Device.open`."""
        self.close()
        file = EventFile(self._path, opener=self._opener, ioctl=self._ioctl)
        for code in _AXES:
            value, least, most = file.axis(code)
            self._ranges[code] = (least, most)
            self._sticks[code] = _deflection(value, least, most)
        self._position, self._time, self._buttons = np.zeros(3), self._clock(), 0
        self._rumbled, self._strength = -np.inf, 0.0
        self._file = file

    def calibrate(self, *, allow_motion: bool) -> None:  # noqa: ARG002
        """See `Device.calibrate`; sticks are absolute."""
        self._opened()

    def enable_force(self, on: bool = True) -> None:
        """See `Device.enable_force`; lets it rumble."""
        self._opened()
        if on:
            self._on = True
        else:
            self.stop()

    def exchange(self, force: Float) -> DeviceReading:
        """See `Device.exchange`; takes no time."""
        file = self._opened()
        for event in file.events():
            if event.kind == EV_ABS and event.code in self._ranges:
                self._sticks[event.code] = _deflection(event.value, *self._ranges[event.code])
            elif event.kind == EV_KEY and 0 <= event.code - _FIRST_BUTTON < 16:
                bit = 1 << event.code - _FIRST_BUTTON
                self._buttons = self._buttons | bit if event.value else self._buttons & ~bit
        now = self._clock()
        elapsed, self._time = max(0.0, now - self._time), now
        way = _RADIUS * self._desired() - self._position
        far = float(np.linalg.norm(way))
        step = way * min(1.0, self._speed * elapsed / far) if far > 0.0 else way
        self._position = self._position + step
        self._rumble(file, float(np.linalg.norm(force)), now)
        return DeviceReading(
            time=now,
            position=self._position.copy(),
            velocity=step / elapsed if elapsed > 0.0 else np.zeros(3),
            force=np.array(UNSAID),
            buttons=self._buttons,
            flags=Flag.CALIBRATED | (Flag.FORCE_ON if self._on else Flag(0)),
        )

    def stop(self) -> None:
        """See `Device.stop`."""
        self._on = False
        file = self._file
        if file is not None and self._strength > 0.0 and self._lock.acquire(timeout=0.02):
            try:
                file.rumble(0.0)
                self._strength = 0.0
            finally:
                self._lock.release()

    def close(self) -> None:
        """See `Device.close`."""
        self.stop()
        file, self._file = self._file, None
        if file is not None:
            file.close()

    def _desired(self) -> Float:
        """Where the sticks point, at most at the rim, (3,)."""
        desired = np.array([-self._sticks[code] for code in _AXES])
        size = float(np.linalg.norm(desired))
        return desired / size if size > 1.0 else desired

    def _rumble(self, file: EventFile, size: float, now: float) -> None:
        with self._lock:
            strength = min(1.0, size / _FULL) if self._on and np.isfinite(size) else 0.0
            if now - self._rumbled < _RUMBLE_EVERY or strength == self._strength == 0.0:
                return
            file.rumble(strength)
            self._rumbled, self._strength = now, strength

    def _opened(self) -> EventFile:
        if self._file is None:
            raise DeviceError("the gamepad is not open; open it first")
        return self._file


def _deflection(value: int, least: int, most: int) -> float:
    """From -1 to 1, none within the dead zone."""
    fraction = 2.0 * (value - least) / (most - least) - 1.0
    size = (abs(fraction) - _DEAD) / (1.0 - _DEAD)
    return float(np.copysign(min(1.0, size), fraction)) if size > 0.0 else 0.0
