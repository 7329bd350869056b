"""A copy of a body with tools that can be stepped from Python, and what its steps must come to.

Every test calls `touch_step` through `TouchedCopy.step`, with arguments of the same types, so that each width is
compiled once.
"""

import numpy as np
from tests.mechanics.support import Copy, Scene

from cotouch.body import Body
from cotouch.mechanics import (
    BODY_LOSS,
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
    surface_of,
    tools,
    touch_step,
    touch_work,
)

Array = np.ndarray


class TouchedCopy:
    """One user's copy and tools.

    Attributes:
        residual: largest gap in the balance of energy in any step [J].
        in_play: largest energy, or energy moved in a step [J].
        debt: lowest that any account was [J].

    With `soft` a truncated body's contacts yield by what its shapes leave out.
    """

    def __init__(
        self,
        what: Body | Scene,
        *,
        count: int = 1,
        basis: Basis = "nodal",
        copies: int = 1,
        tolerance: float = 1e-12,
        soft: bool = False,
    ) -> None:
        still = np.zeros((what.nodes, 3)) if isinstance(what, Body) else np.zeros(0)
        self.scene = Scene(what, still, still, copies=copies) if isinstance(what, Body) else what
        self.copy = Copy(self.scene, basis=basis)
        self.body, self.model, self.state = self.scene.body, self.copy.model, self.copy.state
        surface = surface_of(self.model)
        self.surface = surface if soft else surface._replace(soft=np.zeros((0, 2)))
        self.tools = tools(count)
        self.tools.mode[:] = TOUCH
        self.tools.stiffness[:] = 1000.0
        self.tools.mass[:] = 0.05
        self.touch = touch_work(self.model, self.surface, tools=count, ports=len(self.copy.port_of))
        self.books, self.touch_books = self.copy.books, np.zeros(TOUCH_BOOKS)
        self.tolerance = tolerance
        self.residual = 0.0
        self.in_play = 1e-12
        self.debt = 0.0
        self.totals = np.zeros(TOUCH_BOOKS)

    @property
    def energy(self) -> float:
        own = self.books[KINETIC] + self.books[ELASTIC]
        return float(own + self.touch_books[PROXY] + self.touch_books[TOUCH_STORED])

    def begin(self) -> None:
        """Takes what was written into `state` and `tools` as the start."""
        self.copy.settle()
        square = (self.tools.rate[:, :3] ** 2).sum(axis=1)
        self.touch_books[PROXY] = 0.5 * float(self.tools.mass @ square)
        self.touch_books[TOUCH_STORED] = float(self.tools.account.sum() + self.tools.grip_energy.sum())

    def step(self, T: float, cap: int = 1000) -> None:
        before, copy = self.energy, self.copy
        touch_step(
            self.model.operator,
            self.state,
            copy.links,
            copy.grips,
            self.surface,
            self.tools,
            copy.local_damping,
            copy.extra_damping,
            float(T),
            -1,
            copy.work,
            self.touch,
            self.books,
            self.touch_books,
            copy.link_work,
            float(self.tolerance),
            int(cap),
            self.model.lanes,
        )
        lost = self.books[BODY_LOSS] + self.books[LOCAL_LOSS] + self.books[EXTRA_LOSS] + self.touch_books[TOUCH_LOSS]
        supplied = self.books[SUPPLIED] + self.touch_books[DRIVE] + copy.links_did.sum()
        gap = self.energy - before - supplied + lost
        moved = np.abs(copy.links_did).sum() + abs(self.books[SUPPLIED]) + abs(self.touch_books[DRIVE]) + lost
        self.residual = max(self.residual, abs(gap)) if np.isfinite(gap) else np.inf
        self.in_play = max(self.in_play, before, self.energy, float(moved))
        self.debt = min(self.debt, float(self.tools.account.min()))
        self.totals += self.touch_books

    @property
    def count(self) -> int:
        """How many contacts the last step looked at."""
        return int(self.touch.found.number[0])

    @property
    def pushing(self) -> Array:
        """Normal forces of the last step's contacts."""
        axes = 3 if np.any((self.tools.friction > 0.0) & (self.tools.mode == TOUCH)) else 1
        return self.touch.small.force[: axes * self.count : axes]

    def place(self) -> Array:
        """Nodes' places, (n, 3)."""
        return self.body.rest + self.copy.position

    def skin_place(self) -> Array:
        """Places of the skin's vertices, (V, 3)."""
        skin = self.body.skin
        return self.place() if skin is None else skin.vertices + skin.carried(self.copy.position)
