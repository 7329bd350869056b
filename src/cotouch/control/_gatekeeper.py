"""The process that takes connections for a control plane; only those of the invited reach Zenoh.

    python _gatekeeper.py      with its orders as one line of JSON on its input; ends with its input

It imports nothing of this package: it starts in a tenth of a second and shares no interpreter with the haptic loop.
"""

import asyncio
import contextlib
import json
import os
import random
import socket
import ssl
import sys
from collections import defaultdict
from typing import TypedDict, final

# Unfinished handshakes of one source and of all; beyond it one of the source that has most is dropped, at random, so
# that nobody can time who it will be.
_OF_ONE = 16
_OF_ALL = 64
# TLS takes one way there and back, of up to 2 s in the paper's network, and its loss once [s].
_HANDSHAKE = 6.0
# Connections of the invited at a time; a session has far fewer members.
_MOST_LINKS = 1024
_CHUNK = 1 << 18
# For what was said last to go out, once whoever ordered this has closed its session [s].
_FAREWELL = 1.0
# Strangers get the processor time that the haptic loop leaves.
_NICENESS = 10


@final
class Gatekeeper:
    """Takes connections, lets TLS say who was invited, and hands what they say on."""

    def __init__(self, inner: tuple[str, int], outside: ssl.SSLContext, inside: ssl.SSLContext) -> None:
        """Prepares it.

        Args:
            inner: where Zenoh listens on this machine.
            outside: asks for certificates of the invited.
            inside: with which Zenoh takes this process for one of them.
        """
        self._inner, self._outside, self._inside = inner, outside, inside
        self._unfinished: dict[str, set[asyncio.Task[None]]] = defaultdict(set)
        self._links = set[asyncio.Task[None]]()
        self._draw = random.SystemRandom()

    async def listen(self, listening: socket.socket) -> None:
        """Takes connections for ever."""
        loop = asyncio.get_running_loop()
        listening.setblocking(False)
        while True:
            try:
                taken, address = await loop.sock_accept(listening)
            except OSError:  # none of ours: reset before it was taken, or no file descriptor is left for now
                await asyncio.sleep(0.01)
                continue
            source = _source(address[0])
            self._make_room(source)
            task = loop.create_task(self._let_in(taken, source))
            self._unfinished[source].add(task)

    async def finish(self) -> None:
        """Waits until all links have ended by themselves, which they do when Zenoh closes them; not for long."""
        if self._links:
            await asyncio.wait(self._links, timeout=_FAREWELL)

    def _make_room(self, source: str) -> None:
        count = sum(map(len, self._unfinished.values()))
        if len(self._unfinished.get(source, ())) < _OF_ONE:
            if count < _OF_ALL:
                return
            source = max(self._unfinished, key=lambda one: len(self._unfinished[one]))
        task = self._draw.choice(list(self._unfinished[source]))
        self._finish(task, source)
        task.cancel()

    def _finish(self, task: asyncio.Task[None], source: str) -> None:
        self._unfinished[source].discard(task)
        if not self._unfinished[source]:
            del self._unfinished[source]

    async def _let_in(self, taken: socket.socket, source: str) -> None:
        task = asyncio.current_task()
        assert task is not None
        loop = asyncio.get_running_loop()
        reader = asyncio.StreamReader(limit=_CHUNK)
        protocol = asyncio.StreamReaderProtocol(reader)
        transport: asyncio.Transport | None = None
        try:
            async with asyncio.timeout(_HANDSHAKE):
                transport, _ = await loop.connect_accepted_socket(
                    lambda: protocol, taken, ssl=self._outside, ssl_handshake_timeout=_HANDSHAKE
                )
        except (OSError, TimeoutError):  # of ssl.SSLError, too
            return
        finally:
            self._finish(task, source)
            if transport is None:  # refused, too late, or dropped for another
                taken.close()
        assert transport is not None
        if len(self._links) >= _MOST_LINKS:
            transport.abort()
            return
        self._links.add(task)
        try:
            await self._hand_on(reader, asyncio.StreamWriter(transport, protocol, reader, loop))
        finally:
            self._links.discard(task)
            transport.abort()

    async def _hand_on(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with contextlib.suppress(OSError):
            there, back = await asyncio.open_connection(*self._inner, ssl=self._inside, limit=_CHUNK)
            paths = {asyncio.ensure_future(_pour(reader, back)), asyncio.ensure_future(_pour(there, writer))}
            try:
                await asyncio.wait(paths, return_when=asyncio.FIRST_COMPLETED)
                with contextlib.suppress(OSError, TimeoutError):  # what was said last still goes out
                    async with asyncio.timeout(1.0):
                        await asyncio.gather(writer.drain(), back.drain())
                        writer.close()
                        await writer.wait_closed()
            finally:
                for path_state in paths:
                    path_state.cancel()
                back.transport.abort()


async def _pour(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    with contextlib.suppress(OSError):
        while said := await reader.read(_CHUNK):
            writer.write(said)
            await writer.drain()


def _source(host: str) -> str:
    """What strangers of one origin have in common: an IPv4 address, or a network of IPv6, of which anybody has many."""
    packed = socket.inet_pton(socket.AF_INET6 if ":" in host else socket.AF_INET, host.partition("%")[0])
    return host if len(packed) == 4 or packed[:12] == bytes(10) + b"\xff\xff" else packed[:8].hex()


def _context(purpose: ssl.Purpose, given: "_Orders") -> ssl.SSLContext:
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER if purpose is ssl.Purpose.CLIENT_AUTH else ssl.PROTOCOL_TLS_CLIENT)
    context.minimum_version = ssl.TLSVersion.TLSv1_3
    context.check_hostname = False  # certificates say "was invited"; they name no machine
    context.verify_mode = ssl.CERT_REQUIRED
    context.load_verify_locations(cadata=given["authority"])
    # OpenSSL's binding reads keys from files only; this one is in memory.
    kept = os.memfd_create("certificate")
    try:
        os.write(kept, (given["certificate"] + given["key"]).encode())
        context.load_cert_chain(f"/proc/self/fd/{kept}")
    finally:
        os.close(kept)
    return context


class _Orders(TypedDict):
    """What the process is told when it starts."""

    authority: str
    certificate: str
    key: str
    inner: tuple[str, int]
    listening: list[int]


async def _main(given: _Orders) -> None:
    host, port = given["inner"]
    keeper = Gatekeeper(
        (host, port), _context(ssl.Purpose.CLIENT_AUTH, given), _context(ssl.Purpose.SERVER_AUTH, given)
    )
    loop, ending = asyncio.get_running_loop(), asyncio.Event()

    def over() -> None:
        loop.remove_reader(sys.stdin.fileno())
        ending.set()

    # Whoever ordered this is gone when its end of the pipe is, however it ended.
    loop.add_reader(sys.stdin.fileno(), over)
    doors = [socket.socket(fileno=number) for number in given["listening"]]
    listening = asyncio.gather(*map(keeper.listen, doors))
    waiting = asyncio.ensure_future(ending.wait())
    await asyncio.wait([listening, waiting], return_when=asyncio.FIRST_COMPLETED)
    if ending.is_set():
        listening.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await listening
        for door in doors:  # whoever was killed may start again at once, on the same port
            door.close()
        await keeper.finish()
    os._exit(0)


if __name__ == "__main__":
    os.nice(_NICENESS)
    asyncio.run(_main(json.loads(sys.stdin.buffer.readline())))
