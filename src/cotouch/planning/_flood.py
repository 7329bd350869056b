"""Search for links by a great deluge [Dueck 1993] on what the slowest root would be if it were real.

With both delays of a link at their mean, the characteristic matrix of the closed loop is symmetric on the real axis,
and the number of its negative eigenvalues at -λ counts the real roots right of it. A choice of links *holds* at a level
λ if there is none but the resting translation. To swap one link for another changes that matrix by rank 4, so its
inverse tells in a hundred nanoseconds whether the swap holds (inertia of a Schur complement [Haynsworth 1968]). Any
swap that holds is made, and then the level rises a little.

Nothing is certified by that: complex roots are not seen, and unequal delays move roots off the axis. What the search
ends with is worked out exactly by `rate`.
"""

from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.compiled import raised, routine, subroutine
from cotouch.planning._levels import FURTHEST, ends, fill, holds, still
from cotouch.planning._task import LOST_LINK, LOST_USER, NOTHING, Task, admissible, mean_delay

# Swaps tried at one level after which a search is over: so many times links times the logarithm of the others, but no
# more than so many times all there are.
_PATIENCE, _AGAIN = 2000, 30
# Work done by one call, about, in multiplications.
_WORK = 30_000_000
# The inverse is worked out anew after so many changes for each user.
_FRESH = 0.05


class Front(NamedTuple):
    """Where a search stands.

    Attributes:
        chosen: pairs linked, which hold at the level; changed in place.
        level: λ, 1/s.
        idle: swaps tried since the last one that held.
        over: whether the search has come to its end.
    """

    chosen: Long
    level: float
    idle: int
    over: bool


@subroutine
def _pluses(small: Float, size: int) -> int:
    """Number of positive eigenvalues of the leading block, by elimination; it is used up. Too many at a zero."""
    found = 0
    for p in range(size):
        pivot = small[p, p]
        if not np.abs(pivot) > 0.0:
            return size + 1
        if pivot > 0.0:
            found += 1
        for r in range(p + 1, size):
            factor = small[r, p] / pivot
            for q in range(p + 1, size):
                small[r, q] -= factor * small[p, q]
    return found


@subroutine
def _pair(inverse: Float, i: int, j: int, plus: float, minus: float, at: int, small: Float) -> None:
    """One link's block of `C⁻¹ + Uᵀ X U`, its columns of U being `e_i ± e_j`."""
    small[at, at] = 1.0 / plus + inverse[i, i] + 2.0 * inverse[i, j] + inverse[j, j]
    small[at + 1, at + 1] = 1.0 / minus + inverse[i, i] - 2.0 * inverse[i, j] + inverse[j, j]
    small[at, at + 1] = small[at + 1, at] = inverse[i, i] - inverse[j, j]


@subroutine
def _swap_holds(task: Task, inverse: Float, leaving: int, coming: int, level: float, small: Float) -> bool:
    """Whether the number of negative eigenvalues stays as it is when one link is swapped for another."""
    i, j = task.first[leaving], task.second[leaving]
    k, h = task.first[coming], task.second[coming]
    own, beside = ends(task, leaving, level)
    plus, minus = 0.5 * (beside - own), -0.5 * (own + beside)
    more, less = 0.0, 0.0
    own, beside = ends(task, coming, level)
    more, less = 0.5 * (own - beside), 0.5 * (own + beside)
    if plus == 0.0 or minus == 0.0 or more == 0.0 or less == 0.0:
        return False
    _pair(inverse, i, j, plus, minus, 0, small)
    _pair(inverse, k, h, more, less, 2, small)
    a, b, c, d = inverse[i, k], inverse[i, h], inverse[j, k], inverse[j, h]
    small[0, 2] = small[2, 0] = a + b + c + d
    small[0, 3] = small[3, 0] = a - b + c - d
    small[1, 2] = small[2, 1] = a + b - c - d
    small[1, 3] = small[3, 1] = a - b - c + d
    before = (1 if plus > 0.0 else 0) + (1 if minus > 0.0 else 0) + (1 if more > 0.0 else 0) + (1 if less > 0.0 else 0)
    return _pluses(small, 4) == before


