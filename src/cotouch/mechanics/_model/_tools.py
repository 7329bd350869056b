"""The proxies of a user: spheres that a coupling drives and that touch or hold the body."""

from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.passing import by_address

# What a tool does with the body.
AWAY, TOUCHING, GRASP, BLADE = 0, 1, 2, 3
# What tools book, in order: work of the drives on the proxies, work of contacts and grasps on the body, dissipated in
# contacts and grasps during the step; kinetic energy of the proxies, energy in contacts and grasps after it [J].
DRIVE, TOUCHED, TOUCH_LOSS, PROXY, TOUCH_STORED = range(5)
TOUCH_LEDGER = 5
# Nodes (or skin vertices in a modal basis) in one grasp.
MOST_HELD = 64
MOST_HELD_MODAL = 8


@by_address
class Tools(NamedTuple):
    """Proxies: position y, velocity w, mass m, NPMI like the body [Lee & Huang 2010, section II-B].

    Rows of four, the last column zero.

    Attributes:
        mass: (tools,) [kg].
        radius: of the sphere; of a blade half its thickness, (tools,) [m].
        stiffness: of a contact, (tools,) [N/m].
        loss: λ of a contact: its force grows by (1 + λ η'), (tools,) [s/m].
        friction: Coulomb's coefficient of what does not slip, (tools,).
        kinetic: the same of what slips, (tools,).
        viscosity: of the film on the skin: drag on each of its area, of each speed along it, (tools,) [Ns/m³].
        snap: pull-off force with which a flat draws a tool that is near; 0: it does not, (tools,) [N].
        snap_range: how far from the tool the skin draws it, (tools,) [m].
        snaps: whether it does: since it was out of this range, (tools,).
        well: energy in that, at most 0, (tools,) [J].
        owed: what it would have taken to pull it off when it was taken away, less what it paid of that since; it is
            not drawn before it paid all, (tools,) [J].
        axis: from the middle of a stylus to the middle of its tip, (tools, 4); 0 of a ball; of a blade its edge [m].
        stretch: of the spring of friction, (tools, 4) [m].
        slipping: whether it slipped in the last step, (tools,).
        share: of the contact's law that acts, in [0, 1]; below 1 until it lets go where something else than motion
            pressed it deeper, (tools,).
        grip_stiffness: k of every held node in a grasp, (tools,) [N/m].
        grip_damping: b of it, (tools,) [Ns/m].
        mode: AWAY, TOUCHING, GRASP or BLADE in this step, (tools,).
        drive_stiffness: k of the drive `τ = k (r̂ - ŷ) + b (ṙ̂ - ŵ) + push`, (tools,) [N/m].
        drive_damping: b, (tools,) [Ns/m].
        drive_start: r at the start of the step, (tools, 4) [m].
        drive_end: r at its end, (tools, 4) [m].
        push: explicit mean force, (tools, 4) [N].
        place: y, (tools, 4) [m].
        rate: w, (tools, 4) [m/s].
        stored: energy in the contact of each tool and its friction, or in the springs of its grasp, and what draws it
            to the skin, less what it owes, (tools,) [J].
        inside: 1: it has not been out of the skin yet, and does not touch, (tools,).
        held: how many nodes it holds; -1: it does not hold, (tools,).
        hold: which, (tools, MOST_HELD).
        offset: stretch-free place of each relative to y, less its rest place, (tools * MOST_HELD, 4) [m].
        drive_force: result: τ, (tools, 4) [N].
        touch_force: result: mean force of contact or grasp on the proxy, (tools, 4) [N].
        touching: result: 1 if the skin pushed, or how many nodes are held, (tools,).
        debt: of a blade: what it still has to pay for what it cut, (tools,) [J].
        drag: how much what it cuts, or owes, resists its motion in this step, (tools,) [Ns/m].
    """

    mass: Float
    radius: Float
    stiffness: Float
    loss: Float
    friction: Float
    kinetic: Float
    viscosity: Float
    snap: Float
    snap_range: Float
    snaps: Int
    well: Float
    owed: Float
    axis: Float
    stretch: Float
    slipping: Int
    share: Float
    grip_stiffness: Float
    grip_damping: Float
    mode: Int
    drive_stiffness: Float
    drive_damping: Float
    drive_start: Float
    drive_end: Float
    push: Float
    place: Float
    rate: Float
    stored: Float
    inside: Int
    held: Int
    hold: Int
    offset: Float
    drive_force: Float
    touch_force: Float
    touching: Int
    debt: Float
    drag: Float


def own_tools(held: Tools, first: int, last: int) -> Tools:
    """Those of one copy, in the memory of all.

    Args:
        held: tools of all copies.
        first: the copy's first.
        last: one past its last.
    """
    each = [array.shape[0] // max(held.mode.size, 1) for array in held]  # rows of a tool
    return Tools._make(array[first * rows : last * rows] for array, rows in zip(held, each, strict=True))


def tools(count: int) -> Tools:
    """Room for so many tools, all zero, holding nothing."""
    line, row = (lambda: np.zeros(count)), (lambda: np.zeros((count, 4)))
    whole = lambda: np.zeros(count, dtype=np.int32)  # noqa: E731
    return Tools(
        mass=np.ones(count),
        radius=np.full(count, 0.01),
        stiffness=line(),
        loss=line(),
        friction=line(),
        kinetic=line(),
        viscosity=line(),
        snap=line(),
        snap_range=line(),
        snaps=whole(),
        well=line(),
        owed=line(),
        axis=row(),
        stretch=row(),
        slipping=whole(),
        share=np.ones(count),
        grip_stiffness=line(),
        grip_damping=line(),
        mode=whole(),
        drive_stiffness=line(),
        drive_damping=line(),
        drive_start=row(),
        drive_end=row(),
        push=row(),
        place=row(),
        rate=row(),
        stored=line(),
        inside=np.ones(count, dtype=np.int32),
        held=np.full(count, -1, dtype=np.int32),
        hold=np.zeros((count, MOST_HELD), dtype=np.int32),
        offset=np.zeros((count * MOST_HELD, 4)),
        drive_force=row(),
        touch_force=row(),
        touching=whole(),
        debt=line(),
        drag=line(),
    )
