# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownParameterType=false
# numba has no types
"""What a contact law is: the energy that a tool's overlap with a skin holds, one file for each law."""
# An overload's parameters only name those of its stub, and it returns a function whose names are the same.
# ruff: noqa: ARG001, PLW0108
# pyright: reportMissingParameterType=false, reportAttributeAccessIssue=false, reportUnusedFunction=false

from collections.abc import Callable
from typing import Any

from numba.core import types
from numba.extending import overload

from cotouch.mechanics._contact_laws import _foundation as foundation
from cotouch.mechanics._contact_laws import _stiffening as stiffening

# The registry: a law, and what evaluates it. A *law* is a NamedTuple of numbers that all tools share, with a default
# for each, and one compiled function.
#
# `press(law, stiffness, radius, depth)` returns for one point of the skin the energy of each unit of area, its first
# and its second derivative with respect to depth. Depth is `(R² - r²) / (2 R)`, r the distance to the middle of the
# tool: 0 on the tool's surface, R / 2 in its middle. All three are at least 0, and the first two vanish at depth 0.
# Four points are worked out at once, so depth may be a vector of four: sums, products, quotients and whole powers.
# Where energy is a polynomial in depth of up to the third degree, the sum over the skin is exact.
CONTACT_LAWS: dict[type, Callable[..., Any]] = {
    foundation.Foundation: foundation.press,
    stiffening.Stiffening: stiffening.press,
}


def press(law: Any, stiffness: float, radius: float, depth: float) -> tuple[float, float, float]:
    """Energy, pressure and slope of any law [J/m², Pa, Pa/m]. Kernels only.

    Args:
        law: one of `CONTACT_LAWS`.
        stiffness: k of the tool [N/m].
        radius: of the tool [m].
        depth: of the point in the tool, > 0 [m].
    """
    del law, stiffness, radius, depth
    raise NotImplementedError


@overload(press, jit_options={"forceinline": True})
def _press(law, stiffness, radius, depth):  # numba compares the names with the stub's
    found = CONTACT_LAWS.get(law.instance_class) if isinstance(law, types.BaseNamedTuple) else None
    if found is None:
        return None
    return lambda law, stiffness, radius, depth: found(law, stiffness, radius, depth)
