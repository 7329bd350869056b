"""Draws the pictures of the README from runs made here: `python docs/make_images.py`."""

import subprocess
import sys
from pathlib import Path

from cotouch import drawing
from cotouch.network import Network
from cotouch.scenario import FileTable
from cotouch.simulation import save_body_figure, understood
from cotouch.study import five_users
from cotouch.study._charts import held_and_released
from cotouch.study._experiment import experiment
from cotouch.study._topologies import topologies


def main() -> None:
    """Writes docs/images/five-users.png and liver.png."""
    images = Path(__file__).parent / "images"
    found = topologies(Network.read(five_users()))
    trials = experiment(found.best, found.worst, found.misjudged, period=1e-3)
    with drawing.style():
        figure = held_and_released(trials)
        figure.savefig(images / "five-users.png", dpi=110, bbox_inches="tight")
    _liver(images)


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
    save_body_figure(body, *understood(body), images).replace(images / "liver.png")


if __name__ == "__main__":
    main()
