"""What is said of budgets: changed on its way, or made up."""

import struct
from collections.abc import Iterator

import numpy as np

from cotouch.samples import BudgetAgreement

# Magic, own life, other's life, own number, other's number, what is asked for and what is granted (NaN: nothing).
_MESSAGE = struct.Struct("<4sQQIIdd")


def with_amounts(message: bytes, ask: float | None, grant: float | None) -> bytes:
    """The same, asking and granting something else; None: what it does."""
    *head, asked, granted = _MESSAGE.unpack(message)
    return _MESSAGE.pack(*head, asked if ask is None else ask, granted if grant is None else grant)


def made_up(rng: np.random.Generator) -> Iterator[bytes]:
    """One with numbers of any size, and one that is none."""
    honest = BudgetAgreement(life=1).message(0.0)
    assert honest is not None
    numbers = (int(rng.integers(0, 1 << 32)) for _ in range(4))
    yield _MESSAGE.pack(honest[:4], *numbers, 0.0, 0.0)[:-16] + rng.bytes(16)
    yield rng.bytes(_MESSAGE.size)
