"""Cuts of a run: three copies with delays and loss come to the same set, and no cut raises the energy."""

from typing import Any

import numpy as np
import pytest

from cotouch.errors import BodyError, ScenarioError
from cotouch.scenario import Scenario
from cotouch.simulation import animation, dataset, discrepancy, prepare, run_peers, run_prepared, simulate

DELAY = 0.04
RUN: dict[str, Any] = {
    "seed": 3,
    "network": {
        "users": ["Ann", "Ben", "Cem"],
        "spring": [[0, 50, 0], [50, 0, 50], [0, 50, 0]],
        "delay": [[0, DELAY, 0], [DELAY, 0, DELAY], [0, DELAY, 0]],
    },
    "channel": {"loss": 0.2},
    "body": {
        "kind": "lattice",
        "shape": [7, 4, 3],
        "model": "cells",
        "stiffness": 60.0,
        "damping": 0.05,
        "ground": "x-",
        "ground_stiffness": 100.0,
    },
    "cutting": {"users": [3]},
    "steps": {"duration": 0.5, "rate": 500},
    "record": {"frames": 20},
    "hands": [{"user": 1, "at": [0.06, 0.01, 0.01], "path": [0.01, 0, 0]}],
    "tools": [
        {
            "user": 3,
            "kind": "blade",
            "at": [0.035, -0.02, -0.01],
            "axis": [0, 0, 0.05],
            "thickness": 0.001,
            "hand": {"path": [[0.1, 0, 0, 0], [0.3, 0, 0.08, 0]], "stiffness": 500, "damping": 20},
        },
        {
            "user": 2,
            "at": [0.035, 0.015, 0.042],
            "radius": 0.01,
            "hand": {"path": [[0.05, 0, 0, 0], [0.1, 0, 0, -0.02]], "stiffness": 500, "damping": 20},
        },
    ],
}


def made(**changes: Any) -> Scenario:
    tables: dict[str, Any] = {**RUN, **changes}
    return Scenario.make(**tables)


@pytest.fixture(scope="module")
def ran() -> Any:
    prepared = prepare(made())
    outcome = run_prepared(prepared)
    return prepared, outcome, dataset(prepared, outcome)


def test_the_ledger_is_exact_and_no_cut_raises_the_energy(ran: Any) -> None:
    _, _, run = ran
    assert run.attrs["energy_residual"] < 1e-12
    assert run.attrs["passivity_margin"] >= -1e-12
    cut = run["cut"].values
    assert (np.diff(cut, axis=1) >= 0.0).all()
    assert (cut[:, -1] > 0.0).all()
    count = run["cut_elements"].values
    # In a step that cuts, the copy holds less than its other books say, by just that.
    books = run["supplied"] - run["body_loss"] - run["local_loss"] - run["extra_loss"] - run["cut"]
    gained = (books + run["touch_work"] - run["kinetic"] - run["elastic"]).values
    links = np.zeros_like(gained)
    for direction, receiver in enumerate(run["receiver"].values):
        links[run["user"].values.tolist().index(receiver)] += run["link_work"].values[direction]
    assert np.abs(gained + links).max() < 1e-12
    assert (np.diff(count, axis=1) > 0).sum() >= 9


def test_all_know_of_a_cut_as_soon_as_a_sample_can_tell(ran: Any) -> None:
    _, _, run = ran
    by, time = run["cut_by"].values, run["cut_time"].values
    assert set(np.unique(by)) == {0, 3}
    assert np.array_equal(by[0] > 0, by[2] > 0)
    assert np.array_equal(by[1] > 0, by[2] > 0)
    cut = by[2] > 0
    assert cut.sum() == 6  # one layer of cubes
    for near, far in ((2, 1), (1, 0)):
        late = time[near, cut] + DELAY
        assert (time[far, cut] >= late - 1e-9).all()
        lost = 2e-3 * 8  # so many samples in a row were not lost
        assert (time[far, cut] <= late + lost).all()


def test_batch_and_peers_cut_alike_to_the_bit(ran: Any) -> None:
    prepared, outcome, run = ran
    told = run_peers(prepared)
    for user in range(3):
        assert np.array_equal(told.position[user][-1], outcome.position[user])
        cut = [element for report in told.reports[user] for element in report.cut_elements]
        assert sorted(cut) == np.flatnonzero(run["cut_by"].values[user]).tolist()
        assert sum(report.cut for report in told.reports[user]) == pytest.approx(float(run["cut"].values[user, -1]))
        assert max(abs(report.residual) for report in told.reports[user]) < 1e-14


