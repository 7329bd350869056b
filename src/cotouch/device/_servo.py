"""What a device's servo does at a tick: measure, book, decide on a force, and hold it until the next.

The energy of the port is counted in the device's own coordinates: `effort·Δcoordinate` is what a held effort does,
exactly, also where motors sit at joints.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from math import inf

import numpy as np

from cotouch.arrays import Float
from cotouch.device._hand import LANES, add_to_ledger
from cotouch.device._phantom import joint_torques, phantom_tip
from cotouch.device._tables import (
    CHARGED,
    DECLARED,
    FASTEST,
    HOST_FORCE,
    LONGEST,
    LOWEST,
    MEASURED_WORK,
    PHANTOM,
    PSPM,
    SATURATED,
    SPRING,
    SPRING_ENERGY,
    TANK,
    Devices,
    DeviceState,
)
from cotouch.mechanics import at, credit, inner, load, modulate, part, place_at_rest, put, splat, store, total


@part
def tick(devices: Devices, state: DeviceState, d: int) -> None:
    """One tick of device d, now; with the law TOLD it only measures, because the force is the body's affair.

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    servos = devices.servos
    paid = _measure(devices, state, d)
    place, rate = load(state.place, d, LANES), load(state.sample_velocity, d, LANES)
    desired = load(state.desired, d, LANES)
    stiffness, damping = at(servos.stiffness, d), at(servos.damping, d)
    law = at(servos.law, d)
    if law == PSPM:
        gift = credit(at(state.received, d), at(state.seen, d))
        put(state.seen, d, at(state.seen, d) + gift)
        available = at(state.ledger, (d, SPRING_ENERGY)) + at(state.ledger, (d, TANK)) + paid + gift
        put(state.ledger, (d, LOWEST), min(at(state.ledger, (d, LOWEST)), available))
        gap = desired - place
        potential = 0.5 * stiffness * total(gap * gap)
        fraction, tank, sent = modulate(potential, available, at(servos.cap, d))
        put(state.ledger, (d, TANK), tank)
        if fraction == 0.0:  # also if the desired position is no number
            gap, potential = splat(0.0, LANES), 0.0
        put(state.ledger, (d, SPRING_ENERGY), fraction * fraction * potential)
        put(state.sent, d, at(state.sent, d) + sent)
        store(state.set_position, d, place + fraction * gap, LANES)
        force = (stiffness * fraction) * gap - damping * rate
        if available < -at(servos.reserve, d):
            force = splat(0.0, LANES)
        actuate(devices, state, d, force)
    elif law == SPRING:
        seen = place
        if at(servos.lag, d) > 0:
            late = max(at(state.ticks, d) - 1 - at(servos.lag, d), 0)
            seen = load(state.history, _slot(state, d, late), LANES)
        actuate(devices, state, d, stiffness * (desired - seen) - damping * rate)


@part
def actuate(devices: Devices, state: DeviceState, d: int, force: float) -> None:
    """Holds a force from now on, shortened to what the motors can do; its direction is kept.

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
        force: on the hand, 3 numbers [N].
    """
    servos = devices.servos
    size = total(force * force) ** 0.5
    scale = 1.0
    if size > at(servos.force, d):
        scale = at(servos.force, d) / size
        force = scale * force
    store(state.force, d, force, LANES)
    store(state.effort_before, d, load(state.effort, d, LANES), LANES)
    if at(devices.plants.kind, d) == PHANTOM:
        t1, t2, t3 = joint_torques(
            devices.plants,
            d,
            at(state.measured, (d, 0)),
            at(state.measured, (d, 1)),
            at(state.measured, (d, 2)),
            at(state.force, (d, 0)),
            at(state.force, (d, 1)),
            at(state.force, (d, 2)),
        )
        put(state.effort, (d, 0), t1)
        put(state.effort, (d, 1), t2)
        put(state.effort, (d, 2), t3)
    else:
        store(state.effort, d, force, LANES)
    over = 1.0
    for axis in range(3):
        wanted = abs(at(state.effort, (d, axis)))
        if wanted > at(servos.torque, (d, axis)):
            over = min(over, at(servos.torque, (d, axis)) / wanted)
    if over < 1.0:
        store(state.effort, d, over * load(state.effort, d, LANES), LANES)
        store(state.force, d, over * force, LANES)
    if over * scale < 1.0:
        add_to_ledger(state, d, SATURATED, 1.0)


@inner
def _slot(state: DeviceState, d: int, index: int) -> int:
    """Row of the history, devices in a row, that holds the sample of a tick."""
    length = state.history_time.shape[1]
    return d * length + index % length


