"""`cotouch plan`."""

import csv
import math
import re
import sys
import time
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

from rich.console import Console

from cotouch.cli._output import number, print_json, working
from cotouch.cli._plan_extras import DRAWN, Asked, Extras, ObjectOptions, draw, tuned
from cotouch.cli._plan_tables import UNITS, print_counts, print_plan, print_tuned, said_links
from cotouch.errors import NetworkError, ScenarioError
from cotouch.files import beside, folder, read_toml
from cotouch.network import Network, consensus_lags
from cotouch.planning import (
    FIRST,
    CountsInterrupted,
    LinkCounts,
    Plan,
    PlanInterrupted,
    ProblemOptions,
    compiles,
    first_choice,
    plan,
    plan_counts,
)
from cotouch.units import user_index

# What a part of the work has where the limit of time is used up [s].
_LEAST_SECONDS = 0.1
# Of the paper's consensus model [s].
_TIME_UNIT = 0.01
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
    network = _network(path, delays, pick, spring, quantile)
    options["objective"] = options["objective"] or _objective(network, options["time_unit"], options["rounding"])
    counts = _counts(links, network.size, len(network.with_links(None).links))
    moving = options["objective"] != "consensus" or tune is not None or figures is not None
    body = _object(path, {name: options[name] for name in _OBJECT}, read=moving)
    options |= body
    options |= {"require": _pairs(network, "--require", require), "forbid": _pairs(network, "--forbid", forbid)}
    if tune is not None and not 0 < tune < math.inf:
        raise NetworkError(f"--tune-springs is {tune:g} Ns/m; it must be finite and above 0")
    if figures is not None:
        beside(folder(figures), [f"{name}.png" for name in DRAWN], (*delays, *([] if path is None else [path])))
    seconds, top = options.pop("seconds", None), int(options.pop("top", 5))
    # A limit of time is shared by all that searches.
    parts = 1 + (tune is not None) + (figures is not None)
    shared = None if seconds is None else seconds / parts
    asked = cast("Asked", options | {"seconds": shared, "top": top if tune is None else max(top, FIRST)})
    if compiles(asked["method"], asked["objective"]):
        _first(network, counts, asked)
    every: LinkCounts | None = None
    result: Extras = {}
    with _progress(quiet=as_json) as progress:
        try:
            if len(counts) > 1:
                every = plan_counts(network, links=counts, progress=progress, **asked)
                found = every.best
            else:
                found = plan(network, links=counts[0], progress=progress, **asked)
        except PlanInterrupted as interrupted:
            every = interrupted.counts if isinstance(interrupted, CountsInterrupted) else None
            _tell(interrupted.plan, every, result, top, as_json=as_json)
            raise
    left = None if seconds is None else seconds - sum(one.seconds for one in (every.plans if every else (found,)))
    try:
        if tune is not None:
            begun, share = time.monotonic(), _share(left, parts - 1)
            with working("Tuning springs ...", quiet=as_json):
                tuned(result, network, found, tune, {**asked, "seconds": share})
            left = None if left is None else left - time.monotonic() + begun
        if figures is not None:
            with working("Drawing ...", quiet=as_json):
                result["files"] = draw(figures, network, found, every, {**asked, "seconds": _share(left, 1), "top": 1})
    except KeyboardInterrupt:
        _tell(found, every, result, top, as_json=as_json)
        raise
    _tell(found, every, result, top, as_json=as_json)


def _share(left: float | None, parts: int) -> float | None:
    """Of the time that is left, for one of so many parts [s]."""
    return None if left is None else max(left / parts, _LEAST_SECONDS)


def _objective(network: Network, time_unit: float, rounding: str) -> str:
    """Which objective is meant where none is named: measured delays are on no grid, so consensus has none."""
    if time_unit != _TIME_UNIT or rounding != "exact":
        return "consensus"
    try:
        consensus_lags(network.with_links(None), time_unit=time_unit, convention="matrix", rounding="exact")
    except NetworkError:
        sys.stderr.write(
            f"cotouch: the delays are not multiples of {time_unit:g} s, so links are chosen for the fastest decay "
            "(--objective decay)\n"
        )
        return "decay"
    return "consensus"


