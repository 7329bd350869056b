"""Sensor, clock and actuator."""

import numpy as np
import pytest
from tests.device.support import BOOK, run

from cotouch.coupling import END
from cotouch.device import (
    CartesianPlant,
    Coupling,
    DeviceModel,
    PhantomPlant,
    ServoModel,
    SimulatedDevice,
    SimulatedHand,
    advance,
    assemble,
    critical_stiffness,
    rings,
)
from cotouch.errors import DeviceError

HAND = SimulatedHand(amplitude=(0.02, 0.01, -0.015), frequency=2.0)


def test_places_are_measured_in_steps_of_the_encoder():
    devices, state = assemble([DeviceModel(hand=HAND, servo=ServoModel(resolution=1e-3))])
    seen = set()
    for k in range(1, 300):
        advance(devices, state, 0, 1e-3 * k)
        steps = state.sample[0, :3] / 1e-3
        np.testing.assert_allclose(steps, np.round(steps), atol=1e-9)
        assert np.all(np.abs(state.sample[0, :3] - state.tip[0, :3]) <= 0.5001e-3)
        seen.add(round(float(steps[0])))
    assert len(seen) > 10


@pytest.mark.parametrize("periods", [(1e-3,), (1e-3, 2.5e-3, 0.7e-3)])
def test_velocity_is_the_mean_over_the_window(periods):
    devices, state = assemble([DeviceModel(hand=HAND, servo=ServoModel(period=periods, window=0.02))])
    times, places = [0.0], [state.tip[0, :3].copy()]
    for k in range(200):
        times.append(times[-1] + periods[k % len(periods)])
        advance(devices, state, 0, times[-1])
        places.append(state.tip[0, :3].copy())
        oldest = next(n for n, t in enumerate(times) if t >= times[-1] - 0.02 * (1 + 1e-9))
        expected = (places[-1] - places[oldest]) / (times[-1] - times[oldest])
        np.testing.assert_allclose(state.sample_velocity[0, :3], expected, rtol=1e-9, atol=1e-12)


def test_velocity_of_a_told_device_is_since_the_last_sample():
    devices, state = assemble(
        [DeviceModel(hand=HAND, coupling=Coupling(law="host_force"), servo=ServoModel(window=0.02))]
    )
    advance(devices, state, 0, 0.0)
    time = 0.0
    for T in np.random.default_rng(0).uniform(1e-4, 5e-3, 100):
        before = state.tip[0, :3].copy()
        time += T
        advance(devices, state, 0, time)
        np.testing.assert_allclose(state.sample_velocity[0, :3], (state.tip[0, :3] - before) / T, rtol=1e-6, atol=1e-12)


def test_ticks_come_at_the_given_periods_however_the_device_is_advanced():
    model = DeviceModel(hand=HAND, servo=ServoModel(period=(1e-3, 2e-3, 0.5e-3)), coupling=Coupling(stiffness=300.0))
    once, often = assemble([model]), assemble([model])
    advance(*once, 0, 0.7)
    rng = np.random.default_rng(0)
    for time in [*np.sort(rng.uniform(0.0, 0.7, 500)), 0.7]:
        advance(*often, 0, time)
    assert once[1].ticks[0] == often[1].ticks[0] == 601
    np.testing.assert_allclose(once[1].tip, often[1].tip, atol=1e-6)
    advance(*once, 0, 0.7)  # a second time: nothing more happens
    assert once[1].ticks[0] == 601


def test_force_is_saturated_with_its_direction_kept():
    coupling = Coupling(law="spring", stiffness=1e4, damping=0.0)
    devices, state = assemble([DeviceModel(hand=HAND, servo=ServoModel(force=3.0), coupling=coupling)])
    state.desired[0, :3] = [0.3, -0.4, 0.0]
    advance(devices, state, 0, 0.0)
    np.testing.assert_allclose(state.force[0, :3], [1.8, -2.4, 0.0], rtol=1e-12)
    assert state.ledger[0, BOOK["saturated"]] == 1.0


def test_work_measured_is_work_done_where_encoders_are_exact():
    for plant in (CartesianPlant(), PhantomPlant()):
        devices, state = assemble([DeviceModel(plant=plant, hand=HAND, coupling=Coupling(stiffness=300.0))])
        run(devices, state, 1.0)
        ledger = state.ledger[0]
        assert ledger[BOOK["measured_work"]] == pytest.approx(ledger[BOOK["work"]], rel=1e-9)
        assert abs(ledger[BOOK["work"]]) > 1e-3
        # What the block holds is what was put in.
        held = ledger[BOOK["tank"]] + state.ends[0, END.lost]
        assert held == pytest.approx(-ledger[BOOK["work"]], rel=1e-9)


