"""Names that every module of this room uses."""

from typing import TypeAlias

# Two users by index, the smaller first.
Pair: TypeAlias = tuple[int, int]
