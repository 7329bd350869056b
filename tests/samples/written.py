"""Messages of an agreement on keys, as whoever knows session and invitation can write them; after `_agreement.py`."""

import hashlib
import hmac
import struct

from cotouch.samples import Identity

OPENING = struct.Struct(">4sBII32s32s")  # magic, kind, epoch, connection, ephemeral key, context or hash of the hello
HELLO, REPLY = 1, 2
PROOF, TAG = 32, 16


def context(session: bytes, first: bytes, second: bytes) -> bytes:
    """Session and both ends.

    Args:
        session: its name.
        first: public key of the end that begins.
        second: of the other.
    """
    return hashlib.sha256(hashlib.sha256(session).digest() + first + second).digest()


def tagged(said: bytes, about: bytes, secret: bytes = b"") -> bytes:
    """With the MAC of all who were invited.

    Args:
        said: the message.
        about: context of the two.
        secret: of the invitation.
    """
    known = hashlib.sha256(b"cotouch invitation" + secret).digest()
    key = hmac.digest(known, b"cotouch agreement tag" + about, "sha256")
    return said + hmac.digest(key, said, "sha256")[:TAG]


def hello(signer: Identity, ephemeral: bytes, about: bytes) -> bytes:
    """The first message, without its tag.

    Args:
        signer: whoever says it.
        ephemeral: key.
        about: context of the two.
    """
    body = OPENING.pack(b"ctk1", HELLO, 1, 4, ephemeral, about)
    return body + signer.sign(b"cotouch agreement hello\0" + body)


def reply(signer: Identity, ephemeral: bytes, answered: bytes) -> bytes:
    """The second message, without its tag, and with a proof that proves nothing.

    Args:
        signer: whoever says it.
        ephemeral: key.
        answered: hello without its tag.
    """
    answer = OPENING.pack(b"ctk1", REPLY, 1, 3, ephemeral, hashlib.sha256(answered).digest())
    said = hashlib.sha256(answered + answer).digest()
    return answer + signer.sign(b"cotouch agreement reply\0" + said) + bytes(PROOF)
