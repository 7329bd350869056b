"""What a body asks of its rest shape and masses."""

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Float, extents
from cotouch.body._checks import FARTHEST, positive
from cotouch.errors import BodyError

# Energies of what is heavier are no numbers [kg].
_HEAVIEST = 1e30


def rest_shape(rest: npt.ArrayLike) -> Float:
    try:
        shape = np.array(rest, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise BodyError(f"rest is not an array of positions ({error}); give n rows of 1 to 3 coordinates") from error
    if shape.ndim == 1:
        shape = shape[:, None]
    if shape.ndim != 2 or shape.shape[0] < 1 or not 1 <= shape.shape[1] <= 3:
        wanted = "n x d, with at least one node and d from 1 to 3"
        raise BodyError(f"rest is {extents(shape.shape)}; it must be {wanted}")
    bad = np.argwhere(~np.isfinite(shape))
    if bad.size:
        node, axis = bad[0]
        raise BodyError(f"rest[{node}, {axis}] is {shape[node, axis]}; every coordinate must be a finite number")
    far = np.argwhere(np.abs(shape) > FARTHEST)
    if far.size:
        node, axis = far[0]
        raise BodyError(f"rest[{node}, {axis}] is {shape[node, axis]:.4g} m; a body is within {FARTHEST:g} m")
    shape.setflags(write=False)
    return shape


def check_mass(mass: sp.csr_array, rows_per_node: int) -> None:
    """Refuses masses that are not positive, or larger than can be computed.

    Args:
        mass: M, (rows, rows) [kg].
        rows_per_node: axes of a node if each has a row of its own, else 1.
    """
    own = mass.diagonal()
    bad = np.flatnonzero(own <= 0.0)
    if bad.size:
        row = int(bad[0])
        node = row // rows_per_node + 1
        raise BodyError(f"node {node} has mass {own[row]:.9g} (mass[{row}, {row}]); every node needs a mass > 0")
    heavy = int(np.argmax(own))
    if own[heavy] > _HEAVIEST:
        node = heavy // rows_per_node + 1
        raise BodyError(f"node {node} has a mass of {own[heavy]:.3g} kg; at most {_HEAVIEST:g} kg can be computed")
    positive("mass", mass, strictly=True)


# Beyond these, what a force within the body leaves of the motion of all of it is lost to rounding. No solid is as fast
# on any mesh of a haptic object: sound crosses a tenth of a millimetre of diamond in 1e-8 s.
_FASTEST = 1e8  # [rad/s]
_SHORTEST = 1e-12  # [s]


def check_rates(mass: sp.csr_array, stiffness: sp.csr_array, damping: sp.csr_array, rows_per_node: int) -> None:
    """Refuses nodes that would swing, or stop, faster than can be computed.

    Args:
        mass: M, (rows, rows) [kg].
        stiffness: K, likewise [N/m].
        damping: B, likewise [Ns/m].
        rows_per_node: axes of a node if each has a row of its own, else 1.
    """
    own = mass.diagonal()
    with np.errstate(over="ignore"):  # infinite is too fast as well
        fast, damped = np.sqrt(stiffness.diagonal() / own), damping.diagonal() / own
    row = int(np.argmax(fast))
    if fast[row] > _FASTEST:
        raise BodyError(
            f"node {row // rows_per_node + 1} of {own[row]:.3g} kg has a stiffness of {stiffness.diagonal()[row]:.3g} "
            f"N/m to the others and would oscillate at {fast[row]:.3g} rad/s; at most {_FASTEST:g} can be computed: "
            "give less stiffness or more mass, or make the body rigid"
        )
    row = int(np.argmax(damped))
    if damped[row] * _SHORTEST > 1.0:
        raise BodyError(
            f"node {row // rows_per_node + 1} of {own[row]:.3g} kg has a damping of {damping.diagonal()[row]:.3g} Ns/m "
            f"to the others and would stop within {1.0 / damped[row]:.3g} s; at least {_SHORTEST:g} can be computed: "
            "give less damping or more mass"
        )
