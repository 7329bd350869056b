"""The planner: which links to use."""

import math
import threading
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal, TypeAlias, final, get_args

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Long
from cotouch.errors import NetworkError, UnsupportedError
from cotouch.interrupt import Flag, check, finishing, flag, heeding, interruptible
from cotouch.network import Convention, Network, Rounding
from cotouch.planning._bound import SLICE, descend, dive_into, has_room, some_choice
from cotouch.planning._deadline import in_real_time
from cotouch.planning._enumerate import BestChoices, chosen_at, enumerated
from cotouch.planning._local import Begin, walked, worked_out
from cotouch.planning._problem import Lost, Objective, Problem, impossible, make_problem, questions
from cotouch.planning._ready import compiles, warm
from cotouch.planning._relaxation import bound_of
from cotouch.planning._result import Choice, Plan, SearchMethod, choice_of, shown
from cotouch.planning._starts import WALKS, begun_at
from cotouch.planning._task import NOTHING
from cotouch.planning._workers import Workers, workers

Progress: TypeAlias = Callable[[int, int, float], None]

# More choices than this are not enumerated unasked: minutes for consensus and decay.
_ENUMERABLE = 2_000_000
_STARTS = 64
# Choices returned, at most: each is worked out.
_MOST_SHOWN = 1000
# Ranks of choices must fit the kernels' whole numbers.
_RANKS = 2**62
# Of the time budget, what is left for the floods under way; how often the clock is looked at beside the kernels [s].
_RESERVE, _LOOK = 0.05, 0.02
# What was found is still told for so long after Ctrl-C [s].
_TOLD = 0.3
_BOUNDED = ("damping", "drag")  # have branch and bound
_REACHED = 3e-9  # so near to a bound, as a share, is at the bound


class PlanInterrupted(KeyboardInterrupt):
    """A plan was interrupted from the keyboard after it had found something.

    Attributes:
        plan: with the best found so far.
    """

    def __init__(self, plan: Plan) -> None:
        super().__init__("the plan was interrupted")
        self.plan = plan


@final
@dataclass
class _Search:
    """What a search knows so far.

    Attributes:
        problem: the search.
        tick: told what is done, the total and the best; answers whether the time is up.
        kept: objectives of choices worked out, as `rate` gives them.
        graphs: connected ones looked at.
        looked: all looked at.
        periodic: graphs that never mix.
        unsure: graphs that nothing could tell for certain.
    """

    problem: Problem
    tick: Callable[[int, int, float], bool]
    kept: dict[tuple[int, ...], float] = field(default_factory=dict[tuple[int, ...], float])
    graphs: int = 0
    looked: int = 0
    periodic: int = 0
    unsure: int = 0

    def keep(self, chosen: Long, value: float) -> None:
        """Takes up one choice."""
        self.kept[tuple(chosen.tolist())] = value

    def enough(self, done: int, total: int) -> bool:
        """Says how far the search is; answers whether the time is up."""
        best = min(self.kept.values(), default=None)
        return self.tick(done, total, np.inf if best is None else shown(self.problem, best))


