"""What takes the force away in ordinary use is no fault: a pause, a force button. It comes back, and by the ramp."""

import time
from collections.abc import Callable, Generator
from pathlib import Path

import pytest
from tests.drivers.driving import PUSH
from tests.drivers.inside import ForceDimension, Inverse3, Touch
from tests.drivers.standin import Board, Fault, Service
from tests.haptics.inside import OrderWriter

from cotouch.coupling import EnergyMessage
from cotouch.haptics import Cause, Device, DeviceChoice, Flag, Order, Servo, ServoReport, ServoSettings, norm

# Shorter than the 40 ms after which whoever watches takes a servo for dead, longer than any watchdog here [s].
PAUSE = 0.025
# A report is written down some time after its cycle looked at the clock [s].
RAMP_SLACK = 0.002


class Loop:
    """A servo around a device in this process, whose proxy is always beside it; every report is kept."""

    def __init__(self, device: Device, folder: Path) -> None:
        device.open()
        device.calibrate(allow_motion=False)
        settings = ServoSettings(device=DeviceChoice("stand-in"), folder=folder)
        self.servo = Servo(device, settings, watched=lambda: True)
        self.orders = OrderWriter(folder)
        self.rearm, self.given = 0, 1.0
        self.reports: list[tuple[float, ServoReport]] = []  # and when its cycle had ended

    def cycle(self) -> ServoReport:
        self.given += 1e-3  # energy that never ends, however long it takes until force is back
        message = EnergyMessage(given=self.given)
        order = Order(time=time.monotonic(), place=(0.03, 0.0, 0.0), message=message, enable=True)
        self.orders.write(order._replace(rearm=self.rearm))
        assert self.servo.cycle(), self.servo.fault
        report = self.servo._report
        assert report is not None
        if report.causes & Cause.FAST:  # nobody holds it as firmly as a person does
            self.rearm += 1
        self.reports.append((time.monotonic(), report))
        time.sleep(5e-4)
        return report

    def until(self, done: Callable[[ServoReport], object], what: str) -> list[tuple[float, ServoReport]]:
        """Goes on until then; what came on the way."""
        first, end = len(self.reports), time.monotonic() + 60.0
        while not done(self.cycle()):
            assert time.monotonic() < end, f"{what}: {self.reports[-1]}"
        return self.reports[first:]

    def close(self) -> None:
        self.servo.close()
        self.orders.close()


@pytest.fixture
def omega(board: Board, built: Path, tmp_path: Path) -> Generator[Loop]:
    loop = Loop(ForceDimension(library=str(built)), tmp_path)
    yield loop
    loop.close()


@pytest.fixture(params=["haply", "force_dimension", "touch"])
def any_device(request: pytest.FixtureRequest, tmp_path: Path) -> Generator[tuple[Loop, Board]]:
    if request.param == "haply":
        service: Service = request.getfixturevalue("service")
        device, board = Inverse3(url=service.url, events=service.events), service.board
    else:
        board, library = request.getfixturevalue("board"), str(request.getfixturevalue("built"))
        device = Touch(library=library) if request.param == "touch" else ForceDimension(library=library)
    loop = Loop(device, tmp_path)
    yield loop, board
    loop.close()


def strong(report: ServoReport) -> bool:
    """Back in full: no ramp any more."""
    return not report.causes & Cause.RAMP and norm(report.force) > 0.5


def rises(reports: list[tuple[float, ServoReport]]) -> None:
    """From nothing, by the ramp of half a second, however late cycles were."""
    start = next(k for k, (_, report) in enumerate(reports) if norm(report.force) == 0.0)
    begun = reports[start][0] - RAMP_SLACK
    for ended, report in reports[start:]:
        assert norm(report.force) <= (ended - begun) / 0.5 * norm(report.wanted) * (1 + 1e-9)
    assert norm(reports[-1][1].force) > 0.5


def test_a_pause_takes_the_force_and_gives_it_back(any_device: tuple[Loop, Board]):
    loop, board = any_device
    loop.until(strong, "force")
    time.sleep(PAUSE)
    back = loop.until(strong, "force again")
    assert back[0][1].causes & (Cause.LATE | Cause.DEVICE)
    rises(back)
    assert any(board.get("motor"))


def test_the_watchdog_took_it_and_the_motors_are_on_again(omega: Loop, board: Board):
    loop = omega
    loop.until(strong, "force")
    time.sleep(PAUSE)
    board.wait_for("enabled", lambda enabled: enabled == 0)
    assert board.get("cause") == 3
    back = loop.until(strong, "force again")
    assert back[0][1].causes & Cause.DEVICE
    assert not back[0][1].flags & Flag.FORCE_ON
    board.wait_for("motor", any)


def test_the_force_button_takes_the_force_and_gives_it_back(omega: Loop, board: Board):
    loop = omega
    loop.until(strong, "force")
    board.set("force_button", 1)
    board.wait_for("enabled", lambda enabled: enabled == 0)
    noticed = loop.until(lambda report: report.causes & Cause.DEVICE, "it is noticed")
    assert len(noticed) <= 20
    loop.rearm += 1  # what a hand took, nobody else gives back
    off = [loop.cycle() for _ in range(100)]
    assert all(report.causes & Cause.DEVICE and norm(report.force) == 0.0 for report in off)
    assert board.get("enabled") == 0
    time.sleep(2 * PAUSE)  # nor does a pause
    [loop.cycle() for _ in range(50)]
    assert board.get("enabled") == 0
    board.set("force_button", 2)
    board.wait_for("enabled", lambda enabled: enabled == 1)
    assert not any(board.get("force"))
    rises(loop.until(strong, "force again"))


def test_letting_go_of_a_handle_that_senses_a_hand_is_no_fault(omega: Loop, board: Board):
    loop = omega
    loop.until(strong, "force")
    board.inject(Fault.TAKEN_AWAY, 6.0)
    loop.until(lambda report: report.causes & Cause.DEVICE, "it is noticed")
    [loop.cycle() for _ in range(50)]
    assert board.get("enabled") == 0


def test_a_force_that_nobody_renewed_is_not_there_at_once_when_it_is_renewed(board: Board, built: Path):
    device = Touch(library=str(built))
    try:
        device.open()
        device.enable_force()
        for _ in range(5):
            device.exchange(PUSH)
        time.sleep(PAUSE)
        board.wait_for("motor", lambda force: not any(force))
        renewed = device.exchange(PUSH)
        assert not renewed.flags & Flag.FORCE_ON
        assert not renewed.force.any()
        time.sleep(0.005)
        assert not any(board.get("force"))  # until whoever gives it knows
        for _ in range(500):  # a machine that stands still may take it once more
            if device.exchange(PUSH).flags & Flag.FORCE_ON:
                return
        pytest.fail("it does not come back")
    finally:
        device.close()
