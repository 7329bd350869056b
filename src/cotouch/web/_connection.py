"""Connections of the page's server: none holds a place without a request, or with an answer that it does not take."""

from asyncio import TimerHandle, Transport
from typing import Final, final

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

MOST_CONNECTIONS: Final = 64
_REQUEST: Final = 5.0  # for the head of a request, from the connection or the last answer on [s]
_STUCK: Final = 20.0  # for a client that takes nothing of its answer [s]


@final
class BoundedConnection(H11Protocol):
    """One connection until it is a WebSocket; where too many wait, the oldest that waits makes room for a new one."""

    _deadline: TimerHandle | None = None
    _since: float = 0.0
    _placed: bool = False

    def connection_made(self, transport: Transport) -> None:  # type: ignore[override]
        """Takes a place, or that of the oldest connection that asked for nothing yet."""
        plain = [one for one in self.connections if isinstance(one, BoundedConnection)]
        if len(plain) >= MOST_CONNECTIONS:
            idle = [one for one in plain if one.waits]
            if not idle:
                transport.abort()
                return
            oldest = min(idle, key=lambda one: one._since)
            self.connections.discard(oldest)  # it is told of its end only in the next turn of the loop
            oldest.transport.abort()
        super().connection_made(transport)
        self._placed = True
        self._since = self.loop.time()
        self._within(_REQUEST)

    @property
    def waits(self) -> bool:
        """Whether there is no request of it that is being answered."""
        return self.conn.our_state not in {h11.SEND_RESPONSE, h11.SEND_BODY}

    def data_received(self, data: bytes) -> None:
        """Goes on with a request; pieces of one do not prolong its time."""
        super().data_received(data)
        if self.transport.get_protocol() is not self or not (self.waits or self.flow.write_paused):
            self._within(None)

    def on_response_complete(self) -> None:
        """Waits for the next request."""
        super().on_response_complete()
        self._since = self.loop.time()
        if not self.flow.write_paused:
            self._rest()

    def pause_writing(self) -> None:
        """Its client takes no more."""
        super().pause_writing()
        self._within(_STUCK)

    def resume_writing(self) -> None:
        """Its client takes on."""
        super().resume_writing()
        self._rest()

    def connection_lost(self, exc: Exception | None) -> None:
        """Gives its place back."""
        self._within(None)
        if self._placed:
            super().connection_lost(exc)

    def _rest(self) -> None:
        self._within(_REQUEST if self.waits else None)

    def _within(self, seconds: float | None) -> None:
        if self._deadline is not None:
            self._deadline.cancel()
        self._deadline = None if seconds is None else self.loop.call_later(seconds, self.transport.abort)
