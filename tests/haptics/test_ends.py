"""The coupling of two processes: two-port passivity whatever the mailboxes do, and the share that is felt."""

import numpy as np
import pytest
from tests.haptics.two_ports import Body, check_passive, circumstances, run

from cotouch.coupling import EnergyMessage
from cotouch.device import PRESETS
from cotouch.haptics import (
    Cause,
    DeviceEnd,
    DeviceReading,
    EndOptions,
    Flag,
    Order,
    ProxyEnd,
    SafetyLimits,
    ServoCore,
    SimulatedOnClock,
    norm,
    simulated_model,
)

SPECS = {"phantom": PRESETS["phantom"], "cartesian": PRESETS["phantom"], "touch": PRESETS["touch"]}


def made(variant: str, clock: list[float], sweep: float = 1.0) -> SimulatedOnClock:
    return SimulatedOnClock(simulated_model(variant, sweep=sweep), SPECS[variant], clock=lambda: clock[0])


@pytest.mark.parametrize("seed", range(24))
def test_two_ports_are_passive_whatever_the_rates_and_boards(seed: int):
    """Servo at 1 kHz, peer at 100 to 1000 Hz, nonlinear device with a hand, mailboxes late or unread: no violation."""
    rng = np.random.default_rng(seed)
    variant = ["phantom", "cartesian", "touch"][seed % 3]
    spec, clock = SPECS[variant], [0.0]
    stiffness = float(rng.uniform(50.0, min(2000.0, spec.stiffness)))
    options = EndOptions(
        stiffness=stiffness, damping=float(rng.uniform(0.5, 4.0)), initial_energy=10.0 ** rng.uniform(-4, -2)
    )
    ran = run(
        made(variant, clock, sweep=float(rng.uniform(0.2, 3.0))),
        spec,
        seconds=1.5,
        peer=float(rng.uniform(100.0, 1000.0)),
        clock=clock,
        options=options,
        seed=seed,
        **circumstances(rng),
    )
    check_passive(ran, spec)


def test_a_hand_that_follows_the_force_gets_no_more_than_the_bound():
    """The worst hand: it goes where it is pushed, as fast as it likes; the proxy runs away before it."""
    rng = np.random.default_rng(3)
    for _ in range(6):
        options = EndOptions(
            stiffness=float(rng.uniform(100, 2000)), damping=float(rng.uniform(0, 5)), initial_energy=1e-3
        )
        end = DeviceEnd(options, resolution=0.0, lever=1e9)
        place, force, coming, out, T, fast = np.zeros(3), np.zeros(3), np.zeros(3), 0.0, 1e-3, 0.0
        worst = -np.inf
        for _ in range(3000):
            push = float(rng.choice([0.0, 1.0])) * float(rng.uniform(0.0, 1.5)) * T
            length = float(np.linalg.norm(force))
            moved = push * force / length if length else np.zeros(3)
            moved = moved + rng.normal(0.0, 2e-4, 3)
            out += float(force @ moved)
            place = place + moved
            fast = max(fast, float(np.linalg.norm(moved)) / T)
            worst = max(worst, out)
            end.measure(tuple(place), tuple(coming))
            force = coming
            desired = tuple(place + rng.normal(0.0, 0.02, 3))
            coming = np.array(end.decide(desired, tuple(moved / T), EnergyMessage(), T))
        assert worst <= options.initial_energy + end.bound(fast, T, 0.0) + 1e-12
        assert worst > 0.5 * options.initial_energy  # it really got at what was there


def test_two_ticks_of_a_held_force_take_no_more_than_the_bound():
    """At rest the spring has all that it may; then the tip goes with the force for two ticks, as far as hurts most."""
    stiffness, step = 800.0, 1.5e-3
    seed = 2.0 * stiffness * step**2
    end = DeviceEnd(EndOptions(stiffness=stiffness, damping=0.0, initial_energy=seed), resolution=0.0, lever=1e9)
    place, acting, coming, out, forces = 0.0, 0.0, 0.0, 0.0, []
    for k in range(60):
        moved = step if k in {50, 51} else 0.0
        out += acting * moved
        place += moved
        end.measure((place, 0.0, 0.0), (coming, 0.0, 0.0))
        acting = coming
        coming = end.decide((place + 0.1, 0.0, 0.0), (0.0, 0.0, 0.0), EnergyMessage(), 1e-3)[0]
        forces.append(acting)
    assert min(forces[2:50]) == pytest.approx(max(forces[2:50]))  # it does not take turns with itself
    assert 0.5 * seed < out <= seed + end.bound(step / 1e-3, 1e-3, 0.0)


