"""What is said of budgets: changed on its way, or made up."""

from collections.abc import Iterator

import numpy as np

from cotouch.samples._budget import _MAGIC, _MESSAGE


def with_amounts(message: bytes, ask: float | None, grant: float | None) -> bytes:
    """The same, asking and granting something else; None: what it does."""
    *head, asked, granted = _MESSAGE.unpack(message)
    return _MESSAGE.pack(*head, asked if ask is None else ask, granted if grant is None else grant)


def made_up(rng: np.random.Generator) -> Iterator[bytes]:
    """One with numbers of any size, and one that is none."""
    head = _MESSAGE.pack(_MAGIC, *(int(rng.integers(0, 1 << 32)) for _ in range(4)), 0.0, 0.0)[:-16]
    yield head + rng.bytes(16)
    yield rng.bytes(_MESSAGE.size)
