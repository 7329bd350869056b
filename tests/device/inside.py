"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.device import _tables as tables
from cotouch.device._servo import tick

__all__ = ["tables", "tick"]
