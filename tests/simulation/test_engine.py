"""The batch engine against single peers, the energy ledger, the theorem and the closed loop."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cotouch.body import Body, chain
from cotouch.network import Network, rightmost_root
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch, run_peers, simulate

FIVE_USERS = Path(__file__).parents[2] / "examples" / "five-users.toml"
MODES = ("constant", "self-paced", "freshest")
ROUGH = {
    "jitter": {"kind": "exponential", "scale": 0.01},
    "loss": 0.1,
    "burst": {"enter": 0.02, "leave": 0.3},
    "duplication": 0.1,
    "reordering": 0.1,
    "reordering_delay": 0.02,
}
TRIANGLE: dict[str, Any] = {
    "users": ["a", "b", "c"],
    "spring": [[0, 60, 30], [60, 0, 20], [30, 20, 0]],
    "delay": [[0, 0.03, 0.08], [0.05, 0, 0.02], [0.04, 0.06, 0]],
}


def five_users() -> Network:
    return Network.read(FIVE_USERS)


def bodies() -> dict[str, Body]:
    rng = np.random.default_rng(5)
    root = rng.normal(size=(6, 6))
    coupled = Body(
        mass=np.eye(6) + 0.1 * root @ root.T / 6,
        rest=rng.normal(size=(2, 3)),
        damping_int=0.2 * root.T @ root,
        stiffness_int=20 * root @ root.T,
        stiffness_ext=np.diag([3.0, 0, 0, 0, 5.0, 0]),
    )
    return {
        "point": Body(mass=[[0.7]], rest=[[0.3]], damping_ext=[[0.1]], stiffness_ext=[[4.0]]),
        "chain in 2-D": chain(5, dimension=2, stiffness=200, damping=0.4, ground=[0], ground_stiffness=50),
        "modal chain in 3-D": chain(4, dimension=3, stiffness=200, damping=0.4),
        "coupled axes": coupled,
    }


def hands(body: Body) -> list[dict[str, Any]]:
    d = body.dimension
    return [
        {
            "user": 1,
            "node": 1,
            "stiffness": 80,
            "damping": 1.0,
            "path": [0.05] * d,
            "amplitude": [0.02] * d,
            "frequency": 1.5,
        },
        {"user": 2, "node": body.nodes, "path": [[0.0] + [0.0] * d, [0.5] + [-0.04] * d], "release": 1.1},
        {"user": 3, "node": 1, "kind": "force", "path": [0.5] * d, "begin": 0.2, "release": 0.9},
        {"user": 3, "node": body.nodes, "stiffness": 30, "path": [0.01] * d},
    ]


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("shape", ["point", "chain in 2-D", "modal chain in 3-D", "coupled axes"])
def test_batch_moves_as_single_peers_do(mode: str, shape: str) -> None:
    body = bodies()[shape]
    scenario = Scenario.make(
        network=TRIANGLE,
        body=body,
        steps={"duration": 1.5, "random": {"low": 0.004, "high": 0.02}},
        synchronisation={"mode": mode, "extra_damping": 0.2},
        channel=ROUGH,
        hands=hands(body),
        initial={"velocity": [0.1, -0.2, 0.0]},
    )
    prepared = prepare(scenario)
    batch, peers = run_batch(prepared), run_peers(prepared)
    for i, n in enumerate(prepared.schedule.count):
        assert peers.position[i].shape[0] == n + 1
        assert np.array_equal(peers.end[i], prepared.schedule.end[i, :n])
        assert np.array_equal(peers.position[i][-1], batch.position[i])
        assert [report.supplied for report in peers.reports[i]] == pytest.approx(
            np.diff(batch.record.users[0, i, : n + 1]), rel=1e-9, abs=1e-12
        )
        slots = slice(prepared.schedule.slots.first[i], prepared.schedule.slots.first[i + 1])
        ages = np.array([report.age for report in peers.reports[i]])
        assert np.allclose(ages.T, prepared.schedule.age[slots, :n], rtol=0, atol=1e-9)
        energy = max(report.kinetic + report.elastic for report in peers.reports[i])
        assert max(abs(report.residual) for report in peers.reports[i]) <= 1e-12 * max(energy, 1.0)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("shape", ["point", "chain in 2-D", "modal chain in 3-D", "coupled axes"])
@pytest.mark.parametrize("cap", [1, 3, 500])
def test_books_balance_and_users_stay_passive(mode: str, shape: str, cap: int) -> None:
    body = bodies()[shape]
    run = simulate(
        Scenario.make(
            network=TRIANGLE,
            body=body,
            steps={"duration": 3.0, "random": {"low": 0.004, "high": 0.03}},
            synchronisation={"mode": mode},
            channel=ROUGH,
            hands=hands(body),
            solver={"iterations": cap},
        )
    )
    assert run.attrs["finished"]
    assert run.attrs["energy_residual"] < 1e-12
    assert run.attrs["passivity_margin"] >= -1e-12 * run.attrs["energy_in_play"]
    if mode == "constant":  # all users end on the same step, so their own ledger adds up to those of the network
        last = run.isel(step=-1)
        for total, parts in {
            "supplied_total": ("supplied",),
            "dissipated_total": ("body_loss", "local_loss", "extra_loss"),
            "delay_work_total": ("delay_work",),
        }.items():
            summed = sum(float(last[part].sum(skipna=False)) for part in parts)
            assert summed == pytest.approx(float(run[total][-1]), rel=1e-10)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("steps", [{"period": 0.01}, {"random": {"low": 0.001, "high": 0.02}}, {"rate": [1000, 100]}])
@pytest.mark.parametrize("rough", [False, True])
def test_a_free_object_under_a_known_force_is_as_fast_as_it_should_be(
    mode: str, steps: dict[str, Any], rough: bool
) -> None:
    """At every user and step: nobody's copy lives more slowly than its user, whoever waits for whom."""
    if mode == "constant" and "rate" in steps:
        pytest.skip("different rates are refused under a common index")
    run = simulate(
        Scenario.make(
            network={"users": ["a", "b"], "spring": [[0, 1e-6], [1e-6, 0]], "delay": [[0, 0.03], [0.05, 0]]},
            steps={"duration": 2.0, **steps},
            synchronisation={"law": "spring", "mode": mode},
            channel=ROUGH if rough else {},
            hands=[{"user": user, "kind": "force", "path": 0.5} for user in (1, 2)],
        )
    )
    time, velocity = run["time"].values, run["velocity"].values[:, :, 0, 0]
    simulated = np.cumsum(np.nan_to_num(run["period"].values), axis=1)  # half a kilogram, half a newton: 1 m/s^2
    late = np.where(np.isfinite(time), time - simulated, 0.0)
    there = np.isfinite(time)
    assert velocity[there] == pytest.approx(simulated[there], rel=1e-4, abs=1e-9)
    if mode == "self-paced":  # what the bound on a step cuts off of a wait is made up later, and said
        assert late.max(axis=1) == pytest.approx(run.attrs["behind"], abs=1e-9)
        assert np.abs(np.nanmax(velocity, axis=1) - np.nanmax(time, axis=1)).max() <= max(run.attrs["behind"]) + 1e-3
    else:
        assert np.abs(late).max() < 1e-9
        assert run.attrs["behind"] == [0.0, 0.0]
    asked = {"period": [100.0, 100.0], "rate": [1000.0, 100.0]}.get(next(iter(steps)))
    if asked is not None:
        assert run.attrs["rate_asked"] == pytest.approx(asked, rel=1e-6)
    assert (np.array(run.attrs["rate"]) <= np.array(run.attrs["rate_asked"]) * (1.0 + 1e-6)).all()


