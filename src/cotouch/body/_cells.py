"""The cells of a grid that a closed surface fills or touches, and how much of each it fills.

Inside is where the winding number is above 0, so what shells share counts once.
"""

from dataclasses import dataclass
from typing import Final, final

import numpy as np

from cotouch.arrays import Float, Long, extents
from cotouch.body._lines import crossings, turns
from cotouch.errors import BodyError

# Vertical lines through each cell, along each of two axes, on which what is inside is measured exactly.
_LINES: Final = 4
# Points on the surface are looked at this far inside of it, in cells, so that a face on the grid has its inner cells.
_INWARD: Final = 1e-5
# A cell that the surface only grazes is filled this much, or its nodes would weigh next to nothing.
LEAST_FILL: Final = 0.05
# Grids beyond this are refused before anything is allocated.
_MOST_CELLS: Final = 20_000_000
_BATCH: Final = 2_000_000

# Corners of a cell in the order of their weights.
CORNERS: Final[Long] = np.array([(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)], dtype=np.int64)


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Cells:
    """Part of a regular grid.

    Attributes:
        spacing: edge of a cell [m].
        origin: lowest corner of the grid, (3,) [m].
        shape: cells along each axis, (3,).
        places: which cells, sorted, (E, 3).
        fill: the share of each that is solid, (E,).
    """

    spacing: float
    origin: Float
    shape: Long
    places: Long
    fill: Float


def cells_of(vertices: Float, triangles: Long, resolution: int) -> Cells:
    """The cells that a closed surface fills or touches.

    Args:
        vertices: (V, 3) [m].
        triangles: (F, 3), turned outwards.
        resolution: cells along the longest side.

    Raises:
        BodyError: the grid is too fine.
    """
    low, extent = vertices.min(axis=0), np.ptp(vertices, axis=0)
    spacing = float(extent.max()) / resolution
    shape = np.maximum(np.ceil(extent / spacing - 1e-6), 1.0).astype(np.int64)
    if int(shape.prod()) > _MOST_CELLS:
        raise BodyError(
            f"resolution {resolution} makes a grid of {extents(shape)} cells; it must be lower, for at "
            f"most {_MOST_CELLS} of them"
        )
    origin = low - 0.5 * (shape * spacing - extent)
    fill = _filled((vertices - origin) / spacing, triangles, shape)
    touched = _touched((vertices - origin) / spacing, triangles, shape)
    fill[touched] = np.maximum(fill[touched], LEAST_FILL)
    fill[fill < 0.01 * LEAST_FILL] = 0.0  # rounding of lines that leave where they came in
    places = np.argwhere(fill > 0.0)
    values = np.maximum(fill[tuple(places.T)], LEAST_FILL)
    return Cells(spacing=spacing, origin=origin, shape=shape, places=places, fill=values)


def _filled(points: Float, triangles: Long, shape: Long) -> Float:
    """The share of every cell that is inside, (nx, ny, nz); places are in cells.

    A crossing that leads inside at z fills what is above z, and one that leads out empties it.
    """
    nx, ny, nz = (int(extent) for extent in shape)
    wide, deep = nx * _LINES, ny * _LINES
    lines = np.array([_LINES, _LINES, 1.0])
    line, height, winding, turn = crossings(points * lines, triangles, wide, deep)
    level = np.zeros(wide * deep * (nz + 2))
    inward = (winding + turn > 0) * 1.0 - (winding > 0) * 1.0
    through = inward != 0.0
    at, height, inward = line[through], np.clip(height[through], 0.0, float(nz)), inward[through]
    cell = np.minimum(height.astype(np.int64), nz - 1)
    above = (cell + 1) - height
    np.add.at(level, at * (nz + 2) + cell, inward * above)
    np.add.at(level, at * (nz + 2) + cell + 1, inward * (1.0 - above))
    inside = np.cumsum(level.reshape(wide, deep, nz + 2), axis=2)[:, :, :nz]
    inside = np.clip(inside, 0.0, 1.0)
    # A line that grazed an edge counts it twice or never and does not come out again; the others of its cell stand in.
    sound = (turns(line, turn, wide * deep) == 0).reshape(wide, deep).astype(np.float64)
    blocks = (nx, _LINES, ny, _LINES)
    number = sound.reshape(blocks).sum(axis=(1, 3))
    sums = (inside * sound[:, :, None]).reshape(*blocks, nz).sum(axis=(1, 3))
    return sums / np.maximum(number, 1.0)[:, :, None]


