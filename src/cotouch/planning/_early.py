"""A first answer while kernels compile: the best of a few networks, found without a kernel and not certified."""

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Unpack, final

import numpy as np
from scipy.sparse.csgraph import connected_components

from cotouch.arrays import Float, Long
from cotouch.network import Network, Pair, generator_eigenvalues
from cotouch.planning._options import ProblemOptions
from cotouch.planning._problem import Problem, make_problem
from cotouch.planning._task import CONSENSUS, DAMPING, DECAY, DRAG, FEEL, LOST_LINK, LOST_USER, NOTHING, Task

# Choices up to which every one is tried; else so many networks about hubs, fewer beyond so many users.
_ALL = 300
_TRIES, _MANY, _FEW = 60, 60, 8
_MOST_HUBS = 4
# Degree of the collocation, its rows at most, and those up to which every choice has its own.
_ORDER, _ROWS, _QUICK = 10, 1300, 140
# Levels between which a rate is looked for, beside the longest delay, and how often the stretch is halved.
_LOWEST, _HIGHEST, _HALVINGS = 1e-4, 30.0, 20


@final
@dataclass(frozen=True, eq=False)
class FirstChoice:
    """A choice of links that nothing certifies.

    Attributes:
        links: pairs of user indices, from 0.
        value: about the objective; None where it takes a kernel to tell.
        tried: how many choices were compared.
    """

    links: tuple[Pair, ...]
    value: float | None
    tried: int


def first_choice(
    network: Network, *, links: int, seed: int = 0, **options: Unpack[ProblemOptions]
) -> FirstChoice | None:
    """A fair choice of links within seconds, on a machine where nothing is compiled yet.

    Few choices of few users are ranked by their decay; networks about hubs by the real root that they would have with
    both delays at their mean.

    Args:
        network: as `plan` takes it.
        links: how many.
        seed: of the hubs.
        **options: the objective and the limits, as `plan` takes them.

    Returns:
        None where no such network keeps to the limits.

    Raises:
        NetworkError: as `plan` raises it.
    """
    problem = make_problem(network, links=links, **options)
    task = problem.task
    quick = task.size * (_ORDER + 1) <= _QUICK
    best, level, tried = None, -math.inf, 0
    for chosen in _candidates(problem, np.random.default_rng(seed)):
        if not _admissible(task, chosen):
            continue
        tried += 1
        value = _value(task, chosen) if quick else None
        if value is not None:  # Complex roots are seen, too.
            if best is None or -value > level:
                best, level = chosen, -value
        elif best is None or _above(task, chosen, level):
            best, level = chosen, _level(task, chosen)
    if best is None:
        return None
    return FirstChoice(problem.pairs(best), _value(task, best), tried)


def _candidates(problem: Problem, rng: np.random.Generator) -> Iterator[Long]:
    task = problem.task
    if problem.choices <= _ALL:
        for picked in itertools.combinations(task.free.tolist(), task.pick):
            yield np.sort(np.concatenate([task.require, np.array(picked, dtype=np.int64)]))
        return
    for _ in range(_TRIES if task.size <= _MANY else _FEW):
        hubs = rng.choice(task.size, int(rng.integers(1, _MOST_HUBS + 1)), replace=False)
        chosen = _about(problem, hubs)
        if chosen is not None:
            yield chosen


def _about(problem: Problem, hubs: Long) -> Long | None:
    """Every user linked to its nearest hub, then to further ones."""
    task = problem.task
    first: list[int] = task.first.tolist()
    second: list[int] = task.second.tolist()
    load: list[float] = task.load.tolist()
    hub = np.isin(task.first, hubs) | np.isin(task.second, hubs)
    order: list[int] = task.free[
        np.lexsort((task.to_first[task.free] + task.to_second[task.free], ~hub[task.free]))
    ].tolist()
    degree, damping, group = [0] * task.size, [0.0] * task.size, list(range(task.size))
    chosen: list[int] = []

    def take(e: int) -> None:
        chosen.append(e)
        for user in (first[e], second[e]):
            degree[user] += 1
            damping[user] += load[e]
        a, b = group[first[e]], group[second[e]]
        if a != b:
            group[:] = [a if g == b else g for g in group]

    def fits(e: int) -> bool:
        ends = (first[e], second[e])
        return len(chosen) < problem.links and all(
            degree[user] < task.most and damping[user] + load[e] <= task.limit for user in ends
        )

    for e in task.require.tolist():
        take(e)
    for turn in ("tree", "twice", "more"):
        taken = set(chosen)
        for e in order:
            a, b = first[e], second[e]
            wanted = {
                "tree": group[a] != group[b],
                "twice": task.lost != NOTHING and min(degree[a], degree[b]) < 2,
                "more": True,
            }
            if e not in taken and wanted[turn] and fits(e):
                take(e)
    return np.array(sorted(chosen), dtype=np.int64) if len(chosen) == problem.links else None


