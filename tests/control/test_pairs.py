"""MACs of two members: the same at both ends, another for every pair, direction and session."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.control.inside import PairTags
from tests.live.support import identities

ONE, TWO, THREE = identities(3)


def test_only_the_recipient_takes_it_and_only_from_its_sender():
    one, two, three = (PairTags(who, b"session") for who in (ONE, TWO, THREE))
    tag = one.tag(TWO.public, b"said")
    assert tag is not None
    assert two.read(ONE.public, b"said" + tag, 0.0) == b"said"
    assert two.read(ONE.public, b"saic" + tag, 0.0) is None
    assert two.read(ONE.public, tag[1:], 0.0) is None
    assert two.read(THREE.public, b"said" + tag, 0.0) is None
    assert three.read(ONE.public, b"said" + tag, 0.0) is None
    assert one.read(TWO.public, b"said" + tag, 0.0) is None  # reflected
    assert PairTags(TWO, b"another").read(ONE.public, b"said" + tag, 0.0) is None


@pytest.mark.parametrize("key", [b"\1" + bytes(31), bytes(32), b"\xec" + b"\xff" * 30 + b"\x7f"])
def test_keys_that_all_know_the_secret_of_are_refused(key: bytes):
    one = PairTags(ONE, b"session")
    assert one.tag(key, b"said") is None
    assert one.read(key, b"said" + bytes(16), 0.0) is None


@given(st.binary(min_size=32, max_size=32))
def test_any_bytes_may_stand_for_a_member(key: bytes):
    assert PairTags(ONE, b"session").read(key, b"said" + bytes(16), 0.0) is None


def test_pairs_are_bounded():
    one = PairTags(ONE, b"session")
    others = [number.to_bytes(32, "little") for number in range(1100)]
    for other in others:
        one.tag(other, b"")
    assert sum(map(one.known, others)) <= 1024
    assert not one.known(bytes(32))


def test_only_so_many_strangers_a_second_cost_a_key_agreement(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("cotouch.samples._limit._STRANGERS", 1)  # all share one limit
    one, two = PairTags(ONE, b"session"), PairTags(TWO, b"session")
    said = b"said" + (two.tag(ONE.public, b"said") or b"")
    others = [number.to_bytes(32, "little") for number in range(100)]
    assert [one.read(other, said, 0.0) for other in others] == [None] * 100
    assert sum(map(one.known, others)) == 20
    assert one.read(TWO.public, said, 0.0) is None  # nobody's turn any more
    assert one.read(TWO.public, said, 1.0) == b"said"
    for _ in range(100):
        assert one.read(TWO.public, said, 1.0) == b"said"  # known now