@interruptible
def plan(
    network: Network,
    *,
    links: int,
    objective: Objective = "consensus",
    convention: Convention = "equation",
    time_unit: float = 0.01,
    rounding: Rounding = "exact",
    require: Iterable[Sequence[int]] = (),
    forbid: Iterable[Sequence[int]] = (),
    max_degree: int | None = None,
    damping_limit: float | None = None,
    drag_limit: float | None = None,
    lost: Lost = "nothing",
    mass: npt.ArrayLike = 1.0,
    damping: npt.ArrayLike = 0.0,
    stiffness: npt.ArrayLike = 0.0,
    sync_damping: npt.ArrayLike | None = None,
    begin: Iterable[Sequence[int]] = (),
    top: int = 5,
    method: Literal["auto"] | SearchMethod = "auto",
    limit: int = _ENUMERABLE,
    starts: int = _STARTS,
    seed: int = 0,
    seconds: float | None = None,
    clock: Callable[[], float] = time.monotonic,
    progress: Progress | None = None,
    jobs: int = -1,
    dask: str | None = None,
) -> Plan:
    """Finds the links, of a given number, that serve an objective best. **Beyond** the paper, which tries all.

    Out of time it returns the best found so far; interrupted from the keyboard it raises that.

    Args:
        network: users, springs and delays; pairs with a spring may be linked. Its present links do not matter.
        links: how many links.
        objective: "consensus": second largest |eigenvalue| of the consensus model (`network.mixing`); "decay": real
            part of the rightmost root of the closed loop [1/s] (`network.rightmost_root`), of the slowest body mode;
            "damping": largest `B_i` [Ns/m] of the rule with the delays as ages; "drag": what all users together feel
            per speed of a steady common motion [Ns/m], `Choice.drag`; "feel": the largest that any user's hand feels
            beyond the object itself, `|Z_i - Z|` from 0.2 to 2 Hz [Ns/m]. Smaller is better.
        convention: of the consensus, see `network.mixing`.
        time_unit: s, of the consensus.
        rounding: of delays to time units, see `network.mixing`.
        require: pairs of user indices (from 0) that every choice links.
        forbid: pairs that none links.
        max_degree: largest number of links of one user; None for no limit.
        mass: kg, of the body or of each of its modes.
        damping: Ns/m, likewise.
        stiffness: N/m, likewise.
        sync_damping: (N,) `B_i` in Ns/m of every choice for "decay", "drag" and "feel"; None takes the rule.
        begin: links that the local search also begins at, such as those of a plan with one link less.
        top: how many of the best choices to return.
        damping_limit: Ns/m that no `B_i` of the rule may exceed.
        drag_limit: Ns/m that the drag of all users together may not exceed, `Choice.drag`.
        lost: "link" or "user" makes the objective that of the worst case, with any one of them lost or none.
        method: "enumerate" looks at every choice; "bound" leaves out what cannot be best (damping and drag); "local"
            swaps links from many random starts and proves nothing; "auto" enumerates up to `limit` choices, beyond
            that bounds the damping and searches locally for the others.
        limit: of choices for "auto".
        starts: of the local search.
        seed: of the random starts.
        seconds: time budget; None for none. Compilation, once on a machine, is not part of it.
        clock: seconds that only grow.
        progress: called now and then, maybe in another thread, with what is done, the total (0 if unknown) and the
            best objective so far.
        jobs: threads; -1 for one per core.
        dask: address of a Dask scheduler that shares the work.

    Raises:
        NetworkError: no choice of links can be as asked for, or an argument is out of its range.
        UnsupportedError: decay or feel with springs that have weights, or no Dask; or nothing could be told for certain
            in the time given.
        PlanInterrupted: a `KeyboardInterrupt` that holds what was found by then.
    """
    begun = clock()
    problem = make_problem(
        network,
        links=links,
        objective=objective,
        convention=convention,
        time_unit=time_unit,
        rounding=rounding,
        require=require,
        forbid=forbid,
        max_degree=max_degree,
        damping_limit=damping_limit,
        drag_limit=drag_limit,
        lost=lost,
        mass=mass,
        damping=damping,
        stiffness=stiffness,
        sync_damping=sync_damping,
    )
    chosen_method = _method(problem, method, limit)
    for name, value in (("top", top), ("starts", starts), ("limit", limit)):
        if value < 1:
            raise NetworkError(f"{name} is {value}; it must be at least 1")
    if top > _MOST_SHOWN:
        raise NetworkError(f"top is {top}; it must be at most {_MOST_SHOWN}")
    if seed < 0:
        raise NetworkError(f"seed is {seed}; it must be at least 0")
    if jobs != -1 and jobs < 1:
        raise NetworkError(f"jobs is {jobs}; it must be at least 1, or -1 for one per core")
    if seconds is not None and not seconds > 0:
        raise NetworkError(f"the time limit (seconds) is {seconds:g}; it must be above 0")
    if seconds is not None and compiles(chosen_method, objective):
        before = clock()
        warm(objective, chosen_method, plan)
        begun += clock() - before

    def late(fraction: float = 1.0) -> bool:
        return seconds is not None and clock() - begun >= fraction * seconds

    def tick(done: int, total: int, best: float) -> bool:
        if progress is not None:
            progress(done, total, best)
        return late()

    stop, ending, telling = (np.zeros(1, dtype=np.int64) for _ in range(3))
    problem = replace(problem, task=problem.task._replace(stop=stop))
    closing = 1.0 - _RESERVE if chosen_method == "local" else 1.0
    search = _Search(problem, tick)
    covered = proved = interrupted = False
    fallback, notes = None, questions(problem)
    over = threading.Event()

    def watch(asked: Flag) -> None:
        # A kernel may last longer than the budget; what it was at is worth little.
        heard = math.inf
        while not over.wait(_LOOK):
            timed = in_real_time(clock)
            if search.kept:
                finishing(asked)
            if asked[0]:
                heard = min(heard, time.monotonic())
            if asked[0] or (timed and late(closing)):
                stop[0] = 1
            if asked[0] or (timed and late(1.0 + 0.5 * _RESERVE)):
                ending[0] = 1
            if time.monotonic() - heard > _TOLD or (timed and late(1.0 + _RESERVE)):
                telling[0] = 1

    threading.Thread(target=watch, args=(flag(),), name="cotouch deadline", daemon=True).start()
    try:
        try:
            if problem.choices > limit or chosen_method != "enumerate":
                fallback = some_choice(problem)
                if fallback is None:
                    raise impossible(problem)
            with workers(jobs, dask) as hands:
                if chosen_method == "enumerate":
                    covered = proved = _enumerate(search, top, hands)
                elif fallback is not None:
                    floods = WALKS if chosen_method == "bound" else starts
                    at = (begun_at(problem, begin), fallback)
                    walked_all = _walk(search, floods, seed, at, hands, lambda: late(closing), ending)
                    proved = chosen_method == "bound" and walked_all and has_room(problem) and _bound(search, top)
                notes += hands.notes
        except KeyboardInterrupt:
            if not search.kept:
                raise
            interrupted = True
        lowered: Flag = np.zeros(1, dtype=np.int64) if interrupted else flag()
        if not search.kept:
            search.keep(*_at_least(problem, fallback, lowered))
        with heeding(telling):
            choices = _choices(replace(problem, task=problem.task._replace(stop=telling)), search.kept, top)
    finally:
        over.set()
    covered, proved = covered and not search.unsure, proved and not search.unsure
    if search.periodic and search.periodic == search.graphs:
        proved = False
        notes += (
            f"On a grid of {problem.stride * time_unit:g} s all {search.graphs} graphs are periodic and never mix: "
            "none is better than another. Choose another time unit or the objective decay.",
        )
    bound, bound_by = (choices[0].value, "every choice is covered") if proved else bound_of(problem)
    if not proved and bound is not None and choices[0].value <= bound + _REACHED * abs(bound):
        proved, bound = True, choices[0].value
        notes += ("Those after the first are the best found, not proved.",) * (len(choices) > 2)
    found = Plan(
        users=problem.network.users,
        objective=objective,
        status="proved" if proved else "best found",
        worst_status="proved" if covered else "worst found",
        method=chosen_method,
        best=choices[0],
        worst=choices[-1],
        top=tuple(choices[:-1]),
        choices=problem.choices,
        graphs=search.graphs,
        looked_at=search.looked,
        periodic=search.periodic,
        unsure=search.unsure,
        seed=seed,
        seconds=clock() - begun,
        notes=notes,
        bound=bound,
        bound_by=bound_by,
    )
    if interrupted:
        raise PlanInterrupted(found)
    return found


