"""What the commands print."""

import json
import math
import sys
from collections.abc import Callable, Generator, Iterable, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import cast

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Column, Table
from rich.text import Text

from cotouch.errors import printable


def print_json(value: Mapping[str, object]) -> None:
    """Prints one JSON object on standard output; what is not finite becomes null, which JSON has."""
    sys.stdout.write(json.dumps(_finite(value), indent=2) + "\n")


def say(text: str) -> None:
    """Says something on standard error, a line of its own."""
    sys.stderr.write(f"cotouch: {text}\n")
    sys.stderr.flush()


def _finite(value: object) -> object:
    if isinstance(value, dict):
        return {str(key): _finite(entry) for key, entry in cast("dict[object, object]", value).items()}
    if isinstance(value, list | tuple):
        return [_finite(entry) for entry in cast("list[object]", value)]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def number(value: float | None, unit: str = "", digits: int = 4) -> str:
    """A number for a table.

    Args:
        value: the number; None: a dash.
        unit: of it.
        digits: significant ones.
    """
    if value is None:
        return "does not settle"
    return f"{value + 0.0:.{digits}g}" + (f" {unit}" if unit else "")


def literal(text: object) -> str:
    """A name or a path as rich may have it: no markup, and nothing that a terminal would obey."""
    return escape(printable(str(text)))


def print_note(console: Console, colour: str, text: str) -> None:
    """Prints a sentence as an item of a list; at a terminal in lines that end between words.

    Args:
        console: to print on.
        colour: of the dot before it.
        text: markup, as `literal` makes it.
    """
    dot = f"  [{colour}]•[/{colour}]"
    if not console.is_terminal:
        console.print(dot, text, highlight=False, soft_wrap=True)
        return
    row = Table.grid(padding=(0, 1))
    row.add_row(dot, text)
    console.print(row, highlight=False)


def print_written(console: Console, files: Iterable[Path]) -> None:
    """Prints which files were written.

    Args:
        console: to print on.
        files: of them.
    """
    for file in files:
        console.print(f"  wrote {literal(file)}", highlight=False, soft_wrap=True)


def new_table(*headings: str, title: str | None = None, text: int = 1) -> Table:
    """A table with a line below its headings only.

    Args:
        headings: of its columns.
        title: above it; None: nothing.
        text: how many columns from the left are text; the others are numbers.
    """
    columns = [Column(heading, justify="left" if at < text else "right") for at, heading in enumerate(headings)]
    return Table(*columns, box=SIMPLE_HEAD, title=title, title_justify="left", title_style="bold")


@contextmanager
def working(text: str, *, quiet: bool) -> Generator[None]:
    """Shows on standard error that something is going on.

    Args:
        text: what goes on.
        quiet: whether to show nothing.
    """
    if quiet or not sys.stderr.isatty():
        yield
        return

    with Console(stderr=True).status(text):
        yield


@contextmanager
def counting(first: str, doing: Mapping[str, str], *, quiet: bool) -> Generator[Callable[[int, int, str], None]]:
    """Shows on standard error how much is done.

    Args:
        first: what goes on before anything is done.
        doing: what goes on, for each name of what is counted.
        quiet: whether to show nothing.
    """
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(
        *columns, console=Console(stderr=True), transient=True, disable=quiet or not sys.stderr.isatty()
    ) as bar:
        task = bar.add_task(first, total=None)

        def progress(done: int, total: int, what: str) -> None:
            bar.update(task, completed=done, total=total, description=doing[what])

        yield progress


def print_columns(
    console: Console, title: str, rows: Sequence[str], columns: Sequence[tuple[str, Sequence[str]]]
) -> None:
    """Prints numbers; where all columns do not fit beside each other, as several tables, so that no number is cut.

    Args:
        console: to print on.
        title: above all.
        rows: what each row is.
        columns: heading of each, and its entries, one for each row.
    """

    def plain(text: str) -> Text:
        return Text("\n".join(map(printable, text.split("\n"))))

    def table(some: Sequence[tuple[str, Sequence[str]]], above: Text | None) -> Table:
        made = Table(box=SIMPLE_HEAD, title=above, title_justify="left", title_style="bold")
        made.add_column("", no_wrap=True)
        for heading, _ in some:
            made.add_column(plain(heading), justify="right", no_wrap=True)
        for i, row in enumerate(rows):
            made.add_row(plain(row), *(plain(entries[i]) for _, entries in some))
        return made

    wide = console.options.update_width(1 << 16)  # as wide as it would be; else it is measured as if it fitted
    left: list[tuple[str, Sequence[str]]] = list(columns)
    above: Text | None = plain(title)
    while left:
        count = len(left)
        while count > 1 and console.measure(table(left[:count], None), options=wide).maximum > console.width:
            count -= 1
        console.print(table(left[:count], above))
        left, above = left[count:], None
