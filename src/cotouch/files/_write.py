"""Writing a file: all of it or nothing, so that a full disk or the end of the process leaves what was there before.

The bytes go into a file of a new name in the same folder, onto the disk, and then take the place of what was there in
one step of the file system. So two who write to the same path both succeed, and the later one's file stays.
"""

import contextlib
import errno
import os
import re
import secrets
import stat
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Final

from cotouch.errors import OutputError

# Standard output and its like, by any of their names; a link to them may lead to a file that must not be replaced.
_OPEN: Final = re.compile(
    r"/dev/(?:std(?P<name>in|out|err)|fd/(?P<dev>\d+))|/proc/(?:self|thread-self)/fd/(?P<proc>\d+)"
)
_STREAMS: Final = {"in": 0, "out": 1, "err": 2}


def write(path: str | Path, data: bytes | bytearray | memoryview, what: str, *, private: bool = False) -> None:
    """Puts bytes into a file, whole or not at all.

    A link is followed to what it leads to. What is no ordinary file (a device, a pipe) is written to, and waited for.
    A file that is replaced keeps its permissions.

    Args:
        path: of the file; its folder must be there.
        data: all of it.
        what: it is, for the message: "result".
        private: readable by its owner alone.

    Raises:
        OutputError: it cannot be written; what was there before still is.
    """
    path = Path(path)
    try:
        number = _opened(path)
        if number is not None:
            _flush(number)
            _put(os.dup(number), data)
        elif (found := _found(path)) is not None and not stat.S_ISREG(found.st_mode):
            _put(os.open(path, os.O_WRONLY | getattr(os, "O_NOCTTY", 0)), data)
        else:
            _replace(Path(os.path.realpath(path)), data, found, private=private)
    except (OSError, ValueError) as error:
        raise OutputError(f"the {what} cannot be written to {path}: {reason(error)}") from error


def check_writable(path: Path, suffixes: Sequence[str] = (), inputs: Iterable[Path] = ()) -> None:
    """Refuses a file that could not be written, before the work that would fill it.

    Args:
        path: that will be written.
        suffixes: one of which it must end in, such as ".nc"; none: any. What is no ordinary file may have any name.
        inputs: files that are read; none of them is written over.

    Raises:
        OutputError: it is a folder or one of the inputs, ends wrongly, or its folder is not there or read-only.
    """
    try:
        found, number = _found(path), _opened(path)
    except (OSError, ValueError) as error:
        raise OutputError(f"{path} cannot be written: {reason(error)}") from None
    if found is not None and stat.S_ISDIR(found.st_mode):
        raise OutputError(f"{path} is a folder; name a file")
    for read in inputs:
        with contextlib.suppress(OSError):
            if found is not None and os.path.samestat(found, read.stat()):
                raise OutputError(
                    f"{path} is read by this command ({read}) and would be overwritten; name another file"
                )
    if number is not None or (found is not None and not stat.S_ISREG(found.st_mode)):
        return
    if suffixes and path.suffix.lower() not in suffixes:
        known = suffixes[0] if len(suffixes) == 1 else f"{', '.join(suffixes[:-1])} or {suffixes[-1]}"
        raise OutputError(f'{path} ends in "{path.suffix}"; its name must end in {known}')
    parent = Path(os.path.realpath(path)).parent
    if not parent.is_dir():
        raise OutputError(f"the folder of {path} does not exist; create it first")
    try:
        _usable(parent)
    except OSError as error:
        raise OutputError(f"{path} cannot be written: {reason(error)}") from None


def folder(path: Path) -> Path:
    """Makes a folder for what will be written, if need be.

    Raises:
        OutputError: it cannot be made, or nothing can be written into it.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
        _usable(path)
    except (OSError, ValueError) as error:
        raise OutputError(f"the folder {path} cannot be created: {reason(error)}") from error
    return path


def beside(folder: Path, names: Iterable[str], inputs: Iterable[Path]) -> None:
    """Refuses a folder in which one of the files to be written is one that is read.

    Args:
        folder: to write into.
        names: of the files.
        inputs: that are read.

    Raises:
        OutputError: one is.
    """
    read = list(inputs)
    for name in names:
        check_writable(folder / name, inputs=read)


def reason(error: Exception) -> str:
    """Why the system refused, in its own words."""
    return getattr(error, "strerror", None) or str(error) or type(error).__name__


def _usable(parent: Path) -> None:
    """Refuses a folder that new files cannot be made in."""
    if os.access(parent, os.W_OK | os.X_OK):
        return
    flags = os.statvfs(parent).f_flag if hasattr(os, "statvfs") else 0
    number = errno.EROFS if flags & getattr(os, "ST_RDONLY", 1) else errno.EACCES
    raise OSError(number, os.strerror(number))


def _found(path: Path) -> os.stat_result | None:
    """What there is, behind all links; None if nothing is."""
    try:
        return path.stat()
    except FileNotFoundError:
        return None


def _opened(path: Path) -> int | None:
    """The number of a stream of this process that a path names, also by links."""
    for _ in range(40):
        match = _OPEN.fullmatch(str(path))
        if match is not None:
            return _STREAMS[match["name"]] if match["name"] else int(match["dev"] or match["proc"])
        try:
            path = Path(os.path.normpath(path.absolute().parent / path.readlink()))
        except (OSError, ValueError):
            return None
    return None


def _flush(number: int) -> None:
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError, AttributeError):
            if stream.fileno() == number:
                stream.flush()


def _put(handle: int, data: bytes | bytearray | memoryview, *, settle: bool = False) -> None:
    """Writes all and closes, whatever happens."""
    try:
        left = memoryview(data).cast("B")
        while left:
            left = left[os.write(handle, left) :]
        if settle:
            os.fsync(handle)
    finally:
        os.close(handle)


def _replace(
    target: Path, data: bytes | bytearray | memoryview, found: os.stat_result | None, *, private: bool
) -> None:
    fresh = target.parent / f".cotouch-{secrets.token_hex(8)}.part"
    handle = os.open(
        fresh,
        os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0),
        0o600 if private else 0o666,
    )
    try:
        if found is not None and not private and hasattr(os, "fchmod"):
            with contextlib.suppress(OSError):
                os.fchmod(handle, stat.S_IMODE(found.st_mode) & 0o777)
        _put(handle, data, settle=True)
        fresh.replace(target)
    except BaseException:
        with contextlib.suppress(OSError):
            fresh.unlink()
        raise
    _settle(target.parent)


def _settle(folder: Path) -> None:
    """Has the new name on the disk too, where folders can be told so."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
