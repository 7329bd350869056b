"""Nothing is opened but what the other end of this link sealed, in this direction and epoch, once."""

import copy
import pickle
import struct
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.live.support import agree, agreements, identities, in_a_fork, sealed_pair

from cotouch.errors import SessionError
from cotouch.samples import OVERHEAD, RENEW_EVERY, Opened, Refusal, ReplayWindow, SealedLink

PAYLOAD = bytes(range(200))
HEADER = struct.Struct(">BBHIQ")  # version, 0, epoch of keys, connection, sequence


def sealed(link: SealedLink, payload: bytes = PAYLOAD) -> bytes:
    out = link.seal(payload)
    assert out is not None
    return out


@given(payload=st.binary(max_size=1168))
def test_round_trip_with_a_constant_overhead(payload: bytes):
    one, two = sealed_pair()
    datagram = sealed(one, payload)
    assert len(datagram) == len(payload) + OVERHEAD
    assert two.open(datagram, 0.0) == Opened(payload, newest=True)
    assert len(payload) < 8 or payload not in datagram


def test_every_flipped_bit_is_noticed_and_changes_nothing():
    one, two = sealed_pair()
    datagram = sealed(one)
    for bit in range(8 * len(datagram)):
        forged = bytearray(datagram)
        forged[bit // 8] ^= 1 << (bit % 8)
        assert isinstance(two.open(bytes(forged), 0.0), Refusal)
    assert two.received == (-1, 0)
    assert isinstance(two.open(datagram, 0.0), Opened)


def test_every_truncation_and_extension_is_noticed():
    one, two = sealed_pair()
    datagram = sealed(one)
    for size in range(len(datagram)):
        assert two.open(datagram[:size], 0.0) in {Refusal.SHORT, Refusal.FORGED}
    assert two.open(datagram + b"\0", 0.0) is Refusal.FORGED


def test_a_datagram_is_opened_once():
    one, two = sealed_pair()
    datagram = sealed(one)
    assert isinstance(two.open(datagram, 0.0), Opened)
    assert two.open(datagram, 0.0) is Refusal.REPLAYED


def test_a_reflected_datagram_is_refused():
    """Even where both ends chose the same number, so that only the keys of the directions differ."""
    one, two = sealed_pair(connection=(7, 7))
    assert one.open(sealed(one), 0.0) is Refusal.FORGED
    assert two.open(sealed(two), 0.0) is Refusal.FORGED
    one, two = sealed_pair()
    assert one.open(sealed(one), 0.0) is Refusal.CONNECTION


def test_another_links_datagram_is_refused():
    one, _ = sealed_pair(seed=5)
    _, other = sealed_pair(seed=6)
    assert other.open(sealed(one), 0.0) is Refusal.FORGED


def test_reordering_is_harmless_and_only_the_newest_moves_addresses():
    one, two = sealed_pair()
    first, second, third = (sealed(one, bytes([k])) for k in range(3))
    results = [two.open(datagram, 0.0) for datagram in (third, first, second)]
    assert results == [Opened(b"\2", newest=True), Opened(b"\0", newest=False), Opened(b"\1", newest=False)]
    assert two.received == (2, 3)


def test_without_keys_nothing_is_sealed_or_opened():
    one, _ = sealed_pair()
    bare = SealedLink()
    assert bare.seal(PAYLOAD) is None
    assert bare.open(sealed(one), 0.0) is Refusal.CONNECTION
    assert bare.wants_keys(0.0)


def test_keys_are_used_up(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("cotouch.samples._seal.MOST_SEALED", 100)
    monkeypatch.setattr("cotouch.samples._seal.RENEW_AFTER", 50)
    one, two = sealed_pair()
    for _ in range(49):
        sealed(one)
    assert not one.wants_keys(0.0)
    sealed(one)
    assert one.wants_keys(0.0)
    for _ in range(49):
        sealed(one)
    assert isinstance(two.open(sealed(one), 0.0), Opened)
    assert one.seal(PAYLOAD) is None
    beyond = HEADER.pack(0xC1, 0, 1, two.connection, 100) + bytes(30)
    assert two.open(beyond, 0.0) is Refusal.REPLAYED


def test_keys_grow_old():
    one, _ = sealed_pair()
    assert not one.wants_keys(100.0)
    assert not one.wants_keys(100.0 + RENEW_EVERY - 1.0)
    assert one.wants_keys(100.0 + RENEW_EVERY)
    initiator, responder = agreements(*identities())
    agree(initiator, responder)
    one.install(agree(initiator, responder)[0])
    assert not one.wants_keys(100.0 + RENEW_EVERY)


def test_a_forked_process_seals_nothing():
    one, two = sealed_pair()
    assert in_a_fork(lambda: one.seal(PAYLOAD) is None)
    assert isinstance(two.open(sealed(one), 0.0), Opened)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, pickle.dumps])
