"""Every choice of links, in stretches that a kernel works off and several cores or machines share."""

import itertools
import math
from collections.abc import Generator, Sequence
from typing import Any, NamedTuple

import numpy as np

from cotouch.arrays import Bool, Float, Long
from cotouch.compiled import raised, routine
from cotouch.interrupt import check
from cotouch.planning._judge import between
from cotouch.planning._problem import Problem
from cotouch.planning._task import CONSENSUS, Task, admissible, period_of, rate
from cotouch.planning._workers import Parallel

# Stretches long enough to hide their start, short enough to share and to stop between. They depend on the problem
# alone, so that the result doesn't depend on the machine.
_SHORTEST, _LONGEST, _STRETCHES = 26, 512, 64
# By so much of its value a choice must be worse than the best for sure to be left out.
_MARGIN = 1e-9
# Choices whose objective takes no roots are done this much faster.
_QUICK = 64
# So few choices are worked off one stretch after the other.
_ALONE = 512
# Stretches per core between looks at the clock.
_ROUND = 2


class BestChoices(NamedTuple):
    """What a stretch of choices holds.

    Attributes:
        ranks: of the best choices and the worst, the rank among all choices.
        values: their objectives, as `rate` gives them.
        looked: how many choices were looked at.
        connected: how many of them are admissible.
        periodic: how many of these have objective 0 in a consensus.
        unsure: how many of these nothing could tell for certain; they are not among the best.
    """

    ranks: tuple[int, ...]
    values: tuple[float, ...]
    looked: int
    connected: int
    periodic: int
    unsure: int


def unrank(rank: int, count: int, pick: int) -> Long:
    """Combination number `rank`, in lexicographic order, of `pick` out of `count`.

    Args:
        rank: from 0, below the number of combinations.
        count: out of so many, numbered from 0.
        pick: so many, 0 to `count`.
    """
    combination = np.empty(pick, dtype=np.int64)
    value = 0
    for place in range(pick):
        while rank >= (after := math.comb(count - 1 - value, pick - 1 - place)):
            rank -= after
            value += 1
        combination[place] = value
        value += 1
    return combination


@routine
def choose(task: Task, combination: Long, chosen: Long) -> None:
    """Numbers of the pairs linked, ascending: those that must be and those picked.

    Args:
        task: the search.
        combination: numbers of the free pairs that are picked, places in `task.free`, ascending.
        chosen: result: numbers of the pairs, (links,).
    """
    m = p = 0
    for c in range(len(chosen)):
        if p == len(combination) or (m < len(task.require) and task.require[m] < task.free[combination[p]]):
            chosen[c] = task.require[m]
            m += 1
        else:
            chosen[c] = task.free[combination[p]]
            p += 1


@routine
def sweep(task: Task, combination: Long, values: Float, sure: Bool, best: Float, worst: float) -> None:
    """Objectives of consecutive combinations, NaN where not admissible; neighbours lend each other their roots.

    A consensus that is surely neither among the best nor the worst is not worked out: its value is inf.

    Args:
        task: the search.
        combination: the first combination; changed.
        values: filled with the objectives, as far as it comes; its length says how many there are.
        sure: filled with whether they are certain.
        best: the best known so far, ascending, inf where there is none yet; kept up. With none, (0,), every objective
            is worked out.
        worst: the worst known so far; -inf where there is none yet.
    """
    pick, count = len(combination), len(task.free)
    chosen = np.empty(len(task.require) + pick, np.int64)
    guesses = np.full(len(task.modes), complex(-np.inf, 0.0))
    for r in range(len(values)):
        if raised(task.stop):
            return
        choose(task, combination, chosen)
        values[r], sure[r] = np.nan, True
        if admissible(task, chosen):
            limited = len(best) > 0 and task.objective == CONSENSUS and best[-1] < worst
            if (
                limited
                and period_of(task, chosen) == 1
                and between(task, chosen, best[-1] * (1.0 - _MARGIN), worst, guesses)
            ):
                values[r] = np.inf
            else:
                values[r], sure[r] = rate(task, chosen, guesses, np.inf)
                if sure[r] and len(best) > 0:
                    worst = max(worst, values[r])
                    place = len(best) - 1
                    if values[r] < best[place]:
                        while place > 0 and values[r] < best[place - 1]:
                            best[place] = best[place - 1]
                            place -= 1
                        best[place] = values[r]
        place = pick - 1
        while place >= 0 and combination[place] == count - pick + place:
            place -= 1
        if place >= 0:
            combination[place] += 1
            for later in range(place + 1, pick):
                combination[later] = combination[later - 1] + 1


def chosen_at(problem: Problem, rank: int) -> Long:
    """Numbers of the pairs that choice number `rank` links.

    Args:
        problem: the search.
        rank: of the choice, from 0, in lexicographic order of what it picks.
    """
    task = problem.task
    return np.sort(np.concatenate([task.require, task.free[unrank(rank, len(task.free), task.pick)]]))


