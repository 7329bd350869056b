"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.network._age_sums import age_sums_of
from cotouch.network._consensus import Mixing, consensus_loop, lifted_matrix
from cotouch.network._definite import definite, negatives
from cotouch.network._elimination import REGULAR, cut, evaluate, scratch
from cotouch.network._exact import exact_margin, sync_hermitian
from cotouch.network._gains import coefficients, damping_matrices
from cotouch.network._lags import cycle_period
from cotouch.network._resonance import _swift as swift
from cotouch.network._resonance import _thorough as thorough
from cotouch.network._returns import bend_of, excluded, turn_of
from cotouch.network._rightmost import count_right
from cotouch.network._windows import windows

__all__ = [
    "REGULAR",
    "Mixing",
    "age_sums_of",
    "bend_of",
    "coefficients",
    "consensus_loop",
    "count_right",
    "cut",
    "cycle_period",
    "damping_matrices",
    "definite",
    "evaluate",
    "exact_margin",
    "excluded",
    "lifted_matrix",
    "negatives",
    "scratch",
    "swift",
    "sync_hermitian",
    "thorough",
    "turn_of",
    "windows",
]
