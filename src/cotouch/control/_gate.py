"""A process of its own takes the connections to this member; see `_gatekeeper.py`.

Zenoh's listener sleeps for 0.1 s after every TLS handshake that fails, and meanwhile takes nobody. Ten strangers a
second keep everybody out, and no configuration changes that. So Zenoh opens its socket, and thereby says by gossip
where this member is; then the socket is taken from it, and the gatekeeper accepts there instead. Zenoh is left with
one at which nobody calls, and with a second listener, on an address of this machine only, to which the gatekeeper
hands on what the invited say.
"""

import contextlib
import json
import os
import socket
import subprocess
import sys
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import final

from cotouch.control._certificates import TlsCertificates
from cotouch.control._invitation import Endpoint
from cotouch.control._sockets import sockets
from cotouch.errors import TransportError
from cotouch.samples import Entropy

_GATEKEEPER = Path(__file__).with_name("_gatekeeper.py")
_BACKLOG = 4096
# For a gatekeeper to let the last words out and end [s].
_PATIENCE = 2.0
# A gatekeeper that ended is started again, but not in circles [s].
_AGAIN = 0.5


def inner_endpoint(entropy: Entropy) -> str | None:
    """Where Zenoh listens for the gatekeeper: an address of this machine that nobody else uses, on any free port.

    None: this system has no such addresses, and Zenoh takes connections itself.
    """
    if sys.platform != "linux":
        return None
    _, one, two, three = entropy(4)
    return f"127.{16 + one % 200}.{two}.{1 + three % 254}"


@final
class Gate:
    """The gatekeeper of one session of Zenoh."""

    def __init__(self, outer: Sequence[Endpoint], inner: str, certificates: TlsCertificates) -> None:
        """Takes the listeners over.

        Args:
            outer: where the session listens for others.
            inner: and for the gatekeeper.
            certificates: of this member.
        """
        places = {(endpoint.host, endpoint.port) for endpoint in outer}
        named = {port for host, port in places if not host[-1].isdigit() and ":" not in host}
        self._taken, self._idle, at = list[socket.socket](), list[socket.socket](), None
        for number, found in sockets():
            if not found.getsockopt(socket.SOL_SOCKET, socket.SO_ACCEPTCONN):
                found.close()
                continue
            host, port = found.getsockname()[:2]
            if host == inner:
                at = (host, port)
            elif (host, port) in places or port in named:
                # Zenoh keeps a listener that never hears of anybody: events still come from the one that it had.
                idle = socket.create_server(("127.0.0.1", 0), backlog=1)
                idle.setblocking(False)
                os.dup2(idle.fileno(), number, inheritable=False)
                self._idle.append(idle)
                self._taken.append(found)
                found.listen(_BACKLOG)
                continue
            found.close()
        if at is None:
            raise TransportError(f"the control plane did not open its inner listener at {inner}; report this")
        orders = {name: value.decode() for name, value in certificates._asdict().items()}
        orders |= {"inner": at, "listening": [taken.fileno() for taken in self._taken]}
        self._orders = json.dumps(orders).encode() + b"\n"
        self._closing = threading.Event()
        self._process = self._start()
        self._thread = threading.Thread(target=self._watch, name="cotouch gate", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Takes no more connections; to be called when the session is closed, whose last words still go out."""
        self._closing.set()
        assert self._process.stdin is not None
        with contextlib.suppress(OSError):
            self._process.stdin.close()
        try:
            self._process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.kill()
        self._thread.join()
        for kept in self._taken + self._idle:
            kept.close()

    def _start(self) -> "subprocess.Popen[bytes]":
        process = subprocess.Popen(  # noqa: S603 - our own file, by our own interpreter
            [sys.executable, "-I", "-S", str(_GATEKEEPER)],
            stdin=subprocess.PIPE,
            pass_fds=[taken.fileno() for taken in self._taken],
            start_new_session=True,  # an interrupt from the terminal is for us; it ends with us
        )
        assert process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            process.stdin.write(self._orders)
            process.stdin.flush()
        return process

    def _watch(self) -> None:
        while True:
            self._process.wait()
            assert self._process.stdin is not None
            self._process.stdin.close()
            if self._closing.wait(_AGAIN):
                return
            process = self._start()
            self._process = process
            if self._closing.is_set():
                process.kill()
