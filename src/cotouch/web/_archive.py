"""Files as one ZIP archive, made while it is sent: no disk and no memory holds it a second time."""

import zipfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import IO, Final, cast, final

_PIECE: Final = 1 << 18


@final
class _Sink:
    """What a ZipFile writes to, and what is taken away from there."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []

    def write(self, data: bytes) -> int:
        """Takes more."""
        self._parts.append(bytes(data))
        return len(data)

    def flush(self) -> None:
        """Nothing waits."""

    def take(self) -> bytes:
        """All since the last time."""
        data, self._parts = b"".join(self._parts), []
        return data


def zipped(paths: Sequence[Path]) -> Iterator[bytes]:
    """The archive in pieces; all files are open when this returns, so that they may be removed.

    Args:
        paths: of files, with different names.

    Raises:
        OSError: one cannot be opened; of the pieces, that it cannot be read.
    """
    with ExitStack() as stack:
        files = [(path.name, stack.enter_context(path.open("rb"))) for path in paths]
        opened = stack.pop_all()

    def pieces() -> Iterator[bytes]:
        sink = _Sink()
        with opened, zipfile.ZipFile(cast("IO[bytes]", sink), "w", zipfile.ZIP_STORED) as archive:
            for name, file in files:
                with archive.open(name, "w", force_zip64=True) as entry:
                    while piece := file.read(_PIECE):
                        entry.write(piece)
                        yield sink.take()
        yield sink.take()

    return pieces()
