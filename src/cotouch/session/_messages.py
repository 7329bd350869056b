"""What members tell each other over the control plane, as JSON; checked before anything of it is used."""

from typing import Annotated, TypeVar, final

from pydantic import Field, FiniteFloat, StringConstraints, ValidationError

from cotouch.scenario import Table
from cotouch.session._file import MOST_USERS

MOST_LINKS = MOST_USERS * (MOST_USERS - 1) // 2
Seat = Annotated[int, Field(ge=0, lt=MOST_USERS)]  # from 0; people see seat + 1
Key = Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{64}$")]
Name = Annotated[str, StringConstraints(min_length=1, max_length=32, pattern=r"^[^\x00-\x1f\x7f]+$")]
Text = Annotated[str, StringConstraints(max_length=200)]
Number = Annotated[FiniteFloat, Field(ge=-1e12, le=1e12)]
Path = Annotated[FiniteFloat, Field(ge=0.0, le=1e6)]
T = TypeVar("T", bound=Table)


@final
class Join(Table):
    """A wish to take part; said again until a roster or a refusal answers it.

    Attributes:
        name: that others see.
        fingerprint: of the body as this machine built it.
        version: of the software.
    """

    name: Name
    fingerprint: Annotated[list[Number], Field(max_length=16)]
    version: Text


@final
class Refused(Table):
    """Why a wish to take part was not granted."""

    reason: Text


@final
class Entry(Table):
    """One who takes part.

    Attributes:
        seat: index of the user.
        name: that others see.
        key: public key.
    """

    seat: Seat
    name: Name
    key: Key


@final
class Roster(Table):
    """Who takes part, and who is linked to whom; the newest epoch counts.

    Attributes:
        epoch: rises with every change.
        members: in the order of their seats.
        links: pairs of seats, the smaller first, sorted.
    """

    epoch: Annotated[int, Field(ge=0, lt=1 << 32)] = 0
    members: Annotated[list[Entry], Field(max_length=MOST_USERS)] = Field(default_factory=list[Entry])
    links: Annotated[list[tuple[Seat, Seat]], Field(max_length=MOST_LINKS)] = Field(
        default_factory=list[tuple[Seat, Seat]]
    )

    def by_seat(self) -> dict[int, Entry]:
        """The members by seat."""
        return {entry.seat: entry for entry in self.members}

    def of(self, key: bytes) -> Entry | None:
        """The member with this public key."""
        wanted = key.hex()
        return next((entry for entry in self.members if entry.key == wanted), None)

    def neighbours(self, seat: int) -> list[int]:
        """Seats that a seat is linked to."""
        return [b if a == seat else a for a, b in self.links if seat in (a, b)]


@final
class LinkStatus(Table):
    """What one end knows of a link.

    Attributes:
        seat: of the neighbour.
        state: "keys" (not agreed yet), "waiting" (nothing heard), "guarded", "ready" or "coupled".
        way: "direct" or "relayed".
        age: of the sample in the last step, plus the offset of the clocks [s].
        ages: greatest sum of both directions' ages in the window [s]; null until both are known.
        budget: sum of both budgets [s].
        path: quickest way there and back in the window [s].
        loss: of what the neighbour sent, in the last interval.
        rate: of samples to it [1/s].
        force: of its spring on the copy [N].
        work: of the link on the copy since the start [J].
        difference: between its copy, as far as known, and this one, over all nodes, greatest [m].
        guarded: how often the link was guarded.
    """

    seat: Seat
    state: Text
    way: Text = "direct"
    age: Number | None = None
    ages: Number | None = None
    budget: Number | None = None
    path: Number | None = None
    loss: Number = 0.0
    rate: Number = 0.0
    force: Number = 0.0
    work: Number = 0.0
    difference: Number | None = None
    guarded: int = 0


@final
class Status(Table):
    """What a member says about itself, twice a second.

    Attributes:
        seat: its own.
        epoch: of the roster it works with.
        time: since it began to step [s].
        steps: so many.
        rate: steps per second since the last status [Hz].
        period: that it aims at [s].
        longest: longest T since the last status [s].
        missed: steps that came more than half a period late, so far.
        stood: time in which the copy stood still, because a step was later than it may be [s].
        busy: share of a core that its work takes.
        force: of the hand and devices on the copy [N].
        position: of the copy's centre, from rest [m].
        supplied: by the hands, so far [J].
        lost: in dampers, so far [J].
        linked: work of all links on this copy, so far [J].
        rescaled: what the copy's energy changed by as members came and went and its share of the object with them, so
            far [J]. `initial + supplied + linked + rescaled - lost` is `energy`, to round-off.
        energy: kinetic and elastic [J].
        initial: what it began with [J].
        residual: greatest of any step, of the energy in play.
        damping: B_i, as the largest coefficient [Ns/m].
        certificate: what the damping exceeds what the budgets in force need by, as a share.
        links: to each neighbour.
        alarms: of the books, so far.
        paths: seat of another member, linked or not, and the quickest way there and back as pings find it [s]; with
            what is emulated.
    """

    seat: Seat
    epoch: int = 0
    time: Number = 0.0
    steps: int = 0
    rate: Number = 0.0
    period: Number = 0.0
    longest: Number = 0.0
    missed: int = 0
    stood: Number = 0.0
    busy: Number = 0.0
    force: Number = 0.0
    position: Annotated[list[Number], Field(max_length=3)] = Field(default_factory=list[float])
    supplied: Number = 0.0
    lost: Number = 0.0
    linked: Number = 0.0
    rescaled: Number = 0.0
    energy: Number = 0.0
    initial: Number = 0.0
    residual: Number = 0.0
    damping: Number = 0.0
    certificate: Number | None = None
    links: Annotated[list[LinkStatus], Field(max_length=MOST_USERS)] = Field(default_factory=list[LinkStatus])
    alarms: int = 0
    paths: Annotated[list[tuple[Seat, Path]], Field(max_length=MOST_USERS)] = Field(
        default_factory=list[tuple[Seat, float]]
    )

    def measured(self) -> dict[int, float]:
        """Times there and back by the other's seat [s]: as pings find them; by a relay, as the samples of a link do."""
        return {link.seat: max(link.path, 0.0) for link in self.links if link.path is not None} | dict(self.paths)


def read(kind: type[T], body: bytes) -> T | None:
    """A message, or None if it is none of this kind."""
    try:
        return kind.model_validate_json(body)
    except (ValidationError, ValueError):
        return None


def write(message: Table) -> bytes:
    """The message as bytes."""
    return message.model_dump_json().encode()
