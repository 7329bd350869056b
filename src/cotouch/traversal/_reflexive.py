"""What others see this member send from: asked of members who answer, the host above all, and of no foreign server."""

from collections.abc import Sequence
from typing import final

from cotouch.samples import Address, Entropy, flaw, plain_address
from cotouch.traversal._addresses import NONCE_BYTES, Addresses, Place, transaction_of
from cotouch.traversal._probe import ask, tell, told

# A NAT keeps a mapping for half a minute at least [RFC 4787 asks for two; Linux gives 30 s]: asking anew keeps it, too.
KEEP = 15.0
_HURRY = 0.25
_HURRIED = 12
# After so many questions without an answer, what was answered before is no longer believed.
_DOUBT = 4


@final
class Mirror:
    """Tells members where their questions come from. Limits are up to the reader of the socket."""

    def __init__(self, key: bytes, addresses: Addresses | None = None) -> None:
        """Takes the members' key, see `member_key`, and what makes cookies, if this is the host's."""
        self._key = key
        self._cookie = None if addresses is None else addresses.cookie

    def answer(self, datagram: bytes, source: object) -> bytes | None:
        """The answer, to be sent where the question came from, and as long as it; None: none is due.

        Args:
            datagram: as it came.
            source: where it came from.
        """
        address = plain_address(source)
        return None if address is None else tell(self._key, datagram, address, self._cookie)


@final
class _Asked:
    __slots__ = ("answer", "due", "nonce", "place", "transaction", "tries")

    def __init__(self) -> None:
        self.transaction = b""
        self.due = -float("inf")
        self.tries = 0
        self.answer: Address | None = None
        self.nonce = b""
        self.place: Place | None = None


@final
class Lookup:
    """Asks mirrors for this member's own address: a few times quickly, then often enough to keep a NAT's mapping."""

    def __init__(self, key: bytes, entropy: Entropy, member: bytes) -> None:
        """Takes the members' key, what draws the nonces of questions, and this member's public key."""
        self._key = key
        self._member = member
        self._entropy = entropy
        self._mirrors: dict[Address, _Asked] = {}

    @property
    def addresses(self) -> list[Address]:
        """Where others see this one, each once; two with one host say that its NAT gives each of them another port."""
        return list(dict.fromkeys(asked.answer for asked in self._mirrors.values() if asked.answer is not None))

    @property
    def place(self) -> Place | None:
        """What shows the host where this member is; None: nothing yet."""
        return next((asked.place for asked in self._mirrors.values() if asked.place is not None), None)

    def look(self, mirrors: Sequence[Address]) -> None:
        """Whom to ask from now on, in plain form; what others answered is forgotten."""
        self._mirrors = {mirror: self._mirrors.get(mirror) or _Asked() for mirror in mirrors}

    def hurry(self, now: float) -> None:
        """Asks again at once: a way was lost, so a NAT may have forgotten."""
        for asked in self._mirrors.values():
            asked.due, asked.tries = now, 0

    def due(self, now: float) -> list[tuple[Address, bytes]]:
        """Questions to be sent now [s], and where to."""
        out: list[tuple[Address, bytes]] = []
        for mirror, asked in self._mirrors.items():
            if now < asked.due:
                continue
            asked.tries += 1
            if asked.tries > _DOUBT:
                asked.answer = None
            asked.due = now + (_HURRY if asked.tries < _HURRIED else KEEP)
            if not asked.transaction:  # repeated with the same transaction: the way may take longer than the hurry
                asked.nonce = self._entropy(NONCE_BYTES)
                asked.transaction = transaction_of(self._member, asked.nonce)
            out.append((mirror, ask(self._key, asked.transaction)))
        return out

    def take(self, now: float, datagram: bytes, source: object) -> bool:
        """Takes an answer; whether it was one to the open question to that mirror.

        Args:
            now: time by the clock of this member [s].
            datagram: as it came.
            source: where it came from.
        """
        mirror = plain_address(source)
        asked = None if mirror is None else self._mirrors.get(mirror)
        read = None if asked is None or not asked.transaction else told(self._key, datagram)
        if asked is None or read is None or read[0] != asked.transaction or flaw(read[1]) is not None:
            return False
        asked.transaction, asked.tries, asked.due, asked.answer = b"", 0, now + KEEP, read[1]
        asked.place = Place(asked.nonce, read[1].host, read[2])
        return True
