"""What a run says about the architecture: how soon users agree, how well forces balance, where energy went."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Bool, Float
from cotouch.body import Body
from cotouch.device import PRESETS
from cotouch.scenario import DEFAULT_RATE
from cotouch.simulation._run_tables import DeviceEntry, Span, tables_of
from cotouch.simulation._summary_tables import Judged, Numbers, RigidToolSummary, StateAtTime, Summary, ToolSummary

if TYPE_CHECKING:
    import xarray as xr


_BAND = 0.02
# A signal that still moves in this last part of the window has not settled, however near its last value it is.
_QUIET = 0.1
# Share of the energy through a coupling that rounding may put on its account.
_ROUNDING = 1e-10


def hold_window(run: "xr.Dataset") -> tuple[float, float]:
    """From the last hand's or tool's grip to the first release: the time in which users hold against each other [s].

    Without them, or where nothing is left between the two, the whole run.
    """
    end = float(np.nanmax(run["time"].values))
    tables = tables_of(run)
    tools = tables.get("tools", [])
    both = [*tools, *tables.get("rigid_tools", [])]
    hands: list[Span] = [*tables["hands"], *tools, *(tool["hand"] for tool in both if tool["hand"])]
    begin = max((float(hand["begin"]) for hand in hands), default=0.0)
    release = min((float(hand["release"]) for hand in hands if hand["release"] is not None), default=end)
    release = min(release, end)
    return (begin, release) if begin < release else (0.0, end)


def settling_time(
    run: "xr.Dataset",
    variable: str = "position",
    *,
    start: float | None = None,
    stop: float | None = None,
    band: float = _BAND,
) -> float | None:
    """Time after `start` from which every user stays within a band around where it ends.

    Args:
        run: a result of `simulate`.
        variable: "position" or "force".
        start: of the window [s]; by default as `hold_window`.
        stop: of the window [s]; likewise.
        band: share of the largest distance from the final value within the window, over all users.

    Returns:
        Seconds, or None if the signal has not settled before the last tenth of the window.
    """
    window = hold_window(run)
    start = window[0] if start is None else start
    stop = window[1] if stop is None else stop
    distances: list[Float] = []
    times: list[Float] = []
    for user in range(run.sizes["user"]):
        time = run["time"].values[user]
        # The force of step k is its mean over the step; the step that ends after `stop` may straddle a release.
        inside = np.flatnonzero((time >= start) & (time <= stop * (1.0 + 1e-12)))
        if variable == "force":
            inside = inside[inside > 0]
        if inside.size < 2:
            return None
        values = run[variable].values[user][inside].reshape(inside.size, -1)
        distances.append(np.sqrt(((values - values[-1]) ** 2).sum(axis=1)))
        times.append(time[inside])
    largest = max(float(distance.max()) for distance in distances)
    if not np.isfinite(largest):
        return None
    if largest == 0.0:
        return 0.0
    settled = start
    for time, distance in zip(times, distances, strict=True):
        outside = np.flatnonzero(distance > band * largest)
        if outside.size:
            settled = max(settled, float(time[min(int(outside[-1]) + 1, time.size - 1)]))
    return None if settled > stop - _QUIET * (stop - start) else settled - start


def at_times(run: "xr.Dataset", variable: str, times: Float) -> Float:
    """A variable of every user at common times, straight between its own steps, (times, users, ...).

    Args:
        run: a result of `simulate`.
        variable: of users and steps.
        times: at which it is wanted [s].
    """
    columns: list[Float] = []
    for user in range(run.sizes["user"]):
        time = run["time"].values[user]
        known = np.isfinite(time)
        values = run[variable].values[user][known]
        flat = values.reshape(values.shape[0], -1)
        if flat.shape[0] == times.size and np.array_equal(time[known], times):
            columns.append(values)
            continue
        lines: list[Float] = [np.interp(times, time[known], flat[:, c]) for c in range(flat.shape[1])]
        moved = np.stack(lines, axis=1)
        columns.append(moved.reshape(times.size, *values.shape[1:]))
    return np.stack(columns, axis=1)


def distances(positions: Float, gone: Bool) -> Float:
    """Distance of each copy of a node from the mean of those that are not debris.

    Args:
        positions: (times, users, nodes, axes) [m].
        gone: which are debris, (times, users, nodes).

    Returns:
        Likewise [m]; NaN of debris.
    """
    there = ~gone[..., None]
    count = np.maximum(there.sum(axis=1, keepdims=True), 1)
    gap = positions - positions.sum(axis=1, keepdims=True, where=there) / count
    return np.where(gone, np.nan, np.sqrt((gap**2).sum(axis=-1)))


def discrepancy(run: "xr.Dataset") -> dict[str, float]:
    """How far the copies are apart: distance of a user's node from the mean over users [m].

    A node counts in a copy until it has lost its last element there: debris lies wherever each copy happened to be.

    Returns:
        `rms`, `p99` and `max` over users, recorded nodes and network-wide records.
    """
    times = run["tick_time"].values
    positions = at_times(run, "position", times)
    gone = np.zeros(positions.shape[:-1], dtype=np.bool_)
    if "debris_time" in run:
        gone |= times[:, None, None] >= run["debris_time"].values
    if gone.all():
        return {"rms": 0.0, "p99": 0.0, "max": 0.0}
    distance = distances(positions, gone)[~gone]
    return {
        "rms": float(np.sqrt((distance**2).mean())),
        "p99": float(np.quantile(distance, 0.99)),
        "max": float(distance.max()),
    }


def force_imbalance(run: "xr.Dataset", body: Body, time: float) -> float | None:
    """`|Σ_i f_i - K (x̄ - x_d)|` at a time [N]; 0 at rest [Lee & Huang 2010, eq. 6]; None unless all nodes are kept.

    Of a material, whose forces K does not give, it is None too.

    With tools, whose forces are spread over the skin, both sides are summed over the nodes.

    Args:
        run: a result of `simulate`.
        body: that was run.
        time: at which it is wanted [s].
    """
    if run.sizes["node"] != body.nodes or body.truncation is not None or body.material is not None:
        return None
    moment = np.array([time])
    mean = at_times(run, "position", moment)[0].mean(axis=0)
    balance = -body.apply(body.stiffness, mean - body.rest)
    if "tool" in run.sizes:
        return float(np.linalg.norm(balance.sum(axis=0) + _forces_at(run, time).sum(axis=0)))
    for index, hand in enumerate(tables_of(run)["hands"]):
        balance[hand["node"] - 1] += run["hand_force"].values[index, _step_at(run, hand["user"] - 1, time)]
    return float(np.sqrt((balance**2).sum()))


def felt(run: "xr.Dataset") -> Float:
    """Force that each tool puts on its user's hand, (tool, step, axis) [N].

    With a device it is what the motors hold, without one what the hand's spring and damper pull with.
    """
    force = -run["drive_force"].values
    if "device_force" in run:
        held = run["device_force"].values
        force = np.where(np.isfinite(held), held, force)
    return force


def tool_summary(run: "xr.Dataset") -> list[ToolSummary]:
    """What each tool and its device came to, ready for JSON.

    Of each: its user's number, what it is, the largest force that the hand felt and the mean while in contact, the most
    contacts (or nodes held), the time in contact; for one with a device whether its coupling was passive, the root of
    the mean square of the force that its motors held, and what a preset's motors can hold all the time.
    """
    tables = tables_of(run).get("tools", [])
    if not tables:
        return []
    sizes = np.linalg.norm(felt(run), axis=-1)
    result: list[ToolSummary] = []
    for index, table in enumerate(tables):
        time = run["time"].values[table["user"] - 1]
        last = int(np.isfinite(time).sum())
        force, touching = sizes[index, :last], run["touching"].values[index, :last]
        span = np.where(touching > 0.0, np.diff(time[:last], prepend=0.0), 0.0)
        held = float(span.sum())
        device = table["device"]
        entry: ToolSummary = {
            "user": table["user"],
            "kind": table["kind"],
            "device": None if device is None else _device(device),
            "peak_force_n": float(force.max()),
            "mean_force_n": float(force @ span) / held if held > 0.0 else 0.0,
            "most_contacts": int(touching.max()),
            "contact_time_s": held,
        }
        if device is not None:
            excess = float(run["coupling_excess"].values[index, last - 1])
            bound = float(run["coupling_bound"].values[index])
            flows = [float(np.abs(run[name].values[index, :last]).max()) for name in ("device_work", "coupling_work")]
            held_force = np.linalg.norm(np.nan_to_num(run["device_force"].values[index, :last]), axis=-1)
            length = np.diff(time[:last], prepend=0.0)
            entry.update(
                {
                    "rms_force_n": float(np.sqrt(held_force**2 @ length / length.sum())),
                    "continuous_force_n": PRESETS[device["preset"]].continuous_force if device["preset"] else None,
                    "coupling": {
                        "law": device["coupling"],
                        "excess_j": excess,
                        "bound_j": bound,
                        "passive": excess <= bound + _ROUNDING * max(flows),
                    },
                }
            )
        result.append(entry)
    return result


def rigid_tool_summary(run: "xr.Dataset") -> list[RigidToolSummary]:
    """What the hands on rigid tools felt, ready for JSON: each one's user, shape, largest force and torque."""
    tables = tables_of(run).get("rigid_tools", [])
    force, torque = (
        np.linalg.norm(np.nan_to_num(run[variable].values), axis=-1).max(axis=-1) if tables else np.zeros(0)
        for variable in ("rigid_force", "rigid_torque")
    )
    return [
        {
            "user": table["user"],
            "kind": table["kind"],
            "peak_force_n": float(force[index]),
            "peak_torque_nm": float(torque[index]),
        }
        for index, table in enumerate(tables)
    ]


