"""What the sample plane needs of a network: datagrams to and from neighbours, and nothing of order or certainty."""

from collections import Counter
from collections.abc import Hashable
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol, final

from cotouch.samples._address import Address

# Fits every path of use without fragments: IPv6 guarantees 1,280 bytes, 48 of which are headers.
MOST_BYTES = 1200


class Arrival(NamedTuple):
    """A datagram that arrived.

    Attributes:
        payload: its bytes; nothing about them has been checked but their number.
        source: where it says it came from; anybody can write this on a datagram.
        time: of arrival, on the transport's clock [s].
    """

    payload: bytes
    source: Hashable
    time: float


@final
@dataclass(eq=False)
class Traffic:
    """What has passed through a transport.

    Attributes:
        sent: datagrams handed to the network.
        sent_bytes: their bytes.
        received: datagrams that `poll` returned.
        received_bytes: their bytes.
        unsent: datagrams that could not be handed over, by reason.
        dropped: datagrams that arrived and were thrown away unread, by reason.
    """

    sent: int = 0
    sent_bytes: int = 0
    received: int = 0
    received_bytes: int = 0
    unsent: Counter[str] = field(default_factory=Counter[str])
    dropped: Counter[str] = field(default_factory=Counter[str])

    def __add__(self, other: "Traffic") -> "Traffic":
        """Of both together."""
        return Traffic(
            self.sent + other.sent,
            self.sent_bytes + other.sent_bytes,
            self.received + other.received,
            self.received_bytes + other.received_bytes,
            self.unsent + other.unsent,
            self.dropped + other.dropped,
        )

    def count_sent(self, datagram: bytes) -> None:
        """Counts one that was handed to the network."""
        self.sent += 1
        self.sent_bytes += len(datagram)

    def count_received(self, datagram: bytes) -> None:
        """Counts one that `poll` returns."""
        self.received += 1
        self.received_bytes += len(datagram)


class Transport(Protocol):
    """Carries datagrams of at most `MOST_BYTES`, any of which may be lost, late, duplicated, reordered or forged.

    A neighbour is wherever its owner said (`follow`): at first where the session says, afterwards where its last
    authenticated datagram came from.
    """

    @property
    def traffic(self) -> Traffic:
        """What went through so far."""
        ...

    def send(self, neighbour: int, payload: bytes) -> bool:
        """Hands a datagram to the network; never waits. False, and counted, if that was not possible.

        Args:
            neighbour: slot of the neighbour.
            payload: the datagram.
        """
        ...

    def capacity(self, neighbour: int) -> float:
        """Datagrams per second that the way to a neighbour is to be given at most; inf: what it bears must show."""
        ...

    def poll(self) -> list[Arrival]:
        """Everything that arrived since the last call, oldest first; never waits."""
        ...

    def follow(self, neighbour: int, source: Hashable) -> None:
        """From now on the neighbour is where this datagram came from; only to be said of an authenticated one.

        Args:
            neighbour: slot of the neighbour.
            source: where it came from.
        """
        ...

    def forget(self, neighbour: int) -> None:
        """The neighbour left."""
        ...

    def close(self) -> None:
        """Gives back what was taken of the machine; afterwards nothing is sent and nothing arrives."""
        ...


class AddressedTransport(Transport, Protocol):
    """A transport over a socket on which paths can be probed; `UdpTransport` is one."""

    @property
    def address(self) -> Address:
        """Where it listens."""
        ...

    def rebind(self, host: str) -> None:
        """Listens at another address of this machine from now on.

        Raises:
            TransportError: that is not possible; it stays where it is.
        """
        ...

    def reach(self, address: Address, payload: bytes) -> bool:
        """Hands over a datagram for an address that is no neighbour's, uncounted. False: that was not possible.

        Args:
            address: IP address and port.
            payload: the datagram.
        """
        ...

    def now(self) -> float:
        """Time, as arrivals are stamped [s]."""
        ...
