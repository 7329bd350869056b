"""`cotouch plan`."""

import csv
import re
import sys
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cotouch.cli._output import number, print_json, working
from cotouch.cli._plan_tables import UNITS, names_of, print_counts, print_plan, print_tuned
from cotouch.errors import NetworkError, ScenarioError, UnsupportedError
from cotouch.files import beside, folder, read_toml, write
from cotouch.units import user_index, user_number

if TYPE_CHECKING:
    from cotouch.network import Network
    from cotouch.planning import LinkCounts, Plan

# Up to so many choices every one of them is ranked by both objectives.
_MOST_RANKED = 20_000
# For each number of links in the figure of the knee [s].
_KNEE_SECONDS = 5.0
# Of the paper's consensus model [s].
_TIME_UNIT = 0.01
_DRAWN = ("networks", "ranks", "knee")
# The object where neither the file nor the options say otherwise.
_OBJECT = {"mass": 1.0, "damping": 0.0, "stiffness": 0.0}


def run(
    path: Path | None,
    *,
    require: Sequence[str],
    forbid: Sequence[str],
    links: str,
    tune: float | None,
    figures: Path | None,
    as_json: bool,
    delays: Sequence[Path] = (),
    pick: str | None = None,
    spring: float = 50.0,
    quantile: float = 1.0,
    **options: Any,
) -> None:
    """Plans, shows how far it is, and prints what it found.

    Args:
        path: of the file of the network; None with `delays`.
        require: links that must be, as "1-2".
        forbid: links that may not be.
        links: how many, as "6", "4-8" or "at most 8".
        tune: limit on damping for tuned springs [Ns/m]; None: springs stay.
        figures: folder for figures; None: none.
        as_json: whether to print one JSON object and nothing else on standard output.
        delays: tables of round trips that stand in for the file.
        pick: names of the users to take from them, separated by commas (in quotes where a name has one); None: all.
        spring: stiffness of every link of such a network [N/m].
        quantile: of the round trips that counts, in (0, 1].
        **options: of the library call, as named there.
    """
    from cotouch.planning import LinkCounts, PlanInterrupted, compiles, plan, plan_counts

    network = _network(path, delays, pick, spring, quantile)
    options["objective"] = options["objective"] or _objective(network, options["time_unit"], options["rounding"])
    counts = _counts(links, network.size, len(network.with_links(None).links))
    moving = options["objective"] != "consensus" or tune is not None or figures is not None
    body = _object(path, {name: options[name] for name in _OBJECT}, read=moving)
    options |= body
    limits = {"require": _pairs(network, "--require", require), "forbid": _pairs(network, "--forbid", forbid)}
    if figures is not None:
        beside(folder(figures), [f"{name}.png" for name in _DRAWN], (*delays, *([] if path is None else [path])))
    if compiles(options["method"], options["objective"]):
        _first(network, counts, limits | options)
    every: LinkCounts | None = None
    with _progress(quiet=as_json) as progress:
        try:
            if len(counts) > 1:
                every = plan_counts(network, links=counts, progress=progress, **limits, **options)
                found = every.best
            else:
                found = plan(network, links=counts[0], progress=progress, **limits, **options)
        except PlanInterrupted as interrupted:
            found = interrupted.plan
            _tell(network, found, None, _result(network, found, None), as_json=as_json)
            raise
    result = _result(network, found, every)
    if tune is not None:
        with working("Tuning springs ...", quiet=as_json):
            result["tuned"] = _tuned(network, found, tune, body, limits | options)
    if figures is not None:
        with working("Drawing ...", quiet=as_json):
            result["files"] = _draw(figures, network, found, every, limits | options)
    _tell(network, found, every, result, as_json=as_json)


def _objective(network: "Network", time_unit: float, rounding: str) -> str:
    """Which objective is meant where none is named: measured delays are on no grid, so consensus has none."""
    from cotouch.network import consensus_lags

    if time_unit != _TIME_UNIT or rounding != "exact":
        return "consensus"
    try:
        consensus_lags(network.with_links(None), time_unit=time_unit, convention="matrix", rounding="exact")
    except NetworkError:
        sys.stderr.write(
            f"cotouch: the delays are no multiples of {time_unit:g} s, so links are chosen for the fastest decay "
            "(--objective decay)\n"
        )
        return "decay"
    return "consensus"


def _first(network: "Network", counts: Sequence[int], options: dict[str, Any]) -> None:
    """Something to begin with while kernels compile, on standard error."""
    from cotouch.planning import first_choice

    print("Compiling, once on this machine: about two minutes.", file=sys.stderr)  # noqa: T201
    kept = ("top", "method", "seconds", "seed", "jobs", "dask")
    asked = {name: option for name, option in options.items() if name not in kept}
    found = first_choice(network, links=counts[0], seed=options.get("seed", 0), **asked)
    if found is None:
        return
    unit = UNITS[options["objective"]]
    value = "" if found.value is None else f", about {number(found.value)} {unit}".rstrip()
    pairs = " ".join("-".join(names_of(network, a, b)) for a, b in found.links)
    print(  # noqa: T201
        f"Meanwhile the best of {found.tried} with {counts[0]} links, not certified{value}: {pairs}", file=sys.stderr
    )


