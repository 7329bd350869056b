"""What a plan says."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal, TypeAlias, final

import numpy as np
import scipy.sparse
import scipy.sparse.csgraph

from cotouch.arrays import Float, Long
from cotouch.network import Network, Pair
from cotouch.planning._problem import Objective, Problem
from cotouch.planning._task import DECAY, NOTHING, drag_of, period_of, rate

# Users up to whom a decay that is uncertain is worked out slowly.
_SLOW = 40

PlanStatus: TypeAlias = Literal["proved", "best found"]
WorstStatus: TypeAlias = Literal["proved", "worst found"]
SearchMethod: TypeAlias = Literal["enumerate", "bound", "local"]


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Choice:
    """One choice of links.

    Attributes:
        links: pairs of user indices, from 0; hand them to `Network.with_links`.
        value: the objective, of which smaller is better: second largest |eigenvalue|, real part of the rightmost root
            [1/s], largest damping, drag or felt impedance [Ns/m].
        time_constant_s: seconds in which what is left falls by e, of the consensus or else of the closed loop; inf if
            it never does; NaN where springs have weights, which the closed loop does not take.
        damping: `B_i` in Ns/m, (N,): the rule with the delays as ages, or what was given.
        drag: Ns/m that all users together feel as they move the object steadily: the object's own damping and the sum
            of `B_i + sum_j K_ij d_ij`.
        worst_path_s: longest of the quickest ways from any user to any other along the links, s.
        cycle_period: of the consensus, in time units; above 1 it never settles. 1 for the other objectives.
    """

    links: tuple[Pair, ...]
    value: float
    time_constant_s: float
    damping: Float
    drag: float
    worst_path_s: float
    cycle_period: int

    def numbers(self, users: Sequence[str]) -> dict[str, object]:
        """For JSON, with links between these names."""
        return {
            "links": [[users[a], users[b]] for a, b in self.links],
            "value": self.value,
            "time_constant_s": self.time_constant_s,
            "damping": self.damping.tolist(),
            "largest_damping": float(self.damping.max()),
            "drag": self.drag,
            "worst_path_s": self.worst_path_s,
            "cycle_period": self.cycle_period,
        }


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Plan:
    """The best choice of links, and how sure that is.

    Attributes:
        users: their names.
        objective: what was to be small.
        status: "proved": enumeration or a bound covers every choice; "best found": nothing is claimed of the rest.
        method: how it was found.
        best: the best choice.
        worst: the worst choice, as far as `worst_status` says.
        worst_status: "proved": every choice was looked at; "worst found": the worst of those that were worked out, and
            nothing is claimed of the rest. A bound leaves out what is not best, so it never proves the worst.
        top: the best choices, best first.
        choices: how many choices of links there are, connected or not.
        graphs: how many connected ones within the limits were looked at.
        looked_at: how many choices were looked at.
        periodic: how many of the graphs never mix (consensus; after an enumeration).
        unsure: how many of the graphs no method could tell for certain; they are left out.
        seed: of the random starts.
        seconds: how long it took.
        notes: sentences on what may be a mistake, and on what did not go as asked.
        bound: the best value that any choice could have, by a relaxation; None where none is known.
        bound_by: which relaxation, or why there is none.
    """

    users: tuple[str, ...]
    objective: Objective
    status: PlanStatus
    method: SearchMethod
    best: Choice
    worst: Choice
    worst_status: WorstStatus
    top: tuple[Choice, ...]
    choices: int
    graphs: int
    looked_at: int
    periodic: int
    unsure: int
    seed: int
    seconds: float
    notes: tuple[str, ...] = ()
    bound: float | None = None
    bound_by: str = ""

    def numbers(self) -> dict[str, object]:
        """For JSON; users go by their names."""
        return {
            "users": list(self.users),
            "objective": self.objective,
            "status": self.status,
            "method": self.method,
            "graphs": self.graphs,
            "choices": self.choices,
            "looked_at": self.looked_at,
            "periodic": self.periodic,
            "unsure": self.unsure,
            "seed": self.seed,
            "seconds": self.seconds,
            "notes": list(self.notes),
            "bound": self.bound,
            "bound_by": self.bound_by,
            "best": self.best.numbers(self.users),
            "worst": self.worst.numbers(self.users),
            "worst_status": self.worst_status,
            "top": [choice.numbers(self.users) for choice in self.top],
        }


def shown(problem: Problem, value: float) -> float:
    """The objective as users read it, from the form that `rate` gives.

    Args:
        problem: the search.
        value: objective, as `rate` gives it.
    """
    return math.exp(value * problem.time_unit) if problem.objective == "consensus" else value


def choice_of(problem: Problem, chosen: Long, value: float) -> Choice:
    """Everything about one choice, from the numbers of its pairs and its objective as `rate` gives it.

    Args:
        problem: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
        value: its objective, as `rate` gives it.
    """
    task = problem.task
    network = problem.network.with_links(problem.pairs(chosen))
    damping = np.zeros(task.size)
    for end in (task.first, task.second):
        np.add.at(damping, end[chosen], task.load[chosen])
    slowest = value if problem.objective in ("consensus", "decay") else _decay(problem, chosen)
    return Choice(
        links=network.links,
        value=shown(problem, value),
        time_constant_s=math.nan if math.isnan(slowest) else -1.0 / slowest if slowest < 0 else math.inf,
        damping=task.sync if task.sync.size else damping,
        drag=float(drag_of(task, float(task.load[chosen].sum()))),
        worst_path_s=worst_path(network),
        cycle_period=int(period_of(task, chosen)) if problem.objective == "consensus" else 1,
    )


def _decay(problem: Problem, chosen: Long) -> float:
    """Rightmost root of the closed loop beside another objective, 1/s; NaN where there is none to be had."""
    if any(problem.network.weight_of[i, j] >= 0 for i, j in problem.pairs(chosen)):
        return math.nan
    task = problem.task._replace(objective=DECAY, lost=NOTHING)
    value, sure = rate(task, chosen, np.full(len(task.modes), complex(-np.inf, 0.0)), np.inf)
    if sure:
        return float(value)
    settled = replace(problem, objective="decay", task=task).reference(chosen) if task.size <= _SLOW else None
    return math.nan if settled is None else settled


def worst_path(network: Network) -> float:
    """Longest of the quickest ways from any user to any other along the links, s."""
    ends = np.array(network.links, dtype=np.int64).reshape(-1, 2)
    there, back = np.concatenate([ends, ends[:, ::-1]]).T
    # A delay of 0 is no link to a sparse matrix.
    delay = np.maximum(network.delay[there, back], np.finfo(float).tiny)
    graph = scipy.sparse.csr_array((delay, (there, back)), shape=(network.size, network.size))
    longest = float(scipy.sparse.csgraph.shortest_path(graph).max())
    return longest if longest > network.size * np.finfo(float).tiny else 0.0
