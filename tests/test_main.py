"""`python -m cotouch` and `cotouch` end as Python would, though it is not taken down."""

import subprocess
import sys
from pathlib import Path

import pytest

LATE = """
import atexit, runpy, sys, threading, time
def late():
    time.sleep(2)  # longer than the command
    print("thread")
atexit.register(print, "atexit")
threading.Thread(target=late).start()
sys.argv = ["cotouch", "--version"]
"""
MODULE = 'runpy.run_module("cotouch", run_name="__main__")'
THRESHOLD = """
import atexit, gc, runpy, sys
atexit.register(lambda: print(gc.get_threshold()[0]))
sys.argv = ["cotouch", "--version"]
"""
INSTALLED = """
from importlib.metadata import entry_points
(command,) = entry_points(group="console_scripts", name="cotouch")
command.load()()
print("taken down")
"""


def ran(*arguments: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run([sys.executable, *arguments], capture_output=True, text=True, timeout=120, check=False)


@pytest.mark.parametrize("started", [MODULE, INSTALLED])
def test_threads_and_exit_functions_come_to_their_end_and_all_is_written(started: str) -> None:
    done = ran("-c", LATE + started)
    assert done.returncode == 0
    words = [line.split()[0] for line in done.stdout.splitlines()]
    assert (sorted(words[:2]), words[2:]) == (["cotouch", "thread"], ["atexit"])


def test_the_exit_code_is_that_of_the_command(tmp_path: Path) -> None:
    done = ran("-m", "cotouch", "host", str(tmp_path / "no.toml"))
    assert done.returncode == 2
    assert done.stderr.startswith("cotouch: the session ")
    assert done.stderr.count("\n") == 1


def test_garbage_is_looked_for_seldom() -> None:
    """Python's own 700 objects took a tenth of the start of a simulation."""
    assert int(ran("-c", THRESHOLD + MODULE).stdout.split()[-1]) > 10_000


def test_nothing_is_loaded_before_ctrl_c_is_heeded() -> None:
    """What is interrupted while it loads ends in a traceback, unless `run` has begun."""
    seen = "import sys; before = set(sys.modules); import cotouch.__main__; print(*sorted(set(sys.modules) - before))"
    assert ran("-c", seen).stdout.split() == ["cotouch", "cotouch.__main__"]
