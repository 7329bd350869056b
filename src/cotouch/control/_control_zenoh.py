"""The control plane over Eclipse Zenoh with mutual TLS; see `ControlPlane`."""

import os
import threading
import time
from collections import Counter
from collections.abc import Callable, Sequence
from queue import Empty
from typing import TYPE_CHECKING, NamedTuple, final

from cotouch.control._control import Relayed, SignedMessage
from cotouch.control._files import Files
from cotouch.control._forward import Forwarder
from cotouch.control._held import HeldQueue
from cotouch.control._invitation import Endpoint, Invitation
from cotouch.control._line import Line
from cotouch.control._listening import Whereabouts, listening
from cotouch.control._pairs import TAG_BYTES, PairTags
from cotouch.control._presence import MOST_BEAT, Presence
from cotouch.control._relays import Relays
from cotouch.control._sign import MOST_MESSAGE, MessageReader, MessageRefusal, MessageWriter, cost_of
from cotouch.control._sockets import tend_links
from cotouch.control._starts import Starts
from cotouch.control._zenoh import LEASE, put
from cotouch.control._zenoh_keys import Kind, SessionKeys, sender_of, start_of
from cotouch.errors import SessionError, TransportError
from cotouch.pacing import give_back_memory
from cotouch.samples import MOST_BYTES, Bucket, Identity

if TYPE_CHECKING:
    import zenoh

# Below what others take of one sender, so that nothing said in a hurry is refused there.
_RATE, _BURST = 400.0, 900.0
# What links that came and went leave in pieces is given back so long after the first of them did [s].
_CALM = 5.0
# Who is silent for this much longer than a connection takes to notice is gone: a return of 1.5 s and a lost beat [s].
_PATIENCE = 1.5
_SHORTEST = 0.02
# Connections are looked at so long after somebody came [s].
_SETTLED = 1.0


class _Said(NamedTuple):
    topic: str
    body: bytes
    to: bytes | None


