"""How many datagrams of each source are read at all, whatever is in them."""

from collections.abc import Hashable
from typing import final

# Strangers share this many buckets, so that a flood under ever new addresses costs no memory.
_STRANGERS = 64


@final
class Bucket:
    """Admits `rate` in the long run and `burst` at once."""

    __slots__ = ("_burst", "_left", "_rate", "_then")

    def __init__(self, rate: float, burst: float) -> None:
        self._rate = rate
        self._burst = burst
        self._left = burst
        self._then = -float("inf")

    def take(self, now: float, cost: float = 1.0) -> bool:
        """Whether one more is let through.

        Args:
            now: must not run backwards [s].
            cost: how many it counts for.
        """
        if now > self._then:
            self._left = min(self._burst, self._left + self._rate * (now - self._then))
            self._then = now
        if self._left < cost:
            return False
        self._left -= cost
        return True


@final
class SourceLimit:
    """A bucket for the address of each neighbour, and a fixed number of smaller ones for all others together.

    A stranger may be a neighbour behind a new address, so it is heard a little; a flood of strangers takes nothing
    from the neighbours.
    """

    def __init__(self, *, rate: float, burst: float, stranger_rate: float, stranger_burst: float) -> None:
        """Sets the limits.

        Args:
            rate: of each neighbour, in the long run [1/s].
            burst: of each neighbour, at once.
            stranger_rate: of each share of the strangers [1/s].
            stranger_burst: likewise, at once.
        """
        self._rate, self._burst = rate, burst
        self._known: dict[Hashable, Bucket] = {}
        self._strangers = [Bucket(stranger_rate, stranger_burst) for _ in range(_STRANGERS)]

    def know(self, address: Hashable) -> None:
        """This address is a neighbour's."""
        if address not in self._known:
            self._known[address] = Bucket(self._rate, self._burst)

    def unknow(self, address: Hashable) -> None:
        """It is no longer."""
        self._known.pop(address, None)

    def take(self, now: float, address: Hashable, group: Hashable, cost: float = 1.0) -> bool:
        """Whether a datagram is read.

        Args:
            now: [s].
            address: where it says it came from.
            group: what strangers of one origin have in common, such as their host or network.
            cost: how many it counts for.
        """
        bucket = self._known.get(address)
        if bucket is None:
            bucket = self._strangers[hash(group) % _STRANGERS]
        return bucket.take(now, cost)
