"""The point of a triangle that is nearest to another point."""

import math

from cotouch.arrays import Float
from cotouch.kernels import at, inner

# Square of the sine of two sides' angle up to which rounding may say wrongly whether a point is beyond a side.
_SLIVER = 1e-10
# Nearest point of a triangle: square of the distance, shares of the corners, and whether it lies within.
_Foot = tuple[float, float, float, float, bool]


@inner
def _square(x: float, y: float, z: float) -> float:
    return x * x + y * y + z * z


@inner
def foot(place: Float, i: int, j: int, k: int, x: float, y: float, z: float) -> _Foot:
    """The point of a triangle that is nearest to (x, y, z) [Ericson 2005, 5.1.5].

    Args:
        place: of the vertices, (V, 4) [m].
        i: its first corner.
        j: its second.
        k: its third.
        x: of the point [m].
        y: likewise.
        z: likewise.
    """
    ax, ay, az = at(place, (i, 0)), at(place, (i, 1)), at(place, (i, 2))
    ux, uy, uz = at(place, (j, 0)) - ax, at(place, (j, 1)) - ay, at(place, (j, 2)) - az
    vx, vy, vz = at(place, (k, 0)) - ax, at(place, (k, 1)) - ay, at(place, (k, 2)) - az
    px, py, pz = x - ax, y - ay, z - az
    uu, uv, vv = ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz
    up, vp = ux * px + uy * py + uz * pz, vx * px + vy * py + vz * pz
    size = uu * vv - uv * uv
    b, c, within = 0.0, 0.0, False
    b0, c0 = vv * up - uv * vp, uu * vp - uv * up
    flat = not size > _SLIVER * uu * vv
    if b0 > 0.0 and c0 > 0.0 and b0 + c0 < size and not flat:
        b, c, within = b0 / size, c0 / size, True
    else:  # the nearest of the sides that it is beyond; of a sliver, of all three
        best = math.inf
        if flat or c0 <= 0.0:
            s = min(max(up / uu, 0.0), 1.0) if uu > 0.0 else 0.0
            best, b = _square(px - s * ux, py - s * uy, pz - s * uz), s
        if flat or b0 <= 0.0:
            s = min(max(vp / vv, 0.0), 1.0) if vv > 0.0 else 0.0
            square = _square(px - s * vx, py - s * vy, pz - s * vz)
            if square < best:
                best, b, c = square, 0.0, s
        if flat or b0 + c0 >= size:
            ww = uu - 2.0 * uv + vv
            s = min(max((vp - up - uv + uu) / ww, 0.0), 1.0) if ww > 0.0 else 0.0
            r = 1.0 - s
            square = _square(px - r * ux - s * vx, py - r * uy - s * vy, pz - r * uz - s * vz)
            if square < best:
                b, c = r, s
    gx, gy, gz = px - b * ux - c * vx, py - b * uy - c * vy, pz - b * uz - c * vz
    return gx * gx + gy * gy + gz * gz, 1.0 - b - c, b, c, within


@inner
def normal(place: Float, i: int, j: int, k: int) -> tuple[float, float, float]:
    """Unit normal of a triangle.

    Args:
        place: of the vertices, (V, 4) [m].
        i: its first corner.
        j: its second.
        k: its third.
    """
    ax, ay, az = at(place, (i, 0)), at(place, (i, 1)), at(place, (i, 2))
    ux, uy, uz = at(place, (j, 0)) - ax, at(place, (j, 1)) - ay, at(place, (j, 2)) - az
    vx, vy, vz = at(place, (k, 0)) - ax, at(place, (k, 1)) - ay, at(place, (k, 2)) - az
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size = math.sqrt(nx * nx + ny * ny + nz * nz)
    scale = 1.0 / size if size > 0.0 else 0.0
    return scale * nx, scale * ny, scale * nz
