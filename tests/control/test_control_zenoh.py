"""What only the control plane over Zenoh has: ports, strangers, routers that end, liars among the invited."""

import hashlib
import os
import socket
import ssl
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.control.inside import open_session, sender_of, start_of
from tests.live.support import entropy, identities

from cotouch.control import (
    ControlRouter,
    Endpoint,
    Invitation,
    MessageWriter,
    Relayed,
    SignedMessage,
    ZenohControl,
    free_port,
    make_certificates,
)
from cotouch.errors import SessionError, TransportError

WHO = identities(4)
# Only for what never comes: a busy machine takes its time [s].
PATIENCE = 60.0


def invitation(*, routed: bool = False, seed: int = 1) -> Invitation:
    at = (Endpoint("127.0.0.1", free_port()),)
    places = {"routers": at, "endpoints": ()} if routed else {"endpoints": at}
    return Invitation.make(session="zenoh", host=WHO[0].public, digest=bytes(32), entropy=entropy(seed), **places)


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as stack:
        yield stack


def joined(stack: ExitStack, made: Invitation, count: int) -> list[ZenohControl]:
    planes = []
    for one in WHO[:count]:
        planes.append(ZenohControl(made, one))
        stack.callback(planes[-1].close)
    until(lambda: all(len(plane.present()) == count - 1 for plane in planes))
    return planes


def until(done: Callable[[], object]) -> None:
    end = time.monotonic() + PATIENCE
    while not done():
        if time.monotonic() > end:
            pytest.fail("it did not come")
        time.sleep(0.005)


class Spy:
    """A session of Zenoh that notes which keys it listens at."""

    def __init__(self, session: Any, keys: set[str]) -> None:
        self._session, self._keys = session, keys

    def __getattr__(self, name: str) -> Any:
        found = getattr(self._session, name)
        if name not in {"declare_subscriber", "declare_queryable"}:
            return found

        def declare(key: str, *args: Any, **more: Any) -> Any:
            self._keys.add(key)
            return found(key, *args, **more)

        return declare


def test_no_two_members_listen_at_the_same_key(stack: ExitStack, monkeypatch: pytest.MonkeyPatch) -> None:
    # Zenoh would never let go of a member that did and is gone: memory that rises for as long as members come and go.
    spied: list[set[str]] = []

    def spy(configured: str) -> Any:
        spied.append(set())
        return Spy(open_session(configured), spied[-1])

    monkeypatch.setattr("cotouch.control._line.open_session", spy)
    one, other = joined(stack, invitation(), 2)
    assert all(len(keys) >= 4 for keys in spied)  # said, relayed, files and their sizes
    assert not spied[0] & spied[1]
    other.send("nonces", b"to all")
    one.send("nonces", b"to one", to=other.identity.public)
    received: list[list[SignedMessage]] = [[], []]
    until(
        lambda: (
            [said.extend(plane.poll()) for said, plane in zip(received, (one, other), strict=True)] and all(received)
        )
    )
    assert [(said.body, said.direct) for said in received[0] + received[1]] == [(b"to all", False), (b"to one", True)]


def test_one_connection_for_each_two(stack: ExitStack):
    planes = joined(stack, invitation(), 4)
    time.sleep(0.3)
    assert [len(plane._session.info.links()) for plane in planes] == [3, 3, 3, 3]


def test_a_taken_port_is_named(stack: ExitStack):
    made = invitation()
    joined(stack, made, 1)
    with pytest.raises(TransportError, match=rf"port of 127\.0\.0\.1:{made.endpoints[0].port} is taken"):
        ZenohControl(made, WHO[0])


def test_another_machines_address_is_named():
    made = invitation()
    with pytest.raises(TransportError, match=r"192\.0\.2\.1:9 is not an address of this machine"):
        ZenohControl(made, WHO[0], listen=Endpoint("192.0.2.1", 9))
    with pytest.raises(TransportError, match=r"192\.0\.2\.1 is not an address of this machine"):
        ZenohControl(made, WHO[1], listen="192.0.2.1")
    with pytest.raises(SessionError, match="'everywhere' is not a numeric address"):
        ZenohControl(made, WHO[1], listen="everywhere")


def test_no_router_is_named():
    made = invitation(routed=True)
    with pytest.raises(TransportError, match=rf"no router .* answers at 127\.0\.0\.1:{made.routers[0].port}"):
        ZenohControl(made, WHO[0])


