"""Small authenticated datagrams that look for ways: "what is my address?" and "are you there?".

They come and go by the socket of the samples, begin with `PROBE`, which no sealed sample does, and end with a tag, the
first 16 bytes of an HMAC-SHA256 over all before it [RFC 2104]; numbers are big-endian::

    ask, tell     PROBE u8 | kind u8 | cookie u16 | transaction, 16 bytes | host, 16 bytes | port u16 | cookie u16 | tag
    ping, pong    PROBE u8 | kind u8 | 0 u16 | label u32 | number u64 | tag

The first two are for members: their key comes from the session's secret. In an ask cookie, host and port are zero; in
a tell the cookie is for `_addresses.py`, and the others are where the ask came from, added (xor) to the transaction,
because some routers rewrite addresses that they find in a datagram [RFC 8489, section 14.2]. The other two are for a
pair: there is a key for each direction, so that nothing can be sent back to who sent it. An answer is never longer than
    the
question.
"""

import hashlib
import hmac
import ipaddress
import struct
from collections.abc import Callable
from enum import IntEnum
from typing import NamedTuple, final

from cryptography.hazmat.primitives.hashes import SHA256
from cryptography.hazmat.primitives.kdf.hkdf import HKDF

from cotouch.errors import SessionError
from cotouch.samples import Address, plain_address

PROBE = 0xC2
PAIR_NONCE_BYTES = 16
_TAG_BYTES = 16
_MEMBER = struct.Struct(">BBH16s16sHH")
_PAIR = struct.Struct(">BBHIQ")
MEMBER_BYTES = _MEMBER.size + _TAG_BYTES
PAIR_BYTES = _PAIR.size + _TAG_BYTES


@final
class Kind(IntEnum):
    """What a probe is."""

    ASK = 1
    TELL = 2
    PING = 3
    PONG = 4


class PairKeys(NamedTuple):
    """The keys by which one end's probes to the other are recognised.

    Attributes:
        sending: label and key of what this end sends.
        receiving: of what it receives.
    """

    sending: tuple[int, bytes]
    receiving: tuple[int, bytes]

    def __repr__(self) -> str:
        return f"PairKeys(sending={self.sending[0]}, receiving={self.receiving[0]})"


def member_key(secret: bytes, session: bytes) -> bytes:
    """The key of questions for one's own address, and of their answers.

    Args:
        secret: what only invited members know.
        session: what names the session.
    """
    return _derive(secret, session, b"cotouch probes of members 1", 32)


def pair_keys(
    *, secret: bytes, session: bytes, own: bytes, other: bytes, own_nonce: bytes, other_nonce: bytes
) -> PairKeys:
    """Keys of pings and pongs between two members.

    The nonces come by the control plane, one from each end to the other alone, as ICE's passwords do [RFC 8445, section
    5.3]: so a third member, who knows all the rest, cannot answer in a neighbour's name.

    Args:
        secret: what only invited members know.
        session: what names the session.
        own: public key of this member.
        other: of the other.
        own_nonce: 16 bytes that this end made for this pair.
        other_nonce: that the other made.

    Raises:
        SessionError: a nonce or a key has another length, or both ends are one.
    """
    if len(own) != 32 or len(other) != 32 or own == other:
        raise SessionError("the public keys of a pair must have 32 bytes each and must differ")
    if len(own_nonce) != PAIR_NONCE_BYTES or len(other_nonce) != PAIR_NONCE_BYTES:
        raise SessionError(
            f"the nonces of a pair have {len(own_nonce)} and {len(other_nonce)} bytes; both must have "
            f"{PAIR_NONCE_BYTES}"
        )
    first = own < other
    said = own + other + own_nonce + other_nonce if first else other + own + other_nonce + own_nonce
    made = _derive(secret, session, b"cotouch probes of a pair 1" + said, 72)
    there = (int.from_bytes(made[:4], "big"), made[4:36])
    back = (int.from_bytes(made[36:40], "big"), made[40:])
    return PairKeys(there, back) if first else PairKeys(back, there)


