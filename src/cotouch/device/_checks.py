"""Refuses numbers that are none, or out of range."""

from collections.abc import Sequence
from math import inf, isfinite

from cotouch.errors import DeviceError

Triple = tuple[float, float, float]


def need(
    name: str, value: float, *, least: float = 0.0, above: bool = False, most: float = inf, unit: str = ""
) -> None:
    """Refuses a number that is not finite or out of range.

    Args:
        name: of what is checked, for the message.
        value: the number.
        least: smallest that is right.
        above: whether `least` itself is wrong.
        most: largest that is right.
        unit: for the message.

    Raises:
        DeviceError: it is.
    """
    low = value > least if above else value >= least
    if isfinite(value) and low and value <= most:
        return
    bounds = f"{'above' if above else 'at least'} {least:g}" + (f" and at most {most:g}" if most < inf else "")
    raise DeviceError(f"{name} is {value:g}{' ' + unit if unit else ''}; it must be finite, {bounds}")


def triple(name: str, value: Sequence[float]) -> Triple:
    """Three finite numbers; one or two are padded by zeros.

    Args:
        name: of what is checked, for the message.
        value: the numbers.

    Raises:
        DeviceError: it is not one to three finite numbers.
    """
    try:
        numbers = [float(entry) for entry in value]
    except (TypeError, ValueError):
        numbers = []
    if not 1 <= len(numbers) <= 3 or not all(map(isfinite, numbers)):
        raise DeviceError(f"{name} is {value!r}; it must be one to three finite numbers")
    padded = [*numbers, 0.0, 0.0]
    return padded[0], padded[1], padded[2]
