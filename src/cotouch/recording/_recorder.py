"""The recorder: numbers are copied in the loop, and written by a thread, for which no loop that keeps time waits."""

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from queue import Empty, SimpleQueue
from threading import Thread
from typing import NamedTuple, NotRequired, TypedDict, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Array, Float, Int, Long
from cotouch.mechanics import State, Tools
from cotouch.peer import StepReport
from cotouch.recording._buffer import Buffer, Extents, Extra
from cotouch.recording._disk import NewFile
from cotouch.recording._file import RecordingFile
from cotouch.recording._header import RecordHeader

# Numbers of a state up to which it is kept at every step; of larger ones at so many fewer steps.
_EVERY_STEP = 256
_MOST_WAITING = 10_000
_JOIN = 30.0


@final
@dataclass(frozen=True, kw_only=True)
class Recorded:
    """The outcome of a recording.

    Attributes:
        steps: that are in the file.
        dropped_steps: that are not, because the disk could not follow or writing ended early.
        dropped_events: likewise.
        failure: why writing ended early; None if it did not.
    """

    steps: int
    dropped_steps: int
    dropped_events: int
    failure: str | None

    @property
    def trouble(self) -> str | None:
        """What is wrong with the recording, in words that follow its name; None: it is whole."""
        taken = self.steps + self.dropped_steps
        if self.failure is not None and self.dropped_steps:
            return f"ends after {self.steps:,} of {taken:,} steps: {self.failure}"
        if self.failure is not None:
            return f"has its {self.steps:,} steps, but was not finished: {self.failure}"
        if self.dropped_steps:
            return f"lacks {self.dropped_steps:,} of {taken:,} steps, because the disk was too slow"
        return None


def both_clocks() -> tuple[float, float]:
    """The same instant on the monotonic clock and in Unix time [s], for `RecordHeader`."""
    readings: list[tuple[float, float, float]] = []
    for _ in range(5):  # the tightest of a few: something may come between two readings
        before, unix, after = time.monotonic(), time.time(), time.monotonic()
        readings.append((after - before, 0.5 * (before + after), unix))
    _, monotonic, unix = min(readings)
    return monotonic, unix