def ask(key: bytes, nonce: bytes) -> bytes:
    """The question where this comes from; the answer repeats its transaction of 16 bytes.

    Args:
        key: of the member who is asked.
        nonce: what makes the question new.
    """
    return _tagged(key, _MEMBER.pack(PROBE, Kind.ASK, 0, nonce, bytes(16), 0, 0))


def tell(
    key: bytes, question: bytes, source: Address, cookie: Callable[[bytes, str], bytes] | None = None
) -> bytes | None:
    """The answer to an ask that came from there, in plain form; None: it is not a member's ask.

    Args:
        key: of members.
        question: the ask.
        source: where it came from.
        cookie: makes four bytes of its word and host; None: zeros.
    """
    if len(question) != MEMBER_BYTES or question[1] != Kind.ASK or not _fits(key, question):
        return None
    nonce = question[4:20]
    host = ipaddress.ip_address(source.host)
    number = int(host) if host.version == 6 else int(host) | 0xFFFF << 32
    hidden = (number ^ int.from_bytes(nonce, "big")).to_bytes(16, "big")
    port = source.port ^ int.from_bytes(nonce[:2], "big")
    more = bytes(4) if cookie is None else cookie(nonce, str(host))
    first, second = struct.unpack(">HH", more)
    return _tagged(key, _MEMBER.pack(PROBE, Kind.TELL, first, nonce, hidden, port, second))


def told(key: bytes, answer: bytes) -> tuple[bytes, Address, bytes] | None:
    """Transaction, address and cookie of a tell; None: it is not a member's.

    Args:
        key: public key of the member who is said to answer.
        answer: the datagram.
    """
    if len(answer) != MEMBER_BYTES or answer[1] != Kind.TELL or not _fits(key, answer):
        return None
    _, _, first, nonce, hidden, port, second = _MEMBER.unpack_from(answer)
    host = ipaddress.IPv6Address(int.from_bytes(hidden, "big") ^ int.from_bytes(nonce, "big"))
    address = plain_address((str(host), port ^ int.from_bytes(nonce[:2], "big")))
    return None if address is None else (nonce, address, struct.pack(">HH", first, second))


def ping(keys: PairKeys, number: int) -> bytes:
    """The question whether the other end is there; its number is used once.

    Args:
        keys: of the pair.
        number: used once.
    """
    return _tagged(keys.sending[1], _PAIR.pack(PROBE, Kind.PING, 0, keys.sending[0], number))


def pong(keys: PairKeys, number: int) -> bytes:
    """The answer to the other end's ping of this number.

    Args:
        keys: of the pair.
        number: used once.
    """
    return _tagged(keys.sending[1], _PAIR.pack(PROBE, Kind.PONG, 0, keys.sending[0], number))


def label_of(datagram: bytes) -> int | None:
    """For which pair a ping or pong says it is; nothing about it is true yet. None: it is neither."""
    if len(datagram) != PAIR_BYTES or datagram[1] not in {Kind.PING, Kind.PONG}:
        return None
    return _PAIR.unpack_from(datagram)[3]


def read_pair(keys: PairKeys, datagram: bytes) -> tuple[Kind, int] | None:
    """Kind and number of the other end's ping or pong; None: it is not the other end's.

    Args:
        keys: of the pair.
        datagram: as it came.
    """
    if label_of(datagram) != keys.receiving[0] or not _fits(keys.receiving[1], datagram):
        return None
    return Kind(datagram[1]), _PAIR.unpack_from(datagram)[4]


def _derive(secret: bytes, session: bytes, info: bytes, size: int) -> bytes:
    salt = hashlib.sha256(session).digest()
    return HKDF(SHA256(), size, salt=salt, info=info).derive(hashlib.sha256(b"cotouch invitation" + secret).digest())


def _tagged(key: bytes, body: bytes) -> bytes:
    return body + hmac.digest(key, body, "sha256")[:_TAG_BYTES]


def _fits(key: bytes, datagram: bytes) -> bool:
    tag = hmac.digest(key, datagram[:-_TAG_BYTES], "sha256")[:_TAG_BYTES]
    return datagram[0] == PROBE and hmac.compare_digest(tag, datagram[-_TAG_BYTES:])
