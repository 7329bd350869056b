"""Stands beside a process that runs tests, and ends what that leaves behind; see `leftovers.py`, which starts it.

python -S keeper.py MARK < PIPE
"""

import contextlib
import os
import runpy
import signal
import sys
import time
from pathlib import Path

PROCESSES = Path(__file__).parents[1] / "src" / "cotouch" / "processes.py"


def marked(mark: str) -> list[int]:
    """Processes that were started with a mark in their environment."""
    found = []
    for entry in Path("/proc").iterdir():
        with contextlib.suppress(OSError):
            if entry.name.isdigit() and mark.encode() in (entry / "environ").read_bytes():
                found.append(int(entry.name))
    return found


def main(mark: str) -> None:
    """Waits for the end of its input."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    sys.stdin.buffer.read()
    end = time.monotonic() + 15.0
    while (left := marked(mark)) and time.monotonic() < end:
        for pid in left:
            with contextlib.suppress(OSError):
                os.kill(pid, signal.SIGKILL)
        time.sleep(0.02)
    # A process that dies loses its environment before its locks: once is not enough.
    processes = runpy.run_path(str(PROCESSES))
    end = time.monotonic() + 5.0
    while processes["remove_abandoned"]() and time.monotonic() < end:
        time.sleep(0.05)


if __name__ == "__main__":
    main(sys.argv[1])
