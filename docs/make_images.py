"""Draws the pictures of the README and the documents from runs made here: `python docs/make_images.py`."""

import re
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from itertools import product
from pathlib import Path
from typing import cast

import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from cotouch import drawing
from cotouch.network import Network
from cotouch.scenario import FileTable, Scenario
from cotouch.simulation import body_report, figures, save_body_figure, simulate
from cotouch.study import five_users
from cotouch.study._charts import held_and_released
from cotouch.study._experiment import experiment
from cotouch.study._topologies import topologies

# Moments of each example [s], and from where they are looked at: above the floor and around it [degrees].
EXAMPLES: dict[str, tuple[tuple[float, ...], tuple[float, float]]] = {
    "block-between-two-hands": ((0.2, 0.8, 1.5), (18.0, -72.0)),
    "push-a-box": ((0.2, 1.3, 2.9), (30.0, -130.0)),
    "tower": ((0.4, 1.5, 2.6, 4.0), (14.0, -72.0)),
    "sheet": ((0.2, 1.4, 2.4, 5.0), (28.0, -65.0)),
}
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
    for name, (times, look) in EXAMPLES.items():
        _moments(images, name, times, look)


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


def _moments(images: Path, name: str, times: Sequence[float], look: tuple[float, float]) -> None:
    """Runs an example, and draws the first user's copy with everybody's hands at some moments [s]."""
    path = Path(__file__).parents[1] / "examples" / f"{name}.toml"
    scenario = Scenario.read(path).replace(record__nodes="all", record__every=10).placed()
    body, run = scenario.build_body(), simulate(scenario)
    assert body.skin is not None
    rows = [int(np.argmin(np.abs(run["time"].values[0] - time))) for time in times]
    shown = [body.skin.carried(run["position"].values[0, row]) for row in rows]
    wide = max((tool.radius for tool in scenario.tools), default=0.0)
    ends = [*shown, *(run["tool_position"].values[:, row] + wide * s for row in rows for s in (-1, 1) if wide)]
    low, high = np.min([s.min(axis=0) for s in ends], axis=0), np.max([s.max(axis=0) for s in ends], axis=0)
    eye = np.array([np.cos(angle) for angle in np.radians([look[1], 90.0 - look[1]])]) * np.cos(np.radians(look[0]))
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
            skin = places[body.skin.triangles]
            axes.add_collection3d(
                Poly3DCollection(skin, facecolors="#E4DFD3", edgecolors="#8A8578", linewidth=0.3, shade=True, zorder=2)
            )
            for index, tool in enumerate(scenario.tools):
                _ball(
                    axes,
                    run["tool_position"].values[index, row],
                    tool.radius,
                    drawing.USERS[tool.user - 1],
                    (places, eye),
                )
            for hand in scenario.hands:
                held = run["position"].values[hand.user - 1, row, hand.node - 1]
                _ball(axes, held, 0.02 * float((high - low).max()), drawing.USERS[hand.user - 1], (places, eye))
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
            axes.set_box_aspect(tuple(np.maximum(high - low, 1e-6)), zoom=0.95)
            axes.view_init(*look)
            axes.set_axis_off()
        figure.subplots_adjust(0.0, 0.0, 1.0, 0.94, 0.0, 0.0)
        (images / f"{name}.png").write_bytes(drawing.drawn(figure, format="png", dpi=110))


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
