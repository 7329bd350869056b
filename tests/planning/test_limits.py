"""Limits on damping and drag, and losses, against brute force."""

import math

import numpy as np
import pytest
from tests.planning.support import five_users, small_network

from cotouch import plan
from cotouch.errors import NetworkError
from cotouch.network import Network, closed_loop, connected_graphs, rightmost_root, rule_damping


def drag_of(network: Network) -> float:
    """Force of all users together per speed of a steady common motion: the slope of the closed loop at 0."""
    loop, _ = closed_loop(network)
    late = float((loop.spring * (loop.to_first + loop.to_second)).sum())
    return float(loop.drag.sum()) + late


def left_by(network: Network, lost: str) -> list[Network]:
    if lost == "link":
        return [network.with_links([link for link in network.links if link != gone]) for gone in network.links]
    result = []
    for user in range(network.size):
        rest = [i for i in range(network.size) if i != user]
        there = np.ix_(rest, rest)
        links = [(rest.index(a), rest.index(b)) for a, b in network.links if user not in (a, b)]
        names = [network.users[i] for i in rest]
        result.append(Network(users=names, spring=network.spring[there], delay=network.delay[there], links=links))
    return result


@pytest.mark.parametrize("objective", ["decay", "damping"])
def test_limits_on_damping_and_drag_against_brute_force(objective):
    network = five_users()
    graphs = list(connected_graphs(network, links=5))
    rules = [rule_damping(network.with_links(graph), ages=network.delay).max() for graph in graphs]
    drags = [drag_of(network.with_links(graph)) for graph in graphs]
    for limits in (
        {"damping_limit": float(np.median(rules))},
        {"drag_limit": float(np.median(drags))},
        {"damping_limit": float(np.median(rules)), "drag_limit": float(np.median(drags))},
    ):
        allowed = [
            graph
            for graph, rule, drag in zip(graphs, rules, drags, strict=True)
            if rule <= limits.get("damping_limit", math.inf) and drag <= limits.get("drag_limit", math.inf)
        ]
        value = {
            graph: rightmost_root(network.with_links(graph)).rate
            if objective == "decay"
            else rule_damping(network.with_links(graph), ages=network.delay).max()
            for graph in allowed
        }
        assert 0 < len(allowed) < len(graphs)
        for method in ("enumerate", "local") + (("bound",) if objective == "damping" else ()):
            found = plan(network, links=5, objective=objective, method=method, starts=16, **limits)
            assert found.best.links in value
            assert found.best.value == pytest.approx(min(value.values()), rel=1e-9)
            assert found.best.drag == pytest.approx(drag_of(network.with_links(found.best.links)), rel=1e-12)
            if method == "enumerate":
                assert found.graphs == len(allowed)


@pytest.mark.parametrize("lost", ["link", "user"])
def test_the_worst_loss_counts(lost):
    rng = np.random.default_rng(4)
    network, _ = small_network(rng)
    while network.size != 5 or len(network.links) < 8:
        network, _ = small_network(rng)
    value = {}
    for graph in connected_graphs(network, links=7):
        whole = network.with_links(graph)
        cases = [whole, *left_by(whole, lost)]
        if all(case.is_connected() for case in cases):
            value[graph] = max(rightmost_root(case).rate for case in cases)
    assert value
    for method in ("enumerate", "local"):
        found = plan(network, links=7, objective="decay", lost=lost, method=method, starts=16)
        assert found.best.value == pytest.approx(min(value.values()), rel=1e-9)
        assert value[found.best.links] == pytest.approx(found.best.value, rel=1e-9)
        if method == "enumerate":
            assert found.graphs == len(value)


BAD = [
    ({"damping_limit": 0.0}, "damping_limit is 0 Ns/m"),
    ({"drag_limit": math.nan}, "drag_limit is nan Ns/m"),
    ({"damping_limit": 1e-3}, "no choice of 6 links .* damping_limit; relax"),
    ({"drag_limit": 1e-3}, "no choice of 6 links .* drag_limit; relax"),
    ({"lost": "nobody"}, 'lost is "nobody"'),
    ({"lost": "link", "objective": "consensus"}, 'lost is "link" but objective is "consensus"'),
    ({"damping_limit": 5.0, "sync_damping": [9.0] * 5}, "sync_damping holds 9 Ns/m but damping_limit is 5"),
]


@pytest.mark.parametrize(("options", "message"), BAD)
def test_limits_that_cannot_be_are_one_sentence(options, message):
    with pytest.raises(NetworkError, match=message) as caught:
        plan(five_users(), **({"links": 6, "objective": "decay"} | options))
    assert "\n" not in str(caught.value)


def test_springs_that_overflow_are_one_sentence():
    huge = 1e308 * (1 - np.eye(3))
    network = Network(users=list("abc"), spring=huge, delay=0.01 * (1 - np.eye(3)))
    for objective in ("consensus", "decay", "damping"):
        with pytest.raises(NetworkError, match=r"the spring a-b is 1e\+308 N/m"):
            plan(network, links=2, objective=objective)


def test_a_factor_that_all_lags_share_is_divided_out():
    """Delays of whole 50 ms on a grid of 10 ms: every graph would be periodic, whatever its links."""
    network, links = small_network(np.random.default_rng(5))
    fine, coarse = (plan(network, links=links, time_unit=unit) for unit in (0.01, 0.05))
    assert fine.best.links == coarse.best.links
    assert fine.periodic == coarse.periodic < coarse.graphs
    assert fine.best.value**5 == pytest.approx(coarse.best.value, rel=1e-9)
    assert "multiples of 5 time units" in fine.notes[0]
    assert not coarse.notes


def test_a_grid_on_which_every_graph_is_periodic_proves_nothing():
    ring = Network(users=list("abcd"), spring=10 * (1 - np.eye(4)), delay=0.01 * (1 - np.eye(4)))
    found = plan(ring, links=3)  # trees are bipartite
    assert (found.status, found.periodic) == ("best found", found.graphs)
    assert any("all 16 graphs are periodic" in note for note in found.notes)


def test_a_delay_of_many_seconds_is_questioned():
    delay = 0.1 * (1 - np.eye(3))
    delay[2, 0] = 120.0
    network = Network(users=["Ann", "Ben", "Cleo"], spring=10 * (1 - np.eye(3)), delay=delay)
    (note,) = plan(network, links=2, objective="damping").notes
    assert note == ('The delay from user 1 ("Ann") to user 3 ("Cleo") is 120 s; delays are in seconds: is it right?')