def listening() -> set[tuple[str, int]]:
    """Addresses and ports on which this process listens, as Linux tells."""
    mine = set()
    for descriptor in Path("/proc/self/fd").iterdir():
        try:
            mine.add(str(descriptor.readlink()))
        except OSError:
            continue
    out = set()
    for table, family in (("tcp", socket.AF_INET), ("tcp6", socket.AF_INET6)):
        for line in Path("/proc/self/net", table).read_text().splitlines()[1:]:
            _, local, _, state, *_, inode = line.split()[:10]
            if state == "0A" and f"socket:[{inode}]" in mine:
                raw, port = local.split(":")
                nonces = [bytes.fromhex(raw[k : k + 8])[::-1] for k in range(0, len(raw), 8)]
                out.add((socket.inet_ntop(family, b"".join(nonces)), int(port, 16)))
    return out


@pytest.mark.skipif(not Path("/proc/self/net/tcp").exists(), reason="only Linux tells who listens where")
def test_nobody_listens_but_where_told(stack: ExitStack):
    before = listening()
    made = invitation()
    planes = joined(stack, made, 3)
    found = listening() - before
    assert found >= {tuple(plane.endpoint) for plane in planes}
    assert all(host.startswith("127.") for host, _ in found)  # what else there is serves the gates
    reachable = ZenohControl(made, WHO[3], listen="reachable")
    stack.callback(reachable.close)
    beside = {(host, port) for host, port in listening() - before - found if not host.startswith("127.")}
    assert tuple(reachable.endpoint) in listening()
    assert beside <= {tuple(reachable.endpoint)}
    routed = invitation(routed=True)
    router = ControlRouter(routed, listen=routed.routers)
    stack.callback(router.close)
    now = listening()
    joined(stack, routed, 2)
    assert listening() == now


class TestStrangers:
    """Plain TLS at the host's port, with whatever certificate there is."""

    def answer(
        self, made: Invitation, certificates: tuple[bytes, bytes] | None, folder: Path, patience: float = PATIENCE
    ) -> str:
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
        context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
        if certificates:
            file = folder / "own.pem"
            file.write_bytes(b"".join(certificates))
            context.load_cert_chain(file)
        with socket.create_connection(made.endpoints[0]) as plain:
            plain.settimeout(PATIENCE)
            try:
                with context.wrap_socket(plain) as wrapped:
                    wrapped.settimeout(patience)
                    return "closed" if wrapped.recv(1) == b"" else "spoken to"
            except TimeoutError:
                return "let in"
            except (ssl.SSLError, ConnectionError) as error:
                return str(error)

    def test_are_sent_away(self, stack: ExitStack, tmp_path: Path):
        made, other = invitation(), invitation(seed=2)
        joined(stack, made, 1)
        mine, theirs = (make_certificates(one, entropy=entropy(5))[1:] for one in (made, other))
        assert self.answer(made, mine, tmp_path, 1.0) == "let in"
        assert self.answer(made, None, tmp_path) not in {"let in", "spoken to"}
        assert self.answer(made, theirs, tmp_path) not in {"let in", "spoken to"}

    def test_learn_nothing_from_the_certificate(self, stack: ExitStack, tmp_path: Path):
        made = invitation()
        (host,) = joined(stack, made, 1)
        seen = ssl.PEM_cert_to_DER_cert(ssl.get_server_certificate(made.endpoints[0]))
        for secret in (made.secret, made.session.encode(), made.host, made.id, host.identity.public.hex().encode()):
            assert secret not in seen


def test_members_meet_again_when_their_router_comes_back(stack: ExitStack):
    made = invitation(routed=True)
    router = ControlRouter(made, listen=made.routers)
    one, two = joined(stack, made, 2)
    router.close()
    until(lambda: not one.present() | two.present())
    router = ControlRouter(made, listen=made.routers)
    stack.callback(router.close)
    until(lambda: one.present() and two.present())
    one.send("again", b"")
    until(lambda: [message.topic for message in two.poll()] == ["again"])


def test_the_end_of_an_earlier_start_does_not_hide_a_later_one(stack: ExitStack):
    """A member that was killed comes back before the others noticed; then they notice."""
    made = invitation()
    (host, earlier) = joined(stack, made, 2)
    later = ZenohControl(made, WHO[1])
    stack.callback(later.close)
    until(lambda: host._starts.count(WHO[1].public) == 2)
    earlier.close()
    until(lambda: host._starts.count(WHO[1].public) == 1)
    until(lambda: host.present() == {WHO[1].public})
    until(lambda: later.present() == {WHO[0].public})  # the host may have seen it sooner than it the host
    later.send("hello", b"")
    until(host.poll)


class Stuck:
    """A session of Zenoh that closes late, as one does that is dialling somebody who does not answer."""

    def __init__(self, session: Any, late: threading.Event) -> None:
        self._session, self._late = session, late

    def __getattr__(self, name: str) -> Any:
        return getattr(self._session, name)

    def close(self) -> None:
        self._late.wait(2.0 * PATIENCE)
        self._session.close()


