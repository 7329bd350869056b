"""How two members agree on the keys of their link: three messages, which the control plane carries.

::

    initiator                                       responder
    hello    ephemeral key, signed          ──▶
                                            ◀──     reply    ephemeral key, signed over both, proof of the keys
    confirm  signed over both, proof        ──▶

Ephemeral X25519 keys, signed with both members' Ed25519 identities over everything that was said (session, both
identities, epoch, connection numbers, both ephemerals), then HKDF-SHA256 [RFC 7748, 8032, 5869]. Nobody but the two
can make the keys, not even another member of the session or whoever relays the messages; and whoever learns an identity
later does not learn keys of before. Messages may be lost, doubled, late or made up: what does not fit is refused and
changes nothing, and either end may begin anew.
"""

import hashlib
import hmac
import struct
from typing import NamedTuple, final

from cryptography.hazmat.primitives.asymmetric.x25519 import X25519PrivateKey, X25519PublicKey
from cryptography.hazmat.primitives.hashes import SHA256
from cryptography.hazmat.primitives.kdf.hkdf import HKDF

from cotouch.errors import SessionError
from cotouch.samples._keys import IV_BYTES, KEY_BYTES, DirectionKeys, Entropy, Identity, LinkKeys, signed_by
from cotouch.samples._unique import Unique

_MAGIC = b"ctk1"
_HELLO, _REPLY, _CONFIRM = 1, 2, 3
_OPENING = struct.Struct(">4sBII32s32s")  # magic, kind, epoch, connection, ephemeral, context or hash of the hello
_CLOSING = struct.Struct(">4sB32s")  # magic, kind, hash of all before
_SIGNATURE, _PROOF = 64, 32
# Of every message the last bytes are a MAC under a key of all who were invited. It proves little, but it costs 2 µs,
# and without it nothing is spent on signatures and curves.
_TAG = 16
# An attacker who can inject old hellos must not push out the one that is going on.
_MOST_PENDING = 4
_LAST_EPOCH = 0x7FFF_FFFF
# New keys are agreed one after the other: an epoch that leaps would soon leave none.
_MOST_LEAP = 1 << 16
_SIZES = {
    _HELLO: _OPENING.size + _SIGNATURE + _TAG,
    _REPLY: _OPENING.size + _SIGNATURE + _PROOF + _TAG,
    _CONFIRM: _CLOSING.size + _SIGNATURE + _PROOF + _TAG,
}


class AgreementStep(NamedTuple):
    """What a message led to.

    Attributes:
        message: to be carried to the other end, if any.
        keys: new keys of the link, if they are agreed.
        refused: why the message was of no use, if it was not.
    """

    message: bytes | None = None
    keys: LinkKeys | None = None
    refused: str | None = None


class _Secrets(NamedTuple):
    keys: LinkKeys
    initiator_proof: bytes
    responder_proof: bytes


