"""Energy and forces of a ball on a triangle, exactly: the integral of a contact law over what lies in the ball.

The triangle's plane cuts the ball in a disc about the foot of its middle. A triangle is the signed sum of three
triangles from the foot to its sides; of each, the part in the disc is integrated from the foot outwards, and the rest
is a sector of the disc, in closed form. So the sum over a flat is the same however it is cut into triangles, and no
triangle is too large: nothing depends on where points lie.

Pressure is the slope of the energy, and depth falls with the square of the distance to the foot. So its moments need
no sums over the area [divergence theorem]: with ψ the energy, p the pressure and n the normal of a side in the plane,
`∫ p x dA = -R ∮ ψ n ds` and `∫ p x xᵀ dA = R ∫ ψ dA - R ∮ ψ x nᵀ ds`, where only sides within the disc count, as ψ is 0
at its edge; and outwards from the foot `∫ p r dr = R (ψ(foot) - ψ(side))`.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import Any

import numpy as np

from cotouch.arrays import Float
from cotouch.mechanics._angle import angles
from cotouch.mechanics._contact_law import press
from cotouch.mechanics._kernel import inner, part
from cotouch.mechanics._vector import FOUR, four, lane, load, lower, root, splat, total, upper, where


def _gauss(points: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Places and weights of Gauss's rule on [0, 1]."""
    place, weight = np.polynomial.legendre.leggauss(points)
    return tuple((0.5 + 0.5 * place).tolist()), tuple((0.5 * weight).tolist())


# From the foot outwards to a side: squares of the places, and elements of the area.
_OUT, _OUT_WEIGHT = _gauss(6)
_OUT_SQUARE = tuple(r * r for r in _OUT)
_OUT_AREA = tuple(w * r for r, w in zip(_OUT, _OUT_WEIGHT, strict=True))
# Along a side, and from the foot outwards to the edge of the disc: rows of places and of weights, four points at once.
_SIDE = np.array(_gauss(4))
_DISC = np.array(_gauss(8)).reshape(4, 4)
# Where only forces are asked for, two points between foot and side, and energy and its slope there, do as well up to
# this depth, of the radius: exactly for polynomials up to the seventh degree.
_SHALLOW, _BETWEEN = 0.25, 0.5 / math.sqrt(7.0)
# A side's point that is so near to the foot presses as the foot does; of the disc, in squares of distances.
_NEAR = 1e-8
# A triangle whose sine at a corner is smaller than the root of this is a line.
_FLAT = 1e-24


