"""Every choice of links under several objectives, side by side."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Unpack, final

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import NetworkError
from cotouch.interrupt import check, interruptible
from cotouch.network import Network, Pair
from cotouch.planning._enumerate import chosen_at, values_of
from cotouch.planning._options import ProblemOptions
from cotouch.planning._problem import make_problem
from cotouch.planning._result import shown

# More choices than this are not for looking at side by side.
_MOST = 200_000


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Survey:
    """All connected choices of links.

    Attributes:
        graphs: pairs of user indices (from 0) of each, in lexicographic order.
        values: of each graph, by the names asked for; smaller is better; NaN where nothing could tell.
        never: by the same names, how many graphs are periodic and never mix (consensus).
        choices: how many choices there are, connected or not.
    """

    graphs: tuple[tuple[Pair, ...], ...]
    values: dict[str, Float]
    never: dict[str, int]
    choices: int


@interruptible
def survey(
    network: Network, *, links: int, objectives: Mapping[str, ProblemOptions], **options: Unpack[ProblemOptions]
) -> Survey:
    """Works out several objectives of every connected choice of links.

    Args:
        network: as in `plan`.
        links: how many links each choice has.
        objectives: by a name of your own, options of `plan` that differ between them, such as `{"paper": {"objective":
            "consensus", "time_unit": 0.05, "rounding": "up"}, "loop": {"objective": "decay"}}`.
        **options: of `plan`, for all of them: `require`, `never`, `max_degree`, `mass`, `damping`, `stiffness`.

    Raises:
        NetworkError: more than 200,000 choices, or as `plan` raises it.
    """
    values: dict[str, Float] = {}
    never: dict[str, int] = {}
    graphs: tuple[tuple[Pair, ...], ...] = ()
    choices = 0
    for name, own in objectives.items():
        asked: ProblemOptions = {**options, **own}
        problem = make_problem(network, links=links, **asked)
        choices = problem.choices
        if choices > _MOST:
            raise NetworkError(f"there are {choices} choices of {links} links; at most {_MOST} can be shown together")
        found = values_of(problem, 0, choices)
        check()
        admitted = np.flatnonzero(found.connected)
        values[name] = np.array([shown(problem, value) for value in found.values[admitted].tolist()])
        never[name] = int((values[name] == 1.0).sum()) if problem.objective == "consensus" else 0
        if not graphs:
            graphs = tuple(problem.pairs(chosen_at(problem, rank)) for rank in admitted.tolist())
    return Survey(graphs=graphs, values=values, never=never, choices=choices)
