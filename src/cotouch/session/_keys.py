"""Keys of one link: the agreement over the control plane, said again until both ends have them."""

from typing import final

from cotouch.live import Agreement, ControlPlane, Entropy, SealedLink

_AGAIN = 0.3  # a hello without an answer is said again [s]
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

    def hear(self, body: bytes) -> None:
        """Takes a message of the other end."""
        progress = self._agreement.receive(body)
        if progress.keys is not None:
            self._seal.install(progress.keys)
            self.agreed, self._hello = True, None
        if progress.message is not None:
            self._control.send(TOPIC, progress.message, to=self._other)

    def tend(self, now: float, *, asked: bool) -> None:
        """Begins, or begins again, if it is this end's turn to.

        Args:
            now: [s].
            asked: whether the other end asks for new keys.
        """
        wanted = not self.agreed or self._seal.wants_keys or asked
        if not self._agreement.initiator or not wanted or now - self._said < _AGAIN:
            return
        if self._hello is None or self.agreed:
            self._hello = self._agreement.start()
        self._said = now
        self._control.send(TOPIC, self._hello, to=self._other)
