"""A search for where body and tools go: it keeps what misses least, and combines what changes did."""

from itertools import pairwise

import numpy as np
import pytest
from tests.mechanics.inside import (
    BEST,
    FOUND,
    HOPELESS,
    WORSE,
    Sought,
    begin_search,
    combine_kept,
    judge_look,
    stiffer,
)
from tests.mechanics.materials import made
from tests.mechanics.pressing import Pressed

from cotouch.kernels import kernel
from cotouch.mechanics import Workspace

COUNT, ENOUGH = 2, 1e-3


@kernel
def search_step(what: int, tools: Sought, work: Workspace, lanes: tuple[int, ...]) -> int:
    """Begins a search, judges a look, or combines changes."""
    if what == 0:
        begin_search(None, work, lanes)
    elif what == 1:
        return judge_look(None, tools, ENOUGH, work, lanes)
    else:
        combine_kept(None, tools, work, lanes)
    return -1


@kernel
def stiffness(work: Workspace) -> float:
    """Of the matrix, of what it is at first."""
    return 1.0 + stiffer(work)


class Search:
    """A search among directions of a body and two tools, which a linear system asks for."""

    def __init__(self) -> None:
        copy = Pressed(made("cells"), count=COUNT)
        self.work, self.lanes, touch = copy.copy.work, copy.model.lanes, copy.contact.work
        self.tools = Sought(touch.inertia, touch.mean, touch.lacks, touch.kept)
        rng = np.random.default_rng(3)
        self.work.diagonal[:], touch.inertia[:] = rng.uniform(1.0, 3.0, self.work.mean.shape[0]), [0.5, 2.0]
        firm = np.concatenate([self.work.diagonal, touch.inertia])
        self.weight = np.repeat(1.0 / firm, 3)
        mixed = rng.normal(size=(self.weight.size, self.weight.size))
        self.matrix = np.diag(1.0 / self.weight) + 0.02 * (mixed @ mixed.T) / self.weight.size
        self.goal = rng.normal(size=self.weight.size)
        self.work.mean[:] = 9.0
        search_step(0, self.tools, self.work, self.lanes)

    def fields(self, body: np.ndarray, tools: np.ndarray) -> np.ndarray:
        return np.concatenate([body[:, :3].ravel(), tools[:, :3].ravel()])

    @property
    def rate(self) -> np.ndarray:
        return self.fields(self.work.mean, self.tools.rate)

    @property
    def missed(self) -> np.ndarray:
        return self.fields(self.work.rhs, self.tools.missed)

    def misses(self, rate: np.ndarray) -> np.ndarray:
        """What a direction misses."""
        return self.matrix @ (self.goal - rate)

    def look(self, rate: np.ndarray) -> int:
        """What comes of a look at a direction."""
        split = 3 * self.work.mean.shape[0]
        for values, body, tools in (
            (rate, self.work.mean, self.tools.rate),
            (self.misses(rate), self.work.rhs, self.tools.missed),
        ):
            body[:, :3], tools[:, :3] = values[:split].reshape(-1, 3), values[split:].reshape(-1, 3)
        return search_step(1, self.tools, self.work, self.lanes)


def off(search: Search, size: float, seed: int = 0) -> np.ndarray:
    """A direction so far from what is sought."""
    return search.goal + size * np.random.default_rng(seed).normal(size=search.goal.size)


def test_what_misses_more_is_taken_back_and_the_matrix_is_stiffer() -> None:
    search = Search()
    assert not search.work.mean[:, :3].any()
    best = off(search, 1.0)
    assert search.look(off(search, 1.5, 7)) == BEST
    assert search.look(best) == BEST
    for power in (1, 2, 3):
        assert search.look(off(search, 2.0, power)) == WORSE
        assert search.rate == pytest.approx(best, rel=1e-15)
        assert search.missed == pytest.approx(search.misses(best), rel=1e-15)
        assert stiffness(search.work) == 4.0**power
        search_step(2, search.tools, search.work, search.lanes)  # what led there is forgotten
        assert search.rate == pytest.approx(best, rel=1e-15)
    for power in range(5, -1, -1):
        assert search.look(off(search, 0.1 + 0.1 * power)) == BEST
        assert stiffness(search.work) == 2.0**power
    assert search.look(off(search, 0.05)) == BEST
    assert stiffness(search.work) == 1.0


def test_what_tools_miss_counts_by_how_firm_they_are() -> None:
    search, rng = Search(), np.random.default_rng(5)
    for _ in range(20):
        least = np.inf
        search_step(0, search.tools, search.work, search.lanes)
        for _ in range(4):
            rate = search.goal.copy()
            rate[-3 * COUNT :] += rng.normal(size=3 * COUNT)
            rate[: -3 * COUNT] += 0.1 * rng.normal(size=rate.size - 3 * COUNT)
            square = float(search.weight @ search.misses(rate) ** 2)
            assert search.look(rate) == (BEST if square < least else WORSE)
            least = min(least, square)


def test_a_search_ends_where_enough_is_found_or_nothing_is() -> None:
    search = Search()
    error = search.misses(off(search, 1.0))
    size = np.sqrt(search.weight @ error**2) / np.sqrt((1.0 / search.weight) @ search.goal**2)
    assert search.look(off(search, 1.1 * ENOUGH / size)) == BEST
    assert search.look(off(search, 0.9 * ENOUGH / size)) == FOUND
    search_step(0, search.tools, search.work, search.lanes)
    assert search.look(np.full(search.goal.size, np.nan)) == HOPELESS
    assert search.look(off(search, 1.0)) == BEST
    came = [search.look(off(search, 2.0)) for _ in range(20)]
    assert came == [WORSE] * 19 + [HOPELESS]  # 4^20 is more than 1e12
    assert search.rate == pytest.approx(off(search, 1.0), rel=1e-15)


@pytest.mark.parametrize("looks", [2, 3, 4, 6])
def test_changes_that_are_kept_are_combined_so_that_least_is_missed(looks: int) -> None:
    """Of the last three, in a system that is linear: nothing is missed along what any of them did."""
    search = Search()
    went = [off(search, 1.0 / (1 + look), look) for look in range(looks)]
    for rate in went:
        assert search.look(rate) == BEST
    before = float(search.weight @ search.missed**2)
    search_step(2, search.tools, search.work, search.lanes)
    assert search.missed == pytest.approx(search.misses(search.rate), abs=1e-12)
    for one, two in list(pairwise(went))[-3:]:
        did = search.misses(one) - search.misses(two)
        along = search.weight @ (did * search.missed)
        if looks <= 4:  # later ones are kept without what the forgotten did
            assert abs(along) <= 1e-12 * (search.weight @ did**2)
    assert search.weight @ search.missed**2 < 0.9 * before
