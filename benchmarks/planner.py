"""Choosing links: every graph of the paper, larger ones, beside dense eigenvalues and algebraic connectivity."""

import argparse
import math
import os
import subprocess
import sys
from collections.abc import Callable
from time import perf_counter, process_time
from typing import Any

import numpy as np
from scipy.stats import spearmanr

from benchmarks._brute import brute
from benchmarks._report import Row, add_write, finish
from cotouch.network import Network, connected_graphs, consensus_lags, generator_eigenvalues, rightmost_root
from cotouch.network._consensus import lifted_matrix
from cotouch.planning import plan
from cotouch.planning._problem import make_problem
from cotouch.planning._starts import random_choice
from cotouch.planning._task import rate

EXAMPLE = "examples/five-users.toml"
HOSTS = "examples/round-trips.csv"
LINKS = 6
_ROUNDS = 5
_SAMPLE = 5
_ORDER = 20


def community(users: int, seed: int) -> Network:
    """Users who may all be linked: springs of 20 to 100 N/m, asymmetric delays of 20 to 400 ms in steps of 10 ms."""
    rng = np.random.default_rng(seed)
    spring = np.triu(rng.uniform(20.0, 100.0, (users, users)), 1)
    delay = 0.01 * rng.integers(2, 41, (users, users))
    np.fill_diagonal(delay, 0.0)
    return Network(users=[str(i + 1) for i in range(users)], spring=spring + spring.T, delay=delay)


def _seconds(action: Callable[[], object], rounds: int = _ROUNDS, clock: Callable[[], float] = perf_counter) -> float:
    """Median of some rounds, after one that does not count."""
    action()
    times: list[float] = []
    for _ in range(rounds):
        start = clock()
        action()
        times.append(clock() - start)
    return float(np.median(times))


