"""A run of tests that is interrupted leaves no process and no mailbox behind."""

import contextlib
import os
import secrets
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import IMPORTS, ROOT
from tests.keeper import __file__ as KEEPER
from tests.keeper import marked
from tests.simulation.browser import NAMES

pytestmark = pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="processes are found in /proc")

# A test as any other, which starts processes and hangs. Some have sessions of their own, some have lost their parent.
LIGHT = """
import os, subprocess, sys, time
from pathlib import Path
from cotouch.processes import MemoryFolder

def test_one():
    sleep = [sys.executable, "-S", "-c", "import signal, time; signal.signal(15, signal.SIG_IGN); time.sleep(600)"]
    fork = "import subprocess, sys; subprocess.Popen(sys.argv[1:], start_new_session=True)"
    subprocess.run([sys.executable, "-S", "-c", fork, *sleep])
    subprocess.Popen(sleep, start_new_session=True)
    folder = MemoryFolder()
    Path({seen!r}, "ready").write_text(f"{{os.getpid()}} {{folder.path}}")
    time.sleep(600)
"""
# The same with what our tests start: a device with servo and guardian, a host, a browser.
REAL = """
import os, subprocess, sys, time
from pathlib import Path
from cotouch.haptics import DeviceChoice, ServoLink

def test_one():
    link = ServoLink(DeviceChoice("simulated"), real_time=None)
    host = subprocess.Popen(
        [sys.executable, "-m", "cotouch", "host", {session!r}, "--listen", "127.0.0.1"],
        stdout=subprocess.PIPE, start_new_session=True,
    )
    assert host.stdout.readline()
    if {browser!r}:
        subprocess.Popen([{browser!r}, "--headless", "--no-sandbox", "--user-data-dir=" + {seen!r}, "about:blank"])
    Path({seen!r}, "ready").write_text(f"{{os.getpid()}} {{link._folder.path}}")
    time.sleep(600)
"""
ALONE, TWO = ["-p", "no:xdist"], ["-n", "1"]


class Interrupted:
    """A run of its own, with a mark of its own."""

    def __init__(self, folder: Path, program: str, options: list[str], before: tuple[str, ...] = ()) -> None:
        self.folder, self.mark = folder, secrets.token_hex(8)
        found = next(filter(None, map(shutil.which, NAMES)), "")
        session = str(Path(ROOT, "examples", "live.toml"))
        text = program.format(seen=str(folder), session=session, browser=found)
        (folder / "test_small.py").write_text(text)
        (folder / "pytest.ini").write_text("[pytest]\n")
        command = [*before, sys.executable, "-m", "pytest", "-q", "-p", "tests.leftovers", *options, str(folder)]
        env = {**os.environ, "PYTHONPATH": IMPORTS, "COTOUCH_INTERRUPTED": self.mark}
        with (folder / "said").open("wb") as said:
            self.process = subprocess.Popen(
                command,
                cwd=folder,
                stdin=subprocess.DEVNULL,
                stdout=said,
                stderr=subprocess.STDOUT,
                env=env,
                start_new_session=True,
            )

    def ready(self) -> tuple[int, Path]:
        """Once all of it runs: the process that runs the test, and its folder in memory."""
        ready = self.folder / "ready"
        until(lambda: (ready.exists() and ready.stat().st_size) or self.process.poll() is not None, str)
        assert ready.exists(), (self.folder / "said").read_text()
        pid, folder = ready.read_text().split()
        assert Path(folder).is_dir()
        return int(pid), Path(folder)


def until(done: Callable[[], object], said: Callable[[], object]) -> None:
    end = time.monotonic() + 120.0
    while not done():
        assert time.monotonic() < end, said()
        time.sleep(0.02)


def commands(mark: str) -> list[str]:
    return [Path(f"/proc/{pid}/cmdline").read_text() for pid in marked(mark)]


def control_c(run: Interrupted, worker: int) -> None:
    os.killpg(run.process.pid, signal.SIGINT)


def of_pytest(number: signal.Signals) -> Callable[[Interrupted, int], None]:
    return lambda run, worker: os.kill(run.process.pid, number)


def of_worker(run: Interrupted, worker: int) -> None:
    os.kill(worker, signal.SIGKILL)


def by_timeout(run: Interrupted, worker: int) -> None:
    """`timeout` ends it by itself; it is only told that its time is over."""
    os.kill(run.process.pid, signal.SIGALRM)


WAYS = {
    "Ctrl-C": (LIGHT, TWO, (), control_c),
    "SIGTERM": (LIGHT, TWO, (), of_pytest(signal.SIGTERM)),
    "SIGKILL": (REAL, TWO, (), of_pytest(signal.SIGKILL)),
    "SIGKILL without workers": (LIGHT, ALONE, (), of_pytest(signal.SIGKILL)),
    "SIGKILL of a worker": (LIGHT, TWO, (), of_worker),
    "timeout": (LIGHT, ALONE, ("timeout", "600"), by_timeout),
}


@pytest.mark.parametrize("way", WAYS)
def test_nothing_is_left(way: str, tmp_path: Path):
    program, options, before, interrupt = WAYS[way]
    run = Interrupted(tmp_path, program, options, before)
    try:
        worker, folder = run.ready()
        assert len(marked(run.mark)) > 3
        interrupt(run, worker)
        run.process.wait(60)
        until(lambda: not marked(run.mark), lambda: commands(run.mark))
        until(lambda: not folder.exists(), lambda: folder)
    finally:
        for pid in marked(run.mark):
            os.kill(pid, signal.SIGKILL)
        run.process.wait()


# Has a mailbox until it is killed.
BOARD = """
import time
from cotouch.processes import MemoryFolder
folder = MemoryFolder()
print(folder.path, flush=True)
time.sleep(600)
"""


def test_a_board_whose_process_dies_slowly():
    """Its environment is gone before its lock is: whoever looks only once leaves the mailbox."""
    env = {**os.environ, "PYTHONPATH": IMPORTS}
    with subprocess.Popen([sys.executable, "-c", BOARD], stdout=subprocess.PIPE, env=env) as owner:
        folder = Path(owner.stdout.readline().decode().strip())
        keeper = subprocess.Popen(
            [sys.executable, "-S", str(KEEPER), secrets.token_hex(8)], stdin=subprocess.DEVNULL, start_new_session=True
        )
        with contextlib.suppress(subprocess.TimeoutExpired):
            keeper.wait(1.0)
        assert folder.is_dir()
        owner.kill()
        keeper.wait(60)
    assert not folder.exists()
