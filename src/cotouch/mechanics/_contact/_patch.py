"""Energy and forces of a ball on a triangle, exactly: the integral of a contact law over what lies in the ball.

The triangle's plane cuts the ball in a disc about the foot of its middle. A triangle is the signed sum of three
triangles from the foot to its sides; of each, a part lies in the disc, and the rest is a sector of it. So the sum over
a flat is the same however it is cut into triangles, and no triangle is too large: nothing depends on where points lie.

Depth falls with the square of the distance to the foot, so sums outwards from there are differences of sums over depth:
with ψ the energy and Φ(w) its integral from 0 to w, `∫ ψ r dr = R (Φ(foot) - Φ(side))`, and of a sector `R Φ(foot)`.
Where the foot lies beside the triangle, what it holds drops out between sectors and sides.

Pressure p is the slope of the energy, so `∫ p r dr = R (ψ(foot) - ψ(side))`, and its moments need no sums over the area
[divergence theorem]: with n the normal of a side in the plane, `∫ p x dA = -R ∮ ψ n ds` and
`∫ p x xᵀ dA = R ∫ ψ dA - R ∮ ψ x nᵀ ds`, where only sides within the disc count, as ψ is 0 at its edge.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import Any

import numpy as np

from cotouch.arrays import Float
from cotouch.kernels import (
    FOUR,
    angles,
    at,
    inner,
    lane,
    load,
    lower,
    part,
    root,
    size,
    splat,
    store,
    total,
    upper,
    where,
)
from cotouch.kernels.matrix3 import Vector, cross
from cotouch.mechanics._contact_laws._law import press


def _gauss(points: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Places and weights of Gauss's rule on [0, 1]."""
    place, weight = np.polynomial.legendre.leggauss(points)
    return tuple((0.5 + 0.5 * place).tolist()), tuple((0.5 * weight).tolist())


# From the foot to the edge of a disc whose radius is 1: Gauss's rule for what is multiplied by the distance, exact up
# to its ninth power [Abramowitz & Stegun 1964, table 25.8]; shares of the depth at the foot, and their weights.
_OUT = (0.0985350857988264, 0.3045357266463638, 0.5620251897526138, 0.8019865821263918, 0.9601901429485313)
_OUT_WEIGHT = (0.0157479145216922, 0.0739088700726166, 0.1463869870846698, 0.1671746380943696, 0.0967815902266518)
_DEPTH, _DEPTH_WEIGHT = tuple(1.0 - r * r for r in _OUT), tuple(2.0 * w for w in _OUT_WEIGHT)
# Up to the first of these depths, of the radius, a third and two thirds of a depth and what the law says at its ends do
# better: exactly for energies up to the ninth power. Until the second, one rule gives way to the other, for the energy
# must not step. For forces alone, which hardly depend on that, half of a depth will do.
_LEAST, _MOST = 0.2, 0.25
# Shares of the depth at the foot, four at once: for the energy of the state, and for forces alone.
_FOOT = np.array([(1.0, 1.0 / 3.0, 2.0 / 3.0, 0.0), (1.0, 0.5, 0.0, 0.0)])
# Along a side: rows of places and of weights, four points at once.
_SIDE = np.array(_gauss(8)).reshape(4, 4)
# A side's point that is so near to the foot presses as the foot does; of the disc, in squares of distances.
_NEAR = 1e-8
# A triangle whose sine at a corner is smaller than the root of this is a line.
_FLAT = 1e-24
# An angle so small may be a whole turn that was rounded.
_ROUNDED = 1e-9
# Rows of what `overlap` finds: whether they overlap; twice the area; height and square of the disc's radius; angle
# beyond the sides. Then three for each: corners in the plane, from the foot; where each side's part in the disc begins,
# and how much of it there is; unit vectors of the plane's first axis and of the normal.
MEETS, _SIZE, _HEIGHT, _CUT, _TURNED = range(5)
_X, _Y, _FIRST, _WITHIN, _AXIS, _NORMAL = range(5, 23, 3)
FOUND = 23


