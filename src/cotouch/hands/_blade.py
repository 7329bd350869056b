"""A blade on a pointer or on command: put down where it is wanted, led like a hand, drawn back when it is let go."""

from collections.abc import Sequence
from typing import final

import numpy as np

from cotouch.body import Body
from cotouch.hands._led import LedTool
from cotouch.mechanics import BLADE, Tools
from cotouch.scenario import ToolTable

# Of the body's radius: how thick it is, how long if nobody says it, and the longest that it may be.
_THICK, _USUAL, _MOST = 0.01, 0.5, 4.0
_MASS = 0.05  # [kg]
# A change of its edge takes so long [s].
_TURN = 0.1
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
class Blade(LedTool):
    """An edge that cuts."""

    def __init__(self, tools: Tools, index: int, *, size: float) -> None:
        """Takes over a tool.

        Args:
            tools: of the copy.
            index: of the blade.
            size: radius of the body [m].
        """
        super().__init__(tools, index, BLADE)
        self._size = size
        self._edge = tools.axis[index, :3].copy()
        self._wanted = self._edge.copy()

    def want(self, edge: Sequence[float]) -> None:
        """Chooses its edge, from its place to the other end, (3,); 0: as it was [m]."""
        long = float(np.linalg.norm(edge))
        if long > 0.0:
            self._wanted = np.array(edge) * min(1.0, _MOST * self._size / long)

    def put(self, place: Sequence[float]) -> None:
        """Puts it down, (3,) [m]; only while it cuts nothing."""
        self._edge, self._tools.axis[self._t], self._tools.rate[self._t] = self._wanted.copy(), 0.0, 0.0
        self._put(place)

    def _change(self, T: float) -> None:
        self._edge += (self._wanted - self._edge) * min(1.0, T / _TURN)
        self._tools.axis[self._t, :3] = self.gain * self._edge  # it comes in, and goes out, the way that it points

    @property
    def edge(self) -> list[float]:
        """From its place to the other end of its edge, (3,) [m]."""
        return self._tools.axis[self._t, :3].tolist()
