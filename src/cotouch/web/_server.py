"""The server of the page: a thread with an event loop of its own, beside whatever moves the session."""

import asyncio
import logging
import os
import secrets
import socket
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Final, final

from cotouch.errors import SessionError, TransportError

if TYPE_CHECKING:
    import uvicorn

    from cotouch.session import Stage

PORT: Final = 8765
_TRIED: Final = 20  # ports after the usual one, where that is taken
_STATIC: Final = Path(__file__).parent / "static"
_START, _STOP = 10.0, 5.0  # patience [s]
_GRACE: Final = 0.5  # for pages that take no more [s]
_PING: Final = 5.0  # a page that is gone without a word is noticed after about twice this [s]


@final
class PageServer:
    """Serves the page of a stage until it is closed.

    Attributes:
        listen: address that it listens on.
        port: that it listens on.
        token: that lets a page act.

    Examples:
        >>> with PageServer(stage) as server:  # doctest: +SKIP
        ...     print(server.url)
        http://127.0.0.1:8765/#token=...
    """

    def __init__(
        self,
        stage: "Stage",
        *,
        listen: str = "127.0.0.1",
        port: int | None = None,
        token: str | None = None,
        static: Path | None = None,
    ) -> None:
        """Takes a port and begins to serve; returns when the page can be opened.

        Args:
            stage: what is shown; it is called from the server's thread.
            listen: address of this machine. Everything but loopback can be reached, and overheard, by others.
            port: 1 to 65535; 0: any. None: the usual one, or the next that is free.
            token: None: a new one.
            static: folder of the page's files; None: the one in the package.

        Raises:
            SessionError: the address or the port makes no sense.
            TransportError: the port is taken, or not allowed.
        """
        self.token = secrets.token_urlsafe(24) if token is None else token
        self.listen = listen
        self._socket = _bound(listen, port)
        self.port: int = self._socket.getsockname()[1]
        self._ready = threading.Event()
        self._server: uvicorn.Server | None = None
        self._thread = threading.Thread(
            target=self._run, args=(stage, static or _STATIC), name="cotouch-page", daemon=True
        )
        self._thread.start()
        if not self._ready.wait(_START):
            self.close()
            raise TransportError(f"the page's server did not come up within {_START:.0f} s")

    @property
    def address(self) -> str:
        """Where the page is, without the token: whoever opens it may watch."""
        plain = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(self.listen, self.listen)  # noqa: S104 - told, not bound
        return f"http://{f'[{plain}]' if ':' in plain else plain}:{self.port}/"

    @property
    def url(self) -> str:
        """Where the page is, with the token; whoever has this may act."""
        return f"{self.address}#token={self.token}"

    @property
    def local(self) -> bool:
        """Whether only this machine can reach it."""
        return _loopback(self.listen)

    def close(self) -> None:
        """Stops within a second or so; may be called again."""
        if self._server is not None:
            self._server.should_exit = True
        self._thread.join(_STOP)
        self._socket.close()

    def __enter__(self) -> "PageServer":
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def _run(self, stage: "Stage", static: Path) -> None:
        import uvicorn

        from cotouch.web._access import Access
        from cotouch.web._app import application
        from cotouch.web._hub import Hub
        from cotouch.web._protocol import MOST_BYTES

        # What goes wrong is told to the page that caused it; requests are not logged, because some carry the token.
        for name in ("uvicorn.error", "uvicorn.access"):
            logging.getLogger(name).setLevel(logging.CRITICAL)
        access = Access(listen=self.listen, token=self.token)
        hub = Hub(stage, access)
        config = uvicorn.Config(
            application(hub, access, static),
            loop="asyncio",
            http="h11",
            ws="websockets-sansio",
            ws_max_size=MOST_BYTES,
            ws_per_message_deflate=False,
            ws_ping_interval=_PING,
            ws_ping_timeout=_PING,
            lifespan="off",
            log_config=None,
            access_log=False,
            proxy_headers=False,
            server_header=False,
            limit_concurrency=64,
            timeout_graceful_shutdown=1,
        )
        self._server = server = uvicorn.Server(config)

        async def serve() -> None:
            announced = asyncio.create_task(self._announce(server))
            await server.serve(sockets=[self._socket])
            announced.cancel()

        try:
            asyncio.run(serve())
        finally:
            hub.close()

    async def _announce(self, server: "uvicorn.Server") -> None:
        while not server.started:
            await asyncio.sleep(0.005)
        self._ready.set()
        while not server.should_exit:
            await asyncio.sleep(0.05)
        await asyncio.sleep(_GRACE)
        server.force_exit = True


def _loopback(listen: str) -> bool:
    from cotouch.web._access import LOOPBACK

    return listen.strip("[]") in LOOPBACK or listen.startswith("127.")


def _bound(listen: str, port: int | None) -> socket.socket:
    """A socket that listens."""
    if port is not None and not 0 <= port <= 65_535:
        raise SessionError(f"the page's port is {port}; it must be from 0 to 65535")
    plain = listen.strip("[]")
    try:
        found = socket.getaddrinfo(plain, None, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
    except (OSError, UnicodeError) as error:
        raise SessionError(f'the page\'s address is "{listen}"; it must be an address of this machine') from error
    tried = [PORT + k for k in range(_TRIED)] if port is None else [port]
    reason = ""
    for number in tried:
        made = socket.socket(found[0], socket.SOCK_STREAM)
        try:
            if os.name == "posix":  # elsewhere it would let two servers share a port
                made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            made.bind((found[4][0], number))
            made.listen(128)
        except OSError as error:
            made.close()
            reason = error.strerror or str(error)
        else:
            made.setblocking(False)
            return made
    asked = f"port {tried[0]}" if len(tried) == 1 else f"none of the ports {tried[0]} to {tried[-1]}"
    wrong = f"{asked} of {listen} can be had" if len(tried) > 1 else f"{asked} of {listen} cannot be had"
    raise TransportError(f"{wrong} for the page ({reason}); give another with --port")
