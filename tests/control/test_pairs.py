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
    assert two.true(ONE.public, b"said", tag)
    assert not two.true(ONE.public, b"saic", tag)
    assert not two.true(THREE.public, b"said", tag)
    assert not three.true(ONE.public, b"said", tag)
    assert not one.true(TWO.public, b"said", tag)  # reflected
    assert not PairTags(TWO, b"another").true(ONE.public, b"said", tag)


@pytest.mark.parametrize("key", [b"\1" + bytes(31), bytes(32), b"\xec" + b"\xff" * 30 + b"\x7f"])
def test_keys_that_all_know_the_secret_of_are_refused(key: bytes):
    one = PairTags(ONE, b"session")
    assert one.tag(key, b"said") is None
    assert not one.true(key, b"said", bytes(16))


@given(st.binary(min_size=32, max_size=32))
def test_any_bytes_may_stand_for_a_member(key: bytes):
    assert not PairTags(ONE, b"session").true(key, b"said", bytes(16))


def test_pairs_are_bounded():
    one = PairTags(ONE, b"session")
    others = [number.to_bytes(32, "little") for number in range(1100)]
    for other in others:
        one.tag(other, b"")
    assert sum(map(one.known, others)) <= 1024
    assert not one.known(bytes(32))
