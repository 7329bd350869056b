"""Draws the pictures of the README from runs made here: `python docs/make_images.py`."""

from pathlib import Path

from cotouch.network import Network
from cotouch.simulation import _figures as drawing
from cotouch.study import five_users
from cotouch.study._charts import held_and_released
from cotouch.study._experiment import experiment
from cotouch.study._topologies import topologies


def main() -> None:
    """Writes docs/images/five-users.png."""
    found = topologies(Network.read(five_users()))
    trials = experiment(found.best, found.worst, found.misjudged, period=1e-3)
    with drawing.style():
        figure = held_and_released(trials)
        figure.savefig(Path(__file__).parent / "images" / "five-users.png", dpi=110, bbox_inches="tight")


if __name__ == "__main__":
    main()
