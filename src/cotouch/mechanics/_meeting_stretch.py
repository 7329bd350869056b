"""In which other body a point's friction is stretched: a point may lie in several, and remembers one stretch.

It is that of the body in which it lies deepest at the end of a step; what it was stretched by in others is lost then.
"""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.mechanics._kernel import inner
from cotouch.mechanics._vector import at


@inner
def mark_of(other: int, slips: float) -> float:
    """The fourth number of a stretch: in which body it is, and how far it has slipped there, up to 1; 0: none."""
    return 2.0 * other + 2.0 + slips


@inner
def stretched_in(memory: Float, here: int) -> int:
    """In which body a stretch is; negative: there is none."""
    return int(0.5 * at(memory, here + 3)) - 1


@inner
def stretch_in(memory: Float, here: int, other: int) -> tuple[float, float, float, float]:
    """A point's stretch in one of the bodies [m], and how far it has slipped there, see `pressed`."""
    if stretched_in(memory, here) != other:
        return 0.0, 0.0, 0.0, 0.0
    slips = at(memory, here + 3) - mark_of(other, 0.0)
    return at(memory, here), at(memory, here + 1), at(memory, here + 2), slips
