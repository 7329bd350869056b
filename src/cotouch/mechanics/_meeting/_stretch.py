"""In which other body a point's friction is stretched, and in how many it is: a point may lie in several.

It remembers one stretch, that of the body in which it lies deepest at the end of a step; what it was stretched by in
others is lost then.
"""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import at, inner, put

# A point is in fewer bodies at once than this.
_MANY = 1024


@inner
def mark_of(other: int, slips: float) -> float:
    """The fourth number of a stretch: in which body it is, and how far it has slipped there, up to 1; 0: none.

    Args:
        other: in which body.
        slips: how far, 0 to 1.
    """
    return 2.0 * _MANY * (other + 1.0) + slips


@inner
def stretched_in(memory: Float, here: int) -> int:
    """In which body a stretch is; negative: there is none.

    Args:
        memory: of the copy, (numbers,).
        here: where in it the stretch is.
    """
    return int(at(memory, here + 3)) // (2 * _MANY) - 1


@inner
def stretch_in(memory: Float, here: int, other: int) -> tuple[float, float, float, float]:
    """A point's stretch in one of the bodies [m], and how far it has slipped there, see `pressed`.

    Args:
        memory: of the copy, (numbers,).
        here: where in it the stretch is.
        other: which of the bodies.
    """
    if stretched_in(memory, here) != other:
        return 0.0, 0.0, 0.0, 0.0
    mark = at(memory, here + 3)
    slips = mark - 2.0 * (int(mark) // 2)
    return at(memory, here), at(memory, here + 1), at(memory, here + 2), slips


@inner
def within_of(memory: Float, here: int) -> int:
    """In how many bodies a point is, not asleep.

    Args:
        memory: of the copy, (numbers,).
        here: where in it the stretch is.
    """
    return int(at(memory, here + 3)) // 2 % _MANY


@inner
def put_within(memory: Float, here: int, within: int) -> None:
    """Adds that to the fourth number of a stretch.

    Args:
        memory: of the copy, in place.
        here: where in it the stretch is.
        within: in how many bodies the point is.
    """
    more = min(within, _MANY - 1) - within_of(memory, here)
    put(memory, here + 3, at(memory, here + 3) + 2.0 * more)
