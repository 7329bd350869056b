"""What a step costs against the number of nodes and against the number of users, and what a peer keeps in memory."""

import argparse
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks._copy import compiled, copy, cube
from benchmarks._report import Row, add_write, finish, interleave
from cotouch.body import lattice
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch

FIGURE = Path(__file__).parent.parent / "docs" / "images" / "scaling.png"
LARGEST_FIGURE = 60_000
SIDES = (1, 2, 3, 5, 7, 10, 14, 20, 25, 31)
USERS = (2, 5, 10, 30, 100, 300, 1000)
_NEIGHBOURS = 4  # on average
_ROUNDS = 7


def bytes_kept(arrays: Iterable[Any]) -> int:
    """Bytes of all arrays in some tuples."""
    return sum(part.nbytes for group in arrays for part in group if isinstance(part, np.ndarray))


def against_nodes() -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
    """Nodes, seconds of a step, iterations, and bytes a node of the largest body's matrices, state and scratch."""
    copies = []
    for side in SIDES:
        # One node has no edges; its solve is the closed form.
        body = cube(side) if side > 1 else lattice((1, 1, 1), ground="all", ground_stiffness=10.0)
        copies.append(copy(body, steps=max(2, 20_000 // side**3)))
    seconds = interleave({str(i): lambda c=c: compiled(c) for i, c in enumerate(copies)}, _ROUNDS)
    nodes = np.array([side**3 for side in SIDES])
    each = np.array([np.median(seconds[str(i)]) / c.lengths.size for i, c in enumerate(copies)])
    iterations = np.array([compiled(c) / c.lengths.size for c in copies])
    largest = copies[-1]
    kept = bytes_kept((largest.model.operator, largest.state, largest.work))
    return nodes, each, iterations, kept / nodes[-1]


def _community(users: int) -> Scenario:
    """A random sparse connected graph of users who hold a point, each at its own rate."""
    rng = np.random.default_rng(users)
    links = {(int(rng.integers(i)), i) for i in range(1, users)}
    while len(links) < min(users * _NEIGHBOURS // 2, users * (users - 1) // 2):
        a, b = sorted(int(i) for i in rng.choice(users, 2, replace=False))
        links.add((a, b))
    delay = rng.uniform(0.005, 0.05, (users, users))
    np.fill_diagonal(delay, 0.0)
    table: dict[str, Any] = {
        "network": {
            "users": [str(i + 1) for i in range(users)],
            "spring": 50.0 * (1.0 - np.eye(users)),
            "delay": delay,
            "links": [[a + 1, b + 1] for a, b in sorted(links)],
        },
        "steps": {"period": (1e-3 * rng.uniform(0.8, 1.2, users)).tolist(), "duration": max(0.2, 20.0 / users)},
        "hands": [{"user": i + 1, "path": float(rng.normal() * 0.05)} for i in range(min(users, 10))],
        "synchronisation": {"law": "spring"},
        "record": {"every": 100},
    }
    return Scenario.make(**table)


def against_users() -> tuple[np.ndarray, np.ndarray]:
    """Users, and seconds of one step of one user in the batch engine."""
    prepared = {str(users): prepare(_community(users)) for users in USERS}
    seconds = interleave({name: lambda p=p: run_batch(p) for name, p in prepared.items()}, _ROUNDS)
    events = np.array([prepared[str(users)].schedule.order.size for users in USERS])
    return np.array(USERS), np.array([np.median(seconds[str(users)]) for users in USERS]) / events


def _draw(nodes: np.ndarray, step: np.ndarray, users: np.ndarray, event: np.ndarray) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.2), layout="constrained")
    left.loglog(nodes, 1e6 * step, "o-")
    left.set(xlabel="nodes", ylabel="one step of a peer [µs]", title="Lattice, 3-D, two neighbours")
    left.axhline(1e3, color="0.6", linestyle=":")
    left.annotate("1 kHz", (nodes[0], 1e3), xytext=(0, 3), textcoords="offset points", color="0.4")
    right.loglog(users, 1e9 * event, "o-")
    right.set(xlabel="users", ylabel="one step of a user [ns]", title="Point, sparse random graph", ylim=(50, 5000))
    for axes in (left, right):
        axes.grid(visible=True, which="major", color="0.9")
    FIGURE.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(FIGURE, dpi=100)
    plt.close(figure)
    assert FIGURE.stat().st_size <= LARGEST_FIGURE, f"{FIGURE.name} is larger than {LARGEST_FIGURE} bytes"


def measure(*, draw: bool = False) -> list[Row]:
    """Rows of the table; the figure as well if asked."""
    nodes, step, iterations, kept = against_nodes()
    users, event = against_users()
    if draw:
        _draw(nodes, step, users, event)
    chosen = [int(np.flatnonzero(nodes == side**3)[0]) for side in (1, 10, 20, 31)]
    line = ", ".join(f"{nodes[i]:,}: {1e6 * step[i]:,.1f}" for i in chosen)
    per_node = ", ".join(f"{1e9 * step[i] / nodes[i] / max(iterations[i], 1.0):.1f}" for i in chosen[1:])
    crowd = ", ".join(f"{n:,}: {1e9 * t:.0f}" for n, t in zip(users, event, strict=True))
    return [
        Row("scaling", "step [µs] by nodes", line, "", f"{per_node} ns for each node and iteration"),
        Row(
            "scaling",
            "memory of a peer's matrices, state and scratch",
            f"{kept:.0f} B/node",
            "",
            f"{nodes[-1]:,} nodes in three dimensions, 6 neighbours; 32 B/node more for every sample kept",
        ),
        Row("scaling", "step of a user [ns] by users", crowd, "", f"{_NEIGHBOURS} neighbours on average, own rates"),
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    add_write(parser)
    options = parser.parse_args()
    finish(measure(draw=options.write), write=options.write)


if __name__ == "__main__":
    main()
