"""Where this member may be reached: its socket's address, this machine's others, and what others see it send from."""

from collections.abc import Callable, Sequence
from typing import final

from cotouch.errors import TransportError
from cotouch.samples import AddressedTransport, numeric
from cotouch.traversal._candidates import Candidate, CandidateKind, local_candidates
from cotouch.traversal._reflexive import Lookup

# The machine is asked for its interfaces at most this often.
_LOOK_AROUND = 5.0
# And for the address by which it reaches the others, which costs some system calls, this often [s].
_WATCH = 1.0
# Candidates are said again this often: messages are lost while a member is cut off [s].
_TELL = 5.0
_TELL_DIRECT = 60.0
# As often in the time after this machine got another address, while the control plane finds its own way back [s].
_TELL_MOVED, _MOVED_FOR = 1.0, 20.0


@final
class OwnCandidates:
    """What neighbours are to be told, found out anew as this machine moves.

    Attributes:
        told: the candidates, as of the last look.
    """

    def __init__(
        self,
        socket: AddressedTransport,
        lookup: Lookup,
        interfaces: Callable[[], Sequence[str]],
        here: Callable[[], str | None] | None,
    ) -> None:
        """Knows none until it looks.

        Args:
            socket: of the samples.
            lookup: knows what others see.
            interfaces: gives the hosts of this machine's interfaces.
            here: gives the address by which this machine reaches the others now, None where it does not; None: the
                socket stays.
        """
        self.told = list[Candidate]()
        self._socket, self._lookup = socket, lookup
        self._interfaces, self._address_now = interfaces, here
        self._listening = socket.address
        self._local = list[Candidate]()
        self._looked = self._watched = self._moved = -float("inf")

    def look(self, now: float) -> bool:
        """Finds out where this member may be reached; whether that has changed.

        Args:
            now: [s].
        """
        if now >= self._looked + _LOOK_AROUND:
            self._looked = now
            every = numeric(self._listening.host).is_unspecified
            self._local = local_candidates(self._listening, self._interfaces() if every else ())
        here = {candidate.address for candidate in self._local}
        seen = [Candidate(CandidateKind.REFLEXIVE, at) for at in self._lookup.addresses if at not in here]
        before, self.told = self.told, [*self._local, *seen]
        return self.told != before

    def follow(self, now: float) -> bool:
        """Takes the socket to where this machine is, for at a lost address it neither sends nor receives.

        Args:
            now: [s].

        Returns:
            Whether it went; a look is due then.
        """
        if self._address_now is None or now < self._watched + _WATCH:
            return False
        self._watched = now
        host = self._address_now()
        if host is None or host == self._listening.host:
            return False
        try:
            self._socket.rebind(host)
        except TransportError:  # it is gone again, or not quite there; the next look tells
            return False
        self._listening, self._looked, self._moved = self._socket.address, -float("inf"), now
        self._lookup.hurry(now)
        return True

    def telling(self, now: float, *, direct: bool) -> float:
        """How long until a neighbour is told them again [s].

        Args:
            now: [s].
            direct: whether samples go straight to it.
        """
        if now < self._moved + _MOVED_FOR:
            return _TELL_MOVED
        return _TELL_DIRECT if direct else _TELL

    def reaches(self, candidate: Candidate) -> bool:
        """Whether the socket can reach another's address, and may: of this machine's own only if they are all it has.

        Args:
            candidate: of a neighbour.
        """
        own, other = numeric(self._listening.host), numeric(candidate.address.host)
        if other.version == 6 and own.version == 4:
            return False
        return not other.is_loopback or own.is_loopback or own.is_unspecified
