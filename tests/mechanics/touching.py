"""Copies of a body with tools that can be stepped from Python, and what their steps must come to.

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
    TOUCH_LEDGER,
    TOUCH_LOSS,
    TOUCH_STORED,
    Basis,
    surface_of,
    tools,
    touch_step,
    touch_work,
)

Array = np.ndarray


class ToolCopy:
    """One user's copy and tools.

    Attributes:
        residual: largest gap in the balance of energy in any step [J].
        in_play: largest energy, or energy moved in a step [J].
        totals: what the tools booked so far.
    """

    def __init__(
        self,
        what: Body | Scene,
        *,
        count: int = 1,
        basis: Basis = "nodal",
        copies: int = 1,
        tolerance: float = 1e-12,
        moved: Array | None = None,
    ) -> None:
        still = np.zeros((what.nodes, 3)) if isinstance(what, Body) else np.zeros(0)
        start = still if moved is None else moved
        self.scene = Scene(what, start, still, copies=copies) if isinstance(what, Body) else what
        self.copy = Copy(self.scene, basis=basis)
        self.body, self.model, self.state = self.scene.body, self.copy.model, self.copy.state
        self.surface, self.tools = surface_of(self.model), tools(count)
        self.tools.mode[:] = TOUCH
        self.tools.stiffness[:] = 1000.0
        self.tools.mass[:] = 0.05
        self.ledger, self.touch_ledger = self.copy.ledger, np.zeros(TOUCH_LEDGER)
        self.tolerance = tolerance
        self.residual, self.in_play, self.totals = 0.0, 1e-12, np.zeros(TOUCH_LEDGER)

    @property
    def energy(self) -> float:
        own = self.ledger[KINETIC] + self.ledger[ELASTIC]
        return float(own + self.touch_ledger[PROXY] + self.touch_ledger[TOUCH_STORED])

    def begin(self) -> None:
        """Takes what was written into `state` and `tools` as the start."""
        self.copy.settle()
        square = (self.tools.rate[:, :3] ** 2).sum(axis=1)
        self.touch_ledger[PROXY] = 0.5 * float(self.tools.mass @ square)
        self.touch_ledger[TOUCH_STORED] = float(self.tools.account.sum() + self.tools.grip_energy.sum())

    def balance(self, before: float) -> None:
        """Books the step that was just taken, with what there was before it."""
        own, tool, did = self.ledger, self.touch_ledger, self.copy.links_did
        lost = own[BODY_LOSS] + own[LOCAL_LOSS] + own[EXTRA_LOSS] + tool[TOUCH_LOSS]
        gap = self.energy - before - (own[SUPPLIED] + tool[DRIVE] + did.sum()) + lost
        moved = np.abs(did).sum() + abs(own[SUPPLIED]) + abs(tool[DRIVE]) + lost
        self.residual = max(self.residual, abs(gap)) if np.isfinite(gap) else np.inf
        self.in_play = max(self.in_play, before, self.energy, float(moved))
        self.totals += tool

    def skin_place(self) -> Array:
        """Places of the skin's vertices, (V, 3)."""
        skin, place = self.body.skin, self.copy.position
        return self.body.rest + place if skin is None else skin.vertices + skin.carried(place)


class TouchedCopy(ToolCopy):
    """It touches by springs.

    Attributes:
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
        super().__init__(what, count=count, basis=basis, copies=copies, tolerance=tolerance)
        if not soft:
            self.surface = self.surface._replace(soft=np.zeros((0, 2)))
        self.touch = touch_work(self.model, self.surface, tools=count, port_count=len(self.copy.port_of))
        self.debt = 0.0

    def step(self, T: float, cap: int = 1000) -> None:
        before, copy = self.energy, self.copy
        touch_step(
            self.model.operator,
            self.state,
            copy.links,
            copy.ports,
            self.surface,
            self.tools,
            copy.local_damping,
            copy.extra_damping,
            float(T),
            -1,
            copy.work,
            self.touch,
            self.ledger,
            self.touch_ledger,
            copy.link_work,
            float(self.tolerance),
            int(cap),
            self.model.lanes,
        )
        self.balance(before)
        self.debt = min(self.debt, float(self.tools.account.min()))

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
