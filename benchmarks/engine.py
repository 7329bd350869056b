"""The paper's five users in the batch engine, beside the same equations in a NumPy loop."""

from collections.abc import Callable
from typing import Any

import numpy as np

import cotouch
from benchmarks._report import Row, command, interleave, ratio
from cotouch.scenario import Scenario
from cotouch.simulation import Prepared, prepare, run_batch

STEPS = 20_000
PERIOD = 1e-3
STIFFNESS, RELEASE = 100.0, 10.0
TARGETS = np.array([0.10, -0.05, 0.02, -0.08, 0.05])
# Lee & Huang 2010, section IV: N/m; s, [i][j] from j to i; the best of its topologies.
SPRING = [[0, 60, 50, 40, 100], [60, 0, 25, 75, 100], [50, 25, 0, 50, 40], [40, 75, 50, 0, 75], [100, 100, 40, 75, 0]]
DELAY = [
    [0, 0.1, 0.8, 0.8, 1.0],
    [0.05, 0, 0.05, 0.05, 0.8],
    [0.8, 0.04, 0, 0.05, 0.8],
    [0.8, 0.04, 0.05, 0, 0.05],
    [1.0, 0.8, 0.8, 0.04, 0],
]
LINKS = [[1, 2], [1, 4], [2, 3], [2, 4], [3, 4], [4, 5]]


def scenario() -> Scenario:
    """Five hands hold different places and let go together."""
    table: dict[str, Any] = {
        "network": {"users": list("12345"), "spring": SPRING, "delay": DELAY, "links": LINKS},
        "steps": {"period": PERIOD, "duration": STEPS * PERIOD},
        "synchronisation": {"mode": "constant", "damping": "rule"},
        "hands": [
            {"user": i + 1, "stiffness": STIFFNESS, "path": float(target), "release": RELEASE}
            for i, target in enumerate(TARGETS)
        ],
    }
    return Scenario.make(**table)


def numpy_loop(prepared: Prepared) -> Callable[[], np.ndarray]:
    """The same equations, all users at once, one step after the other; returns positions (users, steps + 1)."""
    delays = prepared.schedule.index_delay
    assert delays is not None
    links = np.array(LINKS) - 1
    receiver = np.concatenate([links[:, 0], links[:, 1]])
    sender = np.concatenate([links[:, 1], links[:, 0]])
    strength = np.array(SPRING, dtype=float)[receiver, sender]
    delay = delays[receiver, sender]
    users, longest = len(TARGETS), int(delay.max())
    stiffness = np.zeros((users, users))
    np.add.at(stiffness, (receiver, receiver), strength)
    own = stiffness.diagonal().copy()
    gather = np.zeros((users, receiver.size))
    gather[receiver, np.arange(receiver.size)] = strength
    mass, damping = 1.0 / users, prepared.local_damping[:, 0]
    half = 0.5 * PERIOD

    def loop() -> np.ndarray:
        x, v = np.zeros(users), np.zeros(users)
        samples = np.zeros((STEPS + longest, users))  # sample k is row k + longest: before the start all is zero
        positions = np.zeros((users, STEPS + 1))
        rows = np.arange(STEPS)[:, None] + (longest - delay)[None, :]
        for k in range(STEPS):
            held = STIFFNESS if (k + 0.5) * PERIOD < RELEASE else 0.0
            seen = gather @ samples[rows[k], sender]
            rhs = (mass / half) * v + seen - own * x + held * (TARGETS - x)
            mean = rhs / (mass / half + damping + half * (own + held))
            samples[k + longest] = x + half * mean
            x = x + PERIOD * mean
            v = 2.0 * mean - v
            positions[:, k + 1] = x
        return positions

    return loop


def measure() -> list[Row]:
    """Rows of the table."""
    asked = scenario()
    prepared = prepare(asked)
    rival = numpy_loop(prepared)
    seconds = interleave(
        {
            "simulate": lambda: cotouch.simulate(asked),
            "engine": lambda: run_batch(prepare(asked)),
            "run": lambda: run_batch(prepared),
            "numpy": rival,
        },
        rounds=9,
    )
    gap = float(np.abs(run_batch(prepared).record.position[:, :, 0, 0] - rival()).max())
    assert gap < 1e-9, f"engine and NumPy loop differ by {gap:g} m"
    ms = {name: 1e3 * float(np.median(times)) for name, times in seconds.items()}
    event = 1e6 * ms["run"] / (STEPS * len(TARGETS))
    faster = ratio(seconds["numpy"], seconds["simulate"])
    return [
        Row(
            "engine",
            "5 users × 20,000 steps: simulate(), scenario to dataset",
            f"{ms['simulate']:.1f} ms",
            "< 50 ms",
            f"{STEPS * PERIOD / ms['simulate'] * 1e3:,.0f} × real time; {faster:.0f} × faster than the NumPy loop",
        ),
        Row(
            "engine",
            "of it: schedule, arrays and run",
            f"{ms['engine']:.1f} ms",
            "",
            "without the labelled dataset",
        ),
        Row("engine", "of it: the run alone", f"{ms['run']:.1f} ms", "", f"{event:.0f} ns for each step of a user"),
        Row(
            "engine",
            "rival: the same equations in a NumPy loop",
            f"{ms['numpy']:.0f} ms",
            "",
            f"positions agree to {gap:.0e} m",
        ),
    ]


if __name__ == "__main__":
    command(measure, __doc__)
