"""Work that one thread asks of the one that moves a session."""

import threading
from collections.abc import Callable
from concurrent.futures import Future
from queue import Empty, SimpleQueue
from typing import final

from cotouch.errors import SessionError

# Whoever asks does not wait for longer [s].
_PATIENCE = 15.0


@final
class Jobs:
    """Requests from any thread, executed by the one that calls `turn`."""

    def __init__(self) -> None:
        self._queue: SimpleQueue[tuple[Callable[[], str], Future[str]]] = SimpleQueue()
        self._worker: int | None = None
        self._closed = False

    def ask(self, job: Callable[[], str]) -> str:
        """Waits until it was done, and returns what it says.

        Raises:
            SessionError: what the job raises, or the session is over.
        """
        if threading.get_ident() == self._worker:
            return job()
        if self._closed:
            raise SessionError("the session is over")
        future: Future[str] = Future()
        self._queue.put((job, future))
        try:
            return future.result(_PATIENCE)
        except TimeoutError:
            raise SessionError(f"it did not finish within {_PATIENCE:.0f} s; the session is busy or over") from None

    def turn(self) -> None:
        """Does what was asked for."""
        self._worker = threading.get_ident()
        while True:
            try:
                job, future = self._queue.get_nowait()
            except Empty:
                return
            try:
                future.set_result(job())
            except Exception as error:  # noqa: BLE001  it is raised where it was asked for
                future.set_exception(error)

    def close(self) -> None:
        """Refuses what was not done, and all that is asked for later."""
        self._closed = True
        while True:
            try:
                _, future = self._queue.get_nowait()
            except Empty:
                return
            future.set_exception(SessionError("the session is over"))
