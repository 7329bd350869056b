"""What members of a control plane over Zenoh say to each other, and what the invited may say there that none would."""

import hashlib
import os
import struct
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from typing import Any, NamedTuple

import pytest
from tests.control.inside import PairTags, SessionKeys
from tests.control.wire import Sessions, starts_of
from tests.live.support import entropy, identities

from cotouch.control import Endpoint, Invitation, MessageRefusal, MessageWriter, Relayed, ZenohControl, free_port

WHO = identities(4)
# Only for what never comes: a busy machine takes its time [s].
PATIENCE = 60.0


def until(done: Callable[[], object]) -> None:
    end = time.monotonic() + PATIENCE
    while not done():
        if time.monotonic() > end:
            pytest.fail("it did not come")
        time.sleep(0.005)


class Stuck:
    """A session of Zenoh that closes late, as one does that is dialling somebody who does not answer."""

    def __init__(self, session: Any, late: threading.Event) -> None:
        self._session, self._late = session, late

    def __getattr__(self, name: str) -> Any:
        return getattr(self._session, name)

    def close(self) -> None:
        self._late.wait(2.0 * PATIENCE)
        self._session.close()


class Met(NamedTuple):
    """Members who see each other, the first one the host, and their sessions of Zenoh.

    Attributes:
        invitation: to their session.
        planes: theirs.
        sessions: likewise.
        keys: under which they speak.
    """

    invitation: Invitation
    planes: list[ZenohControl]
    sessions: Sessions
    keys: list[SessionKeys]

    def tagged(self, said: bytes, sender: int, receiver: int) -> bytes:
        """With the MAC that only these two can make."""
        tag = PairTags(WHO[sender], self.invitation.id).tag(WHO[receiver].public, said)
        assert tag is not None
        return said + tag

    def put(self, by: int, key: str, said: bytes) -> None:
        """Says something under any key, and waits for room on the way."""
        import zenoh

        self.sessions[by].put(key, said, congestion_control=zenoh.CongestionControl.BLOCK)

    def part(self, by: int, member: int) -> None:
        """One says, as far as the network goes, that another left: all others lose sight of that, as behind NATs."""
        session, prefix = self.sessions[by], self.keys[by].prefix
        for start in starts_of(session, self.keys[by], WHO[member].public):
            session.liveliness().declare_token(f"{prefix}/alive/{WHO[member].public.hex()}/{start}/-").undeclare()

    def handed(self, kind: str) -> list[bytes]:
        """What the host is given to hand on, from now on."""
        found = list[bytes]()
        self.sessions[0].declare_subscriber(
            f"{self.keys[0].prefix}/{kind}/*/*", lambda sample: found.append(sample.payload.to_bytes())
        )
        return found


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as stack:
        yield stack


@pytest.fixture
def meet(stack: ExitStack, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Met]:
    def joined(count: int, around: Callable[[Any], Any] = lambda session: session) -> Met:
        at = (Endpoint("127.0.0.1", free_port()),)
        made = Invitation.make(session="zenoh", host=WHO[0].public, digest=bytes(32), entropy=entropy(1), endpoints=at)
        sessions, planes = Sessions(monkeypatch, around), []
        for one in WHO[:count]:
            planes.append(ZenohControl(made, one))
            stack.callback(planes[-1].close)
        until(lambda: all(len(plane.present()) == count - 1 for plane in planes))
        return Met(made, planes, sessions, [SessionKeys(made, one.public) for one in WHO[:count]])

    return joined


def test_one_connection_for_each_two(meet: Callable[..., Met]):
    met = meet(4)
    time.sleep(0.3)
    assert [len(met.sessions[member].info.links()) for member in range(4)] == [3, 3, 3, 3]


def test_the_end_of_an_earlier_start_does_not_hide_a_later_one(meet: Callable[..., Met], stack: ExitStack):
    """A member that was killed comes back before the others noticed; then they notice."""
    met = meet(2)
    host, earlier = met.planes
    later = ZenohControl(met.invitation, WHO[1])
    stack.callback(later.close)

    def starts() -> int:
        return len(starts_of(met.sessions[0], met.keys[0], WHO[1].public))

    until(lambda: starts() == 2)
    earlier.close()
    until(lambda: starts() == 1)
    until(lambda: host.present() == {WHO[1].public})
    until(lambda: later.present() == {WHO[0].public})  # the host may have seen it sooner than it the host
    until(lambda: host.relay(WHO[1].public, b"seen") and later.relayed())  # it is connected, too
    later.send("hello", b"")
    until(host.poll)


