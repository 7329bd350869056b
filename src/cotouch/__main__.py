"""`python -m cotouch` is `cotouch`, and how members of a session are started."""

import atexit
import contextlib
import os
import sys
import threading
import traceback
from typing import NoReturn

from cotouch.cli import main


def _code() -> int:
    """Runs the command; returns its exit code."""
    try:
        main()
    except SystemExit as end:
        if end.code is None or isinstance(end.code, int):
            return end.code or 0
        sys.stderr.write(f"{end.code}\n")
        return 1
    except BaseException:  # noqa: BLE001 - as Python itself would end
        traceback.print_exc()
        return 1
    return 0


def run() -> NoReturn:
    """Runs the command and ends the process; also what is installed as `cotouch`."""
    code = _code()
    # Zenoh's own threads may still call back while Python is taken down, and that takes the process down with "FATAL:
    # exception not rethrown". So all is done that Python would do at its end, but it is not taken down.
    for thread in threading.enumerate():
        if thread is not threading.current_thread() and not thread.daemon:
            thread.join()
    atexit._run_exitfuncs()  # pyright: ignore[reportPrivateUsage, reportAttributeAccessIssue]
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError):  # nobody reads it any more
            stream.flush()
    os._exit(code)


if __name__ == "__main__":
    run()