@part
def overlap(a: Vector, b: Vector, c: Vector, square: float, found: Float) -> bool:
    """Where four triangles, each a lane, lie in balls about the origin.

    All that leads there is worked out for four at once: roots and quotients that wait for each other took three
    quarters of the time when each triangle had its own.

    Args:
        a: first corner of each, from the ball's middle [m].
        b: second ones.
        c: third ones.
        square: of the balls' radii [m²].
        found: result, (FOUND, 4), all of it only if any overlap.

    Returns:
        Whether any do.
    """
    zero = splat(0.0, FOUR)
    gap = zero
    for q in range(3):
        near = upper(upper(lower(lower(a[q], b[q]), c[q]), zero - upper(upper(a[q], b[q]), c[q])), zero)
        gap = gap + near * near
    if not _any(square - gap):
        return False
    u, v = _apart(b, a), _apart(c, a)
    m = cross(u, v)
    wide, long = _dot(m, m), _dot(u, u)
    real = wide - _FLAT * long * _dot(v, v)
    wide, length = root(where(real, wide, 1.0)), root(where(real, long, 1.0))
    every = 1.0 / (wide * length)
    m, u = _scaled(every * length, m), _scaled(every * wide, u)
    w = cross(m, u)
    height = zero - _dot(a, m)
    disc = square - height * height
    x0, y0 = _dot(a, u), _dot(a, w)
    x1, x2, y2 = x0 + length, x0 + _dot(v, u), y0 + _dot(v, w)
    store(found, _X, x0, FOUR)
    store(found, _X + 1, x1, FOUR)
    store(found, _X + 2, x2, FOUR)
    store(found, _Y, y0, FOUR)
    store(found, _Y + 1, y0, FOUR)
    store(found, _Y + 2, y2, FOUR)
    inside = lower(lower(x0 * y0 - y0 * x1, x1 * y2 - y0 * x2), x2 * y0 - y2 * x0)
    p, q, r = (
        _cuts(x0, y0, x1 - x0, zero, disc),
        _cuts(x1, y0, x2 - x1, y2 - y0, disc),
        _cuts(x2, y2, x0 - x2, y0 - y2, disc),
    )
    every = 1.0 / (p[0] * q[0] * r[0])  # one quotient for all
    within = _chord(p, every * q[0] * r[0], found, 0)
    within = upper(within, _chord(q, every * p[0] * r[0], found, 1))
    within = upper(within, _chord(r, every * p[0] * q[0], found, 2))
    meets = lower(lower(upper(inside, within), real), disc)
    store(found, MEETS, meets, FOUR)
    if not _any(meets):
        return False
    # The angle of a product is the sum of the angles. It is at least 0, and a whole turn at most; which of these two it
    # is where rounding does not tell, sides do.
    gx, gy = splat(1.0, FOUR), zero
    for side in range(3):
        x, y, dx, dy = _side(found, side)
        kx, ky = _beyond(x, y, dx, dy, load(found, _FIRST + side, FOUR), load(found, _WITHIN + side, FOUR))
        gx, gy = gx * kx - gy * ky, gx * ky + gy * kx
    turned = angles(gx, gy)
    whole = where(lower(inside, 0.5 - within), _ROUNDED - turned, zero - _ROUNDED - turned)
    turned = where(whole, 2.0 * math.pi + turned, upper(turned, zero))
    store(found, _SIZE, wide, FOUR)
    store(found, _HEIGHT, height, FOUR)
    store(found, _CUT, disc, FOUR)
    store(found, _TURNED, turned, FOUR)
    for q in range(3):
        store(found, _AXIS + q, u[q], FOUR)
        store(found, _NORMAL + q, m[q], FOUR)
    return True