@subroutine
def _loss_holds(task: Task, inverse: Float, gone: int, level: float, small: Float) -> bool:
    """The same where one link is lost."""
    own, beside = ends(task, gone, level)
    plus, minus = 0.5 * (beside - own), -0.5 * (own + beside)
    if plus == 0.0 or minus == 0.0:
        return False
    _pair(inverse, task.first[gone], task.second[gone], plus, minus, 0, small)
    return _pluses(small, 2) == (1 if plus > 0.0 else 0) + (1 if minus > 0.0 else 0)


@subroutine
def _changed(task: Task, inverse: Float, e: int, sign: float, level: float) -> None:
    """The inverse after a link has come (sign 1) or gone (-1): two updates of rank 1 [Sherman & Morrison 1950]."""
    n = task.size
    i, j = task.first[e], task.second[e]
    own, beside = ends(task, e, level)
    column = np.empty(n)
    for turn in range(2):
        side = 1.0 if turn == 0 else -1.0
        weight = sign * 0.5 * (own - side * beside)
        if weight == 0.0:
            continue
        for r in range(n):
            column[r] = inverse[r, i] + side * inverse[r, j]
        factor = 1.0 / (1.0 / weight + column[i] + side * column[j])
        for r in range(n):
            for c in range(n):
                inverse[r, c] -= factor * column[r] * column[c]


@subroutine
def _survives(task: Task, chosen: Long, inverses: Float, level: float, small: Float) -> bool:
    """Whether connected links still hold with any one of them, or any one user, lost."""
    for mode in range(len(task.modes)):
        if task.lost == LOST_LINK:
            for gone in chosen:
                if not _loss_holds(task, inverses[mode], gone, level, small):
                    return False
        if task.lost == LOST_USER:
            for user in range(task.size):
                fill(task, chosen, user, mode, level, np.arange(task.size), inverses[len(task.modes)])
                if _inverted(inverses[len(task.modes)]) > still(task, mode):
                    return False
    return True


@subroutine
def _inverted(matrix: Float) -> int:
    """Inverts in place (Gauss-Jordan); the number of negative eigenvalues, too many where it meets a zero."""
    n = len(matrix)
    found = 0
    for c in range(n):
        pivot = matrix[c, c]
        if not np.abs(pivot) > 0.0:
            return n + 1
        if pivot < 0.0:
            found += 1
        matrix[c, c] = 1.0
        for k in range(n):
            matrix[c, k] /= pivot
        for r in range(n):
            factor = matrix[r, c]
            if r != c and factor != 0.0:
                matrix[r, c] = 0.0
                for k in range(n):
                    matrix[r, k] -= factor * matrix[c, k]
    return found


@subroutine
def _ready(task: Task, chosen: Long, level: float, inverses: Float) -> bool:
    """Works the inverses out anew; whether the links hold."""
    held = True
    for mode in range(len(task.modes)):
        fill(task, chosen, -1, mode, level, np.arange(task.size), inverses[mode])
        held = held and _inverted(inverses[mode]) <= still(task, mode)
    return held


@subroutine
def _fits(task: Task, damping: Float, degree: Long, leaving: int, coming: int) -> bool:
    """Whether a swap keeps to the limits on links and damping."""
    i, j = task.first[leaving], task.second[leaving]
    for end in range(2):
        user = task.first[coming] if end == 0 else task.second[coming]
        shared = user in (i, j)
        if degree[user] + (0 if shared else 1) > task.most:
            return False
        if damping[user] + task.load[coming] - (task.load[leaving] if shared else 0.0) > task.limit:
            return False
    return True


