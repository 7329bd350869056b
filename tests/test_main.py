"""`python -m cotouch` ends as Python would, though it is not taken down."""

import subprocess
import sys
from pathlib import Path

LATE = """
import atexit, runpy, sys, threading, time
def late():
    time.sleep(0.3)
    print("thread")
atexit.register(print, "atexit")
threading.Thread(target=late).start()
sys.argv = ["cotouch", "--version"]
runpy.run_module("cotouch", run_name="__main__")
"""


def ran(*arguments: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run([sys.executable, *arguments], capture_output=True, text=True, timeout=120, check=False)


def test_threads_and_exit_functions_come_to_their_end_and_all_is_written() -> None:
    done = ran("-c", LATE)
    assert done.returncode == 0
    assert [line.split()[0] for line in done.stdout.splitlines()] == ["cotouch", "thread", "atexit"]


def test_the_exit_code_is_that_of_the_command(tmp_path: Path) -> None:
    done = ran("-m", "cotouch", "host", str(tmp_path / "no.toml"))
    assert done.returncode == 2
    assert done.stderr.startswith("cotouch: the session ")
    assert done.stderr.count("\n") == 1
