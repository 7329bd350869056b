"""Recordings as one `xarray.Dataset`, with the names and units of a simulated run."""

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from cotouch.arrays import Array, Float
from cotouch.errors import RecordingError
from cotouch.files import write_netcdf
from cotouch.peer import LinkState
from cotouch.recording._columns import CLOSING, EXCHANGE, GUARDS, HOW_SAID, JAMMED, SAID, VECTORS
from cotouch.recording._links import align
from cotouch.recording._recording import Recording
from cotouch.recording._slack import slack_of
from cotouch.units import user_number

if TYPE_CHECKING:
    import xarray as xr


# Fills a variable: its name, dimensions, values by user or direction, unit and meaning.
_Put: TypeAlias = Callable[[str, tuple[str, ...], Sequence[tuple[int, Array]], str, str], None]
_AXES = ("x", "y", "z")
# Energies that a run has as sums so far, and a recording step by step.
_SUMS = {
    "supplied": "work of a user's hands so far",
    "body_loss": "dissipated so far by the body's own dampers",
    "local_loss": "dissipated so far by the damping B_i of the synchronisation",
    "extra_loss": "dissipated so far by the extra damping B_e",
    "drive_work": "work so far on the proxies by what pulls them",
    "touch_work": "work so far on the body by contacts and grasps",
    "touch_loss": "dissipated so far in contacts and grasps",
    "cut": "lost so far with the elements that were cut",
    "residual": "what the ledger does not explain so far: zero but for round-off",
}
_PLAIN = {
    "kinetic": ("J", "kinetic energy of the copy"),
    "elastic": ("J", "elastic energy of the copy"),
    "proxy": ("J", "kinetic energy of the proxies"),
    "touch_stored": ("J", "energy in contacts and grasps"),
    "iterations": ("1", "iterations of the solver in the step; 0 where it is a closed form"),
}
# Of bodies with a material.
_CLOSED_SUMS = {"world_loss": "of body_loss: lost so far in friction and damping at obstacles and between bodies"}
_CLOSED = {
    "closure": ("J", "work of the velocity correction that closed the step; in no other variable"),
    "closure_factor": ("1", "relative change of the velocity by it, |beta - 1|"),
    "shortened": ("1", "fraction of the step that was given up to close it"),
    "world_stored": ("J", "of elastic: held by obstacles and between bodies"),
}
_TOOLS = {
    "tool_position": ("m", "position y of a proxy"),
    "tool_velocity": ("m/s", "velocity w of a proxy"),
    "drive_force": ("N", "mean force over the step of what drives a proxy"),
    "touch_force": ("N", "mean force over the step of contacts or grasp on a proxy"),
}


