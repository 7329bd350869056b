"""A ball on a pointer: a proxy that is put down outside the body, pushes its skin, and is let go."""

from collections.abc import Sequence
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.hands._led import LedTool
from cotouch.mechanics import TOUCHING, Tools
from cotouch.scenario import ToolTable, resolve_penetration

# Of the body's radius: the ball's, if nobody says how large it is, and the least and most that it may be.
_USUAL, _LEAST, _MOST = 0.15, 0.03, 0.6
_MASS = 0.05  # [kg]
# A contact is so many times as stiff as the hand: it is the hand that is to give way.
_CONTACT = 5.0
_FRICTION = 0.5
# A change of radius takes so long for a whole one [s].
_GROWTH = 0.3
# Before any time that a session knows [s].
_NEVER = 1e9


def ball_table(slot: int, body: Body, *, size: float, stiffness: float) -> ToolTable:
    """The ball as a tool that never begins by itself.

    Args:
        slot: whose.
        body: the shared object.
        size: its radius [m].
        stiffness: of the hand [N/m].
    """
    return ToolTable(
        user=slot + 1,
        at=body.rest.max(axis=0).tolist(),
        radius=_USUAL * size,
        mass=_MASS,
        stiffness=_CONTACT * stiffness,
        friction=_FRICTION,
        begin=_NEVER,
    )


@final
class Ball(LedTool):
    """A sphere that presses.

    Attributes:
        radius: [m].
    """

    def __init__(self, tools: Tools, index: int, body: Body, user: int, *, size: float) -> None:
        """Takes over a tool.

        Args:
            tools: of the copy.
            index: of the ball.
            body: the shared object.
            user: whose it is, from 0.
            size: radius of the body [m].
        """
        super().__init__(tools, index, TOUCHING)
        self._body, self._user, self._size = body, user, size
        self._wanted = self.radius = _USUAL * size

    def want(self, radius: float) -> None:
        """Chooses how large it is; 0: as usual [m]."""
        least, most = _LEAST * self._size, _MOST * self._size
        self._wanted = min(max(radius, least), most) if radius > 0.0 else _USUAL * self._size

    def put(self, place: Sequence[float], displacement: Float) -> None:
        """Puts it down, at the nearest place outside the body; only while it touches nothing.

        Args:
            place: of its middle, (3,) [m].
            displacement: of the body's nodes, (n, 3) [m].
        """
        tools, t = self._tools, self._t
        self.radius = self._wanted
        where = np.array(place, dtype=np.float64)
        reached = resolve_penetration(self._body, displacement, where, self.radius, self._user)
        if reached is not None:
            where = reached[1]
        tools.radius[t] = self.radius
        tools.inside[t] = 1  # nobody looked yet
        self._put(where.tolist())

    def _change(self, T: float) -> None:
        most = self._size * T / _GROWTH
        self.radius += min(max(self._wanted - self.radius, -most), most)
        self._tools.radius[self._t] = self.radius
