"""What `cotouch plan` does with the links that it found: springs, and figures."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Literal, TypedDict, TypeVar

import numpy.typing as npt

from cotouch.cli._output import number
from cotouch.cli._plan_tables import LABELS, UNITS, TunedSprings
from cotouch.errors import NetworkError, UnsupportedError
from cotouch.files import write
from cotouch.interrupt import check, interruptible
from cotouch.network import Convention, Network, Pair, Rounding
from cotouch.planning import (
    JointInterrupted,
    LinkCounts,
    Lost,
    Objective,
    Plan,
    ProblemOptions,
    SearchMethod,
    Tuned,
    TuningInterrupted,
    knee,
    networks,
    plan,
    plan_springs,
    ranks,
    survey,
    tune_springs,
    until,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure


T = TypeVar("T")

DRAWN = ("networks", "ranks", "knee")
# Up to so many choices every one of them is ranked by both objectives.
_MOST_RANKED = 20_000
# For each number of links in the figure of the knee, at most [s]; and how many there are on either side.
_KNEE_SECONDS, _AROUND = 5.0, 4
# Of the time for tuning, what the search gets; the rest is for a run beside its prediction. And the least of it.
_OF_TUNING, _LEAST_TUNING = 0.85, 0.3
# Loading the simulator's kernels takes about so long, and hears no flag [s].
_LOADING = 2.0


class ObjectOptions(TypedDict):
    """The object by its modes: mass [kg], damping [Ns/m] and stiffness [N/m]."""

    mass: npt.ArrayLike
    damping: npt.ArrayLike
    stiffness: npt.ArrayLike


class Asked(ObjectOptions):
    """Options of the plan, each with a value; see `plan`."""

    objective: Objective
    convention: Convention
    time_unit: float
    rounding: Rounding
    require: Sequence[Pair]
    forbid: Sequence[Pair]
    max_degree: int | None
    damping_limit: float | None
    drag_limit: float | None
    lost: Lost
    top: int
    method: Literal["auto"] | SearchMethod
    seconds: float | None
    seed: int
    dask: str | None


class Extras(TypedDict, total=False):
    """What a plan says besides: tuned springs, and files that were drawn."""

    tuned: TunedSprings
    files: list[str]


def tuned(
    result: Extras,
    network: Network,
    found: Plan,
    limit: float,
    options: Asked,
) -> None:
    """Springs within a limit on damping, and the rate that a free decay in the simulator shows with them.

    With the objective decay, links are chosen anew with the springs.

    Args:
        result: gets an entry "tuned", also where the work is interrupted.
        network: whose springs are where tuning starts.
        found: the links.
        limit: on damping [Ns/m].
        options: of the plan.
    """
    begun, seconds = monotonic(), options["seconds"]
    from cotouch.study import confirmed

    if seconds is not None:  # loading took its share, and a run beside the prediction takes one
        options = {**options, "seconds": _OF_TUNING * max(seconds - monotonic() + begun, _LEAST_TUNING * seconds)}
    limit = limit if options["damping_limit"] is None else min(limit, options["damping_limit"])
    drag = options["drag_limit"]
    body: ObjectOptions = {"mass": options["mass"], "damping": options["damping"], "stiffness": options["stiffness"]}

    def kept(one: Tuned, rank: int | None = 1) -> TunedSprings:
        users = network.users
        told = result["tuned"] = {
            "links": [[users[a], users[b]] for a, b in one.network.links],
            "rank": rank,
            "spring": [float(one.network.spring[a, b]) for a, b in one.network.links],
            "damping": one.sync_damping.tolist(),
            "damping_limit": limit,
            "start_factor": one.start_factor,
            "before": one.before,
            "after": one.after,
            "simulated": None,
        }
        return told

    try:
        if found.objective == "decay" and options["lost"] == "nothing":
            joint = plan_springs(
                network,
                links=len(found.best.links),
                damping_limit=limit,
                drag_limit=drag,
                ranked=found,
                require=options["require"],
                forbid=options["forbid"],
                max_degree=options["max_degree"],
                seconds=options["seconds"],
                seed=options["seed"],
                method=options["method"],
                **body,
            )
            best = joint.tuned
            told = kept(best, joint.rank)
        else:
            linked = network.with_links(found.best.links)
            best = tune_springs(linked, damping_limit=limit, drag_limit=drag, seconds=options["seconds"], **body)
            told = kept(best)
    except JointInterrupted as interrupted:
        kept(interrupted.joint.tuned, interrupted.joint.rank)
        raise
    except TuningInterrupted as interrupted:
        kept(interrupted.tuned)
        raise
    mass, damping, stiffness = best.mode.tolist()
    if best.after < 0:
        with suppress(UnsupportedError):  # tuning makes modes decay alike, and a run may not show which is the slowest
            told["simulated"] = _within(
                None if seconds is None else begun + seconds,
                lambda: confirmed(best.network, best.after, mass=mass, damping=damping, stiffness=stiffness),
            )


def _within(deadline: float | None, work: Callable[[], T]) -> T | None:
    """What a function gives, or None if that lasts beyond a time of `monotonic`, or can hardly do otherwise."""
    if deadline is not None and deadline - monotonic() < _LOADING:
        return None

    def limited() -> T | None:
        try:
            with until(lambda: deadline is not None and monotonic() >= deadline):
                return work()
        except KeyboardInterrupt:
            check()
            return None

    return interruptible(limited)()


def draw(path: Path, network: Network, found: Plan, every: LinkCounts | None, options: Asked) -> list[str]:
    """The best choice beside the worst; one objective against the other; what more links bring and cost.

    Args:
        path: of a folder.
        network: which was planned for.
        found: the plan.
        every: plans for several numbers of links, if there are.
        options: of the plan.

    Returns:
        Names of the files.
    """
    from cotouch.drawing import drawn

    unit, seconds = UNITS[found.objective], options["seconds"]
    deadline = None if seconds is None else monotonic() + seconds
    cases = [
        (f"{word}: {number(choice.value)} {unit}", network.with_links(choice.links))
        for word, choice in (
            ("Best" if found.status == "proved" else "Best found", found.best),
            ("Worst" if found.worst_status == "proved" else "Worst found", found.worst),
        )
    ]
    figures = {
        "networks": networks(cases),
        "ranks": _within(deadline, lambda: _ranks(network, found, options)),
        "knee": _knee(network, found, every, deadline, options),
    }
    names: list[str] = []
    for name, figure in figures.items():
        if figure is not None:
            write(path / f"{name}.png", drawn(figure, dpi=200), "figure")
            names.append(str(path / f"{name}.png"))
    return names


def _ranks(network: Network, found: Plan, options: Asked) -> "Figure | None":
    """Consensus against decay; None where there are too many choices, or the delays are on no grid."""
    if found.choices > _MOST_RANKED or options["lost"] != "nothing":
        return None
    limits: ProblemOptions = {
        "require": options["require"],
        "forbid": options["forbid"],
        "max_degree": options["max_degree"],
        "damping_limit": options["damping_limit"],
        "drag_limit": options["drag_limit"],
        "mass": options["mass"],
        "damping": options["damping"],
        "stiffness": options["stiffness"],
    }
    sides: dict[str, ProblemOptions] = {
        "consensus": {
            "objective": "consensus",
            "convention": options["convention"],
            "time_unit": options["time_unit"],
            "rounding": options["rounding"],
        },
        "decay": {"objective": "decay"},
    }
    try:
        values = survey(network, links=len(found.best.links), objectives=sides, **limits).values
    except NetworkError:
        return None
    return ranks(("Consensus", values["consensus"]), ("Decay / (1/s)", values["decay"]))


def _knee(
    network: Network,
    found: Plan,
    every: LinkCounts | None,
    deadline: float | None,
    options: Asked,
) -> "Figure":
    """The objective and its cost with each number of links that was asked for, or of some around the only one.

    What the plan itself found is shown as it is, so that figure and plan agree. The numbers around begin from it, so
    that none looks worse for the time it was given.
    """
    plans = {len(one.best.links): one for one in ((found,) if every is None else every.plans)}
    asked = len(found.best.links)
    possible = len(network.with_links(None).links) - len(options["forbid"])
    around = [] if every else [links for step in range(1, _AROUND + 1) for links in (asked - step, asked + step)]
    for place, links in enumerate(around):
        if not network.size - 1 <= links <= possible:
            continue
        each = _KNEE_SECONDS
        if deadline is not None:
            each = min(each, (deadline - monotonic()) / (len(around) - place))
        if each <= 0.0:
            break
        begin = plans.get(links + (1 if links < asked else -1), found).best.links
        with suppress(NetworkError, UnsupportedError):
            given: Asked = {**options, "seconds": each}
            plans[links] = plan(network, links=links, begin=begin, limit=_MOST_RANKED, **given)
    shown = [plans[links] for links in sorted(plans)]
    label, cost = LABELS[found.objective]
    sign = -1.0 if found.objective == "decay" else 1.0
    return knee(
        [len(one.best.links) for one in shown],
        (label, [sign * one.best.value for one in shown]),
        (cost, [one.best.drag if found.objective == "damping" else float(one.best.damping.max()) for one in shown]),
        chosen=asked,
        bend=None if every is None else len(every.knee.best.links),
        proved=[one.status == "proved" for one in shown],
    )
