"""A WebSocket for a loop that waits for one answer at a time: no thread, no compression, nothing hidden.

The protocol is that of the package `websockets`; only the socket is ours. Its own client reads in a thread; a round
trip to the stand-in then took 470 µs instead of 401 µs at the median.
"""

import contextlib
import selectors
import socket
import threading
import time
from typing import final

from websockets.client import ClientProtocol
from websockets.exceptions import InvalidHandshake, InvalidMessage, InvalidURI
from websockets.frames import Frame, Opcode
from websockets.protocol import State
from websockets.uri import parse_uri

from cotouch.errors import DeviceError, TransportError

# The longest frame that a service with some devices sends is a few thousand characters.
_MOST = 1 << 20
_CLOSED = "it closed the connection"
_PIECE = 1 << 16


@final
class WebSocket:
    """One connection. `send` and `abort` from any thread, the rest from one."""

    def __init__(self, url: str, *, what: str, timeout: float, hint: str = "is it running?") -> None:
        """Connects.

        Args:
            url: ws://host:port.
            what: who should be there, for messages.
            timeout: to connect within [s].
            hint: what to do if nobody answers.

        Raises:
            DeviceError: nobody is there, or no such service.
        """
        self._lock = threading.Lock()
        self._parts: list[bytes] = []
        self._ready: list[bytes] = []
        try:
            uri = parse_uri(url)
        except InvalidURI:
            raise DeviceError(f'the address of {what} is "{url}"; it must be like ws://localhost:10001') from None
        if uri.secure:
            raise DeviceError(f'the address of {what} is "{url}"; it must begin with ws://, as the service has no TLS')
        end = time.monotonic() + timeout
        try:
            self._socket = socket.create_connection((uri.host, uri.port), timeout)
        except OSError as error:
            raise DeviceError(f"{what} did not answer at {url} ({error.strerror or error}); {hint}") from None
        self._protocol = ClientProtocol(uri, max_size=_MOST)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._socket.setblocking(False)
        self._selector = selectors.DefaultSelector()
        self._selector.register(self._socket, selectors.EVENT_READ)
        try:
            answered = self._handshake(end)
        except (TransportError, InvalidHandshake, InvalidMessage) as error:
            self.close()
            raise DeviceError(f"what answers at {url} is not {what}: {error}") from None
        except BaseException:
            self.close()
            raise
        if not answered:
            self.close()
            raise DeviceError(f"{what} did not answer at {url} within {timeout:g} s; {hint}")

    def send(self, text: bytes) -> None:
        """Sends one message.

        Raises:
            TransportError: it cannot be sent.
        """
        if not self._lock.acquire(timeout=0.02):
            raise TransportError("another thread is still using the connection")
        try:
            if self._protocol.state is not State.OPEN:
                raise TransportError("the connection is closed")
            self._protocol.send_text(text)
            self._flush()
        finally:
            self._lock.release()

    def receive(self, timeout: float) -> bytes | None:
        """The next message; None if none is complete in time.

        Args:
            timeout: to wait [s]; 0: not at all.

        Raises:
            TransportError: there will be none.
        """
        end = time.monotonic() + timeout
        while not self._ready:
            if not self._take(max(0.0, end - time.monotonic())):
                return None
        return self._ready.pop(0)

    def abort(self) -> None:
        """Cuts the connection, from any thread."""
        with contextlib.suppress(OSError):
            self._socket.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        """Says goodbye and closes; never raises and does not wait."""
        with contextlib.suppress(Exception), self._lock:
            if self._protocol.state is State.OPEN:
                self._protocol.send_close(1000)
                self._flush()
        with contextlib.suppress(Exception):
            self._selector.close()
        self._socket.close()

    def _handshake(self, end: float) -> bool:
        """Whether the other end answered in time."""
        with self._lock:
            self._protocol.send_request(self._protocol.connect())
            self._flush()
        while self._protocol.state is State.CONNECTING and self._protocol.handshake_exc is None:
            if not self._take(end - time.monotonic()):
                return False
        if self._protocol.handshake_exc is not None:
            raise self._protocol.handshake_exc
        return True

    def _take(self, timeout: float) -> bool:
        """Reads what is there; False if nothing comes in time."""
        if timeout < 0.0 or not self._selector.select(timeout):
            return False
        try:
            data = self._socket.recv(_PIECE)
        except (BlockingIOError, InterruptedError):
            return True
        except ConnectionError:  # closed while something of ours was unread: its goodbye is lost
            raise TransportError(_CLOSED) from None
        except (OSError, ValueError) as error:
            raise TransportError(f"the connection failed ({error})") from None
        with self._lock:
            if data:
                self._protocol.receive_data(data)
            else:
                self._protocol.receive_eof()
            self._flush()
            for event in self._protocol.events_received():
                self._event(event)
        if self._protocol.state is not State.OPEN and not self._ready and self._protocol.handshake_exc is None:
            said = self._protocol.close_reason
            raise TransportError(_CLOSED + (f' and said "{said}"' if said else ""))
        return True

    def _event(self, event: object) -> None:
        if not isinstance(event, Frame) or event.opcode not in {Opcode.TEXT, Opcode.BINARY, Opcode.CONT}:
            return
        self._parts.append(bytes(event.data))
        if event.fin:
            self._ready.append(b"".join(self._parts))
            self._parts.clear()

    def _flush(self) -> None:
        for data in self._protocol.data_to_send():
            if not data:
                self.abort()  # both ends have said goodbye, or the other one is gone
                continue
            try:
                self._socket.sendall(data)
            except ConnectionError:
                raise TransportError(_CLOSED) from None
            except OSError as error:
                raise TransportError(f"the connection failed ({error.strerror or error})") from None
