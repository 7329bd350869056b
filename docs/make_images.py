"""Draws the pictures of the README and the documents from runs made here: `python docs/make_images.py`."""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

from cotouch import drawing
from cotouch.network import Network
from cotouch.scenario import FileTable, Scenario
from cotouch.simulation import body_report, figures, save_body_figure, simulate
from cotouch.study import five_users
from cotouch.study._charts import held_and_released
from cotouch.study._experiment import experiment
from cotouch.study._topologies import topologies


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


if __name__ == "__main__":
    main()
