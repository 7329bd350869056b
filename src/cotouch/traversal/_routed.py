"""Each neighbour by the straightest way that works: its own address, or the control plane's relay."""

from collections import deque
from collections.abc import Callable, Hashable, Sequence
from typing import final

from cotouch.control import ControlPlane, SignedMessage
from cotouch.errors import SessionError
from cotouch.samples import (
    MOST_BYTES,
    Address,
    AddressedTransport,
    Arrival,
    Entropy,
    SourceLimit,
    Traffic,
    origin,
    plain_address,
)
from cotouch.traversal._addresses import Addresses, Place
from cotouch.traversal._candidates import TOPIC, Candidate, read_offer, write_offer
from cotouch.traversal._interfaces import interface_hosts
from cotouch.traversal._own_candidates import OwnCandidates
from cotouch.traversal._path_prober import PathProber, PathState
from cotouch.traversal._paths import ByRelay, Known, PathChanged
from cotouch.traversal._probe import MEMBER_BYTES, PAIR_NONCE_BYTES, PROBE, Kind, label_of, member_key, pair_keys
from cotouch.traversal._reflexive import Lookup, Mirror

# Candidates are said at most this often [s].
_TELL_LEAST = 0.5
# A neighbour that was sent nothing for this long is idle.
_ACTIVE = 1.0
_MOST_EVENTS = 256
# Ways are tended at most this often, however often arrivals are looked for.
_SERVICE = 0.002
# Datagrams to a neighbour by the relay, at most [1/s].
_RELAY_RATE = 100.0