class Values(NamedTuple):
    """Objectives of consecutive choices.

    Attributes:
        values: as `rate` gives them; NaN where not admissible or not to be told, inf where not worked out.
        connected: whether each is admissible.
        unsure: how many admissible ones nothing could tell for certain.
    """

    values: Float
    connected: Bool
    unsure: int


def values_of(problem: Problem, start: int, count: int, best: Sequence[float] = (), worst: float = -math.inf) -> Values:
    """Objectives of `count` choices from number `start` on.

    Those that are surely neither better than the last of `best` nor worse than `worst` may be left at inf; without
    `best`, none is.

    Args:
        problem: the search.
        start: number of the first choice, from 0.
        count: of choices, >= 1.
        best: objectives of the best so far, ascending, as `rate` gives them.
        worst: objective of the worst so far.
    """
    task = thawed(problem.task)
    values, sure = np.full(count, math.nan), np.ones(count, dtype=np.bool_)
    sweep(task, unrank(start, len(task.free), task.pick), values, sure, np.array(best, dtype=np.float64), worst)
    connected, unsure = ~np.isnan(values), 0
    for r in map(int, np.flatnonzero(~sure)):
        value = problem.reference(chosen_at(problem, start + r))
        unsure += value is None and not task.stop[0]  # what was stopped was not looked at
        values[r] = math.nan if value is None else value
    return Values(values, connected, unsure)


def look(problem: Problem, start: int, count: int, top: int, known: BestChoices) -> BestChoices:
    """Works off `count` choices from number `start` on; keeps the `top` best and the worst.

    Args:
        problem: the search.
        start: number of the first choice.
        count: how many there are.
        top: how many of the best to keep.
        known: what earlier choices hold, which need not be beaten twice.
    """
    ahead = sorted(known.values)
    best = [*ahead[:top], *[math.inf] * (top - len(ahead))]
    values, connected, unsure = values_of(problem, start, count, best, ahead[-1] if ahead else -math.inf)
    order = np.argsort(values, kind="stable")[: int((values < math.inf).sum())]
    kept = order[:top].tolist()
    if order.size:
        worst = int(np.flatnonzero(values == values[order[-1]])[0])
        kept += [worst] if worst not in kept else []
    return BestChoices(
        tuple(start + int(r) for r in kept),
        tuple(float(values[r]) for r in kept),
        count,
        int(connected.sum()),
        int((values == 0.0).sum()) if problem.objective == "consensus" else 0,
        unsure,
    )


def thawed(task: Task) -> Task:
    """The same with arrays of its own: what comes from another process is read-only, another type to the kernels."""
    parts: dict[str, Any] = {
        name: np.array(part) if isinstance(part, np.ndarray) and not part.flags.writeable else part  # pyright: ignore[reportUnknownArgumentType]
        for name, part in task._asdict().items()
    }
    return task._replace(**parts)


def merged(parts: Sequence[BestChoices], top: int) -> BestChoices:
    """Several stretches as one; of equals the first ranks first.

    Args:
        parts: of the numbers of choices, none of which is in two.
        top: so many of the best are kept, >= 1.
    """
    both = sorted({pair for part in parts for pair in zip(part.values, part.ranks, strict=True)})
    kept = both[:top]
    if both:
        worst = min((pair for pair in both if pair[0] == both[-1][0]), key=lambda pair: pair[1])
        kept += [worst] if worst not in kept else []
    return BestChoices(
        tuple(rank for _, rank in kept),
        tuple(value for value, _ in kept),
        sum(part.looked for part in parts),
        sum(part.connected for part in parts),
        sum(part.periodic for part in parts),
        sum(part.unsure for part in parts),
    )


def enumerated(problem: Problem, top: int, parallel: Parallel, jobs: int) -> Generator[BestChoices]:
    """Looks at every choice and yields what is known so far, again and again.

    Args:
        problem: the search.
        top: how many of the best to keep.
        parallel: a `joblib.Parallel`.
        jobs: how many stretches run at once.
    """
    import joblib

    quick = _QUICK if problem.objective in ("damping", "drag") else 1
    length = min(max(problem.choices // _STRETCHES, _SHORTEST * quick), _LONGEST * quick)
    starts = iter(range(0, problem.choices, length))
    found = BestChoices((), (), 0, 0, 0, 0)
    # The first stretch alone tells the others what to beat; few choices are done sooner than they are shared.
    shared = _ROUND * jobs if problem.choices > _ALONE else 1
    while batch := list(itertools.islice(starts, shared if found.looked else 1)):
        work = [(start, min(length, problem.choices - start)) for start in batch]
        if len(work) == 1:
            parts = [look(problem, *work[0], top, found)]
        else:
            parts = parallel(joblib.delayed(look)(problem, start, count, top, found) for start, count in work)
        check()
        found = merged([found, *parts], top)
        yield found
