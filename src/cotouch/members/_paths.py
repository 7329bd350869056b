"""How samples get from one member to another."""

from collections.abc import Mapping
from typing import Protocol, final

from cotouch.arrays import Float
from cotouch.control import SignedMessage
from cotouch.samples import Transport
from cotouch.traversal import RoutedTransport


class Paths(Protocol):
    """A transport, and whatever finds out where its neighbours are."""

    @property
    def transport(self) -> Transport:
        """Carries the samples."""
        ...

    def introduce(self, slot: int, key: bytes) -> None:
        """A member is to be reached from now on, or still is.

        Args:
            slot: its index.
            key: its public key.
        """
        ...

    def round_trip(self, slot: int) -> float | None:
        """How long the quickest way there and back took lately, without what is emulated; None: not known [s]."""
        ...

    def take(self, message: SignedMessage) -> bool:
        """Takes a message of the control plane; whether it was about ways."""
        ...

    def path_state(self, slot: int) -> str:
        """How a neighbour is reached now: "direct", "relayed" or "trying"."""
        ...


@final
class MetPaths:
    """To whom one member looks for ways: to all others, linked or not, as how far they are decides who is linked."""

    def __init__(self, paths: Paths) -> None:
        """Begins with nobody, on these paths."""
        self._paths = paths
        self._slots = set[int]()

    def meet(self, others: Mapping[int, bytes]) -> None:
        """Looks for ways to these and no others, by slot and public key."""
        for gone in self._slots - others.keys():
            self._paths.transport.forget(gone)
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


@final
class RoutedPaths:
    """Direct paths where possible, otherwise the control plane's relay."""

    def __init__(self, routed: RoutedTransport, transport: Transport | None = None) -> None:
        """Joins a transport with what may be on top of it.

        Args:
            routed: finds the ways.
            transport: what the samples go through, if there is something on top, such as an emulated network.
        """
        self._routed = routed
        self.transport: Transport = routed if transport is None else transport

    def introduce(self, slot: int, key: bytes) -> None:
        """Begins to look for ways.

        Args:
            slot: the user's.
            key: public key of its member.
        """
        self._routed.introduce(slot, key)

    def round_trip(self, slot: int) -> float | None:
        """As pings found it."""
        return self._routed.round_trip(slot)

    def take(self, message: SignedMessage) -> bool:
        """Takes candidates."""
        return self._routed.take(message)

    def path_state(self, slot: int) -> str:
        """As the transport has it."""
        return self._routed.path_state(slot).name.lower()
