"""The servo's loop in this process, around a device that fails: force goes, and the reason is said."""

import os
import time
from collections.abc import Callable, Generator
from dataclasses import replace
from math import inf, nan
from pathlib import Path

import numpy as np
import pytest
from tests.haptics.inside import OrderWriter, ReportReader, ReportWriter, hung_up
from tests.haptics.plant import DEAF, FROZEN, NAN, SLOW, THROW, Plant, PlantDevice
from tests.stalls import Stalls

from cotouch.coupling import EnergyMessage
from cotouch.device import PRESETS
from cotouch.haptics import (
    Cause,
    DeviceChoice,
    EndOptions,
    Order,
    SafetyLimits,
    Servo,
    ServoCore,
    ServoReport,
    ServoSettings,
    SimulatedOnClock,
    simulated_model,
)


class Loop:
    def __init__(self, folder: Path) -> None:
        self.watched = self.attended = True
        device = PlantDevice(str(folder))
        device.open()
        settings = ServoSettings(device=DeviceChoice("plant"), folder=folder)
        self.servo = Servo(device, settings, watched=lambda: self.watched, attended=lambda: self.attended)
        self.orders, self.reports = OrderWriter(folder), ReportReader(folder)
        self.report: ServoReport | None = None
        self.runs, self.rearm, self.enable, self.given = True, 0, True, 1.0

    def until(self, done: Callable[[], object], what: str, *, orders: bool = True) -> None:
        end = time.monotonic() + 60.0
        while not done():
            assert time.monotonic() < end, f"{what}: {self.report}"
            self.given += 1e-3  # energy that never ends, however long a test takes
            if orders:
                self.orders.write(
                    Order(
                        time=time.monotonic(),
                        place=(0.03, 0.0, 0.0),
                        message=EnergyMessage(given=self.given),
                        enable=self.enable,
                        rearm=self.rearm,
                    )
                )
            if self.runs:
                self.runs = self.servo.cycle()
            self.report = self.reports.read() or self.report
            time.sleep(0.001)

    def close(self) -> None:
        self.servo.close()
        self.orders.close()
        self.reports.close()


@pytest.fixture
def plant(tmp_path: Path) -> Generator[Plant]:
    made = Plant(tmp_path)
    yield made
    made.close()


@pytest.fixture
def loop(plant: Plant, tmp_path: Path) -> Generator[Loop]:
    made = Loop(tmp_path)
    try:
        made.until(lambda: plant.force > 0.0, "force")
        yield made
    finally:
        made.close()


def causes(loop: Loop) -> Cause:
    assert loop.report is not None
    return loop.report.causes


@pytest.mark.parametrize(
    ("mode", "cause", "fault"),
    [
        (NAN, Cause.FAULT, ""),
        (DEAF, Cause.FAULT, "the plant does not answer; is it plugged in?"),
        (SLOW, Cause.FAULT, "the plant does not answer; is it plugged in?"),
        (FROZEN, Cause.LATE, ""),
        (THROW, Cause.FAST, ""),
    ],
)
def test_a_device_that_fails_is_left_without_force(
    plant: Plant, loop: Loop, mode: int, cause: Cause, fault: str, stalls: Stalls
):
    began = time.monotonic()
    plant.command(mode)
    loop.until(lambda: causes(loop) & cause, "cause")
    loop.until(lambda: plant.force == 0.0, "no force")
    assert loop.servo.fault == fault
    assert loop.runs == (cause != Cause.FAULT)
    if not fault:  # this driver waits for a quarter of a second; real ones don't
        stalls.within(began, plant.gone_after(began))


