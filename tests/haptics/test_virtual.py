"""The virtual coupling of two processes: within its limit a plain spring, beyond it an account, refused where known."""

import numpy as np
import pytest
from tests.haptics.inside import End
from tests.haptics.two_ports import Body, Ran, check_passive, circumstances, run

from cotouch.coupling import END, EnergyMessage
from cotouch.device import PRESETS
from cotouch.errors import DeviceError
from cotouch.haptics import (
    Cause,
    DeviceChoice,
    EndOptions,
    ProxyEnd,
    SafetyLimits,
    ServoCore,
    ServoSettings,
    SimulatedOnClock,
    checked_virtual,
    coupling_of,
    simulated_model,
    virtual_limit,
)

SPEC = PRESETS["phantom"]


def virtual(options: EndOptions, friction: float, *, seconds: float = 1.0, peer: float = 500.0, **more) -> Ran:
    """Runs a light mass with this friction; no more is paid than it really took."""
    clock = [0.0]
    device = SimulatedOnClock(
        simulated_model("cartesian", sweep=more.pop("sweep", 1.0), viscous=friction), SPEC, clock=lambda: clock[0]
    )
    ran = run(device, SPEC, seconds=seconds, peer=peer, clock=clock, options=options, **more)
    assert device.device is not None
    assert ran.paid <= device.device.ledger["viscous_loss"] * (1 + 1e-9)
    return ran


def passive(**wanted: float) -> EndOptions:
    """A spring that is as stiff as it may be, or so much of that as `of` says."""
    of = wanted.pop("of", 1.0)
    options = EndOptions(law="virtual", most=SafetyLimits.of(SPEC).force, **({"damping": 0.0, "coulomb": 2.0} | wanted))
    limit = virtual_limit(options, period=1e-3, resolution=SPEC.resolution)
    return options._replace(stiffness=min(of * limit, SPEC.stiffness))


@pytest.mark.parametrize("seed", range(12))
def test_two_ports_are_passive_whatever_the_rates_and_boards(seed: int):
    """Rates from 100 to 1000 Hz that drift, mailboxes late beyond all that was declared, or unread: no violation."""
    rng = np.random.default_rng(seed)
    friction = float(rng.uniform(0.5, 6.0))
    options = passive(
        friction=friction,
        ages=float(rng.uniform(0.0, 0.03)),
        weight=float(10.0 ** rng.uniform(-1, 1)),
        damping=float(rng.uniform(0.0, 0.4)) * friction,
        initial_energy=float(10.0 ** rng.uniform(-4, -2)),
        of=float(rng.uniform(0.2, 1.0)),
    )
    ran = virtual(
        options,
        friction,
        peer=float(rng.uniform(100.0, 1000.0)),
        sweep=float(rng.uniform(0.2, 3.0)),
        seed=seed,
        **circumstances(rng),
    )
    check_passive(ran, SPEC)


def test_within_its_limit_nothing_shortens_the_spring():
    """Ages as declared, after the ramp: the account, which watches, is never short, and the seed is never touched."""
    options = passive(friction=3.0, ages=0.008)
    ran = virtual(options, 3.0, seconds=2.0, peer=500.0, body=Body(mass=0.1, shake=1.0, hertz=3.0))
    assert options.stiffness > 400.0
    assert set(ran.fractions[10:]) == {1.0}
    assert set(ran.pulls) == {1.0}
    followed, led = (np.abs(np.array(places)).max() for places in (ran.proxies, [r.place for r in ran.reports]))
    assert followed == pytest.approx(led, rel=0.3)  # the drag of 1.8 Ns/m is felt


def test_beyond_its_limit_it_would_make_energy_and_the_account_stops_it(monkeypatch: pytest.MonkeyPatch):
    """Ten times as stiff as is passive, with places that are late: the account shortens the spring, and holds."""
    options = passive(friction=0.5, ages=0.0)._replace(stiffness=3500.0)
    with pytest.raises(DeviceError, match=r"is passive up to 333\.3 N/m"):
        checked_virtual(options, SPEC, period=1e-3)
    monkeypatch.setattr("cotouch.haptics._core.checked_virtual", lambda options, *_, **__: options)

    def rung() -> Ran:
        return virtual(options, 0.5, seconds=0.7, late=0.01, body=Body(mass=0.3, spring=200.0))

    ran = rung()
    assert min(ran.fractions) < 0.5
    assert ran.excess <= ran.bound
    # Without the account it gives more than that bound: the scenario is one that counts.
    honest = End._run

    def rich(end: End, *given) -> object:
        end._row[[END.energy, END.initial]] += 1e3
        acts = honest(end, *given)
        end._row[[END.energy, END.initial]] -= 1e3
        return acts

    monkeypatch.setattr(End, "_run", rich)
    ran = rung()
    assert ran.excess > ran.bound
    assert any(report.causes & Cause.ACTIVE for report in ran.reports)  # the observer then ends it