def _device(table: DeviceEntry) -> str:
    """A device in a few words."""
    phantom = table["kind"] == "phantom" or (table["kind"] is None and table["preset"] == "phantom")
    name = "phantom" if phantom else table["preset"] or "cartesian"
    if table["coupling"] == "host_force":
        return name
    if table["periods"]:
        low, high = 1.0 / max(table["periods"]), 1.0 / min(table["periods"])
        return f"{name} {low:.4g}–{high:.4g} Hz" if low < high else f"{name} {low:.4g} Hz"
    rate = table["rate"] or (PRESETS[table["preset"]].rate if table["preset"] else DEFAULT_RATE)
    return f"{name} {rate:.4g} Hz"


def summary(run: "xr.Dataset", body: Body) -> Summary:
    """The figures of a run that fit on one screen, ready for JSON.

    Args:
        run: a result of `simulate`.
        body: that was run.
    """
    start, stop = hold_window(run)
    end = float(np.nanmax(run["time"].values))
    ledger = {name: float(run[name].values[-1]) for name in ("stored", "supplied_total", "dissipated_total")}
    ages = run["age"].values[np.isfinite(run["age"].values)]  # none if the motion left floating point in the first step
    found: Summary = {
        "title": run.attrs["title"],
        "mode": run.attrs["mode"],
        "steps": int(run.attrs["steps"]),
        "duration_s": end,
        "rate_hz": {"asked": plain(run.attrs["rate_asked"]), "taken": plain(run.attrs["rate"])},
        "behind_s": plain(run.attrs["behind"]),
        "finished": bool(run.attrs["finished"]),
        "energy_residual": float(run.attrs["energy_residual"]),
        "passivity_margin_j": float(run.attrs["passivity_margin"]),
        "slack_j": {"least": float(run["slack"].values.min()), "at_end": float(run["slack"].values[-1])},
        "judge": judge(run),
        "settling_time_s": {name: settling_time(run, name) for name in ("position", "force")},
        "settling_window_s": [start, stop],
        "discrepancy_m": discrepancy(run),
        "hold": {**_state(run, stop), "time_s": stop, "force_imbalance": force_imbalance(run, body, stop)},
        "final": _state(run, end),
        "energy_j": {
            "stored": ledger["stored"],
            "supplied": ledger["supplied_total"],
            "dissipated": ledger["dissipated_total"],
            "delay_work": float(run["delay_work_total"].values[-1]),
            "in_play": float(run.attrs["energy_in_play"]),
        },
        "age_s": {"mean": float(ages.mean()), "max": float(ages.max())} if ages.size else {"mean": 0.0, "max": 0.0},
        "underruns": int(run.attrs["underruns"]),
        "messages_lost": int(run.attrs["messages_lost"]),
        "local_damping": [plain(row) for row in run["local_damping"].values],
    }
    if "contents" in run.attrs:
        found["codec"] = coded(run)
    if "tool" in run.sizes:
        found["tools"] = tool_summary(run)
    if "rigid_tool" in run.sizes:
        found["rigid_tools"] = rigid_tool_summary(run)
    if "device_residual" in run.attrs:
        found["device_residual"] = float(run.attrs["device_residual"])
    return found


