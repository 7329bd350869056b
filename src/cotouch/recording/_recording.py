"""A recording in memory: columns by name, events, and what its ledger follows from at every step."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, NamedTuple, final

import numpy as np

from cotouch.arrays import Array, Bool, Float
from cotouch.errors import RecordingError
from cotouch.peer import ROUNDED, Codec, LinkState
from cotouch.recording._columns import EXCHANGE, GUARDS, SAID, SCALARS, STATES, UNSAID, Batch
from cotouch.recording._header import RecordHeader
from cotouch.units import user_number

_LINKS = ("link_work", "age", "used", "link_state")
# What a column of integers says where there is no link.
_NONE = {"used": UNSAID, "link_state": LinkState.GUARDED}
# What is larger is no number of a recording: squares of it, times what bodies have, are not finite.
_LARGEST = 1e100
# Clocks that were never set are apart by less [s].
_OLDEST = 1e12


@final
@dataclass(frozen=True, kw_only=True)
class RecordedEvent:
    """Something that happened.

    Attributes:
        kind: what: setup, gap, closed, joined, left, guarded, coupled, budget, alarm, rate, ...
        time: when, on the user's monotonic clock [s].
        first: index of the first step after it.
        fields: what else was said.
    """

    kind: str
    time: float
    first: int
    fields: Mapping[str, Any] = field(default_factory=dict[str, Any])


class Setup(NamedTuple):
    """What the ledger of some steps depends on; see `Recorder.setup`.

    Attributes:
        first: index of the first step that it holds for.
        copies: N.
        neighbours: users at the other ends.
        strength: spring of each link [N/m for the identity weight].
        weight: index of each link's weight.
        local_damping: B_i over the weights [Ns/m].
        extra_damping: B_e over the weights [Ns/m].
        ports: node of each port; None: not said.
        tool_mass: of every proxy [kg].
        link_damping: share of B_i of each link [Ns/m]; None: not said.
        rounding: most that a coordinate of a sample may differ from what was sent [m].
        keys: of the users at the other ends; None: not said.
        initial_energies: what the tank of each link started with [J]; None: not said.
        allowance: what all tanks may get once besides, to come to where the others are [J].
        codec: how the user's samples are said; None: in full.
        law: of the links; whatever is no "spring" has no strength, and its work is as booked, judged by their sum.
    """

    first: int
    copies: int
    neighbours: tuple[int, ...]
    strength: tuple[float, ...]
    weight: tuple[int, ...]
    local_damping: tuple[float, ...]
    extra_damping: tuple[float, ...]
    ports: tuple[int, ...] | None
    tool_mass: tuple[float, ...]
    link_damping: tuple[float, ...] | None
    rounding: float
    keys: tuple[str, ...] | None = None
    initial_energies: tuple[float, ...] | None = None
    allowance: float = 0.0
    law: str = "spring"
    codec: Codec | None = None


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Recording:
    """One user's recording.

    Attributes:
        path: of the file.
        header: who and what.
        neighbours: every user that there was a link to, in the order of the entries of the columns of links.
        columns: by name, (steps, ...): those of docs/recording.md and any others; NaN (or -3, of `used`) where a step
            had no such link or value.
        states: `state_row` (the step that each state belongs to), `x`, `v`, `middle`, the last three
            (states, rows, axes).
        events: in the order in which they happened.
        broken: why the file ends early; None if it is whole.
    """

    path: str
    header: RecordHeader
    neighbours: tuple[int, ...]
    columns: Mapping[str, Array]
    states: Mapping[str, Array]
    events: tuple[RecordedEvent, ...]
    broken: str | None

    @property
    def steps(self) -> int:
        """Number of steps in it."""
        return int(self.columns["time"].size)

    @property
    def user(self) -> int:
        """Index of the user."""
        return self.header.user

    @property
    def name(self) -> str:
        """What to call the user: its name, or its number."""
        return self.header.name or f"user {user_number(self.user)}"

    @property
    def time(self) -> Float:
        """End of every step in Unix time, by this machine's clock [s]."""
        return self.columns["time"] + self.header.offset

    @property
    def cut(self) -> str | None:
        """Where and why the file ends early, in words; None if it is whole."""
        if self.broken is None:
            return None
        seconds = float(self.columns["time"][-1] - self.columns["time"][0] + self.columns["period"][0])
        return f"cut off after step {int(self.columns['index'][-1]):,}, {seconds:.2f} s from its start: {self.broken}"

    @property
    def closed(self) -> bool:
        """Whether recording ended because the user did."""
        return any(event.kind == "closed" for event in self.events)

    @cached_property
    def consecutive(self) -> Bool:
        """Whether each step follows the one before it in the recording, (steps,); the first one does not."""
        follows = np.zeros(self.steps, dtype=bool)
        follows[1:] = np.diff(self.columns["index"]) == 1
        return follows

    @property
    def missing_after(self) -> int:
        """Steps that were taken after the last one in it and are not in it, as far as it says."""
        said = [event.first for event in self.events if event.kind == "closed"]
        said += [int(event.fields.get("last", -1)) + 1 for event in self.events if event.kind == "gap"]
        return max(0, max(said, default=0) - 1 - int(self.columns["index"][-1]))

    @property
    def missing(self) -> int:
        """Steps that were taken and are not in it, as far as it says."""
        index = self.columns["index"]
        first = min([int(index[0]), *(event.first for event in self.events if event.kind == "setup")])
        return int(index[-1] - first + 1 - index.size) + self.missing_after

    @cached_property
    def setups(self) -> tuple[Setup, ...]:
        """What the ledger follows from, in order.

        Raises:
            RecordingError: there is none, or one makes no sense.
        """
        made = [_setup(event) for event in self.events if event.kind == "setup"]
        if not made:
            raise RecordingError(f"{self.path} does not say how its steps were set up; it has no event of kind setup")
        for setup in made:
            if not set(setup.neighbours) <= set(self.neighbours) and setup.first <= self.columns["index"][-1]:
                raise RecordingError(
                    f"{self.path} has a setup with links that its steps do not have: {setup.neighbours}"
                )
        return tuple(made)

    @cached_property
    def finite(self) -> int:
        """How many steps there are before the first with a number that is not finite, or whose square is not."""
        bad = self.steps
        for name in (*SCALARS, "force"):
            rows = np.flatnonzero(~(np.abs(self.columns[name].reshape(self.steps, -1)) < _LARGEST).all(axis=1))
            bad = min(bad, int(rows[0])) if rows.size else bad
        for name in ("position", "velocity", "middle"):
            values = self.states.get(name, np.zeros((0, 1)))
            if values.size:
                rows = np.flatnonzero(~(np.abs(values.reshape(values.shape[0], -1)) < _LARGEST).all(axis=1))
                bad = min(bad, int(self.states["state_row"][rows[0]])) if rows.size else bad
        return bad

    def first_steps(self, count: int) -> "Recording":
        """The same with so many steps only, as if it had been cut off there."""
        kept = int(np.searchsorted(self.states["state_row"], count))
        return replace(
            self,
            columns={name: values[:count] for name, values in self.columns.items()},
            states={name: values[:kept] for name, values in self.states.items()},
            events=tuple(event for event in self.events if event.kind != "closed"),
        )

    def setup_rows(self) -> list[tuple[Setup, slice]]:
        """Each setup with the steps it holds for."""
        index = self.columns["index"]
        starts = [int(np.searchsorted(index, setup.first)) for setup in self.setups]
        starts[0] = 0
        ends = [*starts[1:], self.steps]
        spans = zip(self.setups, starts, ends, strict=True)
        return [(setup, slice(start, end)) for setup, start, end in spans if end > start]


