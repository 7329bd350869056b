"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.study import _attack as attack
from cotouch.study._blocks import _BOOK as BOOK
from cotouch.study._blocks import _DEVICE as DEVICE
from cotouch.study._blocks import Blocks, blocks
from cotouch.study._charts import ranks as ranks_chart
from cotouch.study._confirm import _slowest as slowest
from cotouch.study._report_solid import solid as chapter
from cotouch.study._scene import RELEASE, SMALL, scene
from cotouch.study._solid import SHAPE, SolidFindings, claims, collaboration, solid, warm_up
from cotouch.study._solid_charts import copies, energies
from cotouch.study._tick import worst_tick

__all__ = [
    "BOOK",
    "DEVICE",
    "RELEASE",
    "SHAPE",
    "SMALL",
    "Blocks",
    "SolidFindings",
    "attack",
    "blocks",
    "chapter",
    "claims",
    "collaboration",
    "copies",
    "energies",
    "ranks_chart",
    "scene",
    "slowest",
    "solid",
    "warm_up",
    "worst_tick",
]
