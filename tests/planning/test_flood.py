"""The flood: what it holds against eigenvalues, and that it keeps to every limit."""

import numpy as np
import pytest
from tests.planning.inside import Front, admissible, flood, holds, level_of, make_problem, random_choice
from tests.planning.support import five_users

from cotouch.network import Network, rightmost_root


def crowd(size: int, seed: int, *, same: bool = False) -> Network:
    rng = np.random.default_rng(seed)
    spring = np.triu(rng.uniform(20, 100, (size, size)), 1)
    delay = rng.uniform(0.02, 0.4, (size, size)) * (1 - np.eye(size))
    delay = (delay + delay.T) / 2 if same else delay
    return Network(users=[f"u{i}" for i in range(size)], spring=spring + spring.T, delay=delay)


def negatives(network, level, mass, damping, stiffness):
    """Negative eigenvalues at -level of the characteristic matrix with each round trip shared equally, by LAPACK."""
    spring, mean = network.linked_spring(), (network.delay + network.delay.T) / 2
    own = mass / network.size * level**2 - level * (damping / network.size + (spring * mean).sum(axis=1))
    matrix = np.diag(own + stiffness / network.size + spring.sum(axis=1)) - spring * np.exp(level * mean)
    return int((np.linalg.eigvalsh(matrix) < 0).sum())


@pytest.mark.parametrize("seed", range(5))
def test_what_holds_has_no_real_root_right_of_the_level(seed):
    network = crowd(9, seed)
    body = {"mass": 2.0, "damping": 1.0, "stiffness": 0.0 if seed % 2 else 5.0}
    task = make_problem(network, links=14, objective="decay", **body).task
    rng = np.random.default_rng(seed)
    seen = set()
    for _ in range(20):
        chosen = random_choice(task, rng)
        linked = network.with_links([network.links[e] for e in chosen])
        highest = level_of(task, chosen)
        level = highest * float(rng.uniform(0.5, 1.5))
        expected = negatives(linked, level, **body) <= (0 if body["stiffness"] else 1)
        assert holds(task, chosen, level) == expected
        seen.add(expected)
        assert holds(task, chosen, highest)
        assert not holds(task, chosen, 1.002 * highest)
    assert len(seen) == 2


def test_where_both_delays_are_equal_the_level_is_the_slowest_real_root():
    network = crowd(8, 3, same=True)
    task = make_problem(network, links=10, objective="decay").task
    rng = np.random.default_rng(1)
    real = 0
    for _ in range(10):
        chosen = random_choice(task, rng)
        root = rightmost_root(network.with_links([network.links[e] for e in chosen])).root
        if root.imag == 0:
            assert level_of(task, chosen) == pytest.approx(-root.real, rel=2e-3)
            real += 1
    assert real > 5


@pytest.mark.parametrize("lost", ["nothing", "link", "user"])
def test_a_flood_rises_and_keeps_to_every_limit(lost):
    network = crowd(12, 7)
    limits = {"require": [(0, 1)], "forbid": [(2, 3)], "max_degree": 5, "damping_limit": 70.0, "lost": lost}
    problem = make_problem(network, links=20, objective="decay", **limits)
    task = problem.task
    rng = np.random.default_rng(2)
    start = random_choice(task, rng)
    begin = 0.9 * level_of(task, start)
    front = Front(start.copy(), begin, 0, False)
    while not front.over:
        front = flood(task, front, 1e-2, rng.random((2000, 2)))
        assert admissible(task, front.chosen)
        assert holds(task, front.chosen, front.level)
    linked = network.with_links(problem.pairs(front.chosen))
    assert len(linked.links) == 20
    assert (0, 1) in linked.links
    assert (2, 3) not in linked.links
    assert linked.adjacency().sum(axis=1).max() <= 5
    assert rightmost_root(linked).sync_damping.max() <= 70.0 * (1 + 1e-9)
    assert front.level > 1.2 * begin


def test_the_same_random_numbers_give_the_same_flood():
    task = make_problem(crowd(30, 1), links=60, objective="decay").task
    found = []
    for _ in range(2):
        rng = np.random.default_rng(5)
        chosen = random_choice(task, rng)
        front = flood(task, Front(chosen, 0.5 * level_of(task, chosen), 0, False), 1e-2, rng.random((3000, 2)))
        found.append((front.chosen.tolist(), front.level))
    assert found[0] == found[1]


def test_nothing_to_swap_is_over_at_once():
    task = make_problem(five_users(), links=10, objective="decay").task
    front = flood(task, Front(np.arange(10), 0.1, 0, False), 1e-2, np.zeros((5, 2)))
    assert front.over
    assert front.chosen.tolist() == list(range(10))
