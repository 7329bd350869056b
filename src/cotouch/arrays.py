"""Names of array types."""

import numpy as np
import numpy.typing as npt

Float = npt.NDArray[np.float64]