def recording_of(
    path: str, header: RecordHeader, batches: Sequence[Batch], events: Sequence[RecordedEvent], broken: str | None
) -> Recording:
    """Puts batches together.

    Args:
        path: of the file; for messages or to write to.
        header: who recorded what.
        batches: of steps, in order.
        events: in order.
        broken: why the file ends early; None if it does not.

    Raises:
        RecordingError: there is no step in them, or they do not fit together.
    """
    if not batches:
        raise RecordingError("it ends before its first batch of steps")
    neighbours = tuple(sorted({user for batch in batches for user in batch.neighbours}))
    counts = [batch.columns["time"].size for batch in batches]
    starts = np.concatenate([[0], np.cumsum(counts)])
    columns: dict[str, Array] = {}
    names = dict.fromkeys(name for batch in batches for name in batch.columns if name not in STATES)
    for name in names:
        if name in _LINKS or name in GUARDS or name in EXCHANGE or name == SAID:
            columns[name] = _links(name, neighbours, batches)
            continue
        entries = [batch.columns.get(name) for batch in batches]
        widest = max((entry.shape[1:] for entry in entries if entry is not None), key=lambda s: (len(s), math.prod(s)))
        columns[name] = np.concatenate(
            [_padded(entry, count, widest) for entry, count in zip(entries, counts, strict=True)]
        )
    if np.any(np.diff(columns["index"]) <= 0):
        raise RecordingError("its steps are not in order")
    if not (
        np.all(np.isfinite(columns["time"])) and np.all((columns["period"] > 0.0) & np.isfinite(columns["period"]))
    ):
        raise RecordingError("a step has a time that is not finite or a length that is not positive")
    if "age" in columns and np.any(np.abs(columns["age"]) > _OLDEST):
        raise RecordingError("a sample has an age that no clocks explain")
    held = [batch.columns for batch in batches if batch.columns.get("state_row", np.zeros(0)).size]
    states: dict[str, Array] = {"state_row": np.zeros(0, dtype=np.int64)}
    if held:
        rows = [
            start + batch.columns["state_row"].astype(np.int64)
            for start, batch in zip(starts[:-1], batches, strict=True)
            if batch.columns.get("state_row", np.zeros(0)).size
        ]
        states["state_row"] = np.concatenate(rows)
        for name in ("position", "velocity", "middle"):
            parts = [batch[name] for batch in held if name in batch]
            if len(parts) < len(held) or {part.shape[1:] for part in parts} != {(header.body.rows, header.body.axes)}:
                raise RecordingError(f"its column {name!r} does not fit the body in its header")
            states[name] = np.concatenate(parts)
    return Recording(
        path=path,
        header=header,
        neighbours=neighbours,
        columns=columns,
        states=states,
        events=tuple(events),
        broken=broken,
    )


