"""A control plane inside one process, on a clock of its own, for tests: signed and checked like any other."""

import hashlib
import heapq
from collections import Counter
from typing import final

import numpy as np
from tests.control.inside import WINDOW

from cotouch.control import MessageReader, MessageRefusal, MessageWriter, Presence, Relayed, SignedMessage
from cotouch.errors import SessionError
from cotouch.samples import MOST_BYTES, EmulatedPath, Identity, PathLaw

# The clock is moved on by no more than this at once, so that beats are said and heard in between [s].
_TURN = 0.05


@final
class MemoryControlNetwork:
    """Carries messages between its members; the seed decides their fates.

    Members beat as the clock is moved, whether they are polled or not.
    """

    def __init__(
        self,
        *,
        session: bytes = bytes(32),
        delay: float = 0.0,
        window: float = WINDOW,
        law: PathLaw | None = None,
        seed: int = 0,
    ) -> None:
        """Makes a network without members.

        Args:
            session: 32 bytes that name the session.
            delay: of every message [s].
            window: of presence; see `Presence` [s].
            law: of relayed datagrams, each way.
            seed: of their fates.
        """
        self._now = 0.0
        self.delay, self.window = delay, window
        self.session = session
        self._law = law or PathLaw()
        self._seed = seed
        self._members: dict[bytes, MemoryControl] = {}
        self._ever = set[bytes]()
        self._cuts = set[frozenset[bytes]]()
        self._paths: dict[tuple[bytes, bytes], EmulatedPath] = {}
        self._joined = 0

    @property
    def now(self) -> float:
        """Its clock; moved by whoever uses it, and never backwards [s]."""
        return self._now

    @now.setter
    def now(self, time: float) -> None:
        while self._now < time:
            self._now = min(time, self._now + _TURN)
            for member in list(self._members.values()):
                member.turn(self._now)

    def join(self, identity: Identity) -> "MemoryControl":
        """A member, or one that comes back after it was killed or left.

        Raises:
            SessionError: the identity is taken.
        """
        if identity.public in self._members:
            raise SessionError("a member with this identity has already joined; every member needs its own")
        self._joined += 1
        # Any rising number does for the unix time: a member that comes back is above all it said before.
        member = MemoryControl(self, identity, started=self._joined * 1_000_000_000, seed=(self._seed, self._joined))
        self._cuts = {pair for pair in self._cuts if identity.public not in pair}
        self._members[identity.public] = member
        self._ever.add(identity.public)
        return member

    def cut(self, one: bytes, other: bytes) -> None:
        """From now on nothing goes between these two, either way.

        Args:
            one: public key of one member.
            other: public key of the other.
        """
        self._cuts.add(self._pair(one, other))
        self._lose(one, other)

    def mend(self, one: bytes, other: bytes) -> None:
        """They meet again.

        Args:
            one: public key of one member.
            other: public key of the other.
        """
        self._cuts.discard(self._pair(one, other))

    def kill(self, member: bytes) -> None:
        """Ends a member without a word."""
        for other in self._members:
            if other != member:
                self._lose(member, other)
        self.drop(member)

    def drop(self, member: bytes) -> None:
        """Takes a member out; what it said is on its way."""
        self._members.pop(member, None)

    def connected(self, one: bytes, other: bytes) -> bool:
        """Whether something sent now would arrive.

        Args:
            one: public key of one member.
            other: public key of the other.
        """
        return one in self._members and other in self._members and frozenset((one, other)) not in self._cuts

    def carry(self, sender: bytes, to: bytes | None, message: bytes, *, beat: bool = False) -> None:
        """Takes a message or a beat on its way; anybody may write any sender into it.

        Args:
            sender: public key that is written on it.
            to: public key of the receiver; None: all others.
            message: as it travels.
            beat: whether it only shows presence.
        """
        for key in self._members if to is None else (to,):
            if key != sender and self.connected(sender, key):
                self._members[key].deliver(self.now + self.delay, sender, message, beat=beat)

    def relay(self, sender: bytes, to: bytes, payload: bytes) -> None:
        """Takes a datagram on its way.

        Args:
            sender: public key that is written on it.
            to: public key of the receiver.
            payload: the datagram.
        """
        if self.connected(sender, to):
            for time in self._path(sender, to).arrivals(self.now, len(payload)):
                self._members[to].deliver_relayed(Relayed(payload, sender, time))

    def content(self, digest: bytes, member: bytes) -> bytes | None:
        """A file that somebody offers whom this member can reach.

        Args:
            digest: of its content.
            member: its public key.
        """
        others = (other for key, other in self._members.items() if key != member and self.connected(member, key))
        offered = (other.offered.get(digest) for other in others)
        return next((content for content in offered if content is not None), None)

    def _lose(self, one: bytes, other: bytes) -> None:
        """What is on its way between two is lost."""
        for sender, receiver in ((one, other), (other, one)):
            if receiver in self._members:
                self._members[receiver].lose(sender)

    def _pair(self, one: bytes, other: bytes) -> frozenset[bytes]:
        if not {one, other} <= self._ever:
            raise SessionError("these two were never in the session together; let both join first")
        return frozenset((one, other))

    def _path(self, sender: bytes, to: bytes) -> EmulatedPath:
        if (sender, to) not in self._paths:
            seed = np.random.SeedSequence([self._seed, *sender, *to])
            self._paths[sender, to] = EmulatedPath(self._law, np.random.Generator(np.random.PCG64(seed)))
        return self._paths[sender, to]