def _at_least(problem: Problem, fallback: Long | None, asked: Flag) -> tuple[Long, float]:
    """One choice and its objective, where the search was stopped before it had any; that takes what it takes."""
    problem = replace(problem, task=problem.task._replace(stop=asked))
    fallback = some_choice(problem) if fallback is None else fallback
    if fallback is None:
        raise impossible(problem)
    value = worked_out(problem, problem.task, fallback)
    check()
    if value is None:
        raise UnsupportedError(
            f"the {problem.objective} of no choice of {problem.links} links could be determined reliably; give "
            "the search more time"
        )
    return fallback, value


def _choices(problem: Problem, kept: dict[tuple[int, ...], float], top: int) -> list[Choice]:
    """Everything about the best and the worst."""
    ranked = sorted((value, chosen) for chosen, value in kept.items())
    worst = next(entry for entry in ranked if entry[0] == ranked[-1][0])
    told = {chosen: choice_of(problem, np.array(chosen), value) for value, chosen in {*ranked[:top], worst}}
    return [told[chosen] for _, chosen in [*ranked[:top], worst]]


def _method(problem: Problem, method: str, limit: int) -> SearchMethod:
    if method == "auto":
        if problem.choices <= limit:
            return "enumerate"
        return "bound" if problem.objective in _BOUNDED else "local"
    for known in get_args(SearchMethod):
        if method == known:
            if known == "bound" and problem.objective not in _BOUNDED:
                raise NetworkError(
                    f'method is "bound" but objective is "{problem.objective}", which has no bound; '
                    'choose "enumerate" or "local"'
                )
            if known == "enumerate" and problem.choices > _RANKS:
                raise NetworkError(f'method is "enumerate" but there are {problem.choices} choices; choose "local"')
            return known
    raise NetworkError(f'method is "{method}"; it must be "auto", "enumerate", "bound" or "local"')


