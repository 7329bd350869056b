"""The planner beside every choice worked out by other means: dense eigenvalues and matrices."""

import os
from collections.abc import Callable
from time import perf_counter

import numpy as np

from benchmarks._report import Row
from cotouch.network import Network, closed_loop, connected_graphs, consensus_lags, generator_eigenvalues
from cotouch.network._consensus import lifted_matrix
from cotouch.planning import Objective, plan

GRID = 0.05
_TONES = 2.0 * np.pi * np.geomspace(0.2, 2.0, 6)
# Degree of the collocation: its rightmost root is good to this share.
_ORDER, _NEAR = 24, 1e-6


def _network(rng: np.random.Generator) -> tuple[Network, int]:
    """4 or 5 users, most pairs with a spring, delays in whole steps of `GRID`; and a number of links that fits."""
    size = int(rng.integers(4, 6))
    while True:
        spring = np.triu(rng.uniform(10, 100, (size, size)) * (rng.random((size, size)) < 0.8), 1)
        delay = GRID * rng.integers(1, 12, (size, size)) * (1 - np.eye(size))
        network = Network(users=[f"u{i}" for i in range(size)], spring=spring + spring.T, delay=delay)
        if network.is_connected():
            return network, int(rng.integers(size - 1, min(size + 1, len(network.links)) + 1))


def consensus(network: Network) -> float:
    """Second largest |eigenvalue| by all eigenvalues of the lifted matrix."""
    lags = consensus_lags(network, time_unit=GRID, convention="equation", rounding="exact")
    spring = network.linked_spring()
    matrix = lifted_matrix(spring / spring.sum(axis=1, keepdims=True), lags)
    return float(np.sort(np.abs(np.linalg.eigvals(matrix)))[-2])


def decay(network: Network) -> float:
    """Rightmost root but the one at 0 by collocation alone, 1/s."""
    loop, sync = closed_loop(network)
    spring = network.linked_spring()
    roots = generator_eigenvalues(loop.mass, sync, spring.sum(axis=1), spring, network.delay, order=_ORDER)
    return float(np.delete(roots, np.abs(roots).argmin()).real.max())


def damping(network: Network) -> float:
    """Largest `B_i`, Ns/m."""
    return float((network.linked_spring() * (network.delay + network.delay.T) / 2).sum(axis=1).max())


def drag(network: Network) -> float:
    """`2 Σ K · round trip`, Ns/m."""
    return float(sum(2 * network.spring[a, b] * (network.delay[a, b] + network.delay[b, a]) for a, b in network.links))


def feel(network: Network) -> float:
    """The largest `|Z_i - Z|`, by inverses of dense matrices, Ns/m."""
    loop, _ = closed_loop(network)
    largest = 0.0
    for s in 1j * _TONES:
        matrix = np.diag((loop.mass * s + loop.drag) * s + loop.rigid)
        matrix[loop.first, loop.second] -= loop.spring * np.exp(-s * loop.to_first)
        matrix[loop.second, loop.first] -= loop.spring * np.exp(-s * loop.to_second)
        largest = max(largest, float(np.abs(1.0 / (s * np.linalg.inv(matrix).diagonal()) - s).max()))
    return largest


BY: dict[Objective, Callable[[Network], float]] = {
    "consensus": consensus,
    "decay": decay,
    "damping": damping,
    "drag": drag,
    "feel": feel,
}


def brute(networks: int = 100) -> list[Row]:
    """Best and worst of random networks, every objective and every method that takes it."""
    begun, rows = perf_counter(), []
    for objective, worked_out in BY.items():
        graphs, off, wrong, missed, searches = 0, 0.0, 0, 0, 0
        for seed in range(networks):
            network, links = _network(np.random.default_rng(seed))
            values = {graph: worked_out(network.with_links(graph)) for graph in connected_graphs(network, links=links)}
            graphs += len(values)
            best, worst = min(values.values()), max(values.values())
            for method in ("enumerate", "local", *(["bound"] if objective in ("damping", "drag") else [])):
                found = plan(
                    network, links=links, objective=objective, time_unit=GRID, method=method, starts=24, jobs=1
                )
                searches += 1
                own = abs(found.best.value - values[found.best.links]) / max(abs(best), 1e-3)
                off = max(off, own)
                short = (found.best.value - best) / max(abs(best), 1e-3)
                wrong += own > _NEAR or (found.status == "proved" and abs(short) > _NEAR)
                if method == "enumerate":
                    wrong += found.graphs != len(values) or abs(found.worst.value - worst) > _NEAR * max(abs(worst), 1)
                else:
                    missed += short > _NEAR
        rows.append(
            Row(
                "planner",
                f"brute force, {networks} random networks of 4 or 5 users, {objective}",
                f"{wrong} of {searches} searches wrong",
                "0",
                f"{graphs:,} graphs by dense matrices, values within {off:.1e}; local search missed the best {missed} "
                f"times; {perf_counter() - begun:,.0f} s; {len(os.sched_getaffinity(0))} cores",
            )
        )
    return rows
