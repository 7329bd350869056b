"""The checks that every device passes see it when one does not do what the interface says."""

import math
import time
from collections.abc import Callable

import numpy as np
import pytest

from cotouch.errors import DeviceError
from cotouch.haptics import DeviceReading, Flag, SimulatedOnClock, conform, make_device


class Broken:
    """A simulated device with one thing wrong."""

    def __init__(self, wrong: str) -> None:
        self._inner = make_device("simulated", variant="cartesian", wrist="torque" in wrong)
        assert isinstance(self._inner, SimulatedOnClock)
        self._wrong, self._stopped = wrong, 0
        self.spec = self._inner.spec
        self._force = np.zeros(3)

    def open(self) -> None:
        self._inner.open()

    def calibrate(self, *, allow_motion: bool) -> None:
        if self._wrong != "not calibrated":
            self._inner.calibrate(allow_motion=allow_motion)

    def enable_force(self, on: bool = True) -> None:
        self._inner.enable_force(on)

    def exchange(self, force, torque=None) -> DeviceReading:
        if self._wrong == "crash":
            raise RuntimeError("segment 7\nfailed")
        assert isinstance(self._inner, SimulatedOnClock)
        was = self._inner.exchange(force, torque)
        if self._wrong == "slow":
            time.sleep(0.05)
        changed = {
            "nan": {"position": np.full(3, math.nan)},
            "always on": {"flags": was.flags | Flag.FORCE_ON, "force": np.asarray(force)},
            "too much": {"force": 2.0 * was.force},
            "millimetres": {"position": np.array([0.0, 0.0, 75.0]), "velocity": 1e3 * was.velocity + 100.0},
            "clock": {"time": 0.25 * was.time},
            "repeats": {"time": math.floor(was.time)},
            "shape": {"velocity": np.zeros(4)},
            "handle": {"orientation": np.array([0.0, 0.0, 0.0, 2.0])},
            "torque without a handle": {"orientation": None},
            "too much torque": {"torque": None if was.torque is None else 2.0 * was.torque},
            "torque always on": {"torque": torque},
        }.get(self._wrong, {})
        fields = {name: getattr(was, name) for name in DeviceReading.__dataclass_fields__}
        return DeviceReading(**(fields | changed))

    def stop(self) -> None:
        if self._wrong == "deaf":
            return
        self._stopped += 1
        if self._wrong == "stops once" and self._stopped > 1:
            raise RuntimeError
        self._inner.stop()

    def close(self) -> None:
        self._inner.close()


@pytest.mark.parametrize(
    ("wrong", "check"),
    [
        ("not calibrated", "calibrated"),
        ("crash", "exchange before open is refused"),
        ("slow", "in time, before calibration"),
        ("nan", "finite, before calibration"),
        ("always on", "no force before it is enabled"),
        ("too much", "no more force than commanded"),
        ("millimetres", "velocity is m/s, before calibration"),
        ("millimetres", "position is m from the centre of the workspace, with force"),
        ("clock", "time is the clock's, before calibration"),
        ("repeats", "time rises, before calibration"),
        ("shape", "three numbers each, before calibration"),
        ("handle", "orientation is a unit quaternion, before calibration"),
        ("deaf", "no force after stop"),
        ("torque without a handle", "it has an orientation, with force"),
        ("too much torque", "no more torque than commanded"),
        ("torque always on", "no force after stop"),
        ("stops once", "stop from other threads, repeatedly"),
    ],
)
def test_what_is_wrong_is_found(wrong: str, check: str):
    make: Callable[[], Broken] = lambda: Broken(wrong)  # noqa: E731
    found = conform(make, cycles=10)
    assert check in [finding.check for finding in found if not finding.passed]
    assert not [finding.detail for finding in found if "\n" in finding.detail]


def test_what_a_device_raises_is_a_sentence_with_its_place():
    (crash,) = [finding for finding in conform(lambda: Broken("crash"), cycles=10) if finding.check == "it works"]
    assert crash.detail.startswith("RuntimeError: segment 7 failed (test_conformance.py, line ")


def test_a_member_that_is_missing_is_a_sentence():
    class Without:
        spec = Broken("").spec

        def open(self) -> None: ...

    (found,) = conform(Without, cycles=10)  # pyright: ignore[reportArgumentType]
    assert not found.passed
    assert found.detail == "calibrate, enable_force, exchange, stop, close missing"


def test_a_device_that_is_missing_is_a_sentence():
    class Missing(Broken):
        def open(self) -> None:
            raise DeviceError("no such device is plugged in; plug it in")

    found = conform(lambda: Missing(""), cycles=10)
    assert found[-1].check == "it works"
    assert not found[-1].passed
    assert found[-1].detail == "no such device is plugged in; plug it in"
