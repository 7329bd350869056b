"""What waits in real time is marked `timed` and takes turns.

`make test` runs some of it with nothing beside it, and everything else gives way to the rest (`run.py`). Whoever runs
tests otherwise has one such test at a time on two cores: a turn is a locked file that all who test on this machine
share. The system unlocks it for whoever is killed.
"""

import contextlib
import fcntl
import os
import tempfile
import time
from collections.abc import Generator
from pathlib import Path

import pytest
from tests.order import TIMED, module_of

# Each needs a core for what it waits for, and one is for whoever tests beside it.
TURNS = max(1, len(os.sched_getaffinity(0)) // 2)


@contextlib.contextmanager
def turn(turns: int = TURNS) -> Generator[None]:
    """Waits for one of so many turns, and keeps it."""
    paths = [Path(tempfile.gettempdir(), f"cotouch-tests-{os.geteuid()}-{k}.turn") for k in range(turns)]
    held = [os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o600) for path in paths]
    try:
        while not any(_taken(one) for one in held):
            time.sleep(0.02)
        yield
    finally:
        for one in held:
            os.close(one)


def _taken(lock: int) -> bool:
    with contextlib.suppress(BlockingIOError, PermissionError):
        # Of this process alone: a fork that a failed test leaves behind must not keep the turn.
        fcntl.lockf(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        return True
    return False


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Marks it, before pytest selects by marks."""
    for item in items:
        if module_of(item.nodeid) in TIMED:
            item.add_marker("timed")


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    """Takes a turn for a test of a module that waits in real time, with its fixtures."""
    with turn() if module_of(item.nodeid) in TIMED else contextlib.nullcontext():
        return (yield)
