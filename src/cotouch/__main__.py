"""`python -m cotouch` is `cotouch`, and how members of a session are started."""

# What takes time to load is loaded where Ctrl-C is heeded.
import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn

# So long may an interrupted command take to tidy up: what it was compiling or working out may go on for minutes [s].
_TIDY = 1.0
_INTERRUPTED = 130
# Whoever started this process says what a Ctrl-C at both of them did.
_SAID = "" if "COTOUCH_PARENT" in os.environ else "cotouch: interrupted\n"
# How many objects more than before are looked through for circles of references; what is loaded stays anyway.
_OBJECTS = 50_000


def _code() -> int:
    """Runs the command; returns its exit code."""
    try:
        from cotouch.cli import main

        main()
    except SystemExit as end:
        if end.code is None or isinstance(end.code, int):
            return end.code or 0
        sys.stderr.write(f"{end.code}\n")
        return 1
    except KeyboardInterrupt:  # before the command began, or while it ended
        sys.stderr.write(_SAID)
        return _INTERRUPTED
    except BaseException:  # noqa: BLE001 - as Python itself would end
        import traceback

        traceback.print_exc()
        return 1
    return 0


def run() -> "NoReturn":
    """Runs the command and ends the process without taking Python down; also what is installed as `cotouch`."""
    try:
        import gc

        gc.set_threshold(_OBJECTS)
        from cotouch.processes import tie_to_parent

        tie_to_parent()
        code = _code()
        if code == _INTERRUPTED:
            import threading

            hard = threading.Timer(_TIDY, os._exit, [code])
            hard.daemon = True
            hard.start()
        _finish()
    except KeyboardInterrupt:
        sys.stderr.write(_SAID)
        code = _INTERRUPTED
    os._exit(code)


def _finish() -> None:
    """Does what Python would do at its end, but for taking itself down.

    Zenoh's own threads may still call back then, and that ends in "FATAL: exception not rethrown".
    """
    import atexit
    import contextlib
    import threading

    for thread in threading.enumerate():
        if thread is not threading.current_thread() and not thread.daemon:
            thread.join()
    atexit._run_exitfuncs()  # pyright: ignore[reportPrivateUsage, reportAttributeAccessIssue]
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError):  # nobody reads it any more
            stream.flush()


if __name__ == "__main__":
    run()