def test_who_leaves_is_not_seen_any_more_however_long_its_session_takes_to_close(
    stack: ExitStack, monkeypatch: pytest.MonkeyPatch
) -> None:
    late = threading.Event()
    monkeypatch.setattr("cotouch.control._line.open_session", lambda configured: Stuck(open_session(configured), late))
    host, member = joined(stack, invitation(), 2)
    stack.callback(late.set)
    until(lambda: host._starts.count(WHO[1].public) == 1)
    member.close()
    until(lambda: host._starts.count(WHO[1].public) == 0)


def test_a_liar_serves_a_file(stack: ExitStack):
    """What it sends has another hash: not taken, counted, and the true one is found."""
    planes = joined(stack, invitation(), 3)
    content = os.urandom(1000)
    digest = hashlib.sha256(content).digest()
    planes[1]._files._have[digest] = b"lies"
    assert planes[2].fetch(digest) is None
    until(lambda: planes[2]._files.corrupt[planes[1].identity.public.hex()] == 1)
    assert planes[2].fetch(digest) is None
    planes[0].offer(content)
    until(lambda: planes[2].fetch(digest) is not None)
    assert planes[2].fetch(digest) == content


def test_what_nobody_polls_is_bounded(stack: ExitStack, monkeypatch: pytest.MonkeyPatch):
    one, two = joined(stack, invitation(), 2)
    monkeypatch.setattr("cotouch.control._held._MOST_BYTES", 5000)
    for _ in range(10):
        one.send("long", bytes(1000))
        time.sleep(0.01)
    until(lambda: two.dropped["not polled"] == 4)
    assert len(two.poll()) == 6
    one.send("long", bytes(1000))
    until(two.poll)


def test_what_cannot_be_sent_yet_is_bounded(stack: ExitStack, monkeypatch: pytest.MonkeyPatch):
    one, two = joined(stack, invitation(), 2)
    monkeypatch.setattr("cotouch.control._control_zenoh._BURST", 1.0)
    monkeypatch.setattr("cotouch.control._control_zenoh._RATE", 20.0)
    monkeypatch.setattr("cotouch.control._held._MOST_ITEMS", 50)
    for _ in range(2000):
        one.send("much", b"")
    assert one.dropped["not sent yet"] > 1900
    until(two.poll)


def test_relays_are_counted_against_their_sender(stack: ExitStack, monkeypatch: pytest.MonkeyPatch):
    import zenoh

    monkeypatch.setattr("cotouch.control._relays._RATE", 100.0)
    one, two = joined(stack, invitation(), 2)
    key, waiting = one._keys.to("relay", two.identity.public), zenoh.CongestionControl.BLOCK
    flood = one._relays.tagged(b"flood", two.identity.public)
    for _ in range(3000):
        one._session.put(key, flood, congestion_control=waiting)
    until(lambda: two.dropped["relayed"] > 0)
    assert 0 < len(two.relayed()) < 2900


def test_nobody_spends_anothers_limits(stack: ExitStack):
    """A third member floods in the name of the first, at the second and at the host that hands on."""
    import zenoh

    host, one, two, third = joined(stack, invitation(), 4)
    for kind in ("relay", "pass", "via"):
        for _ in range(2000):
            third._session.put(
                one._keys.to(kind, two.identity.public),
                third._relays.tagged(third._relays.tagged(b"flood", two.identity.public), host.identity.public),
                congestion_control=zenoh.CongestionControl.BLOCK,
            )
    until(lambda: two.dropped["relayed, forged"] >= 2000)
    assert two.dropped["relayed"] == 0
    assert one.relay(two.identity.public, b"seen")
    until(lambda: [relayed for relayed in two.relayed() if relayed.payload == b"seen"])
    one._near = frozenset({host.identity.public})  # as behind a NAT of its own
    assert one.relay(two.identity.public, b"not seen")
    until(lambda: [relayed for relayed in two.relayed() if relayed.payload == b"not seen"])
    one.send("nonces", b"by the host", to=two.identity.public)
    until(lambda: [message for message in two.poll() if message.body == b"by the host"])


def test_no_member_reads_or_writes_what_is_configured_at_another(stack: ExitStack):
    import zenoh

    one, two = joined(stack, invitation(), 2)
    others = zenoh.Locality.REMOTE
    for about in ("@/**", f"@/{one._session.info.zid()}/**", "**"):
        assert list(two._session.get(about, timeout=1.0, allowed_destination=others)) == []
    there = f"@/{one._session.info.zid()}/peer/config"
    two._session.put(f"{there}/scouting/multicast/enabled", b"true")
    two._session.delete(f"{there}/transport/unicast/max_sessions")
    assert list(two._session.get(f"{there}/**", timeout=1.0, allowed_destination=others)) == []


