"""How a direction turns a body as a whole, so that the torque of the forces where it leads arrives.

The constant matrix resists rotation, which the true forces within a body do not: what it leaves of a turn would be a
torque that nothing exerts, and one that has the same sign in step after step of a body that spins.
"""

from cotouch.arrays import Float
from cotouch.kernels import at, inner, part, put
from cotouch.kernels.matrix3 import cofactor, contraction, cross, times
from cotouch.mechanics._closed._direction_missing import couples, outer
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import Workspace

# Less than this of what a ball would resist, about some axis: a line of nodes, which nothing turns about itself.
_LINE = 1e-9


@part
def turn_whole(op: Operator, places: Float, T: float, solved: bool, work: Workspace) -> float:
    """Turns the body as a whole, as the angular momentum asks that is still missing; translations are done before.

    Args:
        op: the body.
        places: of its rows at rest, (rows, 4) [m].
        T: length of the step [s].
        solved: whether the correction in `mean` was solved for: then that is turned by what the solve left. Otherwise
            v̂, in `pull`, and the right-hand side gets what is left to solve.
        work: scratch; `ahead` is where v̂ led.

    Returns:
        Square of what this changed of v̂, in the norm of M.
    """
    if couples(op):
        return 0.0
    mass, fx, fy, fz, sx, sy, sz, tx, ty, tz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    xx, yy, zz, xy, xz, yz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(op.mass.shape[0]):
        m = outer(op, T, i, work)
        x, y, z = _middle(places, work, T, i)
        rx, ry, rz = at(work.rhs, (i, 0)), at(work.rhs, (i, 1)), at(work.rhs, (i, 2))
        if solved:
            rx, ry, rz = rx - m * at(work.mean, (i, 0)), ry - m * at(work.mean, (i, 1)), rz - m * at(work.mean, (i, 2))
        mass, fx, fy, fz = mass + m, fx + rx, fy + ry, fz + rz
        sx, sy, sz = sx + m * x, sy + m * y, sz + m * z
        tx, ty, tz = tx + y * rz - z * ry, ty + z * rx - x * rz, tz + x * ry - y * rx
        xx, yy, zz = xx + m * x * x, yy + m * y * y, zz + m * z * z
        xy, xz, yz = xy + m * x * y, xz + m * x * z, yz + m * y * z
    cx, cy, cz = sx / mass, sy / mass, sz / mass
    xx, yy, zz = xx - sx * cx, yy - sy * cy, zz - sz * cz
    xy, xz, yz = xy - sx * cy, xz - sx * cz, yz - sy * cz
    inertia = (yy + zz, -xy, -xz, -xy, xx + zz, -yz, -xz, -yz, xx + yy)
    inverse = cofactor(inertia)
    size, third = contraction(inertia, inverse) / 3.0, (xx + yy + zz) / 1.5
    if not size > _LINE * third * third * third:
        return 0.0
    gx, gy, gz = cross((cx, cy, cz), (fx, fy, fz))
    wx, wy, wz = times(inverse, ((tx - gx) / size, (ty - gy) / size, (tz - gz) / size))
    change = 0.0
    for i in range(op.mass.shape[0]):
        x, y, z = _middle(places, work, T, i)
        goes = cross((wx, wy, wz), (x - cx, y - cy, z - cz))
        m = outer(op, T, i, work)
        for a in range(3):
            rate = goes[0] if a == 0 else goes[1] if a == 1 else goes[2]
            change += at(op.mass, i) * rate * rate
            if solved:
                put(work.mean, (i, a), at(work.mean, (i, a)) + rate)
            else:
                put(work.rhs, (i, a), at(work.rhs, (i, a)) - m * rate)
                put(work.pull, (i, a), at(work.pull, (i, a)) + rate)
    return change


@inner
def _middle(places: Float, work: Workspace, T: float, i: int) -> tuple[float, float, float]:
    """Where a row is in the middle of the step."""
    half = 0.5 * T
    return (
        at(places, (i, 0)) + at(work.ahead, (i, 0)) - half * at(work.pull, (i, 0)),
        at(places, (i, 1)) + at(work.ahead, (i, 1)) - half * at(work.pull, (i, 1)),
        at(places, (i, 2)) + at(work.ahead, (i, 2)) - half * at(work.pull, (i, 2)),
    )
