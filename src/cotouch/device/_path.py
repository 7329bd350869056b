"""Where a hand's path leads: straight between waypoints, still before and after them, plus a sine."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import Protocol

import numpy as np

from cotouch.arrays import Float, Int, Long
from cotouch.kernels import at, inner, load, put

Whole = Int | Long


class PathTable(Protocol):
    """Paths of many hands; any table with these columns, as numba sees it."""

    @property
    def path_first(self) -> Whole:
        """First waypoint of each path, (paths + 1,)."""
        ...

    @property
    def path_time(self) -> Float:
        """Of waypoints, rising in each path, (waypoints,) [s]."""
        ...

    @property
    def path_value(self) -> Float:
        """Of waypoints, (waypoints, width)."""
        ...

    @property
    def amplitude(self) -> Float:
        """Of the sine, (paths, width)."""
        ...

    @property
    def frequency(self) -> Float:
        """Of the sine, (paths,) [Hz]."""
        ...

    @property
    def phase(self) -> Float:
        """Of the sine, (paths,) [rad]."""
        ...


@inner
def path_place(paths: PathTable, cursor: Whole, p: int, t: float, lanes: tuple[int, ...]) -> float:
    """Where path p is at time t, a row; kernels only.

    Args:
        paths: of all hands.
        cursor: waypoint at which each path was last, (paths,); changed in place.
        p: which path.
        t: time [s].
        lanes: as long as a row is wide.
    """
    first, last = at(paths.path_first, p), at(paths.path_first, p + 1) - 1
    here = at(cursor, p)
    while here > first and at(paths.path_time, here) > t:
        here -= 1
    while here < last and at(paths.path_time, here + 1) <= t:
        here += 1
    put(cursor, p, here)
    value = load(paths.path_value, here, lanes)
    if here < last and t > at(paths.path_time, here):
        fraction = (t - at(paths.path_time, here)) / (at(paths.path_time, here + 1) - at(paths.path_time, here))
        value = (1.0 - fraction) * value + fraction * load(paths.path_value, here + 1, lanes)
    if at(paths.frequency, p) != 0.0:
        wave = np.sin(2.0 * np.pi * at(paths.frequency, p) * t + at(paths.phase, p))
        value = value + wave * load(paths.amplitude, p, lanes)
    return value
