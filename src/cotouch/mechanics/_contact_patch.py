"""Energy and forces of a ball on a triangle, exactly: the integral of a contact law over what lies in the ball.

The triangle's plane cuts the ball in a disc about the foot of its middle. A triangle is the signed sum of three
triangles from the foot to its sides; of each, the part in the disc is integrated from the foot outwards, and the rest
is a sector of the disc, in closed form. So the sum over a flat is the same however it is cut into triangles, and no
triangle is too large: nothing depends on where points lie.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.mechanics._contact_law import press
from cotouch.mechanics._kernel import block, part

Int = npt.NDArray[np.int32]


def _gauss(points: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Places and weights of Gauss's rule on [0, 1]."""
    place, weight = np.polynomial.legendre.leggauss(points)
    return tuple((0.5 + 0.5 * place).tolist()), tuple((0.5 * weight).tolist())


# Along a side, and from the foot outwards.
_SIDE, _SIDE_WEIGHT = _gauss(4)
_OUT, _OUT_WEIGHT = _gauss(6)
# Weights times powers of the place: an element of the area, and moments of it.
_OUT_AREA = tuple(w * r for r, w in zip(_OUT, _OUT_WEIGHT, strict=True))
_OUT_FIRST = tuple(w * r for r, w in zip(_OUT, _OUT_AREA, strict=True))
_OUT_SECOND = tuple(w * r for r, w in zip(_OUT, _OUT_FIRST, strict=True))
# A triangle whose sine at a corner is smaller than the root of this is a line.
_FLAT = 1e-24


