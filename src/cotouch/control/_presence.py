"""Who is there: those who just now said so, in a way that nobody else can and that cannot be said again later.

A member beats: it says to all that it is there, with a nonce that it drew just now. To each whom it heard it returns
that one's last nonce, under a key of the two::

    beat    magic 4 | sender 32 | key of this life 32 | its signature 64 | nonce 8 | flags u8 | count u16 | tags
    tag     start of the other's public key 8 | HMAC-SHA256 over the other's nonce, its own and flags, 16 bytes of it

The key of a life is X25519's, drawn when the member starts and signed once with its identity [Ed25519]; the keys of two
lives make one for each direction [HKDF-SHA256]. A tag over a nonce of mine shows that the member lived after I drew it,
so it is present for `window` seconds from then, whatever was recorded, repeated or made up by others. Whoever has no
such tag is not there, whatever else is said of it; and nobody but itself can say that it left. A tag that does not fit
costs microseconds, a key that was not seen before two tenths of a millisecond, and of those few are looked at.
"""

import hmac
import struct
from collections import deque
from typing import final

from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PublicKey
from cryptography.hazmat.primitives.asymmetric.x25519 import X25519PrivateKey, X25519PublicKey
from cryptography.hazmat.primitives.hashes import SHA256
from cryptography.hazmat.primitives.kdf.hkdf import HKDF

from cotouch.samples import Bucket, Entropy, Identity

# A beat is said so often [s]; who is not heard of for so long, counted from the nonce that it returned, is gone [s].
BEAT_EVERY = 0.5
WINDOW = 3.0
_MAGIC = b"cta1"
_HEAD = struct.Struct(">4s32s32s64s8sBH")
_TAG = struct.Struct(">8s16s")
_LEAVING = 1
_CONTEXT = b"cotouch presence 1\0"
_MOST_TAGS = 255
MOST_BEAT = _HEAD.size + _MOST_TAGS * _TAG.size
# Whoever comes is answered at once, but no oftener than this [s].
_SOON = 0.1
# A nonce of one's own is used for so long [s].
_FRESH = 0.25
# Members that are kept in mind, and for how long after their last beat [s].
_MOST_OTHERS = 512
_FORGET = 30.0
# Lives of one member that are kept in mind: one that ends and one that begins.
_LIVES = 2
# Nonces of a member that nobody vouches for yet.
_MOST_WORDS = 4
# Keys that were not seen before: so many a second, and at once.
_NEW_RATE, _NEW_BURST = 50.0, 200.0
# Whoever was not called for so long stood still itself, and knows nothing of the others [s].
_STILL = 1.0


@final
class _Life:
    """One start of a member, as far as it was heard."""

    __slots__ = ("left", "listening", "lived", "maybe", "nonce", "received", "speaking")

    def __init__(self, listening: bytes, speaking: bytes, now: float) -> None:
        self.listening, self.speaking = listening, speaking
        self.lived = -float("inf")  # it lived at this time, at least
        self.left = False
        self.received = now
        self.nonce: bytes | None = None  # its last that is known to be its own
        self.maybe = deque[bytes](maxlen=_MOST_WORDS)


