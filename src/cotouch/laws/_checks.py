"""What machine code and runs take for granted of a law that somebody else wrote."""

from collections.abc import Callable
from math import isfinite, nan
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
