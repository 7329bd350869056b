"""`cotouch reproduce`."""

import sys
import webbrowser
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table
from rich.table import Table as Grid

from cotouch.cli._output import number, print_json
from cotouch.cli._page import desktop
from cotouch.files import folder
from cotouch.study import reproduce


def run(out: Path, *, as_json: bool) -> None:
    """Repeats the paper, prints the numbers and where the report is, and opens it if there is a desktop.

    Args:
        out: file to write; None: none.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    folder(out)

    if as_json:
        result = reproduce(out)
        print_json(result.numbers)
        return

    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("Compiling the kernels", total=None)

        def progress(done: int, total: int, text: str) -> None:
            bar.update(task, completed=done, total=total, description=text)

        result = reproduce(out, progress=progress)
    console = Console()
    for table in _tables(result.numbers):
        console.print(table)
    verdict = "all results are as expected" if result.confirmed else "[red]not all results are as expected[/red]"
    console.print(
        f"In {result.seconds:.0f} s; {verdict}. The ledger is off by {result.energy_residual:.0e} of the energy in "
        f"play."
    )
    console.print(f"Report: {result.report.resolve()}", highlight=False, soft_wrap=True)
    if sys.stdout.isatty() and desktop():
        webbrowser.open(result.report.resolve().as_uri())


def _tables(numbers: dict[str, Any]) -> Iterator[Table]:
    """What fits on a screen of what was found."""

    def table(title: str, *headings: str) -> Grid:
        made = Grid(box=SIMPLE_HEAD, title=title, title_justify="left", title_style="bold")
        for index, heading in enumerate(headings):
            text = index == 0 or heading == "claim" or heading.startswith("links")
            made.add_column(
                heading, justify="left" if text else "right", max_width=44, no_wrap=heading.startswith("links")
            )
        return made

    found = numbers["topologies"]
    choice = table(
        f"Choice of links: {found['connected']} of {found['choices']} choices are connected",
        "objective",
        "best links",
        "value",
        "worst links",
        "value",
    )
    titles = {"equation": "equation", "matrix": "matrix", "decay": "decay, 1/s"}
    for name, title in titles.items():
        best, worst = found["objectives"][name]["best"], found["objectives"][name]["worst"]
        periodic = found["objectives"][name]["never_mixing"]
        links = f"{periodic} tied, none mixes" if periodic else worst["links"]
        choice.add_row(title, best["links"], f"{best['value']:.6f}", links, f"{worst['value']:.6f}")
    yield choice

    runs = table(
        "Five users hold, then let go",
        "choice",
        "links",
        "position\nsettles, s",
        "force\nsettles, s",
        "Σf, N",
        "largest B,\nNs/m",
    )
    for name, run in numbers["experiment"].items():
        settles = run["settling_time_s"]
        largest = max(run["damping_ns_m"])
        runs.add_row(
            name,
            run["links"],
            number(settles["position"], digits=3),
            number(settles["force"], digits=3),
            f"{run['force_sum_n']:.1e}",
            number(largest, digits=3),
        )
    yield runs

    claims = table("Theorem 1 and its consequences", "where", "claim", "measured", "must be", "holds")
    for claim in numbers["theorem"]["claims"]:
        unit = f" {claim['unit']}" if claim["unit"] else ""
        measured = f"{claim['measured']:.1e}{unit}"
        claims.add_row(
            claim["item"],
            claim["claim"].split(":")[0],
            measured,
            claim["must_be"],
            "yes" if claim["holds"] else "[red]no[/red]",
        )
    yield claims

    whole = table(
        "All four blocks, in three dimensions", "block", "claim", "constant\ndelay", "freshest", "must be", "holds"
    )
    found = numbers["solid"]["claims"]
    for one, other in zip(found[::2], found[1::2], strict=True):
        unit = f" {one['unit']}" if one["unit"] else ""
        whole.add_row(
            one["item"],
            one["claim"].split(":")[0],
            *(f"{claim['measured']:.1e}{unit}" for claim in (one, other)),
            one["must_be"],
            "yes" if one["holds"] and other["holds"] else "[red]no[/red]",
        )
    yield whole

    ways = table(
        "Same jittery, lossy channel, different mode",
        "mode",
        "largest B,\nNs/m",
        "age, s\nmedian",
        "age, s\nlargest",
        "position\nsettles, s",
        "steps\nper s",
    )
    for name, way in numbers["modes"].items():
        ways.add_row(
            name,
            number(way["largest_damping_ns_m"], digits=3),
            number(way["age_s"]["median"], digits=2),
            number(way["age_s"]["max"], digits=3),
            number(way["settling_time_s"]["position"], digits=3),
            number(way["steps_per_s"], digits=4),
        )
    yield ways
