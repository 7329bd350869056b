"""Where floods begin: networks about a few users in the middle, the best of many by their level."""

import numpy as np

from cotouch.arrays import Bool, Float, Long
from cotouch.compiled import raised, routine, subroutine
from cotouch.planning._levels import holds, level_of
from cotouch.planning._task import LOST_USER, NOTHING, Task, admissible, mean_delay

# By how much a network must beat the best so far.
_BETTER = 1e-3


@subroutine
def _link(task: Task, e: int, degree: Long, damping: Float, group: Long, taken: Bool) -> None:
    i, j = task.first[e], task.second[e]
    a, b = group[i], group[j]
    taken[e] = True
    for user in (i, j):
        degree[user] += 1
        damping[user] += task.load[e]
    if a != b:
        for u in range(task.size):
            if group[u] == a:
                group[u] = b


@subroutine
def _take(task: Task, e: int, tree: bool, degree: Long, damping: Float, group: Long, taken: Bool) -> bool:
    """Links a pair where the limits allow it; for a `tree` only if it joins two groups of users."""
    i, j = task.first[e], task.second[e]
    a, b = group[i], group[j]
    if taken[e] or (tree and a == b) or max(degree[i], degree[j]) >= task.most:
        return False
    if max(damping[i], damping[j]) + task.load[e] > task.limit:
        return False
    _link(task, e, degree, damping, group, taken)
    return True


@routine
def about(task: Task, hub: Bool, order: Long, chosen: Long) -> bool:
    """Links every user to a hub, and then to further ones, always the nearest first.

    Args:
        task: the search.
        hub: which users are hubs, (N,).
        order: the pairs of `task.free`, quickest first.
        chosen: filled with numbers of the pairs linked, ascending; as many as a choice has.

    Returns:
        Whether that is admissible.
    """
    degree, damping = np.zeros(task.size, np.int64), np.zeros(task.size)
    group, taken = np.arange(task.size), np.zeros(len(task.first), np.bool_)
    for e in task.require:
        _link(task, e, degree, damping, group, taken)
    count = len(task.require)
    # A tree, links to hubs before others; where a loss counts, a second link for those at its ends; then what is left.
    for turn in range(6):
        for e in order:
            if count == len(chosen):
                break
            i, j = task.first[e], task.second[e]
            if turn % 2 == 0 and not (hub[i] or hub[j]):
                continue
            if turn in (2, 3) and (task.lost == NOTHING or (degree[i] > 1 and degree[j] > 1)):
                continue
            if _take(task, e, turn < 2, degree, damping, group, taken):
                count += 1
    if count < len(chosen):
        return False
    chosen[:] = np.flatnonzero(taken)
    return admissible(task, chosen)


@routine
def central(task: Task) -> Long:
    """Users, those with short delays to all others first."""
    total, pairs = np.zeros(task.size), np.zeros(task.size)
    for e in range(len(task.first)):
        for user in (task.first[e], task.second[e]):
            total[user] += mean_delay(task, e)
            pairs[user] += 1.0
    return np.argsort(total / np.maximum(pairs, 1.0))


@routine
def hubs(task: Task, most: int, picks: Float, chosen: Long) -> float:
    """The network about hubs that holds at the highest level, of many that are picked.

    Args:
        task: the search, of consensus or decay.
        most: hubs, at most.
        picks: random numbers in [0, 1): how many hubs, and which, (tries, 1 + most).
        chosen: filled with the pairs linked, ascending.

    Returns:
        The level, 1/s; 0 where none is admissible or holds.
    """
    delay = np.empty(len(task.free))
    for c in range(len(task.free)):
        delay[c] = mean_delay(task, task.free[c])
    order, middle = task.free[np.argsort(delay)], central(task)
    hub, trial = np.zeros(task.size, np.bool_), np.empty_like(chosen)
    least = 2 if task.lost == LOST_USER else 1
    best = 0.0
    for t in range(len(picks)):
        if raised(task.stop):
            break
        hub[:] = False
        for h in range(least + int(picks[t, 0] * (most - least + 1))):
            # Squares: users in the middle more often.
            hub[middle[int(picks[t, 1 + h] ** 2 * task.size)]] = True
        if not about(task, hub, order, trial) or (best > 0.0 and not holds(task, trial, (1.0 + _BETTER) * best)):
            continue
        level = level_of(task, trial)
        if level > best:
            best = level
            chosen[:] = trial
    return best
