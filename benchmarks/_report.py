"""Rows of the benchmark table, how they are printed, and how they get into RESULTS.md."""

import argparse
import datetime
import importlib.metadata
import os
import platform
import re
from collections.abc import Callable
from pathlib import Path
from time import perf_counter

import numpy as np

from benchmarks._layout import SECTIONS, Row, introduction, laid_out

RESULTS = Path(__file__).parent / "RESULTS.md"


def machine() -> str:
    """What the numbers were measured on."""
    model = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.exists():
        found = re.search(r"model name\s*:\s*(.+)", info.read_text(encoding="utf-8"))
        model = found.group(1).strip() if found else model
    parts = []
    for package in ("numpy", "scipy", "numba", "mujoco"):
        try:
            parts.append(f"{package} {importlib.metadata.version(package)}")
        except importlib.metadata.PackageNotFoundError:
            parts.append(f"no {package}")
    today = datetime.datetime.now(tz=datetime.UTC).date()
    python = f"{platform.system()}, Python {platform.python_version()}"
    return f"{model}, {os.cpu_count()} cores, {python}, {', '.join(parts)}, {today}"


def interleave(actions: dict[str, Callable[[], object]], rounds: int, least: float = 0.0) -> dict[str, np.ndarray]:
    """Seconds of each action in every round; in a round all of them run one after the other.

    Ratios should be taken round by round, because other work on the machine then weighs on both sides alike.

    Args:
        actions: what to run, by name; each is run once beforehand.
        rounds: how often.
        least: an action is repeated within a round until this much time has passed [s], and the mean is taken.
    """
    for action in actions.values():
        action()
    seconds: dict[str, list[float]] = {name: [] for name in actions}
    for _ in range(rounds):
        for name, action in actions.items():
            count, start = 0, perf_counter()
            while True:
                action()
                count += 1
                passed = perf_counter() - start
                if passed >= least:
                    break
            seconds[name].append(passed / count)
    return {name: np.array(times) for name, times in seconds.items()}


def ratio(above: np.ndarray, below: np.ndarray) -> float:
    """Median of the ratios, round by round."""
    return float(np.median(above / below))


def show(rows: list[Row]) -> None:
    """Prints the table."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    table = Table(caption=machine(), caption_justify="left", title_justify="left", row_styles=["", "dim"])
    for heading in ("", "measured", "value", "goal", "note"):
        table.add_column(heading, justify="right" if heading in {"value", "goal"} else "left", overflow="fold")
    previous = ""
    for row in rows:
        if previous and row.section != previous:
            table.add_section()
        table.add_row(row.section if row.section != previous else "", *(escape(cell) for cell in row[1:]))
        previous = row.section
    console = Console()
    console.width = max(console.width, 120)
    console.print(table)


def _save(rows: list[Row]) -> None:
    """Puts rows into RESULTS.md, section by section; sections that were not run stay as they are."""
    sections: dict[str, str] = {}
    if RESULTS.exists():
        for part in RESULTS.read_text(encoding="utf-8").split("\n## ")[1:]:
            name, _, text = part.partition("\n")
            sections[name.strip()] = text.strip()
    for name in dict.fromkeys(row.section for row in rows):
        measured = [row for row in rows if row.section == name]
        lines = [*introduction(name), f"Measured on {machine()}.", *laid_out(name, measured)]
        sections[name] = "\n".join(lines)
    names = list(SECTIONS)
    order = sorted(sections, key=lambda name: (names.index(name) if name in SECTIONS else len(SECTIONS), name))
    head = "# Results of the benchmarks\n\nWritten by `python -m benchmarks --write`; the code measured every number.\n"
    RESULTS.write_text(head + "".join(f"\n## {name}\n\n{sections[name]}\n" for name in order), encoding="utf-8")


def add_write(parser: argparse.ArgumentParser) -> None:
    """Adds the option that writes the results."""
    parser.add_argument("--write", action="store_true", help="also write benchmarks/RESULTS.md")


def finish(rows: list[Row], *, write: bool) -> None:
    """Prints the rows and, if asked, writes them."""
    show(rows)
    if write:
        _save(rows)


def command(measure: Callable[[], list[Row]], description: str | None) -> None:
    """The command line of one benchmark."""
    parser = argparse.ArgumentParser(description=description)
    add_write(parser)
    options = parser.parse_args()
    finish(measure(), write=options.write)
