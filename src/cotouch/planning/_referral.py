"""What the count of roots leaves uncertain."""

from collections.abc import Iterator

import numpy as np

from cotouch.arrays import Long
from cotouch.errors import UnsupportedError
from cotouch.interrupt import check, heeding
from cotouch.network import rightmost, rightmost_root
from cotouch.planning._deadline import aside
from cotouch.planning._problem import Problem
from cotouch.planning._task import DECAY, LOST_LINK, NOTHING, loop_of


def referred(problem: Problem, chosen: Long) -> float | None:
    """What `Problem.reference` says, unless the search is stopped: eigenvalues of a large matrix hear no flag.

    Args:
        problem: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
    """
    task = problem.task
    work = _worst_loss if task.objective == DECAY and task.lost != NOTHING else Problem.reference
    try:
        return aside(lambda: work(problem, chosen), task.stop)
    except KeyboardInterrupt:
        return None


def _worst_loss(problem: Problem, chosen: Long) -> float | None:
    """The decay after the worst loss, of which only what is uncertain is worked out slowly."""
    task, worst = problem.task, -np.inf
    nothing = np.zeros(0, np.complex128)
    whole = problem.network.with_links(problem.pairs(chosen))
    try:
        with heeding(task.stop):
            for (left, sync), (kept, without) in zip(problem.left_by(whole), _cases(problem, chosen), strict=True):
                for mode, (m, b, k) in enumerate(task.modes.tolist()):
                    root, certain, _ = rightmost(loop_of(task, kept, mode, without), k == 0.0, nothing)
                    check()
                    sure = certain and np.isfinite(root.real)
                    slow = None if sure else rightmost_root(left, mass=m, damping=b, stiffness=k, sync_damping=sync)
                    worst = max(worst, float(root.real) if slow is None else slow.rate)
    except (UnsupportedError, KeyboardInterrupt):  # the latter would end one thread of many; who shares work looks
        return None
    return worst


def _cases(problem: Problem, chosen: Long) -> Iterator[tuple[Long, int]]:
    """Links that are left and the user who is lost, -1 for none, in the order of `Problem.left_by`."""
    yield chosen, -1
    if problem.task.lost == LOST_LINK:
        for gone in range(len(chosen)):
            yield np.delete(chosen, gone), -1
    else:
        for user in range(problem.task.size):
            yield chosen, user
