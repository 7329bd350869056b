"""Measured latencies: a column of a CSV file instead of random numbers."""

import csv
from pathlib import Path
from typing import Annotated, Literal, Self, final

import numpy as np
from pydantic import ConfigDict, Field, model_validator

from cotouch.arrays import Float, Long
from cotouch.errors import ScenarioError
from cotouch.files import read_text
from cotouch.scenario._tables import Positive, Table

_MOST_BYTES = 64_000_000
_MOST_ROWS = 2_000_000
# No clock of any unit shows more; twice that is a number still.
_MOST = 1e100
_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6}
Unit = Literal["s", "ms", "us"]


@final
class Trace:
    """Latencies in the order in which they were measured.

    Attributes:
        time: of sending, from 0 on, (rows,) [s]; None: each row is of one message.
        latency: one way, (rows,) [s].
        loop: whether it begins anew after its end, and may begin anywhere.
        span: how long it lasts, with the gap before it begins anew [s]; messages, where each row is of one.
    """

    def __init__(self, time: Float | None, latency: Float, *, loop: bool) -> None:
        """Takes up arrays that were checked."""
        self.time = time
        self.latency = latency
        self.loop = loop
        self.span = float(latency.size)
        if time is not None:
            self.span = float(time[-1] + (np.median(np.diff(time)) if time.size > 1 else 0.0))
        self._round = None if time is None else (np.append(time, self.span), np.append(latency, latency[0]))

    def of(self, sent: Float, start: float) -> Float:
        """Latency of every message of one direction of a link, (messages,) [s].

        Between rows it changes evenly, as a queue fills and empties.

        Args:
            sent: when, (messages,), increasing [s].
            start: share of the trace, from 0 to 1, at which the first message finds it.

        Raises:
            ScenarioError: the trace ends before the run and does not begin anew.
        """
        if not self.loop:
            last = float(sent.size if self.time is None else sent[-1])
            if last > self.span * (1.0 + 1e-9):
                unit = "messages" if self.time is None else "s"
                raise ScenarioError(
                    f"channel.trace lasts {self.span:.6g} {unit} and the run {last:.6g}; shorten the run, or let the "
                    "trace begin anew with loop = true"
                )
            start = 0.0
        if self.time is None:
            return self.latency[self._row(start, np.arange(sent.size))]
        if not self.loop:
            return np.interp(sent, self.time, self.latency)
        return self._between(start, sent)

    def one(self, since: float, number: int, start: float) -> float:
        """Latency of one message, as long as the trace begins anew [s].

        Args:
            since: when it is sent, after the first [s].
            number: how many were sent before it.
            start: as `of` has it.
        """
        if self.time is None:
            return float(self.latency[self._row(start, np.array(number))])
        return float(self._between(start, np.array(since)))

    def _row(self, start: float, number: Long) -> Long:
        return (int(start * self.latency.size) + number) % self.latency.size

    def _between(self, start: float, since: Float) -> Float:
        assert self._round is not None
        time, latency = self._round
        at = (start * self.span + since) % self.span if self.span else 0.0 * since
        return np.interp(at, time, latency)


@final
class TraceTable(Table):
    """A column of measured latencies, on every link; each direction begins at a place of its own.

    Attributes:
        file: CSV with names in its first row.
        column: of latencies.
        as_: "rtt", of which a message takes half, or "one-way".
        unit: of the column; by default what its name ends in: "_s", "_ms" or "_us".
        time: column of sending times, in seconds unless its name ends otherwise; by default each row is of one message.
        loop: whether the trace begins anew after its end.
        most: a latency beyond it is taken for a mistake [s].
    """

    model_config = ConfigDict(populate_by_name=True)

    file: str
    column: str
    as_: Annotated[Literal["rtt", "one-way"], Field(alias="as")]
    unit: Unit | None = None
    time: str | None = None
    loop: bool = True
    most: Positive = 5.0

    @model_validator(mode="after")
    def _has_unit(self) -> Self:
        if self.unit is None and _unit_of(self.column) is None:
            raise ValueError(f'column is "{self.column}", which does not end in a unit; give unit = "s", "ms" or "us"')
        return self

    def read(self) -> Trace:
        """Reads the file.

        Raises:
            ScenarioError: it cannot be read, has no rows or no such column, or a value cannot be.
        """
        path = Path(self.file)
        text = read_text(path, "trace", ScenarioError, _MOST_BYTES)
        rows = csv.reader(text.splitlines(), skipinitialspace=True)
        try:
            names = [name.strip() for name in next(rows, list[str]())]
            numbered = [(rows.line_num, row) for row in rows if row]
        except csv.Error as error:
            raise ScenarioError(f"the trace {path} cannot be read: {error}") from None
        lines, kept = [line for line, _ in numbered], [row for _, row in numbered]
        if not kept:
            raise ScenarioError(f"{path} has no rows; a trace needs names in its first row and a latency in each other")
        if len(kept) > _MOST_ROWS:
            raise ScenarioError(f"{path} has {len(kept)} rows; a trace may have {_MOST_ROWS}")
        scale = _UNITS[self.unit or _unit_of(self.column) or "s"]
        latency = scale * self._numbers(path, names, lines, kept, self.column)
        worst = int(latency.argmax())
        if latency[worst] > self.most:
            raise ScenarioError(
                f"{path}: {self.column} in line {lines[worst]} is {latency[worst]:.6g} s; if that is no mistake and "
                f"its unit is right, set channel.trace.most above it (it is {self.most:g} s)"
            )
        time = None
        if self.time is not None:
            time = _UNITS[_unit_of(self.time) or "s"] * self._numbers(path, names, lines, kept, self.time)
            back = np.flatnonzero(np.diff(time) <= 0.0)
            if back.size:
                line = lines[int(back[0]) + 1]
                raise ScenarioError(f"{path}: {self.time} does not grow in line {line}; keep one measurement in a file")
            time = time - time[0]
        return Trace(time, (0.5 if self.as_ == "rtt" else 1.0) * latency, loop=self.loop)

    def _numbers(self, path: Path, names: list[str], lines: list[int], rows: list[list[str]], column: str) -> Float:
        """A column, each number finite, at least 0, and no more than a run could ever reach."""
        if column not in names:
            raise ScenarioError(f'{path} has no column "{column}"; its first row names {", ".join(names)[:200]}')
        if names.count(column) > 1:
            raise ScenarioError(f'{path} has {names.count(column)} columns "{column}"; give each a name of its own')
        at = names.index(column)
        fields = [row[at].strip() if at < len(row) else "" for row in rows]
        values = np.array([_number(field) for field in fields])
        wrong: Long = np.flatnonzero(~((values >= 0.0) & (values < _MOST)))
        if wrong.size:
            first = int(wrong[0])
            raise ScenarioError(
                f'{path}: {column} in line {lines[first]} is "{fields[first][:40]}"; it must be a finite number, at '
                "least 0"
            )
        return values


def _number(field: str) -> float:
    try:
        return float(field)
    except ValueError:
        return float("nan")


def _unit_of(column: str) -> Unit | None:
    for unit in ("ms", "us", "s"):
        if column.endswith(f"_{unit}"):
            return unit
    return None