@final
class Agreement(Unique):
    """One end of one link. Opens nothing: messages in, messages and keys out. In a forked process it agrees on nothing.

    Attributes:
        initiator: whether this end begins: the one with the smaller public key, so that never both do.
        epoch: of the newest keys, 0 before the first.
    """

    def __init__(
        self,
        *,
        identity: Identity,
        other: bytes,
        session: bytes,
        connection: int,
        entropy: Entropy,
        secret: bytes = b"",
    ) -> None:
        """Prepares one end.

        Args:
            identity: of this member.
            other: public key of the member at the other end, from the session's list.
            session: what names the session, the same at both ends.
            connection: number by which this end finds the link, below 2^32, its own for each link.
            entropy: gives so many bytes that nobody can guess, such as `os.urandom`.
            secret: what only invited members know.
        """
        super().__init__()
        if len(other) != 32 or other == identity.public:
            raise SessionError("the other end's public key must have 32 bytes and must not be this member's own")
        if not 0 <= connection < 1 << 32:
            raise SessionError(f"connection {connection} does not fit into 32 bits; choose one below 4294967296")
        self.initiator = identity.public < other
        self.epoch = 0
        self._identity = identity
        self._other = other
        self._connection = connection
        self._entropy = entropy
        first, second = (identity.public, other) if self.initiator else (other, identity.public)
        # Everything that both know beforehand; the lengths are fixed, so nothing can be read in two ways.
        self._context = hashlib.sha256(hashlib.sha256(session).digest() + first + second).digest()
        self._secret = hashlib.sha256(b"cotouch invitation" + secret).digest()
        self._tag_key = hmac.digest(self._secret, b"cotouch agreement tag" + self._context, "sha256")
        self._hello: tuple[bytes, X25519PrivateKey] | None = None
        self._answered: dict[bytes, bytes] = {}
        self._pending: dict[bytes, _Secrets] = {}

    def start(self) -> bytes:
        """A hello, at first or for new keys; may be sent again until there is a reply.

        Raises:
            SessionError: this end is not the one that begins.
        """
        if not self.here:
            raise SessionError("keys cannot be agreed on in a forked process; make a new link there")
        if not self.initiator:
            raise SessionError(
                "this end of the link does not start the agreement; the one with the smaller public key does"
            )
        ephemeral = X25519PrivateKey.from_private_bytes(self._entropy(32))
        epoch = min(self.epoch + 1, _LAST_EPOCH)
        public = ephemeral.public_key().public_bytes_raw()
        body = _OPENING.pack(_MAGIC, _HELLO, epoch, self._connection, public, self._context)
        hello = body + self._sign(b"hello", body)
        self._hello = (hello, ephemeral)
        return self._tagged(hello)

    def receive(self, message: bytes) -> AgreementStep:
        """Takes a message of the other end, or what is said to be one; never raises for what is in it."""
        kind = message[4] if len(message) > 4 and message[:4] == _MAGIC else 0
        size = _SIZES.get(kind)
        if size is None or len(message) != size or (kind == _REPLY) is not self.initiator or not self.here:
            return AgreementStep(refused="not a message for this end")
        said = message[:-_TAG]
        if not hmac.compare_digest(message, self._tagged(said)):
            return AgreementStep(refused="another session, secret or other members")
        if kind == _HELLO:
            return self._answer(said)
        return self._conclude(said) if kind == _REPLY else self._accept(said)

    def _answer(self, hello: bytes) -> AgreementStep:
        if hello in self._answered:
            return AgreementStep(message=self._answered[hello])
        body, signature = hello[: _OPENING.size], hello[_OPENING.size :]
        _, _, epoch, connection, theirs, context = _OPENING.unpack(body)
        if context != self._context:
            return AgreementStep(refused="another session or other members")
        if not self._signed(b"hello", body, signature):
            return AgreementStep(refused="signature")
        epoch = max(epoch, self.epoch + 1)
        if epoch > min(_LAST_EPOCH, self.epoch + _MOST_LEAP):
            return AgreementStep(refused="epoch")
        ephemeral = X25519PrivateKey.from_private_bytes(self._entropy(32))
        mine = ephemeral.public_key().public_bytes_raw()
        answer = _OPENING.pack(_MAGIC, _REPLY, epoch, self._connection, mine, hashlib.sha256(hello).digest())
        said = hashlib.sha256(hello + answer).digest()
        secrets = self._derive(ephemeral, theirs, said, epoch, connection)
        if secrets is None:
            return AgreementStep(refused="ephemeral key")
        reply = self._tagged(answer + self._sign(b"reply", said) + secrets.responder_proof)
        while len(self._pending) >= _MOST_PENDING:
            del self._pending[next(iter(self._pending))]
            del self._answered[next(iter(self._answered))]
        self._answered[hello], self._pending[said] = reply, secrets
        return AgreementStep(message=reply)

    def _conclude(self, reply: bytes) -> AgreementStep:
        answer, signature = reply[: _OPENING.size], reply[_OPENING.size : -_PROOF]
        _, _, epoch, connection, theirs, about = _OPENING.unpack(answer)
        if self._hello is None or about != hashlib.sha256(self._hello[0]).digest():
            return AgreementStep(refused="no reply to the last hello")
        hello, ephemeral = self._hello
        said = hashlib.sha256(hello + answer).digest()
        if not self._signed(b"reply", said, signature):
            return AgreementStep(refused="signature")
        secrets = self._derive(ephemeral, theirs, said, epoch, connection)
        if secrets is None or not self.epoch < epoch <= min(_LAST_EPOCH, self.epoch + _MOST_LEAP):
            return AgreementStep(refused="epoch or ephemeral key")
        if not hmac.compare_digest(reply[-_PROOF:], secrets.responder_proof):
            return AgreementStep(refused="another secret")
        self.epoch, self._hello = epoch, None
        body = _CLOSING.pack(_MAGIC, _CONFIRM, said)
        confirm = self._tagged(body + self._sign(b"confirm", said) + secrets.initiator_proof)
        return AgreementStep(message=confirm, keys=secrets.keys)

    def _accept(self, confirm: bytes) -> AgreementStep:
        _, _, said = _CLOSING.unpack(confirm[: _CLOSING.size])
        secrets = self._pending.get(said)
        if secrets is None:
            return AgreementStep(refused="no confirmation of what was replied")
        if not self._signed(b"confirm", said, confirm[_CLOSING.size : -_PROOF]):
            return AgreementStep(refused="signature")
        if not hmac.compare_digest(confirm[-_PROOF:], secrets.initiator_proof):
            return AgreementStep(refused="another secret")
        if secrets.keys.epoch <= self.epoch:
            return AgreementStep(refused="epoch")
        self.epoch = secrets.keys.epoch
        self._pending.clear()
        self._answered.clear()
        return AgreementStep(keys=secrets.keys)

    def _derive(
        self, ephemeral: X25519PrivateKey, theirs: bytes, said: bytes, epoch: int, connection: int
    ) -> _Secrets | None:
        try:
            shared = ephemeral.exchange(X25519PublicKey.from_public_bytes(theirs))
        except ValueError:  # a point of small order: the result would be known to everybody
            return None
        size = 2 * (KEY_BYTES + IV_BYTES) + 2 * _PROOF
        made = HKDF(SHA256(), size, salt=said, info=b"cotouch sample keys 1" + self._context).derive(
            shared + self._secret
        )
        there, back = made[: KEY_BYTES + IV_BYTES], made[KEY_BYTES + IV_BYTES : 2 * (KEY_BYTES + IV_BYTES)]
        mine, other = (there, back) if self.initiator else (back, there)
        keys = LinkKeys(
            epoch=epoch,
            sending=DirectionKeys(connection, mine[:KEY_BYTES], mine[KEY_BYTES:]),
            receiving=DirectionKeys(self._connection, other[:KEY_BYTES], other[KEY_BYTES:]),
            wait=self.initiator,
        )
        return _Secrets(keys, made[-2 * _PROOF : -_PROOF], made[-_PROOF:])

    def _tagged(self, said: bytes) -> bytes:
        return said + hmac.digest(self._tag_key, said, "sha256")[:_TAG]

    def _sign(self, what: bytes, message: bytes) -> bytes:
        return self._identity.sign(b"cotouch agreement " + what + b"\0" + message)

    def _signed(self, what: bytes, message: bytes, signature: bytes) -> bool:
        return signed_by(self._other, signature, b"cotouch agreement " + what + b"\0" + message)
