"""At which address a member is, as it can show: it was told a cookie there that only the host can make.

The member asks the host's mirror with the hash of its public key and a nonce, and is told, where the question came
from, four bytes of an HMAC over that hash and that address. Whoever repeats these, signed with that key, got an answer
there. A path that can read what goes there can, too; who only writes false senders into its datagrams cannot.
"""

import hashlib
import hmac
import ipaddress
from typing import NamedTuple, final

from cotouch.samples import Entropy

NONCE_BYTES = 16
COOKIE_BYTES = 4


class Place(NamedTuple):
    """A proof of where a member is.

    Attributes:
        nonce: that it asked with.
        host: where the question came from, in numbers.
        cookie: that it was told there.
    """

    nonce: bytes
    host: str
    cookie: bytes


def transaction_of(member: bytes, nonce: bytes) -> bytes:
    """The transaction with which a member of this public key asks.

    Args:
        member: its public key.
        nonce: what makes the question new.
    """
    return hashlib.sha256(b"cotouch place 1\0" + member + nonce).digest()[:16]


@final
class Addresses:
    """The host's side: makes proofs of addresses, and recognises them."""

    def __init__(self, entropy: Entropy) -> None:
        """Draws what nobody else knows."""
        self._secret = entropy(32)

    def cookie(self, transaction: bytes, host: str) -> bytes:
        """What is told to a question of this transaction from there.

        Args:
            transaction: 16 bytes.
            host: address it came from.
        """
        return hmac.digest(self._secret, transaction + ipaddress.ip_address(host).packed, "sha256")[:COOKIE_BYTES]

    def shown(self, member: bytes, place: Place) -> str | None:
        """Where a member is: its address, of version 6 the network of 64 bits; None: it did not show it.

        Args:
            member: its public key.
            place: what the member says of itself.
        """
        try:
            address = ipaddress.ip_address(place.host)
            right = self.cookie(transaction_of(member, place.nonce), place.host)
        except ValueError:
            return None
        if not hmac.compare_digest(right, place.cookie):
            return None
        return str(address) if address.version == 4 else str(ipaddress.ip_network((address, 64), strict=False))