def recordings_dataset(recordings: Sequence[Recording]) -> "xr.Dataset":
    """Several users' recordings of one session, side by side.

    Args:
        recordings: of different users.

    Returns:
        As `cotouch.simulation.simulate` does: dimensions `user`, `step` (a user's own steps; 0 is the state before the
        first; NaN after its last), `node`, `axis`, `direction` (a receiver's view of a neighbour, "1<-2") and, with
        tools, `tool` and `space`. Coordinates beside them: `time` of every user's steps, `receiver` and `sender` of a
        direction, by name. Where every neighbour's recording is given and has every state, `slack` over `tick`, the
        steps of the user who took most, with `tick_time`. Where not every state is recorded, `position` and `velocity`
        have a dimension `state` instead of `step`, and `state_time`. Time counts from the beginning of the first step
        of all; the attribute `unix_start` says when that was.

    Raises:
        RecordingError: they do not belong together.
    """
    import xarray as xr

    recordings = sorted(recordings, key=lambda recording: recording.user)
    if len({recording.user for recording in recordings}) < len(recordings):
        raise RecordingError("two of the recordings are of the same user; give one of each")
    rest = recordings[0].header.body.rest
    if any(recording.header.body.rest.shape != rest.shape for recording in recordings):
        raise RecordingError("the recordings are of bodies of different sizes; give recordings of one session")
    offsets, _ = align(recordings)
    begins = [
        float(recording.columns["time"][0] - recording.columns["period"][0]) + offset
        for recording, offset in zip(recordings, offsets, strict=True)
    ]
    start = min(begins)
    users = len(recordings)
    records = 1 + max(recording.steps for recording in recordings)
    data: dict[str, tuple[tuple[str, ...], Array, dict[str, str]]] = {}

    def put(name: str, dims: tuple[str, ...], parts: Sequence[tuple[int, Array]], unit: str, text: str) -> None:
        """Fills what each user (or direction) has into a column padded with NaN."""
        extents = np.max([np.shape(values)[1:] for _, values in parts], axis=0).astype(int)
        length = records if dims[1] == "step" else max(len(values) for _, values in parts)
        first = users if dims[0] == "user" else max(at for at, _ in parts) + 1
        out = np.full((first, length, *extents), np.nan)
        for at, values in parts:
            out[(at, *(slice(0, extent) for extent in np.shape(values)))] = values
        data[name] = (dims, out, {"units": unit, "long_name": text})

    def column(name: str, dims: tuple[str, ...], unit: str, text: str) -> None:
        """One of the recorded columns, with NaN for the state before the first step."""
        parts = [
            (at, _shifted(recording.columns[name]))
            for at, recording in enumerate(recordings)
            if name in recording.columns
        ]
        if parts:
            put(name, dims, parts, unit, text)

    times = [
        np.concatenate([[begin - start], recording.columns["time"] + offset - start])
        for recording, begin, offset in zip(recordings, begins, offsets, strict=True)
    ]
    put("time", ("user", "step"), list(enumerate(times)), "s", "end of the step on the shared clock")
    periods = [_shifted(recording.columns["period"]) for recording in recordings]
    put("period", ("user", "step"), list(enumerate(periods)), "s", "length T of the step")
    closed = any(recording.header.body.material is not None for recording in recordings)
    for name, text in (_SUMS | (_CLOSED_SUMS if closed else {})).items():
        sums = [np.concatenate([[0.0], np.cumsum(recording.columns[name])]) for recording in recordings]
        put(name, ("user", "step"), list(enumerate(sums)), "J", text)
    for name, (unit, text) in (_PLAIN | (_CLOSED if closed else {})).items():
        column(name, ("user", "step"), unit, text)
    bodies = [(at, _shifted(r.columns[CLOSING])) for at, r in enumerate(recordings) if CLOSING in r.columns]
    if bodies:
        factors = [(at, values[:, :, 0]) for at, values in bodies]
        centres = [(at, values[:, :, 1:]) for at, values in bodies]
        put(
            "body_factor",
            ("user", "step", "body"),
            factors,
            "1",
            "factor by which closing the step scaled each body's velocity",
        )
        put("body_centre", ("user", "step", "body", "space"), centres, "m/s", "velocity about which that factor acted")
    forces = [_shifted(_force(recording)) for recording in recordings]
    put("force", ("user", "step", "axis"), list(enumerate(forces)), "N", "sum of the mean forces at a user's ports")
    for name, (unit, text) in _TOOLS.items():
        column(name, ("user", "step", "tool", "space"), unit, text)
    directions = [(at, entry) for at, recording in enumerate(recordings) for entry in range(len(recording.neighbours))]
    ledger = GUARDS | EXCHANGE | {SAID: HOW_SAID}
    if directions:
        for name, unit, text in (
            ("link_work", "J", "work of the link on its receiver so far"),
            ("age", "s", "age of the sample used, by uncorrected clocks"),
            ("used", "1", "index of the sample used; < 0 if it has none"),
            (
                "link_state",
                "1",
                "of the link's end: " + ", ".join(f"{state.value} {state.name.lower()}" for state in LinkState),
            ),
            *((name, *said) for name, said in ledger.items() if any(name in r.columns for r in recordings)),
        ):
            parts: list[tuple[int, Float]] = []
            for k, (at, entry) in enumerate(directions):
                if name not in recordings[at].columns:
                    continue
                values = recordings[at].columns[name][:, entry].astype(float)
                first = np.concatenate([[0.0], np.cumsum(np.nan_to_num(values))])
                parts.append((k, first if name == "link_work" else _shifted(values)))
            put(name, ("direction", "step"), parts, unit, text)
    _states(recordings, times, put)
    known = {*data, *_TOOLS, *_CLOSED, CLOSING, "index"}
    extra = [name for recording in recordings for name in recording.columns if name not in known and name not in ledger]
    for name in dict.fromkeys(extra):
        unit, text = next(
            (r.header.columns[name] for r in recordings if name in r.header.columns),
            VECTORS[JAMMED][:2] if name == JAMMED else ("1", "as recorded"),
        )
        wide = max(r.columns[name].ndim for r in recordings if name in r.columns) - 1
        column(name, ("user", "step", *(f"{name}_{k}" for k in range(wide))), unit, text)
    spare = slack_of(recordings, offsets)
    if spare is not None:
        meaning = "lost so far in the damping B_i, less what the age of samples added: the slack of inequality (7)"
        data["slack"] = (("tick",), spare.energy, {"units": "J", "long_name": meaning})
        of_ticks = {"units": "s", "long_name": "time of the network-wide records"}
        data["tick_time"] = (("tick",), spare.time - start, of_ticks)
    who = {recording.user: recording.name for recording in recordings}
    receivers = [recordings[at].name for at, _ in directions]
    others = [recordings[at].neighbours[entry] for at, entry in directions]
    senders = [who.get(other, f"user {user_number(other)}") for other in others]
    names = [f"{user_number(recordings[at].user)}<-{user_number(recordings[at].neighbours[e])}" for at, e in directions]
    return xr.Dataset(
        data,
        coords={
            "user": [recording.name for recording in recordings],
            "axis": list(_AXES[: rest.shape[1]]),
            "node": np.arange(1, rest.shape[0] + 1),
            **({"direction": np.array(names, dtype=np.str_)} if names else {}),
            **({"receiver": ("direction", receivers), "sender": ("direction", senders)} if names else {}),
            **({"space": list(_AXES)} if {"tool_position", "body_centre"} & data.keys() else {}),
        },
        attrs=_attributes(recordings, users, start),
    ).set_coords([name for name in ("time", "tick_time", "state_time") if name in data])