def test_who_leaves_is_not_seen_any_more_however_long_its_session_takes_to_close(
    meet: Callable[..., Met], stack: ExitStack
) -> None:
    late = threading.Event()
    met = meet(2, lambda session: Stuck(session, late))
    stack.callback(late.set)
    host, member = met.planes
    until(lambda: host.relay(WHO[1].public, b"seen"))
    member.close()
    until(lambda: not host.relay(WHO[1].public, b"seen"))
    assert not starts_of(met.sessions[0], met.keys[0], WHO[1].public)


def test_a_liar_serves_a_file(meet: Callable[..., Met]):
    """What it sends has another hash: not taken, counted, and the true one is found."""
    met = meet(3)
    content = os.urandom(1000)
    digest = hashlib.sha256(content).digest()
    prefix, me = met.keys[1].prefix, WHO[1].public.hex()

    def lie(query: Any) -> None:
        with query:
            key = str(query.key_expr)
            size = key.startswith(f"{prefix}/size")
            query.reply(key.replace("*", me), struct.pack(">Q", 4) if size else b"lies")

    for key in (f"{prefix}/size/{digest.hex()}/{me}", f"{prefix}/file/{digest.hex()}/{me}/*"):
        met.sessions[1].declare_queryable(key, lie)
    assert met.planes[2].fetch(digest) is None
    until(lambda: met.planes[2].corrupt[me] == 1)
    assert met.planes[2].fetch(digest) is None
    met.planes[0].offer(content)
    until(lambda: met.planes[2].fetch(digest) is not None)
    assert met.planes[2].fetch(digest) == content


