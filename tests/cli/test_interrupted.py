"""Ctrl-C at commands that work for long: one line, exit code 130, nothing left behind; whatever they are doing."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
from tests.body.shapes import sphere

from cotouch.processes import start_child

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")

# Long beside the second that it may take; who goes on until it is done does not say that it was interrupted [s].
_PATIENCE = 60.0
_STARTS = 120.0
_TICK = os.sysconf("SC_CLK_TCK")

LONG = """
[network]
users = ["a", "b"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.01], [0.01, 0]]
[body]
kind = "lattice"
shape = [12, 12, 12]
[steps]
duration = 2000
[record]
every = 1000
"""


def worked(pid: int) -> float:
    """Time that a process has used [s]."""
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return sum(map(int, fields[11:13])) / _TICK


class Command:
    """A command in a process of its own, as a terminal starts it."""

    def __init__(self, folder: Path, *arguments: str, **environment: str) -> None:
        self.err = folder / "err"
        with self.err.open("w") as err:
            self.process = subprocess.Popen(
                [sys.executable, "-m", "cotouch", *arguments],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=err,
                cwd=folder,
                env={**os.environ, **environment},
                start_new_session=True,
            )

    def worked(self) -> float:
        """Time that the process has used [s]."""
        return worked(self.process.pid)

    def until(self, ready: Callable[[], bool]) -> None:
        end = time.monotonic() + _STARTS
        while not ready():
            assert self.process.poll() is None, self.err.read_text(encoding="utf-8")
            assert time.monotonic() < end, "it never gets so far"
            time.sleep(0.02)

    def interrupted(self) -> tuple[int, str]:
        """Sends a Ctrl-C to all that a terminal would send it to; the exit code and what was said."""
        os.killpg(self.process.pid, signal.SIGINT)
        try:
            code = self.process.wait(_PATIENCE)
            assert not self.left()
        finally:
            for pid in self.left():
                os.kill(pid, signal.SIGKILL)
            self.process.wait()
        return code, self.err.read_text(encoding="utf-8")

    def left(self) -> list[int]:
        """Processes of this command that still run."""
        found: list[int] = []
        for stat in Path("/proc").glob("[0-9]*/stat"):
            try:
                state, _, _, session = stat.read_text(encoding="utf-8").rpartition(")")[2].split()[:4]
            except OSError:
                continue
            if int(session) == self.process.pid and state != "Z":
                found.append(int(stat.parent.name))
        return found


def network(users: int) -> str:
    rng = np.random.default_rng(1)
    delay = rng.uniform(0.02, 0.2, (users, users))
    np.fill_diagonal(delay, 0.0)
    spring = 50.0 * (1.0 - np.eye(users))
    names = [str(i) for i in range(users)]
    return f"users = {names}\nspring = {spring.tolist()}\ndelay = {delay.tolist()}\n".replace("'", '"')


@pytest.mark.parametrize(
    ("after", "arguments"),
    [
        (0.2, ["simulate", "long.toml"]),  # while Python still loads libraries
        (4.0, ["simulate", "long.toml", "--out", "run.nc"]),
        (4.0, ["plan", "many.toml", "--links", "100", "--objective", "decay", "--json"]),
        (2.5, ["certify", "many.toml", "--period", "1e-5"]),
        (4.0, ["body", "ball.stl", "--unit", "m", "--resolution", "40", "--model", "elastic"]),
        (4.0, ["reproduce", "--out", "report"]),
        (1.0, ["demo", "--no-page"]),
    ],
)
def test_a_command_at_work_ends(after: float, arguments: list[str], tmp_path: Path) -> None:
    (tmp_path / "long.toml").write_text(LONG, encoding="utf-8")
    (tmp_path / "many.toml").write_text("[network]\n" + network(40), encoding="utf-8")
    trimesh.Trimesh(*sphere(4), process=False).export(tmp_path / "ball.stl")
    (tmp_path / "run.nc").write_bytes(b"what was there before")
    command = Command(tmp_path, *arguments)
    command.until(lambda: command.worked() >= after)
    code, said = command.interrupted()
    assert code == 130, said
    assert said.splitlines()[-1] == "cotouch: interrupted"
    assert said.count("interrupted") == 1
    assert "Traceback" not in said
    assert (tmp_path / "run.nc").read_bytes() == b"what was there before"
    assert {path.name for path in tmp_path.iterdir()} - {"report"} == {
        "long.toml",
        "many.toml",
        "ball.stl",
        "run.nc",
        "err",
    }
    assert not list(tmp_path.glob("report/*"))


def test_members_that_load_end_with_their_demo(tmp_path: Path) -> None:
    command = Command(tmp_path, "demo", "--no-page", "--users", "2")
    command.until(lambda: len(command.left()) >= 3)
    time.sleep(0.2)  # while they load libraries
    code, said = command.interrupted()
    assert code == 130, said
    assert said.splitlines()[-1] == "cotouch: interrupted"
    assert said.count("interrupted") == 1
    assert "Traceback" not in said


@pytest.mark.parametrize("after", [0.3, 1.0])
def test_whoever_started_it_says_that_it_was_interrupted(after: float, tmp_path: Path) -> None:
    """Ctrl-C reaches a command and its children: one line, not one of each."""
    (tmp_path / "long.toml").write_text(LONG, encoding="utf-8")
    words = [sys.executable, "-m", "cotouch", "simulate", str(tmp_path / "long.toml")]
    child = start_child(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    end = time.monotonic() + _STARTS
    while worked(child.pid) < after:
        assert time.monotonic() < end, "it never gets so far"
        time.sleep(0.02)
    child.send_signal(signal.SIGINT)
    assert child.communicate(timeout=_PATIENCE)[1].count("interrupted") == 0
    assert child.returncode == 130


@pytest.mark.parametrize(
    "arguments",
    [["simulate", "long.toml"], ["demo", "--json"], ["plan", "many.toml", "--links", "100", "--rounding", "nearest"]],
)
def test_a_command_that_compiles_ends(arguments: list[str], tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    cache.mkdir()
    (tmp_path / "long.toml").write_text(LONG, encoding="utf-8")
    (tmp_path / "many.toml").write_text("[network]\n" + network(40), encoding="utf-8")
    command = Command(tmp_path, *arguments, NUMBA_CACHE_DIR=str(cache))
    command.until(lambda: any(cache.rglob("*.nbi")) or (arguments[0] == "demo" and command.worked() > 5.0))
    code, said = command.interrupted()
    assert code == 130, said
    assert said.splitlines()[-1] == "cotouch: interrupted"
    assert "Traceback" not in said
