"""Samples by whatever way there is: two members on a virtual internet, with a control plane that relays."""

import random
import time

import numpy as np
import pytest
from tests.live.internet import Exchange, Internet, MemoryControl, Nat, VirtualSocket
from tests.live.support import agree, agreements, entropy, identities, layout, state_of
from tests.traversal.shown import asking

from cotouch.control import SignedMessage
from cotouch.errors import SessionError, TransportError
from cotouch.peer import Sample
from cotouch.samples import MOST_BYTES, Address, Arrival, Assembly, SampleLink, SamplePlane, UdpTransport, plain_address
from cotouch.traversal import ByRelay, Candidate, CandidateKind, PathChanged, PathState, RoutedTransport, write_offer

T = 0.004
MEMBER_BYTES, PAIR_BYTES = 56, 32  # of a question where one is, and of one whether the other is there
HOST = Address("203.0.113.1", 7000)


class Member:
    def __init__(self, world: "World", user: int, socket: VirtualSocket) -> None:
        self.socket = socket
        self.where: str | None = socket.address.host  # by which its machine reaches the others
        self.control: MemoryControl = world.exchange.join(identities(3)[user])
        self.transport = RoutedTransport(
            socket, self.control, session=b"session", secret=b"secret", entropy=entropy(50 + user),
            mirrors=[HOST], interfaces=lambda: [socket.address.host], here=lambda: self.where,
        )  # fmt: skip
        self.plane = SamplePlane(self.transport, world.shape, user=user, epoch=3)
        self.events: list[PathChanged] = []

    def poll(self, now: float) -> None:
        for message in self.control.poll():
            assert self.transport.take(message)
        self.plane.poll(now)
        self.plane.stepped(now)
        self.events += self.transport.events()


class World:
    """Users 0 and 1, neighbours; user 2 is the host, in public, whom they ask for their addresses."""

    def __init__(self, *nats: Nat | None, delay: float = 0.01, rows: int = 4) -> None:
        self.net = Internet(delay=delay)
        self.exchange = Exchange(lambda: self.net.now)
        self.shape = layout(rows, 3)
        self.step = 0
        sockets = [
            self.net.socket(f"10.{user}.0.2" if nat else f"198.51.100.{user + 10}", 5000, behind=nat)
            for user, nat in enumerate(nats)
        ]
        sockets.append(self.net.socket(*HOST))
        self.members = [Member(self, user, socket) for user, socket in enumerate(sockets)]
        self.pair = self.members[:2]
        for user, own in enumerate(agree(*agreements(*identities(2)))):
            first = identities(2)[0].public < identities(2)[1].public
            who = user if first else 1 - user
            link = SampleLink(Assembly(self.shape, sender=1 - who, initial=np.zeros((rows, 4))))
            link.seal.install(own)
            self.members[who].plane.connect(1 - who, link)
            self.members[who].transport.introduce(1 - who, identities(2)[1 - who].public)

    def run(self, seconds: float, until: PathState | None = None) -> "World":
        for _ in range(round(seconds / T)):
            self.net.now += T
            self.step += 1
            for member in self.members:
                member.poll(self.net.now)
            for member in self.pair:
                sample = Sample(
                    sender=member.plane.user, index=self.step, stamp=self.net.now - 0.5 * T,
                    position=state_of(self.shape, self.step),
                )  # fmt: skip
                member.plane.send(self.net.now, sample, T)
            if until is not None and self.paths == [until] * 2:
                return self
        assert until is None, self.paths
        return self

    @property
    def paths(self) -> list[PathState]:
        return [member.transport.path_state(1 - user) for user, member in enumerate(self.pair)]

    @property
    def ages(self) -> list[int]:
        """How many steps ago what each holds was sent."""
        return [self.step - member.plane.links[1 - user].assembly.newest for user, member in enumerate(self.pair)]


def nat(k: int, **law: object) -> Nat:
    return Nat(f"192.0.2.{k}", seed=k, **law)


