"""The virtual coupling with a simulated device: the force that the body's step tells, held by the motors."""

import numpy as np
import pytest
from tests.device.support import BOOK

from cotouch.coupling import virtual_coupling_limit
from cotouch.device import CartesianPlant, Coupling, DeviceModel, ServoModel, SimulatedHand, advance, assemble


def couple(
    stiffness,
    damping,
    viscous,
    hand,
    mass=0.1,
    push=0.0,
    until=2.0,
    seed=0,
    spread=1.0,
    kick=0.0,
    dry=0.0,
    resolution=0.0,
    path=None,
):
    """Body steps of a free proxy, coupling implicit: what coupling and device's friction have made, and the device."""
    rng = np.random.default_rng(seed)
    plant, servo = CartesianPlant(viscous=viscous, coulomb=dry), ServoModel(resolution=resolution)
    model = DeviceModel(plant=plant, hand=hand, coupling=Coupling(law="host_force"), servo=servo)
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
        state.host_force[0, :3] = -tau
        assert advance(devices, state, 0, time)
        paid = state.ledger[0, BOOK["viscous_loss"]] + state.ledger[0, BOOK["coulomb_loss"]]
        made.append(state.ledger[0, BOOK["work"]] + work - paid)
        if path is not None:
            path.append(T * float(np.linalg.norm(mean)))
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


@pytest.mark.parametrize("resolution", [1e-5, 1e-4, 1e-3])
@pytest.mark.parametrize("seed", range(3))
def test_what_encoders_falsify_is_paid_by_dry_friction_and_the_proxys_path(seed, resolution):
    """Hands and pushes at random, stiffness at the limit that dry friction sets, and never more than the bound."""
    rng = np.random.default_rng(seed)
    hand = SimulatedHand(amplitude=tuple(rng.uniform(0.0, 0.03, 3)), frequency=float(rng.uniform(1.0, 20.0)))
    unseen, dry, viscous, damping = 0.5 * 3.0**0.5 * resolution, 0.3, 2.0, 0.05
    limit = virtual_coupling_limit(
        device_damping=viscous, period=1e-3, damping=damping, unseen=unseen, dry=dry, shortest=1e-3
    )
    assert limit > 0.0
    path = []
    made, _ = couple(limit, damping, viscous, hand, push=20.0, seed=seed, dry=dry, resolution=resolution, path=path)
    bound = (limit + 2.0 * damping / 1e-3) * unseen * np.cumsum(path)
    assert np.all(made <= bound + 1e-12)


def test_without_dry_friction_an_encoder_gives_energy_away():
    """Which is why the limit is 0 then: at rest in the hand beside a proxy that is pushed about."""
    made = [
        couple(800.0, 0.0, 1.0, SimulatedHand(amplitude=(0.01,), frequency=1.0), resolution=1e-3, seed=seed)[0].max()
        for seed in range(2)
    ]
    assert max(made) > 1e-4
    assert virtual_coupling_limit(device_damping=1.0, period=1e-3, unseen=1e-3) == 0.0


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
    devices, state = assemble([DeviceModel(plant=CartesianPlant(viscous=0.0), coupling=Coupling(law="host_force"))])
    state.host_force[0, :3] = [0.6, 0.0, -1.2]
    advance(devices, state, 0, 0.01)
    np.testing.assert_allclose(state.tip[0, :3], 0.5 * np.array([10.0, 0.0, -20.0]) * 1e-4, rtol=1e-9)
    assert state.ledger[0, BOOK["measured_work"]] == pytest.approx(state.ledger[0, BOOK["work"]], rel=1e-12)
    assert state.sample_time[0] == pytest.approx(0.01)