def _links(name: str, neighbours: tuple[int, ...], batches: Sequence[Batch]) -> Array:
    """A column of links over all batches, whose links need not be the same."""
    parts: list[Array] = []
    for batch in batches:
        steps = batch.columns["time"].size
        part = (
            np.full((steps, len(neighbours)), _NONE[name])
            if name in _NONE
            else np.full((steps, len(neighbours)), np.nan)
        )
        if name in batch.columns:
            for at, user in enumerate(batch.neighbours):
                part[:, neighbours.index(user)] = batch.columns[name][:, at]
        parts.append(part)
    return np.concatenate(parts)


def _padded(entry: Array | None, count: int, shape: tuple[int, ...]) -> Array:
    if entry is not None and entry.shape[1:] == shape:
        return entry
    out = np.full((count, *shape), np.nan)
    if entry is not None:
        if entry.ndim != out.ndim or any(a > b for a, b in zip(entry.shape[1:], shape, strict=True)):
            raise RecordingError("the columns of its batches do not match")
        out[tuple(slice(0, extent) for extent in entry.shape)] = entry
    return out


def _codec(options: Any) -> Codec | None:
    """The codec that a setup names; nothing of it is believed."""
    if options is None:
        return None
    deadband, quantum, hold, age = (float(options[name]) for name in ("deadband", "quantum", "hold", "age"))
    finite = math.isfinite(quantum) and math.isfinite(age)
    if not (finite and 0.0 <= deadband < 1.0 and quantum >= 0.0 and 1 <= hold < ROUNDED and age > 0.0):
        raise ValueError(f"codec is {options!r}")
    return Codec(deadband=deadband, quantum=quantum, hold=int(hold), age=age)


def _setup(event: RecordedEvent) -> Setup:
    said = event.fields
    try:
        neighbours = tuple(int(user) for user in said["neighbours"])
        shared = said["link_damping"]
        setup = Setup(
            first=event.first,
            copies=int(said["copies"]),
            neighbours=neighbours,
            strength=tuple(map(float, said["strength"])),
            weight=tuple(map(int, said["weight"])),
            local_damping=tuple(map(float, said["local_damping"])),
            extra_damping=tuple(map(float, said["extra_damping"])),
            ports=None if said["ports"] is None else tuple(map(int, said["ports"])),
            tool_mass=tuple(map(float, said["tool_mass"])),
            link_damping=None if shared is None else tuple(map(float, shared)),
            rounding=float(said["rounding"]),
            keys=None if said.get("keys") is None else tuple(map(str, said["keys"])),
            initial_energies=None
            if said.get("initial_energies") is None
            else tuple(map(float, said["initial_energies"])),
            allowance=float(said.get("allowance", 0.0)),
            law=str(said.get("law", "spring")),
            codec=_codec(said.get("codec")),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise RecordingError(f"a setup of the recording cannot be read: {error!r}") from None
    sizes = {len(neighbours), len(setup.strength), len(setup.weight)}
    sizes |= {len(more) for more in (setup.keys, setup.initial_energies) if more is not None}
    if len(sizes) > 1 or setup.copies < 1:
        raise RecordingError(f"a setup of the recording has {len(neighbours)} neighbours and lists of other lengths")
    return setup
