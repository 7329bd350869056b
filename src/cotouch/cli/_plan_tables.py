"""What `cotouch plan` found, as tables and sentences."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from cotouch.cli._output import literal, number

if TYPE_CHECKING:
    from cotouch.network import Network
    from cotouch.planning import Choice, LinkCounts, Plan

UNITS = {"consensus": "", "decay": "1/s", "damping": "Ns/m", "drag": "Ns/m", "feel": "Ns/m"}
# More links than this are listed below the table, of the best alone.
_MOST_LISTED = 12
_TITLES = {
    "consensus": "second largest |eigenvalue| of the consensus",
    "decay": "rightmost root of the closed loop",
    "damping": "largest damping",
    "drag": "drag of all users together",
    "feel": "what a hand feels beyond the object",
}


def print_plan(network: "Network", found: "Plan") -> None:
    from rich.box import SIMPLE_HEAD
    from rich.console import Console
    from rich.table import Table

    console = Console()
    unit = UNITS[found.objective]
    table = Table(
        box=SIMPLE_HEAD, title=f"Links by {_TITLES[found.objective]}", title_justify="left", title_style="bold"
    )
    for heading in ("", "links", f"value{', ' + unit if unit else ''}", "time constant, s", "worst path, s"):
        table.add_column(heading, justify="left" if heading in ("", "links") else "right")
    table.add_column("largest B, Ns/m", justify="right")
    long = len(found.best.links) > _MOST_LISTED
    rows = [(str(place), choice) for place, choice in enumerate(found.top, start=1)]
    for place, (title, choice) in enumerate(
        [*rows, (found.worst_status.replace("proved", "worst"), found.worst)], start=1
    ):
        table.add_row(
            title,
            literal(_links(network, choice)),
            number(choice.value, digits=7),
            "never settles" if choice.period > 1 else number(choice.time_constant_s),
            number(choice.worst_path_s),
            number(float(choice.damping.max())),
            end_section=place == len(rows) - 1,
        )
    console.print(table)
    if long:
        console.print(f"Links of the best: {_links(network, found.best)}", highlight=False, markup=False)
    console.print(_verdict(network.users, found), highlight=False)
    for note in found.notes:
        console.print(note, highlight=False, markup=False)


def _verdict(users: Sequence[str], found: "Plan") -> str:
    lines = {
        "enumerate": f"{found.graphs} connected graphs among {found.looked_at} of {found.choices} choices looked at",
        "bound": f"{found.choices} choices covered by bounds, {found.graphs} graphs worked out",
        "local": f"{found.graphs} graphs of {found.choices} choices looked at, seed {found.seed}",
    }
    if found.status != "proved" and found.method == "bound":
        lines["bound"] = f"{found.graphs} graphs of {found.choices} choices worked out, seed {found.seed}"
    text = f"{found.status.capitalize()} for {len(users)} users: {lines[found.method]}, {found.seconds:.2g} s."
    text += _gap(found)
    if found.worst_status != "proved":
        text += " The worst shown is the worst worked out, not proved."
    if found.periodic:
        text += f" {found.periodic} graphs are periodic and never mix."
    if found.unsure:
        text += f" {found.unsure} graphs could not be told for certain and are left out."
    return text


def _gap(found: "Plan") -> str:
    """How far from the best possible what was found may be."""
    if found.status == "proved":
        return ""
    if found.bound is None:
        return f" How much better another choice could be is not known: {found.bound_by}."
    unit = f" {UNITS[found.objective]}" if UNITS[found.objective] else ""
    return (
        f" No choice is better than {number(found.bound)}{unit}, by a relaxation that {found.bound_by}; "
        f"the best found has {number(found.best.value)}{unit}."
    )


def print_counts(every: "LinkCounts") -> None:
    """What each number of links gives, and where more stop paying."""
    from rich.box import SIMPLE_HEAD
    from rich.console import Console
    from rich.table import Table

    unit = UNITS[every.best.objective]
    table = Table(box=SIMPLE_HEAD, title="By number of links", title_justify="left", title_style="bold")
    for heading in ("links", f"value{', ' + unit if unit else ''}", "largest B, Ns/m", "drag, Ns/m", "status"):
        table.add_column(heading, justify="left" if heading == "status" else "right")
    for one in every.plans:
        best = one.best
        table.add_row(
            str(len(best.links)),
            number(best.value, digits=7),
            number(float(best.damping.max())),
            number(best.drag),
            one.status,
        )
    console = Console()
    console.print(table)
    best, knee = len(every.best.best.links), len(every.knee.best.links)
    console.print(
        f"Best with {best} links; the knee is at {knee}: the fewest that come within 10 % of it.", highlight=False
    )


def print_tuned(network: "Network", tuned: dict[str, Any]) -> None:
    from rich.console import Console

    console = Console()
    springs = ", ".join(
        f"{_link(network, a - 1, b - 1)} {number(k)}" for (a, b), k in zip(tuned["links"], tuned["spring"], strict=True)
    )
    whose = "" if tuned["rank"] == 1 else " of other links, which are better once tuned,"
    console.print(
        f"Springs{whose} tuned with no damping above {number(tuned['damping_limit'], 'Ns/m')}: the slowest mode goes "
        f"from {number(tuned['before'])} to {number(tuned['after'])} 1/s"
        + ("" if tuned["simulated"] is None else f"; a simulated free decay shows {number(tuned['simulated'])} 1/s")
        + f". Springs in N/m: {springs}."
        + (
            ""
            if tuned["start_factor"] == 1.0
            else f" The start broke the limit and was scaled by {number(tuned['start_factor'])} first."
        ),
        highlight=False,
        markup=False,
    )


def _links(network: "Network", choice: "Choice") -> str:
    return " ".join(_link(network, a, b) for a, b in choice.links)


def _link(network: "Network", a: int, b: int) -> str:
    return "-".join(names_of(network, a, b))


def names_of(network: "Network", a: int, b: int) -> tuple[str, str]:
    return network.users[a], network.users[b]
