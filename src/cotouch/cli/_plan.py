"""`cotouch plan`."""

import re
import sys
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cotouch.cli._output import folder, number, print_json, working
from cotouch.errors import ScenarioError
from cotouch.units import user_index, user_number

if TYPE_CHECKING:
    from cotouch.network import Network
    from cotouch.planning import Choice, Plan

# Up to so many choices every one of them is ranked by both objectives.
_MOST_RANKED = 20_000
# The object where neither the file nor the options say otherwise.
_OBJECT = {"mass": 1.0, "damping": 0.0, "stiffness": 0.0}
_UNITS = {"consensus": "", "decay": "1/s", "damping": "Ns/m"}
_TITLES = {
    "consensus": "second largest |eigenvalue| of the consensus",
    "decay": "rightmost root of the closed loop",
    "damping": "largest damping",
}


def run(
    path: Path,
    *,
    must: Sequence[str],
    never: Sequence[str],
    tune: float | None,
    figures: Path | None,
    as_json: bool,
    **options: Any,
) -> None:
    """Plans, shows how far it is, and prints what it found."""
    from cotouch.network import Network
    from cotouch.planning import compiles, plan

    network = Network.read(path)
    moving = options["objective"] != "consensus" or tune is not None or figures is not None
    body = _object(path, {name: options[name] for name in _OBJECT}, read=moving)
    options |= body
    limits = {"must": _pairs("--must", must), "never": _pairs("--never", never)}
    if figures is not None:
        folder(figures)
    if compiles(options["method"]):
        print("Compiling, once on this machine: about a minute.", file=sys.stderr)  # noqa: T201
    with _progress(quiet=as_json) as progress:
        found = plan(network, progress=progress, **limits, **options)
    result = found.numbers()
    tuned = None
    if tune is not None:
        with working("Tuning springs ...", quiet=as_json):
            tuned = _tuned(network.with_links(found.best.links), tune, body)
        result["tuned"] = tuned
    if figures is not None:
        with working("Drawing ...", quiet=as_json):
            result["files"] = _draw(figures, network, found, limits | options)
    if as_json:
        print_json(result)
        return
    _print(network.users, found)
    if tuned is not None:
        _print_tuned(tuned)
    for name in result.get("files", ()):
        print(name)  # noqa: T201


def _object(path: Path, given: dict[str, float | None], *, read: bool) -> dict[str, Any]:
    """The modes of the file's body where it has one, with what the options say in its place."""
    import tomllib

    result: dict[str, Any] = dict(_OBJECT)
    said = {name: value for name, value in given.items() if value is not None}
    if read and len(said) < len(given) and "body" in tomllib.loads(path.read_text(encoding="utf-8")):
        from cotouch.planning import modes_of
        from cotouch.scenario import Scenario

        result |= modes_of(Scenario.read(path).build_body())
    return result | said


def _tuned(network: "Network", limit: float, body: dict[str, Any]) -> dict[str, Any]:
    """Springs within a limit on damping, and the rate that a free decay in the simulator shows with them."""
    from cotouch.planning import tune_springs
    from cotouch.study import confirmed

    tuned = tune_springs(network, damping_limit=limit, **body)
    mass, damping, stiffness = tuned.mode.tolist()
    seen = None
    if tuned.after < 0:
        seen = confirmed(tuned.network, tuned.after, mass=mass, damping=damping, stiffness=stiffness)
    return {
        "links": [[user_number(a), user_number(b)] for a, b in tuned.network.links],
        "spring": [float(tuned.network.spring[a, b]) for a, b in tuned.network.links],
        "damping": tuned.sync_damping.tolist(),
        "damping_limit": limit,
        "start_factor": tuned.start_factor,
        "before": tuned.before,
        "after": tuned.after,
        "simulated": seen,
    }


def _print_tuned(tuned: dict[str, Any]) -> None:
    from rich.console import Console

    console = Console()
    springs = ", ".join(f"{a}-{b} {number(k)}" for (a, b), k in zip(tuned["links"], tuned["spring"], strict=True))
    console.print(
        f"Springs tuned with no damping above {number(tuned['damping_limit'], 'Ns/m')}: the slowest mode goes from "
        f"{number(tuned['before'])} to {number(tuned['after'])} 1/s"
        + ("" if tuned["simulated"] is None else f"; a simulated free decay shows {number(tuned['simulated'])} 1/s")
        + f". Springs in N/m: {springs}."
        + (
            ""
            if tuned["start_factor"] == 1.0
            else f" The start broke the limit and was scaled by {number(tuned['start_factor'])} first."
        ),
        highlight=False,
    )


def _draw(path: Path, network: "Network", found: "Plan", options: dict[str, Any]) -> list[str]:
    """The best choice beside the worst; one objective against the other; what more links bring and cost."""
    from cotouch.planning import knee, networks, ranks, survey

    unit = _UNITS[found.objective]
    cases = [
        (f"{word}: {number(choice.value)} {unit}", network.with_links(choice.links))
        for word, choice in (("Best", found.best), ("Worst", found.worst))
    ]
    drawn = {"networks": networks(cases)}
    limits = {name: options[name] for name in ("must", "never", "max_degree", "mass", "damping", "stiffness")}
    grid = {name: options[name] for name in ("convention", "time_unit", "rounding")}
    if found.choices <= _MOST_RANKED:
        sides = {"consensus": grid | {"objective": "consensus"}, "decay": {"objective": "decay"}}
        every = survey(network, links=options["links"], objectives=sides, **limits)
        drawn["ranks"] = ranks(("Consensus", every.values["consensus"]), ("Decay / (1/s)", every.values["decay"]))
    steps = _knee(network, found, limits)
    if steps:
        drawn["knee"] = knee(*zip(*steps, strict=True), chosen=options["links"])
    names: list[str] = []
    for name, figure in drawn.items():
        figure.savefig(path / f"{name}.png", dpi=200)
        names.append(str(path / f"{name}.png"))
    return names


def _knee(network: "Network", found: "Plan", limits: dict[str, Any]) -> list[tuple[int, float, float]]:
    """Links, decay and largest damping of the fastest choice with each number of links around the one asked for."""
    from cotouch.errors import NetworkError
    from cotouch.planning import plan

    asked = len(found.best.links)
    result: list[tuple[int, float, float]] = []
    for links in range(max(network.size - 1, asked - 4), asked + 5):
        try:
            best = plan(network, links=links, objective="decay", top=1, limit=_MOST_RANKED, seconds=5.0, **limits).best
        except NetworkError:
            continue
        result.append((links, best.value, float(best.damping.max())))
    return result if any(links == asked for links, _, _ in result) else []


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
    table.add_column("largest B, Ns/m", justify="right")
    rows = [(str(place), choice) for place, choice in enumerate(found.top, start=1)]
    for place, (title, choice) in enumerate(
        [*rows, (found.worst_status.replace("proved", "worst"), found.worst)], start=1
    ):
        table.add_row(
            title,
            _links(choice),
            number(choice.value, digits=7),
            "never settles" if choice.period > 1 else number(choice.time_constant_s),
            number(choice.worst_path_s),
            number(float(choice.damping.max())),
            end_section=place == len(rows) - 1,
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
    if found.worst_status != "proved":
        text += " The worst shown is the worst worked out, not proved."
    if found.periodic:
        text += f" {found.periodic} graphs are periodic and never mix."
    if found.unsure:
        text += f" {found.unsure} graphs could not be told for certain and are left out."
    return text
