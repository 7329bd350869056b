"""`python -m benchmarks.materials`: what a step of each material costs beside the linear one, and how exact it is.

One copy without neighbours on one core; the best and the middle of many steps. A cube of E = 10 kPa with spacing 1 cm,
bent by a tenth and turning, steps of 1 ms, dampers of 2e-4 s.
"""

import argparse
import os
import time

import numpy as np
from tests.mechanics.materials import EVERY, Alone, bent, made

from benchmarks._report import Row, add_write, finish
from cotouch.mechanics import BETA, ITERATIONS

_STEPS = 400
_TOLERANCE = 1e-6
_GOALS = {
    ("cells", 10): "0.25 ms",
    ("cells", 17): "1.0 ms",
    ("spring-network", 10): "0.4 ms",
    ("corotated", 10): "0.6 ms",
}


def measure(side: int = 10) -> list[Row]:
    """Time of a step of every material with so many nodes along each edge."""
    rows: list[Row] = []
    for name in EVERY:
        body = made(name, viscosity=2e-4, shape=(side, side, side))
        turning = np.cross([1.0, 2.0, 1.0], body.rest - body.rest.mean(axis=0))
        copy = Alone(body, bent(body, 0.05), turning, tolerance=_TOLERANCE)
        took, factors = np.empty(_STEPS), np.empty(_STEPS)
        for k in range(_STEPS):
            begin = time.perf_counter()
            ledger = copy.step(1e-3)
            took[k], factors[k] = time.perf_counter() - begin, ledger[BETA]
        found = f"{1e3 * np.min(took):.3f} ms best, {1e3 * np.median(took):.3f} ms median"
        exact = f"p99 |β - 1| {np.quantile(factors, 0.99):.1e}"
        note = f"{copy.force.directions} looks, {ledger[ITERATIONS]:.0f} iterations, {exact}"
        goal = _GOALS.get((name, side), "")
        rows.append(Row("materials", f"a step, {name}, {side**3} nodes", found, goal, note))
    rows.append(Row("materials", "load of the machine, of the last minute", f"{os.getloadavg()[0]:.1f}"))
    return rows


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--side", type=int, default=10)
    add_write(parser)
    options = parser.parse_args()
    finish(measure(options.side), write=options.write)
