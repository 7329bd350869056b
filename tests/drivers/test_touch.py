"""3D Systems Touch by ctypes: the library's thread, frames, calibration, and exceptions that must not leave a tick."""

import gc
import time
from pathlib import Path

import numpy as np
import pytest
from tests.drivers.driving import push, ready
from tests.drivers.inside import Touch, alive, quaternion
from tests.drivers.standin import Board, Fault
from tests.stalls import Stalls

from cotouch.errors import DeviceError
from cotouch.haptics import Flag


@pytest.fixture
def device(board: Board, built: Path):
    made = Touch(library=str(built), hand_seconds=0.1)
    yield made
    made.close()


def test_axes_and_units(board: Board, device: Touch):
    ready(device)
    push(device, 10, np.array([1.0, 2.0, 3.0]) / 4)
    # Ours: x forward, y left, z up; theirs: x right, y up, z towards the user.
    np.testing.assert_allclose(board.get("force"), np.array([-2.0, 3.0, -1.0]) / 4)
    board.inject(Fault.FROZEN)
    x, y, z = push(device, 3).position
    theirs = np.array(board.get("position")) + np.array(
        [0.0, 0.01, 0.0]
    )  # the middle of the stub's workspace: y from -50 to 70
    np.testing.assert_allclose([-y, z + 0.01, -x], theirs, atol=3e-3)


def test_limits_are_what_the_library_says(device: Touch):
    device.open()
    assert device.spec.name == "3D Systems Touch"
    assert (device.spec.force, device.spec.continuous_force) == (3.3, 0.88)


def test_more_than_the_device_can_is_shortened_before_it_goes_out(board: Board, device: Touch):
    ready(device)
    reading = push(device, 10, np.array([0.0, 0.0, 10.0]))
    assert reading.flags & Flag.LIMITED
    np.testing.assert_allclose(reading.force, [0.0, 0.0, 3.3])
    np.testing.assert_allclose(board.get("force"), [0.0, 3.3, 0.0])


def test_a_force_that_nobody_renews_is_taken_away_by_the_tick(board: Board, device: Touch, stalls: Stalls):
    ready(device, 20)
    began = time.monotonic()
    time.sleep(0.15)  # the servo hangs, the library's thread does not
    stalls.within(began, board.gone_after(began))


@pytest.mark.parametrize("error", [ValueError("odd"), SystemExit(3), KeyboardInterrupt()])
def test_exceptions_in_a_tick_end_the_force(
    board: Board, device: Touch, monkeypatch: pytest.MonkeyPatch, error: BaseException, stalls: Stalls
):
    ready(device, 20)

    def bad(_numbers: object) -> None:
        board.set("struck", time.monotonic())
        raise error

    monkeypatch.setattr("cotouch.drivers._touch._quaternion", bad)
    with pytest.raises(DeviceError, match="the servo failed"):
        push(device, 20)
    time.sleep(0.02)
    stalls.within(board.get("struck"), board.gone_after(board.get("struck")))


def test_the_callback_outlives_whoever_forgets_its_device(board: Board, built: Path, stalls: Stalls):
    device = Touch(library=str(built))
    ready(device)
    callbacks = len(alive)
    hd = device._hd
    assert hd is not None
    left = time.monotonic()
    del device
    gc.collect()
    stalls.within(left, board.gone_after(left))  # it still ticks, with a force that nobody renews
    assert len(alive) == callbacks
    hd.halt()
    alive.clear()


def test_calibration_by_hand(board: Board, device: Touch):
    board.set("initialized", 0)
    device.open()
    assert not push(device, 3).flags & Flag.CALIBRATED
    with pytest.raises(DeviceError, match="put its stylus into the inkwell"):
        device.calibrate(allow_motion=True)


def test_calibration_that_only_needs_taking_up(board: Board, device: Touch):
    board.set("initialized", 2)
    device.open()
    assert not push(device, 3).flags & Flag.CALIBRATED
    device.calibrate(allow_motion=False)
    assert push(device, 3).flags & Flag.CALIBRATED


AUTO, INKWELL, RESET = 2, 4, 1


@pytest.mark.parametrize("styles", [AUTO, INKWELL, AUTO | INKWELL, INKWELL | RESET, AUTO | INKWELL | RESET])
def test_one_style_of_calibration_at_a_time(board: Board, device: Touch, styles: int):
    """The library tells all that it can in one mask, and takes one; the stub notes it where it is told two."""
    board.set("styles", styles)
    board.set("initialized", 2)
    device.open()
    device.calibrate(allow_motion=False)
    assert push(device, 3).flags & Flag.CALIBRATED
    assert board.get("asked") == 1


def test_encoders_are_reset_only_where_somebody_said_that_it_is_held_there(board: Board, built: Path, device: Touch):
    board.set("styles", RESET)
    board.set("initialized", 0)
    device.open()
    with pytest.raises(DeviceError, match="hold it there as its manual shows, and open it with the option reset=true"):
        device.calibrate(allow_motion=True)
    assert board.get("asked") == 0
    device.close()
    held = Touch(library=str(built), reset=True)
    try:
        held.open()
        assert board.get("asked") == 0  # whoever opens it only to stop it moves no origin
        held.calibrate(allow_motion=False)
        assert board.get("asked") == 1
        held.enable_force()
        held.calibrate(allow_motion=False)  # calibrated already: nothing is reset in a hand that moves
        assert push(held, 3).flags & Flag.CALIBRATED
        assert board.get("asked") == 1
    finally:
        held.close()


def test_reset_has_no_effect_on_a_device_with_an_inkwell(board: Board, built: Path):
    board.set("initialized", 0)
    device = Touch(library=str(built), hand_seconds=0.1, reset=True)
    try:
        device.open()
        with pytest.raises(DeviceError, match="put its stylus into the inkwell"):
            device.calibrate(allow_motion=False)
        assert board.get("asked") == 0
    finally:
        device.close()


def test_warm_motors_are_a_limit_not_a_fault(board: Board, device: Touch):
    ready(device)
    board.inject(Fault.SAFETY, 0x200)
    reading = push(device, 10)
    assert reading.flags & Flag.LIMITED
    assert reading.flags & Flag.FORCE_ON


def test_device_that_does_not_start(board: Board, built: Path):
    with pytest.raises(DeviceError, match=r'device "Left" does not start: Device fault.*set it up with'):
        Touch("Left", library=str(built)).open()


def test_library_that_is_missing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    monkeypatch.setenv("COTOUCH_OPENHAPTICS", str(tmp_path))
    with pytest.raises(DeviceError, match=rf"libHD.so of OpenHaptics .* is not at {tmp_path}; install OpenHaptics"):
        Touch().open()


@pytest.mark.parametrize("turn", [0.1, 2.0, 3.1])
@pytest.mark.parametrize("axis", range(3))
def test_quaternions(turn: float, axis: int):
    c, s = np.cos(turn), np.sin(turn)
    R = np.eye(3)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R[i, i], R[i, j], R[j, i], R[j, j] = c, -s, s, c
    transform = np.eye(4)
    transform[:3, :3] = R
    got = np.array(quaternion(transform.T.ravel().tolist()))
    want = np.zeros(4)
    want[axis], want[3] = np.sin(turn / 2), np.cos(turn / 2)
    np.testing.assert_allclose(got * np.sign(got[3]), want, atol=1e-12)