@pytest.mark.parametrize("mode", MODES)
def test_link_weights_balance_too(mode: str) -> None:
    """K_ij as SPD matrices: anisotropic per node, and different on each link."""
    rng = np.random.default_rng(2)
    spring = np.zeros((3, 3, 6, 6))
    for a, b in ((0, 1), (0, 2), (1, 2)):
        root = rng.normal(size=(6, 6))
        spring[a, b] = spring[b, a] = 30 * np.eye(6) + 5 * root @ root.T
    network = Network(users=["a", "b", "c"], spring=spring, delay=TRIANGLE["delay"])
    body = bodies()["coupled axes"]
    run = simulate(
        Scenario.make(
            network=network,
            body=body,
            steps={"duration": 2.0, "random": {"low": 0.004, "high": 0.03}},
            synchronisation={"mode": mode},
            channel=ROUGH,
            hands=hands(body),
        )
    )
    assert run.attrs["energy_residual"] < 1e-12
    assert run.attrs["passivity_margin"] >= -1e-12 * run.attrs["energy_in_play"]
    assert run.sizes["weight"] == 4


def test_modal_and_nodal_runs_agree() -> None:
    body = bodies()["modal chain in 3-D"]
    base = Scenario.make(
        network=TRIANGLE,
        body=body,
        steps={"duration": 2.0, "period": 0.01},
        hands=hands(body),
        synchronisation={"law": "spring"},
        solver={"tolerance": 1e-14},
    )
    modal, nodal = simulate(base), simulate(base.replace(solver__basis="nodal"))
    assert modal.attrs["basis"] == "modal"
    assert nodal.attrs["basis"] == "nodal"
    assert nodal["iterations"].max() > 0
    for name in ("position", "force", "supplied", "link_energy"):
        scale = float(np.abs(nodal[name]).max())
        assert float(np.abs(modal[name] - nodal[name]).max()) < 1e-10 * scale


