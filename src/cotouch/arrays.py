"""Names of array types, and what is said of arrays."""

from collections.abc import Iterable
from typing import Any, cast

import numpy as np
import numpy.typing as npt

Float = npt.NDArray[np.float64]
Single = npt.NDArray[np.float32]
Complex = npt.NDArray[np.complex128]
Int = npt.NDArray[np.int32]
Long = npt.NDArray[np.int64]
Bool = npt.NDArray[np.bool_]
Index = npt.NDArray[np.intp]
Array = npt.NDArray[Any]


def extents(shape: Iterable[int]) -> str:
    """A shape in words, as errors tell it.

    Args:
        shape: of an array; (): of a number.
    """
    return " x ".join(map(str, shape)) or "a single number"


def has_truth(values: object) -> bool:
    """Whether true or false stands in place of a number, for which Python takes it.

    Args:
        values: a number, or lists of them.
    """
    if isinstance(values, list | tuple):
        return any(map(has_truth, cast("Iterable[object]", values)))
    return isinstance(values, bool)
