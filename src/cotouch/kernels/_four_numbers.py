"""What machine vectors of four numbers can do, for functions that are run as they are written."""

from collections.abc import Callable
from math import sqrt
from typing import final


@final
class FourNumbers:
    """Stands for four numbers in a machine vector: what these cannot do, it cannot do either."""

    def __init__(self, value: float) -> None:
        """Four times the same number.

        Args:
            value: the number.
        """
        self.value = value

    def __pow__(self, power: float) -> "FourNumbers":
        if not isinstance(power, int):
            message = f"four numbers at once take whole powers only, not {power}"
            raise TypeError(message)
        return FourNumbers(self.value**power)

    def __bool__(self) -> bool:
        message = "it branches on what may be four numbers at once"
        raise TypeError(message)

    def __float__(self) -> float:
        message = (
            "a function of one number is asked for four at once; cotouch.kernels has root, size, lower, upper, where"
        )
        raise TypeError(message)

    def __neg__(self) -> "FourNumbers":
        message = "four numbers at once have no unary minus; subtract from 0.0"
        raise TypeError(message)


def _operator(name: str) -> Callable[[FourNumbers, "FourNumbers | float"], FourNumbers]:
    def apply(this: FourNumbers, other: FourNumbers | float) -> FourNumbers:
        number = other.value if isinstance(other, FourNumbers) else float(other)
        return FourNumbers(getattr(float(this.value), name)(number))

    return apply


for _name in ("add", "sub", "mul", "truediv"):
    for _side in (f"__{_name}__", f"__r{_name}__"):
        setattr(FourNumbers, _side, _operator(_side))


def _compared(this: FourNumbers, other: "FourNumbers | float") -> FourNumbers:  # noqa: ARG001
    return this


for _name in ("lt", "le", "gt", "ge"):
    setattr(FourNumbers, f"__{_name}__", _compared)


def _numbers(values: "tuple[FourNumbers | float, ...]") -> list[float]:
    return [value.value if isinstance(value, FourNumbers) else value for value in values]


def _as_they_are(function: Callable[..., float]) -> "Callable[..., FourNumbers | float]":
    """The same of numbers, and of what stands for four of them."""

    def apply(*values: FourNumbers | float) -> FourNumbers | float:
        found = function(*_numbers(values))
        return FourNumbers(found) if any(isinstance(value, FourNumbers) for value in values) else found

    return apply


def _size(number: float) -> float:
    return abs(number)


def _lower(left: float, right: float) -> float:
    return min(right, left)


def _upper(left: float, right: float) -> float:
    return max(right, left)


def _where(test: float, yes: float, no: float) -> float:
    return yes if test > 0.0 else no


# What machine vectors have functions of their own for; see `_vector.py`.
AS_WRITTEN: "dict[str, Callable[..., FourNumbers | float]]" = {
    "root": _as_they_are(sqrt),
    "size": _as_they_are(_size),
    "lower": _as_they_are(_lower),
    "upper": _as_they_are(_upper),
    "where": _as_they_are(_where),
}
