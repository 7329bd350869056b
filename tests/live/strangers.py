"""Strangers at a member's port, from several addresses of this machine: whoever is sent away comes back at once.

python tests/live/strangers.py PORT KIND COUNT SOURCES      one line when all were there once; ends with its input

Kinds: silent ones say nothing, dripping ones a byte now and then, noisy ones what is no TLS, and uninvited ones shake
hands in TLS and are refused.
"""

import asyncio
import contextlib
import os
import ssl
import sys
from collections import Counter
from collections.abc import Iterator


@contextlib.contextmanager
def refused() -> Iterator[None]:
    with contextlib.suppress(OSError, asyncio.IncompleteReadError):  # of ssl.SSLError, too
        yield


class Strangers:
    def __init__(self, port: int, kind: str, sources: int) -> None:
        self.port, self.kind, self.sources = port, kind, sources
        self.came = Counter[int]()
        self.context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
        self.context.check_hostname, self.context.verify_mode = False, ssl.CERT_NONE

    async def one(self, number: int) -> None:
        while True:
            with refused():
                await self.call(number, f"127.0.7.{1 + number % self.sources}" if self.sources else "127.0.0.1")
            self.came[number] += 1
            await asyncio.sleep(0.05)

    async def call(self, number: int, source: str) -> None:
        context = self.context if self.kind == "uninvited" else None
        reader, writer = await asyncio.open_connection("127.0.0.1", self.port, ssl=context, local_addr=(source, 0))
        self.came[number] += 1
        try:
            if self.kind == "noisy":
                writer.write(b"GET / HTTP/1.1\r\n\r\n")
            if self.kind == "dripping":
                for byte in b"\x16\x03\x01\x01\x00":
                    writer.write(bytes([byte]))
                    await asyncio.sleep(0.5)
            await reader.readexactly(1)
        finally:
            writer.transport.abort()


async def main(port: int, kind: str, count: int, sources: int) -> None:
    strangers = Strangers(port, kind, sources)
    asyncio.get_running_loop().add_reader(sys.stdin.fileno(), lambda: os._exit(0))
    tasks = [asyncio.create_task(strangers.one(number)) for number in range(count)]
    while len(strangers.came) < count:
        await asyncio.sleep(0.02)
    print("there", flush=True)
    await asyncio.gather(*tasks)


if __name__ == "__main__":
    asyncio.run(main(int(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4])))
