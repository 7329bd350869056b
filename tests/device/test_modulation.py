"""PSPM behind a sampled servo gives away no more than its bound, whatever the hand, the clock and the encoder do."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.device.support import BOOK, Proxy, driven
from tests.thorough import examples

from cotouch.coupling import END, EnergyMessage, hear, message_of, modulation_bound
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
)


def setup(resolution: float = 0.0, window: float = 0.0, force: float = np.inf, **coupling: float):
    servo = ServoModel(resolution=resolution, window=window, force=force)
    return assemble([DeviceModel(servo=servo, coupling=Coupling(law="pspm", **coupling))])


@settings(max_examples=examples(150))
@given(
    seed=st.integers(0, 2**32 - 1),
    stiffness=st.floats(0.0, 7.0).map(lambda e: 10.0**e),
    damping=st.sampled_from([0.0, 1.0, 30.0]),
    period=st.sampled_from([1e-4, 1e-3, 5e-3, 5e-2]),
    resolution=st.sampled_from([0.0, 3e-5, 1e-3]),
    window=st.sampled_from([0.0, 0.02]),
    force=st.sampled_from([np.inf, 8.0]),
    pull=st.sampled_from([0.0, 0.3, 1.0]),
    cap=st.sampled_from([0.0, 1e-3, 1.0]),
    reserve=st.sampled_from([0.0, 1e-3]),
)
def test_no_more_than_the_bound_is_given_away(
    seed, stiffness, damping, period, resolution, window, force, pull, cap, reserve
):
    rng = np.random.default_rng(seed)
    ticks = 400
    limit = 20.0 if np.isinf(force) else force
    devices, state = setup(resolution, window, limit, stiffness=stiffness, damping=damping, cap=cap, reserve=reserve)
    times = np.cumsum(period * rng.uniform(0.2, 1.0, ticks))
    spans = np.diff(times, prepend=times[0] - period)[:, None]
    walk = np.cumsum(rng.normal(0.0, 0.05, (ticks, 3)), axis=0) * 0.1
    steps = spans * np.clip(walk + rng.normal(0.0, 0.1, (ticks, 3)), -1.0, 1.0) * (1.0 - pull)
    pulled = spans[:, 0] * pull * rng.choice([1.0, 1.0, -1.0, 0.0], ticks)
    wishes = np.cumsum(rng.normal(0.0, 2e-3, (ticks, 3)), axis=0)
    totals = np.cumsum(rng.choice([0.0, 0.0, 1e-3], ticks))
    totals = np.where(rng.uniform(size=ticks) < 0.3, 0.5 * totals, totals)  # overtaken, lost, repeated
    out = driven(devices, state, times, steps, pulled, wishes, totals)
    assert np.all(out.credited <= np.maximum.accumulate(totals))
    bound = modulation_bound(
        stiffness=stiffness,
        damping=damping,
        period=state.ledger[0, BOOK["longest"]],
        speed=state.ledger[0, BOOK["fastest"]],
        reserve=reserve,
        force=limit,
        resolution=resolution,
        axes=3,
    )
    scale = 1e-12 * (np.abs(np.diff(out.extracted)).sum() + out.sent[-1] + totals.max())
    assert np.all(out.extracted + out.sent - out.credited <= bound + scale)


def test_the_bound_is_reached_by_a_hand_that_pulls_along_the_force():
    """One step away, then one along the force: a stiff wall gives away nearly ½ k Δq², and no more ever after."""
    stiffness, step = 1e4, 1e-3
    devices, state = setup(stiffness=stiffness, damping=0.0, cap=1.0, reserve=0.0)
    ticks = 50
    times = 1e-3 * np.arange(ticks)
    places = np.zeros((ticks, 3))
    places[1, 0] = step  # against a wish at 0: no work yet, nothing stored
    places[2, 0] = 0.5 * step  # now there is a spring for what is there
    pulled = np.full(ticks, step)
    wishes = np.full((ticks, 3), [10.0, 0.0, 0.0])
    totals = np.full(ticks, 0.5 * stiffness * step**2)
    out = driven(devices, state, times, places, pulled, wishes, totals)
    bound = modulation_bound(stiffness=stiffness, damping=0.0, period=1e-3, speed=2.0)
    gained = out.extracted + out.sent - out.credited
    assert gained.max() <= bound
    assert gained.max() > 0.2 * bound
    assert np.all(state.effort[0] == 0.0)


def test_motion_that_the_encoder_does_not_see_is_paid_for():
    """A hand that moves to and fro within one step of the encoder, always along the force, while the wish jumps."""
    resolution, stiffness, gift, ticks = 1e-4, 1000.0, 0.01, 3000
    devices, state = setup(resolution, stiffness=stiffness, damping=0.0, cap=1.0, reserve=0.0)
    sign = np.where(np.arange(ticks) % 2 == 0, 1.0, -1.0)
    places, wishes = np.zeros((ticks, 3)), np.zeros((ticks, 3))
    places[:, 0] = np.diff(-0.499 * resolution * sign, prepend=0.0)
    wishes[:, 0] = 2e-3 * sign
    out = driven(devices, state, 1e-3 * np.arange(ticks), places, np.zeros(ticks), wishes, np.full(ticks, gift))
    assert state.ledger[0, BOOK["measured_work"]] == 0.0
    bound = modulation_bound(stiffness=stiffness, damping=0.0, period=1e-3, speed=0.0, force=2.0, resolution=resolution)
    gained = out.extracted + out.sent - out.credited
    assert gained.max() <= bound
    assert out.extracted[-1] > 0.9 * gift


def test_debt_switches_the_spring_off_and_damping_repays_it():
    devices, state = setup(stiffness=1e4, damping=5.0, cap=1.0, reserve=1.0)
    state.ends[0, END.energy] = -1e-4
    ticks = 400
    times = 1e-3 * np.arange(ticks)
    steps = np.zeros((ticks, 3))
    steps[:, 0] = 1e-4 * np.sin(0.05 * np.arange(ticks))
    out = driven(devices, state, times, steps, np.zeros(ticks), np.full((ticks, 3), 0.5), np.zeros(ticks))
    tank = -1e-4 - out.extracted
    in_debt = tank < 0.0
    assert 10 < in_debt.sum() < 300
    first = int(np.argmin(in_debt))
    speed = np.diff(out.motion[:, 0], prepend=0.0) / 1e-3
    np.testing.assert_allclose(out.efforts[1:first, 0], -5.0 * speed[1:first], rtol=1e-9, atol=1e-15)
    assert np.any(np.abs(out.efforts[first:, 0] + 5.0 * speed[first:]) > 1e-3)


def continuous(times, place, desired, k, b, cap):
    """The formula for a spring in continuous time [Lee & Huang 2010], evaluated at the ticks."""
    held, tank, sent = place[0], 0.0, 0.0
    trail = []
    for n in range(1, times.size):
        D = b * (place[n] - place[n - 1]) ** 2 / (times[n] - times[n - 1])
        R = 0.5 * k * (place[n] - held) ** 2 + tank + D
        P = 0.5 * k * (place[n] - desired[n]) ** 2
        held = desired[n] if P <= R else place[n] + (desired[n] - place[n]) * np.sqrt(R / P)
        tank = R - 0.5 * k * (place[n] - held) ** 2
        out = max(tank - cap, 0.0)
        tank, sent = tank - out, sent + out
        trail.append((held, tank, sent))
    return np.array(trail)


def test_quick_servo_is_the_continuous_formula():
    """At first order in the servo's period; both with damping and modulation at work."""
    k, b, cap = 500.0, 3.0, 2e-3
    errors = []
    for ticks in (2001, 4001, 8001, 16001):
        times = np.linspace(0.0, 1.0, ticks)
        place = 0.02 * np.sin(7.0 * times)
        desired = 0.03 * np.sin(11.0 * times + 0.5) * times
        devices, state = setup(stiffness=k, damping=b, cap=cap)
        steps = np.zeros((ticks, 3))
        steps[1:, 0] = np.diff(place)
        wishes = np.zeros((ticks, 3))
        wishes[:, 0] = desired
        out = driven(devices, state, times, steps, np.zeros(ticks), wishes, np.zeros(ticks))
        expected = continuous(times, place, desired, k, b, cap)
        assert out.sent[-1] > 0.02
        errors.append(abs(out.sent[-1] - expected[-1, 2]) / expected[-1, 2])
        force_of_continuous = k * (expected[:, 0] - place[1:]) - b * np.diff(place) / np.diff(times)
        errors[-1] += np.abs(out.efforts[1:, 0] - force_of_continuous).mean() / np.abs(force_of_continuous).mean()
    ratios = np.array(errors[:-1]) / np.array(errors[1:])
    assert errors[-1] < 5e-3
    assert np.all(ratios > 1.7)


