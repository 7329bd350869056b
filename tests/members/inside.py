"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.members._keys import KeyExchange
from cotouch.members._shared_cuts import TOPIC, SharedCuts, Statement
from cotouch.members._succession import MOST_LEAP, Belief, acting, order_of, signed
from cotouch.members._totals import Totals

__all__ = [
    "MOST_LEAP",
    "TOPIC",
    "Belief",
    "KeyExchange",
    "SharedCuts",
    "Statement",
    "Totals",
    "acting",
    "order_of",
    "signed",
]
