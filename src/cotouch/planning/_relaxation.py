"""What no choice of links can be better than. **Beyond** the paper.

*Damping*: links that connect all users need, all together, at least the damping of the lightest spanning tree and the
lightest other links; were it shared equally, every user would have the mean. And nobody has less than the lightest link
brings.

*Drag* is a sum over links, so the lightest spanning tree and the lightest other links have the least of all [Kruskal
1956]: where limits allow them, that is the best itself.

*Decay*, where delays are equal both ways (or could be, were clocks set otherwise): then G is symmetric on the real
axis. At -λ a user whose quickest link takes longer than about 1/λ has a negative diagonal term whatever is linked. Two
such users without a link between them are two negative eigenvalues [Cauchy interlacing], one more than the resting
translation has, so a root lies right of -λ. All of them can be linked to each other only if there are links enough.
Held by a spring, an object has no resting translation, and the common motion of all users bounds the rate too.
"""

import math

import numpy as np
import scipy.sparse
import scipy.sparse.linalg
from scipy.sparse.csgraph import minimum_spanning_tree

from cotouch.arrays import Float, Long
from cotouch.planning._problem import Problem
from cotouch.planning._task import DAMPING, DECAY, DRAG, Task, drag_of

# The λ tried, per decade, and how often the step to the first is halved.
_PER_DECADE, _HALVINGS = 20, 8
# By how much round trips may differ from those of a choice of clocks, beside the longest.
_EQUAL = 1e-9
# Round-off, by which a bound is moved to the safe side.
_SAFE = 1e-9
# Beyond this exponentials overflow.
_FURTHEST = 300.0


def bound_of(problem: Problem) -> tuple[float | None, str]:
    """The best value that any choice could have, as users read it, and a sentence on what it rests on.

    Args:
        problem: the search.

    Returns:
        None where no relaxation is known, and why.
    """
    task = problem.task
    if task.objective == DAMPING:
        return _least_damping(problem), (
            "shares the damping of the lightest links that connect all users equally, and gives every user the "
            "lightest link"
        )
    if task.objective == DRAG:
        return float(drag_of(task, _least_load(problem))) * (1.0 - _SAFE), (
            "takes the lightest links that connect all users, whatever other limits say"
        )
    if task.objective != DECAY:
        return None, f"no relaxation is known for {problem.objective}"
    delay = _both_ways(task)
    if delay is None:
        return None, "no relaxation is known where delays differ both ways"
    rates = [_fastest(problem, delay, mode) for mode in task.modes]
    known = [rate for rate in rates if rate is not None]
    if not known:
        return None, "the relaxation by every user's quickest link says nothing"
    return max(-rate * (1.0 + _SAFE) for rate in known), "gives every user the quickest link, whatever the others have"


def _least_load(problem: Problem) -> float:
    """Sum of the loads of the lightest links that connect all users, Ns/m."""
    task, n = problem.task, problem.task.size
    load = task.load
    # Zero is no link to a sparse matrix.
    graph = scipy.sparse.csr_array((load + 1.0, (task.first, task.second)), shape=(n, n))
    graph[task.first[task.require], task.second[task.require]] = 1e-300
    tree = minimum_spanning_tree(graph).tocoo()
    number = {(int(i), int(j)): e for e, (i, j) in enumerate(zip(task.first, task.second, strict=True))}
    taken = {number[min(i, j), max(i, j)] for i, j in zip(tree.row.tolist(), tree.col.tolist(), strict=True)}
    taken |= set(task.require.tolist())
    others = np.sort(load[[e for e in range(len(load)) if e not in taken]])
    return float(load[sorted(taken)].sum() + others[: max(problem.links - len(taken), 0)].sum())


def _least_damping(problem: Problem) -> float:
    task, n, load = problem.task, problem.task.size, problem.task.load
    total = _least_load(problem)
    least = np.full(n, math.inf)
    for end in (task.first, task.second):
        np.minimum.at(least, end, load)
    own = np.zeros(n)
    for end in (task.first, task.second):
        np.add.at(own, end[task.require], load[task.require])
    return float(max(2.0 * total / n, least.max(), own.max())) * (1.0 - _SAFE)


def _both_ways(task: Task) -> Float | None:
    """Delay of every pair if it is the same both ways, once every user's clock is set right; else None."""
    apart = task.to_first - task.to_second
    longest = float(max(task.to_first.max(), task.to_second.max()))
    if np.abs(apart).max() > _EQUAL * longest:
        rows = np.arange(len(apart))
        ends = scipy.sparse.csr_array(
            (
                np.tile([1.0, -1.0], (len(apart), 1)).T.ravel(),
                (np.tile(rows, 2), np.concatenate([task.first, task.second])),
            ),
            shape=(len(apart), task.size),
        )
        clocks = scipy.sparse.linalg.lsqr(ends, apart, atol=1e-14, btol=1e-14)[0]
        if np.abs(ends @ clocks - apart).max() > _EQUAL * longest:
            return None
    return 0.5 * (task.to_first + task.to_second)


def _fastest(problem: Problem, delay: Float, mode: Float) -> float | None:
    """The lowest λ tried at which every choice has a root right of -λ, 1/s; None if there is none."""
    shortest, longest = float(delay[delay > 0].min(initial=math.inf)), float(delay.max())
    if not math.isfinite(shortest):
        return None
    low, high = math.log10((0.1 if mode[2] == 0.0 else 1e-4) / longest), math.log10(100.0 / shortest)
    below = 10.0**low
    for rate in np.logspace(low, high, int((high - low) * _PER_DECADE) + 1).tolist():
        if _impossible(problem, delay, mode, rate):
            # Each rate stands by itself, so what lies between may be tried in any order.
            above = rate
            for _ in range(_HALVINGS):
                middle = math.sqrt(below * above)
                below, above = (below, middle) if _impossible(problem, delay, mode, middle) else (middle, above)
            return above
        below = rate
    return None


def _impossible(problem: Problem, delay: Float, mode: Float, rate: float) -> bool:
    """Whether every choice has more negative eigenvalues at -λ than the resting translation."""
    task, n = problem.task, problem.task.size
    m, b, k = mode.tolist()
    own = ((m * rate - b) * rate + k) / n
    gain = task.spring * (1.0 if task.sync.size else 1.0 - rate * delay)
    most = np.full(n, -math.inf)
    positive = np.zeros(n)
    for end in (task.first, task.second):
        np.maximum.at(most, end, gain)
        np.add.at(positive, end, np.maximum(gain, 0.0))
    best = own + np.where(positive > 0.0, positive, most)
    if task.sync.size:
        best = best - rate * task.sync
    forced = np.flatnonzero(best < -_SAFE * np.abs(task.spring).max())
    if k > 0.0:
        # No root rests: one negative eigenvalue is enough, and so is a common motion of all users with the best links.
        common = np.sort(gain - task.spring * np.exp(np.minimum(rate * delay, _FURTHEST)))[::-1][: problem.links].sum()
        together = n * own + 2.0 * common - rate * task.sync.sum()
        return len(forced) > 0 or together < -_SAFE * np.abs(task.spring).max()
    return len(forced) > 1 and not _clique(problem, forced)


def _clique(problem: Problem, users: Long) -> bool:
    """Whether there are links for all users together and each of these with each other."""
    task, count = problem.task, len(users)
    inside = np.isin(task.first, users) & np.isin(task.second, users)
    needed = count * (count - 1) // 2
    return bool(int(inside.sum()) == needed and needed + task.size - count <= problem.links and count - 1 <= task.most)
