"""What a point of a skin feels that lies in a foundation of springs: pressure, damping, and friction.

All of it is a function of where the point was and where it is beside what it lies in. Pressure is the discrete gradient
of its energy, so it does just the work by which that changes; friction is a spring along the face whose stretch is
remembered, and what is beyond the cone slips [return mapping, Simo & Hughes 1998]. Both lose at least 0 for any motion.
"""

import math

from cotouch.kernels import inner

# Force on the point, energy held, energy lost, what resists motion of a row that is solved for by one number, stretch
# at the end, how far it has slipped; what resists motion along the normal, and across it; and the force of friction for
# each unit of pressure where it slips.
Pressed = tuple[
    float, float, float, float, float, float, float, float, float, float, float, float, float, float, float
]  # fmt: skip
# A matrix of the axes, row by row.
Resists = tuple[float, float, float, float, float, float, float, float, float]


@inner
def untouched(lost: float) -> Pressed:
    """What a point feels that is in nothing, neither before nor after."""
    return 0.0, 0.0, 0.0, 0.0, lost, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0


@inner
def stretched(k: float, sx: float, sy: float, sz: float) -> float:
    """Energy in friction [J]. Half as stiff along a face as across it: within a step, both then resist alike.

    Args:
        k: stiffness across the face [N/m].
        sx: stretch along x [m].
        sy: likewise.
        sz: likewise.
    """
    return 0.25 * k * (sx * sx + sy * sy + sz * sz)


@inner
def pressed(
    k: float,
    loss: float,
    friction: float,
    kinetic: float,
    before: float,
    after: float,
    nx: float,
    ny: float,
    nz: float,
    gx: float,
    gy: float,
    gz: float,
    mx: float,
    my: float,
    mz: float,
    sx: float,
    sy: float,
    sz: float,
    was: float,
    deepest: float,
    T: float,
) -> Pressed:
    """One point that is in something before or after a step.

    Args:
        k: of its foundation [N/m].
        loss: λ: pressure grows by 1 + λ times the speed of approach [s/m].
        friction: Coulomb's coefficient of what holds, and of what has slipped less than the deepest point may be
            stretched: until that slips as well, what was pressed less slips without sliding.
        kinetic: and of what has slipped that far.
        before: depth where the step begins, less than 0 outside [m].
        after: and where it ends; one of them is above 0.
        nx: the normal.
        ny: likewise.
        nz: likewise.
        gx: direction of the pressure, along which m goes out by `before - after`.
        gy: likewise.
        gz: likewise.
        mx: how far the point moves [m].
        my: likewise.
        mz: likewise.
        sx: stretch of friction where the step begins [m].
        sy: likewise.
        sz: likewise.
        was: which share of that way it has slipped, up to 1; the farther it is within its cone, the sooner none.
        deepest: depth of the deepest point where the step begins [m].
        T: length of the step [s].
    """
    grip, held = 0.5 * k, stretched(k, sx, sy, sz)
    deeper = after - before
    # Mean pressure: the difference of ½ k depth² over that of depth.
    if before > 0.0 and after > 0.0:
        push, slope = 0.5 * k * (before + after), 0.5 * k
    elif after > 0.0:
        part_in = after / deeper
        push, slope = 0.5 * k * after * part_in, 0.5 * k * part_in * (2.0 - part_in)
    else:
        part_in = before / deeper
        push, slope = -0.5 * k * before * part_in, 0.5 * k * part_in * part_in
    change = max(loss * deeper / T, -1.0)
    stored, lost = 0.0, push * change * deeper
    if after > 0.0:
        stored = 0.5 * k * after * after
    total = push * (1.0 + change)
    fx, fy, fz = total * gx, total * gy, total * gz
    firm = (0.5 * k * T if after > 0.0 else 0.0) + push * loss
    along = slope * (1.0 + change) * T + (push * loss if change > -1.0 else 0.0)
    if friction <= 0.0:
        return fx, fy, fz, stored, lost, firm, 0.0, 0.0, 0.0, 0.0, along, 0.0, 0.0, 0.0, 0.0
    across = sx * nx + sy * ny + sz * nz
    sx, sy, sz = sx - across * nx, sy - across * ny, sz - across * nz
    lost += max(held - stretched(k, sx, sy, sz), 0.0)
    up = mx * nx + my * ny + mz * nz
    tx, ty, tz = sx + mx - up * nx, sy + my - up * ny, sz + mz - up * nz
    trial = math.sqrt(tx * tx + ty * ty + tz * tz)
    coefficient, way = kinetic if was >= 1.0 else friction, friction * k * deepest / grip
    cone, share = coefficient * total / grip, 1.0
    slips = min(max(was + (trial - cone) / way, 0.0), 1.0) if way > 0.0 else 0.0
    cx = cy = cz = 0.0
    if trial > cone:
        share = coefficient * total / (grip * trial)
        cx, cy, cz = -coefficient / trial * tx, -coefficient / trial * ty, -coefficient / trial * tz
    ex, ey, ez = share * tx, share * ty, share * tz
    stored += stretched(k, ex, ey, ez)
    lost += grip * (ex * (tx - ex) + ey * (ty - ey) + ez * (tz - ez))
    lost += stretched(k, ex - sx, ey - sy, ez - sz)
    across = share * grip * T
    firm = max(firm, across)
    # A dashpot beside what holds, as far as the cone has room.
    slide = math.sqrt(max((mx - up * nx) ** 2 + (my - up * ny) ** 2 + (mz - up * nz) ** 2, 0.0))
    drag = min(0.5 * push * loss * slide / T, max(cone - math.sqrt(ex * ex + ey * ey + ez * ez), 0.0) * grip)
    if trial <= cone and drag > 0.0:
        across += drag * T / slide
        lost += drag * slide
        fx, fy, fz = (
            fx - drag * (mx - up * nx) / slide,
            fy - drag * (my - up * ny) / slide,
            fz - drag * (mz - up * nz) / slide,
        )
    fx, fy, fz = fx - grip * ex, fy - grip * ey, fz - grip * ez
    return fx, fy, fz, stored, lost, firm, ex, ey, ez, slips, along, across, cx, cy, cz


@inner
def resists(normal: tuple[float, float, float], found: Pressed) -> Resists:
    """What resists motion of a point, as the rows of a matrix [Ns/m].

    Args:
        normal: of what it is in.
        found: what it feels.
    """
    nx, ny, nz = normal
    along, across, cx, cy, cz = found[10], found[11], found[12], found[13], found[14]
    px = (along - across) * nx + along * cx
    py = (along - across) * ny + along * cy
    pz = (along - across) * nz + along * cz
    square = cx * cx + cy * cy + cz * cz
    turns = across / square if square > 0.0 else 0.0  # what slips is not held the way that it goes
    qx, qy, qz = turns * cx, turns * cy, turns * cz
    return (
        px * nx - qx * cx + across, px * ny - qx * cy, px * nz - qx * cz,
        py * nx - qy * cx, py * ny - qy * cy + across, py * nz - qy * cz,
        pz * nx - qz * cx, pz * ny - qz * cy, pz * nz - qz * cz + across,
    )  # fmt: skip
