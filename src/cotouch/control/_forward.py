"""The host hands on what members say to each other who are not connected: too far apart, or behind NATs.

What is handed on is signed by who said it, or sealed for whom it is, so the host can only drop it. Nobody asks for
this: a member that does not see another says `via` the host what is for that member alone, and lets datagrams for it
`pass` through the host. To both it adds its MAC for the host, so that nobody uses up another's limit.
"""

import threading
from typing import TYPE_CHECKING, final

from cotouch.control._pairs import TAG_BYTES, PairTags
from cotouch.control._sign import MOST_MESSAGE, cost_of
from cotouch.control._zenoh import put
from cotouch.samples import MOST_BYTES, SourceLimit

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

_RATE, _BURST = 100.0, 200.0
# Datagrams of one sender, to all whom it does not see: ten neighbours at a relay's rate.
_PASS_RATE, _PASS_BURST = 1000.0, 500.0


@final
class Forwarder:
    """Listens at the host, and says again; in Zenoh's own threads.

    Attributes:
        shunned: names of members for whom nothing is handed on.
    """

    def __init__(self, session: "zenoh.Session", prefix: str, tags: PairTags, clock: "Callable[[], float]") -> None:
        """Begins to.

        Args:
            session: the host's.
            prefix: of the session's names.
            tags: the host's own; nobody else uses them.
            clock: [s].
        """
        import zenoh
        from zenoh.handlers import Callback

        self.shunned = frozenset[str]()
        self._session, self._prefix, self._tags, self._clock = session, prefix, tags, clock
        self._lock = threading.Lock()  # among Zenoh's threads
        # Who was not heard before costs a key agreement, and is let through only so often.
        self._strangers = SourceLimit(rate=_RATE, burst=_BURST, stranger_rate=20.0, stranger_burst=20.0)
        self._limit = SourceLimit(rate=_RATE, burst=_BURST, stranger_rate=_RATE, stranger_burst=_BURST)
        self._pass_limit = SourceLimit(
            rate=_PASS_RATE, burst=_PASS_BURST, stranger_rate=_PASS_RATE, stranger_burst=_PASS_BURST
        )
        for kind, forward in (("via", self._forward), ("pass", self._pass)):
            session.declare_subscriber(
                f"{prefix}/{kind}/*/*", Callback(forward, indirect=False), allowed_origin=zenoh.Locality.REMOTE
            )

    def _forward(self, sample: "zenoh.Sample") -> None:
        sender, to, said = self._checked(sample, MOST_MESSAGE)
        name = sender.encode()
        if said is None or not self._limit.take(self._clock(), name, name, cost_of(len(said))):
            return
        # Dropped rather than waited for: this thread also hears everybody else.
        put(self._session, f"{self._prefix}/said/{sender}/{to}", said, priority="INTERACTIVE_HIGH")

    def _pass(self, sample: "zenoh.Sample") -> None:
        sender, to, said = self._checked(sample, MOST_BYTES + TAG_BYTES)
        name = sender.encode()
        if said is None or not self._pass_limit.take(self._clock(), name, name):
            return
        put(self._session, f"{self._prefix}/relay/{sender}/{to}", said, priority="DATA_HIGH")

    def _checked(self, sample: "zenoh.Sample", most: int) -> tuple[str, str, bytes | None]:
        """Sender, recipient, and what is for the recipient; None if the sender did not send it, or too much."""
        *_, sender, to = str(sample.key_expr).split("/")
        size = len(sample.payload)
        if not TAG_BYTES <= size <= most + TAG_BYTES or len(sender) != 64 or sender in self.shunned:
            return sender, to, None
        raw = sample.payload.to_bytes()
        said = raw[:-TAG_BYTES]
        with self._lock:
            try:
                key = bytes.fromhex(sender)
            except ValueError:
                return sender, to, None
            if not self._tags.known(key) and not self._strangers.take(self._clock(), key, key):
                return sender, to, None
            return sender, to, said if self._tags.true(key, said, raw[-TAG_BYTES:]) else None
