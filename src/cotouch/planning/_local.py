"""Local search: one link swapped for another as long as that helps, from many starts.

Nothing is proved by it. A swap is turned down as soon as Newton, from the roots of the links at hand, reaches a root
that is no better; only what passes that is worked out in full, with the count of roots that makes it certain.
"""

from collections.abc import Generator
from dataclasses import dataclass, field, replace
from typing import Any, final

import numpy as np

from cotouch.compiled import routine
from cotouch.planning._bound import ROUND_OFF
from cotouch.planning._enumerate import thawed
from cotouch.planning._problem import Problem
from cotouch.planning._task import DAMPING, ComplexArray, IntArray, Task, admissible, hopeless, pulls, rate, remember

# Walks side by side, whatever the machine, so that a seed means the same everywhere.
WALKS = 8
# Swaps of a walk between looks at the clock: so many over the cube of the number of users, and at least.
_SLICE, _SHORTEST = 200_000, 10
# Random starts tried before a start that is known to be admissible is taken.
_TRIES = 100

# Users up to whom a swap that looks better but is uncertain is worth a slow answer; beyond, it is turned down.
_MOST_REFERRED = 8
# So few swaps are tried in random order.
_FEW = 200
# Roots at hand to turn swaps down by.
_POOL = 6

_DONE, _BETTER, _UNSURE = 0, 1, 2


@final
@dataclass(frozen=True, eq=False)
class Walk:
    """One walk.

    Attributes:
        start: number of the start, from which its random numbers follow.
        chosen: pairs linked now, ascending; empty before the first step.
        value: their objective as `rate` gives it.
        guesses: their roots, one of each mode.
        pool: roots at hand to turn swaps down by, (modes, any number): what settled one settles others like it.
        turn: swaps accepted so far.
        position: swaps tried since.
        tried: swaps tried before the last one accepted, and that.
        looked: swaps and starts looked at.
        over: whether no swap helps.
        seen: choices worked out in full.
    """

    start: int
    chosen: IntArray = field(default_factory=lambda: np.zeros(0, dtype=np.int64))
    value: float = np.inf
    guesses: ComplexArray = field(default_factory=lambda: np.zeros(0, dtype=np.complex128))
    pool: ComplexArray = field(default_factory=lambda: np.zeros((0, 0), dtype=np.complex128))
    turn: int = 0
    position: int = 0
    tried: int = 0
    looked: int = 0
    over: bool = False
    seen: tuple[tuple[float, tuple[int, ...]], ...] = ()


