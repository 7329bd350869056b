"""Random scenarios for the record: does energy balance, and is enough damping enough?

Every scenario is drawn from (seed, number) alone, so that a single one can be run again with `--only NUMBER`.
"""

import argparse
import json
import multiprocessing
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
import numpy.typing as npt

from benchmarks._report import Row, add_write, finish
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch

SEED = 2010
TOLERANCE = 1e-10  # of the energy in play, for the balance and for passivity
SHORT = 500
# One in so many scenarios is run far below the damping that is needed, to see that this does show.
_BELOW = 10
_MODES = ("constant", "self-paced", "freshest")

Table = dict[str, Any]
Float = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Finding:
    """What one scenario came to.

    Attributes:
        number: of the scenario.
        below: whether its damping was far too small on purpose.
        delayed: whether it has a link, hence a delay.
        mode: of the synchronisation.
        events: steps of all users.
        residual: largest imbalance of energy, relative to the energy in play.
        margin: energy that could still be taken out at the worst moment, relative to the energy in play.
        finished: whether the motion stayed in floating point.
    """

    number: int
    below: bool
    delayed: bool
    mode: str
    events: int
    residual: float
    margin: float
    finished: bool

    @property
    def balanced(self) -> bool:
        """Whether energy balanced."""
        return self.residual <= TOLERANCE

    @property
    def passive(self) -> bool:
        """Whether no more energy came out than was there."""
        return self.finished and self.margin >= -TOLERANCE


