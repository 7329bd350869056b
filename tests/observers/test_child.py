"""A function in a process of its own."""

import os
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from cotouch.errors import SessionError
from cotouch.observers import ChildCall

_PATIENCE = 60.0


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
    with pytest.raises(SessionError, match="ended without a result, with exit code 1"):
        call.result()


def test_it_is_ended_at_once() -> None:
    call = ChildCall(time.sleep, 600)
    assert not call.done
    call.kill()
    assert call.done


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_it_does_not_outlive_who_asked() -> None:
    told, tells = os.pipe()
    parent = os.fork()
    if parent == 0:
        try:
            os.write(tells, str(ChildCall(time.sleep, 600).pid).encode())
            signal.pause()
        finally:
            os._exit(1)
    pid = int(os.read(told, 20))
    os.close(told)
    os.close(tells)
    assert alive(pid)
    os.kill(parent, signal.SIGKILL)
    os.waitpid(parent, 0)
    assert becomes(lambda: not alive(pid))
