"""Numbers of an animation as text for its page: quantised, predicted, compressed.

Vertices take 16 bits for each coordinate, in equal steps over the box of all frames, so that none is off by more than
half a step. What moves smoothly is then predicted by a straight line through its last two frames; the small rests,
zigzag coded and split into low and high bytes, are what gzip is good at. All arithmetic is modulo 2^16, so nothing is
lost after the rounding. `page/src/animation/data.js` undoes it.
"""

import base64
import gzip
from typing import Final, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Array, Float, Single

Levels = npt.NDArray[np.uint16]

LEVELS: Final = 2**16 - 1
# Stronger settings of gzip take five times as long for 3 % less.
_EFFORT: Final = 6
_KINDS: Final = {"f4": "<f4", "f8": "<f8", "u4": "<u4"}


@final
class Packer:
    """Gathers arrays behind each other; `entries` says where each lies, for the page's header."""

    def __init__(self) -> None:
        self.entries: dict[str, dict[str, object]] = {}
        self._parts: list[bytes] = []
        self._size = 0

    def add(self, name: str, values: Array, kind: str) -> None:
        """An array as it is: "f4", "f8" or "u4", little-endian.

        Args:
            name: what messages call it.
            values: what was given.
            kind: of the numbers.
        """
        self._put(name, kind, values.shape, np.ascontiguousarray(values, dtype=_KINDS[kind]).tobytes())

    def add_quantised(self, name: str, values: Single) -> tuple[Float, Float]:
        """Places (frames, users, vertices, 3), stored by user and frame; returns the box's corner and step.

        Args:
            name: what messages call it.
            values: what was given.
        """
        low, step = box_of(values)
        frames, users, vertices, _ = values.shape
        lows = np.empty((users, frames, vertices, 3), dtype=np.uint8)
        highs = np.empty_like(lows)
        for user in range(users):
            rests = predicted(quantised(values[:, user], low, step))
            lows[user], highs[user] = rests & 0xFF, rests >> 8
        self._put(name, "q2", (users, frames, vertices, 3), lows.tobytes() + highs.tobytes())
        return low, step

    def text(self) -> str:
        """Everything as base64 of gzip; the same arrays give the same text."""
        return base64.b64encode(gzip.compress(b"".join(self._parts), _EFFORT, mtime=0)).decode("ascii")

    def _put(self, name: str, kind: str, shape: tuple[int, ...], data: bytes) -> None:
        self.entries[name] = {"kind": kind, "shape": list(shape), "offset": self._size}
        padded = data + bytes(-len(data) % 8)  # so that every array starts where a browser may look at it in place
        self._parts.append(padded)
        self._size += len(padded)


def box_of(values: Single) -> tuple[Float, Float]:
    """Lowest corner of the box around all places, and the step of each axis; 0 where the box is flat."""
    flat = values.reshape(-1, 3)
    low = flat.min(axis=0).astype(np.float64)
    return low, (flat.max(axis=0).astype(np.float64) - low) / LEVELS


def quantised(values: Single, low: Float, step: Float) -> Levels:
    """Number of the level next to each coordinate.

    Args:
        values: what was given.
        low: corner of the box [m].
        step: between two levels [m].
    """
    fraction = (values - low) / np.where(step > 0.0, step, 1.0)
    return np.rint(np.clip(fraction, 0.0, LEVELS)).astype(np.uint16)


def predicted(levels: Levels) -> Levels:
    """What a straight line through the two frames before misses, zigzag coded: 0, -1, 1, -2, ... as 0, 1, 2, 3, ..."""
    rests = levels.copy()
    rests[1:] -= levels[:-1]
    rests[2:] -= levels[1:-1] - levels[:-2]
    signed = rests.view(np.int16)
    return ((signed << 1) ^ (signed >> 15)).view(np.uint16)
