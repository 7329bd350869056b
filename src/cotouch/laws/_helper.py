"""What laws that are longer than two functions are written with."""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

F = TypeVar("F", bound=Callable[..., Any])


def helper(function: F) -> F:
    """Compiled with the law and not kept alone, because only a law's own machine code is bound to its file.

    Args:
        function: in the file of the law that calls it.
    """
    njit: Any = numba.njit
    return njit(nogil=True, fastmath={"contract"}, error_model="numpy", _nrt=False, forceinline=True)(function)
