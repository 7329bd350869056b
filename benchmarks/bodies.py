"""Bodies that meet: a step of rigid ones that lie on each other, and a tower that stands for a minute.

The processor's time of many steps in one compiled loop, once the bodies have come to rest on each other.
"""

import os
from time import process_time
from typing import Any

import numba
import numpy as np

from benchmarks._report import Row, command
from cotouch.body import Body, Placed, rigid_box, together
from cotouch.mechanics import (
    BODY_LOSS,
    ELASTIC,
    KINETIC,
    LEDGER_COLUMNS,
    Between,
    Links,
    Obstacle,
    Plane,
    Ports,
    State,
    closed_settle,
    closed_step,
    model,
)

G, SIDE, STIFFNESS = 9.81, 0.1, 1e7
TABLE = Obstacle(shape=Plane(), stiffness=STIFFNESS, loss=20.0, friction=0.5)
STUCK = Between(stiffness=STIFFNESS, loss=20.0, friction=0.5)
_SETTLE, _TIMED, _ROUNDS = 1000, 1000, 5
_MINUTE, _PERIOD = 60.0, 2e-3


@numba.njit(error_model="numpy", nogil=True)
def _run(
    op: Any, force: Any, state: Any, links: Any, ports: Any, steps: int, T: float, work: Any, ledger: Any, lanes: Any
) -> float:
    """So many steps; returns what they lost [J]."""
    none, local, lost = np.zeros(0), np.zeros(1), 0.0
    for _ in range(steps):
        closed_step(op, force, state, links, ports, local, local, T, -1, work, ledger, none, 1e-6, 100, lanes)
        lost += ledger[BODY_LOSS]
    return lost


class Stack:
    """Blocks on each other, each pressed in by what is above it.

    Attributes:
        lost: in all steps [J].
    """

    def __init__(self, count: int, resolution: int = 1) -> None:
        """Takes so many blocks of 1 kg, with so many cells along each side."""
        die = rigid_box([SIDE] * 3, mass=1.0, resolution=resolution)
        depth, height, placed = G / (STIFFNESS * SIDE**2), 0.5 * SIDE, list[Placed]()
        for k in range(count):
            height -= (count - k) * depth
            placed.append(Placed(body=die, name=str(k), at=(0.0, 0.0, height)))
            height += SIDE
        self.body: Body = together(placed).with_gravity((0.0, 0.0, -G))
        self.model = model(self.body, obstacles=[TABLE], between=STUCK)
        rows = self.model.operator_rows
        a, b, c, d = np.zeros((4, rows, 4))
        self.state = State(a, b, c, d, np.zeros(self.model.memory))
        self.work, self.ledger, self.lost = self.model.workspace(0), np.zeros(LEDGER_COLUMNS), 0.0
        none, nothing = np.zeros(0), np.zeros((0, 4))
        self.links = Links(none, np.zeros(0, np.int32), np.zeros(0, np.int64), np.zeros((1, rows, 4)))
        self.ports = Ports(np.zeros(0, np.int32), np.zeros((0, rows)), none, none, nothing, nothing, nothing, nothing)
        assert self.model.force is not None
        closed_settle(self.model.operator, self.model.force, self.state, self.work, self.ledger, self.model.lanes)

    def run(self, steps: int, T: float = 1e-3) -> None:
        """So many steps."""
        args = self.model.operator, self.model.force, self.state, self.links, self.ports, steps, T
        self.lost += _run(*args, self.work, self.ledger, self.model.lanes)

    @property
    def energy(self) -> float:
        """What it holds [J]."""
        return float(self.ledger[KINETIC] + self.ledger[ELASTIC])

    def points(self) -> int:
        """Points that press another body or the table."""
        assert self.model.force is not None
        world = self.model.force.world
        assert world is not None
        return int(np.count_nonzero(np.abs(world.told).sum(axis=1)))


def _timed(what: str, stack: Stack, goal: str = "", speed: float = 0.0) -> Row:
    """A step of a stack; `speed`: the highest one slides at so much [m/s]."""
    stack.run(_SETTLE)
    if speed:
        part = stack.body.parts[-1]
        field = np.zeros((stack.body.nodes, 3))
        field[part.first : part.last, 0] = speed
        stack.state.velocity[:] += stack.model.to_rows(field)
        stack.state.memory[1] += 0.5 * speed**2
    seconds: list[float] = []
    for _ in range(_ROUNDS):
        start = process_time()
        stack.run(_TIMED // (10 if speed else 1))
        seconds.append((process_time() - start) / (_TIMED // (10 if speed else 1)))
    note = f"{stack.points()} points pressed; load {os.getloadavg()[0]:.1f}"
    return Row("bodies", what, f"{1e6 * min(seconds):,.0f} µs", goal, note)


def _tower() -> Row:
    """Five blocks for a minute: how far a node comes, and whether contact gave energy."""
    stack = Stack(5, 2)
    stack.run(int(5.0 / _PERIOD), _PERIOD)
    place, begun, highest, far = stack.state.position.copy(), stack.energy, -np.inf, 0.0
    stack.lost = 0.0
    for _ in range(60):
        stack.run(int(_MINUTE / 60 / _PERIOD), _PERIOD)
        far = max(far, float(np.abs(stack.state.position - place).max()))
        highest = max(highest, stack.energy - begun)
    note = f"energy at most {highest:.1g} J above what it was, {stack.lost:.1g} J lost; 5 s to settle before"
    return Row("bodies", "tower of five blocks, 60 s: creep", f"{far:.1g} m", "≤ 1e-6 m", note)


def measure() -> list[Row]:
    """Rows of the table."""
    Stack(2).run(10)
    return [
        _timed("two rigid blocks on a table, at rest", Stack(2, 4), "≤ 200 µs at 100 points"),
        _timed("— with more points, at rest", Stack(2, 5), "≤ 200 µs at 100 points"),
        _timed("— and the upper slides", Stack(2, 5), "≤ 200 µs at 100 points", speed=0.3),
        _timed("five dice on a table, at rest", Stack(5)),
        _timed("— the highest slides", Stack(5), speed=0.3),
        _tower(),
    ]


if __name__ == "__main__":
    command(measure, __doc__)
