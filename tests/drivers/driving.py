"""Driving a device as a servo does, until it fails or must stop."""

import time
from collections.abc import Callable
from typing import cast

import numpy as np
from tests.drivers.standin import Board, Fault

from cotouch.errors import DeviceError
from cotouch.haptics import Device, DeviceReading, TorqueDevice

PUSH = np.array([1.0, -0.5, 0.25])
TWIST = np.array([0.01, 0.02, -0.04])
STALLS = ("ms for a cycle", "no longer ticks", "does not tick", "did not answer")


def stalled(error: BaseException) -> bool:
    """Whether that may come of a machine that stood still for longer than a device waits."""
    return any(stall in str(error) for stall in STALLS)


def ready(device: Device, cycles: int = 5) -> Device:
    """Opened, calibrated, motors on, and pushing.

    A test's machine may stall for longer than a device waits, 30 or 40 ms; then it is begun again.
    """
    for _ in range(4):
        device.open()
        device.calibrate(allow_motion=False)
        device.enable_force()
        try:
            push(device, cycles)
        except DeviceError as error:
            if not stalled(error):
                raise
        else:
            return device
        device.close()
    raise AssertionError("this machine stalls all the time")


def push(
    device: Device,
    cycles: int,
    force: np.ndarray = PUSH,
    each: Callable[[DeviceReading], None] | None = None,
    twist: np.ndarray = TWIST,
):
    """Some cycles at about 1 kHz, with a torque where a device renders it; returns the last reading."""
    reading = None
    for _ in range(cycles):
        reading = cast("TorqueDevice", device).exchange(force, twist) if device.spec.torque else device.exchange(force)
        if each is not None:
            each(reading)
        time.sleep(5e-4)
    assert reading is not None
    return reading


def in_motion(device: Device, speed: float = 0.03) -> None:
    """Pushes until the last sample says that the device moves: one that rests may stand still to the last bit [m/s]."""
    late = time.monotonic() + 20.0
    while np.abs(push(device, 1).velocity).max() < speed:
        assert time.monotonic() < late, "the device does not move"


def acts(device: Device, board: Board, what: str = "motor", force: np.ndarray = PUSH) -> None:
    """Pushes until the motors do: a library has a thread of its own, which may not have had its turn."""
    late = time.monotonic() + 20.0
    while not any(board.get(what)):
        assert time.monotonic() < late, f"no {what}"
        push(device, 1, force)


def fails(device: Device, board: Board, fault: Fault, value: float = 0.0) -> tuple[str, float]:
    """Injects a fault while the motors push; returns the reason, and how long after it the force was gone [s]."""
    device.close()
    ready(device, 30)
    acts(device, board)
    if fault is Fault.FROZEN:
        in_motion(device)
    board.inject(fault, value)
    end = time.monotonic() + 20.0
    why = ""
    while not why and time.monotonic() < end:
        try:
            push(device, 1)
        except DeviceError as error:
            why = str(error)
    struck = board.get("struck")
    assert struck > 0.0
    return why, board.gone_after(struck)


def is_sentence(why: str) -> bool:
    """Whether a person can read it."""
    return 20 < len(why) < 400 and "\n" not in why and "Traceback" not in why
