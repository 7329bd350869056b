"""Force Dimension's SDK by ctypes: axes, limits, calibration, watchdog, and what is said when it is not there."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from tests.drivers.driving import push, ready
from tests.drivers.standin import COMPILER, Board, Fault

from cotouch.drivers._force_dimension import SPECS, ForceDimension
from cotouch.errors import DeviceError
from cotouch.haptics import Flag


@pytest.fixture
def device(board: Board, built: Path):
    made = ForceDimension(library=str(built), watchdog=0.03, reset_seconds=0.05)
    yield made
    made.close()


def test_axes(board: Board, device: ForceDimension):
    ready(device)
    push(device, 10, np.array([1.0, 2.0, 3.0]))
    assert board.get("force") == (-1.0, -2.0, 3.0)
    board.inject(Fault.FROZEN)
    reading = device.exchange(np.zeros(3))
    x, y, z = reading.position
    board.inject(Fault.NONE)
    theirs = board.get("position")
    np.testing.assert_allclose([-x, -y, z], theirs, atol=2e-3)  # it moves meanwhile, by 0.2 m/s at most


def test_force_is_set_in_every_cycle_also_zero_and_with_motors_off(board: Board, device: ForceDimension):
    device.open()
    before = board.get("sets")
    push(device, 10, np.zeros(3))
    assert board.get("sets") == before + 10


def test_more_than_the_motors_can_is_limited(board: Board, device: ForceDimension):
    ready(device)
    assert not push(device, 3, np.array([0.0, 0.0, 11.0])).flags & Flag.LIMITED
    reading = push(device, 3, np.array([0.0, 0.0, 24.0]))
    assert reading.flags & Flag.LIMITED
    np.testing.assert_allclose(reading.force, [0.0, 0.0, 12.0])
    assert board.get("max_force") == SPECS["omega"].force == 12.0


def test_watchdog_is_armed(board: Board, device: ForceDimension):
    device.open()
    assert device.watchdog
    assert board.get("watchdog") == pytest.approx(0.03)


@pytest.mark.parametrize(
    ("system", "family", "name"),
    [
        (33, "omega", "Force Dimension omega.3"),
        (63, "delta", "Force Dimension delta.3"),
        (105, "sigma", "Force Dimension sigma.7 left"),
        (131, "lambda", "Force Dimension lambda.6"),
        (60, "falcon", "Novint Falcon"),
    ],
)
def test_families(board: Board, device: ForceDimension, system: int, family: str, name: str):
    board.set("system", system)
    device.open()
    assert device.spec.name == name
    assert device.spec.force == SPECS[family].force
    assert device.watchdog == (family != "falcon")


def test_another_family_than_asked_for(board: Board, built: Path):
    with pytest.raises(DeviceError, match=r"device 0 is a omega\.3; it must be a delta"):
        ForceDimension(family="delta", library=str(built)).open()
    assert board.get("open") == 0


def test_it_moves_only_when_it_may(board: Board, device: ForceDimension):
    board.set("initialized", 0)
    device.open()
    assert not device.exchange(np.zeros(3)).flags & Flag.CALIBRATED
    with pytest.raises(DeviceError, match=r"put its handle into its rest, or allow it to move by itself: .*timeout"):
        device.calibrate(allow_motion=False)
    assert board.get("initialized") == 0
    device.open()
    device.calibrate(allow_motion=True)
    assert device.exchange(np.zeros(3)).flags & Flag.CALIBRATED


def test_calibration_that_fails(board: Board, device: ForceDimension):
    board.set("initialized", 0)
    device.open()
    board.inject(Fault.REFUSED)
    with pytest.raises(DeviceError, match=r"keep clear of it: .*cannot find the index of an encoder"):
        device.calibrate(allow_motion=True)


def test_velocity_threshold_only_downwards(board: Board, built: Path):
    device = ForceDimension(library=str(built), velocity_threshold=20)
    device.open()
    device.close()
    with pytest.raises(DeviceError, match="threshold is 21; it must be from 1 to 20"):
        ForceDimension(library=str(built), velocity_threshold=21).open()


def test_device_in_use_and_device_absent(board: Board, built: Path):
    board.inject(Fault.REFUSED)
    with pytest.raises(DeviceError, match="cannot be opened: device is already in use by another application"):
        ForceDimension(library=str(built)).open()
    board.inject(Fault.UNPLUGGED)
    with pytest.raises(DeviceError, match="finds 0 devices, so none has the number 0; connect it"):
        ForceDimension(library=str(built)).open()


def test_buttons(board: Board, device: ForceDimension):
    device.open()
    board.set("buttons", 3)
    assert device.exchange(np.zeros(3)).buttons == 3


def test_library_that_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.delenv("COTOUCH_FORCE_DIMENSION", raising=False)
    with pytest.raises(
        DeviceError, match=r"not where this system looks .*install the Force Dimension SDK .*, or set COTO"
    ):
        ForceDimension().open()
    with pytest.raises(DeviceError, match=f"is not at {tmp_path}; install"):
        ForceDimension(library=str(tmp_path)).open()
    (tmp_path / "libdrd.so").write_bytes(b"no library")
    monkeypatch.setenv("COTOUCH_FORCE_DIMENSION", str(tmp_path))
    with pytest.raises(DeviceError, match=f"the library {tmp_path} of Force Dimension cannot be loaded"):
        ForceDimension().open()


def test_library_that_is_too_old(tmp_path: Path):
    if COMPILER is None:
        pytest.skip("no C compiler here")
    (tmp_path / "old.c").write_text("int dhdGetDeviceCount(void) { return 1; }\n")
    library = tmp_path / "libdrd.so"
    subprocess.run([COMPILER, "-shared", "-fPIC", "-o", library, tmp_path / "old.c"], check=True)
    with pytest.raises(DeviceError, match="has no function dhdErrorGetLastStr, so it is too old"):
        ForceDimension(library=os.fspath(library)).open()


def test_watchdog_range():
    with pytest.raises(DeviceError, match=r"must be from 0.001 to 0.03 s"):
        ForceDimension(watchdog=0.05)
