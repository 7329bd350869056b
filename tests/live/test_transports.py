"""One suite for every transport: whoever adds one adds a line to TRANSPORTS."""

import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

import pytest
from tests.live.internet import Exchange
from tests.live.support import entropy, identities
from tests.samples.memory import MemoryNetwork

from cotouch.errors import SessionError, TransportError
from cotouch.samples import MOST_BYTES, Address, Arrival, Transport, UdpTransport
from cotouch.traversal import ByRelay, RoutedTransport


class Pair(NamedTuple):
    """Two transports that know each other as neighbours 1 and 2, and a third that nobody knows."""

    one: Transport
    two: Transport
    stranger: Transport
    wait: Callable[[], None]
    move: Callable[[Transport], Transport]


def in_memory() -> Iterator[Pair]:
    network = MemoryNetwork()
    one, two, stranger = (network.join(name) for name in ("one", "two", "three"))

    def wait() -> None:
        network.now += 0.01

    def move(transport: Transport) -> Transport:
        transport.move("elsewhere")
        return transport

    one.follow(2, "two")
    two.follow(1, "one")
    stranger.follow(2, "two")
    yield Pair(one, two, stranger, wait, move)
    for transport in (one, two, stranger):
        transport.close()


def over_udp(host: str) -> Iterator[Pair]:
    try:
        one, two, stranger = (UdpTransport(host=host) for _ in range(3))
    except TransportError as error:
        pytest.skip(f"no such address here: {error}")
    opened = [one, two, stranger]

    def wait() -> None:
        time.sleep(0.005)

    def move(transport: Transport) -> Transport:
        other = UdpTransport(host=host)
        other.follow(2, two.address)
        transport.close()
        opened.append(other)
        return other

    one.follow(2, two.address)
    two.follow(1, one.address)
    stranger.follow(2, two.address)
    yield Pair(one, two, stranger, wait, move)
    for transport in opened:
        transport.close()


def routed(*, relayed: bool) -> Iterator[Pair]:
    """Either by the sockets or by the relay; nobody was introduced, so everybody is followed."""
    exchange, opened = Exchange(time.monotonic), list[RoutedTransport]()
    members = identities(4)

    def make() -> RoutedTransport:
        control = exchange.join(members[len(opened)])
        opened.append(RoutedTransport(UdpTransport(), control, session=b"", secret=b"", entropy=entropy(1)))
        return opened[-1]

    def at(member: int) -> object:
        return ByRelay(members[member].public) if relayed else opened[member]._socket.address

    def wait() -> None:
        time.sleep(0.0 if relayed else 0.005)

    def move(transport: Transport) -> Transport:
        other = make()
        other.follow(2, at(1))
        transport.close()
        return other

    one, two, stranger = make(), make(), make()
    one.follow(2, at(1))
    two.follow(1, at(0))
    stranger.follow(2, at(1))
    yield Pair(one, two, stranger, wait, move)
    for transport in opened:
        transport.close()


TRANSPORTS = {
    "memory": in_memory,
    "udp": lambda: over_udp("127.0.0.1"),
    "udp6": lambda: over_udp("::1"),
    "routed": lambda: routed(relayed=False),
    "relayed": lambda: routed(relayed=True),
}


@pytest.fixture(params=TRANSPORTS)
def pair(request: pytest.FixtureRequest) -> Iterator[Pair]:
    yield from TRANSPORTS[request.param]()


def collect(pair: Pair, at: Transport, count: int) -> list[Arrival]:
    """So many arrivals, or fewer if they do not come."""
    arrived: list[Arrival] = []
    for _ in range(200):
        pair.wait()
        arrived += at.poll()
        if len(arrived) >= count:
            break
    return arrived


def test_what_is_sent_arrives_whole(pair: Pair):
    sent = [b"x", bytes(range(256)), b"\0" * MOST_BYTES]
    assert all(pair.one.send(2, payload) for payload in sent)
    assert sorted(arrival.payload for arrival in collect(pair, pair.two, 3)) == sorted(sent)


def test_polling_an_empty_network_does_not_wait(pair: Pair):
    assert pair.two.poll() == []


def test_one_poll_takes_all_that_arrived(pair: Pair):
    for k in range(300):
        pair.one.send(2, k.to_bytes(2, "big"))
    for _ in range(20):
        pair.wait()
    assert len({arrival.payload for arrival in pair.two.poll()}) == 300
    assert pair.two.poll() == []


