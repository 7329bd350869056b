"""What a step with tools came to: work and energies of contacts, drives and grasps, and where the proxies went."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.mechanics._grasp import held_place, held_rate
from cotouch.mechanics._kernel import part
from cotouch.mechanics._proxy import book_drive, move_proxy
from cotouch.mechanics._small import Small
from cotouch.mechanics._surface import Fit, Surface
from cotouch.mechanics._tools import MOST_HELD, TOUCH_LOSS, TOUCH_STORED, TOUCHED, Tools


@part
def settle_contacts(tools: Tools, small: Small, T: float, count: int, axes: int, touch_ledger: Float) -> None:
    """What the contacts' forces did in the step that came of them: to the body, and to the accounts."""
    first, touching_now, touch_force, account = tools.first, tools.touching, tools.touch_force, tools.account
    owner, force, direction, rate, mean = small.owner, small.force, small.direction, small.rate, small.mean
    for c in range(count):
        p = owner[c * axes]
        t = first + p
        if force[c * axes] > 0.0:
            touching_now[t] += 1
        for j in range(c * axes, c * axes + axes):
            proxy = 0.0
            for a in range(3):
                proxy += direction[j, a] * mean[3 * p + a]
                touch_force[t, a] += force[j] * direction[j, a]
            touch_ledger[TOUCHED] -= T * force[j] * (rate[j] + proxy)
            account[t] += T * force[j] * rate[j]


@part
def settle_tools(
    surface: Surface,
    fit: Fit,
    tools: Tools,
    proxies: Float,
    T: float,
    position: Float,
    mean: Float,
    touch_ledger: Float,
) -> None:
    """Forces, work and energies of drives and grasps; new places and velocities."""
    hold_row, rest, shape, moved = surface.hold_row, surface.rest, surface.shape, fit.place
    grip_stiffness, grip_damping, held, hold_of = tools.grip_stiffness, tools.grip_damping, tools.held, tools.hold
    grip_energy, account, touching_now = tools.grip_energy, tools.account, tools.touching
    places, offset, touch_force = tools.place, tools.offset, tools.touch_force
    for t in range(tools.first, tools.last):
        p, kb, bb = t - tools.first, grip_stiffness[t], grip_damping[t]
        if held[t] > 0:
            grip_energy[t] = 0.0
            touching_now[t] = held[t]
        for a in range(3):
            w = proxies[3 * p + a]
            book_drive(tools, t, a, T, w, touch_ledger)
            for c in range(max(held[t], 0)):
                h = hold_of[t, c]
                before = held_place(hold_row, rest, moved, h, a, position) - places[t, a]
                before -= offset[t * MOST_HELD + c, a]
                v = held_rate(hold_row, shape, h, a, mean)
                pull = kb * (before + 0.5 * T * (v - w)) + bb * (v - w)  # on the proxy
                after = before + T * (v - w)
                touch_force[t, a] += pull
                grip_energy[t] += 0.5 * kb * after * after
                touch_ledger[TOUCHED] -= T * pull * v
                touch_ledger[TOUCH_LOSS] += T * bb * (v - w) * (v - w)
        for a in range(3):
            move_proxy(tools, t, a, T, proxies[3 * p + a], touch_ledger)
        touch_ledger[TOUCH_STORED] += account[t] + grip_energy[t]
