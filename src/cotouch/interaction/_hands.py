"""Virtual hands: what pulls at which node, when, and where to."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

from cotouch.arrays import Bool, Float, Int
from cotouch.device import path_place
from cotouch.kernels import at, kernel, put, splat, store
from cotouch.mechanics import Ports
from cotouch.passing import by_address


@by_address
class Hands(NamedTuple):
    """What pulls at the ports. A hand follows its path, pulls by a spring and damper, and lets go.

    Attributes:
        first: first port of each user, (users + 1,).
        row: row of the body that each port holds, (ports,).
        shape: row vectors of the ports in a modal basis, (ports, rows) or (0, rows).
        stiffness: (ports,) [N/m].
        damping: (ports,) [Ns/m].
        begin: the port acts from here, (ports,) [s].
        release: to here, (ports,) [s].
        forced: whether the path is a force [N] rather than a place [m], (ports,).
        path_first: first waypoint of each port, (ports + 1,).
        path_time: (waypoints,) [s].
        path_value: (waypoints, width).
        amplitude: of a sine added to the path, (ports, width).
        frequency: (ports,) [Hz].
        phase: (ports,) [rad].
    """

    first: Int
    row: Int
    shape: Float
    stiffness: Float
    damping: Float
    begin: Float
    release: Float
    forced: Bool
    path_first: Int
    path_time: Float
    path_value: Float
    amplitude: Float
    frequency: Float
    phase: Float


@kernel
def grip(hands: Hands, ports: Ports, cursor: Int, p: int, end: float, T: float, lanes: tuple[int, ...]) -> None:
    """What port p does during a step that ends at `end`.

    Args:
        hands: of all users.
        ports: ports, written to.
        cursor: waypoint at which each path is; changed in place.
        p: number of the port.
        end: of the step [s].
        T: length of the step [s].
        lanes: as many as a row is wide.
    """
    middle = end - 0.5 * T
    zero = splat(0.0, lanes)
    store(ports.start, p, zero, lanes)
    store(ports.end, p, zero, lanes)
    store(ports.push, p, zero, lanes)
    put(ports.stiffness, p, 0.0)
    put(ports.damping, p, 0.0)
    if at(hands.begin, p) <= middle < at(hands.release, p):
        if at(hands.forced, p):
            store(ports.push, p, path_place(hands, cursor, p, middle, lanes), lanes)
        else:
            put(ports.stiffness, p, at(hands.stiffness, p))
            put(ports.damping, p, at(hands.damping, p))
            store(ports.start, p, path_place(hands, cursor, p, end - T, lanes), lanes)
            store(ports.end, p, path_place(hands, cursor, p, end, lanes), lanes)