def _enumerate(search: _Search, top: int, hands: Workers) -> bool:
    """Every choice; answers whether the end was reached."""
    found: BestChoices
    for found in enumerated(search.problem, top, hands.parallel, hands.jobs):
        search.kept = {
            tuple(chosen_at(search.problem, rank).tolist()): value
            for rank, value in zip(found.ranks, found.values, strict=True)
        }
        search.graphs, search.looked = found.connected, found.looked
        search.periodic, search.unsure = found.periodic, found.unsure
        if search.enough(found.looked, search.problem.choices) and found.looked < search.problem.choices:
            return False
    return not search.problem.task.stop[0]  # A stretch that was stopped counts as looked at.


def _walk(
    search: _Search,
    starts: int,
    seed: int,
    begin: Begin,
    hands: Workers,
    closing: Callable[[], bool],
    ending: Flag,
) -> bool:
    """Local search; answers whether every walk came to its end."""
    looked: dict[int, int] = {}
    unsure: dict[int, int] = {}
    over, problem = 0, search.problem
    if problem.task.lost != NOTHING:  # every loss takes its time: there is an answer before the first walk has one
        value = worked_out(problem, problem.task, begin[1], slowly=False)
        if value is not None:
            search.keep(begin[1], value)
    for walk in walked(problem, starts, seed, begin, hands.parallel, closing, ending):
        for value, chosen in walk.seen:
            search.keep(np.array(chosen), value)
        looked[walk.start], unsure[walk.start] = walk.looked, walk.unsure
        search.graphs = search.looked = sum(looked.values())
        search.unsure = sum(unsure.values())
        over += walk.over
        if search.enough(over, starts) and over < starts:
            return False
    return over >= starts


def _bound(search: _Search, top: int) -> bool:
    """Branch and bound below what the local search found."""
    ranked = sorted(search.kept.values())
    ceiling = ranked[top - 1] * (1.0 + 1e-9) if len(ranked) >= top else np.inf
    dive = dive_into(search.problem, top)
    graphs, looked, over = search.graphs, search.looked, False
    while not over:
        over = descend(search.problem.task, dive, ceiling, SLICE, False)
        check()
        for value, chosen in zip(dive.values, dive.choices, strict=True):
            if np.isfinite(value):
                search.keep(chosen, float(value))
        search.graphs, search.looked = graphs + int(dive.counts[1]), looked + int(dive.counts[2])
        if not over and search.enough(0, 0):
            return False
    return True
