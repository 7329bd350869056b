"""The Cartesian device and its hand: a closed ledger, friction that only takes, rest that is rest."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm
from tests.device.support import BOOK, check_ledger, in_play, run

from cotouch.device import (
    CartesianPlant,
    Coupling,
    DeviceModel,
    PhantomPlant,
    ServoModel,
    SimulatedHand,
    advance,
    assemble,
)

FREE = Coupling(law="host_force")


@given(seed=st.integers(0, 10**6), coulomb=st.sampled_from([0.0, 0.3]), substep=st.sampled_from([1e-4, 1e-3]))
def test_books_close(seed, coulomb, substep):
    rng = np.random.default_rng(seed)
    hand = SimulatedHand(
        path=[(0.1 * n, *rng.uniform(-0.08, 0.08, 3)) for n in range(6)],
        amplitude=tuple(rng.uniform(0.0, 0.02, 3)),
        frequency=float(rng.uniform(0.5, 6.0)),
        grip=float(rng.choice([0.25, 1.0, 4.0])),
        begin=float(rng.choice([0.0, 0.1])),
        release=0.4,
        correction=3.0,
    )
    model = DeviceModel(
        plant=CartesianPlant(mass=0.1, viscous=0.2, coulomb=coulomb),
        servo=ServoModel(resolution=3e-5, force=8.0, period=tuple(rng.uniform(5e-4, 2e-3, 3)), substep=substep),
        coupling=Coupling(stiffness=800.0, damping=1.0),
        hand=hand,
        position=tuple(rng.uniform(-0.02, 0.02, 3)),
    )
    devices, state = assemble([model])
    check_ledger(devices, state, rng, within=1e-12)


def test_motion_under_a_held_force_is_the_exact_one():
    """Mass, friction and hand are linear: the matrix exponential, at second order."""
    m, b, k, force = 0.06 + 0.554, 0.0125 + 2 * 6.45, 2 * 135.0, 1.5
    A = np.array([[0.0, 1.0], [-k / m, -b / m]])
    rest = np.array([force / k, 0.0])
    expected = rest + expm(0.05 * A) @ -rest
    errors = []
    for substep in (2e-3, 1e-3, 5e-4):
        model = DeviceModel(coupling=FREE, hand=SimulatedHand(grip=2.0), servo=ServoModel(substep=substep))
        devices, state = assemble([model])
        state.host_force[0, 1] = force
        advance(devices, state, 0, 0.05)
        errors.append(np.abs(np.array([state.tip[0, 1], state.momentum[0, 1] / m]) - expected).max())
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / errors[1:]), 2.0, atol=0.05)
    assert state.tip[0, 0] == 0.0


def test_friction_stops_a_device_and_holds_it():
    devices, state = assemble([DeviceModel(plant=CartesianPlant(viscous=0.0, coulomb=0.26), coupling=FREE)])
    v = np.array([0.3, -0.4, 0.0])
    state.momentum[0, :3] = 0.06 * v
    state.ledger[0, BOOK["initial"]] = energy = 0.5 * 0.06 * 0.25
    places = run(devices, state, 0.5)
    np.testing.assert_array_equal(state.momentum[0], 0.0)
    assert state.ledger[0, BOOK["coulomb_loss"]] == pytest.approx(energy, rel=1e-12)
    # It slides m v² / (2 F), straight on.
    np.testing.assert_allclose(places[-1], energy / 0.26 * v / 0.5, rtol=1e-2, atol=1e-15)
    for push, moves in ((0.25, False), (0.27, True)):
        before = state.tip.copy()
        state.host_force[0, :3] = push * np.array([0.6, 0.8, 0.0])
        advance(devices, state, 0, float(state.time[0]) + 0.1)
        assert np.any(state.tip != before) == moves


@pytest.mark.parametrize(
    "plant", [CartesianPlant(coulomb=0.1), CartesianPlant(), PhantomPlant(), PhantomPlant(coulomb=0.0)]
)
@pytest.mark.parametrize("law", ["pspm", "spring", "host_force"])
def test_at_rest_stays_at_rest_exactly(plant, law):
    hand = SimulatedHand(correction=1.0, release=0.5)
    model = DeviceModel(plant=plant, hand=hand, coupling=Coupling(law=law), servo=ServoModel(resolution=3e-5))
    devices, state = assemble([model])
    run(devices, state, 1.0, 0.01)
    np.testing.assert_array_equal(state.tip[0], 0.0)
    np.testing.assert_array_equal(state.momentum[0], 0.0)
    np.testing.assert_array_equal(state.effort[0], 0.0)
    np.testing.assert_array_equal(state.ledger[0, :12], 0.0)


@pytest.mark.parametrize("plant", [CartesianPlant(), PhantomPlant(coulomb=0.0)])
class TestTakingHoldAndLettingGo:
    def test_hold_is_taken_at_zero_energy(self, plant):
        hand = SimulatedHand(path=(0.05, 0.0, 0.0), begin=0.1, blend=0.2)
        devices, state = assemble([DeviceModel(plant=plant, hand=hand, coupling=FREE)])
        state.momentum[0, 0] = 1e-3
        advance(devices, state, 0, 0.0)
        state.ledger[0, BOOK["initial"]] = state.ledger[0, BOOK["kinetic"]]
        advance(devices, state, 0, 0.0999)
        before = state.ledger[0].copy()
        advance(devices, state, 0, 0.1)
        after = state.ledger[0].copy()
        assert state.holding[0] == 1
        assert after[BOOK["hand_energy"]] == 0.0
        assert after[BOOK["human"]] == 0.0
        assert after[BOOK["kinetic"]] < before[BOOK["kinetic"]]
        assert after[BOOK["hand_loss"]] == pytest.approx(before[BOOK["kinetic"]] - after[BOOK["kinetic"]], rel=1e-2)
        run(devices, state, 3.0, 0.1)
        np.testing.assert_allclose(state.tip[0, :3], [0.05, 0.0, 0.0], atol=2e-3)

    def test_letting_go_supplies_nothing(self, plant):
        hand = SimulatedHand(amplitude=(0.02, 0.01, 0.0), frequency=3.0, release=0.2)
        devices, state = assemble([DeviceModel(plant=plant, hand=hand, coupling=FREE)])
        advance(devices, state, 0, 0.2 - 1e-9)
        before = state.ledger[0].copy()
        speed = np.diff(run_on(devices, state, [0.2 - 1e-9, 0.2 + 1e-5, 0.2 + 2e-5]), axis=0)
        assert state.holding[0] == 0
        after = state.ledger[0]
        assert after[BOOK["human"]] < before[BOOK["human"]]
        assert after[BOOK["kinetic"]] < before[BOOK["kinetic"]]
        assert after[BOOK["hand_energy"]] == 0.0
        np.testing.assert_allclose(speed[0], speed[1], rtol=1e-2, atol=1e-10)
        assert abs(after[BOOK["residual"]]) < 1e-12 * in_play(after)


def run_on(devices, state, times):
    places = []
    for time in times:
        advance(devices, state, 0, time)
        places.append(state.tip[0, :3].copy())
    return np.array(places)


def test_the_will_reacts_after_its_reaction_time_and_then_corrects():
    """A hand that is pushed aside gives way at first; one reaction time later it starts to come back."""
    path = (0.0, 0.0, 0.0)
    plain = assemble([DeviceModel(hand=SimulatedHand(path=path), coupling=FREE)])
    willed = assemble([DeviceModel(hand=SimulatedHand(path=path, correction=2.0, reaction=0.15), coupling=FREE)])
    trails = []
    for devices, state in (plain, willed):
        advance(devices, state, 0, 0.5)
        state.host_force[0, 0] = 2.0
        trails.append(run_on(devices, state, 0.5 + 1e-3 * np.arange(1, 4001))[:, 0])
    still, back = trails
    np.testing.assert_array_equal(still[:147], back[:147])
    assert not np.array_equal(still[:165], back[:165])
    assert still[-1] == pytest.approx(2.0 / 135.0, rel=1e-3)
    assert abs(back[-1]) < 0.2 * still[-1]


def test_the_correction_reaches_only_so_far():
    hand = SimulatedHand(correction=5.0, reach=0.01)
    devices, state = assemble([DeviceModel(hand=hand, coupling=FREE)])
    state.host_force[0, 2] = 10.0
    run(devices, state, 5.0, 0.01)
    assert np.linalg.norm(state.corrected[0]) == pytest.approx(0.01, rel=1e-9)
    assert state.tip[0, 2] == pytest.approx(10.0 / 135.0 - 0.01, rel=1e-3)


@pytest.mark.parametrize("grip", [0.25, 1.0, 4.0])
def test_grip_scales_stiffness_and_damping(grip):
    devices, state = assemble([DeviceModel(hand=SimulatedHand(grip=grip), coupling=FREE)])
    state.host_force[0, 0] = 1.0
    run(devices, state, 8.0, 0.1)
    assert state.tip[0, 0] == pytest.approx(1.0 / (grip * 135.0), rel=1e-3)


def test_a_path_is_followed_between_its_waypoints():
    hand = SimulatedHand(path=[(0.0, 0.0), (1.0, 0.1), (2.0, 0.1)], mass=0.0, stiffness=1e6, damping=100.0)
    devices, state = assemble([DeviceModel(hand=hand, coupling=FREE)])
    places = run(devices, state, 2.0, 0.25)
    np.testing.assert_allclose(places[:, 0], [0.025, 0.05, 0.075, 0.1, 0.1, 0.1, 0.1, 0.1], atol=1e-4)
