"""The server of the page: a thread with an event loop of its own, beside whatever moves the session."""

import asyncio
import contextlib
import logging
import secrets
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Final, final

from cotouch.errors import TransportError
from cotouch.web._access import Access
from cotouch.web._address import PageAddress

if TYPE_CHECKING:
    import uvicorn

    from cotouch.observers import SessionApi
    from cotouch.web._hub import Hub

_STATIC: Final = Path(__file__).parent / "static"
_START, _STOP = 60.0, 5.0  # patience; on a busy machine what is imported takes its time [s]
_GRACE: Final = 0.5  # for pages that take no more [s]
_PING: Final = 5.0  # a page that is gone without a word is noticed after about twice this [s]


@final
class PageServer:
    """Serves the page of a `SessionApi` until it is closed.

    Attributes:
        port: that it listens on.
        token: that lets a page act.
        local: whether only this machine can reach it.

    Examples:
        >>> with PageServer(stage) as server:  # doctest: +SKIP
        ...     print(server.url)
        http://127.0.0.1:8765/#token=...
    """

    def __init__(
        self,
        api: "SessionApi",
        *,
        at: PageAddress | None = None,
        listen: str = "127.0.0.1",
        port: int | None = None,
        token: str | None = None,
        static: Path | None = None,
    ) -> None:
        """Begins to serve; returns when the page can be opened.

        Args:
            api: what is shown; it is called from the server's thread.
            at: an address that was taken already; it is closed with the server. None: one is taken.
            listen: see `PageAddress`.
            port: see `PageAddress`.
            token: None: a new one.
            static: folder of the page's files; None: the one in the package.

        Raises:
            SessionError: the address or the port makes no sense.
            TransportError: the port is taken, or not allowed.
        """
        self._at = at or PageAddress(listen=listen, port=port)
        self._access = Access(listen=self._at.listen, token=token or secrets.token_urlsafe(24))
        self.token, self.port, self.local = self._access.token, self._at.port, self._at.local
        self._ready = threading.Event()
        self._closing = threading.Event()
        self._thread = threading.Thread(
            target=self._run, args=(api, static or _STATIC), name="cotouch-page", daemon=True
        )
        self._thread.start()
        if not self._ready.wait(_START):
            self.close()
            raise TransportError(f"the page's server did not come up within {_START:.0f} s")

    @property
    def address(self) -> str:
        """Where the page is, without the token: whoever opens it may watch."""
        return self._at.url

    @property
    def url(self) -> str:
        """Where the page is, with the token; whoever has this may act."""
        return f"{self.address}#token={self.token}"

    def ticket(self) -> str:
        """Leads to `url`, once; for the command line of a browser, which every user of this machine can read."""
        return f"{self.address}open?ticket={self._access.ticket()}"

    def close(self) -> None:
        """Stops within a second or so; may be called again."""
        self._closing.set()
        self._thread.join(_STOP)
        self._at.close()

    def __enter__(self) -> "PageServer":
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def _run(self, api: "SessionApi", static: Path) -> None:
        import uvicorn

        from cotouch.web._app import application
        from cotouch.web._connection import BoundedConnection
        from cotouch.web._hub import Hub
        from cotouch.web._protocol import MOST_BYTES

        # What goes wrong is told to the page that caused it; requests are not logged, because some carry the token.
        for name in ("uvicorn.error", "uvicorn.access"):
            logging.getLogger(name).setLevel(logging.CRITICAL)
        hub = Hub(api, self._access, address=self._at.elsewhere)
        config = uvicorn.Config(
            application(hub, self._access, static),
            loop="asyncio",
            http=BoundedConnection,
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
            timeout_graceful_shutdown=1,
        )
        server = uvicorn.Server(config)

        async def serve() -> None:
            announced = asyncio.create_task(self._announce(server, hub))
            await server.serve(sockets=[self._at.socket])
            announced.cancel()

        try:
            asyncio.run(serve())
        finally:
            hub.close()

    async def _announce(self, server: "uvicorn.Server", hub: "Hub") -> None:
        while not server.started and not self._closing.is_set():
            await asyncio.sleep(0.005)
        self._ready.set()
        while not self._closing.is_set():
            await asyncio.sleep(0.05)
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(hub.farewell(), _GRACE)
        server.should_exit = True
        await asyncio.sleep(_GRACE)
        server.force_exit = True
