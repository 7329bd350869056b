"""Lines on which a hand depends: what each does to the device, and that a test fails where one of them is wrong.

Every check takes the drivers that it looks at. It is passed by those that there are, and by none of the mutants.
"""

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.drivers.driving import PUSH, TWIST, in_motion, push, ready
from tests.drivers.mutants import Drivers, mutated
from tests.drivers.standin import Board, Fault

from cotouch.errors import DeviceError
from cotouch.haptics import Device, Flag

Check = Callable[[Drivers, Board, str], None]


def stop_brakes(drivers: Drivers, board: Board, library: str) -> None:
    """The motors are off after `stop`, not only at zero."""
    device = ready(drivers.ForceDimension(library=library))
    try:
        assert board.get("enabled") == 1
        device.stop()
        assert board.get("enabled") == 0
    finally:
        device.close()


def _left_on(device: Device, board: Board) -> None:
    board.set("force", 0.0, 0.0, 5.0)
    board.set("enabled", 1)  # as whoever had it before left it
    try:
        device.open()
        assert board.get("enabled") == 0
    finally:
        device.close()


def off_at_opening(drivers: Drivers, board: Board, library: str) -> None:
    """Motors that somebody left on are off once a device is open."""
    _left_on(drivers.ForceDimension(library=library), board)


def touch_off_at_opening(drivers: Drivers, board: Board, library: str) -> None:
    """Before its first tick as well, which would switch them off."""
    _left_on(drivers.Touch(library=library), board)
    assert board.get("cause") == 0


def off_after_it_found_its_place(drivers: Drivers, board: Board, library: str) -> None:
    device = drivers.ForceDimension(library=library)
    board.set("initialized", 0)
    try:
        device.open()
        device.calibrate(allow_motion=True)
        assert board.get("enabled") == 0
    finally:
        device.close()


def protected(drivers: Drivers, board: Board, library: str) -> None:
    """Clamping, ramping and limit of OpenHaptics are on before there can be force."""
    device = drivers.Touch(library=library)
    try:
        device.open()
        assert board.get("protect") == 0b111
    finally:
        device.close()


def gravity(drivers: Drivers, board: Board, library: str) -> None:
    """An arm whose gravity is not compensated falls into a hand."""
    device = drivers.ForceDimension(library=library)
    try:
        device.open()
        assert board.get("gravity") == 1
    finally:
        device.close()


def guarded_is_stale(drivers: Drivers, board: Board, library: str) -> None:
    """A place that the SDK did not ask the device for, as the last call was just before, is the one of before."""
    device = ready(drivers.ForceDimension(library=library))
    try:
        assert not device.exchange(PUSH).flags & Flag.STALE
        board.inject(Fault.TIME_GUARD)
        assert device.exchange(PUSH).flags & Flag.STALE
    finally:
        device.close()


def status_is_asked(drivers: Drivers, board: Board, library: str) -> None:
    """Whether the device took its forces away is noticed within some cycles."""
    device = ready(drivers.ForceDimension(library=library))
    try:
        board.inject(Fault.TAKEN_AWAY, 1.0)
        board.wait_for("enabled", lambda enabled: enabled == 0)
        seen: list[Flag] = []
        push(device, 20, each=lambda reading: seen.append(reading.flags))
        assert not seen[-1] & Flag.FORCE_ON
    finally:
        device.close()


def no_force_on_a_frozen_place(drivers: Drivers, board: Board, library: str) -> None:
    """A force that follows from a place that stands still is not told even once."""
    device = ready(drivers.ForceDimension(library=library))
    try:
        in_motion(device)
        board.inject(Fault.FROZEN)
        before, good = board.get("pushes"), 0
        why, end = "", time.monotonic() + 20.0
        while not why and time.monotonic() < end:
            try:
                good += bool(device.exchange(PUSH).force.any())
            except DeviceError as error:
                why = str(error)
        assert "repeats one position" in why
        assert board.get("pushes") == before + good
    finally:
        device.close()


def returned_number(drivers: Drivers, board: Board, library: str) -> None:
    """Every call names the number that the SDK returned, which is not the device's in its order."""
    device = ready(drivers.ForceDimension(library=library))
    try:
        assert board.get("offset") != 0
        push(device, 20)
        device.enable_force(False)
        device.stop()
    finally:
        device.close()
    assert board.get("violations") == 0, board.said


def expert_calls(drivers: Drivers, board: Board, library: str) -> None:
    device = drivers.ForceDimension(library=library, velocity_threshold=9)
    try:
        device.open()
        assert device.watchdog
    finally:
        device.close()
    assert board.get("violations") == 0, board.said


def most(device: Device, board: Board, what: str, force: np.ndarray = PUSH, twist: np.ndarray = TWIST) -> float:
    """The most that goes out while it is pushed; a machine that stands still has it taken away now and then."""
    seen = list[float]()
    push(device, 50, force, lambda _: seen.append(float(np.linalg.norm(board.get(what)))), twist)
    return max(seen)


