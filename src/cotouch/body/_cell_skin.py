"""A skin that runs through cubes, divided where it passes from one to the next."""

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.body._cells import shapes_of
from cotouch.body._skin import Skin

# A corner this near to a plane of the grid lies on it; where a piece is, is asked this far inside; both in cubes.
_ON, _INWARD = 1e-7, 1e-5


def divided(skin: Skin, rest: Float, cubes: Long) -> tuple[Skin, Long]:
    """The same skin in triangles that each lie in one cube and hang on its corners.

    Args:
        skin: of the body.
        rest: places of its nodes, (n, 3) [m].
        cubes: their corners, (E, 8).

    Returns:
        The skin, and the cube of each triangle, (F,).
    """
    low, spacing = rest.min(axis=0), float(np.linalg.norm(rest[cubes[0, 4]] - rest[cubes[0, 0]]))
    places = np.rint((rest[cubes[:, 0]] - low) / spacing).astype(np.int64)
    number = {(int(x), int(y), int(z)): e for e, (x, y, z) in enumerate(places)}
    points = (skin.vertices - low) / spacing
    corners: list[Float] = []
    owner: list[int] = []
    for triangle in skin.triangles:
        ends = points[triangle]
        normal = np.cross(ends[1] - ends[0], ends[2] - ends[0])
        size = float(np.linalg.norm(normal))
        if size == 0.0:
            continue
        for piece in _pieces(ends):
            middle = piece.mean(axis=0) - _INWARD * normal / size
            cell = number.get((int(middle[0] // 1), int(middle[1] // 1), int(middle[2] // 1)))
            if cell is None:  # rounding at the rim of what is solid
                cell = int(np.argmin(np.abs(places + 0.5 - middle).max(axis=1)))
            for n in range(1, piece.shape[0] - 1):
                corners.append(piece[[0, n, n + 1]])
                owner.append(cell)
    cell = np.array(owner, dtype=np.int64)
    spots: Float = np.concatenate(corners)
    keys = np.column_stack([np.repeat(cell, 3), np.rint(spots / _ON).astype(np.int64)])
    _, first, vertex = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    of: Long = np.repeat(cell, 3)[first]
    local: Float = np.asarray(spots[first] - places[of], dtype=np.float64)
    made = Skin(
        vertices=spots[first] * spacing + low,
        triangles=vertex.reshape(-1, 3),
        nodes=cubes[of],
        weights=shapes_of(local),
    )
    return made, cell


def _pieces(ends: Float) -> list[Float]:
    """A triangle cut along all planes of the grid: polygons, (corners, 3)."""
    whole = [ends]
    for axis in range(3):
        parts: list[Float] = []
        for piece in whole:
            begin, end = float(piece[:, axis].min()), float(piece[:, axis].max())
            for plane in range(int(np.floor(begin + _ON)) + 1, int(np.ceil(end - _ON))):
                below, piece = _halves(piece, axis, float(plane))  # noqa: PLW2901  what is left of it
                parts.append(below)
            parts.append(piece)
        whole = [part for part in parts if part.shape[0] > 2]
    return whole


def _halves(piece: Float, axis: int, plane: float) -> tuple[Float, Float]:
    """What of a polygon lies below a plane, and what above."""
    below: list[Float] = []
    above: list[Float] = []
    height = piece[:, axis] - plane
    for n in range(piece.shape[0]):
        here, there = float(height[n]), float(height[(n + 1) % piece.shape[0]])
        on = abs(here) <= _ON
        if here <= 0.0 or on:
            below.append(piece[n])
        if here >= 0.0 or on:
            above.append(piece[n])
        if here * there < 0.0 and not on and abs(there) > _ON:
            share = here / (here - there)
            spot = (1.0 - share) * piece[n] + share * piece[(n + 1) % piece.shape[0]]
            spot[axis] = plane
            below.append(spot)
            above.append(spot)
    return np.array(below).reshape(-1, 3), np.array(above).reshape(-1, 3)