def _network(path: Path | None, delays: Sequence[Path], pick: str | None, spring: float, quantile: float) -> "Network":
    """The file's network, or that of a table of round trips."""
    from cotouch.network import Network

    if delays:
        if path is not None:
            raise ScenarioError(f"{path} and --delays each name users and delays; give one of them")
        names = (
            []
            if pick is None
            else [name for part in csv.reader([pick], skipinitialspace=True) for name in map(str.strip, part) if name]
        )
        return Network.from_delays(delays, pick=names, spring=spring, quantile=quantile)
    if path is None:
        raise ScenarioError("no network is given; name a TOML file, or a table of round trips by --delays")
    if pick is not None:
        raise ScenarioError("--pick takes users of a table of round trips; name one by --delays")
    for name, value, usual in (("--spring", spring, 50.0), ("--quantile", quantile, 1.0)):
        if value != usual:
            raise ScenarioError(f"{name} is {value:g}, but a table of round trips it would count for is not given")
    return Network.read(path)


def _counts(text: str, size: int, possible: int) -> list[int]:
    """Numbers of links: 6, 4-8 or "at most 8"."""
    said = text.strip()
    for pattern in (r"(\d+)", r"(\d+) *(?:-|\.\.) *(\d+)", r"(?:at most|up to|<=) *(\d+)"):
        match = re.fullmatch(pattern, said, re.IGNORECASE)
        if match is None:
            continue
        ends = [int(group) for group in match.groups()]
        if len(ends) == 1 and said[0].isdigit():
            return ends
        low, high = (ends[0], ends[1]) if len(ends) == 2 else (size - 1, ends[0])
        low, high = max(low, size - 1), min(high, possible)
        if low <= high:
            return list(range(low, high + 1))
        raise ScenarioError(
            f'--links is "{said}"; to connect {size} users with {possible} possible links it takes {size - 1} to '
            f"{possible}"
        )
    raise ScenarioError(f'--links is "{said}"; it must be a number such as 6, a range such as 4-8, or "at most 8"')


def _result(network: "Network", found: "Plan", every: "LinkCounts | None") -> dict[str, Any]:
    """For JSON: the plan with the users' names."""
    names = {"users": list(network.users), "link_names": [list(names_of(network, a, b)) for a, b in found.best.links]}
    return (found if every is None else every).numbers() | names


def _tell(
    network: "Network", found: "Plan", every: "LinkCounts | None", result: dict[str, Any], *, as_json: bool
) -> None:
    if as_json:
        print_json(result)
        return
    print_plan(network, found)
    if every is not None:
        print_counts(every)
    if "tuned" in result:
        print_tuned(network, result["tuned"])
    for name in result.get("files", ()):
        print(name)  # noqa: T201


def _object(path: Path | None, given: dict[str, float | None], *, read: bool) -> dict[str, Any]:
    """The modes of the file's body where it has one, with what the options say in its place."""
    result: dict[str, Any] = dict(_OBJECT)
    said = {name: value for name, value in given.items() if value is not None}
    if path is not None and read and len(said) < len(given) and "body" in read_toml(path, "scenario", ScenarioError):
        from cotouch.interrupt import interruptible
        from cotouch.planning import modes_of
        from cotouch.scenario import Scenario

        scenario = Scenario.read(path)
        result |= interruptible(lambda: modes_of(scenario.build_body()))()
    return result | said


def _tuned(
    network: "Network", found: "Plan", limit: float, body: dict[str, Any], options: dict[str, Any]
) -> dict[str, Any]:
    """Springs within a limit on damping, and the rate that a free decay in the simulator shows with them.

    With the objective decay, links are chosen anew with the springs.
    """
    from cotouch.planning import plan_springs, tune_springs
    from cotouch.study import confirmed

    rank = 1
    if found.objective == "decay" and options["lost"] == "nothing":
        kept = ("require", "forbid", "max_degree", "drag_limit", "seconds", "seed", "method")
        joint = plan_springs(
            network,
            links=len(found.best.links),
            damping_limit=limit,
            **body,
            **{name: options[name] for name in kept},
        )
        tuned, rank = joint.tuned, joint.rank
    else:
        tuned = tune_springs(network.with_links(found.best.links), damping_limit=limit, **body)
    mass, damping, stiffness = tuned.mode.tolist()
    seen = None
    if tuned.after < 0:
        with suppress(UnsupportedError):  # tuning makes modes decay alike, and a run may not show which is the slowest
            seen = confirmed(tuned.network, tuned.after, mass=mass, damping=damping, stiffness=stiffness)
    return {
        "links": [[user_number(a), user_number(b)] for a, b in tuned.network.links],
        "link_names": [list(names_of(network, a, b)) for a, b in tuned.network.links],
        "rank": rank,
        "spring": [float(tuned.network.spring[a, b]) for a, b in tuned.network.links],
        "damping": tuned.sync_damping.tolist(),
        "damping_limit": limit,
        "start_factor": tuned.start_factor,
        "before": tuned.before,
        "after": tuned.after,
        "simulated": seen,
    }


