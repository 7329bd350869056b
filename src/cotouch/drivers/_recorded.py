"""A recording's hand, played again: the proxy that it led, at the times at which it did."""

import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.drivers._passive import PASSIVE, UNSAID
from cotouch.errors import DeviceError, RecordingError
from cotouch.haptics import DeviceReading, Flag
from cotouch.recording import read_recording

RECORDED_SPEC = replace(
    PASSIVE, name="recorded hand", rate=1000.0, resolution=1e-6, source="what the hand went through"
)
"""A recording feels nothing; once open, the workspace is what the hand went through."""


@final
class RecordedHand:
    """Replays a recording. `cotouch.haptics.Device` says what its methods do.

    Its origin is the middle of the box that the hand went through, as of every device; `middle` says where that was.

    Attributes:
        middle: of the box, in the recording's coordinates, (3,) [m].
        length: of the recording [s].
    """

    def __init__(
        self,
        path: str | Path,
        *,
        tool: int = 1,
        repeat: bool = False,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Reads nothing yet.

        Args:
            path: of the recording.
            tool: which of the user's tools, from 1.
            repeat: whether to begin again at the end, there and back so that nothing jumps; else the hand rests there.
            clock: monotonic time [s].
        """
        self._path, self._tool, self._repeat, self._clock = path, tool, repeat, clock
        self.spec = RECORDED_SPEC
        self.middle, self.length = np.zeros(3), 0.0
        self._times, self._places = np.zeros(0), np.zeros((0, 3))
        self._began = 0.0
        self._open = self._on = False

    def open(self) -> None:
        """See `Device.open`."""
        try:
            recording = read_recording(self._path)
        except RecordingError as error:
            raise DeviceError(str(error)) from None
        places = recording.columns.get("tool_position", np.zeros((recording.steps, 0, 3)))
        if not 1 <= self._tool <= places.shape[1]:
            raise DeviceError(f"tool is {self._tool}; {self._path} has {places.shape[1]} tools whose places it keeps")
        mine = np.asarray(places[:, self._tool - 1], dtype=np.float64)
        known = np.isfinite(mine).all(axis=1)
        if np.count_nonzero(known) < 2:
            raise DeviceError(
                f"{self._path} has fewer than two positions of tool {self._tool}, so there is no motion in it"
            )
        times, mine = recording.columns["time"][known], mine[known]
        self.middle = 0.5 * (mine.min(axis=0) + mine.max(axis=0))
        self._times, self._places = times - times[0], mine - self.middle
        self.length = float(self._times[-1])
        reach = float(np.linalg.norm(self._places, axis=1).max())
        self.spec = replace(RECORDED_SPEC, workspace=max(1e-3, reach))
        self._began, self._open = self._clock(), True

    def calibrate(self, *, allow_motion: bool) -> None:  # noqa: ARG002
        """See `Device.calibrate`; nothing to do."""
        self._opened()

    def enable_force(self, on: bool = True) -> None:
        """See `Device.enable_force`; only said."""
        self._opened()
        self._on = on

    def exchange(self, force: Float) -> DeviceReading:  # noqa: ARG002
        """See `Device.exchange`; takes no time and any force."""
        self._opened()
        now = self._clock()
        at, way = max(0.0, now - self._began), 1.0
        if self._repeat:
            turn = at % (2.0 * self.length)
            at, way = (turn, 1.0) if turn < self.length else (2.0 * self.length - turn, -1.0)
        position, velocity = self._motion(at)
        return DeviceReading(
            time=now,
            position=position,
            velocity=way * velocity,
            force=np.array(UNSAID),
            flags=Flag.CALIBRATED | (Flag.FORCE_ON if self._on else Flag(0)),
        )

    def stop(self) -> None:
        """See `Device.stop`."""
        self._on = False

    def close(self) -> None:
        """See `Device.close`."""
        self._open = self._on = False

    def _motion(self, at: float) -> tuple[Float, Float]:
        """Along straight lines between the steps; at rest behind the last."""
        if at >= self.length:
            return self._places[-1].copy(), np.zeros(3)
        after = max(1, int(np.searchsorted(self._times, at, side="right")))
        T = float(self._times[after] - self._times[after - 1])
        velocity = (self._places[after] - self._places[after - 1]) / T
        return self._places[after - 1] + (at - self._times[after - 1]) * velocity, velocity

    def _opened(self) -> None:
        if not self._open:
            raise DeviceError("the recorded hand is not open; open it first")
