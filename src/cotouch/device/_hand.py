"""What a hand does to the tip that it holds: where it wants to be, taking hold, letting go, correcting late.

The hand is a mass on the tip, with a spring and a damper to an equilibrium point [van Beek et al. 2015]. The point
follows a path; what the will adds to it answers the error of the tip one reaction time ago.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from math import inf

from cotouch.device._path import path_place
from cotouch.device._tables import HAND_LOSS, HUMAN, RECALL, VISCOUS_LOSS, WORK, Devices, DeviceState, Grasps
from cotouch.kernels import at, inner, load, part, put, splat, store, total

LANES = (0, 0, 0, 0)


@inner
def add_to_ledger(state: DeviceState, d: int, book: int, value: float) -> None:
    """Adds to a book of device d.

    Args:
        state: of all devices; changed in place.
        d: number of the device.
        book: column of the ledger.
        value: to add.
    """
    put(state.ledger, (d, book), at(state.ledger, (d, book)) + value)


@inner
def equilibrium_after(grasps: Grasps, state: DeviceState, d: int, t: float) -> float:
    """The equilibrium point at time t: path, what is left of the offset of taking hold, and what the will has added.

    Args:
        grasps: how hands hold and move, of all devices.
        state: of all devices; changed in place.
        d: number of the device.
        t: time [s].
    """
    value = path_place(grasps, state.cursor, d, t, LANES) + load(state.corrected, d, LANES)
    passed = t - at(state.grasped, d)
    if passed < at(grasps.blend, d):
        value = value + (1.0 - passed / at(grasps.blend, d)) * load(state.offset, d, LANES)
    return value


@inner
def hand_energy(grasps: Grasps, state: DeviceState, d: int) -> float:
    """Energy of the hand's spring; 0 if it does not hold [J].

    Args:
        grasps: how hands hold and move, of all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    if at(state.holding, d) == 0:
        return 0.0
    stretch = load(state.tip, d, LANES) - load(state.equilibrium, d, LANES)
    return 0.5 * at(grasps.stiffness, d) * total(stretch * stretch)


@part
def correct(grasps: Grasps, state: DeviceState, d: int, h: float) -> None:
    """The will moves the equilibrium for a time h, against the error that it saw one reaction time ago.

    Args:
        grasps: how hands hold and move, of all devices.
        state: of all devices; changed in place.
        d: number of the device.
        h: length of the step [s].
    """
    if at(grasps.correction, d) == 0.0:
        return
    t = at(state.time, d)
    grid = at(grasps.reaction, d) / RECALL
    while at(state.recalled, d) * grid <= t - at(state.grasped, d):
        slot = d * RECALL + at(state.recalled, d) % RECALL
        if at(state.recalled, d) >= RECALL:  # what is overwritten was seen one reaction time ago
            store(state.urge, d, at(grasps.correction, d) * load(state.recall, slot, LANES), LANES)
        error = path_place(grasps, state.cursor, d, t, LANES) - load(state.tip, d, LANES)
        store(state.recall, slot, error, LANES)
        put(state.recalled, d, at(state.recalled, d) + 1)
    moved = load(state.corrected, d, LANES) + h * load(state.urge, d, LANES)
    size = total(moved * moved) ** 0.5
    if size > at(grasps.reach, d):
        moved = (at(grasps.reach, d) / size) * moved
    store(state.corrected, d, moved, LANES)


@inner
def next_change(grasps: Grasps, state: DeviceState, d: int) -> float:
    """When the hand next takes hold or lets go [s].

    Args:
        grasps: how hands hold and move, of all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    t = at(state.time, d)
    if at(grasps.begin, d) > t:
        return at(grasps.begin, d)
    if at(grasps.release, d) > t:
        return at(grasps.release, d)
    return inf


@inner
def should_hold(grasps: Grasps, state: DeviceState, d: int) -> bool:
    """Whether the hand holds from now on.

    Args:
        grasps: how hands hold and move, of all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    return at(grasps.begin, d) <= at(state.time, d) < at(grasps.release, d)


@inner
def relax(devices: Devices, state: DeviceState, d: int) -> None:
    """A hand that is taking hold starts with its spring relaxed; the offset that this needs fades afterwards.

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    tip = load(state.tip, d, LANES)
    place = path_place(devices.grasps, state.cursor, d, at(state.time, d), LANES)
    store(state.offset, d, tip - place, LANES)
    store(state.equilibrium, d, tip, LANES)
    store(state.corrected, d, splat(0.0, LANES), LANES)
    store(state.urge, d, splat(0.0, LANES), LANES)
    put(state.grasped, d, at(state.time, d))
    put(state.recalled, d, 0)


@inner
def book_hand(grasps: Grasps, state: DeviceState, d: int, h: float, work: float, slip: float) -> None:
    """Books a step of the hand: work on its far end, and the square of how far that end went beyond the tip.

    Args:
        grasps: how hands hold and move, of all devices.
        state: of all devices; changed in place.
        d: number of the device.
        h: length of the step [s].
        work: on the far end of the hand's spring [J].
        slip: square of how far that end went beyond the tip [m²].
    """
    add_to_ledger(state, d, HUMAN, work)
    add_to_ledger(state, d, HAND_LOSS, at(grasps.damping, d) / h * slip)


@inner
def book_motors(state: DeviceState, d: int, work: float, viscous: float) -> None:
    """Books the work of the held effort and the loss in the device's viscous friction.

    Args:
        state: of all devices; changed in place.
        d: number of the device.
        work: of the held effort [J].
        viscous: loss in the device's viscous friction [J].
    """
    add_to_ledger(state, d, WORK, work)
    add_to_ledger(state, d, VISCOUS_LOSS, viscous)
