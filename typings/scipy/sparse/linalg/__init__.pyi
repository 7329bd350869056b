from collections.abc import Callable
from typing import Any, Literal, TypeVar, overload

import numpy as np
import numpy.typing as npt
from scipy.sparse import csc_array, sparray

_Float = npt.NDArray[np.float64]

_Number = TypeVar("_Number", np.float64, np.complex128)

class LinearOperator:
    shape: tuple[int, int]
    def __init__(
        self,
        shape: tuple[int, int],
        matvec: Callable[[_Float], _Float],
        rmatvec: Callable[[_Float], _Float] | None = ...,
        matmat: Callable[[_Float], _Float] | None = ...,
        dtype: npt.DTypeLike | None = ...,
    ) -> None: ...

class SuperLU:
    shape: tuple[int, int]
    L: csc_array
    U: csc_array
    perm_r: npt.NDArray[np.int32]
    perm_c: npt.NDArray[np.int32]
    def solve(self, rhs: _Float, trans: str = ...) -> _Float: ...

def splu(
    A: sparray,
    permc_spec: str | None = ...,
    diag_pivot_thresh: float | None = ...,
    relax: int | None = ...,
    panel_size: int | None = ...,
    options: dict[str, Any] | None = ...,
) -> SuperLU: ...
def spsolve(
    A: sparray, b: npt.NDArray[_Number], permc_spec: str | None = ..., use_umfpack: bool = ...
) -> npt.NDArray[_Number]: ...
def lsqr(
    A: object,
    b: _Float,
    damp: float = ...,
    atol: float = ...,
    btol: float = ...,
    conlim: float = ...,
    iter_lim: int | None = ...,
) -> tuple[_Float, int, int, float, float, float, float, float, float, _Float]: ...
@overload
def eigsh(
    A: object,
    k: int = ...,
    M: object = ...,
    sigma: float | None = ...,
    which: str = ...,
    v0: _Float | None = ...,
    ncv: int | None = ...,
    maxiter: int | None = ...,
    tol: float = ...,
    *,
    return_eigenvectors: Literal[False],
    Minv: object = ...,
    OPinv: object = ...,
    mode: str = ...,
    rng: object = ...,
) -> _Float: ...
@overload
def eigsh(
    A: object,
    k: int = ...,
    M: object = ...,
    sigma: float | None = ...,
    which: str = ...,
    v0: _Float | None = ...,
    ncv: int | None = ...,
    maxiter: int | None = ...,
    tol: float = ...,
    return_eigenvectors: Literal[True] = ...,
    Minv: object = ...,
    OPinv: object = ...,
    mode: str = ...,
    rng: object = ...,
) -> tuple[_Float, _Float]: ...
