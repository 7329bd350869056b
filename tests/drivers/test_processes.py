"""Peer, servo and guardian around stand-ins; each is killed and stopped, and the stand-in's motors say when force went.

The Inverse Service keeps the last force for ever, the sigma has the watchdog of its firmware, and OpenHaptics nothing
at all but being opened anew. The last two render torques as well, which go together with the force.
"""

import contextlib
import multiprocessing
import os
import signal
import time
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager
from multiprocessing.connection import Connection
from pathlib import Path

import numpy as np
import pytest
from tests.drivers.driving import stalled
from tests.drivers.standin import Board, Fault, Service
from tests.haptics.inside import ReportReader
from tests.stalls import Stalls

from cotouch.coupling import EnergyMessage
from cotouch.errors import DeviceError
from cotouch.haptics import Cause, CouplingChoice, DeviceChoice, ProxyEnd, ServoLink

FORK = multiprocessing.get_context("fork")
# A quarter turn away from where a handle begins.
TURNED = (0.0, 0.0, 0.5**0.5, 0.5**0.5)
KINDS = ["haply", "force_dimension", "touch"]
Setting = tuple[DeviceChoice, Board]


@pytest.fixture(params=KINDS)
def setting(request: pytest.FixtureRequest) -> Setting:
    """A device to choose, and the board of its stand-in."""
    if request.param == "haply":
        service: Service = request.getfixturevalue("service")
        return DeviceChoice("haply", {"url": service.url, "events": service.events}), service.board
    board, built = request.getfixturevalue("board"), request.getfixturevalue("built")
    # Those that render torques have some in these tests, too.
    return DeviceChoice(request.param, {"library": str(built)}), board


@pytest.fixture
def board(running: Callable[..., AbstractContextManager[Board]]) -> Generator[Board]:
    """A running sigma.7, or a PHANToM Premium 6DOF for the other library."""
    with running(system=104, wrist=True) as board:
        yield board
        assert board.get("violations") == 0, board.said


def pushes(board: Board) -> bool:
    twists = not board.get("wrist") or np.linalg.norm(board.get("twist")) > 5e-3
    return bool(np.linalg.norm(board.get("motor")) > 0.2 and twists)


def couple(link: ServoLink) -> None:
    """Lets torques act as well, where the device renders some."""
    if link.spec.torque:
        link.couple(CouplingChoice())
        link.couple_turning(CouplingChoice())


class Held:
    """A link whose proxy stays beside the device, so that there is force; this process is the peer."""

    def __init__(self, choice: DeviceChoice, board: Board) -> None:
        self.link = ServoLink(choice, real_time=None)
        self.board = board
        couple(self.link)
        self.end = ProxyEnd(self.link.options)
        self.given = 1.0
        self.said: list[str] = []

    def until(self, done: Callable[[], object], what: str) -> None:
        end = time.monotonic() + 60.0
        while not done():
            assert time.monotonic() < end, f"{what}: {self.said}"
            report = self.link.read()
            if report is not None:
                if report.causes & (Cause.FAST | Cause.ACTIVE):
                    self.link.rearm()
                self.end.pull((0.03, 0.0, 0.0), None, (0.0, 0.0, 0.0), report.message, 0.002)
            self.given += 1e-3
            self.link.order(
                (0.03, 0.0, 0.0), self.end.message, orientation=TURNED, twist=EnergyMessage(given=self.given)
            )
            self.said += self.link.warning_log()
            time.sleep(0.002)

    def gone(self, number: int, stalls: Stalls, *, at: int) -> None:
        """Sends a signal to one of the processes, and asserts that force is gone soon."""
        began = time.monotonic()
        os.kill(at, number)
        self.until(lambda: self.board.zero_after(began) < np.inf, "no force")
        stalls.within(began, self.board.zero_after(began))


@pytest.fixture
def held(setting: Setting) -> Generator[Held]:
    for _ in range(4):  # a machine full of tests may stall for longer than a device waits
        try:
            made = Held(*setting)
        except DeviceError as error:
            if not stalled(error):
                raise
            continue
        try:
            made.until(
                lambda held=made: pushes(held.board) or held.link.causes & Cause.FAULT or held.link.gone, "force"
            )
            if pushes(made.board):
                yield made
                return
        finally:
            made.link.close()
    raise AssertionError("this machine stalls all the time")


def test_a_servo_that_is_killed_leaves_no_force(held: Held, stalls: Stalls):
    held.gone(signal.SIGKILL, stalls, at=held.link.servo)
    held.until(lambda: any("the device's servo is gone" in text for text in held.said), "told")


def test_a_servo_that_is_stopped_leaves_no_force(held: Held, stalls: Stalls):
    """Halted from outside, or, where that cannot be, ended and its device opened anew, if it has no watchdog."""
    servo = held.link.servo
    held.gone(signal.SIGSTOP, stalls, at=servo)
    held.until(lambda: not _runs(servo), "it is ended")
    held.until(lambda: any("the device's servo is gone" in text for text in held.said), "told")


def test_a_guardian_that_is_stopped_or_killed_leaves_no_force(held: Held, stalls: Stalls):
    guardian = held.link.guardian
    held.gone(signal.SIGSTOP, stalls, at=guardian)
    held.until(lambda: any("watches over the device has stopped" in text for text in held.said), "told")
    os.kill(guardian, signal.SIGCONT)
    held.until(lambda: pushes(held.board), "force again")
    held.gone(signal.SIGKILL, stalls, at=guardian)
    held.until(lambda: any("watches over the device is gone" in text for text in held.said), "told")
    held.until(lambda: not _runs(held.link.servo), "the servo ends")


