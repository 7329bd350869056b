"""Which roster a member believes: the host's, or that of whoever decides while the host is gone, within bounds.

A roster is signed by who decided it. The host's counts as it is: the newest that it signed, whoever carries it. When
the host is gone, the lowest slot that is there decides, of those whom the host let in; of those who came later only
when none of these is there. What it decides bears the host's last roster as its beginning, so that everybody, a
newcomer too, can see by signatures alone that

* the host let its signer in, or somebody whom the host let in did;
* whoever is in both has the same slot; names keep their keys; who was sent away is not back; nobody's number leaps.

What a signature cannot show, each member looks at itself: that its signer is the one who decides, among those who are
there; and that nobody who is there was left out, moved, or given another's name. What it does not believe it says,
and it gives way only where more of those whom the host let in do (`settle`).
"""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import final

from cotouch.members._messages import LAST_EPOCH, MOST_STAGES, Decided, Decision, Roster, write_message
from cotouch.network import Network
from cotouch.samples import Identity, signed_by

# A number rises by no more than this from what was known: one that leaps would soon leave none.
MOST_LEAP = 1 << 16
_CONTEXT = b"cotouch roster 1\0"
_MOST_VERIFIED = 64

Chain = tuple[Decision, ...]


def signed(identity: Identity, host: bytes, roster: Roster) -> Decision:
    """A roster as decided by this member; the host's key is new for each session and so names it.

    Args:
        identity: this member's keys.
        host: its public key.
        roster: who takes part.
    """
    signature = identity.sign(_CONTEXT + host + write_message(roster))
    return Decision(roster=roster, signer=identity.public.hex(), signature=signature.hex())


def genuine(decision: Decision, host: bytes) -> bool:
    """Whether a roster was signed by its claimed author.

    Args:
        decision: a signed roster.
        host: its public key.
    """
    signer, signature = bytes.fromhex(decision.signer), bytes.fromhex(decision.signature)
    return signed_by(signer, signature, _CONTEXT + host + write_message(decision.roster))


def order_of(chain: Sequence[Decision]) -> list[bytes]:
    """Who decides when the host is gone: those of the last roster, in the order in which they were let in, by slots."""
    there = {entry.key for entry in chain[-1].roster.members} if chain else set[str]()
    found: dict[str, None] = {}
    for decision in chain:
        found.update((entry.key, None) for entry in decision.roster.members if entry.key in there)
    return [bytes.fromhex(key) for key in found]


def acting(chain: Sequence[Decision], host: bytes, present: frozenset[bytes]) -> bytes | None:
    """Public key of the one who decides: the host, or the first in order who is there; None: nobody.

    Args:
        chain: who may decide, in order.
        host: its public key.
        present: public keys of who is there.
    """
    return host if host in present else next((key for key in order_of(chain) if key in present), None)


def follows(before: Roster, after: Roster) -> str | None:
    """What is wrong with a roster that a member made of another; None: nothing.

    Args:
        before: the roster until now.
        after: the roster it was made into.
    """
    if not before.epoch < after.epoch <= before.epoch + LAST_EPOCH // 2:
        return "its number is not the next one"
    if before.banned != after.banned:
        return "only the host may expel members or readmit them"
    if not before.owners().items() <= after.owners().items():
        return "it drops the owner of a name, or gives the name to another"
    had, has = before.slots(), after.slots()
    if any(not slots <= has.get(key, set()) for key, slots in had.items()):
        return "it drops the slot in which a member was"
    if before.former != after.former:
        return "only the host may release a name"
    slots = {entry.key: entry.slot for entry in after.members}
    if any(slots.get(entry.key, entry.slot) != entry.slot for entry in before.members):
        return "it moves a member to another slot"
    return None


