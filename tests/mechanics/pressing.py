"""A copy of a body with tools that touch by a law and can be stepped from Python, and flats to press on.

Every test calls `contact_step` through `Pressed.step`, with arguments of the same types, so that it is compiled once.
"""

from typing import Any

import numpy as np
import numpy.typing as npt
from tests.mechanics.support import Scene
from tests.mechanics.touching import ToolCopy

from cotouch.body import Body, lattice
from cotouch.mechanics import TOUCH_LOSS, Stiffening, contact_by, contact_step

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


class Pressed(ToolCopy):
    """It touches by a law."""

    def __init__(
        self, what: Body | Scene, *, count: int = 1, tolerance: float = 1e-12, moved: Float | None = None
    ) -> None:
        super().__init__(what, count=count, tolerance=tolerance, moved=moved)
        self.contact = contact_by(Stiffening(), self.model, self.surface, tools=count)

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
