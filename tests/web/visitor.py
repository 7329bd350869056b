"""A page without a browser."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from tests.web.reader import Picture, ack, read_frame
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from cotouch.web import PageServer

PATIENCE = 60.0
# What is waited for comes within a tenth of so many messages.
MOST = 600


class Visitor:
    """Reads what comes; acknowledges frames unless it is told not to."""

    def __init__(self, connection: ClientConnection) -> None:
        self.connection = connection
        self.acknowledge = True
        self.frames: list[Picture] = []
        self.texts: list[dict[str, Any]] = []

    def hello(self, **entries: Any) -> None:
        self.say({"type": "hello", "version": 3, "token": None, "slot": None, "want": "all", "rate": 60} | entries)

    def say(self, message: dict[str, Any] | bytes | str) -> None:
        self.connection.send(json.dumps(message) if isinstance(message, dict) else message)

    def next(self) -> Picture | dict[str, Any]:
        message = self.connection.recv(PATIENCE)
        if isinstance(message, bytes):
            picture = read_frame(message)
            self.frames.append(picture)
            if self.acknowledge:
                self.connection.send(ack(picture.number))
            return picture
        text = json.loads(message)
        self.texts.append(text)
        return text

    def until(self, true: Callable[[Any], bool], what: str) -> Any:
        for _ in range(MOST):
            message = self.next()
            if true(message):
                return message
        raise AssertionError(f"{what} did not come")

    def text(self, kind: str, true: Callable[[dict[str, Any]], bool] = lambda _: True) -> dict[str, Any]:
        return self.until(lambda m: isinstance(m, dict) and m["type"] == kind and true(m), kind)

    def frame(self, true: Callable[[Picture], bool] = lambda _: True) -> Picture:
        return self.until(lambda m: isinstance(m, Picture) and true(m), "a frame")

    def do(self, what: str, number: int = 1, **arguments: Any) -> dict[str, Any]:
        self.say({"type": "do", "id": number, "what": what} | arguments)
        return self.text("answer", lambda m: m["id"] == number)

    def closed(self) -> tuple[int, str]:
        """Reads to the end; code and reason."""
        with pytest.raises(ConnectionClosed) as ended:
            self.until(lambda _: False, "the end")
        received = ended.value.rcvd
        assert received is not None
        return received.code, received.reason


@contextmanager
def visit(server: PageServer, *, origin: str | None = "", hello: bool = True, **entries: Any) -> Iterator[Visitor]:
    own = server.address.rstrip("/")
    with connect(
        own.replace("http", "ws") + "/ws",
        origin=own if origin == "" else origin,
        compression=None,
        max_size=None,
        max_queue=None,
    ) as connection:
        visitor = Visitor(connection)
        if hello:
            visitor.hello(**({"token": server.token, "slot": 0} | entries))
        yield visitor
