"""Brings two members together again whose connection broke.

Zenoh dials again whom it was told to dial, the host, but not whom it found by gossip. When the host is gone too, two
members that were cut off for longer than the lease would never meet again. So one of the two opens a session beside its
own, which joins nothing, dials nobody else and only connects to both: by its gossip they find each other at once.
"""

import contextlib
import threading
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, final

from cotouch.errors import TransportError
from cotouch.live._invitation import Endpoint
from cotouch.live._zenoh import close_session

if TYPE_CHECKING:
    import zenoh

# Zenoh's own dialling of the host, and a restart, take less.
_PATIENCE = 2.0
# Who has not come back by then will come by the host, or be invited again.
_GIVE_UP = 120.0
_PERIOD = 0.2


@final
class Introducer:
    """Looks after the members that went away. A thread of its own; nothing else here waits."""

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
        self._thread = threading.Thread(target=self._run, name="cotouch introducer", daemon=True)
        self._thread.start()

    def gone(self, member: bytes, at: Endpoint) -> None:
        """A member that listens there is not seen any more."""
        with self._lock:
            self._gone[member] = (self._clock(), at)

    def back(self, member: bytes) -> None:
        """It is seen again."""
        with self._lock:
            self._gone.pop(member, None)

    def close(self) -> None:
        """Stops."""
        self._closing.set()
        self._thread.join(3.0)

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
            wanted = self._wanted()
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
