"""Ways found and kept on a virtual internet with NATs, on a clock of its own."""

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.live.internet import Internet, Nat, VirtualSocket
from tests.thorough import examples

from cotouch.samples import Address
from cotouch.traversal import Candidate, CandidateKind, PairKeys, PathProber, PathState, pair_keys

TICK = 0.01
PORT = 5000


def keys(nonces: tuple[bytes, bytes] = (b"a" * 16, b"b" * 16)) -> tuple[PairKeys, PairKeys]:
    ends = bytes(32), bytes(31) + b"\1"
    return tuple(
        pair_keys(
            secret=b"secret", session=b"session", own=ends[k], other=ends[1 - k],
            own_nonce=nonces[k], other_nonce=nonces[1 - k],
        )
        for k in range(2)
    )  # fmt: skip


AT = Address("192.0.2.1", 5)


def pings(own: PairKeys, count: int = 1) -> list[bytes]:
    """What an end with these keys asks first."""
    prober, found = PathProber(0.0), list[bytes]()
    prober.rekey(own)
    while len(found) < count:
        prober.offer([Candidate(CandidateKind.LOCAL, Address("192.0.2.9", 1000 + len(found)))])
        found += [probe.payload for probe in prober.due(float(len(found)), active=True)]
    return found


def pong(own: PairKeys, ping: bytes) -> bytes:
    """What an end with these keys answers."""
    prober = PathProber(0.0)
    prober.rekey(own)
    answer = prober.receive(0.0, ping, AT)
    assert answer is not None
    return answer.payload


class Two:
    """Two members that know of each other's addresses what a lookup would have told them."""

    def __init__(self, *nats: Nat | None, delay: float = 0.02, loss: float = 0.0, seed: int = 0) -> None:
        self.net = Internet(delay=delay, loss=loss, seed=seed)
        self.nats = nats
        self.sockets: list[VirtualSocket] = []
        self.probers: list[PathProber] = []
        self.active = [True, True]
        self.sent = [0, 0]
        self.history: list[tuple[float, int, PathState, Address | None]] = []
        for user, nat in enumerate(nats):
            lan = f"10.{0 if nat is not None and nat is nats[0] else user}.0.{user + 2}"
            host = lan if nat else f"203.0.113.{user + 1}"
            self.sockets.append(self.net.socket(host, PORT, behind=nat))
            self.probers.append(PathProber(0.0))
        for user, own in enumerate(keys()):
            self.probers[user].rekey(own)
            self.probers[user].offer(self.candidates(1 - user))

    def candidates(self, user: int) -> list[Candidate]:
        nat = self.nats[user]
        found = [Candidate(CandidateKind.LOCAL, self.sockets[user].address)]
        if nat is not None:
            port = PORT + nat.shift if nat.kept else 40_000
            found.append(Candidate(CandidateKind.REFLEXIVE, Address(nat.host, port)))
        return found

    def step(self) -> None:
        self.net.now += TICK
        for user, (socket, prober) in enumerate(zip(self.sockets, self.probers, strict=True)):
            before = prober.path_state, prober.address
            for arrival in socket.poll():
                if arrival.payload[:1] != b"\xc2":
                    prober.learn(self.net.now, arrival.source)
                    continue
                answer = prober.receive(self.net.now, arrival.payload, arrival.source)
                if answer is not None:
                    socket.reach(*answer)
            for probe in prober.due(self.net.now, active=self.active[user]):
                self.sent[user] += 1
                socket.reach(*probe)
            if self.active[user] and prober.address is not None:
                socket.reach(prober.address, b"a sample")
            if (prober.path_state, prober.address) != before:
                self.history.append((self.net.now, user, prober.path_state, prober.address))

    def run(self, seconds: float, until: PathState | None = None) -> "Two":
        for _ in range(round(seconds / TICK)):
            self.step()
            if until is not None and all(prober.path_state is until for prober in self.probers):
                return self
        assert until is None, [prober.path_state for prober in self.probers]
        return self

    @property
    def paths(self) -> list[PathState]:
        return [prober.path_state for prober in self.probers]


