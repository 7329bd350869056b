"""The figure of an audit: what users put in, and what links made beside what the damping took."""

from pathlib import Path
from typing import TYPE_CHECKING

from cotouch import drawing
from cotouch.files import write
from cotouch.recording._audited import Audit

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def audit_figure(result: Audit) -> "Figure":
    """Draws the energy of an audit over time."""
    with drawing.style():
        figure = drawing.sheet(4.2)
        above, below = figure.subplots(2, 1, sharex=True)
        margin = result.supplied + result.initial
        scale, unit = drawing.prefix(drawing.peak(margin), "J")
        above.plot(*drawing.decimate(result.time, margin / scale), color=drawing.USERS[0])
        above.axhline(0.0, color=drawing.ALARM_COLOUR, linewidth=0.8)
        above.set(
            ylabel=unit,
            title="Energy put in by all users, with what was there at the start: passive if never below zero",
        )
        scale, unit = drawing.prefix(drawing.peak(result.made, result.taken), "J")
        below.plot(*drawing.decimate(result.time, result.made / scale), color=drawing.USERS[1], label="added by links")
        below.plot(
            *drawing.decimate(result.time, result.taken / scale), color=drawing.USERS[2], label="taken by their damping"
        )
        below.set(
            ylabel=unit,
            xlabel="time [s]",
            title="Added by the age of samples, and taken by the damping of the synchronisation",
        )
        below.legend(loc="upper left")
    return figure


def save_audit_figures(result: Audit, folder: Path) -> list[Path]:
    """Writes the figure into a folder as PNG, whole or not at all.

    Args:
        result: the audit.
        folder: to write into.

    Raises:
        OutputError: it cannot be written.
    """
    target = folder / "audit.png"
    write(target, drawing.drawn(audit_figure(result), dpi=200), "figure")
    return [target]