@pytest.fixture(scope="module")
def parted() -> Any:
    """Under gravity: a thick blade takes three layers of cubes, where one user's hand and another's grasp hold on."""
    way = [[0, 0, 0, 0], [0.1, 0, 0, 0.01]]
    grasp = {"user": 2, "kind": "grasp", "at": [0.04, 0.02, 0.01], "radius": 0.004}
    prepared = prepare(
        made(
            world={"gravity": [0, 0, -9.81]},
            hands=[{"user": 1, "at": [0.03, 0.01, 0.01], "path": [0.01, 0, 0]}],
            tools=[
                {**RUN["tools"][0], "thickness": 0.025},
                {**grasp, "hand": {"path": way, "stiffness": 500, "damping": 20}},
            ],
            record={"nodes": "all", "frames": 100},
        )
    )
    outcome = run_prepared(prepared)
    return prepared, outcome, dataset(prepared, outcome)


def test_nodes_that_lost_their_last_element_rest_and_no_hand_feels_them(parted: Any) -> None:
    prepared, outcome, run = parted
    material = prepared.body.material
    assert material is not None
    assert run.attrs["energy_residual"] < 1e-12
    assert run.attrs["passivity_margin"] >= -1e-12
    told = run_peers(prepared)
    for user in range(3):
        gone = np.where(run["cut_by"].values[user] > 0, run["cut_time"].values[user], np.inf)
        last = np.full(prepared.body.nodes, -np.inf)
        np.maximum.at(last, material.elements, gone[:, None])
        debris = last < np.inf
        assert set(prepared.body.rest[debris, 0]) == {0.03, 0.04}
        after = run["time"].values[user] > last[debris].max() + 1e-9
        place = run["position"].values[user][after]
        assert np.array_equal(place[:, debris], np.broadcast_to(place[0, debris], place[:, debris].shape))
        assert (np.ptp(place[:, ~debris], axis=0).max(axis=1) > 0.0).all()
        # Who held on feels nothing from then on.
        for force in (run["force"].values[user], *run["touch_force"].values[[1] if user == 1 else []]):
            assert np.abs(force[after][1:]).max() < 1e-12
            assert user == 2 or np.abs(force[~after]).max() > 0.1
        assert np.array_equal(told.position[user][-1], outcome.position[user])
        assert sum(report.cut for report in told.reports[user]) == pytest.approx(float(run["cut"].values[user, -1]))
        assert max(abs(report.residual) for report in told.reports[user]) < 1e-14
        assert np.array_equal(run["debris_time"].values[user], np.where(debris, last, np.nan), equal_nan=True)


def test_copies_are_not_apart_where_debris_lies(parted: Any) -> None:
    """It lies where each copy happened to be, which is nobody's concern; while copies differ, the others count."""
    prepared, _, run = parted
    place, since = run["position"].values, run["debris_time"].values
    assert np.isfinite(since).any(axis=1).all()
    assert np.ptp(np.where(np.isfinite(since), since, 0.0), axis=0).max() > 0.01  # the copies differ for a while
    expected: list[float] = []
    for k, now in enumerate(run["tick_time"].values):
        for node in range(place.shape[2]):
            those = [user for user in range(3) if not now >= since[user, node]]
            mean = sum(place[user, k, node] for user in those) / max(len(those), 1)
            expected += [float(np.linalg.norm(place[user, k, node] - mean)) for user in those]
    told = discrepancy(run)
    assert told["max"] == pytest.approx(max(expected), rel=1e-12)
    assert told["rms"] == pytest.approx(float(np.sqrt(np.mean(np.square(expected)))), rel=1e-9)
    end = place[:, -1]
    debris = np.isfinite(since).all(axis=0)
    lies, goes = (
        float(np.linalg.norm(end[:, which] - end[:, which].mean(axis=0), axis=-1).max()) for which in (debris, ~debris)
    )
    assert lies > 2.0 * goes
    shown = animation(run, prepared.body).series[0].values
    assert shown[-1].max() == pytest.approx(goes, rel=0.05)


def test_what_was_cut_away_is_not_touched(ran: Any) -> None:
    """The second user's ball presses where the blade goes through; then there is nothing any more."""
    _, _, run = ran
    touched = np.linalg.norm(run["touch_force"].values[1], axis=1)
    time = run["time"].values[1]
    pressed = touched[(time > 0.11) & (time < 0.12)]
    assert pressed.max() > 0.01
    other = simulate(made(tools=RUN["tools"][1:]))  # by the engine of the fixture: another takes 20 s to compile
    there = np.linalg.norm(other["touch_force"].values[0], axis=1)
    assert touched[-1] < 0.7 * there[-1]
    assert not other["cut"].values.any()