@subroutine
def _count(task: Task, e: int, sign: int, damping: Float, degree: Long) -> None:
    i, j = task.first[e], task.second[e]
    damping[i] += sign * task.load[e]
    damping[j] += sign * task.load[e]
    degree[i] += sign
    degree[j] += sign


@subroutine
def _exchange(trial: Long, leaving: int, coming: int) -> None:
    for c in range(len(trial)):
        if trial[c] == leaving:
            trial[c] = coming
    trial.sort()


@routine
def flood(task: Task, front: Front, rise: float, picks: Float) -> Front:
    """Goes on with a search.

    Args:
        task: the search, of consensus or decay.
        front: where it stands; its links are changed.
        rise: share by which the level rises with every swap that holds.
        picks: random numbers in [0, 1), two for each swap to try, (tries, 2).
    """
    n, modes = task.size, len(task.modes)
    chosen, level, idle = front.chosen, front.level, front.idle
    linked = np.zeros(len(task.first), np.bool_)
    damping, degree = np.zeros(n), np.zeros(n, np.int64)
    inside, outside = np.empty(task.pick, np.int64), np.empty(len(task.free) - task.pick, np.int64)
    longest = 0.0
    for e in range(len(task.first)):
        longest = max(longest, mean_delay(task, e))
    for e in chosen:
        linked[e] = True
        _count(task, e, 1, damping, degree)
    a = b = 0
    for e in task.free:
        if linked[e]:
            inside[a] = e
            a += 1
        else:
            outside[b] = e
            b += 1
    small, inverses = np.empty((4, 4)), np.empty((modes + 1, n, n))
    if a == 0 or b == 0 or longest == 0.0 or not _ready(task, chosen, level, inverses):
        return Front(chosen, level, idle, True)
    patience = min(_AGAIN * a * b + 1000.0, _PATIENCE * a * np.log(b + 2.0))
    trial, pending, every = chosen.copy(), 0, max(1, int(_FRESH * n))
    made, most = 0, max(every, _WORK // (4 * n * n * modes + n * n * n * modes // every))
    for t in range(len(picks)):
        if idle > patience or made == most or raised(task.stop):
            break
        p, q = int(picks[t, 0] * a), int(picks[t, 1] * b)
        leaving, coming = inside[p], outside[q]
        idle += 1
        held = _fits(task, damping, degree, leaving, coming)
        for mode in range(modes):
            held = held and _swap_holds(task, inverses[mode], leaving, coming, level, small)
        if not held:
            continue
        _exchange(trial, leaving, coming)
        if not admissible(task, trial):
            _exchange(trial, coming, leaving)
            continue
        if every > 1 or task.lost != NOTHING:
            for mode in range(modes):
                _changed(task, inverses[mode], coming, 1.0, level)
                _changed(task, inverses[mode], leaving, -1.0, level)
            if task.lost != NOTHING and not _survives(task, trial, inverses, level, small):
                _exchange(trial, coming, leaving)
                for mode in range(modes):
                    _changed(task, inverses[mode], leaving, 1.0, level)
                    _changed(task, inverses[mode], coming, -1.0, level)
                continue
        inside[p], outside[q] = coming, leaving
        _count(task, leaving, -1, damping, degree)
        _count(task, coming, 1, damping, degree)
        made += 1
        pending += 1
        if pending < every and made < most:
            continue
        higher = min(level * (1.0 + rise) ** pending, FURTHEST / longest)
        pending = 0
        held = higher > level and _ready(task, trial, higher, inverses)
        if held and (task.lost == NOTHING or holds(task, trial, higher)):
            level, idle = higher, 0
        elif not _ready(task, trial, level, inverses):  # round-off had let something through
            return Front(chosen, level, idle, True)
        chosen[:] = trial
    if pending > 0 and _ready(task, trial, level, inverses):
        chosen[:] = trial
    return Front(chosen, level, idle, idle > patience)
