"""A live session as a table on the terminal."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import RenderableType

    from cotouch.session import LinkStatus, Seen, Watch

# States of a link, so that a row of them can be read at a glance.
_MARKS = {
    "coupled": ("●", "green"),
    "ready": ("◐", "yellow"),
    "guarded": ("○", "red"),
    "waiting": ("·", "dim"),
    "keys": ("·", "dim"),
}
_COLUMNS = ("user", "links", "age ms", "rate Hz", "late", "apart mm", "force N", "residual", "certificate")
_EVENTS = 5


def view(watch: "Watch", now: float, *, title: str, started: float, invitation: str | None = None) -> "RenderableType":
    """The session as it is now.

    Args:
        watch: what is seen of it.
        now: [s].
        title: of the session.
        started: when this began to watch [s].
        invitation: shown while nobody is there yet.
    """
    from rich.console import Group
    from rich.table import Table
    from rich.text import Text

    table = Table(title=f"{title} · {now - started:.0f} s", title_justify="left", title_style="bold", box=None)
    for name in _COLUMNS:
        table.add_column(name, justify="left" if name in {"user", "links"} else "right", header_style="dim")
    for seat in sorted(watch.members):
        table.add_row(*_row(watch.members[seat], now))
    parts: list[RenderableType] = [table]
    if not watch.members:
        parts.append(
            Text("nobody is here yet" + (f"; join with\n\n  cotouch join {invitation}\n" if invitation else ""))
        )
    else:
        parts.append(Text(f"\n{balance(watch)}"))
    recent = [event for event in watch.events if now - event.time < 20.0][-_EVENTS:]
    parts += [Text(f"{event.time - started:6.1f} s  {event.text}", style="dim") for event in recent]
    return Group(*parts)


def balance(watch: "Watch") -> str:
    """The energy of the whole in a sentence."""
    known = [seen.status for seen in watch.members.values() if seen.status is not None]
    supplied = sum(status.supplied for status in known)
    start = sum(status.initial for status in known)
    stored = sum(status.energy for status in known)
    lost = sum(status.lost for status in known)
    return f"the hands put in {supplied:.4g} J, {lost:.4g} J were damped, {stored:.4g} J are in the copies; " + (
        "passive so far" if supplied + start >= -1e-9 else f"{-supplied - start:.3g} J came from nowhere"
    )


def _row(seen: "Seen", now: float) -> list["str | RenderableType"]:
    from rich.text import Text

    status = seen.status
    name = Text(seen.entry.name, style="dim" if seen.stale(now) else "bold")
    if status is None:
        return [name, "starting"]
    marks = Text()
    for link in status.links:
        mark, colour = _MARKS.get(link.state, ("?", "red"))
        marks.append(f"{mark}{link.seat + 1}{'~' if link.way == 'relayed' else ''} ", style=colour)
    apart = max((link.difference for link in status.links if link.difference is not None), default=None)
    margin = status.certificate
    colour = "green" if margin is None or margin >= 0.0 else "red"
    return [
        name,
        marks,
        _ages(status.links),
        f"{status.rate:.0f}",
        f"{status.missed}",
        "" if apart is None else f"{1e3 * apart:.1f}",
        f"{status.force:.2f}",
        Text(f"{status.residual:.0e}", style="bold red" if status.alarms else ""),
        "" if margin is None else Text(f"{100 * margin:+.0f} %", style=colour),
    ]


def _ages(links: "list[LinkStatus]") -> str:
    """Greatest sum of both directions' ages of any link, and what is budgeted for it."""
    known = [(link.ages, link.budget) for link in links if link.ages is not None]
    if not known:
        return ""
    ages, budget = max(known, key=lambda pair: pair[0])
    return f"{1e3 * ages:.0f}" + ("" if budget is None else f" / {1e3 * budget:.0f}")
