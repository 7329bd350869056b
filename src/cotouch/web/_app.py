"""What the server answers: the page's files, a recording, a QR code, and the page's WebSocket."""

import asyncio
import hashlib
import io
from pathlib import Path
from typing import TYPE_CHECKING, Final, final

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response, StreamingResponse
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from cotouch.errors import PageError
from cotouch.web._access import HEADERS, Access
from cotouch.web._archive import zipped
from cotouch.web._hub import Hub
from cotouch.web._page import Page
from cotouch.web._protocol import FrameReceipt, Hello, read_binary, read_text

if TYPE_CHECKING:
    from starlette.types import ASGIApp, Message, Receive, Scope, Send

_KINDS: Final = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".json": "application/json",
    ".txt": "text/plain; charset=utf-8",
}
_FIRST_WORD: Final = 5.0  # a connection that says nothing for so long is no page [s]
_BAD, _LATER = 1008, 1013
_MOST_REASON: Final = 120  # bytes; a close frame has 123
_STUCK: Final = 1.0  # a page that takes no more is not waited for longer [s]


def application(hub: Hub, access: Access, static: Path) -> "ASGIApp":
    """The whole, behind its guard.

    Args:
        hub: that pages talk to.
        access: who is let in.
        static: folder of the page's files.
    """
    routes = _Routes(hub, access, static)
    app = Starlette(
        routes=[
            WebSocketRoute("/ws", routes.socket),
            Route("/recording.zip", routes.recording, methods=["GET"]),
            Route("/qr.svg", routes.qr, methods=["GET"]),
            Route("/open", routes.open, methods=["GET"]),
            Route("/", routes.file, methods=["GET"]),
            Route("/{name}", routes.file, methods=["GET"]),
        ]
    )
    return _Guard(app, access)


@final
class _Guard:
    """Refuses whoever calls the server by a foreign name or comes from a foreign page; adds headers to the rest."""

    def __init__(self, app: "ASGIApp", access: Access) -> None:
        self._app, self._access = app, access

    async def __call__(self, scope: "Scope", receive: "Receive", send: "Send") -> None:
        if scope["type"] not in {"http", "websocket"}:
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        host, server = headers.get("host"), scope.get("server")
        reason: str | None = None
        if not self._access.host_allowed(host, None if server is None else str(server[0])):
            reason = "this server does not answer to that name; use the address that cotouch printed"
        elif not self._access.origin_allowed(headers.get("origin"), host, needed=scope["type"] == "websocket"):
            reason = "only the server's own page may connect to it"

        async def send_guarded(message: "Message") -> None:
            if message["type"] in {"http.response.start", "websocket.http.response.start"}:
                added = MutableHeaders(scope=message)
                for name, value in HEADERS:
                    added[name] = value
            await send(message)

        if reason is not None:
            refusal = PlainTextResponse(f"{reason}\n", 403)
            await refusal(scope, receive, send_guarded)
            return
        await self._app(scope, receive, send_guarded)


