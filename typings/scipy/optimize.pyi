from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

class OptimizeResult:
    x: npt.NDArray[np.float64]
    fun: float
    status: int
    success: bool
    message: str
    ineqlin: Any
    eqlin: Any
    lower: Any
    upper: Any

def linprog(
    c: npt.ArrayLike,
    A_ub: object = ...,
    b_ub: npt.ArrayLike | None = ...,
    A_eq: object = ...,
    b_eq: npt.ArrayLike | None = ...,
    bounds: object = ...,
    method: str = ...,
    options: dict[str, Any] | None = ...,
) -> OptimizeResult: ...
def brentq(
    f: Callable[[float], float], a: float, b: float, xtol: float = ..., rtol: float = ..., maxiter: int = ...
) -> float: ...
