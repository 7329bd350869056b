"""Where a member may be reached: what it tells a neighbour over the control plane, topic `path.candidates`.

::

    version u8 | count u8 | nonce, 16 bytes | count × ( kind u8 | family u8 | port u16 | host, 4 or 16 bytes )

All numbers are big-endian. The nonce is this end's part of the pair's keys; see `pair_keys`.
"""

import ipaddress
import struct
from collections import Counter
from collections.abc import Iterable, Sequence
from enum import IntEnum
from typing import NamedTuple, final

from cotouch.errors import SessionError
from cotouch.samples import Address, flaw, numeric, plain_address
from cotouch.traversal._probe import PAIR_NONCE_BYTES

TOPIC = "path.candidates"
# A machine with more addresses than this is reached by some of them; and nobody can make a neighbour probe more.
MOST_CANDIDATES = 16
_VERSION = 1
_ENTRY = struct.Struct(">BBH")
_HOST_BYTES = {4: 4, 6: 16}


@final
class CandidateKind(IntEnum):
    """How an address is known; the smaller, the more direct."""

    LOCAL = 0
    REFLEXIVE = 1
    LEARNT = 2


class Candidate(NamedTuple):
    """An address at which a member may be reached.

    Attributes:
        origin: LOCAL: of one of its interfaces; REFLEXIVE: what others see it send from.
        address: in plain form.
    """

    origin: CandidateKind
    address: Address


class Offer(NamedTuple):
    """What a neighbour said of itself.

    Attributes:
        nonce: its part of the pair's keys.
        candidates: of use, each once, in its order.
        refused: those that are not, by reason.
    """

    nonce: bytes
    candidates: tuple[Candidate, ...]
    refused: Counter[str]


def local_candidates(listening: Address, interfaces: Iterable[str]) -> list[Candidate]:
    """A member's own addresses.

    Args:
        listening: where its socket listens.
        interfaces: hosts of its machine's interfaces, asked only if it listens on all of them.
    """
    own = numeric(listening.host)
    hosts = [listening.host]
    if own.is_unspecified:
        hosts = [host for host in interfaces if not numeric(host).is_loopback]
    found: list[Candidate] = []
    for host in hosts:
        address = plain_address((host, listening.port))
        wanted = address is not None and (own.version == 6 or numeric(address.host).version == 4)
        if address is not None and wanted and flaw(address) is None:
            found.append(Candidate(CandidateKind.LOCAL, address))
    return found


def write_offer(nonce: bytes, candidates: Sequence[Candidate]) -> bytes:
    """The message; if there are too many candidates, the first of them.

    Args:
        nonce: what makes the question new.
        candidates: addresses that may work.

    Raises:
        SessionError: an address is of no use to anybody, or the nonce has another length.
    """
    if len(nonce) != PAIR_NONCE_BYTES:
        raise SessionError(f"the nonce of an offer has {len(nonce)} bytes; it must have {PAIR_NONCE_BYTES}")
    announced = list(dict.fromkeys(candidates))[:MOST_CANDIDATES]
    out = bytearray((_VERSION, len(announced))) + nonce
    for origin, address in announced:
        host = numeric(address.host)
        why = flaw(address)
        if why is not None or origin is CandidateKind.LEARNT:
            raise SessionError(
                f"{address.host} port {address.port} is not a candidate ({why or 'learnt'}); leave it out"
            )
        out += _ENTRY.pack(origin, host.version, address.port) + host.packed
    return bytes(out)


def read_offer(message: bytes) -> Offer | None:
    """What a neighbour says about itself, or None if it cannot be read. Never raises for its contents."""
    if len(message) < 2 + PAIR_NONCE_BYTES or message[0] != _VERSION or message[1] > MOST_CANDIDATES:
        return None
    found: dict[Candidate, None] = {}
    refused: Counter[str] = Counter()
    at = 2 + PAIR_NONCE_BYTES
    for _ in range(message[1]):
        if len(message) < at + _ENTRY.size:
            return None
        origin, family, port = _ENTRY.unpack_from(message, at)
        at += _ENTRY.size
        size = _HOST_BYTES.get(family)
        if size is None or len(message) < at + size or origin not in {CandidateKind.LOCAL, CandidateKind.REFLEXIVE}:
            return None
        host = message[at : at + size]
        at += size
        address = plain_address((str(ipaddress.ip_address(host)), port))
        why = "host" if address is None else flaw(address)
        if address is None or why is not None:
            refused[why or "host"] += 1
        else:
            found[Candidate(CandidateKind(origin), address)] = None
    return Offer(message[2 : 2 + PAIR_NONCE_BYTES], tuple(found), refused) if at == len(message) else None
