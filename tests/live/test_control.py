"""One suite for every control plane: whoever adds one adds a line to CONTROLS."""

import hashlib
import random
import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

import pytest
from tests.live.support import entropy, identities

from cotouch.errors import SessionError
from cotouch.live import (
    MOST_BODY,
    MOST_BYTES,
    ControlPlane,
    ControlRouter,
    Endpoint,
    Identity,
    Invitation,
    MemoryControlNetwork,
    Message,
    MessageRefusal,
    MessageWriter,
    ZenohControl,
    free_port,
)


class Bed(NamedTuple):
    """Three members who see each other, the first one the host.

    Attributes:
        who: their identities.
        planes: theirs, in the same order.
        wait: lets a little time pass.
        join: another member, or one that comes back.
        inject: puts bytes on the wire as the member of this number, for all others.
    """

    who: list[Identity]
    planes: list[ControlPlane]
    session: bytes
    wait: Callable[[], None]
    join: Callable[[Identity], ControlPlane]
    inject: Callable[[int, bytes], None]


def in_memory() -> Iterator[Bed]:
    who = identities(3)
    network = MemoryControlNetwork(delay=0.02)

    def wait() -> None:
        network.now += 0.01

    def inject(member: int, raw: bytes) -> None:
        network.carry(who[member].public, None, raw)

    yield Bed(who, [network.join(one) for one in who], network.session, wait, network.join, inject)


def over_zenoh(*, routed: bool) -> Iterator[Bed]:
    who = identities(3)
    at = (Endpoint("127.0.0.1", free_port()),)
    made = Invitation.make(
        session="tests",
        host=who[0].public,
        digest=bytes(32),
        endpoints=() if routed else at,
        routers=at if routed else (),
        entropy=entropy(3),
    )
    opened: list[ZenohControl | ControlRouter] = [ControlRouter(made, listen=at)] if routed else []

    def join(identity: Identity) -> ControlPlane:
        plane = ZenohControl(made, identity)
        opened.append(plane)
        return plane

    def inject(member: int, raw: bytes) -> None:
        plane = planes[member]
        import zenoh

        # As urgent as what is said, so that it keeps its place among it.
        urgent = {"priority": zenoh.Priority.INTERACTIVE_HIGH, "congestion_control": zenoh.CongestionControl.BLOCK}
        plane._session.put(f"{plane._prefix}/said/{plane._me}/*", raw, **urgent)

    try:
        planes = [join(one) for one in who]
        yield Bed(who, planes, made.id, lambda: time.sleep(0.005), join, inject)
    finally:
        for plane in reversed(opened):
            plane.close()


CONTROLS = {
    "memory": in_memory,
    "zenoh": lambda: over_zenoh(routed=False),
    "routed": lambda: over_zenoh(routed=True),
}


@pytest.fixture(params=CONTROLS)
def bed(request: pytest.FixtureRequest) -> Iterator[Bed]:
    beds = CONTROLS[request.param]()
    bed = next(beds)
    until(bed, lambda: all(len(plane.present()) == 2 for plane in bed.planes))
    yield bed
    with pytest.raises(StopIteration):
        next(beds)


def until(bed: Bed, done: Callable[[], bool]) -> None:
    """Waits, but not for ever."""
    for _ in range(3000):
        if done():
            return
        bed.wait()
    pytest.fail("it did not come")


def collect(bed: Bed, at: int, count: int) -> list[Message]:
    """So many messages, and a little longer for one too many."""
    out: list[Message] = []

    def done() -> bool:
        out.extend(bed.planes[at].poll())
        return len(out) >= count

    until(bed, done)
    for _ in range(10):
        bed.wait()
    return out + bed.planes[at].poll()


def test_everybody_sees_all_others(bed: Bed):
    keys = {one.public for one in bed.who}
    for one, plane in zip(bed.who, bed.planes, strict=True):
        assert plane.present() == keys - {one.public}
        assert plane.identity.public == one.public


def test_all_others_hear_what_is_for_all(bed: Bed):
    bed.planes[1].send("roster", b"everybody")
    for at in (0, 2):
        assert collect(bed, at, 1) == [Message(bed.who[1].public, "roster", b"everybody", direct=False)]
    assert bed.planes[1].poll() == []
    assert not bed.planes[1].refused  # nothing of its own came back


def test_one_hears_what_is_for_one(bed: Bed):
    bed.planes[1].send("link.keys", b"you", to=bed.who[2].public)
    assert collect(bed, 2, 1) == [Message(bed.who[1].public, "link.keys", b"you", direct=True)]
    assert bed.planes[0].poll() == bed.planes[1].poll() == []


def test_messages_come_once_and_in_order(bed: Bed):
    for k in range(300):
        bed.planes[0].send("count", k.to_bytes(2, "big"), to=bed.who[1].public if k % 3 else None)
    heard = collect(bed, 1, 300)
    assert [int.from_bytes(message.body, "big") for message in heard] == list(range(300))
    assert [message.direct for message in heard] == [bool(k % 3) for k in range(300)]


def test_polling_when_nothing_was_said(bed: Bed):
    assert bed.planes[0].poll() == []
    assert bed.planes[0].relayed() == []


def test_the_longest_body_arrives_whole(bed: Bed):
    body = random.Random(1).randbytes(MOST_BODY)
    bed.planes[0].send("a", b"")
    bed.planes[0].send("a.long.one", body)
    assert [message.body for message in collect(bed, 1, 2)] == [b"", body]


