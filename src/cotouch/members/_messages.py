"""What members tell each other over the control plane, as JSON; checked before anything of it is used."""

import hashlib
from typing import Annotated, Literal, Self, TypeVar, final

from pydantic import Field, FiniteFloat, StringConstraints, ValidationError, model_validator

from cotouch.members._file import MOST_USERS
from cotouch.scenario import Table

MOST_LINKS = MOST_USERS * (MOST_USERS - 1) // 2
MOST_NOTICE = 200
# Names that a session remembers, and keys that it does not let in any more.
MOST_NAMES = MOST_BANNED = 256
# Rosters of one chain: the host's, and those who decided after it was gone.
MOST_STAGES = 4
# No counter of ours comes near these; whoever says more is not believed.
LAST_EPOCH = 1 << 52
_LAST_COUNT = 1 << 53
Slot = Annotated[int, Field(ge=0, lt=MOST_USERS)]  # from 0; people see slot + 1
Key = Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{64}$")]
_SEEN = r"[^\x00-\x1f\x7f-\x9f\u200b\u2028-\u202e\u2060-\u2069\ufeff]"  # nothing steers a terminal or its lines
Name = Annotated[str, StringConstraints(min_length=1, max_length=32, pattern=f"^{_SEEN}+$")]
Text = Annotated[str, StringConstraints(max_length=200, pattern=f"^{_SEEN}*$")]
Notice = Annotated[str, StringConstraints(max_length=MOST_NOTICE, pattern=f"^{_SEEN}*$")]
Reason = Annotated[str, StringConstraints(max_length=100, pattern=f"^{_SEEN}*$")]
Number = Annotated[FiniteFloat, Field(ge=-1e12, le=1e12)]
Start = Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{16}$")]
Signature = Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{128}$")]
Epoch = Annotated[int, Field(ge=0, lt=LAST_EPOCH)]
Count = Annotated[int, Field(ge=0, lt=_LAST_COUNT)]
Path = Annotated[FiniteFloat, Field(ge=0.0, le=1e6)]
T = TypeVar("T", bound=Table)


@final
class AddressProof(Table):
    """A proof of where a member is, given out by the host; see `cotouch.traversal.Place`."""

    nonce: Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{32}$")]
    host: Annotated[str, StringConstraints(max_length=45)]
    cookie: Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{8}$")]


@final
class Join(Table):
    """A request to take part, repeated until a roster or a refusal answers it.

    Attributes:
        name: that others see.
        fingerprint: of the body as this machine built it.
        version: of the software.
        law: signature of the session's link law as this machine has it; see `cotouch.laws.Law`.
        start: drawn when the process began: one that comes back with its key needs new links.
        place: what shows where it is.
    """

    name: Name
    fingerprint: Annotated[list[Number], Field(max_length=16)]
    version: Text
    law: Text = ""
    start: Start = "0" * 16
    place: AddressProof | None = None


@final
class Refused(Table):
    """Why a request to take part was not granted.

    Attributes:
        reason: in a sentence.
        final: whether asking again is of no use; else a slot may become free.
    """

    reason: Text
    final: bool = False


@final
class Entry(Table):
    """One member of a roster.

    Attributes:
        slot: index of the user.
        name: that others see.
        key: public key.
        start: of its process; see `Join`.
    """

    slot: Slot
    name: Name
    key: Key
    start: Start = "0" * 16

    @property
    def life(self) -> str:
        """Tells one start of its process from the next, which comes back with the same key."""
        return self.key + self.start


class Former(Table):
    """A key that has lost its name: the host expelled its owner or released the name.

    Attributes:
        key: public key.
        slots: that this one ever had; so those who come later know in which slot it cut.
    """

    key: Key
    slots: Annotated[tuple[Slot, ...], Field(max_length=MOST_USERS)] = ()


@final
class NameOwner(Former):
    """A name, and the key to which it belongs for the whole session.

    Attributes:
        name: that others see.
    """

    name: Name


