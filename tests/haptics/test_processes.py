"""Peer, guardian and servo as processes around a device that holds its last force for ever; each dies in turn."""

import ctypes
import math
import multiprocessing
import os
import re
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Generator
from multiprocessing.connection import Connection
from pathlib import Path

import pytest
from tests.conftest import IMPORTS, ROOT
from tests.haptics.inside import USUAL
from tests.haptics.plant import GOOD, THROW, Plant
from tests.stalls import Stalls

from cotouch.coupling import device_couplings
from cotouch.errors import DeviceError
from cotouch.haptics import Cause, DeviceChoice, ProxyEnd, ServoLink

PEER = """
import sys, time
sys.path.insert(0, sys.argv[1])
from cotouch.haptics import DeviceChoice, ServoLink
from cotouch.coupling import EnergyMessage
link = ServoLink(DeviceChoice("tests.haptics.plant/PLANT", {"folder": sys.argv[2]}), real_time=None)
print(link.servo, link.guardian, link._folder.path, flush=True)
given = 1.0
while True:
    link.read()
    given += 1e-3
    link.order((0.05, 0.0, 0.0), EnergyMessage(given=given))
    time.sleep(0.002)
"""


FORK = multiprocessing.get_context("fork")


def unprivileged(plant: Path, tell: Connection) -> None:
    """Says what a peer is told that gives up the right to priorities."""
    ctypes.CDLL(None).prctl(24, 23, 0, 0, 0)  # nobody started from here may set them
    resource.setrlimit(resource.RLIMIT_RTPRIO, (0, 0))
    link = ServoLink(DeviceChoice("tests.haptics.plant/PLANT", {"folder": str(plant)}))
    said, end = list[str](), time.monotonic() + 60.0
    while "guardian" not in link.process and time.monotonic() < end:
        said += link.warning_log()
        time.sleep(0.005)
    said += link.warning_log()
    tell.send((said, link.process))
    link.close()


