"""How a function becomes a compiled kernel, and how its cache on disk stays true."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numba

F = TypeVar("F", bound=Callable[..., Any])

_PACKAGE = Path(__file__).parent.parent


def _newest_source() -> tuple[float, int]:
    """Stamp of the sources of every kernel: newest modification time, total size."""
    stats = [path.stat() for path in sorted(_PACKAGE.glob("*/_*.py"))]
    return max(stat.st_mtime for stat in stats), sum(stat.st_size for stat in stats)


_STAMP = _newest_source()


def kernel(function: F) -> F:
    """Compiles a function on first call, keeps the machine code on disk, and keeps its Python signature for readers.

    A product and the sum it feeds may be contracted into one rounding; nothing else of IEEE arithmetic is given up,
    because NaN and infinity must stay visible.

    Kernels are inlined into each other and allocate nothing, so numba's reference counting is off: for a point body
    the calls and counts cost ten times more than the physics.

    numba checks only the file of the function itself when it reads its cache, so a kernel that calls one of another
    file would go on running old physics after an edit there. The stamp therefore covers the sources of all of them.
    """
    njit: Any = numba.njit
    compiled = njit(cache=True, nogil=True, fastmath={"contract"}, error_model="numpy", forceinline=True, _nrt=False)(
        function
    )
    cache_file = getattr(getattr(compiled, "_cache", None), "_cache_file", None)
    if cache_file is not None and hasattr(cache_file, "_source_stamp"):
        cache_file._source_stamp = _STAMP
    return compiled
