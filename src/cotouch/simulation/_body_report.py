"""What was understood of a body: its numbers, and a picture."""

import itertools
from pathlib import Path
from typing import TYPE_CHECKING, Final, TypedDict

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.body import Body, Skin, lowest_modes
from cotouch.drawing import INK, MUTED, USERS, WIDTH, drawn, prefix, sheet, style
from cotouch.errors import ScenarioError
from cotouch.files import write

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d import Axes3D


# Modes that bend the body, besides the rigid ones.
_MODES: Final = 6
_DRAWN: Final = 3
# More triangles than this are not to be told apart in a panel, and take long to draw.
_TRIANGLES: Final = 12_000
_DOTS: Final = 6_000
# A mode is drawn with this displacement at its peak, beside the longest side.
_SWING: Final = 0.14
_LIGHT: Final = np.array([-0.45, -0.6, 0.66])
# How much of a panel the body fills, the form of all panels, and the height of the figure in inches.
_FULL: Final = 0.92
_RATIO: Final = 1.3
_HEIGHT: Final = 4.8
_VIEW: Final = {"elev": 24.0, "azim": -58.0}
_FLESH: Final = np.array([0.80, 0.84, 0.89])


class SkinSize(TypedDict):
    """How much a skin has."""

    vertices: int
    triangles: int


class BodyReport(TypedDict):
    """The numbers of a body from a mesh; `times_each`: once for every axis of scalar springs."""

    file: str
    kind: str
    model: str
    unit: str
    notes: list[str]
    nodes: int
    elements: int
    spacing_m: float
    size_m: list[float]
    volume_m3: float
    mass_kg: float
    inertia_kgm2: list[float]
    skin: SkinSize | None
    held_nodes: int
    free_rigid_motions: int
    frequencies_hz: list[float]
    times_each: int


def body_report(body: Body, modes: int = _MODES) -> tuple[BodyReport, Float]:
    """The numbers of a body that came from a mesh, and its first modes that are not rigid, (modes, n, d).

    A body of scalar springs has each of its modes once along every axis; it is then returned along the thinnest.

    Args:
        body: made from a mesh.
        modes: how many.

    Raises:
        ScenarioError: the body was not made from a mesh.
    """
    origin = body.origin
    if origin is None:
        raise ScenarioError("the body was not made from a mesh; so there is no report on its origin")
    rigid = origin.free if body.form == "full" else int(origin.free > 0)
    values, shapes = np.zeros(0), np.zeros((body.mass.shape[0], 0))
    if not body.rigid:
        values, shapes = lowest_modes(body.mass, body.stiffness, body.rest, rigid + modes)
        values, shapes = values[rigid:], shapes[:, rigid:]
    copies = 1 if body.form == "full" else body.dimension
    fields = np.zeros((values.size, body.nodes, body.dimension))
    if copies == 1:
        fields[:] = shapes.T.reshape(fields.shape)
    else:
        fields[:, :, int(np.argmin(origin.size))] = shapes.T
    numbers: BodyReport = {
        "file": origin.source,
        "kind": origin.kind,
        "model": origin.model,
        "unit": origin.unit,
        "notes": list(origin.notes),
        "nodes": body.nodes,
        "elements": origin.elements,
        "spacing_m": origin.spacing,
        "size_m": origin.size.tolist(),
        "volume_m3": origin.volume,
        "mass_kg": float(body.mass.sum()) / (1 if body.form == "node" else body.dimension),
        "inertia_kgm2": _inertia(body),
        "skin": None
        if body.skin is None
        else {"vertices": body.skin.vertices.shape[0], "triangles": body.skin.triangles.shape[0]},
        "held_nodes": int(origin.held.size),
        "free_rigid_motions": origin.free,
        "frequencies_hz": (np.sqrt(values) / (2.0 * np.pi)).tolist(),
        "times_each": copies,
    }
    return numbers, fields


def _inertia(body: Body) -> list[float]:
    """Moments about the principal axes, of all its nodes, ascending."""
    mass = body.mass.diagonal().reshape(body.nodes, -1)[:, :1]
    about = body.rest - (mass * body.rest).sum(axis=0) / mass.sum()
    spread = (mass * about).T @ about
    return np.linalg.eigvalsh(np.trace(spread) * np.eye(3) - spread).tolist()