def test_relays_are_counted_against_their_sender(meet: Callable[..., Met], monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("cotouch.control._relays._RATE", 100.0)
    met = meet(2)
    two = met.planes[1]
    flood = met.tagged(b"flood", 0, 1)
    for _ in range(3000):
        met.put(0, met.keys[0].to("relay", WHO[1].public), flood)
    until(lambda: two.dropped["relayed"] > 0)
    assert 0 < len(two.relayed()) < 2900


def test_nobody_spends_anothers_limits(meet: Callable[..., Met]):
    """A third member floods in the name of the first, at the second and at the host that hands on."""
    met = meet(4)
    _, one, two, _ = met.planes
    to = WHO[2].public
    for kind in ("relay", "pass", "via"):
        for _ in range(2000):
            met.put(3, met.keys[1].to(kind, to), met.tagged(met.tagged(b"flood", 3, 2), 3, 0))
    until(lambda: two.dropped["relayed, forged"] >= 2000)
    assert two.dropped["relayed"] == 0
    assert one.relay(to, b"seen")
    until(lambda: [relayed for relayed in two.relayed() if relayed.payload == b"seen"])
    passed = met.handed("pass")
    met.part(3, 2)
    until(lambda: one.relay(to, b"not seen") and passed)
    until(lambda: [relayed for relayed in two.relayed() if relayed.payload == b"not seen"])
    messages = met.handed("via")
    one.send("nonces", b"by the host", to=to)
    until(lambda: [message for message in two.poll() if message.body == b"by the host"])
    until(lambda: messages)


def test_no_member_reads_or_writes_what_is_configured_at_another(meet: Callable[..., Met]):
    import zenoh

    met = meet(2)
    one, two = met.sessions[0], met.sessions[1]
    others = zenoh.Locality.REMOTE
    for about in ("@/**", f"@/{one.info.zid()}/**", "**"):
        assert list(two.get(about, timeout=1.0, allowed_destination=others)) == []
    there = f"@/{one.info.zid()}/peer/config"
    two.put(f"{there}/scouting/multicast/enabled", b"true")
    two.delete(f"{there}/transport/unicast/max_sessions")
    assert list(two.get(f"{there}/**", timeout=1.0, allowed_destination=others)) == []


def test_the_host_hands_on_datagrams_of_who_is_not_seen(meet: Callable[..., Met]):
    """Two of four do not see each other, as behind two NATs."""
    met = meet(4)
    host, one, two, _ = met.planes
    passed = met.handed("pass")
    met.part(3, 1)
    met.part(3, 2)
    until(lambda: one.relay(WHO[2].public, b"") and passed)
    got: list[Relayed] = []

    def come(count: int) -> bool:
        got.extend(relayed for relayed in two.relayed() if relayed.payload)
        return len(got) >= count

    def carried(k: int) -> bool:  # a relay may drop: it is said again
        assert one.relay(WHO[2].public, bytes([k]))
        return come(k + 1)

    for k in range(50):
        until(lambda k=k: carried(k))
    assert {relayed.payload for relayed in got} <= {bytes([k]) for k in range(50)}
    assert len({relayed.payload for relayed in got}) > 20
    assert {relayed.sender for relayed in got} == {WHO[1].public}
    assert host.relayed() == []
    assert len(passed) >= 50

    met.part(3, 0)
    until(lambda: not one.relay(WHO[2].public, b"nobody takes it"))


def test_it_hands_on_so_many_of_each(meet: Callable[..., Met], monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("cotouch.control._forward._PASS_BURST", 20.0)
    monkeypatch.setattr("cotouch.control._forward._PASS_RATE", 1e-3)
    met = meet(4)
    host, one, two, _ = met.planes
    passed = met.handed("pass")
    met.part(3, 2)
    until(lambda: one.relay(WHO[2].public, b"") and passed)
    two.relayed()
    handed = len(passed)
    for k in range(60):
        one.relay(WHO[2].public, bytes([k]))
        time.sleep(0.01)
    one.send("last", b"")
    until(host.poll)
    got = two.relayed()
    until(lambda: len(got) + handed > 10 or got.extend(two.relayed()))
    time.sleep(0.2)  # for more, which must not come
    got += two.relayed()
    assert len(got) + handed > 10
    assert len(got) <= 20


def test_a_flood_of_messages_is_not_read(meet: Callable[..., Met]):
    met = meet(2)
    two = met.planes[1]
    noise = MessageWriter(WHO[0], b"of another session".ljust(32), started=1).write("noise", b"")
    for _ in range(3000):
        met.put(0, met.keys[0].to("said"), noise)
    until(lambda: sum(two.refused.values()) >= 3000)
    assert two.refused[MessageRefusal.RATE] > 2500


def test_of_who_left_little_is_kept_and_memory_is_given_back(
    meet: Callable[..., Met], monkeypatch: pytest.MonkeyPatch
) -> None:
    given = list[float]()
    monkeypatch.setattr("cotouch.control._control_zenoh._CALM", 0.2)
    monkeypatch.setattr("cotouch.control._control_zenoh.give_back_memory", lambda: given.append(time.monotonic()))
    met = meet(3)
    host, one, two = met.planes
    two.send("hello", b"")
    for plane in (host, one):
        until(plane.poll)
    until(lambda: len(given) >= 3 and time.monotonic() - given[-1] > 1.0)  # they came
    given.clear()
    left = time.monotonic()
    two.close()
    until(lambda: not host.relay(WHO[2].public, b""))
    until(lambda: not starts_of(met.sessions[1], met.keys[1], WHO[2].public))
    until(lambda: len(given) >= 2)
    assert min(given) - left >= 0.2
    # Each of the two says again what it said, as if it were here: its last counter is known, and it is a stranger.
    old = MessageWriter(WHO[2], met.invitation.id, started=1).write("hello", b"")
    for by, plane in ((1, host), (0, one)):
        before = plane.refused.copy()
        for _ in range(300):
            met.put(by, met.keys[2].to("said"), old)
        until(lambda plane=plane, before=before: sum((plane.refused - before).values()) >= 300)
        assert set(plane.refused - before) == {MessageRefusal.REPLAYED, MessageRefusal.RATE}
        assert (plane.refused - before)[MessageRefusal.RATE] > 200
