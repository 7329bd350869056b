"""Datagrams over UDP: one socket for all neighbours, read without waiting."""

import errno
import socket
import struct
import time
from collections.abc import Callable, Hashable
from contextlib import suppress
from functools import lru_cache
from typing import cast, final

from cotouch.errors import SessionError, TransportError
from cotouch.samples._address import Address, numeric, origin
from cotouch.samples._limit import SourceLimit
from cotouch.samples._transport import MOST_BYTES, Arrival, Traffic

# The kernel's own arrival times (nanoseconds): Python has no name for the option. Without it, the time of reading.
_TIMESTAMPS = getattr(socket, "SO_TIMESTAMPNS", 35 if socket.has_ipv6 and hasattr(socket, "SO_PRIORITY") else None)
_TIMESPEC = struct.Struct("@qq")
_SPACE = socket.CMSG_SPACE(_TIMESPEC.size) if hasattr(socket, "CMSG_SPACE") else 0
# Twice five neighbours with five datagrams each, 1 kHz, a tenth of a second without reading, the kernel's overhead
# included; the kernel grants at most net.core.rmem_max.
_RECEIVE_BUFFER = 4 << 20
# Bounds one `poll` under a flood; what is left stays in the kernel for the next.
_MOST_AT_ONCE = 4096


