"""Lines and numbers as a figure can show them: points, units, labels at ends."""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# So many points on a line as the pixels of a page can show.
_POINTS = 1600
# What is beyond has long left the picture; drawing libraries overflow there.
_LARGEST = 1e100
# Upwards the plain unit with its power of ten says it better.
_PREFIXES = ((1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p"))


def escaped(name: str) -> str:
    """A name as a figure shows it: signs of the dollar in it begin no formula, which would have to be a right one."""
    return name.replace("$", r"\$")


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
    places_in_order: list[int] = order.tolist()
    for fraction, index in zip(spread, places_in_order, strict=True):
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
