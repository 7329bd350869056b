"""A control plane inside one process, on a clock of its own, for tests: signed and checked like any other."""

import hashlib
import heapq
from collections import Counter
from typing import final

import numpy as np

from cotouch.errors import SessionError
from cotouch.live._control import Message, Relayed
from cotouch.live._keys import Identity
from cotouch.live._path import Path, PathLaw
from cotouch.live._sign import MessageReader, MessageRefusal, MessageWriter
from cotouch.live._transport import MOST_BYTES


@final
class _Tie:
    """Whether two members see each other, and since when."""

    def __init__(self, now: float, delay: float) -> None:
        self.up = True
        self._changed, self._lag, self._was = now, delay, False

    def set(self, up: bool, now: float, lag: float) -> None:
        if up != self.up:
            self._was = self.seen(now)
            self.up, self._changed, self._lag = up, now, lag

    def seen(self, now: float) -> bool:
        """Presence follows what is true, `lag` later."""
        return self.up if now >= self._changed + self._lag else self._was


@final
class MemoryControlNetwork:
    """Carries messages between its members; the same seed, the same fates.

    Attributes:
        now: its clock; moved by whoever uses it, and never backwards [s].
    """

    def __init__(
        self,
        *,
        session: bytes = bytes(32),
        delay: float = 0.0,
        lease: float = 1.5,
        law: PathLaw | None = None,
        seed: int = 0,
    ) -> None:
        """Makes a network without members.

        Args:
            session: 32 bytes that name the session.
            delay: of every message, and until somebody who came or left is noticed [s].
            lease: until it is noticed that somebody was cut off or killed [s].
            law: of relayed datagrams, each way.
            seed: of their fates.
        """
        self.now = 0.0
        self.delay, self.lease = delay, lease
        self.session = session
        self._law = law or PathLaw()
        self._seed = seed
        self._members: dict[bytes, MemoryControl] = {}
        self._ties: dict[frozenset[bytes], _Tie] = {}
        self._paths: dict[tuple[bytes, bytes], Path] = {}
        self._joined = 0

    def join(self, identity: Identity) -> "MemoryControl":
        """A member, or one that comes back after it was killed or left.

        Raises:
            SessionError: the identity is taken.
        """
        if identity.public in self._members:
            raise SessionError("a member of this identity is there already; every member needs its own")
        self._joined += 1
        # Any rising number does for the unix time: a member that comes back is above all it said before.
        member = MemoryControl(self, identity, started=self._joined * 1_000_000_000)
        for other in self._members:
            pair = frozenset((identity.public, other))
            if pair in self._ties:
                self._ties[pair].set(up=True, now=self.now, lag=self.delay)
            else:
                self._ties[pair] = _Tie(self.now, self.delay)
        self._members[identity.public] = member
        return member

    def cut(self, one: bytes, other: bytes) -> None:
        """From now on nothing goes between these two, either way."""
        self._tie(one, other).set(up=False, now=self.now, lag=self.lease)
        self._lose(one, other)

    def mend(self, one: bytes, other: bytes) -> None:
        """They meet again."""
        self._tie(one, other).set(up=True, now=self.now, lag=self.delay)

    def kill(self, member: bytes) -> None:
        """Ends a member without a word; the others notice after the lease."""
        for other in self._members:
            if other != member:
                self._lose(member, other)
        self.drop(member, lag=self.lease)

    def drop(self, member: bytes, *, lag: float) -> None:
        """Takes a member out; the others notice after the lag."""
        if self._members.pop(member, None) is not None:
            for other in self._members:
                self._tie(member, other).set(up=False, now=self.now, lag=lag)

    def connected(self, one: bytes, other: bytes) -> bool:
        """Whether something sent now would arrive."""
        return one in self._members and other in self._members and self._tie(one, other).up

    def seen(self, member: bytes) -> frozenset[bytes]:
        """Whom a member sees."""
        ties = ((pair - {member}, tie) for pair, tie in self._ties.items() if member in pair)
        return frozenset(other for others, tie in ties if tie.seen(self.now) for other in others)

    def carry(self, sender: bytes, to: bytes | None, message: bytes) -> None:
        """Takes a message on its way; anybody may write any sender into it."""
        for key in self._members if to is None else (to,):
            if key != sender and self.connected(sender, key):
                self._members[key].deliver(self.now + self.delay, sender, message)

    def relay(self, sender: bytes, to: bytes, payload: bytes) -> None:
        """Takes a datagram on its way."""
        if self.connected(sender, to):
            for time in self._path(sender, to).arrivals(self.now, len(payload)):
                self._members[to].deliver_relayed(Relayed(payload, sender, time))

    def content(self, digest: bytes, member: bytes) -> bytes | None:
        """A file that somebody offers whom this member can reach."""
        others = (other for key, other in self._members.items() if key != member and self.connected(member, key))
        offered = (other.offered.get(digest) for other in others)
        return next((content for content in offered if content is not None), None)

    def _lose(self, one: bytes, other: bytes) -> None:
        """What is on its way between two is lost."""
        for sender, receiver in ((one, other), (other, one)):
            if receiver in self._members:
                self._members[receiver].lose(sender)

    def _tie(self, one: bytes, other: bytes) -> _Tie:
        tie = self._ties.get(frozenset((one, other)))
        if tie is None:
            raise SessionError("these two were never in the session together; let both join first")
        return tie

    def _path(self, sender: bytes, to: bytes) -> Path:
        if (sender, to) not in self._paths:
            seed = np.random.SeedSequence([self._seed, *sender, *to])
            self._paths[sender, to] = Path(self._law, np.random.Generator(np.random.PCG64(seed)))
        return self._paths[sender, to]


