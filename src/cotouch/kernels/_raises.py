"""Whether a function that somebody else wrote for a kernel raises: machine code has nobody to raise to."""

import dis
from collections.abc import Callable, Iterator
from types import CodeType, FunctionType


def raises(function: Callable[..., object]) -> str | None:
    """Where a function, or one that it calls, raises or asserts; None: nowhere.

    A step would go on with whatever was written so far.

    Args:
        function: compiled, or not.
    """
    for code in _codes(function, set()):
        line = code.co_firstlineno
        for step in dis.get_instructions(code):
            line = step.starts_line or line
            if step.opname in {"RAISE_VARARGS", "RERAISE"}:
                return f"{code.co_filename.rpartition('/')[2]}, line {line}"
    return None


def _codes(function: object, seen: set[int]) -> Iterator[CodeType]:
    """Of a function, and of those of the same author that it calls."""
    plain = getattr(function, "py_func", function)
    own = getattr(plain, "__module__", None) or ""
    if not isinstance(plain, FunctionType) or id(plain) in seen or own.partition(".")[0] in {"cotouch", "numba"}:
        return
    seen.add(id(plain))
    yield plain.__code__
    for name in plain.__code__.co_names:
        yield from _codes(plain.__globals__.get(name), seen)
    for cell in plain.__closure__ or ():
        yield from _codes(cell.cell_contents, seen)
