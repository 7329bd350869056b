"""The page that a stand-in shares with tests, and the log of its motors; quick to load, as the service loads it too."""

import math
import mmap
import struct
import time
from enum import IntEnum
from pathlib import Path
from typing import Any

# As in device.h.
_OFFSETS = {
    "force": (0, "3d"), "commanded": (24, "d"), "enabled": (32, "i"), "cause": (36, "i"), "watchdog": (40, "d"),
    "fault": (48, "i"), "stop": (52, "i"), "value": (56, "d"), "struck": (64, "d"), "position": (72, "3d"),
    "velocity": (96, "3d"), "initialized": (120, "i"), "buttons": (124, "i"), "violations": (128, "i"),
    "system": (132, "i"), "motor": (136, "3d"), "max_force": (160, "d"), "open": (168, "i"), "sets": (172, "i"),
    "said": (176, "64s"), "styles": (248, "i"), "protect": (252, "i"), "gravity": (256, "i"), "asked": (260, "i"),
    "pushes": (264, "i"), "force_button": (268, "i"), "emulated": (272, "i"), "offset": (276, "i"),
    "torque": (280, "3d"), "twist": (304, "3d"), "max_torque": (328, "d"), "wrist": (336, "i"), "turned": (344, "4d"),
    "spin": (376, "3d"),
}  # fmt: skip


class Fault(IntEnum):
    """As in device.h; the second row is the Inverse Service's."""

    NONE = 0
    UNPLUGGED = 1
    NOT_A_NUMBER = 2
    FROZEN = 3
    SLOW = 4
    TAKEN_AWAY = 5
    REFUSED = 6
    SILENT = 7
    SAFETY = 8
    CLOSED = 9
    MISSING = 10
    GATE = 11
    OTHERS_SAFETY = 12
    NOT_READY = 13
    NEWS = 14
    BUSY = 15
    RESCALED = 16
    MOVED = 17
    TIME_GUARD = 18
    STUCK = 19
    BENT = 20


class Board:
    """The page that a stand-in shares with tests, and the log of its motors."""

    def __init__(self, folder: Path) -> None:
        self.path, self.log = folder / "board", folder / "motors"
        if not self.path.exists():
            self.path.write_bytes(bytes(4096))
            self.log.write_bytes(b"")
        with self.path.open("r+b") as file:
            self._page = mmap.mmap(file.fileno(), 4096)

    def get(self, name: str) -> Any:
        offset, kind = _OFFSETS[name]
        values = struct.unpack_from("<" + kind, self._page, offset)
        return values if len(values) > 1 else values[0]

    def set(self, name: str, *values: float) -> None:
        offset, kind = _OFFSETS[name]
        struct.pack_into("<" + kind, self._page, offset, *values)

    def inject(self, fault: Fault, value: float = 0.0) -> None:
        """From now on; `struck` says when it was first met."""
        self.set("struck", 0.0)
        self.set("value", value)
        self.set("fault", int(fault))

    @property
    def said(self) -> str:
        return self.get("said").rstrip(b"\0").decode()

    def motors(self) -> list[tuple[float, ...]]:
        """Every change of what the motors do: time, three forces and three torques."""
        data = self.log.read_bytes()
        return list(struct.iter_unpack("<7d", data[: len(data) // 56 * 56]))

    def zero_after(self, since: float) -> float:
        """How long after a moment the motors had force or torque for the last time; infinite if they still have [s]."""
        log = self.motors()
        acting = [row for row, (_, *force) in enumerate(log) if any(force)]
        if not acting:
            return 0.0
        if acting[-1] == len(log) - 1:
            return math.inf
        return max(0.0, log[acting[-1] + 1][0] - since)

    def gone_after(self, since: float) -> float:
        """The same, once the force is gone: whoever plays the motors may have to wait for its turn [s]."""
        late = time.monotonic() + 5.0
        while self.zero_after(since) == math.inf and time.monotonic() < late:
            time.sleep(0.005)
        return self.zero_after(since)

    def wait_for(self, what: str, test: Any, patience: float = 20.0) -> None:
        end = time.monotonic() + patience
        while not test(self.get(what)):
            assert time.monotonic() < end, f"{what} is {self.get(what)}"
            time.sleep(0.002)