@final
class MemoryControl:
    """One member's end of a `MemoryControlNetwork`; see `ControlPlane`.

    Attributes:
        offered: files that others may fetch, by their hash.
    """

    def __init__(self, network: MemoryControlNetwork, identity: Identity, *, started: int) -> None:
        self.offered: dict[bytes, bytes] = {}
        self._network = network
        self._identity = identity
        self._writer = MessageWriter(identity, network.session, started=started)
        self._reader = MessageReader(identity.public, network.session)
        self._inbox: list[tuple[float, int, bytes, bytes]] = []
        self._relayed: list[tuple[float, int, Relayed]] = []
        self._asked: dict[bytes, float] = {}
        self._count = 0
        self._open = True

    @property
    def identity(self) -> Identity:
        """Of this member."""
        return self._identity

    @property
    def refused(self) -> Counter[MessageRefusal]:
        """How many messages were refused, by reason."""
        return self._reader.refused

    def send(self, topic: str, body: bytes, *, to: bytes | None = None) -> None:
        """Says something to one member, or to all others."""
        self._writer.check(topic, body, to)
        if self._open:
            self._network.carry(self._identity.public, to, self._writer.write(topic, body, to))

    def poll(self) -> list[Message]:
        """What was said since the last call."""
        out = list[Message]()
        while self._open and self._inbox and self._inbox[0][0] <= self._network.now:
            time, _, _, message = heapq.heappop(self._inbox)
            read = self._reader.read(message, time)
            if isinstance(read, Message):
                out.append(read)
        return out

    def present(self) -> frozenset[bytes]:
        """Public keys of all others who are connected now."""
        return self._network.seen(self._identity.public) if self._open else frozenset()

    def offer(self, content: bytes) -> bytes:
        """Keeps a file for others to fetch; returns its SHA-256."""
        digest = hashlib.sha256(content).digest()
        self.offered[digest] = content
        return digest

    def fetch(self, digest: bytes) -> bytes | None:
        """A file that somebody offers: there and back after it was asked for."""
        if digest not in self.offered and self._open:
            asked = self._asked.setdefault(digest, self._network.now)
            content = self._network.content(digest, self._identity.public)
            if content is not None and self._network.now >= asked + 2.0 * self._network.delay:
                self.offer(content)
        return self.offered.get(digest)

    def relay(self, to: bytes, payload: bytes) -> bool:
        """Hands on a datagram."""
        if not self._open or len(payload) > MOST_BYTES or to not in self.present():
            return False
        self._network.relay(self._identity.public, to, payload)
        return True

    def relayed(self) -> list[Relayed]:
        """Datagrams that came this way since the last call."""
        out = list[Relayed]()
        while self._open and self._relayed and self._relayed[0][0] <= self._network.now:
            out.append(heapq.heappop(self._relayed)[2])
        return out

    def close(self) -> None:
        """Leaves: the others see it after the delay."""
        if self._open:
            self._open = False
            self._network.drop(self._identity.public, lag=self._network.delay)

    def deliver(self, time: float, sender: bytes, message: bytes) -> None:
        """A message that will arrive; the sender is the true one, whatever the message says."""
        self._count += 1
        heapq.heappush(self._inbox, (time, self._count, sender, message))

    def lose(self, sender: bytes) -> None:
        """What is on its way from a sender will not arrive."""
        now = self._network.now
        self._inbox = [item for item in self._inbox if item[0] <= now or item[2] != sender]
        heapq.heapify(self._inbox)

    def deliver_relayed(self, relayed: Relayed) -> None:
        """A datagram that will arrive."""
        self._count += 1
        heapq.heappush(self._relayed, (relayed.time, self._count, relayed))
