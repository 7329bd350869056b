"""The style of all figures, and the drawing of a network.

Nothing here knows what is drawn: numbers, names and colours come in, lines and texts go out.
"""

from cotouch.drawing._lines import decimate, end_labels, escaped, peak, prefix
from cotouch.drawing._network import MANY_USERS, network
from cotouch.drawing._style import (
    ALARM_COLOUR,
    DASHES,
    GRID,
    INK,
    MUTED,
    SHADE,
    SURFACE,
    USERS,
    WIDTH,
    UserLine,
    drawn,
    figure_legend,
    sheet,
    style,
    user_legend,
    user_line,
)

__all__ = [
    "ALARM_COLOUR",
    "DASHES",
    "GRID",
    "INK",
    "MANY_USERS",
    "MUTED",
    "SHADE",
    "SURFACE",
    "USERS",
    "WIDTH",
    "UserLine",
    "decimate",
    "drawn",
    "end_labels",
    "escaped",
    "figure_legend",
    "network",
    "peak",
    "prefix",
    "sheet",
    "style",
    "user_legend",
    "user_line",
]