@final
class Roster(Table):
    """The members, their slots and their links.

    No slot, key or name is there twice, no name has two keys and no key two names, links are of those who are there.

    Attributes:
        epoch: rises with every change.
        members: in the order of their slots.
        links: pairs of slots, the smaller first, sorted.
        names: that somebody ever had, and whose they are.
        banned: keys of those whom the host sent away.
        former: who has no name any more.
    """

    epoch: Epoch = 0
    members: Annotated[list[Entry], Field(max_length=MOST_USERS)] = Field(default_factory=list[Entry])
    links: Annotated[list[tuple[Slot, Slot]], Field(max_length=MOST_LINKS)] = Field(
        default_factory=list[tuple[Slot, Slot]]
    )
    names: Annotated[list[NameOwner], Field(max_length=MOST_NAMES)] = Field(default_factory=list[NameOwner])
    banned: Annotated[list[Key], Field(max_length=MOST_BANNED)] = Field(default_factory=list[Key])
    former: Annotated[list[Former], Field(max_length=MOST_NAMES)] = Field(default_factory=list[Former])

    @model_validator(mode="after")
    def _whole(self) -> Self:
        slots = [entry.slot for entry in self.members]
        if sorted(set(slots)) != slots:
            raise ValueError("slots are not in order, or one occurs twice")
        if any(not a < b or a not in slots or b not in slots for a, b in self.links):
            raise ValueError("a link is not between two users who are present")
        if sorted(set(self.links)) != self.links:
            raise ValueError("links are not in order, or one occurs twice")
        said = [(entry.name, entry.key) for entry in (*self.names, *self.members)]
        owners = set(said)
        if len({name for name, _ in owners}) < len(owners) or len({key for _, key in owners}) < len(owners):
            raise ValueError("a name has two keys, or a key two names")
        if len({entry.key for entry in self.members}) < len(slots) or len(set(self.names)) < len(self.names):
            raise ValueError("a key or a name occurs twice")
        if len({gone.key for gone in self.former}) < len(self.former):
            raise ValueError("a member left twice")
        if {entry.key for entry in self.members} & set(self.banned):
            raise ValueError("a member is present who was expelled")
        return self

    def owners(self) -> dict[str, str]:
        """Whose each name is: the key by the name."""
        return {entry.name: entry.key for entry in (*self.names, *self.members)}

    def slots(self) -> dict[str, set[int]]:
        """Slots that each key ever had."""
        found: dict[str, set[int]] = {}
        for had in (*self.names, *self.former):
            found.setdefault(had.key, set()).update(had.slots)
        for entry in self.members:
            found.setdefault(entry.key, set()).add(entry.slot)
        return found

    @property
    def digest(self) -> str:
        """SHA-256 of all of it."""
        return hashlib.sha256(write_message(self)).hexdigest()

    def by_slot(self) -> dict[int, Entry]:
        """The members by slot."""
        return {entry.slot: entry for entry in self.members}

    def of(self, key: bytes) -> Entry | None:
        """The member with this public key."""
        wanted = key.hex()
        return next((entry for entry in self.members if entry.key == wanted), None)

    def neighbours(self, slot: int) -> list[int]:
        """Slots that a slot is linked to."""
        return [b if a == slot else a for a, b in self.links if slot in (a, b)]


@final
class Decision(Table):
    """A roster and who decided it.

    Attributes:
        roster: that was decided.
        signer: public key of who did.
        signature: over the roster and the session; see `signed`.
    """

    roster: Roster
    signer: Key
    signature: Signature


@final
class Decided(Table):
    """The newest roster, and the right by which it was decided.

    Attributes:
        chain: first a roster of the host; then, if it is gone, the newest of whoever decides, a member of the one
            before; rarely more, where all whom the host knew have left.
    """

    chain: Annotated[list[Decision], Field(min_length=1, max_length=MOST_STAGES)]


@final
class LinkStatus(Table):
    """What one end knows about a link.

    Attributes:
        slot: of the neighbour.
        law: of the link.
        given: energy that this end says it gave over the link, with a law that pays; 0 for springs [J].
        taken: energy that it took over the link, likewise [J].
        state: "keys" (not agreed yet), "waiting" (nothing heard, or of late), "guarded", "ready" or "coupled".
        path_state: "direct" or "relayed".
        age: of the sample in the last step, plus the offset of the clocks [s].
        age_sum: greatest sum of both directions' ages in the window [s]; null until both are known.
        budget: sum of both budgets [s].
        round_trip: quickest way there and back in the window [s].
        loss: of what the neighbour sent, in the last interval.
        rate: of samples to it [1/s].
        datagram_rate: of datagrams to it [1/s].
        byte_rate: of their bytes, sealed, without what the network adds [B/s].
        saved: share of bytes that a perceptual codec left out; 0 without one.
        force: of its spring on the copy [N].
        work: of the link on the copy since the start [J].
        difference: between its copy, as far as known, and this one, over all nodes, greatest [m].
        guarded: how often the link was guarded.
        asked: what both ends' budgets would come to, where that is beyond the session's limit; null: it is not [s].
    """

    slot: Slot
    state: Text
    law: Reason = "spring"
    given: Number = 0.0
    taken: Number = 0.0
    path_state: Text = "direct"
    age: Number | None = None
    age_sum: Number | None = None
    budget: Number | None = None
    round_trip: Number | None = None
    loss: Number = 0.0
    rate: Number = 0.0
    datagram_rate: Number = 0.0
    byte_rate: Number = 0.0
    saved: Number = 0.0
    force: Number = 0.0
    work: Number = 0.0
    difference: Number | None = None
    guarded: Count = 0
    asked: Number | None = None


