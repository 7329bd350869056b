"""Tools that neither touch nor hold, beside tools that are bodies: the copy takes the closed step, and they go alone.

What a blade cuts is told by where it was and is; it touches nothing.
"""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import block, inner
from cotouch.mechanics._contact._near import forget_rows
from cotouch.mechanics._contact._proxy import book_drive, move_proxy, pay, proxy_drive, proxy_inertia
from cotouch.mechanics._contact._work import Contact
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._meeting._bodies import Meeting
from cotouch.mechanics._meeting._world import World
from cotouch.mechanics._model._tools import BLADE, GRASP, TOUCHING, Tools


@inner
def _know_bodies(m: Meeting | None) -> bool:
    return m is not None and m.away >= 0


@inner
def _know(world: World | None) -> bool:
    return world is not None and _know_bodies(world.bodies)


@block
def are_apart(force: BodyForce | None, tools: Tools) -> bool:
    """Whether a copy that may hold tools that are bodies takes the closed step, as no other tool does anything in it.

    Args:
        force: inside the body; None: it is linear.
        tools: of one user.
    """
    if force is None:
        return False
    apart = _know(force.world)
    for t in range(tools.mode.shape[0]):
        acts = tools.mode[t] in (TOUCHING, GRASP) or tools.held[t] >= 0
        apart = apart and not acts and tools.stored[t] == 0.0 and tools.owed[t] == 0.0
    return apart


@block
def move_apart(contact: Contact | None, tools: Tools, T: float, touch_ledger: Float, lanes: tuple[int, ...]) -> None:
    """Moves tools that `are_apart`.

    Args:
        contact: by which they touch in other steps; None: in none.
        tools: of one user; changed in place.
        T: length of the step, > 0 [s].
        touch_ledger: result (TOUCH_LEDGER,): see `cotouch.mechanics.TOUCH_LEDGER`.
        lanes: fixes the width of a row.
    """
    if contact is not None:
        forget_rows(contact.work, lanes)
    for book in range(touch_ledger.shape[0]):
        touch_ledger[book] = 0.0
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] != BLADE:
            tools.drag[t] = 0.0
        inertia = proxy_inertia(tools, t, T)
        for a in range(3):
            w = proxy_drive(tools, t, a, T) / inertia
            tools.touch_force[t, a] = 0.0
            pay(tools, t, a, T, w, touch_ledger)
            book_drive(tools, t, a, T, w, touch_ledger)
            move_proxy(tools, t, a, T, w, touch_ledger)