def test_the_reply_to_a_source_reaches_it(pair: Pair):
    pair.stranger.send(2, b"who am I")
    (arrival,) = collect(pair, pair.two, 1)
    pair.two.follow(7, arrival.source)
    assert pair.two.send(7, b"you")
    assert [back.payload for back in collect(pair, pair.stranger, 1)] == [b"you"]


def test_a_neighbour_is_followed_to_its_new_address(pair: Pair):
    pair.one.send(2, b"old")
    (old,) = collect(pair, pair.two, 1)
    moved = pair.move(pair.one)
    moved.send(2, b"new")
    (new,) = collect(pair, pair.two, 1)
    assert new.source != old.source
    pair.two.follow(1, new.source)
    pair.two.send(1, b"found")
    assert [back.payload for back in collect(pair, moved, 1)] == [b"found"]


def test_arrival_alone_moves_nobody(pair: Pair):
    pair.stranger.send(2, b"I am neighbour 1")
    collect(pair, pair.two, 1)
    pair.two.send(1, b"to the true one")
    assert [arrival.payload for arrival in collect(pair, pair.one, 1)] == [b"to the true one"]
    assert pair.stranger.poll() == []


def test_times_of_arrival_do_not_run_backwards(pair: Pair):
    times = []
    for _ in range(50):
        pair.one.send(2, b"now")
        times += [arrival.time for arrival in collect(pair, pair.two, 1)]
    assert times == sorted(times)
    assert len(times) == 50


@pytest.mark.parametrize(("payload", "reason"), [(bytes(MOST_BYTES + 1), "too long"), (b"x", "no address")])
def test_what_cannot_be_sent_is_counted_and_not_raised(pair: Pair, payload: bytes, reason: str):
    assert not pair.one.send(2 if reason == "too long" else 99, payload)
    assert pair.one.traffic.unsent[reason] == 1


def test_traffic_is_counted(pair: Pair):
    for payload in (b"12", b"345"):
        pair.one.send(2, payload)
    collect(pair, pair.two, 2)
    one, two = pair.one.traffic, pair.two.traffic
    assert (one.sent, one.sent_bytes, two.received, two.received_bytes) == (2, 5, 2, 5)


def test_a_forgotten_neighbour_gets_nothing(pair: Pair):
    pair.one.forget(2)
    assert not pair.one.send(2, b"still there?")


def test_a_closed_transport_is_silent(pair: Pair):
    pair.one.close()
    pair.one.close()
    assert not pair.one.send(2, b"x")
    assert pair.one.poll() == []


def test_a_neighbour_that_is_gone_harms_nobody(pair: Pair):
    pair.two.close()
    for _ in range(20):
        pair.one.send(2, b"hello?")
        pair.wait()
        assert pair.one.poll() == []