@pytest.mark.parametrize("nats", [(None, None), (0, None), (None, 1), (0, 1)])
@pytest.mark.parametrize("nowhere", [0.0, 1.0, 4.0, 12.0])
def test_a_machine_that_gets_another_address_is_reached_straight_again(nats: tuple[int | None, ...], nowhere: float):
    """Its control plane is cut off with it, and comes back 2 s after the new address."""
    world = World(*(None if k is None else nat(k + 1) for k in nats))
    world.run(5.0, PathState.DIRECT)
    world.run(1.0)
    moved = world.members[0]
    old = moved.socket.address.host
    new = old.rpartition(".")[0] + ".77"
    moved.socket.hosts, moved.where = set(), None
    world.exchange.off.add(moved.control.identity.public)
    world.run(nowhere)
    moved.socket.hosts, moved.where = {new}, new
    world.run(2.0)
    world.exchange.off.clear()
    world.run(8.0)
    assert world.paths == [PathState.DIRECT] * 2
    assert moved.socket.address.host == new
    assert {candidate.address.host for candidate in moved.transport.candidates} >= {new}
    assert old not in {candidate.address.host for candidate in moved.transport.candidates}
    assert max(world.ages) <= 10


def test_an_address_that_cannot_be_listened_at_is_tried_again():
    world = World(None, None)
    world.run(5.0, PathState.DIRECT)
    moved = world.members[0]
    moved.where = "198.51.100.77"  # said to be the way out, but not up yet
    world.run(2.5)
    assert moved.socket.address.host != moved.where
    assert world.paths == [PathState.DIRECT] * 2
    moved.socket.hosts = {moved.where}
    world.run(3.0)
    assert moved.socket.address.host == moved.where
    assert world.paths == [PathState.DIRECT] * 2


def test_samples_flow_by_the_relay_until_nats_are_punched():
    world = World(nat(1), nat(2))
    world.run(0.05)
    assert world.paths == [PathState.TRYING] * 2
    assert max(world.ages) < 15
    world.run(5.0, PathState.DIRECT)
    world.run(5.0)
    assert max(world.ages) <= 10
    for user, member in enumerate(world.pair):
        assert member.transport.mapped == (Address(f"192.0.2.{user + 1}", 5000),)
        assert member.events == [
            PathChanged(1 - user, member.events[0].time, PathState.DIRECT, Address(f"192.0.2.{2 - user}", 5000))
        ]
        assert member.transport.relayed.sent > 0
        assert not member.transport.traffic.unsent
        assert not member.plane.refused


def test_random_ports_leave_the_relay_which_gets_what_it_bears():
    world = World(nat(1, kept=False), nat(2, kept=False)).run(10.0, PathState.RELAYED)
    before = [member.transport.relayed.sent for member in world.pair]
    world.run(10.0)
    assert max(world.ages) <= 12
    for member, then in zip(world.pair, before, strict=True):
        assert 900 <= member.transport.relayed.sent - then <= 1010
        assert member.plane.links[1 - member.plane.user].rate.rate == 100.0
        assert member.transport.direct.sent == 0


def test_states_of_many_chunks_are_relayed_less_often():
    world = World(nat(1, kept=False), nat(2, kept=False), rows=150)
    assert world.shape.chunks == 4
    world.run(5.0)
    member = world.pair[0]
    assert member.transport.capacity(1) == 100.0
    assert member.plane.links[1].rate.rate == 25.0


def test_the_rate_rises_again_on_the_direct_way():
    world = World(None, None).run(5.0, PathState.DIRECT)
    world.run(16.0)
    assert [member.plane.links[1 - user].rate.rate for user, member in enumerate(world.pair)] == [1000.0] * 2


def test_a_way_that_is_cut_falls_to_the_relay_and_returns():
    world = World(nat(1), nat(2)).run(5.0, PathState.DIRECT)
    hosts = {"192.0.2.1", "192.0.2.2"}
    world.net.cut = lambda source, to: {source, to} <= hosts
    world.run(12.0, PathState.RELAYED)
    world.run(1.0)
    assert max(world.ages) <= 12
    world.net.cut = lambda source, to: False
    world.run(60.0, PathState.DIRECT)
    world.run(2.0)
    assert max(world.ages) <= 10
    assert [event.path_state for event in world.pair[0].events] == [
        PathState.DIRECT,
        PathState.TRYING,
        PathState.RELAYED,
        PathState.DIRECT,
    ]


