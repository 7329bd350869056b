"""A hand that can be told what to do while it holds the object: by a pointer, or in a word.

Whatever it is told, its forces come from springs and dampers that begin relaxed, move no faster than a hand does, and
grow or fade within a moment. So nothing jerks, and the ledger of the copy stays exact: a port's work is the work of its
force, however its spring changes between two steps.
"""

from collections.abc import Callable, Sequence
from typing import final

import numpy as np

from cotouch.arrays import Array, Float, Int
from cotouch.hands._ball import Ball, ball_table
from cotouch.hands._blade import Blade, blade_table
from cotouch.hands._led import LedTool
from cotouch.hands._motion import Mover, Wander
from cotouch.hands._posed import PosedTools
from cotouch.hands._shown import write_hand
from cotouch.interaction import grip
from cotouch.mechanics import AWAY
from cotouch.members import Slot, SlotHand, grips_of, no_ports
from cotouch.observers import HandCommand, HandMode, size_of
from cotouch.scenario import RigidTool, Scenario, ports_of, with_tools

# A pointer that holds or pushes and is not heard of for so long has gone [s].
SILENCE = 1.0
# A hand without one in the session's file [N/m], and its damping per stiffness [s].
_STIFFNESS = 100.0
_DAMPING = 0.03
# How much stiffer than usual a pointer may be.
_MOST = 20.0
# A spring grows to its whole stiffness in so long, one of the file after an absence slower, and fades [s].
_GROW, _RETURN, _FADE = 0.05, 0.5, 0.1
# How fast places move, in radii of the body in a second, how closely they follow [1/s], and how fast they speed up, in
# radii in a square second: see `Mover`.
_POINTED, _PULLED = (12.0, 120.0, 200.0), (2.0, 8.0, 200.0)
# Modes that lead a blade, and how fast each does.
_CUTTING: dict[HandMode, tuple[float, float, float]] = {"blade": _POINTED, "cut": _PULLED}
# How far it wanders, in radii.
_REACH = 0.5
_HOLDING: frozenset[HandMode] = frozenset({"hold", "pull", "wander", "grab"})
_BY_POINTER: frozenset[HandMode] = frozenset({"grab", "ball", "blade"})


def usual_stiffness(scenario: Scenario, slot: int) -> float:
    """Stiffness of a slot's hand: that of its first hand in the session's file, otherwise 100 N/m [N/m].

    Args:
        scenario: of the session.
        slot: the user's.
    """
    own = next((hand for hand in scenario.hands if hand.user == slot + 1), None)
    return own.stiffness if own is not None and own.kind == "spring" and own.stiffness > 0.0 else _STIFFNESS


