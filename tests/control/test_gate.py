"""Strangers at the port, and the invited who join meanwhile."""

import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, suppress
from pathlib import Path

import pytest
from tests.live.support import entropy, identities

from cotouch.control import ControlRouter, Endpoint, Invitation, ZenohControl, free_port

STRANGERS = Path(__file__).parents[1] / "live" / "strangers.py"
WHO = identities(3)


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as stack:
        yield stack


def invitation(*, routed: bool = False) -> Invitation:
    at = (Endpoint("127.0.0.1", free_port()),)
    places = {"routers": at, "endpoints": ()} if routed else {"endpoints": at}
    return Invitation.make(session="gate", host=WHO[0].public, digest=bytes(32), entropy=entropy(1), **places)


def until(done: Callable[[], object], seconds: float = 60.0) -> None:
    ends = time.monotonic() + seconds
    while time.monotonic() < ends:
        if done():
            return
        time.sleep(0.005)
    pytest.fail("it did not come")


def besieged(stack: ExitStack, port: int, *, kind: str, count: int, sources: int) -> None:
    command = [sys.executable, str(STRANGERS), str(port), kind, str(count), str(sources)]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    assert process.stdin
    assert process.stdout
    stack.callback(process.wait)
    stack.callback(process.stdout.close)
    stack.callback(process.stdin.close)
    assert process.stdout.readline() == b"there\n"


# Without the gate the last two let nobody in: each handshake that fails stops Zenoh's listener for 0.1 s.
@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "count", "sources"),
    [("silent", 300, 0), ("silent", 2000, 5), ("dripping", 300, 0), ("noisy", 100, 5), ("uninvited", 100, 5)],
)
def test_the_invited_join_however_many_strangers_are_at_the_door(
    stack: ExitStack, kind: str, count: int, sources: int
) -> None:
    made = invitation()
    host = stack.enter_context(closing(ZenohControl(made, WHO[0])))
    besieged(stack, made.endpoints[0].port, kind=kind, count=count, sources=sources)
    for one in WHO[1:]:
        with closing(ZenohControl(made, one)) as member:
            until(lambda member=member: host.identity.public in member.present())
        until(lambda: not host.present())


@pytest.mark.slow
def test_a_router_has_a_gate_too(stack: ExitStack):
    made = invitation(routed=True)
    stack.callback(ControlRouter(made, listen=made.routers).close)
    besieged(stack, made.routers[0].port, kind="uninvited", count=100, sources=5)
    one, other = (stack.enter_context(closing(ZenohControl(made, who))) for who in WHO[:2])
    until(lambda: one.present() and other.present())


def children() -> set[int]:
    out = set[int]()
    for thread in Path("/proc/self/task").iterdir():
        with suppress(FileNotFoundError):  # it ended meanwhile
            out |= set(map(int, (thread / "children").read_text().split()))
    return out


def test_a_gatekeeper_that_dies_is_replaced_and_ends_with_its_member(stack: ExitStack):
    made, before = invitation(), children()
    host = stack.enter_context(closing(ZenohControl(made, WHO[0])))
    (keeper,) = children() - before
    os.kill(keeper, signal.SIGKILL)
    until(lambda: children() - before - {keeper})
    member = stack.enter_context(closing(ZenohControl(made, WHO[1])))
    until(lambda: host.identity.public in member.present())
    member.close()
    host.close()
    assert children() == before


def test_what_is_said_last_goes_out_through_a_slow_gatekeeper(stack: ExitStack):
    """A host says that the session ends, and closes."""
    made, before = invitation(), children()
    host = stack.enter_context(closing(ZenohControl(made, WHO[0])))
    (keeper,) = children() - before
    member = stack.enter_context(closing(ZenohControl(made, WHO[1])))
    until(lambda: host.identity.public in member.present() and WHO[1].public in host.present())
    os.kill(keeper, signal.SIGSTOP)
    host.send("end", b"")
    leaving = threading.Thread(target=host.close)
    leaving.start()
    time.sleep(0.3)
    os.kill(keeper, signal.SIGCONT)
    said = list[str]()
    until(lambda: said.extend(message.topic for message in member.poll()) or "end" in said)
    leaving.join()


def test_a_port_can_be_listened_at_again_at_once():
    made = invitation()
    for _ in range(3):
        ZenohControl(made, WHO[0]).close()


def test_a_port_that_is_about_to_be_free_is_waited_for():
    """As where a member was killed and its gatekeeper, on a busy machine, has not ended yet."""
    made = invitation()
    before = socket.create_server(("127.0.0.1", made.endpoints[0].port))
    leaving = threading.Timer(0.5, before.close)
    leaving.start()
    ZenohControl(made, WHO[0]).close()
    leaving.join()
