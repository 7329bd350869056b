"""Bounds by relaxation against every choice there is."""

import numpy as np
import pytest
from tests.planning.inside import bound_of, make_problem
from tests.planning.support import five_users

from cotouch import plan
from cotouch.network import Network, connected_graphs, rightmost_root, rule_damping


def alike(size: int, seed: int, *, clocks: bool = False) -> Network:
    """Delays that are the same both ways, or would be if all clocks were right."""
    rng = np.random.default_rng(seed)
    spring = np.triu(rng.uniform(20, 100, (size, size)), 1)
    delay = np.triu(rng.uniform(0.2, 0.6, (size, size)), 1)
    delay = delay + delay.T
    if clocks:
        offset = rng.uniform(-0.05, 0.05, size)
        delay = (delay + offset[:, None] - offset[None, :]) * (1 - np.eye(size))
    return Network(users=[str(i) for i in range(size)], spring=spring + spring.T, delay=delay)


@pytest.mark.parametrize("clocks", [False, True])
@pytest.mark.parametrize("stiffness", [0.0, 2.0])
def test_no_choice_decays_faster_than_the_bound(clocks, stiffness):
    body = {"mass": 0.01, "stiffness": stiffness}
    gaps = []
    for seed in range(3):
        network = alike(5, seed, clocks=clocks)
        bound, why = bound_of(make_problem(network, links=4, objective="decay", **body))
        assert bound is not None
        assert "quickest link" in why
        rates = [rightmost_root(network.with_links(g), **body).rate for g in connected_graphs(network, links=4)]
        assert bound <= min(rates)
        gaps.append(bound / min(rates))
    assert min(gaps) < 2.5, "a bound that says nothing is no bound"


def test_no_choice_has_less_damping_than_the_bound():
    network = five_users()
    for links in (4, 6, 8):
        for options in ({}, {"require": [(0, 4)]}):
            bound, _ = bound_of(make_problem(network, links=links, objective="damping", **options))
            least = min(
                rule_damping(network.with_links(g), ages=network.delay).max()
                for g in connected_graphs(network, links=links)
                if set(options.get("require", ())) <= set(g)
            )
            assert bound is not None
            assert 0.4 * least < bound <= least


def test_where_no_relaxation_is_known_it_says_so():
    for objective, word in (("decay", "differ both ways"), ("consensus", "consensus")):
        bound, why = bound_of(make_problem(five_users(), links=6, objective=objective))
        assert bound is None
        assert word in why


def test_a_proof_is_its_own_bound():
    found = plan(five_users(), links=6, objective="damping")
    assert found.status == "proved"
    assert found.bound == found.best.value
    local = plan(five_users(), links=6, objective="damping", method="local", starts=2)
    assert local.bound is not None
    assert local.bound <= local.best.value
    assert local.numbers()["bound"] == local.bound


def test_where_all_users_are_alike_the_bound_on_damping_is_reached():
    size = 6
    alike = np.ones((size, size)) - np.eye(size)
    network = Network(users=[str(i) for i in range(size)], spring=50.0 * alike, delay=0.1 * alike)
    bound, _ = bound_of(make_problem(network, links=size, objective="damping"))
    ring = [(i, i + 1) for i in range(size - 1)] + [(0, size - 1)]
    least = rule_damping(network.with_links(ring), ages=network.delay).max()
    assert bound == pytest.approx(least, rel=1e-8)
    assert bound <= least


def test_users_who_are_far_from_all_but_each_other_may_all_be_linked():
    """Here two whose quickest links are slow are linked to each other, and no more roots are slow than one."""
    rng = np.random.default_rng(33)
    size, links = int(rng.integers(3, 6)), 7
    spring = np.triu(rng.uniform(20, 100, (size, size)), 1)
    far = rng.uniform(0, 0.5, size) * (rng.random(size) < 0.5) + 0.02
    delay = (far[:, None] + far[None, :]) * (1 - np.eye(size))
    network = Network(users=[str(i) for i in range(size)], spring=spring + spring.T, delay=delay)
    bound, _ = bound_of(make_problem(network, links=links, objective="decay", mass=0.01))
    assert bound is not None
    assert bound <= min(
        rightmost_root(network.with_links(g), mass=0.01).rate for g in connected_graphs(network, links=links)
    )