def test_without_nats_the_first_ping_is_enough():
    two = Two(None, None).run(1.0, PathState.DIRECT)
    assert [prober.address for prober in two.probers] == [two.sockets[1].address, two.sockets[0].address]
    assert two.net.now < 0.2
    assert two.probers[0].round_trip == pytest.approx(0.04, abs=2 * TICK)


def test_two_nats_that_keep_ports_are_punched():
    two = Two(Nat("198.51.100.1"), Nat("198.51.100.2")).run(3.0, PathState.DIRECT)
    assert two.probers[0].address == Address("198.51.100.2", PORT)
    assert two.run(60.0).paths == [PathState.DIRECT] * 2
    assert len(two.history) == 2


def test_nats_with_random_ports_are_given_up_and_tried_again_now_and_then():
    two = Two(Nat("198.51.100.1", kept=False), Nat("198.51.100.2", kept=False)).run(10.0, PathState.RELAYED)
    assert 3.0 < two.net.now < 8.0
    first = max(two.sent)
    assert first <= 12 * 2
    two.run(600.0)
    assert two.paths == [PathState.RELAYED] * 2
    assert 10 <= (max(two.sent) - first) / 8 <= 20  # rounds of four pings to two addresses, ever rarer
    assert len(two.history) == 2


def test_one_nat_with_random_ports_before_a_public_member():
    """The member in public answers where it is asked from, though nobody could have told it."""
    two = Two(Nat("198.51.100.1", kept=False), None).run(3.0, PathState.DIRECT)
    assert two.probers[1].address.host == "198.51.100.1"
    assert two.probers[1].address not in {address for _, address in two.candidates(0)}


def test_behind_one_nat_the_straight_way_is_taken():
    nat = Nat("198.51.100.1")
    two = Two(nat, nat).run(5.0)
    assert [prober.address for prober in two.probers] == [two.sockets[1].address, two.sockets[0].address]


def test_a_straighter_way_is_taken_when_it_comes_later():
    two = Two(None, None)
    local, other = two.sockets[1].address, two.net.socket("203.0.113.9", PORT)
    two.net.cut = lambda source, to: local.host in {source, to}
    two.probers[0].offer([Candidate(CandidateKind.LOCAL, local), Candidate(CandidateKind.REFLEXIVE, other.address)])
    for _ in range(6000):
        if two.net.now > 10.0:
            two.net.cut = lambda source, to: False
        two.step()
        for arrival in other.poll():
            answer = two.probers[1].receive(two.net.now, arrival.payload, arrival.source)
            if answer is not None:
                other.reach(*answer)
        if two.net.now < 10.0:
            continue
        if two.probers[0].address == local:
            break
        assert two.probers[0].address == other.address
    assert two.probers[0].address == local


@given(loss=st.floats(0.0, 0.5), delay=st.floats(0.001, 0.5), seed=st.integers(0, 1000))
@settings(max_examples=examples(25))
def test_lossy_and_long_ways_are_found_too(loss: float, delay: float, seed: int):
    Two(Nat("198.51.100.1"), Nat("198.51.100.2"), loss=loss, delay=delay, seed=seed).run(60.0, PathState.DIRECT)


def test_a_way_with_a_third_lost_is_kept():
    two = Two(Nat("198.51.100.1"), Nat("198.51.100.2"), loss=0.3, seed=3).run(5.0, PathState.DIRECT)
    two.run(120.0)
    assert sum(path_state is not PathState.DIRECT for _, _, path_state, _ in two.history) <= 4


def test_a_way_as_long_as_the_papers_longest_is_kept():
    two = Two(None, None, delay=0.9).run(5.0, PathState.DIRECT).run(60.0)
    assert len(two.history) == 2


def test_a_nat_that_forgets_is_followed():
    """Its user sends from another port from then on; the other end asks there and goes on."""
    nat = Nat("198.51.100.1")
    two = Two(nat, None).run(3.0, PathState.DIRECT)
    nat.forget()
    begin = two.net.now
    two.run(5.0)
    assert two.probers[1].address == Address("198.51.100.1", PORT + 1000)
    moved = [time for time, user, _, address in two.history if (user, address) == (1, two.probers[1].address)]
    assert moved[0] - begin < 2.0
    assert two.run(60.0).paths == [PathState.DIRECT] * 2
    assert all(path_state is PathState.DIRECT for _, _, path_state, _ in two.history)