@final
class Presence:
    """Sends beats and receives others'. Opens nothing, knows no clock, and never raises for a beat's contents.

    Attributes:
        refused: how many beats were of no use.
    """

    def __init__(
        self,
        identity: Identity,
        session: bytes,
        entropy: Entropy,
        *,
        window: float = WINDOW,
        every: float = BEAT_EVERY,
    ) -> None:
        """Begins a life.

        Args:
            identity: of this member.
            session: 32 bytes that name the session.
            entropy: gives so many bytes that nobody can guess.
            window: who is there is so from the nonce that it returned on [s].
            every: between two beats [s].
        """
        self.refused = 0
        self._own, self._session, self._entropy = identity.public, session, entropy
        self._window, self._every = window, every
        self._secret = X25519PrivateKey.from_private_bytes(entropy(32))
        self._life = self._secret.public_key().public_bytes_raw()
        self._signature = identity.sign(_CONTEXT + session + self._life)
        self._nonces = deque[tuple[bytes, float]](maxlen=16)
        self._others: dict[bytes, dict[bytes, _Life]] = {}
        self._until: dict[bytes, float] = {}  # replaced, never changed: it is read from another thread
        self._new = Bucket(_NEW_RATE, _NEW_BURST)
        self._said, self._due = -float("inf"), -float("inf")
        self._turned: float | None = None

    def present(self, now: float) -> frozenset[bytes]:
        """Public keys of those who are there; may be asked from any thread [s]."""
        return frozenset(key for key, until in self._until.items() if now <= until)

    def wait(self, now: float) -> float:
        """How long until the next beat is due [s]."""
        return max(0.0, self._due - now)

    def beat(self, now: float, *, leaving: bool = False) -> bytes | None:
        """What is to be said now; None: nothing.

        Args:
            now: time that does not run backwards; to be called about as often as beats are due [s].
            leaving: whether it is the last word of this life, which is always due.
        """
        self._wake(now)
        if now < self._due and not leaving:
            return None
        self._said, self._due = now, now + self._every
        if not self._nonces or now - self._nonces[-1][1] > _FRESH:
            self._nonces.append((self._entropy(8), now))
        nonce, flags = self._nonces[-1][0], _LEAVING if leaving else 0
        for key in [key for key, lives in self._others.items() if not self._kept(lives, now)]:
            del self._others[key]
        tags: list[bytes] = []
        newest = sorted(self._others.items(), key=lambda other: -max(life.lived for life in other[1].values()))
        for key, lives in newest:
            for life in lives.values():
                known = life.nonce is not None and now - life.lived <= self._window
                nonces = [life.nonce] if known and life.nonce is not None else life.maybe
                tags.extend(_TAG.pack(key[:8], _tag(life.speaking, theirs, nonce, flags)) for theirs in nonces)
        del tags[_MOST_TAGS:]
        head = _HEAD.pack(_MAGIC, self._own, self._life, self._signature, nonce, flags, len(tags))
        return head + b"".join(tags)

    def receive(self, raw: bytes, now: float) -> bool:
        """Takes a beat, or what is said to be one; whether it shows that its sender is there.

        Args:
            raw: as it arrived.
            now: [s].
        """
        shown = self._receive(raw, now)
        self.refused += shown is None
        return bool(shown)

    def _receive(self, raw: bytes, now: float) -> bool | None:
        if not _HEAD.size <= len(raw) <= MOST_BEAT or not raw.startswith(_MAGIC):
            return None
        _, sender, key, signature, nonce, flags, count = _HEAD.unpack_from(raw)
        if sender == self._own or len(raw) != _HEAD.size + count * _TAG.size:
            return None
        life = self._others.get(sender, {}).get(key) or self._meet(sender, key, signature, now)
        if life is None:
            return None
        life.received = now
        since = self._returned(life, raw, nonce, flags)
        if since is None:  # it does not know this member yet, or not any more
            if nonce not in life.maybe:
                life.maybe.append(nonce)
                self._due = min(self._due, max(now, self._said + _SOON))
            return False
        if life.lived < now - self._window:
            self._due = min(self._due, max(now, self._said + _SOON))
        life.nonce, life.lived, life.left = nonce, max(life.lived, since), life.left or bool(flags & _LEAVING)
        self._note(sender)
        return True

    def _returned(self, life: _Life, raw: bytes, nonce: bytes, flags: int) -> float | None:
        """When the nonce of this member that is returned was drawn [s]; None: there is none."""
        for at in range(_HEAD.size, len(raw), _TAG.size):
            if raw[at : at + 8] != self._own[:8]:
                continue
            for mine, drawn in reversed(self._nonces):
                if hmac.compare_digest(raw[at + 8 : at + _TAG.size], _tag(life.listening, mine, nonce, flags)):
                    return drawn
        return None

    def _meet(self, sender: bytes, key: bytes, signature: bytes, now: float) -> _Life | None:
        """A life that was not heard of before."""
        lives = self._others.get(sender)
        if lives is None and len(self._others) >= _MOST_OTHERS and not self._room(now):
            return None
        if not self._new.take(now):
            return None
        try:
            Ed25519PublicKey.from_public_bytes(sender).verify(signature, _CONTEXT + self._session + key)
            shared = self._secret.exchange(X25519PublicKey.from_public_bytes(key))
        except (InvalidSignature, ValueError):
            return None
        salt = b"".join(sorted((self._life, key)))

        def derived(of: bytes, to: bytes) -> bytes:
            return HKDF(SHA256(), 32, salt=salt, info=_CONTEXT + self._session + of + to).derive(shared)

        life = _Life(derived(sender, self._own), derived(self._own, sender), now)
        lives = self._others.setdefault(sender, {})
        while len(lives) >= _LIVES:  # old keys can be said again by anybody: they push out no life that shows itself
            del lives[min(lives, key=lambda known: lives[known].lived)]
        lives[key] = life
        return life

    def _room(self, now: float) -> bool:
        """Lets go of one that never showed itself, or not lately."""
        oldest = min(self._others, key=lambda key: max(life.lived for life in self._others[key].values()))
        if max(life.lived for life in self._others[oldest].values()) >= now - self._window:
            return False
        del self._others[oldest]
        return True

    def _kept(self, lives: dict[bytes, _Life], now: float) -> bool:
        return any(now - life.received <= _FORGET for life in lives.values())

    def _note(self, sender: bytes) -> None:
        lived = [life.lived for life in self._others[sender].values() if not life.left]
        until = {key: time for key, time in self._until.items() if key != sender and key in self._others}
        if lived:
            until[sender] = max(lived) + self._window
        self._until = until

    def _wake(self, now: float) -> None:
        """What was not heard while this process stood still says nothing of the others."""
        still = 0.0 if self._turned is None else now - self._turned - self._every
        self._turned = now
        if still > _STILL:
            for lives in self._others.values():
                for life in lives.values():
                    life.lived += still
            self._nonces = deque(((nonce, drawn + still) for nonce, drawn in self._nonces), maxlen=16)
            self._until = {key: until + still for key, until in self._until.items()}


def _tag(key: bytes, theirs: bytes, nonce: bytes, flags: int) -> bytes:
    return hmac.digest(key, theirs + nonce + bytes((flags,)), "sha256")[:16]
