"""The figures of the chapter in three dimensions."""

from typing import TYPE_CHECKING

import numpy as np

from cotouch import drawing
from cotouch.arrays import Bool, Float, Long
from cotouch.study._blocks import Blocks
from cotouch.study._scene import DURATION, RELEASE
from cotouch.study._solid import BELOW, SolidFindings

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path


# The eye: from the front, the left and above [degrees]; user 4 is at the back.
_TURN, _LIFT = -62.0, 24.0
_BACK = 3
_LIGHT = (-0.15, 0.75, 0.65)  # to the right, up and towards the eye
_SHADES = 7
_DARKEST, _LIGHTEST = 0.62, 0.10
_PER_NEWTON = 0.018  # m of arrow
_NEAR = 4  # nodes that a tool is said to be at
_BLOCKS = (
    ("device", "hands and devices", drawing.USERS[1]),
    ("coupling", "couplings", drawing.USERS[3]),
    ("contact", "proxies and contacts", drawing.USERS[4]),
    ("object", "shared object", drawing.USERS[0]),
)


def copies(found: SolidFindings) -> "Figure":
    """Every user's copy with the tool at it, and the average copy with all of them."""
    rest = found.runs["freshest"].rest
    figure = drawing.sheet(4.3)
    panels = figure.subplots(2, 3).ravel()
    mean = rest.copies.mean(axis=0)
    everyone = np.arange(int(rest.place.shape[0]))
    for user, panel in enumerate(panels[:-1]):
        back = user == _BACK
        _solid(panel, found, rest.copies[user], everyone[user : user + 1], turn=_TURN + 180.0 if back else _TURN)
        size = float(np.linalg.norm(rest.force[user]))
        panel.set_title(f"User {user + 1}: {size:.1f} N{', from behind' if back else ''}", color=drawing.USERS[user])
    _solid(panels[-1], found, mean, everyone, turn=_TURN)
    panels[-1].set_title("Average, x̄")
    width, height = 1.03 * np.max([panel.dataLim.size for panel in panels], axis=0)
    for panel in panels:
        x, y = panel.dataLim.min + 0.5 * panel.dataLim.size
        panel.set(xlim=(x - 0.5 * width, x + 0.5 * width), ylim=(y - 0.5 * height, y + 0.5 * height))
    low = np.array([panels[0].get_xlim()[0], panels[0].get_ylim()[0]])
    bar = panels[0]
    start = np.array([low[0], low[1] + 0.004])
    bar.plot([start[0], start[0] + 2.0 * _PER_NEWTON], [start[1]] * 2, color=drawing.INK, linewidth=1.4)
    bar.annotate("2 N", (start[0] + _PER_NEWTON, start[1]), xytext=(0, 3), textcoords="offset points", ha="center")
    return figure


def _axes(turn: float) -> tuple[Float, Float, Float]:
    """To the right, up and towards the eye, which is turned about z by so many degrees."""
    turn, lift = np.radians(turn), np.radians(_LIFT)
    eye = np.array([np.cos(lift) * np.cos(turn), np.cos(lift) * np.sin(turn), np.sin(lift)])
    right = np.array([-np.sin(turn), np.cos(turn), 0.0])
    return right, np.cross(eye, right), eye


def _flat(points: Float, turn: float) -> Float:
    right, up, _ = _axes(turn)
    return np.stack([points @ right, points @ up], axis=-1)