def _admissible(task: Task, chosen: Long) -> bool:
    """`_task.admissible` without a kernel."""
    ends = np.stack([task.first[chosen], task.second[chosen]])
    damping = np.bincount(ends.ravel(), np.tile(task.load[chosen], 2), task.size)
    if np.bincount(ends.ravel(), minlength=task.size).max() > task.most or damping.max() > task.limit:
        return False
    if _drag(task, chosen) > task.drag or not _joined(ends, task.size):
        return False
    if task.lost == LOST_LINK:
        return all(_joined(np.delete(ends, gone, axis=1), task.size) for gone in range(len(chosen)))
    if task.lost == LOST_USER:
        # A user who is lost is one group more.
        return all(_joined(ends[:, (ends != user).all(axis=0)], task.size, 2) for user in range(task.size))
    return True


def _drag(task: Task, chosen: Long) -> float:
    """`_task.drag_of` without a kernel."""
    load = float(task.load[chosen].sum())
    return (float(task.sync.sum()) if task.sync.size else 2.0 * load) + 2.0 * load + task.own_drag


def _joined(ends: Long, size: int, groups: int = 1) -> bool:
    graph = np.zeros((size, size), dtype=np.bool_)
    graph[ends[0], ends[1]] = True
    return int(connected_components(graph, directed=False)[0]) == groups


def _above(task: Task, chosen: Long, level: float) -> bool:
    """Whether a choice holds above a level (of `_level`)."""
    if task.objective in (DAMPING, DRAG, FEEL):
        return _level(task, chosen) > level
    for mode in task.modes:
        matrix = np.zeros((task.size, task.size))
        i, j = task.first[chosen], task.second[chosen]
        spring, delay = task.spring[chosen], 0.5 * (task.to_first + task.to_second)[chosen]
        matrix[i, j] = matrix[j, i] = -spring * np.exp(level * delay)
        own = np.bincount(np.concatenate([i, j]), np.tile(spring, 2), task.size)
        if task.objective == DECAY:
            m, b, k = mode.tolist()
            load = task.sync if task.sync.size else np.bincount(np.concatenate([i, j]), np.tile(task.load[chosen], 2))
            own = own - level * load + ((m * level - b) * level + k) / task.size
        matrix[np.diag_indices(task.size)] = own
        resting = task.objective == CONSENSUS or mode[2] == 0.0
        if int((np.linalg.eigvalsh(matrix) < 0.0).sum()) > int(resting):
            return False
    return True


def _level(task: Task, chosen: Long) -> float:
    """How good a choice is, the larger the better: the rate of its slowest real root at mean delays, or -damping.

    What a hand feels is mostly drag, which stands for it.
    """
    if task.objective in (DRAG, FEEL):
        return -_drag(task, chosen)
    if task.objective == DAMPING:
        ends = np.concatenate([task.first[chosen], task.second[chosen]])
        return -float(np.bincount(ends, np.tile(task.load[chosen], 2), task.size).max())
    longest = max(float(task.to_first.max()), float(task.to_second.max()), 1e-9)
    low, high = math.log(_LOWEST / longest), math.log(_HIGHEST / longest)
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _above(task, chosen, math.exp(middle)) else (low, middle)
    return math.exp(low)


def _value(task: Task, chosen: Long) -> float | None:
    if task.objective in (DAMPING, DRAG):
        return -_level(task, chosen)
    if task.objective != DECAY or task.lost != NOTHING or task.size * (_ORDER + 1) > _ROWS:
        return None
    i, j = task.first[chosen], task.second[chosen]
    spring, delay = np.zeros((2, task.size, task.size))
    spring[i, j] = spring[j, i] = task.spring[chosen]
    delay[i, j], delay[j, i] = task.to_first[chosen], task.to_second[chosen]
    sync: Float = task.sync if task.sync.size else (spring * (delay + delay.T) / 2).sum(axis=1)
    slowest = -math.inf
    for m, b, k in (task.modes / task.size).tolist():
        there = np.ones(task.size)
        roots = generator_eigenvalues(m * there, b + sync, k + spring.sum(axis=1), spring, delay, order=_ORDER)
        if k == 0.0:
            roots = np.delete(roots, np.abs(roots).argmin())
        slowest = max(slowest, float(roots.real.max()))
    return slowest
