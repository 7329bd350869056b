"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.simulation import _layout as layout
from cotouch.simulation._channel import draw, resent
from cotouch.simulation._coding import check_codec
from cotouch.simulation._memory import free_memory, needed, refuse_beyond
from cotouch.simulation._peers import _World as World
from cotouch.simulation._result import _UNITS as UNITS
from cotouch.simulation._timing import ages, elapsed, indexed, newest, ring_size, self_paced
from cotouch.simulation._tool_result import UNITS as TOOL_UNITS

__all__ = [
    "TOOL_UNITS",
    "UNITS",
    "World",
    "ages",
    "check_codec",
    "draw",
    "elapsed",
    "free_memory",
    "indexed",
    "layout",
    "needed",
    "newest",
    "refuse_beyond",
    "resent",
    "ring_size",
    "self_paced",
]