def peer(choice: DeviceChoice, tell: Connection) -> None:
    """Of a process of its own; it says who is around the device, then pulls, with energy that never ends."""
    link = ServoLink(choice, real_time=None)
    couple(link)
    tell.send((link.servo, link.guardian, link._folder.path))
    given = 1.0
    while True:
        link.read()
        given += 1e-3
        message = EnergyMessage(given=given)
        link.order((0.03, 0.0, 0.0), message, orientation=TURNED, twist=message)
        if link.causes & (Cause.FAST | Cause.ACTIVE):  # nobody holds it as firmly as a person does
            link.rearm()
        time.sleep(0.002)


class Around:
    """A peer in a process of its own, and what is around its device."""

    def __init__(self, choice: DeviceChoice, board: Board) -> None:
        self.board = board
        told, tell = FORK.Pipe(duplex=False)
        with told:
            with tell:
                self.peer = FORK.Process(target=peer, args=(choice, tell))  # what it needs is loaded already
                self.peer.start()
            assert self.peer.pid is not None
            self.pid: int = self.peer.pid
            try:
                self.servo, self.guardian, folder = told.recv()
                self.folder: Path = folder
                self.reports = ReportReader(folder)
                self.reports.read()
                self.until(lambda: pushes(board), "force")
            except BaseException:  # its servo and guardian end when it does
                self.peer.kill()
                raise

    def until(self, done: Callable[[], object], what: str) -> None:
        end = time.monotonic() + 60.0
        while not done():
            assert time.monotonic() < end, (what, self.reports.read())
            time.sleep(0.002)

    def gone(self, number: int, stalls: Stalls, *, at: list[int]) -> None:
        """Sends a signal to some of the processes at once, and asserts that force is gone soon."""
        began = time.monotonic()
        for pid in at:
            os.kill(pid, number)
        self.until(lambda: self.board.zero_after(began) < np.inf, "no force")
        stalls.within(began, self.board.zero_after(began))

    def close(self) -> None:
        self.peer.kill()
        self.peer.join()
        self.reports.close()
        with contextlib.suppress(OSError):
            os.kill(self.guardian, signal.SIGCONT)  # in case a test failed
        self.until(lambda: not _runs(self.servo) and not _runs(self.guardian), "no process")


@pytest.fixture
def around(setting: Setting) -> Generator[Around]:
    made = Around(*setting)
    yield made
    made.close()


def test_a_peer_that_is_killed_leaves_no_force_and_no_process(around: Around, stalls: Stalls):
    around.gone(signal.SIGKILL, stalls, at=[around.pid])
    around.until(lambda: not _runs(around.servo) and not _runs(around.guardian), "no process")
    assert not around.folder.exists()


@pytest.mark.parametrize("setting", ["haply"], indirect=True)
def test_a_servo_sees_by_itself_that_its_peer_is_dead(around: Around, stalls: Stalls):
    """Its guardian, which would see it as well, stands still; the pipe says it, before silence does."""
    os.kill(around.guardian, signal.SIGSTOP)
    around.gone(signal.SIGKILL, stalls, at=[around.pid])
    around.until(lambda: (report := around.reports.read()) is not None and report.causes & Cause.PEER, "the reason")
    os.kill(around.guardian, signal.SIGCONT)
    around.until(lambda: not _runs(around.servo) and not _runs(around.guardian), "no process")


def test_peer_and_servo_that_are_killed_at_once_leave_no_force(around: Around, stalls: Stalls):
    around.gone(signal.SIGKILL, stalls, at=[around.pid, around.servo])


def test_a_peer_that_is_stopped_leaves_no_force_and_with_its_servo_neither(around: Around, stalls: Stalls):
    """First the peer alone, which comes back; then both at once; then the peer dies while its servo hangs."""
    around.gone(signal.SIGSTOP, stalls, at=[around.pid])
    os.kill(around.pid, signal.SIGCONT)
    around.until(lambda: pushes(around.board), "force again")
    around.gone(signal.SIGSTOP, stalls, at=[around.pid, around.servo])
    around.peer.kill()
    around.until(lambda: not _runs(around.servo) and not _runs(around.guardian), "no process")


@pytest.mark.parametrize("setting", ["haply"], indirect=True)
def test_a_peer_that_dies_with_its_servo_stopped_leaves_no_force(around: Around, stalls: Stalls):
    """The servo would see it, but stands still: the guardian does not wait until it has ended by itself."""
    os.kill(around.servo, signal.SIGSTOP)
    around.gone(signal.SIGKILL, stalls, at=[around.pid])


@pytest.mark.parametrize("setting", ["haply"], indirect=True)
def test_positions_that_are_no_numbers_leave_no_force(held: Held, stalls: Stalls):
    held.board.inject(Fault.NOT_A_NUMBER)
    held.until(lambda: held.link.causes & Cause.FAULT, "fault")
    held.until(lambda: any("returned no valid numbers" in text for text in held.said), "told")
    struck = held.board.get("struck")
    stalls.within(struck, held.board.gone_after(struck))


@pytest.mark.parametrize("setting", ["touch"], indirect=True)
def test_the_reason_of_a_driver_reaches_the_peer(held: Held, stalls: Stalls):
    held.board.inject(Fault.UNPLUGGED)
    held.until(lambda: any("the device failed: the" in text for text in held.said), "told")
    struck = held.board.get("struck")
    stalls.within(struck, held.board.gone_after(struck))


def _runs(pid: int) -> bool:
    """Whether a process is there, and not only its entry for its parent."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False
