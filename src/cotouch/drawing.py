"""What every figure of this package is made with: one restrained style, and the drawing of a network.

Nothing here knows what is drawn: numbers, names and colours come in, lines and texts go out.
"""

import io
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Final, NamedTuple, TypeAlias, cast, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D
    from matplotlib.typing import RcKeyType

Dash: TypeAlias = "str | tuple[int, tuple[float, ...]]"

INK: Final = "#24292f"
MUTED: Final = "#68707a"
GRID: Final = "#e4e7eb"
SHADE: Final = "#f3f5f8"
SURFACE: Final = "#ffffff"
ALARM: Final = "#b3261e"
# Okabe and Ito's colours, which colour-blind readers tell apart, without yellow and black; a second round is dashed.
USERS: Final = ("#0072b2", "#d55e00", "#009e73", "#c065a0", "#d99000", "#4aa5dd")
DASHES: Final[tuple[Dash, ...]] = ("-", (0, (4.0, 1.6)), (0, (1.2, 1.4)))

STYLE: Final[dict[str, Any]] = {
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
    "axes.titlepad": 6.0,
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

# Wide enough for a page, and so many points on a line as its pixels can show.
WIDTH: Final = 7.2
_POINTS = 1600
# What is beyond has long left the picture; drawing libraries overflow there.
_LARGEST = 1e100
# Upwards the plain unit with its power of ten says it better.
_PREFIXES = ((1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p"))
# Letters that fit into one line of a legend, and the width of a mark in letters.
_LEGEND_LETTERS = 110
_MARK_LETTERS = 4


@contextmanager
def style() -> "Generator[None]":
    """Makes figures in this module's style; the settings of the caller come back afterwards."""
    import matplotlib as mpl

    with mpl.rc_context(cast("dict[RcKeyType, Any]", STYLE)):
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
    with style():
        figure.savefig(stream, format=format, dpi=dpi)
    return stream.getvalue()


def user_line(index: int) -> dict[str, Any]:
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
        axes.set_title(axes.get_title(loc="left"), pad=STYLE["axes.titlepad"] + 12.0 * rows)


def figure_legend(figure: "Figure", names: Sequence[str]) -> None:
    """One row above all panels of a figure.

    Args:
        figure: to draw on.
        names: of the users.
    """
    marks, texts = _marks(names)
    figure.legend(marks, texts, loc="outside upper right", ncols=len(marks), **_ROW)


_ROW: Final[dict[str, Any]] = {"handlelength": 1.2, "handletextpad": 0.5, "columnspacing": 0.9}


def _marks(names: Sequence[str]) -> "tuple[list[Line2D], list[str]]":
    from matplotlib.lines import Line2D

    lines: list[dict[str, Any]] = [user_line(i) for i in range(len(names))]
    marks = [Line2D([], [], color=line["color"], linestyle=line["linestyle"], linewidth=1.8) for line in lines]
    return [Line2D([], [], linestyle="none"), *marks], ["user", *names]


def decimate(time: Float, values: Float, most: int = _POINTS) -> tuple[Float, Float]:
    """At most about `most` points of a line: the lowest and the highest of every bin, so that no peak is lost.

    What is not finite is left out, as nothing can be drawn there.

    Args:
        time: of the points.
        values: at them.
        most: points that are wanted.
    """
    known = np.isfinite(time) & (np.abs(values) < _LARGEST)  # a comparison with NaN is false
    time, values = time[known], values[known]
    if time.size <= most:
        return time, values
    edges = np.linspace(0, time.size, max(most // 2, 1) + 1).astype(np.int64)
    kept = {0, int(time.size) - 1}
    for a, b in pairwise(edges):
        kept |= {int(a + np.argmin(values[a:b])), int(a + np.argmax(values[a:b]))}
    index = np.array(sorted(kept), dtype=np.int64)
    return time[index], values[index]


def prefix(largest: float, unit: str) -> tuple[float, str]:
    """What to divide by so that numbers up to `largest` read well, and the unit with its prefix.

    Args:
        largest: number that is shown.
        unit: without prefix.
    """
    if not 0.0 < largest < _LARGEST:
        return 1.0, unit
    for factor, letter in _PREFIXES:
        if largest >= 0.999 * factor:
            return factor, letter + unit
    return _PREFIXES[-1][0], _PREFIXES[-1][1] + unit


def peak(*values: npt.ArrayLike) -> float:
    """Largest finite size among all values; 0 if there is none."""
    result = 0.0
    for value in values:
        array = np.abs(np.asarray(value, dtype=np.float64))
        array = array[np.isfinite(array) & (array < _LARGEST)]
        result = max(result, float(array.max(initial=0.0)))
    return result


def end_labels(axes: "Axes", places: list[float], texts: list[str], colors: list[str]) -> None:
    """Texts to the right of the axes near their lines' ends, moved apart where they would cover each other.

    Args:
        axes: to draw in.
        places: heights of the ends, in data.
        texts: at them.
        colors: of the texts.
    """
    if not texts:
        return
    low, high = axes.get_ylim()
    height = axes.get_window_extent().height * 72.0 / axes.get_figure(root=True).dpi  # pyright: ignore[reportOptionalMemberAccess]
    gap = min(9.0 / max(height, 1.0), 1.0 / len(texts))
    fractions = np.array([axes.transAxes.inverted().transform(axes.transData.transform((0.0, y)))[1] for y in places])
    fractions = np.clip(fractions, 0.0, 1.0)
    order = np.argsort(fractions, kind="stable")
    spread = fractions[order].copy()
    for k in range(1, spread.size):
        spread[k] = max(spread[k], spread[k - 1] + gap)
    # What was pushed over the top comes down again; the rest keeps its distance below it.
    spread[-1] = min(spread[-1], 1.0)
    for k in range(spread.size - 2, -1, -1):
        spread[k] = min(spread[k], spread[k + 1] - gap)
    for fraction, index in zip(spread, order, strict=True):
        axes.annotate(
            texts[index],
            (1.0, float(fractions[index])),
            xycoords="axes fraction",
            xytext=(1.025, float(fraction)),
            textcoords="axes fraction",
            va="center",
            ha="left",
            color=colors[index],
            fontsize=7.0,
            arrowprops={"arrowstyle": "-", "color": colors[index], "linewidth": 0.4, "shrinkA": 0, "shrinkB": 0},
            annotation_clip=False,
        )
    axes.set_ylim(low, high)


def network(
    axes: "Axes",
    users: Sequence[str],
    links: Sequence[tuple[int, int]],
    spring: Float,
    delay: Float,
    *,
    width: float,
    strongest: float,
    color: Callable[[float], Any],
    labelled: bool = True,
    strengths: bool = True,
    delay_unit: float = 1e-3,
) -> None:
    """Users on a circle; links as wide as they are stiff, coloured by their round trip.

    Labels of a link are its strength in bold and, beside either end, the delay of what arrives there. They stand where
    they cover least. With more than ten users a link has its round trip alone, unless that would cover something.

    Args:
        axes: where to draw; what was set of its limits is replaced.
        users: names.
        links: pairs of indices.
        spring: (N, N) N/m.
        delay: (N, N) s, entry [i][j] from j to i.
        width: of the axes, in inches; says how large a letter is beside a link.
        strongest: N/m, of the widest link.
        color: of a link, from its round trip [s].
        labelled: whether links have labels.
        strengths: whether their strengths are among them.
        delay_unit: s, of the delays that are written.
    """
    size = len(users)
    axes.set_axis_off()
    axes.set_aspect("equal")
    inside = max(map(len, users)) <= _SHORT_NAME
    span = 1.22 if inside else 1.5
    angles = np.pi / 2 - 2 * np.pi * np.arange(size) / size
    places = np.column_stack([np.cos(angles), np.sin(angles)])
    if inside:
        axes.set(xlim=(-span, span), ylim=(float(places[:, 1].min()) - 0.17, 1.17))
    else:
        around = span - 1.0 if size > MANY_USERS else 0.26
        axes.set(xlim=(-span, span), ylim=(float(places[:, 1].min()) - around, 1.0 + around))
    mark = (15.0 if labelled else 10.0) * min(1.0, 22.0 / size) if inside else 5.0
    for a, b in links:
        fraction = spring[a, b] / strongest
        axes.plot(
            *places[[a, b]].T,
            color=color(float(delay[a, b] + delay[b, a])),
            linewidth=(0.8 + 4.2 * fraction) * (1.0 if labelled else 0.7) * min(1.0, (MANY_USERS / size) ** 1.3),
            zorder=1,
        )
    for name, (x, y) in zip(users, places, strict=True):
        if inside:
            axes.plot(x, y, "o", color=SURFACE, markeredgecolor=INK, markersize=mark, zorder=3)
            font = (8.0 if labelled else 7.0) * min(1.0, 22.0 / size)
            axes.annotate(name, (x, y), ha="center", va="center", fontsize=font, zorder=4, color=INK)
        else:
            axes.plot(x, y, "o", color=INK, markeredgecolor=SURFACE, markersize=mark, zorder=3)
            side = "center" if abs(x) < 0.2 else "left" if x > 0 else "right"
            level = "center" if abs(x) >= 0.2 else "bottom" if y > 0 else "top"
            turn = 0.0
            if size > MANY_USERS:  # names side by side would cover each other: they stand outwards
                side, level = "left" if x >= 0.0 else "right", "center"
                turn = float(np.degrees(np.arctan2(y, x))) + (0.0 if x >= 0.0 else 180.0)
            axes.annotate(
                name,
                (x, y),
                (5.0 * x, 5.0 * y),
                textcoords="offset points",
                ha=side,
                va=level,
                rotation=turn,
                rotation_mode="anchor",
                fontsize=7.5 if size <= MANY_USERS else 6.5,
                zorder=4,
            )
    if labelled:
        points = 72.0 * width / (2.0 * span)
        texts = _link_texts(links, places, spring, delay, delay_unit, strengths=strengths)
        for text, place in _placed(texts, places, links, points, 0.5 * mark, thin=size > MANY_USERS):
            axes.annotate(
                text.text,
                (float(place[0]), float(place[1])),
                ha="center",
                va="center",
                fontsize=text.size,
                fontweight="bold" if text.bold else "normal",
                color=INK if text.bold else MUTED,
                bbox={"boxstyle": "round,pad=0.1", "facecolor": SURFACE, "edgecolor": "none"},
                zorder=2,
            )


# Letters of a name that fit into its circle, and users up to which every label is drawn.
_SHORT_NAME = 3
MANY_USERS: Final = 10


@final
class _Text(NamedTuple):
    """A label on a link: what it says, and where it may stand, the best places first."""

    text: str
    size: float
    bold: bool
    near: Float
    far: Float
    fractions: tuple[float, ...]


def _link_texts(
    links: Sequence[tuple[int, int]], places: Float, spring: Float, delay: Float, unit: float, *, strengths: bool
) -> list[_Text]:
    """What arrives at an end is written nearer to it than to the other; those have fewer places, so they come first."""

    def said(seconds: float) -> str:
        return f"{seconds / unit:.0f}" if seconds >= 1e3 * unit else f"{seconds / unit:.3g}"

    ends = tuple(0.15 + 0.02 * k for k in range(12))
    ends = (0.23, *sorted(ends, key=lambda fraction: abs(fraction - 0.23)))
    middle = tuple(sorted((0.36 + 0.02 * k for k in range(15)), key=lambda fraction: abs(fraction - 0.45)))
    if len(places) > MANY_USERS:
        return [_Text(said(delay[a, b] + delay[b, a]), 5.0, False, places[a], places[b], middle) for a, b in links]
    texts = [
        _Text(said(delay[near, far]), 6.0, False, places[near], places[far], ends)
        for a, b in links
        for near, far in ((a, b), (b, a))
    ]
    texts += [
        _Text(
            f"{spring[a, b]:.0f}" if spring[a, b] >= 10 else f"{spring[a, b]:.2g}",
            7.0,
            True,
            places[a],
            places[b],
            middle,
        )
        for a, b in links
        if strengths
    ]
    return texts


def _placed(
    texts: Sequence[_Text],
    places: Float,
    links: Sequence[tuple[int, int]],
    points: float,
    disc: float,
    *,
    thin: bool,
) -> Generator[tuple[_Text, Float]]:
    """Where the labels stand: one by one, each where it covers least of the other labels, circles and links.

    Args:
        texts: labels.
        places: (N, 2) of the users.
        links: pairs of indices.
        points: of a unit of `places`.
        disc: points, radius of a user's circle.
        thin: leave out a label that covers another or a circle.
    """
    boxes = np.zeros((0, 4))
    first, second = (places[[link[side] for link in links]] * points for side in (0, 1))
    for text in texts:
        half = np.array([0.29 * text.size * len(text.text) + 1.0, 0.42 * text.size + 1.0])
        best, least = None, np.inf
        for rank, fraction in enumerate(text.fractions):
            middle = points * (text.near + fraction * (text.far - text.near))
            apart = np.abs(boxes[:, :2] - middle) - boxes[:, 2:] - half
            covered = float(np.prod(np.clip(-apart, 0.0, None), axis=1).sum())
            gap = np.linalg.norm(np.clip(np.abs(points * places - middle) - half, 0.0, None), axis=1)
            covered += 10.0 * float(np.clip(disc + 1.0 - gap, 0.0, None).sum())
            if thin and covered > 0.0:
                continue
            cost = 4.0 * covered + 6.0 * _crossing(first, second, middle, half) + 0.4 * rank
            if cost < least:
                best, least = middle, cost
        if best is not None:
            boxes = np.vstack([boxes, [*best, *half]])
            yield text, best / points


def _crossing(first: Float, second: Float, middle: Float, half: Float) -> int:
    """How many lines from `first` to `second` go through a box, but for the one that it stands on."""
    way = second - first
    along = np.clip(((middle - first) * way).sum(axis=1) / (way * way).sum(axis=1), 0.0, 1.0)
    apart = np.abs(first + along[:, None] * way - middle)
    return int((apart < half).all(axis=1).sum()) - 1
