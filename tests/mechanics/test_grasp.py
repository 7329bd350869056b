"""Taking and letting go [Lee & Huang 2010, contact law]; a grasp's forces are held in `test_touch.py`."""

import numpy as np
import pytest
from tests.mechanics.touching import TouchedCopy

from cotouch.body import lattice
from cotouch.mechanics import AWAY, GRASP, TOUCH_LOSS

SPACING = 0.02


def grasping(kind: str = "node", *, radius: float = 1.1 * SPACING) -> TouchedCopy:
    body = lattice((3, 3, 3), mass=0.3, stiffness=400.0, damping=0.2, spacing=SPACING)
    copy = TouchedCopy(body.as_full() if "full" in kind else body, basis="modal" if "modal" in kind else "nodal")
    tools = copy.tools
    tools.mode[:] = GRASP
    tools.radius[:] = radius
    tools.grip_stiffness[:] = 2000.0
    tools.grip_damping[:] = 1.0
    tools.place[0, :3] = [SPACING, SPACING, 2 * SPACING]
    copy.begin()
    return copy


@pytest.mark.parametrize("kind", ["node", "full", "modal", "full modal"])
def test_takes_what_is_within_its_radius(kind: str):
    copy = grasping(kind)
    copy.step(1e-3)
    held = copy.tools.hold[0, : copy.tools.held[0]]
    places = copy.surface.hold_rest[:, :3]
    away = np.linalg.norm(places - [SPACING, SPACING, 2 * SPACING], axis=1)
    assert set(held) == set(np.flatnonzero(away <= 1.1 * SPACING))
    assert copy.tools.touching[0] == held.size


def test_takes_the_nearest_where_none_is_within():
    copy = grasping(radius=1e-6)
    copy.tools.place[0, :3] += [1e-3, 2e-3, 1e-3]
    copy.step(1e-3)
    assert copy.tools.held[0] == 1
    assert copy.body.rest[copy.tools.hold[0, 0]] == pytest.approx([SPACING, SPACING, 2 * SPACING])


def test_with_too_many_within_keeps_the_nearest():
    copy = grasping("modal", radius=1.0)
    copy.tools.place[0, :3] += [1e-3, 2e-3, 3e-3]
    places = copy.surface.hold_rest[:, :3]
    away = np.linalg.norm(places - copy.tools.place[0, :3], axis=1)
    copy.step(1e-3)
    count = int(copy.tools.held[0])
    assert count == 8
    assert np.sort(away[copy.tools.hold[0, :count]]) == pytest.approx(np.sort(away)[:count])


@pytest.mark.parametrize("kind", ["node", "full", "modal", "full modal"])
def test_takes_and_lets_go_at_no_gain(kind: str):
    copy = grasping(kind)
    copy.step(1e-3)
    assert copy.energy == pytest.approx(0.0, abs=1e-30)  # springs start relaxed: nothing moves
    copy.tools.rate[0, :3] = [0.3, -0.2, 0.1]
    copy.begin()
    start = copy.energy
    for _ in range(20):
        copy.step(1e-3)
    stored = float(copy.tools.grip_energy[0])
    assert stored > 1e-6
    copy.tools.mode[:] = AWAY
    before = copy.energy
    copy.step(1e-3)
    assert copy.touch_ledger[TOUCH_LOSS] == pytest.approx(stored, rel=1e-12)
    assert copy.energy <= before - stored + 1e-15
    assert copy.tools.held[0] == -1
    assert not copy.tools.touch_force.any()
    assert copy.residual <= 1e-13 * start


def test_a_held_body_carries_momentum():
    """Tool and free body together keep theirs."""
    copy = grasping()
    copy.tools.rate[0, :3] = [0.3, -0.2, 0.1]
    copy.begin()
    total = copy.tools.mass[0] * copy.tools.rate[0, :3]
    for T in (1e-3, 5e-4, 2e-3) * 30:
        copy.step(T)
    body = np.diag(copy.body.mass.toarray())[:, None] * copy.copy.velocity
    assert body.sum(axis=0) + copy.tools.mass[0] * copy.tools.rate[0, :3] == pytest.approx(total, rel=1e-9)
