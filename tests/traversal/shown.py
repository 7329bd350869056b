"""What a member asks the host's mirror, and gets that asks it from an address."""

from tests.live.support import entropy

from cotouch.samples import Address
from cotouch.traversal import Addresses, Lookup, Mirror, Place, member_key

KEY = member_key(b"secret", b"session")
MIRROR = Address("203.0.113.1", 7000)


def asking(member: bytes = bytes(32), seed: int = 3) -> tuple[Lookup, bytes]:
    """A member of this public key that asks the mirror, and its question."""
    lookup = Lookup(KEY, entropy(seed), member)
    lookup.look([MIRROR])
    ((to, question),) = lookup.due(0.0)
    assert to == MIRROR
    return lookup, question


def place_at(addresses: Addresses, member: bytes, host: str) -> Place:
    """What shows that the member of this public key is there."""
    lookup, question = asking(member)
    answer = Mirror(KEY, addresses).answer(question, (host, 5000))
    assert answer is not None
    assert lookup.take(0.1, answer, MIRROR)
    assert lookup.place is not None
    return lookup.place
