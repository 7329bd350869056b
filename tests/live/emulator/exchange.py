"""A relay as a process, and a control plane of the tests that goes through it.

    python exchange.py HOST PORT

Each member says its public key, 32 bytes, and then frames of length u16, kind u8 and the other's key; they are handed
on with the sender's. What a member does not read in time is thrown away.
"""

import selectors
import socket
import struct
import sys
import time

from cotouch.control import Relayed, SignedMessage
from cotouch.samples import Identity

FRAME = struct.Struct(">HB32s")
MESSAGE, RELAY = 0, 1
MOST_WAITING = 1 << 16


def frames(buffer: bytearray) -> list[tuple[int, bytes, bytes]]:
    """Takes the whole frames from a buffer: kind, key, body."""
    out = []
    while len(buffer) >= FRAME.size:
        size, kind, key = FRAME.unpack_from(buffer)
        if len(buffer) < FRAME.size + size:
            break
        out.append((kind, key, bytes(buffer[FRAME.size : FRAME.size + size])))
        del buffer[: FRAME.size + size]
    return out


class Line:
    """One end of a connection that is never waited for."""

    def __init__(self, connection: socket.socket) -> None:
        connection.setblocking(False)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.connection = connection
        self.incoming, self.outgoing = bytearray(), bytearray()
        self.key = b""

    def put(self, kind: int, key: bytes, body: bytes) -> bool:
        if len(self.outgoing) > MOST_WAITING:
            return False
        self.outgoing += FRAME.pack(len(body), kind, key) + body
        self.flush()
        return True

    def flush(self) -> None:
        try:
            while self.outgoing:
                del self.outgoing[: self.connection.send(self.outgoing)]
        except (BlockingIOError, BrokenPipeError, ConnectionResetError):
            return

    def get(self) -> bool:
        """Reads what is there; False: the other end is gone."""
        try:
            while True:
                read = self.connection.recv(1 << 16)
                if not read:
                    return False
                self.incoming += read
        except BlockingIOError:
            return True
        except ConnectionResetError:
            return False


class TcpControl:
    """A `ControlPlane` through the exchange; without files, liveliness and signatures."""

    def __init__(self, identity: Identity, at: tuple[str, int]) -> None:
        self.identity = identity
        connection = socket.create_connection(at, timeout=20)
        connection.sendall(identity.public)
        self._line = Line(connection)
        self._said: list[SignedMessage] = []
        self._relayed: list[Relayed] = []

    def _read(self) -> None:
        self._line.flush()
        self._line.get()
        for kind, key, body in frames(self._line.incoming):
            if kind == RELAY:
                self._relayed.append(Relayed(body, key, time.monotonic()))
            else:
                topic, _, said = body.partition(b"\0")
                self._said.append(SignedMessage(key, topic.decode(), said, True))

    def send(self, topic: str, body: bytes, *, to: bytes | None = None) -> None:
        assert to is not None
        self._line.put(MESSAGE, to, topic.encode() + b"\0" + body)

    def poll(self) -> list[SignedMessage]:
        self._read()
        out, self._said = self._said, []
        return out

    def present(self) -> frozenset[bytes]:
        raise NotImplementedError

    def offer(self, content: bytes) -> bytes:
        raise NotImplementedError

    def fetch(self, digest: bytes) -> bytes | None:
        raise NotImplementedError

    def relay(self, to: bytes, payload: bytes) -> bool:
        return self._line.put(RELAY, to, payload)

    def relayed(self) -> list[Relayed]:
        self._read()
        out, self._relayed = self._relayed, []
        return out

    def close(self) -> None:
        self._line.connection.close()


def main(host: str, port: int) -> None:
    selector, members = selectors.DefaultSelector(), dict[bytes, Line]()
    listening = socket.create_server((host, port))
    selector.register(listening, selectors.EVENT_READ)
    selector.register(sys.stdin, selectors.EVENT_READ)
    print("ready", flush=True)
    while True:
        for key, _ in selector.select(0.05):
            if key.fileobj is sys.stdin:
                return
            if key.fileobj is listening:
                line = Line(listening.accept()[0])
                selector.register(line.connection, selectors.EVENT_READ, line)
                continue
            line: Line = key.data
            if not line.get():
                selector.unregister(line.connection)
                members.pop(line.key, None)
                continue
            if not line.key and len(line.incoming) >= 32:
                line.key = bytes(line.incoming[:32])
                del line.incoming[:32]
                members[line.key] = line
            for kind, to, body in frames(line.incoming) if line.key else ():
                if to in members:
                    members[to].put(kind, line.key, body)
        for line in members.values():
            line.flush()


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
