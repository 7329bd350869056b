"""Simulated devices that lead rigid tools: what a coupling pulls is the port of a tool's handle."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

from cotouch.arrays import Float, Int
from cotouch.interaction._touching import Touching, after_step, before_step
from cotouch.kernels import FOUR, at, block, load, part, put, store
from cotouch.mechanics import Ports
from cotouch.passing import by_address


@by_address
class Leading(NamedTuple):
    """Devices of rigid tools, and what they lead.

    Attributes:
        touching: the devices with their couplings; its tools stand for the handles, one for each rigid tool, and touch
            nothing.
        port: of each handle, (tools,); what has no device has none.
        handle: where it is at rest, (tools, 4) [m].
    """

    touching: Touching
    port: Int
    handle: Float


@part
def _find(leading: Leading, ports: Ports, position: Float, t: int) -> None:
    """Looks where a handle is."""
    place, p = load(leading.handle, t, FOUR), at(leading.port, t)
    for i in range(position.shape[0]):
        share = at(ports.shape, (p, i))
        if share != 0.0:
            place = place + share * load(position, i, FOUR)
    store(leading.touching.tools.place, t, place, FOUR)


@part
def begin_lead(leading: Leading, ports: Ports, position: Float, i: int, end: float, T: float) -> bool:
    """What the devices of user i do in a step that ends at `end`: `before_step`, at the ports of handles.

    Args:
        leading: devices of all users; changed in place.
        ports: of all hands; those of handles are written.
        position: of the copy, (rows, width) [m].
        i: number of the user, from 0.
        end: of the step [s].
        T: its length [s].

    Returns:
        Whether all devices' motion is still within the range of floating point.
    """
    touching, tools = leading.touching, leading.touching.tools
    for t in range(at(touching.first, i), at(touching.first, i + 1)):
        if at(leading.port, t) >= 0:
            _find(leading, ports, position, t)
    finite = before_step(touching, i, end, T)
    for t in range(at(touching.first, i), at(touching.first, i + 1)):
        p = at(leading.port, t)
        if p >= 0:
            rest = load(leading.handle, t, FOUR)
            put(ports.stiffness, p, at(tools.drive_stiffness, t))
            put(ports.damping, p, at(tools.drive_damping, t))
            store(ports.start, p, load(tools.drive_start, t, FOUR) - rest, FOUR)
            store(ports.end, p, load(tools.drive_end, t, FOUR) - rest, FOUR)
            store(ports.push, p, load(tools.push, t, FOUR), FOUR)
    return finite


@part
def end_lead(leading: Leading, ports: Ports, position: Float, i: int) -> None:
    """Tells the devices of user i where handles went, and books what that took: `after_step`.

    Args:
        leading: devices of all users; changed in place.
        ports: of all hands, with their forces.
        position: of the copy, (rows, width) [m].
        i: number of the user, from 0.
    """
    touching = leading.touching
    for t in range(at(touching.first, i), at(touching.first, i + 1)):
        p = at(leading.port, t)
        if p >= 0:
            _find(leading, ports, position, t)
            store(touching.tools.drive_force, t, load(ports.force, p, FOUR), FOUR)
    after_step(touching, i)


@block
def begin_lead_alone(leading: Leading, ports: Ports, position: Float, i: int, end: float, T: float) -> bool:
    """`begin_lead` for a call from Python.

    Args:
        leading: see there, like all others.
        ports: likewise.
        position: likewise.
        i: likewise.
        end: likewise.
        T: likewise.
    """
    return begin_lead(leading, ports, position, i, end, T)


@block
def end_lead_alone(leading: Leading, ports: Ports, position: Float, i: int) -> None:
    """`end_lead` for a call from Python.

    Args:
        leading: see there, like all others.
        ports: likewise.
        position: likewise.
        i: likewise.
    """
    end_lead(leading, ports, position, i)
