"""Probes: what is written is read, by the right end and by nobody else."""

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from cotouch.errors import SessionError
from cotouch.samples import Address, Refusal, connection_of
from cotouch.traversal import PROBE, member_key, pair_keys
from cotouch.traversal._probe import PAIR_BYTES, Kind, ask, label_of, ping, pong, read_pair, tell, told

ONE, TWO = bytes(31) + b"\1", bytes(31) + b"\2"
WORDS = b"word of the first", b"word of the other"


def pair(**changes: bytes):
    """Keys of both ends; changes are the second end's mistakes."""
    given = {"secret": b"secret", "session": b"session"}
    first = pair_keys(own=ONE, other=TWO, own_nonce=WORDS[0][:16], other_nonce=WORDS[1][:16], **given)
    second = pair_keys(
        **({"own": TWO, "other": ONE, "own_nonce": WORDS[1][:16], "other_nonce": WORDS[0][:16]} | given | changes)
    )
    return first, second


addresses = st.one_of(st.ip_addresses(v=4), st.ip_addresses(v=6).filter(lambda host: host.ipv4_mapped is None))


@given(host=addresses, port=st.integers(1, 65535), nonce=st.binary(min_size=16, max_size=16))
def test_who_asks_is_told_its_address(host, port: int, nonce: bytes):
    key = member_key(b"secret", b"session")
    question = ask(key, nonce)
    answer = tell(key, question, Address(str(host), port), lambda nonce, host: b"cook")
    assert told(key, answer) == (nonce, Address(str(host), port), b"cook")
    assert len(answer) <= len(question)
    assert question[0] == answer[0] == PROBE
    assert connection_of(question + bytes(64)) is Refusal.VERSION, "taken for no sample"


def test_an_address_is_not_found_in_the_answer():
    """Some routers look for addresses in datagrams and rewrite them."""
    key = member_key(b"secret", b"session")
    answer = tell(key, ask(key, b"\x5a" * 16), Address("192.0.2.7", 7000))
    assert bytes((192, 0, 2, 7)) not in answer


@pytest.mark.parametrize(("secret", "session"), [(b"other", b"session"), (b"secret", b"other")])
def test_only_members_are_answered(secret: bytes, session: bytes):
    key, other = member_key(b"secret", b"session"), member_key(secret, session)
    assert tell(key, ask(other, bytes(16)), Address("192.0.2.7", 1)) is None
    answer = tell(other, ask(other, bytes(16)), Address("192.0.2.7", 1))
    assert told(key, answer) is None


def test_no_answer_is_answered():
    key = member_key(b"secret", b"session")
    answer = tell(key, ask(key, bytes(16)), Address("192.0.2.7", 1))
    assert tell(key, answer, Address("192.0.2.7", 1)) is None
    assert told(key, ask(key, bytes(16))) is None


@pytest.mark.parametrize("write", [ping, pong])
@pytest.mark.parametrize("number", [0, 1, 2**64 - 1])
def test_the_other_end_reads_what_one_wrote(write, number: int):
    first, second = pair()
    kind = Kind.PING if write is ping else Kind.PONG
    for one, other in ((first, second), (second, first)):
        assert read_pair(other, write(one, number)) == (kind, number)
        assert label_of(write(one, number)) == other.receiving[0]
        assert len(write(one, number)) == PAIR_BYTES
        assert read_pair(one, write(one, number)) is None  # sent back to who sent it


@pytest.mark.parametrize("change", [
    {"secret": b"another"}, {"session": b"another"}, {"own": bytes(32)}, {"own_nonce": bytes(16)},
    {"other_nonce": bytes(16)}, {"own_nonce": WORDS[0][:16], "other_nonce": WORDS[1][:16]},
])  # fmt: skip
def test_everything_that_makes_a_pair_counts(change: dict[str, bytes]):
    first, second = pair(**change)
    assert read_pair(second, ping(first, 5)) is None
    assert read_pair(first, ping(second, 5)) is None


def test_every_byte_counts():
    rng = random.Random(1)
    first, second = pair()
    key = member_key(b"secret", b"session")
    question = ask(key, rng.randbytes(16))
    answer = tell(key, question, Address("192.0.2.7", 7000))
    for good, read in (
        (ping(first, 77), lambda datagram: read_pair(second, datagram)),
        (question, lambda datagram: tell(key, datagram, Address("192.0.2.7", 1))),
        (answer, lambda datagram: told(key, datagram)),
    ):
        assert read(good) is not None
        for at in range(len(good)):
            bad = bytearray(good)
            bad[at] ^= 1 << rng.randrange(8)
            assert read(bytes(bad)) is None
        assert read(good[:-1]) is None
        assert read(good + b"\0") is None
        assert read(b"\xc2\1") is None


def test_the_keys_are_shown_to_nobody():
    first, _ = pair()
    assert first.sending[1].hex() not in repr(first)
    assert str(first.sending[1]) not in repr(first)


@pytest.mark.parametrize("change", [{"own": ONE}, {"other": b"short"}, {"own_nonce": b"short"}])
def test_what_makes_no_pair_is_refused(change: dict[str, bytes]):
    with pytest.raises(SessionError):
        pair(**change)