@final
class ZenohControl:
    """One member's end of the control plane, over real networks.

    The host is the member whose public key the invitation names. It listens where the invitation says; the others dial
    it and, by gossip, each other, so they go on when it is gone. If there are routers, everybody dials these and nobody
    listens. Zenoh's threads hand over by queues, and only joining and leaving wait. To be used from one thread.

    Attributes:
        dropped: what was thrown away, by reason.
        identity: of this member.
    """

    def __init__(
        self,
        invitation: Invitation,
        identity: Identity,
        *,
        listen: Endpoint | str | None = None,
    ) -> None:
        """Joins.

        Args:
            invitation: to the session.
            identity: of this member.
            listen: where this member listens: an endpoint; an address in numbers, then on any free port; `"reachable"`
                for the address by which this machine reaches the host. None: the host where the invitation says, the
                others on 127.0.0.1, where only members on the same machine find them.

        Raises:
            SessionError: the address to listen on is none.
            TransportError: it is taken or not this machine's, or no router answers.
        """
        self.dropped = Counter[str]()
        self.identity = identity
        self._keys = SessionKeys(invitation, identity.public)
        self._writer = MessageWriter(identity, invitation.id, started=time.time_ns())
        self._reader = MessageReader(identity.public, invitation.id)
        self._lock = threading.Lock()  # among Zenoh's threads only
        self._inbox, self._outbox = HeldQueue[SignedMessage](), HeldQueue[_Said]()
        self._relays = Relays(identity, invitation.id, self.dropped)
        self._starts = Starts()
        self._near: frozenset[bytes] = (
            frozenset()
        )  # who is said to be connected: by anybody, so it only helps to choose a way
        self._shunned = frozenset[bytes]()
        self._presence = Presence(identity, invitation.id, os.urandom, window=LEASE + _PATIENCE)
        self._beating = threading.Event()
        self._changed: float | None = None  # when somebody came or went, since memory was given back
        self._closed = False

        routers = invitation.routers
        self._invitation, self._host = invitation, invitation.host
        host = identity.public == invitation.host
        # Who listens where this machine reaches the host goes where that goes.
        self._roams = listen == "reachable" and not routers and not host
        self._whereabouts, self._serviced = Whereabouts(None if host else invitation), 0.0

        def opened(at: Sequence[Endpoint]) -> Line:
            dialled = routers or (() if host else invitation.endpoints)
            return Line(invitation, at, mode="client" if routers else "peer", connect=dialled)

        self._opened = opened
        self._mover: threading.Thread | None = None
        self._line = opened(() if routers else listening(invitation, listen, host=host))
        self._files = Files(self._session, self._keys.prefix, self._keys.me)
        self._forwarder = (
            Forwarder(self._session, self._keys.prefix, PairTags(identity, invitation.id), time.monotonic)
            if host
            else None
        )
        self._declare(self._line)
        self._speaker = threading.Thread(target=self._speak, name="cotouch speaker", daemon=True)
        self._speaker.start()
        # Of its own, and dropped rather than waited for: who does not read holds up no other's beats.
        self._heart = threading.Thread(target=self._beat, name="cotouch presence", daemon=True)
        self._heart.start()

    @property
    def endpoint(self) -> Endpoint | None:
        """Where others find this member; None behind routers."""
        return self._line.own

    @property
    def _session(self) -> "zenoh.Session":
        return self._line.session

    @property
    def refused(self) -> Counter[MessageRefusal]:
        """How many messages were refused, by reason."""
        return self._reader.refused

    @property
    def corrupt(self) -> Counter[str]:
        """How often a file had another hash than it was served under, by the server's public key in hexadecimal."""
        return self._files.corrupt

    def send(self, topic: str, body: bytes, *, to: bytes | None = None) -> None:
        """Says something to one member, or to all others: a thread signs and sends it.

        Args:
            topic: what it is about.
            body: the message.
            to: public key of the receiver; None: all others.

        Raises:
            SessionError: the topic, the body or the recipient cannot be.
        """
        self._writer.check(topic, body, to)
        if self._closed:
            self.dropped["closed"] += 1
        elif not self._outbox.put(_Said(topic, body, to), len(body)):
            self.dropped["not sent yet"] += 1

    def poll(self) -> list[SignedMessage]:
        """What was said since the last call."""
        return self._inbox.drain()

    def present(self) -> frozenset[bytes]:
        """Public keys of all others who show that they are there."""
        return frozenset() if self._closed else self._presence.present(time.monotonic()) - self._shunned

    def shun(self, members: frozenset[bytes]) -> None:
        """From now on nothing of these members is taken or handed on, and of nobody else."""
        self._shunned = members
        if self._forwarder is not None:
            self._forwarder.shunned = members

    def offer(self, content: bytes) -> bytes:
        """Keeps a file for others to fetch; returns its SHA-256.

        Raises:
            SessionError: it has more than 256 MB.
        """
        return self._files.offer(content)

    def fetch(self, digest: bytes) -> bytes | None:
        """A file that somebody offers, once it is here and its hash is right; None: it has been asked for.

        Raises:
            SessionError: this is no SHA-256, or 64 others are wanted.
        """
        return self._files.fetch(digest)

    def relay(self, to: bytes, payload: bytes) -> bool:
        """Hands on a datagram, through the host to whom this member does not see; dropped rather than queued.

        Args:
            to: public key of the receiver.
            payload: the datagram.
        """
        near = to in self._near
        if self._closed or len(payload) > MOST_BYTES or not (near or self._host in self._near):
            return False
        tagged = self._relays.tagged(payload, to)
        return put(
            self._session,
            self._keys.to("relay" if near else "pass", to),
            tagged if near else self._relays.tagged(tagged, self._host),
            priority="DATA_HIGH",
        )

    def relayed(self) -> list[Relayed]:
        """Datagrams that came this way since the last call, oldest first; of too many, the newest."""
        return self._relays.poll()

    def close(self) -> None:
        """Says what is still to be said, and leaves; waits a few seconds at most."""
        with self._lock:
            if self._closed:
                return
            self._closed = True
        self._outbox.end()
        self._speaker.join(1.0)
        self._beating.set()
        self._heart.join(1.0)
        if self._mover is not None:  # it lets go of what it opened meanwhile
            self._mover.join(1.0)
        self._files.close()
        self._line.close([self._speaker, self._heart, *self._files.threads])
        self._inbox.drain()
        self._relays.poll()

    def _declare(self, line: Line) -> None:
        """Listens first and then says that it is there: who sees a member can be heard by it."""
        import zenoh
        from zenoh.handlers import Callback

        others = zenoh.Locality.REMOTE

        def lives(sample: zenoh.Sample) -> None:
            self._lives(sample, line)

        # In Zenoh's own threads: the order of a sender's messages is kept, and a flood holds up its sender.
        keys = self._keys
        received: dict[Kind, Callable[[zenoh.Sample], None]]
        received = {"said": self._received, "relay": self._handed, "beat": self._beaten}
        for kind, receive in received.items():
            line.session.declare_subscriber(keys.mine(kind), Callback(receive, indirect=False), allowed_origin=others)
        line.session.liveliness().declare_subscriber(keys.starts, Callback(lives, indirect=False), history=True)
        # A name of its own for every start: the end of an earlier one must not hide this one.
        line.show(keys.start(os.urandom(8).hex(), line.own))

    def _speak(self) -> None:
        limit = Bucket(_RATE, _BURST)
        while True:
            self._tidy()
            try:
                said = self._outbox.take(_CALM)
            except Empty:
                continue
            if said is None:
                return
            cost = cost_of(len(said.body) + 256)
            while not limit.take(time.monotonic(), cost):
                time.sleep(0.5 / _RATE)
            far = said.to is not None and said.to not in self._near and self._host in self._near
            written = self._writer.write(*said)
            if not put(
                self._session,
                self._keys.to("via" if far else "said", said.to),
                self._relays.tagged(written, self._host) if far else written,
                priority="INTERACTIVE_HIGH",
                wait=True,
            ):
                self.dropped["closed"] += 1

    def _beat(self) -> None:
        while True:
            with self._lock:
                leaving = self._closed
                beat = self._presence.beat(time.monotonic(), leaving=leaving)
                wait = self._presence.wait(time.monotonic())
            if beat is not None and not put(self._session, self._keys.to("beat"), beat, priority="INTERACTIVE_LOW"):
                self.dropped["closed"] += 1
            if leaving:
                return
            self._look_around()
            self._beating.wait(max(wait, _SHORTEST))
            self._beating.clear()

    def _look_around(self) -> None:
        """Tends connections that are new, and goes where this machine is when its address is another."""
        now = time.monotonic()
        if self._serviced and now >= self._serviced:
            self._serviced = 0.0
            tend_links()
        if self._mover is not None and self._mover.is_alive():
            return
        here = self._whereabouts.look(now)
        if here is None:
            return
        before = self._whereabouts.here
        if self._roams:
            self._mover = threading.Thread(target=self._move, args=(here,), name="cotouch mover")
            self._mover.start()
        else:
            self._whereabouts.here = here
        tend_links(before)

    def _move(self, host: str) -> None:
        """Listens there from now on. Zenoh keeps the address that it began with, so it begins anew."""
        try:
            line = self._opened(listening(self._invitation, host, host=False))
        except (SessionError, TransportError):  # gone again, or not quite there: looked at again
            return
        with self._lock:
            closed, before = self._closed, self._line
            if not closed:
                self._whereabouts.here, self._line = host, line
                for member in self._starts.members:
                    self._relays.unknow(member)
                self._starts, self._near = Starts(), frozenset()
        if not closed:
            self._declare(line)
            self._files.move(line.session)
        (line if closed else before).close()

    def _beaten(self, sample: "zenoh.Sample") -> None:
        if len(sample.payload) > MOST_BEAT:
            return
        with self._lock:
            now = time.monotonic()
            before = self._presence.wait(now)
            self._presence.receive(sample.payload.to_bytes(), now)
            if self._presence.wait(now) < before:
                self._beating.set()

    def _tidy(self) -> None:
        """Gives memory back some time after somebody came or went: Zenoh needs much for that, and for a moment."""
        if self._changed is not None and time.monotonic() >= self._changed + _CALM:
            self._changed = None
            give_back_memory()

    def _received(self, sample: "zenoh.Sample") -> None:
        size = len(sample.payload)
        raw = sample.payload.to_bytes() if size <= MOST_MESSAGE else bytes(1)  # too long: not even copied
        with self._lock:
            if raw[4:36] in self._shunned:
                self.dropped["shunned"] += 1
                return
            message = self._reader.read(raw, time.monotonic())
            if isinstance(message, MessageRefusal):
                return
            if not self._inbox.put(message, len(message.body)):
                self.dropped["not polled"] += 1

    def _handed(self, sample: "zenoh.Sample") -> None:
        sender = sender_of(str(sample.key_expr))
        raw = sample.payload.to_bytes() if len(sample.payload) <= MOST_BYTES + TAG_BYTES else b""
        self._relays.take(None if sender in self._shunned else sender, raw, time.monotonic())

    def _lives(self, sample: "zenoh.Sample", line: Line) -> None:
        import zenoh

        start = start_of(str(sample.key_expr))
        if start is None or start.member == self.identity.public:
            return
        with self._lock:
            if line is not self._line:  # as seen from where this member was
                return
            self._starts.take(start, alive=sample.kind == zenoh.SampleKind.PUT)
            self._near = self._starts.members
            self._follow(start.member, start.at)

    def _follow(self, member: bytes, at: Endpoint | None) -> None:
        """Tells those who care that a member came or went."""
        now = time.monotonic()
        self._changed = self._changed or now
        self._serviced = self._serviced or now + _SETTLED
        if member in self._near:
            self._relays.know(member)
            self._line.back(member)
        else:
            self._relays.unknow(member)
            self._reader.forget(member)
            if self.identity.public > member:  # one of two introduces
                self._line.gone(member, at)