def _first(network: Network, counts: Sequence[int], options: Asked) -> None:
    """Something to begin with while kernels compile, on standard error."""
    print("Compiling, which takes about two minutes, once on this machine.", file=sys.stderr)  # noqa: T201
    kept = ("top", "method", "seconds", "seed", "jobs", "dask")
    asked = cast("ProblemOptions", {name: option for name, option in options.items() if name not in kept})
    found = first_choice(network, links=counts[0], seed=options["seed"], **asked)
    if found is None:
        return
    unit = UNITS[options["objective"]]
    value = "" if found.value is None else f", about {number(found.value)} {unit}".rstrip()
    pairs = said_links(network.users, found.links)
    print(  # noqa: T201
        f"Meanwhile, the best of {found.tried} choices of {counts[0]} links, not certified{value}: {pairs}",
        file=sys.stderr,
    )


def _network(path: Path | None, delays: Sequence[Path], pick: str | None, spring: float, quantile: float) -> Network:
    """The file's network, or that of a table of round trips."""
    if delays:
        if path is not None:
            raise ScenarioError(f"{path} and --delays both give users and delays; use only one of them")
        names = [] if pick is None else _names(pick)
        return Network.from_delays(delays, pick=names, spring=spring, quantile=quantile)
    if path is None:
        raise ScenarioError("no network is given; name a TOML file, or give a table of round trips with --delays")
    if pick is not None:
        raise ScenarioError("--pick selects users of a table of round trips; give one with --delays")
    for name, value, usual in (("--spring", spring, 50.0), ("--quantile", quantile, 1.0)):
        if value != usual:
            raise ScenarioError(
                f"{name} is {value:g}, but it applies only to a table of round trips; give one with --delays"
            )
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
            f'--links is "{said}"; connecting {size} users with {possible} possible links takes {size - 1} to '
            f"{possible}"
        )
    given = f'is "{said}"' if said else "is missing"
    raise ScenarioError(f'--links {given}; it must be a number such as 6, a range such as 4-8, or "at most 8"')


def _tell(
    found: Plan,
    every: LinkCounts | None,
    result: Extras,
    top: int,
    *,
    as_json: bool,
) -> None:
    """Prints the plan with the `top` best choices, and whatever else there is."""
    found = replace(found, top=found.top[:top])
    if as_json:
        print_json((found if every is None else replace(every, best=found)).numbers() | {**result})
        return
    print_plan(found)
    if every is not None:
        print_counts(every)
    if "tuned" in result:
        print_tuned(result["tuned"])
    for name in result.get("files", ()):
        print(name)  # noqa: T201


def _object(path: Path | None, given: dict[str, float | None], *, read: bool) -> ObjectOptions:
    """The modes of the file's body where it has one, with what the options say in its place."""
    said = {name: value for name, value in given.items() if value is not None}
    if path is not None and read and len(said) < len(given) and "body" in read_toml(path, "scenario", ScenarioError):
        from cotouch.interrupt import interruptible
        from cotouch.planning import modes_of
        from cotouch.scenario import Scenario

        scenario = Scenario.read(path)
        modes = interruptible(lambda: modes_of(scenario.build_body()))()
    else:
        modes = _OBJECT
    return cast("ObjectOptions", {**modes, **said})


def _pairs(network: Network, option: str, texts: Sequence[str]) -> list[tuple[int, int]]:
    """Links such as 1-2 or Ann-Ben; several may stand in one text, in quotes where a name has a comma."""
    result: list[tuple[int, int]] = []
    for text in texts:
        parts = [text.strip()]
        if not _readings(network, parts[0]):
            spaced = "," in text or any(" " in user for user in network.users)
            parts = _names(text) if spaced else text.split()
        for said in parts:
            if not said:
                continue
            pairs = _readings(network, said)
            if len(pairs) != 1:
                many = "can be read in several ways" if pairs else "is not a link"
                raise ScenarioError(
                    f'{option} is "{said}", which {many}; a link is two users by number or name, such as 1-2'
                )
            result.append(pairs[0])
    return result


def _readings(network: Network, said: str) -> list[tuple[int, int]]:
    """The links that a text may stand for: names may have dashes."""
    cuts = [(said[:at], said[at + 1 :]) for at, letter in enumerate(said) if letter == "-"]
    users = [(_user(network, a.strip()), _user(network, b.strip())) for a, b in cuts]
    return [(a, b) for a, b in users if a is not None and b is not None]


def _names(text: str) -> list[str]:
    """What stands between commas; a part that has one is in quotes."""
    return [name for part in csv.reader([text], skipinitialspace=True) for name in map(str.strip, part) if name]


def _user(network: Network, said: str) -> int | None:
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

    with Console(stderr=True).status("Searching ...") as status:

        def show(done: int, total: int, best: float) -> None:
            fraction = f"{done} of {total}" if total else "proving"
            status.update(f"Searching: {fraction}, best {best:.6g} (Ctrl-C accepts it)")

        yield show
