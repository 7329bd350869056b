"""Local search: a flood that lifts whatever holds, swaps of one link as long as they help, and kicks that go on there.

Nothing is proved by it, but every value is. A swap is turned down as soon as Newton, from the roots of the links at
hand, reaches a root that is no better; only what passes that is worked out in full, with the count of roots that makes
it certain.
"""

from collections.abc import Callable, Generator
from dataclasses import dataclass, field, replace
from typing import TypeAlias, final

import numpy as np

from cotouch.arrays import Complex, Long
from cotouch.compiled import raised, routine
from cotouch.interrupt import Flag, check
from cotouch.planning._bound import ROUND_OFF
from cotouch.planning._enumerate import thawed
from cotouch.planning._flood import Front, flood
from cotouch.planning._judge import hopeless, pulls, remember
from cotouch.planning._levels import holds, uneven
from cotouch.planning._problem import Problem
from cotouch.planning._referral import referred
from cotouch.planning._starts import SMALL, side_by_side, start_of
from cotouch.planning._task import DAMPING, DECAY, Task, admissible, rate
from cotouch.planning._workers import Parallel

# Swaps of a walk between looks at the clock: so many over the cube of the number of users, and at least; and how many
# that are turned down by real roots take as long as one that is not.
_SLICE, _SHORTEST, _CHEAP = 200_000, 10, 50
# So few swaps are tried in random order.
_FEW = 200
# Roots at hand to turn swaps down by.
_POOL = 6
# By how much a flood rises with every swap that holds: the first starts quickly, later ones ever more slowly.
_RISES = (1e-2, 1e-3, 1e-4, 3e-5, 1e-5)
# Few users: most floods end alike whatever their speed, and all go on by swaps.
_SLOWEST_SMALL = 1e-3
# The level a flood begins at, beside that of its start, and the swaps it tries in one slice.
_BELOW, _TRIES_OF_FLOOD = 0.9, 20_000
# Among many users only what comes so near the best of all starts goes on by swaps.
_NEAR = 0.02
# Where no swap helps, so many links, at least and at most, are exchanged at random and swaps go on from there, until
# that has been in vain so often, in networks of up to so many users; less often unless for decay.
_KICK, _KICKS, _FEWEST_KICKS = (2, 4), ((SMALL, 12), (60, 10)), 2
# Random exchanges tried for one that keeps to the limits and is worked out for certain.
_TRIES = 100

# What real roots say of links whose delays differ both ways is believed this far: they are those of the mean delays.
_SIGHT = 0.9

_DONE, _BETTER, _UNSURE = 0, 1, 2
# Number of the walk that begins where it is told, beyond all others.
_GIVEN = 2**31

