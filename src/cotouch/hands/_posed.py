"""Rigid tools that somebody leads: a hand's springs draw each to a pose while there is some of them."""

from collections.abc import Sequence
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.body import frame_of, shares_of
from cotouch.hands._motion import Mover
from cotouch.hands._turning import Turner, nearest_to, turned
from cotouch.haptics import turn_of
from cotouch.mechanics import Model, Ports
from cotouch.scenario import RigidTool, rows_of

# How fast one may turn [rad/s], how closely it follows [1/s], and how fast that changes [rad/s²], by command and by
# pointer: see `Mover`.
_TURNING = ({"speed": 6.0, "sharpness": 8.0, "rush": 200.0}, {"speed": 12.0, "sharpness": 60.0, "rush": 1000.0})


@final
class _PosedTool:
    """One of them."""

    def __init__(self, tool: RigidTool, ports: Ports, model: Model) -> None:
        assert tool.part.tool is not None
        assert tool.hand is not None
        self._ports, self._own, self._hand, self._handle = ports, tool.ports, tool.hand, tool.handle
        self._rest, self._rows = tool.part.rest(), rows_of(tool.part, model)
        self._arms = np.array(tool.part.tool.grips) - tool.handle
        self._at = shares_of(self._rest, tool.handle[None])[0]
        self._place, self._turn = Mover(3), Turner()
        self.goal = self._place.place, self._turn.turn

    def stay(self, position: Float) -> None:
        """Is drawn to where it is: its springs are relaxed."""
        masses = self._rest + position[self._rows, :3]
        self._place.put((self._at @ masses).tolist())
        self._turn.put(nearest_to(frame_of(masses) @ np.linalg.inv(frame_of(self._rest))))

    def rest_here(self, position: Float) -> None:
        """As `stay`, and it is to stay there."""
        self.stay(position)
        self.goal = self._place.place, self._turn.turn

    def move(self, gain: float, T: float, *, pointed: bool, **motion: float) -> None:
        ports, own = self._ports, self._own
        ports.start[own, :3] = self._held()
        self._place.move(self.goal[0], T, **motion)
        self._turn.move(self.goal[1], T, **_TURNING[pointed])
        ports.end[own, :3] = self._held()
        ports.push[own] = 0.0
        ports.stiffness[own] = 0.25 * gain * self._hand.stiffness
        ports.damping[own] = 0.25 * gain * self._hand.damping

    def brake(self) -> None:
        """Is let go, and comes to rest: nothing else would stop what weighs nothing."""
        ports, own = self._ports, self._own
        ports.start[own], ports.end[own], ports.push[own] = 0.0, 0.0, 0.0
        ports.stiffness[own], ports.damping[own] = 0.0, 0.25 * self._hand.damping

    def _held(self) -> Float:
        """How far what holds it has gone from its start, (4, 3) [m]."""
        return np.array(self._place.place) + turned(self._turn.turn, self._arms) - self._arms - self._handle

    def shown(self, position: Float) -> tuple[list[float], list[float], list[float]]:
        goal = self._handle + self._ports.end[self._own, :3].mean(axis=0)
        place = self._at @ (self._rest + position[self._rows, :3])
        return goal.tolist(), place.tolist(), self._ports.force[self._own, :3].sum(axis=0).tolist()


@final
class PosedTools:
    """The rigid tools of one user that a hand holds; those that nobody leads stay where they are.

    Attributes:
        gain: how much of the hands there is, 0 to 1; they act while above 0.
        count: how many there are.
        led: which was led last.
    """

    def __init__(self, tools: Sequence[RigidTool], ports: Ports, model: Model) -> None:
        """Takes over tools.

        Args:
            tools: of the user.
            ports: of the copy, among them those that hold tools.
            model: the body in the kernels' form.
        """
        self._tools = [_PosedTool(tool, ports, model) for tool in tools if tool.hand is not None]
        self.gain, self.count, self.led = 0.0, len(self._tools), 0

    @property
    def act(self) -> bool:
        """Whether any of them is held so."""
        return self.gain > 0.0

    def want(self, which: int, place: Sequence[float], turn: Sequence[float], position: Float) -> None:
        """Chooses a pose for one; if none was held so, all others stay where they are.

        Args:
            which: from 0.
            place: where its handle is to be, (3,) [m].
            turn: from its start: along the axis of turning, as long as the angle, (3,) [rad].
            position: of the copy, (rows, width) [m].
        """
        if not self.act:
            for tool in self._tools:
                tool.rest_here(position)
        self._tools[which].goal, self.led = (list(place), turn_of(turn)), which

    def move(self, gain: float, T: float, position: Float, *, pointed: bool, **motion: float) -> None:
        """What they do in the coming step.

        Args:
            gain: how much of the hands there is, 0 to 1.
            T: length of the step [s].
            position: of the copy, (rows, width) [m].
            pointed: whether a pointer leads, as quickly as a wrist.
            **motion: of `Mover.move`.
        """
        for tool in self._tools:
            if self.gain == 0.0:
                tool.stay(position)
            tool.move(gain, T, pointed=pointed, **motion)
        self.gain = gain

    def brake(self) -> None:
        """Lets all of them go, which come to rest."""
        for tool in self._tools:
            tool.brake()

    def shown(self, which: int, position: Float) -> tuple[list[float], list[float], list[float]]:
        """Where a tool's springs draw its handle, where that is [m], and the force of its hand on it [N].

        Args:
            which: from 0.
            position: of the copy, (rows, width) [m].
        """
        return self._tools[which].shown(position)
