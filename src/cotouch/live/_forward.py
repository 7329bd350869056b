"""The host hands on what members say to each other who are not connected: too far apart, or behind NATs.

What is handed on is signed by who said it, or sealed for whom it is, so the host can only drop it. Nobody asks for
this: a member that does not see another says `via` the host what is for that member alone, and lets datagrams for it
`pass` through the host.
"""

from typing import TYPE_CHECKING, final

from cotouch.live._limit import SourceLimit
from cotouch.live._sign import MOST_MESSAGE, cost_of
from cotouch.live._transport import MOST_BYTES

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

_RATE, _BURST = 100.0, 200.0
# Datagrams of one sender, to all whom it does not see: ten neighbours at a relay's rate.
_PASS_RATE, _PASS_BURST = 1000.0, 500.0


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
        self._pass_limit = SourceLimit(
            rate=_PASS_RATE, burst=_PASS_BURST, stranger_rate=_PASS_RATE, stranger_burst=_PASS_BURST
        )
        for kind, forward in (("via", self._forward), ("pass", self._pass)):
            session.declare_subscriber(
                f"{prefix}/{kind}/*/*", Callback(forward, indirect=False), allowed_origin=zenoh.Locality.REMOTE
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

    def _pass(self, sample: "zenoh.Sample") -> None:
        import zenoh

        *_, sender, to = str(sample.key_expr).split("/")
        name = sender.encode()
        if len(sample.payload) > MOST_BYTES or not self._pass_limit.take(self._clock(), name, name):
            return
        self._session.put(
            f"{self._prefix}/relay/{sender}/{to}",
            sample.payload,
            congestion_control=zenoh.CongestionControl.DROP,
            priority=zenoh.Priority.DATA_HIGH,
            express=True,
        )