def test_a_nat_that_forgets_before_one_that_lets_nobody_in():
    """The other end is not reached from the new port, so it must be told."""
    nat = Nat("198.51.100.1")
    two = Two(nat, Nat("198.51.100.2")).run(3.0, PathState.DIRECT)
    nat.forget()
    two.run(4.0, PathState.TRYING)
    two.probers[1].offer(two.candidates(0))
    two.run(5.0, PathState.DIRECT)


def test_an_outage_is_noticed_and_its_end_too():
    two = Two(Nat("198.51.100.1"), Nat("198.51.100.2")).run(3.0, PathState.DIRECT)
    two.net.cut = lambda source, to: True
    begin = two.net.now
    two.run(4.0, PathState.TRYING)
    assert two.net.now - begin > 2.0
    two.run(10.0, PathState.RELAYED)
    two.net.cut = lambda source, to: False
    two.run(30.0, PathState.DIRECT)


@pytest.mark.parametrize("deaf", [0, 1])
def test_an_outage_of_one_direction_ends_both(deaf: int):
    """Who still hears the other is not heard itself: only answers count."""
    two = Two(None, None).run(3.0, PathState.DIRECT)
    host = two.sockets[deaf].address.host
    two.net.cut = lambda source, to: to == host
    two.run(15.0, PathState.RELAYED)
    two.net.cut = lambda source, to: False
    two.run(60.0, PathState.DIRECT)


def test_an_idle_way_costs_little_and_keeps_the_nats():
    two = Two(Nat("198.51.100.1"), Nat("198.51.100.2")).run(10.0)
    two.active = [False, False]
    two.run(1.0)
    before = len(two.net.log)
    two.run(300.0)
    log = two.net.log[before:]
    # A question and an answer in 5 s from each end, and four pings in 40 s to a straighter address that is none.
    assert len(log) <= 2 * (2 * 61 + 4 * 9)
    assert max(b[0] - a[0] for a, b in pairwise(log)) <= 15.1
    assert two.paths == [PathState.DIRECT] * 2


def test_the_quickest_way_there_and_back_is_known_of_an_idle_way_too():
    two = Two(None, None, delay=0.05)
    two.active = [False, False]
    assert two.probers[0].quickest is None
    two.run(8.0)
    assert all(prober.quickest == pytest.approx(0.1, abs=2 * TICK) for prober in two.probers)
    two.net.delay = 0.2
    two.run(40.0)
    assert all(prober.quickest == pytest.approx(0.4, abs=2 * TICK) for prober in two.probers)
    two.net.cut = lambda source, to: True
    two.run(20.0)
    assert two.probers[0].quickest is None


def test_an_idle_way_that_is_gone_is_noticed():
    two = Two(None, None).run(2.0, PathState.DIRECT)
    two.active = [False, False]
    two.net.cut = lambda source, to: True
    two.run(30.0, PathState.RELAYED)


def test_a_repeated_ping_is_not_answered_and_a_stranger_is_not_asked():
    first, second = keys()
    prober = PathProber(0.0)
    prober.rekey(first)
    (good,), mallory = pings(second), Address("192.0.2.66", 6)
    assert prober.receive(0.0, good, AT) == (AT, pong(first, good))
    prober.due(0.0, active=True)
    assert prober.receive(0.0, good, mallory) is None
    assert prober.receive(0.0, pings(first, 9)[8], mallory) is None
    assert prober.receive(0.0, b"noise", mallory) is None
    assert prober.refused == 3
    asked = [probe.to for k in range(500) for probe in prober.due(0.1 * k, active=True)]
    assert mallory not in asked


