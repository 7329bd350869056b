"""Whatever fails, the motors have no force soon after, by the stand-in's own log, and the reason can be read."""

import threading
import time
from collections.abc import Generator
from pathlib import Path

import numpy as np
import pytest
from tests.drivers.driving import PUSH, fails, is_sentence, push, ready
from tests.drivers.standin import Board, Fault, Service
from tests.stalls import Stalls

from cotouch.drivers import FORCE_DIMENSION, HAPLY, TOUCH
from cotouch.errors import DeviceError
from cotouch.haptics import Device, Flag


def gone(device: Device, board: Board, fault: Fault, value: float, words: str, stalls: Stalls) -> None:
    try:
        why, zero = fails(device, board, fault, value)
        assert words in why
        assert is_sentence(why)
        stalls.within(board.get("struck"), zero)
        # After a fault it may only be stopped and closed; neither brings the force back.
        device.stop()
        device.close()
        time.sleep(0.01)
        stalls.within(board.get("struck"), board.gone_after(board.get("struck")))
    finally:
        device.close()


@pytest.mark.parametrize(
    ("fault", "value", "words"),
    [
        (Fault.UNPLUGGED, 0.0, ""),
        (Fault.FROZEN, 0.0, "repeats one position"),
        (Fault.SLOW, 0.09, "did not answer within 60 ms"),
        (Fault.SILENT, 0.0, "did not answer within 60 ms"),
        (Fault.SAFETY, 0.0, "stall_detected"),
        (Fault.CLOSED, 0.0, "it closed the connection"),
        (Fault.MISSING, 0.0, "left out cursor_position"),
        (Fault.NOT_READY, 0.0, "is not ready"),
    ],
)
def test_inverse3(service: Service, fault: Fault, value: float, words: str, stalls: Stalls):
    gone(HAPLY.make(url=service.url, events=service.events), service.board, fault, value, words, stalls)


@pytest.mark.parametrize(
    ("fault", "value", "words"),
    [
        (Fault.UNPLUGGED, 0.0, "communication error"),
        (Fault.FROZEN, 0.0, "repeats one position"),
        (Fault.SLOW, 0.09, "ms for a cycle"),
        (Fault.TAKEN_AWAY, 2.0, "it was too fast"),
        (Fault.TAKEN_AWAY, 4.0, "a program"),
        (Fault.SAFETY, 0.0, "redundant encoders disagree"),
    ],
)
def test_force_dimension(board: Board, built: Path, fault: Fault, value: float, words: str, stalls: Stalls):
    gone(FORCE_DIMENSION.make(library=str(built)), board, fault, value, words, stalls)


@pytest.mark.parametrize(
    ("fault", "value", "words"),
    [
        (Fault.UNPLUGGED, 0.0, "Communication error"),
        (Fault.FROZEN, 0.0, "repeats one position"),
        (Fault.SLOW, 0.09, "no longer ticks"),
        (Fault.SILENT, 0.0, "no longer ticks"),
        (Fault.SAFETY, 0x201, "0x201"),
        (Fault.SAFETY, 0x202, "0x202"),
        (Fault.SAFETY, 0x203, "0x203"),
        (Fault.SAFETY, 0x302, "Communication error"),
    ],
)
def test_touch(board: Board, built: Path, fault: Fault, value: float, words: str, stalls: Stalls):
    gone(TOUCH.make(library=str(built)), board, fault, value, words, stalls)


KINDS = ["haply", "force_dimension", "touch"]


@pytest.fixture(params=KINDS)
def pair(request: pytest.FixtureRequest) -> Generator[tuple[Device, Board]]:
    """A device of each kind with its stand-in."""
    if request.param == "haply":
        service: Service = request.getfixturevalue("service")
        device, board = HAPLY.make(url=service.url, events=service.events), service.board
    else:
        built, board = request.getfixturevalue("built"), request.getfixturevalue("board")
        made = {"force_dimension": lambda: FORCE_DIMENSION.make(library=str(built))}
        device = made.get(request.param, lambda: TOUCH.make(library=str(built)))()
    yield device, board
    device.close()


def test_positions_that_are_no_numbers_are_handed_on(pair: tuple[Device, Board]):
    device, board = pair
    try:
        ready(device)
        board.inject(Fault.NOT_A_NUMBER)
        for _ in range(100):
            reading = device.exchange(np.zeros(3))
            if np.isnan(reading.position).any():
                break
        assert np.isnan(reading.position).sum() == 1
    finally:
        device.close()


def test_forces_that_are_no_numbers_take_the_force_away(pair: tuple[Device, Board], stalls: Stalls):
    device, board = pair
    try:
        ready(device, 20)
        began = time.monotonic()
        with pytest.raises(DeviceError, match="not finite"):
            device.exchange(np.array([0.0, np.nan, 0.0]))
        time.sleep(0.02)
        stalls.within(began, board.gone_after(began))
    finally:
        device.close()


def test_stop_from_another_thread_while_the_loop_goes_on_pushing(pair: tuple[Device, Board], stalls: Stalls):
    device, board = pair
    try:
        ready(device, 20)
        stopped: list[float] = []

        def stop() -> None:
            time.sleep(0.02)
            device.stop()
            stopped.append(time.monotonic())

        thread = threading.Thread(target=stop)
        thread.start()
        while thread.is_alive():
            push(device, 1)  # the loop knows nothing of it
        last = push(device, 50)
        assert not last.flags & Flag.FORCE_ON
        stalls.within(stopped[0], board.gone_after(stopped[0]))
        assert not np.any(
            board.get("motor" if device.spec.name == HAPLY.spec.name else "force")
        )  # nor is any asked for
        device.enable_force()
        wanted = pytest.approx(float(np.linalg.norm(PUSH)), rel=1e-5)
        for _ in range(500):  # the process that plays the motors may have to wait for its turn
            push(device, 1)
            if float(np.linalg.norm(board.get("motor"))) == wanted:
                break
        assert float(np.linalg.norm(board.get("motor"))) == wanted
    finally:
        device.close()


def test_closing_leaves_no_force(pair: tuple[Device, Board], stalls: Stalls):
    device, board = pair
    ready(device, 20)
    closed = time.monotonic()
    device.close()
    stalls.within(closed, board.gone_after(closed))
