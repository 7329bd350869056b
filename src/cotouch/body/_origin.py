"""Where a body came from and what was understood of it on the way."""

from dataclasses import dataclass, field
from typing import Literal, final

import numpy as np

from cotouch.arrays import Float, Index


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class Origin:
    """What a builder read, repaired and made; nothing holds it unless that is said.

    Attributes:
        source: name of the file, or "arrays".
        kind: "surface" (a lattice inside it, or rigid), "tetrahedra" or "shape" (a rigid one from a few numbers).
        model: as a builder was asked for it.
        unit: of the source.
        elements: number of cells or tetrahedra; of what is rigid, of triangles of its skin.
        volume: of the solid [m³].
        size: extents of the source along x, y, z, (3,) [m].
        spacing: edge of a cell; of tetrahedra, and of the triangles of what is rigid, the mean edge [m].
        held: indices of the nodes that the ground holds; by default none.
        free: number of rigid motions that nothing holds: 0 to 6, or 0 to 3 where springs resist turning by themselves;
            by default 6.
        notes: what was repaired or should be known, a sentence each.
    """

    source: str
    kind: Literal["surface", "tetrahedra", "shape"]
    model: str
    unit: str
    elements: int
    volume: float
    size: Float
    spacing: float
    held: Index = field(default_factory=lambda: np.zeros(0, dtype=np.intp))
    free: int = 6
    notes: tuple[str, ...] = ()
