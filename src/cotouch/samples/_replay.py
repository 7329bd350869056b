"""Which sequence numbers were seen: a ring of bits that never shifts [RFC 6479]."""

from typing import final

_BITS = 64


@final
class ReplayWindow:
    """Tells new numbers from seen and old ones, in constant time and memory.

    Attributes:
        newest: greatest number marked; -1 before the first.
        count: how many were marked.
    """

    __slots__ = ("_blocks", "_ring", "count", "newest")

    def __init__(self, blocks: int = 64) -> None:
        """Makes an empty window.

        Args:
            blocks: of 64 numbers, >= 2; all but one of them are behind the newest.
        """
        self._blocks = blocks
        self._ring = [0] * blocks
        self.newest = -1
        self.count = 0

    @property
    def width(self) -> int:
        """How far behind the newest a number may be at least and still be taken."""
        return (self._blocks - 1) * _BITS

    def fresh(self, number: int) -> bool:
        """Whether the number is neither seen nor too old; changes nothing."""
        if number > self.newest:
            return True
        block = number // _BITS
        if block <= self.newest // _BITS - self._blocks:
            return False
        return not self._ring[block % self._blocks] >> (number % _BITS) & 1

    def mark(self, number: int) -> None:
        """The number, which is fresh, was seen."""
        block = number // _BITS
        if number > self.newest:
            last = self.newest // _BITS
            if block != last:
                for entered in range(max(last, block - self._blocks) + 1, block + 1):
                    self._ring[entered % self._blocks] = 0
            self.newest = number
        self._ring[block % self._blocks] |= 1 << (number % _BITS)
        self.count += 1
