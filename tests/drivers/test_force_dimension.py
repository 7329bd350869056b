"""Force Dimension's SDK by ctypes: axes, limits, calibration, watchdog, and what is said when it is not there."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from tests.drivers.driving import push, ready
from tests.drivers.inside import SPECS, SYSTEMS, ForceDimension, count, versioned
from tests.drivers.standin import COMPILER, Board, Fault

from cotouch.errors import DeviceError
from cotouch.haptics import Flag


@pytest.fixture
def device(board: Board, built: Path):
    made = ForceDimension(library=str(built), reset_seconds=0.05)
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
    assert board.get("watchdog") == pytest.approx(0.02)


@pytest.mark.parametrize(
    ("system", "family", "name"),
    [
        (33, "omega", "Force Dimension omega.3"),
        (110, "omega", "Force Dimension omega.3"),
        (63, "delta", "Force Dimension delta.3"),
        (105, "sigma", "Force Dimension sigma.7 left"),
        (209, "sigma", "Force Dimension sigma.7"),
        (133, "sigma", "Force Dimension sigma.3"),
        (116, "sigma", "Force Dimension sigma.6 left"),
        (131, "lambda", "Force Dimension lambda.6"),
        (129, "lambda", "Force Dimension lambda.7"),
        (211, "lambda", "Force Dimension lambda.7 left"),
        (60, "falcon", "Novint Falcon"),
    ],
)
def test_families(board: Board, device: ForceDimension, system: int, family: str, name: str):
    board.set("system", system)
    device.open()
    assert device.spec.name == name
    assert device.spec.force == SPECS[family].force
    assert device.spec.workspace == SPECS[family].workspace
    assert device.watchdog == (family != "falcon")


def test_every_system_type_is_known():
    """Those of dhdc.h, and the revisions that CHAI3D knows."""
    named = {33, 34, 35, 36, 37, 60, 63, 64, 104, 105, 108, 109, 131, 132, 203, 206}
    assert named | set(range(102, 131)) | {133, 209, 210, 211} == set(SYSTEMS)
    assert SPECS["lambda"].workspace == 0.1125
    sevens = {number for number, system in SYSTEMS.items() if "7" in system.product}
    assert sevens == {number for number, system in SYSTEMS.items() if system.gripper}


@pytest.mark.parametrize(
    ("system", "middle"), [(104, (-10, 20, 0)), (102, (-10, 20, 0)), (105, (-10, -20, 0)), (33, (0, 0, 0))]
)
def test_the_middle_of_the_workspace(board: Board, device: ForceDimension, system: int, middle: tuple[float, ...]):
    """What CHAI3D adds to the places of a sigma.7, in the vendor's axes [mm]."""
    board.set("system", system)
    device.open()
    for _ in range(20):  # it moves meanwhile, by 0.2 m/s at most, and the machine may stand still for some 10 ms
        board.inject(Fault.FROZEN)
        x, y, z = device.exchange(np.zeros(3)).position
        away = np.abs([-x, -y, z] - np.array(board.get("position")) - 1e-3 * np.array(middle)).max()
        board.inject(Fault.NONE)
        if away < 5e-3:
            return
    raise AssertionError(away)


@pytest.mark.parametrize(("system", "grips"), [(35, 1), (37, 1), (104, 1), (209, 1), (33, 0), (34, 0), (108, 0)])
def test_a_closed_gripper_is_a_button(board: Board, device: ForceDimension, system: int, grips: int):
    board.set("system", system)
    device.open()  # of a lambda.7 the SDK does not know it, which is no error
    assert board.get("emulated") == grips


def test_another_family_than_asked_for(board: Board, built: Path):
    with pytest.raises(DeviceError, match=r"device 0 is of type omega\.3, but a delta was requested"):
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
    assert board.get("enabled") == 0  # finding its place had them on
    assert device.exchange(np.zeros(3)).flags & Flag.CALIBRATED


def test_calibration_that_fails(board: Board, device: ForceDimension):
    board.set("initialized", 0)
    device.open()
    board.inject(Fault.REFUSED)
    with pytest.raises(DeviceError, match=r"keep clear of it: .*cannot find the index of an encoder"):
        device.calibrate(allow_motion=True)


def test_velocity_threshold_only_downwards(board: Board, built: Path):
    # A device keeps its threshold, and so does its stand-in for all tests of a process: the same one as in the others.
    device = ForceDimension(library=str(built), velocity_threshold=9)
    device.open()
    device.close()
    with pytest.raises(DeviceError, match="threshold is 10; it must be from 1 to 9"):
        ForceDimension(library=str(built), velocity_threshold=10).open()


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


def test_a_library_with_a_version_in_its_name_is_found(board: Board, built: Path, tmp_path: Path, monkeypatch):
    """As the SDK ships it; of several the newest, by numbers and not by letters."""
    folder = tmp_path / "lib"
    folder.mkdir()
    for name in ("libdrd.so.3.9.1", "libdrd.so.3.17.4", "libdrd.so.txt", "libdrd.so.3.18.0.old", "xlibdrd.so.4"):
        (folder / name).write_bytes(b"no library")
    shutil.copy(built / "libdrd.so", folder / "libdrd.so.3.17.5")
    for given in (str(folder), None):
        device = ForceDimension(library=given)
        device.open()
        assert device.spec.name == "Force Dimension omega.3"
        device.close()
        monkeypatch.setenv("COTOUCH_FORCE_DIMENSION", str(folder))
    monkeypatch.delenv("COTOUCH_FORCE_DIMENSION")
    monkeypatch.setenv("LD_LIBRARY_PATH", str(folder))
    assert count() == 1


@pytest.mark.parametrize(
    ("names", "there", "found"),
    [
        (("libdrd.dylib",), ["libdrd.3.9.dylib", "libdrd.3.17.5.dylib", "libdrd.so.4"], ["3.17.5", "3.9"]),
        (("libHD.so",), ["libHD.so.3.4", "libHD.so.3.5", "libHD.so.", "libHD.so.3..5"], ["3.5", "3.4"]),
    ],
)
def test_versions(tmp_path: Path, names: tuple[str, ...], there: list[str], found: list[str]):
    for name in there:
        (tmp_path / name).touch()
    versions = [re.sub(r"[^0-9.]", "", Path(path).name).strip(".") for path in versioned(tmp_path, names)]
    assert versions == found
    assert versioned(tmp_path / "nowhere", names) == ()


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
