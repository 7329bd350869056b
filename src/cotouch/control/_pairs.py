"""A MAC for each two members, so that nobody speaks in another's name where a signature would cost too much.

Their key follows from both identities, without a word between them: an Ed25519 key pair is also one of X25519 (the
birational map of RFC 7748, section 4.1; that both uses keep each other's security: Thormarker 2021). HKDF over the
shared secret, the session, and who sends to whom gives a key of each direction.
"""

import hashlib
import hmac
import threading
from typing import final

from cryptography.hazmat.primitives.asymmetric.x25519 import X25519PrivateKey, X25519PublicKey
from cryptography.hazmat.primitives.hashes import SHA256
from cryptography.hazmat.primitives.kdf.hkdf import HKDF

from cotouch.samples import Identity, SourceLimit

TAG_BYTES = 16
_PRIME = 2**255 - 19
# More than a session has members; the longest unused goes. Making one again costs 0.2 ms.
_MOST_PAIRS = 1024


@final
class PairTags:
    """One member's MACs with all others. Any thread may call it."""

    def __init__(self, identity: Identity, session: bytes) -> None:
        """Begins.

        Args:
            identity: of this member.
            session: names the session.
        """
        self._own = identity.public
        self._session = session
        scalar = hashlib.sha512(identity.secret).digest()[:32]
        self._key = X25519PrivateKey.from_private_bytes(scalar)
        self._pairs: dict[bytes, tuple[bytes, bytes] | None] = {}
        self._lock = threading.Lock()
        # Who was not heard before costs a key agreement, a hundred times a check, so only so many a second.
        self._strangers = SourceLimit(rate=1.0, burst=1.0, stranger_rate=20.0, stranger_burst=20.0)

    def known(self, other: bytes) -> bool:
        """Whether the keys with this member are there, so that a check costs 2 µs and not a hundred times that."""
        return other in self._pairs

    def tag(self, to: bytes, said: bytes) -> bytes | None:
        """16 bytes that only this member and that one can make; None: that is no member's key.

        Args:
            to: public key of the receiver.
            said: what the tag vouches for.
        """
        with self._lock:
            keys = self._with(to)
        return None if keys is None else hmac.digest(keys[0], said, "sha256")[:TAG_BYTES]

    def read(self, sender: bytes, raw: bytes, now: float) -> bytes | None:
        """What a member said to this one, without the tag behind it; None: somebody else said it, or one too many.

        Args:
            sender: public key of who is said to have said it.
            raw: what came.
            now: [s].
        """
        with self._lock:
            if len(raw) < TAG_BYTES or (not self.known(sender) and not self._strangers.take(now, sender, sender)):
                return None
            keys = self._with(sender)
        said, tag = raw[:-TAG_BYTES], raw[-TAG_BYTES:]
        true = keys is not None and hmac.compare_digest(hmac.digest(keys[1], said, "sha256")[:TAG_BYTES], tag)
        return said if true else None

    def _with(self, other: bytes) -> tuple[bytes, bytes] | None:
        if other in self._pairs:
            return self._pairs[other]
        if len(self._pairs) >= _MOST_PAIRS:
            del self._pairs[next(iter(self._pairs))]
        try:
            shared = self._key.exchange(X25519PublicKey.from_public_bytes(_montgomery(other)))
        except ValueError:  # of small order: known to everybody
            self._pairs[other] = None
            return None
        keys = self._direction(shared, self._own, other), self._direction(shared, other, self._own)
        self._pairs[other] = keys
        return keys

    def _direction(self, shared: bytes, sender: bytes, recipient: bytes) -> bytes:
        about = b"cotouch pair 1" + self._session + sender + recipient
        return HKDF(SHA256(), 32, salt=None, info=about).derive(shared)


def _montgomery(public: bytes) -> bytes:
    """The X25519 public key of an Ed25519 one: u = (1 + y) / (1 - y)."""
    y = int.from_bytes(public, "little") & (1 << 255) - 1
    return ((1 + y) * pow(1 - y, _PRIME - 2, _PRIME) % _PRIME).to_bytes(32, "little")
