"""What machine code and runs take for granted of a law that somebody else wrote."""

import dis
from collections.abc import Callable, Iterator
from math import isfinite, nan
from types import CodeType, FunctionType
from typing import TypeVar

from cotouch.errors import NetworkError
from cotouch.installed import cause_of

R = TypeVar("R")


def worked_out(what: str, function: Callable[[], R]) -> R:
    """What a function of somebody else's gives, or why it fails, in a sentence.

    Args:
        what: it works out, for messages.
        function: to call.

    Raises:
        NetworkError: it fails.
    """
    try:
        return function()
    except Exception as error:  # what somebody wrote may be wrong in any way
        raise NetworkError(f"{what} cannot be worked out: {cause_of(error)} ({type(error).__name__})") from error


def factor(text: str) -> float | None:
    """2 of "2x"; None: it is no multiple.

    Args:
        text: that stands for a parameter.
    """
    try:
        found = float(text.removesuffix("x")) if text.endswith("x") else nan
    except ValueError:
        found = nan
    return found if isfinite(found) and found >= 0.0 else None


def raises(function: Callable[..., object]) -> str | None:
    """Where a function, or one that it calls, raises or asserts; None: nowhere.

    Machine code that a kernel calls has nobody to raise to: the step would go on with whatever was written so far.

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
