"""A live session as a table on the terminal."""

from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from cotouch.device import NOTICED_DRAG
from cotouch.members import LinkStatus, MemberState, SessionWatch, Status, law_felt, margin_of

# States of a link, so that a row of them can be read at a glance: mark, colour, what it means.
_MARKS = {
    "coupled": ("●", "green", "coupled"),
    "ready": ("◐", "yellow", "about to couple"),
    "guarded": ("○", "red", "guarded: held back until safe"),
    "waiting": ("·", "dim", "no samples arrive"),
    "keys": ("·", "dim", "connecting"),
}
# Heading, unit, whether it is text.
_COLUMNS = (
    ("user", "", True),
    ("linked to", "", True),
    ("age sum", "ms", False),
    ("budget", "ms", False),
    ("steps", "1/s", False),
    ("missed", "", False),
    ("apart", "mm", False),
    ("hand", "N", False),
    ("ledger", "error", False),
    ("damping", "margin", False),
)
_EVENTS = 5
_RECENT = 20.0  # [s]
_ROUND_OFF = 1e-9  # [J]
_SLOW = 0.9  # share of the wanted rate below which it is marked


def view(
    watch: SessionWatch, now: float, *, title: str, started: float, invitation: str | None = None
) -> RenderableType:
    """The session as it is now.

    Args:
        watch: what is seen of it.
        now: [s].
        title: of the session.
        started: when this began to watch [s].
        invitation: shown while nobody is there yet.
    """
    table = Table(title=f"{title} · {now - started:.0f} s", title_justify="left", title_style="bold", box=None)
    for name, unit, text in _COLUMNS:
        head = Text(name, style="bold").append(f"\n{unit}", style="dim")
        table.add_column(head, justify="left" if text else "right", no_wrap=True)
    for slot in sorted(watch.members):
        table.add_row(*_row(watch.members[slot], now))
    if not watch.members:
        how = f"; join with\n\n  cotouch join {invitation}\n" if invitation else ""
        return Group(Text(f"{title} · {now - started:.0f} s", style="bold"), Text(f"nobody has joined yet{how}"))
    known = [seen.status for seen in watch.members.values() if seen.status is not None]
    parts: list[RenderableType] = [table, Text(), _legend(known)]
    parts.append(Text(f"{balance(known)} {verdict(known, left=watch.left)}"))
    parts += [Text(text, style="bold red") for text in _not_recorded(watch)]
    recent = [event for event in watch.events if now - event.time < _RECENT][-_EVENTS:]
    parts += [Text(f"{event.time - started:6.1f} s  {event.text}", style="dim") for event in recent]
    return Group(*parts)


def _not_recorded(watch: SessionWatch) -> list[str]:
    """Whose recording stopped, as long as they are there."""
    failed = [seen for _, seen in sorted(watch.members.items()) if seen.status and seen.status.recording == "failed"]
    return [
        f"NOT RECORDED: {seen.entry.name}'s recording stopped"
        + (f": {seen.status.recording_failure}" if seen.status and seen.status.recording_failure else "")
        for seen in failed
    ]


def balance(known: Sequence[Status]) -> str:
    """Where the energy of the whole came from and went, in a sentence."""
    names = ("supplied", "linked", "rescaled", "lost", "energy", "initial")
    supplied, linked, shared, lost, stored, start = (sum(getattr(status, name) for status in known) for name in names)
    gave = [f"Hands {'put in' if supplied >= 0.0 else 'took out'} {abs(supplied):.4f} J"]
    if start > _ROUND_OFF:
        gave.append(f"{start:.4f} J was there at the start")
    gave.append(f"delays added {linked:.4f} J" if linked >= 0.0 else f"links took {-linked:.4f} J")
    if abs(shared) > _ROUND_OFF:
        gave.append(f"members joining and leaving {'added' if shared > 0.0 else 'took'} {abs(shared):.4f} J")
    return f"{', '.join(gave)}, damping took {lost:.4f} J; {stored:.4f} J is in the copies."


def verdict(known: Sequence[Status], *, left: bool) -> str:
    """Whether the whole is passive, in a sentence.

    Args:
        known: what those who are there say.
        left: whether somebody took a part of the ledger along.
    """
    margin = margin_of(known)
    if margin >= -_ROUND_OFF:
        return "Passive: nobody took out energy that nobody had put in."
    if left:
        return "Passivity cannot be judged: a user who left took part of the ledger along."
    return f"NOT PASSIVE: {-margin:.3g} J came out that nobody had put in."