def test_a_nat_that_forgets_between_two_is_found_out_and_told():
    nats = nat(1), nat(2)
    world = World(*nats).run(5.0, PathState.DIRECT)
    nats[0].forget()
    world.run(3.0, PathState.TRYING)
    world.run(5.0, PathState.DIRECT)
    assert world.pair[0].transport.mapped == (Address("192.0.2.1", 6000),)
    assert world.pair[1].events[-1].address == Address("192.0.2.1", 6000)


def test_nobody_moves_a_way_by_repeating_a_sample():
    """The newest authentic datagram comes from elsewhere: it is asked there, and nothing more."""
    world = World(None, None).run(5.0, PathState.DIRECT)
    path_state = world.pair[1].events[-1].address
    mallory = world.net.socket("203.0.113.66", 6)
    carry = world.net.carry

    def hurry(sender, to, payload):
        """Mallory sees what user 0 sends and is quicker."""
        if sender is world.pair[0].socket and payload[0] == 0xC1:
            carry(mallory, to, payload)
        else:
            carry(sender, to, payload)

    world.net.carry = hurry
    world.run(5.0)
    assert max(world.ages) <= 10
    assert world.pair[1].events[-1].address == path_state
    assert not [arrival for arrival in mallory.poll() if arrival.payload[0] == 0xC1]


def test_who_is_only_heard_by_its_samples_is_asked_where_they_come_from():
    """Its NAT has forgotten, and its own pings are lost."""
    box = nat(1)
    world = World(box, None).run(5.0, PathState.DIRECT)
    box.forget()
    carry, socket = world.net.carry, world.pair[0].socket
    world.net.carry = lambda sender, to, payload: (
        None if sender is socket and payload[:2] == b"\xc2\3" else carry(sender, to, payload)
    )
    world.run(1.5)
    assert world.pair[1].events[-1].address == Address("192.0.2.1", 6000)


def test_who_comes_later_is_told_at_once(alone):
    net, exchange, transport, _ = alone
    other = exchange.join(identities(2)[1])
    transport.introduce(1, other.identity.public)
    transport.poll()
    assert len(other.poll()) == 1
    net.now = 1.0
    body = write_offer(bytes(16), [])
    for _ in range(3):
        transport.take(SignedMessage(other.identity.public, "path.candidates", body, True))
        transport.poll()
    assert len(other.poll()) == 1


def test_while_a_member_is_cut_off_from_all_nothing_breaks():
    world = World(nat(1), nat(2)).run(5.0, PathState.DIRECT)
    world.net.cut = lambda source, to: True
    world.exchange.off.add(world.pair[0].control.identity.public)
    world.run(12.0, PathState.RELAYED)
    assert world.pair[0].transport.relayed.unsent["relay"] > 0
    world.exchange.off.clear()
    world.net.cut = lambda source, to: False
    world.run(60.0, PathState.DIRECT)


def test_a_member_that_comes_back_is_found():
    """Same name and keys, another process: other words, another port."""
    world = World(nat(1), nat(2)).run(5.0, PathState.DIRECT)
    old = world.pair[0]
    old.transport.close()
    new = Member(world, 0, world.net.socket("10.0.0.2", 5001, behind=world.pair[0].socket.nat))
    link = old.plane.links[1]
    new.plane.connect(1, link)
    new.transport.introduce(1, identities(2)[1].public)
    world.members[0] = world.pair[0] = new
    world.run(1.0)
    world.run(10.0, PathState.DIRECT)
    assert new.transport.path_state(1) is PathState.DIRECT


def test_a_neighbour_that_is_forgotten_is_asked_nothing():
    world = World(None, None).run(5.0, PathState.DIRECT)
    for user, member in enumerate(world.pair):
        member.plane.disconnect(1 - user)
    world.net.log.clear()
    for _ in range(2000):
        world.net.now += T
        for member in world.members:
            member.poll(world.net.now)
    assert {len(payload) for *_, payload in world.net.log} <= {MEMBER_BYTES}
    assert not world.pair[0].transport.send(1, b"still there?")


