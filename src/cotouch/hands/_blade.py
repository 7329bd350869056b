"""A blade on a pointer or on command: put down where it is wanted, led like a hand, drawn back when it is let go."""

from collections.abc import Sequence
from typing import final

import numpy as np

from cotouch.body import Body
from cotouch.hands._motion import Mover
from cotouch.mechanics import AWAY, BLADE, Tools
from cotouch.scenario import ToolTable

# Of the body's radius: how thick it is, how long if nobody says it, and the longest that it may be.
_THICK, _USUAL, _MOST = 0.01, 0.5, 4.0
_MASS = 0.05  # [kg]
# Before any time that a session knows [s].
_NEVER = 1e9


def blade_table(slot: int, body: Body, *, size: float) -> ToolTable:
    """The blade as a tool that never begins by itself.

    Args:
        slot: whose.
        body: the shared object.
        size: its radius [m].
    """
    return ToolTable(
        user=slot + 1,
        at=body.rest.max(axis=0).tolist(),
        kind="blade",
        axis=[0.0, 0.0, -_USUAL * size],
        thickness=_THICK * size,
        mass=_MASS,
        begin=_NEVER,
    )


@final
class Blade:
    """One blade among a copy's tools, moved by whoever points.

    Attributes:
        gain: how much of its edge and of the hand's spring there is, 0 to 1; it cuts while above 0.
    """

    def __init__(self, tools: Tools, index: int, *, size: float) -> None:
        """Takes over a tool.

        Args:
            tools: of the copy.
            index: of the blade.
            size: radius of the body [m].
        """
        self._tools, self._t, self._size = tools, index, size
        self._mover = Mover(3)
        self._edge = tools.axis[index, :3].copy()
        self._wanted = self._edge.copy()
        self.gain = 0.0

    def want(self, edge: Sequence[float]) -> None:
        """Chooses its edge, from its place to the other end, (3,); 0: as it was [m]."""
        long = float(np.linalg.norm(edge))
        if long > 0.0:
            self._wanted = np.array(edge) * min(1.0, _MOST * self._size / long)

    def put(self, place: Sequence[float]) -> None:
        """Puts it down, (3,) [m]; only while it cuts nothing."""
        tools, t = self._tools, self._t
        self._edge = self._wanted.copy()
        tools.place[t, :3], tools.rate[t], tools.axis[t] = place, 0.0, 0.0
        self._mover.put(list(place))

    def move(
        self, goal: Sequence[float] | None, gain: float, T: float, *, stiffness: float, damping: float, **motion: float
    ) -> None:
        """What it does in the coming step.

        Args:
            goal: where its place is drawn to, (3,) [m]; None: where it is.
            gain: how much of its edge and of the hand's spring there is, 0 to 1.
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
            self._edge += (self._wanted - self._edge) * min(1.0, T / 0.1)
            tools.axis[t, :3] = gain * self._edge  # it comes in, and goes out, the way that it points
            mover.move(mover.place if goal is None else goal, T, **motion)
        else:
            mover.put(tools.place[t, :3].tolist())
            tools.drive_start[t, :3] = mover.place
        tools.drive_end[t, :3] = mover.place
        tools.mode[t] = BLADE if gain > 0.0 else AWAY

    @property
    def target(self) -> list[float]:
        """Where its place is drawn to, (3,) [m]."""
        return self._mover.place

    @property
    def place(self) -> list[float]:
        """Where it is, (3,) [m]."""
        return self._tools.place[self._t, :3].tolist()

    @property
    def edge(self) -> list[float]:
        """From there to the other end of its edge, (3,) [m]."""
        return self._tools.axis[self._t, :3].tolist()

    @property
    def force(self) -> list[float]:
        """Of it on the body in the last step, (3,) [N]."""
        return (-self._tools.touch_force[self._t, :3]).tolist()