@final
class UdpTransport:
    """The sample plane's socket; see `Transport`. Listens on this machine only, unless told otherwise.

    Attributes:
        traffic: what went through so far.
    """

    def __init__(
        self,
        *,
        host: str = "127.0.0.1",
        port: int = 0,
        rate: float = 20_000.0,
        burst: float = 4096.0,
        stranger_rate: float = 200.0,
        stranger_burst: float = 64.0,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Opens the socket.

        Args:
            host: address to listen on, IPv4 or IPv6, in numbers; `0.0.0.0` or `::` for all of this machine's.
            port: 0 lets the system choose.
            rate: datagrams that a neighbour may send in the long run [1/s].
            burst: at once.
            stranger_rate: likewise of a stranger, who may be a neighbour behind a new address [1/s].
            stranger_burst: at once.
            clock: gives the time of arrivals [s].

        Raises:
            SessionError: the address is none.
            TransportError: the port is taken, or the address is not this machine's.
        """
        number = numeric(host)
        self._six = number.version == 6
        self._clock = clock
        self._limit = SourceLimit(rate=rate, burst=burst, stranger_rate=stranger_rate, stranger_burst=stranger_burst)
        self._neighbours: dict[int, tuple[str, int]] = {}
        self.traffic = Traffic()
        self._last = clock()
        self._socket: socket.socket | None = _open(str(number), _port(port), six=self._six)
        _ask_for_stamps(self._socket)

    @property
    def address(self) -> Address:
        """Where it listens."""
        if self._socket is None:
            raise TransportError("the socket is closed; open a new transport")
        return Address(*self._socket.getsockname()[:2])

    def rebind(self, host: str) -> None:
        """Listens at another address of this machine from now on, at the same port if that is free.

        What waits in the kernel is lost, as on any path.

        Args:
            host: as at first.

        Raises:
            SessionError: the address is none.
            TransportError: it is not this machine's; the socket stays where it is.
        """
        number = numeric(host)
        if self._socket is None:
            raise TransportError("the socket is closed; open a new transport")
        six, port = number.version == 6, self.address.port
        try:
            opened = _open(str(number), port, six=six)
        except TransportError:
            opened = _open(str(number), 0, six=six)
        self._socket.close()
        self._socket, self._six = opened, six
        _ask_for_stamps(opened)

    @property
    def buffer(self) -> int:
        """Receive buffer that the kernel granted [B]."""
        return 0 if self._socket is None else self._socket.getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF)

    def fileno(self) -> int:
        """For `select` and its kind; -1 when closed."""
        return -1 if self._socket is None else self._socket.fileno()

    def send(self, neighbour: int, payload: bytes) -> bool:
        """Hands a datagram to the kernel; never waits.

        Args:
            neighbour: slot of the neighbour.
            payload: the datagram.
        """
        to = self._neighbours.get(neighbour)
        if self._socket is None:
            self.traffic.unsent["closed"] += 1
        elif len(payload) > MOST_BYTES:
            self.traffic.unsent["too long"] += 1
        elif to is None:
            self.traffic.unsent["no address"] += 1
        else:
            try:
                self._socket.sendto(payload, to)
            except OSError as error:  # buffer full, no route, a firewall: all of them may pass
                self.traffic.unsent[_why(error)] += 1
                return False
            self.traffic.count_sent(payload)
            return True
        return False

    def reach(self, address: Address, payload: bytes) -> bool:
        """Hands the kernel a datagram for an address that is no neighbour's; whoever asks counts it.

        Args:
            address: IP address and port.
            payload: the datagram.
        """
        if self._socket is None:
            return False
        try:
            self._socket.sendto(payload, (_reachable(address.host, six=self._six), address.port))
        except (OSError, SessionError):
            return False
        return True

    def capacity(self, neighbour: int) -> float:  # noqa: ARG002
        """Nothing is known here of what a path bears."""
        return float("inf")

    def now(self) -> float:
        """Time, as arrivals are stamped [s]."""
        return self._clock()

    def poll(self) -> list[Arrival]:
        """Everything that arrived since the last call, oldest first; never waits."""
        if self._socket is None:
            return []
        arrived, traffic, received, behind = list[Arrival](), self.traffic, 0, None
        read, now = self._socket.recvmsg, self._clock()
        for _ in range(_MOST_AT_ONCE):
            try:
                payload, extra, _, sender = read(MOST_BYTES + 1, _SPACE)
            except BlockingIOError:
                if not arrived:  # the most frequent case by far
                    self._last = now
                    return arrived
                break
            except OSError as error:  # an earlier datagram's bad news; the next call goes on
                traffic.dropped[_why(error)] += 1
                continue
            source = sender[:2]
            if not self._limit.take(now, source, origin(source[0])):
                traffic.dropped["too many"] += 1
                continue
            if not 0 < len(payload) <= MOST_BYTES:
                traffic.dropped["size"] += 1
                continue
            stamp = now
            if extra and len(extra[0][2]) == _TIMESPEC.size:
                seconds, nanoseconds = _TIMESPEC.unpack(extra[0][2])
                if behind is None:
                    behind = time.time() - self._clock()  # the kernel stamps with the clock of the wall
                # A datagram arrived after the last reading and before this one, whatever was done to the wall's clock;
                # it may have come after `now`, if this process had to stand back meanwhile.
                stamp = min(max(seconds + 1e-9 * nanoseconds - behind, self._last), self._clock())
            arrived.append(Arrival(payload, source, stamp))
            received += len(payload)
        else:
            traffic.dropped["left for later"] += 1
        self._last = now
        traffic.received += len(arrived)
        traffic.received_bytes += received
        return arrived

    def follow(self, neighbour: int, source: Hashable) -> None:
        """From now on the neighbour is there: an `Address`, or the source of an arrival.

        Args:
            neighbour: slot of the neighbour.
            source: where it came from.

        Raises:
            SessionError: this is no address, or one that this socket cannot reach.
        """
        old = self._neighbours.get(neighbour)
        if source == old:
            return
        pair = cast("tuple[object, ...]", source) if isinstance(source, tuple) else ()
        if len(pair) != 2:
            raise SessionError(f"{source!r} is not an address; it must be a numeric host and a port")
        new = (_reachable(str(pair[0]), six=self._six), _port(pair[1], given=True))
        self.forget(neighbour)
        self._neighbours[neighbour] = new
        self._limit.know(new)

    def forget(self, neighbour: int) -> None:
        """The neighbour left."""
        old = self._neighbours.pop(neighbour, None)
        if old is not None and old not in self._neighbours.values():
            self._limit.unknow(old)

    def close(self) -> None:
        """Gives the port back."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None


@lru_cache(1024)
def _reachable(host: str, *, six: bool) -> str:
    number = numeric(host)
    if six and number.version == 4:
        return f"::ffff:{number}"
    if not six and number.version == 6:
        raise SessionError(f"neighbour {host} has an IPv6 address, but this socket listens on IPv4; listen on '::'")
    return str(number) if number.version == 4 else host


def _open(host: str, port: int, *, six: bool) -> socket.socket:
    opened = socket.socket(socket.AF_INET6 if six else socket.AF_INET, socket.SOCK_DGRAM)
    try:
        opened.setblocking(False)
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _RECEIVE_BUFFER)
        if six:
            opened.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 0)
        opened.bind((host, port))
    except OSError as error:
        opened.close()
        known = {
            errno.EADDRINUSE: f"UDP port {port} of {host} is taken; choose another, or 0 for any that is free",
            errno.EADDRNOTAVAIL: f"{host} is not an address of this machine; listen on one that is",
            errno.EACCES: f"UDP port {port} of {host} is not permitted; choose one of 1024 or above",
        }
        raise TransportError(known.get(error.errno or 0, f"cannot listen on {host} port {port}: {error}")) from error
    return opened


def _ask_for_stamps(opened: socket.socket) -> None:
    if _TIMESTAMPS is not None:
        with suppress(OSError):
            opened.setsockopt(socket.SOL_SOCKET, _TIMESTAMPS, 1)


def _port(port: object, *, given: bool = False) -> int:
    if not isinstance(port, int) or not int(given) <= port <= 65535:
        raise SessionError(f"port {port!r} is not a number from {int(given)} to 65535")
    return port


def _why(error: OSError) -> str:
    return errno.errorcode.get(error.errno or 0, "unknown")
