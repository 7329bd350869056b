"""What the printed text gets wrong, with the numbers that show it."""

from dataclasses import dataclass
from typing import final

import numpy as np
from scipy import stats

from cotouch.arrays import Float
from cotouch.network import Network, mixing
from cotouch.simulation import simulate
from cotouch.study._data import free, names
from cotouch.study._topologies import TIME_UNIT, Topologies

_CONSENSUS = 30.0  # s of the first-order model
_START, _END = 100, 400  # its steps in the first second and in the last four
_PERIODS = (4e-3, 2e-3, 1e-3)
SEED = 3


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Errata:
    """Numbers behind the errata.

    Attributes:
        spearman: rank correlation of each consensus objective with the closed loop, all graphs.
        places: place of each convention's best and worst in the closed loop's ranking, from 1.
        one_graph: λ₂ of the closed loop's best graph under both conventions.
        periodic: graphs that never mix: at 0.01 s and 0.05 s, by convention.
        echo: links and period of a graph that never mixes.
        consensus: states of the first-order model over time, for the best graph and for `echo`, (steps, users).
        spreads: how much the states of the last four seconds still differ, as a share of the first second's.
        work: hands' work with and without the factor T_i, by T: `{T: (Σ T v̂ᵀf, Σ v̂ᵀf)}`.
    """

    spearman: dict[str, float]
    places: dict[str, tuple[int, int]]
    one_graph: dict[str, float]
    periodic: dict[str, tuple[int, int]]
    echo: tuple[str, int]
    consensus: dict[str, Float]
    spreads: dict[str, float]
    work: dict[float, tuple[float, float]]

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {
            "spearman": self.spearman,
            "places_of_best_and_worst": {name: list(places) for name, places in self.places.items()},
            "periodic_graphs_at_0.01_and_0.05_s": {name: list(count) for name, count in self.periodic.items()},
            "periodic_example": {"links": self.echo[0], "period": self.echo[1]},
            "consensus_spread_left": self.spreads,
            "work_with_and_without_T": {f"{period:g}": list(pair) for period, pair in self.work.items()},
        }


def errata(found: Topologies) -> Errata:
    """Looks at the paper's statements with the data of its own experiment."""
    decay = found.rankings["decay"]
    spearman: dict[str, float] = {}
    places: dict[str, tuple[int, int]] = {}
    one_graph: dict[str, float] = {}
    periodic: dict[str, tuple[int, int]] = {}
    for convention in ("equation", "matrix"):
        ranking = found.rankings[convention]
        spearman[convention] = float(stats.spearmanr(ranking.values, decay.values).statistic)
        places[convention] = decay.place(ranking.best), decay.place(ranking.worst)
        one_graph[convention] = float(ranking.values[decay.best])
        periodic[convention] = ranking.never, found.periodic[convention]
    looping = found.network.with_links(found.graphs[found.rankings["equation"].worst])
    consensus = {"best": first_order(found.best), "echo": first_order(looping)}
    return Errata(
        spearman=spearman,
        places=places,
        one_graph=one_graph,
        periodic=periodic,
        echo=(names(looping.links), mixing(looping, time_unit=TIME_UNIT).cycle_period),
        consensus=consensus,
        spreads={name: float(np.ptp(states[-_END:]) / np.ptp(states[:_START])) for name, states in consensus.items()},
        work={period: _work(found.best, period) for period in _PERIODS},
    )


def first_order(network: Network) -> Float:
    """`p_i(k+1) = Σ_j W_ij p_j(k+1−N_ij)` from different states, as printed, (steps, users)."""
    lags = np.rint(network.delay / TIME_UNIT).astype(np.int64)
    spring = network.linked_spring()
    weights = spring / spring.sum(axis=1, keepdims=True)
    steps, longest, users = round(_CONSENSUS / TIME_UNIT), int(lags.max()), network.size
    # Before time 0 everyone has its own state, different from step to step: a general start of the lifted system.
    states = np.zeros((longest + steps, users))
    states[:longest] = np.random.default_rng(SEED).uniform(-1.0, 1.0, (longest, users))
    columns = np.arange(users)[None, :]
    for k in range(longest, longest + steps):
        states[k] = (weights * states[k - lags, columns]).sum(axis=1)
    return states[longest - 1 :]


def _work(network: Network, period: float) -> tuple[float, float]:
    """Work of one hand that pulls for 2 s, and the same sum without T."""
    hands = [{"user": 1, "path": 0.1, "stiffness": 60.0, "damping": 2.0}]
    run = simulate(free(network, duration=2.0, period=period, hands=hands, start=False))
    speed = np.diff(run["position"].values[0, :, 0, 0]) / period
    force = run["force"].values[0, 1:, 0]
    return float(period * (speed @ force)), float(speed @ force)
