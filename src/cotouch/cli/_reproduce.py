"""`cotouch reproduce`."""

import os
import sys
import webbrowser
from pathlib import Path

from cotouch.cli._output import folder, print_json


def run(out: Path, *, as_json: bool) -> None:
    """Repeats the paper, prints the numbers and where the report is, and opens it if there is a desktop."""
    folder(out)
    from cotouch.study import reproduce

    if as_json:
        result = reproduce(out)
        print_json({**result.numbers, "report": str(result.report)})
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("Compiling the kernels", total=None)

        def progress(done: int, total: int, text: str) -> None:
            bar.update(task, completed=done, total=total, description=text)

        result = reproduce(out, progress=progress)
    console = Console()
    for table in result.tables():
        console.print(table)
    console.print(f"The report: {result.report.resolve()}", highlight=False, soft_wrap=True)
    if _desktop():
        webbrowser.open(result.report.resolve().as_uri())


def _desktop() -> bool:
    """Whether someone sits in front of a screen that a browser can open on."""
    if not sys.stdout.isatty():
        return False
    return sys.platform in {"darwin", "win32"} or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
