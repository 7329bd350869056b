"""Whether a search compiles first, and what it compiles then."""

from collections.abc import Callable
from typing import Literal

import numpy as np

from cotouch.compiled import cold
from cotouch.network import Network
from cotouch.planning._bound import descend
from cotouch.planning._enumerate import sweep
from cotouch.planning._flood import flood
from cotouch.planning._hubs import hubs
from cotouch.planning._judge import pulls
from cotouch.planning._levels import level_of
from cotouch.planning._local import swaps
from cotouch.planning._problem import Objective, make_problem
from cotouch.planning._result import SearchMethod
from cotouch.planning._task import admissible, rate

_MOVING = ("consensus", "decay")


def compiles(method: Literal["auto"] | SearchMethod = "auto", objective: Objective = "decay") -> bool:
    """Whether `plan` is going to compile its kernels first, once on this machine, which takes about two minutes.

    Args:
        method: as `plan` takes it; "auto" counts as "enumerate".
        objective: likewise.
    """
    needed: list[Callable[..., object]] = [sweep] if method in ("auto", "enumerate") else [swaps, admissible, rate]
    if method == "bound":  # a local search takes it only where limits are so tight that no walk begins
        needed.append(descend)
    if method == "local" and objective in _MOVING:
        needed += [hubs, level_of, flood, pulls]
    return any(cold(kernel) for kernel in needed)


def warm(objective: Objective, method: SearchMethod, plan: Callable[..., object]) -> None:
    """Compiles, or reads from the disk, what a search is going to run.

    Args:
        objective: of the search.
        method: likewise.
        plan: `plan` itself.
    """
    delay = 0.01 * (1.0 - np.eye(3))
    tiny = Network(users=["a", "b", "c"], spring=100.0 * delay, delay=delay)
    plan(tiny, links=2, objective=objective, method=method, starts=2, jobs=1)
    if method != "enumerate" and objective in _MOVING:
        task = make_problem(tiny, links=2, objective=objective).task
        pulls(task, np.arange(2), np.array([-1.0 + 0.0j]), np.empty(3))
