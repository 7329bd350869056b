"""The control plane over Eclipse Zenoh with mutual TLS; see `ControlPlane`."""

import base64
import os
import threading
import time
from collections import Counter, deque
from collections.abc import Callable, Sequence
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, NamedTuple, final

from cotouch.live._certificates import make_certificates
from cotouch.live._control import Message, Relayed
from cotouch.live._files import Files
from cotouch.live._forward import Forwarder
from cotouch.live._introducer import Introducer
from cotouch.live._invitation import Endpoint, Invitation, checked
from cotouch.live._keys import Entropy, Identity
from cotouch.live._limit import Bucket, SourceLimit
from cotouch.live._listening import advertised, listening
from cotouch.live._sign import MOST_MESSAGE, MessageReader, MessageRefusal, MessageWriter, cost_of
from cotouch.live._transport import MOST_BYTES
from cotouch.live._zenoh import Mode, close_session, configuration, open_session
from cotouch.pacing import give_back_memory

if TYPE_CHECKING:
    import zenoh

# What is said, or heard and not polled, beyond this is dropped and counted [B].
_MOST_HELD = 64 << 20
_MOST_MESSAGES = 8192
_MOST_RELAYED = 4096
# Members that ever lived at a time, and a few restarts of each; who is invited can make up no more of them.
_MOST_ALIVE = 4096
# Below what others take of one sender, so that nothing said in a hurry is refused there.
_RATE, _BURST = 400.0, 900.0
# Datagrams of whom this member does not see come through the host, at a relay's rate and twice that.
_UNSEEN_RATE, _UNSEEN_BURST = 200.0, 64.0
# What links that came and went leave in pieces is given back so long after the first of them did [s].
_CALM = 5.0
_NOWHERE = "-"
# In place of a member's name in a key: everybody. Keys that are subscribed to have their subscriber's name, so that no
# two members subscribe to the same: Zenoh keeps what it knows of a member for ever if that had subscribed to a key that
# lives on here (5 kB for each that ever came; upstream issue 2393).
_EVERYBODY = "*"


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
    """

    def __init__(
        self,
        invitation: Invitation,
        identity: Identity,
        *,
        listen: Endpoint | str | None = None,
        routers: Sequence[Endpoint] | None = None,
        multicast: bool = False,
        lease: float = 1.5,
        started: int | None = None,
        entropy: Entropy = os.urandom,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Joins.

        Args:
            invitation: to the session.
            identity: of this member.
            listen: where this member listens: an endpoint; an address in numbers, then on any free port; `"reachable"`
                for the address by which this machine reaches the host. None: the host where the invitation says, the
                others on 127.0.0.1, where only members on the same machine find them.
            routers: instead of the invitation's.
            multicast: whether members are also looked for on the local network.
            lease: after which a silent member is gone [s].
            started: unix time; None: now [ns].
            entropy: gives so many bytes that nobody can guess.
            clock: gives the time of arrivals [s].

        Raises:
            SessionError: the address to listen on is none.
            TransportError: it is taken or not this machine's, or no router answers.
        """
        self.dropped = Counter[str]()
        self._identity = identity
        self._clock = clock
        self._me = identity.public.hex()
        self._prefix = f"cotouch/{invitation.id[:16].hex()}"
        self._writer = MessageWriter(identity, invitation.id, started=started or time.time_ns())
        self._reader = MessageReader(identity.public, invitation.id)
        self._lock = threading.Lock()  # among Zenoh's threads only
        self._inbox, self._heard_bytes, self._polled_bytes = deque[Message](), 0, 0
        self._outbox, self._said_bytes, self._sent_bytes = SimpleQueue[_Said | None](), 0, 0
        self._relays = deque[Relayed](maxlen=_MOST_RELAYED)
        self._relay_limit = SourceLimit(
            rate=4000.0, burst=1024.0, stranger_rate=_UNSEEN_RATE, stranger_burst=_UNSEEN_BURST
        )
        self._alive: dict[bytes, dict[str, Endpoint | None]] = {}
        self._present = frozenset[bytes]()
        self._changed: float | None = None  # when somebody came or went, since memory was given back
        self._closed = False

        routers = invitation.routers if routers is None else tuple(checked(router) for router in routers)
        mode: Mode = "client" if routers else "peer"
        host = identity.public == invitation.host
        at = () if routers else listening(invitation, listen, host=host)
        certificates = make_certificates(invitation, entropy=entropy)
        connect = routers or (() if host else invitation.endpoints)
        self._own = advertised(at[0], invitation) if at else None
        self._session = open_session(
            configuration(mode, certificates, listen=at, connect=connect, lease=lease, multicast=multicast)
        )
        self._introducer: Introducer | None = None
        if self._own is not None:

            def beside(endpoints: Sequence[Endpoint]) -> "zenoh.Session":
                return open_session(configuration("peer", certificates, connect=endpoints, lease=lease, dial=False))

            self._introducer = Introducer(self._own, beside, clock)
        self._files = Files(self._session, self._prefix, self._me)
        self._host = invitation.host
        self._forwarder = Forwarder(self._session, self._prefix, clock) if host else None
        self._declare(entropy)
        self._speaker = threading.Thread(target=self._speak, name="cotouch speaker", daemon=True)
        self._speaker.start()

    @property
    def identity(self) -> Identity:
        """Of this member."""
        return self._identity

    @property
    def endpoint(self) -> Endpoint | None:
        """Where others find this member; None behind routers."""
        return self._own

    @property
    def refused(self) -> Counter[MessageRefusal]:
        """How many messages were refused, by reason."""
        return self._reader.refused

    def send(self, topic: str, body: bytes, *, to: bytes | None = None) -> None:
        """Says something to one member, or to all others: a thread signs and sends it.

        Raises:
            SessionError: the topic, the body or the recipient cannot be.
        """
        self._writer.check(topic, body, to)
        if self._closed:
            self.dropped["closed"] += 1
        elif self._outbox.qsize() >= _MOST_MESSAGES or self._said_bytes - self._sent_bytes > _MOST_HELD:
            self.dropped["not sent yet"] += 1
        else:
            self._said_bytes += len(body)
            self._outbox.put(_Said(topic, body, to))

    def poll(self) -> list[Message]:
        """What was said since the last call."""
        out = list[Message]()
        while self._inbox:
            message = self._inbox.popleft()
            self._polled_bytes += len(message.body)
            out.append(message)
        return out

    def present(self) -> frozenset[bytes]:
        """Public keys of all others who are connected now, by their liveliness."""
        return frozenset() if self._closed else self._present

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
        """Hands on a datagram, through the host to whom this member does not see; dropped rather than queued."""
        import zenoh

        near = to in self._present
        if self._closed or len(payload) > MOST_BYTES or not (near or self._host in self._present):
            return False
        try:
            self._session.put(
                f"{self._prefix}/{'relay' if near else 'pass'}/{self._me}/{to.hex()}",
                payload,
                congestion_control=zenoh.CongestionControl.DROP,
                priority=zenoh.Priority.DATA_HIGH,
                express=True,
            )
        except zenoh.ZError:
            return False
        return True

    def relayed(self) -> list[Relayed]:
        """Datagrams that came this way since the last call, oldest first; of too many, the newest."""
        out = list[Relayed]()
        while self._relays:
            out.append(self._relays.popleft())
        return out

    def close(self) -> None:
        """Says what is still to be said, and leaves; waits a few seconds at most."""
        if self._closed:
            return
        self._closed = True
        self._outbox.put(None)
        self._speaker.join(1.0)
        users = [self._speaker, *self._files.threads]
        if self._introducer is not None:
            self._introducer.close()
            users.append(self._introducer.thread)
        self._files.close()
        close_session(self._session, [user for user in users if user.is_alive()])
        self._inbox.clear()
        self._relays.clear()

    def _declare(self, entropy: Entropy) -> None:
        """Listens first and then says that it is there: who sees a member can be heard by it."""
        import zenoh
        from zenoh.handlers import Callback

        others = zenoh.Locality.REMOTE
        # In Zenoh's own threads: the order of a sender's messages is kept, and a flood holds up its sender.
        for kind, hear in (("said", self._heard), ("relay", self._handed)):
            key = f"{self._prefix}/{kind}/*/{self._me}"
            self._session.declare_subscriber(key, Callback(hear, indirect=False), allowed_origin=others)
        self._session.liveliness().declare_subscriber(
            f"{self._prefix}/alive/*/*/*", Callback(self._lives, indirect=False), history=True
        )
        at = _NOWHERE if self._own is None else base64.urlsafe_b64encode(str(self._own).encode()).decode().rstrip("=")
        # A name of its own for every start: the end of an earlier one must not hide this one.
        self._token = self._session.liveliness().declare_token(
            f"{self._prefix}/alive/{self._me}/{entropy(8).hex()}/{at}"
        )

    def _speak(self) -> None:
        import zenoh

        limit = Bucket(_RATE, _BURST)
        while True:
            self._tidy()
            try:
                said = self._outbox.get(timeout=_CALM)
            except Empty:
                continue
            if said is None:
                return
            cost = cost_of(len(said.body) + 256)
            while not limit.take(time.monotonic(), cost):
                time.sleep(0.5 / _RATE)
            to = _EVERYBODY if said.to is None else said.to.hex()
            far = said.to is not None and said.to not in self._present and self._host in self._present
            try:
                self._session.put(
                    f"{self._prefix}/{'via' if far else 'said'}/{self._me}/{to}",
                    self._writer.write(*said),
                    congestion_control=zenoh.CongestionControl.BLOCK,
                    priority=zenoh.Priority.INTERACTIVE_HIGH,
                    express=True,
                )
            except zenoh.ZError:
                self.dropped["closed"] += 1
            self._sent_bytes += len(said.body)

    def _tidy(self) -> None:
        """Gives memory back some time after somebody came or went: Zenoh needs much for that, and for a moment."""
        if self._changed is not None and time.monotonic() >= self._changed + _CALM:
            self._changed = None
            give_back_memory()

    def _heard(self, sample: "zenoh.Sample") -> None:
        size = len(sample.payload)
        raw = sample.payload.to_bytes() if size <= MOST_MESSAGE else bytes(1)  # too long: not even copied
        with self._lock:
            message = self._reader.read(raw, self._clock())
            if isinstance(message, MessageRefusal):
                return
            if len(self._inbox) >= _MOST_MESSAGES or self._heard_bytes - self._polled_bytes > _MOST_HELD:
                self.dropped["not polled"] += 1
                return
            self._heard_bytes += len(message.body)
            self._inbox.append(message)

    def _handed(self, sample: "zenoh.Sample") -> None:
        now = self._clock()
        sender = _member(str(sample.key_expr).split("/")[3:4])
        size = len(sample.payload)
        with self._lock:
            if sender is None or size > MOST_BYTES or not self._relay_limit.take(now, sender, sender):
                self.dropped["relayed"] += 1
                return
        self._relays.append(Relayed(sample.payload.to_bytes(), sender, now))

    def _lives(self, sample: "zenoh.Sample") -> None:
        import zenoh

        parts = str(sample.key_expr).split("/")
        member = _member(parts[3:4])
        if member is None or member == self._identity.public or len(parts) != 6:
            return
        with self._lock:
            starts = self._alive.setdefault(member, {})
            if sample.kind == zenoh.SampleKind.PUT:
                if sum(map(len, self._alive.values())) < _MOST_ALIVE:
                    starts[parts[4]] = _endpoint(parts[5])
            else:
                starts.pop(parts[4], None)
            if not starts:
                del self._alive[member]
            self._present = frozenset(self._alive)
            self._follow(member, _endpoint(parts[5]))

    def _follow(self, member: bytes, at: Endpoint | None) -> None:
        """Tells those who care that a member came or went."""
        if self._changed is None:
            self._changed = time.monotonic()
        if member in self._present:
            self._relay_limit.know(member)
            if self._introducer is not None:
                self._introducer.back(member)
        else:
            self._relay_limit.unknow(member)
            self._reader.forget(member)
            # One of two introduces: the one with the greater key.
            if self._introducer is not None and at is not None and self._identity.public > member:
                self._introducer.gone(member, at)


def _member(parts: list[str]) -> bytes | None:
    try:
        out = bytes.fromhex(parts[0])
    except (ValueError, IndexError):
        return None
    return out if len(out) == 32 else None


def _endpoint(text: str) -> Endpoint | None:
    """Where a member says it listens; anybody invited can write anything there."""
    if text == _NOWHERE or len(text) > 400:
        return None
    try:
        return checked(Endpoint.parse(base64.urlsafe_b64decode(text + "=" * (-len(text) % 4)).decode()))
    except ValueError:  # of base64, of UTF-8, or of the endpoint
        return None
