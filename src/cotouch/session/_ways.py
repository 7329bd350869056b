"""How members tell each other where they are, and how datagrams get there."""

from typing import Protocol, final

from cotouch.live import Transport


class Ways(Protocol):
    """A transport, and what its owner says and hears about addresses over the control plane."""

    @property
    def transport(self) -> Transport:
        """Carries the samples."""
        ...

    def introduction(self) -> bytes:
        """Where this member is, for the others."""
        ...

    def introduced(self, seat: int, key: bytes, body: bytes, now: float) -> None:
        """Another member said where it is; what makes no sense is ignored."""
        ...

    def forget(self, seat: int) -> None:
        """A member left, or another took its seat."""
        ...

    def tend(self, now: float) -> None:
        """What has to be done now and then."""
        ...

    def way(self, seat: int) -> str:
        """How datagrams get to a member: "direct", "relayed" or "none"."""
        ...


@final
class MemoryWays:
    """Members of one process, by name; for tests."""

    def __init__(self, transport: Transport, address: str) -> None:
        """Wraps a transport.

        Args:
            transport: over a memory network.
            address: in it.
        """
        self.transport = transport
        self._address = address
        self._known: set[int] = set()

    def introduction(self) -> bytes:
        """The address."""
        return self._address.encode()

    def introduced(self, seat: int, key: bytes, body: bytes, now: float) -> None:
        """Follows it there."""
        del key, now
        self._known.add(seat)
        self.transport.follow(seat, body.decode())

    def forget(self, seat: int) -> None:
        """Forgets it."""
        self._known.discard(seat)

    def tend(self, now: float) -> None:
        """Does nothing."""

    def way(self, seat: int) -> str:
        """Direct, once it is known."""
        return "direct" if seat in self._known else "none"
