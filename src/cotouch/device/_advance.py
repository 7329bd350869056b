"""Moves one device to a given time, with all ticks of its servo on the way.

What whoever steps the proxy does with it, in each step from t to t + T:

* *A coupling, or a sampled spring.* `advance` to any time up to now; pull the proxy towards `place`; after the step
  write the proxy's place to `desired`. Each end of a coupling has a tank of its own, and they tell each other sums,
  late or never as the channel likes: the rows `ends` (`_couple.py`, `SimulatedDevice`).
* *Host force.* `advance` to t, the start of the step; with q = `sample` and v = `sample_velocity` step the proxy under
  `τ = k (q - y⁺) + b (v - ŵ)`; write -τ to `host_force`. The next `advance`, to t + T, holds it.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from math import ceil

from cotouch.device._cartesian import cartesian_mass, cartesian_step
from cotouch.device._hand import LANES, add_to_ledger, hand_energy, next_change, relax, should_hold
from cotouch.device._phantom import coefficients, inverse, mass_matrix, phantom_kinetic, phantom_potential, phantom_step
from cotouch.device._servo import actuate, next_tick, tick
from cotouch.device._tables import (
    COULOMB_LOSS,
    HAND_ENERGY,
    HAND_LOSS,
    HOST_FORCE,
    HUMAN,
    INITIAL,
    KINETIC,
    PHANTOM,
    POTENTIAL,
    RESIDUAL,
    VISCOUS_LOSS,
    WORK,
    Devices,
    DeviceState,
)
from cotouch.kernels import at, inner, kernel, load, part, put, store, total

# A tick this close, beside a period, is now: sums of periods and times of steps differ by rounding.
_ON_TIME = 1e-6


@kernel
def advance(devices: Devices, state: DeviceState, d: int, until: float) -> bool:
    """Moves device d from its own time to `until`; all ticks up to and including `until` happen.

    With the law HOST_FORCE the force in `host_force` acts all the time, and the one sample is taken at `until`.

    Args:
        devices: what the devices are.
        state: where they are; row d is changed in place.
        d: which one.
        until: not before the device's time [s].

    Returns:
        Whether the motion is still within the range of floating point.
    """
    host_force = at(devices.servos.law, d) == HOST_FORCE
    if host_force:
        if at(state.ticks, d) == 0:
            tick(devices, state, d)
        actuate(devices, state, d, load(state.host_force, d, LANES))
    slack = _ON_TIME * at(devices.servos.period, (d, 0))
    moving = True
    while moving:
        t = at(state.time, d)
        due = next_tick(devices, state, d)
        if due <= t + slack:
            period = at(devices.servos.period, (d, at(state.ticks, d) % devices.servos.period.shape[1]))
            tick(devices, state, d)
            put(state.next_tick, d, due + period)
        if should_hold(devices.grasps, state, d) != (at(state.holding, d) != 0):
            _change_hold(devices, state, d)
        moving = t < until
        if moving:
            stop = min(until, next_tick(devices, state, d), next_change(devices.grasps, state, d))
            count = max(1, ceil((stop - t) / at(devices.plants.substep, d) - 1e-9))
            h = (stop - t) / count
            for s in range(count):
                put(state.time, d, t + s * h)
                if at(devices.plants.kind, d) == PHANTOM:
                    phantom_step(devices, state, d, h)
                else:
                    cartesian_step(devices, state, d, h)
            put(state.time, d, stop)
    if host_force:
        tick(devices, state, d)
    return balance(devices, state, d) < 1e200


@kernel
def balance(devices: Devices, state: DeviceState, d: int) -> float:
    """Books the energies of now and the residual; returns the energy in all [J].

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    kinetic = _kinetic(devices, state, d)
    held = hand_energy(devices.grasps, state, d)
    potential = 0.0
    if at(devices.plants.kind, d) == PHANTOM:
        potential = phantom_potential(devices.plants, d, at(state.coordinate, (d, 1)), at(state.coordinate, (d, 2)))
    now = kinetic + held + potential
    ledger = state.ledger
    put(ledger, (d, KINETIC), kinetic)
    put(ledger, (d, HAND_ENERGY), held)
    put(ledger, (d, POTENTIAL), potential)
    losses = at(ledger, (d, HAND_LOSS)) + at(ledger, (d, VISCOUS_LOSS)) + at(ledger, (d, COULOMB_LOSS))
    supplied = at(ledger, (d, WORK)) + at(ledger, (d, HUMAN))
    put(ledger, (d, RESIDUAL), now - at(ledger, (d, INITIAL)) - supplied + losses)
    return now


@inner
def _kinetic(devices: Devices, state: DeviceState, d: int) -> float:
    if at(devices.plants.kind, d) == PHANTOM:
        return phantom_kinetic(devices, state, d)
    momentum = load(state.momentum, d, LANES)
    return 0.5 * total(momentum * momentum) / cartesian_mass(devices, state, d)


@part
def _change_hold(devices: Devices, state: DeviceState, d: int) -> None:
    """The hand takes hold or lets go.

    It takes hold with a relaxed spring and at rest: momentum stays, and what kinetic energy is lost is the impact's.
    It lets go with the tip's velocity, and takes along what it and its spring have.
    """
    before = _kinetic(devices, state, d)
    if at(state.holding, d) == 0:
        put(state.holding, d, 1)
        relax(devices, state, d)
        add_to_ledger(state, d, HAND_LOSS, before - _kinetic(devices, state, d))
        return
    before += hand_energy(devices.grasps, state, d)
    if at(devices.plants.kind, d) == PHANTOM:
        q2, q3 = at(state.coordinate, (d, 1)), at(state.coordinate, (d, 2))
        p1, p2, p3 = at(state.momentum, (d, 0)), at(state.momentum, (d, 1)), at(state.momentum, (d, 2))
        w = inverse(mass_matrix(coefficients(devices, state, d), q2, q3))
        v1, v2, v3 = w[0] * p1, w[1] * p2 + w[3] * p3, w[3] * p2 + w[2] * p3
        put(state.holding, d, 0)
        m = mass_matrix(coefficients(devices, state, d), q2, q3)
        put(state.momentum, (d, 0), m[0] * v1)
        put(state.momentum, (d, 1), m[1] * v2 + m[3] * v3)
        put(state.momentum, (d, 2), m[3] * v2 + m[2] * v3)
    else:
        fraction = 1.0 / cartesian_mass(devices, state, d)
        put(state.holding, d, 0)
        fraction *= cartesian_mass(devices, state, d)
        store(state.momentum, d, fraction * load(state.momentum, d, LANES), LANES)
    add_to_ledger(state, d, HUMAN, _kinetic(devices, state, d) - before)
