"""A ball on a pointer: a proxy that is put down outside the body, pushes its skin, and is let go."""

from collections.abc import Sequence
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.hands._motion import Mover
from cotouch.mechanics import AWAY, TOUCH, Tools
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
class Ball:
    """One proxy among a copy's tools, moved by whoever points.

    Attributes:
        radius: [m].
        gain: how much of the hand's spring draws it, 0 to 1; it touches while above 0.
    """

    def __init__(self, tools: Tools, index: int, body: Body, *, size: float) -> None:
        """Takes over a tool.

        Args:
            tools: of the copy.
            index: of the ball.
            body: the shared object.
            size: radius of the body [m].
        """
        self._tools, self._t, self._body, self._size = tools, index, body, size
        self._mover = Mover(3)
        self._wanted = self.radius = _USUAL * size
        self.gain = 0.0

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
        reached = resolve_penetration(self._body, displacement, where, self.radius)
        if reached is not None:
            where = reached[1]
        tools.radius[t] = self.radius
        tools.place[t, :3] = where
        tools.inside[t] = 1  # nobody looked yet
        self._mover.put(where.tolist())

    def move(
        self, goal: Sequence[float] | None, gain: float, T: float, *, stiffness: float, damping: float, **motion: float
    ) -> None:
        """What it does in the coming step.

        Args:
            goal: where it is drawn to, (3,) [m]; None: where it is.
            gain: how much of the hand's spring draws it, 0 to 1.
            T: length of the step [s].
            stiffness: of the hand [N/m].
            damping: of it [Ns/m].
            **motion: of `Mover.move`.
        """
        tools, t, mover = self._tools, self._t, self._mover
        self.gain = gain
        tools.push[t] = 0.0
        tools.drive_stiffness[t] = gain * stiffness
        tools.drive_damping[t] = damping  # also when it was let go, so that it comes to rest
        if gain > 0.0:
            tools.drive_start[t, :3] = mover.place
            most = self._size * T / _GROWTH
            self.radius += min(max(self._wanted - self.radius, -most), most)
            tools.radius[t] = self.radius
            mover.move(mover.place if goal is None else goal, T, **motion)
        else:  # the damper holds against where it is: to follow its own motion would keep it moving
            mover.put(tools.place[t, :3].tolist())
            tools.drive_start[t, :3] = mover.place
        tools.drive_end[t, :3] = mover.place
        tools.mode[t] = TOUCH if gain > 0.0 else AWAY

    @property
    def target(self) -> list[float]:
        """Where it is drawn to, (3,) [m]."""
        return self._mover.place

    @property
    def place(self) -> list[float]:
        """Where it is, (3,) [m]."""
        return self._tools.place[self._t, :3].tolist()

    @property
    def force(self) -> list[float]:
        """Of it on the body in the last step, (3,) [N]."""
        return (-self._tools.touch_force[self._t, :3]).tolist()
