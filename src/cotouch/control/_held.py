"""A queue between two threads that holds so much and no more."""

from queue import Empty, SimpleQueue
from typing import Generic, NamedTuple, TypeVar, final

_MOST_BYTES = 64 << 20
_MOST_ITEMS = 8192

Item = TypeVar("Item")


class _Held(NamedTuple, Generic[Item]):
    item: Item
    size: int


@final
class HeldQueue(Generic[Item]):
    """What one thread, or several under a lock, put in and another takes out."""

    def __init__(self) -> None:
        """Begins empty."""
        self._queue = SimpleQueue[_Held[Item] | None]()
        # One is written by who puts in, the other by who takes out.
        self._put_bytes, self._taken_bytes = 0, 0

    def put(self, item: Item, size: int) -> bool:
        """Takes something in, unless it holds too much; whether it did.

        Args:
            item: what is handed over.
            size: what it counts for [B].
        """
        if self._queue.qsize() >= _MOST_ITEMS or self._put_bytes - self._taken_bytes > _MOST_BYTES:
            return False
        self._put_bytes += size
        self._queue.put(_Held(item, size))
        return True

    def end(self) -> None:
        """Nothing more comes."""
        self._queue.put(None)

    def take(self, wait: float) -> Item | None:
        """The oldest; None: nothing more comes.

        Args:
            wait: for it, at most [s].

        Raises:
            queue.Empty: there was none.
        """
        held = self._queue.get(timeout=wait)
        if held is None:
            return None
        self._taken_bytes += held.size
        return held.item

    def drain(self) -> list[Item]:
        """All that is there, oldest first."""
        out = list[Item]()
        while True:
            try:
                held = self._queue.get_nowait()
            except Empty:
                return out
            if held is not None:
                self._taken_bytes += held.size
                out.append(held.item)