def test_the_proxy_takes_no_more_than_the_seed_beyond_what_the_device_has_heard():
    end = ProxyEnd(EndOptions(law="virtual", damping=0.0, ages=0.0, initial_energy=1e-3))
    rich = EnergyMessage(put=1.0)  # the device put in much, and has heard of nothing
    for k in range(1000):
        pull = end.pull((0.0, 0.0, 0.0), (0.05, 0.0, 0.0), (0.0, 0.0, 0.0), rich, 1e-3)
        end.settle((500.0 * pull.target[0], 0.0, 0.0), (0.25 * pull.target[0], 0.0, 0.0))
        assert end.message.taken <= 1e-3 + 1e-12, k
    assert end.message.taken > 0.9e-3
    end.pull((0.0, 0.0, 0.0), (0.05, 0.0, 0.0), (0.0, 0.0, 0.0), rich._replace(known=end.message.taken), 1e-3)
    assert end.fraction > 0.03  # it has heard: there is as much again


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("coupling=stiff", 'coupling is "stiff"; it must be one of pspm, virtual'),
        ("friction=1", "friction is given, but with coupling=pspm it has no effect; leave it out"),
        ("coupling=virtual", "the friction of PHANToM 1.5 is 0 Ns/m, and a virtual coupling depends on it"),
        ("coupling=virtual,friction=much", "the coupling's friction is much; it must be a number of at least 0"),
        ("coupling=virtual,friction=-1", "the coupling's friction is -1; it must be a number of at least 0"),
        ("coupling=virtual,friction=1,weight=0", "weight is 0; it must be finite and above 0"),
        ("coupling=virtual,friction=1,damping=1", "damping is 1 Ns/m; .* pays for less than 0.952 Ns/m, so lower it"),
        (
            "coupling=virtual,friction=1,stiffness=500",
            "stiffness is 500 N/m; .* friction of 1 Ns/m, ticks of 1 ms and positions 10 ms old is passive up to 153.8",
        ),
        (
            "coupling=virtual,friction=1",
            "is 153.846 N/m; PHANToM .* knows its position to 0.03 mm and .* passive with none",
        ),
        ("coupling=virtual,friction=9", "knows its position to 0.03 mm and .* friction of 0 N is passive with none"),
        (
            "coupling=virtual,friction=9,coulomb=0.01,stiffness=400",
            r"is 400 N/m; PHANToM 1\.5 knows .* 0.01 N is passive up to 384\.9 N/m, so lower it, state its real dry",
        ),
    ],
)
def test_what_cannot_be_passive_is_refused_in_a_sentence(text: str, said: str):
    with pytest.raises(DeviceError, match=said) as caught:
        core_of(text)
    assert "\n" not in str(caught.value)


def test_without_a_stiffness_it_takes_what_is_passive():
    virtual = "coupling=virtual,coulomb"
    assert core_of(f"{virtual}=1,friction=1").end.options.stiffness == pytest.approx(153.846, rel=1e-4)
    assert core_of(f"{virtual}=1,friction=9").end.options.stiffness == 500.0
    # As the simulated one: half a step on each of three axes, and what a velocity over 10 ms makes of it.
    coarse = 0.01 / (0.5 * 3.0**0.5 * SPEC.resolution)
    assert core_of(f"{virtual}=0.01,friction=9").end.options.stiffness == pytest.approx(coarse)
    damped = core_of(f"{virtual}=0.01,friction=9,damping=0.5").end.options
    assert damped.stiffness == pytest.approx(coarse - 2.0 * 0.5 / 0.01)
    assert core_of("stiffness=300").end.options.stiffness == 300.0


def core_of(text: str) -> ServoCore:
    choice, said = coupling_of(DeviceChoice.read(f"simulated:cartesian,sweep=2,{text}"))
    assert choice == DeviceChoice("simulated", {"variant": "cartesian", "sweep": 2})
    settings = ServoSettings(device=choice, folder=None, coupling=said)  # type: ignore[arg-type]
    options = settings.end_options(SPEC)
    return ServoCore(SPEC, settings.safety(SPEC), options, period=settings.period(SPEC))
