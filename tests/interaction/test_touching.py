"""Tools in one peer at a time move as in the batch: the kernels are the same."""

import numpy as np

from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch, run_peers

TOML = """
[network]
users = ["Ann", "Ben"]
spring = [[0, 5], [5, 0]]
delay = [[0, 0.01], [0.015, 0]]

[body]
kind = "lattice"
shape = [4, 4, 3]
mass = 0.3
stiffness = 200
damping = 0.05
ground = "z-"
ground_stiffness = 500

[steps]
duration = 0.5
random = {low = 0.001, high = 0.004}

[channel]
jitter = {scale = 0.004}
loss = 0.1

[[tools]]
user = 2
at = [0.012, 0.014, 0.034]
[tools.hand]
path = [[0, 0, 0, 0], [0.2, 0, 0, -0.02], [0.3, 0, 0, -0.02], [0.4, 0, 0, 0.02]]
stiffness = 300
[tools.device]
coupling = "pspm"

[[tools]]
user = 1
at = [0.011, 0.016, 0.034]
friction = 0.4
[tools.hand]
path = [[0, 0, 0, 0], [0.2, 0.01, 0, -0.02], [0.4, 0, 0, 0.02]]
stiffness = 300
"""


def test_peers_and_batch_move_alike():
    prepared = prepare(Scenario.from_toml(TOML))
    batch, peers = run_batch(prepared), run_peers(prepared)
    assert batch.tools is not None
    assert prepared.tool == [1, 0]
    assert batch.tools.touching.max(axis=1).min() >= 1.0
    for user in range(2):
        steps = peers.tools[user].shape[0]
        assert steps == batch.taken[user]
        # Rounding differs where the compiler joins the same kernels in another order, and contact amplifies it.
        assert np.abs(peers.tools[user][:, 0] - batch.tools.place[user, 1 : steps + 1, :3]).max() < 1e-7
        assert np.abs(peers.position[user][-1] - batch.position[user]).max() < 1e-7
        in_play = max(*(report.kinetic + report.elastic + report.proxy for report in peers.reports[user]), 1e-12)
        assert max(abs(report.residual) for report in peers.reports[user]) < 1e-12 * in_play


def test_a_run_leaves_the_prepared_tools_as_they_were():
    prepared = prepare(Scenario.from_toml(TOML))
    first, second = run_batch(prepared), run_batch(prepared)
    assert first.tools is not None
    assert second.tools is not None
    assert np.array_equal(first.tools.place, second.tools.place)
    assert np.array_equal(first.tools.force, second.tools.force)
