"""Where walks begin: networks about hubs, and random ones."""

from collections.abc import Iterable, Sequence

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.planning._hubs import hubs
from cotouch.planning._levels import level_of
from cotouch.planning._problem import Problem
from cotouch.planning._task import CONSENSUS, DECAY, DRAG, FEEL, NOTHING, Task, admissible

# Walks side by side, whatever the machine, so that a seed means the same everywhere; and fewer of more users.
WALKS = 8
_SIDE_BY_SIDE = ((60, WALKS), (200, 4))
_FEWEST = 2
# Few users: every second start swaps from chance.
SMALL = 12
# Random starts tried before a start that is known to be admissible is taken; fewer of more users. Links that are tried
# where somebody has some are as many.
_TRIES, _MANY, _FEW = 100, 100, 5
# Networks about hubs tried for one start: so many over the cube of the number of users, at least and at most; the most
# hubs; and which starts of so many are random instead.
_TRIED_HUBS, _LEAST_TRIED, _MOST_TRIED = 2e8, 30, 400
_MOST_HUBS = 6
_RANDOM_EVERY = 4


def side_by_side(users: int) -> int:
    """How many walks go on at once."""
    return next((count for most, count in _SIDE_BY_SIDE if users <= most), _FEWEST)


def start_of(task: Task, start: int, seed: int, fallback: Long) -> tuple[Long, float]:
    """Links that a walk begins with, and the level that a flood may begin below, 1/s; 0 for none.

    Args:
        task: the search.
        start: number of the start.
        seed: of all random numbers.
        fallback: an admissible choice.
    """
    rng = np.random.default_rng((seed, start))
    few = task.size <= SMALL or task.objective == CONSENSUS
    if task.objective in (CONSENSUS, DECAY) and not (few and start % 2):
        if (start // (2 if few else 1)) % _RANDOM_EVERY != _RANDOM_EVERY - 1:
            chosen = np.zeros(len(task.require) + task.pick, dtype=np.int64)
            tries = int(np.clip(_TRIED_HUBS / task.size**3, _LEAST_TRIED, _MOST_TRIED))
            level = float(hubs(task, _MOST_HUBS, rng.random((tries, 1 + _MOST_HUBS)), chosen))
            if level > 0.0:
                return chosen, level
        chosen = _random(task, rng, fallback)
        return chosen, float(level_of(task, chosen))
    if start == 0 and task.objective in (DRAG, FEEL):
        chosen = lightest(task)
        if admissible(task, chosen):
            return chosen, 0.0
    return _random(task, rng, fallback), 0.0


def lightest(task: Task) -> Long:
    """Links with the least load of all that connect the users: a spanning tree, then the others [Kruskal 1956]."""
    group, spare = list(range(task.size)), list[int]()
    chosen: list[int] = task.require.tolist()
    order: list[int] = task.free[np.argsort(task.load[task.free], kind="stable")].tolist()
    for e in [*chosen, *order]:
        a, b = group[int(task.first[e])], group[int(task.second[e])]
        if a != b:
            group = [a if g == b else g for g in group]
            if e not in task.require:
                chosen.append(e)
        elif e not in task.require:
            spare.append(e)
    return np.sort(np.array((chosen + spare)[: len(task.require) + task.pick], dtype=np.int64))


def _random(task: Task, rng: np.random.Generator, fallback: Long) -> Long:
    chosen = random_choice(task, rng)
    return fallback.copy() if chosen is None else chosen


def random_choice(task: Task, rng: np.random.Generator) -> Long | None:
    """A random spanning tree with random links on top; None if the limits leave none after some tries.

    Args:
        task: the search.
        rng: random numbers.
    """
    users = range(task.size)
    needed = set(task.require.tolist())
    pairs = {(int(task.first[e]), int(task.second[e])): int(e) for e in task.free} if task.lost != NOTHING else {}
    for attempt in range(_TRIES if task.size <= _MANY else _FEW):
        group, degree, chosen = list(users), [0] * task.size, list[int]()
        damping = np.zeros(task.size)
        spare: list[int] = []

        def fits(e: int, degree: list[int] = degree, damping: Float = damping) -> bool:
            i, j = int(task.first[e]), int(task.second[e])
            return max(degree[i], degree[j]) < task.most and max(damping[i], damping[j]) + task.load[e] <= task.limit

        def take(e: int, chosen: list[int] = chosen, degree: list[int] = degree, damping: Float = damping) -> None:
            chosen.append(e)
            for user in (task.first[e], task.second[e]):
                degree[user] += 1
                damping[user] += task.load[e]

        # Where a limit is tight, light links go first, more and more.
        order = rng.permutation(task.free)
        if attempt % 2:
            order = task.free[np.argsort(task.load[task.free] * rng.random(task.free.size) ** (3.0 / attempt))]
        around: list[int] = []
        if task.lost != NOTHING:  # a ring stays connected whatever is lost
            ring = rng.permutation(task.size).tolist()
            ends = [tuple(sorted(pair)) for pair in zip(ring, [*ring[1:], ring[0]], strict=True)]
            around = [pairs[pair] for pair in dict.fromkeys(ends) if pair in pairs]
        for e in [*needed, *(e for e in around if e not in needed)]:
            i, j = int(task.first[e]), int(task.second[e])
            if e in needed or (fits(e) and len(chosen) < len(needed) + task.pick):
                take(e)
                group = [group[j] if g == group[i] else g for g in group]
        taken = set(chosen)
        for e in order.tolist():
            i, j = int(task.first[e]), int(task.second[e])
            if e in taken:
                continue
            if group[i] != group[j] and fits(e):
                take(e)
                group = [group[j] if g == group[i] else g for g in group]
            else:
                spare.append(e)
        for e in spare:
            if len(chosen) < len(needed) + task.pick and fits(e):
                take(e)
        result = np.array(sorted(chosen), dtype=np.int64)
        if len(result) == len(needed) + task.pick and admissible(task, result):
            return result
    return None


def begun_at(problem: Problem, links: Iterable[Sequence[int]]) -> Long | None:
    """A choice near some links: the lightest others are added, or the heaviest left out; None if that cannot be.

    Args:
        problem: the search.
        links: pairs of users, from 0; those that nobody may link are left out.
    """
    task, count = problem.task, problem.links
    place = {pair: e for e, pair in enumerate(problem.network.links)}
    given = [place[pair] for a, b in links if (pair := (min(a, b), max(a, b))) in place]
    chosen = np.union1d(np.array(given, dtype=np.int64), task.require)
    adding = len(chosen) < count
    others = np.setdiff1d(task.free, chosen) if adding else np.setdiff1d(chosen, task.require)
    order = others[np.argsort(task.load[others] * (1.0 if adding else -1.0), kind="stable")]
    for e in order[:_TRIES] if given else ():
        if len(chosen) == count:
            break
        trial = np.union1d(chosen, e) if adding else np.setdiff1d(chosen, e)
        chosen = trial if admissible(task, trial) else chosen
    return chosen if len(chosen) == count and admissible(task, chosen) else None
