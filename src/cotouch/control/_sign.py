"""Messages of the control plane: signed by who says them, and read only as far as they are of use.

::

    magic 4 | sender 32 | recipient 32, zeros: all | counter 8 | length of topic 1 | topic | body | signature 64

The signature [Ed25519, RFC 8032] covers all of it and the session, so a message is of use in one session, for those it
was meant for, and once: a sender's counter rises from message to message, and nothing at or below the last is taken.
"""

import re
import struct
from collections import Counter
from enum import Enum
from typing import final

from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PublicKey

from cotouch.control._control import SignedMessage
from cotouch.errors import SessionError
from cotouch.samples import Bucket, Identity, SourceLimit

MOST_BODY = 1 << 18
_MOST_TOPIC = 64
_TOPIC = re.compile(r"[a-z0-9]+(?:\.[a-z0-9]+)*")
_MAGIC = b"ctm1"
_HEAD = struct.Struct(">4s32s32sQB")
_SIGNATURE = 64
_ALL = bytes(32)
_CONTEXT = b"cotouch control 1\0"
_LEAST = _HEAD.size + 1 + _SIGNATURE
MOST_MESSAGE = _HEAD.size + _MOST_TOPIC + MOST_BODY + _SIGNATURE
# Far more than a session has members; an invited one who makes up senders gets no further.
_MOST_SENDERS = 1024
# Of those who left, the last counters are kept of so many.
_MOST_GONE = 1024
# Unix time in nanoseconds comes there in the year 2262.
_LAST_COUNTER = 1 << 63
# So many bytes count as one more message: hashing them takes as long as a signature.
_BYTES_PER_UNIT = 16_384


@final
class MessageRefusal(Enum):
    """Why a message was refused, in the order in which the reasons are checked: counted, never raised."""

    SIZE = "too short or too long to be one of ours"
    VERSION = "another version of the format"
    RATE = "more than this sender, or all together, may say"
    NOT_OURS = "for another member"
    OWN = "said to be from ourselves"
    TOPIC = "not a topic"
    COUNTER = "a counter near its end"
    REPLAYED = "seen before, or older than what was seen"
    STRANGERS = "one more sender than a session may have"
    FORGED = "the signature does not fit"


def cost_of(size: int) -> float:
    """What a message of so many bytes takes of a limit."""
    return 1.0 + size / _BYTES_PER_UNIT


@final
class MessageWriter:
    """Signs one member's messages."""

    def __init__(self, identity: Identity, session: bytes, *, started: int) -> None:
        """Begins to speak.

        Args:
            identity: of this member.
            session: 32 bytes that name the session.
            started: unix time [ns]; a member that comes back under the same identity is then above all it said before.
        """
        if not 0 < started < 1 << 63:
            raise SessionError(f"a start at {started} ns is not a Unix time; it must be in nanoseconds since 1970")
        self._identity = identity
        self._session = session
        self._counter = started

    def write(self, topic: str, body: bytes, to: bytes | None = None) -> bytes:
        """A message as it travels; see `check` for what it may be.

        Args:
            topic: what it is about.
            body: the message.
            to: public key of the receiver; None: all others.
        """
        self._counter += 1
        head = _HEAD.pack(_MAGIC, self._identity.public, to or _ALL, self._counter, len(topic))
        said = head + topic.encode() + body
        return said + self._identity.sign(_CONTEXT + self._session + said)

    def check(self, topic: str, body: bytes, to: bytes | None) -> None:
        """Refuses what cannot be said.

        Args:
            topic: what it is about.
            body: the message.
            to: public key of the receiver; None: all others.

        Raises:
            SessionError: the topic, the body or the recipient cannot be.
        """
        if len(topic) > _MOST_TOPIC or not _TOPIC.fullmatch(topic):
            raise SessionError(
                f"topic {topic[:80]!r} is not valid; it must be lower-case words joined by dots, as in link.keys"
            )
        if len(body) > MOST_BODY:
            raise SessionError(
                f"a message on {topic!r} has {len(body)} bytes; at most {MOST_BODY} are allowed, so offer it as a file"
            )
        if to is not None and (len(to) != 32 or to in {_ALL, self._identity.public}):
            raise SessionError("a message is for another member's public key of 32 bytes, or for None: everybody")


