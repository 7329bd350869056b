"""A relief on the skin: heights at points that lie fixed on it bring it nearer to a tool.

A point of the skin meets a ball that is larger by its height: `w = R/2 (1 - r² / (R + h)²)`, which is 0 where the gap
to the ball is h and R / 2 in the ball's middle, as without. What this adds to the energy of the bare skin is summed
over points fixed on the skin, so the energy is a function of the state and its force has no steps. Heights are at least
0, so nothing is added that pulls. Each triangle is cut into equal ones, a point in the middle of each.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from cotouch.arrays import Bool, Float, Int
from cotouch.errors import BodyError
from cotouch.kernels import at, part
from cotouch.mechanics._contact_laws._law import press
from cotouch.passing import by_address

# A triangle whose sine at a corner is smaller than the root of this is a line.
_FLAT = 1e-24


@by_address
class Relief(NamedTuple):
    """Heights on a triangulated skin.

    Attributes:
        height: of the points of one triangle after the other, >= 0, (P,) [m].
        first: a triangle's first point, (F,); empty if the skin is bare.
        cells: into how many parts its sides are cut; it has the square of that in points, (F,).
        top: the greatest height; 0: the skin is bare [m].
    """

    height: Float
    first: Int
    cells: Int
    top: float


def bare() -> Relief:
    """No relief."""
    return Relief(np.zeros(0), np.zeros(0, dtype=np.int32), np.zeros(0, dtype=np.int32), 0.0)


def relief_on(
    place: Float,
    corner: Int,
    height: Callable[[Float, Float], Float],
    *,
    spacing: float,
    most: int,
    smooth: Bool | None = None,
) -> Relief:
    """Heights at points of a skin at rest.

    Args:
        place: of the vertices, (V, 3) [m].
        corner: vertices of each triangle, (F, 3).
        height: of the relief at places, (P, 3) [m], where the skin has these normals, (P, 3): >= 0, (P,) [m].
        spacing: of the points at most, > 0 [m].
        most: points.
        smooth: triangles that stay without, (F,); None: there are none.

    Raises:
        BodyError: there would be more.
    """
    a, b, c = (place[corner[:, q]] for q in range(3))
    longest = np.max([np.linalg.norm(side, axis=1) for side in (b - a, c - b, a - c)], axis=0)
    cells = np.maximum(np.ceil(longest / spacing), 1.0)
    if smooth is not None:
        cells[smooth] = 1.0
    with np.errstate(over="ignore"):  # infinitely many are too many as well
        points = float((cells**2).sum())
    if points > most:
        count = f"{points:.3g}" if math.isfinite(points) else "countless"
        apart = math.sqrt(float((longest**2).sum()) / most)
        raise BodyError(
            f"the relief needs {count} points on this skin; at most {most:.3g} are possible, which are {apart:.2g} m "
            "apart"
        )
    normal = np.zeros(place.shape)
    for q in range(3):
        np.add.at(normal, corner[:, q], np.cross(b - a, c - a))
    cells = cells.astype(np.int32)
    first = np.concatenate([[0], np.cumsum(cells.astype(np.int64) ** 2)])
    heights = np.zeros(int(first[-1]))
    for count in np.unique(cells):
        own = np.flatnonzero(cells == count)
        shares = _shares(int(count))
        where = np.einsum("pq,fqa->fpa", shares, place[corner[own]]).reshape(-1, 3)
        ways = np.einsum("pq,fqa->fpa", shares, normal[corner[own]]).reshape(-1, 3)
        size = np.linalg.norm(ways, axis=1, keepdims=True)
        found = height(where, ways / np.where(size > 0.0, size, 1.0))
        heights[(first[own][:, None] + np.arange(len(shares))[None, :]).reshape(-1)] = found
    if smooth is not None:
        heights[first[:-1][smooth]] = 0.0
    return Relief(heights, first[:-1].astype(np.int32), cells, float(heights.max(initial=0.0)))


def _shares(count: int) -> Float:
    """Shares of the corners in the points of a triangle, in their order, (count², 3).

    Point `i count + j` is the middle of the small triangle that stands at (i, j); the one that hangs beside it, where
    there is one, has what is left of the square, counted from its end.
    """
    i, j = np.divmod(np.arange(count * count), count)
    hangs = i + j >= count
    first = np.where(hangs, count - 1 - i + 2.0 / 3.0, i + 1.0 / 3.0) / count
    second = np.where(hangs, count - 1 - j + 2.0 / 3.0, j + 1.0 / 3.0) / count
    return np.stack([1.0 - first - second, first, second], axis=1)


@part
def press_relief(
    law: Any,
    stiffness: float,
    radius: float,
    area: float,
    forces: bool,
    relief: Relief,
    f: int,
    spot: Float,
    out: Float,
) -> float:
    """Adds what the relief of one triangle does to what the bare triangle does; see `press_triangle`.

    Args:
        law: of the contact.
        stiffness: of the tool [N/m].
        radius: of the ball [m].
        area: of the triangle at rest [m²].
        forces: whether to add more than the energy.
        relief: of the skin, not bare.
        f: the triangle.
        spot: its corners and the middle of the ball, (4, 4) [m].
        out: as of `press_triangle`.

    Returns:
        How much more of the area at rest touches the ball [m²].
    """
    count, first, top = relief.cells[f], relief.first[f], radius + relief.top
    px, py, pz = spot[3, 0] - spot[0, 0], spot[3, 1] - spot[0, 1], spot[3, 2] - spot[0, 2]
    ux, uy, uz = spot[1, 0] - spot[0, 0], spot[1, 1] - spot[0, 1], spot[1, 2] - spot[0, 2]
    vx, vy, vz = spot[2, 0] - spot[0, 0], spot[2, 1] - spot[0, 1], spot[2, 2] - spot[0, 2]
    uu, uv, vv = ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz
    up, vp = ux * px + uy * py + uz * pz, vx * px + vy * py + vz * pz
    size = uu * vv - uv * uv
    if not size > _FLAT * uu * vv:
        return 0.0
    # Shares of two corners in the foot of the ball's middle, and how far those of the disc differ from them.
    b, c = (vv * up - uv * vp) / size, (uu * vp - uv * up) / size
    disc = top * top - (px * px + py * py + pz * pz - b * up - c * vp)
    if disc <= 0.0:
        return 0.0
    wide, high = math.sqrt(disc * vv / size), math.sqrt(disc * uu / size)
    if b + wide < 0.0 or c + high < 0.0 or b - wide > 1.0 or c - high > 1.0:
        return 0.0
    i0, i1 = int(max(b - wide, 0.0) * count), int(min(b + wide, 1.0) * count) + 1
    j0, j1 = int(max(c - high, 0.0) * count), int(min(c + high, 1.0) * count) + 1
    own, covered = area / (count * count), 0.0
    for i in range(i0, min(i1, count)):
        for j in range(j0, min(j1, count - i)):
            for hangs in range(1 if i + j == count - 1 else 2):
                point = i * count + j if hangs == 0 else (count - 1 - i) * count + count - 1 - j
                h = at(relief.height, first + point)
                if h <= 0.0:
                    continue
                sb, sc = (i + (1 + hangs) / 3.0) / count, (j + (1 + hangs) / 3.0) / count
                x, y, z = sb * ux + sc * vx - px, sb * uy + sc * vy - py, sb * uz + sc * vz - pz
                square, ball = x * x + y * y + z * z, (radius + h) * (radius + h)
                if square >= ball:
                    continue
                energy, pressure, slope = press(law, stiffness, radius, 0.5 * radius * (1.0 - square / ball))
                pull = pressure * radius / ball
                if square < radius * radius:
                    e0, p0, s0 = press(law, stiffness, radius, 0.5 * (radius - square / radius))
                    energy, pressure, slope, pull = energy - e0, pressure - p0, slope - s0, pull - p0 / radius
                else:
                    covered += own
                out[3, 3] += own * energy
                if not forces:
                    continue
                pull, pressure, slope = own * pull, own * pressure, own * max(slope, 0.0)
                for q in range(3):
                    share = 1.0 - sb - sc if q == 0 else sb if q == 1 else sc
                    out[q, 0] += share * pull * x
                    out[q, 1] += share * pull * y
                    out[q, 2] += share * pull * z
                    out[q, 3] += share * pressure
                    out[3, q] += share * slope
    return covered