def coded(run: "xr.Dataset") -> dict[str, float]:
    """What senders with a codec said to a neighbour, in the mean over the directions of links.

    Args:
        run: a result of `simulate`, with a codec.

    Returns:
        `full_hz`, samples in full a second; `unchanged_hz`, those in one byte; `bytes_hz`, the bytes of both without
        headers.
    """
    span = run.sizes["direction"] * float(np.nanmax(run["time"].values))
    names = {"full_hz": "contents", "unchanged_hz": "unchanged", "bytes_hz": "content_bytes"}
    return {name: float(run.attrs[kept]) / span for name, kept in names.items()}


def judge(run: "xr.Dataset") -> Judged:
    """What the run says about its link law.

    Returns:
        `law`, its name; `made_j`, the most energy that the links had made, infinite where the motion left floating
        point; `initial_energy_j`, what they may make; `extracted_j`, the most that users got out beyond what there was;
        `promised`, whether the law promises under these options that `made_j` is at most `initial_energy_j`; `kept`,
        whether it is.
    """
    made, seed = float(run.attrs["made"]) if run.attrs["finished"] else np.inf, float(run.attrs["law_initial_energy"])
    return {
        "law": run.attrs["law"],
        "made_j": made,
        "initial_energy_j": seed,
        "extracted_j": float(run.attrs["extracted"]),
        "promised": bool(run.attrs["law_promises"]),
        "kept": made <= seed + _ROUNDING * float(run.attrs["energy_in_play"]),
    }


def _state(run: "xr.Dataset", time: float) -> StateAtTime:
    """Positions and forces of all users at a time: numbers for a single node on one axis, else nested lists."""
    positions = at_times(run, "position", np.array([time]))[0]
    forces = _forces_at(run, time)
    return {
        "position": [plain(position) for position in positions],
        "force": [plain(force) for force in forces],
        "force_sum": plain(forces.sum(axis=0)),
    }


def _forces_at(run: "xr.Dataset", time: float) -> Float:
    """Force of every user in the step at a time, (users, axes) [N]."""
    forces = run["force"].values
    return np.array([own[_step_at(run, user, time)] for user, own in enumerate(forces)], dtype=np.float64)


def _step_at(run: "xr.Dataset", user: int, time: float) -> int:
    """The last step that a user had taken."""
    own = run["time"].values[user]
    return int(np.searchsorted(own[np.isfinite(own)], time * (1.0 + 1e-12), side="right")) - 1


def plain(values: npt.ArrayLike) -> Numbers:
    """A number if there is only one, else nested lists."""
    array = np.asarray(values)
    return array.item() if array.size == 1 else array.tolist()
