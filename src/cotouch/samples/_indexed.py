"""What a peer holds of one neighbour under a constant indexing delay: whole states, each at its index."""

from math import inf
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import SessionError
from cotouch.peer import NO_HEADER, LinkHeader, Sample
from cotouch.samples._chunk import Chunk, Refusal
from cotouch.samples._layout import Layout

# Whoever sends indices far ahead is not given memory for them.
_AHEAD = 64


@final
class _Entry:
    """A state that is coming together."""

    def __init__(self, rows: int, width: int, chunks: int) -> None:
        self.state = np.zeros((rows, width))
        self.missing = set(range(chunks))
        self.stamp = inf
        self.header: LinkHeader | None = None


@final
class IndexedAssembly:
    """Step k uses index k - N_ij [Lee & Huang 2010, section II-A]; a `Link` of the peer.

    A state counts once all its chunks are there. One that never comes whole is gone: nobody sends it again, and its
    step uses the newest whole one before it, whose age its guard sees. A step may be taken as soon as the index that it
    uses, or a later one, is whole; so a loss never stops a self-paced peer for good, as long as its neighbour goes on.
    Two that wait for each other must each send their last sample again from time to time.

    Attributes:
        sender: index of the neighbour.
        delay: N_ij, >= 1.
        shift: the neighbour's index less this end's: nobody began at the same time.
        newest: greatest index that came whole; -1: none.
    """

    def __init__(self, layout: Layout, *, sender: int, initial: Float, delay: int, stamp: float = 0.0) -> None:
        """Starts from a state that both ends know.

        Args:
            layout: of the session.
            sender: index of the neighbour.
            initial: stands for every index before the first, (rows, width).
            delay: N_ij, >= 1.
            stamp: of the initial state [s].

        Raises:
            SessionError: the delay is below 1.
        """
        if delay < 1:
            raise SessionError(f"the indexing delay is {delay}; it must be at least 1")
        self._layout = layout
        self.sender = sender
        self.delay = delay
        self.shift = 0
        self.newest = -1
        # By how much the neighbour counts faster than this user, found where what was due has been given up long since.
        self._ahead = 0
        self._whole: dict[int, Sample] = {}
        self._parts: dict[int, _Entry] = {}
        self._current = Sample(
            sender=sender, index=-1, stamp=stamp, position=np.array(initial, dtype=np.float64), header=NO_HEADER
        )

    @property
    def complete(self) -> bool:
        """Whether a whole state arrived that a step has used."""
        return self._current.index >= 0

    @property
    def state(self) -> Float:
        """The newest whole state, (rows, width)."""
        newest = self._whole.get(self.newest)
        return self._current.position if newest is None else newest.position

    @property
    def oldest(self) -> float:
        """Stamp of the state that the last step used [s]."""
        return self._current.stamp

    def take(self, chunk: Chunk) -> Refusal | None:
        """Takes a chunk that was read; says why, if it is of no use."""
        heading, layout, index = chunk.heading, self._layout, chunk.heading.step
        if index <= self._current.index or index in self._whole:
            return Refusal.STALE
        # The first one heard may be far ahead: whoever joins finds the others anywhere.
        if self.newest >= 0 and index > self.newest + self.delay + _AHEAD:
            return Refusal.INDEX
        entry = self._parts.get(index)
        if entry is None:
            entry = self._parts[index] = _Entry(layout.rows, layout.width, layout.chunks)
            while len(self._parts) > self.delay + _AHEAD:
                del self._parts[min(self._parts)]
        if chunk.chunk not in entry.missing:
            return Refusal.STALE
        if layout.basis is None:
            entry.state[layout.span(chunk.chunk), : layout.axes] = chunk.values
        else:
            layout.expand(chunk.values, entry.state)
        entry.missing.discard(chunk.chunk)
        entry.stamp = min(entry.stamp, heading.stamp)
        entry.header = heading.header if entry.header is None else min(entry.header, heading.header)
        if not entry.missing:
            self._parts.pop(index, None)
            self._keep(
                Sample(sender=self.sender, index=index, stamp=entry.stamp, position=entry.state, header=entry.header)
            )
        return None

    def offer(self, sample: Sample) -> bool:
        """Takes a whole sample, as one that came another way than in chunks."""
        if sample.index <= self._current.index or sample.index in self._whole:
            return False
        self._keep(sample)
        return True

    def ready(self, k: int) -> bool:
        """Whether what step k uses is there, or will never be."""
        return self.newest >= self._due(k)

    def choose(self, k: int) -> Sample:
        """Index k - N_ij; where it is missing, the newest before it."""
        if len(self._whole) >= self.delay + _AHEAD and min(self._whole) > self._due(k):
            self._ahead += self.newest - 1 - self._due(k)
        due = [index for index in self._whole if index <= self._due(k)]
        if due:
            self._current = self._whole[max(due)]
            for index in due:
                del self._whole[index]
            for index in [index for index in self._parts if index <= self._current.index]:
                del self._parts[index]
        return self._current

    def _due(self, k: int) -> int:
        return k + self.shift + self._ahead - self.delay

    def _keep(self, sample: Sample) -> None:
        self._whole[sample.index] = sample
        self.newest = max(self.newest, sample.index)
        while len(self._whole) > self.delay + _AHEAD:
            del self._whole[min(self._whole)]
