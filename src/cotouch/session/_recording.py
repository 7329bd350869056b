"""Recording while everybody moves: each member of this machine keeps a file, and all go into one archive."""

import io
import zipfile
from collections.abc import Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from typing import final

from cotouch.errors import SessionError
from cotouch.session._boards import BoardFolder
from cotouch.session._desk import Desk

# Whoever did not finish its file by then is not waited for [s].
_PATIENCE = 10.0


@final
class RecordingDesk:
    """Orders recordings, and gathers them; `switch` and `turn` belong to one thread.

    Attributes:
        archive: of the last finished recording; None before there is one.
    """

    def __init__(self, boards: BoardFolder, desk: Desk) -> None:
        """Nothing is recorded yet.

        Args:
            boards: where the files are.
            desk: by which members are told.
        """
        self.archive: bytes | None = None
        self._boards, self._desk = boards, desk
        self._number = 0
        self._began: float | None = None
        self._ending: float | None = None
        self._pool = ThreadPoolExecutor(1, thread_name_prefix="cotouch archive")
        self._packing: Future[bytes] | None = None

    def since(self, now: float) -> float | None:
        """How long is recorded already; None: nothing is [s]."""
        return None if self._began is None else max(0.0, now - self._began)

    def switch(self, on: bool, now: float) -> str:
        """Begins or ends a recording.

        Args:
            on: which.
            now: [s].

        Raises:
            SessionError: it is so already, or the one before is still being gathered.
        """
        if on:
            if self._began is not None:
                raise SessionError("a recording is under way already")
            if self._ending is not None or self._packing is not None:
                raise SessionError("the recording before is still being gathered; try again in a moment")
            self._number += 1
            self._began = now
            self._desk.record(self._number)
            return "recording"
        if self._began is None:
            raise SessionError("nothing is being recorded")
        self._began, self._ending = None, now
        self._desk.record(0)
        return "the recording ends; it can be fetched in a moment"

    def turn(self, now: float, members: Sequence[str]) -> None:
        """Gathers what is whole.

        Args:
            now: [s].
            members: names of those whose processes run.
        """
        if self._ending is not None:
            whole = all(self._desk.number(name, "recording") <= 0 for name in members)
            if whole or now - self._ending > _PATIENCE:
                self._ending = None
                self._packing = self._pool.submit(_packed, self._boards, self._number)
        if self._packing is not None and self._packing.done():
            packing, self._packing = self._packing, None
            self.archive = packing.result() or None

    def close(self) -> None:
        """Lets go of the thread."""
        self._pool.shutdown(wait=False, cancel_futures=True)


def _packed(boards: BoardFolder, number: int) -> bytes:
    """All files of a recording, which are removed; empty if there are none."""
    paths = boards.recordings(number)
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as archive:  # MCAP is compressed already
        for path in paths:
            archive.write(path, path.name)
            path.unlink()
    return out.getvalue() if paths else b""