@final
class RoutedTransport:
    """Samples straight to neighbours that answer at one of their addresses, and over the relay to others.

    See `Transport`. A neighbour that was introduced is sent to where it answers, whatever address a datagram of it came
    from: `follow` only says where to ask. One that was not introduced is followed as the socket would. `poll` is to be
    called often, for it also asks and answers: once per step, and 20 times a second at least.

    Attributes:
        direct: what went through the socket, without probes.
        relayed: what went by the relay.
        probes: what was sent and taken to find ways.
    """

    def __init__(
        self,
        socket: AddressedTransport,
        control: ControlPlane,
        *,
        session: bytes,
        secret: bytes,
        entropy: Entropy,
        mirrors: Sequence[Address] = (),
        interfaces: Callable[[], Sequence[str]] = interface_hosts,
        addresses: Addresses | None = None,
        here: Callable[[], str | None] | None = None,
    ) -> None:
        """Begins without neighbours.

        Args:
            socket: of the samples; closed with this.
            control: carries candidates, and what has no other way; it is its owner's to close and to poll.
            session: what names the session.
            secret: what only invited members know.
            entropy: gives so many bytes that nobody can guess, such as `os.urandom`.
            mirrors: who is asked for this member's own address: the host's sample socket, as members reach it.
            interfaces: gives the hosts of this machine's interfaces.
            addresses: tells members what shows where they are, if this is the host's.
            here: gives the address by which this machine reaches the others now, None where it does not; the socket
                goes where that goes. None: the socket stays.

        Raises:
            SessionError: a mirror is no address in numbers.
        """
        self.direct, self.relayed, self.probes = Traffic(), Traffic(), Traffic()
        self._socket, self._control = socket, control
        self._session, self._secret, self._entropy = session, secret, entropy
        key = member_key(secret, session)
        self._mirror, self._lookup = Mirror(key, addresses), Lookup(key, entropy, control.identity.public)
        self._own = OwnCandidates(socket, self._lookup, interfaces, here)
        self._neighbours: dict[int, Known] = {}
        self._labels: dict[int, int] = {}
        self._by_relay: dict[int, bytes] = {}  # neighbours that were not introduced
        self._probe_limit = SourceLimit(rate=200.0, burst=100.0, stranger_rate=200.0, stranger_burst=100.0)
        self._relay_limit = SourceLimit(rate=4096.0, burst=4096.0, stranger_rate=200.0, stranger_burst=64.0)
        self._events: deque[PathChanged] = deque(maxlen=_MOST_EVENTS)
        self._last, self._serviced = socket.now(), -float("inf")
        self._open = True
        self.look(mirrors)
        self._look_around(self._last)

    @property
    def traffic(self) -> Traffic:
        """What went through so far, by all ways; probes are not in it."""
        below, both = self._socket.traffic, self.direct + self.relayed
        both.unsent += below.unsent
        both.dropped += below.dropped + self.probes.dropped
        return both

    @property
    def candidates(self) -> tuple[Candidate, ...]:
        """Where this member may be reached, as neighbours are told."""
        return tuple(self._own.told)

    @property
    def mapped(self) -> tuple[Address, ...]:
        """Where others see this one; two with one host are a NAT through which nobody can punch."""
        return tuple(self._lookup.addresses)

    @property
    def place(self) -> Place | None:
        """What shows the host where this member is; None: nothing yet."""
        return self._lookup.place

    def look(self, mirrors: Sequence[Address]) -> None:
        """Whom to ask for this member's own address from now on.

        Raises:
            SessionError: one is no address in numbers.
        """
        found = [(mirror, plain_address(tuple(mirror))) for mirror in mirrors]
        for mirror, address in found:
            if address is None:
                raise SessionError(f"mirror {mirror!r} is not a numeric address and a port; resolve it first")
        self._lookup.look([address for _, address in found if address is not None])

    def introduce(self, neighbour: int, member: bytes) -> None:
        """From now on ways to this neighbour are looked for; it is reached by the relay meanwhile. Again: no change.

        Args:
            neighbour: index of the user.
            member: its public key.

        Raises:
            SessionError: this is no public key, or this member's own.
        """
        if len(member) != 32 or member == self._control.identity.public:
            raise SessionError(f"neighbour {neighbour} needs a public key of 32 bytes that is not this member's own")
        known = self._neighbours.get(neighbour)
        if known is None or known.member != member:
            self.forget(neighbour)
            self._neighbours[neighbour] = Known(member, self._entropy(PAIR_NONCE_BYTES), PathProber(self._socket.now()))
            self._relay_limit.know(ByRelay(member))

    def path_state(self, neighbour: int) -> PathState:
        """How a neighbour that was introduced is reached now."""
        return self._neighbours[neighbour].path_state

    def round_trip(self, neighbour: int) -> float | None:
        """Quickest way there and back of the last 20 s to one that was introduced; None if it is not direct [s]."""
        known = self._neighbours.get(neighbour)
        return None if known is None else known.prober.quickest

    def events(self) -> list[PathChanged]:
        """What changed since the last call; of too much the newest."""
        out = list(self._events)
        self._events.clear()
        return out

    def take(self, message: SignedMessage) -> bool:
        """Takes a message of the control plane; whether it was one about ways."""
        if message.topic != TOPIC:
            return False
        now = self._socket.now()
        offer = read_offer(message.body) if message.direct else None
        if offer is None:
            self.probes.dropped["candidates"] += 1
            return True
        for why, count in offer.refused.items():
            self.probes.dropped[f"candidate: {why}"] += count
        for neighbour, known in self._neighbours.items():
            if known.member != message.sender:
                continue
            if offer.nonce != known.theirs:
                known.theirs = offer.nonce
                known.tell = now  # it may not have ours
                self._rekey(neighbour, known)
            known.prober.offer([candidate for candidate in offer.candidates if self._own.reaches(candidate)])
        return True

    def send(self, neighbour: int, payload: bytes) -> bool:
        """Hands a datagram to the socket or the relay; never waits.

        Args:
            neighbour: slot of the neighbour.
            payload: the datagram.
        """
        known = self._neighbours.get(neighbour)
        member = self._by_relay.get(neighbour) if known is None else known.member
        by = self.direct if member is None or (known is not None and known.address is not None) else self.relayed
        why = "closed" if not self._open else "too long" if len(payload) > MOST_BYTES else None
        if why is not None:
            by.unsent[why] += 1
            return False
        if known is not None:
            known.sent = self._last
        if member is None:
            done = self._socket.send(neighbour, payload)  # and counts why not
        elif known is not None and known.address is not None:
            done = self._socket.reach(known.address, payload)
            by.unsent.update(() if done else ("system",))
        else:
            done = self._control.relay(member, payload)
            by.unsent.update(() if done else ("relay",))
        if done:
            by.count_sent(payload)
        return done

    def capacity(self, neighbour: int) -> float:
        """Datagrams per second that the way to a neighbour is to be given at most."""
        known = self._neighbours.get(neighbour)
        if known is None:
            return _RELAY_RATE if neighbour in self._by_relay else float("inf")
        return float("inf") if known.address is not None else _RELAY_RATE

    def poll(self) -> list[Arrival]:
        """Everything that arrived since the last call, oldest first; also looks for ways."""
        if not self._open:
            return []
        out: list[Arrival] = []
        for arrival in self._socket.poll():
            if arrival.payload[0] == PROBE:
                self._probe(arrival)
            else:
                self.direct.count_received(arrival.payload)
                out.append(arrival)
        now = self._socket.now()
        if came := self._relayed(now):
            out = sorted(out + came, key=lambda arrival: arrival.time)
        if now >= self._serviced + _SERVICE:
            self._serviced = now
            self._service(now)
        self._last = now
        return out

    def follow(self, neighbour: int, source: Hashable) -> None:
        """The neighbour's newest authentic datagram came from there: an address, or `ByRelay`.

        Args:
            neighbour: slot of the neighbour.
            source: where it came from.

        Raises:
            SessionError: this is no address, or one that the socket cannot reach.
        """
        known = self._neighbours.get(neighbour)
        if isinstance(source, ByRelay):
            # Of one that was introduced, the member is known better than from whoever handed on its datagram.
            if known is None and self._by_relay.get(neighbour) != source.member:
                self.forget(neighbour)
                self._by_relay[neighbour] = source.member
                self._relay_limit.know(source)
            return
        if known is not None and known.received is not None and known.received[0] == source:
            known.prober.learn(self._last, known.received[1])
            return
        self._socket.follow(neighbour, source)  # its datagrams from there are no stranger's
        self._by_relay.pop(neighbour, None)
        address = plain_address(source)
        if known is not None and address is not None:
            known.received = (source, address)
            known.prober.learn(self._last, address)

    def forget(self, neighbour: int) -> None:
        """The neighbour left."""
        self._socket.forget(neighbour)
        known = self._neighbours.pop(neighbour, None)
        if known is not None and known.label is not None:
            self._labels.pop(known.label, None)
        member = self._by_relay.pop(neighbour, None) if known is None else known.member
        used = {*self._by_relay.values(), *(other.member for other in self._neighbours.values())}
        if member is not None and member not in used:
            self._relay_limit.unknow(ByRelay(member))

    def close(self) -> None:
        """Closes the socket; the control plane stays."""
        self._open = False
        self._socket.close()

    def _probe(self, arrival: Arrival) -> None:
        source, datagram, dropped = plain_address(arrival.source), arrival.payload, self.probes.dropped
        if source is None or len(datagram) < 2:
            dropped["probe: shape"] += 1
            return
        if not self._probe_limit.take(arrival.time, source, origin(source.host)):
            dropped["probe: too many"] += 1
            return
        answer: tuple[Address, bytes] | None = None
        if (label := label_of(datagram)) is not None:
            neighbour = self._labels.get(label)
            if neighbour is None:
                dropped["probe: label"] += 1
                return
            prober = self._neighbours[neighbour].prober
            before = prober.refused
            answer = prober.receive(arrival.time, datagram, source)
            if prober.refused > before:
                dropped["probe: refused"] += 1
                return
            self._note(arrival.time, neighbour)
        elif len(datagram) == MEMBER_BYTES and datagram[1] == Kind.TELL:
            before = self._lookup.addresses
            if not self._lookup.take(arrival.time, datagram, source):
                dropped["probe: refused"] += 1
                return
            if self._lookup.addresses != before:
                self._look_around(arrival.time)
        else:
            announced = self._mirror.answer(datagram, source)
            if announced is None:
                dropped["probe: refused"] += 1
                return
            answer = (source, announced)
        self.probes.count_received(datagram)
        if answer is not None:
            self._out(*answer)

    def _relayed(self, now: float) -> list[Arrival]:
        out: list[Arrival] = []
        for payload, sender, time in self._control.relayed():
            source = ByRelay(sender)
            if not self._relay_limit.take(now, source, sender):
                self.relayed.dropped["too many"] += 1
            elif not 0 < len(payload) <= MOST_BYTES or payload[0] == PROBE:
                self.relayed.dropped["size" if payload[:1] != bytes((PROBE,)) else "probe"] += 1
            else:
                out.append(Arrival(payload, source, min(max(time, self._last), now)))
                self.relayed.count_received(payload)
        return out

    def _service(self, now: float) -> None:
        """Sends what is due: questions, pings, candidates."""
        if self._own.follow(now):
            for known in self._neighbours.values():
                known.prober.moved()
                known.tell = now
            self._look_around(now)
        for to, question in self._lookup.due(now):
            self._out(to, question)
        for neighbour, known in self._neighbours.items():
            for to, payload in known.prober.due(now, active=now - known.sent < _ACTIVE):
                self._out(to, payload)
            self._note(now, neighbour)
            if now >= max(known.tell, known.announced + _TELL_LEAST):
                known.announced = now
                known.tell = now + self._own.telling(now, direct=known.path_state is PathState.DIRECT)
                self._control.send(TOPIC, write_offer(known.nonce, self._own.told), to=known.member)

    def _note(self, now: float, neighbour: int) -> None:
        """Takes over which way the prober has come to."""
        known = self._neighbours[neighbour]
        prober = known.prober
        if known.path_state is prober.path_state and known.address == prober.address:
            return
        lost = known.path_state is PathState.DIRECT and prober.path_state is not PathState.DIRECT
        known.path_state, known.address = prober.path_state, prober.address
        self._events.append(PathChanged(neighbour, now, known.path_state, known.address))
        if lost:  # perhaps this machine is elsewhere now, or its NAT has forgotten
            known.tell = now
            self._lookup.hurry(now)
            self._look_around(now)

    def _rekey(self, neighbour: int, known: Known) -> None:
        if known.label is not None:
            self._labels.pop(known.label, None)
        keys = pair_keys(
            secret=self._secret,
            session=self._session,
            own=self._control.identity.public,
            other=known.member,
            own_nonce=known.nonce,
            other_nonce=known.theirs,
        )
        known.label = keys.receiving[0]
        self._labels[known.label] = neighbour
        known.prober.rekey(keys)

    def _look_around(self, now: float) -> None:
        """Finds out where this member may be reached; neighbours are told if that has changed."""
        if self._own.look(now):
            for known in self._neighbours.values():
                known.tell = now

    def _out(self, to: Address, payload: bytes) -> None:
        if self._socket.reach(to, payload):
            self.probes.count_sent(payload)
        else:
            self.probes.unsent["system"] += 1
