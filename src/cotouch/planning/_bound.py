"""Branch and bound for the smallest largest damping, and for the smallest drag.

`B_i` is a sum over the links of user i of terms that are not negative, so a further link never lowers any of them: the
largest `B_i` of some links bounds that of every choice that holds them. Nor can the largest lie below the average, to
which the cheapest links left add least; and the drag is a sum over all links. Consensus, decay and feel have no such
bound: a link more may speed the slowest root up or slow it down, so a partial choice says nothing about those that
complete it.

The same search, asked to stop at its first choice, tells whether there is any choice at all.
"""

import math
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Bool, Float, Long
from cotouch.compiled import routine, subroutine
from cotouch.interrupt import check
from cotouch.planning._problem import Problem
from cotouch.planning._starts import random_choice
from cotouch.planning._task import DRAG, NOTHING, Task, admissible, drag_of, weight_of

# Decisions between looks at the clock: about a tenth of a second.
SLICE = 100_000
# Improvements smaller than this, beside the value, are round-off.
ROUND_OFF = 1e-12
# Decisions after which the search for any choice within tight limits gives up.
_DECISIONS = 3_000_000
# Users times pairs up to which there is branch and bound: 270 users, 240 MB.
_ROOM = 10_000_000


class Dive(NamedTuple):
    """Where a search stands: the tree of decisions is walked depth first, links in the order of their load.

    Attributes:
        order: the free pairs, cheapest first, (F,).
        cheapest: sum of the loads before each, (F + 1,).
        taken: whether each is taken, as far as decided, (F,).
        values: smallest objectives found, ascending, inf where there is none yet, (top,).
        choices: what they link, (top, links).
        counts: number of pairs decided, of choices reached, of decisions made; (3,).
    """

    order: Long
    cheapest: Float
    taken: Bool
    values: Float
    choices: Long
    counts: Long


def dive_into(problem: Problem, top: int) -> Dive:
    """A search that has not begun.

    Args:
        problem: the search.
        top: so many of the best are kept, >= 1.
    """
    task = problem.task
    order = task.free[np.argsort(task.load[task.free], kind="stable")]
    return Dive(
        order=order,
        cheapest=np.concatenate([[0.0], np.cumsum(task.load[order])]),
        taken=np.zeros(len(order), dtype=np.bool_),
        values=np.full(top, np.inf),
        choices=np.zeros((top, problem.links), dtype=np.int64),
        counts=np.zeros(3, dtype=np.int64),
    )


@subroutine
def _joins(task: Task, dive: Dive, depth: int, group: Long, degree: Long, need: int) -> bool:
    """Whether `need` links of those left can still connect all users and give none too many."""
    n = task.size
    groups, fits = 0, 0
    for u in range(n):
        groups += 1 if group[u] == u else 0
    if groups - 1 > need:
        return False
    wider = group.copy()
    for place in range(depth, len(dive.order)):
        i, j = task.first[dive.order[place]], task.second[dive.order[place]]
        if degree[i] >= task.most or degree[j] >= task.most:
            continue
        fits += 1
        a, b = int(wider[i]), int(wider[j])
        if a != b:
            groups -= 1
            _relabel(wider, a, b)
    return groups == 1 and fits >= need


@subroutine
def _relabel(group: Long, a: int, b: int) -> None:
    """Makes one group of two; each goes by its smallest user."""
    low, high = min(a, b), max(a, b)
    for u in range(len(group)):
        if group[u] == high:
            group[u] = low


@routine
def _take(task: Task, e: int, damping: Float, group: Long, degree: Long) -> None:
    """Takes one link up."""
    i, j = task.first[e], task.second[e]
    damping[i] += task.load[e]
    damping[j] += task.load[e]
    degree[i] += 1
    degree[j] += 1
    if group[i] != group[j]:
        _relabel(group, int(group[i]), int(group[j]))


