"""A copy of a body with tools that can be stepped from Python."""

from typing import Any

import numpy as np

from cotouch.body import Body
from cotouch.mechanics import (
    BODY_LOSS,
    BOOKS,
    DRIVE,
    ELASTIC,
    EXTRA_LOSS,
    KINETIC,
    LOCAL_LOSS,
    PROXY,
    SUPPLIED,
    TOUCH,
    TOUCH_BOOKS,
    TOUCH_LOSS,
    TOUCH_STORED,
    Basis,
    Grips,
    Links,
    State,
    model,
    settle,
    surface_of,
    tools,
    touch_step,
    touch_work,
    workspace,
)

Array = np.ndarray


class TouchedCopy:
    """One user's copy and tools; `ledger` holds what each step did."""

    def __init__(
        self, body: Body, *, count: int = 1, basis: Basis = "nodal", copies: int = 1, tolerance: float = 1e-12
    ) -> None:
        self.body = body
        self.model = model(body, copies=copies, basis=basis)
        op, width, rows = self.model.operator, self.model.width, self.model.operator_rows
        zero = lambda: np.zeros((rows, width))  # noqa: E731
        self.state = State(zero(), zero(), zero(), zero())
        self.links = Links(0, 0, np.zeros(0), np.zeros(0, np.int32), np.zeros(0, np.int64), np.zeros((1, rows, width)))
        empty = np.zeros(0)
        none = np.zeros((0, width))
        self.grips = Grips(0, 0, np.zeros(0, np.int32), np.zeros((0, rows)), empty, empty, none, none, none, none)
        self.surface = surface_of(self.model)
        self.tools = tools(count)
        self.tools.mode[:] = TOUCH
        self.tools.stiffness[:] = 1000.0
        self.tools.mass[:] = 0.05
        self.work = workspace(op, width, 1)
        self.touch = touch_work(self.model, self.surface, tools=count, ports=1)
        self.books, self.touch_books = np.zeros(BOOKS), np.zeros(TOUCH_BOOKS)
        self.damping = np.zeros(1)
        self.tolerance = tolerance
        settle(op, self.state, self.books, self.model.lanes)
        self.residual = 0.0
        self.in_play = 1e-12
        self.totals = np.zeros(TOUCH_BOOKS)

    @property
    def energy(self) -> float:
        own = self.books[KINETIC] + self.books[ELASTIC]
        return float(own + self.touch_books[PROXY] + self.touch_books[TOUCH_STORED])

    def begin(self) -> None:
        """Takes what was written into `state` and `tools` as the start."""
        settle(self.model.operator, self.state, self.books, self.model.lanes)
        square = (self.tools.rate[:, :3] ** 2).sum(axis=1)
        self.touch_books[PROXY] = 0.5 * float(self.tools.mass @ square)
        self.touch_books[TOUCH_STORED] = float(self.tools.account.sum() + self.tools.grip_energy.sum())

    def step(self, T: float, cap: int = 1000) -> dict[str, Any]:
        before = self.energy
        touch_step(
            self.model.operator,
            self.state,
            self.links,
            self.grips,
            self.surface,
            self.tools,
            self.damping,
            np.zeros(1),
            T,
            -1,
            self.work,
            self.touch,
            self.books,
            self.touch_books,
            np.zeros(0),
            self.tolerance,
            cap,
            self.model.lanes,
        )
        lost = self.books[BODY_LOSS] + self.books[LOCAL_LOSS] + self.books[EXTRA_LOSS] + self.touch_books[TOUCH_LOSS]
        supplied = self.books[SUPPLIED] + self.touch_books[DRIVE]
        gap = self.energy - before - supplied + lost
        self.residual = max(self.residual, abs(gap))
        self.in_play = max(self.in_play, self.energy, abs(supplied))
        self.totals += self.touch_books
        return {"energy": self.energy, "supplied": supplied, "lost": lost, "gap": gap}

    def place(self) -> Array:
        """Nodes' places, (n, 3)."""
        return self.body.rest + self.model.to_nodes(self.state.position)
