"""Kernels of the planner against the plain functions of the network room."""

from itertools import combinations

import numpy as np
import pytest
from tests.network.inside import cycle_period
from tests.planning.inside import admissible, between, hopeless, make_problem, period_of, pulls, rate, unrank
from tests.planning.support import GRID, small_network

from cotouch.network import consensus_lags

COMMON = {"time_unit": GRID}


def test_combinations_are_numbered_in_order():
    for number, combination in enumerate(combinations(range(7), 3)):
        assert tuple(unrank(number, 7, 3)) == combination


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("objective", ["consensus", "decay"])
def test_kernels_against_the_network_room(seed: int, objective):
    network, links = small_network(np.random.default_rng(seed))
    problem = make_problem(network, links=links, objective=objective, **COMMON)
    task = problem.task
    guesses = np.full(1, complex(-np.inf, 0.0))
    chosen_ones = [np.array(c) for c in combinations(range(len(network.links)), links)]
    for chosen in chosen_ones[:: max(len(chosen_ones) // 12, 1)]:
        graph = network.with_links(problem.pairs(chosen))
        assert admissible(task, chosen) == graph.is_connected()
        if not graph.is_connected():
            continue
        if objective == "consensus":
            lags = consensus_lags(graph, time_unit=GRID, convention="equation", rounding="exact")
            assert period_of(task, chosen) == cycle_period(lags)
        value, sure = rate(task, chosen, guesses, np.inf)
        assert sure
        assert value == pytest.approx(problem.reference(chosen), rel=1e-7, abs=1e-9)
        # A quick rejection is never wrong.
        for best in (1.01 * value, 0.99 * value):
            if hopeless(task, chosen, best, guesses[:, None].copy()):
                assert value >= best - 1e-9 * abs(best)
        if objective == "consensus" and period_of(task, chosen) == 1:
            for best, worst in ((2.0, 0.5), (0.9, 0.5), (2.0, 1.1)):
                if between(task, chosen, best * value, worst * value, guesses.copy()):
                    assert best > 1 > worst


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("objective", ["consensus", "decay"])
def test_pulls_are_the_slopes_of_the_root(seed, objective):
    """A link a little stiffer moves the slowest root by as much as the null vectors say."""
    network, links = small_network(np.random.default_rng(seed))
    problem = make_problem(network, links=links, objective=objective, **COMMON)
    task = problem.task
    chosen = next(c for c in map(np.array, combinations(range(len(network.links)), links)) if admissible(task, c))
    guesses = np.full(1, complex(-np.inf, 0.0))
    value, _ = rate(task, chosen, guesses, np.inf)
    if objective == "consensus" and period_of(task, chosen) > 1:
        return
    pull = np.empty(len(network.links))
    pulls(task, chosen, guesses, pull)
    for e in chosen:
        change = np.zeros(len(network.links))
        change[e] = 1e-6
        moved = task._replace(spring=task.spring * (1 + change), load=task.load * (1 + change))
        there, _ = rate(moved, chosen, guesses.copy(), np.inf)
        assert (there - value) / 1e-6 == pytest.approx(pull[e], rel=1e-3, abs=1e-3 * np.abs(pull).max() + 1e-6)
