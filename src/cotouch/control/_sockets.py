"""This process's sockets, as the system knows them: what Zenoh opens and no configuration of it reaches."""

import os
import socket
import stat
import struct
import sys
from collections.abc import Iterator
from pathlib import Path

_LINGER = struct.Struct("ii")
# Zenoh gives what it said last so long to arrive when it closes a connection, and does nothing else meanwhile, such as
# dialling again. Where the path is gone nothing arrives [s].
_THEIRS, _OURS = 10, 1


def sockets() -> Iterator[tuple[int, socket.socket]]:
    """This process's sockets over IP: their numbers, and a handle of our own for each, to be closed."""
    if sys.platform != "linux":
        return
    for number in [int(entry.name) for entry in Path("/proc/self/fd").iterdir()]:
        try:
            if not stat.S_ISSOCK(os.fstat(number).st_mode):
                continue
            found = socket.socket(fileno=os.dup(number))
        except OSError:  # closed meanwhile
            continue
        if found.family in {socket.AF_INET, socket.AF_INET6}:
            yield number, found
        else:
            found.close()


def tend_links(gone: str | None = None) -> int:
    """Lets no connection of Zenoh hold up what follows it, and drops those of an address that is gone.

    Without it the other end is not dialled again before the connection was found dead, and closed: 12 s.

    Args:
        gone: an address that this machine had; None: none.

    Returns:
        How many were dropped.
    """
    dropped = 0
    for _, link in sockets():
        with link:
            try:
                on, seconds = _LINGER.unpack(link.getsockopt(socket.SOL_SOCKET, socket.SO_LINGER, _LINGER.size))
                if link.type != socket.SOCK_STREAM or not on or seconds not in {_THEIRS, _OURS}:
                    continue
                dead = gone is not None and link.getsockname()[0] == gone
                link.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, _LINGER.pack(1, 0 if dead else _OURS))
                if dead:
                    link.shutdown(socket.SHUT_RDWR)
                    dropped += 1
            except OSError:  # it ended meanwhile
                continue
    return dropped
