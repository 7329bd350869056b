"""What a peer holds of one neighbour: in every chunk the newest, each with its own age."""

from math import inf
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.live._codec import Chunk
from cotouch.live._layout import Layout
from cotouch.live._refusal import Refusal
from cotouch.peer import GUARDED, UNHEARD, Sample, Word

Float = npt.NDArray[np.float64]


@final
class Assembly:
    """A neighbour's state, put together of the newest chunks; a `Link` of the peer (freshest).

    A lost chunk leaves its rows as they are and ages only them. Duplicates and what was overtaken change nothing.

    Attributes:
        sender: index of the neighbour.
        state: as far as it is known, (rows, width); changes in place.
        stamps: of each chunk, on the neighbour's clock [s].
        indices: of each chunk, the step it comes from; -1 before the first.
        words: of each chunk, what the neighbour's guard said with it.
    """

    def __init__(self, layout: Layout, *, sender: int, initial: Float, stamp: float = 0.0) -> None:
        """Starts from a state that both ends know.

        Args:
            layout: of the session.
            sender: index of the neighbour.
            initial: stands for what has not arrived yet, (rows, width).
            stamp: of it [s].
        """
        self._layout = layout
        self.sender = sender
        self.state = np.array(initial, dtype=np.float64)
        self.stamps = [stamp] * layout.chunks
        self.indices = [-1] * layout.chunks
        self.words = [UNHEARD] * layout.chunks
        self._whole = False
        # Where each chunk goes; none with a basis, which spreads every number over all rows.
        spans = [] if layout.basis is not None else [layout.span(chunk) for chunk in range(layout.chunks)]
        self._parts = [self.state[span, : layout.axes] for span in spans]
        self._chosen: Sample | None = None

    @property
    def complete(self) -> bool:
        """Whether every chunk arrived at least once."""
        return self._whole

    @property
    def oldest(self) -> float:
        """Stamp from which the age of the whole counts [s]."""
        return min(self.stamps)

    @property
    def newest(self) -> int:
        """Greatest step index so far; -1: none."""
        return max(self.indices)

    @property
    def word(self) -> Word:
        """What the neighbour's guard says of all rows together.

        Of chunks that were sent in different states, the most cautious counts; in different epochs, none is to be
        relied on. What it has heard is that of the newest.
        """
        first = self.words[0]
        if len(self.words) == 1:
            return first
        newest = self.words[self.indices.index(max(self.indices))]
        if any(word.epoch != newest.epoch for word in self.words):
            return newest._replace(state=GUARDED)
        return newest._replace(state=min(word.state for word in self.words))

    def take(self, chunk: Chunk) -> Refusal | None:
        """Takes a chunk that was read; says why, if it is of no use."""
        at, heading = chunk.chunk, chunk.heading
        held, step, stamp = self.indices[at], heading.step, heading.stamp
        if step <= held:
            return Refusal.STALE
        if held >= 0 and stamp <= self.stamps[at]:
            return Refusal.BACKWARDS
        if self._parts:
            self._parts[at][...] = chunk.values
        else:
            self._layout.expand(chunk.values, self.state)
        self.indices[at] = step
        self.stamps[at] = stamp
        self.words[at] = heading.word
        self._chosen = None
        if not self._whole:
            self._whole = min(self.indices) >= 0
        return None

    def offer(self, sample: Sample) -> bool:
        """Takes a whole sample, as one that came another way than in chunks."""
        if sample.index <= self.newest or (self.newest >= 0 and sample.stamp <= max(self.stamps)):
            return False
        self.state[:] = sample.position
        self.indices = [sample.index] * len(self.indices)
        self.stamps = [sample.stamp] * len(self.stamps)
        self.words = [sample.word] * len(self.words)
        self._whole, self._chosen = True, None
        return True

    def ready(self, k: int) -> bool:
        """Always: a step never waits."""
        del k
        return True

    def choose(self, k: int) -> Sample:
        """The newest of every row, with the stamp of the oldest; to be used before the next chunk is taken.

        Until every row has arrived it is infinitely old.
        """
        del k
        if not self._whole:
            return Sample(sender=self.sender, index=-1, stamp=-inf, position=self.state, word=self.word)
        if self._chosen is None:
            self._chosen = Sample(
                sender=self.sender, index=self.newest, stamp=self.oldest, position=self.state, word=self.word
            )
        return self._chosen
