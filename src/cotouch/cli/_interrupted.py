"""How a command ends that was interrupted from the keyboard."""

import contextlib
import signal
import sys

from cotouch.processes import tied

INTERRUPTED = 130  # what shells give a command that SIGINT ended


def say_interrupted() -> None:
    """Says it in one line. A second Ctrl-C is not listened to any more: the command is about to end."""
    with contextlib.suppress(ValueError):  # not in the main thread
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    if not tied():
        with contextlib.suppress(OSError):
            sys.stderr.write("cotouch: interrupted\n")
