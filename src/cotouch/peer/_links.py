"""Which sample of a neighbour a step uses: one of a fixed index, or the newest there is."""

from dataclasses import dataclass, field
from enum import IntEnum
from typing import NamedTuple, Protocol, TypeAlias, final

from cotouch.arrays import Float, Int

# Fields (fields, size) and numbers (scalars,) that a law tells a neighbour besides x̂; see `cotouch.laws.Law`.
Message: TypeAlias = tuple[Float, Float]

# A live step may use what comes so long after its end: reading goes on for a little after the clock was read. What came
# later came while the process stood still, and a step must not know what is yet to be [s].
MOST_AHEAD = 1e-3


@final
class LinkState(IntEnum):
    """States of a link's end, in order of increasing trust; see `cotouch.peer.LinkGuard`."""

    GUARDED = 0
    READY = 1
    COUPLED = 2


class LinkHeader(NamedTuple):
    """What one end of a link reports to the other besides its position.

    Attributes:
        state: in which the step was taken: a `LinkState`.
        epoch: how often this end was guarded, 1 to 255 and round again; 0 says nothing.
        known_epoch: the other end's epoch as this end heard it last; 0 before.
        given: energy that this end gave to the other, all since the beginning, >= 0 [J].
        starved: whether this end cannot follow its neighbour for want of energy.
    """

    state: int = LinkState.COUPLED
    epoch: int = 0
    known_epoch: int = 0
    given: float = 0.0
    starved: bool = False


# Of a neighbour that holds its springs itself, as in the simulator, and of one that has not been heard yet.
PLAIN, NO_HEADER = LinkHeader(), LinkHeader(LinkState.GUARDED)


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Sample:
    """What a peer sends its neighbours after every step.

    Attributes:
        sender: index of the user.
        index: k, the number of the step, from 0.
        stamp: time at the middle of the step on the sender's clock [s].
        position: x̂, the position at the middle of the step, in the rows of the session's model, (rows, width) [m].
        header: of the sender's guard to this neighbour; by default that of a neighbour without one.
        message: of the link's law to this neighbour; None where the law says nothing.
        content: number of the step whose content it continues, from a `Decoder`; None: it is its own.
        cuts: who decided to cut each element that is cut, from 1, else 0, (elements,); None of a body that cannot be
            cut, and where another way tells it.
    """

    sender: int
    index: int
    stamp: float
    position: Float
    header: LinkHeader = PLAIN
    message: Message | None = None
    content: int | None = None
    cuts: Int | None = None


class Link(Protocol):
    """What a peer keeps about one neighbour."""

    def offer(self, sample: Sample) -> bool:
        """Takes a sample that arrived; False if it is of no use (late, or a duplicate)."""
        ...

    def ready(self, k: int) -> bool:
        """Whether step k may be taken."""
        ...

    def choose(self, k: int) -> Sample:
        """The sample that step k uses."""
        ...


class SourcedLink:
    """A link that uses the samples of another, in its own way.

    Attributes:
        source: which sample a step uses.
    """

    source: Link

    def offer(self, sample: Sample) -> bool:
        """Hands a sample to the source."""
        return self.source.offer(sample)

    def ready(self, k: int) -> bool:
        """Whether the source has what step k needs."""
        return self.source.ready(k)

    def choose(self, k: int) -> Sample:
        """The sample that step k would use."""
        return self.source.choose(k)


@final
@dataclass(eq=False)
class FreshestLink:
    """The newest sample wins, whatever was lost, late, duplicated or reordered.

    Attributes:
        current: the newest sample so far.
    """

    current: Sample

    def offer(self, sample: Sample) -> bool:
        """Takes the sample if it is newer than what is held."""
        if sample.index <= self.current.index:
            return False
        self.current = sample
        return True

    def ready(self, k: int) -> bool:  # noqa: ARG002
        """Always: a step never waits."""
        return True

    def choose(self, k: int) -> Sample:  # noqa: ARG002
        """The newest sample."""
        return self.current


@final
@dataclass(eq=False)
class ConstantLink:
    """Constant indexing delay: step k uses sample k - N_ij [Lee & Huang 2010, section II-A].

    Attributes:
        initial: stands for every sample before the first.
        delay: N_ij, >= 1.
        waiting: samples that arrived and may still be needed, by index.
    """

    initial: Sample
    delay: int
    waiting: dict[int, Sample] = field(default_factory=dict[int, Sample])
    _oldest: int = -1

    def offer(self, sample: Sample) -> bool:
        """Keeps the sample until its step."""
        if sample.index < self._oldest or sample.index in self.waiting:
            return False
        self.waiting[sample.index] = sample
        return True

    def ready(self, k: int) -> bool:
        """Whether sample k - N_ij is there."""
        return k < self.delay or (k - self.delay) in self.waiting

    def choose(self, k: int) -> Sample:
        """Sample k - N_ij; where the buffer has run empty, the newest before it."""
        held = [index for index in self.waiting if index <= k - self.delay]
        if not held:
            return self.initial
        newest = max(held)
        for index in held:
            if index < newest:
                del self.waiting[index]
        self._oldest = newest
        return self.waiting[newest]
