"""Specifications, and what is refused with which sentence."""

import pytest
from tests.device.inside import tables

from cotouch.device import (
    DEVICE_LEDGER,
    PRESETS,
    CartesianPlant,
    Coupling,
    DeviceModel,
    PhantomPlant,
    ServoModel,
    SimulatedHand,
    assemble,
    critical_stiffness,
    preset,
)
from cotouch.errors import DeviceError


@pytest.mark.parametrize("name", PRESETS)
def test_presets_can_be_simulated(name):
    spec = preset(name)
    assert 0.0 < spec.continuous_force <= spec.force
    assert spec.actuated <= spec.degrees_of_freedom
    DeviceModel(
        plant=CartesianPlant(mass=spec.mass, coulomb=spec.friction),
        servo=ServoModel(period=1.0 / spec.rate, resolution=spec.resolution, force=spec.force),
        coupling=Coupling(stiffness=spec.stiffness, damping=spec.damping),
    )


def test_limits_are_those_in_common_use():
    forces = {name: preset(name).force for name in ("omega", "delta", "touch", "falcon")}
    assert forces == {"omega": 12.0, "delta": 20.0, "touch": 3.3, "falcon": 8.0}
    assert preset("inverse3").rate == 4000.0


def test_books_are_named_in_their_order():
    for index, name in enumerate(DEVICE_LEDGER):
        constant = {"spring_energy": "SPRING_ENERGY"}.get(name, name.upper())
        assert getattr(tables, constant) == index


def test_no_devices_are_a_table_too():
    devices, state = assemble([])
    assert devices.servos.period.shape == (0, 1)
    assert state.tip.shape == (0, 4)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: preset("phantom 1.5"), 'device is "phantom 1.5"; it must be one of omega, delta, touch, falcon'),
        (lambda: CartesianPlant(mass=0.0), "mass is 0 kg; it must be finite, above 0"),
        (lambda: CartesianPlant(viscous=-1.0), "viscous is -1 Ns/m; it must be finite, at least 0"),
        (lambda: CartesianPlant(coulomb=float("nan")), "coulomb is nan N"),
        (lambda: PhantomPlant(torque=(1.0, 0.0, 1.0)), "torque is 0 Nm; it must be finite, above 0"),
        (lambda: ServoModel(period=0.0), "period is 0 s; it must be finite, above 0"),
        (lambda: ServoModel(period=()), "period is empty; it must be one time or several"),
        (lambda: ServoModel(window=float("inf")), "window is inf s"),
        (lambda: ServoModel(force=0.0), "force is 0 N; it must be above 0"),
        (lambda: ServoModel(substep=-1.0), "substep is -1 s"),
        (lambda: Coupling(law="magic"), 'law is "magic"; it must be one of pspm, virtual, spring, host_force'),  # type: ignore[arg-type]
        (lambda: Coupling(lag=9), "lag is 9; it must be finite, at least 0 and at most 8"),
        (lambda: Coupling(cap=-1.0), "cap is -1 J"),
        (lambda: SimulatedHand(grip=5.0), r"hand's grip is 5; it must be finite, at least 0\.25 and at most 4"),
        (lambda: SimulatedHand(begin=1.0, release=1.0), "hand's release is 1 s; it must be finite, above 1"),
        (lambda: SimulatedHand(blend=0.0), "hand's blend is 0 s; it must be finite, above 0"),
        (
            lambda: SimulatedHand(path=[(0.0, 1.0), (0.0, 2.0)]),
            r"hand's path has the times \[0.0, 0.0\]; they must increase",
        ),
        (lambda: SimulatedHand(path=[(0.0,)]), r"waypoint \(0.0,\); it must be a time and one to three numbers"),
        (lambda: SimulatedHand(path=(1.0, 2.0, 3.0, 4.0)), "hand's path is .*; it must be one to three finite numbers"),
        (lambda: SimulatedHand(path=()), "hand's path is .*; it must be one to three finite numbers"),
        (lambda: SimulatedHand(amplitude=(float("inf"),)), "hand's amplitude is .*; it must be one to three finite"),
        (lambda: DeviceModel(position=("x",)), "position is .*; it must be one to three finite numbers"),  # type: ignore[arg-type]
        (
            lambda: DeviceModel(plant=PhantomPlant(), position=(-0.2,)),
            "position is .*; a PHANToM's tip cannot reach it",
        ),
        (lambda: DeviceModel(plant=PhantomPlant(), position=(0.215,)), "a PHANToM's tip cannot reach it"),
        (lambda: critical_stiffness(CartesianPlant(viscous=0.0)), "viscous is 0 Ns/m and no hand damps the device"),
        (lambda: critical_stiffness(CartesianPlant(), precision=0.0), "precision is 0"),
    ],
)
def test_what_is_wrong_is_named(make, message):
    with pytest.raises(DeviceError, match=message):
        make()
