"""How a function becomes a kernel."""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

from cotouch.compiled import stamped

F = TypeVar("F", bound=Callable[..., Any])


def kernel(function: F) -> F:
    """Compiles a function on first call, keeps the machine code on disk, and keeps its Python signature for readers.

    A product and the sum it feeds may be contracted into one rounding; nothing else of IEEE arithmetic is given up,
    because NaN and infinity must stay visible.

    Kernels are inlined into each other and allocate nothing, so numba's reference counting is off: for a point body
    the calls and counts cost ten times more than the physics.
    """
    njit: Any = numba.njit
    return stamped(
        njit(cache=True, nogil=True, fastmath={"contract"}, error_model="numpy", forceinline=True, _nrt=False)(function)
    )


def block(function: F) -> F:
    """A kernel that is called rather than inlined: for what is long, or does not run in every step."""
    njit: Any = numba.njit
    return stamped(njit(cache=True, nogil=True, fastmath={"contract"}, error_model="numpy", _nrt=False)(function))
