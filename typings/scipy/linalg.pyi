from typing import Literal, overload

import numpy as np
import numpy.typing as npt

_Float = npt.NDArray[np.float64]

@overload
def eigh(
    a: npt.ArrayLike,
    b: npt.ArrayLike | None = ...,
    *,
    lower: bool = ...,
    eigvals_only: Literal[True],
    subset_by_index: tuple[int, int] | list[int] | None = ...,
    check_finite: bool = ...,
    driver: str | None = ...,
) -> _Float: ...
@overload
def eigh(
    a: npt.ArrayLike,
    b: npt.ArrayLike | None = ...,
    *,
    lower: bool = ...,
    eigvals_only: Literal[False] = ...,
    subset_by_index: tuple[int, int] | list[int] | None = ...,
    check_finite: bool = ...,
    driver: str | None = ...,
) -> tuple[_Float, _Float]: ...
def eigvalsh(
    a: npt.ArrayLike,
    b: npt.ArrayLike | None = ...,
    *,
    subset_by_index: tuple[int, int] | list[int] | None = ...,
    check_finite: bool = ...,
) -> _Float: ...
def norm(a: npt.ArrayLike, ord: float | str | None = ...) -> float: ...
def qr(
    a: npt.ArrayLike, *, mode: Literal["economic"], pivoting: Literal[True]
) -> tuple[_Float, _Float, npt.NDArray[np.int32]]: ...
