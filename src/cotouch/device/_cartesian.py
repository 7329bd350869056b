"""A device that moves its tip alike in all directions: mass, viscous and Coulomb friction, perhaps a hand."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.device._hand import LANES, add_to_ledger, book_hand, book_motors, correct, equilibrium_after
from cotouch.device._tables import COULOMB_LOSS, Devices, DeviceState
from cotouch.kernels import at, inner, load, part, splat, store, total


@inner
def cartesian_mass(devices: Devices, state: DeviceState, d: int) -> float:
    """Mass that moves, the hand's included [kg].

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    mass = at(devices.plants.mass, d)
    if at(state.holding, d) != 0:
        mass += at(devices.grasps.mass, d)
    return mass


@part
def cartesian_step(devices: Devices, state: DeviceState, d: int, h: float) -> None:
    """A Cartesian device for a time h, by the midpoint rule, whose energy balance is exact.

    Coulomb friction acts against v̂, at most with its own size. Where all else together is less, the device stops: the
    midpoint rule alone would go on with -v for ever. What it had is booked as friction.

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
        h: length of the step [s].
    """
    grasps = devices.grasps
    drag, rough = at(devices.plants.viscous, (d, 0)), at(devices.plants.coulomb, (d, 0))
    mass = cartesian_mass(devices, state, d)
    momentum, place = load(state.momentum, d, LANES), load(state.coordinate, d, LANES)
    effort = load(state.effort, d, LANES)
    stiffness, damping = 0.0, 0.0
    start = load(state.equilibrium, d, LANES)
    shift = splat(0.0, LANES)
    holding = at(state.holding, d) != 0
    if holding:
        stiffness, damping = at(grasps.stiffness, d), at(grasps.damping, d)
        correct(grasps, state, d, h)
        end = equilibrium_after(grasps, state, d, at(state.time, d) + h)
        shift = end - start
        store(state.equilibrium, d, end, LANES)
    aim = start + 0.5 * shift
    push = effort + stiffness * (aim - place) + (damping / h) * shift + (2.0 / h) * momentum
    gain = 1.0 / (2.0 * mass / h + drag + damping + 0.5 * h * stiffness)
    size = total(push * push) ** 0.5
    if rough > 0.0 and size <= rough:
        mean = splat(0.0, LANES)
        add_to_ledger(state, d, COULOMB_LOSS, 0.5 * total(momentum * momentum) / mass)
        momentum = splat(0.0, LANES)
    else:
        if rough > 0.0:
            gain *= 1.0 - rough / size
        mean = gain * push
        momentum = (2.0 * mass) * mean - momentum
        add_to_ledger(state, d, COULOMB_LOSS, h * rough * total(mean * mean) ** 0.5)
    motion = h * mean
    store(state.momentum, d, momentum, LANES)
    store(state.coordinate, d, place + motion, LANES)
    store(state.tip, d, place + motion, LANES)
    book_motors(state, d, total(effort * motion), h * drag * total(mean * mean))
    if holding:
        pull = stiffness * (aim - place - 0.5 * motion) + (damping / h) * (shift - motion)
        book_hand(grasps, state, d, h, total(pull * shift), total((shift - motion) * (shift - motion)))