def _draw(
    path: Path, network: "Network", found: "Plan", every: "LinkCounts | None", options: dict[str, Any]
) -> list[str]:
    """The best choice beside the worst; one objective against the other; what more links bring and cost."""
    from cotouch.drawing import drawn
    from cotouch.planning import knee, networks, ranks, survey

    unit = UNITS[found.objective]
    cases = [
        (f"{word}: {number(choice.value)} {unit}", network.with_links(choice.links))
        for word, choice in (
            ("Best" if found.status == "proved" else "Best found", found.best),
            ("Worst" if found.worst_status == "proved" else "Worst found", found.worst),
        )
    ]
    figures = {"networks": networks(cases)}
    kept = ("require", "forbid", "max_degree", "damping_limit", "drag_limit", "mass", "damping", "stiffness")
    limits = {name: options[name] for name in kept}
    grid = {name: options[name] for name in ("convention", "time_unit", "rounding")}
    if found.choices <= _MOST_RANKED and options["lost"] == "nothing":
        sides = {"consensus": grid | {"objective": "consensus"}, "decay": {"objective": "decay"}}
        values = survey(network, links=len(found.best.links), objectives=sides, **limits).values
        figures["ranks"] = ranks(("Consensus", values["consensus"]), ("Decay / (1/s)", values["decay"]))
    steps = _knee(
        network, found, every, options["seconds"], limits | {"lost": options["lost"], "seed": options["seed"]}
    )
    if steps:
        figures["knee"] = knee(*zip(*steps, strict=True), chosen=len(found.best.links))
    names: list[str] = []
    for name, figure in figures.items():
        write(path / f"{name}.png", drawn(figure, dpi=200), "figure")
        names.append(str(path / f"{name}.png"))
    return names


def _knee(
    network: "Network", found: "Plan", every: "LinkCounts | None", seconds: float | None, limits: dict[str, Any]
) -> list[tuple[int, float, float]]:
    """Links, decay and largest damping of the fastest choice with each number of links around the one found.

    What the plan itself found is shown as it is, so that figure and plan agree.
    """
    from cotouch.errors import NetworkError
    from cotouch.planning import plan

    plans = (found,) if every is None else every.plans
    known = {len(one.best.links): one.best for one in plans if one.objective == "decay"}
    asked = len(found.best.links)
    # All of them together take half the time limit at most.
    each = _KNEE_SECONDS if seconds is None else min(_KNEE_SECONDS, seconds / 16)
    result: list[tuple[int, float, float]] = []
    for links in sorted({*range(max(network.size - 1, asked - 4), asked + 5), *known}):
        try:
            best = (
                known.get(links)
                or plan(network, links=links, objective="decay", top=1, limit=_MOST_RANKED, seconds=each, **limits).best
            )
        except NetworkError:
            continue
        result.append((links, best.value, float(best.damping.max())))
    return result if any(links == asked for links, _, _ in result) else []


def _pairs(network: "Network", option: str, texts: Sequence[str]) -> list[tuple[int, int]]:
    """Links such as 1-2 or Ann-Ben; several may stand in one text."""
    result: list[tuple[int, int]] = []
    for text in texts:
        for part in text.split(",") if "," in text or any(" " in user for user in network.users) else text.split():
            said = part.strip()
            if not said:
                continue
            cuts = [(said[:at], said[at + 1 :]) for at, letter in enumerate(said) if letter == "-"]
            users = [(_user(network, a.strip()), _user(network, b.strip())) for a, b in cuts]
            pairs = [(a, b) for a, b in users if a is not None and b is not None]
            if len(pairs) != 1:
                many = "can be read in several ways" if pairs else "is no link"
                raise ScenarioError(
                    f'{option} is "{said}", which {many}; a link is two users by number or name, such as 1-2'
                )
            result.append(pairs[0])
    return result


def _user(network: "Network", said: str) -> int | None:
    """Index of a user by name or else by number; a number beyond the last user is left to the planner to refuse."""
    if said in network.users:
        return network.users.index(said)
    return user_index(int(said)) if re.fullmatch(r"[0-9]{1,9}", said) else None


@contextmanager
def _progress(*, quiet: bool) -> Generator[Callable[[int, int, float], None] | None]:
    """Shows on standard error how far the search is."""
    if quiet or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console

    with Console(stderr=True).status("Looking at links ...") as status:

        def show(done: int, total: int, best: float) -> None:
            fraction = f"{done} of {total}" if total else "proving"
            status.update(f"Looking at links: {fraction}, best {best:.6g} (Ctrl-C takes it)")

        yield show