def _solid(panel: "Axes", found: SolidFindings, moved: Float, users: Long, *, turn: float) -> None:
    """A displaced body: shaded faces that look at the eye, the grid on them, where it was at rest, tools and forces."""
    from matplotlib.patches import PathPatch

    right, up, eye = _axes(turn)
    light = _LIGHT[0] * right + _LIGHT[1] * up + _LIGHT[2] * eye
    rest = found.runs["freshest"].rest
    places = found.places + moved
    corners = places[found.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    front = across @ eye > 0.0
    flat = _flat(corners[front], turn)
    shade = np.clip(across[front] @ light, 0.0, 1.0)
    level = np.minimum((shade * _SHADES).astype(np.int64), _SHADES - 1)
    _outline(panel, found.places, turn)
    panel.add_patch(PathPatch(_path(flat), facecolor=drawing.SURFACE, edgecolor="none", zorder=3))
    for step in range(_SHADES):
        own = flat[level == step]
        if own.size:
            alpha = _DARKEST + (_LIGHTEST - _DARKEST) * (step + 0.5) / _SHADES
            patch = PathPatch(_path(own), facecolor=drawing.MUTED, edgecolor="none", alpha=alpha, zorder=3)
            panel.add_patch(patch)
    panel.add_patch(_grid(found, places, front, turn))
    middle = places.mean(axis=0)
    for user in users:
        # On the average body a tool is drawn where it would be, had it taken along its nodes as they have moved there.
        away = np.linalg.norm(found.places + rest.copies[user] - rest.place[user], axis=1)
        near = np.argsort(away, kind="stable")[:_NEAR]
        place = rest.place[user] + (moved - rest.copies[user])[near].mean(axis=0)
        pulls = float(rest.force[user] @ (place - middle)) > 0.0
        behind = float((place - middle) @ eye) < 0.0  # then the body comes over it
        _tool(panel, found, int(user), place, pulls=pulls, order=2 if behind else 4, turn=turn)
    panel.autoscale_view()
    panel.set_aspect("equal")
    panel.set_axis_off()


def _path(polygons: Float) -> "Path":
    """Many closed polygons as one path, so that no seams show between them."""
    from matplotlib.path import Path

    count, sides = polygons.shape[:2]
    points = np.concatenate([polygons, polygons[:, :1]], axis=1).reshape(-1, 2)
    codes = np.tile([Path.MOVETO, *[Path.LINETO] * (sides - 1), Path.CLOSEPOLY], count)
    return Path(points, codes)


def _grid(found: SolidFindings, places: Float, front: Bool, turn: float) -> "PathPatch":
    """Springs on the faces that are seen; the diagonals of the triangles are none."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    seen = found.triangles[front]
    pairs = np.unique(np.sort(seen[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    length = np.linalg.norm(found.places[pairs[:, 0]] - found.places[pairs[:, 1]], axis=1)
    pairs = pairs[length < 1.2 * length.min()]
    lines = Path(_flat(places[pairs.ravel()], turn), np.tile([Path.MOVETO, Path.LINETO], len(pairs)))
    return PathPatch(lines, facecolor="none", edgecolor=drawing.SURFACE, linewidth=0.35, zorder=3)


def _outline(panel: "Axes", places: Float, turn: float) -> None:
    """The box of the body at rest."""
    low, high = places.min(axis=0), places.max(axis=0)
    corners = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    for a in range(8):
        for bit in (1, 2, 4):
            if not a & bit:
                line = _flat(corners[[a, a | bit]], turn)
                panel.plot(*line.T, color=drawing.MUTED, linewidth=0.6, linestyle=(0, (2.0, 2.0)), zorder=1)


def _tool(
    panel: "Axes", found: SolidFindings, user: int, place: Float, *, pulls: bool, order: int, turn: float
) -> None:
    """The sphere and the force on the body: pushing arrows end at it, pulling ones start there."""
    from matplotlib.patches import Circle

    color = drawing.USERS[user]
    arm = _PER_NEWTON * found.runs["freshest"].rest.force[user]
    tail, head = _flat(np.array([place, place + arm] if pulls else [place - arm, place]), turn)
    x, y = _flat(place, turn)
    radius = float(found.radii[user])
    panel.add_patch(Circle((float(x), float(y)), radius, facecolor=color, alpha=0.35, linewidth=0, zorder=order))
    panel.annotate(
        "",
        tuple(head),
        xytext=tuple(tail),
        arrowprops={
            "arrowstyle": "-|>,head_width=0.22,head_length=0.42",
            "color": color,
            "linewidth": 1.5,
            "shrinkA": 0,
            "shrinkB": 0,
            "zorder": order,
        },
        zorder=order,
    )
    panel.update_datalim(np.array([tail, head]))


def energies(found: SolidFindings) -> "Figure":
    """What each block has taken, over time, under the rule; and the copies with far too little damping."""
    figure = drawing.sheet(2.9)
    panels = figure.subplots(1, 3)
    for panel, (mode, run) in zip(panels[:2], found.runs.items(), strict=True):
        _hold(panel)
        for name, label, color in _BLOCKS:
            panel.plot(*_line(run.blocks, name), color=color, label=label)
        panel.plot(*_line(run.blocks, "human"), color=drawing.INK, label="work of the hands")
        panel.set_title("Constant index delay" if mode == "constant" else "Freshest samples")
    top = max(float(panel.get_ylim()[1]) for panel in panels[:2])
    for panel in panels[:2]:
        panel.set_ylim(-0.04 * top, top)
    panels[0].set_ylabel("Energy taken so far / J")
    last = panels[2]
    _hold(last)
    last.plot(*_line(found.runs["constant"].blocks, "object"), color=drawing.USERS[0])
    last.plot(*_line(found.below, "object"), color=drawing.ALARM_COLOUR)
    for run, color, label, at, offset in (
        (found.runs["constant"].blocks, drawing.USERS[0], "the rule", 0.45 * DURATION, (4, 5)),
        (found.below, drawing.ALARM_COLOUR, f"{100 * BELOW:g} % of it", RELEASE, (6, 8)),
    ):
        time, value = _line(run, "object")
        place = int(np.searchsorted(time, at))
        last.annotate(
            label,
            (time[place], value[place]),
            xytext=offset,
            textcoords="offset points",
            color=color,
            fontsize=7.5,
        )
    last.axhline(0.0, color=drawing.MUTED, linewidth=0.8)
    last.set_title("Taken by the shared object")
    for panel in panels:
        panel.set(xlabel="Time / s", xlim=(0.0, DURATION))
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=len(labels))
    return figure


def _line(found: Blocks, name: str) -> tuple[Float, Float]:
    return drawing.decimate(found.time, getattr(found, name), 500)


def _hold(panel: "Axes") -> None:
    panel.axvspan(0.0, RELEASE, color=drawing.SHADE, linewidth=0, zorder=0)