def _log(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def _graph(rng: np.random.Generator, users: int) -> list[list[int]]:
    """Links of a random connected graph; one in eight keeps only some links of it."""
    links = {(int(rng.integers(i)), i) for i in range(1, users)}
    fraction = rng.random() ** 2
    links |= {(a, b) for b in range(users) for a in range(b) if rng.random() < fraction}
    if rng.random() < 0.125:
        links = {link for link in sorted(links) if rng.random() < 0.6}
    return [[a + 1, b + 1] for a, b in sorted(links)]


def _spd(rng: np.random.Generator, rows: int) -> Float:
    root = rng.normal(size=(rows, rows))
    return root @ root.T + 0.1 * np.eye(rows)


def _network(rng: np.random.Generator, body: Table) -> Table:
    users = int(rng.integers(1, 9))
    spring = np.zeros((users, users))
    delay = np.zeros((users, users))
    longest = _log(rng, 1e-3, 0.3)
    for b in range(users):
        for a in range(b):
            spring[a, b] = spring[b, a] = _log(rng, 1.0, 1000.0)
            delay[a, b], delay[b, a] = rng.uniform(0.0, longest, 2) * (rng.random(2) < 0.9)
    table: Table = {"users": [str(i + 1) for i in range(users)], "delay": delay.tolist(), "links": _graph(rng, users)}
    nodes, axes = _size(body)
    sizes = sorted({s for s in (nodes, nodes * axes) if 1 < s <= 12 and (nodes != axes or s == nodes * axes)})
    kind = rng.random()
    if sizes and users > 1 and kind < 0.2:
        rows = int(rng.choice(sizes))
        if kind < 0.1:
            table["weight"] = _spd(rng, rows).tolist()
        else:
            full = np.zeros((users, users, rows, rows))
            for b in range(users):
                for a in range(b):
                    full[a, b] = full[b, a] = spring[a, b] * _spd(rng, rows)
            spring = full
    table["spring"] = spring.tolist()
    return table


def _size(body: Table) -> tuple[int, int]:
    match body["kind"]:
        case "point":
            return 1, len(body["rest"])
        case "chain":
            return body["nodes"], body["dimension"]
        case "lattice":
            return int(np.prod(body["shape"])), len(body["shape"])
        case _:
            return len(body["rest"]), len(body["rest"][0])


def _body(rng: np.random.Generator) -> Table:
    mass = _log(rng, 0.05, 20.0)
    stiffness, damping = (_log(rng, *bounds) * (rng.random() < 0.7) for bounds in ((1.0, 1e5), (1e-3, 30.0)))
    axes = int(rng.integers(1, 4))
    kind = rng.choice(["point", "chain", "lattice", "matrices"], p=[0.4, 0.25, 0.2, 0.15])
    if kind == "point":
        return {"kind": "point", "mass": mass, "stiffness": stiffness, "damping": damping, "rest": [0.0] * axes}
    if kind == "matrices":
        nodes = int(rng.integers(1, 5))
        size = nodes if rng.random() < 0.5 else nodes * axes
        table: Table = {"kind": "matrices", "rest": rng.normal(size=(nodes, axes)).tolist()}
        table["mass"] = (mass / nodes * _spd(rng, size)).tolist()
        table["stiffness_ext"] = np.diag(stiffness * rng.random(size)).tolist()
        table["damping_ext"] = np.diag(damping * rng.random(size)).tolist()
        return table
    table = {
        "kind": str(kind),
        "mass": mass,
        "stiffness": stiffness,
        "damping": damping,
        "ground": str(rng.choice(["none", "all", "x-", "x+"])),
        "ground_stiffness": _log(rng, 1.0, 1e3),
        "ground_damping": _log(rng, 1e-2, 1.0),
    }
    if kind == "chain":
        return {**table, "nodes": int(rng.integers(2, 13)), "dimension": axes}
    shape = [int(extent) for extent in rng.integers(2, 4, axes)]
    return {**table, "shape": shape, "neighbours": int(rng.choice([6, 18, 26]))}


def _steps(rng: np.random.Generator, users: int) -> Table:
    count = int(_log(rng, 100, 2000))
    kind = rng.integers(4)
    if kind == 0:
        period = _log(rng, 1e-4, 5e-2)
        return {"period": period, "duration": period * count}
    if kind == 1:
        periods = np.exp(rng.uniform(np.log(1e-4), np.log(5e-2), users))
        return {"period": periods.tolist(), "duration": float(min(periods.min() * 20_000, periods.max() * count))}
    if kind == 2:
        rates = rng.uniform(100.0, 1500.0, users)
        return {"rate": rates.tolist(), "duration": float(count / rates.min())}
    low, high = np.sort(np.exp(rng.uniform(np.log(1e-4), np.log(5e-2), 2)))
    return {"random": {"low": float(low), "high": float(high)}, "duration": float(high * 2 + low * count)}


def _channel(rng: np.random.Generator) -> Table:
    table: Table = {}
    if rng.random() < 0.5:
        table["jitter"] = {
            "kind": str(rng.choice(["uniform", "exponential", "normal"])),
            "scale": _log(rng, 1e-4, 5e-2),
        }
    if rng.random() < 0.4:
        table["loss"] = float(rng.uniform(0.0, 0.5))
    if rng.random() < 0.2:
        enter, leave = float(rng.uniform(0.001, 0.1)), float(rng.uniform(0.05, 0.9))
        table["burst"] = {"enter": enter, "leave": leave}
    if rng.random() < 0.3:
        table["duplication"] = float(rng.uniform(0.0, 0.5))
    if rng.random() < 0.3:
        table |= {"reordering": float(rng.uniform(0.0, 0.5)), "reordering_delay": _log(rng, 1e-3, 5e-2)}
    return table


def _hand(rng: np.random.Generator, user: int, nodes: int, axes: int, duration: float) -> Table:
    hand: Table = {"user": user, "node": int(rng.integers(1, nodes + 1))}
    size = _log(rng, 1e-2, 1.0)
    if rng.random() < 0.4:
        size *= 50.0
        hand["kind"] = "force"
    else:
        hand["stiffness"] = _log(rng, 1.0, 5e3) * (rng.random() < 0.9)
        hand["damping"] = _log(rng, 0.01, 50.0) * (rng.random() < 0.7)
    shape = rng.integers(3)
    if shape == 0:
        hand["path"] = rng.normal(size=axes, scale=size).tolist()
    elif shape == 1:  # the adversary: new places or forces at random times, with jumps nearly at once
        times = np.sort(rng.uniform(0.0, duration, int(rng.integers(2, 60))))
        rows = [[float(t), *rng.normal(size=axes, scale=size)] for t in np.unique(times)]
        hand["path"] = rows
    else:
        hand["amplitude"] = rng.normal(size=axes, scale=size).tolist()
        hand["frequency"] = _log(rng, 0.5 / duration, 200.0)
        hand["phase"] = float(rng.uniform(0.0, 6.28))
    if rng.random() < 0.3:
        hand["begin"] = float(rng.uniform(0.0, 0.3) * duration)
    if rng.random() < 0.5:
        hand["release"] = float(rng.uniform(0.35, 1.0) * duration)
    return hand


def tables(number: int) -> tuple[Table, bool]:
    """The scenario of a number, and whether its damping is far too small on purpose."""
    rng = np.random.default_rng((SEED, number))
    below = number % _BELOW == 0
    body = _body(rng)
    network = _network(rng, body)
    users = len(network["users"])
    nodes, axes = _size(body)
    steps = _steps(rng, users)
    mode = str(rng.choice(_MODES))
    if mode == "constant":  # clocks of different rates cannot share an index
        steps |= {name: steps[name][0] for name in ("period", "rate") if isinstance(steps.get(name), list)}
    methods = ["rule", "minimax"] + (["exact"] if mode == "constant" and isinstance(steps.get("period"), float) else [])
    scale = float(rng.uniform(0.0, 0.1)) if below else 1.0 if rng.random() < 0.5 else float(rng.uniform(1.0, 2.0))
    synchronisation: Table = {"mode": mode, "damping": str(rng.choice(methods)), "damping_scale": scale}
    if not below and rng.random() < 0.2:
        synchronisation["extra_damping"] = rng.uniform(0.0, 5.0, users).tolist()
    holders = [i + 1 for i in range(users) if rng.random() < 0.7]
    hands = [_hand(rng, user, nodes, axes, steps["duration"]) for user in holders for _ in range(rng.integers(1, 3))]
    initial: Table = {}
    if below or rng.random() < 0.3:
        initial["position"] = (rng.normal(size=(users, nodes, axes)) * 0.1).tolist()
    if rng.random() < 0.3:
        initial["velocity"] = (rng.normal(size=(users, nodes, axes)) * 0.3).tolist()
    solver: Table = {"basis": str(rng.choice(["auto", "nodal"])), "tolerance": _log(rng, 1e-12, 1e-3)}
    if rng.random() < 0.5:
        solver["iterations"] = int(rng.integers(1, 51))
    return {
        "title": f"record {number}",
        "seed": number,
        "network": network,
        "body": body,
        "steps": steps,
        "synchronisation": synchronisation,
        "channel": _channel(rng),
        "hands": hands,
        "initial": initial,
        "solver": solver,
    }, below


def examine(number: int) -> Finding | str:
    """Runs one scenario; a sentence where it could not be run."""
    table, below = tables(number)
    try:
        prepared = prepare(Scenario.make(**table))
    except ValueError as error:  # self-paced users may wait for the first samples longer than the run lasts
        return f"{type(error).__name__}: {error}"
    outcome = run_batch(prepared)
    ticks = outcome.record.ticks
    finished = outcome.events == prepared.schedule.order.size
    done = ticks[:, : int(outcome.taken[prepared.schedule.reference]) + 1]
    with np.errstate(over="ignore", invalid="ignore"):
        stored, supplied, dissipated, residual = (np.abs(done[book]) for book in (0, 1, 2, 4))
        play = float(max(stored.max(), supplied.max(), dissipated.max(), -outcome.record.lowest[0]))
        play = play or 1.0  # nothing ever moved
        return Finding(
            number=number,
            below=below,
            delayed=bool(table["network"]["links"]),
            mode=table["synchronisation"]["mode"],
            events=outcome.events,
            residual=float(residual.max() / play),
            margin=float((outcome.record.lowest[0] + done[0, 0]) / play),
            finished=finished,
        )


def run(count: int, workers: int) -> tuple[list[Finding], list[str]]:
    """Findings of the first `count` scenarios that can be run, and why others could not."""
    findings: list[Finding] = []
    refused: list[str] = []
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        first = 1
        while len(findings) < count:
            wanted = count - len(findings)
            for found in pool.imap_unordered(examine, range(first, first + wanted), chunksize=8):
                (refused if isinstance(found, str) else findings).append(cast(Any, found))
            first += wanted
    return sorted(findings, key=lambda finding: finding.number), refused


def measure(count: int = SHORT, workers: int = 2) -> list[Row]:
    """Rows of the table."""
    findings, refused = run(count, workers)
    enough = [finding for finding in findings if not finding.below]
    below = [finding for finding in findings if finding.below and finding.delayed]
    worst = max(findings, key=lambda finding: finding.residual)
    thin = min(enough, key=lambda finding: finding.margin)
    unbalanced = [finding.number for finding in findings if not finding.balanced]
    active = [finding.number for finding in enough if not finding.passive]
    shown = [finding for finding in below if not finding.passive]
    diverged = [finding for finding in below if not finding.finished]
    steps = sum(finding.events for finding in findings)
    modes = ", ".join(f"{sum(finding.mode == mode for finding in findings):,} {mode}" for mode in _MODES)
    drawn = f"{modes}; {steps:,} steps; {len(refused)} more that end before the first sample is there"
    none = "none"
    return [
        Row("record", "random scenarios", f"{len(findings):,}", "", drawn),
        Row(
            "record",
            "worst energy residual, of the energy in play",
            f"{worst.residual:.1e}",
            f"≤ {TOLERANCE:g}",
            f"above: {unbalanced[:9] or none}; worst is number {worst.number}",
        ),
        Row(
            "record",
            "passivity violations, damping ≥ what the mode's certificate asks",
            f"{len(active)} of {len(enough):,}",
            "0",
            f"numbers: {active[:9] or none}; smallest margin {thin.margin:.1e} of the energy in play",
        ),
        Row(
            "record",
            "passivity violations, damping 0 to 0.1 × that, with links",
            f"{len(shown)} of {len(below):,}",
            "> 0",
            f"{len(diverged)} of them left floating point",
        ),
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=SHORT, help="how many scenarios (10,000 for the record)")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--only", type=int, help="run this scenario alone and print it")
    add_write(parser)
    options = parser.parse_args()
    if options.only is not None:
        print(json.dumps(tables(options.only)[0]))
        print(examine(options.only))
        return
    finish(measure(options.count, options.workers), write=options.write)


if __name__ == "__main__":
    main()
