"""The local search beside every choice there is, and what turns its swaps down beside exact roots."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from tests.planning.inside import begun_at, holds, local, make_problem, random_choice, rate, referral

from cotouch.network import Network, rightmost_root
from cotouch.planning import plan


def full_network(users: int, seed: int, *, even: bool = False) -> Network:
    """Users who may all be linked, with delays that differ both ways unless they are even."""
    rng = np.random.default_rng(seed)
    spring = np.triu(rng.uniform(20.0, 100.0, (users, users)), 1)
    delay = 0.01 * rng.integers(2, 41, (users, users)) * (1 - np.eye(users))
    if even:
        delay = np.triu(delay) + np.triu(delay).T
    return Network(users=[f"u{i}" for i in range(users)], spring=spring + spring.T, delay=delay)


@pytest.mark.parametrize("even", [False, True])
def test_few_starts_find_the_best_of_all_choices(even: bool) -> None:
    for seed in range(5):
        network = full_network(6, seed, even=even)
        every = plan(network, links=8, objective="decay")
        found = plan(network, links=8, objective="decay", method="local", starts=2, seed=seed)
        assert every.status == "proved"
        assert found.best.value == pytest.approx(every.best.value, rel=1e-9)


def test_a_walk_keeps_to_what_is_asked() -> None:
    network = full_network(7, 3)
    required, barred = [(0, 6), (2, 5)], [(0, 1), (3, 4)]
    found = plan(
        network, links=10, objective="decay", method="local", starts=2, require=required, forbid=barred, max_degree=4
    )
    assert {tuple(sorted(pair)) for pair in required} <= set(found.best.links)
    assert not {tuple(sorted(pair)) for pair in barred} & set(found.best.links)
    degree = np.bincount(np.ravel(found.best.links), minlength=7)
    assert degree.max() <= 4


def test_links_that_do_not_hold_are_no_faster() -> None:
    rng, refused = np.random.default_rng(5), 0
    for seed in range(4):
        task = make_problem(full_network(7, seed, even=True), links=9, objective="decay").task
        for _ in range(25):
            chosen = random_choice(task, rng)
            assert chosen is not None
            value, sure = rate(task, chosen, np.full(1, complex(-np.inf, 0.0)), np.inf)
            level = -value * rng.uniform(0.7, 1.3)
            if sure and not holds(task, chosen, level):
                refused += 1
                assert value > -level
    assert refused > 20


def test_what_the_count_leaves_uncertain_is_referred(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the number of users, unless the search is stopped; what nothing settles is counted."""
    network = full_network(12, 1)
    problem = make_problem(network, links=20, objective="decay")
    chosen = random_choice(problem.task, np.random.default_rng(0))
    assert chosen is not None
    monkeypatch.setattr(local, "rate", lambda *_: (0.0, False))
    exact = rightmost_root(network.with_links(problem.pairs(chosen))).rate
    assert local.worked_out(problem, problem.task, chosen, np.zeros(1, np.complex128)) == pytest.approx(exact)
    monkeypatch.setattr(type(problem), "reference", lambda *_: None)
    left = local._settled(problem, problem.task, local.Walk(1, chosen=chosen))
    assert (left.over, left.seen, left.unsure) == (True, (), 1)
    stopped = replace(problem, task=problem.task._replace(stop=np.ones(1, np.int64)))
    assert local.referred(stopped, chosen) is None
    assert local._settled(stopped, stopped.task, local.Walk(1, chosen=chosen)).unsure == 0


@pytest.mark.parametrize("lost", ["link", "user"])
def test_of_all_losses_only_the_uncertain_are_worked_out_slowly(lost: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    problem = make_problem(full_network(5, 2), links=8, objective="decay", lost=lost)
    chosen = random_choice(problem.task, np.random.default_rng(1))
    assert chosen is not None
    exact, sure = rate(problem.task, chosen, np.full(1, complex(-np.inf, 0.0)), np.inf)
    assert sure
    slow: list[Network] = []
    count, slowly = referral.rightmost, referral.rightmost_root
    monkeypatch.setattr(
        "cotouch.planning._referral.rightmost_root", lambda left, **more: slow.append(left) or slowly(left, **more)
    )
    assert local.referred(problem, chosen) == pytest.approx(exact, rel=1e-9)
    assert not slow
    uncertain = complex(5.0, 0.0)  # what the count leaves uncertain is not believed
    monkeypatch.setattr(
        "cotouch.planning._referral.rightmost", lambda *a: count(*a) if len(slow) > 1 else (uncertain, False, 0)
    )
    assert local.referred(problem, chosen) == pytest.approx(exact, rel=1e-9)
    assert len(slow) == 2


def test_a_search_also_begins_where_it_is_told() -> None:
    network = full_network(12, 4)
    one = plan(network, links=18, objective="decay", method="local", starts=1)
    problem = make_problem(network, links=19, objective="decay")
    near = begun_at(problem, one.best.links)
    assert near is not None
    assert set(one.best.links) < set(problem.pairs(near))
    less = begun_at(make_problem(network, links=17, objective="decay"), one.best.links)
    assert less is not None
    assert set(problem.pairs(less)) < set(one.best.links)
    assert begun_at(problem, ()) is None
    assert begun_at(make_problem(network, links=19, objective="decay", forbid=[(0, 1)]), [(0, 1)]) is None
    walks = local.walked(problem, 1, 0, (near, near), lambda calls: [call(*given) for call, given, _ in calls])
    assert tuple(near.tolist()) in [chosen for _, chosen in next(walks).seen]


def test_a_start_that_is_uncertain_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """It goes on with its flood: among 100 measured hosts one such start kept the others waiting for minutes."""
    problem = make_problem(full_network(12, 1), links=20, objective="decay")
    chosen = random_choice(problem.task, np.random.default_rng(0))
    assert chosen is not None
    monkeypatch.setattr(local, "rate", lambda *_: (0.0, False))
    monkeypatch.setattr(local, "referred", lambda *_: pytest.fail("it waits for eigenvalues"))
    walk = local._begin(problem, problem.task, local.Walk(0), 0, (None, chosen))
    assert (walk.over, walk.seen, walk.unsure) == (False, (), 1)
    assert walk.level > 0.0
    last = local.closed(problem, walk)
    assert (last.over, last.seen, last.unsure) == (True, (), 2)


@pytest.mark.parametrize(("told", "taken"), [(None, False), (-0.5, False), (-9.0, True)])
def test_a_swap_that_looks_better_counts_as_what_it_is_referred_to(
    told: float | None, taken: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    problem = make_problem(full_network(6, 1), links=8, objective="decay")
    task, chosen = problem.task, random_choice(problem.task, np.random.default_rng(0))
    assert chosen is not None
    walk = local._settled(problem, task, local.Walk(1, chosen=chosen))
    other = np.sort(np.append(chosen[1:], np.setdiff1d(task.free, chosen)[0]))

    def swap(_: object, links: np.ndarray, *__: object) -> tuple[int, int, float, int, int]:
        links[:] = other
        return local._UNSURE, 1, -99.0, 1, 1

    monkeypatch.setattr(local, "swaps", swap)
    monkeypatch.setattr(local, "referred", lambda *_: told)
    after, _ = local._swapped(problem, task, replace(walk, value=-1.0), 0, 1)
    assert after.value == (told if taken else -1.0)
    assert after.chosen.tolist() == (other if taken else chosen).tolist()
    assert after.unsure == (told is None)
