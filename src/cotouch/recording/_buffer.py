"""Room for one batch of steps, made once, filled in the loop without making anything."""

import struct
from collections.abc import Mapping, Sequence
from typing import NamedTuple, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Array, Float, Long
from cotouch.mechanics import State, Tools
from cotouch.peer import LinkState, StepReport
from cotouch.recording._columns import CLOSING, JAMMED, SCALARS, UNSAID, Batch

Extra = Mapping[str, float | Sequence[float] | Array]


class Extents(NamedTuple):
    """What decides the size of a buffer.

    Attributes:
        neighbours: users at the other ends of the links.
        ports: number of ports.
        width: columns of a field in the kernels.
        axes: columns of it that mean something.
        rows: of the model.
        tools: number of proxies, 0 without.
        steps: most steps.
        every: one state is kept in so many steps.
    """

    neighbours: tuple[int, ...]
    ports: int
    width: int
    axes: int
    rows: int
    tools: int
    steps: int
    every: int


_PACK = struct.Struct(f"<{len(SCALARS)}d")


@final
class Buffer:
    """One batch being filled.

    Attributes:
        extents: its sizes.
        count: steps in it.
        states: states in it.
        first_end: end of its first step [s].
        last_end: end of its last step [s].
        first: index of its first step.
        last: index of its last step.
    """

    def __init__(self, extents: Extents) -> None:
        self.extents = extents
        self.count = 0
        self.states = 0
        self.first_end = self.last_end = 0.0
        self.first = 0
        self.last = -1
        steps, links, width = extents.steps, len(extents.neighbours), extents.width
        kept = -(-steps // extents.every) + 1
        self._scalars = np.zeros((steps, len(SCALARS)))
        self._bytes = self._scalars.data.cast("B")
        self._force = np.zeros((steps, extents.ports, width))
        self._link_work = np.zeros((steps, links))
        self._age = np.zeros((steps, links))
        self._used = np.zeros((steps, links), dtype=np.int64)
        self._link_state = np.zeros((steps, links), dtype=np.int8)
        self._tools = [np.zeros((steps, extents.tools, 4)) for _ in range(4 if extents.tools else 0)]
        self._row = np.zeros(kept, dtype=np.int32)
        self._state = [np.zeros((kept, extents.rows, width)) for _ in range(3)]
        self._extra: dict[str, Float] = {}

    @property
    def full(self) -> bool:
        """Whether there is no room for another step."""
        return self.count == self.extents.steps

    def clear(self) -> None:
        """Makes it empty."""
        self.count = self.states = 0
        for column in self._extra.values():
            column.fill(np.nan)

    def put(
        self,
        report: StepReport,
        end: float,
        T: float,
        state: State,
        tools: Tools | None,
        used: Sequence[int] | Long | None,
        link_state: Sequence[int] | npt.NDArray[np.int8] | None,
        extra: Extra | None,
    ) -> None:
        """Copies what a step did into the next row.

        Args:
            report: of the step.
            end: of the step, on the user's clock [s].
            T: its length [s].
            state: after it.
            tools: of the user; None without.
            used: index of the sample that each link used; None: not known.
            link_state: of each link's end; None: not known.
            extra: columns of one's own.
        """
        k = self.count
        index = report.sample.index
        # One call for all scalars: writing them into an array one by one would take three times as long.
        _PACK.pack_into(
            self._bytes,
            k * _PACK.size,
            index,
            end,
            T,
            report.supplied,
            report.body_loss,
            report.local_loss,
            report.extra_loss,
            report.kinetic,
            report.elastic,
            report.drive_work,
            report.touch_work,
            report.touch_loss,
            report.proxy,
            report.touch_stored,
            report.residual,
            report.iterations,
            report.closure,
            report.closure_factor,
            report.shortened,
            report.world_loss,
            report.world_stored,
            report.cut,
        )
        if k == 0:
            self.first, self.first_end = index, end
        self.last, self.last_end = index, end
        self._force[k] = report.force
        if self.extents.neighbours:
            self._link_work[k] = report.link_work
            self._age[k] = report.age
            self._used[k] = UNSAID if used is None else used
            self._link_state[k] = LinkState.COUPLED if link_state is None else link_state
        if tools is not None and self._tools:
            for column, values in zip(
                self._tools, (tools.place, tools.rate, tools.drive_force, tools.touch_force), strict=True
            ):
                column[k] = values
        if index % self.extents.every == 0:
            at = self.states
            self._row[at] = k
            x, v, middle = self._state
            x[at], v[at], middle[at] = state.position, state.velocity, report.sample.position
            self.states = at + 1
        if report.closing is not None:
            extra = {CLOSING: report.closing, **(extra or {})}
        if report.jammed is not None:
            extra = {JAMMED: report.jammed, **(extra or {})}
        if extra is not None:
            for name, value in extra.items():
                column = self._extra.get(name)
                if column is None:
                    column = self._extra[name] = np.full((self.extents.steps, *np.shape(value)), np.nan)
                column[k] = value
        self.count = k + 1

    def batch(self) -> Batch:
        """What is in it, as columns; views, to be packed before the buffer is used again."""
        n, m, axes = self.count, self.states, self.extents.axes
        scalars: dict[str, Array] = dict(zip(SCALARS, self._scalars[:n].T, strict=True))
        tools = zip(("tool_position", "tool_velocity", "drive_force", "touch_force"), self._tools, strict=False)
        columns: dict[str, Array] = {
            **scalars,
            "index": scalars["index"].astype(np.int64),
            "iterations": scalars["iterations"].astype(np.int32),
            "force": self._force[:n, :, :axes],
            "link_work": self._link_work[:n],
            "age": self._age[:n],
            "used": self._used[:n],
            "link_state": self._link_state[:n],
            **{name: values[:n, :, :3] for name, values in tools},
            "state_row": self._row[:m],
            **{
                name: values[:m, :, :axes]
                for name, values in zip(("position", "velocity", "middle"), self._state, strict=True)
            },
            **{name: values[:n] for name, values in self._extra.items()},
        }
        return Batch(self.extents.neighbours, columns)
