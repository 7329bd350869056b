"""The tools of all users in a run: when they touch, what drives them, what they did."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.device import DEVICE_LEDGER, Couplings, Devices, DeviceState, account_energy, command_device, pull_proxy
from cotouch.interaction._hands import Hands, grip
from cotouch.kernels import FOUR, at, block, load, part, put, store
from cotouch.mechanics import AWAY, Contact, Ports, Surface, Tools, own_tools
from cotouch.passing import by_address


@by_address
class Touching(NamedTuple):
    """Everything that tools need in a run. Row t of every array of tools belongs to tool t, ordered by user.

    Attributes:
        surface: the body's skin.
        tools: the proxies.
        contact: the law by which they touch, and scratch.
        first: first tool of each user, (users + 1,).
        kind: what each does while it acts, TOUCHING or GRASP, (tools,).
        begin: it acts from here, (tools,) [s].
        release: to here, (tools,) [s].
        hands: drives of the tools without a device, one port for each tool.
        cursor: their waypoints, (tools,).
        drive: the drives of `tools`, as `grip` writes them.
        devices: the devices.
        states: where they are.
        couplings: which drives which tool.
        ledger: result of one step, (TOUCH_LEDGER,).
    """

    surface: Surface
    tools: Tools
    contact: Contact
    first: Int
    kind: Int
    begin: Float
    release: Float
    hands: Hands
    cursor: Int
    drive: Ports
    devices: Devices
    states: DeviceState
    couplings: Couplings
    ledger: Float


@by_address
class ToolRecord(NamedTuple):
    """What is kept of the tools; entry 0 is the start.

    Attributes:
        place: of the proxies, (tools, records, 4) [m].
        rate: (tools, records, 4) [m/s].
        force: mean force of contact or grasp on the proxy in the step, (tools, records, 4) [N].
        drive: mean force of what pulls the proxy, (tools, records, 4) [N].
        touching: 1 where the skin pushed, or how many nodes were held, (tools, records).
        device_place: measured place of the device in the body's frame, (tools, records, 4) [m].
        device_force: that its motors hold, (tools, records, 4) [N].
        device_ledger: (len(DEVICE_LEDGER), tools, records), see there.
        coupling: work of the coupling on the proxy; largest excess; what nobody pays for; what the proxy's end has,
            (4, tools, records) [J].
    """

    place: Float
    rate: Float
    force: Float
    drive: Float
    touching: Float
    device_place: Float
    device_force: Float
    device_ledger: Float
    coupling: Float


def tool_record(count: int, records: int) -> ToolRecord:
    """Room for a record.

    Args:
        count: of tools.
        records: of each tool.
    """
    rows = [np.zeros((count, records, 4)) for _ in range(6)]
    return ToolRecord(
        place=rows[0],
        rate=rows[1],
        force=rows[2],
        drive=rows[3],
        touching=np.zeros((count, records)),
        device_place=rows[4],
        device_force=rows[5],
        device_ledger=np.zeros((len(DEVICE_LEDGER), count, records)),
        coupling=np.zeros((4, count, records)),
    )


@part
def before_step(touching: Touching, i: int, end: float, T: float) -> bool:
    """What the tools of user i do in a step that ends at `end`; their devices advance to then.

    Args:
        touching: tools and devices of all users; changed in place.
        i: number of the user, from 0.
        end: of the step [s].
        T: length of the step [s].

    Returns:
        Whether all devices' motion is still within the range of floating point.
    """
    tools, hands = touching.tools, touching.hands
    middle = end - 0.5 * T
    finite = True
    for t in range(at(touching.first, i), at(touching.first, i + 1)):
        acts = at(touching.begin, t) <= middle < at(touching.release, t)
        put(tools.mode, t, at(touching.kind, t) if acts else AWAY)
        if at(touching.couplings.device, t) >= 0:
            fine = pull_proxy(touching.devices, touching.states, touching.couplings, tools, t, end, T)
            finite = finite and fine
        else:
            grip(hands, touching.drive, touching.cursor, t, end, T, FOUR)
    return finite


@part
def after_step(touching: Touching, i: int) -> None:
    """Tells the devices of user i what came of the step.

    Args:
        touching: tools and devices of all users; changed in place.
        i: number of the user, from 0.
    """
    for t in range(at(touching.first, i), at(touching.first, i + 1)):
        if at(touching.couplings.device, t) >= 0:
            command_device(touching.devices, touching.states, touching.couplings, touching.tools, t)


@block
def before_step_alone(touching: Touching, i: int, end: float, T: float) -> bool:
    """`before_step` for a call from Python.

    Args:
        touching: tools and devices of all users; changed in place.
        i: number of the user, from 0.
        end: of the step [s].
        T: length of the step [s].
    """
    return before_step(touching, i, end, T)


@block
def after_step_alone(touching: Touching, i: int) -> None:
    """`after_step` for a call from Python.

    Args:
        touching: tools and devices of all users; changed in place.
        i: number of the user, from 0.
    """
    after_step(touching, i)


def tools_of(touching: Touching, i: int) -> Tools:
    """The tools of one user, in the arrays of all.

    Args:
        touching: tools and devices of all users; changed in place.
        i: number of the user, from 0.
    """
    return own_tools(touching.tools, int(touching.first[i]), int(touching.first[i + 1]))


@part
def proxy_energy(touching: Touching, i: int) -> float:
    """Kinetic energy of a user's proxies [J].

    Args:
        touching: tools and devices of all users; changed in place.
        i: number of the user, from 0.
    """
    energy = 0.0
    for t in range(at(touching.first, i), at(touching.first, i + 1)):
        for axis in range(3):
            energy += 0.5 * at(touching.tools.mass, t) * at(touching.tools.rate, (t, axis)) ** 2
    return energy


@part
def keep_tools(record: ToolRecord, touching: Touching, i: int, entry: int) -> None:
    """Records the tools of one user.

    Args:
        record: written to.
        touching: tools and devices of all users; changed in place.
        i: number of the user, from 0.
        entry: row of the record.
    """
    tools, couplings, states = touching.tools, touching.couplings, touching.states
    records = record.touching.shape[1]
    for t in range(at(touching.first, i), at(touching.first, i + 1)):
        here = t * records + entry
        store(record.place, here, load(tools.place, t, FOUR), FOUR)
        store(record.rate, here, load(tools.rate, t, FOUR), FOUR)
        store(record.force, here, load(tools.touch_force, t, FOUR), FOUR)
        store(record.drive, here, load(tools.drive_force, t, FOUR), FOUR)
        put(record.touching, (t, entry), float(at(tools.touching, t)))
        d = at(couplings.device, t)
        if d >= 0:
            store(record.device_place, here, load(states.sample, d, FOUR) + load(couplings.origin, t, FOUR), FOUR)
            store(record.device_force, here, load(states.force, d, FOUR), FOUR)
            for book in range(record.device_ledger.shape[0]):
                put(record.device_ledger, (book, t, entry), at(states.ledger, (d, book)))
            put(record.coupling, (0, t, entry), at(couplings.work, t))
            put(record.coupling, (1, t, entry), at(couplings.excess, t))
            put(record.coupling, (2, t, entry), at(couplings.unpaid, t))
            put(record.coupling, (3, t, entry), account_energy(couplings, states, t))