@part
def press_triangle(
    law: Any, stiffness: float, radius: float, area: float, forces: bool, energies: bool, spot: Float, out: Float
) -> float:
    """Adds what one ball does on one triangle.

    Args:
        law: of the contact.
        stiffness: of the tool [N/m].
        radius: of the ball [m].
        area: of the triangle at rest; what it holds does not grow as it is stretched [m²].
        forces: whether to add more than the energy.
        energies: whether the energy is that of the state, rather than what suffices for forces.
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
    x, y = four(x0, x1, x2, x0), four(y0, y1, y2, y0)
    dx, dy = four(x1 - x0, x2 - x1, x0 - x2, 1.0), four(y1 - y0, y2 - y1, y0 - y2, 0.0)
    first, last = _chords(x, y, dx, dy, disc)
    inside = x0 * y1 - y0 * x1 > 0.0 and x1 * y2 - y1 * x2 > 0.0 and x2 * y0 - y2 * x0 > 0.0
    within = last - first
    if not (inside or lane(within, 0) > 0.0 or lane(within, 1) > 0.0 or lane(within, 2) > 0.0):
        return 0.0
    sweep = _beyond(x, y, dx, dy, first, last)
    turned = lane(sweep, 0) + lane(sweep, 1) + lane(sweep, 2)
    edge, deeper = math.sqrt(disc), 1.0 / (2.0 * radius)
    top, zero = disc * deeper, splat(0.0, FOUR)
    ue = zero
    for k in range(2):
        r = edge * load(_DISC, k, FOUR)
        energy, _, _ = press(law, stiffness, radius, upper(top - deeper * (r * r), zero))
        ue = ue + (turned * edge) * (load(_DISC, 2 + k, FOUR) * (r * energy))
    covered, scale = 0.5 * turned * disc, area / (0.5 * size)
    # Over four points of a side at once: pressure and slopes; what comes of the energy, and of the pressure, on sides.
    uc, us, upx, upy, uxx, uxy, uyy, uhx, uhy = zero, zero, zero, zero, zero, zero, zero, zero, zero
    # From the foot to the edge of the disc.
    shares = four(top, (0.5 + _BETWEEN) * top, (0.5 - _BETWEEN) * top, 0.0)
    deepest, hardest, firmest = press(law, stiffness, radius, shares)
    foot, hard, firm = lane(deepest, 0), lane(hardest, 0), lane(firmest, 0)
    sums = energies or not forces or top > _SHALLOW * radius
    for side in range(3):
        begin, share = lane(first, side), lane(within, side)
        if not share > 0.0:
            continue
        fx, fy, tx, ty = lane(x, side), lane(y, side), lane(dx, side), lane(dy, side)
        place = begin + share * load(_SIDE, 0, FOUR)
        ex, ey = fx + place * tx, fy + place * ty
        square = deeper * (ex * ex + ey * ey)
        cross = (fx * ty - fy * tx) * share
        covered += 0.5 * cross
        weight, e0 = load(_SIDE, 1, FOUR), zero
        if sums:
            for b in range(6):
                energy, _, _ = press(law, stiffness, radius, upper(top - _OUT_SQUARE[b] * square, zero))
                e0 = e0 + _OUT_AREA[b] * energy
        if not forces:
            ue = ue + (cross * weight) * e0
            continue
        energy, pressure, slope = press(law, stiffness, radius, upper(top - square, zero))
        near, _, firmer = press(law, stiffness, radius, upper(top - (0.5 - _BETWEEN) * square, zero))
        far, _, softer = press(law, stiffness, radius, upper(top - (0.5 + _BETWEEN) * square, zero))
        if not sums:
            e0 = (49.0 / 270.0) * (near + far) + (37.0 / 540.0) * (foot + energy)
            e0 = e0 - (1.0 / 360.0) * (square * (hard - pressure))
        ue = ue + (cross * weight) * e0
        away = square - _NEAR * top
        uc = uc + (cross * weight) * where(away, (foot - energy) / where(away, square, 1.0), hard)
        us = us + (cross * weight) * ((1.0 / 9.0) * (firm + slope) + (7.0 / 18.0) * (firmer + softer))
        for k in range(2):
            place = begin + share * load(_DISC, k, FOUR)
            ex, ey = fx + place * tx, fy + place * ty
            energy, pressure, _ = press(law, stiffness, radius, upper(top - deeper * (ex * ex + ey * ey), zero))
            weight = share * load(_DISC, 2 + k, FOUR)
            energy, pressure = weight * energy, weight * pressure
            upx, upy = upx - ty * energy, upy + tx * energy
            uxx, uyy = uxx - ty * (ex * energy), uyy + tx * (ey * energy)
            uxy = uxy + (tx * ex - ty * ey) * energy
            uhx, uhy = uhx - ty * pressure, uhy + tx * pressure
    se = total(ue)
    out[3, 3] += scale * se
    if not forces:
        return scale * covered
    # Sums over the plane: pressure and slopes; pressure times x, y, xx, xy, yy, of the radius; slopes times x, y.
    sc = turned * radius * foot + 0.5 * total(uc)
    ss = (1.0 / 9.0) * (firm + lane(firmest, 3)) + (7.0 / 18.0) * (lane(firmest, 1) + lane(firmest, 2))
    ss = 0.5 * (turned * disc * ss + total(us))
    sx, sy, sxx, sxy, syy = total(upx), total(upy), se + total(uxx), 0.5 * total(uxy), se + total(uyy)
    hx, hy = radius * total(uhx), radius * total(uhy)
    own, per = 1.0 / size, scale / radius
    for corner in range(3):
        bx, by = (x1, y1) if corner == 0 else (x2, y2) if corner == 1 else (x0, y0)
        cx, cy = (x2, y2) if corner == 0 else (x0, y0) if corner == 1 else (x1, y1)
        # Share of the corner in a point of the plane.
        l0, lx, ly = (bx * cy - by * cx) * own, (by - cy) * own, (cx - bx) * own
        borne = l0 * sc + radius * (lx * sx + ly * sy)
        along = (l0 * sx + lx * sxx + ly * sxy) * scale
        beside = (l0 * sy + lx * sxy + ly * syy) * scale
        down = -height * borne * per
        out[corner, 0] += along * ux + beside * wx + down * mx
        out[corner, 1] += along * uy + beside * wy + down * my
        out[corner, 2] += along * uz + beside * wz + down * mz
        out[corner, 3] += scale * borne
        out[3, corner] += scale * max(l0 * ss + lx * hx + ly * hy, 0.0)
    return scale * covered


@inner
def _chords(x: float, y: float, dx: float, dy: float, disc: float) -> tuple[float, float]:
    """Between which shares of each side it lies in a disc about the origin; the second is not larger: nowhere."""
    zero, one = splat(0.0, FOUR), splat(1.0, FOUR)
    square, along, under = dx * dx + dy * dy, x * dx + y * dy, disc - (x * x + y * y)
    seen = along * along + square * under
    far = root(upper(seen, zero))
    # Each root by the form that does not cancel.
    q = where(along, along + far, along - far)
    a, b = (0.0 - q) / square, under / q
    first, last = upper(where(along, a, b), zero), lower(where(along, b, a), one)
    return where(seen, first, one), where(seen, last, zero)


@inner
def _beyond(x: float, y: float, dx: float, dy: float, first: float, last: float) -> float:
    """Angles that the parts of each side outside of the disc are seen under from the foot.

    Of a side less that of its part within the disc: both have one sign, and the difference is less than half a turn.
    """
    share, cross = upper(last - first, splat(0.0, FOUR)), x * dy - y * dx
    whole = x * (x + dx) + y * (y + dy)
    gx, gy, kx, ky = x + first * dx, y + first * dy, x + last * dx, y + last * dy
    inner_part = where(share, gx * kx + gy * ky, 1.0)
    return angles(whole * inner_part + (share * cross) * cross, cross * (inner_part - share * whole))
