from typing import Literal, overload

import numpy as np
import numpy.typing as npt
from scipy.sparse import csr_array

_Float = npt.NDArray[np.float64]
_Labels = npt.NDArray[np.int32]

@overload
def connected_components(
    csgraph: object, directed: bool = ..., connection: str = ..., *, return_labels: Literal[False]
) -> int: ...
@overload
def connected_components(
    csgraph: object, directed: bool = ..., connection: str = ..., return_labels: Literal[True] = ...
) -> tuple[int, _Labels]: ...
@overload
def breadth_first_order(
    csgraph: object, i_start: int, directed: bool = ..., *, return_predecessors: Literal[False]
) -> _Labels: ...
@overload
def breadth_first_order(
    csgraph: object, i_start: int, directed: bool = ..., return_predecessors: Literal[True] = ...
) -> tuple[_Labels, _Labels]: ...
def minimum_spanning_tree(csgraph: object, overwrite: bool = ...) -> csr_array: ...
def shortest_path(csgraph: object, method: str = ..., directed: bool = ..., *, unweighted: bool = ...) -> _Float: ...
