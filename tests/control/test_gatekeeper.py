"""The process that takes connections, without its process: whom it drops, and who stays."""

import asyncio
import os
import socket
import ssl
from collections.abc import Awaitable, Callable

import pytest
from tests.control.inside import Gatekeeper, keep_gate, tls_context
from tests.live.support import entropy, identities

from cotouch.control import Endpoint, Invitation, make_certificates

PATIENCE = 30.0


def given() -> dict[str, str]:
    made = Invitation.make(
        session="gate",
        host=identities(1)[0].public,
        digest=bytes(32),
        endpoints=(Endpoint("127.0.0.1", 7000),),
        entropy=entropy(1),
    )
    return {name: value.decode() for name, value in make_certificates(made, entropy=os.urandom)._asdict().items()}


class Door:
    """A gatekeeper that listens, before one who echoes what the invited say; and strangers, who say nothing."""

    def __init__(self, port: int) -> None:
        self.port = port
        self._strangers: dict[str, list[tuple[asyncio.Task[bytes], asyncio.StreamWriter]]] = {}

    async def crowd(self, count: int, source: str) -> None:
        """So many connections of a source that begin no handshake."""
        for _ in range(count):
            reader, writer = await asyncio.open_connection("127.0.0.1", self.port, local_addr=(source, 0))
            waiting = asyncio.create_task(_read(reader))
            self._strangers.setdefault(source, []).append((waiting, writer))

    def left(self, source: str) -> int:
        """How many of them were not dropped."""
        return sum(not waiting.done() for waiting, _ in self._strangers[source])

    async def until(self, done: Callable[[], bool]) -> None:
        async with asyncio.timeout(PATIENCE):
            while not done():
                await asyncio.sleep(0.01)
        await asyncio.sleep(0.05)  # and nobody else goes

    async def invited(self, source: str) -> bytes:
        """What one of the invited hears of the echo."""
        context = tls_context(ssl.Purpose.SERVER_AUTH, given())
        reader, writer = await asyncio.open_connection("127.0.0.1", self.port, ssl=context, local_addr=(source, 0))
        writer.write(b"hello")
        said = await reader.readexactly(5)
        writer.transport.abort()
        return said

    def close(self) -> None:
        for waiting, writer in [one for many in self._strangers.values() for one in many]:
            waiting.cancel()
            writer.transport.abort()


async def _read(reader: asyncio.StreamReader) -> bytes:
    try:
        return await reader.read(1)
    except ConnectionError:
        return b""


def at_the_door(play: Callable[[Door], Awaitable[None]]) -> None:
    async def run() -> None:
        async def echo(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            writer.write(await reader.readexactly(5))

        ours = given()
        outside, inside = (tls_context(one, ours) for one in (ssl.Purpose.CLIENT_AUTH, ssl.Purpose.SERVER_AUTH))
        server = await asyncio.start_server(echo, "127.0.0.1", 0, ssl=tls_context(ssl.Purpose.CLIENT_AUTH, ours))
        keeper = Gatekeeper(server.sockets[0].getsockname(), outside, inside)
        with socket.create_server(("127.0.0.1", 0), backlog=1024) as listening:
            task = asyncio.create_task(keeper.listen(listening))
            door = Door(listening.getsockname()[1])
            try:
                await play(door)
            finally:
                door.close()
                task.cancel()
                server.close()
                await keeper.finish()
                unfinished = asyncio.all_tasks() - {asyncio.current_task()}
                for waiting in unfinished:
                    waiting.cancel()
                await asyncio.gather(*unfinished, return_exceptions=True)
                await asyncio.sleep(0.05)

    asyncio.run(run())


@pytest.fixture(autouse=True)
def nothing_ends_by_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cotouch.control._gatekeeper._HANDSHAKE", 600.0)


def test_its_port_is_free_as_soon_as_its_member_is_gone_though_links_still_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """Who was killed starts again at once, on the port of its invitation."""
    monkeypatch.setattr("cotouch.control._gatekeeper._FAREWELL", 600.0)
    orders, member = os.pipe()

    async def play() -> None:
        async def talk(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            writer.write(await reader.readexactly(5))
            await reader.read()

        ours = given()
        context = tls_context(ssl.Purpose.CLIENT_AUTH, ours)
        server = await asyncio.start_server(talk, "127.0.0.1", 0, ssl=context)
        listening = socket.create_server(("127.0.0.1", 0))
        port = listening.getsockname()[1]
        said = {**ours, "inner": server.sockets[0].getsockname(), "listening": [listening.detach()]}
        keeping = asyncio.create_task(keep_gate(said))
        reader, writer = await asyncio.open_connection(
            "127.0.0.1", port, ssl=tls_context(ssl.Purpose.SERVER_AUTH, given())
        )
        writer.write(b"hello")
        assert await reader.readexactly(5) == b"hello"
        os.close(member)
        async with asyncio.timeout(PATIENCE):
            while not _is_free(port):
                await asyncio.sleep(0.01)
        assert not keeping.done()
        keeping.cancel()
        writer.transport.abort()
        server.close()
        await asyncio.gather(keeping, return_exceptions=True)
        await asyncio.sleep(0.05)

    with os.fdopen(orders, "rb") as end:
        monkeypatch.setattr("sys.stdin", end)
        asyncio.run(play())


def _is_free(port: int) -> bool:
    try:
        socket.create_server(("127.0.0.1", port)).close()
    except OSError:
        return False
    return True


def test_of_300_half_open_connections_of_one_source_16_stay_and_others_lose_none() -> None:
    async def play(door: Door) -> None:
        await door.crowd(10, "127.0.0.2")
        await door.crowd(300, "127.0.0.1")
        await door.until(lambda: door.left("127.0.0.1") <= 16)
        assert (door.left("127.0.0.1"), door.left("127.0.0.2")) == (16, 10)
        assert await door.invited("127.0.0.3") == b"hello"
        assert (door.left("127.0.0.1"), door.left("127.0.0.2")) == (16, 10)

    at_the_door(play)


def test_of_many_sources_64_stay_and_the_greediest_loses() -> None:
    async def play(door: Door) -> None:
        await door.crowd(3, "127.0.0.2")
        for source in range(10, 20):
            await door.crowd(12, f"127.0.0.{source}")
        crowds = [f"127.0.0.{source}" for source in range(10, 20)]

        def left() -> int:
            return sum(map(door.left, crowds))

        await door.until(lambda: left() <= 61)
        assert left() == 61
        assert door.left("127.0.0.2") == 3
        assert await door.invited("127.0.0.3") == b"hello"

    at_the_door(play)


def test_a_handshake_that_takes_too_long_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cotouch.control._gatekeeper._HANDSHAKE", 0.2)
    at_the_door(_slow)


async def _slow(door: Door) -> None:
    await door.crowd(5, "127.0.0.1")
    await door.until(lambda: door.left("127.0.0.1") == 0)
