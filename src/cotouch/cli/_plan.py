"""`cotouch plan`."""

import re
import sys
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cotouch.cli._output import number, print_json
from cotouch.errors import ScenarioError
from cotouch.units import user_index, user_number

if TYPE_CHECKING:
    from cotouch.planning import Choice, Plan

_UNITS = {"consensus": "", "decay": "1/s", "damping": "Ns/m"}
_TITLES = {
    "consensus": "second largest |eigenvalue| of the consensus",
    "decay": "rightmost root of the closed loop",
    "damping": "largest damping",
}


def run(path: Path, *, must: Sequence[str], never: Sequence[str], as_json: bool, **options: Any) -> None:
    """Plans, shows how far it is, and prints what it found."""
    from cotouch.network import Network
    from cotouch.planning import plan

    network = Network.read(path)
    with _progress(quiet=as_json) as progress:
        found = plan(network, must=_pairs("--must", must), never=_pairs("--never", never), progress=progress, **options)
    if as_json:
        print_json(found.numbers())
    else:
        _print(network.users, found)


def _pairs(option: str, texts: Sequence[str]) -> list[tuple[int, int]]:
    """Links such as 1-2; several may stand in one text."""
    result: list[tuple[int, int]] = []
    for text in texts:
        for part in text.replace(",", " ").split():
            match = re.fullmatch(r"(\d+)-(\d+)", part)
            if match is None:
                raise ScenarioError(f'{option} is "{part}"; a link is two user numbers, such as 1-2')
            result.append((user_index(int(match[1])), user_index(int(match[2]))))
    return result


@contextmanager
def _progress(*, quiet: bool) -> Generator[Callable[[int, int, float], None] | None]:
    """Shows on standard error how far the search is."""
    if quiet or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console

    with Console(stderr=True).status("Looking at links ...") as status:

        def show(done: int, total: int, best: float) -> None:
            share = f"{done} of {total}" if total else "proving"
            status.update(f"Looking at links: {share}, best {best:.6g} (Ctrl-C takes it)")

        yield show


def _links(choice: "Choice") -> str:
    return " ".join(f"{user_number(a)}-{user_number(b)}" for a, b in choice.links)


def _print(users: Sequence[str], found: "Plan") -> None:
    from rich.box import SIMPLE_HEAD
    from rich.console import Console
    from rich.table import Table

    console = Console()
    unit = _UNITS[found.objective]
    table = Table(
        box=SIMPLE_HEAD, title=f"Links by {_TITLES[found.objective]}", title_justify="left", title_style="bold"
    )
    for heading in ("", "links", f"value{', ' + unit if unit else ''}", "time constant, s", "worst path, s"):
        table.add_column(heading, justify="left" if heading in ("", "links") else "right")
    table.add_column("damping of the users, Ns/m")
    rows = [(str(place), choice) for place, choice in enumerate(found.top, start=1)]
    for place, (title, choice) in enumerate([*rows, ("worst", found.worst)], start=1):
        table.add_row(
            title,
            _links(choice),
            number(choice.value, digits=7),
            "never settles" if choice.period > 1 else number(choice.time_constant_s),
            number(choice.worst_path_s),
            " ".join(number(float(value)) for value in choice.damping),
            end_section=place == len(rows),
        )
    console.print(table)
    console.print(_verdict(users, found), highlight=False)


def _verdict(users: Sequence[str], found: "Plan") -> str:
    lines = {
        "enumerate": f"{found.graphs} connected graphs among {found.looked_at} of {found.choices} choices looked at",
        "bound": f"{found.choices} choices covered by bounds, {found.graphs} graphs worked out",
        "local": f"{found.graphs} graphs of {found.choices} choices looked at, seed {found.seed}",
    }
    if found.status != "proved" and found.method == "bound":
        lines["bound"] = f"{found.graphs} graphs of {found.choices} choices worked out, seed {found.seed}"
    text = f"{found.status.capitalize()} for {len(users)} users: {lines[found.method]}, {found.seconds:.2g} s."
    if found.periodic:
        text += f" {found.periodic} graphs are periodic and never mix."
    if found.unsure:
        text += f" {found.unsure} graphs could not be told for certain and are left out."
    return text
