"""One line says where, whose and the secret; what is wrong with a line is said in a sentence."""

import random
import string

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.control.inside import check_of
from tests.live.support import entropy, identities

from cotouch.control import Endpoint, Invitation
from cotouch.errors import SessionError

HOST = identities(1)[0].public
PORTS = st.integers(1, 65535)
NAMES = st.from_regex(r"[a-z][a-z0-9-]{0,20}[a-z0-9](\.[a-z]{2,5}){0,2}", fullmatch=True)
HOSTS = st.ip_addresses(v=4).map(str) | st.ip_addresses(v=6).map(str) | NAMES
PLACES = st.lists(st.builds(Endpoint, HOSTS, PORTS), max_size=4).map(tuple)
SESSIONS = st.text(st.characters(categories=("L", "N", "P", "S")), min_size=1, max_size=64)


def made(**changes: object) -> Invitation:
    at = (Endpoint("192.0.2.7", 7447),)
    values = {"session": "lab", "host": HOST, "digest": bytes(range(32)), "endpoints": at, "entropy": entropy(1)}
    return Invitation.make(**(values | changes))  # pyright: ignore[reportArgumentType]


@given(SESSIONS, PLACES, PLACES, st.integers(0))
def test_what_is_encoded_is_decoded(session: str, endpoints: tuple, routers: tuple, seed: int):
    if not endpoints + routers:
        return
    invitation = made(session=session, endpoints=endpoints, routers=routers, entropy=entropy(seed))
    line = invitation.encode()
    assert Invitation.decode(line) == invitation
    assert set(line) <= set("cotouch:" + string.ascii_letters + string.digits + "-_")
    # As mail and chat mangle lines.
    assert Invitation.decode(f"  {line[:30]}\r\n {line[30:]}\n") == invitation


def test_a_short_line():
    assert len(made().encode()) < 150


@given(st.data())
def test_a_slip_is_found(data: st.DataObject):
    line = made().encode()
    at = data.draw(st.integers(len("cotouch:"), len(line) - 1))
    other = data.draw(st.sampled_from(sorted(set(string.ascii_letters + string.digits) - {line[at]})))
    changed = line[:at] + other + line[at + 1 :]
    try:
        # The last character carries bits that stand for nothing.
        assert Invitation.decode(changed) == made()
        assert at == len(line) - 1
    except SessionError as error:
        assert "\n" not in str(error)  # noqa: PT017 -- both outcomes are right


def test_every_cut_is_found():
    line = made().encode()
    for length in range(len("cotouch:"), len(line)):
        with pytest.raises(SessionError, match="cut off"):
            Invitation.decode(line[:length])


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("", "is not an invitation; invitations begin with 'cotouch:'"),
        ("https://example.org", "is not an invitation"),
        ("cotouch:AB$D", r"contains '\$', which is not allowed"),
        ("cotouch:Ägypten", "contains 'Ä', which is not allowed"),
        ("cotouch:" + "C" + made().encode()[9:], "has version 9, but this cotouch reads version 1"),
        (made().encode() + "AAAA", "a mistake"),
    ],
)
def test_what_is_wrong_with_a_line(line: str, sentence: str):
    with pytest.raises(SessionError, match=sentence):
        Invitation.decode(line)


def test_noise_is_an_error_and_nothing_else():
    """Also noise with a check that fits, which anybody can make."""
    import base64

    rng = random.Random(1)
    good = made(routers=(Endpoint("example.org", 1), Endpoint("::1", 2))).encode()
    whole = base64.urlsafe_b64decode(good[8:] + "=" * (-len(good[8:]) % 4))[:-4]
    for _ in range(20_000):
        body = bytearray(whole[: rng.randrange(3, len(whole) + 1)]) + rng.randbytes(rng.choice((0, 0, 3, 40)))
        for _ in range(rng.randrange(4)):
            body[rng.randrange(3, len(body)) if len(body) > 3 else 2] = rng.randrange(256)
        body[1:3] = (len(body) + 4).to_bytes(2, "big")
        line = "cotouch:" + base64.urlsafe_b64encode(bytes(body) + check_of(bytes(body))).decode().rstrip("=")
        try:
            read = Invitation.decode(line)
        except SessionError as error:
            assert "\n" not in str(error)  # noqa: PT017 -- both outcomes are right
        else:
            assert Invitation.decode(read.encode()) == read


def test_the_secret_is_not_shown():
    invitation = made()
    assert invitation.secret.hex() not in repr(invitation)
    assert repr(invitation.secret)[2:-1] not in repr(invitation)


def test_what_is_derived_hangs_on_secret_host_session_and_purpose():
    one = made()
    others = [made(session="lab2"), made(host=bytes(32)), made(digest=bytes(32)), made(entropy=entropy(2))]
    assert len({one.id, one.derive(b"else", 32), *(other.id for other in others)}) == 6
    assert made(endpoints=(Endpoint("::1", 5),)).id == one.id


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"session": ""}, "1 to 64 printable"),
        ({"session": "a\nb"}, "1 to 64 printable"),
        ({"session": "x" * 65}, "1 to 64 printable"),
        ({"host": b"short"}, "5 bytes; it must have 32"),
        ({"digest": b"short"}, "has 5 bytes; it must have 32"),
        ({"endpoints": ()}, "names no endpoint"),
        ({"endpoints": (Endpoint("::1", 1),) * 17}, "at most 16"),
        ({"endpoints": (Endpoint("::1", 0),)}, "port 0 of ::1"),
        ({"endpoints": (Endpoint("1.2.3", 5),)}, "'1.2.3' is neither"),
        ({"routers": (Endpoint("a b", 5),)}, "'a b' is neither"),
        ({"entropy": lambda size: b"short"}, "5 bytes; it must have 16"),
    ],
)
def test_what_no_invitation_has(changes: dict[str, object], sentence: str):
    with pytest.raises(SessionError, match=sentence):
        made(**changes)


@given(HOSTS, PORTS)
def test_endpoints_as_text(host: str, port: int):
    assert Endpoint.parse(str(Endpoint(host, port))) == Endpoint(host, port)


@pytest.mark.parametrize("text", ["", "host", ":5", "host:", "host:x", "::1:5", "host:123456", "host:²"])
def test_what_is_no_endpoint(text: str):
    with pytest.raises(SessionError, match="not an endpoint"):
        Endpoint.parse(text)
