"""Copies as bytes: what is drawn of each, worked out once for all pages, in whole numbers."""

import math
from collections.abc import Collection, Mapping
from typing import Final, final

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float, Single
from cotouch.body import Body, cut_skin, drawn_skin, drawn_tools
from cotouch.observers import HAND_MODES, CopyView
from cotouch.web._protocol import COPY, DIRECT, HAS_HAND, HEADER, VERSION

_FRAME: Final = 1
_MOST: Final = 32_767
# So fine that nothing smaller is seen, for bodies at rest [m].
_FINEST: Final = 2.0**-40
_LARGEST: Final = 2.0**40
_COARSER: Final = 0.25  # a scale is kept until less than this share of its range is used
_NOWHERE: Final = (0.0, 0.0, 0.0)


@final
class FrameEncoder:
    """Makes frames of what copies are now; a copy that did not change is not worked out again.

    Attributes:
        points: how many are drawn: vertices of the skin, or nodes.
        scale: of the whole numbers [m]; a power of two, so that it seldom changes.
        passes: over the skin, so far.
    """

    def __init__(self, body: Body) -> None:
        """Prepares the skin's table.

        Args:
            body: that is shared.
        """
        self._dimension, self._nodes = body.dimension, body.nodes
        self._table: sp.csr_array | None = None
        self.points = body.nodes
        self._tools: list[tuple[int, int, int]] = []
        self._ways: list[Float] = []
        self._reach = 1.0  # a point moves at most so many times as far as the node that moves farthest
        skin = drawn_skin(body)
        if skin is not None:
            table = skin.interpolation(body.nodes).astype(np.float32)
            table.eliminate_zeros()
            self._table = table
            self.points = skin.vertices.shape[0]
            self._reach = float(np.abs(skin.weights).sum(axis=1).max(initial=1.0)) + 1e-3
            self._tools = drawn_tools(body, cut_skin(body) if body.cut_count else None) if body.tools else []
            # What brings all points of a tool to its first: without extent, it is not seen.
            self._ways = [(skin.vertices[first] - skin.vertices[first:last]) for first, last, _ in self._tools]
        self.scale = _FINEST
        self.passes = 0
        self._known: dict[int, tuple[CopyView, bytes]] = {}

    def update(self, views: Mapping[int, CopyView], wanted: Collection[int]) -> None:
        """Works out what is drawn of the wanted copies.

        Args:
            views: newest of every copy, by slot.
            wanted: slots; of others nothing is kept.
        """
        slots = [slot for slot in sorted(views) if slot in wanted]
        known = self._known
        self._known = {slot: known[slot] for slot in slots if slot in known}
        fresh = [slot for slot in slots if slot not in known or known[slot][0] is not views[slot]]
        if not fresh:
            return
        fields = [views[slot].displacement for slot in fresh]
        largest = max(_size(views[slot].displacement) for slot in slots)
        largest = max(largest, *(float(np.abs(ways).max()) for ways in self._ways), 0.0)
        if self._rescaled(largest):
            fresh, fields = slots, [views[slot].displacement for slot in slots]
        for slot, block in zip(fresh, self._drawn(fields, fresh), strict=True):
            self._known[slot] = (views[slot], block)

    def frame(
        self, slots: Collection[int], *, number: int, time: float, start: float, echo: int = 0, waited: float = 0.0
    ) -> bytes:
        """One frame.

        Args:
            slots: whose copies to show, of those handed to `update`.
            number: of the frame.
            time: now, by the clock of the copies [s].
            start: what the frame's time counts from [s].
            echo: number of the newest pointer that the page's copy has used.
            waited: since that pointer came [s].
        """
        shown = [(view, block) for slot, (view, block) in self._known.items() if slot in slots]
        waited_us = min(max(int(1e6 * waited), 0), 0xFFFF_FFFF)
        parts: list[bytes] = [
            HEADER.pack(_FRAME, VERSION, len(shown), number, time - start, self.points, self.scale, echo, waited_us)
        ]
        for view, block in shown:
            parts.append(_about(view, time))
            parts.append(block)
        return b"".join(parts)

    def _rescaled(self, largest: float) -> bool:
        """Whether the scale had to change for displacements up to this [m]."""
        wanted = largest * self._reach / _MOST
        if _COARSER * self.scale <= wanted <= self.scale or (self.scale == _FINEST and wanted <= _FINEST):
            return False
        self.scale = 2.0 ** math.ceil(math.log2(min(max(wanted, _FINEST), _LARGEST)))
        return True

    def _drawn(self, fields: list[Single], slots: list[int]) -> list[bytes]:
        """Displacements of the drawn points as whole numbers, a block for each copy; tools of others are not seen."""
        self.passes += 1
        count = len(fields)
        moved = np.zeros((self._nodes, 3 * count), np.float32)
        for k, field in enumerate(fields):
            moved[:, 3 * k : 3 * k + self._dimension] = field
        moved *= np.float32(1.0 / self.scale)
        if not np.isfinite(moved).all():
            np.nan_to_num(moved, copy=False)
        drawn = moved if self._table is None else np.asarray(self._table @ moved)
        for (first, last, owner), ways in zip(self._tools, self._ways, strict=True):
            for k, slot in enumerate(slots):
                if slot != owner:
                    drawn[first:last, 3 * k : 3 * k + 3] = ways / self.scale
        np.rint(drawn, drawn)
        np.clip(drawn, -_MOST, _MOST, drawn)
        whole = drawn.astype("<i2")
        padding = b"\0" * (-6 * self.points % 4)
        return [whole[:, 3 * k : 3 * k + 3].tobytes() + padding for k in range(count)]


def _size(field: Single) -> float:
    """Greatest distance along an axis; 0 where it is no number, which a page couldn't draw."""
    size = float(np.abs(field).max(initial=0.0))
    return size if math.isfinite(size) else 0.0


def _about(view: CopyView, time: float) -> bytes:
    """What stands in front of a copy's points."""
    hand = view.hands[0] if view.hands else None
    flags = (DIRECT if view.direct else 0) | (HAS_HAND if hand is not None else 0)
    age = max(time - view.time, 0.0)
    ledger = (view.energy, view.supplied, view.lost, view.linked)
    if hand is None:
        mode = HAND_MODES.index("free")
        return COPY.pack(view.slot, mode, flags, 0, age, *_NOWHERE, *_NOWHERE, *_NOWHERE, 0.0, *ledger, -1, *_NOWHERE)
    vectors = (*hand.target.tolist(), *hand.place.tolist(), *hand.force.tolist())
    count = min(len(view.hands), 255)
    mode, edge = HAND_MODES.index(hand.mode), hand.edge.tolist()
    return COPY.pack(view.slot, mode, flags, count, age, *vectors, hand.radius, *ledger, hand.node, *edge)
