"""A network inside one process on a clock of its own: the transport of tests."""

import heapq
from collections.abc import Hashable
from typing import final

import numpy as np

from cotouch.errors import SessionError
from cotouch.samples import MOST_BYTES, Arrival, EmulatedPath, PathLaw, Traffic


@final
class MemoryNetwork:
    """Carries datagrams between its transports by laws of delay, loss and so on; the seed decides the fates.

    Attributes:
        now: its clock; moved by whoever uses it, and never backwards [s].
    """

    def __init__(self, *, law: PathLaw | None = None, seed: int = 0) -> None:
        """Makes a network without members.

        Args:
            law: of every path that `set` does not name.
            seed: of all fates.
        """
        self.now = 0.0
        self._law = law or PathLaw()
        self._seed = seed
        self._paths: dict[tuple[str, str], EmulatedPath] = {}
        self._waiting: dict[str, list[tuple[float, int, str, bytes]]] = {}
        self._count = 0
        self._joined: dict[str, MemoryTransport] = {}

    def __getitem__(self, address: str) -> "MemoryTransport":
        """The transport that joined at this address."""
        return self._joined[address]

    def set(self, sender: str, receiver: str, law: PathLaw) -> None:
        """Changes the law of one direction.

        Args:
            sender: name of who sends.
            receiver: name of the one who gets it.
            law: delay, jitter, loss and order of the path.
        """
        self._path(sender, receiver).law = law

    def law(self, sender: str, receiver: str) -> PathLaw:
        """The law of one direction.

        Args:
            sender: name of who sends.
            receiver: name of the one who gets it.
        """
        return self._path(sender, receiver).law

    def join(self, address: str) -> "MemoryTransport":
        """A transport at this address."""
        if address in self._waiting:
            raise SessionError(f"address {address!r} is taken; every member needs its own")
        self._waiting[address] = []
        self._joined[address] = MemoryTransport(self, address)
        return self._joined[address]

    def carry(self, sender: str, receiver: str, payload: bytes) -> None:
        """Takes a datagram on its way; anybody may write any sender on it.

        Args:
            sender: name that is written on it.
            receiver: name of the one who gets it.
            payload: the datagram.
        """
        path = self._path(sender, receiver)
        for time in path.arrivals(self.now, len(payload)):
            if receiver in self._waiting:
                self._count += 1
                heapq.heappush(self._waiting[receiver], (time, self._count, sender, payload))

    def collect(self, address: str) -> list[Arrival]:
        """What arrived at an address by now."""
        waiting, out = self._waiting.get(address, []), list[Arrival]()
        while waiting and waiting[0][0] <= self.now:
            time, _, sender, payload = heapq.heappop(waiting)
            out.append(Arrival(payload, sender, time))
        return out

    def move(self, old: str, new: str) -> None:
        """Another address for a member, as a NAT gives; what is on its way to the old one is lost.

        Args:
            old: address until now.
            new: address from now on.
        """
        del self._waiting[old]
        self._waiting[new] = []

    def leave(self, address: str) -> None:
        """Nobody is at this address any more."""
        self._waiting.pop(address, None)

    def _path(self, sender: str, receiver: str) -> EmulatedPath:
        key = (sender, receiver)
        if key not in self._paths:
            # From the names, so that a path's fates do not depend on which paths there are.
            seed = np.random.SeedSequence([self._seed, *sender.encode(), 0x100, *receiver.encode()])
            self._paths[key] = EmulatedPath(self._law, np.random.Generator(np.random.PCG64(seed)))
        return self._paths[key]


@final
class MemoryTransport:
    """One member's end of a `MemoryNetwork`; see `Transport`.

    Attributes:
        address: where it is.
        traffic: what went through so far.
    """

    def __init__(self, network: MemoryNetwork, address: str) -> None:
        self._network = network
        self.address = address
        self._neighbours: dict[int, str] = {}
        self.traffic = Traffic()
        self._open = True

    def send(self, neighbour: int, payload: bytes) -> bool:
        """Hands a datagram to the network.

        Args:
            neighbour: slot of the neighbour.
            payload: the datagram.
        """
        if not self._open:
            self.traffic.unsent["closed"] += 1
        elif len(payload) > MOST_BYTES:
            self.traffic.unsent["too long"] += 1
        elif neighbour not in self._neighbours:
            self.traffic.unsent["no address"] += 1
        else:
            self._network.carry(self.address, self._neighbours[neighbour], payload)
            self.traffic.count_sent(payload)
            return True
        return False

    def capacity(self, neighbour: int) -> float:
        """Nothing is known here of what a path bears."""
        return float("inf")

    def poll(self) -> list[Arrival]:
        """Everything that arrived since the last call."""
        if not self._open:
            return []
        arrived = self._network.collect(self.address)
        self.traffic.received += len(arrived)
        self.traffic.received_bytes += sum(len(arrival.payload) for arrival in arrived)
        return arrived

    def follow(self, neighbour: int, source: Hashable) -> None:
        """From now on the neighbour is there.

        Args:
            neighbour: slot of the neighbour.
            source: where it came from.
        """
        self._neighbours[neighbour] = str(source)

    def forget(self, neighbour: int) -> None:
        """The neighbour left."""
        self._neighbours.pop(neighbour, None)

    def move(self, address: str) -> None:
        """Gets another address, as behind a NAT that forgot its mapping."""
        self._network.move(self.address, address)
        self.address = address

    def close(self) -> None:
        """Leaves the network."""
        if self._open:
            self._open = False
            self._network.leave(self.address)
