"""`cotouch replay`."""

import sys
from pathlib import Path
from typing import TypedDict

import numpy as np
from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.live import Live
from rich.table import Table

from cotouch.arrays import Float
from cotouch.cli._output import literal, number, print_json
from cotouch.peer import LinkState
from cotouch.recording import Recording, read_recording, replay
from cotouch.units import user_number

# Of the table, while it plays; and of the lines where there is no terminal, in seconds of the recording.
_REFRESH = 10.0
_LINE = 1.0
# Rate and residual are taken over so much of the recording [s].
_WINDOW = 0.5


def run(path: Path, *, speed: float, start: float, stop: float | None, as_json: bool) -> None:
    """Plays one user's recording as a table, as lines without a terminal, or only sums it up.

    Args:
        path: of the file to read.
        speed: a factor.
        start: in the recording [s].
        stop: likewise; None: the end.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    recording = read_recording(path)
    if as_json:
        print_json(_summary(recording))
        return
    steps = replay(recording, speed=speed, start=start, stop=float("inf") if stop is None else stop)
    shown = -float("inf")
    if not sys.stdout.isatty():
        for step in steps:
            if step.time >= shown + _LINE:
                shown = step.time
                sys.stdout.write(_line(recording, step.row, step.time) + "\n")
                sys.stdout.flush()
    else:
        row, time = 0, 0.0
        with Live(refresh_per_second=_REFRESH, transient=True) as live:
            for step in steps:
                row, time = step.row, step.time
                if time >= shown + speed / _REFRESH:
                    shown = time
                    live.update(_table(recording, row, time))
        Console().print(_table(recording, row, time))
    if recording.broken is not None or recording.missing:
        sys.stderr.write(f"{_gaps(recording)}\n")


def _gaps(recording: Recording) -> str:
    missing = f"{recording.missing} steps are missing" if recording.missing else ""
    if recording.cut is None:
        return f"in {recording.path} {missing}"
    return f"{recording.path} is {'; '.join(filter(None, (recording.cut, missing)))}"


class _Link(TypedDict):
    neighbour: int
    age: float
    state: str
    work: float


class _Now(TypedDict):
    rate: float
    period: float
    force: float
    residual: float
    stored: float
    links: list[_Link]


def _now(recording: Recording, row: int) -> _Now:
    """What there is to say of one step and those just before it."""
    columns = recording.columns
    end = float(columns["time"][row])
    first = int(np.searchsorted(columns["time"], end - _WINDOW, side="right"))
    own = slice(first, row + 1)
    span = end - float(columns["time"][first] - columns["period"][first])
    return {
        "rate": (row + 1 - first) / span,
        "period": float(columns["period"][row]),
        "force": float(_forces(recording, slice(row, row + 1))[0]),
        "residual": float(np.abs(columns["residual"][own]).max()),
        "stored": sum(float(columns[name][row]) for name in ("kinetic", "elastic", "proxy", "touch_stored")),
        "links": [
            {
                "neighbour": user,
                "age": float(columns["age"][row, entry]),
                "state": _state(int(columns["link_state"][row, entry]), float(columns["age"][row, entry])),
                "work": float(np.nansum(columns["link_work"][own, entry])),
            }
            for entry, user in enumerate(recording.neighbours)
        ],
    }


def _forces(recording: Recording, rows: slice) -> Float:
    """Of the hands on the copy and on its proxies, as a whole, in some steps; what the live table shows [N]."""
    columns = recording.columns
    force = columns["force"][rows].sum(axis=1)
    if "drive_force" in columns:
        force = force + columns["drive_force"][rows].sum(axis=1)[:, : force.shape[1]]
    return np.linalg.norm(force, axis=-1)


def _state(code: int, age: float) -> str:
    if not np.isfinite(age):
        return "no link"
    return LinkState(code).name.lower() if code in list(LinkState) else f"state {code}"


def _age(age: float, unit: str = "") -> str:
    """In ms; nothing where there is no link."""
    return number(1e3 * age, unit, 3) if np.isfinite(age) else ""


def _line(recording: Recording, row: int, time: float) -> str:
    now = _now(recording, row)
    links = ", ".join(
        " ".join(filter(None, (f"{user_number(link['neighbour'])}:", _age(link["age"], "ms"), link["state"])))
        for link in now["links"]
    )
    return (
        f"{time:9.3f} s  {number(now['rate'], 'Hz')}  period {number(1e3 * now['period'], 'ms', 3)}  "
        f"force {number(now['force'], 'N', 3)}  residual {number(now['residual'], 'J', 2)}  [{links}]"
    )


def _table(recording: Recording, row: int, time: float) -> Table:
    now = _now(recording, row)
    caption = (
        f"{number(now['rate'], 'Hz')} · period {number(1e3 * now['period'], 'ms', 3)} · "
        f"force {number(now['force'], 'N', 3)} · stored {number(now['stored'], 'J', 3)} · "
        f"residual {number(now['residual'], 'J', 2)}"
    )
    title = f"{literal(recording.name)}, {time:.2f} s of {_seconds(recording):.2f} s"
    table = Table(title=title, caption=caption, box=SIMPLE_HEAD, title_justify="left", caption_justify="left")
    table.add_column("neighbour")
    table.add_column("link")
    table.add_column("age\nms", justify="right")
    table.add_column(f"work in {_WINDOW:g} s\nJ", justify="right")
    for link in now["links"]:
        table.add_row(
            str(user_number(link["neighbour"])),
            link["state"],
            _age(link["age"]),
            number(link["work"]),
        )
    return table


def _seconds(recording: Recording) -> float:
    columns = recording.columns
    return float(columns["time"][-1] - columns["time"][0] + columns["period"][0])


def _summary(recording: Recording) -> dict[str, object]:
    columns = recording.columns
    periods, force = columns["period"], _forces(recording, slice(None))
    counts: dict[str, int] = {}
    for event in recording.events:
        counts[event.kind] = counts.get(event.kind, 0) + 1
    return {
        "file": recording.path,
        "user": user_number(recording.user),
        "name": recording.name,
        "session": recording.header.session,
        "version": recording.header.version,
        "whole": recording.broken is None,
        "broken": recording.broken,
        "last_step": int(columns["index"][-1]),
        "steps": recording.steps,
        "missing_steps": recording.missing,
        "seconds": _seconds(recording),
        "rate_hz": recording.steps / float(periods.sum()),
        "period_s": {"min": float(periods.min()), "mean": float(periods.mean()), "max": float(periods.max())},
        "peak_force_n": float(force.max(initial=0.0)),
        "residual_j": float(np.abs(columns["residual"]).max()),
        "supplied_j": float(columns["supplied"].sum() + columns["drive_work"].sum()),
        "links": [
            {"neighbour": user_number(user), **_ages(columns["age"][:, entry])}
            for entry, user in enumerate(recording.neighbours)
        ],
        "events": counts,
    }


def _ages(age: Float) -> dict[str, float | None]:
    known = age[np.isfinite(age)]
    if known.size == 0:
        return {"age_p50_s": None, "age_p99_s": None, "age_max_s": None}
    middle, high, most = np.quantile(known, [0.5, 0.99, 1.0])
    return {"age_p50_s": float(middle), "age_p99_s": float(high), "age_max_s": float(most)}
