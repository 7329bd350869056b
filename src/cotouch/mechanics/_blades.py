"""Blades by themselves: what they cut is told by where they were and are, and they touch nothing."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.mechanics._kernel import block
from cotouch.mechanics._proxy import book_drive, move_proxy, pay, proxy_drive, proxy_inertia
from cotouch.mechanics._tools import Tools


@block
def move_blades(tools: Tools, T: float, touch_ledger: Float) -> None:
    """Moves blades, or tools that do nothing, beside a copy whose step knows of no contact by a law.

    Args:
        tools: of one user, none of which touches or holds; changed in place.
        T: length of the step, > 0 [s].
        touch_ledger: result (TOUCH_BOOKS,): see `cotouch.mechanics.TOUCH_LEDGER`.
    """
    for book in range(touch_ledger.shape[0]):
        touch_ledger[book] = 0.0
    for t in range(tools.mode.shape[0]):
        inertia = proxy_inertia(tools, t, T)
        for a in range(3):
            w = proxy_drive(tools, t, a, T) / inertia
            tools.touch_force[t, a] = 0.0
            pay(tools, t, a, T, w, touch_ledger)
            book_drive(tools, t, a, T, w, touch_ledger)
            move_proxy(tools, t, a, T, w, touch_ledger)