def test_free_decay_shows_the_dominant_root() -> None:
    """Theory section 6: the best topology decays at 1.428553 1/s, in the simulator as in the closed loop."""
    run = simulate(
        Scenario.make(
            network=five_users(),
            steps={"duration": 12.0, "period": 0.001},
            synchronisation={"mode": "constant"},
            initial={"position": [1.0, -1.0, 0.5, -0.5, 2.0]},
        )
    )
    apart = run["position"].values[:, :, 0, 0]
    apart = apart - apart.mean(axis=0)
    time = run["time"].values[0]
    expected = rightmost_root(five_users()).root
    assert expected.real == pytest.approx(-1.428553, abs=1e-6)
    early, late = np.searchsorted(time, [6.0, 11.0])
    if abs(expected.imag) < 1e-9:
        rates = np.log(np.abs(apart[:, late] / apart[:, early])) / (time[late] - time[early])
        assert rates == pytest.approx(np.full(5, expected.real), abs=1e-5)
    else:  # two neighbouring samples of a damped oscillation obey y(t+h) - 2 Re(e^{sh}) y(t) + |e^{sh}|² y(t-h) = 0
        h = 100
        rows = np.array([[apart[i, k], -apart[i, k - h]] for i in range(5) for k in range(early, late, 50)])
        right = np.array([apart[i, k + h] for i in range(5) for k in range(early, late, 50)])
        scale = np.exp(-expected.real * np.repeat(time[early:late:50][None, :], 5, axis=0).ravel())
        (_, square), *_ = np.linalg.lstsq(rows * scale[:, None], right * scale, rcond=None)
        assert np.log(square) / 2 / (h * 0.001) == pytest.approx(expected.real, abs=1e-5)