@final
class CommandedHand(SlotHand):
    """The hand of one slot.

    Attributes:
        mode: what it does, see `HandMode`.
        received: number of the newest pointer; 0 before the first.
        usual: stiffness unless somebody asks for another [N/m].
    """

    def __init__(
        self, at: Slot, *, scripted: bool = True, requests: Callable[[], HandCommand | None] = lambda: None
    ) -> None:
        """Begins with what the session's file says, or free.

        Args:
            at: the copy.
            scripted: whether it begins with what the file says.
            requests: gives an order that was not given before; asked before every step.

        Raises:
            ScenarioError: a hand, tool or device of the file is wrong.
        """
        scenario, body, model, slot = at.scenario, at.body, at.model, at.index
        super().__init__(model, slot)
        users, axes = scenario.network.size, body.dimension
        own = [hand for hand in scenario.hands if hand.user == slot + 1]
        self._hands, ports = ports_of(own, users, body, model)
        rigid: list[RigidTool] = []
        if body.tools:
            self._hands, _, rigid = with_tools(self._hands, ports, scenario.rigid_tools, model, slot)
        self._each = axes if model.full else 1  # ports of a hand
        self._held = [hand.node - 1 for hand in own]
        self._node = self._held[0] if own else 0
        self._first = first = self._hands.row.size  # port of what can be told
        self.ports = no_ports(model, [*self._hands.row.tolist(), *model.port_rows(self._node).tolist()])
        if self.ports.shape.shape[0]:
            self.ports.shape[:first] = self._hands.shape
        self._posed = PosedTools(rigid, self.ports, model)
        self._scripted_nodes = [node for node in self._held for _ in range(self._each)] + grips_of(body, slot)
        self.nodes = [*self._scripted_nodes, *[self._node] * self._each]
        assert self.ports.row.size == first + self._each
        self._cursor, self._lanes = self._hands.path_first[:-1].copy(), model.lanes
        self._body, self._model, self._axes = body, model, axes
        self._order = None if model.order is None else np.argsort(model.order)
        self.usual = usual_stiffness(scenario, slot)
        self._ratio = own[0].damping / self.usual if own and own[0].damping > 0.0 else _DAMPING
        self._stiffness = self._wanted_stiffness = self.usual
        self._size = size_of(body)
        self._mover, self._wander = Mover(axes), Wander(axes, reach=_REACH * self._size, seed=slot)
        self._goal: list[float] = [0.0] * axes
        self._ball: Ball | None = None
        self._blade: Blade | None = None
        tables = [tool for tool in scenario.proxies if tool.user == slot + 1]
        skinned = body.skin is not None
        balls = [ball_table(slot, body, size=self._size, stiffness=self.usual)] if skinned else []
        cutting = body.cut_count > 0
        cutting &= scenario.cutting is None or scenario.cutting.may(slot + 1)
        blades = [blade_table(slot, body, size=self._size)] if cutting else []
        touching = self._take_up(at, [*tables, *balls, *blades])
        if touching is not None and balls:
            self._ball = Ball(touching.tools, len(tables), body, slot, size=self._size)
        if touching is not None and blades:
            self._blade = Blade(touching.tools, len(tables) + len(balls), size=self._size)
        self._tabled = bool(tables)
        self._drawn = [t for t, tool in enumerate(tables) if tool.device is None]  # tools that no device moves
        self._blades = {t for t, tool in enumerate(tables) if tool.kind == "blade"}
        self._slots = [*(("hand", h) for h in range(len(own))), *(("tool", t) for t in range(len(tables)))]
        self._slots += [("rigid", k) for k in range(self._posed.count)]
        self.mode: HandMode = "script" if scripted else "free"
        self.received = 0
        self._script, self._grasp = float(scripted), 0.0  # how much of each there is
        self._wanted = self._node
        self._silent = 0.0
        self._pointed = False  # whether a pointer gave the last order
        self._requests = requests
        self._position: Float | None = None

    def attach(self, position: Float) -> None:
        """Learns where the copy is, (rows, width), changed in place; before that it takes no orders."""
        self._position = position

    def before(self, end: float, T: float) -> None:
        """Does what it is to do in this step.

        Args:
            end: of the step [s].
            T: length of the step [s].
        """
        request = self._requests() if self._position is not None else None
        if request is not None:
            self._silent = 0.0
            self._take(request)
        elif self.mode in _BY_POINTER or (self.mode == "pose" and self._pointed):
            self._silent += T
            if self._silent > SILENCE:
                self.mode = "free"
        self._follow_script(end, T)
        self._pose(T)
        self._hold(end, T)
        if self._ball is not None:
            self._lead(self._ball, self.mode == "ball", T, _POINTED)
        if self._blade is not None:
            self._lead(self._blade, self.mode in _CUTTING, T, _CUTTING.get(self.mode, _POINTED))

    def after(self) -> None:
        """Tells the devices of the file what came of the step."""
        if self._tabled:
            super().after()

    def show(self, fields: dict[str, Array]) -> None:
        """Writes what it does into a mailbox's fields; see `view_fields`."""
        fields["received"][()] = self.received
        slots = self._slots if self._script > 0.0 else self._slots[:1]
        fields["hands"][()] = max(1, len(slots))
        self._show_first(fields)
        for k, (kind, index) in enumerate(slots[1:], start=1):
            self._show_scripted(fields, k, kind, index)

    # -- orders ------------------------------------------------------------------------------------------------------

    def _take(self, request: HandCommand) -> None:
        """Begins with what it is told."""
        self.received = request.pointer or self.received
        self._pointed = request.pointer > 0
        lacks = (request.mode == "ball" and self._ball is None) or (request.mode in _CUTTING and self._blade is None)
        lacks |= request.mode == "pose" and max(request.node, 0) >= self._posed.count
        mode = "free" if lacks else request.mode
        if request.stiffness > 0.0:
            self._wanted_stiffness = min(request.stiffness, _MOST * self.usual)
        if mode in _HOLDING:
            self._wanted = request.node if 0 <= request.node < self._body.holds else self._node
        target = list(request.target)
        if mode == "hold" and (self.mode != "hold" or request.node >= 0):
            self._goal = self._where(self._wanted)
        elif mode in {"pull", "grab"}:
            self._goal = target[: self._axes]
        elif mode == "ball" and self._ball is not None:
            self._goal = target
            self._ball.want(request.radius)
            if self._ball.gain == 0.0:
                assert self._position is not None
                self._ball.put(target, self._model.to_nodes(self._position))
        elif mode in _CUTTING and self._blade is not None:
            self._goal = target
            self._blade.want(request.edge)
            if self._blade.gain == 0.0:
                self._blade.put(request.start)
        elif mode == "pose":
            assert self._position is not None
            self._posed.want(max(request.node, 0), target, request.turn, self._position)
        self.mode = mode

    def _follow_script(self, end: float, T: float) -> None:
        """Hands and tools of the file, as far as they act."""
        fraction = self._script = _toward(self._script, self.mode == "script" and not self._posed.act, T, _RETURN)
        ports, first = self.ports, self._first
        for port in range(first):
            grip(self._hands, ports, self._cursor, port, end, T, self._lanes)
        if fraction < 1.0:
            ports.stiffness[:first] *= fraction
            ports.damping[:first] *= fraction
            ports.push[:first] *= fraction
        if fraction == 0.0:
            self._posed.brake()
        if self._touching is None or not self._tabled:
            return
        super().before(end, T)
        if fraction < 1.0:
            tools = self._touching.tools
            for t in self._drawn:
                tools.drive_stiffness[t] *= fraction
                tools.push[t] *= fraction
                if fraction == 0.0:
                    tools.mode[t] = AWAY

    def _pose(self, T: float) -> None:
        """Rigid tools that are led, once what the file says of them has faded."""
        there, pointed = self.mode == "pose" and self._script == 0.0, self._pointed
        speed, sharpness, rush = _POINTED if pointed else _PULLED
        if self._posed.act or there:
            assert self._position is not None
            gain = _toward(self._posed.gain, there, T, _GROW)
            motion = {"speed": speed * self._size, "sharpness": sharpness, "rush": rush * self._size}
            self._posed.move(gain, T, self._position, pointed=pointed, **motion)

    def _hold(self, end: float, T: float) -> None:
        """The spring at the node that was chosen."""
        holding = self.mode in _HOLDING
        if holding and self._grasp == 0.0:
            self._reach_for(self._wanted)
        self._grasp = _toward(self._grasp, holding and self._node == self._wanted, T, _GROW)
        ports, port, axes, mover = self.ports, self._first, self._axes, self._mover
        span = slice(port, None)
        self._stiffness += (self._wanted_stiffness - self._stiffness) * min(1.0, T / _FADE)
        stiffness = self._grasp * self._stiffness
        ports.stiffness[span] = stiffness
        ports.damping[span] = self._ratio * stiffness
        if self._grasp == 0.0:
            return
        rest = self._body.held_rest[self._node].tolist()
        start = [a - b for a, b in zip(mover.place, rest, strict=True)]
        if holding:
            goal = self._goal
            if self.mode == "wander":
                goal = [a + b for a, b in zip(rest, self._wander.at(end), strict=True)]
            self._go(mover, goal, T, _POINTED if self.mode == "grab" else _PULLED)
        else:
            self._go(mover, mover.place, T, _POINTED)  # comes to rest while it fades
        stop = [a - b for a, b in zip(mover.place, rest, strict=True)]
        if self._model.full:
            ports.start[span, 0], ports.end[span, 0] = start, stop
        else:
            ports.start[port, :axes], ports.end[port, :axes] = start, stop

    def _reach_for(self, node: int) -> None:
        """Takes a node, where it is; nothing of the spring is left then."""
        rows = self._rows(node)
        span = slice(self._first, None)
        self.ports.row[span] = rows
        if self.ports.shape.shape[0]:
            self.ports.shape[span] = self._model.port_shapes(rows)
        if node != self._node:
            self._node = node
            self.nodes = [*self._scripted_nodes, *[node] * self._each]
        self._mover.put(self._where(node))

    def _lead(self, tool: LedTool, wanted: bool, T: float, how: tuple[float, float, float]) -> None:
        """The ball or the blade, as much of it as there is."""
        tool.move(
            self._goal if wanted else None,
            _toward(tool.gain, wanted, T, _GROW),
            T,
            stiffness=self._stiffness,
            damping=self._ratio * self._stiffness,
            speed=how[0] * self._size,
            sharpness=how[1],
            rush=how[2] * self._size,
        )

    def _go(self, mover: Mover, goal: Sequence[float], T: float, how: tuple[float, float, float]) -> None:
        mover.move(goal, T, speed=how[0] * self._size, sharpness=how[1], rush=how[2] * self._size)

    # -- what is seen ------------------------------------------------------------------------------------------------

    def _where(self, node: int) -> list[float]:
        """Place of a node, (axes,) [m]."""
        rest = self._body.held_rest[node]
        if self._position is None:
            return rest.tolist()
        rows, position = self._rows(node), self._position
        moved = self._model.port_shapes(rows) @ position if self.ports.shape.shape[0] else position[rows]
        moved = moved[:, 0] if self._model.full else moved[0, : self._axes]
        return (rest + moved).tolist()

    def _rows(self, node: int) -> Int:
        """As `Model.port_rows`, which sorts all rows each time."""
        own = node * self._each + np.arange(self._each)
        return (own if self._order is None else self._order[own]).astype(np.int32)

    def _show_first(self, fields: dict[str, Array]) -> None:
        if self.mode == "ball" or (self._ball is not None and self._ball.gain > 0.0):
            assert self._ball is not None
            ball = self._ball
            write_hand(fields, 0, self.mode, -1, ball.target, ball.place, ball.force, ball.radius)
        elif self._blade is not None and (self.mode in _CUTTING or self._blade.gain > 0.0):
            blade = self._blade
            write_hand(fields, 0, self.mode, -1, blade.target, blade.place, blade.force, edge=blade.edge)
        elif self.mode in _HOLDING or self._grasp > 0.0:
            write_hand(
                fields, 0, self.mode, self._node, self._mover.place, self._where(self._node), self._force(self._first)
            )
        elif self._posed.count and (self.mode == "pose" or self._posed.act):
            self._show_scripted(fields, 0, "rigid", self._posed.led)
        elif self._slots and self.mode == "script":
            self._show_scripted(fields, 0, *self._slots[0])
        else:
            write_hand(fields, 0, self.mode, -1, (), self._where(self._node), ())

    def _show_scripted(self, fields: dict[str, Array], k: int, kind: str, index: int) -> None:
        if kind == "tool":
            assert self.tools is not None
            tools = self.tools
            write_hand(
                fields,
                k,
                "script",
                -1,
                tools.drive_end[index, :3].tolist(),
                tools.place[index, :3].tolist(),
                (-tools.touch_force[index, :3]).tolist(),
                0.0 if index in self._blades else float(tools.radius[index]),
                edge=tools.axis[index, :3].tolist(),
            )
            return
        if kind == "rigid":
            assert self._position is not None
            mode = "pose" if self._posed.act else "script"
            write_hand(fields, k, mode, -1, *self._posed.shown(index, self._position))
            return
        node, port = self._held[index], index * self._each
        place, ports = self._where(node), self.ports
        if not ports.stiffness[port] and not ports.push[port : port + self._each].any():
            write_hand(fields, k, "script", -1, place, place, ())  # it let go
            return
        end = ports.end[port : port + self._each, 0] if self._model.full else ports.end[port, : self._axes]
        target = (self._body.held_rest[node] + end).tolist() if ports.stiffness[port] else place
        write_hand(fields, k, "script", node, target, place, self._force(port))

    def _force(self, port: int) -> list[float]:
        force = self.ports.force
        return (force[port : port + self._each, 0] if self._model.full else force[port, : self._axes]).tolist()


def _toward(fraction: float, there: bool, T: float, grow: float) -> float:
    """A share that grows to 1 or fades to 0."""
    return min(1.0, fraction + T / grow) if there else max(0.0, fraction - T / _FADE)