@final
class MessageReader:
    """Reads messages. Never raises for their contents; a refused one changes nothing but a counter.

    Not for several threads at once.

    Attributes:
        refused: how many messages were refused, by reason.
    """

    def __init__(
        self, own: bytes, session: bytes, *, rate: float = 500.0, burst: float = 1000.0, total: float = 4.0
    ) -> None:
        """Begins to listen.

        Args:
            own: public key of this member.
            session: 32 bytes that name the session.
            rate: messages that one sender may send in the long run, longer ones counting more [1/s].
            burst: at once.
            total: how many times as much all may send together.
        """
        self.refused = Counter[MessageRefusal]()
        self._own = own
        self._session = session
        # Whoever has not said anything true yet; the first true message makes a known sender of it.
        self._limit = SourceLimit(rate=rate, burst=burst, stranger_rate=rate / 20, stranger_burst=burst / 20)
        self._total = Bucket(total * rate, total * burst)
        self._last: dict[bytes, int] = {}
        self._gone: dict[bytes, int] = {}
        self._keys: dict[bytes, Ed25519PublicKey] = {}

    def read(self, message: bytes, now: float) -> SignedMessage | MessageRefusal:
        """What was said, if it is whole, new, for this member, and truly the sender's.

        Args:
            message: as it arrived.
            now: time that does not run backwards [s].
        """
        out = self._read(message, now)
        if isinstance(out, MessageRefusal):
            self.refused[out] += 1
        return out

    def forget(self, sender: bytes) -> None:
        """A sender left: only its last counter is kept, so that nothing it said before is taken again.

        That of the longest gone goes when 1,024 more have left. It may be heard anew, and is if it was only cut off.

        Args:
            sender: its public key.
        """
        if self._keys.pop(sender, None) is None:
            return
        self._limit.unknow(sender)
        self._gone.pop(sender, None)
        if len(self._gone) >= _MOST_GONE:
            del self._gone[next(iter(self._gone))]
        self._gone[sender] = self._last.pop(sender)

    def _read(self, message: bytes, now: float) -> SignedMessage | MessageRefusal:
        if not _LEAST <= len(message) <= MOST_MESSAGE:
            return MessageRefusal.SIZE
        if message[:4] != _MAGIC:
            return MessageRefusal.VERSION
        cost, sender = cost_of(len(message)), message[4:36]
        if not self._limit.take(now, sender, sender, cost) or not self._total.take(now, cost):
            return MessageRefusal.RATE
        _, _, recipient, counter, length = _HEAD.unpack_from(message)
        if recipient not in {_ALL, self._own}:
            return MessageRefusal.NOT_OURS
        if sender == self._own:
            return MessageRefusal.OWN
        end = _HEAD.size + length
        topic = message[_HEAD.size : end].decode("ascii", "replace")
        if not 1 <= length <= _MOST_TOPIC or end + _SIGNATURE > len(message) or not _TOPIC.fullmatch(topic):
            return MessageRefusal.TOPIC
        if len(message) - end - _SIGNATURE > MOST_BODY:
            return MessageRefusal.SIZE
        if counter >= _LAST_COUNTER:
            return MessageRefusal.COUNTER
        if counter <= self._last.get(sender, self._gone.get(sender, 0)):
            return MessageRefusal.REPLAYED
        key = self._keys.get(sender)
        if key is None and len(self._keys) >= _MOST_SENDERS:
            return MessageRefusal.STRANGERS
        key = key or Ed25519PublicKey.from_public_bytes(sender)
        try:
            key.verify(message[-_SIGNATURE:], _CONTEXT + self._session + message[:-_SIGNATURE])
        except InvalidSignature:
            return MessageRefusal.FORGED
        self._last[sender], self._keys[sender] = counter, key
        self._gone.pop(sender, None)
        self._limit.know(sender)
        return SignedMessage(sender, topic, message[end:-_SIGNATURE], recipient != _ALL)
