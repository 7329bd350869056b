"""A body's modes as planning takes them."""

import math

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.errors import NetworkError


def modes_table(mass: npt.ArrayLike, damping: npt.ArrayLike, stiffness: npt.ArrayLike) -> Float:
    """(modes, 3); scalars count for every mode.

    Args:
        mass: a number, or one for each body mode, > 0 [kg].
        damping: likewise, >= 0 [Ns/m].
        stiffness: likewise, >= 0 [N/m].
    """
    parts = [np.atleast_1d(np.asarray(part, dtype=np.float64)) for part in (mass, damping, stiffness)]
    try:
        modes = np.stack(np.broadcast_arrays(*parts), axis=-1)
    except ValueError:
        counts = ", ".join(str(part.size) for part in parts)
        raise NetworkError(
            f"mass, damping and stiffness have {counts} entries; give one of each, or one for each body mode"
        ) from None
    if modes.ndim != 2 or not modes.size:
        raise NetworkError("mass, damping and stiffness must be numbers, or lists with a number for each body mode")
    for column, (name, unit) in enumerate((("mass", "kg"), ("damping", "Ns/m"), ("stiffness", "N/m"))):
        for value in modes[:, column]:
            if not (math.isfinite(value) and (value > 0 if column == 0 else value >= 0)):
                right = "above 0" if column == 0 else "at least 0"
                raise NetworkError(f"{name} is {value:g} {unit}; it must be finite and {right}")
    return np.unique(modes, axis=0)


def own_drag(modes: Float) -> float:
    """Damping of the modes that move freely, or of all if none does, Ns/m: what the object adds to `Choice.drag`.

    Args:
        modes: as `modes_table` makes them.
    """
    free = modes[:, 2] == 0.0
    return float(modes[free if free.any() else slice(None), 1].max())
