"""`cotouch demo`: five people at one object, each a process of its own, on this machine."""

import math
import sys
import time
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, ExitStack, nullcontext
from pathlib import Path

from rich.console import Console
from rich.table import Table
from rich.text import Text

from cotouch.cli._output import literal, print_json
from cotouch.cli._progress import ProgressLine
from cotouch.cli._session import shown, stop_signals
from cotouch.cli._table import balance, felt_words, verdict
from cotouch.errors import SessionError
from cotouch.files import folder
from cotouch.members import SessionFile, Status
from cotouch.session import DemoOutcome, DemoSessionApi, all_move, demo_session, play

_COLUMNS = (
    ("user", ""),
    ("steps", ""),
    ("missed", ""),
    ("longest period", "ms"),
    ("by hand", "J"),
    ("by delays", "J"),
    ("damped", "J"),
    ("ledger", "error"),
)
_LOWERED = "While the damping was lowered, nothing was guaranteed"
_USERS = 5  # of the paper
_LINE_EVERY = 5.0  # where nobody looks at a terminal [s]


def run(
    *,
    file: Path | None,
    users: int | None,
    body: str | None,
    seconds: float | None,
    impair: Sequence[str],
    law: str | None,
    record: Path | None,
    headless: bool,
    as_json: bool,
    progress: ProgressLine,
    beside: Callable[[DemoSessionApi], AbstractContextManager[object]] | None = None,
) -> None:
    """Plays the demonstration and says how it went.

    Args:
        file: of a session that is played instead; None: the demonstration's own.
        users: how many; None: the paper's five.
        body: see `demo_session`; None: the cushion where there is something beside, else the paper's point.
        seconds: how long; None: until it is interrupted.
        impair: what the network does besides.
        law: of the links, as `demo_session` takes it; None: the default.
        record: folder for recordings.
        headless: whether to show no table.
        as_json: whether to print numbers.
        progress: says what takes time until there is something to see.
        beside: what goes on with the stage as long as there is one; a page's server, say.
    """
    for name, given in (("--users", users), ("--body", body), ("--impair", impair or None)):
        if file is not None and given is not None:
            raise SessionError(f"{name} is given, but {file} sets that itself; leave one of them out")
    body = body or ("point" if beside is None else "soft")
    told = [-float("inf")]
    quiet = headless or as_json
    draws: list[Callable[[], None]] = []
    if seconds is not None and math.isinf(seconds):
        raise SessionError("--duration is inf; it must be a finite number of seconds")
    if file is None:
        people = _USERS if users is None else users
        session = demo_session(users=people, body=body, seconds=seconds, impair=impair, law=law)
    else:
        session = SessionFile.read(file, law=law)
    if record is not None:
        folder(record)
    if not quiet:
        who = f"{session.slots} users, each in its own process" if session.slots > 1 else "one user"
        progress.tell(f"starting {who}; the first run compiles kernels")

    def each(api: DemoSessionApi, now: float) -> None:
        if not (draws or quiet or sys.stderr.isatty() or api.acted or all_move(api)):
            here = len(api.opened.host.watch.members)
            progress.say(f"starting the users: {here} of {session.slots} have joined")
            return
        if not draws:
            progress.end()
            table = shown(lambda: api.opened.host.watch, title=session.scenario.title, quiet=quiet)
            draws.append(display.enter_context(table))
        draws[0]()
        if not quiet and not sys.stderr.isatty() and now - told[0] > _LINE_EVERY:
            told[0] = now
            _line(api)

    with stop_signals() as stopped, ExitStack() as display:
        outcome = play(
            session,
            seconds=seconds,
            each=each,
            stopped=stopped,
            record=record,
            beside=beside or nullcontext,
            say=progress.say,
        )
    progress.end()
    for note in outcome.notes:
        sys.stderr.write(f"cotouch: {note}\n")
    if as_json:
        print_json(numbers(outcome))
    else:
        _print(outcome)
    if outcome.complaints:
        sys.exit(1)


def numbers(outcome: DemoOutcome) -> dict[str, object]:
    """The outcome for JSON."""
    return {
        "seconds": outcome.seconds,
        "supplied_j": outcome.supplied,
        "delays_added_j": outcome.linked,
        "damped_j": outcome.lost,
        "in_copies_j": outcome.energy,
        "residual": outcome.residual,
        "apart_m": outcome.apart,
        "missed_share": outcome.missed,
        "guarded": outcome.guarded,
        "complaints": outcome.complaints,
        "members": outcome.members,
    }


def _line(api: DemoSessionApi) -> None:
    """One line for a log."""
    members = api.opened.host.watch.members
    known = [seen.status for seen in members.values() if seen.status is not None]
    if known:
        sys.stderr.write(f"cotouch: {time.strftime('%H:%M:%S')} {len(members)} joined. {balance(known)}\n")


def _print(outcome: DemoOutcome) -> None:
    table = Table(title=f"\nAfter {outcome.seconds:.0f} s", title_justify="left", title_style="bold", box=None)
    for name, unit in _COLUMNS:
        head = Text(name, style="bold").append(f"\n{unit}", style="dim")
        table.add_column(head, justify="left" if name == "user" else "right", no_wrap=True)
    known: list[Status] = []
    for name, result in outcome.members.items():
        status = None if result is None else result["status"]
        if status is None:
            table.add_row(literal(name), Text("no result", style="red"))
            continue
        known.append(Status.model_validate(status))
        table.add_row(
            literal(name),
            f"{status['steps']:,}",
            f"{status['missed']:,}",
            f"{1e3 * status['longest_period']:.1f}",
            f"{status['supplied']:.4f}",
            f"{status['linked']:.4f}",
            f"{status['lost']:.4f}",
            f"{status['residual']:.0e}",
        )
    console = Console()
    console.print(table)
    console.print(
        f"\n{balance(known)} Linked copies ended within {1e3 * outcome.apart:.2f} mm of each other; once coupled, "
        f"links were {_guarded(outcome.guarded)}.",
        highlight=False,
    )
    console.print(felt_words(known), highlight=False, markup=False)
    if outcome.complaints:
        for complaint in outcome.complaints:
            console.print(f"[red]{literal(complaint)}[/red]", highlight=False)
    elif outcome.lowered:
        console.print(f"[yellow]{_LOWERED}; links added {outcome.linked:.4g} J in total.[/yellow]", highlight=False)
    else:
        console.print(f"[green]{verdict(known, left=outcome.left)}[/green]", highlight=False)


def _guarded(count: int) -> str:
    return {0: "never guarded", 1: "guarded once"}.get(count, f"guarded {count} times")