def _touched(points: Float, triangles: Long, shape: Long) -> tuple[Long, Long, Long]:
    """Cells in which the surface runs: those of points on it at most half a cell apart, and of its vertices."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal, axis=1)
    flat = length == 0.0
    normal = normal / np.where(flat, 1.0, length)[:, None]
    sides = np.stack([np.linalg.norm(b - a, axis=1), np.linalg.norm(c - b, axis=1), np.linalg.norm(a - c, axis=1)])
    parts = np.maximum(np.ceil(2.0 * sides.max(axis=0)), 1.0).astype(np.int64)
    found: list[Long] = []
    for number in np.unique(parts):
        chosen = np.flatnonzero((parts == number) & ~flat)
        grid = np.array([(i, j) for i in range(number + 1) for j in range(number + 1 - i)]) / number
        rows = max(1, _BATCH // len(grid))
        for begin in range(0, chosen.size, rows):
            some = chosen[begin : begin + rows]
            spots = (
                a[some, None] * (1.0 - grid.sum(axis=1))[None, :, None]
                + b[some, None] * grid[None, :, 0, None]
                + c[some, None] * grid[None, :, 1, None]
                - _INWARD * normal[some, None]
            )
            found.append(np.unique(_cell(spots.reshape(-1, 3), shape), axis=0))
    found.append(_cell(_drawn_in(points, triangles), shape))
    cells = np.unique(np.concatenate(found), axis=0)
    return cells[:, 0], cells[:, 1], cells[:, 2]


def _drawn_in(points: Float, triangles: Long) -> Float:
    """The vertices, moved inside by next to nothing."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    normal = normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    sums = np.zeros_like(points)
    for k in range(3):
        np.add.at(sums, triangles[:, k], normal)
    length = np.maximum(np.linalg.norm(sums, axis=1), 1e-300)
    return points - _INWARD * sums / length[:, None]


def _cell(spots: Float, shape: Long) -> Long:
    return np.clip(np.floor(spots).astype(np.int64), 0, shape - 1)


def carriers(vertices: Float, triangles: Long, cells: Cells) -> tuple[Long, Float]:
    """For every vertex the cell that it lies in, as a row of `cells.places`, and trilinear weights of its corners.

    Args:
        vertices: (V, 3) [m].
        triangles: (T, 3) indices of vertices.
        cells: of the lattice.

    Returns:
        rows (V,), and weights (V, 8) in the order of `CORNERS`.
    """
    points = (vertices - cells.origin) / cells.spacing
    places = _cell(_drawn_in(points, triangles), cells.shape)
    keys = np.asarray(np.ravel_multi_index(tuple(cells.places.T), tuple(cells.shape)))
    wanted = np.asarray(np.ravel_multi_index(tuple(places.T), tuple(cells.shape)))
    rows: Long = np.minimum(np.searchsorted(keys, wanted), keys.size - 1).astype(np.int64)
    assert np.array_equal(keys[rows], wanted)  # `cells_of` took every cell that holds a vertex
    return rows, shapes_of(points - places)


def shapes_of(local: Float) -> Float:
    """Trilinear weights of a cube's corners, (P, 8).

    Args:
        local: places in the cube, 0 to 1 along each side, (P, 3).
    """
    share = local[:, None, :]
    weights: Float = np.where(CORNERS[None] == 1, share, 1.0 - share).prod(axis=2)
    return weights
