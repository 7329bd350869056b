"""Joins devices to proxies: what a proxy is pulled by in a body's step, and what the device is told after it.

The device runs at its servo's rate, the body at its own, and neither waits. With a coupling of `cotouch.mechanics` each
has an end of its own, as with a real device: a tick of the servo books what the held force did on the device, a step of
the body what the spring did on the proxy, and each hears what the other said last. With the law HOST_FORCE, a virtual
coupling, the body's step computes the force, and the device holds it; it asks for no more than the motors can do,
wherever the device is.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from math import inf
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.coupling import END, HeldForce, book_end, coupling_at, hear_end, run_end
from cotouch.device._advance import advance
from cotouch.device._hand import LANES
from cotouch.device._tables import (
    COULOMB_LOSS,
    COUPLED,
    DECLARED,
    HOST_FORCE,
    PHANTOM,
    VISCOUS_LOSS,
    WORK,
    Devices,
    DeviceState,
)
from cotouch.kernels import at, inner, load, part, put, splat, store, total
from cotouch.mechanics import Tools
from cotouch.passing import by_address


@by_address
class Couplings(NamedTuple):
    """The proxies' side. Row t of every array belongs to tool t.

    Attributes:
        device: which device drives the tool; -1: none, (tools,).
        origin: place of the device's origin in the body's frame, (tools, 4) [m].
        stiffness: k at the proxy, (tools,) [N/m].
        damping: b at the proxy, (tools,) [Ns/m].
        most: of a virtual coupling: the force at which it saturates, (tools,) [N].
        before: y at the start of the step, (tools, 4) [m].
        target: from there to the set position, (tools, 4) [m].
        unsure: of a virtual coupling: by how much encoders may falsify its force, (tools,) [N].
        ends: the coupling's end at each proxy, (tools, END.length).
        address: of the coupling's function for it, in this process; 0: it has none, (tools,).
        work: Σ τᵀŵ T, done on the proxy since the start, (tools,) [J].
        excess: largest `∫τᵀq̇ dt + Σ τᵀŵ T` so far: two-port passive if bounded, (tools,) [J]. Where the coupling
            counts on the device's own friction this is paid from it: all of it with a virtual coupling, what was
            declared with PSPM.
        unpaid: of a virtual coupling: what the false part of its force can have done on the proxy, (tools,) [J].
    """

    device: Long
    origin: Float
    stiffness: Float
    damping: Float
    most: Float
    before: Float
    target: Float
    unsure: Float
    ends: Float
    address: Long
    work: Float
    excess: Float
    unpaid: Float


def couplings(count: int) -> Couplings:
    """Room for the couplings of so many tools, none of which has a device yet."""
    return Couplings(
        device=np.full(count, -1, dtype=np.int64),
        origin=np.zeros((count, 4)),
        stiffness=np.zeros(count),
        damping=np.zeros(count),
        most=np.full(count, inf),
        before=np.zeros((count, 4)),
        target=np.zeros((count, 4)),
        unsure=np.zeros(count),
        ends=np.zeros((count, END.length)),
        address=np.zeros(count, dtype=np.int64),
        work=np.zeros(count),
        excess=np.zeros(count),
        unpaid=np.zeros(count),
    )


def sure_force(devices: Devices, d: int) -> float:
    """The force that a device's motors can do in every direction and wherever it is; may be infinite [N].

    Args:
        devices: all devices.
        d: number of the device.
    """
    servos, plants = devices.servos, devices.plants
    most = float(servos.force[d])
    if plants.kind[d] == PHANTOM:
        # The first joint turns both arms, each of the others its own.
        levers = np.array([plants.length[d].sum(), *plants.length[d]])
        most = min(most, float((servos.torque[d, :3] / levers).min()))
    return most


def excess_bound(
    devices: Devices,
    couplings: Couplings,
    t: int,
    *,
    fastest: float,
    longest: float,
    largest: float,
    unpaid: float,
) -> float:
    """What the excess of a coupling can at most come to [J].

    That of a virtual coupling by host force is paid by its device's own friction, but for what its encoders' error did
    on the proxy.

    Args:
        devices: what the devices are.
        couplings: of all tools.
        t: which tool.
        fastest: highest speed of its tip, as measured [m/s].
        longest: longest period between ticks [s].
        largest: highest force that its motors held; matters where nothing limits it [N].
        unpaid: as in `Couplings` [J].
    """
    end, d, servos = couplings.ends[t], int(couplings.device[t]), devices.servos
    if servos.law[d] != COUPLED:
        return unpaid
    begun = 2.0 * float(end[END.initial])
    if longest == 0.0:
        return begun
    # A joint's encoder moves the tip by no more than its resolution times the arm.
    arm = float(devices.plants.length[d].sum()) if devices.plants.kind[d] == PHANTOM else 1.0
    held = HeldForce(
        stiffness=float(servos.stiffness[d]),
        damping=float(servos.damping[d]),
        period=longest,
        speed=fastest,
        reserve=float(end[END.reserve]),
        force=float(servos.force[d]) if servos.force[d] < inf else largest,
        resolution=arm * float(servos.resolution[d, 0]),
    )
    return begun + (1 + int(servos.latency[d])) * coupling_at(int(servos.address[d])).bound(held)


@inner
def account_energy(couplings: Couplings, state: DeviceState, t: int) -> float:
    """What the proxy's end of a coupling has, and what either end gave that the other has not received yet [J].

    Args:
        couplings: of all tools.
        state: of all devices.
        t: which tool; it has a device.
    """
    ends, others, d = couplings.ends, state.ends, at(couplings.device, t)
    there = at(ends, (t, END.given)) - at(others, (d, END.received))
    back = at(others, (d, END.given)) - at(ends, (t, END.received))
    return at(ends, (t, END.energy)) + there + back


@part
def pull_proxy(
    devices: Devices, state: DeviceState, couplings: Couplings, tools: Tools, t: int, end: float, T: float
) -> bool:
    """Brings a tool's device to the end of a body's step and sets what pulls its proxy during that step.

    Args:
        devices: what the devices are.
        state: where they are; the tool's device advances.
        couplings: the proxies' side.
        tools: drive of tool t is written.
        t: which tool; it has a device.
        end: of the step [s].
        T: its length [s].

    Returns:
        Whether the device's motion is still within the range of floating point.
    """
    d = at(couplings.device, t)
    finite = advance(devices, state, d, end)
    k, b = at(couplings.stiffness, t), at(couplings.damping, t)
    place = load(tools.place, t, LANES)
    gap = load(state.place, d, LANES) + load(couplings.origin, t, LANES) - place
    store(couplings.before, t, place, LANES)
    rate = load(state.sample_velocity, d, LANES)
    if at(devices.servos.law, d) == HOST_FORCE:
        # The gap at the start of the step is shortened, which makes k (q - y) the slope of a convex energy, no steeper
        # than k; the damper gets what force is left. What the coupling makes in a period then keeps its bound, which it
        # does not if motors cut off the force of a linear spring and damper.
        most, pull, drag = at(couplings.most, t), k * total(gap * gap) ** 0.5, b * total(rate * rate) ** 0.5
        if pull > most:
            gap, pull = (most / pull) * gap, most
        if pull + drag > most:
            b *= (most - pull) / drag
        # k (q - y⁺) + b (v - ŵ): the end of the step rather than its middle is what makes half of k T damping.
        store(tools.push, t, b * rate, LANES)
        b += 0.5 * k * T
    else:
        ends = couplings.ends
        hear_end(ends, t, state.ends, d)
        put(ends, (t, END.T), T)
        put(ends, (t, END.known), 1.0)
        for axis in range(3):
            distance = at(state.place, (d, axis)) + at(couplings.origin, (t, axis)) - at(tools.place, (t, axis))
            put(ends, (t, END.gap + axis), distance)
            put(ends, (t, END.rate + axis), at(state.sample_velocity, (d, axis)))
        run_end(at(couplings.address, t), ends, t)
        k, b = at(ends, (t, END.spring)), at(ends, (t, END.brake))
        for axis in range(3):
            put(couplings.target, (t, axis), at(ends, (t, END.stretch + axis)))
            put(tools.push, (t, axis), at(ends, (t, END.push + axis)))
        gap = load(couplings.target, t, LANES)
    target = place + gap
    put(tools.drive_stiffness, t, k)
    put(tools.drive_damping, t, b)
    store(tools.drive_start, t, target, LANES)
    store(tools.drive_end, t, target, LANES)
    return finite


@part
def command_device(devices: Devices, state: DeviceState, couplings: Couplings, tools: Tools, t: int) -> None:
    """Tells a tool's device where its proxy went in the step just taken, and books what that took from the coupling.

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        couplings: of all tools; changed in place.
        tools: proxies and their ledger.
        t: number of the tool.
    """
    d = at(couplings.device, t)
    place, force = load(tools.place, t, LANES), load(tools.drive_force, t, LANES)
    moved = place - load(couplings.before, t, LANES)
    done = total(force * moved)
    put(couplings.work, t, at(couplings.work, t) + done)
    store(state.desired, d, place - load(couplings.origin, t, LANES), LANES)
    if at(devices.servos.law, d) == HOST_FORCE:
        store(state.host_force, d, splat(0.0, LANES) - force, LANES)
        false = at(couplings.unsure, t) * total(moved * moved) ** 0.5
        put(couplings.unpaid, t, at(couplings.unpaid, t) + false)
        paid = at(state.ledger, (d, VISCOUS_LOSS)) + at(state.ledger, (d, COULOMB_LOSS))
    else:
        book_end(couplings.ends, t, done, 0.0, 0.0)
        hear_end(state.ends, d, couplings.ends, t)
        paid = at(state.ledger, (d, DECLARED))
    both = at(state.ledger, (d, WORK)) + at(couplings.work, t) - paid
    put(couplings.excess, t, max(at(couplings.excess, t), both))