def test_an_animation_draws_the_cut(ran: Any) -> None:
    prepared, _, run = ran
    shown = animation(run, prepared.body)
    begin, end = shown.spans[..., 0], shown.spans[..., 1]
    time = run["cut_time"].values
    assert shown.triangles.shape[0] == begin.shape[1]
    last = np.nanmax(time, axis=1)
    for user in range(3):
        first = (begin[user] <= 0.0) & (end[user] > 0.0)
        after = (begin[user] <= last[user] + 1e-3) & (end[user] > last[user] + 1e-3)
        assert first.sum() == prepared.body.skin.triangles.shape[0]
        opened = after & ~first
        assert opened.sum() == 2 * 6 * 2  # two walls of six squares
    assert shown.tools.axis.tolist() == [[0, 0, 0.05], [0, 0, 0]]
    assert '"spans"' in shown.page()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"thickness": 0.0}, 'kind is "blade" and thickness is 0 m; a blade needs one above 0'),
        ({"thickness": None}, 'kind is "blade" and thickness is not given'),
        ({"thickness": 1e9}, r"thickness is 1e\+09 m, but axis is .* m long; a blade is at most as thick"),
        ({"axis": [0.0, 0.0, 0.0]}, 'kind is "blade" and axis is of no length'),
        ({"friction": 0.5}, "friction is 0.5, but a blade does not touch"),
        ({"kind": "touch", "axis": None}, 'thickness is 0.001, but kind is "touch"; only a blade has one'),
        ({"user": 1}, r'tools\[1\].kind is "blade", but cutting.users is \[3\]; name user 1 there'),
    ],
)
def test_a_wrong_blade_is_told_in_a_sentence(change: dict[str, Any], words: str) -> None:
    blade = {**RUN["tools"][0], **change}
    with pytest.raises(ScenarioError, match=words):
        prepare(made(tools=[{k: v for k, v in blade.items() if v is not None}]))


def test_what_cannot_be_cut_is_told_in_a_sentence() -> None:
    with pytest.raises(BodyError, match="cutting takes away elements, but the body is linear and has none"):
        prepare(made(body={"kind": "lattice", "shape": [7, 4, 3]}))
    with pytest.raises(ScenarioError, match=r"cutting\.tear is -1"):
        made(cutting={"tear": -1})
    with pytest.raises(ScenarioError, match=r"cutting\.users names user 9; the network has users 1 to 3"):
        prepare(made(cutting={"users": [3, 9]}))


def test_a_blade_pays_for_the_area_that_it_opens() -> None:
    """Slowly through a whole block: what is lost is toughness times area, what resists is toughness times edge."""
    toughness, h = 40.0, 0.01
    block = {**RUN["body"], "ground": "all", "ground_stiffness": 2000.0, "damping": 0.5}
    blade = RUN["tools"][0] | {
        "user": 1,
        "hand": {"path": [[0.0, 0, 0, 0], [0.8, 0, 0.09, 0]], "stiffness": 2000, "damping": 20},
    }
    alone = {"network": {"users": ["Ann"], "spring": [[0]], "delay": [[0]]}, "hands": [], "channel": {}}
    alone["synchronisation"] = {"law": "spring"}  # nobody is linked, and the fixture's engine is compiled
    still = {"body": block, "steps": {"duration": 0.8, "rate": 1000}, "tools": [blade], **alone}
    run, free = (simulate(made(cutting={"toughness": one}, **still)) for one in (toughness, 0.0))
    # Three cubes along y, two along z.
    assert int(run["cut_elements"][0, -1]) == int(free["cut_elements"][0, -1]) == 6
    assert float(run["touch_loss"][0, -1]) == pytest.approx(toughness * 6 * h * h, rel=0.02)
    assert float(free["touch_loss"][0, -1]) == 0.0
    assert run.attrs["energy_residual"] < 1e-12
    assert run.attrs["passivity_margin"] >= -1e-12
    force = -run["touch_force"].values[0, :, 1]  # against its way
    time = run["time"].values[0]
    within = (time > 0.8 * 0.035 / 0.09) & (time < 0.8 * 0.05 / 0.09)
    assert float(force[within].mean()) == pytest.approx(toughness * 2 * h, rel=0.25)