@pytest.mark.parametrize("ahead", [0.5, 1e9, inf, nan])
def test_an_order_from_the_future_is_silence(plant: Plant, loop: Loop, ahead: float, stalls: Stalls):
    """Its sender hangs right after it: the stamp keeps nothing alive, now or when the clock comes to it."""
    began = time.monotonic()
    order = Order(time=began + ahead, place=(0.03, 0.0, 0.0), message=EnergyMessage(given=1.0), enable=True)
    loop.orders.write(order)
    loop.until(lambda: causes(loop) & Cause.SILENT, "cause", orders=False)
    loop.until(lambda: plant.force == 0.0, "no force", orders=False)
    stalls.within(began, plant.gone_after(began))
    seen: list[Cause] = []
    loop.until(lambda: seen.append(causes(loop)) or time.monotonic() > began + 0.7, "a while", orders=False)
    assert all(cause & Cause.SILENT for cause in seen)
    assert plant.force == 0.0
    loop.until(lambda: plant.force > 0.0, "force again")  # orders of now


def test_a_loop_that_nobody_watches_ends(plant: Plant, loop: Loop):
    loop.watched = False
    loop.until(lambda: not loop.runs, "its end")
    loop.until(lambda: plant.force == 0.0, "no force")
    assert causes(loop) & Cause.PARENT
    loop.servo.say()  # and it goes on saying so
    report = loop.reports.read()
    assert report is not None
    assert report.causes == Cause.PARENT
    assert report.force == (0.0, 0.0, 0.0)


def test_a_loop_whose_peer_is_dead_ends_before_it_is_silent(plant: Plant, loop: Loop):
    loop.attended = False
    loop.until(lambda: not loop.runs, "its end")
    loop.until(lambda: plant.force == 0.0, "no force")
    assert causes(loop) == Cause.PEER


def test_how_a_handle_is_turned_comes_to_the_peer(tmp_path: Path):
    now, spec = [0.0], PRESETS["phantom"]
    device = SimulatedOnClock(simulated_model("cartesian"), spec, turn=1.0, clock=lambda: now[0])
    device.open()
    core = ServoCore(spec, SafetyLimits.of(spec), EndOptions())
    writer, reader = ReportWriter(tmp_path), ReportReader(tmp_path)

    def told(orientation: np.ndarray | None) -> tuple[float, ...] | None:
        reading = replace(device.exchange(np.zeros(3)), orientation=orientation)
        writer.write(core.cycle(reading, now[0]), now[0])
        report = reader.read()
        assert report is not None
        return report.orientation

    try:
        turned = None
        for now[0] in np.linspace(0.0, 1.0, 41).tolist():  # a quarter of a round
            turned = device.exchange(np.zeros(3)).orientation
        assert turned is not None
        assert told(turned) == pytest.approx((0.0, 0.0, np.sin(0.5), np.cos(0.5)), abs=1e-3)
        assert told(None) is None
        assert told(np.array([0.0, 0.0, 0.0, 2.0])) is None  # no rotation
        assert told(np.array([nan, 0.0, 0.0, 1.0])) is None
    finally:
        device.close()
        writer.close()
        reader.close()


@pytest.mark.parametrize("kept", [0, 1], ids=["reads", "writes"])
def test_whose_pipe_is_held_by_nobody_else_knows_it_at_once(kept: int):
    pipe = os.pipe()
    try:
        gone = hung_up(pipe[kept])
        assert not gone()
        os.close(pipe[1 - kept])
        assert gone()
    finally:
        os.close(pipe[kept])


def test_a_device_that_switches_itself_off_comes_back_when_re_armed(plant: Plant, loop: Loop):
    PlantDevice.stop(loop.servo._device)  # as a safety switch on it
    loop.until(lambda: causes(loop) & Cause.DEVICE, "cause")
    assert plant.force == 0.0
    loop.rearm += 1
    loop.until(lambda: plant.force > 0.0, "force again")


def test_force_follows_what_the_peer_wants(plant: Plant, loop: Loop):
    loop.enable = False
    loop.until(lambda: causes(loop) & Cause.OFF, "off")
    loop.until(lambda: plant.force == 0.0, "no force")
    loop.enable = True
    loop.until(lambda: causes(loop) & Cause.RAMP, "coming back")
    loop.until(lambda: plant.force > 0.0, "force again")
