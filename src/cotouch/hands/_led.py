"""A tool among a copy's that somebody leads: a hand's spring draws it while there is some of it."""

from collections.abc import Sequence

from cotouch.hands._motion import Mover
from cotouch.mechanics import AWAY, Tools


class LedTool:
    """One proxy, moved by whoever points; what it does to the body is its kind's.

    Attributes:
        gain: how much of it there is, 0 to 1; it acts while above 0.
    """

    def __init__(self, tools: Tools, index: int, mode: int) -> None:
        """Takes over a tool.

        Args:
            tools: of the copy.
            index: of it among them.
            mode: its mode while it acts.
        """
        self._tools, self._t, self._mode = tools, index, mode
        self._mover = Mover(3)
        self.gain = 0.0
        self._fresh = False

    def move(
        self, goal: Sequence[float] | None, gain: float, T: float, *, stiffness: float, damping: float, **motion: float
    ) -> None:
        """What it does in the coming step.

        Args:
            goal: where it is drawn to, (3,) [m]; None: where it is.
            gain: how much of it there is, 0 to 1.
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
            self._change(T)
            # In the step after a jump nothing pulls: to an audit it is a way, on which a force would do work.
            mover.move(mover.place if goal is None or self._fresh else goal, T, **motion)
            self._fresh = False
        else:  # the damper holds against where it is: to follow its own motion would keep it moving
            mover.put(tools.place[t, :3].tolist())
            tools.drive_start[t, :3] = mover.place
        tools.drive_end[t, :3] = mover.place
        tools.mode[t] = self._mode if gain > 0.0 else AWAY

    def _put(self, place: Sequence[float]) -> None:
        """Puts it somewhere, (3,) [m]; only while it does nothing."""
        self._tools.place[self._t, :3] = place
        self._mover.put(list(place))
        self._fresh = True

    def _change(self, T: float) -> None:
        """What changes of it, besides its place, in a step in which it acts."""
        raise NotImplementedError

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