def test_what_cannot_be_said_is_named(bed: Bed):
    plane = bed.planes[0]
    with pytest.raises(SessionError, match="lower-case words"):
        plane.send("Not a topic", b"")
    with pytest.raises(SessionError, match=f"{MOST_BODY + 1} bytes"):
        plane.send("a", bytes(MOST_BODY + 1))
    for nobody in (b"short", bytes(32), plane.identity.public):
        with pytest.raises(SessionError, match="another member's public key"):
            plane.send("a", b"", to=nobody)


def test_who_leaves_is_missed(bed: Bed):
    bed.planes[1].close()
    until(bed, lambda: bed.who[1].public not in bed.planes[0].present() | bed.planes[2].present())
    bed.planes[0].send("still.here", b"")
    assert len(collect(bed, 2, 1)) == 1


def test_what_was_said_before_leaving_is_heard(bed: Bed):
    bed.planes[1].send("goodbye", b"")
    bed.planes[1].close()
    assert [message.topic for message in collect(bed, 0, 1)] == ["goodbye"]


@pytest.mark.parametrize("member", [0, 1])
def test_who_comes_back_is_heard(bed: Bed, member: int):
    """The host too: under the same identity, above all counters of before."""
    other, key = bed.planes[2], bed.who[member].public
    bed.planes[member].send("first", b"")
    assert len(collect(bed, 2, 1)) == 1
    bed.planes[member].close()
    until(bed, lambda: key not in other.present())
    back = bed.join(bed.who[member])
    until(bed, lambda: key in other.present() and bed.who[2].public in back.present())
    back.send("second", b"")
    assert [message.topic for message in collect(bed, 2, 1)] == ["second"]
    other.send("third", b"", to=key)
    heard: list[Message] = []
    until(bed, lambda: bool(heard.extend(back.poll()) or heard))
    assert heard[0].topic == "third"


def test_a_closed_plane_is_silent(bed: Bed):
    plane = bed.planes[1]
    plane.close()
    plane.close()
    plane.send("anybody.there", b"")
    bed.planes[0].send("hello", b"")
    for _ in range(10):
        bed.wait()
    assert (plane.poll(), plane.relayed(), plane.present()) == ([], [], frozenset())
    assert not plane.relay(bed.who[0].public, b"x")
    assert bed.planes[0].poll() == []


def fetched(bed: Bed, at: int, digest: bytes) -> bytes:
    got: list[bytes | None] = [None]

    def done() -> bool:
        got[0] = bed.planes[at].fetch(digest)
        return got[0] is not None

    until(bed, done)
    return got[0] or b""


@pytest.mark.parametrize("size", [0, 1, 256 << 10, (256 << 10) + 1, 10 << 20])
def test_a_file_is_fetched_by_its_hash(bed: Bed, size: int):
    content = random.Random(size).randbytes(size)
    digest = bed.planes[0].offer(content)
    assert digest == hashlib.sha256(content).digest()
    assert bed.planes[0].fetch(digest) == content
    assert bed.planes[1].fetch(digest) is None
    assert fetched(bed, 1, digest) == content


def test_who_fetched_a_file_serves_it(bed: Bed):
    digest = bed.planes[0].offer(b"a body" * 1000)
    fetched(bed, 1, digest)
    bed.planes[0].close()
    assert fetched(bed, 2, digest) == b"a body" * 1000


def test_a_file_may_be_asked_for_before_it_is_offered(bed: Bed):
    digest = hashlib.sha256(b"later").digest()
    assert bed.planes[1].fetch(digest) is None
    for _ in range(5):
        bed.wait()
    assert bed.planes[1].fetch(digest) is None
    bed.planes[2].offer(b"later")
    assert fetched(bed, 1, digest) == b"later"


def test_datagrams_are_handed_on(bed: Bed):
    sent = [k.to_bytes(2, "big") * (MOST_BYTES // 2) for k in range(60)]
    got = []

    def done() -> bool:
        got.extend(bed.planes[2].relayed())
        return len(got) >= 60

    for payload in sent:
        assert bed.planes[1].relay(bed.who[2].public, payload)
        bed.wait()
    until(bed, done)
    assert [one.payload for one in got] == sent
    assert {one.sender for one in got} == {bed.who[1].public}
    assert [one.time for one in got] == sorted(one.time for one in got)
    assert bed.planes[0].relayed() == []


def test_what_cannot_be_handed_on(bed: Bed):
    assert not bed.planes[0].relay(bed.who[1].public, bytes(MOST_BYTES + 1))
    assert not bed.planes[0].relay(bytes(range(32)), b"who?")


def test_nobody_speaks_in_anothers_name(bed: Bed):
    """A member signs with its own key what it says is from another; and sends again what another said."""
    mine = MessageWriter(bed.who[1], bed.session, started=1)
    forged = mine.write("roster", b"forged").replace(bed.who[1].public, bed.who[0].public)
    theirs = MessageWriter(bed.who[0], bed.session, started=1).write("roster", b"true")
    elsewhere = MessageWriter(bed.who[0], bytes(31) + b"1", started=2).write("roster", b"elsewhere")
    for raw in (forged, elsewhere, bytes(2 * MOST_BODY), b"noise", theirs, theirs):
        bed.inject(1, raw)
    assert [message.body for message in collect(bed, 2, 1)] == [b"true"]
    assert bed.planes[2].refused == {
        MessageRefusal.FORGED: 2,
        MessageRefusal.REPLAYED: 1,
        MessageRefusal.SIZE: 2,
    }
