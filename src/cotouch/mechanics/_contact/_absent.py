"""What of a skin is not in the copy at hand: tools that are bodies, of other users."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import at, part, put
from cotouch.mechanics._model._fit import Fit
from cotouch.mechanics._model._surface import Surface


@part
def hide_away(surface: Surface, fit: Fit, memory: Float) -> None:
    """Notes which triangles are of tools that are not in the copy at hand.

    Args:
        surface: the skin.
        fit: result.
        memory: of the copy.
    """
    for f in range(surface.corner.shape[0] if surface.away.shape[0] > 0 else 0):
        mark = at(surface.away, f)
        if mark >= 0:
            put(fit.hidden, f, 1 if at(memory, mark) != 0.0 else 0)


@part
def is_held_away(surface: Surface, memory: Float, h: int) -> bool:
    """Whether what a grasp may hold is of a tool that is not in the copy at hand.

    Args:
        surface: the skin.
        memory: of the copy.
        h: what is held.
    """
    if surface.away.shape[0] == 0:
        return False
    mark = at(surface.away, surface.corner.shape[0] + h)
    return mark >= 0 and at(memory, mark) != 0.0
