"""Draws the pictures of the README and the documents from runs made here: `python docs/make_images.py`."""

import re
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from itertools import pairwise, product
from pathlib import Path
from typing import cast

import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
import xarray as xr
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from cotouch import drawing
from cotouch.body import Body, cut_skin, joined, turning
from cotouch.network import Network
from cotouch.scenario import FileTable, Scenario
from cotouch.scenario._world_table import PlateTable
from cotouch.simulation import body_report, figures, save_body_figure, simulate
from cotouch.study import five_users
from cotouch.study._charts import held_and_released
from cotouch.study._experiment import experiment
from cotouch.study._topologies import topologies

# Moments of each example [s], from where they are looked at: above the floor and around it [degrees], and how near.
EXAMPLES: dict[str, tuple[tuple[float, ...], tuple[float, float], float]] = {
    "block-between-two-hands": ((0.2, 0.8, 1.5), (18.0, -72.0), 0.95),
    "peg-in-hole": ((0.0, 1.4, 2.0, 3.4), (16.0, -60.0), 0.95),
    "push-a-box": ((0.2, 1.3, 2.9), (30.0, -130.0), 0.95),
    "tower": ((0.4, 1.5, 2.6, 4.0), (14.0, -72.0), 0.95),
    "sheet": ((0.2, 1.4, 2.4, 5.0), (28.0, -65.0), 0.95),
    "turn-a-block": ((0.0, 0.8, 1.5, 2.4), (34.0, -60.0), 0.95),
    "cut-a-liver": ((0.8, 1.7, 3.9), (24.0, -62.0), 1.05),
}
# A skin of more triangles is drawn with thinner lines.
_FINE = 2000
# Corners of a box's sides, in the order of `itertools.product`.
SIDES = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))


def main() -> None:
    """Writes into docs/images what is drawn rather than photographed."""
    images = Path(__file__).parent / "images"
    found = topologies(Network.read(five_users()))
    trials = experiment(found.best, found.worst, found.misjudged, period=1e-3)
    with drawing.style():
        figure = held_and_released(trials)
        figure.savefig(images / "five-users.png", dpi=110, bbox_inches="tight")
    _two_people(images)
    _links(images)
    _liver(images)
    for name, (times, look, zoom) in EXAMPLES.items():
        _moments(images, name, times, look, zoom)


def _two_people(images: Path) -> None:
    """Runs the scenario that the tutorial writes down."""
    tutorial = (images.parent / "tutorial.md").read_text(encoding="utf-8")
    written = re.search(r'title="two.toml"\n(.*?)```', tutorial, re.DOTALL)
    assert written is not None
    drawn = figures(simulate(Scenario.from_toml(written[1])))
    for name, figure in (("two-people", drawn["positions"]), ("two-people-energy", drawn["energies"])):
        (images / f"{name}.png").write_bytes(drawing.drawn(figure, format="png", dpi=160))