def save_body_figure(body: Body, numbers: BodyReport, fields: Float, directory: Path) -> Path:
    """Draws `body.png` into a folder: the surface, what carries it, and the first modes.

    Args:
        body: made from a mesh.
        numbers: as `body_report` gives them.
        fields: (modes, n, d) shapes.
        directory: the folder.

    Raises:
        OutputError: it cannot be written.
    """
    path = directory / "body.png"
    with style():
        figure = _figure(body, numbers, fields)
    write(path, drawn(figure, dpi=170), "figure")
    return path


def _figure(body: Body, numbers: BodyReport, fields: Float) -> "Figure":
    origin, skin = body.origin, body.skin
    assert origin is not None
    assert skin is not None
    figure = sheet(_HEIGHT, WIDTH)
    figure.set_layout_engine("none")  # nothing to lay out: axes without labels, each in its place
    vertices, triangles, kept = _coarser(skin)
    panels: list[Axes3D] = [figure.add_axes((0.5 * k, 0.46, 0.5, 0.475), projection="3d") for k in range(2)]
    factor, unit = prefix(float(origin.size.max()), "m")
    size = " × ".join(f"{extent / factor:.3g}" for extent in origin.size)
    _title(figure, 0.02, 0.975, f"{Path(origin.source).name}: {size} {unit}, {_mass(numbers['mass_kg'])}")
    _surface(panels[0], vertices, triangles)
    what = "triangles" if body.rigid else "cells" if origin.kind == "surface" else "tetrahedra"
    held = f", {origin.held.size:,} held" if origin.held.size else ", held by nothing"
    _title(figure, 0.52, 0.975, f"{body.nodes:,} nodes of {origin.elements:,} {what}{held}")
    _surface(panels[1], vertices, triangles, alpha=0.07)
    loose = np.setdiff1d(np.arange(body.nodes), origin.held)
    loose = loose[:: -(-loose.size // _DOTS)] if loose.size else loose
    dots: dict[str, object] = {"linewidths": 0.0, "depthshade": False, "clip_on": False}
    own = float(np.clip(220.0 / np.sqrt(max(loose.size, 1)), 1.5, 9.0))
    panels[1].scatter(*body.rest[loose].T, s=own, color=USERS[0], alpha=0.55, **dots)
    if origin.held.size:
        panels[1].scatter(*body.rest[origin.held].T, s=1.6 * own, color=USERS[1], **dots)
    for k in range(min(_DRAWN, fields.shape[0])):
        panel: Axes3D = figure.add_axes((k / 3, 0.0, 1 / 3, 0.385), projection="3d")
        field = fields[k]
        moved = skin.carried(field)[kept]
        reach = float(np.linalg.norm(moved, axis=1).max())
        moved = moved / (reach or 1.0)
        swing = _SWING * float(origin.size.max())
        _surface(panel, vertices + swing * moved, triangles, shade=np.linalg.norm(moved, axis=1))
        again = f" (×{numbers['times_each']})" if numbers["times_each"] > 1 else ""
        _title(figure, 0.02 + k / 3, 0.42, f"Mode {k + 1}: {numbers['frequencies_hz'][k]:.3g} Hz{again}")
        panels.append(panel)
    points = np.concatenate([vertices, body.rest])
    for index, panel in enumerate(panels):
        margin = _SWING * float(origin.size.max()) * 0.5 if index > 1 else 0.0
        _stage(panel, points.min(axis=0) - margin, points.max(axis=0) + margin, _RATIO)
    _scale(panels[0], points.min(axis=0), points.max(axis=0))
    _directions(figure, 0.455, 0.50)
    return figure


def _title(figure: "Figure", x: float, y: float, text: str) -> None:
    figure.text(x, y, text, fontsize=8.5, fontweight="bold", color=INK, va="top")


def _surface(
    panel: "Axes3D", vertices: Float, triangles: Long, *, shade: Float | None = None, alpha: float = 1.0
) -> None:
    """Triangles lit from the upper left, coloured by `shade` from 0 to 1 if there is one."""
    import matplotlib as mpl
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    corners = vertices[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal = normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    light = 0.62 + 0.38 * np.clip(normal @ (_LIGHT / np.linalg.norm(_LIGHT)), -1.0, 1.0)
    if shade is None:
        colour = np.broadcast_to(_FLESH, (triangles.shape[0], 3))
    else:
        colour = mpl.colormaps["viridis"](shade[triangles].mean(axis=1))[:, :3]
        light = 0.5 + 0.5 * light
    faces = np.concatenate(
        [np.clip(colour * light[:, None], 0.0, 1.0), np.full((triangles.shape[0], 1), alpha)], axis=1
    )
    # Edges in the colour of their face close the seams that smoothing leaves between triangles.
    edges = faces if alpha == 1.0 else np.zeros_like(faces)
    panel.add_collection3d(Poly3DCollection(corners, facecolors=faces, edgecolors=edges, linewidths=0.2, clip_on=False))


def _stage(panel: "Axes3D", low: Float, high: Float, ratio: float) -> None:
    """Equal scales, nothing around, as large as a panel `ratio` times as wide as high can take."""
    extent = np.maximum(high - low, 1e-12)
    panel.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    panel.set_zlim(low[2], high[2])
    elevation, azimuth = np.radians(_VIEW["elev"]), np.radians(_VIEW["azim"])
    wide = abs(np.sin(azimuth)) * extent[0] + abs(np.cos(azimuth)) * extent[1]
    high_ = np.sin(elevation) * (abs(np.cos(azimuth)) * extent[0] + abs(np.sin(azimuth)) * extent[1])
    high_ += np.cos(elevation) * extent[2]
    # A box is drawn with its diagonal of one fixed length; at zoom 1 that is about the height of the panel.
    zoom = _FULL * float(np.linalg.norm(extent)) * min(ratio / wide, 1.0 / high_)
    panel.set_box_aspect(tuple(extent), zoom=zoom)
    panel.view_init(**_VIEW)
    panel.set_proj_type("ortho")
    panel.set_axis_off()
    panel.patch.set_alpha(0.0)


def _scale(panel: "Axes3D", low: Float, high: Float) -> None:
    """A bar along x of a round length, before the body."""
    extent = high - low
    longest = float(extent.max())
    decade = 10.0 ** np.floor(np.log10(0.5 * extent[0]))
    length = max(m for m in (1.0, 2.0, 5.0) if m * decade <= 0.5 * extent[0]) * decade
    factor, unit = prefix(longest, "m")
    start = np.array([low[0], low[1] - 0.09 * longest, low[2]])
    ends = np.stack([start, start + length * np.eye(3)[0]])
    panel.plot(*ends.T, color=INK, linewidth=1.4, solid_capstyle="butt", clip_on=False)
    middle = start + np.array([0.5 * length, 0.0, -0.035 * longest])
    panel.text(*middle, f"{length / factor:g} {unit}", color=INK, fontsize=7.0, ha="right", va="top")


def _directions(figure: "Figure", x: float, y: float) -> None:
    """Where the axes point, in a corner of the figure."""
    elevation, azimuth = np.radians(_VIEW["elev"]), np.radians(_VIEW["azim"])
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    up = np.array([-np.sin(elevation) * np.cos(azimuth), -np.sin(elevation) * np.sin(azimuth), np.cos(elevation)])
    from matplotlib.lines import Line2D

    for axis, name in enumerate("xyz"):
        across, along = 0.24 * right[axis] / WIDTH, 0.24 * up[axis] / _HEIGHT  # inches
        figure.add_artist(Line2D([x, x + across], [y, y + along], color=MUTED, linewidth=0.8))
        figure.text(x + 1.4 * across, y + 1.4 * along, name, color=MUTED, fontsize=7.0, ha="center", va="center")


def _coarser(skin: Skin) -> tuple[Float, Long, Long]:
    """The skin with few enough triangles to draw: vertices of one cell of a grid become one of them.

    Returns:
        Vertices, triangles, and which vertex of the skin each is.
    """
    vertices, triangles = skin.vertices, skin.triangles.astype(np.int64)
    kept: Long = np.arange(len(vertices))
    extent = float(np.ptp(vertices, axis=0).max())
    for cells in itertools.count(90, -10):
        if triangles.shape[0] <= _TRIANGLES or cells < 10:
            break
        keys = np.floor((skin.vertices - skin.vertices.min(axis=0)) / extent * cells).astype(np.int64)
        _, kept, places = np.unique(keys, axis=0, return_index=True, return_inverse=True)
        folded = places.ravel()[skin.triangles]
        a, b, c = folded.T
        triangles = folded[(a != b) & (b != c) & (c != a)]
        vertices = skin.vertices[kept]
    return vertices, triangles, kept


def _mass(kilograms: float) -> str:
    return f"{kilograms:.3g} kg" if kilograms >= 1.0 else f"{1000.0 * kilograms:.3g} g"
