"""What these tests take from inside the room."""

from cotouch.coupling._modulation import credit
from cotouch.coupling._toll import most_toll

__all__ = ["credit", "most_toll"]