@pytest.fixture
def plant(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Generator[Plant]:
    monkeypatch.setenv("PYTHONPATH", IMPORTS)  # so that the servo's process finds the plant's driver
    made = Plant(tmp_path)
    yield made
    made.close()


class Held:
    """A link whose proxy is far, so that there is force."""

    def __init__(self, plant: Plant, driver: str, **said: str) -> None:
        choice = DeviceChoice(f"tests.haptics.plant/{driver}", {"folder": str(plant.folder), **said})
        self.link = ServoLink(choice, real_time=None)
        self.end = ProxyEnd(self.link.options)
        self.said: list[str] = []

    def until(self, done: Callable[[], object], what: str, *, orders: bool = True) -> None:
        end = time.monotonic() + 60.0
        while not done():
            assert time.monotonic() < end, f"{what}: {self.said}"
            report = self.link.read()
            if orders:
                self.end.pull((0.02, 0.0, 0.0), None, (0.0, 0.0, 0.0), report.message, 0.002) if report else None
                self.link.order((0.02, 0.0, 0.0), self.end.message)
            self.said += self.link.warning_log()
            time.sleep(0.002)


@pytest.fixture
def held(plant: Plant, request: pytest.FixtureRequest) -> Generator[Held]:
    made = Held(plant, getattr(request, "param", "PLANT"))
    try:
        made.until(lambda: plant.force > 0.0, "force")
        yield made
    finally:
        made.link.close()


@pytest.fixture(scope="module")
def lasting(tmp_path_factory: pytest.TempPathFactory) -> Generator[tuple[Plant, Held]]:
    """One for tests after which it is as before."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", IMPORTS)
        plant = Plant(tmp_path_factory.mktemp("plant"))
        held = Held(plant, "PLANT")
        try:
            held.until(lambda: plant.force > 0.0, "force")
            yield plant, held
        finally:
            held.link.close()
            plant.close()


@pytest.mark.parametrize("held", ["PLANT", "PLANT_ALONE"], indirect=True)
def test_a_servo_that_is_killed_leaves_no_force(plant: Plant, held: Held, stalls: Stalls):
    """Once halted from outside; once, where nobody else reaches the device while it is in use, opened anew."""
    began = time.monotonic()
    os.kill(held.link.servo, signal.SIGKILL)
    held.until(lambda: plant.force == 0.0, "no force")
    held.until(lambda: any("the device's servo is gone" in text for text in held.said), "told")
    assert held.link.gone
    assert held.link.read() is None
    stalls.within(began, plant.gone_after(began))


def test_a_servo_that_stands_still_leaves_no_force(plant: Plant, held: Held, stalls: Stalls):
    began = time.monotonic()
    os.kill(held.link.servo, signal.SIGSTOP)
    held.until(lambda: plant.force == 0.0, "no force")
    held.until(lambda: any("servo has stopped" in text for text in held.said), "told")
    held.until(lambda: any("is gone" in text for text in held.said), "ended")
    stalls.within(began, plant.gone_after(began))


def test_a_guardian_that_is_killed_leaves_no_force(plant: Plant, held: Held, stalls: Stalls):
    began = time.monotonic()
    os.kill(held.link.guardian, signal.SIGKILL)
    held.until(lambda: plant.force == 0.0, "no force")
    held.until(lambda: any("watches over the device is gone" in text for text in held.said), "told")
    held.until(lambda: not _runs(held.link.servo), "the servo ends")
    stalls.within(began, plant.gone_after(began))


def test_a_peer_that_is_killed_leaves_no_force_and_no_process(plant: Plant, stalls: Stalls):
    command = [sys.executable, "-c", PEER, ROOT, str(plant.folder)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as peer:
        try:
            assert peer.stdout is not None
            *numbers, folder = peer.stdout.readline().split()
            servo, guardian = map(int, numbers)
            _wait(lambda: plant.force > 0.0, "force")
            began = time.monotonic()
        finally:
            peer.kill()
        _wait(lambda: plant.force == 0.0, "no force")
        _wait(lambda: not _runs(servo) and not _runs(guardian), "no process")
        assert not Path(folder).exists()
    stalls.within(began, plant.gone_after(began))


def test_a_peer_that_says_nothing_leaves_no_force_and_may_come_back(lasting: tuple[Plant, Held], stalls: Stalls):
    plant, held = lasting
    felt = lambda: held.link.report is not None and not held.link.causes & ~USUAL  # noqa: E731
    held.until(felt, "the peer knows of the force: it is not told why there never was any")
    began = time.monotonic()
    held.until(lambda: held.link.causes & Cause.SILENT, "silent", orders=False)
    held.until(lambda: plant.force == 0.0, "no force", orders=False)
    stalls.within(began, plant.gone_after(began))
    held.until(lambda: plant.force > 0.0, "force again")
    assert any("peer has been silent" in text for text in held.said)
    plant.command(THROW)
    held.until(lambda: held.link.causes & Cause.FAST, "latched")
    held.until(lambda: any("faster than any hand" in text for text in held.said), "told")
    plant.command(GOOD)
    held.until(lambda: plant.force == 0.0, "no force")
    held.link.rearm()
    held.until(lambda: plant.force > 0.0, "force after it is re-armed")


def test_a_servo_from_the_future_is_gone(lasting: tuple[Plant, Held]):
    """A report dated ahead of the clock, or infinitely so, keeps no servo alive that says nothing more."""
    _, held = lasting
    link = held.link
    for ahead in (10.0, math.inf, math.nan):
        held.until(lambda: link.report is not None and not link.gone, "it is heard")
        assert link.report is not None
        link.report = link.report._replace(time=time.monotonic() + ahead)
        assert link.gone
    link.report = link.report._replace(time=time.monotonic())
    assert not link.gone


def test_a_refused_priority_is_said_once(plant: Plant):
    """By a peer that gives up the right to it, so that its servo and its guardian have none."""
    told, tell = FORK.Pipe(duplex=False)
    with told:
        with tell:
            peer = FORK.Process(target=unprivileged, args=(plant.folder, tell))
            peer.start()
        said, process = told.recv()
    peer.join(60.0)
    assert peer.exitcode == 0
    assert process["real_time"] is None
    assert process["guardian"]["real_time"] is None
    assert len([text for text in said if "real-time priority was refused" in text and "ulimit -r" in text]) == 1


def test_a_device_that_cannot_be_opened_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("PYTHONPATH", IMPORTS)
    with pytest.raises(DeviceError, match="no plant at"):
        ServoLink(DeviceChoice("tests.haptics.plant/PLANT", {"folder": str(tmp_path / "nowhere")}))
    with pytest.raises(DeviceError, match='device is "omega9"'):
        ServoLink(DeviceChoice("omega9"))


def test_a_limit_above_the_devices_own_is_a_sentence():
    with pytest.raises(DeviceError, match="safety limit force is 9"):
        ServoLink(DeviceChoice("simulated", {"variant": "phantom"}), limits={"force": 9.0})


@pytest.mark.parametrize(
    "text", ["simulated:cartesian", "simulated:touch,viscous=4,coupling=virtual,friction=4,coulomb=0.2"]
)
def test_the_simulated_device_is_felt_outlasts_a_servo_that_stood_still_and_is_closed(text: str):
    """A busy machine keeps a servo waiting now and then; nobody is moved by a simulated device meanwhile."""
    link = ServoLink(DeviceChoice.read(text), real_time=None)
    end, first = ProxyEnd(link.options), None
    assert link.options.law == ("virtual" if "virtual" in text else "pspm")
    try:
        felt = 0.0
        finish = time.monotonic() + 60.0
        while felt < 0.5 and time.monotonic() < finish:
            report = link.read()
            if report is not None:
                first = report.place if first is None else first
                end.pull(first, report.place, report.rate, report.message, 0.002)  # a proxy that does not move
                link.order(first, end.message)
                felt = max(abs(value) for value in report.force)
            time.sleep(0.002)
        assert felt >= 0.5
        for stand in (0.0, 0.3):
            os.kill(link.servo, signal.SIGSTOP)
            time.sleep(stand)
            os.kill(link.servo, signal.SIGCONT)
            began = link.report.tick if link.read() else 0
            _wait(lambda began=began: (report := link.read()) is not None and report.tick > began + 20, "it goes on")
        assert not any("is gone" in text for text in link.warning_log())
    finally:
        link.close()
    assert link.statistics["steps"] > 10
    assert not _runs(link.servo)
    assert not _runs(link.guardian)


def _runs(pid: int) -> bool:
    """Whether a process is there, and not only its entry for its parent."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def _wait(done: Callable[[], object], what: str) -> None:
    end = time.monotonic() + 60.0
    while not done():
        assert time.monotonic() < end, what
        time.sleep(0.002)


def test_a_servo_finds_the_coupling_of_another_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = (Path(ROOT) / "docs" / "extending.md").read_text(encoding="utf-8")
    code = re.search(r'```python title="my_coupling.py"\n(.*?)```', page, re.DOTALL)
    assert code is not None
    place, info = tmp_path / "site", tmp_path / "site" / "my_coupling-1.0.dist-info"
    info.mkdir(parents=True)
    (place / "my_coupling.py").write_text(code[1], encoding="utf-8")
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: my-coupling\nVersion: 1.0\n", encoding="utf-8")
    (info / "entry_points.txt").write_text("[cotouch.couplings]\nslipping = my_coupling:SLIPPING\n", encoding="utf-8")
    monkeypatch.syspath_prepend(place)
    monkeypatch.setattr("cotouch.coupling._law._KNOWN", device_couplings())
    monkeypatch.delitem(sys.modules, "my_coupling", raising=False)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join((IMPORTS, str(place))))
    plant = Plant(tmp_path)
    held = Held(plant, "PLANT", coupling="slipping")
    try:
        assert held.link.options.law == "slipping"
        held.until(lambda: plant.force > 0.0, "force")
    finally:
        sys.modules.pop("my_coupling", None)
        held.link.close()
        plant.close()
