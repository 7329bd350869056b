"""What members cut, told over the control plane: each says which elements it decided to cut, and signs that.

A statement names all elements that its author ever decided to cut, so a newer one contains the older, and any of them
may be lost, repeated, or handed on by others, to those who come later too. What is believed is the union of what all
have signed. A liar's statement costs others what it says it cut, no faster than `_SPEED` of the body a second; nobody
can speak in another's name, and nobody whom the session does not let cut is believed.
"""

import base64
import binascii
import hashlib
from typing import Annotated, final

import numpy as np
from pydantic import StringConstraints

from cotouch.arrays import Bool, Int
from cotouch.control import ControlPlane
from cotouch.members._messages import Key, Roster, Signature, Slot, read_message, write_message
from cotouch.members._shared_model import SharedModel
from cotouch.peer import CutSet, Peer
from cotouch.samples import Bucket, signed_by
from cotouch.scenario import Table

TOPIC = "link.cuts"
# What is new is said at once, but no oftener than this; what was said is said again this often [s].
_SOON, _AGAIN = 0.05, 1.0
# A newcomer listens for so long at least before anything breaks in its copy [s].
_LISTEN = 2.0
# Elements of one author that are believed in a second and at once, as shares of the body; and so many at least at once.
_SPEED, _BURST, _LEAST = 0.1, 0.25, 64
# Authors that are kept in mind: more than a session has users, as they come and go.
_MOST_AUTHORS = 256
# Signatures that one sender may ask to be looked at [1/s].
_LOOKS = 20.0
_CONTEXT = b"cotouch cuts 1\0"
_MOST_ELEMENTS = 1 << 20