@part
def press_triangle(
    law: Any, stiffness: float, radius: float, area: float, forces: bool, spot: Float, out: Float
) -> bool:
    """Adds what one ball does on one triangle.

    Args:
        law: of the contact.
        stiffness: of the tool [N/m].
        radius: of the ball [m].
        area: of the triangle at rest; what it holds does not grow as it is stretched [m²].
        forces: whether to add more than the energy.
        spot: its corners and the middle of the ball, (4, 4) [m].
        out: rows 0 to 2: force on each corner [N], and its share of the pressure's sum [N]; row 3: the sum of the
            slopes for each corner [N/m], and the energy [J]; (4, 4).

    Returns:
        Whether they overlap; if not, `out` is as it was.
    """
    ax, ay, az = spot[0, 0], spot[0, 1], spot[0, 2]
    ux, uy, uz = spot[1, 0] - ax, spot[1, 1] - ay, spot[1, 2] - az
    vx, vy, vz = spot[2, 0] - ax, spot[2, 1] - ay, spot[2, 2] - az
    mx, my, mz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size = math.sqrt(mx * mx + my * my + mz * mz)
    length = math.sqrt(ux * ux + uy * uy + uz * uz)
    if not size * size > _FLAT * length * length * (vx * vx + vy * vy + vz * vz):
        return False
    mx, my, mz = mx / size, my / size, mz / size
    px, py, pz = spot[3, 0] - ax, spot[3, 1] - ay, spot[3, 2] - az
    height = px * mx + py * my + pz * mz
    disc = radius * radius - height * height
    if disc <= 0.0:
        return False
    ux, uy, uz = ux / length, uy / length, uz / length
    wx, wy, wz = my * uz - mz * uy, mz * ux - mx * uz, mx * uy - my * ux
    # Corners in the plane, from the foot.
    x0, y0 = -(px * ux + py * uy + pz * uz), -(px * wx + py * wy + pz * wz)
    x1, y1 = x0 + length, y0
    x2, y2 = x0 + vx * ux + vy * uy + vz * uz, y0 + vx * wx + vy * wy + vz * wz
    inside, meets, within = True, False, True
    for side in range(3):
        fx, fy = (x0, y0) if side == 0 else (x1, y1) if side == 1 else (x2, y2)
        tx, ty = (x1, y1) if side == 0 else (x2, y2) if side == 1 else (x0, y0)
        inside = inside and fx * ty - fy * tx > 0.0
        first, last = _chord(fx, fy, tx - fx, ty - fy, disc)
        meets = meets or first < last
        within = within and first == 0.0 and last == 1.0
    if not meets and not inside:
        return False
    edge, deeper = math.sqrt(disc), 1.0 / (2.0 * radius)
    # Radial moments of the pressure over the disc, and of slope and energy.
    r0, r1, r2, rs, re = 0.0, 0.0, 0.0, 0.0, 0.0
    for k in range(0 if within else 6):
        r = edge * _OUT[k]
        energy, pressure, slope = press(law, stiffness, radius, (disc - r * r) * deeper)
        weight = edge * _OUT_WEIGHT[k] * r
        r0 += weight * pressure
        r1 += weight * pressure * r
        r2 += weight * pressure * r * r
        rs += weight * slope
        re += weight * energy
    scale = area / (0.5 * size)
    # Sums over the plane: energy; slopes; pressure times 1, x, y, xx, xy, yy.
    se, ss, sc = 0.0, 0.0, 0.0
    sx, sy, sxx, sxy, syy = 0.0, 0.0, 0.0, 0.0, 0.0
    hx, hy = 0.0, 0.0  # slopes times x, y
    for side in range(3):
        fx, fy = (x0, y0) if side == 0 else (x1, y1) if side == 1 else (x2, y2)
        tx, ty = (x1, y1) if side == 0 else (x2, y2) if side == 1 else (x0, y0)
        dx, dy = tx - fx, ty - fy
        first, last = _chord(fx, fy, dx, dy, disc)
        for piece in range(2):  # outside of the disc: a sector
            begin, end = (0.0, first) if piece == 0 else (last, 1.0)
            if first >= last:
                begin, end = 0.0, 1.0 if piece == 0 else 0.0
            if end <= begin:
                continue
            gx, gy, kx, ky = fx + begin * dx, fy + begin * dy, fx + end * dx, fy + end * dy
            half = 0.5 * math.atan2(gx * ky - gy * kx, gx * kx + gy * ky)
            se += 2.0 * half * re
            if not forces:
                continue
            far = math.sqrt(gx * gx + gy * gy)
            c, s = math.cos(half), math.sin(half)
            nx, ny = (gx * c - gy * s) / far, (gx * s + gy * c) / far
            long, wide = half + s * c, half - s * c
            ss += 2.0 * half * rs
            sc += 2.0 * half * r0
            sx += 2.0 * s * nx * r1
            sy += 2.0 * s * ny * r1
            sxx += (long * nx * nx + wide * ny * ny) * r2
            sxy += (long - wide) * nx * ny * r2
            syy += (long * ny * ny + wide * nx * nx) * r2
            hx += 2.0 * s * nx * rs * edge * (2.0 / 3.0)
            hy += 2.0 * s * ny * rs * edge * (2.0 / 3.0)
        if first < last:
            cross = (fx * ty - fy * tx) * (last - first)
            for a in range(4):
                t = first + (last - first) * _SIDE[a]
                ex, ey = fx + t * dx, fy + t * dy
                square, weight = (ex * ex + ey * ey) * deeper, cross * _SIDE_WEIGHT[a]
                top, e0, p0, p1, p2, s0, s1 = disc * deeper, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
                if not forces:
                    for b in range(6):
                        depth = max(top - _OUT[b] * _OUT[b] * square, 0.0)
                        energy, _, _ = press(law, stiffness, radius, depth)
                        e0 += _OUT_AREA[b] * energy
                    se += weight * e0
                    continue
                for b in range(6):
                    depth = max(top - _OUT[b] * _OUT[b] * square, 0.0)
                    energy, pressure, slope = press(law, stiffness, radius, depth)
                    e0 += _OUT_AREA[b] * energy
                    p0 += _OUT_AREA[b] * pressure
                    p1 += _OUT_FIRST[b] * pressure
                    p2 += _OUT_SECOND[b] * pressure
                    s0 += _OUT_AREA[b] * slope
                    s1 += _OUT_FIRST[b] * slope
                se += weight * e0
                ss += weight * s0
                sc += weight * p0
                sx += weight * ex * p1
                sy += weight * ey * p1
                sxx += weight * ex * ex * p2
                sxy += weight * ex * ey * p2
                syy += weight * ey * ey * p2
                hx += weight * ex * s1
                hy += weight * ey * s1
    out[3, 3] += scale * se
    if not forces:
        return True
    for corner in range(3):
        bx, by = (x1, y1) if corner == 0 else (x2, y2) if corner == 1 else (x0, y0)
        cx, cy = (x2, y2) if corner == 0 else (x0, y0) if corner == 1 else (x1, y1)
        # Share of the corner in a point of the plane.
        l0, lx, ly = (bx * cy - by * cx) / size, (by - cy) / size, (cx - bx) / size
        load = l0 * sc + lx * sx + ly * sy
        along = (l0 * sx + lx * sxx + ly * sxy) * scale / radius
        beside = (l0 * sy + lx * sxy + ly * syy) * scale / radius
        down = -height * load * scale / radius
        out[corner, 0] += along * ux + beside * wx + down * mx
        out[corner, 1] += along * uy + beside * wy + down * my
        out[corner, 2] += along * uz + beside * wz + down * mz
        out[corner, 3] += scale * load
        out[3, corner] += scale * max(l0 * ss + lx * hx + ly * hy, 0.0)
    return True


