"""The drawing of a network: users on a circle, and labels on their links where they cover least."""

from collections.abc import Callable, Generator, Sequence
from typing import TYPE_CHECKING, Final, NamedTuple, final

import numpy as np

from cotouch.arrays import Float

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.typing import ColorType

from cotouch.drawing._lines import escaped
from cotouch.drawing._style import INK, MUTED, SURFACE

# Letters of a name that fit into its circle, and users up to which every label is drawn.
_SHORT_NAME = 3
MANY_USERS: Final = 10
# Size of names that stand outwards, pt; a letter is about 0.6 of it wide.
_OUTWARDS = 6.5


def network(
    axes: "Axes",
    users: Sequence[str],
    links: Sequence[tuple[int, int]],
    spring: Float,
    delay: Float,
    *,
    width: float,
    strongest: float,
    color: Callable[[float], "ColorType"],
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
    if not inside and size > MANY_USERS:  # room for the longest name, which stands outwards
        room = 36.0 * width
        span = max(span, room / (room - min(5.0 + 0.6 * _OUTWARDS * max(map(len, users)), 0.5 * room)))
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
    for name, (x, y) in zip(map(escaped, users), places, strict=True):
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
                fontsize=7.5 if size <= MANY_USERS else _OUTWARDS,
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