class TestUdp:
    def test_a_taken_port_is_named(self):
        with UdpHeld() as held, pytest.raises(TransportError, match=f"port {held.address.port} of 127.0.0.1 is taken"):
            UdpTransport(port=held.address.port)

    def test_another_machines_address_is_named(self):
        with pytest.raises(TransportError, match=r"192\.0\.2\.1 is not an address of this machine"):
            UdpTransport(host="192.0.2.1")

    @pytest.mark.parametrize("host", ["localhost", "", "256.1.1.1", "a b"])
    def test_only_numbers_are_addresses(self, host: str):
        with pytest.raises(SessionError, match="not a numeric address"):
            UdpTransport(host=host)

    @pytest.mark.parametrize("port", [-1, 65536, "80"])
    def test_ports_have_a_range(self, port: object):
        with pytest.raises(SessionError, match="not a number from 0 to 65535"):
            UdpTransport(port=port)

    @pytest.mark.parametrize("source", [("127.0.0.1", 0), ("127.0.0.1", 70000), "127.0.0.1:5", ("name", 5), ("::1", 5)])
    def test_what_is_no_address_is_not_followed(self, source: object):
        with UdpHeld() as held:
            held.follow(1, ("127.0.0.1", 9))
            with pytest.raises(SessionError):
                held.follow(1, source)
            assert held.send(1, b"x")

    def test_listens_on_this_machine_only_unless_told(self):
        with UdpHeld() as held:
            assert held.address.host == "127.0.0.1"

    def test_the_buffer_is_asked_for(self):
        with UdpHeld() as held:
            assert held.buffer > 212_992  # the kernel's own choice

    def test_an_ipv4_neighbour_of_an_ipv6_socket(self):
        try:
            six = UdpTransport(host="::")
        except TransportError as error:
            pytest.skip(str(error))
        four = UdpTransport()
        six.follow(1, four.address)
        four.follow(1, ("127.0.0.1", six.address.port))
        assert six.send(1, b"down")
        assert four.send(1, b"up")
        time.sleep(0.02)
        assert [arrival.payload for arrival in four.poll()] == [b"down"]
        (up,) = six.poll()
        six.follow(1, up.source)
        assert six.send(1, b"again")
        six.close()
        four.close()

    def test_a_flood_of_strangers_costs_the_neighbour_nothing(self):
        two = UdpTransport(stranger_rate=1.0, stranger_burst=5.0)
        one, flood = UdpTransport(), UdpTransport()
        for sender in (one, flood):
            sender.follow(2, two.address)
        two.follow(1, one.address)
        for _ in range(50):
            flood.send(2, b"noise")
            one.send(2, b"sample")
        time.sleep(0.05)
        arrived = [arrival.payload for arrival in two.poll()]
        assert arrived.count(b"sample") == 50
        assert arrived.count(b"noise") <= 6
        assert two.traffic.dropped["too many"] >= 44
        for transport in (one, two, flood):
            transport.close()

    def test_a_neighbour_is_limited_too(self):
        two = UdpTransport(rate=1.0, burst=10.0)
        one = UdpTransport()
        one.follow(2, two.address)
        two.follow(1, one.address)
        for _ in range(50):
            one.send(2, b"sample")
        time.sleep(0.05)
        assert len(two.poll()) <= 11
        one.close()
        two.close()

    def test_who_left_is_a_stranger_again(self):
        two, one = UdpTransport(stranger_rate=1.0, stranger_burst=5.0), UdpTransport()
        one.follow(2, two.address)
        two.follow(1, one.address)
        two.forget(1)
        for _ in range(50):
            one.send(2, b"still here")
        time.sleep(0.05)
        assert len(two.poll()) <= 6
        one.close()
        two.close()

    def test_empty_and_longer_datagrams_are_dropped(self):
        import socket

        with UdpHeld() as held, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as raw:
            for payload in (b"", bytes(MOST_BYTES + 1), bytes(9000), b"good"):
                raw.sendto(payload, held.address)
            time.sleep(0.02)
            assert [arrival.payload for arrival in held.poll()] == [b"good"]
            assert held.traffic.dropped["size"] == 3


class UdpHeld:
    """A UDP transport that is closed at the end."""

    def __enter__(self) -> UdpTransport:
        self.transport = UdpTransport()
        return self.transport

    def __exit__(self, *error: object) -> None:
        self.transport.close()


def waited(transport: UdpTransport) -> list[Arrival]:
    """What arrives at a socket, and it is bound to arrive."""
    found: list[Arrival] = []
    for _ in range(1000):
        found += transport.poll()
        if found:
            break
        time.sleep(0.002)
    return found


def test_a_socket_goes_to_another_address_of_its_machine():
    with_it, other = UdpTransport(host="127.0.0.2"), UdpTransport()
    try:
        port = with_it.address.port
        with_it.rebind("127.0.0.3")
        assert with_it.address == Address("127.0.0.3", port)
        other.reach(with_it.address, b"there")
        assert [arrival.payload for arrival in waited(with_it)] == [b"there"]
        with_it.reach(other.address, b"back")
        assert [Address(*arrival.source) for arrival in waited(other)] == [Address("127.0.0.3", port)]
        with pytest.raises(TransportError, match="not an address of this machine"):
            with_it.rebind("192.0.2.1")
        assert with_it.address == Address("127.0.0.3", port)
        taken = UdpTransport(host="127.0.0.4", port=port)
        with_it.rebind("127.0.0.4")  # at another port, then
        assert with_it.address.host == "127.0.0.4"
        assert with_it.address.port != port
        taken.close()
    finally:
        with_it.close()
        other.close()
    with pytest.raises(TransportError, match="closed"):
        with_it.rebind("127.0.0.1")
