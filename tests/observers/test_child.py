"""A function in a process of its own."""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from cotouch.errors import SessionError
from cotouch.observers import ChildCall

_PATIENCE = 60.0

PARENT = """
import os, sys, time
from cotouch.observers._child import ChildCall
child = ChildCall(time.sleep, 600)
print(child.pid, flush=True)
sys.stdin.readline()
os._exit(0)
"""


def becomes(true: Callable[[], bool]) -> bool:
    end = time.monotonic() + _PATIENCE
    while not true() and time.monotonic() < end:
        time.sleep(0.02)
    return true()


def alive(pid: int) -> bool:
    try:
        stat = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8")
    except OSError:
        return False
    return stat.rpartition(")")[2].split()[0] != "Z"


def test_it_returns_what_the_function_does() -> None:
    call = ChildCall(divmod, 7, 2)
    assert becomes(lambda: call.done)
    assert call.result() == (3, 1)


def test_one_that_fails_is_told_in_a_sentence() -> None:
    call = ChildCall(divmod, 7, 0)
    assert becomes(lambda: call.done)
    with pytest.raises(SessionError, match="ended without a result, with code 1"):
        call.result()


def test_it_is_ended_at_once() -> None:
    call = ChildCall(time.sleep, 600)
    assert not call.done
    call.kill()
    assert call.done


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_it_does_not_outlive_who_asked() -> None:
    parent = subprocess.Popen([sys.executable, "-c", PARENT], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    assert parent.stdout is not None
    pid = int(parent.stdout.readline())
    os.kill(pid, 0)
    parent.communicate(b"\n")
    assert becomes(lambda: not alive(pid))
