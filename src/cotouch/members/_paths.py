"""To whom a member looks for ways, and how long these take."""

from collections.abc import Mapping
from typing import Protocol, final

from cotouch.arrays import Float
from cotouch.control import SignedMessage
from cotouch.samples import Transport
from cotouch.traversal import PathState


class Paths(Protocol):
    """Finds out where neighbours are, by their slots; such as `RoutedTransport`."""

    def introduce(self, neighbour: int, member: bytes) -> None:
        """A member is to be reached from now on, or still is.

        Args:
            neighbour: its slot.
            member: its public key.
        """
        ...

    def round_trip(self, neighbour: int) -> float | None:
        """How long the quickest way there and back took lately, without what is emulated; None: not known [s]."""
        ...

    def take(self, message: SignedMessage) -> bool:
        """Takes a message of the control plane; whether it was about ways."""
        ...

    def path_state(self, neighbour: int) -> PathState:
        """How a neighbour is reached now."""
        ...


@final
class MetPaths:
    """To whom one member looks for ways: to all others, linked or not, as how far they are decides who is linked."""

    def __init__(self, paths: Paths, transport: Transport) -> None:
        """Begins with nobody, on these paths, of whose ends the transport forgets who leaves."""
        self._paths, self._transport = paths, transport
        self._slots = set[int]()

    def meet(self, others: Mapping[int, bytes]) -> None:
        """Looks for ways to these and no others, by slot and public key."""
        for gone in self._slots - others.keys():
            self._transport.forget(gone)
        for slot, key in others.items():
            self._paths.introduce(slot, key)
        self._slots = set(others)

    def round_trips(self, own: int | None, delay: Float) -> list[tuple[int, float]]:
        """Times there and back, by slot; pings do not go through what is emulated, so its delays are added [s].

        Args:
            own: slot of this member; None: it has none, and knows of no times.
            delay: that is emulated, [to, from] [s].
        """
        found: list[tuple[int, float]] = []
        for slot in self._slots:
            path = self._paths.round_trip(slot)
            if own is not None and path is not None:
                found.append((slot, path + float(delay[own, slot] + delay[slot, own])))
        return found
