"""What a look keeps of forces, and what resists motion at obstacles, as the linear system of a step has it."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float, Int
from cotouch.kernels import FOUR, at, four, inner, load, part, put, splat, store
from cotouch.mechanics._linear._state import Workspace
from cotouch.mechanics._meeting._pressed_point import Resists
from cotouch.mechanics._meeting._world import World


@inner
def tell(world: World, n: int, fx: float, fy: float, fz: float) -> float:
    """Keeps the force on a point; returns the square of what it changed by since the last look.

    Args:
        world: obstacles and points; `told` is changed.
        n: row of `told`.
        fx: force along x [N].
        fy: likewise.
        fz: likewise.
    """
    change = (fx - at(world.told, (n, 0))) ** 2
    change += (fy - at(world.told, (n, 1))) ** 2 + (fz - at(world.told, (n, 2))) ** 2
    put(world.told, (n, 0), fx)
    put(world.told, (n, 1), fy)
    put(world.told, (n, 2), fz)
    return change


@inner
def couple(world: World, p: int, by: Resists) -> None:
    """Adds what resists motion of a point to what couples the rows at it; see `couple_rows`.

    Args:
        world: obstacles and points; `couple` or `pairs` is added to.
        p: which point.
        by: what resists.
    """
    if world.couple.shape[0] > 0:
        couple_rows(world, world.among, world.share, at(world.pointer, p), at(world.pointer, p + 1), by)


@part
def couple_rows(world: World, rows: Int, shares: Float, first: int, last: int, by: Resists) -> None:
    """Adds what resists motion of a point to what couples pairs of the rows that move it.

    Args:
        world: obstacles and points.
        rows: numbers of those that are solved for at once; negative: none of them.
        shares: how much each moves.
        first: of these two, the first that counts.
        last: and one past the last.
        by: what resists.
    """
    x, y, z = four(by[0], by[1], by[2], 0.0), four(by[3], by[4], by[5], 0.0), four(by[6], by[7], by[8], 0.0)
    count = world.couple.shape[0] // 3
    for e in range(first, last):
        r, own = at(rows, e), at(shares, e)
        for other in range(first, e + 1 if r >= 0 else first):
            s = at(rows, other)
            if s >= 0:
                share, place = own * at(shares, other), 3 * (max(r, s) * count + min(r, s))
                store(world.pairs, place, load(world.pairs, place, FOUR) + share * x, FOUR)
                store(world.pairs, place + 1, load(world.pairs, place + 1, FOUR) + share * y, FOUR)
                store(world.pairs, place + 2, load(world.pairs, place + 2, FOUR) + share * z, FOUR)


@part
def clear_pairs(world: World) -> None:
    """Nothing couples rows."""
    zero = splat(0.0, FOUR)
    for place in range(world.pairs.shape[0]):
        store(world.pairs, place, zero, FOUR)


@part
def spread_pairs(world: World) -> None:
    """Makes of what was added up for each pair of rows the matrix of all of them."""
    count = world.couple.shape[0] // 3
    for r in range(count):
        for s in range(r + 1):
            for a in range(3):
                for b in range(3):
                    value = at(world.pairs, (3 * (r * count + s) + a, b))
                    put(world.couple, (3 * r + a, 3 * s + b), value)
                    put(world.couple, (3 * s + a, 3 * r + b), value)


@part
def lean_world(world: World | None, copy_scale: float, rate: Float, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Puts what resists at the touched rows into the linear system, about the rate at which forces were worked out.

    Args:
        world: obstacles and points; None: none.
        copy_scale: what is taken of it.
        rate: at which forces were worked out, (rows, width) [m/s].
        work: the system; added to.
        lanes: fixes the width of a row.
    """
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
