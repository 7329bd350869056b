"""One suite for every control plane: whoever adds one adds a line to CONTROLS."""

import hashlib
import random
import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

import pytest
from tests.control.inside import SessionKeys
from tests.control.memory import MemoryControlNetwork
from tests.control.wire import Sessions, starts_of
from tests.live.support import entropy, identities

from cotouch.control import (
    MOST_BODY,
    ControlPlane,
    ControlRouter,
    Endpoint,
    Invitation,
    MessageRefusal,
    MessageWriter,
    Presence,
    SignedMessage,
    ZenohControl,
    free_port,
)
from cotouch.errors import SessionError
from cotouch.samples import MOST_BYTES, Identity


class Bed(NamedTuple):
    """Three members who see each other, the first one the host.

    Attributes:
        who: their identities.
        planes: theirs, in the same order.
        wait: lets a little time pass.
        join: another member, or one that comes back.
        inject: puts bytes on the wire as the member of this number, for all others.
        tap: what the member of this number overhears of everybody's beats, from now on.
        beat: puts a beat on the wire as the member of this number, under another's name where there are names.
        pretend: the member of this number says, as far as the network goes, that another came, or left.
        kill: ends the member of this number without a word.
    """

    who: list[Identity]
    planes: list[ControlPlane]
    session: bytes
    wait: Callable[[], None]
    join: Callable[[Identity], ControlPlane]
    inject: Callable[[int, bytes], None]
    tap: Callable[[int], list[bytes]]
    beat: Callable[[int, bytes, bytes], None]
    pretend: Callable[[int, bytes, bool], None]
    kill: Callable[[int], None]


def in_memory() -> Iterator[Bed]:
    who = identities(3)
    network = MemoryControlNetwork(delay=0.02)

    def wait() -> None:
        network.now += 0.01

    def inject(member: int, raw: bytes) -> None:
        network.carry(who[member].public, None, raw)

    def tap(member: int) -> list[bytes]:
        received, plane = list[bytes](), planes[member]
        deliver = plane.deliver

        def intercept(time: float, sender: bytes, message: bytes, *, beat: bool = False) -> None:
            if beat:
                received.append(message)
            deliver(time, sender, message, beat=beat)

        plane.deliver = intercept
        return received

    def beat(member: int, key: bytes, raw: bytes) -> None:
        del key  # here nobody is believed to be anybody
        network.carry(who[member].public, None, raw, beat=True)

    planes = [network.join(one) for one in who]
    yield Bed(
        who,
        planes,
        network.session,
        wait,
        network.join,
        inject,
        tap,
        beat,
        lambda member, key, here: None,
        lambda member: network.kill(who[member].public),
    )


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
    keys = [SessionKeys(made, one.public) for one in who]

    def join(identity: Identity) -> ControlPlane:
        plane = ZenohControl(made, identity)
        opened.append(plane)
        return plane

    def inject(member: int, raw: bytes) -> None:
        import zenoh

        # As urgent as what is said, so that it keeps its place among it.
        urgent = {"priority": zenoh.Priority.INTERACTIVE_HIGH, "congestion_control": zenoh.CongestionControl.BLOCK}
        sessions[member].put(keys[member].to("said"), raw, **urgent)

    def tap(member: int) -> list[bytes]:
        received = list[bytes]()
        sessions[member].declare_subscriber(
            f"{keys[member].prefix}/beat/**", lambda sample: received.append(sample.payload.to_bytes())
        )
        return received

    def beat(member: int, key: bytes, raw: bytes) -> None:
        sessions[member].put(f"{keys[member].prefix}/beat/{key.hex()}/*", raw)

    def pretend(member: int, key: bytes, here: bool) -> None:
        session, prefix = sessions[member], keys[member].prefix
        for start in {"0" * 16, *starts_of(session, keys[member], key)}:
            token = session.liveliness().declare_token(f"{prefix}/alive/{key.hex()}/{start}/-")
            tokens.append(token)
            if not here:
                token.undeclare()

    def kill(member: int) -> None:
        sessions[member].close()

    tokens = []
    with pytest.MonkeyPatch.context() as monkeypatch:
        sessions = Sessions(monkeypatch)
        try:
            planes = [join(one) for one in who]
            yield Bed(who, planes, made.id, lambda: time.sleep(0.005), join, inject, tap, beat, pretend, kill)
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
    """Waits, but not for ever: a busy machine takes its time."""
    for _ in range(12_000):
        if done():
            return
        bed.wait()
    pytest.fail("it did not come")


def collect(bed: Bed, at: int, count: int) -> list[SignedMessage]:
    """So many messages, and a little longer for one too many."""
    out: list[SignedMessage] = []

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
        assert collect(bed, at, 1) == [SignedMessage(bed.who[1].public, "roster", b"everybody", direct=False)]
    assert bed.planes[1].poll() == []
    assert not bed.planes[1].refused  # nothing of its own came back


