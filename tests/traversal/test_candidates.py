"""Where a member may be reached, written and read."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from cotouch.errors import SessionError
from cotouch.samples import Address, flaw, origin, plain_address
from cotouch.traversal import (
    MOST_CANDIDATES,
    Candidate,
    CandidateKind,
    interface_hosts,
    local_candidates,
    read_offer,
    write_offer,
)

NONCE = bytes(range(16))
hosts = st.one_of(st.ip_addresses(v=4), st.ip_addresses(v=6)).map(str)
anywhere = st.builds(lambda host, port: plain_address((host, port)), hosts, st.integers(0, 65535))
usable = st.builds(
    Candidate,
    st.sampled_from([CandidateKind.LOCAL, CandidateKind.REFLEXIVE]),
    anywhere.filter(lambda address: not flaw(address)),
)


@given(candidates=st.lists(usable, max_size=MOST_CANDIDATES + 4), nonce=st.binary(min_size=16, max_size=16))
def test_what_is_written_is_read(candidates: list[Candidate], nonce: bytes):
    offer = read_offer(write_offer(nonce, candidates))
    assert offer.nonce == nonce
    assert offer.candidates == tuple(dict.fromkeys(candidates))[:MOST_CANDIDATES]
    assert not offer.refused


@given(message=st.binary(max_size=300))
def test_noise_is_refused_and_never_raised(message: bytes):
    offer = read_offer(b"\1" + message)
    assert offer is None or len(offer.candidates) + sum(offer.refused.values()) <= MOST_CANDIDATES


@given(candidates=st.lists(usable, min_size=1, max_size=4), cut=st.integers(1, 22))
def test_what_is_cut_or_longer_is_refused(candidates: list[Candidate], cut: int):
    message = write_offer(NONCE, candidates)
    assert read_offer(message[:-cut]) is None
    assert read_offer(message + bytes(cut)) is None


BAD = [
    (("192.0.2.1", 0), "port"), (("224.0.0.1", 7), "multicast"), (("239.255.255.250", 1900), "multicast"),
    (("255.255.255.255", 7), "reserved"), (("240.0.0.1", 7), "reserved"), (("0.0.0.0", 7), "unspecified"),
    (("0.1.2.3", 7), "reserved"), (("::", 7), "unspecified"), (("ff02::1", 7), "multicast"),
    (("fe80::1", 7), "link-local"),
]  # fmt: skip


@pytest.mark.parametrize(("address", "why"), BAD)
def test_nobody_is_sent_to_what_is_no_member(address: tuple[str, int], why: str):
    good = Candidate(CandidateKind.LOCAL, Address("192.0.2.1", 7000))
    message = bytearray(write_offer(NONCE, [good, good._replace(address=Address("2001:db8::1", 7))]))
    import ipaddress

    host = ipaddress.ip_address(address[0]).packed
    entry = bytes((0, 4 if len(host) == 4 else 6)) + address[1].to_bytes(2, "big") + host
    message[1] += 1
    offer = read_offer(bytes(message) + entry)
    assert dict(offer.refused) == {why: 1}
    assert len(offer.candidates) == 2
    with pytest.raises(SessionError, match=why):
        write_offer(NONCE, [Candidate(CandidateKind.LOCAL, Address(*address))])


def test_a_multicast_group_within_ipv6_is_one_too():
    message = write_offer(NONCE, [])
    mapped = b"\0\6\0\7" + bytes(10) + b"\xff\xff" + bytes((224, 0, 0, 1))
    offer = read_offer(message[:1] + b"\1" + message[2:] + mapped)
    assert dict(offer.refused) == {"multicast": 1}


@pytest.mark.parametrize(("origin", "family"), [(2, 4), (9, 4), (0, 5), (0, 0)])
def test_unknown_origins_and_families_are_refused(origin: int, family: int):
    message = b"\1\1" + NONCE + bytes((origin, family, 0, 7, 192, 0, 2, 1))
    assert read_offer(message) is None
    assert read_offer(b"\1\1" + NONCE + bytes((0, 4, 0, 7, 192, 0, 2, 1))) is not None


def test_more_than_the_most_is_refused():
    """Whoever says more than anybody needs is to make no neighbour probe."""
    entry = bytes((0, 4, 0, 7, 192, 0, 2, 1))
    assert read_offer(bytes((1, MOST_CANDIDATES)) + NONCE + MOST_CANDIDATES * entry) is not None
    assert read_offer(bytes((1, MOST_CANDIDATES + 1)) + NONCE + (MOST_CANDIDATES + 1) * entry) is None


def test_another_version_is_refused():
    assert read_offer(b"\2" + write_offer(NONCE, [])[1:]) is None


def test_what_is_learnt_is_told_to_nobody():
    with pytest.raises(SessionError, match="learnt"):
        write_offer(NONCE, [Candidate(CandidateKind.LEARNT, Address("192.0.2.1", 7))])


INTERFACES = ["127.0.0.1", "::1", "192.0.2.9", "2001:db8::9", "fe80::1"]


@pytest.mark.parametrize(("listening", "expected"), [
    ("127.0.0.1", ["127.0.0.1"]), ("::1", ["::1"]), ("192.0.2.9", ["192.0.2.9"]),
    ("0.0.0.0", ["192.0.2.9"]), ("::", ["192.0.2.9", "2001:db8::9"]),
])  # fmt: skip
def test_local_candidates_are_where_it_listens(listening: str, expected: list[str]):
    found = local_candidates(Address(listening, 7000), INTERFACES)
    assert found == [Candidate(CandidateKind.LOCAL, Address(host, 7000)) for host in expected]


def test_the_machines_own_interfaces():
    assert "127.0.0.1" in interface_hosts()
    assert all(plain_address((host, 1)) is not None for host in interface_hosts())


@pytest.mark.parametrize(("source", "expected"), [
    (("::ffff:192.0.2.1", 5), Address("192.0.2.1", 5)), (("2001:DB8::1", 5), Address("2001:db8::1", 5)),
    (("name", 5), None), ("192.0.2.1:5", None), (("192.0.2.1", "5"), None), ((1, 5), None), ((), None),
])  # fmt: skip
def test_one_form_of_an_address(source: object, expected: Address | None):
    assert plain_address(source) == expected


def test_an_owner_of_addresses():
    assert origin("2001:db8:1:2:3:4:5:6") == origin("2001:db8:1:2::9")
    assert origin("192.0.2.1") != origin("192.0.2.2")