def felt_words(known: Sequence[Status]) -> str:
    """Which law the links have, what energy of it is on its way, and what drag hands feel of it, in a sentence."""
    found = law_felt(known)
    if found is None:
        return ""
    said = [] if found.on_the_way is None else [f"{1e3 * found.on_the_way:.3g} mJ on its way"]
    values = (("measured", found.measured), ("predicted", found.predicted))
    drags = [f"{value:.2f} Ns/m {name}" for name, value in values if value is not None]
    said.append(f"felt drag {' and '.join(drags)}" if drags else "felt drag not known yet")
    return f"Law {found.law}: {'; '.join(said)} (people notice {NOTICED_DRAG:.1f} Ns/m)."


def traffic_words(known: Sequence[Status]) -> str:
    """What all members together send, and what a codec saves of it, in a sentence; empty before they send."""
    links = [link for status in known for link in status.links]
    datagrams, size = sum(link.datagram_rate for link in links), sum(link.byte_rate for link in links)
    if size == 0.0:
        return ""
    full = sum(link.byte_rate / (1.0 - link.saved) for link in links if link.saved < 1.0)
    saved = f"; the codec saves {100.0 * (1.0 - size / full):.0f} %" if full > size else ""
    return f"Samples: {datagrams:,.0f} datagrams and {size / 1e3:,.1f} kB a second{saved}."


def _legend(known: Sequence[Status]) -> Text:
    """What the marks mean, of those that can be seen now, and the rest of the headings."""
    seen = {link.state for status in known for link in status.links} | {"coupled"}
    legend = Text()
    told: set[str] = set()
    for state, (mark, colour, meaning) in _MARKS.items():
        if state in seen and meaning not in told:
            told.add(meaning)
            legend.append(mark, style=colour).append(f" {meaning}   ", style="dim")
    if any(link.path_state == "relayed" for status in known for link in status.links):
        legend.append("~ through the relay   ", style="dim")
    for words in (felt_words(known), traffic_words(known)):
        if words:
            legend.append(f"\n{words}")
    for status in known:
        if status.unsent:
            away = "farther away than samples can tell, so neighbours hear nothing of it"
            legend.append(f"\nuser {status.slot + 1}: the copy is {away}", style="yellow")
        if status.closure_alarms:
            worst = f"{100.0 * status.closure_factor:.2g} %"
            off = f"forces and energy disagree in {status.closure_alarms:,} of {status.steps:,} steps, by up to {worst}"
            legend.append(f"\nuser {status.slot + 1}: {off}; shorter steps help", style="yellow")
    legend.append(
        "\nage sum: of the samples at both ends of a link; budget: age sum that the damping covers", style="dim"
    )
    return legend


def _row(seen: MemberState, now: float) -> list[str | RenderableType]:
    status = seen.status
    name = Text(f"{seen.entry.slot + 1} ", style="dim")
    name.append(seen.entry.name, style="dim" if seen.stale(now) else "bold")
    if status is None:
        return [name, Text("starting", style="dim")]
    marks = Text()
    for link in status.links:
        mark, colour, _ = _MARKS.get(link.state, ("?", "red", ""))
        marks.append(mark, style=colour).append(f"{link.slot + 1}{'~' if link.path_state == 'relayed' else ''} ")
    apart = max((link.difference for link in status.links if link.difference is not None), default=None)
    ages, budget = _ages(status.links)
    margin = status.damping_margin
    slow = status.nominal_period > 0.0 and status.rate < _SLOW / status.nominal_period
    return [
        name,
        marks,
        ages,
        budget,
        Text(f"{status.rate:.0f}", style="yellow" if slow else ""),
        f"{status.missed:,}",
        "" if apart is None else f"{1e3 * apart:.1f}",
        f"{status.force:.2f}",
        Text(f"{status.residual:.0e}", style="bold red" if status.alarms else "green"),
        "" if margin is None else Text(f"{100 * margin + 0.0:.0f} %", style="green" if margin >= -1e-9 else "bold red"),
    ]


def _ages(links: list[LinkStatus]) -> tuple[str, str]:
    """Greatest sum of both directions' ages of any link, and what is budgeted for it."""
    known = [(link.age_sum, link.budget) for link in links if link.age_sum is not None]
    if not known:
        return "", ""
    ages, budget = max(known, key=lambda pair: pair[0])
    return f"{1e3 * ages:.0f}", "" if budget is None else f"{1e3 * budget:.0f}"
