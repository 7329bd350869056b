"""What a file is, before it is opened: what has no end, or waits for somebody, is refused."""

import os
import stat
import tomllib
from pathlib import Path
from typing import Final

from cotouch.errors import CotouchError

# Nobody writes more by hand; matrices of a body of 400 nodes take so much.
MOST_TEXT: Final = 16 << 20
_CHUNK: Final = 1 << 20
_KINDS: Final = (
    (stat.S_ISDIR, "a folder"),
    (stat.S_ISFIFO, "a pipe"),
    (stat.S_ISCHR, "a device"),
    (stat.S_ISBLK, "a device"),
    (stat.S_ISSOCK, "a socket"),
)


def look(path: Path, what: str, error: type[CotouchError], most: int | None = None) -> os.stat_result:
    """What a file to be read is, without opening it.

    Args:
        path: of the file; links are followed.
        what: it is, for the message: "mesh".
        error: to be raised.
        most: bytes that it may have.

    Raises:
        CotouchError: of the given class: it is not there, is no ordinary file, or is too large.
    """
    try:
        found = path.stat()
    except (OSError, ValueError) as problem:
        raise error(f"the {what} {path} cannot be read: {_reason(problem)}") from None
    _check(found, path, what, error, most)
    return found


def read_bytes(path: Path, what: str, error: type[CotouchError], most: int) -> bytes:
    """The content of an ordinary file of at most so many bytes, also if the path became something else meanwhile.

    Args:
        path: of the file.
        what: it is, for messages: "the scenario".
        error: class of what is raised.
        most: bytes that are taken.

    Raises:
        CotouchError: of the given class: it is not there, is no ordinary file, cannot be read or is too large.
    """
    look(path, what, error, most)
    try:
        # Without waiting for a pipe's other end, should it have become one since.
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
        with os.fdopen(handle, "rb") as file:
            _check(os.fstat(handle), path, what, error, most)
            data = file.read(most + 1)
    except (OSError, MemoryError) as problem:
        raise error(f"the {what} {path} cannot be read: {_reason(problem)}") from None
    if len(data) > most:
        raise error(_too_large(path, what, most))
    return data


def read_text(path: Path, what: str, error: type[CotouchError], most: int = MOST_TEXT) -> str:
    """The same as text, without the mark that some editors and spreadsheets put before UTF-8.

    Args:
        path: of the file.
        what: it is, for messages: "the scenario".
        error: class of what is raised.
        most: bytes that are taken.

    Raises:
        CotouchError: of the given class: as `read_bytes` says, or it is not UTF-8.
    """
    try:
        return read_bytes(path, what, error, most).decode("utf-8-sig")
    except UnicodeDecodeError:
        raise error(f"the {what} {path} cannot be read: it is not UTF-8 text") from None


def read_toml(path: Path, what: str, error: type[CotouchError]) -> dict[str, object]:
    """The tables of a TOML file.

    Args:
        path: of the file.
        what: it is, for messages: "the scenario".
        error: class of what is raised.

    Raises:
        CotouchError: of the given class: as `read_text` says, or it is not TOML.
    """
    return toml(read_text(path, what, error), str(path), error)


def toml(text: str, source: str, error: type[CotouchError]) -> dict[str, object]:
    """The tables of TOML text.

    Args:
        text: to read.
        source: what it is, for messages.
        error: class of what is raised.

    Raises:
        CotouchError: of the given class: it is not TOML.
    """
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise error(f"{source} is not TOML that can be read: its tables or lists are too deep") from None
    except ValueError as problem:  # TOMLDecodeError, and numbers of too many digits
        raise error(f"{source} is not TOML: {problem}") from None


def _check(found: os.stat_result, path: Path, what: str, error: type[CotouchError], most: int | None) -> None:
    for holds, kind in _KINDS:
        if holds(found.st_mode):
            raise error(f"the {what} {path} cannot be read: it is {kind}; name an ordinary file")
    if most is not None and found.st_size > most:
        raise error(_too_large(path, what, most))


def _too_large(path: Path, what: str, most: int) -> str:
    return f"the {what} {path} cannot be read: it has more than {most >> 20} MB"


def _reason(problem: Exception) -> str:
    if isinstance(problem, MemoryError):
        return "it does not fit into memory"
    return getattr(problem, "strerror", None) or str(problem)