def test_a_pong_counts_only_once_and_from_where_it_was_asked():
    first, second = keys()
    prober = PathProber(0.0)
    prober.rekey(first)
    elsewhere = Address("192.0.2.66", 6)
    prober.offer([Candidate(CandidateKind.LOCAL, AT)])
    asked, unasked = pings(first, 2)
    assert prober.due(0.0, active=True) == [(AT, asked)]
    good, own = pong(second, asked), pong(first, *pings(second))
    for answer, source in ((pong(second, unasked), AT), (good, elsewhere), (own, AT)):
        prober.receive(0.1, answer, source)
        assert prober.path_state is PathState.TRYING
    prober.receive(0.1, good, AT)
    assert (prober.path_state, prober.address) == (PathState.DIRECT, AT)
    refused = prober.refused
    prober.receive(0.1, good, AT)
    assert prober.refused == refused + 1


def test_an_answer_that_comes_too_late_is_none():
    first, second = keys()
    prober = PathProber(0.0)
    prober.rekey(first)
    prober.offer([Candidate(CandidateKind.LOCAL, AT)])
    (probe,) = prober.due(0.0, active=True)
    for k in range(1, 100):
        prober.due(0.1 * k, active=True)
    prober.receive(9.9, pong(second, probe.payload), AT)
    assert prober.path_state is not PathState.DIRECT


def test_addresses_that_were_learnt_are_few():
    first, second = keys()
    prober = PathProber(0.0)
    prober.rekey(first)
    for k, ping in enumerate(pings(second, 1000)):
        prober.receive(0.001 * k, ping, Address("192.0.2.1", 1000 + k))
    asked = [probe for k in range(1000) for probe in prober.due(1.0 + 0.001 * k, active=True)]
    assert len(asked) == 1
    prober.offer([Candidate(CandidateKind.LOCAL, AT)])  # a round over all addresses
    asked = [probe for k in range(1000) for probe in prober.due(2.0 + 0.01 * k, active=True)]
    assert {probe.to for probe in asked} == {AT, *(Address("192.0.2.1", port) for port in range(1996, 2000))}


def test_addresses_that_change_without_end_do_not_hasten_pings_either():
    first, second = keys()
    prober = PathProber(0.0)
    prober.rekey(first)
    sent = 0
    for k, ping in enumerate(pings(second, 1000)):
        prober.receive(0.001 * k, ping, Address("192.0.2.1", 1000 + k))
        sent += len(prober.due(0.001 * k, active=True))
    assert 5 <= sent <= 11


def test_who_is_heard_from_elsewhere_is_not_asked_there_while_its_way_works():
    """Each end may have chosen another of two ways that both work."""
    two = Two(None, None).run(5.0)
    other = Address("203.0.113.66", 6)
    for _ in range(500):
        two.probers[0].learn(two.net.now, other)
        two.step()
    assert other not in {to for _, _, to, _ in two.net.log}


def test_the_same_keys_again_do_not_begin_numbers_anew():
    first, second = keys()
    prober = PathProber(0.0)
    prober.rekey(first)
    (ping,) = pings(second)
    assert prober.receive(0.0, ping, AT) is not None
    prober.rekey(first)
    assert prober.receive(0.0, ping, AT) is None


def test_offers_without_end_do_not_hasten_pings():
    prober = PathProber(0.0)
    prober.rekey(keys()[0])
    sent = 0
    for k in range(1000):
        prober.offer([Candidate(CandidateKind.LOCAL, Address("192.0.2.1", 1000 + k + j)) for j in range(16)])
        sent += len(prober.due(0.001 * k, active=True))
    assert sent <= 51


def test_other_words_are_other_keys():
    """A member that came back: what was asked before is of no use, and numbers begin anew."""
    two = Two(None, None).run(1.0, PathState.DIRECT)
    for prober, own in zip(two.probers, keys((b"c" * 16, b"b" * 16)), strict=True):
        prober.rekey(own)
    refused = [prober.refused for prober in two.probers]
    two.run(10.0)
    assert two.paths == [PathState.DIRECT] * 2
    assert max(prober.refused - then for prober, then in zip(two.probers, refused, strict=True)) <= 2


def test_without_keys_nothing_is_sent_and_it_gives_up():
    prober = PathProber(0.0)
    prober.offer([Candidate(CandidateKind.LOCAL, Address("192.0.2.1", 5))])
    assert [probe for k in range(100) for probe in prober.due(0.1 * k, active=True)] == []
    assert prober.path_state is PathState.RELAYED
