"""A child ends with whoever started it, however that ended; mailboxes whose process is gone are removed."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from cotouch import processes
from cotouch.processes import MemoryFolder, remove_abandoned, start_child

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="mailboxes are in memory on Linux only")

PARENT = """
import sys, time
from cotouch.processes import start_child
start_child([sys.executable, "-c", sys.argv[1], *sys.argv[2:]])
time.sleep(600)
"""
# Leaves in order: it has time to write a word. It sleeps for moments only: a signal that arrives between Python's last
# look for one and a sleep is seen after the sleep.
ORDERLY = """
import signal, sys, time
from pathlib import Path
from cotouch.processes import tie_to_parent
signal.signal(signal.SIGTERM, lambda *_: (Path(sys.argv[1], "left").touch(), sys.exit()))
tie_to_parent()
Path(sys.argv[1], "there").touch()
while True:
    time.sleep(0.01)
"""
# Only asks and stays; by its clock, patience is over once it has been asked: a busy machine may take its time.
STUBBORN = """
import itertools, os, signal, sys, time
from pathlib import Path
from cotouch import processes
asked, looks = Path(sys.argv[1], "asked"), itertools.count()
class Clock:
    sleep = time.sleep
    monotonic = staticmethod(lambda: 1e3 * next(looks) if asked.exists() else 0.0)
processes.time = Clock
signal.signal(signal.SIGTERM, lambda *_: asked.touch())
processes.tie_to_parent()
Path(sys.argv[1], "pid").write_text(str(os.getpid()))
Path(sys.argv[1], "there").touch()
while True:
    time.sleep(0.01)
"""

KILLED = """
import os, signal, sys
from pathlib import Path
from cotouch import processes
processes._MEMORY = Path(sys.argv[1])
folder = processes.MemoryFolder()
(folder.path / "mailbox").write_text("x")
print(folder.path, flush=True)
os.kill(os.getpid(), signal.SIGKILL)
"""


def until(done: Callable[[], object]) -> None:
    end = time.monotonic() + 60.0
    while not done():
        assert time.monotonic() < end
        time.sleep(0.01)


def alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def killed_parent(folder: Path, child: str) -> None:
    with subprocess.Popen([sys.executable, "-c", PARENT, child, str(folder)]) as parent:
        until((folder / "there").exists)
        parent.kill()


def test_a_child_leaves_in_order_when_its_parent_was_killed(tmp_path: Path):
    killed_parent(tmp_path, ORDERLY)
    until((tmp_path / "left").exists)


def test_one_that_does_not_is_ended(tmp_path: Path):
    killed_parent(tmp_path, STUBBORN)
    until(lambda: not alive(int((tmp_path / "pid").read_text())))
    assert (tmp_path / "asked").exists()


def test_a_program_that_cannot_be_started_leaves_no_pipe():
    before = set(Path("/proc/self/fd").iterdir())
    with pytest.raises(FileNotFoundError):
        start_child(["/nowhere"])
    assert set(Path("/proc/self/fd").iterdir()) == before


@pytest.fixture
def memory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(processes, "_MEMORY", tmp_path)
    return tmp_path


def of_killed(memory: Path) -> Path:
    """A folder with a mailbox whose process was killed."""
    done = subprocess.run([sys.executable, "-c", KILLED, str(memory)], capture_output=True, text=True, check=False)
    assert done.returncode == -signal.SIGKILL, done.stderr
    path = Path(done.stdout.strip())
    assert path.parent == memory
    assert (path / "mailbox").exists()
    return path


def test_the_next_folder_takes_those_away_whose_process_was_killed(memory: Path):
    with MemoryFolder() as mine:
        left = of_killed(memory)
        with MemoryFolder() as other:
            assert not left.exists()
            assert remove_abandoned() == 2
            assert mine.path.is_dir()
            assert other.path.is_dir()
        assert not other.path.exists()
    assert list(memory.iterdir()) == []


def test_what_is_not_ours_stays(memory: Path, monkeypatch: pytest.MonkeyPatch):
    """A folder that is being made, one that has another name, and another user's, which may be a link to anywhere."""
    left = of_killed(memory)
    (memory / "cotouch-made-just-now").mkdir()
    (memory / "another").mkdir()
    (memory / "another" / "owner").touch()
    (memory / "cotouch-link").symlink_to(memory / "another")
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    remove_abandoned()
    assert left.exists()
    monkeypatch.undo()
    monkeypatch.setattr(processes, "_MEMORY", memory)
    assert remove_abandoned() == 0
    assert not left.exists()
    assert (memory / "cotouch-made-just-now").is_dir()
    assert (memory / "another" / "owner").exists()


def test_a_folder_may_be_closed_twice(memory: Path):
    folder = MemoryFolder()
    assert folder.path.stat().st_mode & 0o777 == 0o700
    folder.close()
    folder.close()
    assert list(memory.iterdir()) == []
