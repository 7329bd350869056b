"""What is said while kernels compile: no kernel is needed for it, and it is about right."""

import subprocess
import sys

import numpy as np
import pytest
from tests.planning.support import five_users
from tests.planning.test_flood import crowd

from cotouch import plan
from cotouch.network import rightmost_root
from cotouch.planning import first_choice

NO_KERNEL = """
import numba.core.dispatcher
def refuse(*_, **__):
    raise AssertionError("a kernel was compiled")
numba.core.dispatcher.Dispatcher.compile = refuse
from tests.planning.test_flood import crowd
from cotouch.planning import first_choice
for objective in ("decay", "consensus", "damping"):
    for lost in ("nothing",) if objective == "consensus" else ("nothing", "link", "user"):
        more = {} if objective == "decay" else {"rounding": "nearest"}
        assert first_choice(crowd(9, 1), links=16, objective=objective, lost=lost, **more) is not None
"""


def test_no_kernel_is_needed():
    done = subprocess.run([sys.executable, "-c", NO_KERNEL], capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stderr


def test_few_choices_are_all_tried():
    found, best = (pick(five_users(), links=6, objective="decay") for pick in (first_choice, plan))
    assert found is not None
    assert found.tried == 205
    assert found.value == pytest.approx(rightmost_root(five_users().with_links(found.links)).rate, rel=1e-3)
    assert found.links == best.best.links


def test_of_many_choices_it_is_far_better_than_chance_and_keeps_to_the_limits():
    network = crowd(20, 3)
    limits = {"require": [(0, 1)], "forbid": [(2, 3)], "max_degree": 12, "damping_limit": 150.0}
    found = first_choice(network, links=40, objective="decay", **limits)
    assert found is not None
    linked = network.with_links(found.links)
    assert len(linked.links) == 40
    assert (0, 1) in linked.links
    assert (2, 3) not in linked.links
    assert linked.adjacency().sum(axis=1).max() <= 12
    decay = rightmost_root(linked)
    assert decay.sync_damping.max() <= 150.0
    assert found.value == pytest.approx(decay.rate, rel=1e-3)
    rng = np.random.default_rng(0)
    tree = [(int(rng.integers(b)), b) for b in range(1, 20)]
    others = rng.permutation([link for link in network.with_links(None).links if link not in tree])
    chance = network.with_links([*tree, *map(tuple, others[:21].tolist())])
    assert found.value < 2 * rightmost_root(chance).rate


def test_none_where_limits_leave_none():
    assert first_choice(crowd(9, 1), links=16, objective="decay", damping_limit=1.0) is None
