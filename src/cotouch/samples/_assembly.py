"""What a peer holds of one neighbour: in every chunk the newest, each with its own age."""

from math import inf
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.peer import NO_HEADER, LinkHeader, LinkState, Message, Sample
from cotouch.samples._chunk import Chunk, Refusal
from cotouch.samples._layout import Layout


@final
class Assembly:
    """A neighbour's state, assembled from the newest chunks; a `Link` of the peer (freshest).

    A lost chunk leaves its rows as they are and ages only them. Duplicates and what was overtaken change nothing.

    Attributes:
        sender: index of the neighbour.
        state: as far as it is known, (rows, width); changes in place.
        stamps: of each chunk, on the neighbour's clock [s].
        indices: of each chunk, the step it comes from; -1 before the first.
        headers: of each chunk, what the neighbour's guard said with it.
        message: fields of the link's law, each row of the newest chunk that has it, and the newest numbers; None where
            the law says nothing. It changes in place.
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
        self.headers = [NO_HEADER] * layout.chunks
        self.message: Message | None = None
        self._fields: Float | None = None  # the same, with rows
        if layout.fields or layout.scalars:
            self._fields = np.zeros((layout.fields, layout.rows, layout.width))
            self.message = self._fields.reshape(layout.fields, layout.rows * layout.width), np.zeros(layout.scalars)
        self._content: int | None = None
        self._whole = False
        # Where each chunk goes; none with a basis, which spreads every number over all rows.
        spans = [] if layout.basis is not None else [layout.span(chunk) for chunk in range(layout.chunks)]
        self._parts = [self.state[span, : layout.axes] for span in spans]
        self._told = [] if self._fields is None else [self._fields[:, span, : layout.axes] for span in spans]
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
    def header(self) -> LinkHeader:
        """What the neighbour's guard says of all rows together.

        Of chunks that were sent in different states, the most cautious counts; in different epochs, none is to be
        relied on. What it has heard is that of the newest.
        """
        first = self.headers[0]
        if len(self.headers) == 1:
            return first
        newest = self.headers[self.indices.index(max(self.indices))]
        if any(header.epoch != newest.epoch for header in self.headers):
            return newest._replace(state=LinkState.GUARDED)
        return newest._replace(state=min(header.state for header in self.headers))

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
        if self.message is not None:
            assert chunk.fields is not None and chunk.scalars is not None  # noqa: PT018
            self._told[at][...] = chunk.fields
            if step >= self.newest:
                self.message[1][:] = chunk.scalars
                self._content = chunk.content
        self.indices[at] = step
        self.stamps[at] = stamp
        self.headers[at] = heading.header
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
        self.headers = [sample.header] * len(self.headers)
        self._whole, self._chosen = True, None
        return True

    def ready(self, k: int) -> bool:  # noqa: ARG002
        """Always: a step never waits."""
        return True

    def choose(self, k: int) -> Sample:  # noqa: ARG002
        """The newest of every row, with the stamp of the oldest; to be used before the next chunk is taken.

        Until every row has arrived it is infinitely old.
        """
        if not self._whole:
            return Sample(sender=self.sender, index=-1, stamp=-inf, position=self.state, header=self.header)
        if self._chosen is None:
            self._chosen = Sample(
                sender=self.sender,
                index=self.newest,
                stamp=self.oldest,
                position=self.state,
                header=self.header,
                message=self.message,
                content=self._content,
            )
        return self._chosen
