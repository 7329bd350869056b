"""The figures of a plan: networks side by side, one objective against another, and what more links bring and cost."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from cotouch import drawing
from cotouch.arrays import Bool, Float
from cotouch.errors import NetworkError
from cotouch.network import Network
from cotouch.units import user_number

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.typing import ColorType


_GOOD, _BAD, _OTHER = drawing.USERS[2], drawing.USERS[1], drawing.USERS[0]
# From here on delays are written in seconds.
_LONG_DELAY = 10.0
# More dots than this are a blot; their density is drawn instead.
_MOST_DOTS = 4000
# More links than this have no labels; and room above the highest point, for its label.
_MOST_LABELLED, _HEADROOM = 40, 0.2


def networks(cases: Sequence[tuple[str, Network]]) -> "Figure":
    """Draws networks side by side, as the paper's Fig. 4: the best choice of links beside the worst.

    A link is as wide as its spring is strong and has the colour of its round trip, on scales that all networks share;
    in bold its strength [N/m] unless all are alike, beside either end the delay of what arrives there. With more than
    ten users a link has its round trip alone, and with more than 40 links its colour.

    Args:
        cases: titles and networks, at least one.

    Raises:
        NetworkError: there are no cases.
    """
    if not cases:
        raise NetworkError("cases is empty; there must be at least one network to draw")
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LinearSegmentedColormap, LogNorm

    ends = [(network, a, b) for _, network in cases for a, b in network.links]
    trips = [float(network.delay[a, b] + network.delay[b, a]) for network, a, b in ends]
    longest = max((max(float(network.delay[a, b]), float(network.delay[b, a])) for network, a, b in ends), default=0.0)
    strongest = max((float(network.spring[a, b]) for network, a, b in ends), default=1.0)
    alike = len({float(network.spring[a, b]) for network, a, b in ends}) == 1
    many = max(network.size for _, network in cases) > drawing.MANY_USERS
    unit, letter = (1.0, "s") if longest >= _LONG_DELAY else (1e-3, "ms")
    quickest, slowest = min((t for t in trips if t > 0), default=1.0) / unit, max([*trips, 0.0]) / unit
    several = slowest > 1.001 * quickest
    labelled = not many or max(len(network.links) for _, network in cases) <= _MOST_LABELLED
    colors = LinearSegmentedColormap.from_list("trips", [drawing.USERS[0], "#9a6f9c", drawing.USERS[1]])
    norm = LogNorm(quickest, slowest) if several else None

    def color(seconds: float) -> "ColorType":
        return drawing.USERS[0] if norm is None else colors(float(norm(max(seconds / unit, quickest))))

    with drawing.style():
        columns = min(len(cases), 2)
        rows = -(-len(cases) // columns)
        width = drawing.WIDTH / 2 * (1.0 if columns > 1 else 1.25)
        figure = drawing.sheet(rows * 0.95 * width + 0.6, columns * width)
        panels: list[Axes] = list(figure.subplots(rows, columns, squeeze=False).flat)
        for panel in panels[len(cases) :]:
            panel.set_axis_off()
        for panel, (title, network) in zip(panels, cases, strict=False):
            drawing.network(
                panel,
                [_legible(name, user) for user, name in enumerate(network.users)],
                network.links,
                network.spring,
                network.delay,
                width=width,
                strongest=strongest,
                color=color,
                labelled=labelled,
                strengths=not alike,
                delay_unit=unit,
            )
            panel.set_title(title)
        springs = f"All springs {strongest:.4g} N/m." if alike else "Bold: strength / (N/m), width likewise."
        if many and not alike:
            springs = f"As wide as strong, up to {strongest:.4g} N/m."
        words = f"{springs} Small: " + (
            f"round trip / {letter}." if many else f"delay / {letter} of what arrives at that end."
        )
        if not labelled:
            words = springs
        if norm is not None:
            bar = figure.colorbar(
                ScalarMappable(norm, colors), ax=panels, location="bottom", shrink=0.5, aspect=45, pad=0.01
            )
            ticks = np.geomspace(quickest, slowest, 4)
            bar.set_ticks(ticks.tolist(), labels=[f"{tick:.2g}" if tick < 10 else f"{tick:.0f}" for tick in ticks])
            bar.ax.minorticks_off()
            bar.outline.set_visible(False)
            bar.set_label(f"Round trip / {letter}", fontsize=7.5)
        figure.supxlabel(words, fontsize=7.0, color=drawing.MUTED)
    return figure


def _legible(name: str, index: int) -> str:
    """A user's name, or the number where the figure's font lacks a letter of it."""
    from matplotlib.font_manager import FontProperties, findfont, get_font

    font = get_font(findfont(FontProperties()))
    return name if all(font.get_char_index(ord(letter)) for letter in name) else f"user {user_number(index)}"


def ranks(first: tuple[str, npt.ArrayLike], second: tuple[str, npt.ArrayLike]) -> "Figure":
    """Draws the places of all choices by one objective against their places by another.

    Args:
        first: name, with its unit as "Decay / (1/s)", and the values of all choices, of which smaller is better; inf
            is worst, NaN is left out. Choices with the same value share the mean of their places.
        second: likewise, of the same choices.

    Raises:
        NetworkError: there are not as many values of one as of the other, or fewer than two.
    """
    from scipy import stats

    names = [name for name, _ in (first, second)]
    values = [np.asarray(entry, dtype=np.float64).ravel() for _, entry in (first, second)]
    if values[0].size != values[1].size:
        raise NetworkError(
            f"{names[0]} has {values[0].size} values and {names[1]} has {values[1].size}; both must have the same "
            f"number"
        )
    known = ~(np.isnan(values[0]) | np.isnan(values[1]))
    values = [entry[known] for entry in values]
    count = values[0].size
    if count < 2:
        raise NetworkError(f"{count} choices have both values; there must be at least 2 to rank")
    places = [stats.rankdata(entry) for entry in values]
    varied = all(np.ptp(place) > 0 for place in places)
    rho = f"{np.corrcoef(places[0], places[1])[0, 1]:.2f}" if varied else "undefined"
    with drawing.style():
        figure = drawing.sheet(4.3, 4.6)
        panel: Axes = figure.subplots()
        panel.set_aspect("equal")
        panel.plot([1, count], [1, count], color=drawing.MUTED, linewidth=0.7, linestyle=(0, (2.0, 2.0)), zorder=1)
        if count > _MOST_DOTS:
            panel.hexbin(places[0], places[1], gridsize=60, cmap="Greys", bins="log", linewidths=0.0, zorder=0)
        else:
            size = 4.0 if count < 300 else 2.2
            panel.plot(places[0], places[1], "o", color=drawing.MUTED, markersize=size, alpha=0.55, markeredgewidth=0)
        for k, mark in enumerate(("o", "s")):
            short = names[k].split(" / ")[0]
            for word, color, index in (
                ("best", _GOOD, int(values[k].argmin())),
                ("worst", _BAD, int(values[k].argmax())),
            ):
                panel.plot(
                    places[0][index],
                    places[1][index],
                    mark,
                    color=color,
                    markersize=7.5 if k == 0 else 5.5,
                    markerfacecolor=drawing.SURFACE if k == 0 else color,
                    markeredgewidth=1.6 if k == 0 else 0.8,
                    linestyle="none",
                    zorder=3 + k,
                    label=f"{word} by {short}: places {places[0][index]:.4g} and {places[1][index]:.4g}",
                )
        margin = 0.04 * count
        panel.set(
            xlim=(1 - margin, count + margin),
            ylim=(1 - margin, count + margin),
            xlabel=f"Place by {names[0].split(' / ')[0]}, 1 is best",
            ylabel=f"Place by {names[1].split(' / ')[0]}, 1 is best",
            title=f"{count:,} choices: Spearman's ρ = {rho}",
        )
        figure.legend(loc="outside lower center", ncols=2, fontsize=7.0, handletextpad=0.3)
    return figure


def knee(
    links: npt.ArrayLike,
    objective: tuple[str, npt.ArrayLike],
    cost: tuple[str, npt.ArrayLike],
    *,
    chosen: int | None = None,
    bend: int | None = None,
    proved: Sequence[bool] = (),
) -> "Figure":
    """Draws what more links bring, and what they cost.

    Args:
        links: numbers of links.
        objective: name with its unit, as "Decay / (1/s)", and its value for the best choice with so many links.
        cost: likewise, of that choice.
        chosen: number of links to mark.
        bend: number of links at which more stop paying, if that is known.
        proved: whether each best is proved; those that are not have open marks. None given: all are.

    Raises:
        NetworkError: the lengths differ, nothing is given, or `chosen` or `bend` is not among the numbers of links.
    """
    from matplotlib.ticker import MaxNLocator

    names = [name for name, _ in (objective, cost)]
    count, *values = (np.asarray(entry, dtype=np.float64).ravel() for entry in (links, objective[1], cost[1]))
    sure = np.array(proved if len(proved) else [True] * count.size, dtype=np.bool_)
    if not count.size or not count.size == values[0].size == values[1].size == sure.size:
        raise NetworkError(
            f"links, objective, cost and proved have {count.size}, {values[0].size}, {values[1].size} and {sure.size} "
            "entries; all must have the same number, at least one"
        )
    for name, number in (("chosen", chosen), ("bend", bend)):
        if number is not None and number not in count:
            raise NetworkError(f"{name} is {number}; it must be one of the numbers of links")
    order = np.argsort(count)
    count, sure = count[order], sure[order]
    with drawing.style():
        figure = drawing.sheet(3.8, 4.8)
        panels: list[Axes] = list(figure.subplots(2, 1, sharex=True))
        for panel, name, entry, color in zip(panels, names, values, (_OTHER, _BAD), strict=True):
            _course(panel, name, count, entry[order], sure, color, chosen)
        panels[1].xaxis.set_major_locator(MaxNLocator(integer=True))
        panels[0].set_title("What more links bring")
        panels[1].set(title="What they cost", xlabel="Number of links")
        words = ["Open marks: best found, not proved."] * (not sure.all())
        if bend is not None:
            for panel in panels:
                panel.axvline(bend, color=drawing.MUTED, linewidth=1.0, zorder=0)
            words.insert(0, f"The line is at the knee, {bend} links.")
        if words:
            figure.supxlabel(" ".join(words), fontsize=7.0, color=drawing.MUTED)
        figure.align_ylabels(panels)
    return figure


def _course(panel: "Axes", name: str, count: Float, values: Float, sure: Bool, color: str, chosen: int | None) -> None:
    """One quantity over the numbers of links."""
    panel.plot(count, values, "-", color=color)
    for known, face in ((True, color), (False, drawing.SURFACE)):
        these = sure == known
        if these.any():
            panel.plot(
                count[these], values[these], "o", markersize=4.0, markerfacecolor=face, markeredgecolor=color, zorder=3
            )
    if chosen is not None:
        at = int(np.flatnonzero(count == chosen)[0])
        panel.axvline(chosen, color=drawing.MUTED, linewidth=0.7, linestyle=(0, (2.0, 2.0)), zorder=0)
        panel.plot(chosen, values[at], "o", markerfacecolor="none", markeredgecolor=color, markersize=9.0)
        side = "left" if at == 0 else "right" if at == count.size - 1 else "center"
        unit = name.partition(" / ")[2].strip("()")
        panel.annotate(
            f"{values[at]:.3g} {unit}".strip(),
            (chosen, values[at]),
            xytext=(0, 7),
            textcoords="offset points",
            ha=side,
            va="bottom",
            color=color,
            bbox={"boxstyle": "square,pad=0.1", "facecolor": drawing.SURFACE, "edgecolor": "none"},
        )
    panel.margins(x=0.05)
    panel.set_ylabel(name)
    # What has no unit is a share near 1, which a scale from 0 would flatten.
    bottom, top = float(values.min()), float(values.max())
    if " / " in name:
        bottom, top = min(0.0, bottom), max(0.0, top)
    room = _HEADROOM * (top - bottom or 1e-3 * abs(top) or 1.0)
    panel.set_ylim(bottom - (room / 2 if bottom != 0.0 else 0.0), top + room)
    if bottom < 0.0 and " / " in name:
        panel.axhline(0.0, color=drawing.ALARM_COLOUR, linewidth=0.8)