def save_dataset(run: "xr.Dataset", path: str | Path) -> None:
    """Writes a dataset to a NetCDF 4 file, compressed, whole or not at all.

    Args:
        run: the dataset.
        path: of the file; for messages or to write to.

    Raises:
        OutputError: the file cannot be written, or its name does not end in ".nc", ".nc4", ".h5" or ".hdf5".
    """
    write_netcdf(run, path, "recordings")


def _shifted(values: Array) -> Float:
    """With a row of NaN for the state before the first step."""
    return np.concatenate([np.full((1, *values.shape[1:]), np.nan), values])


def _force(recording: Recording) -> Float:
    """Sum over a user's ports, (steps, axes); of a body in the full form a port is one axis of a node."""
    force, body = recording.columns["force"], recording.header.body
    axes = body.rest.shape[1]
    if body.full and axes > 1 and force.shape[1] % axes == 0:
        return force[:, :, 0].reshape(force.shape[0], -1, axes).sum(axis=1)
    return force.sum(axis=1) if force.shape[1] else np.zeros((force.shape[0], axes))


def _states(recordings: Sequence[Recording], times: Sequence[Float], put: _Put) -> None:
    every = all(recording.states["state_row"].size == recording.steps for recording in recordings)
    dims = ("user", "step" if every else "state", "node", "axis")
    places, rates, moments = list[tuple[int, Float]](), list[tuple[int, Float]](), list[tuple[int, Float]]()
    for at, (recording, time) in enumerate(zip(recordings, times, strict=True)):
        states, body = recording.states, recording.header.body
        if states["state_row"].size == 0:
            continue
        x, v, middle = states["position"], states["velocity"], states["middle"]
        if every:  # the state before the first step follows from it
            mean = 2.0 * (x[:1] - middle[:1]) / recording.columns["period"][0]
            x = np.concatenate([2.0 * middle[:1] - x[:1], x])
            v = np.concatenate([2.0 * mean - v[:1], v])
        places.append((at, body.rest + body.nodes(x)))
        rates.append((at, body.nodes(v)))
        moments.append((at, time[1 + states["state_row"]]))
    if places:
        put("position", dims, places, "m", "position x of a node")
        put("velocity", dims, rates, "m/s", "velocity v of a node")
        if not every:
            put("state_time", ("user", "state"), moments, "s", "end of the step whose state is recorded")


def _attributes(recordings: Sequence[Recording], users: int, start: float) -> dict[str, object]:
    first = recordings[0]
    return {
        "title": str(first.header.configuration.get("title", "")) or "cotouch session",
        "source": first.header.version,
        "session": first.header.session,
        "configuration": json.dumps(dict(first.header.configuration)),
        "unix_start": start + first.header.offset,
        "users": [user_number(recording.user) for recording in recordings],
        "steps": [recording.steps for recording in recordings],
        "missing_steps": [recording.missing for recording in recordings],
        "broken": json.dumps([recording.broken for recording in recordings]),
        "events": json.dumps(
            [
                {"user": user_number(recordings[at].user), "kind": event.kind, "time": event.time, **event.fields}
                for at in range(users)
                for event in recordings[at].events
            ]
        ),
    }