def test_a_link_cannot_be_copied(copied: Callable[[object], object]):
    one, two = sealed_pair()
    with pytest.raises(SessionError, match="SealedLink cannot be copied: nonces would be used twice"):
        copied(one)
    assert isinstance(two.open(sealed(one), 0.0), Opened)


def test_no_nonce_is_used_twice():
    one, _ = sealed_pair()
    numbers = {HEADER.unpack_from(sealed(one))[4] for _ in range(1000)}
    assert len(numbers) == 1000


class TestNewKeys:
    """An agreement while samples flow: none is lost over it, in either direction, and old keys end."""

    def ends(self):
        initiator, responder = agreements(*identities())
        one, two = SealedLink(), SealedLink()
        for end, keys in zip((one, two), agree(initiator, responder), strict=True):
            end.install(keys)
        return initiator, responder, one, two

    def test_both_directions_go_on_at_every_moment(self):
        initiator, responder, one, two = self.ends()
        for _ in range(3):
            reply = responder.receive(initiator.start())
            both_open(one, two)
            confirm = initiator.receive(reply.message)
            one.install(confirm.keys)
            both_open(one, two)
            two.install(responder.receive(confirm.message).keys)
            both_open(one, two)
        assert one.epoch == two.epoch == 4
        assert one.sealed < 5

    def test_what_was_on_its_way_still_opens_and_later_no_longer(self):
        initiator, responder, one, two = self.ends()
        late, later = sealed(two), sealed(two)
        for end, keys in zip((one, two), agree(initiator, responder), strict=True):
            end.install(keys)
        assert isinstance(one.open(sealed(two), 10.0), Opened)
        assert one.open(late, 11.0) == Opened(PAYLOAD, newest=False)
        assert one.open(later, 12.5) is Refusal.EPOCH_OF_KEYS

    def test_old_keys_last_until_the_new_ones_are_heard(self):
        """The confirmation may be long on its way; until then the initiator sends as before."""
        initiator, responder, one, two = self.ends()
        keys, _ = agree(initiator, responder)
        one.install(keys)
        for now in (0.0, 100.0, 1000.0):
            assert isinstance(two.open(sealed(one), now), Opened)
            assert isinstance(one.open(sealed(two), now), Opened)

    def test_keys_of_an_earlier_epoch_are_not_installed_again(self):
        initiator, responder = agreements(*identities())
        first, _ = agree(initiator, responder)
        second, others = agree(initiator, responder)
        link, other = SealedLink(), SealedLink()
        link.install(second)
        other.install(others)
        sealed(link)
        for old in (first, second):
            link.install(old)
            assert (link.epoch, link.sealed) == (2, 1)
        assert isinstance(link.open(sealed(other), 0.0), Opened)  # nor do they wait for the other end to be heard
        assert isinstance(other.open(sealed(link), 0.0), Opened)
        assert (link.epoch, link.sealed) == (2, 2)


def both_open(one: SealedLink, two: SealedLink) -> None:
    for sender, receiver in ((one, two), (two, one)):
        assert isinstance(receiver.open(sealed(sender), 0.0), Opened)


@given(st.data())
def test_the_window_against_a_set(data: st.DataObject):
    window, blocks = ReplayWindow(blocks=4), 4
    seen: set[int] = set()
    numbers = st.one_of(
        st.integers(0, 600),
        st.integers(0, 2**40),
        st.builds(lambda k: max(0, max(seen, default=0) + k), st.integers(-400, 300)),
    )
    for number in data.draw(st.lists(numbers, max_size=150)):
        newest = max(seen, default=-1)
        fresh = window.fresh(number)
        if number in seen or number // 64 <= newest // 64 - blocks:
            assert not fresh
        else:
            assert fresh
        if number > newest - window.width and number not in seen:
            assert fresh
        if fresh:
            window.mark(number)
            seen.add(number)
        assert not window.fresh(number)
    assert (window.newest, window.count) == (max(seen, default=-1), len(seen))


@pytest.mark.parametrize("number", [0, 63, 64, 4095, 2**28 - 1])
def test_the_first_number_may_be_any(number: int):
    window = ReplayWindow()
    assert window.fresh(number)
    window.mark(number)
    assert not window.fresh(number)
    assert window.fresh(number + 1)
    assert number == 0 or window.fresh(number - 1)