def _links(images: Path) -> None:
    """Plans as the tutorial does."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["plan", str(five_users()), "--links", "6", "--figures", folder]
        subprocess.run([sys.executable, "-m", "cotouch", *command], check=True)  # noqa: S603 (our own)
        (images / "links.png").write_bytes(Path(folder, "networks.png").read_bytes())


def _liver(images: Path) -> None:
    """Reads the liver that `examples/make_shapes.py` makes, as `cotouch body` does."""
    root = Path(__file__).parents[1]
    subprocess.run([sys.executable, root / "examples" / "make_shapes.py"], check=True)  # noqa: S603 (our own)
    table = FileTable.make(
        source="the picture",
        file=str(root / "examples" / "shapes" / "liver.stl"),
        unit="mm",
        resolution=24,
        model="elastic",
        young=5e3,
        ground={"box": {"low": [-0.2, 0.0, -0.02], "high": [0.0, 0.1, 0.1]}},
        ground_stiffness=200.0,
    )
    body = table.build()
    save_body_figure(body, *body_report(body), images).replace(images / "liver.png")


def _moments(images: Path, name: str, times: Sequence[float], look: tuple[float, float], zoom: float) -> None:
    """Runs an example, and draws the first user's copy with everybody's hands at some moments [s]."""
    path = Path(__file__).parents[1] / "examples" / f"{name}.toml"
    scenario = Scenario.read(path).replace(record__every=10)
    rigid = scenario.build_body().rigid
    scenario = (scenario if rigid else scenario.replace(record__nodes="all")).placed()
    body, run = scenario.build_body(), simulate(scenario)
    faces = cut_skin(body) if "cut_time" in run else None
    skin = body.skin if faces is None else faces.skin
    if body.tools:
        skin = joined([part for part in body.parts if part.tool is None]).skin
    assert skin is not None
    numbers = run["node"].values.tolist()
    rows = [int(np.argmin(np.abs(run["time"].values[0] - time))) for time in times]
    shown = [skin.carried(run["position"].values[0, row, : body.shared]) for row in rows]
    wide = max((tool.radius for tool in scenario.proxies if tool.kind != "blade"), default=0.0)
    ends = [*shown, *(_posed(run, body, k, row) for row in rows for k in range(len(body.tools)))]
    ends = [*ends, *(run["tool_position"].values[:, row] + wide * s for row in rows for s in (-1, 1) if wide)]
    low, high = np.min([s.min(axis=0) for s in ends], axis=0), np.max([s.max(axis=0) for s in ends], axis=0)
    eye = np.array([np.cos(angle) for angle in np.radians([look[1], 90.0 - look[1]])]) * np.cos(np.radians(look[0]))
    for plate in scenario.world.plates:
        half = 0.5 * np.array(plate.size)
        low, high = np.minimum(low, plate.centre - half), np.maximum(high, plate.centre + half)
    room = 0.25 * float((high - low).max())
    with drawing.style():
        figure = plt.figure(figsize=(4.0 * len(rows), 3.6))
        for number, (row, places) in enumerate(zip(rows, shown, strict=True), start=1):
            axes = cast("Axes3D", figure.add_subplot(1, len(rows), number, projection="3d", computed_zorder=False))
            axes.set_title(f"{run['time'].values[0, row]:.1f} s", fontsize=10)
            for table in scenario.world.planes:
                x, y = np.clip([low[0] - room, high[0] + room], -9, 9), [low[1] - room, high[1] + room]
                z = table.point[2]
                floor = [[(x[0], y[0], z), (x[1], y[0], z), (x[1], y[1], z), (x[0], y[1], z)]]
                axes.add_collection3d(
                    Poly3DCollection(floor, facecolor=drawing.SHADE, edgecolor=drawing.GRID, zorder=0)
                )
            for box in scenario.world.boxes:
                solid = np.array(list(product((-0.5, 0.5), repeat=3))) * box.size + box.centre
                sides = [solid[list(corners)] for corners in SIDES]
                axes.add_collection3d(Poly3DCollection(sides, facecolor="#AEB7C4", edgecolor=drawing.MUTED, zorder=1))
            for plate in scenario.world.plates:
                _plate(axes, plate, behind=True)
            drawn = skin.triangles
            if faces is not None:
                drawn = drawn[faces.shown(run["cut_time"].values[0] <= run["time"].values[0, row])]
            fine = 0.3 if len(drawn) < _FINE else 0.05
            axes.add_collection3d(
                Poly3DCollection(
                    places[drawn], facecolors="#E4DFD3", edgecolors="#8A8578", linewidth=fine, shade=True, zorder=2
                )
            )
            for index, tool in enumerate(scenario.proxies):
                if tool.kind == "blade":
                    ends = run["tool_position"].values[index, row] + np.outer([0.0, 1.0], tool.axis or [0.0])
                    middle = (ends.mean(axis=0) - places.mean(axis=0))[:2]
                    order = 3 if middle @ eye > 0.0 or ends[0, 2] > places[:, 2].max() else 1.5
                    axes.plot(*ends.T, color=drawing.USERS[tool.user - 1], linewidth=3.0, zorder=order)
                    continue
                _ball(
                    axes,
                    run["tool_position"].values[index, row],
                    tool.radius,
                    drawing.USERS[tool.user - 1],
                    (places, eye),
                )
            for index, part in enumerate(body.tools):
                solid, colour = _posed(run, body, index, row), drawing.USERS[scenario.rigid_tools[index].user - 1]
                order = 3 if (solid.mean(axis=0) - places.mean(axis=0))[:2] @ eye > 0.0 else 1.5
                order = 3 if solid[:, 2].mean() > places[:, 2].max() else order
                sides = solid[part.skin().triangles]
                axes.add_collection3d(Poly3DCollection(sides, facecolors=colour, shade=True, zorder=order))
            for hand in scenario.hands:
                held = run["position"].values[hand.user - 1, row, numbers.index(hand.node)]
                _ball(axes, held, 0.02 * float((high - low).max()), drawing.USERS[hand.user - 1], (places, eye))
            for plate in scenario.world.plates:
                _plate(axes, plate, behind=False)
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
            axes.set_box_aspect(tuple(np.maximum(high - low, 1e-6)), zoom=zoom)
            axes.view_init(*look)
            axes.set_axis_off()
        figure.subplots_adjust(0.0, 0.0, 1.0, 0.94, 0.0, 0.0)
        (images / f"{name}.png").write_bytes(drawing.drawn(figure, format="png", dpi=110))


def _posed(run: xr.Dataset, body: Body, index: int, row: int) -> npt.NDArray[np.float64]:
    """Vertices of a rigid tool where it is in a record."""
    part = body.tools[index]
    vertices = part.skin().vertices @ part.turn.T + part.shift
    begun, place = run["rigid_position"].values[index, [0, row]]
    return (vertices - begun) @ turning(run["rigid_rotation"].values[index, row].tolist()).T + place


def _plate(axes: Axes3D, plate: PlateTable, *, behind: bool) -> None:
    """Draws a level plate: what is behind of its hole, or a clear block that what goes in is seen through."""
    half, angle = 0.5 * np.array(plate.size), np.radians(np.arange(0, 361, 9))
    middle, low, high = (
        np.array([*plate.hole_at, 0.0]) + plate.centre,
        plate.centre[2] - half[2],
        plate.centre[2] + half[2],
    )
    way = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    if behind:
        rings = [(plate.hole_radius, low), (plate.hole_radius, high - plate.chamfer)]
        rings.append((plate.hole_radius + plate.chamfer, high))
        wall: list[npt.NDArray[np.float64]] = []
        for (r, z), (s, t) in pairwise(rings):
            below, above = (np.column_stack([middle[:2] + q * way, np.full(len(way), p)]) for q, p in ((r, z), (s, t)))
            wall += [np.stack([below[k], below[k + 1], above[k + 1], above[k]]) for k in range(len(way) - 1)]
        axes.add_collection3d(Poly3DCollection(wall, facecolor="#8F99A8", edgecolor="none", zorder=1))
        return
    solid = np.array(list(product((-1.0, 1.0), repeat=3))) * half + plate.centre
    sides = [solid[list(corners)] for number, corners in enumerate(SIDES) if number not in {4, 5}]
    axes.add_collection3d(Poly3DCollection(sides, facecolor="#AEB7C4", edgecolor=drawing.MUTED, alpha=0.3, zorder=3))
    rim = middle[:2] + (plate.hole_radius + plate.chamfer) * way
    edge = plate.centre[:2] + way / np.abs(way).max(axis=1, keepdims=True) * half[:2]
    top = [np.stack([rim[k], rim[k + 1], edge[k + 1], edge[k]]) for k in range(len(way) - 1)]
    lid = [np.column_stack([one, np.full(4, high)]) for one in top]
    axes.add_collection3d(Poly3DCollection(lid, facecolor="#AEB7C4", edgecolor="none", alpha=0.45, zorder=3))


def _ball(
    axes: "Axes3D",
    centre: npt.NDArray[np.float64],
    radius: float,
    colour: str,
    seen: tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]],
) -> None:
    """A hand, in front of or behind the places of a body, as seen from a direction along the floor."""
    u, v = np.meshgrid(np.linspace(0.0, 2.0 * np.pi, 24), np.linspace(0.0, np.pi, 13))
    order = 3 if (centre - seen[0].mean(axis=0))[:2] @ seen[1] > 0.0 else 1.5
    ball = [np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)]
    axes.plot_surface(*(c + radius * part for c, part in zip(centre, ball, strict=True)), color=colour, zorder=order)


if __name__ == "__main__":
    main()
