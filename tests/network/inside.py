"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.network._consensus import consensus_loop, lifted_matrix
from cotouch.network._definite import definite, negatives
from cotouch.network._elimination import REGULAR, cut, evaluate, scratch
from cotouch.network._resonance import _swift as swift
from cotouch.network._resonance import _thorough as thorough
from cotouch.network._returns import bend_of, excluded, turn_of
from cotouch.network._rightmost import count_right
from cotouch.network._windows import windows

__all__ = [
    "REGULAR",
    "bend_of",
    "consensus_loop",
    "count_right",
    "cut",
    "definite",
    "evaluate",
    "excluded",
    "lifted_matrix",
    "negatives",
    "scratch",
    "swift",
    "thorough",
    "turn_of",
    "windows",
]
