"""What machine vectors of four numbers can do, for functions that are run as they are written."""

from collections.abc import Callable
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
