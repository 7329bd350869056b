"""How a body yields to forces at a few places, against a dense inverse."""

import numpy as np
import pytest

from cotouch.body import Body, chain, lattice
from cotouch.mechanics import model
from cotouch.mechanics._columns import Columns, columns, read_column, solve_columns

Array = np.ndarray


class Yielding:
    """A = diagonal + K's entries, for forces at random places."""

    def __init__(self, body: Body, rng: np.random.Generator, count: int, *, heavy: float = 1.0, entries: int = 8):
        self.model = model(body, basis="nodal")
        op = self.model.operator
        self.op, rows = op, self.model.operator_rows
        self.values = op.entries[0] if op.entries.shape[0] else np.zeros(0)
        self.scale = float(op.mix[2, 0]) if op.entries.shape[0] else 0.0
        self.diagonal = op.stiffness + heavy * op.mass
        self.dense = np.diag(self.diagonal)
        for i in range(rows):
            for e in range(op.pointer[i], op.pointer[i + 1]):
                self.dense[i, op.column[e]] += self.scale * self.values[e]
        self.work: Columns = columns(rows, count, held=64, modal=False)
        self.count = count
        self.force(rng, entries)

    def force(self, rng: np.random.Generator, entries: int) -> None:
        rows, work = self.model.operator_rows, self.work
        self.H = np.zeros((rows, self.count))
        for c in range(self.count):
            own = rng.integers(0, rows, entries)  # a row may come twice
            work.row[c, :entries] = own
            work.value[c, :entries] = rng.normal(size=entries)
            work.entries[c] = entries
            np.add.at(self.H[:, c], own, work.value[c, :entries])

    def solve(self, tolerance: float = 1e-13, cap: int = 1000) -> Array:
        solve_columns(
            self.op, self.values, self.scale, self.diagonal, self.work, self.count, float(tolerance), int(cap)
        )
        return self.answers(self.work.reach[: self.work.size[0]])

    def answers(self, rows: Array) -> Array:
        out = np.zeros((self.model.operator_rows, self.count))
        for c in range(self.count):
            out[rows, c] = self.work.answer[c // 4, rows, c % 4]
        return out


@pytest.mark.parametrize("count", [1, 4, 5, 11])
@pytest.mark.parametrize("full", [False, True])
def test_are_those_of_the_inverse(count: int, full: bool):
    body = lattice((4, 4, 4), mass=0.5, stiffness=300.0, ground="z-", ground_stiffness=100.0)
    yielding = Yielding(body.as_full() if full else body, np.random.default_rng(count), count, heavy=1e4)
    exact = np.linalg.solve(yielding.dense, yielding.H)
    assert yielding.solve() == pytest.approx(exact, rel=1e-9, abs=1e-12 * np.abs(exact).max())
    for c in range(count):
        for o in range(count):
            read = read_column(yielding.work, c, yielding.work.answer[o // 4], o % 4)
            assert read == pytest.approx(yielding.H[:, c] @ exact[:, o], rel=1e-9, abs=1e-12 * np.abs(exact).max())


def test_are_the_same_whatever_was_asked_before():
    """Of rows that only a later group reaches, the earlier groups must not keep what another step left there."""
    body = chain(200, mass=1.0, stiffness=1000.0)
    rng = np.random.default_rng(0)
    used = Yielding(body, rng, 8, heavy=3e5, entries=1)
    used.solve()
    fresh = Yielding(body, rng, 8, heavy=3e5, entries=1)
    for work in (used.work, fresh.work):
        work.row[:4, 0], work.row[4:, 0] = 100, 101
        work.value[:4, 0], work.value[4:, 0] = 1.0, [1.0, 1.0, 1e-3, 1.0]
        work.row[4:, 1], work.value[4:, 1], work.entries[4:] = 140, 1.0, 2
    used.diagonal[110:] = fresh.diagonal[110:] = 2.2 * 1000.0  # slow to settle beyond: the second group goes farther
    got, wanted = used.solve(), fresh.solve()
    assert np.array_equal(got, wanted)


def test_touch_no_row_out_of_reach():
    body = chain(300, mass=1.0, stiffness=1000.0)
    yielding = Yielding(body, np.random.default_rng(0), 2, heavy=1e6, entries=1)
    yielding.work.row[:2, 0] = [50, 60]
    yielding.work.answer[:] = np.nan
    yielding.work.residual[:] = np.nan
    yielding.work.image[:] = np.nan
    cap = 12
    yielding.solve(cap=cap)
    reached = np.sort(yielding.work.reach[: yielding.work.size[0]])
    own = yielding.model.order if yielding.model.order is not None else np.arange(300)
    assert set(own[reached]) <= {int(own[row]) + side for row in (50, 60) for side in range(-cap, cap + 1)}
    assert not np.isnan(yielding.work.answer[0][reached, :2]).any()
    others = np.setdiff1d(np.arange(300), reached)
    assert np.isnan(yielding.work.answer[0][others]).all()
    assert not yielding.work.direction.any()


def test_later_groups_reach_no_farther_than_their_own_iterations():
    body = chain(400, mass=1.0, stiffness=1000.0)
    reached: list[int] = []
    for count in (4, 12):  # the same four columns, three times
        yielding = Yielding(body, np.random.default_rng(0), count, heavy=1e6, entries=1)
        yielding.work.row[:count, 0] = np.resize([100, 150, 200, 250], count)
        yielding.work.value[:count, 0] = 1.0
        answers = yielding.solve()
        assert np.array_equal(answers, np.tile(answers[:, :4], count // 4))
        reached.append(int(yielding.work.size[0]))
    assert reached[1] == reached[0] < 200


@pytest.mark.parametrize("cap", [1, 2, 5])
def test_a_cap_leaves_a_smaller_yield(cap: int):
    """What conjugate gradients give so far never yields more than A⁻¹: contacts come out too stiff, never too soft."""
    body = lattice((4, 4, 4), mass=0.5, stiffness=300.0, ground="z-", ground_stiffness=100.0)
    yielding = Yielding(body, np.random.default_rng(3), 3)
    exact = np.linalg.solve(yielding.dense, yielding.H)
    got = yielding.solve(cap=cap)
    for c in range(3):
        assert 0.0 < yielding.H[:, c] @ got[:, c] < yielding.H[:, c] @ exact[:, c]


def test_of_a_body_without_springs_are_a_division():
    yielding = Yielding(Body(mass=np.diag([1.0, 2.0, 4.0]), rest=np.zeros((3, 3))), np.random.default_rng(0), 2)
    assert yielding.solve() == pytest.approx(yielding.H / yielding.diagonal[:, None])
