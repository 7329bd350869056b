"""What others see this member send from: asked of members who answer, the host above all, and of no foreign server."""

from collections.abc import Sequence
from typing import final

from cotouch.live._address import Address, flaw, plain
from cotouch.live._keys import Entropy
from cotouch.live._probe import WORD_BYTES, ask, tell, told

# A NAT keeps a mapping for half a minute at least [RFC 4787 asks for two; Linux gives 30 s]: asking anew keeps it, too.
KEEP = 15.0
_HURRY = 0.25
_HURRIED = 12
# After so many questions without an answer, what was answered before is no longer believed.
_DOUBT = 4


@final
class Mirror:
    """Tells members where their questions come from. Limits are up to who reads the socket."""

    def __init__(self, key: bytes) -> None:
        """Takes the members' key; see `member_key`."""
        self._key = key

    def answer(self, datagram: bytes, source: object) -> bytes | None:
        """The answer, to be sent where the question came from, and as long as it; None: none is due."""
        address = plain(source)
        return None if address is None else tell(self._key, datagram, address)


@final
class _Asked:
    __slots__ = ("answer", "due", "tries", "word")

    def __init__(self) -> None:
        self.word = b""
        self.due = -float("inf")
        self.tries = 0
        self.answer: Address | None = None


@final
class Lookup:
    """Asks mirrors for this member's own address: a few times in a hurry, then as often as keeps a NAT's mapping."""

    def __init__(self, key: bytes, entropy: Entropy) -> None:
        """Takes the members' key and what draws the words of questions."""
        self._key = key
        self._entropy = entropy
        self._mirrors: dict[Address, _Asked] = {}

    @property
    def addresses(self) -> list[Address]:
        """Where others see this one, each once; two with one host say that its NAT gives each of them another port."""
        return list(dict.fromkeys(asked.answer for asked in self._mirrors.values() if asked.answer is not None))

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
            if not asked.word:  # repeated with the same word: the way may take longer than the hurry
                asked.word = self._entropy(WORD_BYTES)
            out.append((mirror, ask(self._key, asked.word)))
        return out

    def take(self, now: float, datagram: bytes, source: object) -> bool:
        """Takes an answer; whether it was one to the open question to that mirror."""
        mirror = plain(source)
        asked = None if mirror is None else self._mirrors.get(mirror)
        read = None if asked is None or not asked.word else told(self._key, datagram)
        if asked is None or read is None or read[0] != asked.word or flaw(read[1]) is not None:
            return False
        asked.word, asked.tries, asked.due, asked.answer = b"", 0, now + KEEP, read[1]
        return True
