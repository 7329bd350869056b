"""A texture as a page draws it: one tile of heights that repeats, no larger than can be told from a finer one."""

import base64
from dataclasses import dataclass
from typing import Final, final

import numpy as np

from cotouch.arrays import Float

# Heights along a side of a tile: of a pattern; of a map at least, whose splines are seen between its own; and at most.
WAVE, _LEAST, MOST = 64, 128, 256
_LEVELS: Final = 2**16 - 1


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class DrawnTexture:
    """Heights on a skin at rest, by the projection that contact uses.

    Attributes:
        heights: of places in the middle of equal parts of the tile, rows along its second side, in [0, top], at most
            `MOST` by `MOST` [m].
        size: of the two sides of the tile, > 0 [m].
        top: the greatest height, > 0 [m].
        angle: by which it is turned in its plane [rad].
        projection: see `TextureTable`.
    """

    heights: Float
    size: tuple[float, float]
    top: float
    angle: float
    projection: str

    def table(self) -> dict[str, object]:
        """As JSON's values; heights are shares of the top in 16 bits."""
        levels = np.rint(np.clip(self.heights / self.top, 0.0, 1.0) * _LEVELS).astype("<u2")
        return {
            "rows": int(levels.shape[0]),
            "columns": int(levels.shape[1]),
            "heights": base64.b64encode(levels.tobytes()).decode("ascii"),
            "size": list(self.size),
            "top": self.top,
            "angle": self.angle,
            "projection": self.projection,
        }


def sides(heights: Float) -> tuple[int, int]:
    """Heights along the two sides of the tile of a map, rows first: as many as a map has, within bounds."""
    rows, columns = (min(max(count, _LEAST), MOST) for count in heights.shape)
    return (1 if heights.shape[0] == 1 else rows), (1 if heights.shape[1] == 1 else columns)


def coarser(heights: Float) -> Float:
    """A map with at most `MOST` heights along each side: means of those that are next to each other."""
    for axis in (0, 1):
        count = heights.shape[axis]
        if count > MOST:
            first = count * np.arange(MOST) // MOST
            shape = (-1, 1) if axis == 0 else (1, -1)
            each = np.diff(np.append(first, count)).reshape(shape)
            heights = np.add.reduceat(heights, first, axis=axis) / each
    return heights
