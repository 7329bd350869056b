"""How a function becomes a kernel."""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

from cotouch.compiled import stamped

F = TypeVar("F", bound=Callable[..., object])

# A block of at least so many of LLVM's instructions is compiled once and called by its symbol. With smaller ones a run
# with a device would take twice as long.
_LARGE = 1000


def kernel(function: F) -> F:
    """Compiles a function on first call, keeps the machine code on disk, and keeps its Python signature for readers.

    A product and the sum it feeds may be contracted into one rounding; nothing else of IEEE arithmetic is given up,
    because NaN and infinity must stay visible.

    Kernels are inlined into each other and allocate nothing, so numba's reference counting is off: for a point body
    the calls and counts cost ten times more than the physics.
    """
    return stamped(_numba(forceinline=True)(function))


def inner(function: F) -> F:
    """A kernel that only kernels call. What lets Python call one costs a second of compilation with many arrays."""
    return stamped(_numba(forceinline=True, no_cpython_wrapper=True)(function))


def block(function: F) -> F:
    """A kernel that stays a function of its own, because it is large or does not run in every step."""
    return stamped(_numba(forceinline=False)(function), apart=_LARGE)


def part(function: F) -> F:
    """A `block` that only kernels call."""
    return stamped(_numba(forceinline=False, no_cpython_wrapper=True)(function))


def outlined(function: F) -> F:
    """A `part` that others call by its symbol or its address, however small it is."""
    return stamped(_numba(forceinline=False, no_cpython_wrapper=True)(function), apart=1)


def _numba(**options: bool) -> Callable[[F], Any]:
    njit: Any = numba.njit
    return njit(nogil=True, fastmath={"contract"}, error_model="numpy", _nrt=False, no_cfunc_wrapper=True, **options)
