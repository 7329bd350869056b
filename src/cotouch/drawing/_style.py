"""One restrained style for all figures: colours, sheets, and legends of users."""

import io
import warnings
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final, Literal, TypeAlias, TypedDict

from cotouch.drawing._lines import escaped

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

Dash: TypeAlias = Literal["-"] | tuple[int, tuple[float, ...]]


class UserLine(TypedDict):
    """Colour and dashes of what belongs to a user."""

    color: str
    linestyle: Dash


INK: Final = "#24292f"
MUTED: Final = "#68707a"
GRID: Final = "#e4e7eb"
SHADE: Final = "#f3f5f8"
SURFACE: Final = "#ffffff"
ALARM_COLOUR: Final = "#b3261e"
# Okabe and Ito's colours, which colour-blind readers tell apart, without yellow and black; a second round is dashed.
USERS: Final = ("#0072b2", "#d55e00", "#009e73", "#c065a0", "#d99000", "#4aa5dd")
DASHES: Final[tuple[Dash, ...]] = ("-", (0, (4.0, 1.6)), (0, (1.2, 1.4)))

_TITLE_PAD: Final = 6.0

STYLE: Final[dict[str, object]] = {
    "font.family": "sans-serif",
    "font.size": 8.0,
    "text.color": INK,
    "axes.edgecolor": MUTED,
    "axes.facecolor": SURFACE,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.labelcolor": INK,
    "axes.labelsize": 8.0,
    "axes.linewidth": 0.6,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlecolor": INK,
    "axes.titlelocation": "left",
    "axes.titlesize": 8.5,
    "axes.titleweight": "bold",
    "axes.titlepad": _TITLE_PAD,
    "axes.xmargin": 0.0,
    "axes.ymargin": 0.12,
    "axes.formatter.use_mathtext": False,
    "axes.formatter.useoffset": False,
    "axes.unicode_minus": True,
    "figure.facecolor": SURFACE,
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "legend.fontsize": 7.5,
    "legend.frameon": False,
    "legend.handlelength": 1.6,
    "legend.columnspacing": 1.4,
    "legend.borderaxespad": 0.0,
    "lines.linewidth": 1.2,
    "lines.solid_capstyle": "round",
    "xtick.color": MUTED,
    "xtick.labelcolor": INK,
    "xtick.labelsize": 7.5,
    "xtick.major.width": 0.6,
    "xtick.major.size": 3.0,
    "ytick.color": MUTED,
    "ytick.labelcolor": INK,
    "ytick.labelsize": 7.5,
    "ytick.major.width": 0.6,
    "ytick.major.size": 3.0,
}

# Wide enough for a page, in inches.
WIDTH: Final = 7.2
# Letters that fit into one line of a legend, and the width of a mark in letters.
_LEGEND_LETTERS = 110
_MARK_LETTERS = 4


@contextmanager
def style() -> "Generator[None]":
    """Makes figures in this module's style; the settings of the caller come back afterwards."""
    import matplotlib as mpl

    with mpl.rc_context(STYLE):
        yield


def sheet(height: float, width: float = WIDTH) -> "Figure":
    """An empty figure, in inches, that belongs to nobody and needs no window.

    Args:
        height: in inches.
        width: in inches.
    """
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def drawn(figure: "Figure", *, dpi: float, format: str = "png") -> bytes:  # noqa: A002
    """A figure as the bytes of a file.

    Args:
        figure: to draw.
        dpi: points per inch.
        format: one that matplotlib knows.

    Raises:
        ValueError: there is no such format.
    """
    stream = io.BytesIO()
    with style(), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from font")  # of a name; a box stands for it
        figure.savefig(stream, format=format, dpi=dpi)
    return stream.getvalue()


def user_line(index: int) -> UserLine:
    """Colour and dashes of a user, the same in all figures."""
    return {"color": USERS[index % len(USERS)], "linestyle": DASHES[index // len(USERS) % len(DASHES)]}


def user_legend(axes: "Axes", names: Sequence[str]) -> None:
    """Rows above the axes, to the right, that say which line is whose; the axes' title moves up if they are long.

    Args:
        axes: to draw in.
        names: of the users.
    """
    marks, texts = _marks(names)
    columns = max(1, min(len(marks), int(_LEGEND_LETTERS / (max(map(len, texts)) + _MARK_LETTERS))))
    rows = -(-len(marks) // columns)
    axes.legend(marks, texts, loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=columns, **_ROW)
    if rows > 1 or len(marks) * (max(map(len, texts)) + _MARK_LETTERS) > _LEGEND_LETTERS / 2:
        axes.set_title(axes.get_title(loc="left"), pad=_TITLE_PAD + 12.0 * rows)


def figure_legend(figure: "Figure", names: Sequence[str]) -> None:
    """One row above all panels of a figure.

    Args:
        figure: to draw on.
        names: of the users.
    """
    marks, texts = _marks(names)
    figure.legend(marks, texts, loc="outside upper right", ncols=len(marks), **_ROW)


_ROW: Final = {"handlelength": 1.2, "handletextpad": 0.5, "columnspacing": 0.9}


def _marks(names: Sequence[str]) -> "tuple[list[Line2D], list[str]]":
    from matplotlib.lines import Line2D

    marks = [Line2D([], [], **user_line(i), linewidth=1.8) for i in range(len(names))]
    return [Line2D([], [], linestyle="none"), *marks], ["user", *map(escaped, names)]
