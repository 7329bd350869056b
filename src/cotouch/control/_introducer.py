"""Brings two members together again whose connection broke.

Zenoh dials again whom it was told to dial, the host, but not whom it found by gossip. When the host is gone too, two
members that were cut off for longer than the lease would never meet again. So one of the two opens a session beside its
own, which joins nothing, dials nobody else and only connects to both: by its gossip they find each other at once.

A session costs threads, handshakes and memory, and who went away mostly stays away. So there is a knock first where a
member listened, a bare connection: only one that is taken is worth a session.
"""

import contextlib
import errno
import select
import socket
import threading
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, final

from cotouch.control._invitation import Endpoint
from cotouch.control._zenoh import close_session
from cotouch.errors import TransportError

if TYPE_CHECKING:
    import zenoh

# Zenoh's own dialling of the host, and a restart, take less.
_PATIENCE = 2.0
# Who has not come back by then will come by the host, or be invited again.
_GIVE_UP = 120.0
_PERIOD = 0.2
# For an answer to come back to a knock, over the longest of paths and after a loss; knocks follow each other as soon.
_KNOCK = 3.0
_KNOCK_EVERY = 0.5


@final
class Introducer:
    """Looks after the members that went away. A thread of its own; nothing else here waits.

    Attributes:
        thread: that opens sessions; it ends after `close`, at the latest when what it opens is open.
    """

    def __init__(
        self, own: Endpoint, open_beside: Callable[[Sequence[Endpoint]], "zenoh.Session"], clock: Callable[[], float]
    ) -> None:
        """Starts to look.

        Args:
            own: where this member listens.
            open_beside: opens a session that connects to these and does nothing else.
            clock: [s].
        """
        self._own = own
        self._open = open_beside
        self._clock = clock
        self._lock = threading.Lock()
        self._gone: dict[bytes, tuple[float, Endpoint]] = {}
        self._closing = threading.Event()
        self.thread = threading.Thread(target=self._run, name="cotouch introducer", daemon=True)
        self.thread.start()

    def gone(self, member: bytes, at: Endpoint) -> None:
        """A member that listens there is not seen any more.

        Args:
            member: its public key.
            at: endpoint in question.
        """
        with self._lock:
            self._gone[member] = (self._clock(), at)

    def back(self, member: bytes) -> None:
        """It is seen again."""
        with self._lock:
            self._gone.pop(member, None)

    def close(self) -> None:
        """Stops."""
        self._closing.set()
        self.thread.join(3.0)

    def _wanted(self) -> tuple[Endpoint, ...]:
        now = self._clock()
        with self._lock:
            for member in [member for member, (since, _) in self._gone.items() if now > since + _GIVE_UP]:
                del self._gone[member]
            return tuple(sorted({at for since, at in self._gone.values() if now > since + _PATIENCE}))

    def _run(self) -> None:
        beside: zenoh.Session | None = None
        dialled: tuple[Endpoint, ...] = ()
        while not self._closing.wait(_PERIOD):
            gone = self._wanted()
            there = {at for at in gone if at in dialled}
            fresh = [at for at in gone if at not in dialled]
            there |= answering(fresh, self._closing)
            wanted = tuple(at for at in gone if at in there)
            if fresh and not wanted:
                self._closing.wait(_KNOCK_EVERY)
            if wanted == dialled:
                continue
            if beside is not None:
                close_session(beside)
            beside, dialled = None, wanted
            if wanted:
                # What this machine refuses now, ports or memory, it may grant later.
                with contextlib.suppress(TransportError):
                    beside = self._open((self._own, *wanted))
        if beside is not None:
            close_session(beside)


def answering(places: Sequence[Endpoint], closing: threading.Event) -> set[Endpoint]:
    """Where somebody takes a connection; nothing is said on it.

    Args:
        places: where to knock, all at once.
        closing: ends the waiting.

    Returns:
        Those that answered within 3 s, or as soon as one did; names that are no addresses in numbers count, too.
    """
    found: set[Endpoint] = set()
    knocking: dict[int, Endpoint] = {}
    with contextlib.ExitStack() as open_ones:
        poller = select.poll()
        for at in places:
            try:
                family, kind, _, _, to = socket.getaddrinfo(
                    at.host, at.port, type=socket.SOCK_STREAM, flags=socket.AI_NUMERICHOST
                )[0]
            except OSError:
                found.add(at)
                continue
            knock = open_ones.enter_context(socket.socket(family, kind))
            knock.setblocking(False)
            code = knock.connect_ex(to)
            if code == 0:
                found.add(at)
            elif code == errno.EINPROGRESS:
                knocking[knock.fileno()] = at
                poller.register(knock, select.POLLOUT)
        left = _KNOCK
        while knocking and not found and left > 0.0 and not closing.is_set():
            for number, what in poller.poll(1000.0 * _PERIOD):
                poller.unregister(number)
                at = knocking.pop(number)
                if not what & (select.POLLERR | select.POLLHUP):
                    found.add(at)
            left -= _PERIOD
    return found
