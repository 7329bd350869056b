"""What a mesh file holds."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final, final

from cotouch.arrays import Float, Long

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
    elements: Long
    sets: Mapping[str, Long] = field(default_factory=dict[str, Long])
    notes: tuple[str, ...] = ()