@pytest.mark.parametrize("hosts", [("127.0.0.1", "127.0.0.1"), ("::1", "::1"), ("127.0.0.1", "::"), ("::1", "::")])
def test_over_real_sockets(hosts: tuple[str, str]):
    """IPv4, IPv6, and both; the second is asked for the first one's address."""
    exchange, members = Exchange(time.monotonic), identities(2)
    try:
        sockets = [UdpTransport(host=host) for host in hosts]
    except TransportError as error:
        pytest.skip(f"no such address here: {error}")
    at = Address(hosts[0], sockets[1].address.port)
    controls = [exchange.join(member) for member in members]
    transports = [
        RoutedTransport(
            sockets[user], controls[user], session=b"", secret=b"", entropy=entropy(user),
            mirrors=[at] if user == 0 else [], interfaces=lambda: ["127.0.0.1"],
        )
        for user in range(2)
    ]  # fmt: skip
    for user, transport in enumerate(transports):
        transport.introduce(1 - user, members[1 - user].public)
    got: list[Arrival] = []
    for k in range(1000):
        time.sleep(0.002)
        for user, transport in enumerate(transports):
            for message in controls[user].poll():
                transport.take(message)
            arrived = transport.poll()
            got += [arrival for arrival in arrived if arrival.payload == b"direct"]
            for arrival in arrived:
                transport.follow(1 - user, arrival.source)
        if [transport.path_state(1 - user) for user, transport in enumerate(transports)] == [PathState.DIRECT] * 2:
            transports[k % 2].send(1 - k % 2, b"direct")
        if len(got) >= 2 and transports[0].mapped:
            break
    assert {plain_address(arrival.source) for arrival in got} == {at, Address(hosts[0], sockets[0].address.port)}
    assert transports[0].mapped == (Address(hosts[0], sockets[0].address.port),)
    assert [transport.direct.sent for transport in transports] != [0, 0]
    for transport in transports:
        transport.close()


@pytest.fixture
def alone() -> tuple[Internet, Exchange, RoutedTransport, VirtualSocket]:
    net = Internet(delay=0.0)
    exchange = Exchange(lambda: net.now)
    socket = net.socket("198.51.100.1", 5000)
    transport = RoutedTransport(
        socket, exchange.join(identities(1)[0]), session=b"session", secret=b"secret", entropy=entropy(9),
    )  # fmt: skip
    return net, exchange, transport, socket


def test_probes_from_a_stranger_are_limited_before_they_are_looked_at(alone):
    net, _, transport, socket = alone
    stranger = net.socket("192.0.2.1", 5)
    _, question = asking()
    for _ in range(1000):
        stranger.reach(socket.address, question)
    assert transport.poll() == []
    assert transport.probes.received == 100
    assert len(stranger.poll()) == 100
    assert transport.probes.dropped["probe: too many"] == 900


def test_noise_that_looks_like_probes_changes_nothing_and_is_not_answered(alone):
    net, _, transport, socket = alone
    rng = random.Random(3)
    stranger = net.socket("192.0.2.1", 5)
    transport.introduce(1, identities(2)[1].public)
    for _ in range(5000):
        net.now += 0.01
        size = rng.choice([1, 2, PAIR_BYTES, MEMBER_BYTES, rng.randrange(1, MOST_BYTES)])
        stranger.reach(socket.address, bytes((0xC2, rng.randrange(6)))[:size] + rng.randbytes(max(0, size - 2)))
        assert transport.poll() == []
    assert transport.probes.received == 0
    assert sum(transport.probes.dropped.values()) == 5000
    assert stranger.poll() == []


def test_what_is_relayed_is_limited_and_checked(alone):
    _, exchange, transport, _ = alone
    other, stranger = exchange.join(identities(3)[1]), exchange.join(identities(3)[2])
    transport.introduce(1, other.identity.public)
    to = identities(1)[0].public
    for payload in (b"", bytes(MOST_BYTES + 1), b"\xc2 a probe by the relay", b"good"):
        other.relay(to, payload)
    for _ in range(500):
        stranger.relay(to, b"flood")
    arrived = transport.poll()
    assert arrived[0].payload == b"good"
    assert arrived[0].source == ByRelay(other.identity.public)
    assert len(arrived) == 1 + 64
    assert dict(transport.relayed.dropped) == {"size": 2, "probe": 1, "too many": 436}


