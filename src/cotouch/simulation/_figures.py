"""Figures of a run: positions, forces, energies and ages."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from cotouch.arrays import Float
from cotouch.drawing import (
    ALARM_COLOUR,
    DASHES,
    INK,
    MUTED,
    SHADE,
    USERS,
    UserLine,
    decimate,
    drawn,
    end_labels,
    peak,
    prefix,
    sheet,
    style,
    user_legend,
    user_line,
)
from cotouch.errors import ScenarioError
from cotouch.files import folder as make_folder
from cotouch.files import write
from cotouch.simulation._metrics import at_times, felt, hold_window
from cotouch.simulation._run_tables import tables_of

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


# What grows by more than this from the first half of a run to the second has left a straight axis.
_GROWTH = 1e4
_MOST_LABELS = 14


FIGURES: Final = ("positions", "forces", "energies", "ages", "tools", "touch")


def figures(run: "xr.Dataset") -> "dict[str, Figure]":
    """Draws a run.

    Args:
        run: a result of `simulate`.

    Returns:
        "positions" and "forces" of every user (of the node that is held most, if there are several), "energies" (what
        is stored where, where it came from and went, and what the ledger misses) and "ages" of the samples. With tools
        also "tools", where they went, and "touch", what they did and what their users felt.
    """
    with style():
        every = {
            "positions": _positions(run),
            "forces": _forces(run),
            "energies": _energies(run),
            "ages": _ages(run),
        }
        if "tool" in run.sizes:
            every |= {"tools": _tool_places(run), "touch": _touch(run)}
        return every


def save_figures(run: "xr.Dataset", directory: str | Path, format: str = "png") -> list[Path]:  # noqa: A002
    """Writes the figures of a run into a folder, which is made if need be, and returns their paths.

    Args:
        run: a result of `simulate`.
        directory: made if need be.
        format: one that matplotlib knows.

    Raises:
        OutputError: the folder or a file cannot be written.
        ScenarioError: the format is unknown.
    """
    folder = make_folder(Path(directory))
    written: list[Path] = []
    for name, figure in figures(run).items():
        path = folder / f"{name}.{format}"
        try:
            data = drawn(figure, format=format, dpi=160)
        except ValueError as error:
            raise ScenarioError(f'figures cannot be written as "{format}": {error}') from error
        write(path, data, "figure")
        written.append(path)
    return written


def shade_hold(axes: "Axes", run: "xr.Dataset", *, label: bool = True) -> None:
    """Shades the time in which users hold against each other.

    Args:
        axes: drawn on.
        run: as `simulate` returns it.
        label: whether the legend names it.
    """
    tables = tables_of(run)
    if not tables["hands"] and not tables.get("tools"):
        return
    start, stop = hold_window(run)
    axes.axvspan(start, stop, color=SHADE, linewidth=0, zorder=0)
    if label:
        axes.annotate(
            "held",
            ((start + stop) / 2, 1.0),
            xycoords=("data", "axes fraction"),
            xytext=(0, -3),
            textcoords="offset points",
            ha="center",
            va="top",
            color=MUTED,
            fontsize=7.0,
            bbox={"boxstyle": "square,pad=0.15", "facecolor": SHADE, "edgecolor": "none"},
            zorder=3,
        )


def _panels(figure: "Figure", rows: int, ratios: Sequence[float] | None = None) -> "list[Axes]":
    grid = figure.subplots(rows, 1, sharex=True, squeeze=False, height_ratios=ratios)
    panels: list[Axes] = list(grid[:, 0])
    panels[-1].set_xlabel("Time / s")
    return panels


def _by_user(run: "xr.Dataset", panels: "Sequence[Axes]", what: str, unit: str, values: Float, *, first: int) -> None:
    """A panel for each axis, with a line for each user from the record with this number."""
    for axis, panel in enumerate(panels):
        shade_hold(panel, run, label=axis == 0)
        for i, own in enumerate(values):
            panel.plot(*decimate(run["time"].values[i, first:], own[first:, axis]), **user_line(i))
        name = f" {run['axis'].values[axis]}" if len(panels) > 1 else ""
        panel.set_ylabel(f"{what}{name} / {unit}")


def _positions(run: "xr.Dataset") -> "Figure":
    axes, node = run.sizes["axis"], _shown_node(run)
    figure = sheet(1.0 + 1.7 * axes)
    panels = _panels(figure, axes)
    places = run["position"].values[:, :, node, :]
    factor, unit = prefix(peak(places), "m")
    _by_user(run, panels, "Position", unit, places / factor, first=0)
    which = f" of node {int(run['node'].values[node])}" if run.sizes["node"] > 1 else ""
    panels[0].set_title(f"Position{which}")
    _limit(panels, run)
    user_legend(panels[0], [str(name) for name in run["user"].values])
    return figure


def _forces(run: "xr.Dataset") -> "Figure":
    axes = run.sizes["axis"]
    figure = sheet(2.2 + 1.7 * axes)
    panels = _panels(figure, axes + 1, [1.6] * axes + [1.0])
    forces = run["force"].values
    ticks = run["tick_time"].values
    total = at_times(run, "force", ticks).sum(axis=1)
    factor, unit = prefix(peak(forces[:, 1:]), "N")
    # Record 0 is the initial state, which no force belongs to.
    _by_user(run, panels[:-1], "Force", unit, forces / factor, first=1)
    last = panels[-1]
    shade_hold(last, run, label=False)
    for axis in range(axes):
        label = str(run["axis"].values[axis])
        last.plot(*decimate(ticks[1:], total[1:, axis] / factor), color=INK, linestyle=DASHES[axis], label=label)
    if axes > 1:
        last.legend(loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=axes)
    last.set(ylabel=f"Sum / {unit}", title="Sum over users")
    panels[0].set_title("Force of the hands" if "tool" not in run.sizes else "Force of hands and tools on the object")
    _limit(panels, run)
    user_legend(panels[0], [str(name) for name in run["user"].values])
    return figure


def _owners(run: "xr.Dataset") -> list[int]:
    """Whose each tool is."""
    return [tool["user"] - 1 for tool in tables_of(run).get("tools", [])]


def _tool_line(owners: list[int], tool: int) -> UserLine:
    """The colour of the user; the second tool of one is dashed, the third dotted."""
    mine = [other for other, owner in enumerate(owners) if owner == owners[tool]].index(tool)
    return {"color": user_line(owners[tool])["color"], "linestyle": DASHES[mine % len(DASHES)]}


def _tool_places(run: "xr.Dataset") -> "Figure":
    owners = _owners(run)
    places = run["tool_position"].values
    devices = run["device_position"].values if "device_position" in run else np.full(places.shape, np.nan)
    moved, held = places - places[:, :1], devices - places[:, :1]
    figure = sheet(6.1)
    panels = _panels(figure, 3)
    factor, unit = prefix(peak(moved, held), "m")
    for axis, panel in enumerate(panels):
        shade_hold(panel, run, label=axis == 0)
        for tool, owner in enumerate(owners):
            line = _tool_line(owners, tool)
            time = run["time"].values[owner]
            panel.plot(*decimate(time, held[tool, :, axis] / factor), linewidth=2.6, alpha=0.25, **line)
            panel.plot(*decimate(time, moved[tool, :, axis] / factor), **line)
        panel.set_ylabel(f"{run['axis'].values[axis]} / {unit}")
    devices_too = " (wide and pale: their devices)" if np.isfinite(held).any() else ""
    panels[0].set_title(f"Displacement of tools from their start{devices_too}")
    _limit(panels, run)
    _user_legend_of(panels[0], run, owners)
    return figure


def _touch(run: "xr.Dataset") -> "Figure":
    from matplotlib.ticker import MaxNLocator

    owners = _owners(run)
    pushed = np.linalg.norm(run["touch_force"].values, axis=-1)
    hand = np.linalg.norm(felt(run), axis=-1)
    figure = sheet(5.4)
    panels = _panels(figure, 3, [1.25, 1.25, 0.7])
    factor, unit = prefix(peak(pushed[:, 1:], hand[:, 1:]), "N")
    with_device = "device_force" in run
    titles = (
        "Force between tool and object",
        f"Force that the hand feels{' through its device' if with_device else ''}",
    )
    for panel, values, title in zip(panels, (pushed, hand), titles, strict=False):
        shade_hold(panel, run, label=panel is panels[0])
        for tool, owner in enumerate(owners):
            seen = decimate(run["time"].values[owner][1:], values[tool, 1:] / factor)
            panel.plot(*seen, **_tool_line(owners, tool))
        panel.set(ylabel=f"|f| / {unit}", title=title, ylim=(0.0, None))
    last = panels[-1]
    shade_hold(last, run, label=False)
    counts = run["touching"].values
    for tool, owner in enumerate(owners):
        time = run["time"].values[owner]
        known = np.isfinite(time)
        changes = np.flatnonzero(np.diff(counts[tool, known], prepend=np.nan, append=np.nan) != 0.0)
        moments, steps = time[known][np.minimum(changes, known.sum() - 1)], counts[tool, known]
        level = [float(steps[min(change, steps.size - 1)]) for change in changes]
        last.step(moments, level, where="post", linewidth=0.9, **_tool_line(owners, tool))
    last.set(title="Active contacts, or nodes held", ylabel="Number", ylim=(0.0, None))
    last.yaxis.set_major_locator(MaxNLocator(integer=True, nbins=4))
    panels[0].set_xlim(0.0, float(np.nanmax(run["time"].values)))
    _user_legend_of(panels[0], run, owners)
    return figure


def _user_legend_of(panel: "Axes", run: "xr.Dataset", owners: list[int]) -> None:
    """Names up to the last user who has a tool."""
    names = [str(name) for name in run["user"].values]
    user_legend(panel, names[: max(owners) + 1])


def _energies(run: "xr.Dataset") -> "Figure":
    ticks = run["tick_time"].values
    figure = sheet(5.6)
    stores, flows, ledger = _panels(figure, 3, [1.25, 1.25, 0.8])
    kinetic, elastic = (at_times(run, name, ticks).sum(axis=1) for name in ("kinetic", "elastic"))
    kept = {
        "kinetic": (kinetic, USERS[0]),
        "elastic": (elastic, USERS[2]),
        "link springs": (run["link_energy"].values.sum(axis=1), USERS[1]),
    }
    if "tool" in run.sizes:
        tools = (at_times(run, name, ticks).sum(axis=1) for name in ("proxy", "touch_stored"))
        kept["tools and contacts"] = (sum(tools, np.zeros(ticks.size)), USERS[3])
    moved = {
        "supplied": (run["supplied_total"].values, USERS[0]),
        "dissipated": (run["dissipated_total"].values, USERS[1]),
        "added by delay": (run["delay_work_total"].values, USERS[3]),
        "stored": (run["stored"].values, INK),
    }
    for panel, lines in ((stores, kept), (flows, moved)):
        factor, unit = prefix(peak(*(values for values, _ in lines.values())), "J")
        shade_hold(panel, run, label=panel is stores)
        for name, (values, color) in lines.items():
            panel.plot(*decimate(ticks, values / factor), color=color, label=name)
        panel.set_ylabel(f"Energy / {unit}")
        panel.legend(loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=len(lines))
    stores.set_title("Stored")
    flows.set_title("Where energy came from and went")
    shade_hold(ledger, run, label=False)
    time, line = decimate(ticks, np.abs(run["residual"].values))
    seen = line > 0.0
    ledger.plot(time[seen], line[seen], color=ALARM_COLOUR, linewidth=0.8)
    if seen.any():
        ledger.set_yscale("log")
    ledger.set_ylabel("|Residual| / J")
    fraction = float(run.attrs["energy_residual"])
    ledger.set_title(f"Ledger residual: at most {fraction:.1e} of the energy in play")
    _limit([stores, flows, ledger], run)
    return figure


def _ages(run: "xr.Dataset") -> "Figure":
    figure = sheet(2.9)
    (panel,) = _panels(figure, 1)
    shade_hold(panel, run)
    ages = run["age"].values
    factor, unit = prefix(peak(ages), "s")
    names = [str(name) for name in run["direction"].values]
    receivers = np.array([int(name.split("<-")[0]) - 1 for name in names], dtype=np.int64)
    ends: list[float] = []
    texts: list[str] = []
    colors: list[str] = []

    def draw(user: int, values: Float, text: str) -> None:
        time, line = decimate(run["time"].values[user], values / factor)
        panel.plot(time, line, **user_line(user), linewidth=0.9)
        if line.size:
            ends.append(float(np.median(line)))
            texts.append(text)
            colors.append(USERS[user % len(USERS)])

    if len(names) <= _MOST_LABELS:
        for s, name in enumerate(names):
            draw(int(receivers[s]), ages[s], name.replace("<-", " ← "))
        title = "Age of the sample that each step uses (receiver ← sender)"
    else:
        for user in np.unique(receivers):
            draw(int(user), _highest(ages[receivers == user]), "")
        title = "Age of the oldest sample that each step uses, by receiver"
    panel.set(title=title if names else "No links, so no samples", ylabel=f"Age / {unit}", ylim=(0.0, None))
    _limit([panel], run)
    if len(names) > _MOST_LABELS:
        user_legend(panel, [str(name) for name in run["user"].values])
    elif names:
        end_labels(panel, ends, texts, colors)
    return figure


def _highest(rows: Float) -> Float:
    """Column by column, the largest that is known."""
    known = np.isfinite(rows).any(axis=0)
    result = np.full(rows.shape[1], np.nan)
    result[known] = np.nanmax(rows[:, known], axis=0)
    return result


def _limit(panels: "Sequence[Axes]", run: "xr.Dataset") -> None:
    """Time from start to end; for what grows out of sight, decades instead of a straight axis."""
    from matplotlib.ticker import SymmetricalLogLocator

    end = float(np.nanmax(run["time"].values))
    panels[0].set_xlim(0.0, end)
    for panel in panels:
        first = last = lowest = 0.0
        for line in panel.get_lines():
            time, values = np.asarray(line.get_xdata()), np.asarray(line.get_ydata(), dtype=np.float64)
            first, last = max(first, peak(values[time <= end / 2])), max(last, peak(values[time > end / 2]))
            lowest = min(lowest, float(values.min(initial=0.0)))
        if panel.get_yscale() == "linear" and 0.0 < _GROWTH * first < last:
            panel.set_yscale("symlog", linthresh=first)
            locator = SymmetricalLogLocator(base=10.0, linthresh=first)
            locator.numticks = 7
            panel.yaxis.set_major_locator(locator)
            if lowest == 0.0:
                panel.set_ylim(bottom=0.0)


def _shown_node(run: "xr.Dataset") -> int:
    """Index of the recorded node that most hands hold, the first such."""
    nodes = [int(number) for number in run["node"].values]
    held = [hand["node"] for hand in tables_of(run)["hands"]]
    count: Callable[[int], int] = held.count
    return max(range(len(nodes)), key=lambda k: (count(nodes[k]), -k))
