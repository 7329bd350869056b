"""Connections that Zenoh opened, as told by how long they linger; and no others."""

import socket
import struct
import sys
from collections.abc import Iterator

import pytest
from tests.control.inside import is_ours, sockets, tend_links

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="this system does not show a process its sockets")
GONE = "127.0.0.9"


@pytest.fixture
def listening() -> Iterator[socket.socket]:
    with socket.create_server(("127.0.0.1", 0)) as made:
        made.settimeout(5.0)
        yield made


def dialled(listening: socket.socket, source: str, seconds: int | None) -> tuple[socket.socket, socket.socket]:
    """A connection from there that lingers for so long, and its other end."""
    near = socket.create_connection(listening.getsockname(), source_address=(source, 0), timeout=5.0)
    if seconds is not None:
        near.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, seconds))
    far, _ = listening.accept()
    far.settimeout(5.0)
    return near, far


def lingers(link: socket.socket) -> tuple[int, int]:
    return struct.unpack("ii", link.getsockopt(socket.SOL_SOCKET, socket.SO_LINGER, 8))


def test_connections_of_zenoh_linger_for_a_second_and_those_of_an_address_that_is_gone_end(
    listening: socket.socket,
) -> None:
    made = [dialled(listening, *about) for about in ((GONE, 10), ("127.0.0.1", 10), (GONE, None), (GONE, 7))]
    (dead, dead_far), (kept, kept_far), (other, _), (third, _) = made
    try:
        assert tend_links() == 0
        assert [lingers(near) for near, _ in made] == [(1, 1), (1, 1), (0, 0), (1, 7)]
        assert tend_links(GONE) == 1
        assert dead.recv(1) == dead_far.recv(1) == b""  # whoever reads knows at once
        assert lingers(dead) == (1, 0)
        for near in (kept, other, third):
            near.sendall(b"x")
        assert kept_far.recv(1) == b"x"
    finally:
        for near, far in made:
            near.close()
            far.close()


def test_a_process_sees_its_own_sockets(listening: socket.socket) -> None:
    found = dict(sockets())
    try:
        assert found[listening.fileno()].getsockname() == listening.getsockname()
        assert found[listening.fileno()].fileno() != listening.fileno()
    finally:
        for one in found.values():
            one.close()


def test_which_addresses_are_this_machines() -> None:
    assert is_ours("127.0.0.1")
    assert not is_ours("192.0.2.1")