@final
class Recorder:
    """Records one user's steps and events into an MCAP file.

    `setup`, then `step` after every step and `event` whenever something happens, then `close`; from one thread. If
    the disk cannot follow, whole batches are dropped and an event of kind "gap" says which; unless it `waits`.

    Attributes:
        failure: why nothing is written any more; None as long as it is.
    """

    def __init__(
        self,
        file: str | Path | NewFile,
        header: RecordHeader,
        *,
        batch: int = 256,
        interval: float = 0.25,
        every: int | None = None,
        buffers: int = 4,
        waits: bool = False,
    ) -> None:
        """Opens the file and starts the thread.

        Args:
            file: path of a file that does not exist, or one that was made before.
            header: who and what.
            batch: most steps of a batch, >= 1.
            interval: a batch ends after this time even if it is not full [s]; what a crash can take at most.
            every: the state is kept at every so many steps; None: at all of them for a body of up to 256 numbers, for
                a larger one at so many fewer that the file grows no faster.
            buffers: batches that may wait for the disk, and the one being filled, >= 2.
            waits: whether a step waits for a slow disk, 30 s at most, before its batch is dropped; for a loop on a
                virtual clock, which runs faster than disks and has no hand to keep waiting.

        Raises:
            RecordingError: the file exists, or cannot be made.
        """
        self.failure: str | None = None
        self._header = header
        body = header.body
        self._every = max(1, every if every is not None else -(-body.rows * body.axes // _EVERY_STEP))
        self._batch = max(1, batch)
        self._interval = interval
        self._buffers = max(2, buffers)
        self._patience = _JOIN if waits else 0.0
        self._free: SimpleQueue[Buffer] = SimpleQueue()
        self._full: SimpleQueue[_Full | Mapping[str, object] | None] = SimpleQueue()
        self._current: Buffer | None = None
        self._neighbours: tuple[int, ...] | None = None
        self._next = 0
        self._ended = header.monotonic
        self._written = self._failed_steps = self._failed_events = 0  # the thread's
        self._dropped_steps = self._dropped_events = 0  # the loop's
        self._gap: _Gap | None = None
        self._closed = False
        new = file if isinstance(file, NewFile) else NewFile(Path(file))
        self._file = RecordingFile(new, header)
        # A daemon: a disk that hangs must not keep the process from ending.
        self._thread = Thread(target=self._write, name="cotouch recorder", daemon=True)
        self._thread.start()

    def setup(
        self,
        time: float,
        *,
        copies: int,
        neighbours: Sequence[int],
        strength: Sequence[float] | Float,
        weight: Sequence[int] | Int | None = None,
        local_damping: Sequence[float] | Float = (0.0,),
        extra_damping: Sequence[float] | Float = (0.0,),
        ports: Sequence[int] | None = (),
        tool_mass: Sequence[float] | Float = (),
        link_damping: Sequence[float] | None = None,
        rounding: float = 0.0,
        **fields: object,
    ) -> None:
        """Says what the ledger of the next steps follow from; before the first step, and whenever one of it changes.

        Args:
            time: now, on the user's clock [s].
            copies: N, of which each carries 1/N of the body.
            neighbours: users at the other ends of the links, in the order of `Peer.neighbours`.
            strength: spring of each link [N/m for the identity weight].
            weight: index of each link's weight; None: all 0.
            local_damping: B_i as coefficients over the weights [Ns/m].
            extra_damping: B_e likewise [Ns/m].
            ports: index of the node that each port holds; of a body in the full form each node once for every axis.
                None: not said, then the work at the ports is taken as booked.
            tool_mass: of every proxy [kg].
            link_damping: share of B_i that each link has, for weights other than d = 1 [Ns/m]; None: in proportion to
                spring and ages.
            rounding: most that a coordinate of a sample may differ from what its sender recorded, where samples are
                sent with fewer digits [m].
            **fields: whatever else should be kept with it.
        """
        self._neighbours = tuple(int(user) for user in neighbours)
        self.event(
            "setup",
            time,
            copies=int(copies),
            neighbours=list(self._neighbours),
            strength=_list(strength),
            weight=[0] * len(self._neighbours) if weight is None else [int(w) for w in weight],
            local_damping=_list(local_damping),
            extra_damping=_list(extra_damping),
            ports=None if ports is None else [int(node) for node in ports],
            tool_mass=_list(tool_mass),
            link_damping=None if link_damping is None else _list(link_damping),
            rounding=float(rounding),
            **fields,
        )

    def step(
        self,
        report: StepReport,
        *,
        end: float,
        T: float,
        state: State,
        tools: Tools | None = None,
        used: Sequence[int] | Long | None = None,
        link_state: Sequence[int] | npt.NDArray[np.int8] | None = None,
        extra: Extra | None = None,
    ) -> None:
        """Copies what a step did; opens nothing, and never waits if the recorder does not.

        Args:
            report: of `Peer.step`.
            end: of the step, on the user's clock [s].
            T: its length [s].
            state: after it (`Peer.state`).
            tools: after it (`Peer.tools`).
            used: index of the sample that each link used, -1 for the one before the first, -2 for one that is mixed of
                several or otherwise not a sample as it was sent; None: to be found by its age.
            link_state: of each link's end, a `LinkState`; None: all are coupled.
            extra: further columns by name, each a number or an array that keeps its length until the next `setup`.
        """
        current = self._current
        if current is None or (
            current.extents.neighbours != self._neighbours and self._neighbours is not None
        ):  # the first step, or other links
            current = self._resize(report, state, tools)
        current.put(report, end, T, state, tools, used, link_state, extra)
        self._next = current.last + 1
        if current.full or end - current.first_end >= self._interval:
            self._cut()

    def event(self, kind: str, time: float, **fields: object) -> None:
        """Notes that something happened.

        Args:
            kind: what: joined, left, guarded, coupled, budget, alarm, rate, ...
            time: when, on the user's clock [s].
            **fields: what else there is to say; anything that JSON can.
        """
        if self._full.qsize() >= _MOST_WAITING:
            self._dropped_events += 1
            return
        self._full.put({"kind": kind, "time": float(time), "first": self._next, **fields})

    @property
    def dropped(self) -> int:
        """Steps so far that are not in the file and never will be."""
        return self._dropped_steps + self._failed_steps

    def close(self) -> Recorded:
        """Writes what is left, closes the file, and says what became of it; a second call changes nothing."""
        if not self._closed:
            self._closed = True
            self._cut()
            self._tell_gap()
            self._full.put({"kind": "closed", "time": self._ended, "first": self._next})
            self._full.put(None)
            self._thread.join(_JOIN)
            if self._thread.is_alive():
                self.failure = f"the disk did not accept the rest within {_JOIN:g} s"
        return Recorded(
            steps=self._written,
            dropped_steps=self.dropped,
            dropped_events=self._dropped_events + self._failed_events,
            failure=self.failure,
        )

    def __enter__(self) -> "Recorder":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _resize(self, report: StepReport, state: State, tools: Tools | None) -> Buffer:
        """Buffers for other sizes; those of before go when they are written."""
        self._cut()
        links = report.link_work.size
        neighbours = self._neighbours if self._neighbours is not None else tuple(range(-links, 0))
        rows, width = state.position.shape
        extents = Extents(
            neighbours=neighbours,
            ports=report.force.shape[0],
            width=width,
            axes=self._header.body.axes,
            rows=rows,
            tools=0 if tools is None else tools.mode.size,
            steps=self._batch,
            every=self._every,
        )
        self._free = SimpleQueue()
        for _ in range(self._buffers - 1):
            self._free.put(Buffer(extents))
        self._current = Buffer(extents)
        return self._current

    def _cut(self) -> None:
        """Hands the batch over, or drops it where nobody could take it."""
        current = self._current
        if current is None or current.count == 0:
            return
        self._ended = current.last_end
        try:
            following = self._free.get(self._patience > 0.0, self._patience)
        except Empty:
            self._dropped_steps += current.count
            if self._gap is None:
                self._gap = {"kind": "gap", "time": current.first_end, "first": current.first, "steps": 0}
            self._gap["steps"] += current.count
            self._gap["last"] = current.last
            current.clear()
            return
        self._tell_gap()
        self._full.put(_Full(current, self._free))
        self._current = following

    def _tell_gap(self) -> None:
        if self._gap is not None:
            self._full.put(self._gap)
            self._gap = None

    def _write(self) -> None:
        """The thread: everything until None; after an error it only goes on emptying the queue."""
        while True:
            item = self._full.get()
            if item is None:
                break
            if self.failure is None:
                try:
                    self._put(item)
                except Exception as error:  # noqa: BLE001  whatever it is, it ends the recording and has to be said
                    self._fail(error)
            if self.failure is not None:
                if isinstance(item, _Full):
                    self._failed_steps += item.buffer.count
                else:
                    self._failed_events += 1
            if isinstance(item, _Full):
                item.buffer.clear()
                item.home.put(item.buffer)
        if self.failure is None:
            try:
                self._file.finish()
            except Exception as error:  # noqa: BLE001
                self._fail(error)

    def _fail(self, error: Exception) -> None:
        """Ends the file where it is whole, at once, so that nothing that comes later can harm it."""
        reason = error.strerror if isinstance(error, OSError) else f"{type(error).__name__}: {error}"
        self.failure = reason or str(error)
        self._file.abandon()

    def _put(self, item: "_Full | Mapping[str, object]") -> None:
        if isinstance(item, _Full):
            self._file.batch(item.buffer.batch())
            self._file.flush()
            self._written += item.buffer.count
            return
        self._file.event(item)
        if self._full.empty():
            self._file.flush()


class _Gap(TypedDict):
    """Steps that are not in the file, as an event."""

    kind: str
    time: float
    first: int
    steps: int
    last: NotRequired[int]


class _Full(NamedTuple):
    """A batch to be written, and where its buffer goes afterwards: other links make other buffers."""

    buffer: Buffer
    home: SimpleQueue[Buffer]


def _list(values: Sequence[float] | Array) -> list[float]:
    return [float(value) for value in values]
