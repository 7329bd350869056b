"""Ends what a run of tests started and could not end itself, because it was interrupted.

Each process that runs tests marks its environment, which all that it starts inherit, and holds one end of a pipe. A
process beside it (`keeper.py`) sees that end close, whether pytest ended, was stopped by Ctrl-C or was killed, and ends
whatever bears the mark, also what has a session, a namespace or another parent of its own. Mailboxes in memory go with
it.
"""

import contextlib
import os
import secrets
import subprocess
import sys
from collections.abc import Generator
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

MARK = "COTOUCH_TEST_RUN"
_KEPT = pytest.StashKey[AbstractContextManager[None]]()


@contextlib.contextmanager
def none_left() -> Generator[None]:
    """What this process starts in here is ended after it, however this process ends."""
    mark, before = secrets.token_hex(8), os.environ.get(MARK, "")
    command = [sys.executable, "-S", str(Path(__file__).with_name("keeper.py")), mark]
    keeper = subprocess.Popen(command, stdin=subprocess.PIPE, start_new_session=True)
    os.environ[MARK] = f"{before} {mark}"
    try:
        yield
    finally:
        assert keeper.stdin is not None
        keeper.stdin.close()
        with contextlib.suppress(subprocess.TimeoutExpired):
            keeper.wait(20)
        os.environ[MARK] = os.environ[MARK].rpartition(" ")[0]


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config: pytest.Config) -> None:
    """Starts the process beside this one, and marks what is started from now on."""
    config.stash[_KEPT] = none_left()
    config.stash[_KEPT].__enter__()


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """Has what is left ended before this process is."""
    config.stash[_KEPT].__exit__(None, None, None)
