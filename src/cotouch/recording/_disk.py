"""A new file on a disk that may be full, go away or be taken away: what is kept in it is whole."""

import contextlib
import os
from collections.abc import Callable
from io import FileIO
from pathlib import Path
from typing import Protocol, final

from cotouch.errors import RecordingError


class RawFile(Protocol):
    """What bytes go to, without a buffer; `io.FileIO`."""

    def write(self, data: memoryview, /) -> int | None:
        """Takes the first so many of these bytes."""
        ...

    def truncate(self, size: int, /) -> int:
        """Cuts the file off."""
        ...

    def fileno(self) -> int:
        """Number of the open file."""
        ...

    def close(self) -> None:
        """Closes it."""
        ...


def make(path: Path) -> RawFile:
    """Makes a file that only this user may read and write.

    Raises:
        OSError: it cannot be made, or exists.
    """
    return FileIO(path, "x", opener=lambda name, flags: os.open(name, flags, 0o600))


@final
class NewFile:
    """A file that did not exist before, written from beginning to end.

    Bytes go out at once; an error while they do leaves what `keep` was told of, and nothing after it.

    Attributes:
        path: of the file.
        kept: bytes in it that stay, whatever comes.
    """

    def __init__(self, path: Path, making: Callable[[Path], RawFile] = make) -> None:
        """Makes it.

        Args:
            path: must not exist.
            making: opens it.

        Raises:
            RecordingError: the file exists, or cannot be made.
        """
        try:
            self._raw = making(path)
        except FileExistsError:
            raise RecordingError(f"{path} exists; recordings are never overwritten; name another file") from None
        except OSError as error:
            raise RecordingError(f"the recording {path} cannot be written: {error.strerror or error}") from error
        self.path = path
        self.kept = 0
        self._at = 0
        self._closed = self._discarded = False

    def write(self, data: bytes) -> int:
        """Writes all of it.

        Raises:
            OSError: the disk does not take it.
        """
        rest = memoryview(data)
        while rest:
            taken = self._raw.write(rest)
            if not taken:
                raise OSError("the disk took nothing")
            self._at += taken
            rest = rest[taken:]
        return len(data)

    def tell(self) -> int:
        """Bytes so far."""
        return self._at

    def flush(self) -> None:
        """Nothing waits here."""

    def keep(self) -> None:
        """What was written so far stays.

        Raises:
            OSError: the file was removed, so that nobody will ever read it.
        """
        if os.fstat(self._raw.fileno()).st_nlink == 0:
            raise OSError("the file was removed while it was written")
        self.kept = self._at

    def cut(self) -> None:
        """Takes back what came after `keep`, as far as the disk lets it."""
        if self._closed:
            return
        with contextlib.suppress(OSError):
            self._raw.truncate(self.kept)

    def close(self) -> None:
        """Waits until the disk has everything, and closes; may be called again.

        Raises:
            OSError: the disk does not have it: some say so only now.
        """
        if self._closed:
            return
        self._closed = True
        try:
            os.fsync(self._raw.fileno())
        finally:
            self._raw.close()

    def discard(self) -> None:
        """Closes and removes it; may be called again."""
        if self._discarded:
            return
        self._discarded = True
        with contextlib.suppress(OSError):
            self.close()
        with contextlib.suppress(OSError):
            self.path.unlink()
