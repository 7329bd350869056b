"""What the guardian does about a servo, without processes: it halts, ends, or leaves alone."""

import signal
from pathlib import Path
from typing import Any

import pytest
from tests.haptics.inside import ReportWriter, ServoWatch, Watched
from tests.haptics.plant import PLANT, PLANT_ALONE

from cotouch.coupling import EnergyMessage
from cotouch.haptics import Cause, DeviceChoice, Driver, Flag, ServoReport, ServoSettings


class Servo:
    """A process that ends when it is killed, and does not mind being asked to."""

    def __init__(self) -> None:
        self.commanded: list[str] = []

    def poll(self) -> int | None:
        return -signal.SIGKILL if "kill" in self.commanded else None

    def kill(self) -> None:
        self.commanded.append("kill")

    def terminate(self) -> None:
        self.commanded.append("terminate")


class World:
    """A clock that a guardian's sleep moves on, a servo that ticks until some moment, and what is done to it."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch, driver: Driver) -> None:
        self.now, self.servo = 100.0, Servo()
        self.halted: list[float] = []
        self.last, self.causes, self.unwanted = 101.0, Cause.RAMP, float("inf")
        self.silences: list[float] = []
        self._reports = ReportWriter(folder)
        self._seen = Watched(folder, lambda: self.now)
        monkeypatch.setattr("cotouch.haptics._guardian.time", self)
        monkeypatch.setattr("cotouch.haptics._guardian._said", lambda **_: None)
        halt = None if driver.halt is None else lambda **_: self.halted.append(self.now)
        chosen = Driver(
            name="plant", summary="", make=driver.make, spec=driver.spec, watchdog="It has none.", halt=halt
        )
        settings = ServoSettings(device=DeviceChoice("plant"), folder=folder)
        servo: Any = self.servo
        self.watch = ServoWatch(servo, settings, chosen)

    def monotonic(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds
        assert self.now < 110.0
        self.silences.append(self._seen.silence())
        if self.now <= self.last:
            zero = (0.0, 0.0, 0.0)
            report = ServoReport(
                self.now, 1, zero, zero, zero, zero, EnergyMessage(), 0.0, 0.0, self.causes, 0, Flag(0)
            )
            self._reports.write(report, self.now)

    def run(self) -> int:
        return self.watch.run(lambda: self.now > self.unwanted)


def test_a_servo_that_stands_still_is_halted_from_outside_again_and_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    world = World(tmp_path, monkeypatch, PLANT)
    assert world.run() == -signal.SIGKILL
    assert 0.04 < world.halted[0] - world.last < 0.05
    assert 30 < len(world.halted) < 60
    assert 1.0 < world.now - world.last < 1.02
    assert max(world.silences) < 0.005  # it said all the time that it looks


def test_where_nobody_else_reaches_the_device_it_is_ended_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    world = World(tmp_path, monkeypatch, PLANT_ALONE)
    world.run()
    assert 0.04 < world.now - world.last < 0.05


@pytest.mark.parametrize("before", [0.0, 0.02])
def test_a_peer_that_is_gone_changes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, before: float):
    """Peer and servo at once: the guardian does not wait for a servo that hangs to end by itself."""
    world = World(tmp_path, monkeypatch, PLANT)
    world.unwanted = world.last - before
    world.run()
    assert world.servo.commanded[0] == "terminate"
    assert 0.04 < world.halted[0] - world.last < 0.05


def test_a_servo_that_stopped_its_device_is_only_asked_to_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    world = World(tmp_path, monkeypatch, PLANT_ALONE)
    world.causes, world.unwanted = Cause.STOPPED, 100.5
    world.run()
    assert world.halted == []
    assert world.servo.commanded[0] == "terminate"
    assert 2.0 < world.now - 100.5 < 2.01  # it did not end, as this one never does


def test_before_it_ever_ticked_nothing_is_taken_away(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    world = World(tmp_path, monkeypatch, PLANT_ALONE)
    world.last, world.unwanted = 0.0, 105.0  # loading and calibrating take long
    world.run()
    assert world.now > 107.0


def test_where_all_of_the_machine_stood_still_a_servo_may_say_that_it_lives(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    world = World(tmp_path, monkeypatch, PLANT_ALONE)
    world.last = 101.0
    slept = world.sleep

    def stalled(seconds: float) -> None:
        if 100.5 < world.now < 100.6:
            world.now += 0.2
            world.last, kept = 0.0, world.last  # nor does the servo say anything just then
            slept(seconds)
            world.last = kept
        else:
            slept(seconds)

    world.sleep = stalled
    world.run()
    assert world.now > 101.04
