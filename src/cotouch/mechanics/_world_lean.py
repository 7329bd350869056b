"""What resists motion at obstacles, as the linear system of a step has it."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.mechanics._kernel import inner, part
from cotouch.mechanics._state import Workspace
from cotouch.mechanics._vector import at, load, put, store
from cotouch.mechanics._world import World


@inner
def couple(world: World, p: int, nx: float, ny: float, nz: float, more: float, across: float) -> None:
    """Adds what resists motion of a point, `across I + more n nᵀ`, to the lower half of what couples the rows at it.

    Args:
        world: obstacles and points.
        p: the point.
        nx: the normal.
        ny: likewise.
        nz: likewise.
        more: along that [Ns/m].
        across: whichever way [Ns/m].
    """
    if world.couple.shape[0] > 0:
        xx, yy, zz = more * nx * nx + across, more * ny * ny + across, more * nz * nz + across
        yx, zx, zy = more * ny * nx, more * nz * nx, more * nz * ny
        for e in range(at(world.pointer, p), at(world.pointer, p + 1)):
            r, own = at(world.rigid, at(world.row, e)), at(world.share, e)
            for other in range(at(world.pointer, p), at(world.pointer, p + 1) if r >= 0 else 0):
                s = at(world.rigid, at(world.row, other))
                if s > r:
                    continue
                i, j, share = 3 * r, 3 * s, own * at(world.share, other)
                _add_couple(world, i, j, share * xx, share * yx, share * zx)
                _add_couple(world, i + 1, j, share * yx, share * yy, share * zy)
                _add_couple(world, i + 2, j, share * zx, share * zy, share * zz)


@inner
def _add_couple(world: World, i: int, j: int, a: float, b: float, c: float) -> None:
    put(world.couple, (i, j), at(world.couple, (i, j)) + a)
    put(world.couple, (i, j + 1), at(world.couple, (i, j + 1)) + b)
    put(world.couple, (i, j + 2), at(world.couple, (i, j + 2)) + c)


@inner
def mirror(world: World) -> None:
    """What couples rows, of which the lower half is known, is symmetric."""
    for i in range(world.couple.shape[0]):
        for j in range(i):
            put(world.couple, (j, i), at(world.couple, (i, j)))


@part
def lean_world(world: World | None, copy_scale: float, rate: Float, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Puts what resists at the touched rows into the linear system, about the rate at which forces were worked out."""
    if world is not None:
        rates = work.answer
        for q in range(world.couple.shape[0]):
            put(rates, q, at(rate, (at(work.among, q // 3), q % 3)))
        for i in range(world.hold.shape[0]):
            store(world.tried, i, load(rate, i, lanes), lanes)
            hold = copy_scale * at(world.hold, i)
            r = 3 * at(world.rigid, i)
            if r >= 0:
                fx = fy = fz = 0.0
                for q in range(world.couple.shape[0]):
                    value = at(rates, q)
                    hx, hy, hz = (
                        copy_scale * at(world.couple, (r, q)),
                        copy_scale * at(world.couple, (r + 1, q)),
                        copy_scale * at(world.couple, (r + 2, q)),
                    )
                    fx, fy, fz = fx + hx * value, fy + hy * value, fz + hz * value
                    put(work.dense, (r, q), at(work.dense, (r, q)) + hx)
                    put(work.dense, (r + 1, q), at(work.dense, (r + 1, q)) + hy)
                    put(work.dense, (r + 2, q), at(work.dense, (r + 2, q)) + hz)
                put(work.rhs, (i, 0), at(work.rhs, (i, 0)) + fx)
                put(work.rhs, (i, 1), at(work.rhs, (i, 1)) + fy)
                put(work.rhs, (i, 2), at(work.rhs, (i, 2)) + fz)
            elif hold != 0.0:
                put(work.diagonal, i, at(work.diagonal, i) + hold)
                store(work.rhs, i, load(work.rhs, i, lanes) + hold * load(rate, i, lanes), lanes)
