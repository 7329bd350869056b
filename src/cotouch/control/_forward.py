"""The host hands on what members say to each other who are not connected: too far apart, or behind NATs.

What is handed on is signed by who said it, or sealed for whom it is, so the host can only drop it. Nobody asks for
this: a member that does not see another says `via` the host what is for that member alone, and lets datagrams for it
`pass` through the host. To both it adds its MAC for the host, so that nobody uses up another's limit.
"""

import threading
from typing import TYPE_CHECKING, final

from cotouch.control._pairs import TAG_BYTES, PairTags
from cotouch.control._sign import MOST_MESSAGE, cost_of
from cotouch.control._zenoh import Priority, put
from cotouch.control._zenoh_keys import sender_of
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
        shunned: public keys of members for whom nothing is handed on.
    """

    def __init__(self, session: "zenoh.Session", prefix: str, tags: PairTags, clock: "Callable[[], float]") -> None:
        """Begins to.

        Args:
            session: the host's.
            prefix: of the session's names.
            tags: the host's own.
            clock: [s].
        """
        import zenoh
        from zenoh.handlers import Callback

        self.shunned = frozenset[bytes]()
        self._session, self._prefix, self._tags, self._clock = session, prefix, tags, clock
        self._lock = threading.Lock()  # among Zenoh's threads
        self._limit = SourceLimit(rate=_RATE, burst=_BURST, stranger_rate=_RATE, stranger_burst=_BURST)
        self._pass_limit = SourceLimit(
            rate=_PASS_RATE, burst=_PASS_BURST, stranger_rate=_PASS_RATE, stranger_burst=_PASS_BURST
        )
        for kind, forward in (("via", self._forward), ("pass", self._pass)):
            session.declare_subscriber(
                f"{prefix}/{kind}/*/*", Callback(forward, indirect=False), allowed_origin=zenoh.Locality.REMOTE
            )

    def _forward(self, sample: "zenoh.Sample") -> None:
        cost = cost_of(len(sample.payload) - TAG_BYTES)
        self._again(sample, MOST_MESSAGE, self._limit, cost, "said", "INTERACTIVE_HIGH")

    def _pass(self, sample: "zenoh.Sample") -> None:
        self._again(sample, MOST_BYTES + TAG_BYTES, self._pass_limit, 1.0, "relay", "DATA_HIGH")

    def _again(
        self, sample: "zenoh.Sample", most: int, limit: SourceLimit, cost: float, kind: str, priority: Priority
    ) -> None:
        """Says to the recipient what the sender sent, unless it is too long or one too many."""
        key = str(sample.key_expr)
        sender, now = sender_of(key), self._clock()
        if sender is None or sender in self.shunned or len(sample.payload) > most + TAG_BYTES:
            return
        said = self._tags.read(sender, sample.payload.to_bytes(), now)
        with self._lock:
            if said is None or not limit.take(now, sender, sender, cost):
                return
        # Dropped rather than waited for: this thread also hears everybody else.
        put(self._session, f"{self._prefix}/{kind}/{sender.hex()}/{key.rpartition('/')[2]}", said, priority=priority)