def test_one_process_for_each_end_feels_as_one():
    """With the seed, the spring is whole most of the time, at 200 Hz as at 1000 Hz; the proxy follows."""
    for rate in (1000.0, 200.0):
        clock = [0.0]
        ran = run(made("phantom", clock), SPECS["phantom"], seconds=3.0, peer=rate, clock=clock, late=0.002)
        assert float(np.mean(np.array(ran.fractions[200:]) > 0.99)) > 0.9
        followed = np.abs(np.array(ran.proxies)).max(axis=0)
        led = np.abs(np.array([report.place for report in ran.reports])).max(axis=0)
        np.testing.assert_allclose(followed, led, rtol=0.05, atol=2e-4)


def test_a_peer_that_falls_silent_is_faded_out_and_back():
    clock = [0.0]
    wall = Body(mass=1e6)  # does not move: there is force
    ran = run(
        made("phantom", clock), SPECS["phantom"], seconds=3.0, peer=500.0, clock=clock, body=wall, silent=(1.5, 2.0)
    )
    forces = [(report.time, norm(report.force), report.causes) for report in ran.reports]
    assert max(f for t, f, _ in forces if 1.4 < t < 1.5) > 0.3
    assert all(f == 0.0 for t, f, _ in forces if 1.59 < t < 2.0)
    assert all(c & Cause.QUIET for t, _, c in forces if 1.53 < t < 1.57)
    assert max(f for t, f, _ in forces if t > 2.6) > 0.3


class Lying:
    """A core whose coupling pushes the hand wherever it goes: an error that only the observer can see."""

    def __init__(self, spec, limits, options):
        self._core = ServoCore(spec, limits, options)
        self._core.end.decide = lambda desired, rate, message, T: tuple(5.0 * np.array(rate) / (1e-9 + norm(rate)))

    def __getattr__(self, name):
        return getattr(self._core, name)


def test_the_observer_stops_what_makes_energy():
    clock, spec = [0.0], SPECS["cartesian"]
    core = Lying(spec, SafetyLimits.of(spec), EndOptions())
    ran = run(made("cartesian", clock), spec, seconds=1.5, peer=500.0, clock=clock, core=core)
    assert ran.reports[-1].causes & Cause.ACTIVE
    assert norm(ran.reports[-1].force) == 0.0
    first = next(report for report in ran.reports if report.causes & Cause.ACTIVE)
    assert first.work < 0.1


def _pushed(core: ServoCore, places: list[float], T: float = 1e-3) -> list[float]:
    """Forces along x while the tip is led along x."""
    found = []
    for k, x in enumerate(places):
        now = T * k
        core.receive(Order(time=now, place=None, enable=True))
        reading = DeviceReading(
            time=now,
            position=np.array([x, 0.0, 0.0]),
            velocity=np.zeros(3),
            force=np.full(3, np.nan),
            flags=Flag.FORCE_ON | Flag.CALIBRATED,
        )
        found.append(core.cycle(reading, now).force[0])
    return found


def test_the_wall_of_the_workspace_leads_back_and_gives_nothing():
    spec = SPECS["phantom"]
    core = ServoCore(spec, SafetyLimits.of(spec), EndOptions(damping=0.0, initial_energy=1e-3))
    out = [0.1 + 1e-5 * k for k in range(200)]  # after the ramp has come up
    led = [0.09 + 1e-2 * k / 700 for k in range(700)] + out + out[::-1]
    forces = _pushed(core, led)
    assert max(map(abs, forces[:700])) == 0.0
    full = spec.stiffness / 2 * (led[899] - 0.1)
    # What the acting force's spring holds is kept back, so that without damping the wall is softer by up to a third.
    assert 0.65 * full <= -forces[899] <= full
    work = sum(f * (b - a) for f, a, b in zip(forces, led[1:], led[2:], strict=False))
    assert work <= 1e-3 + core.observed_bound


def test_the_proxy_end_never_owes():
    rng = np.random.default_rng(0)
    end, place = ProxyEnd(EndOptions()), np.zeros(3)
    for _ in range(2000):
        rate = rng.normal(0.0, 0.5, 3)
        T = float(rng.uniform(1e-3, 1e-2))
        pull = end.pull(tuple(place), tuple(rng.normal(0.0, 0.03, 3)), tuple(rate), EnergyMessage(), T)
        k, b, m = pull.stiffness, pull.damping, 0.05
        other = rng.normal(0.0, 3.0, 3)
        mean = (k * (np.array(pull.target) - place) + np.array(pull.push) + other) / (2 * m / T + b + k * T / 2)
        done = k * (np.array(pull.target) - place - T / 2 * mean) - b * mean + np.array(pull.push)
        place = place + T * mean
        end.settle(tuple(done), tuple(T * mean))
        assert end.energy >= -1e-12
