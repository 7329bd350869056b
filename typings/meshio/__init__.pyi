from collections.abc import Sequence
from pathlib import Path

import numpy.typing as npt

class CellBlock:
    type: str
    data: npt.ArrayLike

class Mesh:
    points: npt.ArrayLike
    cells: list[CellBlock]
    point_sets: dict[str, npt.ArrayLike]
    # Of each block of cells; None where a set has none of it.
    cell_sets: dict[str, Sequence[Sequence[int] | None]]
    point_data: dict[str, npt.ArrayLike]
    cell_data: dict[str, list[npt.ArrayLike]]
    field_data: dict[str, tuple[int, int]]

def read(filename: str | Path, file_format: str | None = ...) -> Mesh: ...