@inner
def _measure(devices: Devices, state: DeviceState, d: int) -> float:
    """Reads encoders and clock; returns what the coupling's energy has changed by since the last tick [J].

    That is minus the work of the held effort, minus the encoder's charge, plus declared damping.
    """
    servos = devices.servos
    now = at(state.time, d)
    index = at(state.ticks, d)
    span = now - at(state.sample_time, d)
    work, charged, declared = 0.0, 0.0, 0.0
    for axis in range(3):
        fine = at(servos.resolution, (d, axis))
        value = at(state.coordinate, (d, axis))
        if fine > 0.0:
            value = fine * np.rint(value / fine)
        moved = value - at(state.measured, (d, axis))
        effort = at(state.effort, (d, axis))
        put(state.measured, (d, axis), value)
        work += effort * moved
        charged += 0.5 * fine * abs(effort - at(state.effort_before, (d, axis)))
        if index > 0 and span > 0.0:
            sure = max(abs(moved) - fine, 0.0)
            declared += at(servos.declared, (d, axis)) * sure * sure / span
    store(state.effort_before, d, load(state.effort, d, LANES), LANES)  # charged, also if it stays
    before, last = load(state.sample, d, LANES), load(state.place, d, LANES)
    q1, q2, q3 = at(state.measured, (d, 0)), at(state.measured, (d, 1)), at(state.measured, (d, 2))
    _see(devices, state.sample, d, q1, q2, q3)
    p1, p2, p3 = _rest(devices, state, d, 0, span), _rest(devices, state, d, 1, span), _rest(devices, state, d, 2, span)
    _see(devices, state.place, d, p1, p2, p3)
    place = load(state.place, d, LANES)
    store(state.history, _slot(state, d, index), place, LANES)
    put(state.history_time, _slot(state, d, index), now)
    put(state.sample_time, d, now)
    put(state.ticks, d, index + 1)
    if index == 0 or span <= 0.0:
        return 0.0
    _differentiate(devices, state, d, index)
    moved, step = load(state.sample, d, LANES) - before, place - last
    fastest = max(total(moved * moved), total(step * step)) ** 0.5 / span
    put(state.ledger, (d, FASTEST), max(at(state.ledger, (d, FASTEST)), fastest))
    put(state.ledger, (d, LONGEST), max(at(state.ledger, (d, LONGEST)), span))
    add_to_ledger(state, d, MEASURED_WORK, work)
    add_to_ledger(state, d, CHARGED, charged)
    add_to_ledger(state, d, DECLARED, declared)
    return declared - work - charged


@inner
def _see(devices: Devices, places: Float, d: int, q1: float, q2: float, q3: float) -> None:
    """Writes where the tip is at these coordinates."""
    if at(devices.plants.kind, d) == PHANTOM:
        q1, q2, q3 = phantom_tip(devices.plants, d, q1, q2, q3)
    put(places, (d, 0), q1)
    put(places, (d, 1), q2)
    put(places, (d, 2), q3)


@inner
def _rest(devices: Devices, state: DeviceState, d: int, axis: int, span: float) -> float:
    """A coordinate as the law takes it."""
    fraction, fine = at(devices.servos.rest, (d, axis)), at(devices.servos.resolution, (d, axis))
    return place_at_rest(state.resting, 4 * d + axis, at(state.measured, (d, axis)), fine, fraction, span)


@inner
def _differentiate(devices: Devices, state: DeviceState, d: int, index: int) -> None:
    """Velocity over the window: since the oldest sample in it, and at least since the last tick.

    With the law TOLD always since the last sample, which is what the bound of the virtual coupling asks for.
    """
    now = at(state.sample_time, d)
    window = 0.0 if at(devices.servos.law, d) == HOST_FORCE else at(devices.servos.window, d)
    horizon = now - window * (1.0 + 1e-9)
    oldest = max(at(state.oldest, d), index + 1 - state.history_time.shape[1])
    while oldest < index - 1 and at(state.history_time, _slot(state, d, oldest)) < horizon:
        oldest += 1
    put(state.oldest, d, oldest)
    slot = _slot(state, d, oldest)
    rate = (load(state.place, d, LANES) - load(state.history, slot, LANES)) * (
        1.0 / (now - at(state.history_time, slot))
    )
    store(state.sample_velocity, d, rate, LANES)


@inner
def next_tick(devices: Devices, state: DeviceState, d: int) -> float:
    """When the servo next ticks by itself [s].

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    return inf if at(devices.servos.law, d) == HOST_FORCE else at(state.next_tick, d)
