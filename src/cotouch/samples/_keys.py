"""Who a member is, and the keys of one link for one epoch."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple, final

from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey, Ed25519PublicKey
from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat, PublicFormat

from cotouch.errors import SessionError

Entropy = Callable[[int], bytes]
KEY_BYTES = 16  # AES-128
IV_BYTES = 12


class DirectionKeys(NamedTuple):
    """The keys that seal one direction of a link.

    Attributes:
        connection: number that the receiver chose for the link; it finds the link whatever the address.
        key: of the cipher.
        iv: what the sequence number is added to, to make the nonce.
    """

    connection: int
    key: bytes
    iv: bytes

    def __repr__(self) -> str:
        return f"DirectionKeys(connection={self.connection})"


@final
@dataclass(frozen=True, kw_only=True)
class LinkKeys:
    """Both directions of a link for one epoch, as one end sees them.

    Attributes:
        epoch: number of the agreement, from 1, rising.
        sending: for what this end sends.
        receiving: for what it receives.
        wait: whether the other end may not have its keys yet, so that the old ones are sent with until it is heard.
    """

    epoch: int
    sending: DirectionKeys
    receiving: DirectionKeys
    wait: bool = False


@final
@dataclass(frozen=True)
class Identity:
    """A member's own key pair [Ed25519], made for one session.

    Attributes:
        secret: 32 bytes that nobody else ever sees.
        public: 32 bytes by which all others know the member.
    """

    secret: bytes = field(repr=False)
    public: bytes = field(init=False)

    def __post_init__(self) -> None:
        if len(self.secret) != 32:
            raise SessionError(f"the secret of an identity has {len(self.secret)} bytes; it must have 32")
        public = self._key().public_key().public_bytes(Encoding.Raw, PublicFormat.Raw)
        object.__setattr__(self, "public", public)

    @classmethod
    def make(cls, entropy: Entropy) -> "Identity":
        """A new one.

        Args:
            entropy: gives so many bytes that nobody can guess, such as `os.urandom`.
        """
        made = Ed25519PrivateKey.from_private_bytes(entropy(32))
        return cls(made.private_bytes(Encoding.Raw, PrivateFormat.Raw, NoEncryption()))

    def sign(self, message: bytes) -> bytes:
        """64 bytes that only this member can make of this message."""
        return self._key().sign(message)

    def _key(self) -> Ed25519PrivateKey:
        return Ed25519PrivateKey.from_private_bytes(self.secret)


def signed_by(public: bytes, signature: bytes, message: bytes) -> bool:
    """Whether the member with this public key made this signature of this message.

    Args:
        public: 32 bytes.
        signature: as `Identity.sign` gives it.
        message: what was signed.
    """
    try:
        Ed25519PublicKey.from_public_bytes(public).verify(signature, message)
    except (InvalidSignature, ValueError):
        return False
    return True
