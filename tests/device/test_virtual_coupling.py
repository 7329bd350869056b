"""The virtual coupling with a simulated device: the force that the body's step tells, held by the motors."""

import numpy as np
import pytest
from tests.device.support import BOOK

from cotouch.device import CartesianPlant, Coupling, DeviceModel, SimulatedHand, advance, assemble
from cotouch.mechanics import virtual_coupling_limit


def couple(stiffness, damping, viscous, hand, mass=0.1, push=0.0, until=2.0, seed=0, spread=1.0, kick=0.0):
    """Body steps of a free proxy, coupling implicit: what coupling and device's damping have made, and the device."""
    rng = np.random.default_rng(seed)
    model = DeviceModel(plant=CartesianPlant(viscous=viscous), hand=hand, coupling=Coupling(law="told"))
    devices, state = assemble([model])
    state.momentum[0, 0] = kick
    assert advance(devices, state, 0, 0.0)
    y, w, work, time = np.zeros(3), np.zeros(3), 0.0, 0.0
    made = []
    while time < until:
        T = 1e-3 * spread ** rng.uniform(-1.0, 0.0)
        q = state.sample[0, :3].copy()
        v = state.sample_velocity[0, :3].copy()
        f = push * rng.normal(size=3)
        mean = (2 * mass / T * w + stiffness * (q - y) + damping * v + f) / (2 * mass / T + stiffness * T + damping)
        tau = stiffness * (q - y - T * mean) + damping * (v - mean)
        y, w, work = y + T * mean, 2 * mean - w, work + T * float(tau @ mean)
        time += T
        state.told[0, :3] = -tau
        assert advance(devices, state, 0, time)
        made.append(state.books[0, BOOK["work"]] + work - state.books[0, BOOK["viscous_loss"]])
    return np.array(made), state


@pytest.mark.parametrize("spread", [1.0, 2.0])
@pytest.mark.parametrize("seed", range(4))
def test_within_the_limit_the_two_ports_are_passive(seed, spread):
    rng = np.random.default_rng(seed)
    hand = SimulatedHand(amplitude=tuple(rng.uniform(0.0, 0.03, 3)), frequency=float(rng.uniform(1.0, 20.0)))
    damping = 0.1
    # Two neighbouring periods differ by `spread` at most.
    limit = virtual_coupling_limit(device_damping=1.0, period=1e-3, damping=damping, spread=spread)
    made, _ = couple(limit, damping, 1.0, hand, push=20.0, seed=seed, spread=spread)
    assert made.max() <= 1e-12


@pytest.mark.parametrize(("factor", "grows"), [(0.9, False), (1.15, True)])
def test_a_device_rings_against_a_proxy_that_stands_still_above_the_limit_only(factor, grows):
    limit = virtual_coupling_limit(device_damping=1.0, period=1e-3)
    energy = []
    for until in (0.5, 2.5):
        _, state = couple(factor * limit, 0.0, 1.0, None, mass=1e9, kick=1e-3, until=until)
        p, x = state.momentum[0, 0], state.tip[0, 0]
        energy.append(0.5 * p**2 / 0.06 + 0.5 * factor * limit * x**2)
    assert (energy[1] > 9.0 * energy[0]) if grows else (energy[1] < energy[0] / 9.0)


def test_the_told_force_is_what_acts_until_the_next():
    devices, state = assemble([DeviceModel(plant=CartesianPlant(viscous=0.0), coupling=Coupling(law="told"))])
    state.told[0, :3] = [0.6, 0.0, -1.2]
    advance(devices, state, 0, 0.01)
    np.testing.assert_allclose(state.tip[0, :3], 0.5 * np.array([10.0, 0.0, -20.0]) * 1e-4, rtol=1e-9)
    assert state.books[0, BOOK["measured_work"]] == pytest.approx(state.books[0, BOOK["work"]], rel=1e-12)
    assert state.sample_time[0] == pytest.approx(0.01)
