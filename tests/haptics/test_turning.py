"""Turning in the servo's cycle: torque goes where force goes, and its own limits hold."""

import math
from contextlib import closing
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tests.haptics.inside import OrderReader, OrderWriter, ReportReader, ReportWriter, way_back, with_wrist

from cotouch.coupling import EnergyMessage
from cotouch.device import PRESETS
from cotouch.errors import DeviceError
from cotouch.haptics import (
    ARM,
    Cause,
    CouplingChoice,
    DeviceChoice,
    DeviceReading,
    EndOptions,
    Flag,
    Order,
    SafetyLimits,
    Servo,
    ServoCore,
    ServoReport,
    ServoSettings,
    at_arm,
)

SPEC = with_wrist(PRESETS["omega"])
LIMITS = SafetyLimits.of(SPEC)
OPTIONS = CouplingChoice(turning_stiffness=1.0).turning(SPEC, period=1e-3, torque=0.1)
AWAY = (0.0, 0.0, math.sin(0.04), math.cos(0.04))


def about(angle: float, axis: int = 2) -> np.ndarray:
    vector = np.zeros(3)
    vector[axis] = angle
    return Rotation.from_rotvec(vector).as_quat()


class Ticks:
    """A handle that stands where a test has it."""

    def __init__(self) -> None:
        self.core = ServoCore(SPEC, LIMITS, EndOptions())
        self.now, self.given, self.number = 0.0, 1.0, 1
        self.reading = DeviceReading(
            time=0.0,
            position=np.zeros(3),
            velocity=np.zeros(3),
            force=np.full(3, math.nan),
            flags=Flag.FORCE_ON | Flag.CALIBRATED,
            orientation=about(0.0),
        )

    def run(self, count: int, *, orders: bool = True, unwatched: float = 0.0, **changed) -> ServoReport:
        goal = changed.pop("goal", AWAY)
        enable = changed.pop("enable", True)
        report = None
        for _ in range(count):
            self.now += 1e-3
            self.given += 1e-3
            if orders:
                message = EnergyMessage(given=self.given)
                self.core.receive(
                    Order(
                        time=self.now, place=(0.005, 0.0, 0.0), message=message, enable=enable, coupling=self.number,
                        options=EndOptions(), turning=OPTIONS, orientation=goal, twist=message,
                    )
                )  # fmt: skip
            report = self.core.cycle(replace(self.reading, time=self.now, **changed), self.now, unwatched)
        assert report is not None
        return report


@pytest.fixture
def ticks() -> Ticks:
    made = Ticks()
    report = made.run(700)
    assert report.causes == 0
    assert report.torque[2] == pytest.approx(0.08)  # 0.08 rad of 1 Nm/rad; half of the device's torque is the limit
    assert report.force[0] == pytest.approx(2.5)
    return made


def gone(report: ServoReport) -> bool:
    return not any(report.force) and not any(report.torque)


@pytest.mark.parametrize(
    ("changed", "cause"),
    [
        ({"orientation": np.full(4, math.nan)}, Cause.FAULT),
        ({"orientation": None}, Cause.FAULT),
        ({"orientation": np.array([0.0, 0.0, 0.0, 2.0])}, Cause.FAULT),
        ({"position": np.full(3, math.nan)}, Cause.FAULT),
        ({"goal": (math.nan, 0.0, 0.0, 1.0)}, Cause.FAULT),
        ({"flags": Flag.CALIBRATED}, Cause.DEVICE),
        ({"enable": False}, Cause.OFF),
        ({"unwatched": 0.09}, Cause.UNWATCHED),
    ],
    ids=["nan", "none", "no unit", "place", "goal", "motors off", "disabled", "unwatched"],
)
def test_whatever_takes_force_away_takes_torque_away(ticks: Ticks, changed: dict, cause: Cause):
    report = ticks.run(1, **changed)
    assert report.causes & cause
    assert gone(report)
    again = ticks.run(3)
    assert gone(again) == (cause is Cause.FAULT) or np.linalg.norm(again.torque) < 0.002  # for good, or by the ramp


