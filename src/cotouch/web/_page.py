"""One open page: what it may do, what it was sent and has not taken yet, and what waits to be sent."""

import asyncio
import json
import math
from collections import deque
from typing import Final, final

from starlette.websockets import WebSocket

from cotouch.samples import Bucket
from cotouch.web._protocol import FrameReceipt, Hello

IN_FLIGHT: Final = 2  # frames that were sent and not acknowledged
_APART: Final = 0.65  # frames stay so far apart, whatever a screen asks for, in periods
_WAITING: Final = 64  # answers that a page lets lie
# A mouse may report a thousand times a second; nobody clicks or slides faster than the other.
_BINARY, _TEXT = 2_000.0, 100.0


@final
class Page:
    """See the module.

    Attributes:
        hello: what it said first; None before.
        acts: whether it has the token.
        period: between frames [s].
        received: when it said anything last [s].
        lapsed: whether it was silent for so long that it lost control.
        due: when the next frame is [s].
        sent: when the last frame was [s].
        skipped: frames that were replaced by newer ones before they went out.
        told_why: whether it was told that it may only watch.
        complained: when it was told last that its pointer cannot be there [s].
        answering: what it asked for and was not answered yet.
        idle: set while nothing waits to be sent.
    """

    def __init__(self, socket: WebSocket) -> None:
        """Prepares a page that said nothing yet."""
        self.hello: Hello | None = None
        self.acts = self.lapsed = False
        self.received = -float("inf")
        self.period = 1.0
        self.due = self.sent = 0.0
        self.skipped = 0
        self.told_why = False
        self.complained = -float("inf")
        self.answering = 0
        self.binary, self.text = Bucket(_BINARY, _BINARY), Bucket(_TEXT, 2.0 * _TEXT)
        self._socket = socket
        self._numbers = deque[int]()
        self._frame: tuple[int, bytes] | None = None
        self._state: str | None = None
        self._texts = deque[str](maxlen=_WAITING)
        self._wake = asyncio.Event()
        self.idle = asyncio.Event()
        self.idle.set()

    @property
    def slot(self) -> int | None:
        """That it acts for."""
        return None if self.hello is None else self.hello.slot

    def takes(self) -> bool:
        """Whether it may be sent another frame."""
        return self.hello is not None and len(self._numbers) < IN_FLIGHT

    def acknowledged(self, taken: FrameReceipt, now: float) -> None:
        """Takes note that frames up to this one arrived, and when the page's screen wants the next.

        Two clocks of 60 Hz that do not know of each other let what is shown wait for both. So a page says when a frame
        is just in time for its screen, and the first such time that is not too early counts.

        Args:
            taken: what the page said of it.
            now: time [s].
        """
        while self._numbers and self._numbers[0] <= taken.number:
            self._numbers.popleft()
        if taken.every:
            pictures = math.ceil((self.sent + _APART * self.period - now - taken.wait) / taken.every)
            self.due = now + taken.wait + max(pictures, 0) * taken.every

    def offer(self, number: int, frame: bytes, now: float) -> None:
        """Hands over the newest frame; one that still waits to go out is forgotten.

        Args:
            number: of the frame.
            frame: as it travels.
            now: time [s].
        """
        if self._frame is not None:
            self.skipped += 1
        self._frame = (number, frame)
        self.sent = now
        self.due = max(self.due + self.period, now + 0.5 * self.period)
        self._hand_over()

    def scene(self, message: str) -> None:
        """Hands over the scene."""
        self._texts.append(message)
        self._hand_over()

    def show(self, state: str) -> None:
        """Hands over how things are; newest wins here, too."""
        self._state = state
        self._hand_over()

    def tell(self, **message: object) -> None:
        """Hands over an answer."""
        self._texts.append(json.dumps(message))
        self._hand_over()

    async def send_all(self) -> None:
        """Sends what was handed over, as fast as the connection takes it, until cancelled."""
        while True:
            await self._wake.wait()
            self._wake.clear()
            while self._texts:
                await self._socket.send_text(self._texts.popleft())
            if self._frame is not None:
                (number, frame), self._frame = self._frame, None
                self._numbers.append(number)
                await self._socket.send_bytes(frame)
            if self._state is not None:
                state, self._state = self._state, None
                await self._socket.send_text(state)
            if not self._wake.is_set():
                self.idle.set()

    def _hand_over(self) -> None:
        self.idle.clear()
        self._wake.set()
