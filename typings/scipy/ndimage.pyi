from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

_Float = npt.NDArray[np.float64]

def map_coordinates(input: _Float, coordinates: Sequence[_Float], *, order: int = ..., mode: str = ...) -> _Float: ...
