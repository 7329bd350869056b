import numpy as np
import numpy.typing as npt

class _T:
    def ppf(self, q: float, df: float) -> float: ...

t: _T

class _Significance:
    statistic: float
    pvalue: float

def spearmanr(a: npt.ArrayLike, b: npt.ArrayLike) -> _Significance: ...
def rankdata(a: npt.ArrayLike, method: str = ...) -> npt.NDArray[np.float64]: ...
