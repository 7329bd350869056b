"""Networks about hubs: what they keep to, and that floods begin high there."""

import numpy as np
import pytest
from tests.planning.inside import (
    about,
    admissible,
    central,
    holds,
    hubs,
    level_of,
    make_problem,
    random_choice,
    side_by_side,
    start_of,
)
from tests.planning.test_flood import crowd


def picks(tries: int, seed: int = 0) -> np.ndarray:
    return np.random.default_rng(seed).random((tries, 7))


@pytest.mark.parametrize("lost", ["nothing", "link", "user"])
def test_they_keep_to_every_limit(lost):
    limits = {"require": [(0, 1)], "forbid": [(2, 3)], "max_degree": 9, "damping_limit": 90.0, "lost": lost}
    problem = make_problem(crowd(14, 3), links=28, objective="decay", **limits)
    chosen = np.zeros(28, dtype=np.int64)
    level = hubs(problem.task, 6, picks(200), chosen)
    assert level > 0.0
    assert admissible(problem.task, chosen)
    assert holds(problem.task, chosen, level)
    pairs = problem.pairs(chosen)
    assert (0, 1) in pairs
    assert (2, 3) not in pairs
    assert len(set(pairs)) == 28


def test_about_one_hub_all_are_linked_to_it_and_the_rest_are_the_quickest():
    network = crowd(9, 2)
    problem = make_problem(network, links=10, objective="decay")
    task = problem.task
    hub = np.zeros(9, dtype=np.bool_)
    hub[4] = True
    mean = (task.to_first + task.to_second) / 2
    chosen = np.zeros(10, dtype=np.int64)
    assert about(task, hub, np.argsort(mean), chosen)
    pairs = problem.pairs(chosen)
    assert {pair for pair in pairs if 4 in pair} == {tuple(sorted((4, i))) for i in range(9) if i != 4}
    others = sorted((float(mean[e]), pair) for e, pair in enumerate(network.links) if 4 not in pair)
    assert {pair for pair in pairs if 4 not in pair} == {pair for _, pair in others[:2]}


def test_users_in_the_middle_come_first():
    network = crowd(10, 5)
    mean = (network.delay + network.delay.T).sum(axis=1)
    assert central(make_problem(network, links=12, objective="decay").task).tolist() == np.argsort(mean).tolist()


def test_floods_begin_far_above_chance():
    """On 60 users, who is in the middle decides more than anything a swap does for a long time."""
    task = make_problem(crowd(60, 1), links=120, objective="decay").task
    chance = max(level_of(task, random_choice(task, np.random.default_rng(seed))) for seed in range(10))
    _, level = start_of(task, 0, 0, np.zeros(0, dtype=np.int64))
    assert level > 2.5 * chance


def test_the_more_users_the_fewer_walks_side_by_side():
    counts = [side_by_side(users) for users in (5, 60, 61, 200, 201, 2000)]
    assert counts == sorted(counts, reverse=True)
    assert min(counts) > 1


def test_where_limits_leave_no_hub_it_says_so():
    task = make_problem(crowd(12, 1), links=12, objective="decay", max_degree=2).task
    assert hubs(task, 1, picks(20), np.zeros(12, dtype=np.int64)) >= 0.0
    tight = make_problem(crowd(12, 1), links=30, objective="decay", damping_limit=1.0).task
    assert hubs(tight, 6, picks(20), np.zeros(30, dtype=np.int64)) == 0.0