@part
def overlap_one(spot: Float, square: float, found: Float) -> bool:
    """`overlap` of one triangle with four balls about one middle.

    Args:
        spot: its corners and the middle of the balls, (4, 4) [m].
        square: of the balls' radii [m²].
        found: result, (FOUND, 4).
    """
    return overlap(_everywhere(spot, 0), _everywhere(spot, 1), _everywhere(spot, 2), square, found)


@inner
def _everywhere(spot: Float, q: int) -> Vector:
    x, y, z = spot[q, 0] - spot[3, 0], spot[q, 1] - spot[3, 1], spot[q, 2] - spot[3, 2]
    return splat(x, FOUR), splat(y, FOUR), splat(z, FOUR)


@inner
def _any(values: float) -> bool:
    """Whether any of four numbers is above 0."""
    return lane(values, 0) > 0.0 or lane(values, 1) > 0.0 or lane(values, 2) > 0.0 or lane(values, 3) > 0.0


@inner
def _apart(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@inner
def _dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@inner
def _scaled(p: float, a: Vector) -> Vector:
    return p * a[0], p * a[1], p * a[2]


@inner
def _side(found: Float, side: int) -> tuple[float, float, float, float]:
    """Where a side begins in the plane of each triangle, and how far it goes."""
    after = side + 1 if side < 2 else 0
    x, y = load(found, _X + side, FOUR), load(found, _Y + side, FOUR)
    return x, y, load(found, _X + after, FOUR) - x, load(found, _Y + after, FOUR) - y


@part
def press_triangle(
    law: Any,
    stiffness: float,
    radius: float,
    area: float,
    forces: bool,
    energies: bool,
    found: Float,
    n: int,
    out: Float,
) -> float:
    """What one ball does on one triangle that it overlaps.

    Args:
        law: of the contact.
        stiffness: of the tool [N/m].
        radius: of the ball [m].
        area: of the triangle at rest; what it holds does not grow as it is stretched [m²].
        forces: whether to add more than the energy.
        energies: whether the energy is that of the state, rather than what suffices for forces.
        found: by `overlap`.
        n: the triangle's lane there.
        out: result: rows 0 to 2: force on each corner [N], and its share of the pressure's sum [N]; row 3: the sum of
            the slopes for each corner [N/m], and the energy [J]; (4, 4). Without forces only the last.

    Returns:
        How much of the area at rest lies in the ball [m²].
    """
    double, height, disc, turned = (
        at(found, (_SIZE, n)),
        at(found, (_HEIGHT, n)),
        at(found, (_CUT, n)),
        at(found, (_TURNED, n)),
    )
    deeper = 1.0 / (2.0 * radius)
    top, zero = disc * deeper, splat(0.0, FOUR)
    covered, scale = 0.5 * turned * disc, area / (0.5 * double)
    # Over four points of a side at once: energy, pressure, slopes; what comes of the energy and of the pressure there.
    ue, uc, us, upx, upy, uxx, uxy, uyy, uhx, uhy = zero, zero, zero, zero, zero, zero, zero, zero, zero, zero
    # How much of the energy is summed by the rule for what is deep, and whether it is that of the state.
    deep = min(max((top / radius - _LEAST) / (_MOST - _LEAST), 0.0), 1.0)
    state = energies or not forces
    if not state and deep > 0.0:
        deep = 1.0
    energy, pressure, slope = press(law, stiffness, radius, top * load(_FOOT, 0 if state else 1, FOUR))
    foot, hard, firm, soft = lane(energy, 0), lane(pressure, 0), lane(slope, 0), lane(slope, 3)
    if state:
        whole = _closely(top, lane(energy, 1) + lane(energy, 2), foot, hard, firm + soft)
    else:
        whole = _nearly(top, lane(energy, 1), foot, hard, firm + soft)
    if deep > 0.0:
        whole += deep * (_up_to(law, stiffness, radius, top) - whole)
    for side in range(3):
        begin, share = at(found, (_FIRST + side, n)), at(found, (_WITHIN + side, n))
        if not share > 0.0:
            continue
        after = side + 1 if side < 2 else 0
        fx, fy = at(found, (_X + side, n)), at(found, (_Y + side, n))
        tx, ty = at(found, (_X + after, n)) - fx, at(found, (_Y + after, n)) - fy
        cross = (fx * ty - fy * tx) * share
        covered += 0.5 * cross
        for k in range(2):
            place, weight = begin + share * load(_SIDE, k, FOUR), load(_SIDE, 2 + k, FOUR)
            ex, ey = fx + place * tx, fy + place * ty
            square = deeper * (ex * ex + ey * ey)
            depth, away = upper(top - square, zero), square - _NEAR * top
            at_foot = cross * weight
            every = at_foot * (1.0 / where(away, square, 1.0))
            energy, pressure, slope = press(law, stiffness, radius, depth)
            less = zero
            if deep < 1.0 and state:
                third, _, _ = press(law, stiffness, radius, (1.0 / 3.0) * depth)
                other, _, _ = press(law, stiffness, radius, (2.0 / 3.0) * depth)
                less = _closely(depth, third + other, energy, pressure, slope + soft)
            elif deep < 1.0:
                half, _, _ = press(law, stiffness, radius, 0.5 * depth)
                less = _nearly(depth, half, energy, pressure, slope + soft)
            if deep > 0.0:
                less = less + deep * (_up_to(law, stiffness, radius, depth) - less)
            ue = ue + where(away, every * (whole - less), at_foot * foot)
            if not forces:
                continue
            uc = uc + where(away, every * (foot - energy), at_foot * hard)
            us = us + where(away, every * (hard - pressure), at_foot * firm)
            energy, pressure = (share * weight) * energy, (share * weight) * pressure
            upx, upy = upx - ty * energy, upy + tx * energy
            uxx, uyy = uxx - ty * (ex * energy), uyy + tx * (ey * energy)
            uxy = uxy + (tx * ex - ty * ey) * energy
            uhx, uhy = uhx - ty * pressure, uhy + tx * pressure
    se = turned * radius * whole + 0.5 * total(ue)
    out[3, 3] = scale * se
    if not forces:
        return scale * covered
    # Sums over the plane: pressure and slopes; pressure times x, y, xx, xy, yy, of the radius; slopes times x, y.
    sc = turned * radius * foot + 0.5 * total(uc)
    ss = turned * radius * hard + 0.5 * total(us)
    sx, sy, sxx, sxy, syy = total(upx), total(upy), se + total(uxx), 0.5 * total(uxy), se + total(uyy)
    hx, hy = radius * total(uhx), radius * total(uhy)
    own, per = 1.0 / double, scale / radius
    ux, uy, uz = at(found, (_AXIS, n)), at(found, (_AXIS + 1, n)), at(found, (_AXIS + 2, n))
    mx, my, mz = at(found, (_NORMAL, n)), at(found, (_NORMAL + 1, n)), at(found, (_NORMAL + 2, n))
    wx, wy, wz = my * uz - mz * uy, mz * ux - mx * uz, mx * uy - my * ux
    x0, x1, x2 = at(found, (_X, n)), at(found, (_X + 1, n)), at(found, (_X + 2, n))
    y0, y1, y2 = at(found, (_Y, n)), at(found, (_Y + 1, n)), at(found, (_Y + 2, n))
    for corner in range(3):
        bx, by = (x1, y1) if corner == 0 else (x2, y2) if corner == 1 else (x0, y0)
        cx, cy = (x2, y2) if corner == 0 else (x0, y0) if corner == 1 else (x1, y1)
        # Share of the corner in a point of the plane.
        l0, lx, ly = (bx * cy - by * cx) * own, (by - cy) * own, (cx - bx) * own
        borne = l0 * sc + radius * (lx * sx + ly * sy)
        along = (l0 * sx + lx * sxx + ly * sxy) * scale
        beside = (l0 * sy + lx * sxy + ly * syy) * scale
        down = -height * borne * per
        out[corner, 0] = along * ux + beside * wx + down * mx
        out[corner, 1] = along * uy + beside * wy + down * my
        out[corner, 2] = along * uz + beside * wz + down * mz
        out[corner, 3] = scale * borne
        out[3, corner] = scale * max(l0 * ss + lx * hx + ly * hy, 0.0)
    return scale * covered


@inner
def _up_to(law: Any, stiffness: float, radius: float, depth: float) -> float:
    """Integral of the energy over all depths up to one [J/m]."""
    energy, _, _ = press(law, stiffness, radius, _DEPTH[0] * depth)
    result = _DEPTH_WEIGHT[0] * energy
    for b in range(1, 5):
        energy, _, _ = press(law, stiffness, radius, _DEPTH[b] * depth)
        result = result + _DEPTH_WEIGHT[b] * energy
    return depth * result


@inner
def _closely(depth: float, between: float, energy: float, pressure: float, slopes: float) -> float:
    """`_up_to` where that is not deep.

    Args:
        depth: see `_up_to` [m].
        between: sum of the energies at a third and at two thirds of it [J/m²].
        energy: there [J/m²].
        pressure: likewise [Pa].
        slopes: the slope there and that at no depth [Pa/m].
    """
    ends = depth * ((13.0 / 1120.0) * pressure - (1.0 / 3360.0) * (depth * slopes))
    return depth * ((729.0 / 2240.0) * between + (391.0 / 2240.0) * energy - ends)


@inner
def _nearly(depth: float, half: float, energy: float, pressure: float, slopes: float) -> float:
    """The same by the energy at half of a depth [J/m²] alone; see `_closely`."""
    ends = depth * ((1.0 / 35.0) * pressure - (1.0 / 840.0) * (depth * slopes))
    return depth * ((16.0 / 35.0) * half + (19.0 / 70.0) * energy - ends)


@inner
def _cuts(x: float, y: float, dx: float, dy: float, disc: float) -> tuple[float, float, float, float]:
    """At which shares of a side its line cuts a disc about the origin, as quotients.

    Returns:
        What to divide by; for the one and the other share; whether the one is the smaller. Where the line misses the
        disc, the smaller is 1 and the other 0.
    """
    zero = splat(0.0, FOUR)
    square, along, under = dx * dx + dy * dy, x * dx + y * dy, disc - (x * x + y * y)
    seen = along * along + square * under
    far = root(upper(seen, zero))
    # Each root by the form that does not cancel.
    q = where(seen, where(along, along + far, along - far), 1.0)
    by = square * q
    return by, where(seen, zero - q * q, by), where(seen, under * square, 0.0), where(seen, along, 1.0)


@inner
def _chord(cuts: tuple[float, float, float, float], every: float, found: Float, side: int) -> float:
    """Keeps which part of a side lies in the disc; returns how much of it, not above 0: nothing."""
    a, b = every * cuts[1], every * cuts[2]
    first = upper(where(cuts[3], a, b), splat(0.0, FOUR))
    within = lower(where(cuts[3], b, a), splat(1.0, FOUR)) - first
    store(found, _FIRST + side, first, FOUR)
    store(found, _WITHIN + side, within, FOUR)
    return within


@inner
def _beyond(x: float, y: float, dx: float, dy: float, first: float, within: float) -> tuple[float, float]:
    """A vector of the angle that the parts of a side outside of the disc are seen under from the foot.

    Of the side less that of its part within the disc: both have one sign, and the difference is less than half a turn.
    """
    one = splat(1.0, FOUR)
    share, beside, last = upper(within, splat(0.0, FOUR)), x * dy - y * dx, first + within
    whole = x * (x + dx) + y * (y + dy)
    gx, gy, kx, ky = x + first * dx, y + first * dy, x + last * dx, y + last * dy
    inner_part = where(share, gx * kx + gy * ky, one)
    along, across = whole * inner_part + (share * beside) * beside, beside * (inner_part - share * whole)
    return where(size(along) + size(across), along, one), across
