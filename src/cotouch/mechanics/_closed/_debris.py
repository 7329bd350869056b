"""Nodes that have lost their last element: no longer part of the object, they rest where they were cut off.

They have no skin, so no table would ever stop them. That they rest costs nothing: a row whose mean velocity is 0 takes
part in no work at all, so its weight, links and whatever else would pull at it leave the balance as it is. What they
moved with goes with what was cut.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float, Int
from cotouch.kernels import at, block, load, part, put, splat, store, total
from cotouch.mechanics._closed._balance import MOTION
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import CUT, KINETIC, Ports, State
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import MOST_HELD, Tools


@block
def free_debris(op: Operator, ports: Ports, lanes: tuple[int, ...]) -> None:
    """Before a step: no port holds debris, nor feels it.

    Args:
        op: of the body, as the copy has it.
        ports: what holds the copy; those at debris are changed.
        lanes: fixes the width of a row.
    """
    if op.debris.shape[0] == 0 or ports.shape.shape[0] > 0:
        return
    for p in range(ports.row.shape[0]):
        if at(op.debris, at(ports.row, p)) != 0:
            put(ports.stiffness, p, 0.0)
            put(ports.damping, p, 0.0)
            store(ports.push, p, splat(0.0, lanes), lanes)


@block
def rest_debris(op: Operator, mean: Float, lanes: tuple[int, ...]) -> None:
    """Before a copy moves: debris does not.

    Args:
        op: of the body, as the copy has it.
        mean: v̂ of all rows; changed in place.
        lanes: fixes the width of a row.
    """
    for i in range(op.debris.shape[0]):
        if at(op.debris, i) != 0:
            store(mean, i, splat(0.0, lanes), lanes)


@block
def stop_debris(op: Operator, state: State, ledger: Float, lanes: tuple[int, ...]) -> None:
    """After a cut: debris stops, and CUT of the ledger gets what it moved with.

    Args:
        op: of the body, as the copy has it now.
        state: of the copy; changed in place.
        ledger: of the step; changed in place.
        lanes: fixes the width of a row.
    """
    zero = splat(0.0, lanes)
    gone, left = zero, zero
    for i in range(op.debris.shape[0]):
        v = load(state.velocity, i, lanes)
        if at(op.debris, i) != 0:
            gone = gone + at(op.mass, i) * (v * v)
            store(state.velocity, i, zero, lanes)
        else:
            left = left + at(op.mass, i) * (v * v)
    if total(gone) > 0.0:
        moving = 0.5 * total(left)
        lost = state.memory[MOTION] - moving
        if lost > 0.0:
            state.memory[MOTION] = moving
            ledger[KINETIC] = op.copy_scale * moving
            ledger[CUT] += op.copy_scale * lost


@part
def is_debris(debris: Int, hold_row: Int, h: int) -> bool:
    """Whether what a grasp may hold is debris.

    Args:
        debris: of the operator.
        hold_row: of the surface.
        h: what is held.
    """
    return debris.shape[0] > 0 and hold_row.shape[1] == 1 and at(debris, at(hold_row, (h, 0))) != 0


@part
def drop_debris(debris: Int, surface: Surface, tools: Tools, t: int, position: Float) -> float:
    """Makes a grasp let go of debris; returns what its springs held there [J].

    Args:
        debris: of the operator.
        surface: the skin.
        tools: the proxies.
        t: which of them, a grasp that holds something.
        position: of the copy, displacements of the rows [m].
    """
    hold_row, base, kept, lost = surface.hold_row, t * MOST_HELD, 0, 0.0
    if debris.shape[0] == 0 or hold_row.shape[1] != 1:
        return 0.0
    for c in range(tools.held[t]):
        h = at(tools.hold, (t, c))
        if is_debris(debris, hold_row, h):
            for a in range(3):
                stretch = position[hold_row[h, 0], a] - tools.place[t, a] - tools.offset[base + c, a]
                lost += 0.5 * tools.grip_stiffness[t] * stretch * stretch
            continue
        if kept != c:
            tools.hold[t, kept] = h
            for a in range(4):
                tools.offset[base + kept, a] = tools.offset[base + c, a]
        kept += 1
    tools.held[t] = kept
    return lost