@pytest.mark.parametrize("hand", [None, SimulatedHand(amplitude=(0.02,), frequency=1.0)])
@pytest.mark.parametrize("stiffness", [1e2, 1e4, 1e6])
def test_stable_far_beyond_the_critical_stiffness(hand, stiffness):
    """Against a wall at rest nothing but the bound is ever put into device and hand."""
    coupling = Coupling(stiffness=stiffness, damping=2.0)
    model = DeviceModel(servo=ServoModel(resolution=1e-5, window=0.0), coupling=coupling, hand=hand)
    devices, state = assemble([model])
    state.momentum[0, 0] = 0.06 * 0.2
    state.ledger[0, BOOK["initial"]] = 0.5 * 0.06 * 0.2**2
    most = 0.0
    for k in range(1, 3001):
        assert advance(devices, state, 0, 1e-3 * k)
        most = max(most, state.ledger[0, BOOK["work"]])
    ledger = state.ledger[0]
    bound = modulation_bound(
        stiffness=stiffness,
        damping=2.0,
        period=ledger[BOOK["longest"]],
        speed=ledger[BOOK["fastest"]],
        reserve=1e-3,
        force=float(np.abs(state.force).max()) + stiffness * 1e-3,
        resolution=1e-5,
    )
    assert most <= bound
    if hand is None and stiffness <= 1e4:  # 400 times the critical one
        assert ledger[BOOK["kinetic"]] < 1e-4 * ledger[BOOK["initial"]]


