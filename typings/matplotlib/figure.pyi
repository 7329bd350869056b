from collections.abc import Iterable, Sequence
from typing import IO, Any, Literal, overload

import numpy.typing as npt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colorbar import Colorbar
from matplotlib.colorizer import ColorizingArtist
from matplotlib.legend import Legend
from matplotlib.patches import Patch
from matplotlib.text import Text
from mpl_toolkits.mplot3d import Axes3D

_Shared = bool | Literal["none", "all", "row", "col"]

class SubFigure(Artist):
    dpi: float

class _Bar(Colorbar):
    ax: Axes
    outline: Patch
    def set_label(self, label: str, **kwargs: object) -> None: ...
    def set_ticks(self, ticks: Sequence[float], *, labels: Sequence[str] | None = ..., **kwargs: object) -> None: ...

class Figure(Artist):
    dpi: float
    def __init__(self, figsize: tuple[float, float] | None = ..., *, layout: str | None = ...) -> None: ...
    def add_artist(self, artist: Artist) -> Artist: ...
    def add_axes(self, rect: tuple[float, float, float, float], *, projection: Literal["3d"]) -> Axes3D: ...
    def align_ylabels(self, axs: Iterable[Axes] | None = ...) -> None: ...
    def colorbar(
        self, mappable: ScalarMappable | ColorizingArtist, *, ax: Axes | Iterable[Axes] | None = ..., **kwargs: object
    ) -> _Bar: ...
    def legend(self, handles: Iterable[Artist] = ..., labels: Iterable[str] = ..., **kwargs: object) -> Legend: ...
    def savefig(self, fname: IO[bytes] | IO[str], **kwargs: object) -> None: ...
    def set_layout_engine(self, layout: str | None = ...) -> None: ...
    @overload
    def subplots(self) -> Axes: ...
    @overload
    def subplots(
        self,
        nrows: int,
        ncols: int,
        *,
        sharex: _Shared = ...,
        sharey: _Shared = ...,
        squeeze: bool = ...,
        width_ratios: Sequence[float] | None = ...,
        height_ratios: Sequence[float] | None = ...,
    ) -> npt.NDArray[Any]: ...
    def supxlabel(self, t: str, **kwargs: object) -> Text: ...
    def text(self, x: float, y: float, s: str, **kwargs: object) -> Text: ...
