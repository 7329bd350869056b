"""Joins devices to proxies: what a proxy is pulled by in a body's step, and what the device is told after it.

The device runs at its servo's rate, the body at its own, and neither waits. With PSPM each side holds a spring to where
the other was when it last heard of it, and moves that place only as far as there is energy for it. With a virtual
coupling the body's step computes the force, and the device holds it.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.device._advance import advance
from cotouch.device._hand import LANES
from cotouch.device._tables import TOLD, WORK, Devices, DeviceState
from cotouch.mechanics import Tools, at, credit, load, modulate, part, put, splat, store, total

Float = npt.NDArray[np.float64]
Int = npt.NDArray[np.int64]


class Couplings(NamedTuple):
    """The proxies' side. Row t of every array belongs to tool t.

    Attributes:
        device: which device drives the tool; -1: none, (tools,).
        origin: place of the device's origin in the body's frame, (tools, 4) [m].
        stiffness: k at the proxy, (tools,) [N/m].
        damping: b at the proxy, (tools,) [Ns/m].
        cap: Ē, (tools,) [J].
        set_position: q̄, the place that pulls the proxy, (tools, 4) [m].
        spring: energy ½k‖q̄ - y‖² of that pull, (tools,) [J].
        tank: E, (tools,) [J].
        seen: energy that the device has sent and that is credited, (tools,) [J].
        sent: energy sent to the device since the start, (tools,) [J].
        before: y at the start of the step, (tools, 4) [m].
        work: Σ τᵀŵ T, done on the proxy since the start, (tools,) [J].
        excess: largest `∫τᵀq̇ dt + Σ τᵀŵ T` so far: two-port passive if bounded, (tools,) [J].
    """

    device: Int
    origin: Float
    stiffness: Float
    damping: Float
    cap: Float
    set_position: Float
    spring: Float
    tank: Float
    seen: Float
    sent: Float
    before: Float
    work: Float
    excess: Float


def couplings(count: int) -> Couplings:
    """Room for the couplings of so many tools, none of which has a device yet."""
    line, row = (lambda: np.zeros(count)), (lambda: np.zeros((count, 4)))
    return Couplings(
        device=np.full(count, -1, dtype=np.int64),
        origin=row(),
        stiffness=line(),
        damping=line(),
        cap=line(),
        set_position=row(),
        spring=line(),
        tank=line(),
        seen=line(),
        sent=line(),
        before=row(),
        work=line(),
        excess=line(),
    )


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
    gap = load(state.sample, d, LANES) + load(couplings.origin, t, LANES) - place
    store(couplings.before, t, place, LANES)
    push = splat(0.0, LANES)
    if at(devices.servos.law, d) == TOLD:
        # k (q - y⁺) + b (v - ŵ): the end of the step rather than its middle is what makes half of k T damping.
        push = b * load(state.sample_velocity, d, LANES)
        b += 0.5 * k * T
        put(couplings.spring, t, 0.5 * k * total(gap * gap))
    else:
        gift = credit(at(state.sent, d), at(couplings.seen, t))
        put(couplings.seen, t, at(couplings.seen, t) + gift)
        available = at(couplings.spring, t) + at(couplings.tank, t) + gift
        potential = 0.5 * k * total(gap * gap)
        share, tank, sent = modulate(potential, available, at(couplings.cap, t))
        put(couplings.tank, t, tank)
        put(couplings.sent, t, at(couplings.sent, t) + sent)
        put(couplings.spring, t, share * share * potential)
        gap = share * gap
    target = place + gap
    store(couplings.set_position, t, target, LANES)
    put(tools.drive_stiffness, t, k)
    put(tools.drive_damping, t, b)
    store(tools.drive_start, t, target, LANES)
    store(tools.drive_end, t, target, LANES)
    store(tools.push, t, push, LANES)
    return finite


@part
def tell_device(devices: Devices, state: DeviceState, couplings: Couplings, tools: Tools, t: int, T: float) -> None:
    """Tells a tool's device where its proxy went in the step just taken, and with PSPM what energy is sent."""
    d = at(couplings.device, t)
    place, force = load(tools.place, t, LANES), load(tools.drive_force, t, LANES)
    moved = place - load(couplings.before, t, LANES)
    put(couplings.work, t, at(couplings.work, t) + total(force * moved))
    left = load(couplings.set_position, t, LANES) - place
    put(couplings.spring, t, 0.5 * at(couplings.stiffness, t) * total(left * left))
    store(state.wish, d, place - load(couplings.origin, t, LANES), LANES)
    if at(devices.servos.law, d) == TOLD:
        store(state.told, d, splat(0.0, LANES) - force, LANES)
    else:
        # What the damper took is the coupling's to spend again.
        put(couplings.tank, t, at(couplings.tank, t) + at(couplings.damping, t) / T * total(moved * moved))
        put(state.received, d, at(couplings.sent, t))
    both = at(state.books, (d, WORK)) + at(couplings.work, t)
    put(couplings.excess, t, max(at(couplings.excess, t), both))
