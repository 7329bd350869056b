"""Levels: how far left the slowest root of a choice would be if it were real, with both delays at their mean."""

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.compiled import routine, subroutine
from cotouch.planning._task import CONSENSUS, LOST_LINK, LOST_USER, Task, mean_delay

# Levels beyond which links carry e to this say nothing, and roots this many decades apart are not bisected.
FURTHEST, _HALVINGS = 30.0, 60


@subroutine
def ends(task: Task, e: int, level: float) -> tuple[float, float]:
    """What a link adds to the diagonal and takes from beside it at -λ.

    Args:
        task: the search.
        e: number of the pair.
        level: λ [1/s].
    """
    own = task.spring[e]
    if task.objective != CONSENSUS and len(task.sync) == 0:
        own -= level * task.load[e]
    return own, task.spring[e] * np.exp(level * mean_delay(task, e))


@subroutine
def fill(task: Task, chosen: Long, without: int, mode: int, level: float, place: Long, matrix: Float) -> None:
    """The matrix at -λ, users in their places; one `without` is left out (its row is that of a unit matrix).

    Args:
        task: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
        without: user whose row is left out, from 0; -1: nobody.
        mode: number of the body mode, from 0.
        level: λ [1/s].
        place: of each user's row, (N,).
        matrix: result, (N, N) [N/m].
    """
    n = task.size
    there = n - 1 if without >= 0 else n
    own = 0.0
    if task.objective != CONSENSUS:
        m, b, k = task.modes[mode, 0], task.modes[mode, 1], task.modes[mode, 2]
        own = ((m * level - b) * level + k) / there
    for i in range(n):
        for j in range(n):
            matrix[i, j] = 0.0
        matrix[i, i] = own
    if task.objective != CONSENSUS and len(task.sync) > 0:
        for i in range(n):
            matrix[place[i], place[i]] -= level * task.sync[i]
    for e in chosen:
        i, j = task.first[e], task.second[e]
        if without in (i, j):
            continue
        i, j = place[i], place[j]
        diagonal, beside = ends(task, e, level)
        matrix[i, i] += diagonal
        matrix[j, j] += diagonal
        matrix[i, j] -= beside
        matrix[j, i] -= beside
    if without >= 0:
        matrix[place[without], place[without]] = 1.0


@subroutine
def _negatives(matrix: Float) -> int:
    """Number of negative eigenvalues, by elimination; the matrix is used up. Too many where it meets a zero."""
    n = len(matrix)
    found = 0
    for p in range(n):
        pivot = matrix[p, p]
        if not np.abs(pivot) > 0.0:
            return n + 1
        if pivot < 0.0:
            found += 1
        for r in range(p + 1, n):
            factor = matrix[p, r] / pivot
            if factor != 0.0:
                for q in range(r, n):
                    matrix[r, q] -= factor * matrix[p, q]
    return found


@subroutine
def still(task: Task, mode: int) -> int:
    """Real roots that every choice has right of any level: the resting translation, if there is one.

    Args:
        task: the search.
        mode: number of the body mode, from 0.
    """
    return 1 if task.objective == CONSENSUS or task.modes[mode, 2] == 0.0 else 0


@subroutine
def _places(task: Task, chosen: Long) -> Long:
    """Users with few links first: elimination then fills little."""
    degree, place = np.zeros(task.size, np.int64), np.empty(task.size, np.int64)
    for e in chosen:
        degree[task.first[e]] += 1
        degree[task.second[e]] += 1
    order = np.argsort(degree)
    for a in range(task.size):
        place[order[a]] = a
    return place


@subroutine
def uneven(task: Task) -> bool:
    """Whether any link takes longer one way than the other, so that real roots are those of other links."""
    return bool(np.any(task.to_first != task.to_second))


@routine
def holds(task: Task, chosen: Long, level: float) -> bool:
    """Whether no real root of connected links lies right of -λ, for equal delays both ways.

    Args:
        task: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
        level: λ, >= 0 [1/s].
    """
    matrix, place = np.empty((task.size, task.size)), _places(task, chosen)
    for mode in range(len(task.modes)):
        for without in range(-1, task.size if task.lost == LOST_USER else 0):
            fill(task, chosen, without, mode, level, place, matrix)
            if _negatives(matrix) > still(task, mode):
                return False
        for gone in range(len(chosen) if task.lost == LOST_LINK else 0):
            left = np.concatenate((chosen[:gone], chosen[gone + 1 :]))
            fill(task, left, -1, mode, level, place, matrix)
            if _negatives(matrix) > still(task, mode):
                return False
    return True


@routine
def level_of(task: Task, chosen: Long) -> float:
    """The highest level at which links hold, but for a thousandth, 1/s; 0 if they hold at none.

    Args:
        task: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
    """
    longest = 0.0
    for e in range(len(task.first)):
        longest = max(longest, mean_delay(task, e))
    low, high = 0.0, 1e-6 / longest if longest > 0.0 else 1e-6
    for _ in range(_HALVINGS):
        if not holds(task, chosen, high) or high * longest > FURTHEST:
            break
        low, high = high, 2.0 * high
    for _ in range(_HALVINGS):
        if high - low < 1e-3 * high:
            break
        middle = 0.5 * (low + high)
        if holds(task, chosen, middle):
            low = middle
        else:
            high = middle
    return low
