"""When the guardian ends a servo that stands still, on a clock of its own."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from cotouch.device import PRESETS
from cotouch.haptics import DeviceChoice, Driver, _guardian
from cotouch.haptics._settings import ServoSettings

LOOK = 0.005


@dataclass
class Looks:
    """What the guardian sees: so much later than at the look before, and whether the servo has said something."""

    script: Iterator[tuple[float, bool]]
    now: float = 100.0
    said: bool = False
    killed: float | None = None
    halted: list[float] = field(default_factory=list)

    def monotonic(self) -> float:
        return self.now

    def gone(self, wait: float = 0.0) -> bool:
        step = next(self.script, None)
        if step is None:
            return True
        self.now, self.said = self.now + step[0], step[1]
        return False

    def read(self) -> object:
        return object() if self.said else None

    def poll(self) -> int | None:
        return None if self.killed is None else -9

    def kill(self) -> None:
        self.killed = self.now


def watched(monkeypatch: pytest.MonkeyPatch, script: list[tuple[float, bool]], *, halts: bool = False) -> Looks:
    looks = Looks(iter(script))
    monkeypatch.setattr(_guardian, "time", looks)
    monkeypatch.setattr(_guardian, "ReportReader", lambda folder: looks)
    monkeypatch.setattr(_guardian, "_peer_is_gone", looks.gone)
    monkeypatch.setattr(_guardian, "_said", lambda **values: None)
    chosen = Driver(
        name="none", summary="", make=lambda: None, spec=PRESETS["phantom"], watchdog="",  # type: ignore[arg-type,return-value]
        halt=(lambda: looks.halted.append(looks.now)) if halts else None,
    )  # fmt: skip
    settings = ServoSettings(device=DeviceChoice("none"), folder=Path())
    _guardian._watch(looks, settings, chosen, [])  # type: ignore[arg-type]
    return looks


def test_a_servo_that_stands_still_is_ended_within_100_ms(monkeypatch: pytest.MonkeyPatch):
    looks = watched(monkeypatch, [(LOOK, True), *[(LOOK, False)] * 40])
    assert looks.killed is not None
    assert 0.09 < looks.killed - 100.0 - LOOK < 0.1


def test_where_the_whole_machine_stood_still_the_servo_gets_one_more_look(monkeypatch: pytest.MonkeyPatch):
    assert watched(monkeypatch, [(LOOK, True), (0.5, False), (LOOK, True), *[(LOOK, True)] * 9]).killed is None
    looks = watched(monkeypatch, [(LOOK, True), (0.5, False), *[(LOOK, False)] * 9])
    assert looks.killed == pytest.approx(100.0 + 0.5 + 2 * LOOK)


def test_a_machine_that_is_always_late_does_not_save_a_servo(monkeypatch: pytest.MonkeyPatch):
    looks = watched(monkeypatch, [(LOOK, True), *[(0.03, False)] * 100])
    assert looks.killed is not None
    assert looks.killed < 101.1


def test_where_force_can_be_taken_away_from_outside_it_is_and_the_servo_has_a_second(monkeypatch: pytest.MonkeyPatch):
    looks = watched(monkeypatch, [(LOOK, True), *[(LOOK, False)] * 100, (LOOK, True), (LOOK, True)], halts=True)
    assert looks.killed is None
    assert 0.06 < looks.halted[0] - 100.0 - LOOK < 0.07
    assert watched(monkeypatch, [(LOOK, True), *[(LOOK, False)] * 300], halts=True).killed == pytest.approx(
        101.0, abs=0.02
    )
