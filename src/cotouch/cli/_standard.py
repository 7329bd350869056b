"""Standard output that is full, closed, or that nobody reads any more."""

import contextlib
import errno
import io
import os
import sys
import warnings
from collections.abc import Generator
from typing import Final, NoReturn

from cotouch.errors import OutputError

# With these, and no name of a file, a stream refuses what is written to it.
_REFUSALS: Final = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EBADF, errno.EPIPE}


@contextlib.contextmanager
def interrupts() -> Generator[None]:
    """Sees to it that what a command printed arrived, however the command ended.

    Raises:
        OutputError: standard output cannot be written: its disk is full, say, or it is closed.
        SystemExit: nobody reads it any more; that is no error to speak of, but no success either.
    """
    _occupied()
    _lenient()
    try:
        yield
    except OSError as error:
        if error.filename is None and error.errno in _REFUSALS:
            _give_up(error)
        raise
    except SystemExit as end:
        refused = _refused()
        if refused is not None and not end.code:
            _give_up(refused)
        raise
    else:
        refused = _refused()
        if refused is not None:
            _give_up(refused)
    finally:
        if _refused() is not None:
            _silence()


def _lenient() -> None:
    """Letters that a terminal's encoding has not become question marks."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
            stream.reconfigure(errors="replace")


def _give_up(refused: OSError) -> NoReturn:
    _silence()
    if refused.errno == errno.EPIPE:
        raise SystemExit(1) from None
    raise OutputError(f"standard output cannot be written: {refused.strerror or refused}") from None


def _refused() -> OSError | None:
    """What the system says to whatever still waits to be written."""
    try:
        sys.stdout.flush()
    except OSError as error:
        return error
    except ValueError:  # closed by whoever handed it over
        return None
    return None


def _silence() -> None:
    """Nothing more is written there, so that the end of the process doesn't complain again."""
    with contextlib.suppress(OSError, ValueError):
        number = sys.stdout.fileno()
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, number)
        os.close(nowhere)


def _occupied() -> None:
    """Standard streams that were closed come back, so that no file that is opened takes their place.

    Input is empty then, what is written to standard output fails, and what goes to standard error is lost.
    """
    for number, way in ((0, os.O_RDONLY), (1, os.O_RDONLY), (2, os.O_WRONLY)):
        try:
            os.fstat(number)
        except OSError:
            os.set_inheritable(os.open(os.devnull, way), True)
    if sys.stdout is None:  # pyright: ignore[reportUnnecessaryComparison]
        sys.stdout = os.fdopen(1, "w", encoding="utf-8", closefd=False)
    if sys.stderr is None:  # pyright: ignore[reportUnnecessaryComparison]
        sys.stderr = os.fdopen(2, "w", encoding="utf-8", closefd=False)
    if sys.stdin is None:  # pyright: ignore[reportUnnecessaryComparison]
        sys.stdin = os.fdopen(0, encoding="utf-8", closefd=False)


@contextlib.contextmanager
def warnings_as_sentences() -> Generator[None]:
    """What cotouch warns of is one line, without the place in its sources that Python would show."""
    usual = warnings.formatwarning

    def formatted(
        message: Warning | str, category: type[Warning], filename: str, lineno: int, line: str | None = None
    ) -> str:
        own = category.__module__.partition(".")[0] == "cotouch"
        return f"cotouch: {message}\n" if own else usual(message, category, filename, lineno, line)

    warnings.formatwarning = formatted
    try:
        yield
    finally:
        warnings.formatwarning = usual
