"""What a step with tools came to: work and energies of contacts, drives and grasps, and where the proxies went."""
# pyright: reportArgumentType=false, reportReturnType=false

import numpy as np
import numpy.typing as npt

from cotouch.mechanics._grasp import held_place, held_rate
from cotouch.mechanics._kernel import part
from cotouch.mechanics._small import Small
from cotouch.mechanics._surface import Fit, Surface
from cotouch.mechanics._tools import DRIVE, MOST_HELD, PROXY, TOUCH_LOSS, TOUCH_STORED, TOUCHED, Tools

Float = npt.NDArray[np.float64]


@part
def settle_contacts(tools: Tools, small: Small, T: float, count: int, axes: int, touch_books: Float) -> None:
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
            touch_books[TOUCHED] -= T * force[j] * (rate[j] + proxy)
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
    touch_books: Float,
) -> None:
    """Forces, work and energies of drives and grasps; new places and velocities."""
    hold_row, rest, shape, moved = surface.hold_row, surface.rest, surface.shape, fit.place
    stiffness, damping, first_place, last_place = (
        tools.drive_stiffness,
        tools.drive_damping,
        tools.drive_start,
        tools.drive_end,
    )
    grip_stiffness, grip_damping, held, hold_of = tools.grip_stiffness, tools.grip_damping, tools.held, tools.hold
    grip_energy, account, touching_now, mass = tools.grip_energy, tools.account, tools.touching, tools.mass
    places, rates, offset, push = tools.place, tools.rate, tools.offset, tools.push
    drive_force, touch_force = tools.drive_force, tools.touch_force
    for t in range(tools.first, tools.last):
        p, k, b = t - tools.first, stiffness[t], damping[t]
        kb, bb = grip_stiffness[t], grip_damping[t]
        square = 0.0
        drive_force[t, 3] = 0.0
        if held[t] > 0:
            grip_energy[t] = 0.0
            touching_now[t] = held[t]
        for a in range(3):
            w = proxies[3 * p + a]
            start, end = first_place[t, a], last_place[t, a]
            force = k * (0.5 * (start + end) - places[t, a] - 0.5 * T * w) + b * ((end - start) / T - w) + push[t, a]
            drive_force[t, a] = force
            touch_books[DRIVE] += T * force * w
            for c in range(max(held[t], 0)):
                h = hold_of[t, c]
                before = held_place(hold_row, rest, moved, h, a, position) - places[t, a]
                before -= offset[t * MOST_HELD + c, a]
                v = held_rate(hold_row, shape, h, a, mean)
                pull = kb * (before + 0.5 * T * (v - w)) + bb * (v - w)  # on the proxy
                after = before + T * (v - w)
                touch_force[t, a] += pull
                grip_energy[t] += 0.5 * kb * after * after
                touch_books[TOUCHED] -= T * pull * v
                touch_books[TOUCH_LOSS] += T * bb * (v - w) * (v - w)
        for a in range(3):
            w = proxies[3 * p + a]
            places[t, a] += T * w
            rates[t, a] = 2.0 * w - rates[t, a]
            square += rates[t, a] * rates[t, a]
        touch_books[PROXY] += 0.5 * mass[t] * square
        touch_books[TOUCH_STORED] += account[t] + grip_energy[t]
