"""Which sample of a neighbour a step uses: one of a fixed index, or the newest there is."""

from dataclasses import dataclass, field
from typing import NamedTuple, Protocol, final

import numpy as np
import numpy.typing as npt

Float = npt.NDArray[np.float64]

# States of one end of a link, in the order of trust; see `cotouch.peer.LinkGuard`.
GUARDED, READY, COUPLED = range(3)


class Word(NamedTuple):
    """What one end of a link tells the other besides its position.

    Attributes:
        state: in which the step was taken: `GUARDED`, `READY` or `COUPLED`.
        epoch: how often this end was guarded, 1 to 255 and round again; 0 says nothing.
        heard: the other end's epoch as this end heard it last; 0 before.
        given: energy that this end gave to the other, all since the beginning, >= 0 [J].
        wanting: whether this end cannot follow its neighbour for want of energy.
    """

    state: int = COUPLED
    epoch: int = 0
    heard: int = 0
    given: float = 0.0
    wanting: bool = False


# Of a neighbour that holds its springs itself, as in the simulator, and of one that has not been heard yet.
_PLAIN, UNHEARD = Word(), Word(GUARDED)


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Sample:
    """What a peer tells its neighbours after every step.

    Attributes:
        sender: index of the user.
        index: k, the number of the step, from 0.
        stamp: time at the middle of the step on the sender's clock [s].
        position: x̂, the position at the middle of the step, in the rows of the session's model, (rows, width) [m].
        word: of the sender's guard to this neighbour; by default that of a neighbour without one.
    """

    sender: int
    index: int
    stamp: float
    position: Float
    word: Word = _PLAIN


class Link(Protocol):
    """What a peer holds of one neighbour."""

    def offer(self, sample: Sample) -> bool:
        """Takes a sample that arrived; False if it is of no use (late, or a duplicate)."""
        ...

    def ready(self, k: int) -> bool:
        """Whether step k may be taken."""
        ...

    def choose(self, k: int) -> Sample:
        """The sample that step k uses."""
        ...


@final
@dataclass(eq=False)
class FreshestLink:
    """Newest wins: whatever was lost, late, duplicated or out of order.

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

    def ready(self, k: int) -> bool:
        """Always: a step never waits."""
        del k
        return True

    def choose(self, k: int) -> Sample:
        """The newest sample."""
        del k
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