@final
class MemoryControl:
    """One member's end of a `MemoryControlNetwork`; see `ControlPlane`.

    Attributes:
        offered: files that others may fetch, by their hash.
        identity: of this member.
        dropped: what was thrown away, by reason.
    """

    def __init__(
        self, network: MemoryControlNetwork, identity: Identity, *, started: int, seed: tuple[int, int]
    ) -> None:
        self.offered: dict[bytes, bytes] = {}
        self._network = network
        self.identity = identity
        self._writer = MessageWriter(identity, network.session, started=started)
        self._reader = MessageReader(identity.public, network.session)
        self._presence = Presence(identity, network.session, np.random.default_rng(seed).bytes, window=network.window)
        self._shunned = frozenset[bytes]()
        self.dropped = Counter[str]()
        self._inbox: list[tuple[float, int, bytes, bytes, bool]] = []
        self._received = list[SignedMessage]()
        self._relayed: list[tuple[float, int, Relayed]] = []
        self._asked: dict[bytes, float] = {}
        self._count = 0
        self._open = True

    @property
    def refused(self) -> Counter[MessageRefusal]:
        """How many messages were refused, by reason."""
        return self._reader.refused

    def send(self, topic: str, body: bytes, *, to: bytes | None = None) -> None:
        """Says something to one member, or to all others.

        Args:
            topic: what it is about.
            body: the message.
            to: public key of the receiver; None: all others.
        """
        self._writer.check(topic, body, to)
        if self._open:
            self._network.carry(self.identity.public, to, self._writer.write(topic, body, to))

    def poll(self) -> list[SignedMessage]:
        """What was said since the last call."""
        out, self._received = self._received, []
        return out

    def present(self) -> frozenset[bytes]:
        """Public keys of all others who show that they are there."""
        return self._presence.present(self._network.now) - self._shunned if self._open else frozenset()

    def shun(self, members: frozenset[bytes]) -> None:
        """From now on nothing of these members is taken."""
        self._shunned = members

    def offer(self, content: bytes) -> bytes:
        """Keeps a file for others to fetch; returns its SHA-256."""
        digest = hashlib.sha256(content).digest()
        self.offered[digest] = content
        return digest

    def fetch(self, digest: bytes) -> bytes | None:
        """A file that somebody offers: there and back after it was asked for."""
        if digest not in self.offered and self._open:
            asked = self._asked.setdefault(digest, self._network.now)
            content = self._network.content(digest, self.identity.public)
            if content is not None and self._network.now >= asked + 2.0 * self._network.delay:
                self.offer(content)
        return self.offered.get(digest)

    def relay(self, to: bytes, payload: bytes) -> bool:
        """Hands on a datagram.

        Args:
            to: public key of the receiver.
            payload: the datagram.
        """
        if not self._open or len(payload) > MOST_BYTES or to not in self.present():
            return False
        self._network.relay(self.identity.public, to, payload)
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
            self._beat(self._network.now, leaving=True)
            self._open = False
            self._received.clear()
            self._network.drop(self.identity.public)

    def turn(self, now: float) -> None:
        """Hears what has arrived, and says that it is there when that is due [s]."""
        while self._open and self._inbox and self._inbox[0][0] <= now:
            time, _, _, raw, beat = heapq.heappop(self._inbox)
            if beat:
                self._presence.receive(raw, time)
                continue
            read = self._reader.read(raw, time)
            if isinstance(read, SignedMessage) and read.sender in self._shunned:
                self.dropped["shunned"] += 1
            elif isinstance(read, SignedMessage):
                self._received.append(read)
        if self._presence.wait(now) == 0.0:
            self._beat(now)

    def deliver(self, time: float, sender: bytes, message: bytes, *, beat: bool = False) -> None:
        """Something that will arrive; the sender is the true one, whatever the message says.

        Args:
            time: when it arrives [s].
            sender: public key of who truly sent it.
            message: as it travels.
            beat: whether it only shows presence.
        """
        self._count += 1
        heapq.heappush(self._inbox, (time, self._count, sender, message, beat))

    def _beat(self, now: float, *, leaving: bool = False) -> None:
        raw = self._presence.beat(now, leaving=leaving)
        if raw is not None:
            self._network.carry(self.identity.public, None, raw, beat=True)

    def lose(self, sender: bytes) -> None:
        """What is on its way from a sender will not arrive."""
        now = self._network.now
        self._inbox = [item for item in self._inbox if item[0] <= now or item[2] != sender]
        heapq.heapify(self._inbox)

    def deliver_relayed(self, relayed: Relayed) -> None:
        """A datagram that will arrive."""
        self._count += 1
        heapq.heappush(self._relayed, (relayed.time, self._count, relayed))