def test_times_by_both_ways_are_in_order(alone):
    net, exchange, transport, socket = alone
    other = exchange.join(identities(3)[1])
    sender = net.socket("192.0.2.1", 5)
    net.now = 1.0
    sender.reach(socket.address, b"first")
    net.now = 1.1
    other.relay(identities(1)[0].public, b"second")
    net.now = 1.2
    sender.reach(socket.address, b"third")
    net.now = 1.3
    for text, then in ((b"from the future", 9.0), (b"from the past", -9.0)):
        exchange.clock = lambda then=then: then
        other.relay(identities(1)[0].public, text)
    arrived = transport.poll()
    assert [arrival.payload for arrival in arrived] == [
        b"from the past",
        b"first",
        b"second",
        b"third",
        b"from the future",
    ]
    assert [arrival.time for arrival in arrived] == [0.0, 1.0, 1.1, 1.2, 1.3]


def test_candidates_are_believed_of_the_neighbour_alone_and_only_in_private(alone):
    net, exchange, transport, _ = alone
    victim = net.socket("192.0.2.9", 9)
    members = identities(3)
    exchange.join(members[1])
    transport.introduce(1, members[1].public)
    body = write_offer(bytes(16), [Candidate(CandidateKind.LOCAL, victim.address)])
    for sender, direct in ((members[2], True), (members[1], False)):
        assert transport.take(SignedMessage(sender.public, "path.candidates", body, direct))
    assert transport.take(SignedMessage(members[1].public, "path.candidates", b"nonsense", True))
    assert not transport.take(SignedMessage(members[1].public, "roster", body, True))
    assert transport.probes.dropped["candidates"] == 2
    for _ in range(100):
        net.now += 0.02
        transport.poll()
    assert victim.poll() == []
    transport.take(SignedMessage(members[1].public, "path.candidates", body, True))
    for _ in range(2000):
        net.now += 0.02
        transport.poll()
    assert 12 <= len(victim.poll()) <= 12 + 4 * 3


@pytest.mark.parametrize(("listening", "host", "asked"), [
    ("198.51.100.1", "127.0.0.1", False), ("127.0.0.1", "127.0.0.1", True), ("0.0.0.0", "127.0.0.1", True),
    ("0.0.0.0", "2001:db8::1", False), ("::", "2001:db8::1", True), ("::", "192.0.2.1", True),
])  # fmt: skip
def test_addresses_beyond_this_socket_are_not_asked(listening: str, host: str, asked: bool):
    net = Internet(delay=0.0)
    exchange = Exchange(lambda: net.now)
    members = identities(2)
    transport = RoutedTransport(
        net.socket(listening, 5000), exchange.join(members[0]), session=b"", secret=b"", entropy=entropy(9),
        interfaces=list,
    )  # fmt: skip
    transport.introduce(1, members[1].public)
    body = write_offer(bytes(16), [Candidate(CandidateKind.LOCAL, Address(host, 7))])
    transport.take(SignedMessage(members[1].public, "path.candidates", body, True))
    transport.poll()
    assert [to.host for _, _, to, _ in net.log] == [host] * asked


def test_where_this_member_may_be_reached_is_looked_up_when_it_listens_everywhere():
    net = Internet(delay=0.0)
    exchange = Exchange(lambda: net.now)
    transport = RoutedTransport(
        net.socket("0.0.0.0", 5000), exchange.join(identities(1)[0]), session=b"", secret=b"", entropy=entropy(9),
        interfaces=lambda: ["127.0.0.1", "192.0.2.7", "fe80::1", "2001:db8::1"],
    )  # fmt: skip
    assert transport.candidates == (Candidate(CandidateKind.LOCAL, Address("192.0.2.7", 5000)),)


@pytest.mark.parametrize("make", [
    lambda alone: alone[2].introduce(1, b"short"),
    lambda alone: alone[2].introduce(1, identities(1)[0].public),
    lambda alone: alone[2].look([("example.org", 7000)]),
])  # fmt: skip
def test_what_cannot_be_is_refused(alone, make):
    with pytest.raises(SessionError):
        make(alone)