def test_silence_fades_torque_as_force(ticks: Ticks):
    assert np.linalg.norm(ticks.run(20, orders=False).torque) > 0.05
    assert gone(ticks.run(62, orders=False))
    assert np.linalg.norm(ticks.run(50).torque) < 0.02  # the ramp


def test_a_handle_that_spins_faster_than_a_hand_latches(ticks: Ticks):
    """40 rad/s; torque and force are back only after somebody re-arms."""
    for k in range(1, 8):
        report = ticks.run(1, orientation=about(0.04 * k))
    assert report.causes & Cause.FAST
    assert gone(report)
    assert gone(ticks.run(50, orientation=about(0.28)))
    ticks.core.chain.rearm()
    assert not gone(ticks.run(50, orientation=about(0.28)))


def test_the_observer_holds_torques_to_what_they_may_give(ticks: Ticks):
    """A handle that yields to the torque: its work is in the report; more than was given latches."""
    before = ticks.run(1)
    after = ticks.run(1, orientation=about(0.005))
    assert after.work - before.work == pytest.approx(0.08 * 0.005, rel=1e-6)
    assert not after.causes
    assert ticks.core.turning is not None
    ticks.core.turning.seen.work += 2.0  # as if the law had given what nobody brought
    latched = ticks.run(1, orientation=about(0.005))
    assert latched.causes & Cause.ACTIVE
    assert gone(latched)


def test_torque_rises_in_ten_milliseconds_and_has_its_own_heat():
    made = Ticks()
    before = np.zeros(3)
    for k in range(700):
        torque = np.array(made.run(1, goal=about(1.0) if k > 600 else about(0.0)).torque)
        assert np.linalg.norm(torque - before) <= 0.1 * 0.1 * (1 + 1e-9)
        before = torque
    assert np.linalg.norm(before) == pytest.approx(0.1)
    spec = replace(SPEC, continuous_torque=0.05)
    core = ServoCore(spec, LIMITS, EndOptions(), turning_limits=SafetyLimits.of(at_arm(spec), heat=1.0))
    made.core = core
    assert np.linalg.norm(made.run(4_000, goal=about(1.0)).torque) == pytest.approx(0.05, rel=0.02)
    assert np.linalg.norm(made.run(1).force) == pytest.approx(2.5)  # force is not what heats those motors


def test_the_way_back_is_steady_everywhere():
    rng = np.random.default_rng(3)
    for _ in range(300):
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        angle = float(rng.choice([rng.uniform(0, math.pi), math.pi - 1e-9, 1e-12, math.pi / 2]))
        here = Rotation.random(random_state=rng)
        goal = Rotation.from_rotvec(angle * axis) * here
        sign = float(rng.choice([-1.0, 1.0]))  # both quaternions are the same turn
        way = way_back(tuple(sign * goal.as_quat()), tuple(here.as_quat()))
        assert way == pytest.approx(min(angle, math.pi - angle) * axis, abs=1e-7)


def test_what_is_said_of_turning_is_checked():
    settings = ServoSettings(device=DeviceChoice("x"), folder=None, limits={"torque": 0.05, "ramp": 1.0})  # type: ignore[arg-type]
    limits = settings.turning_safety(SPEC)
    assert limits is not None
    assert (ARM * limits.force, limits.ramp) == (pytest.approx(0.05), 1.0)
    assert settings.safety(SPEC).ramp == 1.0
    with pytest.raises(DeviceError, match="renders no torque"):
        settings.turning_safety(PRESETS["omega"])
    for torque in (0.3, -0.1, math.nan):
        with pytest.raises(DeviceError, match=r"at most 0\.2"):
            replace(settings, limits={"torque": torque}).turning_safety(SPEC)
    with pytest.raises(DeviceError, match="renders at most 1 Nm/rad"):
        CouplingChoice(turning_stiffness=2.0).turning(SPEC, period=1e-3, torque=0.1)
    with pytest.raises(DeviceError, match=r"arcs at 50 mm: .*oscillates"):
        CouplingChoice(turning_stiffness=1.0, turning_damping=1e-3).turning(SPEC, period=1e-3, torque=0.1)
    with pytest.raises(DeviceError, match="renders no torque; leave it out"):
        CouplingChoice(turning_stiffness=1.0).turning(PRESETS["omega"], period=1e-3, torque=0.0)
    with pytest.raises(DeviceError, match="at least 0"):
        CouplingChoice(turning_damping=-1.0)


