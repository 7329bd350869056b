"""Objectives of what hands feel: drag and impedance, against brute force with dense matrices."""

import numpy as np
import pytest
from tests.planning.support import small_network
from tests.planning.test_limits import drag_of, left_by

from cotouch import plan
from cotouch.network import Network, closed_loop, connected_graphs
from cotouch.planning import first_choice

OMEGA = 2.0 * np.pi * np.geomspace(0.2, 2.0, 6)


def felt_of(network: Network, mass: float = 1.0, damping: float = 0.0, stiffness: float = 0.0) -> float:
    """The largest of `|Z_i - Z|` over users and tones, by LAPACK."""
    loop, _ = closed_loop(network, mass, damping, stiffness)
    largest = 0.0
    for s in 1j * OMEGA:
        matrix = np.diag((loop.mass * s + loop.drag) * s + loop.rigid)
        matrix[loop.first, loop.second] -= loop.spring * np.exp(-s * loop.to_first)
        matrix[loop.second, loop.first] -= loop.spring * np.exp(-s * loop.to_second)
        own = 1.0 / (s * np.linalg.inv(matrix).diagonal())
        largest = max(largest, float(np.abs(own - (mass * s + damping + stiffness / s)).max()))
    return largest


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("objective", ["drag", "feel"])
def test_every_way_finds_what_brute_force_finds(objective, seed):
    network, links = small_network(np.random.default_rng(seed))
    thing = {"mass": 2.0, "damping": 3.0, "stiffness": 7.0 * (seed % 2)}
    value = {
        graph: felt_of(network.with_links(graph), **thing)
        if objective == "feel"
        else drag_of(network.with_links(graph)) + thing["damping"]
        for graph in connected_graphs(network, links=links)
    }
    for method in ("enumerate", "local") + (("bound",) if objective == "drag" else ()):
        found = plan(network, links=links, objective=objective, method=method, starts=16, seed=seed, **thing)
        assert found.best.value == pytest.approx(min(value.values()), rel=1e-9)
        assert value[found.best.links] == pytest.approx(found.best.value, rel=1e-9)
        assert found.best.drag == pytest.approx(drag_of(network.with_links(found.best.links)) + 3.0, rel=1e-12)
        assert found.status == ("proved" if method == "enumerate" or objective == "drag" else "best found")


def test_slow_tones_feel_the_drag():
    """Far below all rates of the loop a hand feels the object's mass and drag, and nothing else."""
    network = Network(users=list("abc"), spring=50 * (1 - np.eye(3)), delay=1e-4 * (1 - np.eye(3)))
    found = plan(network, links=3, objective="feel", mass=1e-3)
    assert found.best.value == pytest.approx(found.best.drag, rel=1e-2)
    assert found.best.drag == pytest.approx(2 * 3 * 50 * 2e-4)


def test_limits_keep_a_plan_from_the_least_drag_of_all():
    network, links = small_network(np.random.default_rng(1))
    free = plan(network, links=links, objective="drag", method="local", starts=1)
    degree = max(np.bincount(np.array(free.best.links).ravel()))
    bound = plan(network, links=links, objective="drag", max_degree=int(degree) - 1, method="bound")
    every = plan(network, links=links, objective="drag", max_degree=int(degree) - 1)
    assert free.status == bound.status == "proved"
    assert bound.best.value == pytest.approx(every.best.value, rel=1e-12)
    assert bound.best.value > free.best.value


def test_the_worst_loss_counts_for_what_is_felt():
    network = Network(
        users=list("abcd"),
        spring=10.0 * (1 - np.eye(4)),
        delay=0.01 * np.array([[0, 1, 2, 3], [2, 0, 4, 5], [3, 4, 0, 1], [5, 1, 2, 0]]),
    )
    found = plan(network, links=4, objective="feel", lost="user")
    value = {}
    for graph in connected_graphs(network, links=4):
        cases = [network.with_links(graph), *left_by(network.with_links(graph), "user")]
        if all(case.is_connected() for case in cases):
            value[graph] = max(map(felt_of, cases))
    assert found.best.value == pytest.approx(min(value.values()), rel=1e-9)


def test_the_lightest_links_come_first_without_a_kernel():
    network, links = small_network(np.random.default_rng(3))
    first = first_choice(network, links=links, objective="drag", damping=2.0)
    best = plan(network, links=links, objective="drag", damping=2.0).best
    assert first is not None
    assert first.value == pytest.approx(drag_of(network.with_links(first.links)) + 2.0)
    assert first.value >= best.value * (1.0 - 1e-12)
