"""Every choice by several objectives: the same as one network at a time."""

import numpy as np
import pytest
from tests.network.support import five_users

from cotouch.errors import NetworkError
from cotouch.network import connected_graphs, mixing, rightmost_root
from cotouch.planning import survey


def test_values_are_those_of_the_networks_one_by_one():
    every = five_users().with_links(None)
    sides = {"mixing": {"time_unit": 0.05, "rounding": "up"}, "decay": {"objective": "decay"}}
    found = survey(every, links=4, objectives=sides, mass=2.0)
    assert found.graphs == tuple(connected_graphs(every, links=4))
    networks = [every.with_links(graph) for graph in found.graphs]
    mixings = [mixing(network, time_unit=0.05, rounding="up") for network in networks]
    np.testing.assert_allclose(found.values["mixing"], [one.value for one in mixings], atol=1e-9)
    np.testing.assert_allclose(found.values["decay"], [rightmost_root(n, mass=2.0).rate for n in networks], atol=1e-9)
    assert found.never == {"mixing": sum(one.cycle_period > 1 for one in mixings), "decay": 0}
    assert (found.choices, found.never["mixing"] > 0) == (210, True)


def test_refuses_what_is_too_much_to_show():
    size = 9
    ones = np.ones((size, size)) - np.eye(size)
    network = type(five_users())(users=[str(i) for i in range(size)], spring=ones, delay=ones)
    with pytest.raises(NetworkError, match="at most 200000"):
        survey(network, links=12, objectives={"decay": {"objective": "decay"}})