class Handle:
    """A device that stands still and notes what it is told."""

    spec = SPEC

    def __init__(self) -> None:
        self.told: list[tuple[np.ndarray, np.ndarray | None]] = []
        self.stopped = 0
        self.time = 0.0

    def enable_force(self, on: bool = True) -> None:
        pass

    def exchange(self, force: np.ndarray, torque: np.ndarray | None = None) -> DeviceReading:
        self.told.append((force.copy(), None if torque is None else torque.copy()))
        reading = Ticks().reading
        return replace(reading, time=self.time, force=force.copy(), torque=torque)

    def stop(self) -> None:
        self.stopped += 1

    def close(self) -> None:
        pass


@pytest.mark.parametrize("spec", [SPEC, PRESETS["omega"]], ids=["torque", "none"])
def test_a_servo_hands_torques_on_to_devices_that_render_some(tmp_path, spec):
    """Another coupling begins without, as does a servo that ends; other devices are given forces alone, as ever."""
    device = Handle()
    device.spec = spec
    there = [True]
    settings = ServoSettings(device=DeviceChoice("x"), folder=tmp_path)
    servo = Servo(device, settings, watched=lambda: there[0], clock=lambda: device.time)  # type: ignore[arg-type]
    orders = OrderWriter(tmp_path)

    def run(count: int, coupling: int) -> bool:
        for _ in range(count):
            device.time += 1e-3
            message = EnergyMessage(given=1.0)
            order = Order(time=device.time, place=(0.005, 0.0, 0.0), message=message, enable=True, coupling=coupling)
            order = order._replace(options=EndOptions(), orientation=AWAY, twist=message)
            orders.write(order._replace(turning=OPTIONS if spec.torque else None))
            if not servo.cycle():
                return False
        return True

    assert run(700, 1)
    force, torque = device.told[-1]
    assert force[0] > 2.0
    if not spec.torque:
        assert torque is None
    else:
        assert torque is not None
        assert torque[2] == pytest.approx(0.08)
        assert run(1, 2)
        assert not any(np.any(one) for one in device.told[-1])
        assert run(700, 2)
    there[0] = False
    assert not run(1, 2)
    assert device.stopped == 1
    with closing(ReportReader(tmp_path)) as reports:
        last = reports.read()
    assert last is not None
    assert last.causes & Cause.PARENT
    assert not any((*last.force, *last.torque))
    servo.close()
    orders.close()


def test_mailboxes_carry_how_a_handle_is_turned(tmp_path, ticks: Ticks):
    report = ticks.run(1)._replace(twist=EnergyMessage(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, True))
    order = ticks.core.order._replace(coupling=3, twist=EnergyMessage(6.0, 5.0, 4.0, 3.0, 2.0, 1.0, True))
    reports, orders = ReportWriter(tmp_path), OrderWriter(tmp_path)
    reports.write(report, report.time)
    orders.write(order)
    readers = ReportReader(tmp_path), OrderReader(tmp_path)
    assert readers[0].read() == report
    assert readers[1].read() == order
    orders.write(order._replace(coupling=4, turning=None, orientation=None))
    again = readers[1].read()
    assert again is not None
    assert (again.turning, again.orientation) == (None, None)
    for one in (reports, orders, *readers):
        one.close()
