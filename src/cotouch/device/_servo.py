"""What a device's servo does at a tick: measure, book, decide on a force, and hold it until the next.

The energy of the port is counted in the device's own coordinates: `effort·Δcoordinate` is what a held effort does,
exactly, also where motors sit at joints.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from math import inf

import numpy as np

from cotouch.arrays import Float
from cotouch.coupling import END, book_end, place_at_rest, run_end
from cotouch.device._hand import LANES, add_to_ledger
from cotouch.device._phantom import joint_torques, phantom_tip
from cotouch.device._tables import (
    CHARGED,
    COUPLED,
    DECLARED,
    FASTEST,
    HOST_FORCE,
    LONGEST,
    LOWEST,
    MEASURED_WORK,
    PHANTOM,
    SATURATED,
    SPRING,
    SPRING_ENERGY,
    TANK,
    Devices,
    DeviceState,
)
from cotouch.kernels import at, inner, load, part, put, store, total


@part
def tick(devices: Devices, state: DeviceState, d: int) -> None:
    """One tick of device d, now; with the law HOST_FORCE it only measures, because the force is the body's affair.

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    servos = devices.servos
    _measure(devices, state, d)
    place, rate = load(state.place, d, LANES), load(state.sample_velocity, d, LANES)
    desired = load(state.desired, d, LANES)
    stiffness, damping = at(servos.stiffness, d), at(servos.damping, d)
    law = at(servos.law, d)
    if law == COUPLED:
        _couple(devices, state, d)
    elif law == SPRING:
        seen = place
        if at(servos.lag, d) > 0:
            late = max(at(state.ticks, d) - 1 - at(servos.lag, d), 0)
            seen = load(state.history, _slot(state, d, late), LANES)
        actuate(devices, state, d, stiffness * (desired - seen) - damping * rate)


@part
def _couple(devices: Devices, state: DeviceState, d: int) -> None:
    """The coupling's end at a device decides on a force, which acts at once or, with a latency, from the next tick."""
    ends = state.ends
    late = at(ends, (d, END.latency)) > 0.0
    put(ends, (d, END.acting), at(ends, (d, END.held)) if late else 0.0)
    put(ends, (d, END.known), 1.0)
    for axis in range(3):
        put(ends, (d, END.gap + axis), at(state.desired, (d, axis)) - at(state.place, (d, axis)))
        put(ends, (d, END.rate + axis), at(state.sample_velocity, (d, axis)))
    run_end(at(devices.servos.address, d), ends, d)
    put(state.ledger, (d, TANK), at(ends, (d, END.energy)))
    put(state.ledger, (d, SPRING_ENERGY), at(ends, (d, END.held)))
    put(state.ledger, (d, LOWEST), at(ends, (d, END.lowest)))
    spring, brake = at(ends, (d, END.spring)), at(ends, (d, END.brake))
    on = at(ends, (d, END.energy)) >= -at(ends, (d, END.reserve))
    acts = load(state.coming, d, LANES)
    for axis in range(3):
        stretch, push = at(ends, (d, END.stretch + axis)), at(ends, (d, END.push + axis))
        put(state.set_position, (d, axis), at(state.place, (d, axis)) + stretch)
        force = spring * stretch + push - brake * at(state.sample_velocity, (d, axis))
        put(state.coming, (d, axis), force if on else 0.0)
    actuate(devices, state, d, acts if late else load(state.coming, d, LANES))


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
def _measure(devices: Devices, state: DeviceState, d: int) -> None:
    """Reads encoders and clock; books what the held effort did, the encoder's charge, and declared damping."""
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
        return
    _differentiate(devices, state, d, index)
    moved, step = load(state.sample, d, LANES) - before, place - last
    fastest = max(total(moved * moved), total(step * step)) ** 0.5 / span
    put(state.ledger, (d, FASTEST), max(at(state.ledger, (d, FASTEST)), fastest))
    put(state.ledger, (d, LONGEST), max(at(state.ledger, (d, LONGEST)), span))
    add_to_ledger(state, d, MEASURED_WORK, work)
    add_to_ledger(state, d, CHARGED, charged)
    add_to_ledger(state, d, DECLARED, declared)
    put(state.ends, (d, END.T), span)
    book_end(state.ends, d, work, declared, charged)


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

    With the law HOST_FORCE always since the last sample, which is what the bound of the virtual coupling asks for.
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