@final
class Belief:
    """What one member believes of who takes part.

    Attributes:
        chain: the newest roster, after those it follows from; empty: none is known.
        complaint: why what was heard last from the one who decides is not believed; None: it is.
        announced: a chain that was heard last and may be true, whoever decides; who does takes up whom it names.
    """

    def __init__(
        self, host: bytes, *, network: Network | None = None, own: bytes | None = None, start: str | None = None
    ) -> None:
        """Knows nobody.

        Args:
            host: public key of the host.
            network: of the session, if it is known: others slots and springs than there are are not believed.
            own: public key of this member, if it takes part.
            start: of its process.
        """
        self.chain: Chain = ()
        self.complaint: str | None = None
        self.announced: Chain | None = None
        self._host, self._network = host, network
        self._own, self._start = None if own is None else own.hex(), start
        self._other: Chain | None = None
        self._verified: dict[tuple[str, str], None] = {}

    @property
    def roster(self) -> Roster:
        """The newest."""
        return self.chain[-1].roster if self.chain else Roster()

    def acting(self, present: frozenset[bytes]) -> bytes | None:
        """Public key of the one who decides; None: nobody."""
        return acting(self.chain, self._host, present)

    def decide(self, identity: Identity, roster: Roster) -> None:
        """Takes what this member itself decided, with what gives it the right to.

        Args:
            identity: this member's keys.
            roster: who takes part.
        """
        decision, own = signed(identity, self._host, roster), identity.public.hex()
        if identity.public == self._host:
            self._take((decision,))
            return
        # As short as can be: whom the host let in needs nobody else's word.
        entitled = next(
            at for at, one in enumerate(self.chain) if any(entry.key == own for entry in one.roster.members)
        )
        self._take((*self.chain[: entitled + 1], decision)[:MOST_STAGES])

    def entitled(self, identity: Identity) -> bool:
        """Whether a roster of this member would be believed, if nobody before it is there."""
        own = identity.public.hex()
        at = next((at for at, one in enumerate(self.chain) if any(e.key == own for e in one.roster.members)), None)
        return identity.public == self._host or (at is not None and at + 1 < MOST_STAGES)

    def vouched(self, chain: Sequence[Decision]) -> bool:
        """Whether a chain begins with the host, and each of it may follow from the one before, by signatures."""
        if bytes.fromhex(chain[0].signer) != self._host or not all(map(self._fits, chain)):
            return False
        for before, after in pairwise(chain):
            if all(entry.key != after.signer for entry in before.roster.members):
                return False
            if follows(before.roster, after.roster) is not None:
                return False
        return all(map(self._genuine, chain))

    def receive(self, decided: Decided, sender: bytes, present: frozenset[bytes]) -> bool:
        """Takes a roster, if it is to be believed; whether it did.

        Args:
            decided: that was said.
            sender: public key of who said it.
            present: public keys of those who are there, this member included.
        """
        chain = tuple(decided.chain)
        if self.chain and chain[-1].signature == self.chain[-1].signature:
            return False
        took = self._root(chain[0], alone=len(chain) == 1 and sender == self._host)
        known = self.chain
        if len(chain) == 1 or not known or chain[0].signature != known[0].signature:
            return took
        last, before = chain[-1], known[-1]
        repeated = before.signer == last.signer and last.roster.epoch <= before.roster.epoch
        if repeated or last.roster.epoch > before.roster.epoch + MOST_LEAP or not self.vouched(chain):
            return took
        self.announced = chain
        if sender.hex() != last.signer:
            return took
        # A newcomer knows the one before only from what is said; who decides by it is to be seen.
        decides = acting(known if len(known) > 1 else chain[:-1], self._host, present) == sender
        self.complaint = self._harm(before.roster, last.roster, present) if decides else None
        if not decides or self.complaint is not None:
            self._other = chain
            return took
        self._take(chain)
        return True

    def settle(self, votes: Mapping[bytes, str | None], present: frozenset[bytes]) -> bool:
        """Takes what more of those whom the host let in, and who are there, work with; whether it did.

        Who was cut off may have decided alone meanwhile, as may the others. Where as many are for either, the one
        counts whose signer the host let in at a lower slot.

        Args:
            votes: digest of the roster that members say they work with, by their keys.
            present: public keys of those who are there, this member included.
        """
        other = self._other
        if other is None:
            return False
        order = [entry.key for entry in self.chain[0].roster.members]
        digest, signer = other[-1].roster.digest, other[-1].signer
        here = [key for key in order if bytes.fromhex(key) in present]
        count = sum(key == signer or votes.get(bytes.fromhex(key)) == digest for key in here)
        decides = self.acting(present)
        mine = self._own if self._own in order else None if decides is None else decides.hex()
        first = signer in order and (mine not in order or order.index(signer) < order.index(mine))
        if not count or 2 * count < len(here) or (2 * count == len(here) and not first):
            return False
        self._take(other)
        return True

    def _take(self, chain: Chain) -> None:
        self.chain, self.complaint, self._other = chain, None, None

    def _root(self, root: Decision, *, alone: bool) -> bool:
        """Takes a newer roster of the host; or its last again, when it says that itself and another's is known."""
        newest = self.chain[0].roster.epoch if self.chain else -1
        again = alone and root.roster.epoch == newest and len(self.chain) > 1
        if root.roster.epoch <= newest and not again:
            return False
        if not self.vouched([root]):
            return False
        self._take((root,))
        return True

    def _fits(self, decision: Decision) -> bool:
        """Whether the session has such slots and springs."""
        network, roster = self._network, decision.roster
        if network is None:
            return True
        slots = all(entry.slot < network.size for entry in roster.members)
        return slots and all(network.spring[pair] > 0.0 for pair in roster.links)

    def _genuine(self, decision: Decision) -> bool:
        about = (decision.signature, decision.signer + decision.roster.digest)
        if about in self._verified:
            return True
        if not genuine(decision, self._host):
            return False
        while len(self._verified) >= _MOST_VERIFIED:
            del self._verified[next(iter(self._verified))]
        self._verified[about] = None
        return True

    def _harm(self, before: Roster, after: Roster, present: frozenset[bytes]) -> str | None:
        """What a roster does to somebody who is there, as far as this member sees."""
        said = {entry.key: entry for entry in after.members}
        owners = after.owners()
        for entry in before.members:
            if bytes.fromhex(entry.key) not in present:
                continue
            new = said.get(entry.key)
            if owners.get(entry.name, entry.key) != entry.key:
                return f"it gives {entry.name}'s name to another"
            if new is None:
                return f"it leaves out {entry.name}, who is here"
            if new.slot != entry.slot or new.name != entry.name:
                return f"it changes the slot or the name of {entry.name}, who is here"
            if entry.key == self._own and entry.start == self._start and new.start != self._start:
                return "it gives this member's slot to another run of this member"
        return None
