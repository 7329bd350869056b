"""What a link law costs through the interface: springs written as a law beside the springs that the kernels have.

`python -m benchmarks.interface` runs both in turn on a point and on a lattice of 4,913 nodes; other laws stand beside
them, with what they themselves do.
"""

from dataclasses import replace
from os import getloadavg
from time import thread_time
from typing import Any

from benchmarks._report import Row, command
from cotouch.laws import SPRING, register
from cotouch.scenario import Scenario
from cotouch.simulation import Prepared, prepare, run_batch

_AS_LAW = register(replace(SPRING, name="spring as law", _parts=[]))
# Body, steps of a run, rounds.
_BODIES: dict[str, tuple[dict[str, Any], int, int]] = {
    "point": ({"kind": "point"}, 20_000, 10),
    "lattice of 4,913 nodes": ({"kind": "lattice", "shape": [17, 17, 17], "stiffness": 300.0, "damping": 0.3}, 60, 9),
}
_LAWS = ("wave", "paid")
_GOALS = {"point": "≤ 100 ns", "lattice of 4,913 nodes": "≤ 10 %"}


def _prepared(law: str, body: dict[str, Any], steps: int) -> Prepared:
    nodes, sway = (1, 0.05) if body["kind"] == "point" else (17**3, [0.05, 0.0, 0.0])
    return prepare(
        Scenario.make(
            network={"users": ["one", "two"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.02], [0.02, 0]]},
            body=body,
            steps={"duration": steps * 1e-3},
            solver={"basis": "nodal"},
            record={"every": steps},
            synchronisation={"law": law, "damping": 2.0},
            hands=[{"user": 1, "node": 1, "amplitude": sway}, {"user": 2, "node": nodes, "stiffness": 100.0}],
        )
    )


def measure() -> list[Row]:
    """Rows of the table."""
    rows: list[Row] = []
    for name, (body, steps, rounds) in _BODIES.items():
        runs = {law: _prepared(law, body, steps) for law in ("spring", _AS_LAW.name, *_LAWS)}
        least = dict.fromkeys(runs, float("inf"))
        for _ in range(rounds):
            for law, run in runs.items():
                begun = thread_time()
                run_batch(run)
                least[law] = min(least[law], thread_time() - begun)
        # Two users and a link: as many ends as steps of all users.
        each = {law: 1e9 * seconds / (2 * steps) for law, seconds in least.items()}
        bare = each["spring"]
        for law in (_AS_LAW.name, *_LAWS):
            more, share = each[law] - bare, 100.0 * (each[law] / bare - 1.0)
            value = f"{more:+,.0f} ns" if name == "point" else f"{share:+.1f} %"
            goal = _GOALS[name] if law == _AS_LAW.name else ""
            beside = (
                f"a step with built-in springs takes {bare:,.0f} ns; {share:+.1f} %, {more:+,.0f} ns; CPU time, best "
                f"of {rounds}; load of the machine {getloadavg()[0]:.1f}"
            )
            rows.append(Row("law interface", f"{name}: {law}, a link's end and step", value, goal, beside))
    return rows


if __name__ == "__main__":
    command(measure, __doc__)
