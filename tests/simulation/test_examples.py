"""The examples with tools do what their comments say."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import xarray as xr

from cotouch.scenario import Scenario
from cotouch.simulation import discrepancy, felt, simulate, summary

EXAMPLES = Path(__file__).parents[2] / "examples"
Made = tuple[Scenario, xr.Dataset]
Floats = npt.NDArray[np.float64]


def made(path: Path) -> Made:
    scenario = Scenario.read(path)
    return scenario, simulate(scenario)


@pytest.fixture(scope="module")
def squeeze() -> Made:
    return made(EXAMPLES / "squeeze.toml")


@pytest.fixture(scope="module")
def alone() -> Made:
    return made(EXAMPLES / "alone.toml")


@pytest.fixture(scope="module")
def alone_by_springs() -> Made:
    scenario = Scenario.read(EXAMPLES / "alone.toml").replace(synchronisation__law="spring")
    return scenario, simulate(scenario)


@pytest.fixture(scope="module")
def two_rates() -> Made:
    return made(EXAMPLES / "two-rates.toml")


@pytest.fixture(scope="module")
def liver(tmp_path_factory: pytest.TempPathFactory) -> Made:
    folder = tmp_path_factory.mktemp("examples")
    script = EXAMPLES / "make_shapes.py"
    subprocess.run([sys.executable, str(script), str(folder / "shapes")], check=True, capture_output=True, timeout=120)
    path = folder / "five-users-liver.toml"
    path.write_text((EXAMPLES / "five-users-liver.toml").read_text(encoding="utf-8"), encoding="utf-8")
    return made(path)


@pytest.mark.parametrize("name", ["squeeze", "alone", "two_rates", "liver"])
def test_energy_balances_and_everything_is_passive(name: str, request: pytest.FixtureRequest) -> None:
    scenario, run = request.getfixturevalue(name)
    assert run.attrs["finished"]
    assert run.attrs["energy_residual"] <= 1e-10
    assert run.attrs["passivity_margin"] >= -1e-12 * run.attrs["energy_in_play"]
    assert run.attrs["device_residual"] <= 1e-10
    figures = summary(run, scenario.build_body())
    assert all(tool["coupling"]["passive"] for tool in figures["tools"])
    assert all(tool["coupling"]["excess_j"] <= tool["coupling"]["bound_j"] for tool in figures["tools"])


def between(run: xr.Dataset, user: int, start: float, stop: float) -> npt.NDArray[np.bool_]:
    time = run["time"].values[user]
    return (time >= start) & (time <= stop)


def test_squeezing_users_feel_equal_and_opposite_forces(squeeze: Made) -> None:
    _, run = squeeze
    hold = between(run, 0, 1.2, 1.5)
    for force in (run["touch_force"].values, -run["force"].values, felt(run)):
        left, right = force[0, hold], force[1, hold]
        assert np.linalg.norm(left, axis=1).min() > 2.0
        assert np.linalg.norm(left + right, axis=1).max() < 0.01 * np.linalg.norm(left, axis=1).min()
    assert felt(run)[0, hold, 0].max() < 0.0 < felt(run)[1, hold, 0].min()


def test_friction_alone_carries_the_block(squeeze: Made) -> None:
    scenario, run = squeeze
    rest = scenario.build_body().rest
    nodes = run["node"].values - 1
    lifted = between(run, 0, 2.6, 2.7)
    height = (run["position"].values[:, lifted] - rest[nodes])[..., 2]
    assert height.min() > 0.02
    assert run["touching"].values[:, lifted].min() > 0
    after = between(run, 0, 3.8, 4.0)
    assert not run["touch_force"].values[:, after].any()
    assert discrepancy(run)["max"] < 0.003


def test_one_user_alone_feels_the_whole_object(alone: Made) -> None:
    """f = K (x - x_d) of the whole, x the mean of the copies, though each copy is a third as stiff."""
    scenario, run = alone
    body = scenario.build_body()
    force = felt(run)[0, -1]
    mean = run["position"].values[:, -1].mean(axis=0) - body.rest
    whole = body.apply(body.stiffness, mean).sum(axis=0)
    assert np.linalg.norm(force) > 3.0
    assert np.linalg.norm(force + whole) < 1e-3 * np.linalg.norm(whole)
    np.testing.assert_allclose(run["touch_force"].values[0, -1], force, atol=1e-3 * np.linalg.norm(force))
    assert summary(run, body)["hold"]["force_imbalance"] < 1e-3 * np.linalg.norm(whole)


def at_rest(scenario: Scenario, spring: Floats) -> tuple[Floats, Floats]:
    """The force that the user of a grasp feels in the end, and where all copies are then; no simulation.

    [P + I ⊗ K/N + grasp] x = grasp y, and springs in series from the hand's will to the grasp.
    """
    body, tool = scenario.build_body(), scenario.tools[0]
    users, nodes = spring.shape[0], body.nodes
    assert tool.hand is not None
    assert tool.device is not None
    system = np.zeros((users * nodes, users * nodes))
    for i in range(users):
        own = slice(i * nodes, (i + 1) * nodes)
        system[own, own] += body.stiffness.toarray() / users + spring[i].sum() * np.eye(nodes)
        for j in range(users):
            if i != j:
                system[own, j * nodes : (j + 1) * nodes] -= spring[i, j] * np.eye(nodes)
    held = np.flatnonzero(np.linalg.norm(body.rest - np.array(tool.at), axis=1) <= tool.radius)
    system[held, held] += tool.stiffness
    load = np.zeros(users * nodes)
    load[held] = tool.stiffness
    place = np.linalg.solve(system, load)  # of all copies, for a tool that is one metre away
    stiffness = tool.stiffness * float((1.0 - place[held]).sum())  # that the tool feels
    series = 1.0 / (1.0 / tool.hand.stiffness + 1.0 / tool.device.stiffness + 1.0 / stiffness)
    goal = np.array(tool.hand.path[-1][1:])  # type: ignore[index]  # pyright: ignore[reportIndexIssue]
    force = series * goal
    return force, place.reshape(users, nodes, 1) * (force / stiffness)


def test_the_closed_form_of_rest_predicts_force_and_copies(alone: Made) -> None:
    """`paid` lets copies that rest be one body: the user feels what he would of a single one."""
    scenario, run = alone
    assert run.attrs["law"] == "paid"
    force, moved = at_rest(scenario, np.zeros((1, 1)))
    np.testing.assert_allclose(-felt(run)[0, -1], force, rtol=1e-6, atol=1e-9)
    copies = run["position"].values[:, -1] - scenario.build_body().rest
    assert np.abs(copies - moved).max() < 1e-6 * np.abs(moved).max()


def test_the_closed_form_of_rest_with_springs_predicts_force_and_copies(alone_by_springs: Made) -> None:
    """Springs that are stretched keep copies apart, and what one user feels is softer."""
    scenario, run = alone_by_springs
    force, moved = at_rest(scenario, scenario.network.spring)
    np.testing.assert_allclose(-felt(run)[0, -1], force, rtol=1e-3, atol=1e-9)
    copies = run["position"].values[:, -1] - scenario.build_body().rest
    assert np.abs(copies - moved).max() < 1e-3 * np.abs(moved).max()


def test_watchers_see_what_one_user_does(alone: Made, alone_by_springs: Made) -> None:
    """With `paid` just that; with springs less, by what these stretch, and both watchers alike."""
    scenario, run = alone
    rest = scenario.build_body().rest
    moved = run["position"].values[:, -1] - rest
    assert np.abs(moved[1:] - moved[0]).max() < 1e-6 * np.abs(moved[0]).max()
    heights = (alone_by_springs[1]["position"].values[:, -1] - rest)[..., 2].max(axis=1)
    assert heights[1:] == pytest.approx(heights[1], rel=0.01)
    assert 0.4 * heights[0] < heights[1] < heights[0]


def test_the_slow_users_bound_is_larger_and_he_feels_the_fast_ones_pushes(two_rates: Made) -> None:
    scenario, run = two_rates
    tools: list[dict[str, Any]] = summary(run, scenario.build_body())["tools"]
    assert [tool["device"] for tool in tools] == ["touch 500 Hz", "omega 2000 Hz"]
    assert run.sizes["step"] == 4001
    assert int(np.isfinite(run["time"].values[0]).sum()) == 1001
    late = between(run, 0, 1.5, 4.0)
    force = np.linalg.norm(felt(run)[0, late], axis=1)
    when = run["time"].values[0, late]
    wave = np.abs(np.mean((force - force.mean()) * np.exp(-2j * np.pi * when)))
    assert 2.0 * wave > 0.1  # newtons at the 1 Hz with which the other one pushes
    quiet = between(run, 0, 0.7, 4.0)
    assert force.min() > 0.3
    assert run["touching"].values[0, quiet].min() > 0


def test_five_users_pull_one_liver_and_let_go(liver: Made) -> None:
    scenario, run = liver
    assert [tool["device"] for tool in summary(run, scenario.build_body())["tools"]] == [
        "omega 1000 Hz",
        "falcon 1000 Hz",
        "touch 1000 Hz",
        "phantom 1000 Hz",
        "inverse3 4000 Hz",
    ]
    time = run["time"].values[0]
    held, free = int(np.searchsorted(time, 5.9)), int(np.searchsorted(time, 9.9))
    assert np.linalg.norm(felt(run)[:, held], axis=1).min() > 0.5
    assert np.linalg.norm(felt(run)[:, free], axis=1).max() < 0.05
    rest = scenario.build_body().rest[run["node"].values - 1]
    moved = run["position"].values - rest
    assert np.abs(moved[:, held]).max() > 0.02
    apart = [np.linalg.norm(moved[:, step] - moved[:, step].mean(axis=0), axis=-1).max() for step in (held, free)]
    assert apart[1] < 0.001 < apart[0]
