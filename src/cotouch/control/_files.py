"""Files by their hash over Zenoh: whoever has one serves it, in chunks; threads of its own do the waiting."""

import hashlib
import struct
import threading
from collections import Counter, deque
from queue import SimpleQueue
from typing import TYPE_CHECKING, Protocol, final

from cotouch.errors import SessionError

if TYPE_CHECKING:
    import zenoh

MOST_FILE = 256 << 20
_CHUNK = 256 << 10
# So many chunks are asked for at a time: a path of 100 ms then carries 10 MB/s.
_AHEAD = 4
_MOST_WANTED = 64
_MOST_QUERIES = 256
# A chunk over a wire of 0.25 Mbit/s.
_CHUNK_TIMEOUT = 10.0
_ASK_TIMEOUT = 2.0
_AGAIN = 0.5
_SIZE = struct.Struct(">Q")


class _Query(Protocol):
    """What is used of a question, of whose `reply` Zenoh does not say that it returns nothing."""

    @property
    def key_expr(self) -> object: ...

    def reply(self, key_expr: str, payload: bytes) -> object: ...


@final
class Files:
    """What one member offers, and what it wants.

    Attributes:
        corrupt: how often a file did not have the hash that it was served under.
    """

    def __init__(self, session: "zenoh.Session", prefix: str, me: str) -> None:
        """Begins to serve.

        Args:
            session: that carries the chunks.
            prefix: of all keys of the session.
            me: this member's public key in hexadecimal.
        """
        self.corrupt = Counter[str]()
        self._session = session
        self._prefix, self._me = prefix, me
        self._have: dict[bytes, bytes] = {}
        self._wanted = set[bytes]()
        self._queries: SimpleQueue[zenoh.Query | None] = SimpleQueue()
        self._asked: SimpleQueue[bytes | None] = SimpleQueue()
        self._closing = threading.Event()
        self._threads = [
            threading.Thread(target=run, name=f"cotouch {run.__name__}", daemon=True)
            for run in (self._serve, self._collect)
        ]
        for thread in self._threads:
            thread.start()
        self.move(session)

    def move(self, session: "zenoh.Session") -> None:
        """Serves, and asks, through this session from now on."""
        self._session = session
        for key in (f"{self._prefix}/size/*/{self._me}", f"{self._prefix}/file/*/{self._me}/*"):
            session.declare_queryable(key, self._take)

    def offer(self, content: bytes) -> bytes:
        """Keeps a file for others; returns its SHA-256.

        Raises:
            SessionError: it is too long.
        """
        if len(content) > MOST_FILE:
            raise SessionError(f"a file has {len(content)} bytes; at most {MOST_FILE} can be sent")
        digest = hashlib.sha256(content).digest()
        self._have[digest] = content
        return digest

    def fetch(self, digest: bytes) -> bytes | None:
        """The file, if it is here; otherwise it is asked for until it is.

        Raises:
            SessionError: this is no SHA-256, or too many are wanted already.
        """
        if len(digest) != 32:
            raise SessionError(f"a file's hash has {len(digest)} bytes; it must have 32")
        held = self._have.get(digest)
        if held is None and digest not in self._wanted:
            if len(self._wanted) >= _MOST_WANTED:
                raise SessionError(f"{_MOST_WANTED} files have already been requested; wait for one of them")
            self._wanted.add(digest)
            self._asked.put(digest)
        return held

    @property
    def threads(self) -> tuple[threading.Thread, ...]:
        """That speak with the session; they end after `close`, at the latest with what they wait for."""
        return tuple(self._threads)

    def close(self) -> None:
        """Stops; the session is still open then."""
        self._closing.set()
        self._queries.put(None)
        self._asked.put(None)
        for thread in self._threads:
            thread.join(1.0)

    def _take(self, query: "zenoh.Query") -> None:
        if self._queries.qsize() < _MOST_QUERIES:
            self._queries.put(query)

    def _serve(self) -> None:
        import zenoh

        while (query := self._queries.get()) is not None:
            with query:
                # What does not fit gets no answer; a querier that went away is no harm.
                try:
                    self._answer(query)
                except (ValueError, IndexError, zenoh.ZError):
                    continue

    def _answer(self, query: _Query) -> None:
        """Answers one query; its key is ours, or has our own name in place of `*`."""
        key = str(query.key_expr)
        parts = key.removeprefix(self._prefix + "/").split("/")
        content = self._have.get(bytes.fromhex(parts[1]))
        if content is None:
            return
        if parts[0] == "size":
            query.reply(f"{self._prefix}/size/{parts[1]}/{self._me}", _SIZE.pack(len(content)))
        else:
            begin = int(parts[3]) * _CHUNK
            if 0 <= begin <= len(content):
                query.reply(key, content[begin : begin + _CHUNK])

    def _collect(self) -> None:
        while not self._closing.is_set() and (digest := self._asked.get()) is not None:
            content = self._search(digest)
            if content is not None:
                self._have[digest] = content
                self._wanted.discard(digest)
            elif not self._closing.wait(_AGAIN):
                self._asked.put(digest)

    def _search(self, digest: bytes) -> bytes | None:
        """Asks who has it, then one after the other of them."""
        import zenoh

        try:
            for holder, size in self._holders(digest):
                content = self._load(digest, holder, size)
                if content is not None and hashlib.sha256(content).digest() == digest:
                    return content
                if content is not None:
                    self.corrupt[holder] += 1
        except zenoh.ZError:  # the session is closing
            return None
        return None

    def _holders(self, digest: bytes) -> list[tuple[str, int]]:
        import zenoh

        out = list[tuple[str, int]]()
        replies = self._session.get(
            f"{self._prefix}/size/{digest.hex()}/*",
            target=zenoh.QueryTarget.ALL,
            consolidation=zenoh.ConsolidationMode.NONE,
            timeout=_ASK_TIMEOUT,
            priority=zenoh.Priority.DATA_LOW,
            congestion_control=zenoh.CongestionControl.BLOCK,
        )
        for reply in replies:
            if reply.ok is not None and len(reply.ok.payload) == _SIZE.size and len(out) < _MOST_QUERIES:
                size = _SIZE.unpack(reply.ok.payload.to_bytes())[0]
                if size <= MOST_FILE:
                    out.append((str(reply.ok.key_expr).rsplit("/", 1)[1], size))
        return out

    def _load(self, digest: bytes, holder: str, size: int) -> bytes | None:
        """All chunks, a few asked for ahead; None if one does not come."""
        import zenoh

        count = max(1, -(-size // _CHUNK))
        out, ahead = bytearray(), deque[zenoh.Handler[zenoh.Reply]]()
        asked = 0
        for chunk in range(count):
            while asked < min(count, chunk + _AHEAD):
                ahead.append(
                    self._session.get(
                        f"{self._prefix}/file/{digest.hex()}/{holder}/{asked}",
                        timeout=_CHUNK_TIMEOUT,
                        priority=zenoh.Priority.DATA_LOW,
                        congestion_control=zenoh.CongestionControl.BLOCK,
                    )
                )
                asked += 1
            parts = [reply.ok.payload.to_bytes() for reply in ahead.popleft() if reply.ok is not None]
            # More than one answer: somebody speaks in the holder's name. The hash decides.
            if not parts or len(parts[0]) != min(_CHUNK, size - chunk * _CHUNK) or self._closing.is_set():
                return None
            out += parts[0]
        return bytes(out)
