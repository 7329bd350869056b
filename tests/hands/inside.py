"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.hands._motion import Mover, Wander
from cotouch.hands._turning import Turner, nearest_to, turned

__all__ = ["Mover", "Turner", "Wander", "nearest_to", "turned"]
