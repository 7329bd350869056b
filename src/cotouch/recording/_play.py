"""A recording in real time: step after step, as it was."""

import time
from collections.abc import Callable, Generator
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import RecordingError
from cotouch.recording._recording import Recording

# Times that differ by no more are the same: they come from sums and differences of large numbers [s].
_SAME = 1e-9


class Replayed(NamedTuple):
    """One step of a recording.

    Attributes:
        row: of the recording's columns.
        time: end of the step since the beginning of the first [s].
        period: its length [s].
        force: at every port, (ports, axes) [N].
        place: displacement of the nodes after the step, (n, d) [m]; that of the last step whose state is recorded.
    """

    row: int
    time: float
    period: float
    force: Float
    place: Float


def replay(
    recording: Recording,
    *,
    speed: float = 1.0,
    start: float = 0.0,
    stop: float = float("inf"),
    clock: Callable[[], float] = time.monotonic,
    sleep: Callable[[float], None] = time.sleep,
) -> Generator[Replayed]:
    """Yields the steps of a recording when they are due.

    Who takes them late gets the next ones at once, so that it stays in time.

    Args:
        recording: to play.
        speed: seconds of the recording in a second, > 0.
        start: where to begin, since the beginning [s].
        stop: where to end [s].
        clock: monotonic time [s].
        sleep: waits so long [s].

    Raises:
        RecordingError: the speed is not positive, or nothing lies between `start` and `stop`.
    """
    if not speed > 0.0:
        raise RecordingError(f"speed is {speed:g}; it must be greater than 0")
    columns, states = recording.columns, recording.states
    ends = columns["time"] - columns["time"][0] + columns["period"][0]
    rows = np.flatnonzero((ends >= start - _SAME) & (ends <= stop + _SAME))
    if rows.size == 0:
        asked = f"between {start:g} s and {stop:g} s" if np.isfinite(stop) else f"after {start:g} s"
        raise RecordingError(f"{recording.path} has nothing {asked}; it is {float(ends[-1]):.4g} s long")
    body = recording.header.body
    kept = states["state_row"]
    still = np.zeros(body.rest.shape)
    shown, place = -1, still
    begin = clock()
    for row in rows:
        wait = (float(ends[row]) - float(ends[rows[0]])) / speed - (clock() - begin)
        if wait > 0.0:
            sleep(wait)
        state = int(np.searchsorted(kept, row, side="right")) - 1
        if state != shown and state >= 0:
            shown, place = state, body.nodes(states["position"][state])
        yield Replayed(int(row), float(ends[row]), float(columns["period"][row]), columns["force"][row], place)