@final
class _Routes:
    def __init__(self, hub: Hub, access: Access, static: Path) -> None:
        self._hub, self._access, self._static = hub, access, static

    async def file(self, request: Request) -> Response:
        """A file of the page, by its plain name."""
        name = request.path_params.get("name", "index.html")
        path = self._static / name
        if not (name[:1] != "." and path.suffix in _KINDS and name in {file.name for file in self._static.iterdir()}):
            return PlainTextResponse("there is no such file\n", 404)
        content = path.read_bytes()
        tag = f'"{hashlib.sha256(content).hexdigest()[:32]}"'
        headers = {"ETag": tag, "Cache-Control": "no-cache"}
        if request.headers.get("if-none-match") == tag:
            return Response(status_code=304, headers=headers)
        return Response(content, media_type=_KINDS[path.suffix], headers=headers)

    async def open(self, request: Request) -> Response:
        """Leads to the page, with the token if there is a good ticket."""
        good = self._access.redeemed(request.query_params.get("ticket"))
        headers = {"Location": f"/#token={self._access.token}" if good else "/", "Cache-Control": "no-store"}
        return Response(status_code=303, headers=headers)

    async def recording(self, request: Request) -> Response:
        """The last recording."""
        if not self._access.token_right(request.query_params.get("token")):
            return _no_token()
        if request.method == "HEAD":  # asked whether it is there, before it is fetched
            state = (await run_in_threadpool(self._hub.api.overview)).recording.state
            return Response(status_code=200 if state == "done" else 404, headers={"Cache-Control": "no-store"})
        try:
            paths = await run_in_threadpool(self._hub.api.recorded)
            pieces = await run_in_threadpool(zipped, paths)
        except OSError as error:
            return PlainTextResponse(f"the recording cannot be read: {error.strerror or error}\n", 500)
        if not paths:
            return PlainTextResponse("nothing has been recorded yet\n", 404)
        headers = {"Content-Disposition": 'attachment; filename="cotouch-recording.zip"', "Cache-Control": "no-store"}
        return StreamingResponse(pieces, media_type="application/zip", headers=headers)

    async def qr(self, request: Request) -> Response:
        """The page's address, as a picture that opens it on a phone; whoever scans it may act."""
        if not self._access.token_right(request.query_params.get("token")):
            return _no_token()
        address, user = self._hub.address, request.query_params.get("user", "1")
        if address is None:
            return PlainTextResponse("only this computer can open the page; to change that, use --page-listen\n", 404)
        if user not in {str(number + 1) for number in range(len(self._hub.scene.users))}:
            return PlainTextResponse("there is no such user\n", 404)
        import segno

        picture = io.BytesIO()
        code = segno.make_qr(f"{address}?user={user}#token={self._access.token}", error="l")
        code.save(picture, kind="svg", border=4, light="#fff", xmldecl=False)
        return Response(picture.getvalue(), media_type="image/svg+xml", headers={"Cache-Control": "no-store"})

    async def socket(self, socket: WebSocket) -> None:
        """A page, from its first word to its last."""
        hub, page = self._hub, Page(socket)
        await socket.accept()
        if not hub.enter(page):
            await socket.close(_LATER, "too many pages are still connecting; try again in a moment")
            return
        sender = asyncio.create_task(page.send_all())
        refusal: str | None = None
        try:
            await self._listen(socket, page)
        except PageError as error:
            refusal = str(error)
        except (TimeoutError, WebSocketDisconnect) as error:
            refusal = "no hello arrived in time" if isinstance(error, TimeoutError) else None
        finally:
            hub.leave(page)
            sender.cancel()
            await asyncio.gather(sender, return_exceptions=True)
        if refusal is not None:
            await _refuse(socket, refusal, told=page.hello is None)

    async def _listen(self, socket: WebSocket, page: Page) -> None:
        hub, clock = self._hub, asyncio.get_running_loop().time
        while True:
            waiting = socket.receive()
            message = await (waiting if page.hello is not None else asyncio.wait_for(waiting, _FIRST_WORD))
            if message["type"] != "websocket.receive":
                return
            hub.received(page)
            data, text = message.get("bytes"), message.get("text")
            if data is not None:
                if not page.binary.take(clock()):
                    raise PageError("too many messages: a page may send about 2,000 a second")
                read = read_binary(data)
                if page.hello is None:
                    raise PageError("the first message must be a hello")
                if isinstance(read, FrameReceipt):
                    hub.acknowledged(page, read)
                else:
                    hub.pointed(page, read)
            elif text is not None:
                if not page.text.take(clock()):
                    raise PageError("too many messages: a page may send about 100 commands a second")
                asked = read_text(text)
                if isinstance(asked, Hello):
                    hub.hello(page, asked)
                elif page.hello is None:
                    raise PageError("the first message must be a hello")
                else:
                    hub.asked(page, asked)


def _no_token() -> Response:
    return PlainTextResponse("the token is missing or wrong; open the address that cotouch printed\n", 403)


async def _refuse(socket: WebSocket, reason: str, *, told: bool) -> None:
    """Says why, and closes; one that takes no more is left to the end of its connection."""
    short = reason.encode(errors="replace")[:_MOST_REASON].decode(errors="ignore")

    async def say() -> None:
        if told:
            await socket.send_json({"type": "error", "text": reason})
        await socket.close(_BAD, short)

    try:
        await asyncio.wait_for(say(), _STUCK)
    except (TimeoutError, WebSocketDisconnect, RuntimeError):
        return