@routine
def swaps(
    task: Task,
    chosen: IntArray,
    inside: IntArray,
    outside: IntArray,
    order: IntArray,
    begin: int,
    end: int,
    value: float,
    guesses: ComplexArray,
    pool: ComplexArray,
) -> tuple[int, int, float, int]:
    """Tries swaps until one helps.

    Args:
        task: the search.
        chosen: pairs linked; becomes those after the swap that helps.
        inside: those that may go.
        outside: those that may come.
        order: the swaps, `leaving * len(outside) + coming`.
        begin: first of them to try.
        end: one after the last.
        value: objective of `chosen`.
        guesses: roots of `chosen`; become those after the swap.
        pool: roots that settle swaps, as `hopeless` takes them; kept up.

    Returns:
        `_DONE`, `_BETTER` or `_UNSURE` (looks better, uncertain), the next swap, the objective, the swaps looked at.
    """
    looked = 0
    trial, roots = chosen.copy(), guesses.copy()
    for p in range(begin, end):
        leaving, coming = inside[order[p] // len(outside)], outside[order[p] % len(outside)]
        for c in range(len(chosen)):
            trial[c] = coming if chosen[c] == leaving else chosen[c]
        trial.sort()
        if not admissible(task, trial):
            continue
        looked += 1
        least = value - ROUND_OFF * np.abs(value)
        if hopeless(task, trial, least, pool):
            continue
        roots[:] = guesses
        found, sure = rate(task, trial, roots, least)
        if not found < least:
            for mode in range(len(roots)):
                if roots[mode].real >= least:
                    remember(pool, mode, _POOL - 1, roots[mode])
        else:
            chosen[:] = trial
            guesses[:] = roots
            return (_BETTER if sure else _UNSURE), p + 1, found, looked
    return _DONE, end, value, looked


def random_choice(task: Task, rng: np.random.Generator) -> IntArray | None:
    """A random spanning tree with random links on top; None if the limits leave none after some tries."""
    users = range(task.size)
    for _ in range(_TRIES):
        group, degree, chosen = list(users), [0] * task.size, []
        spare: list[int] = []
        needed = task.must.tolist()
        for e in [*needed, *rng.permutation(task.free).tolist()]:
            i, j = int(task.first[e]), int(task.second[e])
            joins = group[i] != group[j]
            if e in needed or (joins and max(degree[i], degree[j]) < task.most):
                chosen.append(e)
                degree[i] += 1
                degree[j] += 1
                group = [group[j] if g == group[i] else g for g in group]
            else:
                spare.append(e)
        for e in spare:
            i, j = int(task.first[e]), int(task.second[e])
            if len(chosen) < len(needed) + task.pick and max(degree[i], degree[j]) < task.most:
                chosen.append(e)
                degree[i] += 1
                degree[j] += 1
        result = np.array(sorted(chosen), dtype=np.int64)
        if len(result) == len(needed) + task.pick and admissible(task, result):
            return result
    return None


def step(problem: Problem, walk: Walk, seed: int, fallback: IntArray) -> Walk:
    """Goes on with a walk for a while."""
    task = thawed(problem.task)
    if not walk.chosen.size:
        walk = _begin(problem, task, walk, seed, fallback)
    left = max(_SLICE // task.size**3, _SHORTEST)
    while left > 0 and not walk.over:
        turn, position = walk.turn, walk.position
        walk = _swapped(problem, task, walk, seed, left)
        left -= walk.position - position if walk.turn == turn else 1 + max(walk.tried - position, 0)
    return walk


def _swapped(problem: Problem, task: Task, walk: Walk, seed: int, most: int) -> Walk:
    """The walk after the next swap that helps, or after `most` that don't."""
    chosen, guesses, pool = walk.chosen.copy(), walk.guesses.copy(), walk.pool.copy()
    inside = np.setdiff1d(chosen, task.must)
    outside = np.setdiff1d(task.free, chosen)
    order = _order(task, walk, seed, inside, outside)
    end = min(walk.position + most, order.size)
    outcome, position, value, looked = swaps(
        task, chosen, inside, outside, order, walk.position, end, walk.value, guesses, pool
    )
    looked += walk.looked
    if outcome == _UNSURE:
        settled = problem.reference(chosen) if task.size <= _MOST_REFERRED else None
        if settled is None or settled >= walk.value:
            outcome = _DONE
        else:
            value = settled
    if outcome == _DONE:
        return replace(walk, pool=pool, position=position, looked=looked, over=position == order.size)
    seen = (*walk.seen, (value, tuple(chosen.tolist())))
    return replace(
        walk,
        chosen=chosen,
        value=value,
        guesses=guesses,
        pool=_pool(guesses, pool),
        turn=walk.turn + 1,
        position=0,
        tried=position,
        looked=looked,
        seen=seen,
    )


def _pool(guesses: ComplexArray, pool: ComplexArray) -> ComplexArray:
    """The roots of the links at hand before those that settled swaps so far."""
    return np.ascontiguousarray(np.concatenate([guesses[:, None], pool[:, :-1]], axis=1))


def _order(task: Task, walk: Walk, seed: int, inside: IntArray, outside: IntArray) -> IntArray:
    """The swaps in the order in which they are tried, which follows from the walk: it can go on in any process.

    Those go first that move the slowest root furthest left, as far as its slope tells. Few swaps are sooner tried than
    ranked, and chance leads many starts to more ends; it decides for damping too.
    """
    few = inside.size * outside.size <= _FEW
    if few or task.objective == DAMPING or not np.isfinite(walk.guesses.real).all():
        return np.random.default_rng((seed, walk.start, walk.turn)).permutation(inside.size * outside.size)
    pull = np.empty(len(task.first))
    pulls(task, walk.chosen.copy(), walk.guesses.copy(), pull)
    return np.argsort((pull[outside][None, :] - pull[inside][:, None]).ravel(), kind="stable")


def _begin(problem: Problem, task: Task, walk: Walk, seed: int, fallback: IntArray) -> Walk:
    chosen = random_choice(task, np.random.default_rng((seed, walk.start)))
    chosen = fallback.copy() if chosen is None else chosen
    guesses = np.full(len(task.modes), complex(-np.inf, 0.0))
    value, sure = rate(task, chosen, guesses)
    if not sure:
        settled = problem.reference(chosen)
        if settled is None:
            return replace(walk, over=True, looked=1)
        value = settled
    nothing = np.full((len(guesses), _POOL), complex(-np.inf, 0.0))
    pool = _pool(guesses, nothing)
    return replace(
        walk, chosen=chosen, value=value, guesses=guesses, pool=pool, looked=1, seen=((value, tuple(chosen.tolist())),)
    )


def walked(problem: Problem, starts: int, seed: int, fallback: IntArray, parallel: Any) -> Generator[Walk]:
    """Walks from random starts; yields every walk as it ends, or as it stands after a while.

    Args:
        problem: the search.
        starts: number of starts.
        seed: of all random numbers.
        fallback: an admissible choice.
        parallel: a `joblib.Parallel`.
    """
    from joblib import delayed

    walks = [Walk(start) for start in range(min(WALKS, starts))]
    following = len(walks)
    while walks:
        walks = parallel(delayed(step)(problem, walk, seed, fallback) for walk in walks)
        yield from walks
        going: list[Walk] = []
        for walk in walks:
            if not walk.over:
                going.append(walk)
            elif following < starts:
                going.append(Walk(following))
                following += 1
        walks = going
