"""Where a body came from and what was understood of it on the way."""

from dataclasses import dataclass
from typing import Literal, TypedDict, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class Origin:
    """What a builder read, repaired and made.

    Attributes:
        source: name of the file, or "arrays".
        kind: "surface" (a lattice inside it, or rigid), "tetrahedra" or "shape" (a rigid one from a few numbers).
        model: as a builder was asked for it.
        unit: of the source.
        elements: number of cells or tetrahedra; of what is rigid, of triangles of its skin.
        volume: of the solid [m³].
        size: extents of the source along x, y, z, (3,) [m].
        spacing: edge of a cell; of tetrahedra, and of the triangles of what is rigid, the mean edge [m].
        held: indices of the nodes that the ground holds.
        free: number of rigid motions that nothing holds: 0 to 6, or 0 to 3 where springs resist turning by themselves.
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
    held: npt.NDArray[np.intp]
    free: int
    notes: tuple[str, ...] = ()


class SourceSaid(TypedDict):
    """What a builder read of it, before it is known what holds the body; see `Origin`."""

    source: str
    kind: Literal["surface", "tetrahedra", "shape"]
    model: str
    unit: str
    elements: int
    volume: float
    size: Float
    spacing: float


class ShapeSaid(SourceSaid, total=False):
    """Likewise of a rigid one, which nothing holds."""

    notes: tuple[str, ...]
