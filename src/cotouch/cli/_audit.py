"""`cotouch audit`."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cotouch.cli._output import folder, number, print_json, working

if TYPE_CHECKING:
    from rich.table import Table

    from cotouch.recording import Audit, UserBooks


def run(files: Sequence[Path], *, figures: Path | None, tolerance: float | None, as_json: bool) -> bool:
    """Audits recordings of one session and prints what came out; returns whether all is accounted for."""
    from cotouch.recording import audit, read_recording, save_audit_figures

    if figures is not None:
        folder(figures)
    with working("Reading ...", quiet=as_json):
        recordings = [read_recording(file) for file in files]
    options = {} if tolerance is None else {"tolerance": tolerance}
    with working("Working the energy out anew ...", quiet=as_json):
        result = audit(recordings, **options)
    written: list[Path] = []
    if figures is not None:
        with working("Drawing ...", quiet=as_json):
            written = save_audit_figures(result, figures)
    if as_json:
        print_json({**result.numbers(), "files": [str(file) for file in written]})
    else:
        _print(result, written)
    return result.holds


def _print(result: "Audit", written: Sequence[Path]) -> None:
    from rich.console import Console
    from rich.markup import escape

    console = Console()
    console.print(_users(result))
    if result.links:
        console.print(_links(result))
    for note in result.notes:
        console.print(f"  [yellow]•[/yellow] {escape(note)}", highlight=False, soft_wrap=True)
    for finding in result.findings:
        console.print(
            f"  [red]•[/red] at {finding.time:.4g} s, {number(finding.energy, 'J')}: {escape(finding.words)}",
            highlight=False,
            soft_wrap=True,
        )
    console.print(result.verdict, style="bold green" if result.holds else "bold red", highlight=False, markup=False)
    for file in written:
        console.print(f"  wrote {file}", highlight=False, soft_wrap=True)


def _users(result: "Audit") -> "Table":
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    table = Table(box=SIMPLE_HEAD, title="Energy of each user [J]", title_justify="left")
    table.add_column("")
    for books in result.users:
        table.add_column(books.name, justify="right")
    rows: list[tuple[str, Callable[[UserBooks], float]]] = [
        ("put in by hands and tools", lambda books: books.supplied),
        ("work of the links", lambda books: books.link_work),
        ("taken by the body's dampers", lambda books: 0.0 - books.body_loss),
        ("taken by damping B of the links", lambda books: 0.0 - books.local_loss),
        ("taken by extra damping B_e", lambda books: 0.0 - books.extra_loss),
        ("lost in contacts and grasps", lambda books: 0.0 - books.touch_loss),
        ("came with joining and leaving", lambda books: books.members),
        ("stored, more than at the start", lambda books: books.stored),
    ]
    for label, value in rows:
        values = [value(books) for books in result.users]
        if any(values) or "joining" not in label:
            table.add_row(label, *(number(entry) for entry in values))
    table.add_row("unexplained", *(number(books.residual, digits=2) for books in result.users))
    return table


def _links(result: "Audit") -> "Table":
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    names: dict[int, str] = {books.user: books.name for books in result.users}
    phases = list(dict.fromkeys(phase for books in result.links for phase in books.by_phase))
    table = Table(box=SIMPLE_HEAD, title="Energy of each link [J]", title_justify="left")
    table.add_column("link")
    headings: list[Any] = ["on the\nfirst", "on the\nsecond", "its\nspring", *(f"made,\n{phase}" for phase in phases)]
    for heading in (*headings, "damping\ntook", "most\nbeyond"):
        table.add_column(heading, justify="right")
    for books in result.links:
        one, two = (names[user] for user in books.ends)
        table.add_row(
            f"{one} - {two}",
            *(number(value) for value in (*books.work, books.spring)),
            *(number(books.by_phase.get(phase, 0.0)) for phase in phases),
            number(books.dissipated),
            number(books.excess, digits=2) if books.strict else "not judged",
        )
    return table
