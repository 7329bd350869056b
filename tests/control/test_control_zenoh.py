"""What only the control plane over Zenoh has: ports, strangers, routers that end, liars among the invited."""

import socket
import ssl
import subprocess
import sys
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


@given(st.text(max_size=500) | st.binary(max_size=300).map(bytes.hex))
def test_what_stands_in_a_key_may_be_anything(text: str):
    sender, start = sender_of(f"cotouch/1/said/{text}/x"), start_of(f"cotouch/1/alive/{bytes(32).hex()}/2/{text}")
    assert sender is None or len(sender) == 32
    assert start is None or start.at is None or isinstance(start.at, Endpoint)
    assert start_of(text) is sender_of("cotouch/1/said") is None


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
