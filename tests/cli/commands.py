"""The command as a user runs it, in a process of its own; or in this one, which spares what starting one costs."""

import io
import signal
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from unittest.mock import patch

from cotouch.cli import main

FIVE_USERS = Path(__file__).parents[2] / "examples" / "five-users.toml"
Done = subprocess.CompletedProcess[str]


def cotouch(*arguments: str | Path) -> Done:
    """A process of its own."""
    return subprocess.run(
        [sys.executable, "-c", "from cotouch.cli import main; main()", *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


def here(*arguments: str | Path) -> Done:
    """In this process; what the command raises and does not turn into a sentence is raised."""
    out, err, code = io.StringIO(), io.StringIO(), 0
    heeds = signal.getsignal(signal.SIGINT)  # a command that was interrupted heeds no other one
    with patch.object(sys, "argv", ["cotouch", *map(str, arguments)]), redirect_stdout(out), redirect_stderr(err):
        try:
            main()
        except SystemExit as ended:
            code = int(ended.code or 0)
        finally:
            signal.signal(signal.SIGINT, heeds)
    return Done(arguments, code, out.getvalue(), err.getvalue())
