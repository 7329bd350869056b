"""What goes out over a link, for people to see."""

from typing import final

_WINDOW = 1.0  # [s]


@final
class Sent:
    """Datagrams and bytes a second, of the last whole second or so.

    Attributes:
        datagrams: [1/s].
        size: of them, sealed, without what the network adds [B/s].
        saved: share of bytes that a perceptual codec left out; 0 without one.
    """

    def __init__(self) -> None:
        """Starts with nothing sent."""
        self.datagrams = self.size = self.saved = 0.0
        self._begun: float | None = None
        self._count = self._bytes = self._full = 0

    def add(self, now: float, count: int, size: int, full: int) -> None:
        """Counts a sample.

        Args:
            now: [s].
            count: of its datagrams.
            size: of these [bytes].
            full: what it would have taken without a codec [bytes].
        """
        if self._begun is None:
            self._begun = now
        passed = now - self._begun
        if passed >= _WINDOW:
            self.datagrams, self.size = self._count / passed, self._bytes / passed
            self.saved = max(0.0, 1.0 - self._bytes / self._full) if self._full else 0.0
            self._begun, self._count, self._bytes, self._full = now, 0, 0, 0
        self._count += count
        self._bytes += size
        self._full += full