def clipped(drivers: Drivers, board: Board, library: str) -> None:
    """No more goes out than the device can, whoever asks."""
    device = ready(drivers.Touch(library=library))
    try:
        assert 3.0 < most(device, board, "force", np.array([0.0, 0.0, 50.0])) < 3.4
    finally:
        device.close()


def with_wrist(board: Board) -> None:
    board.set("system", 104)
    board.set("wrist", 1)


def no_torque_on_a_stuck_wrist(drivers: Drivers, board: Board, library: str) -> None:
    """A torque that follows from an orientation that stands still while the handle turns is taken away."""
    with_wrist(board)
    device = ready(drivers.ForceDimension(library=library), 20)
    try:
        board.inject(Fault.STUCK)
        why, end = "", time.monotonic() + 20.0
        while not why and time.monotonic() < end:
            try:
                push(device, 1)
            except DeviceError as error:
                why = str(error)
        assert "repeats one orientation" in why
    finally:
        device.close()


def clipped_torque(drivers: Drivers, board: Board, library: str) -> None:
    """No more goes out than the device can, whoever asks."""
    with_wrist(board)
    for make in (drivers.Touch, drivers.ForceDimension):
        device = ready(make(library=library))
        try:
            assert 0.1 < most(device, board, "torque", twist=np.array([0.0, 0.0, 5.0])) <= 0.2
        finally:
            device.close()


CHECKS: list[Check] = [
    stop_brakes,
    off_at_opening,
    touch_off_at_opening,
    off_after_it_found_its_place,
    protected,
    gravity,
    guarded_is_stale,
    status_is_asked,
    no_force_on_a_frozen_place,
    returned_number,
    expert_calls,
    clipped,
    no_torque_on_a_stuck_wrist,
    clipped_torque,
]
PROTECTIONS = "for protection in (FORCE_CLAMPING, FORCE_RAMPING, SOFTWARE_LIMIT):"
# What is in which module, what it is in the mutant, and what must notice.
MUTANTS: list[tuple[str, str, str, Check]] = [
    ("_dhd", 'self._call["dhdStop"](self._id)', "pass", stop_brakes),
    ("_force_dimension", "dhd.enable_force(False)\n            family", "family", off_at_opening),
    ("_force_dimension", "dhd.enable_force(False)  # finding", "pass  # finding", off_after_it_found_its_place),
    ("_hd", 'self._call["hdDisable"](FORCE_OUTPUT)', "pass", touch_off_at_opening),
    ("_hd", PROTECTIONS, "for protection in (FORCE_RAMPING, SOFTWARE_LIMIT):", protected),
    ("_hd", PROTECTIONS, "for protection in (FORCE_CLAMPING, SOFTWARE_LIMIT):", protected),
    ("_hd", PROTECTIONS, "for protection in (FORCE_CLAMPING, FORCE_RAMPING):", protected),
    ("_hd", PROTECTIONS, "for protection in ():", protected),
    ("_dhd", 'self._asked("dhdSetGravityCompensation", 1)', "pass", gravity),
    ("_dhd", 'self._asked("dhdSetGravityCompensation", 1)', 'self._asked("dhdSetGravityCompensation", 0)', gravity),
    ("_force_dimension", "Flag.STALE if guarded == TIME_GUARD", "Flag.STALE if False", guarded_is_stale),
    ("_force_dimension", "_ASK_EVERY = 10\n", "_ASK_EVERY = 1000\n", status_is_asked),
    ("_force_dimension", "if why is not None or at", "if at", no_force_on_a_frozen_place),
    ("_force_dimension", "why = why or self._turning_watch", "self._turning_watch", no_torque_on_a_stuck_wrist),
    ("_dhd", "self._index, self._id = index, opened", "self._index, self._id = index, index", returned_number),
    ("_dhd", 'if self._call["dhdEnableExpertMode"]() < 0:', "if False:", expert_calls),
    ("_dhd", 'self._asked("dhdEnableExpertMode", device=False)', "pass", expert_calls),
    ("_touch", "min(1.0, most / size) if size", "1.0 if size", clipped),
    ("_touch", "self._spec.torque if self._wrist else np.inf", "np.inf", clipped_torque),
    ("_dhd", 'self._asked("dhdSetMaxTorque", torque)', "pass", clipped_torque),
]  # fmt: skip


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.__name__)
def test_critical(check: Check, board: Board, built: Path):
    check(Drivers(), board, str(built))


@pytest.mark.parametrize("number", range(len(MUTANTS)))
def test_a_mutant_is_noticed(number: int, running: Callable, built: Path):
    module, line, wrong, check = MUTANTS[number]
    with running() as board, mutated(module, line, wrong) as drivers, pytest.raises((AssertionError, DeviceError)):
        check(drivers, board, str(built))
