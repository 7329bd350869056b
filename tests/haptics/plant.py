"""A device that is a process of its own and holds what it was told last, for ever: the worst that hardware can be.

It has no watchdog, so that what takes its force away is ours. A hand moves it to and fro whatever the force is. It
writes down when force came and went; tests tell it to fail.
"""

import contextlib
import math
import os
import select
import socket
import struct
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

EXCHANGE, ENABLE, OFF, NAN, DEAF, FROZEN, SLOW, THROW, GOOD = range(9)
_ASK = struct.Struct("<i3d")
_ANSWER = struct.Struct("<d3d3d3di")


def serve(folder: Path) -> None:
    """The device's own loop, in its own process; ends when its parent does."""
    own = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    own.bind(str(folder / "plant"))
    log = (folder / "log").open("w", buffering=1)
    parent, begun = os.getppid(), time.monotonic()
    force, on, mode, since = (0.0, 0.0, 0.0), False, EXCHANGE, 0.0
    was = 0.0
    while os.getppid() == parent:
        if select.select([own], [], [], 0.2)[0]:
            content, asker = own.recvfrom(256)
            kind, *commanded = _ASK.unpack(content)
            now = time.monotonic()
            if kind == EXCHANGE:
                force = tuple(commanded)
                if mode == SLOW:
                    time.sleep(0.5)
                at = since if mode == FROZEN else now
                turn = 2 * math.pi * (at - begun)
                speed = 50.0 if mode == THROW else 1.0
                place = (math.nan if mode == NAN else 0.01 * math.sin(turn), 0.0, 0.0)
                rate = (speed * 0.01 * 2 * math.pi * math.cos(turn), 0.0, 0.0)
                if mode != DEAF and asker:
                    acting = force if on else (0.0, 0.0, 0.0)
                    with contextlib.suppress(OSError):  # whoever asked is gone
                        own.sendto(_ANSWER.pack(at, *place, *rate, *acting, on), asker)
            elif kind in {ENABLE, OFF}:
                on, force = kind == ENABLE, (0.0, 0.0, 0.0)
            else:
                mode, since = kind, now
        acting_now = math.dist(force, (0.0, 0.0, 0.0)) if on else 0.0
        if (acting_now > 0.0) != (was > 0.0):
            log.write(f"{time.monotonic()} {acting_now}\n")
        was = acting_now


class Plant:
    """The process, for a test."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._process = subprocess.Popen([sys.executable, __file__, str(folder)])
        end = time.monotonic() + 60.0
        while not (folder / "log").exists():
            assert time.monotonic() < end
            time.sleep(0.01)

    def command(self, kind: int) -> None:
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as way:
            way.sendto(_ASK.pack(kind, 0.0, 0.0, 0.0), str(self.folder / "plant"))

    def changes(self) -> list[tuple[float, float]]:
        """When force came (its size) or went (0)."""
        lines = (self.folder / "log").read_text().splitlines()
        return [(float(a), float(b)) for a, b in (line.split() for line in lines)]

    def gone_after(self, since: float) -> float:
        """How long after a moment there was force for the last time; infinite if there still is [s]."""
        known = self.changes()
        if not known:
            return 0.0
        return math.inf if known[-1][1] > 0.0 else max(0.0, known[-1][0] - since)

    @property
    def force(self) -> float:
        """Whether it acts now: its size when it came, or 0."""
        known = self.changes()
        return known[-1][1] if known else 0.0

    def close(self) -> None:
        self._process.kill()
        self._process.wait()


if __name__ == "__main__":
    serve(Path(sys.argv[1]))
else:
    from cotouch.device import PRESETS, DeviceSpec
    from cotouch.errors import DeviceError
    from cotouch.haptics import DeviceReading, Driver, Flag

    class PlantDevice:
        """The driver's side of it."""

        def __init__(self, folder: str) -> None:
            self.spec: DeviceSpec = PRESETS["omega"]
            self._path = f"{folder}/plant"
            self._socket: socket.socket | None = None
            self._last = 0.0

        def open(self) -> None:
            if not Path(self._path).exists():
                raise DeviceError(f"no plant at {self._path}; start one")
            way = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
            way.bind(f"{self._path}-{os.getpid()}-{id(self)}")
            way.settimeout(0.25)  # a machine full of tests is slow; a driver has 20 ms
            try:
                way.connect(self._path)
            except OSError as error:
                raise DeviceError(f"no plant at {self._path}: {error}") from error
            self._socket = way

        def calibrate(self, *, allow_motion: bool) -> None:
            pass

        def enable_force(self, on: bool = True) -> None:
            self._send(ENABLE if on else OFF, (0.0, 0.0, 0.0))

        def exchange(self, force) -> DeviceReading:
            self._send(EXCHANGE, force)
            assert self._socket is not None
            try:
                content = self._socket.recv(256)
            except OSError as error:
                raise DeviceError("the plant does not answer; is it plugged in?") from error
            at, *numbers, on = _ANSWER.unpack(content)
            stale = Flag.STALE if at == self._last else Flag(0)
            self._last = at
            place, rate, acting = (np.array(numbers[n : n + 3]) for n in (0, 3, 6))
            flags = Flag.CALIBRATED | stale | (Flag.FORCE_ON if on else Flag(0))
            return DeviceReading(time=at, position=place, velocity=rate, force=acting, flags=flags)

        def stop(self) -> None:
            with contextlib.suppress(DeviceError):
                self._send(OFF, (0.0, 0.0, 0.0))

        def close(self) -> None:
            self.stop()
            if self._socket is not None:
                Path(self._socket.getsockname()).unlink(missing_ok=True)
                self._socket.close()
                self._socket = None

        def _send(self, kind: int, force) -> None:
            if self._socket is None:
                raise DeviceError("the plant is not open; open it first")
            try:
                self._socket.send(_ASK.pack(kind, *map(float, force)))
            except OSError as error:
                raise DeviceError("the plant does not answer; is it plugged in?") from error

    def _halt(*, folder: str) -> None:
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as way:
            way.setblocking(False)
            way.sendto(_ASK.pack(OFF, 0.0, 0.0, 0.0), f"{folder}/plant")

    def _driver(halt) -> Driver:
        return Driver(
            name="plant",
            summary="a device in a process of its own",
            make=PlantDevice,
            spec=PRESETS["omega"],
            options={"folder": "where it listens"},
            watchdog="It has none.",
            halt=halt,
        )

    PLANT, PLANT_ALONE = _driver(_halt), _driver(None)
