"""What a member gets that asks the host's mirror from an address."""

from cotouch.traversal import Addresses, Place
from cotouch.traversal._addresses import transaction_of


def place_at(addresses: Addresses, member: bytes, host: str) -> Place:
    """What shows that the member of this public key is there."""
    nonce = bytes(16)
    return Place(nonce, host, addresses.cookie(transaction_of(member, nonce), host))
