"""What a session needs of a control plane: signed messages between members, who is there, files by their hash."""

from typing import NamedTuple, Protocol

from cotouch.samples import Identity


class SignedMessage(NamedTuple):
    """A member's message, its signature verified.

    Attributes:
        sender: public key of the member who said it.
        topic: what it is about, such as "roster" or "link.keys".
        body: what it says; nothing about it has been checked but who said it.
        direct: whether it was for this member alone.
    """

    sender: bytes
    topic: str
    body: bytes
    direct: bool


class Relayed(NamedTuple):
    """A datagram that arrived over the control plane, because there is no direct path.

    Attributes:
        payload: its bytes, sealed for the link as any other datagram.
        sender: public key of the member who sent it; what others send in its name was dropped.
        time: of arrival [s].
    """

    payload: bytes
    sender: bytes
    time: float


class ControlPlane(Protocol):
    """Carries messages between members and says who is present; nothing here waits.

    Messages between two members arrive once and in order while both are connected. They are lost when a member is cut
    off; so what must be known is said again. Members are known by their public keys.
    """

    @property
    def identity(self) -> Identity:
        """Of this member."""
        ...

    def send(self, topic: str, body: bytes, *, to: bytes | None = None) -> None:
        """Says something to one member, or to all others.

        Args:
            topic: lower-case words joined by dots.
            body: at most 256 kB.
            to: public key of the member; None: everybody.
        """
        ...

    def poll(self) -> list[SignedMessage]:
        """What was said since the last call."""
        ...

    def present(self) -> frozenset[bytes]:
        """Public keys of all others who show that they are there; see `Presence`. Nobody can say it of another."""
        ...

    def shun(self, members: frozenset[bytes]) -> None:
        """From now on nothing of these members is taken or handed on, and of nobody else.

        Args:
            members: public keys.
        """
        ...

    def offer(self, content: bytes) -> bytes:
        """Keeps a file for others to fetch; returns its SHA-256."""
        ...

    def fetch(self, digest: bytes) -> bytes | None:
        """A file that somebody offers, once it is here and its hash is right; None: it has been asked for."""
        ...

    def relay(self, to: bytes, payload: bytes) -> bool:
        """Hands on a datagram for a member who cannot be reached directly: may be lost, never waits in a queue.

        Args:
            to: public key of the receiver.
            payload: the datagram.
        """
        ...

    def relayed(self) -> list[Relayed]:
        """Datagrams that came this way since the last call, oldest first."""
        ...

    def close(self) -> None:
        """Leaves: the others see it at once."""
        ...