@final
class Status(Table):
    """What a member says about itself, twice a second.

    Attributes:
        slot: its own.
        epoch: of the roster it works with.
        time: since it began to step [s].
        steps: so many.
        rate: steps per second since the last status [Hz].
        nominal_period: length of a step that it aims at [s].
        longest_period: longest step since the last status [s].
        missed: steps that came more than half a period late, so far.
        stood: time in which the copy stood still, because a step was later than it may be, or waited longer [s].
        busy: share of a core that its work takes.
        force: of the hand and devices on the copy [N].
        position: of the copy's centre, from rest [m].
        supplied: by the hands, so far [J].
        lost: in dampers, so far [J].
        linked: work of all links on this copy, so far [J].
        rescaled: what the copy's energy changed by as members came and went and its share of the object with them, so
            far [J]. `initial + supplied + linked + rescaled - lost` is `energy`, to round-off.
        energy: kinetic and elastic, with weight and obstacles; of the weight 0 where the copy began [J].
        depth: how far that was below 0 at most [J].
        initial: what it began with [J].
        initial_energies: what its links were given once, to begin with and to come to where the others are, so far [J].
        residual: greatest of any step, of the energy in play.
        damping: B_i, as the largest coefficient [Ns/m].
        law: of its links.
        held: energy that the law's account holds, for who gave and was not given back [J].
        drag: this copy's part of the drag that the law is predicted to put on whoever moves all copies evenly together;
            null: none is predicted [Ns/m for the identity weight].
        braked: what the law took of this copy's motion in the last seconds [J].
        moved: ∫‖v̂‖² over them, in the identity weight [m²/s].
        damping_margin: what the damping exceeds what the budgets in force need by, as a share.
        links: to each neighbour.
        unsent: whether the copy is farther away than samples can tell, so that none are sent.
        alarms: of the ledger, so far.
        closure: work on the velocities that closed the steps of a body with a material, so far [J].
        closure_factor: greatest change of a velocity by that, |β - 1|.
        closure_alarms: steps so far whose forces and energy disagree, by more than 0.01, or that were shortened for it.
        cut_energy: lost with the elements that were cut, so far; part of `lost` [J].
        cuts: elements that are cut.
        cut_set: 64 bits that tell that set from another; empty of a body that cannot be cut.
        roster: digest of the roster it works with.
        round_trips: slots of others, linked or not, and the quickest ways there and back, emulation included [s].
        device: what there is to say of the device in the user's hand; empty for nothing.
        recording: whether it records what it does, or wanted to.
        recording_failure: why it does not any more.
    """

    slot: Slot
    epoch: Count = 0
    time: Number = 0.0
    steps: Count = 0
    rate: Number = 0.0
    nominal_period: Number = 0.0
    longest_period: Number = 0.0
    missed: Count = 0
    stood: Number = 0.0
    busy: Number = 0.0
    force: Number = 0.0
    position: Annotated[list[Number], Field(max_length=3)] = Field(default_factory=list[float])
    supplied: Number = 0.0
    lost: Number = 0.0
    linked: Number = 0.0
    rescaled: Number = 0.0
    energy: Number = 0.0
    depth: Number = 0.0
    initial: Number = 0.0
    initial_energies: Number = 0.0
    residual: Number = 0.0
    damping: Number = 0.0
    law: Reason = "spring"
    held: Number = 0.0
    drag: Number | None = None
    braked: Number = 0.0
    moved: Number = 0.0
    damping_margin: Number | None = None
    links: Annotated[list[LinkStatus], Field(max_length=MOST_USERS)] = Field(default_factory=list[LinkStatus])
    unsent: bool = False
    alarms: Count = 0
    closure: Number = 0.0
    closure_factor: Number = 0.0
    closure_alarms: Count = 0
    cut_energy: Number = 0.0
    cuts: Count = 0
    cut_set: Annotated[str, StringConstraints(pattern=r"^([0-9a-f]{16})?$")] = ""
    roster: Key | None = None
    round_trips: Annotated[list[tuple[Slot, Path]], Field(max_length=MOST_USERS)] = Field(
        default_factory=list[tuple[Slot, float]]
    )
    device: Notice = ""
    recording: Literal["off", "on", "failed"] = "off"
    recording_failure: Reason = ""

    def measured(self) -> dict[int, float]:
        """Times there and back by the other's slot [s]: as pings find them; by a relay, as the samples of a link do."""
        return {link.slot: max(link.round_trip, 0.0) for link in self.links if link.round_trip is not None} | dict(
            self.round_trips
        )


def read_message(kind: type[T], body: bytes) -> T | None:
    """A message, or None if it is not of this kind.

    Args:
        kind: of message.
        body: as it came.
    """
    try:
        return kind.model_validate_json(body)
    except (ValidationError, ValueError):
        return None


def write_message(message: Table) -> bytes:
    """The message as bytes."""
    return message.model_dump_json().encode()


def plain(text: str) -> str:
    """As a `Reason`: short, without what steers a terminal."""
    return "".join(letter if letter.isprintable() else " " for letter in text)[:100]
