"""The point of a triangle that is nearest to a point."""

import numpy as np

from cotouch.arrays import Float
from cotouch.mechanics._kernel import block, part

# A triangle whose sine at a corner is smaller than the root of this is a line.
_FLAT = 1e-24


@part
def _inside(place: Float, ia: int, ib: int, ic: int, x: float, y: float, z: float, near: Float) -> bool:
    """Whether a point lies above the inside of a triangle; if so, `near` gets shares and foot."""
    ax, ay, az = place[ia, 0], place[ia, 1], place[ia, 2]
    ux, uy, uz = place[ib, 0] - ax, place[ib, 1] - ay, place[ib, 2] - az
    vx, vy, vz = place[ic, 0] - ax, place[ic, 1] - ay, place[ic, 2] - az
    px, py, pz = x - ax, y - ay, z - az
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size = nx * nx + ny * ny + nz * nz
    if not size > _FLAT * (ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz):
        return False
    b = (nx * (py * vz - pz * vy) + ny * (pz * vx - px * vz) + nz * (px * vy - py * vx)) / size
    c = (nx * (uy * pz - uz * py) + ny * (uz * px - ux * pz) + nz * (ux * py - uy * px)) / size
    a = 1.0 - b - c
    if not (a > 0.0 and b > 0.0 and c > 0.0):
        return False
    near[0, 0], near[0, 1], near[0, 2] = a, b, c
    near[1, 0], near[1, 1], near[1, 2] = ax + b * ux + c * vx, ay + b * uy + c * vy, az + b * uz + c * vz
    return True


@block
def nearest_point(place: Float, ia: int, ib: int, ic: int, x: float, y: float, z: float, near: Float) -> int:
    """Nearest point of a triangle to a point.

    Triangles that share an edge or a corner work out the same numbers for it, from the smaller index to the larger, and
    break ties alike. So they agree to the bit on whether it is nearest, however the point lies.

    Args:
        place: of all vertices, (vertices, 4) [m].
        ia: index of the first corner.
        ib: of the second.
        ic: of the third.
        x: of the point [m].
        y: likewise.
        z: likewise.
        near: filled, (2, 4).

    Returns:
        Where it is: 0, 1, 2 a corner, 3, 4, 5 on the edge 0-1, 1-2, 2-0, 6 inside. `near` gets the share of the corners
        in row 0 and the point in row 1.
    """
    if _inside(place, ia, ib, ic, x, y, z, near):
        return 6
    where, best, rank = 0, np.inf, 0
    vertices = place.shape[0]
    for corner in range(3):
        i = ia if corner == 0 else ib if corner == 1 else ic
        gx, gy, gz = x - place[i, 0], y - place[i, 1], z - place[i, 2]
        square = gx * gx + gy * gy + gz * gz
        if square < best or (square == best and i < rank):
            where, best, rank = corner, square, i
            near[0, 0], near[0, 1], near[0, 2] = 0.0, 0.0, 0.0
            near[0, corner] = 1.0
            near[1, 0], near[1, 1], near[1, 2] = place[i, 0], place[i, 1], place[i, 2]
    for side in range(3):
        i, j, first, second = ia, ib, 0, 1
        if side == 1:
            i, j, first, second = ib, ic, 1, 2
        elif side == 2:
            i, j, first, second = ic, ia, 2, 0
        if i > j:
            i, j, first, second = j, i, second, first
        ux, uy, uz = place[j, 0] - place[i, 0], place[j, 1] - place[i, 1], place[j, 2] - place[i, 2]
        dot = ux * (x - place[i, 0]) + uy * (y - place[i, 1]) + uz * (z - place[i, 2])
        size = ux * ux + uy * uy + uz * uz
        if not 0.0 < dot < size:
            continue  # a corner is as near
        fraction, own = dot / size, (i + 1) * vertices + j
        fx, fy, fz = place[i, 0] + fraction * ux, place[i, 1] + fraction * uy, place[i, 2] + fraction * uz
        gx, gy, gz = x - fx, y - fy, z - fz
        square = gx * gx + gy * gy + gz * gz
        if square < best or (square == best and own < rank):
            where, best, rank = 3 + side, square, own
            near[0, 0], near[0, 1], near[0, 2] = 0.0, 0.0, 0.0
            near[0, first] = 1.0 - fraction
            near[0, second] = fraction
            near[1, 0], near[1, 1], near[1, 2] = fx, fy, fz
    return where
