"""Names of array types."""

from typing import Any

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
