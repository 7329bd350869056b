"""What the search looks for, in compiled form: the pairs that may be linked, the limits on them, the objective."""

from typing import NamedTuple

import numpy as np

from cotouch.arrays import Complex, Float, Long
from cotouch.compiled import raised, routine, subroutine
from cotouch.network import Loop, rightmost, slowest
from cotouch.planning._feel import felt

CONSENSUS, DECAY, DAMPING, DRAG, FEEL = range(5)
NOTHING, LOST_LINK, LOST_USER = 0, 1, 2


class Task(NamedTuple):
    """One search. Pairs that may be linked are numbered in lexicographic order, M of them.

    Attributes:
        size: number of users, N.
        objective: `CONSENSUS`, `DECAY`, `DAMPING`, `DRAG` or `FEEL`.
        first: smaller user of each pair, (M,).
        second: larger user, (M,).
        spring: N/m, (M,).
        to_first: s, (M,), delay from second to first; for consensus a whole number of time units.
        to_second: s, (M,), the other way.
        lag_first: for consensus the delays in time units, (M,).
        lag_second: the other way, (M,).
        load: what the link adds to the damping of either end, Ns/m, (M,): `K (d_ij + d_ji) / 2`.
        require: pairs that every choice has, ascending.
        free: the other pairs, ascending.
        pick: how many of `free` a choice has.
        most: largest number of links of one user.
        modes: mass [kg], damping [Ns/m], stiffness [N/m] of each body mode, (modes, 3).
        own_drag: damping of the object itself, Ns/m; see `own_drag`.
        sync: synchronisation damping Ns/m, (N,), or (0,) for the rule.
        limit: Ns/m that no `B_i` of the rule may exceed; inf for none.
        drag: Ns/m that the drag of all users together may not exceed; inf for none.
        lost: `LOST_LINK` or `LOST_USER` where the objective is the worst with any one of them lost, or `NOTHING`.
        top: π over the time unit of consensus, 1/s.
        tones: 1/s, angular frequencies at which a hand feels the object.
        stop: the search ends, with whatever it has, once this is raised, (1,); see `cotouch.interrupt`.
    """

    size: int
    objective: int
    first: Long
    second: Long
    spring: Float
    to_first: Float
    to_second: Float
    lag_first: Long
    lag_second: Long
    load: Float
    require: Long
    free: Long
    pick: int
    most: int
    modes: Float
    own_drag: float
    sync: Float
    limit: float
    drag: float
    lost: int
    top: float
    tones: Float
    stop: Long


@subroutine
def mean_delay(task: Task, e: int) -> float:
    """Mean of both delays of a pair, s.

    Args:
        task: the search.
        e: number of the pair.
    """
    return 0.5 * (task.to_first[e] + task.to_second[e])


@subroutine
def _joined(task: Task, chosen: Long, without_link: int, without_user: int, group: Long) -> bool:
    """Whether links connect all users but one, without one of them; -1 leaves none out."""
    for u in range(task.size):
        group[u] = u
    groups = task.size - (1 if without_user >= 0 else 0)
    for e in chosen:
        i, j = task.first[e], task.second[e]
        if without_user in (i, j) or e == without_link:
            continue
        a, b = group[i], group[j]
        if a != b:
            groups -= 1
            for u in range(task.size):
                if group[u] == a:
                    group[u] = b
    return groups == 1


@routine
def admissible(task: Task, chosen: Long) -> bool:
    """Whether links connect all users, also those left after a loss, and keep to the limits.

    Args:
        task: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
    """
    degree, damping = np.zeros(task.size, np.int64), np.zeros(task.size)
    total = 0.0
    for e in chosen:
        i, j = task.first[e], task.second[e]
        degree[i] += 1
        degree[j] += 1
        damping[i] += task.load[e]
        damping[j] += task.load[e]
        total += task.load[e]
        if degree[i] > task.most or degree[j] > task.most:
            return False
    if np.max(damping) > task.limit or drag_of(task, float(total)) > task.drag:
        return False
    group = np.empty(task.size, np.int64)
    for without in range(-1, task.size if task.lost == LOST_USER else 0):
        if not _joined(task, chosen, -1, without, group):
            return False
    for e in chosen[: len(chosen) if task.lost == LOST_LINK else 0]:  # noqa: SIM110 (kernels have no generators)
        if not _joined(task, chosen, e, -1, group):
            return False
    return True


@routine
def drag_of(task: Task, total: float) -> float:
    """What all users together feel per speed of a steady common motion, Ns/m: the sum of `B_i + sum_j K_ij d_ij`.

    The object's own damping comes on top.

    Args:
        task: the search.
        total: sum of the loads of the links.
    """
    own = np.sum(task.sync) if len(task.sync) > 0 else 2.0 * total
    return own + 2.0 * total + task.own_drag


@routine
def weight_of(task: Task, chosen: Long) -> float:
    """What follows from the loads alone: the largest damping, or for `DRAG` the drag of all together, Ns/m.

    Args:
        task: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
    """
    damping, total = np.zeros(task.size), 0.0
    for e in chosen:
        damping[task.first[e]] += task.load[e]
        damping[task.second[e]] += task.load[e]
        total += task.load[e]
    if task.objective == DAMPING:
        return np.max(damping)
    return drag_of(task, float(total))