def press_skin(
    law: Any,
    place: Float,
    corner: Int,
    middle: Float,
    *,
    stiffness: float,
    radius: float,
    area: Float | None = None,
) -> tuple[float, Float]:
    """What a ball does on a skin that stands still; for tests and figures.

    Args:
        law: of the contact, one of `CONTACT_LAWS`.
        place: of the vertices, (V, 3) [m].
        corner: vertices of each triangle, (F, 3).
        middle: of the ball, (3,) [m].
        stiffness: of the tool [N/m].
        radius: of the ball [m].
        area: of each triangle at rest, (F,) [m²]; by default as it is now.

    Returns:
        The energy [J], and the force on each vertex, (V, 3) [N].
    """
    padded, force = np.zeros((place.shape[0], 4)), np.zeros((place.shape[0], 4))
    padded[:, :3] = place
    faces = np.ascontiguousarray(corner, dtype=np.int32)
    if area is None:
        a, b, c = (padded[faces[:, q], :3] for q in range(3))
        area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    spot, out = np.zeros((4, 4)), np.zeros((4, 4))
    spot[3, :3] = middle
    own = np.ascontiguousarray(area, dtype=np.float64)
    return _press_all(law, float(stiffness), float(radius), padded, faces, own, spot, out, force), force[:, :3]


@block
def _press_all(
    law: Any,
    stiffness: float,
    radius: float,
    place: Float,
    corner: Int,
    area: Float,
    spot: Float,
    out: Float,
    force: Float,
) -> float:
    energy = 0.0
    for f in range(corner.shape[0]):
        for q in range(3):
            for a in range(3):
                spot[q, a] = place[corner[f, q], a]
        for q in range(4):
            for a in range(4):
                out[q, a] = 0.0
        press_triangle(law, stiffness, radius, area[f], True, spot, out)
        energy += out[3, 3]
        for q in range(3):
            for a in range(4):
                force[corner[f, q], a] += out[q, a]
    return energy


@part
def _chord(fx: float, fy: float, dx: float, dy: float, disc: float) -> tuple[float, float]:
    """Between which shares of a side it lies in a disc about the origin; the second is not larger: nowhere."""
    square, along, over = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - disc
    under = along * along - square * over
    if not under > 0.0:
        return 1.0, 0.0
    root = math.sqrt(under)
    # Each root by the form that does not cancel.
    if along > 0.0:
        first, last = (-along - root) / square, over / (-along - root)
    else:
        first, last = over / (root - along), (root - along) / square
    return max(first, 0.0), min(last, 1.0)
