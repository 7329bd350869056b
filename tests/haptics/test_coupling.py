"""What is said of a coupling, and a servo that is given another one."""

import numpy as np
import pytest

from cotouch.coupling import EnergyMessage, encoder_toll, opening_energy
from cotouch.device import PRESETS, DeviceSpec
from cotouch.errors import DeviceError
from cotouch.haptics import (
    Cause,
    CouplingChoice,
    DeviceChoice,
    DeviceReading,
    EndOptions,
    Flag,
    Order,
    ProxyEnd,
    SafetyLimits,
    ServoCore,
    ServoReport,
    coupling_of,
)

SPEC = PRESETS["phantom"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("scale=0", "scale is 0; it must be from 0.01 to 100, or fit"),
        ("scale=101", "scale is 101; it must be from 0.01 to 100, or fit"),
        ("scale=big", "scale is big; it must be from 0.01 to 100, or fit"),
        ("tool=0", "tool is 0; tools of a user are numbered from 1"),
        ("tool=1.5", "tool is 1.5; tools of a user are numbered from 1"),
        ("tool=true", "tool is True; tools of a user are numbered from 1"),
        ("coupling=pspm,weight=1", "weight is given, but with coupling=pspm it has no effect; leave it out"),
        ("stiffness=true", "the coupling's stiffness is True; it must be a number of at least 0"),
    ],
)
def test_what_makes_no_sense_is_refused_in_a_sentence(text: str, said: str):
    with pytest.raises(DeviceError, match=said) as caught:
        coupling_of(DeviceChoice.read(f"haply:{text}"))
    assert "\n" not in str(caught.value)


def test_what_is_said_of_the_coupling_is_not_the_drivers():
    choice, said = coupling_of(DeviceChoice.read("haply:id=7,scale=fit,tool=2,stiffness=300"))
    assert choice == DeviceChoice("haply", {"id": 7})
    assert said == CouplingChoice(scale="fit", tool=2, stiffness=300.0)
    assert CouplingChoice(**said.plain()) == said


def test_what_would_hum_or_slip_is_refused_or_lowered():
    """With what coarse encoders cost a tank, and old places without damping."""
    falcon, omega = PRESETS["falcon"], PRESETS["omega"]

    def made(spec: DeviceSpec, **said: float) -> EndOptions:
        return CouplingChoice(**said).options(spec, period=1e-3, force=1.0)

    with pytest.raises(
        DeviceError, match=r"stiffness is 850 N/m, but .* damping of 2 Ns/m and positions 10 ms old it oscil"
    ):
        made(falcon, stiffness=850.0, damping=2.0)
    with pytest.raises(DeviceError, match=r"stiffness is 300 N/m, but encoders .* at 20 Ns/m above 250 N/m; lower it"):
        made(falcon, stiffness=300.0, damping=20.0)
    assert made(falcon, damping=20.0).stiffness == pytest.approx(250.0)
    assert made(falcon, damping=0.5).stiffness == pytest.approx(200.0)
    assert made(omega, stiffness=5000.0, damping=30.0).stiffness == 5000.0
    usual = made(falcon)
    assert (usual.stiffness, usual.damping) == (500.0, 2.0)
    assert usual.initial_energy == pytest.approx(0.5 * 5.0**2 / 500.0)
    coarse = made(falcon, damping=20.0)
    assert coarse.initial_energy == opening_energy(
        toll=encoder_toll(stiffness=coarse.stiffness, damping=20.0, window=0.01, resolution=falcon.resolution),
        stiffness=coarse.stiffness,
        cap=coarse.cap,
    )


def _cycle(core: ServoCore, k: int, place: float, order: Order | None, buttons: int = 0) -> ServoReport:
    if order is not None:
        core.receive(order._replace(time=1e-3 * k, enable=True))
    reading = DeviceReading(
        time=1e-3 * k,
        position=np.array([place, 0.0, 0.0]),
        velocity=np.zeros(3),
        force=np.full(3, np.nan),
        flags=Flag.FORCE_ON | Flag.CALIBRATED,
        buttons=buttons,
    )
    return core.cycle(reading, 1e-3 * k)


