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
from pathlib import Path

import pytest

MARK = "COTOUCH_TEST_RUN"
_KEEPER = pytest.StashKey["subprocess.Popen[bytes]"]()


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config: pytest.Config) -> None:
    """Starts the process beside this one, and marks what is started from now on."""
    mark, before = secrets.token_hex(8), os.environ.get(MARK, "")
    command = [sys.executable, "-S", str(Path(__file__).with_name("keeper.py")), mark]
    config.stash[_KEEPER] = subprocess.Popen(command, stdin=subprocess.PIPE, start_new_session=True)
    os.environ[MARK] = f"{before} {mark}"


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """Has what is left ended before this process is."""
    keeper = config.stash[_KEEPER]
    assert keeper.stdin is not None
    keeper.stdin.close()
    with contextlib.suppress(subprocess.TimeoutExpired):
        keeper.wait(20)
    os.environ[MARK] = os.environ[MARK].rpartition(" ")[0]
