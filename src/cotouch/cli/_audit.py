"""`cotouch audit`."""

from collections.abc import Callable, Sequence
from pathlib import Path

from rich.console import Console

from cotouch.cli._output import literal, number, print_columns, print_json, print_note, print_written, working
from cotouch.files import beside, folder
from cotouch.recording import Audit, LinkLedger, UserLedger, audit, read_recording, save_audit_figures


def run(files: Sequence[Path], *, figures: Path | None, tolerance: float | None, as_json: bool) -> bool:
    """Audits recordings of one session and prints what came out; returns whether all is accounted for.

    Args:
        files: the recordings.
        figures: folder for figures; None: none.
        tolerance: of the energy, as a share; None: the usual.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    if figures is not None:
        beside(folder(figures), ("audit.png",), files)
    with working("Reading ...", quiet=as_json):
        recordings = [read_recording(file) for file in files]
    options = {} if tolerance is None else {"tolerance": tolerance}
    with working("Recomputing the energy ...", quiet=as_json):
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


def _print(result: Audit, written: Sequence[Path]) -> None:
    console = Console()
    _users(console, result)
    if result.links:
        _links(console, result)
    console.print(_law(result), highlight=False)
    for note in result.notes:
        print_note(console, "yellow", literal(note))
    for finding in result.findings:
        said = f"at {finding.time:.4g} s, {number(finding.energy, 'J')}: {literal(finding.words)}"
        print_note(console, "red", said)
    console.print(result.verdict, style="bold green" if result.holds else "bold red", highlight=False, markup=False)
    print_written(console, written)


def _law(result: Audit) -> str:
    law = result.law
    said = [] if law.on_the_way is None else [f"{number(law.on_the_way, 'J')} still on its way"]
    said.append("felt drag unknown" if law.drag is None else f"felt drag {number(law.drag, 'Ns/m')}")
    return f"  Law {literal(law.name)}: {', '.join(said)}"


def _users(console: Console, result: Audit) -> None:
    rows: list[tuple[str, Callable[[UserLedger], float]]] = [
        ("put in by hands and tools", lambda ledger: ledger.supplied),
        ("added by links", lambda ledger: ledger.link_work),
        ("lost in the body's dampers", lambda ledger: 0.0 - ledger.body_loss),
        ("lost in the links' damping", lambda ledger: 0.0 - ledger.local_loss),
        ("lost in extra damping B_e", lambda ledger: 0.0 - ledger.extra_loss),
        ("lost in contacts and grasps", lambda ledger: 0.0 - ledger.touch_loss),
        ("change from joining and leaving", lambda ledger: ledger.members),
        ("increase in stored energy", lambda ledger: ledger.stored),
        ("work of closing steps, not in the sums", lambda ledger: ledger.closure),
    ]
    seldom = ("joining", "closing")
    rows = [row for row in rows if any(map(row[1], result.users)) or not any(word in row[0] for word in seldom)]
    columns = [
        (ledger.name, [*(number(value(ledger)) for _, value in rows), number(ledger.residual, digits=2)])
        for ledger in result.users
    ]
    print_columns(console, "Energy of each user [J]", [*(label for label, _ in rows), "unexplained"], columns)


def _links(console: Console, result: Audit) -> None:
    names: dict[int, str] = {ledger.user: ledger.name for ledger in result.users}
    states = list(dict.fromkeys(state for ledger in result.links for state in ledger.by_state))
    columns: list[tuple[str, Callable[[LinkLedger], str]]] = [
        ("on the\nfirst", lambda ledger: number(ledger.work[0])),
        ("on the\nsecond", lambda ledger: number(ledger.work[1])),
        ("its\nspring", lambda ledger: number(ledger.spring)),
        *(
            (f"added,\n{state}", lambda ledger, state=state: number(ledger.by_state.get(state, 0.0)))
            for state in states
        ),
        ("damping\ntook", lambda ledger: number(ledger.dissipated)),
        ("worst\nexcess", lambda ledger: number(ledger.excess, digits=2) if ledger.strict else "not judged"),
    ]
    print_columns(
        console,
        "Energy of each link [J]",
        [" - ".join(names[user] for user in ledger.ends) for ledger in result.links],
        [(heading, [show(ledger) for ledger in result.links]) for heading, show in columns],
    )
