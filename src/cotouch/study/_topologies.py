"""Which links to choose: all connected graphs, looked at one by one."""

from dataclasses import dataclass
from typing import Literal, TypeAlias, final

from cotouch.arrays import Float
from cotouch.network import Convention, Network, Pair
from cotouch.planning import ProblemOptions, survey
from cotouch.study._data import names

Objective: TypeAlias = Literal["equation", "matrix", "decay"]

LINKS = 6
TIME_UNIT = 0.01
COARSE_UNIT = 0.05


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Ranking:
    """All graphs under one objective, of which smaller is better.

    Attributes:
        objective: "equation" and "matrix": second largest |eigenvalue| of the consensus model; "decay": real part of
            the rightmost root of the closed loop [1/s].
        values: of every graph.
        never: how many graphs never mix; they share the last place.
        best: index of the best graph.
        worst: index of the worst graph, the first of those that never mix.
    """

    objective: Objective
    values: Float
    never: int
    best: int
    worst: int

    def place(self, graph: int) -> int:
        """Place of a graph, from 1 for the best."""
        return int((self.values < self.values[graph]).sum()) + 1


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Reference:
    """A value known beforehand, beside the one found here.

    Attributes:
        text: what it is.
        expected: links and value.
        found: links and value.
    """

    text: str
    expected: tuple[str, float]
    found: tuple[str, float]

    @property
    def agrees(self) -> bool:
        """Same links, and the same value to 1e-5."""
        return self.expected[0] == self.found[0] and abs(self.expected[1] - self.found[1]) <= 1e-5


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Topologies:
    """Every connected choice of links, ranked.

    Attributes:
        network: the users, with all links that their springs allow.
        choices: how many choices of links there are, connected or not.
        graphs: the connected ones.
        rankings: by objective, at the fine time unit.
        periodic: of each convention at the coarse time unit, how many graphs never mix.
        references: expected beside found.
    """

    network: Network
    choices: int
    graphs: tuple[tuple[Pair, ...], ...]
    rankings: dict[Objective, Ranking]
    periodic: dict[str, int]
    references: tuple[Reference, ...]

    @property
    def best(self) -> Network:
        """The network with the links that come to rest fastest."""
        return self.network.with_links(self.graphs[self.rankings["decay"].best])

    @property
    def worst(self) -> Network:
        """The network with the links that come to rest slowest."""
        return self.network.with_links(self.graphs[self.rankings["decay"].worst])

    @property
    def misjudged(self) -> Network:
        """What the matrix convention takes for the worst choice."""
        return self.network.with_links(self.graphs[self.rankings["matrix"].worst])

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        chosen = {
            objective: {
                "best": {"links": names(self.graphs[r.best]), "value": float(r.values[r.best])},
                "worst": {"links": names(self.graphs[r.worst]), "value": float(r.values[r.worst])},
                "never_mixing": r.never,
            }
            for objective, r in self.rankings.items()
        }
        return {
            "choices": self.choices,
            "connected": len(self.graphs),
            "time_unit_s": TIME_UNIT,
            "objectives": chosen,
            "references_agree": all(reference.agrees for reference in self.references),
        }


def topologies(network: Network) -> Topologies:
    """Looks at every connected choice of six links."""
    conventions: tuple[Convention, ...] = ("equation", "matrix")
    fine: dict[str, ProblemOptions] = {word: {"convention": word, "time_unit": TIME_UNIT} for word in conventions}
    # 0.04 s is not a multiple of the coarse unit; a delay rounds up, as an index delay does.
    coarse: dict[str, ProblemOptions] = {
        f"coarse {word}": {"convention": word, "time_unit": COARSE_UNIT, "rounding": "up"} for word in conventions
    }
    found = survey(network, links=LINKS, objectives={**fine, **coarse, "decay": {"objective": "decay"}})
    objectives: tuple[Objective, ...] = ("equation", "matrix", "decay")
    rankings: dict[Objective, Ranking] = {
        name: _ranking(name, found.values[name], found.never[name]) for name in objectives
    }
    return Topologies(
        network=network.with_links(None),
        choices=found.choices,
        graphs=found.graphs,
        rankings=rankings,
        periodic={word: found.never[f"coarse {word}"] for word in conventions},
        references=_references(found.graphs, rankings),
    )


def _ranking(objective: Objective, values: Float, never: int) -> Ranking:
    return Ranking(
        objective=objective, values=values, never=never, best=int(values.argmin()), worst=int(values.argmax())
    )


# Known beforehand, from dense eigenvalues of the printed J and dense collocation of the closed loop.
_EXPECTED: tuple[tuple[Objective, bool, str, str, float], ...] = (
    ("equation", True, "consensus, equation: best", "12 14 23 24 34 45", 0.993061),
    ("equation", False, "consensus, equation: worst", "7 periodic graphs", 1.0),
    ("matrix", True, "consensus, matrix: best", "12 23 24 34 35 45", 0.992725),
    ("matrix", False, "consensus, matrix: worst", "13 14 23 24 35 45", 0.999828),
    ("decay", True, "closed loop: best [1/s]", "12 14 23 24 34 45", -1.428553),
    ("decay", False, "closed loop: worst [1/s]", "13 14 23 25 34 35", -0.289652),
)


def _references(graphs: tuple[tuple[Pair, ...], ...], rankings: dict[Objective, Ranking]) -> tuple[Reference, ...]:
    result: list[Reference] = []
    for objective, best, text, links, value in _EXPECTED:
        ranking = rankings[objective]
        chosen = ranking.best if best else ranking.worst
        tie = not best and ranking.never > 0
        found = f"{ranking.never} periodic graphs" if tie else names(graphs[chosen])
        result.append(Reference(text=text, expected=(links, value), found=(found, float(ranking.values[chosen]))))
    return tuple(result)
