"""A virtual internet of sockets, some behind NATs, on a clock of its own; and a control plane within one process."""

import heapq
import random
from collections.abc import Callable, Hashable

from cotouch.control import Relayed, SignedMessage
from cotouch.errors import TransportError
from cotouch.samples import MOST_BYTES, Address, Arrival, Identity, Traffic


class Nat:
    """Masquerades the sockets behind it, as Linux does: lets in only what answers, address and port.

    With `kept` ports a socket has the same one outside for everybody; otherwise each destination sees another.
    """

    def __init__(self, host: str, *, kept: bool = True, seed: int = 0) -> None:
        self.host, self.kept = host, kept
        self._rng = random.Random(seed)
        self._flows: dict[tuple[Address, Address], int] = {}
        self.shift = 0

    def out(self, inside: Address, to: Address) -> Address:
        port = self._flows.get((inside, to))
        if port is None:
            port = inside.port + self.shift if self.kept else self._rng.randrange(1024, 65536)
            while any(to == other and port == taken for (_, other), taken in self._flows.items()):
                port += 1
            self._flows[inside, to] = port
        return Address(self.host, port)

    def inward(self, port: int, source: Address) -> Address | None:
        for (inside, to), mapped in self._flows.items():
            if (mapped, to) == (port, source):
                return inside
        return None

    def forget(self) -> None:
        """Its mappings are gone, and the next have other ports."""
        self._flows.clear()
        self.shift += 1000


class Internet:
    """Carries datagrams after a delay; `cut` says which pairs of hosts cannot be crossed."""

    def __init__(self, *, delay: float = 0.01, loss: float = 0.0, seed: int = 0) -> None:
        self.now, self.delay, self.loss = 0.0, delay, loss
        self.cut: Callable[[str, str], bool] = lambda source, to: False
        self.log: list[tuple[float, Address, Address, bytes]] = []
        self._rng = random.Random(seed)
        self._sockets: dict[tuple[str, Address], VirtualSocket] = {}
        self._nats: dict[str, Nat] = {}
        self._flying: list[tuple[float, int, VirtualSocket, bytes, Address]] = []
        self._count = 0

    def socket(self, host: str, port: int, *, behind: Nat | None = None) -> "VirtualSocket":
        made = VirtualSocket(self, Address(host, port), behind)
        self._sockets[behind.host if behind else "", made.address] = made
        if behind:
            self._nats[behind.host] = behind
        return made

    def move(self, socket: "VirtualSocket", address: Address) -> None:
        realm = socket.nat.host if socket.nat else ""
        del self._sockets[realm, socket.address]
        socket.address = address
        self._sockets[realm, address] = socket

    def carry(self, sender: "VirtualSocket", to: Address, payload: bytes) -> None:
        source, realm = sender.address, sender.nat.host if sender.nat else ""
        found = self._sockets.get((realm, to))
        if found is None and sender.nat is not None:
            source = sender.nat.out(source, to)
        if found is None:
            outer = self._nats.get(to.host)
            inside = to if outer is None else outer.inward(to.port, source)
            found = None if inside is None else self._sockets.get((outer.host if outer else "", inside))
        self.log.append((self.now, source, to, payload))
        if (
            found is None
            or found.address.host not in found.hosts
            or self.cut(source.host, to.host)
            or self._rng.random() < self.loss
        ):
            return
        self._count += 1
        heapq.heappush(self._flying, (self.now + self.delay, self._count, found, payload, source))

    def deliver(self) -> None:
        while self._flying and self._flying[0][0] <= self.now:
            time, _, to, payload, source = heapq.heappop(self._flying)
            to.waiting.append(Arrival(payload, source, time))


class VirtualSocket:
    """A `Ground` of the virtual internet."""

    def __init__(self, net: Internet, address: Address, nat: Nat | None) -> None:
        self.net, self.address, self.nat = net, address, nat
        self.waiting: list[Arrival] = []
        self._neighbours: dict[int, Address] = {}
        self._traffic = Traffic()
        self.open = True
        self.hosts = {address.host}  # of its machine; where the socket's own is no more, nothing is sent

    @property
    def traffic(self) -> Traffic:
        return self._traffic

    def now(self) -> float:
        return self.net.now

    def rebind(self, host: str) -> None:
        if host not in self.hosts:
            raise TransportError(f"{host} is not an address of this machine")
        self.net.move(self, Address(host, self.address.port))

    def reach(self, address: Address, payload: bytes) -> bool:
        assert len(payload) <= MOST_BYTES
        if self.address.host not in self.hosts:
            return False
        self.net.carry(self, Address(*address), payload)
        return self.open

    def send(self, neighbour: int, payload: bytes) -> bool:
        if neighbour not in self._neighbours:
            self._traffic.unsent["no address"] += 1
            return False
        return self.reach(self._neighbours[neighbour], payload)

    def capacity(self, neighbour: int) -> float:
        return float("inf")

    def poll(self) -> list[Arrival]:
        self.net.deliver()
        out, self.waiting = self.waiting, []
        return out

    def follow(self, neighbour: int, source: Hashable) -> None:
        self._neighbours[neighbour] = Address(*source)

    def forget(self, neighbour: int) -> None:
        self._neighbours.pop(neighbour, None)

    def close(self) -> None:
        self.open = False


class Exchange:
    """Where control planes of one process meet; messages arrive at once, unless a member is cut off."""

    def __init__(self, clock: Callable[[], float]) -> None:
        self.clock = clock
        self.members: dict[bytes, MemoryControl] = {}
        self.off: set[bytes] = set()

    def join(self, identity: Identity) -> "MemoryControl":
        self.members[identity.public] = MemoryControl(self, identity)
        return self.members[identity.public]


class MemoryControl:
    """A `ControlPlane` within one process."""

    def __init__(self, exchange: Exchange, identity: Identity) -> None:
        self._exchange, self._identity = exchange, identity
        self.said: list[SignedMessage] = []
        self.waiting: list[Relayed] = []

    @property
    def identity(self) -> Identity:
        return self._identity

    def _reached(self, member: bytes) -> "list[MemoryControl]":
        off = self._exchange.off
        return [] if {member, self._identity.public} & off else [self._exchange.members[member]]

    def send(self, topic: str, body: bytes, *, to: bytes | None = None) -> None:
        for member in self.present() if to is None else {to} & self.present():
            for other in self._reached(member):
                other.said.append(SignedMessage(self._identity.public, topic, body, to is not None))

    def poll(self) -> list[SignedMessage]:
        out, self.said = self.said, []
        return out

    def present(self) -> frozenset[bytes]:
        return frozenset(self._exchange.members) - {self._identity.public}

    def offer(self, content: bytes) -> bytes:
        raise NotImplementedError

    def fetch(self, digest: bytes) -> bytes | None:
        raise NotImplementedError

    def relay(self, to: bytes, payload: bytes) -> bool:
        reached = self._reached(to) if to in self._exchange.members else []
        for other in reached:
            other.waiting.append(Relayed(payload, self._identity.public, self._exchange.clock()))
        return bool(reached)

    def relayed(self) -> list[Relayed]:
        out, self.waiting = self.waiting, []
        return out

    def close(self) -> None:
        self._exchange.members.pop(self._identity.public, None)
