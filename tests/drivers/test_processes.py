"""Peer, servo and guardian around stand-ins; each is killed in turn, and the stand-in's motors say when force was gone.

The Inverse Service keeps the last force for ever, the omega has the watchdog of its firmware, and the Touch's library
nothing at all but being opened anew.
"""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Generator
from pathlib import Path

import numpy as np
import pytest
from tests.conftest import ROOT
from tests.drivers.standin import Board, Fault, Service
from tests.stalls import Stalls

from cotouch.haptics import Cause, DeviceChoice, ProxyEnd, ServoLink

# A peer of its own; it says who is around the device, then pulls.
PEER = """
import json, sys, time
from cotouch.haptics import DeviceChoice, ServoLink, Word
link = ServoLink(DeviceChoice(sys.argv[1], json.loads(sys.argv[2])), real_time=None)
print(link.servo, link.guardian, flush=True)
while True:
    link.read()
    link.order((0.03, 0.0, 0.0), Word(given=1.0))
    time.sleep(0.002)
"""
KINDS = ["haply", "force_dimension", "touch"]
Setting = tuple[DeviceChoice, Board]


@pytest.fixture(params=KINDS)
def setting(request: pytest.FixtureRequest) -> Setting:
    """A device to choose, and the board of its stand-in."""
    if request.param == "haply":
        service: Service = request.getfixturevalue("service")
        return DeviceChoice("haply", {"url": service.url, "events": service.events}), service.board
    board, built = request.getfixturevalue("board"), request.getfixturevalue("built")
    options = {"library": str(built), **({"watchdog": 0.03} if request.param == "force_dimension" else {})}
    return DeviceChoice(request.param, options), board


class Held:
    """A link whose proxy stays beside the device, so that there is force."""

    def __init__(self, choice: DeviceChoice, board: Board) -> None:
        self.link = ServoLink(choice, real_time=None)
        self.board = board
        self.end = ProxyEnd(self.link.options)
        self.said: list[str] = []

    def until(self, done: Callable[[], object], what: str) -> None:
        end = time.monotonic() + 30.0
        while not done():
            assert time.monotonic() < end, f"{what}: {self.said}"
            report = self.link.read()
            if report is not None:
                if report.causes & Cause.FAST:
                    self.link.rearm()
                self.end.pull((0.03, 0.0, 0.0), None, (0.0, 0.0, 0.0), report.word, 0.002)
            self.link.order((0.03, 0.0, 0.0), self.end.purse.word)
            self.said += self.link.notices()
            time.sleep(0.002)

    def pushes(self) -> bool:
        return bool(np.linalg.norm(self.board.get("motor")) > 0.2)


@pytest.fixture
def held(setting: Setting) -> Generator[Held]:
    for _ in range(4):  # a machine full of tests may stall for longer than a device waits
        made = Held(*setting)
        try:
            made.until(lambda held=made: held.pushes() or held.link.causes & Cause.FAULT or held.link.gone, "force")
            if made.pushes():
                yield made
                return
        finally:
            made.link.close()
    raise AssertionError(f"this machine stalls all the time: {made.said}")


def test_a_servo_that_is_killed_leaves_no_force(held: Held, stalls: Stalls):
    began = time.monotonic()
    os.kill(held.link.servo, signal.SIGKILL)
    held.until(lambda: any("the device's servo is gone" in text for text in held.said), "told")
    stalls.within(began, held.board.zero_after(began))


def test_a_guardian_that_is_killed_leaves_no_force(held: Held, stalls: Stalls):
    began = time.monotonic()
    os.kill(held.link.guardian, signal.SIGKILL)
    held.until(lambda: any("watches over the device is gone" in text for text in held.said), "told")
    held.until(lambda: held.board.zero_after(began) < float("inf"), "no force")
    stalls.within(began, held.board.zero_after(began))


def test_a_peer_that_is_killed_leaves_no_force(setting: Setting, stalls: Stalls):
    choice, board = setting
    command = [sys.executable, "-c", PEER, choice.name, json.dumps(dict(choice.options))]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=ROOT) as peer:
        try:
            assert peer.stdout is not None
            servo, guardian = map(int, peer.stdout.readline().split())
            board.wait_for("motor", any, 20.0)
            began = time.monotonic()
        finally:
            peer.kill()
    end = time.monotonic() + 20.0
    while any(_runs(pid) for pid in (servo, guardian)):
        assert time.monotonic() < end
        time.sleep(0.005)
    stalls.within(began, board.zero_after(began))


@pytest.mark.parametrize("setting", ["haply"], indirect=True)
def test_positions_that_are_no_numbers_leave_no_force(held: Held, stalls: Stalls):
    held.board.inject(Fault.NOT_A_NUMBER)
    held.until(lambda: held.link.causes & Cause.FAULT, "fault")
    held.until(lambda: any("gave no numbers" in text for text in held.said), "told")
    struck = held.board.get("struck")
    stalls.within(struck, held.board.zero_after(struck))


@pytest.mark.parametrize("setting", ["touch"], indirect=True)
def test_the_reason_of_a_driver_reaches_the_peer(held: Held, stalls: Stalls):
    held.board.inject(Fault.UNPLUGGED)
    held.until(lambda: any("the device failed: the" in text for text in held.said), "told")
    struck = held.board.get("struck")
    stalls.within(struck, held.board.zero_after(struck))


def _runs(pid: int) -> bool:
    """Whether a process is there, and not only its entry for its parent."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False
