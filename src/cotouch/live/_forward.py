"""The host hands on what members say to each other who are not connected: too far apart, or behind NATs.

What is handed on is signed by who said it, so the host can only drop it. Nobody asks for this: a member that does not
see another says `via` the host what is for that member alone.
"""

from typing import TYPE_CHECKING, final

from cotouch.live._limit import SourceLimit
from cotouch.live._sign import MOST_MESSAGE, cost_of

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

_RATE, _BURST = 100.0, 200.0


@final
class Forwarder:
    """Listens at the host, and says again; in Zenoh's own threads."""

    def __init__(self, session: "zenoh.Session", prefix: str, clock: "Callable[[], float]") -> None:
        """Begins to.

        Args:
            session: the host's.
            prefix: of the session's names.
            clock: [s].
        """
        import zenoh
        from zenoh.handlers import Callback

        self._session, self._prefix, self._clock = session, prefix, clock
        self._limit = SourceLimit(rate=_RATE, burst=_BURST, stranger_rate=_RATE, stranger_burst=_BURST)
        session.declare_subscriber(
            f"{prefix}/via/*/*", Callback(self._forward, indirect=False), allowed_origin=zenoh.Locality.REMOTE
        )

    def _forward(self, sample: "zenoh.Sample") -> None:
        import zenoh

        *_, sender, to = str(sample.key_expr).split("/")
        size = len(sample.payload)
        name = sender.encode()
        if size > MOST_MESSAGE or not self._limit.take(self._clock(), name, name, cost_of(size)):
            return
        # Dropped rather than waited for: this thread also hears everybody else.
        self._session.put(
            f"{self._prefix}/said/{sender}/{to}",
            sample.payload,
            congestion_control=zenoh.CongestionControl.DROP,
            priority=zenoh.Priority.INTERACTIVE_HIGH,
            express=True,
        )
