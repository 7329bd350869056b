"""Whether the area that a blade sweeps comes nearer to an element than half the blade is thick."""
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float, Int
from cotouch.kernels import at, block, part


@block
def crosses(spot: Float, first: int, edge: Int, face: Int, reach: float) -> bool:
    """Whether a quadrilateral comes within reach of a convex element or of a spring.

    Args:
        spot: corners of the element, then the four of the quadrilateral in turn, (first + 4, 4) [m].
        first: how many corners the element has.
        edge: pairs of its corners, (s, 2).
        face: triples of them, (q, 3); none of a spring.
        reach: >= 0 [m].
    """
    apart = 0.0
    for a in range(3):
        low, high, least, most = math.inf, -math.inf, math.inf, -math.inf
        for c in range(first):
            low, high = min(low, spot[c, a]), max(high, spot[c, a])
        for c in range(first, first + 4):
            least, most = min(least, spot[c, a]), max(most, spot[c, a])
        apart = max(apart, low - most, least - high)
    if apart > reach:
        return False
    one, two, three, four = first, first + 1, first + 2, first + 3
    for s in range(edge.shape[0]):
        i, j = at(edge, (s, 0)), at(edge, (s, 1))
        if near_triangle(spot, i, j, one, two, three, reach) or near_triangle(spot, i, j, one, three, four, reach):
            return True
    if face.shape[0] == 0:
        return False
    for q in range(face.shape[0]):
        a, b, c = at(face, (q, 0)), at(face, (q, 1)), at(face, (q, 2))
        for side in range(4):
            i, j = first + side, first + (side + 1) % 4
            if near_triangle(spot, i, j, a, b, c, reach):
                return True
    return _within(spot, first, face)


@part
def _within(spot: Float, first: int, face: Int) -> bool:
    """Whether the first corner of a quadrilateral that meets no face is inside."""
    outside = -math.inf
    for q in range(face.shape[0]):
        outside = max(outside, _volume(spot, at(face, (q, 0)), at(face, (q, 1)), at(face, (q, 2)), first))
    return outside <= 0.0


@part
def _volume(spot: Float, a: int, b: int, c: int, d: int) -> float:
    """Six times the volume of four points, above 0 where d is on the side of `a b c` that sees it turn left."""
    ux, uy, uz = spot[b, 0] - spot[a, 0], spot[b, 1] - spot[a, 1], spot[b, 2] - spot[a, 2]
    vx, vy, vz = spot[c, 0] - spot[a, 0], spot[c, 1] - spot[a, 1], spot[c, 2] - spot[a, 2]
    x, y, z = spot[d, 0] - spot[a, 0], spot[d, 1] - spot[a, 1], spot[d, 2] - spot[a, 2]
    return x * (uy * vz - uz * vy) + y * (uz * vx - ux * vz) + z * (ux * vy - uy * vx)


@part
def near_triangle(spot: Float, i: int, j: int, a: int, b: int, c: int, reach: float) -> bool:
    """Whether the line from i to j comes within reach of a triangle.

    Args:
        spot: places, (points, 3 or more) [m].
        i: point at one end of the line.
        j: at the other.
        a: corner of the triangle.
        b: likewise.
        c: likewise.
        reach: >= 0 [m].
    """
    one, two = _volume(spot, a, b, c, i), _volume(spot, a, b, c, j)
    if (one > 0.0) != (two > 0.0):
        p, q, r = _volume(spot, i, j, a, b), _volume(spot, i, j, b, c), _volume(spot, i, j, c, a)
        if (p >= 0.0 and q >= 0.0 and r >= 0.0) or (p <= 0.0 and q <= 0.0 and r <= 0.0):
            return True
    most = reach * reach
    return (
        _lines(spot, i, j, a, b) <= most
        or _lines(spot, i, j, b, c) <= most
        or _lines(spot, i, j, c, a) <= most
        or _above(spot, i, a, b, c) <= most
        or _above(spot, j, a, b, c) <= most
    )


@part
def _above(spot: Float, p: int, a: int, b: int, c: int) -> float:
    """Square of the distance of a point from the plane of a triangle that it lies above; else infinite [m²]."""
    ux, uy, uz = spot[b, 0] - spot[a, 0], spot[b, 1] - spot[a, 1], spot[b, 2] - spot[a, 2]
    vx, vy, vz = spot[c, 0] - spot[a, 0], spot[c, 1] - spot[a, 1], spot[c, 2] - spot[a, 2]
    x, y, z = spot[p, 0] - spot[a, 0], spot[p, 1] - spot[a, 1], spot[p, 2] - spot[a, 2]
    uu, uv, vv = ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz
    up, vp = x * ux + y * uy + z * uz, x * vx + y * vy + z * vz
    size = uu * vv - uv * uv
    if not size > 0.0:
        return math.inf
    s, t = (vv * up - uv * vp) / size, (uu * vp - uv * up) / size
    if s < 0.0 or t < 0.0 or s + t > 1.0:
        return math.inf
    x, y, z = x - s * ux - t * vx, y - s * uy - t * vy, z - s * uz - t * vz
    return x * x + y * y + z * z


@part
def _lines(spot: Float, i: int, j: int, k: int, l: int) -> float:
    """Square of the distance between two lines with ends [m²; after Ericson 2005, section 5.1.9]."""
    dx, dy, dz = spot[j, 0] - spot[i, 0], spot[j, 1] - spot[i, 1], spot[j, 2] - spot[i, 2]
    ex, ey, ez = spot[l, 0] - spot[k, 0], spot[l, 1] - spot[k, 1], spot[l, 2] - spot[k, 2]
    rx, ry, rz = spot[i, 0] - spot[k, 0], spot[i, 1] - spot[k, 1], spot[i, 2] - spot[k, 2]
    a, e = dx * dx + dy * dy + dz * dz, ex * ex + ey * ey + ez * ez
    b, c, f = dx * ex + dy * ey + dz * ez, dx * rx + dy * ry + dz * rz, ex * rx + ey * ry + ez * rz
    size = a * e - b * b
    s = min(max((b * f - c * e) / size, 0.0), 1.0) if size > 0.0 else 0.0
    t = (b * s + f) / e if e > 0.0 else 0.0
    if t < 0.0 or t > 1.0 or e == 0.0:
        t = min(max(t, 0.0), 1.0)
        s = min(max((b * t - c) / a, 0.0), 1.0) if a > 0.0 else 0.0
    x, y, z = rx + s * dx - t * ex, ry + s * dy - t * ey, rz + s * dz - t * ez
    return x * x + y * y + z * z
