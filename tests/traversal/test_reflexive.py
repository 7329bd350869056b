"""What others see a member send from."""

import pytest
from tests.live.internet import Internet, Nat
from tests.live.support import entropy, identities
from tests.traversal.shown import KEY, MIRROR, asking, place_at

from cotouch.samples import Address
from cotouch.traversal import Addresses, Lookup, Mirror

MEMBER, OTHER = (one.public for one in identities(2))
_, QUESTION = asking(MEMBER)


class Asking:
    """A member behind a NAT and its mirrors in public."""

    def __init__(self, nat: Nat, mirrors: int = 1, **law: float) -> None:
        self.net = Internet(**law)
        self.own = self.net.socket("10.0.0.2", 5000, behind=nat)
        self.mirrors = [self.net.socket("203.0.113.1", 7000 + k) for k in range(mirrors)]
        self.lookup = Lookup(KEY, entropy(3), MEMBER)
        self.lookup.look([socket.address for socket in self.mirrors])
        self.addresses = Addresses(entropy(8))
        self.silent = False

    def run(self, seconds: float) -> "Asking":
        for _ in range(round(seconds / 0.05)):
            self.net.now += 0.05
            for to, question in self.lookup.due(self.net.now):
                self.own.reach(to, question)
            for socket in self.mirrors:
                for arrival in socket.poll():
                    answer = Mirror(KEY, self.addresses).answer(arrival.payload, arrival.source)
                    if answer is not None and not self.silent:
                        socket.reach(arrival.source, answer)
            for arrival in self.own.poll():
                self.lookup.take(self.net.now, arrival.payload, arrival.source)
        return self


def test_the_nats_address_is_found_and_kept():
    asking = Asking(Nat("198.51.100.1")).run(100.0)
    assert asking.lookup.addresses == [Address("198.51.100.1", 5000)]
    assert 6 <= len(asking.net.log) // 2 <= 10


def test_a_way_that_takes_longer_than_the_hurry():
    asking = Asking(Nat("198.51.100.1"), delay=0.8).run(2.0)
    assert asking.lookup.addresses == [Address("198.51.100.1", 5000)]


def test_a_lossy_way():
    assert Asking(Nat("198.51.100.1"), loss=0.5).run(5.0).lookup.addresses


def test_a_nat_with_a_port_for_each_destination_is_seen():
    found = Asking(Nat("198.51.100.1", kept=False), mirrors=2).run(5.0).lookup.addresses
    assert len(found) == 2
    assert {address.host for address in found} == {"198.51.100.1"}


def test_a_nat_that_forgets_is_noticed():
    nat = Nat("198.51.100.1")
    asking = Asking(nat).run(5.0)
    nat.forget()
    assert asking.run(20.0).lookup.addresses == [Address("198.51.100.1", 6000)]


def test_in_a_hurry_it_is_asked_at_once():
    nat = Nat("198.51.100.1")
    asking = Asking(nat).run(5.0)
    nat.forget()
    asking.lookup.hurry(asking.net.now)
    assert asking.run(0.2).lookup.addresses == [Address("198.51.100.1", 6000)]


def test_a_mirror_that_is_gone_is_asked_rarely_and_forgotten():
    asking = Asking(Nat("198.51.100.1")).run(5.0)
    asking.silent = True
    before = len(asking.net.log)
    asking.run(100.0)
    assert asking.lookup.addresses == []
    assert 10 <= len(asking.net.log) - before <= 20


def test_a_question_has_one_answer_from_where_it_was_asked():
    lookup, question = asking(MEMBER)
    own = Address("198.51.100.1", 9)
    answer, other = (Mirror(KEY).answer(asked, own) for asked in (question, asking(MEMBER, seed=4)[1]))
    assert answer is not None
    assert other is not None
    assert not lookup.take(0.1, answer, ("203.0.113.1", 7001))
    assert not lookup.take(0.1, other, MIRROR)
    assert not lookup.take(0.1, answer, "nonsense")
    assert lookup.take(0.1, answer, MIRROR)
    assert lookup.addresses == [own]
    assert not lookup.take(0.2, answer, MIRROR)


def test_a_member_that_tells_nonsense_is_not_believed():
    lookup, question = asking(MEMBER)
    for host, believed in (("224.0.0.1", False), ("192.0.2.9", True)):
        answer = Mirror(KEY).answer(question, (host, 9))
        assert answer is not None
        assert lookup.take(0.1, answer, MIRROR) is believed


@pytest.mark.parametrize("datagram", [b"", QUESTION[:2], bytes(len(QUESTION)), QUESTION[:2] + bytes(len(QUESTION) - 2)])
def test_strangers_are_not_answered(datagram: bytes):
    assert Mirror(KEY).answer(QUESTION, ("192.0.2.1", 5)) is not None
    assert Mirror(KEY).answer(datagram, ("192.0.2.1", 5)) is None
    assert Mirror(KEY).answer(QUESTION, "nowhere") is None


def test_who_was_told_shows_where_it_is_and_nobody_else_with_that():
    asking = Asking(Nat("198.51.100.1")).run(5.0)
    place = asking.lookup.place
    assert place is not None
    assert asking.addresses.shown(MEMBER, place) == "198.51.100.1"
    assert asking.addresses.shown(OTHER, place) is None
    assert asking.addresses.shown(MEMBER, place._replace(host="198.51.100.2")) is None
    assert asking.addresses.shown(MEMBER, place._replace(host="nowhere")) is None
    assert asking.addresses.shown(MEMBER, place._replace(nonce=bytes(16))) is None
    assert Addresses(entropy(9)).shown(MEMBER, place) is None


def test_of_version_6_a_network_is_one_address():
    addresses = Addresses(entropy(8))
    hosts = ("2001:db8:1:2::5", "2001:db8:1:2:ffff::9", "2001:db8:1:3::5")
    shown = [addresses.shown(MEMBER, place_at(addresses, MEMBER, host)) for host in hosts]
    assert shown[0] == shown[1] == "2001:db8:1:2::/64"
    assert shown[2] == "2001:db8:1:3::/64"
