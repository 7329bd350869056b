"""A copy of a body with tools that can be stepped from Python, what its steps must come to, and flats to press on.

Every test calls `contact_step` through `Pressed.step`, with arguments of the same types, so that it is compiled once.
"""

from typing import Any

import numpy as np
import numpy.typing as npt
from tests.mechanics.support import Copy, Scene

from cotouch.body import Body, lattice
from cotouch.mechanics import (
    BODY_LOSS,
    DRIVE,
    ELASTIC,
    EXTRA_LOSS,
    KINETIC,
    LOCAL_LOSS,
    PROXY,
    SUPPLIED,
    TOUCH_LEDGER,
    TOUCH_LOSS,
    TOUCH_STORED,
    TOUCHING,
    Basis,
    Stiffening,
    contact_by,
    contact_step,
    surface_of,
    tools,
)

Float = npt.NDArray[np.float64]
SPACING = 0.02


def block(*, damping: float = 0.2, shape: tuple[int, int, int] = (4, 4, 3)) -> Body:
    """A soft block on the ground."""
    return lattice(
        shape,
        mass=0.3,
        stiffness=400.0,
        damping=damping,
        spacing=SPACING,
        ground="z-",
        ground_stiffness=2000.0,
        ground_damping=5.0 * damping,
    )


class Pressed:
    """One user's copy and tools; with `soft` a truncated body's skin yields by what its shapes leave out.

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
        moved: Float | None = None,
        soft: bool = False,
    ) -> None:
        still = np.zeros((what.nodes, 3)) if isinstance(what, Body) else np.zeros(0)
        start = still if moved is None else moved
        self.scene = Scene(what, start, still, copies=copies) if isinstance(what, Body) else what
        self.copy = Copy(self.scene, basis=basis)
        self.body, self.model, self.state = self.scene.body, self.copy.model, self.copy.state
        self.surface, self.tools = surface_of(self.model), tools(count)
        if not soft:
            self.surface = self.surface._replace(soft=np.zeros((0, 2)))
        self.contact = contact_by(Stiffening(), self.model, self.surface, tools=count)
        self.tools.mode[:] = TOUCHING
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
        self.touch_ledger[TOUCH_STORED] = float(self.tools.stored.sum())

    def balance(self, before: float) -> None:
        """Books the step that was just taken, with what there was before it."""
        own, tool, did = self.ledger, self.touch_ledger, self.copy.links_did
        lost = own[BODY_LOSS] + own[LOCAL_LOSS] + own[EXTRA_LOSS] + tool[TOUCH_LOSS]
        gap = self.energy - before - (own[SUPPLIED] + tool[DRIVE] + did.sum()) + lost
        moved = np.abs(did).sum() + abs(own[SUPPLIED]) + abs(tool[DRIVE]) + lost
        self.residual = max(self.residual, abs(gap)) if np.isfinite(gap) else np.inf
        self.in_play = max(self.in_play, abs(before), abs(self.energy), float(moved))
        self.totals += tool

    def skin_place(self) -> Float:
        """Places of the skin's vertices, (V, 3)."""
        skin, place = self.body.skin, self.copy.position
        return self.body.rest + place if skin is None else skin.vertices + skin.carried(place)

    @property
    def lost(self) -> float:
        """In contacts so far [J]."""
        return float(self.totals[TOUCH_LOSS])

    def step(self, T: float, cap: int = 1000) -> None:
        before, copy = self.energy, self.copy
        contact_step(
            self.contact,
            self.model.operator,
            self.model.force,
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
            self.ledger,
            self.touch_ledger,
            copy.link_work,
            float(self.tolerance),
            int(cap),
            self.model.lanes,
        )
        self.balance(before)

    def lead(self, start: npt.ArrayLike, end: npt.ArrayLike, stiffness: float = 500.0, damping: float = 6.0) -> None:
        """Lets a hand move the first tool's equilibrium in the coming step."""
        self.tools.drive_stiffness[0], self.tools.drive_damping[0] = stiffness, damping
        self.tools.drive_start[0, :3], self.tools.drive_end[0, :3] = start, end

    @property
    def force(self) -> Float:
        """Of the skin on the first tool in the last step [N]."""
        return self.tools.touch_force[0, :3].copy()


def slab(**kind: Any) -> Body:
    """A flat that hardly yields, of 49 squares of 10 mm."""
    return lattice(
        (8, 8, 2),
        mass=0.3,
        stiffness=4e5,
        damping=20.0,
        spacing=0.01,
        **{"ground": "z-", "ground_stiffness": 1e7, "ground_damping": 100.0, **kind},
    )


def plate(**kind: Any) -> Pressed:
    """A tool above a slab."""
    copy = Pressed(slab(**kind))
    copy.tools.radius[:] = 0.01
    copy.tools.place[0, :3] = [0.02, 0.021, 0.0201]
    copy.begin()
    return copy


def flat(cells: int, *, size: float = 0.08, uneven: float = 0.3, seed: int = 0) -> tuple[Float, npt.NDArray[np.int32]]:
    """Vertices, (V, 3), and triangles of a square in the plane z = 0, whose inner vertices lie unevenly."""
    rng, line = np.random.default_rng(seed), np.linspace(-0.5 * size, 0.5 * size, cells + 1)
    place = np.zeros(((cells + 1) ** 2, 3))
    place[:, :2] = np.stack(np.meshgrid(line, line, indexing="ij"), axis=-1).reshape(-1, 2)
    place[:, :2] += rng.uniform(-uneven, uneven, (place.shape[0], 2)) * size / cells
    index = np.arange(place.shape[0]).reshape(cells + 1, cells + 1)
    a, b, c, d = (
        index[i : i + cells, j : j + cells].ravel() for i in (0, 1) for j in (0, 1)
    )  # fmt: skip
    return place, np.concatenate([np.stack([a, c, d], 1), np.stack([a, d, b], 1)]).astype(np.int32)


def areas(place: Float, corner: npt.NDArray[np.int32]) -> Float:
    """Of triangles, (F,)."""
    a, b, c = (place[corner[:, q]] for q in range(3))
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