def test_another_coupling_begins_relaxed_with_books_of_its_own():
    """Without that, a proxy that is made anew would be given once more what the device ever gave, and has spent."""
    core = ServoCore(SPEC, SafetyLimits.of(SPEC), EndOptions())
    starved = EnergyMessage(starved=True)
    order = Order(time=0.0, place=(0.01, 0.0, 0.0), message=starved)
    for k in range(800):  # the hand pushes against the spring, and the proxy's end lacks energy
        report = _cycle(core, k, -2e-5 * k, order)
    assert report.force[0] > 1.0
    assert report.message.given > 1e-3
    bound, number = core.observed_bound, report.coupling
    assert bound > 0.0
    assert number == 0
    again = order._replace(coupling=1, options=EndOptions(stiffness=200.0), message=EnergyMessage())
    report = _cycle(core, 800, -0.016, again)
    assert report.coupling == 1
    assert report.force == (0.0, 0.0, 0.0)
    assert report.message == EnergyMessage(tank=EndOptions().initial_energy, starved=True)
    assert report.work == 0.0
    assert report.causes & Cause.RAMP
    for k in range(801, 1400):
        report = _cycle(core, k, -0.016, again)
        assert report.excess <= 0.0
        assert 0.0 <= report.force[0] <= 200.0 * 0.026 + 1e-9
    assert report.message.given == 0.0
    end = ProxyEnd(core.end.options)
    end.pull((0.0, 0.0, 0.0), None, (0.0, 0.0, 0.0), report.message, 1e-3)
    assert end.message.received == 0.0
    # An order that is older has no say any more, and one that fits no device is a fault.
    assert _cycle(core, 1400, -0.016, order).coupling == 1
    with pytest.raises(DeviceError, match="renders at most"):
        core.receive(again._replace(coupling=2, options=EndOptions(stiffness=1e6)))


def test_another_coupling_leaves_what_is_latched():
    core = ServoCore(SPEC, SafetyLimits.of(SPEC), EndOptions())
    for k in range(20):
        report = _cycle(core, k, 2e-3 * k, Order(time=0.0, place=(0.0, 0.0, 0.0)))
    assert report.causes & Cause.FAST
    for k in range(20, 60):  # at rest again
        report = _cycle(core, k, 0.038, Order(time=0.0))
    report = _cycle(core, 60, 0.038, Order(time=0.0, coupling=1, options=EndOptions()))
    assert report.causes & Cause.FAST
    report = _cycle(core, 61, 0.038, Order(time=0.0, coupling=1, options=EndOptions(), rearm=1))
    assert not report.causes & Cause.FAST


def test_the_first_order_re_arms_nothing():
    """What it counts may have been counted for another device, or before this servo was started."""
    core = ServoCore(SPEC, SafetyLimits.of(SPEC), EndOptions())
    for k in range(60):  # nobody has said anything yet, and the device is thrown
        _cycle(core, k, 2e-3 * min(k, 20), None)
    for k, rearm in ((60, 3), (61, 3), (62, 2)):
        assert _cycle(core, k, 0.04, Order(time=0.0, rearm=rearm)).causes & Cause.FAST
    assert not _cycle(core, 63, 0.04, Order(time=0.0, rearm=4)).causes & Cause.FAST


def test_a_button_re_arms_at_rest_alone():
    core = ServoCore(SPEC, SafetyLimits.of(SPEC), EndOptions())
    for k in range(30):
        _cycle(core, k, 2e-3 * min(k, 20), Order(time=0.0))
    for k in range(30, 1600):  # held while the device moves to and fro, slower than a hand
        report = _cycle(core, k, 0.04 - 2e-4 * abs((k - 30) % 100 - 50), Order(time=0.0), buttons=1)
    assert report.causes & Cause.FAST
    for k in range(1600, 2500):
        report = _cycle(core, k, 0.04, Order(time=0.0), buttons=1)
    assert report.causes & Cause.FAST
    for k in range(2500, 2800):
        report = _cycle(core, k, 0.04, Order(time=0.0), buttons=1)
    assert not report.causes & Cause.FAST


def test_whoever_is_not_watched_fades_and_comes_back():
    core = ServoCore(SPEC, SafetyLimits.of(SPEC), EndOptions(initial_energy=1.0))
    order = Order(time=0.0, place=(0.003, 0.0, 0.0))
    forces, causes = [], []
    for k in range(2000):
        core.receive(order._replace(time=1e-3 * k, enable=True))
        reading = DeviceReading(
            time=1e-3 * k, position=np.zeros(3), velocity=np.zeros(3), force=np.full(3, np.nan), flags=Flag.FORCE_ON
        )
        report = core.cycle(reading, 1e-3 * k, unwatched=max(0.0, 1e-3 * (k - 1000)) if k < 1200 else 0.0)
        forces.append(report.force[0])
        causes.append(report.causes)
    assert forces[1019] == pytest.approx(forces[999], rel=0.05)
    assert 0.0 < forces[1050] < 0.7 * forces[1019]
    assert set(forces[1080:1200]) == {0.0}
    assert all(cause & Cause.UNWATCHED for cause in causes[1030:1200])
    assert causes[1201] & Cause.RAMP
    assert forces[1999] == pytest.approx(forces[999], rel=0.05)
