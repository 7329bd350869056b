"""Kernels of the planner against the plain functions of the network room."""

from itertools import combinations

import numpy as np
import pytest
from tests.planning.support import GRID, small_network

from cotouch.network import consensus_lags, cycle_period
from cotouch.planning._enumerate import unrank
from cotouch.planning._problem import make_problem
from cotouch.planning._task import admissible, hopeless, period_of, rate

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
        value, sure = rate(task, chosen, guesses)
        assert sure
        assert value == pytest.approx(problem.reference(chosen), rel=1e-7, abs=1e-9)
        # A quick rejection is never wrong.
        for best in (1.01 * value, 0.99 * value):
            if hopeless(task, chosen, best, guesses):
                assert value >= best - 1e-9 * abs(best)
