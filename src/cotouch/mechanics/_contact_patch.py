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

from cotouch.arrays import Float
from cotouch.mechanics._contact_law import press
from cotouch.mechanics._kernel import part
from cotouch.mechanics._vector import FOUR, load, splat, total, upper


def _gauss(points: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Places and weights of Gauss's rule on [0, 1]."""
    place, weight = np.polynomial.legendre.leggauss(points)
    return tuple((0.5 + 0.5 * place).tolist()), tuple((0.5 * weight).tolist())


# From the foot outwards to a side: weights times powers of the place, an element of the area and moments of it.
_OUT, _OUT_WEIGHT = _gauss(6)
_OUT_SQUARE = tuple(r * r for r in _OUT)
_OUT_AREA = tuple(w * r for r, w in zip(_OUT, _OUT_WEIGHT, strict=True))
_OUT_FIRST = tuple(w * r for r, w in zip(_OUT, _OUT_AREA, strict=True))
_OUT_SECOND = tuple(w * r for r, w in zip(_OUT, _OUT_FIRST, strict=True))
# Along a side, and from the foot outwards to the edge of the disc: rows of places and of weights, four points at once.
_SIDE = np.array(_gauss(4))
_DISC = np.array(_gauss(8)).reshape(4, 4)
# A triangle whose sine at a corner is smaller than the root of this is a line.
_FLAT = 1e-24


@part
def press_triangle(
    law: Any, stiffness: float, radius: float, area: float, forces: bool, spot: Float, out: Float
) -> float:
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
        How much of the area at rest lies in the ball [m²]; 0: they do not overlap, and `out` is as it was.
    """
    ax, ay, az = spot[0, 0], spot[0, 1], spot[0, 2]
    ux, uy, uz = spot[1, 0] - ax, spot[1, 1] - ay, spot[1, 2] - az
    vx, vy, vz = spot[2, 0] - ax, spot[2, 1] - ay, spot[2, 2] - az
    mx, my, mz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size = math.sqrt(mx * mx + my * my + mz * mz)
    length = math.sqrt(ux * ux + uy * uy + uz * uz)
    if not size * size > _FLAT * length * length * (vx * vx + vy * vy + vz * vz):
        return 0.0
    mx, my, mz = mx / size, my / size, mz / size
    px, py, pz = spot[3, 0] - ax, spot[3, 1] - ay, spot[3, 2] - az
    height = px * mx + py * my + pz * mz
    disc = radius * radius - height * height
    if disc <= 0.0:
        return 0.0
    ux, uy, uz = ux / length, uy / length, uz / length
    wx, wy, wz = my * uz - mz * uy, mz * ux - mx * uz, mx * uy - my * ux
    # Corners in the plane, from the foot.
    x0, y0 = -(px * ux + py * uy + pz * uz), -(px * wx + py * wy + pz * wz)
    x1, y1 = x0 + length, y0
    x2, y2 = x0 + vx * ux + vy * uy + vz * uz, y0 + vx * wx + vy * wy + vz * wz
    first0, last0 = _chord(x0, y0, x1 - x0, y1 - y0, disc)
    first1, last1 = _chord(x1, y1, x2 - x1, y2 - y1, disc)
    first2, last2 = _chord(x2, y2, x0 - x2, y0 - y2, disc)
    inside = x0 * y1 - y0 * x1 > 0.0 and x1 * y2 - y1 * x2 > 0.0 and x2 * y0 - y2 * x0 > 0.0
    if not (inside or first0 < last0 or first1 < last1 or first2 < last2):
        return 0.0
    within = first0 == 0.0 and last0 == 1.0 and first1 == 0.0 and last1 == 1.0 and first2 == 0.0 and last2 == 1.0
    edge, deeper = math.sqrt(disc), 1.0 / (2.0 * radius)
    top, zero = disc * deeper, splat(0.0, FOUR)
    # Radial moments of the pressure over the disc, and of slope and energy.
    r0, r1, r2, rs, re = 0.0, 0.0, 0.0, 0.0, 0.0
    if not within:
        v0, v1, v2, vs, ve = zero, zero, zero, zero, zero
        for k in range(2):
            r = edge * load(_DISC, k, FOUR)
            energy, pressure, slope = press(law, stiffness, radius, upper(top - deeper * (r * r), zero))
            weight = edge * load(_DISC, 2 + k, FOUR) * r
            ve = ve + weight * energy
            vs = vs + weight * slope
            weight = weight * pressure
            v0 = v0 + weight
            weight = weight * r
            v1 = v1 + weight
            v2 = v2 + weight * r
        r0, r1, r2, rs, re = total(v0), total(v1), total(v2), total(vs), total(ve)
    scale = area / (0.5 * size)
    # Sums over the plane: energy; slopes; pressure times 1, x, y, xx, xy, yy.
    se, ss, sc, covered = 0.0, 0.0, 0.0, 0.0
    sx, sy, sxx, sxy, syy = 0.0, 0.0, 0.0, 0.0, 0.0
    hx, hy = 0.0, 0.0  # slopes times x, y
    # The same at four points of a side at once.
    ue, us, uc, uhx, uhy = zero, zero, zero, zero, zero
    upx, upy, uxx, uxy, uyy = zero, zero, zero, zero, zero
    for side in range(3):
        fx, fy = (x0, y0) if side == 0 else (x1, y1) if side == 1 else (x2, y2)
        tx, ty = (x1, y1) if side == 0 else (x2, y2) if side == 1 else (x0, y0)
        first, last = (first0, last0) if side == 0 else (first1, last1) if side == 1 else (first2, last2)
        dx, dy = tx - fx, ty - fy
        for piece in range(0 if within else 2):  # outside of the disc: a sector
            begin, end = (0.0, first) if piece == 0 else (last, 1.0)
            if first >= last:
                begin, end = 0.0, 1.0 if piece == 0 else 0.0
            if end <= begin:
                continue
            gx, gy, kx, ky = fx + begin * dx, fy + begin * dy, fx + end * dx, fy + end * dy
            across, along = gx * ky - gy * kx, gx * kx + gy * ky
            half = 0.5 * math.atan2(across, along)
            se += 2.0 * half * re
            covered += half * disc
            if not forces:
                continue
            far = math.sqrt(gx * gx + gy * gy)
            # Cosine and sine of half the angle, each by the form that does not cancel.
            span = far * math.sqrt(kx * kx + ky * ky)
            if along > 0.0:
                c = math.sqrt(0.5 + 0.5 * along / span)
                s = 0.5 * across / (span * c)
            else:
                s = math.copysign(math.sqrt(0.5 - 0.5 * along / span), across)
                c = 0.5 * across / (span * s)
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
            share = first + (last - first) * load(_SIDE, 0, FOUR)
            ex, ey = fx + share * dx, fy + share * dy
            square = deeper * (ex * ex + ey * ey)
            cross = (fx * ty - fy * tx) * (last - first)
            covered += 0.5 * cross
            weight = cross * load(_SIDE, 1, FOUR)
            e0, p0, p1, p2, s0, s1 = zero, zero, zero, zero, zero, zero
            if not forces:
                for b in range(6):
                    energy, _, _ = press(law, stiffness, radius, upper(top - _OUT_SQUARE[b] * square, zero))
                    e0 = e0 + _OUT_AREA[b] * energy
                ue = ue + weight * e0
                continue
            for b in range(6):
                energy, pressure, slope = press(law, stiffness, radius, upper(top - _OUT_SQUARE[b] * square, zero))
                e0 = e0 + _OUT_AREA[b] * energy
                p0 = p0 + _OUT_AREA[b] * pressure
                p1 = p1 + _OUT_FIRST[b] * pressure
                p2 = p2 + _OUT_SECOND[b] * pressure
                s0 = s0 + _OUT_AREA[b] * slope
                s1 = s1 + _OUT_FIRST[b] * slope
            ue = ue + weight * e0
            us = us + weight * s0
            uc = uc + weight * p0
            fromx, fromy = weight * ex, weight * ey
            upx = upx + fromx * p1
            upy = upy + fromy * p1
            uxx = uxx + fromx * (ex * p2)
            uxy = uxy + fromx * (ey * p2)
            uyy = uyy + fromy * (ey * p2)
            uhx = uhx + fromx * s1
            uhy = uhy + fromy * s1
    se += total(ue)
    out[3, 3] += scale * se
    if not forces:
        return scale * covered
    ss, sc, sx, sy = ss + total(us), sc + total(uc), sx + total(upx), sy + total(upy)
    sxx, sxy, syy, hx, hy = sxx + total(uxx), sxy + total(uxy), syy + total(uyy), hx + total(uhx), hy + total(uhy)
    for corner in range(3):
        bx, by = (x1, y1) if corner == 0 else (x2, y2) if corner == 1 else (x0, y0)
        cx, cy = (x2, y2) if corner == 0 else (x0, y0) if corner == 1 else (x1, y1)
        # Share of the corner in a point of the plane.
        l0, lx, ly = (bx * cy - by * cx) / size, (by - cy) / size, (cx - bx) / size
        borne = l0 * sc + lx * sx + ly * sy
        along = (l0 * sx + lx * sxx + ly * sxy) * scale / radius
        beside = (l0 * sy + lx * sxy + ly * syy) * scale / radius
        down = -height * borne * scale / radius
        out[corner, 0] += along * ux + beside * wx + down * mx
        out[corner, 1] += along * uy + beside * wy + down * my
        out[corner, 2] += along * uz + beside * wz + down * mz
        out[corner, 3] += scale * borne
        out[3, corner] += scale * max(l0 * ss + lx * hx + ly * hy, 0.0)
    return scale * covered


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