def test_held_at_rest_forces_balance_the_mean_deformation() -> None:
    """Theorem 1, item 3: with K ≠ 0, Σ f → K (x̄ - x_d)."""
    body = Body(mass=[[1.0]], rest=[[0.2]], damping_ext=[[2.0]], stiffness_ext=[[30.0]])
    run = simulate(
        Scenario.make(
            network=five_users(),
            body=body,
            steps={"duration": 40.0, "period": 0.002},
            hands=[{"user": i, "path": 0.1 * i - 0.2, "stiffness": 60, "damping": 2} for i in range(1, 6)],
        )
    )
    mean = float(run["position"].isel(step=-1).mean())
    force = float(run["force"].isel(step=-1).sum())
    assert abs(mean - 0.2) > 0.05
    assert force == pytest.approx(30.0 * (mean - 0.2), rel=1e-8)


def test_a_single_user_feels_the_whole_object() -> None:
    body = Body(mass=[[1.0]], rest=[[0.0]], damping_ext=[[2.0]], stiffness_ext=[[30.0]])
    run = simulate(
        Scenario.make(
            network=five_users(),
            body=body,
            steps={"duration": 60.0, "period": 0.002},
            hands=[{"user": 2, "path": 0.1, "stiffness": 100, "damping": 2}],
        )
    )
    held = run.isel(step=-1)
    # The others hang on springs, so they follow with a stretch: f = K x̄, which is K x only where they keep up.
    assert float(held["force"].sel(user="2")[0]) == pytest.approx(30.0 * float(held["position"].mean()), rel=1e-8)


def test_released_users_agree_and_return() -> None:
    """Theorem 1, item 2 and the cases after it."""
    release = [{"user": i, "path": 0.1 * i - 0.2, "release": 5.0} for i in range(1, 6)]
    tables: dict[str, Any] = {
        "network": five_users(),
        "steps": {"duration": 40.0, "period": 0.002},
        "synchronisation": {"extra_damping": 0.05},
        "hands": release,
    }
    free = simulate(Scenario.make(**tables))["position"].isel(step=-1).values.ravel()
    assert np.ptp(free) < 1e-8
    assert abs(free.mean()) > 1e-3
    bound = Body(mass=[[1.0]], rest=[[0.5]], damping_ext=[[5.0]], stiffness_ext=[[100.0]])
    back = simulate(Scenario.make(**{**tables, "body": bound}))["position"].isel(step=-1).values.ravel()
    assert np.abs(back - 0.5).max() < 1e-6
    rigid = chain(3, stiffness=100, damping=1.0, spacing=0.1)
    drifted = simulate(Scenario.make(**{**tables, "body": rigid}))["position"].isel(step=-1).values[:, :, 0]
    assert np.abs(drifted - drifted[0]).max() < 1e-6
    shift = drifted - rigid.rest[:, 0]
    assert np.ptp(shift) < 1e-6
    assert abs(shift.mean()) > 1e-3


def test_far_below_the_rule_the_users_run_away() -> None:
    tables: dict[str, Any] = {"network": five_users(), "steps": {"duration": 60.0}, "hands": [{"user": 1, "path": 0.1}]}
    safe = simulate(Scenario.make(**tables, synchronisation={"mode": "constant"}))
    assert safe.attrs["finished"]
    loose = simulate(Scenario.make(**tables, synchronisation={"mode": "constant", "damping_scale": 0.02}))
    assert loose.attrs["passivity_margin"] < -1.0
    assert not loose.attrs["finished"] or float(loose["stored"].max()) > 1e6 * float(safe["stored"].max())
    # The energy came from delay, and the ledger says so to the last joule.
    assert loose.attrs["energy_residual"] < 1e-10
    assert float(loose["delay_work_total"][-1]) > float(loose["dissipated_total"][-1])


def test_a_run_that_leaves_floating_point_stops_there() -> None:
    run = simulate(
        Scenario.make(
            network=TRIANGLE,
            steps={"duration": 400.0, "period": 0.01},
            synchronisation={"law": "spring", "damping": 0.0},
            initial={"position": [1.0, 0.0, -1.0]},
        )
    )
    assert not run.attrs["finished"]
    assert run.attrs["steps"] < 40_000
    assert run["position"].isnull().any()
    assert float(run["stored"].max()) > 1e150
