"""What a mesh file holds."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float

Ints = npt.NDArray[np.int64]

SURFACES: Final = (".stl", ".obj", ".ply", ".off", ".glb")
VOLUMES: Final = (".vtk", ".vtu", ".msh", ".mesh")


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh:
    """What a file holds, in its own unit.

    Attributes:
        points: (P, 3).
        elements: triangles (F, 3) or tetrahedra (E, 4), indices of points.
        sets: indices of points of every named set.
        notes: what was left out or changed.
    """

    points: Float
    elements: Ints
    sets: Mapping[str, Ints] = field(default_factory=dict[str, Ints])
    notes: tuple[str, ...] = ()
