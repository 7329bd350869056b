import json
from typing import Any

import numpy as np
import pytest
import xarray as xr

from cotouch.body import point
from cotouch.scenario import Scenario
from cotouch.simulation import at_times, discrepancy, force_imbalance, hold_window, settling_time, simulate, summary


def made(
    position: Any, *, force: Any = None, time: Any = None, hands: list[dict[str, Any]] | None = None
) -> xr.Dataset:
    """A result with given motion of single nodes on one axis, (users, steps)."""
    position = np.asarray(position, dtype=float)
    users, steps = position.shape
    time = np.tile(np.arange(steps) * 0.01, (users, 1)) if time is None else np.asarray(time)
    return xr.Dataset(
        {
            "position": (("user", "step", "node", "axis"), position[:, :, None, None]),
            "force": (
                ("user", "step", "axis"),
                np.zeros((users, steps, 1)) if force is None else np.asarray(force)[..., None],
            ),
            "time": (("user", "step"), time),
            "tick_time": (("tick",), time[0]),
        },
        attrs={"scenario": json.dumps({"hands": hands or []})},
    )


def test_settling_time_of_an_exponential() -> None:
    time = np.arange(1001) * 0.01
    run = made([np.exp(-time), np.zeros(1001)])
    expected = -np.log(0.02 * (1 - np.exp(-10)) + np.exp(-10))
    assert settling_time(run) == pytest.approx(expected, abs=0.011)
    assert settling_time(run, band=0.1) == pytest.approx(-np.log(0.1), abs=0.011)
    assert settling_time(run, start=1.0) == pytest.approx(-np.log(0.02), abs=0.02)


def test_settling_time_waits_for_the_slowest_user_and_the_last_excursion() -> None:
    time = np.arange(1001) * 0.01
    bump = np.where((time > 6.0) & (time < 6.5), 0.5, 0.0)
    assert settling_time(made([np.exp(-time), bump])) == pytest.approx(6.5, abs=0.011)


def test_what_still_moves_has_not_settled() -> None:
    time = np.arange(1001) * 0.01
    assert settling_time(made([np.sin(3 * time), np.zeros(1001)])) is None
    assert settling_time(made([time, np.zeros(1001)])) is None
    assert settling_time(made([np.zeros(1001), np.zeros(1001)])) == 0.0


def test_window_runs_from_the_last_grip_to_the_first_release() -> None:
    still = np.zeros((2, 1001))
    assert hold_window(made(still)) == (0.0, pytest.approx(10.0))
    hands = [{"begin": 1.0, "release": 7.0}, {"begin": 2.0, "release": None}, {"begin": 0.0, "release": 6.0}]
    assert hold_window(made(still, hands=hands)) == (2.0, 6.0)
    assert hold_window(made(still, hands=[{"begin": 5.0, "release": None}, {"begin": 0.0, "release": 3.0}])) == (
        0.0,
        pytest.approx(10.0),
    )


def test_discrepancy_is_the_distance_from_the_mean() -> None:
    run = made([np.full(100, 1.0), np.full(100, -1.0), np.full(100, 0.0)])
    assert discrepancy(run) == {
        "rms": pytest.approx(np.sqrt(2 / 3)),
        "p99": pytest.approx(1.0),
        "max": pytest.approx(1.0),
    }


def test_own_clocks_are_brought_together() -> None:
    time = np.array([[0.0, 1.0, 2.0], [0.0, 0.5, np.nan]])
    run = made([[0.0, 1.0, 2.0], [0.0, 5.0, np.nan]], time=time)
    assert at_times(run, "position", np.array([0.25, 1.5]))[:, :, 0, 0] == pytest.approx(
        np.array([[0.25, 2.5], [1.5, 5.0]])
    )


def test_summary_of_two_users_who_pull_apart() -> None:
    scenario = Scenario.make(
        network={"users": ["a", "b"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.02], [0.02, 0]]},
        body=point(stiffness=10.0),
        steps={"duration": 8.0, "period": 0.002},
        synchronisation={"law": "spring"},
        hands=[
            {"user": 1, "path": 0.1, "damping": 5, "release": 6.0},
            {"user": 2, "path": -0.04, "damping": 5, "release": 6.0},
        ],
    )
    run = simulate(scenario)
    figures = summary(run, scenario.build_body())
    # At rest: (K/2) x_i + κ (x_i - x_j) = k (r_i - x_i), two equations.
    matrix = np.array([[5 + 50 + 100, -50], [-50, 5 + 50 + 100]])
    x = np.linalg.solve(matrix, 100 * np.array([0.1, -0.04]))
    assert figures["hold"]["time_s"] == 6.0
    assert figures["hold"]["position"] == pytest.approx(list(x), rel=1e-4)
    assert figures["hold"]["force"] == pytest.approx(list(100 * (np.array([0.1, -0.04]) - x)), rel=1e-4)
    assert figures["hold"]["force_sum"] == pytest.approx(10 * x.mean(), rel=1e-3)
    assert figures["hold"]["force_imbalance"] < 1e-4
    assert force_imbalance(run, scenario.build_body(), 0.5) > 0.0
    assert figures["final"]["force"] == [0.0, 0.0]
    assert 0 < figures["settling_time_s"]["position"] < 5
    assert figures["steps"] == 4000
    assert figures["energy_residual"] < 1e-12
    assert json.loads(json.dumps(figures)) == figures
