"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.body._cells import LEAST_FILL, carriers, cells_of
from cotouch.body._checks import plausible, square
from cotouch.body._inertia import inertia_excess
from cotouch.body._repair import Shells, repaired
from cotouch.body._statics import _dissect as dissect

__all__ = [
    "LEAST_FILL",
    "Shells",
    "carriers",
    "cells_of",
    "dissect",
    "inertia_excess",
    "plausible",
    "repaired",
    "square",
]
