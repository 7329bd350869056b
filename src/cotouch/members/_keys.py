"""Keys of one link: the agreement over the control plane, said again until both ends have them."""

from typing import final

from cotouch.control import ControlPlane
from cotouch.samples import Agreement, Bucket, Entropy, SealedLink

_AGAIN = 0.3  # a hello without an answer is said again [s]
# Messages of the other end that are looked at: an honest one says a hello again every 0.3 s, and each that fits costs a
# signature and a key exchange, 0.3 ms [1/s].
_RATE, _BURST = 8.0, 16.0
TOPIC = "link.keys"


@final
class KeyExchange:
    """Carries one link's agreement.

    Attributes:
        agreed: whether there are keys.
    """

    def __init__(
        self,
        control: ControlPlane,
        seal: SealedLink,
        *,
        other: bytes,
        session: bytes,
        connection: int,
        entropy: Entropy,
        secret: bytes,
    ) -> None:
        """Prepares one end.

        Args:
            control: carries the messages.
            seal: gets the keys.
            other: public key of the other end.
            session: names the session.
            connection: number by which this end finds the link.
            entropy: gives so many bytes that nobody can guess.
            secret: that only the invited know.
        """
        self.agreed = False
        self._control = control
        self._seal = seal
        self._other = other
        self._agreement = Agreement(
            identity=control.identity,
            other=other,
            session=session,
            connection=connection,
            entropy=entropy,
            secret=secret,
        )
        self._hello: bytes | None = None
        self._said = -float("inf")
        self._now = 0.0
        self._limit = Bucket(_RATE, _BURST)
        self._renew = False

    def renew(self) -> None:
        """Keys are agreed anew, though those that there are would do."""
        self._renew = self.agreed

    def receive(self, body: bytes) -> None:
        """Takes a message of the other end; of too many, none."""
        if not self._limit.take(self._now):
            return
        progress = self._agreement.receive(body)
        if progress.keys is not None:
            self._seal.install(progress.keys)
            self.agreed, self._hello, self._renew = True, None, False
        if progress.message is not None:
            self._control.send(TOPIC, progress.message, to=self._other)

    def service(self, now: float, *, asked: bool) -> None:
        """Begins, or begins again, if it is this end's turn to.

        Args:
            now: [s].
            asked: whether the other end asks for new keys.
        """
        self._now = now
        wanted = not self.agreed or self._seal.wants_keys(now) or asked or self._renew
        if not self._agreement.initiator or not wanted or now - self._said < _AGAIN:
            return
        if self._hello is None:  # kept until there is an answer to it, however long the way is
            self._hello = self._agreement.start()
        self._said = now
        self._control.send(TOPIC, self._hello, to=self._other)