@final
class Statement(Table):
    """Elements that a member decided to cut.

    Attributes:
        author: its public key.
        slot: of its user.
        elements: bit n of byte n // 8, the highest first: element n; base64.
        signature: of the author, over all of it and the session.
    """

    author: Key
    slot: Slot
    elements: Annotated[str, StringConstraints(max_length=_MOST_ELEMENTS // 6 + 4)]
    signature: Signature


@final
class _Trust:
    """How many elements one member is believed to have cut, in whatever slots it was."""

    def __init__(self, size: int) -> None:
        self._most, self._rate = max(float(_LEAST), _BURST * size), max(_SPEED * size, float(_LEAST))
        self._left, self._then = self._most, float("inf")

    def take(self, wanted: int, now: float) -> int:
        """As many of those that are wanted as may be believed now."""
        self._left = min(self._most, self._left + max(now - self._then, 0.0) * self._rate)
        self._then = now
        taken = min(wanted, int(self._left))
        self._left -= taken
        return taken


@final
class _Author:
    """What one member has signed in one slot, and how much of it is believed so far."""

    def __init__(self, slot: int, size: int, trust: "_Trust") -> None:
        self.slot = slot
        self.signed: Bool = np.zeros(size, dtype=np.bool_)
        self.believed: Bool = np.zeros(size, dtype=np.bool_)
        self.body = b""
        self._trust = trust

    def believe(self, now: float) -> Bool:
        """Takes as much of what was signed as may be believed by now; returns what is new."""
        waiting = np.flatnonzero(self.signed & ~self.believed)
        waiting = waiting[: self._trust.take(waiting.size, now)]
        new = np.zeros(self.signed.size, dtype=np.bool_)
        new[waiting] = True
        self.believed |= new
        return new


@final
class SharedCuts:
    """Says what its copy decided to cut, hears what others did, and hands that on.

    Attributes:
        refused: statements that were not believed.
    """

    def __init__(self, control: ControlPlane, replica: SharedModel, session: bytes, slot: int) -> None:
        """Knows of no cut yet.

        Args:
            control: the control plane.
            replica: of the session, with a body that can be cut.
            session: bytes that name the session.
            slot: of this user.
        """
        self.refused = 0
        self._control, self._slot = control, slot
        self._size = replica.body.cut_count
        self._may = replica.scenario.cutting
        self._session = session
        self._authors: dict[tuple[str, int], _Author] = {}
        self._trusts: dict[str, _Trust] = {}
        self._said, self._since = -float("inf"), float("inf")
        self._own: Bool = np.zeros(self._size, dtype=np.bool_)
        self._body = b""
        self._looks: dict[int, Bucket] = {}  # signatures of each sender
        self._turn = 0
        self._listened = False

    def receive(self, sender: int, body: bytes, roster: Roster, now: float) -> None:
        """Takes a statement; never raises for what is in it.

        Args:
            sender: slot of the member who told it, its own or another's.
            body: as it arrived.
            roster: who takes part, and whose names were ever known.
            now: [s].
        """
        said = read_message(Statement, body)
        signed = None if said is None else self._elements(said.elements)
        if said is None or signed is None or not self._credible(said, roster):
            self.refused += 1
            return
        known = self._authors.get((said.author, said.slot))
        if known is not None and not np.any(signed & ~known.signed):
            return
        if known is None and len(self._authors) >= _MOST_AUTHORS:
            self.refused += 1
            return
        looks = self._looks.setdefault(sender, Bucket(_LOOKS, _LOOKS))
        if not looks.take(now) or not self._genuine(said):
            self.refused += 1
            return
        if known is None:
            trust = self._trusts.setdefault(said.author, _Trust(self._size))
            known = self._authors[said.author, said.slot] = _Author(said.slot, self._size, trust)
        if np.all(signed | ~known.signed):  # the newer one contains the older
            known.body = body
        known.signed |= signed

    def service(self, peer: Peer | None, now: float, *, coupled: bool) -> None:
        """Tells the copy what is new, and others what it decided.

        Nothing breaks in a newcomer's copy before it has heard the others and is where they are: on its way it is
        strained.

        Args:
            peer: the copy; None before it moves.
            now: [s].
            coupled: whether all its links are.
        """
        if peer is None or peer.cuts is None:
            return
        self._since = min(self._since, now)
        if coupled and now - self._since >= _LISTEN:
            self._listened = True
        peer.cuts.tears = self._listened
        self._tell_copy(peer.cuts, now)
        own = peer.cuts.own if self._before is None else peer.cuts.own | self._before.signed
        new = bool(np.any(own & ~self._own))
        if new and now - self._said >= _SOON:
            self._own = own.copy()
            self._body = self._signed(self._own)
        elif now - self._said < _AGAIN:
            return
        self._said = now
        if self._body:
            self._control.send(TOPIC, self._body)
        told = [author.body for author in self._authors.values() if author.body and author is not self._before]
        if told and not new:  # one who has left tells nobody any more
            self._turn = (self._turn + 1) % len(told)
            self._control.send(TOPIC, told[self._turn])

    @property
    def _before(self) -> _Author | None:
        """What this member itself cut before it was started again, as others tell; None: nothing is known of it."""
        return self._authors.get((self._control.identity.public.hex(), self._slot))

    def _tell_copy(self, cuts: CutSet, now: float) -> None:
        for author in self._authors.values():
            new = author.believe(now)
            if new.any():
                cuts.hear(np.where(new, np.int32(author.slot + 1), np.int32(0)))

    def _credible(self, said: Statement, roster: Roster) -> bool:
        """Whether the author had that slot, as the roster says, and whoever has it may cut."""
        if self._may is not None and not self._may.may(said.slot + 1):
            return False
        return said.slot in roster.slots().get(said.author, set())

    def _elements(self, text: str) -> Bool | None:
        """Which elements are meant; None: they are not of this body."""
        try:
            raw = base64.b64decode(text, validate=True)
        except (ValueError, binascii.Error):
            return None
        if len(raw) != (self._size + 7) // 8:
            return None
        bits = np.unpackbits(np.frombuffer(raw, dtype=np.uint8))
        return None if bits[self._size :].any() else bits[: self._size].astype(np.bool_)

    def _about(self, author: str, slot: int, elements: str) -> bytes:
        digest = hashlib.sha256(_CONTEXT + self._session).digest()
        return digest + f"{author} {slot} {elements}".encode()

    def _signed(self, own: Bool) -> bytes:
        identity, elements = self._control.identity, base64.b64encode(np.packbits(own).tobytes()).decode()
        author = identity.public.hex()
        signature = identity.sign(self._about(author, self._slot, elements)).hex()
        return write_message(Statement(author=author, slot=self._slot, elements=elements, signature=signature))

    def _genuine(self, said: Statement) -> bool:
        about = self._about(said.author, said.slot, said.elements)
        return signed_by(bytes.fromhex(said.author), bytes.fromhex(said.signature), about)


def digest_of(by: Int) -> str:
    """64 bits that tell one set of cut elements from another, as hex digits.

    Args:
        by: as `cotouch.peer.CutSet.by`.
    """
    return hashlib.blake2b(np.packbits(by != 0).tobytes(), digest_size=8).hexdigest()