@pytest.mark.parametrize(
    ("hand", "lag", "expected"),
    [
        (None, 0, 25.0),
        (None, 1, 25.0 / 3.0),
        (SimulatedHand(), 0, 12_948.0),
        (SimulatedHand(), 1, 4_321.0),
    ],
)
def test_critical_stiffness_of_the_sampled_wall(hand, lag, expected):
    assert critical_stiffness(CartesianPlant(), hand, lag=lag) == pytest.approx(expected, rel=2e-3)


def test_critical_stiffness_goes_with_the_rate():
    quick = critical_stiffness(CartesianPlant(viscous=0.2), period=2.5e-4)
    assert quick == pytest.approx(2 * 0.2 / 2.5e-4, rel=5e-3)


@pytest.mark.parametrize("stiffness", [24.5, 25.5])
def test_rings_above_only(stiffness):
    model = DeviceModel(coupling=Coupling(law="spring", stiffness=stiffness, damping=0.0), servo=ServoModel(window=0.0))
    assert rings(model, 60.0, 1e-3) == (stiffness > 25.0)


def test_devices_of_a_table_do_not_touch_each_other():
    """Two in turn are as each alone, to the bit."""
    models = [
        DeviceModel(plant=PhantomPlant(), hand=HAND, servo=ServoModel(period=(1e-3, 3e-3), window=0.01)),
        DeviceModel(hand=SimulatedHand(path=[(0.0, 0.0), (0.5, 0.05)]), servo=ServoModel(resolution=1e-5)),
    ]
    devices, state = assemble(models)
    assert advance(devices, state, 0, 0.3)
    assert advance(devices, state, 1, 0.3)
    for d, model in enumerate(models):
        alone_devices, alone = assemble([model])
        advance(alone_devices, alone, 0, 0.3)
        np.testing.assert_array_equal(state.tip[d], alone.tip[0])
        np.testing.assert_array_equal(state.ledger[d], alone.ledger[0])


def test_a_wish_that_is_no_number_switches_the_spring_off_and_nothing_else():
    devices, state = assemble([DeviceModel(hand=HAND, coupling=Coupling(stiffness=300.0))])
    advance(devices, state, 0, 0.1)
    state.desired[0, 1] = np.nan
    for _ in range(20):
        advance(devices, state, 0, float(state.time[0]) + 1e-3)
        np.testing.assert_allclose(state.force[0], -2.0 * state.sample_velocity[0], atol=1e-12)
    state.desired[0, 1] = 0.0
    advance(devices, state, 0, 0.2)
    assert state.ledger[0, BOOK["spring_energy"]] > 0.0
    assert abs(state.ledger[0, BOOK["residual"]]) < 1e-12


class TestSimulatedDevice:
    def test_exchange_holds_a_force_for_a_period(self):
        device = SimulatedDevice(DeviceModel(plant=CartesianPlant(viscous=0.0), coupling=Coupling(law="host_force")))
        sample = device.exchange([0.0, 0.06, 0.0])
        assert sample.time == pytest.approx(1e-3)
        np.testing.assert_allclose(sample.position, [0.0, 0.5e-6, 0.0], rtol=1e-9)
        np.testing.assert_allclose(sample.velocity, [0.0, 0.5e-3, 0.0], rtol=1e-9)
        np.testing.assert_array_equal(sample.force, [0.0, 0.06, 0.0])
        assert sample.finite
        assert not sample.limited

    def test_it_is_the_same_as_the_table(self):
        model = DeviceModel(hand=HAND, coupling=Coupling(stiffness=200.0))
        device = SimulatedDevice(model)
        devices, state = assemble([model])
        for k in range(1, 50):
            sample = device.advance(2e-3 * k)
            advance(devices, state, 0, 2e-3 * k)
            np.testing.assert_array_equal(sample.position, state.sample[0, :3])
            np.testing.assert_array_equal(sample.force, state.force[0, :3])

    def test_it_refuses_what_makes_no_sense(self):
        device = SimulatedDevice(DeviceModel())
        device.advance(0.5)
        with pytest.raises(DeviceError, match=r"until is 0\.1 s; it must be finite, at least 0\.5"):
            device.advance(0.1)
        with pytest.raises(DeviceError, match='law is "pspm"; to exchange forces it must be "host_force"'):
            device.exchange([0.0])
        with pytest.raises(DeviceError, match=r"desired is .*; it must be one to three finite numbers"):
            device.command(desired=[np.nan, 0.0, 0.0])

    def test_a_motion_without_bounds_is_reported(self):
        device = SimulatedDevice(
            DeviceModel(coupling=Coupling(law="spring", stiffness=1e9, damping=0.0), servo=ServoModel(window=0.0))
        )
        device.command(desired=[1e-3])
        assert not device.advance(5.0).finite
