"""A member's side of recordings that are ordered while everybody moves: each order comes to an end that is told."""

from collections.abc import Callable
from threading import Thread
from typing import final

import numpy as np

from cotouch.arrays import Array
from cotouch.errors import RecordingError
from cotouch.members import Replica, SessionRecorder
from cotouch.observers._mailboxes import TROUBLE

# A copy that takes no step within this time after the end of a recording has none in it [s].
_PATIENCE = 2.0


@final
class Takes:
    """Follows orders to record, one after the other; belongs to the thread that moves the copy.

    Attributes:
        session_recorder: that is to be told what the copy does; None while nothing is recorded.
    """

    def __init__(
        self, fields: dict[str, Array], publish: Callable[[], None], make: Callable[[int], SessionRecorder]
    ) -> None:
        """Nothing is recorded yet.

        Args:
            fields: of the member's mailbox; see `view_fields`.
            publish: shows them.
            make: the recorder of the recording of this number; may raise RecordingError.
        """
        self.session_recorder: SessionRecorder | None = None
        self._fields, self._publish, self._make = fields, publish, make
        self._done: int | None = None  # number of the newest order that asks for nothing more
        self._number = 0
        self._over: float | None = None  # when the order under way ended
        self._closing: Thread | None = None
        self._closed: SessionRecorder | None = None

    def follow(self, number: int, copy: Replica | None, now: float, *, on: bool) -> None:
        """Does what is ordered; to be called now and then.

        Args:
            number: of the newest order.
            copy: None before there is one.
            now: [s].
            on: whether that recording is to go on.
        """
        if self._done is None:  # what ended before this member came is not for it
            self._done = number if not on else number - 1
        self._finish()
        if self._closing is not None:
            return
        if self.session_recorder is not None:
            self._over = None if on and number == self._number else self._over or now
            waited = self._over is not None and (self.session_recorder.steps > 0 or now - self._over > _PATIENCE)
            if waited or self.session_recorder.failure is not None:
                self.end()
        elif number > self._done:
            if copy is not None and copy.peer is not None:
                self._begin(number, copy, now)
            elif not on:  # nobody waits for who does not move
                self._done = number

    def end(self, *, wait: bool = False) -> None:
        """Ends what is recorded, in a thread, because the disk may take its time.

        Args:
            wait: for it.
        """
        if self.session_recorder is not None:
            self._closed, self.session_recorder = self.session_recorder, None
            self._closing = Thread(target=self._closed.close, name="cotouch end of recording")
            self._closing.start()
        self._finish(wait=wait)

    def _begin(self, number: int, copy: Replica, now: float) -> None:
        self._number, self._over = number, None
        try:
            self.session_recorder = self._make(number)
        except RecordingError as error:
            self._tell(0, f"was not started: {getattr(error.__cause__, 'strerror', None) or error}")
            return
        self.session_recorder.setup(copy, now)
        self._fields["recording"][()] = number
        self._publish()

    def _finish(self, *, wait: bool = False) -> None:
        if self._closing is None or self._closed is None:
            return
        if wait:
            self._closing.join()
        if not self._closing.is_alive():
            session_recorder, self._closing, self._closed = self._closed, None, None
            none = None if session_recorder.steps else "has no steps: the copy took none in that time"
            self._tell(session_recorder.recorded, session_recorder.trouble or none)

    def _tell(self, steps: int, trouble: str | None) -> None:
        """Says what came of it, at once, whether the copy steps or not."""
        self._done = self._number
        fields = self._fields
        fields["recorded"][()], fields["recording"][()] = self._number, 0
        fields["recorded_steps"][()] = steps
        fields["recorded_trouble"][()] = np.bytes_((trouble or "").encode()[:TROUBLE])
        self._publish()
