"""How a function becomes machine code, and how its cache on disk stays true."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numba

F = TypeVar("F", bound=Callable[..., Any])

_PACKAGE = Path(__file__).parent
# Those that have kernels: an edit elsewhere need not compile them anew.
_ROOMS = ("device", "mechanics", "network", "planning", "scenario", "simulation")


def _newest_source() -> tuple[float, int]:
    """Stamp of the sources of every kernel: newest modification time, total size."""
    stats = [path.stat() for room in _ROOMS for path in sorted((_PACKAGE / room).glob("_*.py"))]
    return max(stat.st_mtime for stat in stats), sum(stat.st_size for stat in stats)


_STAMP = _newest_source()


def routine(function: F) -> F:
    """Compiles a function on first call and keeps the machine code on disk; it may allocate, and holds no lock."""
    njit: Any = numba.njit
    return stamped(njit(cache=True, nogil=True, error_model="numpy")(function))


def subroutine(function: F) -> F:
    """A routine that only routines call. What lets Python call one takes its share of the compilation's time."""
    njit: Any = numba.njit
    options = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    return stamped(njit(cache=True, nogil=True, error_model="numpy", **options)(function))


def stamped(compiled: Any) -> Any:
    """The compiled function, its cache on disk bound to the sources of the whole package.

    numba checks only the file of the function itself when it reads its cache, so a function that calls one of another
    file would go on running old code after an edit there. The stamp therefore covers the sources of all of them.
    """
    cache_file = getattr(getattr(compiled, "_cache", None), "_cache_file", None)
    if cache_file is not None and hasattr(cache_file, "_source_stamp"):
        cache_file._source_stamp = _STAMP
    return compiled


def cold(compiled: Any) -> bool:
    """Whether the next call of a function compiles it, because neither memory nor the disk holds its machine code."""
    if getattr(compiled, "signatures", None):
        return False
    cache_file = getattr(getattr(compiled, "_cache", None), "_cache_file", None)
    return cache_file is not None and not cache_file._load_index()