def test_the_host_hands_on_datagrams_of_who_is_not_seen(stack: ExitStack):
    """Two of three do not see each other, as behind two NATs."""
    host, one, two = joined(stack, invitation(), 3)
    one._near = two._near = frozenset({host.identity.public})
    two._relays.unknow(one.identity.public)
    got: list[Relayed] = []

    def come(count: int) -> bool:
        got.extend(two.relayed())
        return len(got) >= count

    def carried(k: int) -> bool:  # a relay may drop: it is said again
        assert one.relay(two.identity.public, bytes([k]))
        return come(k + 1)

    for k in range(50):
        until(lambda k=k: carried(k))
    assert {relayed.payload for relayed in got} <= {bytes([k]) for k in range(50)}
    assert len({relayed.payload for relayed in got}) > 20
    assert {relayed.sender for relayed in got} == {one.identity.public}
    assert host.relayed() == []

    one._near = frozenset()
    assert not one.relay(two.identity.public, b"nobody takes it")


def test_it_hands_on_so_many_of_each(stack: ExitStack, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("cotouch.control._forward._PASS_BURST", 20.0)
    monkeypatch.setattr("cotouch.control._forward._PASS_RATE", 1e-3)
    host, one, two = joined(stack, invitation(), 3)
    one._near = frozenset({host.identity.public})
    for k in range(60):
        one.relay(two.identity.public, bytes([k]))
        time.sleep(0.01)
    one.send("last", b"")
    until(host.poll)
    got = two.relayed()
    until(lambda: len(got) > 10 or got.extend(two.relayed()))
    time.sleep(0.2)  # for more, which must not come
    got += two.relayed()
    assert 10 < len(got) <= 20


def test_a_flood_of_messages_is_not_read(stack: ExitStack):
    import zenoh

    one, two = joined(stack, invitation(), 2)
    writer = MessageWriter(WHO[0], b"of another session".ljust(32), started=1)
    noise = writer.write("noise", b"")
    for _ in range(3000):
        one._session.put(one._keys.to("said"), noise, congestion_control=zenoh.CongestionControl.BLOCK)
    until(lambda: sum(two.refused.values()) >= 3000)
    counts = {reason.name: count for reason, count in two.refused.items()}
    assert counts["RATE"] > 2500


@given(st.text(max_size=500) | st.binary(max_size=300).map(bytes.hex))
def test_what_stands_in_a_key_may_be_anything(text: str):
    sender, start = sender_of(f"cotouch/1/said/{text}/x"), start_of(f"cotouch/1/alive/{bytes(32).hex()}/2/{text}")
    assert sender is None or len(sender) == 32
    assert start is None or start.at is None or isinstance(start.at, Endpoint)
    assert start_of(text) is sender_of("cotouch/1/said") is None


def test_of_who_left_little_is_kept_and_memory_is_given_back(stack: ExitStack, monkeypatch: pytest.MonkeyPatch):
    given = list[float]()
    monkeypatch.setattr("cotouch.control._control_zenoh._CALM", 0.2)
    monkeypatch.setattr("cotouch.control._control_zenoh.give_back_memory", lambda: given.append(time.monotonic()))
    host, one, two = joined(stack, invitation(), 3)
    two.send("hello", b"")
    until(lambda: WHO[2].public in host._reader._keys and WHO[2].public in one._reader._keys)
    until(lambda: len(given) >= 3 and not any(plane._changed for plane in (host, one, two)))  # they came
    given.clear()
    left = time.monotonic()
    two.close()
    until(lambda: WHO[2].public not in host._reader._keys and WHO[2].public not in one._reader._keys)
    until(lambda: len(given) >= 2)
    assert min(given) - left >= 0.2
    assert set(host._reader._gone) == {WHO[2].public}


ENDING = """
import contextlib, json, sys, threading, time
import zenoh
from cotouch.control import _zenoh

class Slow:  # Python ends, and takes its time
    def __del__(self, sleep=time.sleep):
        sleep(2.5)

def opening():  # nobody listens at port 9 of this machine
    configured = {"mode": "client", "connect": {"endpoints": ["tcp/127.0.0.1:9"], "timeout_ms": 1200},
                  "scouting": {"multicast": {"enabled": False}}}
    with contextlib.suppress(zenoh.ZError):
        zenoh.open(zenoh.Config.from_json5(json.dumps(configured)))

class Closed:
    def close(self):
        pass

sys.slow = Slow()
_zenoh._CLOSING = 0.1
user = threading.Thread(target=opening, daemon=True)
user.start()
_zenoh.close_session(Closed(), [user])
"""


def test_python_does_not_end_while_a_thread_is_in_zenoh():
    done = subprocess.run([sys.executable, "-c", ENDING], capture_output=True, check=False, timeout=60, text=True)
    assert (done.returncode, done.stderr) == (0, "")  # else an abort: "FATAL: exception not rethrown"
