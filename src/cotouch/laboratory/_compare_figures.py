"""The figures of a comparison: where laws become dangerous, and what no law has all of."""

from typing import TYPE_CHECKING

import numpy as np

from cotouch.arrays import Bool
from cotouch.drawing import ALARM_COLOUR, DASHES, INK, MUTED, USERS, escaped, sheet
from cotouch.laboratory._noticed import chosen, is_dangerous

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.collections import QuadMesh
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

_ACROSS = 3
_MARKS = ("o", "s", "^", "D", "v", "P", "X")
# Costs are drawn between these.
_LOW, _HIGH = 0.1, 10.0


def maps(data: "xr.Dataset") -> "Figure":
    """Cost over delay and stiffness of hands, a panel for each law; what is dangerous is crossed out.

    Args:
        data: of `compare`, with maps.
    """
    from matplotlib.colors import LogNorm

    laws = data["law"].values.tolist()
    rows = -(-len(laws) // _ACROSS)
    figure = sheet(0.5 + 1.75 * rows)
    panels = figure.subplots(rows, _ACROSS, sharex=True, sharey=True, squeeze=False)
    delay, stiffness = 1e3 * data["delay"].values, data["stiffness"].values
    shades: QuadMesh | None = None
    for panel, law in zip(panels.ravel(), laws, strict=False):
        here = data.sel(law=law)
        cost = np.clip(np.nan_to_num(here["map_cost"].values, posinf=_HIGH, nan=_HIGH), _LOW, _HIGH)
        risky = here["map_dangerous"].values == 1.0
        x, y = np.arange(delay.size + 1), np.arange(stiffness.size + 1)
        shades = panel.pcolormesh(x, y, cost, cmap="Blues", norm=LogNorm(_LOW, _HIGH), linewidth=0)
        _line(panel, risky)
        panel.set_title(escaped(law))
        panel.grid(visible=False)
        panel.set_xticks(x[:-1] + 0.5, labels=[f"{value:g}" for value in delay])
        panel.set_yticks(y[:-1] + 0.5, labels=[f"{value:g}" for value in stiffness])
    for panel in panels.ravel()[len(laws) :]:
        panel.set_visible(False)
    for panel in panels[:, 0]:
        panel.set_ylabel("hand / (N/m)")
    for column in range(_ACROSS):
        shown = [panel for panel in panels[:, column] if panel.get_visible()]
        if shown:
            shown[-1].set_xlabel("delay, one way / ms")
            shown[-1].tick_params(labelbottom=True)
    assert shades is not None  # a study has laws
    bar = figure.colorbar(shades, ax=panels, shrink=0.7, aspect=30, pad=0.01)
    bar.set_label("cost")
    bar.outline.set_visible(False)
    return figure


def _line(panel: "Axes", risky: Bool) -> None:
    """Crosses out what is dangerous, and draws the line around it."""
    rows, columns = risky.shape
    for r in range(rows):
        for c in range(columns):
            if not risky[r, c]:
                continue
            panel.plot([c + 0.25, c + 0.75], [r + 0.25, r + 0.75], color=ALARM_COLOUR, linewidth=0.9)
            panel.plot([c + 0.25, c + 0.75], [r + 0.75, r + 0.25], color=ALARM_COLOUR, linewidth=0.9)
            for there, xs, ys in (
                ((r, c - 1), [c, c], [r, r + 1]),
                ((r, c + 1), [c + 1, c + 1], [r, r + 1]),
                ((r - 1, c), [c, c + 1], [r, r]),
                ((r + 1, c), [c, c + 1], [r + 1, r + 1]),
            ):
                inside = 0 <= there[0] < rows and 0 <= there[1] < columns
                if inside and not risky[there]:
                    panel.plot(xs, ys, color=ALARM_COLOUR, linewidth=2.0, solid_capstyle="butt")


def fronts(data: "xr.Dataset", users: int, across: str) -> "Figure":
    """Position error over drag or energy made, a panel for each network, with the front that no law is beyond.

    Args:
        data: of `compare`.
        users: how many.
        across: "drag" or "made".
    """
    laws, networks = data["law"].values.tolist(), data["network"].values.tolist()
    rows = -(-len(networks) // _ACROSS)
    figure = sheet(0.55 + 1.9 * rows)
    panels = figure.subplots(rows, _ACROSS, squeeze=False)
    here = data.sel(users=users, tuning=chosen(data))
    lines: list[Line2D] = []
    for panel, network in zip(panels.ravel(), networks, strict=False):
        points: list[tuple[float, float]] = []
        for index, law in enumerate(laws):
            one = here.sel(law=law, network=network)
            error = 1e3 * float(one["place"].isel(hand=0).mean())
            drag = float(one["felt_drag"]) if across == "drag" else float(one["made"].isel(hand=0).max())
            fine = np.isfinite([error, drag]).all()
            risky = fine and is_dangerous(data, law, network, users)
            if fine and not risky:
                points.append((drag, error))
            look = {"color": USERS[index % len(USERS)], "marker": _MARKS[index % len(_MARKS)], "ls": ""}
            filled = "none" if risky else look["color"]
            (line,) = panel.plot(
                [drag] if fine else [],
                [error] if fine else [],
                markersize=5,
                markerfacecolor=filled,
                label=escaped(law),
                **look,
            )
            if len(lines) < len(laws):
                lines.append(line)
        front = _front(points)
        if len(front) > 1:
            panel.step(
                *zip(*front, strict=True), where="post", color=MUTED, linewidth=0.9, linestyle=DASHES[1], zorder=0
            )
        panel.set_title(escaped(network))
        panel.margins(x=0.12)
        panel.set(yscale="log", ylabel="position error / mm" if panel in panels[:, 0] else "")
        panel.yaxis.set_major_formatter(_short)
        panel.yaxis.set_minor_formatter(_nothing)
        if across == "made":
            panel.set_xscale("symlog", linthresh=1e-3)
            panel.set_xlim(left=-1e-3)
        else:
            panel.axvline(0.0, color=MUTED, linewidth=0.6)
    for panel in panels.ravel()[len(networks) :]:
        panel.set_visible(False)
    for panel in panels.ravel()[: len(networks)][-_ACROSS:]:
        panel.set_xlabel("drag / (Ns/m)" if across == "drag" else "energy made beyond the initial energy / J")
    figure.legend(lines, laws, loc="outside lower center", ncols=min(len(laws), 6), labelcolor=INK)
    return figure


def _front(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Those to which no other is better in both, in order."""
    result: list[tuple[float, float]] = []
    for point in sorted(points):
        if not result or point[1] < result[-1][1]:
            result.append(point)
    return result


def _short(value: float, _place: int | None) -> str:
    return f"{value:g}"


def _nothing(_value: float, _place: int | None) -> str:
    return ""
