"""A function called in a process of its own: it can be ended at any moment, even while it compiles."""

import contextlib
import os
import pickle
import subprocess
import sys
import tempfile
from collections.abc import Callable
from typing import Generic, ParamSpec, TypeVar, final

from cotouch.errors import SessionError
from cotouch.processes import ONE_THREAD, start_child, tie_to_parent

P = ParamSpec("P")
R = TypeVar("R")

_PATIENCE = 10.0
# What moves a copy on this machine goes before what is worked out for it.
_NICE = 10


@final
class ChildCall(Generic[R]):
    """One call in a child process; arguments and result must be picklable, and progress is not reported."""

    def __init__(self, function: Callable[P, R], /, *args: P.args, **options: P.kwargs) -> None:
        """Starts it.

        Args:
            function: of a module.
            *args: of the function.
            **options: likewise.
        """
        # Files, because nobody reads or writes a pipe while the process starts or runs.
        self._out = tempfile.TemporaryFile()  # noqa: SIM115
        with tempfile.TemporaryFile() as given:
            pickle.dump((function, args, options), given)
            given.seek(0)
            self._process = start_child(
                [sys.executable, "-c", "from cotouch.observers._child import answer; answer()"],
                stdin=given,
                stdout=self._out,
                stderr=subprocess.DEVNULL,
                env={**os.environ, **ONE_THREAD},
            )

    @property
    def pid(self) -> int:
        """Of the process."""
        return self._process.pid

    @property
    def done(self) -> bool:
        """Whether it has ended."""
        return self._process.poll() is not None

    def result(self) -> R:
        """What the function returned; to be asked for once, when it is done.

        Raises:
            SessionError: it raised something, or the process ended without a result.
        """
        self._process.wait(_PATIENCE)
        self._out.seek(0)
        try:
            return pickle.load(self._out)  # noqa: S301  written by our own process
        except (EOFError, pickle.UnpicklingError):
            code = self._process.returncode
            raise SessionError(f"a worker process ended without a result, with exit code {code}") from None
        finally:
            self._out.close()

    def kill(self) -> None:
        """Ends it at once, whatever it does."""
        self._process.kill()
        self._process.wait(_PATIENCE)
        self._out.close()


def answer() -> None:
    """Does what standard input asks for; the result goes to standard output. Nobody waits for what a dead one asked."""
    tie_to_parent()
    function, args, options = pickle.load(sys.stdin.buffer)  # noqa: S301  written by our own process
    with contextlib.suppress(OSError, AttributeError):
        os.nice(_NICE)
    pickle.dump(function(*args, **options), sys.stdout.buffer)