@subroutine
def _record(task: Task, dive: Dive, depth: int) -> None:
    """Keeps a complete choice where it belongs among the best."""
    chosen = np.empty(len(task.require) + task.pick, np.int64)
    count = len(task.require)
    chosen[:count] = task.require
    for place in range(depth):
        if dive.taken[place]:
            chosen[count] = dive.order[place]
            count += 1
    chosen.sort()
    if not admissible(task, chosen):
        return
    dive.counts[1] += 1
    value = weight_of(task, chosen)
    place = len(dive.values)
    while place > 0 and value < dive.values[place - 1]:
        place -= 1
    for later in range(len(dive.values) - 1, place, -1):
        dive.values[later] = dive.values[later - 1]
        dive.choices[later] = dive.choices[later - 1]
    if place < len(dive.values):
        dive.values[place] = value
        dive.choices[place] = chosen


@routine
def descend(task: Task, dive: Dive, ceiling: float, most: int, first: bool) -> bool:
    """Goes on with a search.

    Args:
        task: the search.
        dive: where it stands; changed.
        ceiling: what choices must stay below, besides those found; inf for no limit.
        most: decisions after which to pause.
        first: whether one choice is enough.

    Returns:
        Whether it is over.
    """
    n, pairs = task.size, len(dive.order)
    damping, group, degree = (
        np.zeros((pairs + 1, n)),
        np.zeros((pairs + 1, n), np.int64),
        np.zeros((pairs + 1, n), np.int64),
    )
    picked = np.zeros(pairs + 1, np.int64)
    depth = int(dive.counts[0])
    group[0] = np.arange(n)
    for e in task.require:
        _take(task, e, damping[0], group[0], degree[0])
    for place in range(depth):
        damping[place + 1], group[place + 1], degree[place + 1] = damping[place], group[place], degree[place]
        picked[place + 1] = picked[place]
        if dive.taken[place]:
            _take(task, int(dive.order[place]), damping[place + 1], group[place + 1], degree[place + 1])
            picked[place + 1] += 1
    for _ in range(most):
        dive.counts[2] += 1
        need = task.pick - int(picked[depth])
        open_ = depth + need <= pairs
        if open_:
            total = 0.5 * np.sum(damping[depth]) + dive.cheapest[depth + need] - dive.cheapest[depth]
            largest, drag = max(np.max(damping[depth]), 2.0 * total / n), drag_of(task, total)
            least, limit = drag if task.objective == DRAG else largest, min(dive.values[-1], ceiling)
            open_ = least < limit * (1.0 - ROUND_OFF) or limit == np.inf
            open_ = open_ and largest <= task.limit * (1.0 + ROUND_OFF) and drag <= task.drag
        open_ = open_ and _joins(task, dive, depth, group[depth], degree[depth], need)
        if open_ and need == 0:
            _record(task, dive, depth)
            if first and dive.counts[1] > 0:
                return True
            open_ = False
        if not open_:
            while depth > 0 and not dive.taken[depth - 1]:
                depth -= 1
            if depth == 0:
                return True
            depth -= 1
        damping[depth + 1], group[depth + 1], degree[depth + 1] = damping[depth], group[depth], degree[depth]
        picked[depth + 1] = picked[depth]
        e = int(dive.order[depth])
        fits = degree[depth, task.first[e]] < task.most and degree[depth, task.second[e]] < task.most
        dive.taken[depth] = open_ and fits
        if dive.taken[depth]:
            _take(task, e, damping[depth + 1], group[depth + 1], degree[depth + 1])
            picked[depth + 1] += 1
        depth += 1
        dive.counts[0] = depth
    return False


def any_choice(problem: Problem, most: float = np.inf) -> Long | None:
    """Numbers of the pairs of some admissible choice; None if there is none, or none after so many decisions.

    Args:
        problem: the search.
        most: decisions after which it gives up.
    """
    dive = dive_into(problem, 1)
    while not descend(problem.task, dive, np.inf, SLICE, True) and dive.counts[2] < most:
        check()
    return dive.choices[0] if dive.counts[1] else None


def some_choice(problem: Problem) -> Long | None:
    """Numbers of the pairs of some admissible choice; None if there is none, or none is found within tight limits."""
    chosen = random_choice(problem.task, np.random.default_rng(0))
    if chosen is not None or not has_room(problem):
        return chosen
    free = problem.task.lost == NOTHING and not math.isfinite(problem.task.limit)
    return any_choice(problem) if free else any_choice(problem, _DECISIONS)


def has_room(problem: Problem) -> bool:
    """Whether branch and bound has room: it keeps what every user has after every decision."""
    return problem.task.size * len(problem.task.free) <= _ROOM