def test_the_plain_spring_gives_away_without_end():
    """What PSPM is for: the same wall as a plain sampled spring."""
    model = DeviceModel(servo=ServoModel(window=0.0), coupling=Coupling(law="spring", stiffness=1e4, damping=0.0))
    devices, state = assemble([model])
    state.desired[0, 0] = 1e-3
    advance(devices, state, 0, 0.5)
    assert state.ledger[0, BOOK["work"]] > 10.0


@pytest.mark.parametrize("plant", [CartesianPlant(coulomb=0.05), PhantomPlant()])
@pytest.mark.parametrize(("servo", "body"), [(1e-3, 1e-3), (2e-3, 5e-4), (2.5e-4, 0.01), (1e-3, 0.0371)])
def test_two_ports_with_a_proxy_are_passive(plant, servo, body):
    """`∫τᵀq̇ dt + Σ τ_iᵀŵ T <= d²` over random hands, pushes at the proxy, clocks, losses and delays."""
    rng = np.random.default_rng(1)
    periods = tuple(servo * rng.uniform(0.5, 1.0, 7))
    for trial in range(3):
        hand = SimulatedHand(
            path=[(0.3 * n, *rng.uniform(-0.05, 0.05, 3)) for n in range(8)],
            amplitude=tuple(rng.uniform(0.0, 0.01, 3)),
            frequency=float(rng.uniform(1.0, 8.0)),
            grip=float(rng.choice([0.25, 1.0, 4.0])),
            release=1.5,
        )
        model = DeviceModel(
            plant=plant,
            hand=hand,
            servo=ServoModel(period=periods, resolution=3e-5, force=8.0),
            coupling=Coupling(stiffness=10.0 ** rng.uniform(2.0, 4.5), damping=2.0, cap=0.01),
        )
        devices, state = assemble([model])
        place = state.tip[0, :3].copy()
        proxy = Proxy(0.1, 10.0 ** rng.uniform(2.0, 4.5), 1.0, 0.01, place)
        time, commanded, worst = 0.0, [(place, EnergyMessage())], 0.0
        heard = [(place, EnergyMessage())]
        while time < 2.0:
            T = body * rng.uniform(0.3, 1.0)
            time += T
            assert advance(devices, state, 0, time)
            heard.append((state.sample[0, :3].copy(), message_of(state.ends[0])))
            desired, message = heard[-1 - min(int(rng.integers(0, 4)), len(heard) - 1)]
            push = rng.normal(0.0, 3.0, 3)
            proxy.step(T, push, desired, message)
            commanded.append((proxy.place, proxy.message))
            if rng.uniform() < 0.7:  # else lost
                desired, message = commanded[-1 - min(int(rng.integers(0, 4)), len(commanded) - 1)]
                state.desired[0, :3] = desired
                hear(state.ends[0], message)
            worst = max(worst, state.ledger[0, BOOK["work"]] + proxy.work)
        ledger = state.ledger[0]
        bound = modulation_bound(
            stiffness=model.coupling.stiffness,
            damping=2.0,
            period=ledger[BOOK["longest"]],
            speed=2.0 * ledger[BOOK["fastest"]],
            reserve=1e-3,
            force=8.0,
            resolution=3e-5,
            axes=3,
        )
        assert worst <= bound, trial
        assert ledger[BOOK["work"]] != 0.0
        assert abs(proxy.work) > 1e-6