def _extrapolated(action: Callable[[Network], object], graphs: list[Network], count: int = _SAMPLE) -> float:
    """Seconds for all graphs, from `count` of them."""
    sample = graphs[:: max(1, len(graphs) // count)][:count]
    start = perf_counter()
    for graph in sample:
        action(graph)
    return (perf_counter() - start) / len(sample) * len(graphs)


def dense_consensus(network: Network, convention: Any, time_unit: float) -> float:
    """Second largest |eigenvalue| by all eigenvalues of the lifted matrix."""
    lags = consensus_lags(network, time_unit=time_unit, convention=convention, rounding="exact")
    spring = network.linked_spring()
    matrix = lifted_matrix(spring / spring.sum(axis=1, keepdims=True), lags)
    return float(np.sort(np.abs(np.linalg.eigvals(matrix)))[-2])


def dense_decay(network: Network) -> float:
    """Rightmost root but the one at 0 by collocation alone, 1/s."""
    spring = network.linked_spring()
    size = network.size
    sync = (spring * (network.delay + network.delay.T) / 2).sum(axis=1)
    roots = generator_eigenvalues(
        np.full(size, 1.0 / size), sync, spring.sum(axis=1), spring, network.delay, order=_ORDER
    )
    return float(np.delete(roots, np.abs(roots).argmin()).real.max())


def _where() -> str:
    """Cores this process may use, and how many processes wanted one in the last minute, all told."""
    return f"{len(os.sched_getaffinity(0))} cores, load {os.getloadavg()[0]:.1f}"


def _time(seconds: float) -> str:
    return f"{1e3 * seconds:,.0f} ms" if seconds < 1 else f"{seconds:,.1f} s"


def paper() -> list[Row]:
    """All connected choices of six links among the paper's five users."""
    import networkx as nx

    every = Network.read(EXAMPLE).with_links(None)
    graphs = [every.with_links(graph) for graph in connected_graphs(every, links=LINKS)]
    rows: list[Row] = []
    cases = (("equation", 0.01, 0.05, "≤ 50 ms"), ("matrix", 0.001, 0.1, "≤ 100 ms"))
    for convention, unit, goal, text in cases:
        took = _seconds(lambda c=convention, u=unit: plan(every, links=LINKS, convention=c, time_unit=u))
        lags = consensus_lags(graphs[0], time_unit=unit, convention=convention, rounding="exact")
        note = f"dense eigenvalues of J, about {int(lags.max(axis=0).sum()):,} rows"
        if unit < 0.005:
            note += ": not tried, it takes minutes for one graph"
        else:
            naive = _extrapolated(lambda g, c=convention, u=unit: dense_consensus(g, c, u), graphs)
            note += f": {_time(naive)}, extrapolated from {_SAMPLE} graphs"
        what = f"{len(graphs)} graphs, consensus ({convention}), time unit {unit:g} s"
        rows.append(
            Row("planner", what, _time(took), text, f"{note}; {'met' if took <= goal else 'not met'}; {_where()}")
        )
    took = _seconds(lambda: plan(every, links=LINKS, objective="decay"))
    naive = _extrapolated(dense_decay, graphs)
    note = f"collocation of order {_ORDER}: {_time(naive)}, extrapolated from {_SAMPLE} graphs"
    verdict = "met" if took <= 0.25 else "not met"
    rows.append(
        Row("planner", f"{len(graphs)} graphs, decay", _time(took), "≤ 250 ms", f"{note}; {verdict}; {_where()}")
    )

    def connectivity() -> list[float]:
        found: list[float] = []
        for graph in graphs:
            g = nx.Graph()
            g.add_weighted_edges_from((a, b, float(graph.spring[a, b])) for a, b in graph.links)
            found.append(float(nx.algebraic_connectivity(g, method="lanczos", seed=0)))
        return found

    proxy = connectivity()
    start = perf_counter()
    connectivity()
    took = perf_counter() - start
    rate = [-rightmost_root(graph).rate for graph in graphs]
    rho = float(spearmanr(proxy, rate).statistic)
    rows.append(
        Row(
            "planner",
            f"{len(graphs)} graphs, algebraic connectivity (networkx)",
            _time(took),
            "",
            f"blind to delays: rank correlation with decay {rho:.2f}",
        )
    )
    return rows


def _proved(users: int, links: int, objective: Any, goal: str, **more: Any) -> Row:
    network = community(users, users)
    start = perf_counter()
    found = plan(network, links=links, objective=objective, **more)
    took = perf_counter() - start
    return Row(
        "planner",
        f"{users} users, {links} of {len(network.links) - len(more.get('forbid', ()))} links, {objective}",
        _time(took),
        goal,
        f"{found.status}: {found.choices:,} choices, {found.graphs:,} connected; best {found.best.value:.6g}; "
        f"{_where()}",
    )


def large() -> list[Row]:
    """Searches of minutes: 352,716 choices proved; 30 users, where a local search says how good it is."""
    rows = [_proved(7, 10, objective, "≤ 5 min on 2 cores", jobs=2) for objective in ("consensus", "decay")]
    network = community(30, 30)
    for objective in ("consensus", "decay"):
        short, tenfold = (
            plan(network, links=60, objective=objective, method="local", starts=10**6, seconds=seconds, jobs=2)
            for seconds in (60.0, 600.0)
        )
        rows.append(
            Row(
                "planner",
                f"30 users, 60 of {len(network.links)} links, {objective}, local search",
                f"{short.best.value:.6g}",
                "within 60 s",
                f"{short.looked_at:,} looked at in {short.seconds:.0f} s; ten times the time: {tenfold.best.value:.6g} "
                f"of {tenfold.looked_at:,} in {tenfold.seconds:.0f} s; {_where()}",
            )
        )
    return rows


def _evaluation() -> list[Row]:
    """One certified decay of sparse graphs of hundreds of users."""
    rows: list[Row] = []
    for users, links, goal in ((100, 200, 0.02), (500, 1000, 0.3)):
        network = community(users, users)
        problem = make_problem(network, links=links, objective="decay")
        chosen = random_choice(problem.task, np.random.default_rng(0))
        assert chosen is not None
        guesses = np.full(1, complex(-np.inf, 0.0))
        sure = []
        took = _seconds(
            lambda p=problem, c=chosen, g=guesses, s=sure: s.append(rate(p.task, c, g.copy(), math.inf)[1]),
            clock=process_time,
        )
        rows.append(
            Row(
                "planner",
                f"one decay of {users} users and {links} random links, one core",
                _time(took),
                f"≤ {_time(goal)}",
                f"{'certain' if all(sure) else 'uncertain'}; {'met' if took <= goal else 'not met'}; {_where()}",
            )
        )
    return rows


def _searched(seeds: int = 5, seconds: float = 10.0) -> Row:
    """30 users, 60 links, in a sixth of the time that the goal allows; time of one core, whatever else it does."""
    options = {"links": 60, "objective": "decay", "method": "local", "starts": 10**6, "jobs": 1}
    network = community(30, 30)
    found = [
        plan(network, seconds=seconds, clock=process_time, seed=seed, damping_limit=140.0, **options)  # pyright: ignore[reportArgumentType]
        for seed in range(seeds)
    ]
    values = [one.best.value for one in found]
    longest, damping = max(one.seconds for one in found), max(float(one.best.damping.max()) for one in found)
    return Row(
        "planner",
        f"30 users, 60 links, decay, {seconds:.0f} s of one core, {seeds} seeds",
        f"{max(values):.3f} … {min(values):.3f} 1/s",
        "≤ −3.0 in all, 60 s",
        f"largest damping {damping:.1f} of 140 Ns/m; longest {longest:.1f} s; "
        f"{'met' if max(values) <= -3.0 and damping <= 140.0 else 'not met'}; {_where()}",
    )


def _beside_chance(seconds: float = 10.0, count: int = 2000) -> Row:
    """100 users, 200 links, beside random connected graphs, in a sixth of the time that the goal allows, likewise."""
    network = community(100, 100)
    problem = make_problem(network, links=200, objective="decay")
    rng, best = np.random.default_rng(0), math.inf
    for _ in range(count):
        chosen = random_choice(problem.task, rng)
        assert chosen is not None
        best = min(best, rate(problem.task, chosen, np.full(1, complex(-np.inf, 0.0)), math.inf)[0])
    found = plan(
        network, links=200, objective="decay", method="local", starts=10**6, seconds=seconds, clock=process_time, jobs=1
    )
    return Row(
        "planner",
        f"100 users, 200 links, decay, {seconds:.0f} s of one core",
        f"{found.best.value:.3f} 1/s",
        "twice the best of 2,000 random graphs, 60 s",
        f"best of {count:,} random graphs {best:.3f} 1/s; {found.seconds:.1f} s; "
        f"{'met' if found.best.value <= 2 * best else 'not met'}; {_where()}",
    )


def _cities(starts: int = 24) -> Row:
    """12 measured hosts, 16 links, beside ten times the effort."""
    network = Network.from_delays([HOSTS])
    short, long = (
        plan(network, links=16, objective="decay", method="local", starts=effort, seed=seed)
        for effort, seed in ((starts, 0), (10 * starts, 1))
    )
    return Row(
        "planner",
        "12 measured hosts, 16 links, decay, local search",
        f"{short.best.value:.4f} 1/s in {short.seconds:.1f} s",
        "within 1 % of ten times the effort",
        f"that gives {long.best.value:.4f} in {long.seconds:.1f} s; "
        f"{'met' if short.best.value <= 0.99 * long.best.value else 'not met'}; {_where()}",
    )


_FIRST = """
import sys
from time import perf_counter
from benchmarks.planner import community
from cotouch.planning import plan
users, seconds, jobs = (int(text) for text in sys.argv[1:])
network, start = community(users, users), perf_counter()
found = plan(
    network, links=2 * users - 3, objective="decay", method="local", starts=10**6, seconds=seconds, jobs=jobs
)
print(perf_counter() - start, found.best.value)
"""


def _budgets() -> list[Row]:
    """How long the first search of a process takes beside what it was given, from the call to the plan."""
    rows: list[Row] = []
    cases = [(5, 2), (8, 2), (12, 2), (30, 2), (100, 5), (500, 10)]
    for users, seconds in cases:
        took: list[float] = []
        best: list[str] = []
        for jobs in (1, 2):
            given = [str(part) for part in (users, seconds, jobs)]
            done = subprocess.run([sys.executable, "-c", _FIRST, *given], capture_output=True, text=True, check=True)
            spent, value = done.stdout.split()
            took.append(float(spent))
            best.append(f"{float(value):.3f}")
        rows.append(
            Row(
                "planner",
                f"{users} users, {2 * users - 3} links, decay, given {seconds} s, first search of a process",
                _time(max(took)),
                f"≤ {_time(1.1 * seconds)}",
                f"best {' and '.join(best)} 1/s with 1 and 2 threads; "
                f"{'met' if max(took) <= 1.1 * seconds else 'not met'}; {_where()}",
            )
        )
    return rows


def goals() -> list[Row]:
    """What the search is held to; some three minutes, once kernels are compiled."""
    plan(community(4, 4), links=4, objective="decay", method="local", starts=1)
    return [*_evaluation(), *_budgets(), _cities(), _beside_chance(), _searched()]


def measure(*, long: bool = False) -> list[Row]:
    """Rows of the table; those that take minutes if asked."""
    plan(community(4, 4), links=4, objective="decay")
    rows = [*paper(), _proved(6, 8, "decay", "≤ 3 s", forbid=[(0, 1)])]
    return [*rows, *goals(), *large()] if long else rows


def add_long(parser: argparse.ArgumentParser) -> None:
    """Adds the option for what takes minutes."""
    parser.add_argument("--long", action="store_true", help="also the planner's searches of many minutes")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    add_write(parser)
    add_long(parser)
    parser.add_argument("--goals", action="store_true", help="only what the search is held to")
    parser.add_argument("--brute", action="store_true", help="only the planner beside every choice worked out")
    options = parser.parse_args()
    if options.goals or options.brute:
        finish(goals() if options.goals else brute(), write=options.write)
    else:
        finish(measure(long=options.long), write=options.write)


if __name__ == "__main__":
    main()
