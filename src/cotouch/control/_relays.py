"""Datagrams that came by another way than the socket's, from who sent them and not too many of each."""

import threading
from collections import Counter, deque
from typing import final

from cotouch.control._control import Relayed
from cotouch.control._pairs import TAG_BYTES, PairTags
from cotouch.samples import Identity, SourceLimit

_MOST_RELAYED = 4096
# Datagrams of whom this member does not see come through the host, at a relay's rate and twice that.
_RATE, _BURST = 4000.0, 1024.0
_UNSEEN_RATE, _UNSEEN_BURST = 200.0, 64.0


@final
class Relays:
    """What one member tags for others, and what of theirs it has yet to poll. Any thread may call it."""

    def __init__(self, identity: Identity, session: bytes, dropped: Counter[str]) -> None:
        """Begins with nobody.

        Args:
            identity: of this member.
            session: names the session.
            dropped: counts what is thrown away, by reason.
        """
        self._dropped = dropped
        self._waiting = deque[Relayed](maxlen=_MOST_RELAYED)
        self._lock = threading.Lock()
        self._limit = SourceLimit(rate=_RATE, burst=_BURST, stranger_rate=_UNSEEN_RATE, stranger_burst=_UNSEEN_BURST)
        self._tags = PairTags(identity, session)

    def know(self, member: bytes) -> None:
        """This member is connected."""
        with self._lock:
            self._limit.know(member)

    def unknow(self, member: bytes) -> None:
        """It is no longer."""
        with self._lock:
            self._limit.unknow(member)

    def tagged(self, said: bytes, to: bytes) -> bytes:
        """With the MAC that only these two members can make.

        Args:
            said: what the tag vouches for.
            to: public key of the receiver.
        """
        return said + (self._tags.tag(to, said) or bytes(TAG_BYTES))

    def take(self, sender: bytes | None, raw: bytes, now: float) -> None:
        """Keeps a tagged datagram until it is polled, unless somebody else sent it or its sender sends too much.

        Args:
            sender: public key of who is said to have sent it; None: nobody whose datagrams are taken.
            raw: what came; empty: it was too long.
            now: [s].
        """
        said = None if sender is None else self._tags.read(sender, raw, now)  # before anything counts against its limit
        with self._lock:
            if sender is None or said is None:
                self._dropped["relayed, forged"] += 1
            elif not self._limit.take(now, sender, sender):
                self._dropped["relayed"] += 1
            else:
                self._waiting.append(Relayed(said, sender, now))

    def poll(self) -> list[Relayed]:
        """What was taken since the last call, oldest first; of too many, the newest."""
        out = list[Relayed]()
        while self._waiting:
            out.append(self._waiting.popleft())
        return out