@pytest.mark.parametrize("plant", [CartesianPlant(coulomb=0.05), PhantomPlant()])
def test_between_hand_and_proxy_every_joule_is_somewhere(plant):
    """With exact encoders: springs, tanks and messages under way hold exactly what both ports have put in."""
    rng = np.random.default_rng(5)
    hand = SimulatedHand(amplitude=(0.02, 0.01, -0.01), frequency=3.0, release=0.8)
    coupling = Coupling(stiffness=2000.0, damping=2.0, cap=2e-3)
    devices, state = assemble([DeviceModel(plant=plant, hand=hand, coupling=coupling, servo=ServoModel(force=8.0))])
    proxy = Proxy(0.1, 1500.0, 1.0, 2e-3, np.zeros(3))
    went = 0.0
    for n in range(1, 1201):
        T = 1e-3 * rng.integers(1, 4)
        assert advance(devices, state, 0, float(state.time[0]) + T)
        proxy.step(T, rng.normal(0.0, 3.0, 3), state.sample[0, :3], message_of(state.ends[0]))
        ledger = state.ledger[0]
        here, there = state.ends[0], proxy.rows[0]
        held = here[END.energy] + here[END.lost] + here[END.given] - there[END.received]
        held += there[END.energy] + there[END.lost] + there[END.given] - here[END.received]
        went += abs(ledger[BOOK["work"]] + proxy.work)
        assert abs(ledger[BOOK["work"]] + proxy.work + held) < 1e-11, n
        if rng.uniform() < 0.7:
            state.desired[0, :3] = proxy.place
            hear(state.ends[0], proxy.message)
    assert min(state.ends[0, END.given], proxy.message.given) > 1e-4
    assert went > 1.0


def test_declared_damping_is_credited_by_positions_alone_and_never_more_than_was_lost():
    rng = np.random.default_rng(2)
    for resolution in (0.0, 1e-5):
        model = DeviceModel(
            plant=CartesianPlant(viscous=0.5),
            servo=ServoModel(resolution=resolution),
            coupling=Coupling(assumed_damping=0.5, stiffness=2000.0),
            hand=SimulatedHand(amplitude=tuple(rng.uniform(0.0, 0.02, 3)), frequency=7.0),
        )
        devices, state = assemble([model])
        for k in range(1, 500):
            advance(devices, state, 0, 1e-3 * k)
            declared, lost = state.ledger[0, BOOK["declared"]], state.ledger[0, BOOK["viscous_loss"]]
            assert declared <= lost * (1.0 + 1e-9)
        assert declared > (0.95 if resolution == 0.0 else 0.5) * lost


def test_messages_of_energy_may_be_lost_repeated_and_overtaken():
    """Whatever arrives, the device ends with the largest total, credited once."""
    rng = np.random.default_rng(3)
    totals = np.cumsum(rng.uniform(0.0, 1e-3, 40))
    device = SimulatedDevice(DeviceModel(coupling=Coupling(cap=10.0)))
    messages = [total for n, total in enumerate(totals) for _ in range(rng.integers(0, 3)) if n < 39]
    rng.shuffle(messages)
    best = 0.0
    for n, total in enumerate([*messages, totals[-1]], start=1):
        best = max(best, total)
        device.command(message=EnergyMessage(given=total))
        sample = device.advance(1e-3 * n)
        assert device.ledger["tank"] == pytest.approx(best, rel=1e-12)
        assert sample.message.given == 0.0
    assert device.ledger["tank"] == pytest.approx(totals[-1], rel=1e-12)


def test_what_the_tank_cannot_keep_is_lost():
    device = SimulatedDevice(DeviceModel(coupling=Coupling(cap=0.01)))
    device.command(message=EnergyMessage(given=0.05))
    sample = device.advance(0.01)
    assert sample.message == EnergyMessage(received=0.05, tank=pytest.approx(0.01, rel=1e-12))
    assert device.ledger["tank"] == pytest.approx(0.01, rel=1e-12)