Begin: TypeAlias = tuple[Long | None, Long]


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
        looked: swaps and starts looked at.
        unsure: those that looked better, but that nothing could tell for certain.
        level: of its flood, 1/s; 0 once that is over, or if there is none.
        idle: swaps that the flood tried in vain since its level rose.
        slices: of the flood.
        home: the best pairs that no swap helps, (0,) before there are any.
        best: their objective.
        kicks: random exchanges made from there.
        vain: those since `home` changed.
        over: whether it has come to its end.
        seen: choices worked out in full by the last step.
    """

    start: int
    chosen: Long = field(default_factory=lambda: np.zeros(0, dtype=np.int64))
    value: float = np.inf
    guesses: Complex = field(default_factory=lambda: np.zeros(0, dtype=np.complex128))
    pool: Complex = field(default_factory=lambda: np.zeros((0, 0), dtype=np.complex128))
    turn: int = 0
    position: int = 0
    looked: int = 0
    unsure: int = 0
    level: float = 0.0
    idle: int = 0
    slices: int = 0
    home: Long = field(default_factory=lambda: np.zeros(0, dtype=np.int64))
    best: float = np.inf
    kicks: int = 0
    vain: int = 0
    over: bool = False
    seen: tuple[tuple[float, tuple[int, ...]], ...] = ()

    @property
    def reached(self) -> float:
        """The best objective so far."""
        return min(self.best, self.value)


@routine
def swaps(
    task: Task,
    chosen: Long,
    inside: Long,
    outside: Long,
    order: Long,
    begin: int,
    most: int,
    value: float,
    guesses: Complex,
    pool: Complex,
) -> tuple[int, int, float, int, int]:
    """Tries swaps until one helps, or the work is done.

    Args:
        task: the search.
        chosen: pairs linked; becomes those after the swap that helps.
        inside: those that may go.
        outside: those that may come.
        order: the swaps, `leaving * len(outside) + coming`.
        begin: first of them to try.
        most: work to do, in swaps not turned down by real roots.
        value: objective of `chosen`.
        guesses: roots of `chosen`; become those after the swap.
        pool: roots that settle swaps, as `hopeless` takes them; kept up.

    Returns:
        `_DONE`, `_BETTER` or `_UNSURE` (looks better, uncertain), the next swap, the objective, the swaps looked at,
        and the work done.
    """
    looked = dear = work = 0
    sight = _SIGHT if uneven(task) else 1.0
    trial, roots = chosen.copy(), guesses.copy()
    for p in range(begin, len(order)):
        work = dear + (p - begin) // _CHEAP
        if work >= most or raised(task.stop):
            return _DONE, p, value, looked, work
        leaving, coming = inside[order[p] // len(outside)], outside[order[p] % len(outside)]
        for c in range(len(chosen)):
            trial[c] = coming if chosen[c] == leaving else chosen[c]
        trial.sort()
        if not admissible(task, trial):
            continue
        looked += 1
        least = value - ROUND_OFF * np.abs(value)
        if task.objective != DAMPING and least < 0.0 and not holds(task, trial, -sight * least):
            continue
        dear += 1
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
            return (_BETTER if sure else _UNSURE), p + 1, found, looked, work + 1
    return _DONE, len(order), value, looked, work + 1


def step(problem: Problem, walk: Walk, seed: int, begin: Begin) -> Walk:
    """Goes on with a walk for a while.

    Args:
        problem: the search.
        walk: where it stands.
        seed: of all walks of the search.
        begin: choices that walks may begin at.
    """
    task = thawed(problem.task)
    walk = replace(walk, seen=())
    if not walk.chosen.size:
        walk = _begin(problem, task, walk, seed, begin)
    if walk.level > 0.0:
        return _flooded(problem, task, walk, seed)
    left = max(_SLICE // task.size**3, _SHORTEST)
    while left > 0 and not walk.over and not task.stop[0]:
        walk, work = _swapped(problem, task, walk, seed, left)
        left -= 1 + work
    return walk


def _swapped(problem: Problem, task: Task, walk: Walk, seed: int, most: int) -> tuple[Walk, int]:
    """The walk after the next swap that helps, or after so much work; and the work."""
    chosen, guesses, pool = walk.chosen.copy(), walk.guesses.copy(), walk.pool.copy()
    inside = np.setdiff1d(chosen, task.require)
    outside = np.setdiff1d(task.free, chosen)
    order = _order(task, walk, seed, inside, outside)
    outcome, position, value, looked, work = swaps(
        task, chosen, inside, outside, order, walk.position, most, walk.value, guesses, pool
    )
    looked += walk.looked
    if outcome == _UNSURE:
        settled = referred(problem, chosen)
        if settled is None:
            walk = replace(walk, unsure=walk.unsure + (not task.stop[0]))
        if settled is None or settled >= walk.value:
            outcome = _DONE
        else:
            value = settled
    if outcome == _DONE:
        walk = replace(walk, pool=pool, position=position, looked=looked)
        if position == order.size and not task.stop[0]:
            walk = _kicked(problem, task, walk, seed)
        return walk, work
    seen = (*walk.seen, (value, tuple(chosen.tolist())))
    walk = replace(walk, value=value, guesses=guesses, pool=_pool(guesses, pool), looked=looked, seen=seen)
    return replace(walk, chosen=chosen, turn=walk.turn + 1, position=0), work


def _kicked(problem: Problem, task: Task, walk: Walk, seed: int) -> Walk:
    """The walk somewhere near the best links that it knows, now that no swap helps; over if it was there too often."""
    vain = 0 if walk.value < walk.best else walk.vain + 1
    if walk.value <= walk.best:
        walk = replace(walk, home=walk.chosen, best=walk.value)
    most = _FEWEST_KICKS
    if task.objective == DECAY:
        most = next((kicks for users, kicks in _KICKS if task.size <= users), most)
    rng = np.random.default_rng((seed, walk.start, walk.kicks, 2))
    inside, outside = np.setdiff1d(walk.home, task.require), np.setdiff1d(task.free, walk.home)
    largest = min(_KICK[1], inside.size, outside.size)
    walk = replace(walk, turn=walk.turn + 1, position=0, kicks=walk.kicks + 1, vain=vain)
    for _ in range(_TRIES if vain < most and largest >= _KICK[0] else 0):
        count = rng.integers(_KICK[0], largest, endpoint=True)
        kept = np.setdiff1d(walk.home, rng.choice(inside, count, replace=False))
        chosen = np.sort(np.concatenate([kept, rng.choice(outside, count, replace=False)]))
        if admissible(task, chosen):
            kicked = _settled(problem, task, replace(walk, chosen=chosen))
            if not kicked.over:
                return kicked
            walk = replace(walk, looked=kicked.looked, unsure=kicked.unsure)
    return replace(walk, over=True)


def _pool(guesses: Complex, pool: Complex) -> Complex:
    """The roots of the links at hand before those that settled swaps so far."""
    return np.ascontiguousarray(np.concatenate([guesses[:, None], pool[:, :-1]], axis=1))


def _order(task: Task, walk: Walk, seed: int, inside: Long, outside: Long) -> Long:
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


def _begin(problem: Problem, task: Task, walk: Walk, seed: int, begin: Begin) -> Walk:
    given, fallback = begin
    if walk.start == _GIVEN and given is not None:
        return _settled(problem, task, replace(walk, chosen=given))
    chosen, level = start_of(task, walk.start, seed, fallback)
    walk = replace(walk, chosen=chosen)
    if walk.start >= side_by_side(task.size) and level > 0.0:
        return replace(walk, level=_BELOW * level)
    # The first starts are worked out before they go on, so that there is an answer early: what takes long is left out.
    walk = _settled(problem, task, walk, slowly=level <= 0.0)
    return replace(walk, level=_BELOW * level, over=False) if level > 0.0 else walk


def _flooded(problem: Problem, task: Task, walk: Walk, seed: int) -> Walk:
    """The walk after a slice of its flood; what the flood ends with is worked out exactly."""
    rise = _RISES[min(walk.start // side_by_side(task.size), len(_RISES) - 1)]
    if task.size <= SMALL:
        rise = max(rise, _SLOWEST_SMALL)
    picks = np.random.default_rng((seed, walk.start, walk.slices, 1)).random((_TRIES_OF_FLOOD, 2))
    front = flood(task, Front(walk.chosen.copy(), walk.level, walk.idle, False), rise, picks)
    walk = replace(walk, chosen=front.chosen, level=front.level, idle=front.idle, slices=walk.slices + 1)
    return _settled(problem, task, replace(walk, level=0.0)) if front.over and not task.stop[0] else walk


def _settled(problem: Problem, task: Task, walk: Walk, *, slowly: bool = True) -> Walk:
    """The walk with its links worked out exactly; what is uncertain is referred if that may be slow."""
    guesses = np.full(len(task.modes), complex(-np.inf, 0.0))
    value = worked_out(problem, task, walk.chosen, guesses, slowly=slowly)
    if value is None:
        return replace(walk, over=True, looked=walk.looked + 1, unsure=walk.unsure + (not task.stop[0]))
    nothing = np.full((len(guesses), _POOL), complex(-np.inf, 0.0))
    seen = (*walk.seen, (value, tuple(walk.chosen.tolist())))
    return replace(walk, value=value, guesses=guesses, pool=_pool(guesses, nothing), looked=walk.looked + 1, seen=seen)


def worked_out(
    problem: Problem, task: Task, chosen: Long, guesses: Complex | None = None, *, slowly: bool = True
) -> float | None:
    """The objective of one choice as `rate` gives it; None if it cannot be told for certain, or not in time.

    Args:
        problem: the search.
        task: that of the problem, with arrays of its own.
        chosen: numbers of the pairs linked.
        guesses: of roots, as `rate` takes them.
        slowly: whether what `rate` leaves uncertain is referred.
    """
    guesses = np.full(len(task.modes), complex(-np.inf, 0.0)) if guesses is None else guesses
    value, sure = rate(task, chosen, guesses, np.inf)
    if sure:
        return float(value)
    return referred(replace(problem, task=task), chosen) if slowly else None


def closed(problem: Problem, walk: Walk) -> Walk:
    """A walk in the middle of its flood, at its end all the same; the time left is for others if it is uncertain.

    Args:
        problem: the search.
        walk: where it stands.
    """
    return replace(_settled(problem, thawed(problem.task), replace(walk, level=0.0), slowly=False), over=True)


def walked(
    problem: Problem,
    starts: int,
    seed: int,
    begin: Begin,
    parallel: Parallel,
    closing: Callable[[], bool] = lambda: False,
    ending: Flag | None = None,
) -> Generator[Walk]:
    """Walks from random starts; yields every walk as it ends, or as it stands after a while.

    Args:
        problem: the search.
        starts: number of starts.
        seed: of all random numbers.
        begin: where one more walk begins, or None; and an admissible choice for where random ones fail.
        parallel: a `joblib.Parallel`.
        closing: whether it is time to end: what floods hold then is worked out, the highest first.
        ending: raised once there is no time for that either.
    """
    import joblib

    walks = [Walk(start) for start in range(min(side_by_side(problem.task.size), starts))]
    following, best = len(walks), np.inf
    walks = [*([] if begin[0] is None else [Walk(_GIVEN)]), *walks]
    many = problem.task.size > SMALL
    while walks:
        walks = parallel(joblib.delayed(step)(problem, walk, seed, begin) for walk in walks)
        check()
        best = min(best, *(walk.reached for walk in walks))
        walks = [
            replace(walk, over=True)
            if many and walk.slices and walk.level == 0.0 and _NEAR * abs(best) < walk.reached - best < np.inf
            else walk
            for walk in walks
        ]
        yield from walks
        if closing():
            floods = sorted((walk for walk in walks if walk.level > 0.0), key=lambda walk: -walk.level)
            last = problem if ending is None else replace(problem, task=problem.task._replace(stop=ending))
            for walk in floods:  # one by one: who reads them stops when it is late
                yield closed(last, walk)
            return
        going: list[Walk] = []
        for walk in walks:
            if not walk.over:
                going.append(walk)
            elif following < starts:
                going.append(Walk(following))
                following += 1
        walks = going