def test_one_hears_what_is_for_one(bed: Bed):
    bed.planes[1].send("link.keys", b"you", to=bed.who[2].public)
    assert collect(bed, 2, 1) == [SignedMessage(bed.who[1].public, "link.keys", b"you", direct=True)]
    assert bed.planes[0].poll() == bed.planes[1].poll() == []


def test_messages_come_once_and_in_order(bed: Bed):
    for k in range(300):
        bed.planes[0].send("count", k.to_bytes(2, "big"), to=bed.who[1].public if k % 3 else None)
    received = collect(bed, 1, 300)
    assert [int.from_bytes(message.body, "big") for message in received] == list(range(300))
    assert [message.direct for message in received] == [bool(k % 3) for k in range(300)]


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
    received: list[SignedMessage] = []
    until(bed, lambda: bool(received.extend(back.poll()) or received))
    assert received[0].topic == "third"


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

    def came() -> bool:
        got.extend(bed.planes[2].relayed())
        return bool(got) and got[-1].payload == payload

    for payload in sent:  # what does not get through at once is dropped rather than queued: it is sent again
        for _ in range(100):
            assert bed.planes[1].relay(bed.who[2].public, payload)
            for _ in range(20):
                if came():
                    break
                bed.wait()
            if came():
                break
    assert list(dict.fromkeys(one.payload for one in got)) == sent
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


def forged(bed: Bed, intercepted: list[bytes], victim: bytes) -> list[bytes]:
    """Beats in a victim's name by one who has all that was overheard, and keys of its own."""
    mine, made = bed.who[1], list[bytes]()
    theirs = [raw for raw in intercepted if raw[4:36] == victim]
    own = Presence(mine, bed.session, entropy(77))
    for at, raw in enumerate(intercepted):
        own.receive(raw, 0.01 * at)
    beat = own.beat(1.0)
    assert beat is not None
    made.append(beat.replace(mine.public, victim))  # its own life and signature
    for raw in theirs[-3:]:
        made += [raw, raw[:140] + bytes([raw[140] ^ 1]) + raw[141:]]  # said again; and as if it left
        made.append(raw[:132] + beat[132:140] + raw[140:])  # with a word of its own
    return made


def test_a_dead_members_presence_cannot_be_made_up(bed: Bed):
    """Neither by its liveliness, nor by what it said, nor by other keys: it is gone, and stays so."""
    dead = bed.who[0].public
    intercepted = bed.tap(1)
    until(bed, lambda: sum(raw[4:36] == dead for raw in intercepted) >= 3)
    bed.kill(0)

    def lie() -> None:
        bed.pretend(1, dead, True)
        for raw in forged(bed, intercepted, dead):
            bed.beat(1, dead, raw)

    lie()
    lies = 0

    def gone() -> bool:
        nonlocal lies
        lies += 1
        if lies % 10 == 0:
            lie()
        return dead not in bed.planes[2].present()

    until(bed, gone)
    for _ in range(40):
        bed.wait()
        assert gone()


def test_who_is_there_cannot_be_made_absent(bed: Bed):
    here = bed.who[0].public
    intercepted = bed.tap(1)
    until(bed, lambda: sum(raw[4:36] == here for raw in intercepted) >= 3)
    for turn in range(600):
        if turn % 20 == 0:
            bed.pretend(1, here, False)
            for raw in forged(bed, intercepted, here):
                bed.beat(1, here, raw)
        bed.wait()
        assert here in bed.planes[2].present()


def test_a_newcomer_is_not_told_of_the_dead(bed: Bed):
    """It never heard them, so all that they said is new to it."""
    dead, intercepted = bed.who[2].public, bed.tap(1)
    until(bed, lambda: sum(raw[4:36] == dead for raw in intercepted) >= 3)
    bed.kill(2)
    newcomer = bed.join(identities(4)[3])
    until(bed, lambda: bed.who[0].public in newcomer.present())
    for raw in [raw for raw in intercepted if raw[4:36] == dead]:
        bed.beat(1, dead, raw)
        for _ in range(5):
            bed.wait()
            assert dead not in newcomer.present()


def test_who_is_shunned_is_not_heard(bed: Bed):
    bed.planes[2].shun(frozenset({bed.who[1].public}))
    bed.planes[1].send("a", b"shunned")
    bed.planes[0].send("a", b"received")
    assert [message.body for message in collect(bed, 2, 1)] == [b"received"]
    assert bed.planes[2].present() == {bed.who[0].public}
    until(bed, lambda: bed.planes[2].dropped["shunned"] == 1)  # what one says may come long after what another does
    bed.planes[2].shun(frozenset())
    bed.planes[1].send("a", b"again")
    assert [message.body for message in collect(bed, 2, 1)] == [b"again"]
