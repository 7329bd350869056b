"""What `cotouch plan` found, as tables and sentences."""

from collections.abc import Sequence
from typing import TypedDict

from rich.console import Console

from cotouch.cli._output import literal, new_table, number
from cotouch.errors import printable
from cotouch.network import Pair
from cotouch.planning import LinkCounts, Plan

UNITS = {"consensus": "", "decay": "1/s", "damping": "Ns/m", "drag": "Ns/m", "feel": "Ns/m"}
# Names of links that take more letters than this do not fit into the table and are listed below it.
_MOST_LETTERS = 48
# The objective and what it costs, as axes of a figure.
LABELS = {
    "consensus": ("Second largest |eigenvalue|", "Largest damping / (Ns/m)"),
    "decay": ("Decay / (1/s)", "Largest damping / (Ns/m)"),
    "damping": ("Largest damping / (Ns/m)", "Drag / (Ns/m)"),
    "drag": ("Drag / (Ns/m)", "Largest damping / (Ns/m)"),
    "feel": ("Felt in addition to the object / (Ns/m)", "Largest damping / (Ns/m)"),
}
_TITLES = {
    "consensus": "second largest |eigenvalue| of the consensus",
    "decay": "rightmost root of the closed loop",
    "damping": "largest damping",
    "drag": "drag of all users together",
    "feel": "what a hand feels in addition to the object",
}


class TunedSprings(TypedDict):
    """Springs that were tuned, of links by names of users, and which place these links had before."""

    links: list[list[str]]
    rank: int | None
    spring: list[float]
    damping: list[float]
    damping_limit: float
    start_factor: float
    before: float
    after: float
    simulated: float | None


def print_plan(found: Plan) -> None:
    console = Console()
    unit = UNITS[found.objective]
    texts = {choice.links: said_links(found.users, choice.links) for choice in (*found.top, found.worst)}
    long = max(map(len, texts.values())) > _MOST_LETTERS
    texts_shown = [""] if long else ["", "links"]
    numbers = (f"value{', ' + unit if unit else ''}", "time constant, s", "worst path, s", "largest B, Ns/m")
    table = new_table(*texts_shown, *numbers, title=f"Links by {_TITLES[found.objective]}", text=len(texts_shown))
    rows = [(str(place), choice) for place, choice in enumerate(found.top, start=1)]
    for place, (title, choice) in enumerate(
        [*rows, (found.worst_status.replace("proved", "worst"), found.worst)], start=1
    ):
        table.add_row(
            title,
            *([] if long else [literal(texts[choice.links])]),
            number(choice.value, digits=7),
            "never settles" if choice.cycle_period > 1 else number(choice.time_constant_s),
            number(choice.worst_path_s),
            number(float(choice.damping.max())),
            end_section=place == len(rows),
        )
    console.print(table)
    if long:
        console.print(
            f"Links of the best choice (for the others, use --json): {texts[found.best.links]}",
            highlight=False,
            markup=False,
        )
    console.print(_verdict(found), highlight=False)
    for note in found.notes:
        console.print(note, highlight=False, markup=False)


def _verdict(found: Plan) -> str:
    graphs, choices = _many(found.graphs, "graph"), _many(found.choices, "choice")
    connected = graphs.replace("graph", "connected graph")
    lines = {
        "enumerate": f"{connected} among the {found.looked_at} of {choices} examined",
        "bound": f"{choices} covered by bounds, {graphs} evaluated",
        "local": f"{graphs} of {choices} evaluated, seed {found.seed}",
    }
    if found.status != "proved" and found.method == "bound":
        lines["bound"] = f"{graphs} of {choices} evaluated, seed {found.seed}"
    text = f"{found.status.capitalize()} for {len(found.users)} users: {lines[found.method]}, {found.seconds:.2g} s."
    text += _gap(found)
    if found.worst_status != "proved":
        text += " The worst shown is the worst evaluated, not proved worst."
    if found.periodic:
        mixes = "is periodic and never mixes" if found.periodic == 1 else "are periodic and never mix"
        text += f" {_many(found.periodic, 'graph')} {mixes}."
    if found.unsure:
        left = "is" if found.unsure == 1 else "are"
        text += f" {_many(found.unsure, 'graph')} could not be decided numerically and {left} left out."
    return text


def _many(count: int, what: str) -> str:
    """A count in full, or about how large it is where nobody would read it."""
    size = f"{count}" if count < 10**12 else f"about 10^{len(str(count)) - 1}"
    return f"{size} {what}{'s' * (count != 1)}"


def _gap(found: Plan) -> str:
    """How far from the best possible what was found may be."""
    if found.status == "proved":
        return ""
    if found.bound is None:
        return f" How much better another choice could be is unknown: {found.bound_by}."
    unit = f" {UNITS[found.objective]}" if UNITS[found.objective] else ""
    return (
        f" No choice is better than {number(found.bound)}{unit}, by a relaxation that {found.bound_by}; "
        f"the best found has {number(found.best.value)}{unit}."
    )


def print_counts(every: LinkCounts) -> None:
    """What each number of links gives, and where more stop paying."""
    unit = UNITS[every.best.objective]
    headings = ("links", f"value{', ' + unit if unit else ''}", "largest B, Ns/m", "drag, Ns/m")
    table = new_table(*headings, title="By number of links", text=0)
    table.add_column("status")
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
        f"Best with {best} links; the knee is at {knee}: the fewest links within 10 % of the best value.",
        highlight=False,
    )


def print_tuned(tuned: TunedSprings) -> None:
    console = Console()
    springs = ", ".join(
        f"{said_link(*link)} {number(k)}" for link, k in zip(tuned["links"], tuned["spring"], strict=True)
    )
    whose = "" if tuned["rank"] == 1 else " of another choice of links, which is better once tuned,"
    console.print(
        f"Springs{whose} tuned with no user's damping above {number(tuned['damping_limit'], 'Ns/m')}: the slowest "
        f"mode goes from {number(tuned['before'])} to {number(tuned['after'])} 1/s"
        + ("" if tuned["simulated"] is None else f"; a simulated free decay shows {number(tuned['simulated'])} 1/s")
        + f". Springs in N/m: {springs}."
        + (
            ""
            if tuned["start_factor"] == 1.0
            else f" The initial springs broke the limit and were first scaled by {number(tuned['start_factor'])}."
        ),
        highlight=False,
        markup=False,
    )


def said_links(users: Sequence[str], links: Sequence[Pair]) -> str:
    """Links by the names of their users, with commas where a name has a space.

    Args:
        users: their names.
        links: pairs of users, from 0.
    """
    texts = [said_link(users[a], users[b]) for a, b in links]
    return (", " if any(" " in text for text in texts) else " ").join(texts)


def said_link(first: str, second: str) -> str:
    """A link as `--require` takes it: in quotes where a name has a comma.

    Args:
        first: name of a user.
        second: name of the other.
    """
    text = printable(f"{first}-{second}")
    return '"' + text.replace('"', '""') + '"' if "," in text or text.startswith('"') else text
