from collections.abc import Mapping
from contextlib import AbstractContextManager

import numpy as np
import numpy.typing as npt

class _Colormap:
    def __call__(self, X: npt.ArrayLike) -> npt.NDArray[np.float64]: ...

colormaps: Mapping[str, _Colormap]

def rc_context(rc: Mapping[str, object] | None = ...) -> AbstractContextManager[None]: ...
