"""Where a page is served: a port that is held from before there is anything to serve."""

import os
import socket
from typing import Final, final

from cotouch.errors import SessionError, TransportError
from cotouch.web._access import is_loopback

PORT: Final = 8765
_TRIED: Final = 20  # ports after the usual one, where that is taken
_QUEUE: Final = 128


@final
class PageAddress:
    """A port of this machine, reserved for a page; callers wait until a server answers.

    Attributes:
        listen: address of this machine.
        port: number.
        socket: that listens.
    """

    def __init__(self, *, listen: str = "127.0.0.1", port: int | None = None) -> None:
        """Takes it.

        Args:
            listen: address of this machine. Everything but loopback can be reached, and overheard, by others.
            port: 1 to 65535; 0: any. None: the usual one, or the next that is free.

        Raises:
            SessionError: the address or the port makes no sense.
            TransportError: the port is taken, or not allowed.
        """
        self.listen = listen
        self.socket = _bound(listen, port)
        self.port: int = self.socket.getsockname()[1]

    @property
    def url(self) -> str:
        """Of the page, without the token: whoever opens it may watch."""
        plain = self.listen.strip("[]")
        return self._at({"0.0.0.0": "127.0.0.1", "::": "::1"}.get(plain, plain))  # noqa: S104 - told, not bound

    @property
    def local(self) -> bool:
        """Whether only this machine can reach it."""
        return is_loopback(self.socket.getsockname()[0])

    @property
    def elsewhere(self) -> str | None:
        """Of the page as other devices find it, without the token; None if only this machine can reach it."""
        if self.local:
            return None
        everywhere = self.listen.strip("[]") in {"0.0.0.0", "::"}  # noqa: S104 - compared, not bound
        plain = _outward() if everywhere else self.listen.strip("[]")
        return None if plain is None else self._at(plain)

    def _at(self, plain: str) -> str:
        return f"http://{f'[{plain}]' if ':' in plain else plain}:{self.port}/"

    def close(self) -> None:
        """Gives the port back."""
        self.socket.close()


def _outward() -> str | None:
    """The address by which this machine reaches others; nothing is sent to find it."""
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.connect(("192.0.2.1", 9))  # an address of documentation (RFC 5737)
            return str(probe.getsockname()[0])
    except OSError:
        return None


def _bound(listen: str, port: int | None) -> socket.socket:
    """A socket that listens."""
    if port is not None and not 0 <= port <= 65_535:
        raise SessionError(f"the page's port is {port}; it must be from 0 to 65535")
    try:
        found = socket.getaddrinfo(listen.strip("[]"), None, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
    except (OSError, UnicodeError) as error:
        raise SessionError(f'the page\'s address is "{listen}"; it must be an address of this machine') from error
    tried = [PORT + k for k in range(_TRIED)] if port is None else [port]
    reason = ""
    for number in tried:
        # With its protocol named: only then asyncio sends at once what is written to connections that come of it, and a
        # frame after a shorter message does not lie until the browser has acknowledged that one.
        made = socket.socket(found[0], socket.SOCK_STREAM, socket.IPPROTO_TCP)
        try:
            if os.name == "posix":  # elsewhere it would let two servers share a port
                made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            made.bind((found[4][0], number))
            made.listen(_QUEUE)
        except OSError as error:
            made.close()
            reason = error.strerror or str(error)
        else:
            made.setblocking(False)
            return made
    asked = f"port {tried[0]} of {listen} is not available"
    if len(tried) > 1:
        asked = f"none of the ports {tried[0]} to {tried[-1]} of {listen} is available"
    raise TransportError(f"{asked} for the page ({reason}); give another with --port")