@subroutine
def _slowest_of(task: Task, loop: Loop, mode: int, guesses: Complex, enough: float) -> tuple[complex, bool]:
    """The objective of one mode's loop, as a root that has it as real part; and whether it is certain."""
    if task.objective == FEEL:
        worst = felt(loop, task.modes[mode], task.tones, enough)
        return complex(worst, 0.0), not raised(task.stop)
    if task.objective == CONSENSUS:
        root, certain, _ = slowest(loop, task.top, guesses, enough)
    else:
        root, certain, _ = rightmost(loop, task.modes[mode, 2] == 0.0, guesses)
    # No root at all is rare enough to be looked at again.
    return root, certain and root.real > -np.inf


@routine
def period_of(task: Task, chosen: Long) -> int:
    """Greatest common divisor of the total lags of all cycles of connected links: `network.cycle_period`, compiled.

    Args:
        task: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
    """
    distance, reached = np.zeros(task.size, np.int64), np.zeros(task.size, np.bool_)
    reached[0] = True
    left = task.size - 1
    while left > 0:
        for e in chosen:
            i, j = task.first[e], task.second[e]
            if reached[i] and not reached[j]:
                distance[j] = distance[i] + task.lag_second[e]
            elif reached[j] and not reached[i]:
                distance[i] = distance[j] + task.lag_first[e]
            else:
                continue
            reached[i] = reached[j] = True
            left -= 1
    period = 0
    for e in chosen:
        i, j = task.first[e], task.second[e]
        for rest in (
            distance[j] + task.lag_first[e] - distance[i],
            distance[i] + task.lag_second[e] - distance[j],
        ):
            a, b = period, abs(int(rest))
            while b != 0:
                a, b = b, a % b
            period = a
    return period


@routine
def loop_of(task: Task, chosen: Long, mode: int, without: int) -> Loop:
    """The loop of one choice of links: the consensus, or the closed loop of one body mode; maybe without one user.

    Args:
        task: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
        mode: number of the body mode, from 0; without meaning for the consensus.
        without: user who is gone, from 0; -1: nobody.
    """
    n = task.size
    if without >= 0:
        n -= 1
        chosen = chosen[(task.first[chosen] != without) & (task.second[chosen] != without)]
    first, second = task.first[chosen], task.second[chosen]
    if without >= 0:
        first, second = first - (first > without), second - (second > without)
    mass, drag, rigid = np.zeros(n), np.zeros(n), np.zeros(n)
    moving = task.objective != CONSENSUS
    for c in range(len(chosen)):
        e = chosen[c]
        for i in (first[c], second[c]):
            rigid[i] += task.spring[e]
            if moving and len(task.sync) == 0:
                drag[i] += task.load[e]
    if moving:
        for i in range(n):
            mass[i] = task.modes[mode, 0] / n
            drag[i] += task.modes[mode, 1] / n
            rigid[i] += task.modes[mode, 2] / n
            if len(task.sync) > 0:
                drag[i] += task.sync[i + 1 if 0 <= without <= i else i]
    return Loop(
        mass,
        drag,
        rigid,
        first,
        second,
        task.spring[chosen],
        task.to_first[chosen],
        task.to_second[chosen],
        task.stop,
    )


@routine
def rate(task: Task, chosen: Long, guesses: Complex, enough: float) -> tuple[float, bool]:
    """The objective of connected links, in a form of which smaller is better.

    Args:
        task: the search.
        chosen: numbers of the pairs linked, ascending.
        guesses: of each mode where its root may be, real part -inf where nothing is known; the roots found replace
            them.
        enough: for consensus, feel and with losses, a value that the objective need not be known beyond.

    Returns:
        Real part of the slowest root in 1/s (0 for a periodic graph, -inf if there is no root), or the damping, drag or
        felt impedance in Ns/m; and whether it is certain.
    """
    if task.objective in (DAMPING, DRAG):
        return weight_of(task, chosen), True
    if task.objective == CONSENSUS and period_of(task, chosen) > 1:
        return 0.0, True
    worst, sure = -np.inf, True
    for mode in range(len(task.modes)):
        loop = loop_of(task, chosen, mode, -1)
        start = guesses[mode : mode + 1] if np.isfinite(guesses[mode].real) else guesses[:0]
        root, certain = _slowest_of(task, loop, mode, start, enough)
        if task.objective != FEEL:
            guesses[mode] = root
        sure = sure and certain
        worst = max(worst, root.real)
        if task.lost == NOTHING or not sure or worst > enough:
            continue
        for gone in range(len(chosen) if task.lost == LOST_LINK else task.size):
            if task.lost == LOST_LINK:
                loop = loop_of(task, np.concatenate((chosen[:gone], chosen[gone + 1 :])), mode, -1)
            else:
                loop = loop_of(task, chosen, mode, gone)
            root, certain = _slowest_of(task, loop, mode, guesses[:0], enough)
            sure = sure and certain
            worst = max(worst, root.real)
            if not sure or worst > enough:
                break
    return worst, sure
